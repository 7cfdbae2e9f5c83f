//! From the bytes of a BVH file to what it says, or to all that is wrong with it.

use super::data::Bvh;
use super::hierarchy::hierarchy;
use super::motion::motion;
use super::words::Words;
use crate::diagnostics::{Diagnostic, Severity, Source, Span};
use std::borrow::Cow;

/// A file that could be read.
#[derive(Debug, Clone, PartialEq)]
pub struct Reading {
    /// What it says.
    pub bvh: Bvh,
    /// What is odd about it, by place: a row count that differs, joints without channels, names used twice.
    pub warnings: Vec<Diagnostic>,
}

/// Reads a BVH file: any order and number of channels on any joint, several roots, no or several End Sites, any kind
/// of line end, keywords in any case, names with spaces, a byte order mark. Spans are into [`source_of_bytes`]' text.
///
/// # Errors
/// All faults with their places (of faulty rows, the first twenty): see the [module](super)'s "What is refused".
///
/// ```
/// use chereme::format::bvh;
/// let text = "HIERARCHY\nROOT Hips {\n OFFSET 0 0 0\n CHANNELS 1 Yrotation\n}\nMOTION\nFrames: 2\nFrame Time: 0.02\n10\n20\n";
/// let reading = bvh::read(text.as_bytes()).unwrap();
/// assert_eq!(reading.bvh.rows().map(|row| row[0]).sum::<f64>(), 30.0);
/// assert_eq!(reading.warnings, []);
/// let faults = bvh::read(b"HIERARCHY\nJOINT Hips").unwrap_err();
/// assert_eq!(faults[0].message, "a JOINT without a parent");
/// ```
pub fn read(bytes: &[u8]) -> Result<Reading, Vec<Diagnostic>> {
    let (text, mut notes) = decode(bytes);
    let mut words = Words::new(&text);
    let hierarchy = hierarchy(&mut words);
    notes.extend(hierarchy.notes);
    if has_fault(&notes) {
        return Err(sorted(notes));
    }
    let joints = hierarchy.joints;
    let motion = motion(&mut words, joints.iter().map(|j| j.channels.len()).sum());
    notes.extend(motion.notes);
    if has_fault(&notes) {
        return Err(sorted(notes));
    }
    Ok(Reading { bvh: Bvh::checked(joints, motion.frame_time, motion.values), warnings: sorted(notes) })
}

/// The text that a reading's spans point into: what is not UTF-8 is replaced.
///
/// ```
/// use chereme::{diagnostics::render::render, format::bvh};
/// let bytes = b"HIERARCHY\nROOT";
/// let source = bvh::source_of_bytes("walk.bvh", bytes);
/// let fault = &bvh::read(bytes).unwrap_err()[0];
/// assert!(render(fault, &source, false).contains("walk.bvh:2:1"));
/// ```
pub fn source_of_bytes(name: &str, bytes: &[u8]) -> Source {
    Source::new(name, decode(bytes).0)
}

fn decode(bytes: &[u8]) -> (Cow<'_, str>, Vec<Diagnostic>) {
    let error = match std::str::from_utf8(bytes) {
        Ok(text) => return (text.into(), vec![]),
        Err(error) => error,
    };
    let at = Span::new(error.valid_up_to(), error.valid_up_to() + 3);
    let warning = Diagnostic::warning(at, "a byte is not UTF-8").label("read as \u{fffd}");
    let hint = if bytes.starts_with(&[0xff, 0xfe]) || bytes.starts_with(&[0xfe, 0xff]) {
        "this file is UTF-16; save it as UTF-8"
    } else {
        "joint names may be in another encoding; save the file as UTF-8"
    };
    (String::from_utf8_lossy(bytes), vec![warning.hint(hint)])
}

fn has_fault(notes: &[Diagnostic]) -> bool {
    notes.iter().any(|n| n.severity == Severity::Fault)
}

fn sorted(mut notes: Vec<Diagnostic>) -> Vec<Diagnostic> {
    notes.sort_by_key(|n| n.span.start);
    notes
}
