//! Labels of hand configurations: `round-B`, `5–S`, `U, thumb out, index hooked`.

use super::{Features, Reading, Vocabulary};
use crate::phonology::distance::HandPoints;
use crate::phonology::grammar::fold;
use crate::phonology::{Bend, Configuration, Digit, Digits, HandshapeChange, ThumbPosition};

/// The longest name that is looked up, bytes: looking for near names takes time with the length.
const LONGEST: usize = 120;

/// What synthesis writes for changes whose details it leaves out (`synthesis::tiers`): known words without features.
const SHORT: [&str; 9] = [
    "thumb",
    "crossed",
    "thumb between",
    "other fingers",
    "some fingers left",
    "tight",
    "slack",
    "fingers touching",
    "thumb touching",
];

impl Vocabulary {
    /// Reads a configuration: a handshape, or two with a dash between, then changes after commas.
    pub(super) fn configuration(&self, text: &str, reading: &mut Reading) -> Features {
        let mut parts = text.split(',').map(str::trim).filter(|part| !part.is_empty());
        let Some(base) = parts.next() else { return Features::Nothing };
        let changes: Vec<HandshapeChange> = parts.filter_map(|part| change(part, reading)).collect();
        let find = |name: &str| self.handshapes.find(name.trim(), self.language()).ok().map(|shape| shape.id.clone());
        let id = |name: &str| Some(name).filter(|n| n.len() <= LONGEST).and_then(find);
        let configuration = match (id(base), base.split_once('–').map(|(a, b)| (id(a), id(b)))) {
            (Some(one), _) => Configuration { changes, ..Configuration::named(one) },
            (None, Some((Some(a), Some(b)))) => Configuration { changes, ..Configuration::halfway(a, b) },
            _ => {
                reading.terms.push(format!("base {}", fold(base)));
                reading.unknown.push(base.to_owned());
                return Features::Nothing;
            }
        };
        let second = configuration.between.as_ref().map(|b| format!("–{}", b.second)).unwrap_or_default();
        reading.known(format!("base {}", fold(&format!("{}{second}", configuration.base))));
        // The names are ids, which stand for themselves in no language.
        match self.handshapes.angles(&configuration, None) {
            Ok(angles) => Features::Hand(Box::new(HandPoints::of(&angles))),
            Err(_) => Features::Nothing,
        }
    }
}

impl Vocabulary {
    /// Why a configuration's handshape is none, as a sentence.
    pub(super) fn doubt(&self, text: &str) -> Option<String> {
        let base = text.split(',').next().unwrap_or_default().trim();
        let short = Some(base).filter(|b| b.len() <= LONGEST && !b.contains('–'));
        short.and_then(|name| self.handshapes.find(name, self.language()).err()).map(|fault| fault.to_string())
    }
}

/// A change, where its words tell it whole: `thumb out`, `bent`, `index middle hooked`, `spread`.
fn change(part: &str, reading: &mut Reading) -> Option<HandshapeChange> {
    let folded = fold(part);
    let words: Vec<&str> = folded.split_whitespace().collect();
    let found = match words[..] {
        ["spread"] => Some(HandshapeChange::Spread(true)),
        ["together"] => Some(HandshapeChange::Spread(false)),
        ["thumb", at] => ThumbPosition::ALL.into_iter().find(|p| p.name() == at).map(HandshapeChange::Thumb),
        [ref digits @ .., bend] => bent(digits, bend),
        [] => None,
    };
    if found.is_some() || SHORT.contains(&folded.as_str()) || folded == "joints bent" {
        reading.known(format!("change {}", words.join(" ")));
    } else {
        reading.terms.push(format!("change {}", words.join(" ")));
        reading.unknown.push(part.to_owned());
    }
    found
}

fn bent(digits: &[&str], bend: &str) -> Option<HandshapeChange> {
    let bend = Bend::ALL.into_iter().find(|b| b.name() == bend)?;
    let named = |word: &&str| Digit::ALL.into_iter().find(|d| d.name() == *word);
    let digits: Option<Vec<Digit>> = digits.iter().map(named).collect();
    Some(HandshapeChange::Bend(Digits::of(digits?), bend))
}
