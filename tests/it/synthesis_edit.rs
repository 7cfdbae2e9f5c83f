//! Operators on clips: expectations 16–32, 36 and 50 of facts/phonology.md §9, with 12 and 13 of every result; on
//! random smooth clips first, then on signs of the lexicon.

use crate::moving::{any_clip, apart, hand_turns, is_sound, path, same_but, turned, wrist_path};
use crate::signing::{perform, signs_of, world};
use chereme::body::channel::Channels;
use chereme::motion::clip::Clip;
use chereme::motion::profile::{derivative, length};
use chereme::motion::skeleton::JointId;
use chereme::motion::two_bone::inner_angle;
use chereme::phonology::Side;
use chereme::synthesis::Performance;
use chereme::synthesis::edit::{self, About, Extent, HandKept, Relocation, Repetition, Scaling, Sides};
use chereme::time::Seconds;
use glam::DVec3;
use proptest::prelude::*;
use std::sync::OnceLock;

/// BOL moves both hands apart, CLAIR opens them, PUNIR is beaten once, WEEK-END is of one hand.
fn performed() -> &'static [Performance] {
    static PERFORMED: OnceLock<Vec<Performance>> = OnceLock::new();
    PERFORMED.get_or_init(|| {
        let names = ["BOL", "CLAIR", "PUNIR", "WEEK-END"];
        signs_of("lsf").iter().filter(|s| names.contains(&s.name.as_str())).map(perform).collect()
    })
}

fn signed_clip() -> impl Strategy<Value = Clip> {
    (0..4usize).prop_map(|i| performed()[i].track.clip.clone())
}

fn any_side() -> impl Strategy<Value = Side> {
    prop_oneof![Just(Side::Left), Just(Side::Right)]
}

fn any_sides() -> impl Strategy<Value = Sides> {
    prop_oneof![Just(Sides::Left), Just(Sides::Right), Just(Sides::Both)]
}

fn small(by: f64) -> impl Strategy<Value = DVec3> {
    (-by..by, -by..by, -by..by).prop_map(|(x, y, z)| DVec3::new(x, y, z))
}

fn limb(side: Side) -> Vec<JointId> {
    Channels::of(&world().signer, side).limb().collect()
}

fn limbs() -> Vec<JointId> {
    [limb(Side::Left), limb(Side::Right)].concat()
}

/// The joints that a wrist elsewhere may change.
fn arm_joints(sides: Sides) -> Vec<JointId> {
    let channels = sides.each().iter().map(|s| Channels::of(&world().signer, *s));
    channels.flat_map(|c| [&c.placement[1..], &c.orientation].concat()).collect()
}

fn largest_step(clip: &Clip) -> f64 {
    let pairs = clip.frames().windows(2);
    pairs.map(|w| turned(&w[0].pose.rotations, &w[1].pose.rotations)).fold(0.0, f64::max)
}

