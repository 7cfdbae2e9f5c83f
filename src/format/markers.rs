//! Positions of markers or of points of a hand, frame by frame: Qualisys' TSV, and tables of numbers alone.
//!
//! # Conventions
//! - Positions stay in the file's unit and axes: Qualisys' are millimetres with Z up as a rule, and the file does not say.
//! - A marker that was not seen is `None`: three empty cells or three `nan`. In Qualisys' files three zeros mean the same, as
//!   QTM writes it; in a table of numbers alone they are a position, because there the wrist often is the origin.
//! - A table of numbers alone has three columns a point and no header; it does not say its frame rate, so
//!   [`Markers::rate`] is `None` and the caller has to know. 63 columns are named as the 21 points of a hand
//!   ([`HAND_POINTS`]), others by their number.
//!
//! Source: Qualisys Track Manager, user manual, "TSV file format (motion data)".
//!
//! # What is refused
//! Rows of another length than there are markers, cells that are no finite numbers, counts of markers that do not fit.
//! Memory is in proportion to the text.

mod rows;

use crate::diagnostics::{Diagnostic, Span};
use crate::format::cells::{Cell, Rows, separator};
use crate::format::text;
use crate::format::told::Told;
use crate::time::Fps;
use glam::DVec3;

/// The 21 points of a hand in the order that hand trackers have agreed on: the wrist, then from thumb to little finger
/// from the knuckle to the tip (MediaPipe Hands, Zhang et al. 2020).
pub const HAND_POINTS: [&str; 21] = [
    "wrist",
    "thumb 1",
    "thumb 2",
    "thumb 3",
    "thumb tip",
    "index 1",
    "index 2",
    "index 3",
    "index tip",
    "middle 1",
    "middle 2",
    "middle 3",
    "middle tip",
    "ring 1",
    "ring 2",
    "ring 3",
    "ring tip",
    "pinky 1",
    "pinky 2",
    "pinky 3",
    "pinky tip",
];

/// Markers and where they were in each frame, in the file's unit and axes.
#[derive(Debug, Clone, PartialEq)]
pub struct Markers {
    names: Vec<String>,
    rate: Option<Fps>,
    positions: Vec<Option<DVec3>>,
}

impl Markers {
    /// The markers' names, in the file's order.
    pub fn names(&self) -> &[String] {
        &self.names
    }

    /// Frames a second, where the file says it.
    pub fn rate(&self) -> Option<Fps> {
        self.rate
    }

    /// The frames, each with one position a marker; `None` where it was not seen.
    pub fn frames(&self) -> std::slice::ChunksExact<'_, Option<DVec3>> {
        self.positions.chunks_exact(self.names.len().max(1))
    }

    /// The place of a marker among [`names`](Markers::names), in any case.
    ///
    /// ```
    /// let reading = chereme::format::markers::read(b"1,2,3,,,\n4,5,6,7,8,9\n").unwrap();
    /// assert_eq!(reading.markers.find("POINT 2"), Some(1));
    /// assert_eq!(reading.markers.frames().next().unwrap()[1], None);
    /// ```
    pub fn find(&self, name: &str) -> Option<usize> {
        self.names.iter().position(|own| own.eq_ignore_ascii_case(name))
    }
}

/// A file that could be read.
#[derive(Debug, Clone, PartialEq)]
pub struct Reading {
    /// What it says.
    pub markers: Markers,
    /// What is odd about it, by place: a count of frames that differs from the rows.
    pub warnings: Vec<Diagnostic>,
}

/// Reads Qualisys' TSV (it begins with `NO_OF_FRAMES`) or a table of numbers alone, with commas, semicolons or tabs.
///
/// # Errors
/// All faults, the first hundred of them with their places in the text that
/// [`source_of_bytes`](crate::format::text::source_of_bytes) gives.
///
/// ```
/// use chereme::format::markers;
/// let file = b"NO_OF_FRAMES\t2\nNO_OF_MARKERS\t1\nFREQUENCY\t100\nMARKER_NAMES\thand_top\n1\t2\t3\n0\t0\t0\n";
/// let markers = markers::read(file).unwrap().markers;
/// assert_eq!(markers.rate().unwrap().get(), 100.0);
/// let seen: Vec<bool> = markers.frames().map(|frame| frame[0].is_some()).collect();
/// assert_eq!(seen, [true, false]);
/// let faults = markers::read(b"1,2,3\n4,5\n").unwrap_err();
/// assert_eq!(faults[0].message, "this row has 2 numbers, and the others 3");
/// ```
pub fn read(bytes: &[u8]) -> Result<Reading, Vec<Diagnostic>> {
    let (text, note) = text::decode(bytes);
    let mut told = Told::default();
    note.into_iter().for_each(|note| told.say(note));
    let begins = |word: &str| text.trim_start().get(..word.len()).is_some_and(|b| b.eq_ignore_ascii_case(word));
    let qualisys = begins("NO_OF_FRAMES") || begins("FILE_VERSION");
    let markers = if qualisys { of_qualisys(&text, &mut told) } else { of_numbers(&text, &mut told) };
    let none = Markers { names: Vec::new(), rate: None, positions: Vec::new() };
    told.judge(markers.unwrap_or(none)).map(|(markers, warnings)| Reading { markers, warnings })
}

