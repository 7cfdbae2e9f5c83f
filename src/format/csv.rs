//! Kinematic profiles as CSV: one row an instant, one column a curve, for R, pandas and spreadsheets.
//!
//! # Conventions
//! The first row names the columns: `time [s]`, then `POINT FRAME MEASURE [UNIT]` such as `RightHand floor speed [m/s]`, then `phase`
//! where the motion has phases. Commas, a decimal point, no comments. A phase stands in the rows from its start up to its end, so
//! reading gives phases to the nearest row.
//!
//! # Refuses
//! Other separators and decimal commas; columns that are not named so; cells that are no finite numbers; times that do not increase;
//! more than [`MOST_COLUMNS`] columns.

use crate::diagnostics::Error;
use crate::motion::curve::{Curve, Measure, Phase, Profile, Reference};
use crate::time::Seconds;
use ::csv::{ByteRecord, ReaderBuilder, WriterBuilder};

/// The decimals that are written where nothing else is asked for: micrometres.
pub const DECIMALS: usize = 6;
/// The greatest number of columns that is read.
pub const MOST_COLUMNS: usize = 2000;
/// The least decimals of a time, which tell apart the frames of the greatest frame rate.
const TIME_DECIMALS: usize = 3;
const TIME: &str = "time [s]";
const PHASE: &str = "phase";

/// The profile as a table with so many decimals (at most 12).
///
/// ```
/// use chereme::format::csv;
/// use chereme::motion::curve::{Curve, Measure, Profile, Reference};
/// use chereme::time::Seconds;
/// let curve = Curve {
///     point: "RightHand".into(), reference: Reference::Floor, measure: Measure::Height, values: vec![1.0, 1.25],
/// };
/// let profile = Profile::new(vec![Seconds(0.0), Seconds(0.5)], vec![curve]).unwrap();
/// assert_eq!(csv::write(&profile, 3), "time [s],RightHand floor height [m]\n0.000,1.000\n0.500,1.250\n");
/// ```
pub fn write(profile: &Profile, decimals: usize) -> String {
    let decimals = decimals.min(12);
    let phases = phases_of_rows(profile);
    let phased = phases.iter().any(|p| !p.is_empty());
    let mut rows = Vec::with_capacity(profile.times().len() + 1);
    let mut header = vec![TIME.to_owned()];
    header.extend(profile.curves().iter().map(heading));
    header.extend(phased.then(|| PHASE.to_owned()));
    rows.push(header);
    for (i, time) in profile.times().iter().enumerate() {
        let mut row = vec![fixed(time.0, decimals.max(TIME_DECIMALS))];
        row.extend(profile.curves().iter().map(|c| fixed(c.values[i], decimals)));
        row.extend(phased.then(|| phases[i].to_owned()));
        rows.push(row);
    }
    let mut writer = WriterBuilder::new().from_writer(Vec::new());
    // Rows of one length into memory cannot fail.
    let whole = rows.iter().all(|row| writer.write_record(row).is_ok());
    debug_assert!(whole, "a row was not written");
    String::from_utf8(writer.into_inner().unwrap_or_default()).unwrap_or_default()
}

/// The phase that each row stands in: from its start up to its end. The last row, where nothing moves on from, is as the
/// row before it; one row alone is no stretch of time.
fn phases_of_rows(profile: &Profile) -> Vec<&str> {
    const NOISE: f64 = 1e-9;
    let holds = |p: &&Phase, time: &Seconds| p.start.0 <= time.0 + NOISE && time.0 + NOISE < p.end.0;
    let name = |time| profile.phases().iter().find(|p| holds(p, time)).map_or("", |p| p.name.as_str());
    let mut rows: Vec<&str> = profile.times().iter().map(name).collect();
    match &mut rows[..] {
        [.., before, last] => *last = *before,
        short => short.fill(""),
    }
    rows
}

/// A number with so many decimals; what rounds to zero has no sign.
fn fixed(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    match text.strip_prefix('-') {
        Some(size) if size.bytes().all(|b| matches!(b, b'0' | b'.')) => size.to_owned(),
        _ => text,
    }
}

/// The heading of a curve's column.
fn heading(curve: &Curve) -> String {
    format!("{} [{}]", curve.name(), curve.measure.unit())
}

/// A curve without values from the heading of its column.
fn curve(heading: &str) -> Result<Curve, Error> {
    let expected = || {
        Error::new(format!(
            "`{heading}` names no curve; expected such as `RightHand floor speed [m/s]`, or `{PHASE}` in the last column"
        ))
    };
    let (name, unit) = heading.strip_suffix(']').and_then(|h| h.rsplit_once(" [")).ok_or_else(expected)?;
    let (name, measure) = name.rsplit_once(' ').ok_or_else(expected)?;
    let (point, reference) = name.rsplit_once(' ').ok_or_else(expected)?;
    let (reference, measure) = (reference.parse::<Reference>()?, measure.parse::<Measure>()?);
    if unit != measure.unit() {
        return Err(Error::new(format!("{measure} is in {}, not in `{unit}`", measure.unit())));
    }
    Ok(Curve { point: point.to_owned(), reference, measure, values: Vec::new() })
}

