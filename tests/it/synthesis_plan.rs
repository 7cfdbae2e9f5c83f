//! Plans: signs that follow each other, holds and rests, times allotted from outside, pointing and spatialization
//! (expectations 29, 36, 37, 38 and 46 of facts/phonology.md §9).

use crate::moving::turned;
use crate::signing::{body_at, lexicon, perform, perform_with, sign, signs_of, tables, world};
use chereme::body::channel::Channels;
use chereme::motion::pose::ModelPose;
use chereme::motion::profile::speed;
use chereme::motion::rotation::angle_between;
use chereme::motion::skeleton::JointId;
use chereme::phonology::{Forced, Hand, Motion, Movement, Place, Relocation, Side, Sign, Space};
use chereme::score::gloss::{self, Known, Settings};
use chereme::score::plan::{Act, Item, Plan};
use chereme::synthesis::schedule::Schedule;
use chereme::synthesis::{self, Options, Performance};
use chereme::time::{Fps, Seconds};
use glam::DVec3;

fn plan(acts: impl IntoIterator<Item = Act>) -> Plan {
    let gloss = |act: &Act| match act {
        Act::Sign(sign) => sign.name.clone(),
        Act::Hold(..) => "<HOLD>".into(),
        Act::Rest(_) => "<REST>".into(),
        Act::Captured(_) => "captured".into(),
    };
    Plan {
        items: acts.into_iter().map(|act| Item { gloss: gloss(&act), act, span: None }).collect(),
        spans: Vec::new(),
    }
}

fn lexical(name: &str) -> Act {
    let found = signs_of("lsf").into_iter().find(|s| s.name == name);
    Act::Sign(Box::new(found.unwrap_or_else(|| panic!("{name}"))))
}

fn signed(plan: &Plan) -> Performance {
    let world = world();
    synthesis::synthesize_plan(plan, &world.grammar, &world.signer, &Options::default())
        .unwrap_or_else(|e| panic!("{e}"))
}

fn measured(plan: &Plan) -> synthesis::schedule::Measured {
    let world = world();
    synthesis::measure(plan, &world.grammar, &world.signer, &Options::default()).unwrap()
}

fn at_times(plan: &Plan, schedule: &Schedule) -> Performance {
    let world = world();
    synthesis::render(plan, schedule, &world.grammar, &world.signer, &Options::default())
        .unwrap_or_else(|e| panic!("{e}"))
}

/// Where a wrist is in every frame.
fn wrist(performance: &Performance, side: Side) -> Vec<DVec3> {
    let joint = world().signer.arm(side).hand;
    let skeleton = &world().signer.skeleton;
    performance.track.clip.frames().iter().map(|f| f.pose.to_model(skeleton).position(joint)).collect()
}

fn neutral_wrist(side: Side) -> DVec3 {
    wrist(&perform(&sign("sign X\n hands one\n placement chest, 20cm away\n")), side)[0]
}

fn line() -> Plan {
    plan(["BONJOUR", "CHIEN", "BOL", "MOI"].map(lexical))
}

#[test]
fn signs_follow_each_other_without_rest() {
    let performance = signed(&line());
    let fps = performance.track.clip.fps().get();
    let path = wrist(&performance, Side::Right);
    let times = &performance.report.items;
    let still = neutral_wrist(Side::Right);
    for pair in times.windows(2) {
        let transition = pair[1].stroke - pair[0].hold_end;
        assert!((0.15..=0.6).contains(&transition.0), "{transition}");
        let frames = (pair[0].hold_end.0 * fps) as usize..(pair[1].stroke.0 * fps) as usize;
        assert!(path[frames].iter().all(|p| p.distance(still) > 0.12), "the hand goes to rest");
    }
    assert!(performance.report.wrist_speed <= 3.0, "{}", performance.report.wrist_speed);
    let fastest = speed(&path, performance.track.clip.fps()).into_iter().fold(0.0, f64::max);
    assert!(fastest <= 3.2, "{fastest}");
    assert!(path[0].distance(still) < 1e-9 && path.last().unwrap().distance(still) < 1e-9);
}

