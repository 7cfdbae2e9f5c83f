//! What HamNoSys can say beyond single movements, as motion: assertions of the goal, value by value.

use crate::signing::{body_at, perform, perform_with, sign, world};
use crate::strategies::{self, Words};
use chereme::motion::rotation::angle_between;
use chereme::phonology::movement_table::MovementTable;
use chereme::phonology::symmetry::Turns;
use chereme::phonology::*;
use chereme::score::plan::{Act, Item, Plan};
use chereme::synthesis::legs::lay_out;
use chereme::synthesis::{Options, Performance, measure, render, synthesize};
use chereme::time::{Fps, Seconds};
use glam::DVec3;
use proptest::prelude::*;

const STILL: &str = "sign X\n configuration flat\n placement chest, 30cm away, with palm\n orientation fingers out, palm down\n movement hold\n";
const BOTH: &str = "sign X\n hands both\n strong configuration flat\n strong placement right chest, 30cm away, with palm\n strong orientation fingers out, palm down\n strong movement hold\n weak configuration flat\n weak placement left chest, 30cm away, with palm\n weak orientation fingers out, palm down\n";
const MIRRORED: &str = "sign X\n hands both mirrored\n configuration flat\n placement chest, 30cm away\n orientation fingers out, palm down\n movement hold\n";

fn fine() -> Options {
    Options { fps: Fps::new(500.0).unwrap(), ..Options::default() }
}

fn with(text: &str, movement: Movement) -> Sign {
    let mut sign = sign(text);
    sign.strong.movement = vec![movement];
    sign
}

fn one(motion: Motion) -> Action {
    Action::new(motion)
}

fn act(action: Action) -> Movement {
    Movement::Action(Box::new(action))
}

fn way(direction: &str, metres: f64) -> Motion {
    let direction: Direction = direction.parse().unwrap();
    Motion::Straight { direction: direction.into(), extent: Extent::Metres(metres), overlay: None }
}

fn go(direction: &str, metres: f64) -> Movement {
    act(one(way(direction, metres)))
}

fn becomes(shape: &str) -> Action {
    let becoming = Becoming { configuration: Some(Configuration::named(shape)), ..Becoming::default() };
    Action { becoming: Some(Box::new(becoming)), ..one(Motion::Change) }
}

fn again(movement: Movement, repetition: Repetition) -> Movement {
    Movement::Repeated(Box::new(Repeated { movement, repetition, alternating: false }))
}

/// How far the fingers are from a named shape, radians.
fn off(performance: &Performance, time: f64, side: Side, shape: &str) -> f64 {
    let wanted = world().grammar.handshapes.find(shape, None).unwrap().angles();
    world().signer.hand(side).angles_of(&performance.track.clip.sample(Seconds(time)).pose).max_difference(&wanted)
}

fn wrist(performance: &Performance, time: f64, side: Side) -> DVec3 {
    body_at(performance, Seconds(time)).position(world().signer.arm(side).hand)
}

fn point(performance: &Performance, time: f64, side: Side, point: HandPoint) -> DVec3 {
    world().signer.landmarks.hand_point(side, point).unwrap().position(&body_at(performance, Seconds(time)))
}

fn on(digit: Digit, part: HandPart) -> HandPoint {
    HandPoint::of_digit(digit, part).unwrap()
}

fn limb(part: HandPart) -> HandPoint {
    HandPoint::new(Digits::NONE, part, None).unwrap()
}

/// From the first key to the last.
fn ends(performance: &Performance) -> (f64, f64) {
    (performance.report.keys[0].0, performance.report.keys.last().unwrap().0)
}

/// How far the palm is led from the first key to the last.
fn led(performance: &Performance, side: Side) -> DVec3 {
    let (first, last) = ends(performance);
    let palm = |time| point(performance, time, side, limb(HandPart::Palm));
    palm(last) - palm(first)
}

fn smooth(performance: &Performance) {
    let clip = &performance.track.clip;
    let (fps, skeleton) = (clip.fps().get(), &world().signer.skeleton);
    for side in [Side::Left, Side::Right] {
        let joint = world().signer.arm(side).hand;
        let at: Vec<DVec3> = clip.frames().iter().map(|f| f.pose.to_model(skeleton).position(joint)).collect();
        for (i, pair) in at.windows(2).enumerate() {
            let speed = pair[0].distance(pair[1]) * fps;
            assert!(speed < 3.2, "{side:?} wrist, frame {i}: {speed:.1} m/s");
        }
    }
}

#[test]
fn a_hand_becomes_what_a_movement_within_an_interval_says() {
    let parts = vec![go("up", 0.06), act(becomes("fist-s")), go("right", 0.06), act(becomes("5")), go("down", 0.06)];
    let performance = perform_with(&with(STILL, Movement::Sequence(parts)), &fine());
    let (first, last) = ends(&performance);
    let table = MovementTable::embedded();
    let timing = &table.timing;
    let length = |m: f64| timing.move_time * (m / table.straight.of(Size::Normal)).powf(timing.length_exponent);
    let legs = [0.06, 0.0, 0.06, 0.0, 0.06].map(|m| if m > 0.0 { length(m) } else { timing.change });
    let whole: f64 = legs.iter().sum();
    let mut at = first;
    for (leg, shape) in legs.iter().zip(["flat", "fist-s", "fist-s", "5", "5"]) {
        at += leg / whole * (last - first);
        assert!(off(&performance, at, Side::Right, shape) < 0.02, "{shape} at {at}");
    }
    assert!(off(&performance, performance.report.sign_end.0, Side::Right, "5") < 0.02);
    smooth(&performance);
}

