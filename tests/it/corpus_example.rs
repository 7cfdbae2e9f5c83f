//! Query by example: warping agrees with a plain table, finds what was put in, and tells glosses of real takes; bases.

use crate::corpus_query::{VOCABULARY, some_segments};
use crate::shared::shared;
use chereme::avatar::SKELETON;
use chereme::corpus::bases::{self, bases};
use chereme::corpus::example::components::Components;
use chereme::corpus::example::features::{DIMS_A_HAND, Options, Reference, features_of};
use chereme::corpus::example::neighbours::{Take, distances, leave_one_group_out, leave_one_out};
use chereme::corpus::example::warp::{stretches, whole, whole_by};
use chereme::corpus::example::{Motion, search};
use chereme::corpus::segment::{Component, Segment, Value};
use chereme::motion::clip::{Clip, Frame};
use chereme::motion::pose::LocalPose;
use chereme::motion::skeleton::Skeleton;
use chereme::phonology::Side;
use chereme::time::{Fps, Seconds};
use glam::{DQuat, DVec3};
use proptest::prelude::*;
use std::sync::Arc;

#[allow(dead_code)]
#[path = "../../examples/gloss_by_example.rs"]
mod gloss_by_example;

fn motion(rows: &[[f32; 2]]) -> Motion {
    Motion::new(Fps::new(30.0).unwrap(), 2, rows.as_flattened()).unwrap()
}

fn rows(length: std::ops::Range<usize>) -> impl Strategy<Value = Vec<[f32; 2]>> {
    prop::collection::vec([-1.0..1.0f32, -1.0..1.0f32], length)
}

fn apart(a: [f32; 2], b: [f32; 2]) -> f64 {
    f64::from((a[0] - b[0]).hypot(a[1] - b[1]))
}

/// The least sum of distances of an example's frames up to one that is laid on a frame of a recording, by plain recursion.
fn laid(example: &[[f32; 2]], recording: &[[f32; 2]], i: usize, j: usize) -> f64 {
    let here = apart(example[i], recording[j]);
    let mut best = f64::INFINITY;
    if i == 0 {
        return here;
    }
    if i == 1 {
        best = apart(example[0], recording[j]);
    }
    for back in 1..=2 {
        if j >= back {
            best = best.min(laid(example, recording, i - 1, j - back));
        }
    }
    if i >= 2 && j >= 1 {
        best = best.min(laid(example, recording, i - 2, j - 1) + apart(example[i - 1], recording[j]));
    }
    best + here
}

