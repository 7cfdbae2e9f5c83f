//! Phases: `sign_manual`.

use super::element::Element;
use super::{action, place, posture, unsayable};
use crate::diagnostics::Error;
use crate::notation::hamnosys::syntax::{Action, Hands, Phase};

/// The phases of a sign: one, or several within one; a sign that the hands do not make has none.
pub(super) fn phases(phases: &[Phase]) -> Result<Option<Element>, Error> {
    let mut all = phases.iter().map(phase).collect::<Result<Vec<_>, _>>()?;
    // A phase that says nothing would alone be read as none.
    let alone = all.len() == 1 && !(all[0].attributes.is_empty() && all[0].children.is_empty());
    Ok(match (alone, all.is_empty()) {
        (true, _) => all.pop(),
        (false, true) => None,
        (false, false) => Some(Element::of("sign_manual", all)),
    })
}

fn phase(phase: &Phase) -> Result<Element, Error> {
    let mut element = Element::new("sign_manual");
    match phase.hands {
        Hands::Strong => {}
        Hands::Weak => element.mark("nondominant", true),
        Hands::Both(symmetry) => {
            element.mark("both_hands", true);
            element.mark("lr_symm", symmetry.left_right);
            element.mark("ud_symm", symmetry.up_down);
            element.mark("oi_symm", symmetry.out_in);
            element.mark("outofphase", symmetry.alternating);
            element.mark("realspace", symmetry.non_ipsi);
        }
    }
    element.mark("holdover", phase.holds_over);
    for action in &phase.body {
        element.children.push(body(action)?);
    }
    element.children.extend(posture::posture(&phase.posture)?);
    element.children.extend(phase.location.as_ref().map(place::location).transpose()?);
    for action in &phase.actions {
        element.children.push(action::action(action, 0)?);
    }
    Ok(element)
}

/// `nonmanualconfig`.
fn body(action: &Action) -> Result<Element, Error> {
    match action {
        Action::OfBody(part, inner) => action::of_body("nonmanualconfig", part, inner, 0),
        Action::Move(_) | Action::Target(..) | Action::Together(_) | Action::Sequence(_) | Action::Fused(_) => {
            unsayable(BODY)
        }
        Action::Alternating(inner, times) if matches!(**inner, Action::OfBody(..)) => {
            let mut element = body(inner)?;
            action::mark_alternating(&mut element, *times);
            Ok(element)
        }
        Action::Split(..) | Action::Repeated(..) | Action::Alternating(..) => unsayable(BODY),
    }
}

const BODY: &str = "before the posture of the hands, SiGML has actions of parts of the body only";
