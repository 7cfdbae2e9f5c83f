//! Ratings as tables: for the eye, and for other programs.

use super::{Analysis, Cell, Comparison, Group, Measure, Pair};
use crate::evaluation::statistics::Method;
use std::fmt::Write;

/// The analysis as text; p at or above the threshold is "no significant difference", which is not equality.
///
/// ```
/// use chereme::evaluation::ratings::{THRESHOLD, analyse, print};
/// assert!(print::text(&analyse(&[], None), THRESHOLD).starts_with("0 participants; a difference is significant where p < 0.01"));
/// ```
pub fn text(analysis: &Analysis, threshold: f64) -> String {
    let people = |n| if n == 1 { "1 participant".to_owned() } else { format!("{n} participants") };
    let mut out = people(analysis.participants);
    if analysis.left_out > 0 {
        let _ = write!(out, " ({} left out by level)", analysis.left_out);
    }
    let _ = writeln!(out, "; a difference is significant where p < {threshold}, after Holm among pairs");
    out += "Answers are tested as if they were independent, as in the paper, though one person gives several; no significant difference is not equality.\n";
    for group in &analysis.groups {
        let _ = write!(out, "\n{}\n", group.name);
        out += &cells(group);
        group.comparisons.iter().for_each(|c| out += &comparison(c, threshold));
    }
    out
}

fn cells(group: &Group) -> String {
    let mut rows = vec![["item", "version", "n", "mean", "SD", "median", "recognised", "95 %"].map(str::to_owned)];
    rows.extend(group.cells.iter().map(row));
    let width = |column: usize| rows.iter().map(|r| r[column].chars().count()).max().unwrap_or(0);
    let widths: Vec<usize> = (0..8).map(width).collect();
    let mut out = String::new();
    for row in &rows {
        let cells = row.iter().zip(&widths).enumerate().map(|(i, (cell, width))| match i {
            0 | 1 => format!("{cell:<width$}"),
            _ => format!("{cell:>width$}"),
        });
        let _ = writeln!(out, "  {}", cells.collect::<Vec<_>>().join("  ").trim_end());
    }
    out
}

fn row(cell: &Cell) -> [String; 8] {
    let or_none = |text: Option<String>| text.unwrap_or_else(|| "–".into());
    let realism =
        |f: fn(&crate::evaluation::statistics::describe::Summary) -> String| or_none(cell.realism.as_ref().map(f));
    let recognised = cell.recognition.map(|(hits, n, rate)| format!("{hits}/{n} = {:.1} %", 100.0 * rate.share));
    let interval = cell.recognition.map(|(_, _, rate)| format!("{:.1}–{:.1} %", 100.0 * rate.low, 100.0 * rate.high));
    [
        cell.item.clone().unwrap_or_else(|| "all".into()),
        cell.version.clone(),
        realism(|s| s.n.to_string()),
        realism(|s| format!("{:.3}", s.mean)),
        realism(|s| format!("{:.3}", s.sd)),
        realism(|s| format!("{}", s.median)),
        or_none(recognised),
        or_none(interval),
    ]
}

fn comparison(comparison: &Comparison, threshold: f64) -> String {
    let about = match &comparison.item {
        Some(item) => format!("{} of {item}", comparison.measure),
        None => comparison.measure.to_string(),
    };
    let Some(all) = &comparison.all else {
        return format!("  {about}: all values are equal, there is nothing to test\n");
    };
    let mut out = format!(
        "  {about}: Kruskal–Wallis H({}) = {:.3}, p = {}, ε² = {:.3}: {}\n",
        all.df,
        all.h,
        p(all.p),
        all.epsilon_squared,
        verdict(all.p, threshold)
    );
    for pair in &comparison.pairs {
        out += &line(pair, threshold);
    }
    out
}

fn line(pair: &Pair, threshold: f64) -> String {
    let method = match pair.test.method {
        Method::Exact => "exact",
        Method::Normal => "normal",
    };
    format!(
        "    {} – {}: Mann–Whitney U = {}, p = {} ({method}), Holm p = {}, rank-biserial r = {:+.3}: {}\n",
        pair.first,
        pair.second,
        pair.test.u,
        p(pair.test.p),
        p(pair.p_holm),
        pair.test.rank_biserial,
        verdict(pair.p_holm, threshold)
    )
}