/// The least cost of laying two motions on each other up to two frames, by plain recursion.
fn laid_whole(a: &[[f32; 2]], b: &[[f32; 2]], i: usize, j: usize) -> f64 {
    let here = apart(a[i], b[j]);
    if (i, j) == (0, 0) {
        return 2.0 * here;
    }
    let mut best = f64::INFINITY;
    if i > 0 && j > 0 {
        best = best.min(laid_whole(a, b, i - 1, j - 1) + 2.0 * here);
    }
    if i > 0 {
        best = best.min(laid_whole(a, b, i - 1, j) + here);
    }
    if j > 0 {
        best = best.min(laid_whole(a, b, i, j - 1) + here);
    }
    best
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 64, ..ProptestConfig::default() })]

    #[test]
    fn stretches_are_those_of_the_plain_table(example in rows(1..6), recording in rows(1..9)) {
        let ends: Vec<f64> = (0..recording.len()).map(|j| laid(&example, &recording, example.len() - 1, j)).collect();
        let found = stretches(&motion(&example), &motion(&recording));
        for stretch in &found {
            let expected = ends[stretch.end] / example.len() as f64;
            prop_assert!((f64::from(stretch.distance) - expected).abs() < 1e-4, "{stretch:?} {expected}");
            let (frames, length) = (stretch.end - stretch.start + 1, example.len());
            prop_assert!(frames <= 2 * length && length <= 2 * frames, "the slope is limited: {stretch:?}");
        }
        let least = ends.iter().copied().fold(f64::INFINITY, f64::min) / example.len() as f64;
        let best = found.iter().map(|s| f64::from(s.distance)).fold(f64::INFINITY, f64::min);
        prop_assert!(least == best || (least - best).abs() < 1e-4, "{least} {best}");
    }

    #[test]
    fn whole_motions_are_laid_as_by_the_plain_table(a in rows(1..6), b in rows(1..6)) {
        let (first, second) = (motion(&a), motion(&b));
        let expected = laid_whole(&a, &b, a.len() - 1, b.len() - 1) / (a.len() + b.len()) as f64;
        prop_assert!((whole(&first, &second, 1.0) - expected).abs() < 1e-4);
        prop_assert_eq!(whole(&first, &second, 0.3), whole(&second, &first, 0.3));
        prop_assert_eq!(whole(&first, &first, 0.1), 0.0);
        prop_assert_eq!(whole_by(&first, &second, 0.3, |d| 2.0 * d), 2.0 * whole(&first, &second, 0.3));
        prop_assert!(whole(&first, &second, 0.2) >= whole(&first, &second, 1.0) - 1e-6, "a band only takes ways away");
    }

    #[test]
    fn hits_do_not_overlap_and_come_nearest_first(example in rows(2..6), recordings in prop::collection::vec(rows(1..40), 1..4)) {
        let recordings: Vec<Motion> = recordings.iter().map(|r| motion(r)).collect();
        let found = search(&motion(&example), &recordings, 10).unwrap();
        prop_assert!(found.is_sorted_by(|a, b| a.distance <= b.distance));
        for (i, a) in found.iter().enumerate() {
            prop_assert!(a.start <= a.end);
            prop_assert!(found[..i].iter().all(|b| b.recording != a.recording || b.end < a.start || a.end < b.start));
        }
    }

    #[test]
    fn bases_are_as_promised(all in some_segments(0..60), orientation in any::<bool>(), tolerance in prop::option::of(0.0..0.6f64)) {
        let options = bases::Options { orientation, tolerance };
        let found = bases(&all, &VOCABULARY, &options);
        prop_assert_eq!(&found, &bases(&all, &VOCABULARY, &options));
        let mut seen = Vec::new();
        for base in &found {
            let glosses: std::collections::BTreeSet<String> = base.members.iter().map(|m| m.gloss.to_lowercase()).collect();
            prop_assert!(glosses.len() >= 2 && base.members.len() >= 2, "{base:?}");
            for segment in base.members.iter().flat_map(|m| &m.segments) {
                let known = |c: Component| all[*segment].of(c).iter().all(|v| v.label != "?") && !all[*segment].of(c).is_empty();
                prop_assert!(known(Component::Configuration) && known(Component::Placement) && known(Component::Movement));
                prop_assert!(!orientation || known(Component::Orientation));
                seen.push(*segment);
            }
        }
        let count = seen.len();
        seen.sort_unstable();
        seen.dedup();
        prop_assert_eq!(count, seen.len(), "a segment is in one base");
    }
}

#[test]
fn hands_that_act_together_are_one_sign_of_a_base() {
    let segment = |gloss: &str, side, shape: &str, place: &str, start: f64| {
        let value = |label: &str| vec![Value { label: label.into(), start: Seconds(start), end: Seconds(start + 1.0) }];
        let values = [value(shape), value(place), Vec::new(), value("arc up 15cm")];
        let (start, end, gloss) = (Seconds(start), Seconds(start + 1.0), Some(gloss.to_owned()));
        Segment { gloss, side: Some(side), start, end, values, ..Segment::default() }
    };
    let all = [
        segment("ESCARGOT", Side::Right, "V", "forehead", 0.0),
        segment("LIMACE", Side::Right, "U", "Forehead", 2.0),
        segment("limace", Side::Right, "U", "forehead", 4.0),
        segment("COLLINE", Side::Right, "B", "chest", 6.0),
        segment("MONTAGNE", Side::Right, "5", "chest", 8.0),
        segment("MONTAGNE", Side::Left, "5", "chest", 8.0),
        segment("BOSSE", Side::Right, "S", "eyebrows", 10.0),
    ];
    let found = bases(&all, &VOCABULARY, &bases::Options::default());
    assert_eq!(found.len(), 1, "one hand and two are no base: {found:?}");
    let members: Vec<(&str, &str, &[usize])> =
        found[0].members.iter().map(|m| (m.gloss.as_str(), m.configuration.as_str(), &m.segments[..])).collect();
    assert_eq!(members, [("ESCARGOT", "right V", &[0][..]), ("LIMACE", "right U", &[1, 2])]);
    assert_eq!(found[0].shared, ["right placement forehead", "right movement arc up 15cm"]);
    let near = bases(&all, &VOCABULARY, &bases::Options { tolerance: Some(0.1), ..Default::default() });
    assert_eq!(near[0].members.len(), 3, "forehead and eyebrows are near: {near:?}");
    assert!(bases(&all, &VOCABULARY, &bases::Options { orientation: true, ..Default::default() }).is_empty());
}

