//! Peaks of motions as a table for the eye.

use crate::format::profile_plot::Motion;
use crate::motion::curve::{Curve, Measure, Profile};

const HEADINGS: [&str; 7] = ["motion", "curve", "least", "greatest", "at", "path", "lasts"];

/// One line a curve: its least and greatest value, when that is, how long the path is, how long the motion lasts.
pub(super) fn table(motions: &[Motion]) -> String {
    let mut rows = vec![HEADINGS.map(str::to_owned)];
    for motion in motions {
        rows.extend(motion.profile.curves().iter().map(|curve| row(motion, curve)));
    }
    let width = |column: usize| rows.iter().map(|r| r[column].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..HEADINGS.len()).map(width).collect();
    let mut text = String::new();
    for row in &rows {
        let cells = row.iter().zip(&widths).enumerate().map(|(i, (cell, width))| match i {
            0 | 1 => format!("{cell:<width$}"),
            _ => format!("{cell:>width$}"),
        });
        text += cells.collect::<Vec<_>>().join("  ").trim_end();
        text.push('\n');
    }
    text
}

fn row(motion: &Motion, curve: &Curve) -> [String; 7] {
    let with_unit = |value: f64| format!("{value:.3} {}", curve.measure.unit());
    let later = |a: (usize, f64), b: (usize, f64)| if b.1 > a.1 { b } else { a };
    let (at, greatest) = curve.values.iter().copied().enumerate().reduce(later).unwrap_or_default();
    let least = curve.values.iter().copied().fold(greatest, f64::min);
    let time = motion.profile.times().get(at).map_or(String::new(), |t| t.to_string());
    let path = match curve.measure {
        Measure::Speed => format!("{:.3} m", length(&motion.profile, curve)),
        Measure::X | Measure::Y | Measure::Z | Measure::Position | Measure::Height => String::new(),
        Measure::Acceleration | Measure::Jerk => String::new(),
    };
    let lasts = motion.profile.duration().to_string();
    [motion.name.clone(), curve.name(), with_unit(least), with_unit(greatest), time, path, lasts]
}

/// The length of the path whose speed this is: the area below the curve, metres.
fn length(profile: &Profile, speed: &Curve) -> f64 {
    let steps = profile.times().windows(2).zip(speed.values.windows(2));
    steps.map(|(t, v)| (t[1] - t[0]).0 * (v[0] + v[1]) / 2.0).sum()
}
