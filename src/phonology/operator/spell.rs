//! Dactylology: words spelled with the letters of a manual alphabet (Naert et al. 2021, §5.2).
//!
//! Signs *derived* from spelled words (OK, LSF, WEEK-END, DODO) run from shape to shape without holds; a word *held* letter by letter
//! is what `fs(…)` writes in glosses. Spelling stays in one place, "the placement component is thus fixed": the first
//! letter's, unless a letter touches the body or the other hand. A letter's own movement (J, Z) is kept.

use super::compound::{Part, joined};
use super::phase::flattened;
use super::{plain, touches};
use crate::diagnostics::Error;
use crate::phonology::{Action, Direction, Extent, Hands, Keys, LocationInventory, Motion, Movement, Place, Sign};
use crate::time::Seconds;

/// How letters follow each other.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Spelling {
    /// From shape to shape without holds.
    Derived,
    /// Every letter held.
    Held,
}

/// How long a letter is held, seconds: with its transition about three letters a second, a clear pace for readers.
const HELD_S: f64 = 0.15;
/// The first and the last letter, seconds: words are known by their ends.
const HELD_AT_ENDS_S: f64 = 0.28;
/// How far a double letter slides to the hand's own side, metres.
const SLIDE_M: f64 = 0.04;

/// A word of the signs of its letters.
///
/// # Errors
/// No letter; more letters than a sign has movements for.
///
/// ```
/// use chereme::phonology::operator::{Spelling, spelled};
/// use chereme::phonology::Sign;
/// let ok = spelled(&[Sign::named("O"), Sign::named("K")], Spelling::Derived).unwrap();
/// assert_eq!((ok.name.as_str(), ok.intervals), ("OK", 1));
/// // Each letter held, and one transition between.
/// assert_eq!(spelled(&[Sign::named("O"), Sign::named("K")], Spelling::Held).unwrap().intervals, 3);
/// ```
pub fn spelled(letters: &[Sign], style: Spelling) -> Result<Sign, Error> {
    let letters = &letters.iter().map(flattened).collect::<Result<Vec<Sign>, Error>>()?;
    let name: String = letters.iter().map(|l| l.name.as_str()).collect();
    let Some(first) = letters.first() else { return Err(Error::new("a word without letters")) };
    let locations = LocationInventory::builtin();
    let mut parts: Vec<(Sign, Movement)> = Vec::new();
    // Whether the hand has left the word's place, so that the next letter goes back to it.
    let mut away = false;
    for (i, letter) in letters.iter().enumerate() {
        let double = i > 0 && letters[i - 1] == *letter && letter.intervals == 0;
        let mut sign = letter.clone();
        let stays = i > 0 && in_space(letter, &locations) && in_space(first, &locations);
        if stays {
            sign.strong.placement = Keys::default();
            sign.weak.placement = Keys::default();
        }
        let before = match (double, away && stays) {
            (true, _) => slide(letter.hands),
            (false, true) => plain(Motion::Return { key: 0 }),
            (false, false) => plain(Motion::Change),
        };
        away = double || letter.intervals > 0;
        if style == Spelling::Held {
            let ends = i == 0 || i + 1 == letters.len();
            hold(&mut sign, if ends { HELD_AT_ENDS_S } else { HELD_S });
        }
        parts.push((sign, before));
    }
    let parts: Vec<Part> = parts.iter().map(|(sign, before)| Part { sign, before: before.clone() }).collect();
    let mut word = joined(&parts, name, super::compound::Unsaid::Stays)?;
    word.language.clone_from(&first.language);
    Ok(word)
}

/// Whether a letter is signed in space, so that the word's place can be its place.
fn in_space(letter: &Sign, locations: &LocationInventory) -> bool {
    let all = || letter.strong.placement.iter().chain(letter.weak.placement.iter());
    let one_hand = matches!(letter.hands, Hands::Strong | Hands::Weak);
    one_hand && all().all(|(_, p)| !touches(p, locations) && !matches!(p.place, Place::OtherHand(_)))
}

/// To the hand's own side.
fn slide(hands: Hands) -> Movement {
    let side = match hands {
        Hands::Weak => Direction::LEFT,
        Hands::Strong | Hands::Both(_) => Direction::RIGHT,
    };
    plain(Motion::Straight { direction: side.into(), extent: Extent::Metres(SLIDE_M), overlay: None })
}

/// The letter with a hold at its end.
fn hold(sign: &mut Sign, seconds: f64) {
    sign.intervals += 1;
    let hold = Movement::Action(Box::new(Action { duration: Some(Seconds(seconds)), ..Action::new(Motion::Hold) }));
    let leads = if sign.hands == Hands::Weak { &mut sign.weak } else { &mut sign.strong };
    leads.movement.push(hold.clone());
    let follows = if sign.hands == Hands::Weak { &mut sign.strong } else { &mut sign.weak };
    if !follows.movement.is_empty() {
        follows.movement.push(hold);
    }
}
