//! Writing SiGML, the same bytes for the same signs.

mod action;
mod element;
mod movement;
mod nonmanual;
mod phase;
mod place;
mod posture;

use super::{MOST_DEEP, words};
use crate::diagnostics::Error;
use crate::notation::hamnosys::print::tokens;
use crate::notation::hamnosys::syntax::{Sign, Timing};
use element::Element;

/// The kinds of SiGML.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Kind {
    /// H-SiGML: the symbols of HamNoSys, an element each.
    HamNoSys,
    /// Gestural SiGML: a tree of postures, places and motions.
    Gestural,
}

/// Writes signs as a SiGML file. What `read` makes of it is the signs again.
///
/// # Errors
/// The first thing that this kind of SiGML has no words for, after the gloss of its sign: gestural SiGML has one attribute
/// for the side and the face of a place, H-SiGML no sequences of mouth pictures.
///
/// ```
/// use chereme::{diagnostics::Source, notation::sigml};
/// let text = r#"<hamgestural_sign gloss="NO"><sign_nonmanual><head_tier><head_movement movement="SH"/></head_tier>
///     </sign_nonmanual></hamgestural_sign>"#;
/// let (signs, _) = sigml::read(&Source::new("no.sigml", text));
/// let written = sigml::write(&signs, sigml::Kind::HamNoSys).unwrap();
/// assert!(written.contains(r#"<hnm_head tag="SH"/>"#));
/// assert_eq!(sigml::read(&Source::new("no.sigml", written)).0, signs);
/// ```
pub fn write(signs: &[Sign], kind: Kind) -> Result<String, Error> {
    let mut root = Element::new("sigml");
    for (i, sign) in signs.iter().enumerate() {
        let element = match kind {
            Kind::HamNoSys => plain(sign),
            Kind::Gestural => gestural(sign),
        };
        root.children.push(element.and_then(Element::checked).map_err(|error| match &sign.gloss {
            Some(gloss) => error.context(gloss),
            None => error.context(format!("sign {}", i + 1)),
        })?);
    }
    root.print()
}

fn gestural(sign: &Sign) -> Result<Element, Error> {
    let mut element = opening("hamgestural_sign", sign)?;
    if !sign.nonmanual.is_empty() {
        element.children.push(nonmanual::tiers(&sign.nonmanual)?);
    }
    element.children.extend(phase::phases(&sign.phases)?);
    Ok(element)
}

fn plain(sign: &Sign) -> Result<Element, Error> {
    let mut element = opening("hns_sign", sign)?;
    element.children.push(nonmanual::plain(&sign.nonmanual)?);
    let mut manual = Element::new("hamnosys_manual");
    if !sign.phases.is_empty() {
        let symbols = tokens(&sign.phases).map_err(|unsaid| Error::new(unsaid.join("; ")))?;
        manual.children = symbols.into_iter().map(|symbol| Element::new(symbol.tag())).collect();
    }
    element.children.push(manual);
    Ok(element)
}

/// The element of a sign with its attributes.
fn opening(name: &'static str, sign: &Sign) -> Result<Element, Error> {
    let mut element = Element::new(name);
    if let Some(gloss) = &sign.gloss {
        element.set("gloss", gloss.as_str());
    }
    let Timing { speed, duration, timescale } = sign.timing;
    element.factor("duration", duration)?;
    element.factor("speed", speed)?;
    element.factor("timescale", timescale)?;
    Ok(element)
}

/// What a kind of SiGML has no words for.
fn unsayable<T>(what: &str) -> Result<T, Error> {
    Err(Error::new(what))
}

/// Refuses actions and cues that stand too deep within each other, before the stack ends.
fn check_depth(depth: usize) -> Result<(), Error> {
    match depth < MOST_DEEP {
        true => Ok(()),
        false => unsayable(&format!("more than {MOST_DEEP} actions stand within each other")),
    }
}