#[test]
fn what_a_hand_became_holds_at_later_keys_until_they_say_another() {
    let mut sign = sign(STILL);
    sign.intervals = 3;
    sign.strong.movement = vec![act(becomes("fist-s")), go("up", 0.1), go("down", 0.1)];
    sign.strong.configuration =
        Keys::new(vec![(0, Configuration::named("flat")), (3, Configuration::named("5"))]).unwrap();
    let performance = perform_with(&sign, &fine());
    for (key, shape) in ["flat", "fist-s", "fist-s", "5"].into_iter().enumerate() {
        let time = performance.report.keys[key].0;
        assert!(off(&performance, time, Side::Right, shape) < 0.02, "{shape} at key {key}");
    }
}

#[test]
fn orientation_becomes_another_one_too() {
    let orientation =
        Orientation { fingers: None, palm: Some(Heading::Toward("up".parse().unwrap())), along_path: false };
    let becoming = Becoming { orientation: Some(orientation), ..Becoming::default() };
    let turn = Action { becoming: Some(Box::new(becoming)), ..one(Motion::Change) };
    let performance = perform_with(&with(STILL, Movement::Sequence(vec![act(turn), go("up", 0.1)])), &fine());
    let arm = world().signer.arm(Side::Right);
    let (_, last) = ends(&performance);
    let (fingers, palm) = arm.fingers_and_palm(body_at(&performance, Seconds(last)).rotation(arm.hand));
    assert!(palm.angle_between(DVec3::Y).to_degrees() < 3.0, "{palm}");
    assert!(fingers.angle_between(DVec3::Z).to_degrees() < 3.0, "{fingers}");
    smooth(&performance);
}

#[test]
fn each_performance_from_the_start_starts_in_the_posture_it_started_with() {
    let once = Movement::Sequence(vec![go("up", 0.08), act(becomes("fist-s"))]);
    let sign = with(STILL, again(once, Repetition::new(RepetitionKind::FromStart, 3)));
    let performance = perform_with(&sign, &fine());
    let (first, last) = ends(&performance);
    let (mut flat, mut before) = (0, false);
    for i in 0..=400 {
        let now = off(&performance, first + (last - first) * f64::from(i) / 400.0, Side::Right, "flat") < 0.05;
        flat += usize::from(now && !before);
        before = now;
    }
    assert_eq!(flat, 3, "the hand is flat at the start of each performance");
    assert!(off(&performance, last, Side::Right, "fist-s") < 0.02);
    assert!((led(&performance, Side::Right) - DVec3::Y * 0.08).length() < 3e-3);
}

#[test]
fn groups_repeat_from_the_start_on_and_on_and_to_and_fro() {
    let once = || Movement::Sequence(vec![go("right", 0.05), go("up", 0.04)]);
    for (kind, times, wanted) in [
        (RepetitionKind::FromStart, 3, DVec3::new(-0.05, 0.04, 0.0)),
        (RepetitionKind::Continue, 3, DVec3::new(-0.15, 0.12, 0.0)),
        (RepetitionKind::ToAndFro, 1, DVec3::ZERO),
        (RepetitionKind::ToAndFro, 2, DVec3::ZERO),
    ] {
        let performance = perform_with(&with(STILL, again(once(), Repetition::new(kind, times))), &fine());
        let end = led(&performance, Side::Right);
        assert!((end - wanted).length() < 4e-3, "{kind:?} {times}: {end}");
        // How often the far corner is reached.
        let (first, last) = ends(&performance);
        let start = wrist(&performance, first, Side::Right);
        let corner = DVec3::new(-0.05, 0.04, 0.0);
        let near = |i: i32| {
            let at = wrist(&performance, first + (last - first) * f64::from(i) / 600.0, Side::Right) - start;
            at.distance(corner) < 6e-3
        };
        let visits = (0..=600).filter(|i| near(*i) && (*i == 0 || !near(i - 1))).count();
        let expected = if kind == RepetitionKind::Continue { 1 } else { usize::from(times) };
        assert_eq!(visits, expected, "{kind:?} {times}");
        smooth(&performance);
    }
}

