//! Described signs as motion: expectations 12, 13, 38, 46, 47, 48 and 50 of facts/phonology.md §9, and the
//! assertions of the goal: contact points, orientations, wrists.

use crate::signing::{body_at, perform, perform_with, sign, signs_of, world};
use crate::strategies::{self, Words};
use chereme::body::arm::WristLimits;
use chereme::format::glb;
use chereme::motion::arm::orient;
use chereme::motion::rotation::angle_between;
use chereme::phonology::{Distance, Hand, Hands, Place, Side, Sign, symmetry};
use chereme::synthesis::{Options, Performance, side_of};
use chereme::time::{Fps, FrameIndex, Seconds};
use glam::{DQuat, DVec3};
use proptest::prelude::*;

/// Frames from the first to the last of the stroke and its hold.
fn stroke(performance: &Performance) -> std::ops::Range<usize> {
    let (report, fps) = (&performance.report, performance.track.clip.fps().get());
    let first = (report.stroke_start.0 * fps).ceil() as usize;
    first..(report.sign_end.0 * fps).floor() as usize + 1
}

#[test]
fn expectations_12_and_13_every_quaternion_is_a_unit_and_neighbours_are_on_one_side() {
    for sign in signs_of("lsf") {
        let clip = perform(&sign).track.clip;
        for pair in clip.frames().windows(2) {
            for (p, q) in pair[0].pose.rotations.iter().zip(&pair[1].pose.rotations) {
                assert!((q.length() - 1.0).abs() < 1e-6, "{}", sign.name);
                assert!(p.dot(*q) >= 0.0, "{}", sign.name);
            }
        }
    }
}

#[test]
fn expectation_38_dodo_is_d_o_d_o_at_its_keys() {
    let dodo = signs_of("lsf").into_iter().find(|s| s.name == "DODO").expect("DODO");
    let performance = perform(&dodo);
    assert_eq!(performance.report.keys.len(), 4);
    let hand = world().signer.hand(Side::Right);
    for (time, letter) in performance.report.keys.iter().zip(["D", "O", "D", "O"]) {
        let wanted = world().grammar.handshapes.find(letter, Some("lsf")).unwrap().angles();
        // The clip's frames stand beside the key by up to half a frame; sampled finely, the shape is there.
        let pose = perform_with(&dodo, &Options { fps: Fps::new(1000.0).unwrap(), ..Options::default() });
        let found = hand.angles_of(&pose.track.clip.sample(*time).pose);
        assert!(found.max_difference(&wanted) < 1e-3, "{letter} at {time}: {}", found.max_difference(&wanted));
    }
}

#[test]
fn expectation_46_the_tiers_stand_at_the_keys() {
    for sign in signs_of("lsf") {
        let Performance { track, report } = perform(&sign);
        let half_a_frame = 0.5 / track.clip.fps().get();
        let near = |time: Seconds, all: &[Seconds]| all.iter().any(|k| (k.0 - time.0).abs() <= half_a_frame);
        let mut ends = report.keys.clone();
        ends.push(report.sign_end);
        for tier in track.tiers.iter().filter(|t| !t.name.ends_with("Phase")) {
            for value in tier.values() {
                assert!(near(value.start, &ends) && near(value.end, &ends), "{}: {} {value:?}", sign.name, tier.name);
            }
        }
    }
}

#[test]
fn expectation_46_the_hand_moves_when_its_movement_tier_says_so() {
    // Two intervals with a change of shape: the shape is D's at the first key, E's at the last, half-way at the middle.
    let text = "sign X\n configuration flat then fist-s then flat\n movement up 10cm then down 10cm\n";
    let performance = perform(&sign(text));
    let hand = world().signer.hand(Side::Right);
    let shape = |name: &str| world().grammar.handshapes.find(name, None).unwrap().angles();
    for (time, name) in performance.report.keys.iter().zip(["flat", "fist-s", "flat"]) {
        let found = hand.angles_of(&performance.track.clip.sample(*time).pose);
        assert!(found.max_difference(&shape(name)) < 0.05, "{name} at {time}");
    }
}

#[test]
fn expectation_47_the_same_sign_gives_the_same_bytes() {
    let bytes = || {
        let sign = sign("sign X\n hands both mirrored\n configuration flat\n movement circle axis up turns 2\n");
        glb::write(chereme::avatar::GLB, &perform(&sign).track).unwrap()
    };
    assert!(bytes() == bytes());
}

#[test]
fn expectation_48_signs_last_as_signs_do_and_wrists_stay_slow() {
    for language in ["lsf", "asl", "lsfb", "lis", "bsl"] {
        for sign in signs_of(language) {
            let report = perform(&sign).report;
            let lasts = report.sign_end.0 - report.stroke_start.0;
            let most = if sign.intervals <= 1 && !repeats(&sign) { 1.4 } else { 4.0 };
            assert!((0.4 - 1e-9..=most).contains(&lasts), "{language} {} lasts {lasts:.2} s", sign.name);
            assert!(report.wrist_speed <= 3.0, "{language} {}: {:.2} m/s", sign.name, report.wrist_speed);
        }
    }
}

