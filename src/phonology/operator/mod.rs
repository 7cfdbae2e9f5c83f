//! Operators on descriptions: new signs from known ones (Naert, Larboulette and Gibet 2021, §4 to §6).
//!
//! A sign is played backwards, mirrored, swapped, repeated, given another hand configuration, moved, made faster or
//! larger; signs are joined. Each operator makes a whole new [`Sign`]; nothing is edited in place. What an operator does to captured
//! motion is another matter (`synthesis`); a described sign is recombined as a description, then synthesized.
//!
//! # Conventions
//! Keys and intervals as in [`Sign`]. Non-manual tiers stay unless an operator names them. Numbers of repetition count
//! performances in all. Refuses what has no meaning (a sign anchored on the body moved away, counts that do not fit) with
//! an [`Error`]; what is doubtful comes back as warnings.
//!
//! Of a sign of several phases each phase is changed; one value of a tier is that of all phases, several stand at the keys of
//! all phases, counted through. Played backwards, the phases come in reverse order too. A compound, a sign on each hand and
//! the path alone backwards make the phases one first.

mod compound;
mod invert;
mod phase;
mod place;
mod point;
mod posture;
mod reflect;
mod repeat;
mod replace;
mod scale;
mod spell;

pub use compound::{chain, on_each_hand};
pub use invert::{inverted, inverted_movement};
pub use place::{anchored, touches};
pub use point::{pointing, wrist_at};
pub use reflect::{for_left_hander, mirrored, reflected, swapped};
pub use repeat::repeated;
pub use scale::{BIG, FAST, SIZES, SLOW, SMALL};
pub use spell::{Spelling, spelled};

use super::configuration::Configuration;
use super::hand::Hand;
use super::location::LocationInventory;
use super::movement::{Action, Motion, Movement};
use super::movement_table::MovementTable;
use super::nonmanual::{Channel, NonManual};
use super::orientation::Orientation;
use super::placement::{Place, Placement, Relocation};
use super::sign::{Keys, Manual, Sign};
use crate::diagnostics::Error;
use crate::time::Seconds;

/// An operator on a sign.
#[derive(Debug, Clone, PartialEq)]
pub enum Operator {
    /// Played backwards: every manual tier and contact. An involution.
    Inverted,
    /// Only the path backwards: placement, movement and contact.
    InvertedMovement,
    /// The acting hand copied onto the other. Idempotent.
    Mirrored,
    /// The hands exchanged, left and right with them. An involution.
    Swapped,
    /// The mirror image of the whole signer. An involution.
    Reflected,
    /// Performed several times.
    Repeated {
        /// Performances in all, from 1.
        times: u8,
        /// How long the way back takes before each further performance.
        gap: Option<Seconds>,
        /// Each performance larger (+) or smaller (−) than the one before.
        growth: i8,
    },
    /// Other hand configurations, of one hand or of those that share the strong hand's.
    Configuration(Option<Hand>, Keys<Configuration>),
    /// Other orientations.
    Orientation(Option<Hand>, Keys<Orientation>),
    /// Other placements.
    Placement(Option<Hand>, Keys<Placement>),
    /// Other movements, one an interval.
    Movement(Option<Hand>, Vec<Movement>),
    /// Another non-manual tier.
    NonManual(Channel, Keys<NonManual>),
    /// Moved to a place: spatialization.
    At(Relocation),
    /// So many times as fast.
    Speed(f64),
    /// Paths so many times as large.
    Size(f64),
}

/// The inventories that operators look things up in.
#[derive(Debug, Clone, Copy)]
pub struct Tables<'t> {
    /// Places: which are on the body.
    pub locations: &'t LocationInventory,
    /// Movements: how large sizes are.
    pub movements: &'t MovementTable,
}

/// What an operator made.
#[derive(Debug, Clone, PartialEq)]
pub struct Applied {
    /// The new sign.
    pub sign: Sign,
    /// Sentences for the author.
    pub warnings: Vec<String>,
}

impl From<Sign> for Applied {
    fn from(sign: Sign) -> Applied {
        Applied { sign, warnings: Vec::new() }
    }
}

/// Applies an operator to a sign.
///
/// # Errors
/// What the operator cannot mean for this sign; the message says what to do instead.
///
/// ```
/// use chereme::phonology::movement_table::MovementTable;
/// use chereme::phonology::operator::{Operator, Tables, apply};
/// use chereme::phonology::{Configuration, Keys, LocationInventory, Sign};
/// let (locations, movements) = (LocationInventory::builtin(), MovementTable::embedded());
/// let tables = Tables { locations: &locations, movements: &movements };
/// let u = Operator::Configuration(None, Keys::one(Configuration::named("U")));
/// let slug = apply(&u, &Sign::named("ESCARGOT"), &tables).unwrap().sign;
/// assert_eq!(slug.strong.configuration.at(0).unwrap().base, "U");
/// ```
pub fn apply(operator: &Operator, sign: &Sign, tables: &Tables) -> Result<Applied, Error> {
    match operator {
        Operator::Inverted => Ok(inverted(sign).into()),
        Operator::InvertedMovement => Ok(inverted_movement(sign).into()),
        Operator::Mirrored => mirrored(sign, tables),
        Operator::Swapped => Ok(swapped(sign).into()),
        Operator::Reflected => Ok(reflected(sign).into()),
        Operator::Repeated { times, gap, growth } => {
            let sign_made = repeated(sign, *times, *gap, *growth, tables)?;
            let left_out = gap.is_some() && !sign.then.is_empty();
            let warning =
                || format!("{}: its phases follow each other without rest, so the gap is left out", sign.name);
            Ok(Applied { sign: sign_made, warnings: left_out.then(warning).into_iter().collect() })
        }
        Operator::Configuration(hand, values) => replace::configuration(sign, *hand, values),
        Operator::Orientation(hand, values) => replace::orientation(sign, *hand, values),
        Operator::Placement(hand, values) => replace::placement(sign, *hand, values),
        Operator::Movement(hand, movements) => replace::movement(sign, *hand, movements),
        Operator::NonManual(channel, values) => replace::nonmanual(sign, *channel, values),
        Operator::At(to) => place::at(sign, to, tables).map(Applied::from),
        Operator::Speed(factor) => scale::speed(sign, *factor).map(Applied::from),
        Operator::Size(factor) => scale::size(sign, *factor, tables).map(Applied::from),
    }
    .map_err(|e| e.context(&sign.name))
}

/// A hand's tiers.
fn manual(sign: &Sign, hand: Hand) -> &Manual {
    match hand {
        Hand::Strong => &sign.strong,
        Hand::Weak => &sign.weak,
    }
}

/// A hand's tiers, to be changed.
fn manual_mut(sign: &mut Sign, hand: Hand) -> &mut Manual {
    match hand {
        Hand::Strong => &mut sign.strong,
        Hand::Weak => &mut sign.weak,
    }
}

/// The place of a hand of which nothing is said.
fn neutral() -> Placement {
    Placement::at(Place::Body("neutral".into()))
}

/// A movement with nothing more said than what it is.
fn plain(motion: Motion) -> Movement {
    Movement::Action(Box::new(Action::new(motion)))
}

/// Values at keys in any order; the last one said of a key holds.
fn keys_of<T>(mut values: Vec<(usize, T)>) -> Keys<T> {
    values.sort_by_key(|(key, _)| *key);
    values.reverse();
    values.dedup_by_key(|(key, _)| *key);
    values.reverse();
    // Sorted, and each key once.
    Keys::new(values).unwrap_or_default()
}
