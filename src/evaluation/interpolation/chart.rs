//! The comparison as a figure: mean captured speed with its band beside the interpolations' speeds, and their errors.

use super::{Ends, Model, PROFILE, Report, Timing};
use crate::format::svg::chart::{Across, Chart, Mark, Panel, Shape};

/// The figure of all kinds: speed profiles, and errors with intervals.
///
/// ```
/// assert_eq!(chereme::evaluation::interpolation::chart::chart(&[], "", chereme::evaluation::interpolation::Ends::Whole).keys.len(), 6);
/// ```
pub fn chart(reports: &[Report], subtitle: &str, ends: Ends) -> Chart {
    let mut keys = vec!["captured (mean, quartiles)".to_owned()];
    keys.extend(Model::ALL.iter().map(Model::to_string));
    let panels = reports.iter().flat_map(|report| [speeds(report, ends), errors(report)]).collect();
    Chart { title: "Interpolations against captured motion".into(), subtitle: subtitle.to_owned(), keys, panels }
}

fn speeds(report: &Report, ends: Ends) -> Panel {
    let share = |i: usize| i as f64 / (PROFILE - 1) as f64;
    let band = report.profile.iter().enumerate().map(|(i, [low, _, high])| (share(i), *low, *high)).collect();
    let mean = report.profile.iter().enumerate().map(|(i, [_, mean, _])| (share(i), *mean)).collect();
    let k = report.k.map_or(crate::motion::easing::PAPER_STEEPNESS, |k| k.value);
    let mut marks = vec![Mark { key: 0, shape: Shape::Band(band) }];
    for (i, model) in Model::ALL.iter().enumerate() {
        let points = (0..PROFILE).map(|j| (share(j), Timing::of(model.easing(k), ends).rate(share(j)))).collect();
        marks.push(Mark { key: i + 1, shape: Shape::Line(points) });
    }
    marks.push(Mark { key: 0, shape: Shape::Line(mean) });
    let title = format!(
        "{}: speed, in mean speeds ({} transitions of {} takes; fitted k = {k:.1})",
        report.kind, report.transitions, report.takes
    );
    Panel { title, across: Across::Numbers("share of the transition".into()), holds: vec![0.0], marks }
}

fn errors(report: &Report) -> Panel {
    let mark = |(i, row): (usize, &super::Row)| {
        let e = row.error?;
        let (value, interval) = (100.0 * e.value, (100.0 * e.low, 100.0 * e.high));
        Some(Mark { key: i + 1, shape: Shape::Dot { at: i as f64, value, interval } })
    };
    let names = Model::ALL.iter().map(Model::to_string).collect();
    let marks = report.rows.iter().enumerate().filter_map(mark).collect();
    let title = format!("{}: error (% of the amplitude, mean with 95 % interval)", report.kind);
    Panel { title, across: Across::Names(names), holds: vec![0.0], marks }
}
