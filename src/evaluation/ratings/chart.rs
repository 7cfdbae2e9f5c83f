//! Ratings as a figure: box plots of realism as in the paper's figures 15 and 17, bars of recognition as in its figure 16.

use super::{Analysis, Cell, Group};
use crate::format::svg::chart::{Across, Chart, Mark, Panel, Shape};

/// What all items together are called.
const ALL: &str = "all";

/// The figure of an analysis: a panel a group and measure, a colour a version.
///
/// ```
/// use chereme::evaluation::ratings::{analyse, chart};
/// assert_eq!(chart::chart(&analyse(&[], None), "Ratings").title, "Ratings");
/// ```
pub fn chart(analysis: &Analysis, title: &str) -> Chart {
    let mut keys: Vec<String> = Vec::new();
    for cell in analysis.groups.iter().flat_map(|group| &group.cells) {
        if !keys.contains(&cell.version) {
            keys.push(cell.version.clone());
        }
    }
    let of = |group| [realism(group, &keys), recognition(group, &keys)];
    let panels = analysis.groups.iter().flat_map(of).flatten().collect();
    let subtitle = format!(
        "{} participants; boxes: quartiles, line the median, dotted the mean, whiskers to 1.5 interquartile ranges",
        analysis.participants
    );
    Chart { title: title.to_owned(), subtitle, keys, panels }
}

fn realism(group: &Group, keys: &[String]) -> Option<Panel> {
    let shape = |cell: &Cell, at, width| {
        cell.realism.map(|s| Shape::Box {
            at,
            width,
            five: [s.whisker_low, s.q1, s.median, s.q3, s.whisker_high],
            mean: s.mean,
        })
    };
    let title = format!("{}: realism (1 to 5)", group.name);
    panel(group, keys, title, vec![1.0, 5.0], shape)
}

fn recognition(group: &Group, keys: &[String]) -> Option<Panel> {
    let shape = |cell: &Cell, at, width| {
        let (_, _, rate) = cell.recognition?;
        Some(Shape::Bar { at, width, value: 100.0 * rate.share, interval: (100.0 * rate.low, 100.0 * rate.high) })
    };
    let title = format!("{}: recognised (%, with 95 % intervals)", group.name);
    panel(group, keys, title, vec![0.0, 100.0], shape)
}

/// A panel of one measure: the items side by side, the versions of each beside one another.
fn panel(
    group: &Group,
    keys: &[String],
    title: String,
    holds: Vec<f64>,
    shape: impl Fn(&Cell, f64, f64) -> Option<Shape>,
) -> Option<Panel> {
    let mut names: Vec<&str> = Vec::new();
    for cell in &group.cells {
        let name = cell.item.as_deref().unwrap_or(ALL);
        if !names.contains(&name) {
            names.push(name);
        }
    }
    let mut marks = Vec::new();
    for (i, name) in names.iter().enumerate() {
        let cells: Vec<&Cell> = group.cells.iter().filter(|c| c.item.as_deref().unwrap_or(ALL) == *name).collect();
        let width = (0.8 / cells.len() as f64).min(0.3);
        for (j, cell) in cells.iter().enumerate() {
            let at = i as f64 + (j as f64 - (cells.len() as f64 - 1.0) / 2.0) * width;
            let key = keys.iter().position(|k| *k == cell.version).unwrap_or(0);
            marks.extend(shape(cell, at, 0.82 * width).map(|shape| Mark { key, shape }));
        }
    }
    let across = Across::Names(names.into_iter().map(str::to_owned).collect());
    (!marks.is_empty()).then_some(Panel { title, across, holds, marks })
}