#[test]
fn growing_and_shifted_repetitions() {
    let grown = Repetition { growth: 1, ..Repetition::new(RepetitionKind::Continue, 3) };
    let performance = perform_with(&with(STILL, again(go("up", 0.04), grown)), &fine());
    assert!((led(&performance, Side::Right).y - 0.04 * (1.0 + 1.3 + 1.69)).abs() < 4e-3);

    let shift = Some(Shift { direction: "left".parse().unwrap(), size: Size::Normal });
    let left = MovementTable::embedded().straight.of(Size::Normal);
    for (kind, up) in
        [(RepetitionKind::FromStart, 0.05), (RepetitionKind::ToAndFro, 0.0), (RepetitionKind::Continue, 0.15)]
    {
        let shifted = Repetition { shift, ..Repetition::new(kind, 3) };
        for movement in
            [again(go("up", 0.05), shifted), act(Action { repetition: Some(shifted), ..one(way("up", 0.05)) })]
        {
            let end = led(&perform_with(&with(STILL, movement), &fine()), Side::Right);
            assert!((end - DVec3::new(left, up, 0.0)).length() < 4e-3, "{kind:?}: {end}");
        }
    }
    // A circle moves on while it is drawn.
    let circle = Motion::Circle {
        axis: Heading::Toward("left".parse().unwrap()),
        extent: Extent::Metres(0.04),
        start: Clock::default(),
        turns: 1.0,
        ellipse: None,
        growth: 0,
        overlay: None,
    };
    let shifted = Repetition { shift, ..Repetition::new(RepetitionKind::FromStart, 3) };
    let end = led(
        &perform_with(&with(STILL, act(Action { repetition: Some(shifted), ..one(circle) })), &fine()),
        Side::Right,
    );
    assert!((end - DVec3::X * left).length() < 4e-3, "{end}");
}

#[test]
fn alternating_groups_take_turns() {
    let group = Repeated {
        movement: Movement::Sequence(vec![go("up", 0.04), go("up", 0.03)]),
        repetition: Repetition::new(RepetitionKind::FromStart, 2),
        alternating: true,
    };
    let performance = perform_with(&with(MIRRORED, Movement::Repeated(Box::new(group))), &fine());
    let (first, last) = ends(&performance);
    let early = first + 0.2 * (last - first);
    let rise = |side| wrist(&performance, early, side).y - wrist(&performance, first, side).y;
    assert!(rise(Side::Right) * rise(Side::Left) < 0.0, "{} {}", rise(Side::Right), rise(Side::Left));
}

#[test]
fn the_longer_of_two_at_the_same_time_decides() {
    let both = Movement::Together(vec![go("up", 0.12), Movement::Sequence(vec![go("left", 0.06), go("out", 0.06)])]);
    let table = MovementTable::embedded();
    let legs = lay_out(&both, &table, Turns::default());
    let alone = lay_out(&Movement::Sequence(vec![go("left", 0.06), go("out", 0.06)]), &table, Turns::default());
    let whole = |legs: &[chereme::synthesis::legs::Leg]| legs.iter().map(|l| l.duration).sum::<f64>();
    assert!((whole(&legs) - whole(&alone)).abs() < 1e-9);
    let performance = perform_with(&with(STILL, both), &fine());
    assert!((led(&performance, Side::Right) - DVec3::new(0.06, 0.12, 0.06)).length() < 4e-3);
    smooth(&performance);
}

#[test]
fn repetitions_at_the_same_time_as_a_path_are_carried_along() {
    let bob = again(go("up", 0.04), Repetition::new(RepetitionKind::ToAndFro, 3));
    let performance = perform_with(&with(STILL, Movement::Together(vec![go("left", 0.15), bob])), &fine());
    assert!((led(&performance, Side::Right) - DVec3::X * 0.15).length() < 4e-3, "{}", led(&performance, Side::Right));
    let (first, last) = ends(&performance);
    let heights: Vec<f64> =
        (0..=300).map(|i| wrist(&performance, first + (last - first) * f64::from(i) / 300.0, Side::Right).y).collect();
    let tops = heights.windows(3).filter(|w| w[1] > w[0] && w[1] >= w[2] && w[1] > heights[0] + 0.02).count();
    assert_eq!(tops, 3);
    // And fingers and wrist play meanwhile.
    let plays = Movement::Together(vec![
        Movement::Sequence(vec![go("left", 0.1), go("right", 0.1)]),
        act(one(Motion::Wiggle(Digits::NONE))),
        act(one(Motion::Wrist(WristMotion::Twist, Size::Normal))),
    ]);
    let legs = lay_out(&plays, &MovementTable::embedded(), Turns::default());
    assert!(legs.len() == 2 && legs.iter().all(|l| l.wiggle.len() == 1 && l.wrist.len() == 1));
    smooth(&perform(&with(STILL, plays)));
}

#[test]
fn becoming_while_a_sequence_goes_on_is_spread_over_it() {
    let both =
        Movement::Together(vec![Movement::Sequence(vec![go("left", 0.08), go("up", 0.08)]), act(becomes("fist-s"))]);
    let performance = perform_with(&with(STILL, both), &fine());
    let (first, last) = ends(&performance);
    assert!(off(&performance, last, Side::Right, "fist-s") < 0.02);
    let half = off(&performance, (first + last) / 2.0, Side::Right, "fist-s");
    assert!(half > 0.2, "half way it is half way: {half}");
    smooth(&performance);
}

