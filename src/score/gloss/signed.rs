//! A sign of a line made: looked up, pointed or spelled, then what is said of it, in this order: operators, how
//! often, on which hand, where.

use super::line::Line;
use super::{Handedness, Missing, spelling};
use crate::diagnostics::{Diagnostic, Error, Span, Spanned};
use crate::notation::gloss::syntax::{Head, Signed, Site};
use crate::notation::lower::operators;
use crate::phonology::operator::{
    Applied, Operator, apply, for_left_hander, on_each_hand, pointing, swapped, wrist_at,
};
use crate::phonology::{Forced, Hand, Keys, Place, Placement, Relocation, Sign};
use glam::DVec3;

/// The sign as the signer signs it; faults and warnings are told to the line.
pub(super) fn sign(line: &mut Line, written: &Signed) -> Option<Sign> {
    let made = changed(line, written)?;
    let span = written.head.span;
    let made = match written.hand {
        Hand::Strong => made,
        Hand::Weak => on_weak_hand(made, written),
    };
    let made = placed(line, made, written.site.as_ref(), span)?;
    Some(by_signer(line, made))
}

/// Two signs at the same time. Only the first may be placed: a sign is moved as a whole.
pub(super) fn together(line: &mut Line, strong: &Signed, weak: &Signed) -> Option<Sign> {
    let (first, second) = (changed(line, strong), changed(line, weak));
    if let Some(site) = &weak.site {
        line.diagnostics.push(
            Diagnostic::fault(site.span, "two signs at the same time are placed as one")
                .label("of the second sign")
                .hint(
                    "place the first: `BOL@left & CHIEN`, or sign one after the other, the first held: `<HOLD weak>`",
                ),
        );
        return None;
    }
    let span = strong.head.span.to(weak.head.span);
    let both = on_each_hand(&first?, &on_weak_hand(second?, weak));
    let both = told(line, span, both)?;
    let both = placed(line, both, strong.site.as_ref(), span)?;
    Some(by_signer(line, both))
}

/// The sign with its operators and performances, with the strong hand, at its own place.
fn changed(line: &mut Line, written: &Signed) -> Option<Sign> {
    let mut made = head(line, &written.head)?;
    let language = made.language.clone();
    let all = operators(&written.operators.value, line.known.vocabulary, &language, line.diagnostics);
    if all.len() < written.operators.value.len() {
        return None;
    }
    for operator in &all {
        made = operated(line, operator, &made, written.operators.span)?;
    }
    let again = Operator::Repeated { times: written.performances.value, gap: None, growth: 0 };
    operated(line, &again, &made, written.head.span)
}

fn head(line: &mut Line, written: &Spanned<Head>) -> Option<Sign> {
    let span = written.span;
    match &written.value {
        Head::Gloss(name) => gloss(line, name, span),
        Head::Pointing(site) => {
            let place = line.place(&Spanned::new(site.clone(), span))?;
            Some(pointing(None, place))
        }
        Head::Wrist(site) => {
            let place = line.place(&Spanned::new(site.clone(), span))?;
            Some(wrist_to(place))
        }
        Head::Spelled(word) => spelling::word(line, word, span),
        Head::Taken(_) => {
            let fault = Diagnostic::fault(span, "a take has no description that another sign can be made with");
            line.diagnostics.push(fault.label("captured").hint("sign one after the other"));
            None
        }
    }
}

/// The wrist brought to a place of any kind.
fn wrist_to(place: Place) -> Sign {
    let mut sign = wrist_at(DVec3::ZERO);
    if let Some(at) = sign.strong.placement.at(0) {
        sign.strong.placement = Keys::one(Placement { place, ..at.clone() });
    }
    sign
}

fn gloss(line: &mut Line, name: &str, span: Span) -> Option<Sign> {
    match line.lookup.sign(name, span) {
        Ok(Some(entry)) => return Some(entry.sign.clone()),
        Ok(None) => {}
        Err(fault) => {
            line.diagnostics.push(fault);
            return None;
        }
    }
    let missing = Diagnostic::warning(span, format!("there is no sign `{name}`"));
    match line.lookup.settings.missing {
        Missing::Refuse => line.diagnostics.push(line.lookup.unknown(name, span)),
        Missing::Skip => line.diagnostics.push(missing.label("left out")),
        Missing::Fingerspell => {
            line.diagnostics.push(missing.label("spelled"));
            return spelling::word(line, name, span);
        }
    }
    None
}

/// The same sign with the weak hand. Pointing keeps its target.
fn on_weak_hand(sign: Sign, written: &Signed) -> Sign {
    match written.head.value {
        Head::Gloss(_) | Head::Spelled(_) | Head::Taken(_) => swapped(&sign),
        Head::Pointing(_) | Head::Wrist(_) => for_left_hander(&sign),
    }
}

fn placed(line: &mut Line, sign: Sign, site: Option<&Spanned<Site>>, span: Span) -> Option<Sign> {
    let Some(site) = site else { return Some(sign) };
    let to = Relocation { place: line.place(site)?, forced: Forced::No };
    operated(line, &Operator::At(to), &sign, span.to(site.span))
}

/// A left-handed signer's hands exchange; places in space stay.
fn by_signer(line: &Line, sign: Sign) -> Sign {
    match line.lookup.settings.handedness {
        Handedness::Right => sign,
        Handedness::Left => for_left_hander(&sign),
    }
}

/// What an operator makes; its warnings are told, its refusal is a fault.
fn operated(line: &mut Line, operator: &Operator, sign: &Sign, span: Span) -> Option<Sign> {
    let Applied { sign, warnings } = told(line, span, apply(operator, sign, &line.known.tables))?;
    line.diagnostics.extend(warnings.into_iter().map(|w| Diagnostic::warning(span, w).label("of this sign")));
    Some(sign)
}

/// A result, or its error as a fault.
pub(super) fn told<T>(line: &mut Line, span: Span, result: Result<T, Error>) -> Option<T> {
    result.map_err(|e| line.diagnostics.push(Diagnostic::fault(span, e.to_string()).label("here"))).ok()
}
