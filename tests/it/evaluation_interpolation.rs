//! `chereme evaluate interpolation`: on constructed transitions the right model wins; what comes out of captured ones.

use crate::cli::{Folder, run};
use crate::evaluation_moving::{When, take};
use crate::shared::shared;
use chereme::evaluation::interpolation::{Model, Rule, Transition, Trim, compare, find, print, summarise};
use chereme::evaluation::kinematics::cut::transitions;
use chereme::evaluation::kinematics::{Kind, Movement, distance};
use chereme::format::bvh;
use chereme::motion::easing::Easing;
use chereme::time::{Fps, Seconds};
use glam::DVec3;
use proptest::prelude::*;

const SMOOTHING: Seconds = Seconds(0.02);

/// Fingers that move from 0.6 s to 1.4 s by an easing.
fn fingers(easing: Easing) -> Movement {
    let when = When::new(0.6, 1.4, easing);
    let all = Movement::of_clip("take", &take(60.0, when, when, when));
    all.into_iter().find(|m| m.kind() == Kind::Fingers).unwrap()
}

fn error(transition: &Transition, model: Model) -> f64 {
    transition.models[model as usize].error
}

#[test]
fn the_right_model_wins_with_nearly_no_error() {
    let right = [
        (Easing::Linear, Model::Slerp),
        (Easing::Cosine, Model::Cosine),
        (Easing::Sigmoid { k: 10.0 }, Model::Sigmoid),
        (Easing::MinimumJerk, Model::MinimumJerk),
    ];
    for (easing, model) in right {
        let transition = compare(&fingers(easing), 36, 84, SMOOTHING).unwrap();
        assert!(error(&transition, model) < 1e-4 && transition.path_error < 1e-4, "{easing}: {transition:?}");
        let close = transition.models[model as usize];
        assert!((close.peak_height - 1.0).abs() < 0.01, "{easing}: {close:?}");
        assert!(close.correlation.unwrap() > 0.999, "{easing}: {close:?}");
        for other in Model::ALL.into_iter().filter(|m| ![model, Model::Fitted].contains(m)) {
            assert!(error(&transition, other) > 0.01, "{other} for {easing}: {}", error(&transition, other));
        }
        // The fitted sigmoid is never worse than the paper's.
        assert!(error(&transition, Model::Fitted) <= error(&transition, Model::Sigmoid) + 1e-9);
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    #[test]
    fn the_fitted_k_is_the_k_that_moved(k in 2.0..25.0f64) {
        let transition = compare(&fingers(Easing::Sigmoid { k }), 36, 84, SMOOTHING).unwrap();
        prop_assert!((transition.k - k).abs() < 0.01 * k, "{} is not {k}", transition.k);
        prop_assert!(error(&transition, Model::Fitted) < 1e-3);
    }

    #[test]
    fn cuts_are_apart_and_at_rest(speed in prop::collection::vec(0.0..1.0f64, 0..80), rest in 0.02..0.5f64) {
        let cuts = transitions(&speed, rest);
        for cut in &cuts {
            prop_assert!(cut.start < cut.peak && cut.peak < cut.end);
            prop_assert!(speed[cut.start] <= rest * speed[cut.peak] && speed[cut.end] <= rest * speed[cut.peak]);
            prop_assert!(speed[cut.start..=cut.end].iter().all(|v| *v <= speed[cut.peak]));
            prop_assert!((cut.start as f64..=cut.go.ceil()).contains(&cut.go) && cut.stop <= cut.end as f64);
        }
        prop_assert!(cuts.windows(2).all(|pair| pair[0].end <= pair[1].start));
    }
}

/// Cut at 5 %, a minimum-jerk movement is nearest to the cosine; held against interpolations that are cut as well, to itself.
#[test]
fn trimmed_interpolations_undo_the_bias_of_the_cut() {
    for (easing, model) in [(Easing::MinimumJerk, Model::MinimumJerk), (Easing::Cosine, Model::Cosine)] {
        let rule = Rule { trim: Trim::AsCut, smoothing: Seconds(0.0), ..Rule::default() };
        let when = When::new(0.6, 1.4, easing);
        let movements = Movement::of_clip("take", &take(240.0, when, when, when));
        let hand = movements.iter().find(|m| m.kind() == Kind::Hand).unwrap();
        let found = find(hand, &rule);
        assert_eq!(found.len(), 1);
        let own = error(&found[0], model);
        assert!(own < 0.005, "{easing}: {:?}", found[0]);
        let others =
            [Model::Slerp, Model::Cosine, Model::MinimumJerk, Model::Sigmoid].into_iter().filter(|m| *m != model);
        others.for_each(|other| assert!(error(&found[0], other) > own, "{other} for {easing}: {:?}", found[0]));
    }
}

/// A sigmoid cut at a share of its peak has the steepness that the theory says: the threshold decides the fitted k.
#[test]
fn the_threshold_decides_the_fitted_k() {
    for (rest, k) in [(0.05, 8.73), (0.1, 7.27)] {
        let rule = Rule { rest, ..Rule::default() };
        let found = find(&fingers(Easing::Sigmoid { k: 14.0 }), &rule);
        assert_eq!(found.len(), 1);
        // Smoothing and whole frames widen the cut a little.
        assert!((found[0].k - k).abs() < 1.2, "{} is not {k}", found[0].k);
    }
}

#[test]
fn an_arm_of_markers_turns_its_bones() {
    let arm = |w: f64| {
        let (up, fore) = (glam::DQuat::from_rotation_z(0.9 * w), glam::DQuat::from_rotation_z(1.7 * w));
        let elbow = DVec3::Y + up * DVec3::new(0.0, -0.3, 0.0);
        [DVec3::Y, elbow, elbow + fore * DVec3::new(0.0, -0.25, 0.0)]
    };
    let fps = Fps::new(100.0).unwrap();
    let frames = (0..=80).map(|i| arm(Easing::MinimumJerk.weight(f64::from(i) / 80.0))).collect();
    let movement = Movement::of_arm("arm", fps, frames).unwrap();
    let transition = compare(&movement, 0, 80, SMOOTHING).unwrap();
    assert!(error(&transition, Model::MinimumJerk) < 1e-4, "{transition:?}");
    let (way, first) = (movement.way(0, 80), &movement.frames()[0]);
    assert!(distance(&way.at(0.0), first) < 1e-12 && distance(&way.at(1.0), &movement.frames()[80]) < 1e-9);
    assert!(Movement::of_path("p", fps, vec![]).is_none() && Movement::of_path("p", fps, vec![DVec3::NAN]).is_none());
}

#[test]
fn summaries_say_which_is_nearest() {
    let found: Vec<Transition> = [0.0, 0.1, 0.2]
        .into_iter()
        .map(|shift| {
            let when = When::new(0.6 + shift, 1.4 + shift, Easing::MinimumJerk);
            let all = Movement::of_clip(&format!("take {shift}"), &take(60.0, when, when, when));
            let movement = all.into_iter().find(|m| m.kind() == Kind::Fingers).unwrap();
            let start = (60.0 * (0.6 + shift)).round() as usize;
            compare(&movement, start, start + 48, SMOOTHING).unwrap()
        })
        .collect();
    let reports = summarise(&found, 1);
    assert_eq!((reports.len(), reports[0].transitions, reports[0].takes), (1, 3, 3));
    let row = |model: Model| reports[0].rows.iter().find(|row| row.model == model).unwrap();
    assert_eq!((row(Model::MinimumJerk).nearest, row(Model::Sigmoid).nearest), (1.0, 0.0));
    assert!(row(Model::MinimumJerk).against_sigmoid.unwrap().high < 0.0);
    assert_eq!(reports, summarise(&found, 1));
    let text = print::text(&reports, &Rule::default());
    assert!(
        text.contains("nearest on average: minimum jerk (nearer than the sigmoid, which the paper chose)"),
        "{text}"
    );
    assert_eq!(print::csv(&found).lines().count(), 1 + 3 * 5);
}

#[test]
fn the_command_measures_files_and_says_what_it_cannot_read() {
    let folder = Folder::new("interpolation");
    let when = When::new(0.6, 1.4, Easing::MinimumJerk);
    let clip = take(60.0, when, when, when);
    let text = bvh::write(&clip, &bvh::Options::default()).unwrap();
    folder.write("takes/one.bvh", &text);
    folder.write("takes/two.bvh", &text);
    folder.write("takes/broken.bvh", "HIERARCHY\nROOT x\n");
    let args = ["evaluate", "interpolation", "takes", "-o", "out/i.csv", "-o", "out/i.svg", "-q"];
    let done = run(&folder.0, &args, "");
    assert!(done.code == 0 && done.err.contains("broken.bvh:") && done.err.contains("1 file left out"), "{}", done.err);
    assert!(
        done.out.contains("fingers: 2 transitions of 2 takes (intervals over so few takes say little)"),
        "{}",
        done.out
    );
    assert!(done.out.contains("minimum jerk") && done.out.contains("hand: 2 transitions"), "{}", done.out);
    let svg = std::fs::read_to_string(folder.0.join("out/i.svg")).unwrap();
    assert!(svg.contains("<polygon") && svg.contains("fingers: error"), "{svg}");
    assert_eq!(run(&folder.0, &args, "").code, 2);
    let share = run(&folder.0, &["evaluate", "interpolation", "takes", "--rest", "5"], "");
    assert!(share.code == 2 && share.err.contains("between 0 and 1"), "{}", share.err);
    let still = run(&folder.0, &["evaluate", "interpolation", "takes/broken.bvh"], "");
    assert!(still.code == 1 && still.err.contains("no recording that can be read"), "{}", still.err);
}

#[test]
fn tables_of_markers_are_read_or_refused_with_their_place() {
    let folder = Folder::new("markers");
    let mut table =
        String::from("NO_OF_FRAMES\t160\nFREQUENCY\t100\nMARKER_NAMES\thand_top\tright_elbow\tright_shoulder\n");
    table += "Frame\tTime\thand_top X\thand_top Y\thand_top Z\tright_elbow X\tright_elbow Y\tright_elbow Z\tright_shoulder X\tright_shoulder Y\tright_shoulder Z\n";
    for i in 0..160 {
        let w = Easing::MinimumJerk.weight((f64::from(i) - 40.0) / 80.0);
        let (x, y) = (250.0 * (1.2 * w).sin(), -300.0 - 250.0 * (1.2 * w).cos());
        table += &format!("{i}\t{}\t{x}\t{y}\t9\t0\t-300\t9\t0\t0\t9\n", f64::from(i) / 100.0);
    }
    folder.write("arm.tsv", &table);
    let done = run(&folder.0, &["evaluate", "interpolation", "arm.tsv", "-q"], "");
    assert!(done.code == 0 && done.out.contains("reaching: 1 transitions of 1 takes"), "{}{}", done.out, done.err);
    // The cut takes the slow ends of a minimum-jerk movement away, and what is left is nearer to the cosine: the bias that
    // the module's documentation names.
    assert!(done.out.contains("nearest on average: cosine"), "{}", done.out);
    let refused = |name: &str, text: &str, what: &str| {
        folder.write(name, text);
        let done = run(&folder.0, &["evaluate", "interpolation", name, "-q"], "");
        assert!(done.code == 1 && done.err.contains(what), "{}", done.err);
    };
    refused("hole.tsv", &table.replace("\n7\t0.07\t0\t", "\n7\t0.07\tx\t"), "hole.tsv:12:");
    refused("rate.tsv", &table.replace("FREQUENCY\t100", "FREQUENCY\t0"), "rate.tsv:2:");
    refused("names.tsv", &table.replace("elbow", "knee"), "no marker whose name ends in `elbow`");
    refused(
        "huge.bvh",
        "HIERARCHY\nROOT Palm {\n OFFSET 0 0 0\n CHANNELS 1 Xrotation\n End Site {\n OFFSET 0 1 0 } }\nMOTION\nFrames: 1\nFrame Time: .1\n0\n",
        "neither a person nor a hand",
    );
}

/// Captured takes: each has transitions, and no model but the fitted one is better than the fitted one.
#[test]
fn captured_takes_have_transitions() {
    let Some(folder) = shared("data/mocap/sign_hand_tsl") else { return };
    let mut found = 0;
    for take in ["come-quickly_0_right", "come-quickly_1_right", "eight_0_right"] {
        let bytes = std::fs::read(folder.join(format!("{take}.bvh"))).unwrap();
        let options = bvh::ClipOptions { metres_per_unit: 0.001, roots: bvh::Roots::One };
        let clip = bvh::to_clip(&bvh::read(&bytes).unwrap().bvh, &options).unwrap().clip;
        for movement in Movement::of_clip(take, &clip.into()) {
            for t in find(&movement, &Rule { rest: 0.1, ..Rule::default() }) {
                found += 1;
                assert!(error(&t, Model::Fitted) <= error(&t, Model::Sigmoid) + 1e-6);
                assert!(error(&t, Model::Fitted) + 1e-6 >= t.path_error, "{t:?}");
            }
        }
    }
    println!("{found} transitions");
}
