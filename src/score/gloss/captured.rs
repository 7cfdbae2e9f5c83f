//! Signs of a line that are captured motion: a take by its name, or a gloss of which a corpus has motion.

use super::Handedness;
use super::line::Line;
use crate::notation::gloss::syntax::{Head, Signed};
use crate::notation::lower::operators;
use crate::notation::syntax::Operator;
use crate::phonology::Hand;
use crate::score::plan::{Captured, CapturedSign};

/// The captured sign that is meant; nothing where a description is meant, nothing within where what is said of it has a fault.
pub(super) fn of(line: &mut Line, written: &Signed) -> Option<Option<Captured>> {
    let what = match &written.head.value {
        Head::Taken(taken) => CapturedSign::Take(taken.clone()),
        Head::Gloss(name) if is_captured(line, written, name) => CapturedSign::Gloss(name.clone()),
        Head::Gloss(_) | Head::Pointing(_) | Head::Wrist(_) | Head::Spelled(_) => return None,
    };
    Some(changed(line, written, what))
}

fn is_captured(line: &Line, written: &Signed, name: &str) -> bool {
    let captured = &line.lookup.settings.captured;
    let described = || !matches!(line.lookup.sign(name, written.head.span), Ok(None));
    // What motion has no description for is said of the description, where there is one.
    let needs_description = written.operators.value.iter().any(|operator| {
        matches!(
            operator,
            Operator::Orientation(..) | Operator::Placement(..) | Operator::Movement(..) | Operator::NonManual(..)
        )
    });
    captured.has(name) && ((captured.preferred && !needs_description) || !described())
}

fn changed(line: &mut Line, written: &Signed, what: CapturedSign) -> Option<Captured> {
    let said = &written.operators.value;
    let all = operators(said, line.known.vocabulary, line.lookup.language, line.diagnostics);
    if all.len() < said.len() {
        return None;
    }
    let place = match &written.site {
        None => None,
        Some(site) => Some(line.place(site)?),
    };
    let weak = written.hand == Hand::Weak;
    let left_handed = line.lookup.settings.handedness == Handedness::Left;
    Some(Captured { what, operators: all, times: written.performances.value, swapped: weak != left_handed, place })
}
