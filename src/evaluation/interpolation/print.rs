//! The comparison as tables: for the eye, and a row a transition for other programs.

use super::{Interval, Model, Report, Row, Rule, Transition, Trim};
use std::fmt::Write;

/// The reports as text.
///
/// ```
/// use chereme::evaluation::interpolation::{Rule, print, summarise};
/// assert!(print::text(&summarise(&[], 0), &Rule::default()).starts_with("rest: at most 5 %"));
/// ```
pub fn text(reports: &[Report], rule: &Rule) -> String {
    let mut out = format!(
        "rest: at most {} % of the peak speed; speeds smoothed by {} ms; means and medians with 95 % intervals over takes\n",
        100.0 * rule.rest,
        1000.0 * rule.smoothing.0
    );
    if rule.trim == Trim::AsCut {
        out += "interpolations are trimmed as the motion is; a fitted k cannot be told from any greater one\n";
    }
    for report in reports {
        out += &one(report);
    }
    out
}

fn one(report: &Report) -> String {
    let mut out = format!("\n{}: {} transitions of {} takes", report.kind, report.transitions, report.takes);
    if report.takes < 10 {
        out += " (intervals over so few takes say little)";
    }
    let _ = writeln!(
        out,
        "\n  median duration {} s, amplitude {} m, peak at {} of the time, {} mean speeds high",
        value(report.duration, 3),
        value(report.amplitude, 3),
        value(report.peak_at, 3),
        value(report.peak_speed, 2)
    );
    let _ = writeln!(
        out,
        "  fitted k {}; beside the interpolated path, whatever the timing: {} of the amplitude",
        value(report.k, 2),
        percent(report.path_error)
    );
    let mut rows = vec![
        ["interpolation", "error", "minus sigmoid's", "nearest", "speed correlation", "peak time", "peak height"]
            .map(str::to_owned),
    ];
    for row in &report.rows {
        let nearest = if row.model == Model::Fitted { "–".into() } else { format!("{:.0} %", 100.0 * row.nearest) };
        rows.push([
            row.model.to_string(),
            percent(row.error),
            if row.model == Model::Sigmoid { "–".into() } else { percent(row.against_sigmoid) },
            nearest,
            value(row.correlation, 3),
            value(row.peak_time, 2),
            value(row.peak_height, 2),
        ]);
    }
    out + &columns(&rows) + &finding(report)
}

/// Which interpolation is nearest on average, beside what the paper found: the sigmoid (its figures 6 and 10, judged by eye).
fn finding(report: &Report) -> String {
    let mut fixed: Vec<&Row> = report.rows.iter().filter(|row| row.model != Model::Fitted).collect();
    let error = |row: &Row| row.error.map_or(f64::INFINITY, |e| e.value);
    fixed.sort_by(|a, b| error(a).total_cmp(&error(b)));
    let [best, second, ..] = fixed[..] else { return String::new() };
    let told = match best.model {
        Model::Sigmoid if second.against_sigmoid.is_some_and(|d| d.low > 0.0) => "as in the paper".to_owned(),
        Model::Sigmoid => format!("as in the paper, but {} is not told apart from it", second.model),
        _ if best.against_sigmoid.is_some_and(|d| d.high < 0.0) => {
            "nearer than the sigmoid, which the paper chose".to_owned()
        }
        _ => "not told apart from the sigmoid, which the paper chose".to_owned(),
    };
    format!("  nearest on average: {} ({told})\n", best.model)
}

/// Rows in columns of one width, the first to the left.
pub(in crate::evaluation) fn columns<const N: usize>(rows: &[[String; N]]) -> String {
    let width = |column: usize| rows.iter().map(|r| r[column].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..N).map(width).collect();
    let mut out = String::new();
    for row in rows {
        let cells = row.iter().zip(&widths).enumerate().map(|(i, (cell, width))| match i {
            0 => format!("{cell:<width$}"),
            _ => format!("{cell:>width$}"),
        });
        let _ = writeln!(out, "  {}", cells.collect::<Vec<_>>().join("  ").trim_end());
    }
    out
}

/// An estimate with its interval.
pub(in crate::evaluation) fn value(interval: Interval, decimals: usize) -> String {
    match interval {
        Some(e) => format!("{:.decimals$} [{:.decimals$}, {:.decimals$}]", e.value, e.low, e.high),
        None => "–".into(),
    }
}

fn percent(interval: Interval) -> String {
    match interval {
        Some(e) => format!("{:.1} % [{:.1}, {:.1}]", 100.0 * e.value, 100.0 * e.low, 100.0 * e.high),
        None => "–".into(),
    }
}

/// A row a transition and interpolation.
///
/// ```
/// assert!(chereme::evaluation::interpolation::print::csv(&[]).starts_with("take,kind,start_s"));
/// ```
pub fn csv(transitions: &[Transition]) -> String {
    let mut writer = ::csv::WriterBuilder::new().from_writer(Vec::new());
    let headings = [
        "take",
        "kind",
        "start_s",
        "duration_s",
        "amplitude_m",
        "path_error",
        "k",
        "interpolation",
        "error",
        "speed_correlation",
        "peak_time_ratio",
        "peak_height_ratio",
    ];
    let mut whole = writer.write_record(headings).is_ok();
    for t in transitions {
        for (model, close) in Model::ALL.iter().zip(&t.models) {
            let number = |v: f64| format!("{v:.6}");
            let k = if *model == Model::Fitted { number(t.k) } else { String::new() };
            let row = [
                t.take.clone(),
                t.kind.to_string(),
                number(t.start.0),
                number(t.duration.0),
                number(t.amplitude),
                number(t.path_error),
                k,
                model.to_string(),
                number(close.error),
                close.correlation.map_or(String::new(), number),
                number(close.peak_time),
                number(close.peak_height),
            ];
            whole &= writer.write_record(row).is_ok();
        }
    }
    // Rows of one length into memory cannot fail.
    debug_assert!(whole, "a row was not written");
    String::from_utf8(writer.into_inner().unwrap_or_default()).unwrap_or_default()
}
