//! Lags as tables and as a figure.

use super::{Channel, Rule, Stop, Summary};
use crate::evaluation::interpolation::print::{columns, value};
use crate::evaluation::statistics::describe;
use crate::format::svg::chart::{Across, Chart, Mark, Panel, Shape};

/// The medians as text, and what they suggest for synthesis.
///
/// ```
/// use chereme::evaluation::lags::{Rule, print, summarise};
/// assert!(print::text(&[], &summarise(&[], 0), &Rule::default()).starts_with("0 wrist movements of 0 takes"));
/// ```
pub fn text(stops: &[Stop], summaries: &[Summary], rule: &Rule) -> String {
    let mut takes: Vec<&str> = stops.iter().map(|s| s.take.as_str()).collect();
    takes.sort_unstable();
    takes.dedup();
    let mut out = format!(
        "{} wrist movements of {} takes; rest: at most {} % of a movement's peak speed; medians with 95 % intervals over takes\n",
        stops.len(),
        takes.len(),
        100.0 * rule.rest
    );
    let mut rows = vec![["end of", "pairs", "lag (s)", "share of the wrist's movement", "earlier"].map(str::to_owned)];
    for s in summaries {
        let n = s.lag.map_or(0, |l| l.n);
        let earlier = if n == 0 { "–".into() } else { format!("{:.0} %", 100.0 * s.earlier) };
        rows.push([s.what.clone(), n.to_string(), value(s.lag, 3), value(s.share, 2), earlier]);
    }
    out += &columns(&rows);
    for (summary, default) in summaries.iter().zip(["handshape lead", "palm lead"]) {
        if let Some(share) = summary.share {
            // A lead beyond the whole transition would go on when the wrist has stopped; synthesis knows none.
            let after = if share.value > 1.0 { " (it ends after the wrist: no lead)" } else { "" };
            out +=
                &format!("as a default of synthesis: {default} {:.2} of a transition{after}\n", share.value.min(1.0));
        }
    }
    out
}

/// A row a wrist movement.
///
/// ```
/// assert!(chereme::evaluation::lags::print::csv(&[]).starts_with("take,side,wrist_start_s"));
/// ```
pub fn csv(stops: &[Stop]) -> String {
    let mut writer = ::csv::WriterBuilder::new().from_writer(Vec::new());
    let headings = [
        "take",
        "side",
        "wrist_start_s",
        "wrist_end_s",
        "configuration_start_s",
        "configuration_end_s",
        "palm_start_s",
        "palm_end_s",
        "configuration_lag_s",
        "palm_lag_s",
        "configuration_share",
        "palm_share",
    ];
    let mut whole = writer.write_record(headings).is_ok();
    for stop in stops {
        let number = |v: Option<f64>| v.map_or(String::new(), |v| format!("{v:.5}"));
        let mut row = vec![stop.take.clone(), stop.side.to_owned()];
        for stretch in [Some(stop.wrist), stop.configuration, stop.palm] {
            row.extend([number(stretch.map(|s| s.start.0)), number(stretch.map(|s| s.end.0))]);
        }
        row.extend(Channel::ALL.map(|channel| number(stop.lag(channel))));
        row.extend(Channel::ALL.map(|channel| number(stop.share(channel))));
        whole &= writer.write_record(row).is_ok();
    }
    // Rows of one length into memory cannot fail.
    debug_assert!(whole, "a row was not written");
    String::from_utf8(writer.into_inner().unwrap_or_default()).unwrap_or_default()
}

/// The lags as box plots.
///
/// ```
/// assert_eq!(chereme::evaluation::lags::print::chart(&[]).panels.len(), 1);
/// ```
pub fn chart(stops: &[Stop]) -> Chart {
    let mark = |(i, channel): (usize, Channel)| {
        let lags: Vec<f64> = stops.iter().filter_map(|s| s.lag(channel)).map(|l| 1000.0 * l).collect();
        let s = describe::summary(&lags)?;
        let five = [s.whisker_low, s.q1, s.median, s.q3, s.whisker_high];
        Some(Mark { key: i, shape: Shape::Box { at: i as f64, width: 0.4, five, mean: s.mean } })
    };
    let names: Vec<String> = Channel::ALL.iter().map(Channel::to_string).collect();
    let panel = Panel {
        title: "end of the channel less the wrist's stop (ms)".into(),
        across: Across::Names(names.clone()),
        holds: vec![0.0],
        marks: Channel::ALL.into_iter().enumerate().filter_map(mark).collect(),
    };
    let subtitle = format!("{} wrist movements; below zero the channel ends first", stops.len());
    Chart { title: "Lags between channels".into(), subtitle, keys: names, panels: vec![panel] }
}