/// A clip of the rig whose forearms and fingers move.
fn clip(frames: usize, fps: f64, mirrored: bool) -> Clip {
    let rig = Arc::new(Skeleton::from_json(SKELETON).unwrap());
    let (arm, fingers) = if mirrored { ("RightForeArm", "RightHandIndex1") } else { ("LeftForeArm", "LeftHandIndex1") };
    let sign = if mirrored { -1.0 } else { 1.0 };
    let frame = |i: usize| {
        let time = i as f64 / fps;
        let mut pose = LocalPose::rest(&rig);
        pose.set(rig.joint(arm).unwrap(), DQuat::from_rotation_y(-sign * time.sin()));
        pose.set(rig.joint(fingers).unwrap(), DQuat::from_rotation_z(-sign * (1.0 - (2.0 * time).cos()) / 2.0));
        Frame { pose, weights: Vec::new() }
    };
    Clip::new(rig.clone(), Fps::new(fps).unwrap(), Arc::new(Vec::new()), (0..frames).map(frame).collect()).unwrap()
}

fn greatest_difference(a: &Motion, b: &Motion) -> f32 {
    assert_eq!(a.len(), b.len());
    let rows = (0..a.len()).flat_map(|i| a.row(i).iter().zip(b.row(i)).map(|(x, y)| (x - y).abs()).collect::<Vec<_>>());
    rows.fold(0.0, f32::max)
}

#[test]
fn a_left_hand_is_the_right_one_that_mirrors_it() {
    let options = Options::default();
    let left = features_of(&clip(90, 60.0, false), &[Side::Left], &options).unwrap();
    let right = features_of(&clip(90, 60.0, true), &[Side::Right], &options).unwrap();
    // The avatar's two hands are mirror images to a few tenths of a millimetre.
    assert!(greatest_difference(&left, &right) < 0.02, "{}", greatest_difference(&left, &right));
}

#[test]
fn features_do_not_depend_on_where_the_body_stands_or_how_often_it_is_filmed() {
    let of = |clip: &Clip| features_of(clip, &[Side::Left, Side::Right], &Options::default()).unwrap();
    let at_60 = clip(91, 60.0, false);
    assert!(greatest_difference(&of(&at_60), &of(&clip(181, 120.0, false))) < 0.02);
    let moved = at_60.frames().iter().cloned().map(|mut frame| {
        frame.pose.root_model += DVec3::new(3.0, 0.0, -2.0);
        frame
    });
    let moved = Clip::new(at_60.skeleton().clone(), at_60.fps(), at_60.morphs().clone(), moved.collect()).unwrap();
    assert!(greatest_difference(&of(&at_60), &of(&moved)) < 1e-3);
}

#[test]
fn a_part_of_a_motion_is_found_where_it_is_even_when_made_slower() {
    let whole_motion = features_of(&clip(600, 60.0, false), &[Side::Left], &Options::default()).unwrap();
    let example = whole_motion.part(100, 140).unwrap();
    let found = search(&example, std::slice::from_ref(&whole_motion), 3).unwrap();
    assert_eq!((found[0].start, found[0].distance), (whole_motion.fps().time_of(chereme::time::FrameIndex(100)), 0.0));
    // The same motion at 0.7 of the speed: 100/30 s come at 143/30 s.
    let slow = features_of(
        &clip(600, 60.0 / 0.7, false),
        &[Side::Left],
        &Options { fps: Fps::new(30.0).unwrap(), movement: 0.0, ..Options::default() },
    );
    let quick =
        features_of(&clip(600, 60.0, false), &[Side::Left], &Options { movement: 0.0, ..Options::default() }).unwrap();
    let found = search(&quick.part(60, 100).unwrap(), &[slow.unwrap()], 1).unwrap();
    assert!(found[0].distance < 0.05, "{found:?}");
    assert!(search(&example, &[motion(&[[0.0, 0.0]])], 1).is_err());
}

/// Takes of one hand that moves at random; some belong to one performance.
fn some_takes() -> impl Strategy<Value = Vec<(usize, Vec<[f32; 3]>)>> {
    prop::collection::vec((0..4usize, prop::collection::vec([-1.0..1.0f32, -1.0..1.0f32, -1.0..1.0f32], 1..12)), 1..7)
}