#[test]
fn bouncing_goes_back_a_little_and_returns() {
    let bounced = Action { manner: vec![Manner::Bouncing], ..one(way("down", 0.12)) };
    let performance = perform_with(&with(STILL, act(bounced)), &fine());
    let (first, last) = ends(&performance);
    let end = wrist(&performance, last, Side::Right);
    assert!((led(&performance, Side::Right) + DVec3::Y * 0.12).length() < 4e-3);
    // The lowest point comes before the end, and after it the hand rises once more.
    let heights: Vec<f64> = (0..=200)
        .map(|i| wrist(&performance, first + (last - first) * f64::from(i) / 200.0, Side::Right).y - end.y)
        .collect();
    let lowest = heights.iter().position(|h| *h < 2e-3).unwrap();
    let rebound = heights[lowest..].iter().copied().fold(0.0, f64::max);
    assert!((0.01..0.05).contains(&rebound), "{rebound}");
}

#[test]
fn fingers_change_one_after_the_other() {
    for (manner, first, last) in [(Manner::TowardPinky, 0usize, 3usize), (Manner::TowardThumb, 3, 0)] {
        let change = Action { manner: vec![manner], ..becomes("fist-s") };
        let performance = perform_with(&with(STILL, act(change)), &fine());
        let (start, end) = ends(&performance);
        let hand = world().signer.hand(Side::Right);
        let time = Seconds((start + end) / 2.0);
        let angles = hand.angles_of(&performance.track.clip.sample(time).pose);
        assert!(angles.fingers[first].pip > angles.fingers[last].pip + 0.3, "{manner:?}");
        assert!(off(&performance, end, Side::Right, "fist-s") < 0.02);
    }
}

#[test]
fn twice_the_pace_is_half_the_time() {
    let lasts = |pace: f64| {
        let performance = perform(&with(STILL, act(Action { pace, ..one(way("up", 0.2)) })));
        ends(&performance).1 - ends(&performance).0
    };
    assert!((lasts(0.5) - 2.0 * lasts(1.0)).abs() < 1e-9);
}

#[test]
fn a_brushed_place_is_touched_half_way() {
    let tip = on(Digit::Index, HandPart::Tip);
    let brushing =
        Placement { distance: Distance::Touch, with: Some(tip), ..Placement::at(Place::Body("chest".into())) };
    let text = "sign X\n configuration index\n placement chest, 8cm away, with index tip\n orientation fingers in-left, palm in\n movement hold\n";
    for (text, direction) in [(text.to_owned(), "down"), (text.replace("8cm away", "touch"), "left")] {
        let brushed = Action { brushing: Some(brushing.clone()), ..one(way(direction, 0.1)) };
        let performance = perform_with(&with(&text, act(brushed)), &fine());
        let (first, last) = ends(&performance);
        let chest = world().signer.landmarks.body_place("chest", None).unwrap();
        let half = (first + last) / 2.0;
        let miss =
            point(&performance, half, Side::Right, tip).distance(chest.position(&body_at(&performance, Seconds(half))));
        assert!(miss < 5e-3, "{direction}: {miss}");
        let way = point(&performance, last, Side::Right, tip) - point(&performance, first, Side::Right, tip);
        let wanted = direction.parse::<Direction>().unwrap().vector() * 0.1;
        assert!((way - wanted).length() < 5e-3, "{way}");
        smooth(&performance);
    }
}

#[test]
fn waves_swing_where_they_are_said_to_and_grow() {
    let table = MovementTable::embedded();
    let path = |overlay: Overlay, circle: bool| {
        let motion = if circle {
            Motion::Circle {
                axis: Heading::Between("up".parse().unwrap(), "out".parse().unwrap()),
                extent: Extent::Metres(0.1),
                start: Clock::default(),
                turns: 1.0,
                ellipse: None,
                growth: 0,
                overlay: Some(overlay),
            }
        } else {
            let direction: Direction = "left".parse().unwrap();
            Motion::Straight { direction: direction.into(), extent: Extent::Metres(0.2), overlay: Some(overlay) }
        };
        lay_out(&act(one(motion)), &table, Turns::default()).remove(0).path
    };
    let out = Overlay { across: Some("out".parse().unwrap()), ..Overlay::new(false, Size::Normal) };
    let shares = || (0..=400).map(|i| f64::from(i) / 400.0);
    let straight = path(out, false);
    let most = |axis: DVec3, from: f64, to: f64, path: &chereme::synthesis::path::Path| {
        shares().filter(|s| (from..=to).contains(s)).map(|s| path.at(s).dot(axis).abs()).fold(0.0, f64::max)
    };
    assert!(most(DVec3::Z, 0.0, 1.0, &straight) > 0.015 && most(DVec3::Y, 0.0, 1.0, &straight) < 1e-9);
    let growing = path(Overlay { growth: 1, ..out }, false);
    assert!(most(DVec3::Z, 0.5, 1.0, &growing) > 1.4 * most(DVec3::Z, 0.0, 0.5, &growing));
    let circle = path(Overlay::new(true, Size::Normal), true);
    let axis = DVec3::new(0.0, 1.0, 1.0).normalize();
    assert!(most(axis, 0.0, 1.0, &circle) > 0.015 && circle.closes());
    let (bulge, chord) = (Heading::Between("up".parse().unwrap(), "left".parse().unwrap()), "out");
    let chord: Direction = chord.parse().unwrap();
    let arc =
        Motion::Arc { direction: chord.into(), extent: Extent::Metres(0.2), bulge, depth: Size::Large, overlay: None };
    let top = lay_out(&act(one(arc)), &table, Turns::default()).remove(0).path.at(0.5) - DVec3::Z * 0.1;
    assert!(top.normalize().dot(bulge.vector()) > 0.999);
}