#[test]
fn each_sign_of_a_line_is_the_sign_alone() {
    // From the first key to the last the strong wrist goes the same way, whatever stands before and after.
    let performance = signed(&line());
    let path = wrist(&performance, Side::Right);
    for (item, times) in line().items.iter().zip(&performance.report.items) {
        let Act::Sign(alone) = &item.act else { continue };
        let alone = perform(alone);
        let own = wrist(&alone, Side::Right);
        let fps = alone.track.clip.fps().get();
        let at = |path: &[DVec3], time: f64| {
            let (i, w) = ((time * fps).floor() as usize, (time * fps).fract());
            path[i].lerp(path[(i + 1).min(path.len() - 1)], w)
        };
        let (start, end) = (alone.report.keys[0].0, alone.report.keys.last().unwrap().0);
        for n in 0..=20 {
            let share = f64::from(n) / 20.0;
            let there = at(&path, times.stroke.0 + share * (times.stroke_end.0 - times.stroke.0));
            let here = at(&own, start + share * (end - start));
            assert!(there.distance(here) < 0.012, "{} at {share}: {:.4} m", item.gloss, there.distance(here));
        }
    }
}

#[test]
fn what_is_measured_is_what_is_signed_and_least_times_are_less() {
    let line = line();
    let measured = measured(&line);
    assert_eq!(measured.schedule().items, signed(&line).report.items);
    for phases in &measured.items {
        for phase in [phases.transition, phases.stroke, phases.hold] {
            assert!(phase.least.0 >= 0.0 && phase.least <= phase.usual, "{phase:?}");
        }
        assert!(phases.hold.least < phases.hold.usual, "holds give way");
    }
    // At the least times wrists are not faster than signers'.
    let mut pressed = measured.clone();
    for phases in &mut pressed.items {
        for phase in [&mut phases.transition, &mut phases.stroke, &mut phases.hold] {
            phase.usual = phase.least;
        }
    }
    let hurried = at_times(&line, &pressed.schedule());
    assert!(hurried.report.wrist_speed <= 3.3, "{}", hurried.report.wrist_speed);
}

#[test]
fn allotted_times_are_rendered_unchanged() {
    let line = line();
    let mut schedule = measured(&line).schedule();
    let longer = |s: &mut Seconds| *s = *s * 1.7;
    for times in &mut schedule.items {
        [&mut times.stroke, &mut times.stroke_end, &mut times.hold_end].into_iter().for_each(longer);
    }
    [&mut schedule.start, &mut schedule.retracted, &mut schedule.end].into_iter().for_each(longer);
    let performance = at_times(&line, &schedule);
    assert_eq!(performance.report.items, schedule.items);
    let gloss = performance.track.tier("RH Gloss").unwrap();
    for (value, times) in gloss.values().iter().zip(&schedule.items) {
        assert_eq!((value.start, value.end), (times.stroke, times.hold_end));
    }
    // The same way in another time.
    let usual = signed(&line);
    let (a, b) = (wrist(&usual, Side::Right), wrist(&performance, Side::Right));
    let length = |path: &[DVec3]| chereme::motion::profile::length(path);
    assert!((length(&a) - length(&b)).abs() < 0.02 * length(&a), "{} {}", length(&a), length(&b));
    let late = Schedule { items: schedule.items[..2].to_vec(), ..schedule.clone() };
    let world = world();
    let refused = synthesis::render(&line, &late, &world.grammar, &world.signer, &Options::default());
    assert!(refused.is_err_and(|e| e.to_string().contains("4 items have 2 times")));
    let mut back = schedule.clone();
    back.items[2].stroke = Seconds(0.1);
    let refused = synthesis::render(&line, &back, &world.grammar, &world.signer, &Options::default());
    assert!(refused.is_err_and(|e| e.to_string().contains("back to 0.100 s")));
}

