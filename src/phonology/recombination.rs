//! Signs made from other signs: what `sign FONCÉ = CLAIR inverted` means.
//!
//! A base (a known sign, a spelled word, a pointing, signs joined) and the operators applied to it, in order. Names are looked up by
//! whoever evaluates it: a lexicon, a gloss line.

use super::operator::{Applied, Operator, Spelling, Tables, apply, chain, on_each_hand, pointing, spelled, wrist_at};
use super::placement::Place;
use super::sign::Sign;
use crate::diagnostics::Error;
use glam::DVec3;

/// The parts of a hand's motion that recombination exchanges one by one (Naert et al. 2021, figure 1).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum ManualChannel {
    /// The fingers.
    Configuration,
    /// How the hand is turned.
    Orientation,
    /// Where the arm brings the hand: placement, and over time movement.
    Placement,
}

impl ManualChannel {
    /// All three.
    pub const ALL: [ManualChannel; 3] =
        [ManualChannel::Configuration, ManualChannel::Orientation, ManualChannel::Placement];

    /// The name in text.
    pub fn name(self) -> &'static str {
        match self {
            ManualChannel::Configuration => "configuration",
            ManualChannel::Orientation => "orientation",
            ManualChannel::Placement => "placement",
        }
    }
}

/// A captured sign: a take of a corpus by its name, with channels of other takes in it.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Taken {
    /// The take.
    pub take: String,
    /// Which channels come from which other takes, each at most once.
    pub channels: Vec<(ManualChannel, String)>,
}

/// A sign made from others.
#[derive(Debug, Clone, PartialEq)]
pub struct Recombination {
    /// What it is made from.
    pub base: Base,
    /// What is done with that, one after the other.
    pub operators: Vec<Operator>,
}

/// What a recombination begins with.
#[derive(Debug, Clone, PartialEq)]
pub enum Base {
    /// A sign by its name.
    Named(String),
    /// A word of letters, run together: `spelled "OK"`.
    Spelled(String),
    /// A hand that points at a place.
    Pointing(Place),
    /// The wrist at a point, model space, metres.
    WristAt(DVec3),
    /// One after the other: a compound.
    Chain(Vec<Recombination>),
    /// The first on the strong hand, the second on the weak one.
    Hands(Box<Recombination>, Box<Recombination>),
}

/// What a recombination asks for by name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Wanted<'n> {
    /// A sign.
    Sign(&'n str),
    /// A letter of the manual alphabet.
    Letter(&'n str),
}

/// The sign that a recombination makes. `find` gives signs and letters by name.
///
/// The meaning of the base goes on where an operator only moves, resizes or exchanges hands; a sign with other values means something
/// else, and says nothing of it unless the base knows it as attested.
///
/// # Errors
/// What `find` does not find, and what an operator refuses.
///
/// ```
/// use chereme::phonology::movement_table::MovementTable;
/// use chereme::phonology::operator::{Operator, Tables};
/// use chereme::phonology::recombination::{Base, Recombination, Wanted, made};
/// use chereme::phonology::{LocationInventory, Sign};
/// let (locations, movements) = (LocationInventory::builtin(), MovementTable::embedded());
/// let tables = Tables { locations: &locations, movements: &movements };
/// let ok = Recombination { base: Base::Spelled("OK".into()), operators: vec![Operator::Speed(2.0)] };
/// let sign = made(&ok, &mut |wanted| match wanted {
///     Wanted::Letter(letter) | Wanted::Sign(letter) => Ok(Sign::named(letter)),
/// }, &tables).unwrap().sign;
/// assert_eq!((sign.intervals, sign.speed), (1, 2.0));
/// ```
pub fn made(
    of: &Recombination,
    find: &mut dyn FnMut(Wanted) -> Result<Sign, Error>,
    tables: &Tables,
) -> Result<Applied, Error> {
    let mut warnings = Vec::new();
    let mut part = |of: &Recombination| {
        let mut part = made(of, find, tables)?;
        warnings.append(&mut part.warnings);
        Ok::<Sign, Error>(part.sign)
    };
    let mut sign = match &of.base {
        Base::Chain(parts) => {
            let parts = parts.iter().map(&mut part).collect::<Result<Vec<Sign>, Error>>()?;
            let names: Vec<&str> = parts.iter().map(|p| p.name.as_str()).collect();
            chain(&parts, names.join("-"))?
        }
        Base::Hands(strong, weak) => {
            let (strong, weak) = (part(strong)?, part(weak)?);
            on_each_hand(&strong, &weak)?
        }
        Base::Named(name) => find(Wanted::Sign(name))?,
        Base::Spelled(word) => {
            let letters = letters(word).map(|letter| find(Wanted::Letter(&letter))).collect::<Result<Vec<_>, _>>()?;
            Sign { meaning: Vec::new(), ..spelled(&letters, Spelling::Derived)? }
        }
        Base::Pointing(at) => pointing(None, at.clone()),
        Base::WristAt(point) => wrist_at(*point),
    };
    for operator in &of.operators {
        let mut applied = apply(operator, &sign, tables)?;
        warnings.append(&mut applied.warnings);
        if changes_meaning(operator) && applied.sign.meaning == sign.meaning {
            applied.sign.meaning.clear();
        }
        sign = applied.sign;
    }
    Ok(Applied { sign, warnings })
}

/// The letters of a word, as alphabets name them; white space and hyphens are none.
pub fn letters(word: &str) -> impl Iterator<Item = String> + '_ {
    word.chars().filter(|c| !c.is_whitespace() && *c != '-').map(|c| c.to_uppercase().collect())
}

fn changes_meaning(operator: &Operator) -> bool {
    match operator {
        Operator::Inverted
        | Operator::InvertedMovement
        | Operator::Configuration(..)
        | Operator::Orientation(..)
        | Operator::Placement(..)
        | Operator::Movement(..) => true,
        Operator::Repeated { times, .. } => *times > 1,
        Operator::Mirrored
        | Operator::Swapped
        | Operator::Reflected
        | Operator::NonManual(..)
        | Operator::At(_)
        | Operator::Speed(_)
        | Operator::Size(_) => false,
    }
}