fn reversed(path: &[DVec3]) -> Vec<DVec3> {
    path.iter().rev().copied().collect()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn expectations_16_to_19_backwards_is_the_same_poses_the_other_way(clip in any_clip(), side in any_side()) {
        let back = edit::inverted(&clip);
        prop_assert!(is_sound(&back));
        let again = edit::inverted(&back);
        prop_assert_eq!(again.frames(), clip.frames());
        prop_assert_eq!(back.duration(), clip.duration());
        prop_assert_eq!(&back.frames()[0], clip.frames().last().unwrap());
        prop_assert!(back.frames().iter().rev().eq(clip.frames()));
        let velocity = |clip: &Clip| derivative(&wrist_path(clip, side), clip.fps());
        let negated: Vec<DVec3> = velocity(&back).iter().map(|v| -*v).collect();
        prop_assert!(apart(&reversed(&negated), &velocity(&clip)) < 1e-12);
    }

    #[test]
    fn the_movement_alone_backwards_is_the_path_in_the_trunk(clip in any_clip(), sides in any_sides()) {
        let signer = &world().signer;
        let back = edit::inverted_movement(&clip, signer, sides).unwrap();
        prop_assert!(is_sound(&back));
        prop_assert!(turned(&hand_turns(&back, Side::Right), &hand_turns(&clip, Side::Right)) < 1e-9);
        let channels = sides.each().iter().map(|s| Channels::of(signer, *s));
        let changed: Vec<JointId> = channels.flat_map(|c| [&c.placement[..], &c.orientation].concat()).collect();
        prop_assert!(same_but(&back, &clip, &changed));
        for side in sides.each() {
            prop_assert!(apart(&in_trunk(&back, *side), &reversed(&in_trunk(&clip, *side))) < 1e-9);
        }
        let again = edit::inverted_movement(&back, signer, sides).unwrap();
        let worst = again.frames().iter().zip(clip.frames()).map(|(a, b)| turned(&a.pose.rotations, &b.pose.rotations));
        prop_assert!(worst.fold(0.0, f64::max) < 1e-6);
    }

    #[test]
    fn expectations_20_and_21_mirrored_is_idempotent_and_its_wrists_are_images(clip in any_clip(), from in any_side()) {
        let signer = &world().signer;
        let both = edit::mirrored(&clip, signer, from).unwrap();
        prop_assert!(is_sound(&both));
        prop_assert!(same_but(&both, &clip, &limb(from.other())));
        let again = edit::mirrored(&both, signer, from).unwrap();
        prop_assert_eq!(again.frames(), both.frames());
        // The avatar's bones are symmetric to 0 mm, so what is left is rounding.
        let image: Vec<DVec3> = in_trunk(&both, from).iter().map(|p| DVec3::new(-p.x, p.y, p.z)).collect();
        prop_assert!(apart(&image, &in_trunk(&both, from.other())) < 1e-9);
    }

    #[test]
    fn expectations_22_and_24_exchanges_undo_themselves_and_commute(clip in any_clip(), from in any_side()) {
        let signer = &world().signer;
        let swap = |c: &Clip| edit::swapped(c, signer).unwrap();
        let mirror = |c: &Clip, from| edit::mirrored(c, signer, from).unwrap();
        let (invert, reflect) = (edit::inverted, edit::reflected);
        let swapped = swap(&clip);
        let reflected = reflect(&clip);
        prop_assert!(is_sound(&swapped) && is_sound(&reflected));
        let (twice_swapped, twice_reflected) = (swap(&swapped), reflect(&reflected));
        prop_assert_eq!(twice_swapped.frames(), clip.frames());
        prop_assert_eq!(twice_reflected.frames(), clip.frames());
        prop_assert!(same_but(&swapped, &clip, &limbs()));
        // A swap is the reflection of the arms alone.
        let arms = |c: &Clip| -> Vec<_> { c.frames().iter().map(|f| limbs().iter().map(|j| f.pose.rotation(*j)).collect::<Vec<_>>()).collect() };
        prop_assert_eq!(arms(&swapped), arms(&reflected));
        let pairs = [
            (invert(&mirror(&clip, from)), mirror(&invert(&clip), from)),
            (invert(&swapped), swap(&invert(&clip))),
            (invert(&reflected), reflect(&invert(&clip))),
            (swap(&reflected), reflect(&swapped)),
            (mirror(&swapped, from), mirror(&clip, from.other())),
        ];
        for (n, (a, b)) in pairs.iter().enumerate() {
            prop_assert_eq!(a.frames(), b.frames(), "pair {}", n);
        }
        // What trunk and gaze did left is right: the wrists are images in model space too.
        let image: Vec<DVec3> = wrist_path(&clip, from).iter().map(|p| DVec3::new(-p.x, p.y, p.z)).collect();
        prop_assert!(apart(&image, &wrist_path(&reflected, from.other())) < 1e-9);
    }

    #[test]
    fn expectation_23_repetition_has_its_length_and_no_jump(clip in any_clip(), times in 1u32..4, gap in 0usize..12) {
        let signer = &world().signer;
        let gap = Seconds(gap as f64 / 60.0);
        let how = Repetition { times, gap, ..Repetition::default() };
        let made = edit::repeated(&clip, signer, &how).unwrap();
        prop_assert!(is_sound(&made));
        let (first, length) = (clip.frames().len(), made.frames().len() - 1);
        prop_assert_eq!(&made.frames()[..first], clip.frames());
        prop_assert!(largest_step(&made) <= largest_step(&clip) + 1e-9);
        let gaps = (length - times as usize * (first - 1)).checked_div(times as usize - 1).unwrap_or(0);
        prop_assert_eq!(length, times as usize * (first - 1) + (times as usize - 1) * gaps);
        // A gap as long as the clip's steps need is taken as it is; and none is left out that would do.
        let used = Seconds(gaps as f64 / 60.0);
        prop_assert!(times == 1 || used >= gap);
        if times == 2 && used > gap && gaps > 1 {
            let way = |gaps: usize| (0..gaps).map(|i| {
                let easing = how.easing;
                easing.weight((i + 1) as f64 / gaps as f64) - easing.weight(i as f64 / gaps as f64)
            }).fold(0.0, f64::max);
            let ends = turned(&clip.frames()[first - 1].pose.rotations, &clip.frames()[0].pose.rotations);
            let face = clip.frames()[0].weights.iter().zip(&clip.frames()[first - 1].weights);
            let face = face.map(|(a, b)| f64::from((a - b).abs())).fold(0.0, f64::max);
            let root = clip.frames()[0].pose.root_model.distance(clip.frames()[first - 1].pose.root_model);
            let (most_face, most_root) = largest_other_steps(&clip);
            let fewer = way(gaps - 1);
            prop_assert!(
                fewer * ends > largest_step(&clip) || fewer * face > most_face || fewer * root > most_root,
                "{} frames would do", gaps - 1
            );
        }
    }

    #[test]
    fn expectation_25_repetition_commutes_with_inversion(clip in any_clip(), times in 1u32..4, gap in 0usize..12) {
        let signer = &world().signer;
        let how = Repetition { times, gap: Seconds(gap as f64 / 60.0), ..Repetition::default() };
        let a = edit::repeated(&edit::inverted(&clip), signer, &how).unwrap();
        let b = edit::inverted(&edit::repeated(&clip, signer, &how).unwrap());
        prop_assert_eq!(a.frames().len(), b.frames().len());
        for (f, g) in a.frames().iter().zip(b.frames()) {
            prop_assert!(turned(&f.pose.rotations, &g.pose.rotations) < 1e-6);
        }
    }

    #[test]
    fn expectations_26_to_28_a_configuration_is_fifteen_joints(clip in any_clip(), side in any_side(), from in 0.0..0.1f64) {
        let signer = &world().signer;
        let hand = signer.hand(side);
        let shape = world().grammar.handshapes.find("fist-s", None).unwrap().angles();
        let extent = Extent::between(Seconds(from), Seconds(from + 0.05)).eased(Seconds(0.05), Seconds(0.05));
        let made = edit::with_configuration(&clip, signer, side, &shape, &extent).unwrap();
        prop_assert!(is_sound(&made));
        prop_assert!(same_but(&made, &clip, &hand.joints()));
        prop_assert_eq!(wrist_path(&made, side), wrist_path(&clip, side));
        for (i, frame) in made.frames().iter().enumerate() {
            let weight = extent.weight(Seconds(i as f64 / 60.0));
            if weight == 1.0 {
                prop_assert!(hand.angles_of(&frame.pose).max_difference(&shape) < 1e-9);
            }
            if weight == 0.0 {
                prop_assert_eq!(&frame.pose, &clip.frames()[i].pose);
            }
        }
        let itself = Extent::between(extent.start, extent.end);
        let again = edit::with_configuration(&made, signer, side, &shape, &itself).unwrap();
        prop_assert_eq!(again.frames(), made.frames());
    }

    #[test]
    fn expectation_29_elsewhere_the_wrists_keep_their_way(
        clip in prop_oneof![any_clip(), signed_clip()], by in small(0.12), sides in any_sides(),
    ) {
        let signer = &world().signer;
        let how = Relocation { sides, extent: Extent::whole(&clip), kept: HandKept::Global };
        let moved = edit::relocated(&clip, signer, by, &how).unwrap();
        prop_assert!(is_sound(&moved.clip));
        prop_assert!(same_but(&moved.clip, &clip, &arm_joints(sides)));
        for &side in sides.each() {
            let goal: Vec<DVec3> = wrist_path(&clip, side).iter().map(|p| *p + by).collect();
            let off = apart(&goal, &wrist_path(&moved.clip, side));
            prop_assert!(off <= moved.residual_m + 1e-6, "{off} m off, {} reported", moved.residual_m);
            prop_assert!(turned(&hand_turns(&moved.clip, side), &hand_turns(&clip, side)) < 1e-9);
        }
        if moved.residual_m < 1e-3 {
            let between = |c: &Clip| wrist_path(c, Side::Left).iter().zip(wrist_path(c, Side::Right)).map(|(l, r)| l.distance(r)).collect::<Vec<_>>();
            if sides == Sides::Both {
                prop_assert!(between(&clip).iter().zip(between(&moved.clip)).all(|(a, b)| (a - b).abs() < 2e-3));
            }
            // There and back (30).
            let back = edit::relocated(&moved.clip, signer, -by, &how).unwrap().clip;
            for &side in sides.each() {
                prop_assert!(apart(&wrist_path(&back, side), &wrist_path(&clip, side)) < 2e-3);
                let elbow = signer.arm(side).fore;
                prop_assert!(apart(&path(&back, elbow), &path(&clip, elbow)) < 2e-3);
            }
        }
        let nowhere = edit::relocated(&clip, signer, DVec3::ZERO, &how).unwrap();
        prop_assert_eq!(nowhere.clip.frames(), clip.frames());
        prop_assert_eq!(nowhere.residual_m, 0.0);
        // A hair's breadth away the arm is where it was: nothing is made anew.
        let hair = edit::relocated(&clip, signer, DVec3::splat(1e-6), &how).unwrap().clip;
        for (a, b) in hair.frames().iter().zip(clip.frames()) {
            prop_assert!(turned(&a.pose.rotations, &b.pose.rotations) < 1e-3);
        }
    }

    #[test]
    fn expectations_31_and_32_out_of_reach_the_arm_is_straight_toward_it(clip in any_clip(), by in small(3.0), side in any_side()) {
        prop_assume!(by.length() > 1.8);
        let signer = &world().signer;
        let sides = if side == Side::Left { Sides::Left } else { Sides::Right };
        let how = Relocation { sides, extent: Extent::whole(&clip), kept: HandKept::Global };
        let moved = edit::relocated(&clip, signer, by, &how).unwrap();
        let arm = signer.arm(side);
        let mut worst = 0.0f64;
        for (before, after) in clip.frames().iter().zip(moved.clip.frames()) {
            let target = before.pose.to_model(&signer.skeleton).position(arm.hand) + by;
            let model = after.pose.to_model(&signer.skeleton);
            let [s, e, w] = [arm.upper, arm.fore, arm.hand].map(|j| model.position(j));
            prop_assert!(inner_angle(s, e, w).to_degrees() > 179.0);
            prop_assert!((target - s).angle_between(w - s).to_degrees() < 0.1);
            worst = worst.max(s.distance(target) - arm.upper_m - arm.fore_m);
        }
        prop_assert!((worst - moved.residual_m).abs() < 1e-4);
        prop_assert!(is_sound(&moved.clip));
        // On the shoulder itself.
        let shoulder = clip.frames()[0].pose.to_model(&signer.skeleton);
        let onto = shoulder.position(arm.upper) - shoulder.position(arm.hand);
        prop_assert!(is_sound(&edit::relocated(&clip, signer, onto, &how).unwrap().clip));
    }

    #[test]
    fn expectation_50_at_twice_the_speed_the_path_is_the_same(clip in prop_oneof![any_clip(), signed_clip()], side in any_side()) {
        let fast = edit::at_speed(&clip, 2.0).unwrap();
        prop_assert!(is_sound(&fast));
        prop_assert!((fast.duration().0 - clip.duration().0 / 2.0).abs() <= 0.5 / 60.0 + 1e-9);
        let every_other: Vec<DVec3> = wrist_path(&clip, side).into_iter().step_by(2).collect();
        let found = wrist_path(&fast, side);
        prop_assert!(apart(&every_other, &found[..every_other.len()]) < 1e-9);
        let same = edit::at_speed(&clip, 1.0).unwrap();
        prop_assert_eq!(same.frames(), clip.frames());
        let slow = edit::at_speed(&edit::at_speed(&clip, 0.5).unwrap(), 2.0).unwrap();
        prop_assert!(apart(&wrist_path(&slow, side), &wrist_path(&clip, side)) < 1e-3);
    }
}