#[test]
fn a_hold_keeps_the_posture_and_a_rest_lets_the_hands_down() {
    let held = signed(&plan([lexical("BOL"), Act::Hold(None, Some(Seconds(0.8))), lexical("MOI")]));
    let path = wrist(&held, Side::Right);
    let fps = held.track.clip.fps().get();
    let times = &held.report.items;
    assert!((times[1].hold_end - times[0].hold_end).0 >= 0.8 - 1e-9);
    let frames = (times[0].stroke_end.0 * fps).ceil() as usize..(times[1].hold_end.0 * fps) as usize;
    assert!(path[frames.clone()].iter().all(|p| p.distance(path[frames.start]) < 2e-3), "the hand drifts in the hold");

    let rested = signed(&plan([lexical("BOL"), Act::Rest(Some(Seconds(0.5))), lexical("MOI")]));
    for side in [Side::Left, Side::Right] {
        let path = wrist(&rested, side);
        let at = rested.report.items[1];
        let frames = (at.stroke.0 * fps).ceil() as usize..=(at.hold_end.0 * fps) as usize;
        assert!(frames.clone().count() >= 29);
        assert!(path[frames].iter().all(|p| p.distance(neutral_wrist(side)) < 1e-6), "{side:?} is not at rest");
    }
    let phases: Vec<&str> = rested.track.tier("RH Phase").unwrap().values().iter().map(|v| v.label.as_str()).collect();
    let expected = ["preparation", "stroke", "hold", "retraction", "preparation", "hold", "retraction"];
    assert_eq!(phases.iter().filter(|p| **p != "stroke").count(), expected.len() - 1, "{phases:?}");
}

#[test]
fn a_buoy_stays_while_the_other_hand_goes_on() {
    let hold = Act::Hold(Some(Hand::Weak), None);
    let performance = signed(&plan([lexical("MAISON"), hold, lexical("TOI"), lexical("MOI")]));
    let path = wrist(&performance, Side::Left);
    let fps = performance.track.clip.fps().get();
    let times = &performance.report.items;
    let frames = (times[0].stroke_end.0 * fps).ceil() as usize..(times[3].hold_end.0 * fps) as usize;
    assert!(path[frames.clone()].iter().all(|p| p.distance(path[frames.start]) < 2e-3));
    // Without it the weak hand goes down.
    let without = signed(&plan([lexical("MAISON"), lexical("TOI"), lexical("MOI")]));
    let end = (without.report.items[2].hold_end.0 * fps) as usize;
    assert!(wrist(&without, Side::Left)[end].distance(neutral_wrist(Side::Left)) < 0.05);
}

#[test]
fn no_joint_leaps_from_frame_to_frame() {
    let performance = signed(&plan(["PENSER", "BOL", "CLAIR", "ESCARGOT", "DODO", "PUNIR"].map(lexical)));
    for (i, pair) in performance.track.clip.frames().windows(2).enumerate() {
        for (joint, (p, q)) in pair[0].pose.rotations.iter().zip(&pair[1].pose.rotations).enumerate() {
            let turned = angle_between(*p, *q).to_degrees();
            let name = &world().signer.skeleton.joints()[joint].name;
            assert!(turned < 22.0 && p.dot(*q) >= 0.0, "{name} turns by {turned:.0}° at frame {i}");
        }
    }
}

#[test]
fn expectation_37_a_pointing_hand_points() {
    for target in [[0.5, 1.3, 0.6], [-0.4, 1.0, 0.7], [0.1, 1.9, 0.5], [-1.5, 1.5, 2.0], [0.0, 1.2, 0.9]] {
        let [x, y, z] = target;
        let sign = sign(&format!("sign IX\n configuration index\n placement pointing at point {x} {y} {z}\n"));
        let performance = perform(&sign);
        let (skeleton, signer) = (&world().signer.skeleton, &world().signer);
        let apex = performance.track.clip.sample(performance.report.keys[0]).pose.to_model(skeleton);
        let joints = signer.hand(Side::Right).of_digit(chereme::phonology::Digit::Index);
        let root = apex.position(joints[0]);
        let tip = apex.point(joints[2], skeleton[joints[2]].tail_model - skeleton[joints[2]].rest_model);
        let target = DVec3::from(target);
        let off = (tip - root).angle_between(target - root).to_degrees();
        assert!(off < 2.0, "{target}: {off:.1}° off; {:?}", performance.report.warnings);
        // Two peaks of speed: reach and retraction; both ends are the neutral pose.
        let path = wrist(&performance, Side::Right);
        let speeds = speed(&path, performance.track.clip.fps());
        let most = speeds.iter().copied().fold(0.0, f64::max);
        let peaks = speeds.windows(3).filter(|w| w[1] > 0.2 * most && w[0] < w[1] && w[1] >= w[2]).count();
        assert_eq!(peaks, 2, "{target}");
        let frames = performance.track.clip.frames();
        let relaxed = world().grammar.handshapes.find("rest", None).unwrap().angles();
        for end in [&frames[0], &frames[frames.len() - 1]] {
            assert!(turned(&end.pose.rotations, &signer.neutral(&relaxed).rotations) < 1e-6, "{target}");
        }
    }
}