#[test]
fn every_point_of_hand_and_arm_is_somewhere() {
    let landmarks = &world().signer.landmarks;
    let flanks = || Flank::ALL.into_iter().map(Some).chain([None]);
    let mut all = Vec::new();
    for part in HandPart::all() {
        for flank in flanks() {
            let digits: Vec<Digits> = if part.needs_digit() {
                Digit::ALL
                    .into_iter()
                    .map(|d| Digits::of([d]))
                    .chain([Digits::FINGERS, Digits::of(Digit::ALL)])
                    .collect()
            } else {
                vec![Digits::NONE]
            };
            all.extend(digits.into_iter().filter_map(|d| HandPoint::new(d, part, flank)));
        }
    }
    assert!(all.len() > 240, "{}", all.len());
    for side in [Side::Left, Side::Right] {
        for (i, point) in all.iter().enumerate() {
            landmarks.hand_point(side, *point).unwrap_or_else(|e| panic!("{point}: {e}"));
            let other = all[(i * 7 + 3) % all.len()];
            landmarks.hand_point(side, point.halfway(other)).unwrap_or_else(|e| panic!("{point}: {e}"));
        }
    }
    let body = chereme::motion::pose::LocalPose::rest(&world().signer.skeleton).to_model(&world().signer.skeleton);
    let at = |p: HandPoint| landmarks.hand_point(Side::Left, p).unwrap().position(&body);
    let (fingers, thumb) =
        (HandPoint::new(Digits::FINGERS, HandPart::Tip, None).unwrap(), on(Digit::Thumb, HandPart::Tip));
    assert!(at(fingers.halfway(thumb)).distance((at(fingers) + at(thumb)) / 2.0) < 1e-9);
}

#[test]
fn the_other_arm_is_touched_where_it_is_whether_it_acts_or_not() {
    let tip = on(Digit::Index, HandPart::Tip);
    let parts = [HandPart::UpperArm, HandPart::Elbow, HandPart::ElbowInside, HandPart::LowerArm, HandPart::WristBack];
    for part in parts {
        for flank in [None, Some(Flank::Dorsal), Some(Flank::Radial)] {
            let there = HandPoint::new(Digits::NONE, part, flank).unwrap();
            let place = Placement { with: Some(tip), ..Placement::at(Place::OtherHand(there)) };
            for text in ["sign X\n configuration index\n movement hold\n", BOTH] {
                let mut sign = sign(text);
                sign.strong.configuration = Keys::one(Configuration::named("index"));
                sign.strong.placement = Keys::one(place.clone());
                sign.strong.orientation = Keys::default();
                let performance = perform_with(&sign, &fine());
                let (first, _) = ends(&performance);
                let miss = point(&performance, first, Side::Right, tip).distance(point(
                    &performance,
                    first,
                    Side::Left,
                    there,
                ));
                let warned = !performance.report.warnings.is_empty();
                assert!(miss < 5e-3 || warned, "{there}: {:.1} mm", miss * 1e3);
            }
        }
    }
}

#[test]
fn two_hands_that_are_on_each_other_are_no_error() {
    let palm = || Placement {
        distance: Distance::Touch,
        with: Some(limb(HandPart::Palm)),
        ..Placement::at(Place::OtherHand(limb(HandPart::Palm)))
    };
    let mut mirrored = sign(MIRRORED);
    mirrored.strong.placement = Keys::one(palm());
    mirrored.strong.orientation = Keys::one(Orientation {
        fingers: Some(Heading::Toward("up".parse().unwrap())),
        palm: Some(Heading::Toward("left".parse().unwrap())),
        along_path: false,
    });
    let performance = perform_with(&mirrored, &fine());
    let (first, _) = ends(&performance);
    let [left, right] = [Side::Left, Side::Right].map(|side| point(&performance, first, side, limb(HandPart::Palm)));
    assert!(left.distance(right) < 5e-3 && left.x.abs() < 0.02, "{left} {right}");

    let mut plain = sign(BOTH);
    plain.strong.placement = Keys::one(palm());
    plain.weak.placement = Keys::one(palm());
    let performance = perform_with(&plain, &fine());
    assert!(performance.report.warnings.iter().any(|w| w.contains("each hand")), "{:?}", performance.report.warnings);
    let (first, _) = ends(&performance);
    let [left, right] = [Side::Left, Side::Right].map(|side| point(&performance, first, side, limb(HandPart::Palm)));
    assert!(left.distance(right) < 5e-3 && left.x > 0.002, "{left} {right}");
}