fn repeats(sign: &Sign) -> bool {
    format!("{:?}", sign.strong.movement).contains("repetition: Some")
}

#[test]
fn a_hurried_sign_is_warned_of_and_an_impossible_one_refused() {
    let hurried = sign("sign X\n placement chest, 20cm away\n movement up 60cm duration 0.3s\n");
    let performance = perform(&hurried);
    assert!(performance.report.warnings.iter().any(|w| w.contains("m/s")), "{:?}", performance.report.warnings);
    let impossible = sign("sign X\n placement chest, 20cm away\n movement up 60cm duration 0.1s\n");
    let world = world();
    let refused = chereme::synthesis::synthesize(&impossible, &world.grammar, &world.signer, &Options::default());
    assert!(refused.is_err_and(|e| e.to_string().contains("more time")));
}

#[test]
fn expectation_50_twice_the_speed_is_half_the_time_on_the_same_path() {
    for text in [
        "sign X\n movement circle axis out radius 8cm turns 2\n",
        "sign X\n hands both mirrored\n placement chest, 25cm away\n movement arc up-right 15cm then down 10cm\n",
    ] {
        let sign = sign(text);
        let slow = perform_with(&sign, &Options { fps: Fps::new(60.0).unwrap(), ..Options::default() });
        let fast = perform_with(&sign, &Options { fps: Fps::new(120.0).unwrap(), speed: 2.0, ..Options::default() });
        let lasts = |p: &Performance| p.report.sign_end.0 - p.report.stroke_start.0;
        assert!((lasts(&slow) - 2.0 * lasts(&fast)).abs() < 1e-9);
        let wrist = world().signer.arm(Side::Right).hand;
        for i in 0..=40 {
            let share = f64::from(i) / 40.0;
            let at = |p: &Performance| {
                let time = p.report.stroke_start.0 + share * lasts(p);
                body_at(p, Seconds(time)).position(wrist)
            };
            assert!(at(&slow).distance(at(&fast)) < 1e-3, "{text}at {share}: {}", at(&slow).distance(at(&fast)));
        }
    }
}

/// Contact points that a description puts on the skin, checked on the finished clip.
#[test]
fn contact_points_are_within_5_mm_of_their_landmark() {
    let (mut checked, mut greatest) = (0, 0.0f64);
    for language in ["lsf", "bsl"] {
        for sign in signs_of(language) {
            let (here, miss) = check_contacts(&sign);
            checked += here;
            greatest = greatest.max(miss);
        }
    }
    println!("{checked} contacts, the greatest miss {greatest:.3} mm");
    assert!(checked >= 20, "only {checked} contacts were found to check");
}

/// Every place touched by the tip of the index finger: the picture of places is made from the same file.
#[test]
fn every_place_is_touched_by_the_index_finger() {
    let text = include_str!("../suite/synthesis/places.sign");
    let reading = chereme::notation::read(text, &world().vocabulary, "test");
    assert_eq!(reading.diagnostics, []);
    assert_eq!(reading.signs.len(), 44, "the 44 locations of HamNoSys");
    let checked: usize = reading.signs.iter().map(|s| check_contacts(&s.sign).0).sum();
    assert_eq!(checked, 43, "all but neutral space are on the skin");
    for sign in &reading.signs {
        let report = perform(&sign.sign).report;
        assert!(report.residual_m < 5e-3, "{}: {:?}", sign.sign.name, report.warnings);
    }
}