/// The wrist from the trunk, in the trunk's axes.
fn in_trunk(clip: &Clip, side: Side) -> Vec<DVec3> {
    let signer = &world().signer;
    let trunk = signer.skeleton.joint("Spine2").unwrap();
    let in_frame = |f: &chereme::motion::clip::Frame| {
        let model = f.pose.to_model(&signer.skeleton);
        model.rotation(trunk).conjugate() * (model.position(signer.arm(side).hand) - model.position(trunk))
    };
    clip.frames().iter().map(in_frame).collect()
}

/// The largest steps of the face's weights and of the root, metres.
fn largest_other_steps(clip: &Clip) -> (f64, f64) {
    let mut most = (0.0f64, 0.0f64);
    for w in clip.frames().windows(2) {
        let face = w[0].weights.iter().zip(&w[1].weights).map(|(a, b)| f64::from((a - b).abs()));
        most = (face.fold(most.0, f64::max), most.1.max(w[0].pose.root_model.distance(w[1].pose.root_model)));
    }
    most
}

#[test]
fn expectation_36_elbows_do_not_jump_when_a_sign_is_elsewhere() {
    let signer = &world().signer;
    let (mut reached, mut tried) = (0, 0);
    for made in performed() {
        let clip = &made.track.clip;
        let phases = edit::track::Phases::of(&made.track).unwrap();
        for by in [
            DVec3::new(0.12, 0.0, 0.0),
            DVec3::new(-0.15, 0.15, 0.0),
            DVec3::new(0.0, -0.1, 0.05),
            DVec3::new(0.05, 0.0, -0.05),
        ] {
            tried += 1;
            let how =
                Relocation { sides: phases.sides, extent: phases.extent(Default::default()), kept: HandKept::Global };
            let moved = edit::relocated(clip, signer, by, &how).unwrap();
            assert!(is_sound(&moved.clip));
            if moved.residual_m > 1e-6 {
                continue;
            }
            reached += 1;
            for &side in phases.sides.each() {
                let steps = |c: &Clip| {
                    let elbow = path(c, signer.arm(side).fore);
                    elbow.windows(2).map(|w| w[0].distance(w[1])).fold(0.0, f64::max)
                };
                let (after, before) = (steps(&moved.clip), steps(clip));
                assert!(after <= 3.0 * before, "{by} {side:?}: {after} > 3 × {before}");
            }
        }
    }
    assert!(reached * 2 > tried, "only {reached} of {tried} within reach");
}

