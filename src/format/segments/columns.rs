//! Which column is which: from the header, or from the first row where ELAN wrote none.

use super::time::{Unit, time};
use crate::diagnostics::Diagnostic;
use crate::diagnostics::xml::short;
use crate::format::cells::Cell;
use crate::format::told::Told;

/// A column of times.
#[derive(Debug, Clone, Copy)]
pub(super) struct Times {
    pub at: usize,
    pub unit: Unit,
}

/// Where an annotation's end comes from.
#[derive(Debug, Clone, Copy)]
pub(super) enum End {
    At(Times),
    After(Times),
}

/// What the values of a row are.
#[derive(Debug, Clone)]
pub(super) enum Values {
    /// One value: the columns of its tier and its text.
    One { tier: Option<usize>, label: usize },
    /// One for each of these columns that is not empty; the header names the tier.
    Each(Vec<(usize, String)>),
}

/// The columns of a table.
#[derive(Debug, Clone)]
pub(super) struct Columns {
    pub start: Times,
    pub end: End,
    pub values: Values,
    pub source: Option<usize>,
    pub recording: Option<usize>,
    /// The tier of values where no column says it.
    pub only_tier: String,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum What {
    Tier,
    Start,
    End,
    Duration,
    Label,
    Source,
    Recording,
    /// Of no use here, but no tier either.
    Other,
}

const NAMES: [(What, &[&str]); 8] = [
    (What::Tier, &["tier", "tiername", "layer"]),
    (What::Start, &["start", "begin", "onset", "from", "starttime", "begintime", "tmin", "xmin"]),
    (What::End, &["end", "offset", "to", "stop", "endtime", "stoptime", "tmax", "xmax"]),
    (What::Duration, &["duration", "dur", "length"]),
    (What::Label, &["label", "value", "annotation", "annotationvalue", "text"]),
    (What::Source, &["source"]),
    (What::Recording, &["file", "filename", "recording", "take"]),
    (What::Other, &["filepath", "participant", "annotator", "id"]),
];

/// What a heading says: `Begin Time - ss.msec` is a start in seconds, `start_ms` one in milliseconds.
fn heading(text: &str) -> (Option<What>, Unit) {
    let lower = text.to_lowercase();
    let (name, unit) = match lower.split_once(" - ").or_else(|| lower.split_once(['(', '['])) {
        Some((name, unit)) => (name.trim(), unit.trim_end_matches([')', ']']).trim()),
        None => match lower.rsplit_once(['_', ' ']) {
            Some((name, unit @ ("ms" | "msec" | "s" | "sec" | "seconds" | "milliseconds"))) => (name, unit),
            _ => (lower.as_str(), ""),
        },
    };
    let letters: String = name.chars().filter(|c| !matches!(c, ' ' | '_' | '-' | '.')).collect();
    let what = NAMES.iter().find(|(_, names)| names.contains(&letters.as_str())).map(|(what, _)| *what);
    match unit {
        "ms" | "msec" | "milliseconds" => (what, Unit::Milliseconds),
        // Frame counts: ELAN writes them beside other units, never alone.
        _ if unit.contains("pal") || unit.contains("ntsc") || unit.contains(":ff") => {
            (Some(What::Other), Unit::Seconds)
        }
        _ => (what, Unit::Seconds),
    }
}

/// Whether this row is a header; ELAN's export without one begins with annotations.
pub(super) fn is_header(cells: &[Cell<'_>]) -> bool {
    cells.iter().filter(|cell| is_time(cell)).count() < 2
}

fn is_time(cell: &Cell<'_>) -> bool {
    time(&cell.text, Unit::Seconds).is_some()
}

/// The columns that a header names; faults are told.
pub(super) fn named(cells: &[Cell<'_>], told: &mut Told) -> Option<Columns> {
    let heads: Vec<(Option<What>, Unit)> = cells.iter().map(|cell| heading(&cell.text)).collect();
    let first = |what| heads.iter().position(|head| head.0 == Some(what));
    let times = |what| first(what).map(|at| Times { at, unit: heads[at].1 });
    let missing = |what: &str, hint: &str| {
        let span = cells.first().zip(cells.last()).map(|(a, b)| a.span.to(b.span)).unwrap_or_default();
        let fault = Diagnostic::fault(span, format!("no column is {what}")).label("the header");
        let names: Vec<String> = cells.iter().take(8).map(|cell| format!("`{}`", short(&cell.text))).collect();
        fault.hint(format!("the columns are {}", names.join(", "))).hint(hint)
    };
    let start = times(What::Start);
    let end = times(What::End).map(End::At).or(times(What::Duration).map(End::After));
    if start.is_none() {
        let hint = "name one start, begin or onset (seconds), or start_ms; are the columns separated by tabs?";
        told.say(missing("the start", hint));
    }
    if end.is_none() {
        told.say(missing("the end", "name one end or offset (seconds) or end_ms, or one duration"));
    }
    let others = || {
        let free = |at: &usize| heads[*at].0.is_none() && !cells[*at].text.is_empty();
        (0..cells.len()).filter(free).map(|at| (at, cells[at].text.to_string())).collect::<Vec<_>>()
    };
    let values = match (first(What::Tier), first(What::Label)) {
        (tier, Some(label)) => Values::One { tier, label },
        (None, None) if !others().is_empty() => Values::Each(others()),
        _ => {
            told.say(missing("the label", "name one label, value or annotation"));
            return None;
        }
    };
    let only_tier = first(What::Label).map_or(String::new(), |at| cells[at].text.to_string());
    Some(Columns {
        start: start?,
        end: end?,
        values,
        source: first(What::Source),
        recording: first(What::Recording),
        only_tier,
    })
}

/// The columns of ELAN's export without a header: tier, participant (or none), times of begin, end and duration, each in
/// one or several units, then the text.
pub(super) fn unnamed(cells: &[Cell<'_>], told: &mut Told) -> Option<Columns> {
    let first = cells.iter().position(is_time).unwrap_or(0);
    let count = cells[first..].iter().take_while(|cell| is_time(cell)).count();
    let form = |at: usize| match &cells[first + at].text {
        text if text.contains(':') => 0,
        text if text.contains('.') => 1,
        _ => 2,
    };
    // The units repeat: `0:00:01.040 1.04 1040` is one time.
    let repeats = |units: &usize| count % units == 0 && (*units..count).all(|at| form(at) == form(at - units));
    let units = (1..=count / 2).find(repeats).unwrap_or(count);
    let label = first + count;
    if !(1..=2).contains(&first) || count < 2 * units || label >= cells.len() {
        let span = cells.first().zip(cells.last()).map(|(a, b)| a.span.to(b.span)).unwrap_or_default();
        let fault = Diagnostic::fault(span, "there is no header").label("expected names of columns");
        told.say(fault.hint("the first line names the columns: tier, start, end, label"));
        return None;
    }
    // Whole numbers are milliseconds: ELAN writes seconds with a point.
    let times =
        |at: usize| Times { at: first + at, unit: if form(at) == 2 { Unit::Milliseconds } else { Unit::Seconds } };
    let values = Values::One { tier: Some(0), label };
    let (start, end) = (times(0), End::At(times(units)));
    Some(Columns { start, end, values, source: None, recording: None, only_tier: String::new() })
}