fn check_contacts(sign: &Sign) -> (usize, f64) {
    let world = world();
    let (landmarks, grammar) = (&world.signer.landmarks, &world.grammar);
    // Sampled at a thousand frames a second, the keys are hit.
    let performance = perform_with(sign, &Options { fps: Fps::new(1000.0).unwrap(), ..Options::default() });
    let (mut checked, mut greatest) = (0, 0.0f64);
    for hand in Hand::BOTH.into_iter().filter(|h| symmetry::acts(sign, *h)) {
        let side = side_of(hand);
        let said = symmetry::resolve(sign, hand);
        for (key, placement) in said.placement.iter() {
            let body = body_at(&performance, performance.report.keys[key]);
            let shape = said.configuration.at(key).map_or("rest", |c| c.base.as_str());
            let shape = grammar.handshapes.find(shape, Some(&sign.language)).unwrap();
            let own = landmarks.hand_point(side, placement.with.unwrap_or(shape.touches_with)).unwrap();
            let place = match (&placement.place, placement.distance) {
                (Place::OtherHand(point), Distance::Touch | Distance::Unmarked) => {
                    landmarks.hand_point(side.other(), *point).unwrap().position(&body)
                }
                (Place::Body(name), Distance::Touch) => {
                    let row = grammar.locations.get(name).unwrap();
                    let own_side = chereme::phonology::Lateral { side, beside: false };
                    let lateral = placement.lateral.or(row.paired.then_some(own_side));
                    landmarks.body_place(&row.id, lateral).unwrap().position(&body)
                }
                _ => continue,
            };
            let offset = placement.offset.map_or(DVec3::ZERO, |(d, metres)| d.vector() * metres);
            let miss = own.position(&body).distance(place + offset) * 1e3;
            assert!(miss < 5.0, "{} {}, {hand:?} hand, key {key}: {miss:.1} mm off", sign.language, sign.name);
            checked += 1;
            greatest = greatest.max(miss);
        }
    }
    for (key, contact) in sign.contact.iter().filter(|_| matches!(sign.hands, Hands::Both(_))) {
        if contact.kind != chereme::phonology::ContactKind::Touch {
            continue;
        }
        let body = body_at(&performance, performance.report.keys[key]);
        let at = |side, point| landmarks.hand_point(side, point).unwrap().position(&body);
        let miss = at(Side::Right, contact.strong.unwrap()).distance(at(Side::Left, contact.weak.unwrap())) * 1e3;
        assert!(miss < 5.0, "{}: the hands meet {miss:.1} mm apart", sign.name);
        checked += 1;
        greatest = greatest.max(miss);
    }
    (checked, greatest)
}

#[test]
fn stated_directions_hold_within_2_degrees_where_the_wrist_goes_that_far() {
    let mut checked = 0;
    for sign in signs_of("lsf") {
        let performance = perform_with(&sign, &Options { fps: Fps::new(1000.0).unwrap(), ..Options::default() });
        if performance.report.tilt > 2f64.to_radians() || performance.report.keys.is_empty() {
            continue;
        }
        for hand in Hand::BOTH.into_iter().filter(|h| symmetry::acts(&sign, *h)) {
            let arm = world().signer.arm(side_of(hand));
            for (key, stated) in symmetry::resolve(&sign, hand).orientation.iter() {
                // At the first and last key no wrist movement plays.
                let body = body_at(&performance, performance.report.keys[key]);
                let (fingers, palm) = arm.fingers_and_palm(body.rotation(arm.hand));
                if let Some(heading) = stated.fingers {
                    let off = fingers.angle_between(heading.vector()).to_degrees();
                    assert!(off < 2.0, "{} key {key}: fingers {off:.1}° off {heading}", sign.name);
                    checked += 1;
                }
                if let Some(heading) = stated.palm {
                    let across = heading.vector().reject_from_normalized(fingers);
                    let off = palm.angle_between(across).to_degrees();
                    assert!(off < 2.0, "{} key {key}: palm {off:.1}° off {heading}", sign.name);
                    checked += 1;
                }
            }
        }
    }
    assert!(checked >= 40, "only {checked} directions were checked");
}

/// The angles of an arm, measured back from a finished pose.
fn wrist_angles(performance: &Performance, frame: usize, side: Side) -> chereme::motion::arm::ArmAngles {
    let arm = world().signer.arm(side);
    let body = body_at(performance, performance.track.clip.fps().time_of(FrameIndex(frame)));
    let joints = [arm.upper, arm.fore, arm.hand].map(|j| body.position(j));
    orient(&arm.rest, body.rotation(arm.clavicle), joints, body.rotation(arm.hand), None).angles
}

#[test]
fn wrists_bend_like_wrists_in_every_frame_of_every_stroke() {
    for language in ["lsf", "asl", "bsl"] {
        for sign in signs_of(language) {
            let performance = perform(&sign);
            for hand in Hand::BOTH.into_iter().filter(|h| symmetry::acts(&sign, *h)) {
                for frame in stroke(&performance) {
                    let angles = wrist_angles(&performance, frame, side_of(hand));
                    let over = WristLimits::ANATOMICAL.excess(&angles).sqrt().to_degrees();
                    assert!(over < 0.5, "{language} {} frame {frame}: {over:.1}° past the wrist's limits", sign.name);
                }
            }
        }
    }
}

#[test]
fn elbows_do_not_jump() {
    for sign in signs_of("lsf") {
        let performance = perform(&sign);
        let fps = performance.track.clip.fps();
        for side in [Side::Left, Side::Right] {
            let elbow = world().signer.arm(side).fore;
            let at = |i: usize| body_at(&performance, fps.time_of(FrameIndex(i))).position(elbow);
            for i in 1..performance.track.clip.frames().len() {
                let step = at(i).distance(at(i - 1)) * fps.get();
                assert!(step < 2.5, "{} frame {i}: the elbow moves at {step:.1} m/s", sign.name);
            }
        }
    }
}