#[test]
fn a_larger_sign_has_a_longer_path_about_the_same_place() {
    let signer = &world().signer;
    for made in performed() {
        let (clip, report) = (&made.track.clip, &made.report);
        let extent = Extent::between(report.stroke_start, report.sign_end);
        for (about, factor) in [(About::Mean, 1.3), (About::Start, 0.5)] {
            let how = Scaling { sides: Sides::Right, extent, about };
            let larger = edit::sized(clip, signer, factor, &how).unwrap();
            assert!(is_sound(&larger.clip) && same_but(&larger.clip, clip, &arm_joints(Sides::Right)));
            assert!(larger.residual_m < 1e-6);
            let frames = (report.stroke_start.0 * 60.0).ceil() as usize..(report.sign_end.0 * 60.0) as usize;
            let stroke = |c: &Clip| wrist_path(c, Side::Right)[frames.clone()].to_vec();
            let (before, after) = (stroke(clip), stroke(&larger.clip));
            assert!((length(&after) - factor * length(&before)).abs() < 1e-5, "{} {}", length(&before), length(&after));
            let moved = match about {
                About::Start => before[0].distance(after[0]),
                About::Mean => {
                    let mean = |p: &[DVec3]| p.iter().sum::<DVec3>() / p.len() as f64;
                    mean(&before).distance(mean(&after))
                }
            };
            assert!(moved < 2e-3, "{about:?}: {moved}");
        }
    }
}

