//! A [`Sign`] as HamNoSys and SiGML write it.
//!
//! What they have no symbols for (distances in centimetres, points of space, ways backwards) is an error in plain words, all of
//! them at once; what they write only nearly (lengths, durations) is a warning.

mod action;
pub(super) mod location;
mod nonmanual;
pub(super) mod orientation;
mod phase;
pub(crate) mod shape;

use super::dictionary::Dictionary;
use super::syntax;
use crate::phonology::{Hands, Sign};

/// A sign as it is written.
#[derive(Debug, Clone, PartialEq)]
pub struct Raised {
    /// The tree.
    pub sign: syntax::Sign,
    /// What it says only nearly.
    pub warnings: Vec<String>,
}

/// The tree of a sign.
///
/// # Errors
/// What HamNoSys cannot say of this sign, each once.
///
/// ```
/// use chereme::notation::hamnosys::{Dictionary, raise};
/// use chereme::phonology::{Configuration, Keys, Sign};
/// let mut sign = Sign::named("FLAT");
/// sign.strong.configuration = Keys::one(Configuration::named("flat"));
/// assert_eq!(raise(&sign, Dictionary::builtin()).unwrap().sign.phases.len(), 1);
/// ```
pub fn raise(sign: &Sign, dictionary: &Dictionary) -> Result<Raised, Vec<String>> {
    let (mut errors, mut warnings) = (Vec::new(), Vec::new());
    let silent = sign.intervals == 0
        && sign.then.is_empty()
        && sign.strong.is_empty()
        && sign.weak.is_empty()
        && sign.contact.is_empty()
        && sign.hands == Hands::Strong;
    let language = (!sign.language.is_empty()).then_some(sign.language.as_str());
    let phases = match silent {
        true => Vec::new(),
        false => sign.phases().map(|p| phase::phase(p, language, dictionary, &mut errors, &mut warnings)).collect(),
    };
    let nonmanual = nonmanual::tiers(&sign.nonmanual, dictionary, &mut errors, &mut warnings);
    if !errors.is_empty() {
        return Err(errors);
    }
    let timing = syntax::Timing {
        speed: (sign.speed != 1.0).then_some(sign.speed),
        duration: sign.duration.map(|d| d.0),
        timescale: None,
    };
    let gloss = (!sign.name.is_empty()).then(|| sign.name.clone());
    let sign = syntax::Sign { gloss, timing, nonmanual, phases, span: Default::default() };
    Ok(Raised { sign, warnings })
}

/// Says something once.
fn note(list: &mut Vec<String>, message: &str) {
    if !list.iter().any(|told| told == message) {
        list.push(message.to_owned());
    }
}
