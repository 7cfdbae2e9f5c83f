//! Figures as SVG: small multiples of curves over time, as the papers of the field print kinematic profiles.
//!
//! Rows are measures and share their scale, columns are motions and share the time axis; phases of the motion stand behind the curves
//! as bands, key instants as letters. Knows numbers and words alone; what they mean is the caller's.
//!
//! # Conventions
//! Seconds to the right, the row's unit upwards. One file without references, for light and dark surroundings (`prefers-color-scheme`);
//! all text is escaped. The same figure gives the same bytes.

pub mod chart;
mod draw;
mod scale;

use crate::motion::curve::Phase;
use crate::time::Seconds;

/// What is drawn.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Figure {
    /// The heading.
    pub title: String,
    /// A line below the heading; may be empty.
    pub subtitle: String,
    /// What each colour means; lines name them by number.
    pub keys: Vec<String>,
    /// From left to right.
    pub columns: Vec<Column>,
    /// From top to bottom.
    pub rows: Vec<Row>,
}

/// What stands above and behind the panels of a column.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Column {
    /// The heading; may be empty.
    pub title: String,
    /// Bands behind the curves.
    pub phases: Vec<Phase>,
    /// Letters at key instants.
    pub marks: Vec<Mark>,
}

/// A letter at an instant.
#[derive(Debug, Clone, PartialEq)]
pub struct Mark {
    /// The letter.
    pub name: String,
    /// Where it stands.
    pub time: Seconds,
}

/// Panels of one measure, with one scale.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// What is measured, with its unit.
    pub title: String,
    /// What the scale holds besides the curves.
    pub base: Base,
    /// One panel a column.
    pub panels: Vec<Panel>,
}

/// What a scale holds besides the curves.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Base {
    /// Nothing: it reaches from the least value to the greatest.
    Data,
    /// Zero, for what cannot be negative.
    Zero,
    /// A band as far below and above zero, for differences that have a tolerance, in the row's unit.
    Tolerance(f64),
}

/// The curves of a row in a column.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Panel {
    /// The curves, the last one uppermost.
    pub lines: Vec<Line>,
}

/// A curve.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    /// The number of its key.
    pub key: usize,
    /// Seconds and values; what is not finite is left out.
    pub points: Vec<(f64, f64)>,
}

/// The figure as an SVG document.
///
/// ```
/// use chereme::format::svg::{Base, Column, Figure, Line, Panel, Row, write};
/// let line = Line { key: 0, points: vec![(0.0, 0.0), (0.5, 1.2), (1.0, 0.0)] };
/// let row = Row { title: "speed (m/s)".into(), base: Base::Zero, panels: vec![Panel { lines: vec![line] }] };
/// let figure = Figure { title: "BOL".into(), keys: vec!["RightHand".into()], columns: vec![Column::default()], rows: vec![row], ..Figure::default() };
/// let svg = write(&figure);
/// assert!(svg.starts_with("<svg ") && svg.contains("speed (m/s)") && svg.contains(">1.0<"));
/// ```
pub fn write(figure: &Figure) -> String {
    draw::draw(figure)
}