#[test]
fn a_place_that_a_movement_named_is_found_again() {
    let named = Action { names: Some("there".into()), ..one(way("up", 0.15)) };
    let back = |name: &str| {
        let target = Placement { with: Some(limb(HandPart::Palm)), ..Placement::at(Place::Referent(name.into())) };
        Action { target: Some(target), ..one(Motion::Change) }
    };
    let mut sign = sign(STILL);
    sign.intervals = 3;
    sign.strong.movement = vec![act(named), go("left", 0.15), act(back("there"))];
    let performance = perform_with(&sign, &fine());
    let keys = &performance.report.keys;
    let palm = |key: usize| point(&performance, keys[key].0, Side::Right, limb(HandPart::Palm));
    assert!(palm(1).distance(palm(3)) < 5e-3 && palm(1).distance(palm(2)) > 0.1);
    assert!(!performance.report.warnings.iter().any(|w| w.contains("referent")));
    sign.strong.movement[2] = act(back("nowhere"));
    let lost = perform(&sign);
    assert!(lost.report.warnings.iter().any(|w| w.contains("nowhere")), "{:?}", lost.report.warnings);
}

#[test]
fn contacts_hold_in_all_their_kinds() {
    let (tip, palm, back) = (on(Digit::Index, HandPart::Tip), limb(HandPart::Palm), limb(HandPart::Back));
    let arm = world().signer.landmarks.arm_length();
    for text in [BOTH, MIRRORED] {
        for (kind, apart) in [
            (ContactKind::Touch, 0.0),
            (ContactKind::Crossed, 0.0),
            // A hand that goes over to the other stays farther off.
            (ContactKind::Close, if text == BOTH { 0.132 * arm } else { 0.06 * arm }),
            (ContactKind::Metres(0.1), 0.1),
        ] {
            for (strong, weak) in [(tip, palm), (palm, back), (palm, palm)] {
                let mut sign = sign(text);
                sign.contact = Keys::one(Contact { strong: Some(strong), weak: Some(weak), kind });
                let performance = perform_with(&sign, &fine());
                let (first, _) = ends(&performance);
                let gap = point(&performance, first, Side::Right, strong).distance(point(
                    &performance,
                    first,
                    Side::Left,
                    weak,
                ));
                assert!((gap - apart).abs() < 5e-3, "{kind:?} {strong} {weak}: {:.1} mm", gap * 1e3);
            }
        }
    }
}

#[test]
fn open_contacts_are_of_what_the_shapes_touch_with() {
    for kind in ContactKind::NAMED {
        for text in [BOTH, MIRRORED, "sign X\n configuration flat\n movement hold\n"] {
            let mut sign = sign(text);
            sign.contact = Keys::one(Contact { strong: None, weak: None, kind });
            let performance = perform(&sign);
            smooth(&performance);
        }
    }
}

#[test]
fn a_contact_is_reached_by_a_movement() {
    let palm = limb(HandPart::Palm);
    for text in [BOTH, MIRRORED] {
        let mut sign = with(text, go("left", 0.1));
        sign.contact =
            Keys::new(vec![(1, Contact { strong: Some(palm), weak: Some(palm), kind: ContactKind::Touch })]).unwrap();
        let performance = perform_with(&sign, &fine());
        let (first, last) = ends(&performance);
        let gap = |time: f64| {
            point(&performance, time, Side::Right, palm).distance(point(&performance, time, Side::Left, palm))
        };
        assert!(gap(last) < 5e-3, "{:.1} mm", gap(last) * 1e3);
        assert!(gap(first) > 0.05);
        // Within an interval it is an action's becoming.
        let contact = Contact { strong: Some(palm), weak: Some(palm), kind: ContactKind::Touch };
        let becoming = Becoming { contact: Some(contact), ..Becoming::default() };
        let meet = Action { becoming: Some(Box::new(becoming)), ..one(Motion::Change) };
        let performance = perform_with(&with(text, Movement::Sequence(vec![go("up", 0.05), act(meet)])), &fine());
        let (_, last) = ends(&performance);
        let gap = point(&performance, last, Side::Right, palm).distance(point(&performance, last, Side::Left, palm));
        assert!(gap < 5e-3, "becoming: {:.1} mm", gap * 1e3);
    }
}

#[test]
fn fingers_of_interlocked_hands_lie_between_each_other() {
    let text = "sign X\n hands both mirrored\n configuration 5\n placement chest, 25cm away\n orientation fingers up-out, palm left\n movement hold\n";
    let mut sign = sign(text);
    sign.contact = Keys::one(Contact { strong: None, weak: None, kind: ContactKind::Interlocked });
    let performance = perform_with(&sign, &fine());
    let body = body_at(&performance, performance.report.keys[0]);
    let root = |side: Side, digit: Digit| {
        let joints = world().signer.hand(side).of_digit(digit);
        body.position(joints[0]).lerp(body.position(joints[1]), 0.45)
    };
    let across = (root(Side::Right, Digit::Index) - root(Side::Right, Digit::Pinky)).normalize();
    let mut order: Vec<(f64, Side)> = Digit::FINGERS
        .into_iter()
        .flat_map(|d| [(root(Side::Right, d).dot(across), Side::Right), (root(Side::Left, d).dot(across), Side::Left)])
        .collect();
    order.sort_by(|a, b| a.0.total_cmp(&b.0));
    assert!(order.windows(2).all(|w| w[0].1 != w[1].1), "fingers take turns: {order:?}");
    let middle = |side| Digit::FINGERS.into_iter().map(|d| root(side, d)).sum::<DVec3>() / 4.0;
    assert!(middle(Side::Right).distance(middle(Side::Left)) < 0.02);
}