#[test]
fn a_hand_that_does_not_act_hangs_still() {
    let performance = perform(&sign("sign X\n configuration index\n movement up 10cm\n"));
    let frames = performance.track.clip.frames();
    let arm = world().signer.arm(Side::Left);
    for joint in [arm.clavicle, arm.upper, arm.fore, arm.hand] {
        assert!(frames.iter().all(|f| f.pose.rotation(joint) == frames[0].pose.rotation(joint)));
    }
}

#[test]
fn both_ends_are_the_neutral_pose() {
    for sign in signs_of("lsf") {
        let clip = perform(&sign).track.clip;
        let (first, last) = (&clip.frames()[0], clip.frames().last().unwrap());
        for (p, q) in first.pose.rotations.iter().zip(&last.pose.rotations) {
            assert!(angle_between(*p, *q) < 1e-6, "{}", sign.name);
        }
    }
}

#[test]
fn a_mirrored_hand_is_the_mirror_image() {
    let text = "sign X\n hands both mirrored\n configuration flat\n placement chest, 25cm away\n \
                orientation fingers out, palm down-left\n movement arc up-right 15cm\n";
    let performance = perform(&sign(text));
    let (left, right) = (world().signer.arm(Side::Left), world().signer.arm(Side::Right));
    for frame in stroke(&performance) {
        let body = body_at(&performance, performance.track.clip.fps().time_of(FrameIndex(frame)));
        for (l, r) in [(left.hand, right.hand), (left.fore, right.fore)] {
            let mirrored = body.position(r) * DVec3::new(-1.0, 1.0, 1.0);
            assert!(body.position(l).distance(mirrored) < 1e-4, "frame {frame}");
        }
    }
}

#[test]
fn alternating_hands_are_half_a_cycle_apart() {
    let text = "sign X\n hands both mirrored alternating\n configuration flat\n placement neutral\n \
                orientation fingers out, palm down\n movement circle axis left radius 5cm turns 2\n";
    let performance = perform(&sign(text));
    let heights = |side: Side| -> Vec<f64> {
        let wrist = world().signer.arm(side).hand;
        let fps = performance.track.clip.fps();
        stroke(&performance).map(|i| body_at(&performance, fps.time_of(FrameIndex(i))).position(wrist).y).collect()
    };
    let (left, right) = (heights(Side::Left), heights(Side::Right));
    let mean = |v: &[f64]| v.iter().sum::<f64>() / v.len() as f64;
    let (ml, mr) = (mean(&left), mean(&right));
    let product: f64 = left.iter().zip(&right).map(|(l, r)| (l - ml) * (r - mr)).sum();
    assert!(product < 0.0, "the hands rise and fall together");
}

#[test]
fn paper_mode_places_the_wrist_without_limits_and_leaves_the_clavicle_alone() {
    let text =
        "sign X\n configuration flat\n placement chest, touch, with palm\n orientation fingers right, palm out\n";
    let sign = sign(text);
    let limited = perform(&sign);
    let paper = perform_with(&sign, &Options { paper: true, ..Options::default() });
    assert!(limited.report.tilt > 0.2 && paper.report.tilt < 1e-6);
    let (clavicle, wrist) = (world().signer.arm(Side::Right).clavicle, world().signer.arm(Side::Right).hand);
    let body = body_at(&paper, paper.report.keys[0]);
    let chest = world().signer.landmarks.body_place("chest", None).unwrap().position(&body);
    assert!(body.position(wrist).distance(chest) < 1e-3, "the wrist itself is at the place");
    for frame in &paper.track.clip.frames()[stroke(&paper)] {
        assert!(angle_between(frame.pose.rotation(clavicle), DQuat::IDENTITY) < 1e-9);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 120, failure_persistence: None, ..ProptestConfig::default() })]

    /// Whatever the phonology holds becomes finite motion, or is refused with a reason that names the sign.
    #[test]
    fn any_sign_becomes_finite_motion_or_is_refused(sign in strategies::sign(Words::known())) {
        let world = world();
        match chereme::synthesis::synthesize(&sign, &world.grammar, &world.signer, &Options { fps: Fps::new(25.0).unwrap(), ..Options::default() }) {
            Err(error) => prop_assert!(error.to_string().starts_with(&sign.name)),
            Ok(performance) => {
                for frame in performance.track.clip.frames() {
                    prop_assert!(frame.pose.root_model.is_finite());
                    prop_assert!(frame.pose.rotations.iter().all(|q| q.is_finite() && (q.length() - 1.0).abs() < 1e-6));
                    prop_assert!(frame.weights.iter().all(|w| (0.0..=1.0).contains(w)));
                }
            }
        }
    }
}