/// Reads a table of numbers alone, three columns a point.
fn of_numbers(text: &str, told: &mut Told) -> Option<Markers> {
    let mut rows = Rows::new(text, separator(text));
    let mut cells = Vec::new();
    if !rows.next(&mut cells) {
        let fault = Diagnostic::fault(Span::new(0, 0), "this file is empty").label("expected positions");
        told.say(fault.hint("three numbers a point, one frame a line"));
        return None;
    }
    let columns = cells.len();
    if columns % 3 != 0 {
        let message = format!("this row has {columns} numbers, not three a point");
        let fault = Diagnostic::fault(rows::whole(&cells), message).label("expected three numbers a point");
        told.say(fault.hint("is there a column for the time? take it out; or is a separator missing?"));
        return None;
    }
    let names = match columns {
        63 => HAND_POINTS.map(str::to_owned).to_vec(),
        _ => (1..=columns / 3).map(|number| format!("point {number}")).collect(),
    };
    let mut positions = Vec::new();
    rows::row(&cells, rows::Zeros::Seen, &mut positions, told);
    while rows.next(&mut cells) {
        if rows::fits(&cells, columns, told) {
            rows::row(&cells, rows::Zeros::Seen, &mut positions, told);
        }
    }
    Some(Markers { names, rate: None, positions })
}

/// What the lines before the rows say.
#[derive(Default)]
struct Head {
    frames: Option<(u64, Span)>,
    markers: Option<(u64, Span)>,
    rate: Option<Fps>,
    names: Option<Vec<String>>,
    /// How many columns stand before the positions: the frame's number and its time, or none.
    before: usize,
}

fn of_qualisys(text: &str, told: &mut Told) -> Option<Markers> {
    let mut rows = Rows::new(text, b'\t');
    let mut cells = Vec::new();
    let mut head = Head::default();
    let mut more = rows.next(&mut cells);
    // A row may begin with a marker that was not seen, an empty cell.
    let begins = |cells: &[Cell<'_>], head: &Head| match cells[0].text.is_empty() {
        true => head.names.is_some(),
        false => rows::is_number(&cells[0].text),
    };
    while more && !begins(&cells, &head) {
        head.line(&cells, told);
        more = rows.next(&mut cells);
    }
    let Some(names) = head.names.filter(|names| !names.is_empty()) else {
        let fault = Diagnostic::fault(Span::new(0, 0), "the markers have no names").label("expected MARKER_NAMES");
        told.say(fault.hint("export from QTM with a header: it has a line MARKER_NAMES"));
        return None;
    };
    if let Some((count, span)) = head.markers.filter(|(count, _)| *count != names.len() as u64) {
        let message = format!("NO_OF_MARKERS says {count}, and there are {} names", names.len());
        told.say(Diagnostic::fault(span, message).label("these should be the same"));
        return None;
    }
    let mut positions = Vec::new();
    let columns = head.before + 3 * names.len();
    let mut count = 0;
    while more {
        if rows::fits(&cells, columns, told) {
            rows::row(&cells[head.before..columns], rows::Zeros::Missing, &mut positions, told);
        }
        count += 1;
        more = rows.next(&mut cells);
    }
    if let Some((said, span)) = head.frames.filter(|(said, _)| *said != count) {
        let message = format!("NO_OF_FRAMES says {said}, and there are {count} rows");
        told.say(Diagnostic::warning(span, message).label("the rows count"));
    }
    Some(Markers { names, rate: head.rate, positions })
}

impl Head {
    fn line(&mut self, cells: &[Cell<'_>], told: &mut Told) {
        let value = cells.get(1);
        let mut whole = || {
            let cell = value?;
            let count = cell.text.parse::<u64>().ok();
            if count.is_none() {
                told.say(Diagnostic::fault(cell.span, "this is no count").label("expected a whole number, 0 or more"));
            }
            count.map(|count| (count, cell.span))
        };
        match cells[0].text.to_ascii_uppercase().as_str() {
            "NO_OF_FRAMES" => self.frames = whole(),
            "NO_OF_MARKERS" => self.markers = whole(),
            "FREQUENCY" => {
                self.rate = value.and_then(|cell| Fps::new(cell.text.parse().ok()?));
                if let Some(cell) = value.filter(|_| self.rate.is_none()) {
                    let label = format!("expected frames a second, above 0 and at most {}", Fps::MAX);
                    told.say(Diagnostic::fault(cell.span, "this is no frame rate").label(label));
                }
            }
            "MARKER_NAMES" => {
                // Tabs at the end of the line name no marker.
                let named = cells.iter().rposition(|cell| !cell.text.is_empty()).unwrap_or(0);
                self.names = Some(cells[1..].iter().take(named).map(|cell| cell.text.to_string()).collect());
            }
            "FRAME" => self.before = 1 + usize::from(value.is_some_and(|cell| cell.text.eq_ignore_ascii_case("time"))),
            _ => {}
        }
    }
}