#[test]
fn hands_that_move_on_together_stay_together_and_go_as_far_as_they_say() {
    let palm = limb(HandPart::Palm);
    let mut sign = with(BOTH, go("up", 0.1));
    sign.weak.movement = vec![go("up", 0.1)];
    sign.contact =
        Keys::one(Contact { strong: Some(palm), weak: Some(limb(HandPart::Back)), kind: ContactKind::Touch });
    let performance = perform_with(&sign, &fine());
    for side in [Side::Left, Side::Right] {
        assert!((led(&performance, side) - DVec3::Y * 0.1).length() < 5e-3, "{side:?} {}", led(&performance, side));
    }
}

fn phased() -> Sign {
    let mut first = sign(
        "sign TWO\n hands both mirrored\n configuration flat\n placement chest, 25cm away\n orientation fingers out, palm down\n movement up 8cm\n brows raised\n",
    );
    let second =
        sign("sign X\n configuration index\n placement forehead, touch, with index tip\n movement hold then out 8cm\n");
    let third = sign(
        "sign X\n hands both mirrored\n configuration fist-s\n placement stomach, 20cm away\n movement down 8cm\n",
    );
    first.then = vec![second, third];
    first
}

#[test]
fn phases_follow_each_other_as_one_sign() {
    let sign = phased();
    let performance = perform_with(&sign, &fine());
    let (track, report) = (&performance.track, &performance.report);
    assert_eq!(report.keys.len(), 2 + 3 + 2);
    assert!(report.keys.windows(2).all(|k| k[0] <= k[1]));
    assert_eq!(report.items.len(), 1);
    assert_eq!((report.items[0].stroke, report.items[0].hold_end), (report.stroke_start, report.sign_end));
    for (key, shape) in [(0, "flat"), (1, "flat"), (2, "index"), (4, "index"), (5, "fist-s"), (6, "fist-s")] {
        assert!(off(&performance, report.keys[key].0, Side::Right, shape) < 0.02, "{shape} at key {key}");
    }
    for name in ["RH Gloss", "LH Gloss"] {
        let gloss = track.tier(name).unwrap().values();
        assert_eq!(gloss.len(), 1, "{name}");
        assert_eq!((gloss[0].start, gloss[0].end), (report.stroke_start, report.sign_end));
    }
    let phases: Vec<&str> = track.tier("RH Phase").unwrap().values().iter().map(|v| v.label.as_str()).collect();
    assert_eq!(
        phases,
        ["preparation", "stroke", "hold", "transition", "stroke", "hold", "transition", "stroke", "hold", "retraction"]
    );
    let brows = track.tier("Brows").unwrap().values();
    assert_eq!((brows[0].start, brows[0].end), (report.stroke_start, report.sign_end));
    smooth(&performance);
    // Measured and scheduled as one.
    let world = world();
    let plan = Plan::of(sign);
    let measured = measure(&plan, &world.grammar, &world.signer, &Options::default()).unwrap();
    assert_eq!(measured.items.len(), 1);
    let schedule = measured.schedule();
    let at_its_times = render(&plan, &schedule, &world.grammar, &world.signer, &Options::default()).unwrap();
    let own = perform(&phased());
    assert_eq!(at_its_times.report.items, own.report.items);
    for (a, b) in at_its_times.report.keys.iter().zip(&own.report.keys) {
        assert!((a.0 - b.0).abs() < 1e-9);
    }
}

#[test]
fn a_hand_without_a_part_in_a_phase_rests_or_stays() {
    let resting = phased();
    let mut staying = resting.clone();
    staying.then[0].holds_over = true;
    let rest = wrist(&perform(&resting), 0.0, Side::Left);
    for (sign, stays) in [(&resting, false), (&staying, true)] {
        let performance = perform_with(sign, &fine());
        let keys = &performance.report.keys;
        let (before, during) = (wrist(&performance, keys[1].0, Side::Left), wrist(&performance, keys[4].0, Side::Left));
        assert_eq!(before.distance(during) < 1e-3, stays, "{before} {during} {rest}");
    }
}

#[test]
fn phases_last_as_long_as_the_whole_says() {
    let mut sign = phased();
    sign.duration = Some(Seconds(3.0));
    let report = perform(&sign).report;
    let (first, last) = (report.keys[0].0, report.keys.last().unwrap().0);
    assert!((last - first - 3.0).abs() < 1e-6, "{}", last - first);
}