/// A spelled word, as `fs(…)` writes it.
fn spelled(word: &str) -> Plan {
    let known = Known { lexicon: lexicon(), vocabulary: &world().vocabulary, tables: tables() };
    let settings = Settings { language: Some("lsf".into()), ..Settings::default() };
    let reading = gloss::read(&format!("fs({word})"), &known, &settings);
    assert_eq!(reading.diagnostics, []);
    reading.plan
}

/// The stretches of a sign's stroke in which its movement is a hold: from key to key.
fn holds(sign: &Sign) -> Vec<usize> {
    let held = |m: &Movement| matches!(m, Movement::Action(action) if action.motion == Motion::Hold);
    (0..sign.intervals).filter(|i| held(&sign.strong.movement[*i])).collect()
}

#[test]
fn expectation_38_each_letter_of_a_spelled_word_is_held_in_its_shape() {
    let signer = &world().signer;
    let right = signer.hand(Side::Right);
    let limb: Vec<JointId> = Channels::of(signer, Side::Right).limb().collect();
    for word in ["ABCDEFGHIJKLMNOPQRSTUVWXYZ", "CHEREME"] {
        let plan = spelled(word);
        let Act::Sign(sign) = &plan.items[0].act else { panic!("{word} is a sign") };
        let (letters, holds) = (word.chars().count(), holds(sign));
        assert_eq!(holds.len(), letters, "{word}: a hold a letter");
        let made = signed(&plan);
        let (clip, keys) = (&made.track.clip, &made.report.keys);
        let frames = |from: Seconds, to: Seconds| {
            let fps = clip.fps().get();
            (from.0 * fps - 1e-6).ceil() as usize..=(to.0 * fps + 1e-6).floor() as usize
        };
        for (letter, hold) in word.chars().zip(&holds) {
            let wanted = world().grammar.handshapes.find(&letter.to_string(), Some("lsf")).unwrap().angles();
            let held = frames(keys[*hold], keys[hold + 1]);
            assert!(held.clone().count() >= 8, "{word}: {letter} is held for {held:?}");
            for i in held {
                let off = right.angles_of(&clip.frames()[i].pose).max_difference(&wanted);
                assert!(off < 1e-3, "{word}: {letter} at frame {i} is {off} rad off");
            }
        }
        // Nothing else moves: not the other limb, the legs, the trunk, the head or the face.
        let stroke = frames(made.report.stroke_start, made.report.sign_end);
        let first = &clip.frames()[*stroke.start()];
        for frame in &clip.frames()[stroke.clone()] {
            let others = || signer.skeleton.ids().filter(|j| !limb.contains(j));
            assert!(
                others().all(|j| frame.pose.rotation(j) == first.pose.rotation(j)) && frame.weights == first.weights
            );
        }
        // No two neighbours of the second word share a shape: its fingers come to rest as often as it has letters.
        if word == "CHEREME" {
            assert_eq!(sign.intervals, 2 * letters - 1, "between the holds, one transition less");
            let still = |i: usize| {
                let [a, b] = [i, i + 1].map(|i| right.angles_of(&clip.frames()[i].pose));
                a.max_difference(&b) < 1e-9
            };
            let begins = stroke.clone().skip(1).filter(|i| still(*i) && !still(i - 1)).count();
            assert_eq!(begins + usize::from(still(*stroke.start())), letters);
        }
    }
}

