//! A sign of a line made: looked up, pointed or spelled, then what is said of it.

use super::Missing;
use super::line::Line;
use crate::diagnostics::Diagnostic;
use crate::notation::gloss::syntax::{Head, Signed};
use crate::phonology::Sign;

/// The sign as it is signed; faults and warnings are told to the line.
pub(super) fn sign(line: &mut Line, written: &Signed) -> Option<Sign> {
    match &written.head.value {
        Head::Gloss(name) => gloss(line, name, written),
        _ => None,
    }
}

fn gloss(line: &mut Line, name: &str, written: &Signed) -> Option<Sign> {
    let span = written.head.span;
    match line.lookup.sign(name, span) {
        Ok(Some(entry)) => return Some(entry.sign.clone()),
        Ok(None) => {}
        Err(fault) => {
            line.diagnostics.push(fault);
            return None;
        }
    }
    match line.lookup.settings.missing {
        Missing::Refuse => line.diagnostics.push(line.lookup.unknown(name, span)),
        Missing::Skip => {
            line.diagnostics.push(Diagnostic::warning(span, format!("there is no sign `{name}`")).label("left out"))
        }
        Missing::Fingerspell => {}
    }
    None
}

/// Two signs at the same time.
pub(super) fn together(line: &mut Line, strong: &Signed, weak: &Signed) -> Option<Sign> {
    let (strong, weak) = (sign(line, strong), sign(line, weak));
    strong.and(weak)
}