#[test]
fn phases_in_a_line_are_one_item_of_it() {
    let item = |sign: Sign| Item { gloss: sign.name.clone(), act: Act::Sign(Box::new(sign)), span: None };
    let plan = Plan { items: vec![item(sign(STILL)), item(phased()), item(sign(STILL))], spans: Vec::new() };
    let world = world();
    let made = chereme::synthesis::synthesize_plan(&plan, &world.grammar, &world.signer, &Options::default()).unwrap();
    assert_eq!(made.report.items.len(), 3);
    assert_eq!(made.track.tier("RH Gloss").unwrap().values().len(), 3);
    let plan = Plan {
        spans: vec![chereme::score::plan::Over {
            items: 1..2,
            channel: Channel::Brows,
            value: NonManual::plain(NonManualValue::Named("raised".into())),
        }],
        ..plan
    };
    let made = chereme::synthesis::synthesize_plan(&plan, &world.grammar, &world.signer, &Options::default()).unwrap();
    let brows = made.track.tier("Brows").unwrap().values();
    assert!(brows.iter().any(|v| (v.start, v.end) == (made.report.items[1].stroke, made.report.items[1].hold_end)));
}

#[test]
fn operators_on_motion_take_phases_as_one_sign() {
    use chereme::synthesis::edit::track;
    let performance = perform(&phased());
    let phases = track::Phases::of(&performance.track).unwrap();
    assert_eq!((phases.stroke, phases.sign_end), (performance.report.stroke_start, performance.report.sign_end));
    let easing = chereme::motion::easing::Easing::default();
    track::inverted(&performance.track, &world().signer, easing).unwrap();
    track::at_speed(&performance.track, 2.0).unwrap();
}

#[test]
fn what_a_wrist_cannot_do_is_bounded_in_time_and_speed() {
    let headings: Vec<Heading> = ["up", "down", "in", "left-in", "down-in", "right-in"]
        .iter()
        .map(|d| d.split('-').rev().collect::<Vec<_>>().join("-").parse::<Direction>().unwrap().into())
        .collect();
    for from in &headings {
        for to in &headings {
            for palm in ["up", "left", "out", "right"] {
                let palm: Heading = palm.parse::<Direction>().unwrap().into();
                let said =
                    |fingers: &Heading| Orientation { fingers: Some(*fingers), palm: Some(palm), along_path: false };
                let mut sign = with(STILL, go("left", 0.2));
                sign.strong.orientation = Keys::new(vec![(0, said(from)), (1, said(to))]).unwrap();
                let performance = perform(&sign);
                let lasts = performance.report.sign_end.0 - performance.report.stroke_start.0;
                assert!(lasts <= 4.3, "{from} {to}: {lasts:.1} s");
                assert!(
                    performance.report.wrist_speed <= 3.3,
                    "{from} {to} {palm}: {:.1} m/s",
                    performance.report.wrist_speed
                );
            }
        }
    }
}

#[test]
fn nonsense_numbers_are_no_trouble() {
    let circle = |turns: f64, metres: f64| Motion::Circle {
        axis: Heading::Toward("up".parse().unwrap()),
        extent: Extent::Metres(metres),
        start: Clock::default(),
        turns,
        ellipse: Some((f64::NAN, "left".parse().unwrap())),
        growth: 9,
        overlay: Some(Overlay { growth: -3, ..Overlay::new(true, Size::Large) }),
    };
    for bad in [f64::NAN, f64::INFINITY, -1.0, 0.0, 1e300] {
        let actions = [
            one(way("up", bad)),
            one(circle(bad, 0.1)),
            one(circle(1.0, bad)),
            Action { pace: bad, ..one(way("up", 0.1)) },
            Action { target: Some(Placement::at(Place::Point(DVec3::splat(bad)))), ..one(Motion::Change) },
            Action {
                target: Some(Placement {
                    distance: Distance::Metres(bad),
                    ..Placement::at(Place::Body("chest".into()))
                }),
                ..one(Motion::Change)
            },
        ];
        for action in actions {
            let performance = perform(&with(STILL, act(action)));
            assert!(performance.track.clip.frames().iter().all(|f| f.pose.rotations.iter().all(|q| q.is_finite())));
        }
    }
    // Repetitions in repetitions come to an end.
    let mut deep = go("up", 0.05);
    for _ in 0..5 {
        deep = again(deep, Repetition { growth: 1, ..Repetition::new(RepetitionKind::FromStart, 250) });
    }
    let performance = perform_with(&with(STILL, deep), &Options { fps: Fps::new(10.0).unwrap(), ..Options::default() });
    assert!(performance.track.clip.frames().len() < 2000);
    assert_eq!(angle_between(performance.track.clip.frames()[0].pose.rotations[0], glam::DQuat::IDENTITY), 0.0);
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 100, failure_persistence: None, ..ProptestConfig::default() })]

    /// Whatever the model holds becomes finite motion of a bounded length, with phases too; only unknown names, and
    /// times that nobody could keep, are refused.
    #[test]
    fn any_sign_is_signed(sign in strategies::sign(Words::known())) {
        let world = world();
        let options = Options { fps: Fps::new(20.0).unwrap(), ..Options::default() };
        match synthesize(&sign, &world.grammar, &world.signer, &options) {
            Err(error) => prop_assert!(error.to_string().contains("more time") || error.to_string().contains("handshape"), "{}", error),
            Ok(performance) => {
                for frame in performance.track.clip.frames() {
                    prop_assert!(frame.pose.rotations.iter().all(|q| q.is_finite() && (q.length() - 1.0).abs() < 1e-6));
                }
            }
        }
    }
}