/// A hand whose shape, direction and place each follow one of three numbers, features times `scale`.
fn take((group, rows): &(usize, Vec<[f32; 3]>), number: usize, scale: f32) -> Take {
    let row = |[shape, direction, place]: &[f32; 3]| {
        let of = |value: f32, count: usize| std::iter::repeat_n(value * scale, count);
        of(*shape, 45).chain(of(*direction, 6)).chain(of(*place, 3)).chain(of(0.0, 3)).collect::<Vec<f32>>()
    };
    let values: Vec<f32> = rows.iter().flat_map(row).collect();
    Take {
        gloss: format!("gloss {}", group % 2),
        group: format!("{group}"),
        side: if number.is_multiple_of(2) { Side::Right } else { Side::Left },
        components: Components::of(&Motion::new(Fps::new(30.0).unwrap(), DIMS_A_HAND, &values).unwrap()).unwrap(),
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 32, ..ProptestConfig::default() })]

    #[test]
    fn takes_are_as_far_one_way_as_the_other_in_whatever_unit(all in some_takes()) {
        let of = |scale: f32| all.iter().enumerate().map(|(i, rows)| take(rows, i, scale)).collect::<Vec<Take>>();
        let (takes, larger) = (of(1.0), of(4.0));
        let (found, scaled) = (distances(&takes), distances(&larger));
        for (i, row) in found.iter().enumerate() {
            for (j, distance) in row.iter().enumerate() {
                prop_assert_eq!(distance.is_finite(), takes[i].group != takes[j].group);
                prop_assert_eq!(*distance, found[j][i]);
                prop_assert!(*distance >= 0.0 && (distance == &scaled[i][j] || (distance - scaled[i][j]).abs() < 1e-5));
            }
        }
        let groups: std::collections::BTreeSet<&str> = takes.iter().map(|t| t.group.as_str()).collect();
        let (hands, performances) = (leave_one_out(&takes), leave_one_group_out(&takes));
        prop_assert_eq!((hands.len(), performances.len()), (takes.len(), groups.len()));
        for guess in hands.iter().chain(&performances) {
            prop_assert!(guess.ranked.is_sorted_by(|a, b| a.1 <= b.1));
            prop_assert_eq!(guess.place.map(|p| &guess.ranked[p].0), guess.place.map(|_| &guess.gloss));
        }
    }
}

#[test]
fn a_performance_is_told_by_both_hands() {
    // Right hands alone are nearer to the wrong one; left hands settle it.
    let hand = |gloss: &str, group: &str, side: Side, v: f32| {
        // A single frame: rates are 0 without any rounding.
        let rows = [[v, v, v]];
        Take { gloss: gloss.into(), group: group.into(), side, ..take(&(0, rows.to_vec()), 0, 1.0) }
    };
    let takes = [
        hand("help", "1", Side::Right, 0.0),
        hand("help", "1", Side::Left, 4.0),
        hand("help", "2", Side::Right, 1.0),
        hand("help", "2", Side::Left, 4.1),
        hand("like", "3", Side::Right, 0.7),
        hand("like", "3", Side::Left, -4.0),
    ];
    assert_eq!(leave_one_out(&takes)[0].place, Some(1));
    assert_eq!(leave_one_group_out(&takes)[0].place, Some(0));
}

#[test]
fn clips_without_hands_are_refused() {
    let bare = Skeleton::new(vec![chereme::motion::skeleton::Joint {
        name: "Hips".into(),
        parent: None,
        rest_model: DVec3::ZERO,
        tail_model: DVec3::Y,
    }]);
    let rig = Arc::new(bare.unwrap());
    let frame = Frame { pose: LocalPose::rest(&rig), weights: Vec::new() };
    let clip = Clip::new(rig, Fps::DEFAULT, Arc::new(Vec::new()), vec![frame]).unwrap();
    let error = features_of(&clip, &[Side::Right], &Options::default()).unwrap_err().to_string();
    assert!(error.contains("RightHandThumb1"), "{error}");
    assert!(features_of(&clip, &[], &Options { reference: Reference::Start, ..Options::default() }).is_err());
}

/// Six takes of each of twelve glosses that differ in each component; the whole set is measured by `examples/gloss_by_example.rs`.
#[test]
fn glosses_of_real_takes_are_found_by_example() {
    const GLOSSES: [&str; 12] =
        ["one", "two", "three", "five", "six", "nine", "father", "mother", "hello", "sorry", "thousand", "tomorrow"];
    let Some(folder) = shared("data/mocap/sign_hand_tsl") else { return };
    let wanted = |gloss: &str, number: usize, _: Side| number < 6 && GLOSSES.contains(&gloss);
    let files = gloss_by_example::recorded(&folder, &gloss_by_example::options(), wanted);
    let takes: Vec<Take> = files.iter().map(gloss_by_example::Recorded::as_take).collect();
    assert_eq!(takes.len(), 72);
    let guesses = leave_one_out(&takes);
    let (first, five) = (gloss_by_example::share(&guesses, 1), gloss_by_example::share(&guesses, 5));
    assert!(first >= 0.85 && five >= 0.98, "top-1 {first:.3}, top-5 {five:.3}");
    let performances = leave_one_group_out(&takes);
    let first = gloss_by_example::share(&performances, 1);
    assert!(performances.len() <= 72 && first >= 0.85, "{} performances, top-1 {first:.3}", performances.len());
}