fn verdict(p: f64, threshold: f64) -> &'static str {
    if p < threshold { "differs" } else { "no significant difference" }
}

/// A p-value in three digits.
fn p(value: f64) -> String {
    if value < 1e-4 { format!("{value:.2e}") } else { format!("{value:.4}") }
}

/// The analysis as CSV: a row a cell, a test over all versions, a test of two versions.
///
/// ```
/// use chereme::evaluation::ratings::{analyse, print};
/// assert!(print::csv(&analyse(&[], None)).starts_with("kind,group,item,measure"));
/// ```
pub fn csv(analysis: &Analysis) -> String {
    let mut rows = vec![HEADINGS.map(str::to_owned).to_vec()];
    for group in &analysis.groups {
        for cell in &group.cells {
            rows.push(cell_row(group, cell));
        }
        for comparison in &group.comparisons {
            rows.extend(test_rows(group, comparison));
        }
    }
    let mut writer = ::csv::WriterBuilder::new().from_writer(Vec::new());
    // Rows of one length into memory cannot fail.
    let whole = rows.iter().all(|row| writer.write_record(row).is_ok());
    debug_assert!(whole, "a row was not written");
    String::from_utf8(writer.into_inner().unwrap_or_default()).unwrap_or_default()
}

const HEADINGS: [&str; 23] = [
    "kind",
    "group",
    "item",
    "measure",
    "version",
    "against",
    "n",
    "mean",
    "sd",
    "median",
    "q1",
    "q3",
    "hits",
    "answers",
    "rate",
    "rate_low",
    "rate_high",
    "statistic",
    "df",
    "p",
    "p_holm",
    "effect",
    "method",
];

fn cell_row(group: &Group, cell: &Cell) -> Vec<String> {
    let item = cell.item.clone().unwrap_or_default();
    let mut row: Vec<String> =
        vec!["cell".into(), group.name.clone(), item, String::new(), cell.version.clone(), String::new()];
    match &cell.realism {
        Some(s) => {
            row.push(s.n.to_string());
            row.extend([s.mean, s.sd, s.median, s.q1, s.q3].map(|v| v.to_string()));
        }
        None => row.extend(vec![String::new(); 6]),
    }
    match &cell.recognition {
        Some((hits, n, rate)) => {
            row.extend([hits.to_string(), n.to_string()]);
            row.extend([rate.share, rate.low, rate.high].map(|v| v.to_string()));
        }
        None => row.extend(vec![String::new(); 5]),
    }
    row.extend(vec![String::new(); 6]);
    row
}

fn test_rows(group: &Group, comparison: &Comparison) -> Vec<Vec<String>> {
    let item = comparison.item.clone().unwrap_or_default();
    let start = |kind: &str, first: &str, second: &str| {
        let mut row: Vec<String> = vec![kind.into(), group.name.clone(), item.clone(), measure(comparison.measure)];
        row.extend([first.to_owned(), second.to_owned()]);
        row.extend(vec![String::new(); 11]);
        row
    };
    let mut rows = Vec::new();
    if let Some(all) = &comparison.all {
        let mut row = start("kruskal-wallis", "", "");
        row.extend([all.h.to_string(), all.df.to_string(), all.p.to_string(), String::new()]);
        row.extend([all.epsilon_squared.to_string(), "chi-square".into()]);
        rows.push(row);
    }
    for pair in &comparison.pairs {
        let mut row = start("mann-whitney", &pair.first, &pair.second);
        row.extend([pair.test.u.to_string(), String::new(), pair.test.p.to_string(), pair.p_holm.to_string()]);
        let method = if pair.test.method == Method::Exact { "exact" } else { "normal" };
        row.extend([pair.test.rank_biserial.to_string(), method.into()]);
        rows.push(row);
    }
    rows
}

fn measure(measure: Measure) -> String {
    measure.to_string()
}
