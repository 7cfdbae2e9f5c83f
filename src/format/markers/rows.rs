//! A row of positions.

use crate::diagnostics::xml::short;
use crate::diagnostics::{Diagnostic, Span};
use crate::format::cells::Cell;
use crate::format::told::Told;
use glam::DVec3;

/// What a marker at 0, 0, 0 is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Zeros {
    Seen,
    /// A marker that was not seen.
    Missing,
}

/// Where a row is.
pub(super) fn whole(cells: &[Cell<'_>]) -> Span {
    cells.first().zip(cells.last()).map(|(a, b)| a.span.to(b.span)).unwrap_or_default()
}

/// Whether a cell is a number, finite or not.
pub(super) fn is_number(text: &str) -> bool {
    text.parse::<f64>().is_ok()
}

/// Whether a row has as many cells as the others; where it has not, that is told. Empty cells behind are left out.
pub(super) fn fits(cells: &[Cell<'_>], columns: usize, told: &mut Told) -> bool {
    let behind = cells.iter().skip(columns).all(|cell| cell.text.is_empty());
    if cells.len() < columns || !behind {
        let message = format!("this row has {} numbers, and the others {columns}", cells.len());
        let fault = Diagnostic::fault(whole(cells), message).label(format!("expected {columns} numbers"));
        told.say(fault.hint("was the file cut off, or a number taken out?"));
    }
    cells.len() >= columns && behind
}

/// Adds the positions of a row; what is no number is told.
pub(super) fn row(cells: &[Cell<'_>], zeros: Zeros, positions: &mut Vec<Option<DVec3>>, told: &mut Told) {
    for three in cells.chunks_exact(3) {
        let empty = three.iter().filter(|cell| is_missing(cell)).count();
        if empty == 3 {
            positions.push(None);
            continue;
        }
        if empty > 0 {
            let fault = Diagnostic::fault(whole(three), "this position has not three numbers");
            told.say(fault.label("expected three, or none where the marker was not seen"));
        }
        let [x, y, z] = [0, 1, 2].map(|i| number(&three[i], told));
        let place = DVec3::new(x, y, z);
        positions.push(Some(place).filter(|p| zeros == Zeros::Seen || *p != DVec3::ZERO));
    }
}

/// How programs write that a marker was not seen.
fn is_missing(cell: &Cell<'_>) -> bool {
    cell.text.is_empty() || cell.text.eq_ignore_ascii_case("nan")
}

/// The number of a cell, or 0 where it is none, which is told (of a missing one, elsewhere).
fn number(cell: &Cell<'_>, told: &mut Told) -> f64 {
    match cell.text.parse::<f64>() {
        Ok(value) if value.is_finite() => value,
        _ if is_missing(cell) => 0.0,
        _ => {
            let fault = Diagnostic::fault(cell.span, format!("`{}` is no number here", short(&cell.text)));
            told.say(fault.label("expected a finite number, or nothing where the marker was not seen"));
            0.0
        }
    }
}