/// Reads a table that [`write()`] or another program wrote.
///
/// # Errors
/// What the module refuses, with line and column.
///
/// ```
/// use chereme::format::csv::read;
/// let profile = read(b"time [s],RightHand floor speed [m/s],phase\n0,0.1,stroke\n0.5,1,stroke\n").unwrap();
/// assert_eq!(profile.curves()[0].values, [0.1, 1.0]);
/// assert_eq!(profile.phases()[0].name, "stroke");
/// let error = read(b"time [s],RightHand floor speed [m/s]\n0,fast\n").unwrap_err();
/// assert_eq!(error.to_string(), "line 2, column 2: `fast` is no finite number");
/// ```
pub fn read(bytes: &[u8]) -> Result<Profile, Error> {
    // Spreadsheets begin UTF-8 with a byte order mark.
    let bytes = bytes.strip_prefix(b"\xef\xbb\xbf").unwrap_or(bytes);
    let first = bytes.split(|b| *b == b'\n').next().unwrap_or_default();
    if first.iter().filter(|b| **b == b',').count() >= MOST_COLUMNS {
        return Err(Error::new(format!("line 1: more than {MOST_COLUMNS} columns")));
    }
    let mut reader = ReaderBuilder::new().has_headers(false).from_reader(bytes);
    let mut record = ByteRecord::new();
    let mut next = |record: &mut ByteRecord| reader.read_byte_record(record).map_err(|e| told(&e));
    if !next(&mut record)? {
        return Err(Error::new(format!("line 1: the file is empty; expected a first row that begins with `{TIME}`")));
    }
    let (mut curves, phased) = header(&record)?;
    let (mut times, mut labels) = (Vec::new(), Vec::new());
    while next(&mut record)? {
        let line = record.position().map_or(0, ::csv::Position::line);
        let cell = |column: usize| number(&record[column]).map_err(|e| e.context(place(line, column)));
        let time = cell(0)?;
        if times.last().is_some_and(|before: &Seconds| before.0 >= time) {
            return Err(Error::new(format!("{}: times increase from row to row", place(line, 0))));
        }
        times.push(Seconds(time));
        for (i, curve) in curves.iter_mut().enumerate() {
            curve.values.push(cell(i + 1)?);
        }
        if phased {
            let column = record.len() - 1;
            labels.push(text(&record[column]).map_err(|e| e.context(place(line, column)))?);
        }
    }
    if times.is_empty() {
        return Err(Error::new("line 2: there is no row of numbers"));
    }
    let phases = runs(&times, labels);
    Ok(Profile::new(times, curves)?.with_phases(phases))
}

/// The curves that the first row names, and whether its last column is the phases'.
fn header(record: &ByteRecord) -> Result<(Vec<Curve>, bool), Error> {
    let names: Result<Vec<String>, Error> =
        record.iter().enumerate().map(|(i, cell)| text(cell).map_err(|e| e.context(place(1, i)))).collect();
    let names = names?;
    if names.len() == 1 && names[0].contains([';', '\t']) {
        return Err(Error::new(
            "line 1: the cells are not separated by commas; save the table with commas and decimal points",
        ));
    }
    if names[0] != TIME {
        return Err(Error::new(format!("{}: the first column is `{}`; expected `{TIME}`", place(1, 0), names[0])));
    }
    let phased = names.len() > 1 && names[names.len() - 1] == PHASE;
    let last = names.len() - usize::from(phased);
    let mut curves: Vec<Curve> = Vec::new();
    for (i, name) in names.iter().enumerate().take(last).skip(1) {
        let curve = curve(name).map_err(|e| e.context(place(1, i)))?;
        if curves.iter().any(|c| c.name() == curve.name()) {
            return Err(Error::new(format!("{}: {} is there twice", place(1, i), curve.name())));
        }
        curves.push(curve);
    }
    Ok((curves, phased))
}

/// Stretches of rows with the same label, each up to the first row of the next.
fn runs(times: &[Seconds], labels: Vec<String>) -> Vec<Phase> {
    let mut phases: Vec<Phase> = Vec::new();
    let mut before = String::new();
    for (time, label) in times.iter().zip(labels) {
        if let Some(open) = phases.last_mut().filter(|_| !before.is_empty()) {
            open.end = *time;
        }
        if label != before && !label.is_empty() {
            phases.push(Phase { name: label.clone(), start: *time, end: *time });
        }
        before = label;
    }
    phases
}

fn number(cell: &[u8]) -> Result<f64, Error> {
    let cell = text(cell)?;
    match cell.trim().parse::<f64>() {
        Ok(value) if value.is_finite() => Ok(value),
        _ => Err(Error::new(format!("`{}` is no finite number", cell.chars().take(40).collect::<String>()))),
    }
}

fn text(cell: &[u8]) -> Result<String, Error> {
    let text = std::str::from_utf8(cell).map_err(|_| Error::new("the cell is not UTF-8"))?;
    match text.chars().any(char::is_control) {
        true => Err(Error::new("the cell has a line break or another control character")),
        false => Ok(text.to_owned()),
    }
}

/// Where a cell is, both from 1.
fn place(line: u64, column: usize) -> String {
    format!("line {line}, column {}", column + 1)
}

fn told(error: &::csv::Error) -> Error {
    match error.kind() {
        ::csv::ErrorKind::UnequalLengths { pos, expected_len, len } => {
            let line = pos.as_ref().map_or(0, ::csv::Position::line);
            Error::new(format!("line {line}: {len} cells instead of {expected_len}"))
        }
        _ => Error::new(error.to_string()),
    }
}