#[test]
fn repetitions_grow_about_the_mean_place() {
    let signer = &world().signer;
    let made = &performed()[0];
    let clip = &made.track.clip;
    let how = Repetition { times: 3, growth: 0.7, sides: Sides::Right, ..Repetition::default() };
    let thrice = edit::repeated(clip, signer, &how).unwrap();
    assert!(is_sound(&thrice));
    let path = wrist_path(&thrice, Side::Right);
    let frames = clip.frames().len();
    let first = length(&path[..frames]);
    let last = length(&path[path.len() - frames..]);
    assert!((last / first - 0.49).abs() < 0.01, "{}", last / first);
    let much = Repetition { times: 1_000_000, ..how };
    assert!(edit::repeated(clip, signer, &much).is_err());
}

#[test]
fn two_signs_go_on_at_once_each_on_a_hand() {
    let signer = &world().signer;
    for (strong, weak) in [(1, 3), (3, 0)] {
        let (strong, weak) = (&performed()[strong].track, &performed()[weak].track);
        let both = edit::track::on_each_hand(strong, weak, signer).unwrap();
        assert!(is_sound(&both.clip));
        let longer = strong.clip.frames().len().max(weak.clip.frames().len());
        assert_eq!(both.clip.frames().len(), longer);
        let prefixes = |p: &str| both.tiers.iter().filter(|t| t.name.starts_with(p)).count();
        assert!(prefixes("RH ") > 3 && prefixes("LH ") > 3);
        let right = wrist_path(&both.clip, Side::Right);
        let own = wrist_path(&strong.clip, Side::Right);
        assert!(apart(&own, &right[..own.len()]) < 1e-12);
    }
}