fn relocated(mut sign: Sign, place: Place) -> Sign {
    sign.relocated = Some(Relocation { place, forced: Forced::No });
    sign
}

#[test]
fn expectation_29_a_relocated_sign_is_the_same_elsewhere() {
    for name in ["BOL", "CLAIR", "ESCARGOT"] {
        let Act::Sign(citation) = lexical(name) else { continue };
        let there = Place::Space(Space { left: 1, high: 1, far: 0 });
        let moved = relocated((*citation).clone(), there);
        let fine = Options { fps: Fps::new(240.0).unwrap(), ..Options::default() };
        let (here, moved) = (perform_with(&citation, &fine), perform_with(&moved, &fine));
        let sides: Vec<Side> = [Side::Left, Side::Right]
            .into_iter()
            .filter(|s| here.track.tier(if *s == Side::Left { "LH Gloss" } else { "RH Gloss" }).is_some())
            .collect();
        let at = |p: &Performance, share: f64| {
            let (start, end) = (p.report.keys[0].0, p.report.keys.last().unwrap().0);
            body_at(p, Seconds(start + share * (end - start)))
        };
        let first = |body: &ModelPose| body.position(world().signer.arm(sides[0]).hand);
        let by = first(&at(&moved, 0.0)) - first(&at(&here, 0.0));
        assert!(by.length() > 0.1, "{name} moves by {by}");
        assert!(moved.report.residual_m < 1e-3, "{name} is out of reach there");
        for n in 0..=20 {
            let (a, b) = (at(&here, f64::from(n) / 20.0), at(&moved, f64::from(n) / 20.0));
            for side in &sides {
                let hand = world().signer.arm(*side).hand;
                let off = (b.position(hand) - a.position(hand)).distance(by);
                assert!(off < 2e-3, "{name}, {side:?} at {n}/20: {:.1} mm", off * 1e3);
                let turned = angle_between(a.rotation(hand), b.rotation(hand)).to_degrees();
                assert!(turned < 0.1 || !moved.report.warnings.is_empty(), "{name}, {side:?}: turned by {turned:.1}°");
            }
        }
    }
}

#[test]
fn a_place_said_at_the_end_is_gone_back_from() {
    let there = perform(&sign(
        "sign X\n configuration flat\n orientation fingers up, palm out\n placement chest, 20cm away\n movement right 12cm\n",
    ));
    let back = perform(&sign(
        "sign X\n configuration flat\n orientation fingers up, palm out\n placement chest, 20cm away at end\n movement left 12cm\n",
    ));
    let (a, b) = (wrist(&there, Side::Right), wrist(&back, Side::Right));
    let at = |p: &Performance, path: &[DVec3], key: usize| path[(p.report.keys[key].0 * 60.0).round() as usize];
    assert!(at(&there, &a, 0).distance(at(&back, &b, 1)) < 3e-3);
    assert!(at(&there, &a, 1).distance(at(&back, &b, 0)) < 3e-3);
}

#[test]
fn variation_follows_its_seed_and_keeps_contacts() {
    let with = |seed: u64, variation: f64, plan: &Plan| {
        let options = Options { seed, variation, ..Options::default() };
        synthesis::synthesize_plan(plan, &world().grammar, &world().signer, &options).unwrap()
    };
    let line = line();
    let (one, again, other) = (with(1, 1.0, &line), with(1, 1.0, &line), with(2, 1.0, &line));
    assert_eq!(one.track.clip.frames(), again.track.clip.frames());
    assert_ne!(one.report.items, other.report.items);
    assert_eq!(with(7, 0.0, &line).track.clip.frames(), signed(&line).track.clip.frames());
    let usual = signed(&line).report.items;
    for (a, b) in one.report.items.iter().zip(&usual) {
        let ratio = (a.stroke_end - a.stroke).0 / (b.stroke_end - b.stroke).0.max(1e-9);
        assert!(a.stroke_end == a.stroke || (0.6..=1.6).contains(&ratio), "{ratio}");
    }
    // A sign on the body still touches it.
    let penser = plan([lexical("PENSER")]);
    assert!(with(3, 3.0, &penser).report.residual_m < 1e-3);
}
