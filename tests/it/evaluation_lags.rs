//! `chereme evaluate lags`: known lags are found again.

use crate::cli::{Folder, run};
use crate::evaluation_moving::{When, take};
use chereme::evaluation::lags::{Channel, Rule, find, summarise};
use chereme::format::bvh;
use chereme::motion::easing::Easing;
use proptest::prelude::*;

fn jerk(start: f64, end: f64) -> When {
    When::new(start, end, Easing::MinimumJerk)
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(16))]

    #[test]
    fn known_lags_are_found(configuration in -0.3..0.3f64, palm in -0.3..0.3f64) {
        // All three last 0.8 s, so the threshold is reached as long before the end in each; bent fingers move their tips
        // less, and reach it somewhat earlier.
        let clip = take(60.0, jerk(0.7, 1.5), jerk(0.7 + palm, 1.5 + palm), jerk(0.7 + configuration, 1.5 + configuration));
        let stops = find("take", &clip, &Rule::default());
        prop_assert_eq!(stops.len(), 1);
        let lag = |channel| stops[0].lag(channel).unwrap();
        prop_assert!((lag(Channel::Configuration) - configuration).abs() < 0.02, "{} {configuration}", lag(Channel::Configuration));
        prop_assert!((lag(Channel::Palm) - palm).abs() < 0.01, "{} {palm}", lag(Channel::Palm));
        let share = stops[0].share(Channel::Configuration).unwrap();
        let lasts = stops[0].wrist.end.0 - stops[0].wrist.start.0;
        prop_assert!((share - 1.0 - configuration / lasts).abs() < 0.03);
    }
}

#[test]
fn what_goes_on_at_another_time_is_no_pair() {
    let clip = take(60.0, jerk(0.3, 1.0), jerk(0.3, 1.0), jerk(1.4, 2.1));
    let stops = find("take", &clip, &Rule::default());
    assert!(stops.len() == 1 && stops[0].configuration.is_none() && stops[0].palm.is_some(), "{stops:?}");
}

#[test]
fn medians_are_over_takes_and_repeat() {
    let lags = [-0.2, -0.16, -0.12, -0.08];
    let stops: Vec<_> = lags
        .iter()
        .flat_map(|lag| {
            find(
                &format!("{lag}"),
                &take(60.0, jerk(0.6, 1.4), jerk(0.6, 1.4), jerk(0.6 + lag, 1.4 + lag)),
                &Rule::default(),
            )
        })
        .collect();
    let summaries = summarise(&stops, 3);
    let median = summaries[0].lag.unwrap();
    assert!((median.value + 0.14).abs() < 0.02 && median.clusters == 4 && summaries[0].earlier == 1.0, "{summaries:?}");
    assert!(summaries[2].what == "configuration against palm" && summaries[2].share.is_none());
    assert_eq!(summaries, summarise(&stops, 3));
}

#[test]
fn the_command_prints_defaults_for_synthesis() {
    let folder = Folder::new("lags");
    let clip = take(60.0, jerk(0.6, 1.4), jerk(0.6, 1.4), jerk(0.6, 1.2));
    folder.write("one.bvh", &bvh::write(&clip, &bvh::Options::default()).unwrap());
    let args = ["evaluate", "lags", "one.bvh", "-o", "lags.csv", "-o", "lags.svg", "-q"];
    let done = run(&folder.0, &args, "");
    assert!(done.code == 0 && done.out.contains("1 wrist movements of 1 takes"), "{}{}", done.out, done.err);
    assert!(done.out.contains("handshape lead 0."), "{}", done.out);
    assert_eq!(std::fs::read_to_string(folder.0.join("lags.csv")).unwrap().lines().count(), 2);
    let piped = run(
        &folder.0,
        &["evaluate", "lags", "-", "-o", "-"],
        &std::fs::read_to_string(folder.0.join("one.bvh")).unwrap(),
    );
    assert!(piped.code == 0 && piped.out.starts_with("take,side,"), "{}{}", piped.out, piped.err);
}
