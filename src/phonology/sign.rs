//! A sign: tiers of values at keys and in intervals, without motion.
//!
//! A sign has N + 1 key postures and N movement intervals. Configuration, placement and orientation take
//! values at keys, movement in intervals, non-manuals and contact over keys. A key without a value keeps that
//! of its neighbour; for placement it is where the movement leads.

use super::configuration::Configuration;
use super::movement::Movement;
use super::nonmanual::{Channel, NonManual};
use super::orientation::Orientation;
use super::placement::{Contact, Placement, Relocation};
use crate::time::Seconds;

/// A sign as it is described.
#[derive(Debug, Clone, PartialEq)]
pub struct Sign {
    /// The gloss, NFC.
    pub name: String,
    /// The language's short name (`lsf`), empty where not known.
    pub language: String,
    /// Meanings: language tag and words.
    pub meaning: Vec<(String, String)>,
    /// What was read to write the description.
    pub source: Option<String>,
    /// `unverified`, or who checked it.
    pub status: Option<String>,
    /// Remarks for people.
    pub note: Option<String>,
    /// Which hands act, and their relation.
    pub hands: Hands,
    /// The number of movement intervals; there is one key more.
    pub intervals: usize,
    /// The strong hand's tiers.
    pub strong: Manual,
    /// The weak hand's own tiers; with a symmetry, what is not stated follows the strong hand.
    pub weak: Manual,
    /// How the hands meet, at keys.
    pub contact: Keys<Contact>,
    /// Non-manual tiers, each at most once, in the order of [`Channel::ALL`].
    pub nonmanual: Vec<(Channel, Keys<NonManual>)>,
    /// How long all the intervals last together.
    pub duration: Option<Seconds>,
    /// How fast: every time of the sign is divided by it; from 0.05 to 20.
    pub speed: f64,
    /// The configurations attested on this derivative base or shape specifier; empty where it is none.
    pub base: Vec<Attested>,
    /// Where the whole sign is moved to.
    pub relocated: Option<Relocation>,
    /// The other hand stays as the phase before left it; only in [`Sign::then`] (SiGML `holdover`).
    pub holds_over: bool,
    /// Further phases, performed after this one without rest: each with hands, tiers and keys of its own, without name,
    /// meaning, language or phases (HamNoSys `hamplus` between signs, several `sign_manual` in SiGML). Non-manual values,
    /// duration and speed of this sign are those of all phases together; a further phase's speed multiplies it.
    pub then: Vec<Sign>,
}

/// A configuration that is attested on a derivative base or shape specifier, and what the sign means then
/// (Naert et al. 2021, §5.1).
#[derive(Debug, Clone, PartialEq)]
pub struct Attested {
    /// The configuration.
    pub configuration: Configuration,
    /// Meanings: language tag and words.
    pub meaning: Vec<(String, String)>,
}

impl Sign {
    /// The most movement intervals a sign has: far above any sign, and enough for a long fingerspelled word.
    pub const MOST_INTERVALS: usize = 256;
    /// The slowest and the greatest speed of a sign.
    pub const SPEEDS: std::ops::RangeInclusive<f64> = 0.05..=20.0;

    /// A sign of one hand of which nothing is said yet.
    pub fn named(name: impl Into<String>) -> Sign {
        Sign {
            name: name.into(),
            language: String::new(),
            meaning: Vec::new(),
            source: None,
            status: None,
            note: None,
            hands: Hands::Strong,
            intervals: 0,
            strong: Manual::default(),
            weak: Manual::default(),
            contact: Keys::default(),
            nonmanual: Vec::new(),
            duration: None,
            speed: 1.0,
            base: Vec::new(),
            relocated: None,
            holds_over: false,
            then: Vec::new(),
        }
    }

    /// All phases in order: this one and those after it.
    pub fn phases(&self) -> impl DoubleEndedIterator<Item = &Sign> {
        std::iter::once(self).chain(&self.then)
    }
}

/// The manual tiers of one hand.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Manual {
    /// Hand configuration at keys.
    pub configuration: Keys<Configuration>,
    /// Hand placement at keys.
    pub placement: Keys<Placement>,
    /// Hand orientation at keys.
    pub orientation: Keys<Orientation>,
    /// Hand movement, one an interval; empty where none is stated.
    pub movement: Vec<Movement>,
}

impl Manual {
    /// Whether nothing is stated.
    pub fn is_empty(&self) -> bool {
        self.configuration.is_empty()
            && self.placement.is_empty()
            && self.orientation.is_empty()
            && self.movement.is_empty()
    }
}

/// Values at keys, by rising key number (0 is the start); keys may be left out.
#[derive(Debug, Clone, PartialEq)]
pub struct Keys<T>(Vec<(usize, T)>);

impl<T> Default for Keys<T> {
    fn default() -> Self {
        Keys(Vec::new())
    }
}

impl<T> Keys<T> {
    /// One value, stated at the first key.
    pub fn one(value: T) -> Keys<T> {
        Keys(vec![(0, value)])
    }

    /// Values at keys; `None` where the key numbers do not rise.
    pub fn new(values: Vec<(usize, T)>) -> Option<Keys<T>> {
        values.windows(2).all(|w| w[0].0 < w[1].0).then_some(Keys(values))
    }

    /// Whether there is no value.
    pub fn is_empty(&self) -> bool {
        self.0.is_empty()
    }

    /// How many values there are.
    pub fn len(&self) -> usize {
        self.0.len()
    }

    /// Key numbers and values.
    pub fn iter(&self) -> impl Iterator<Item = (usize, &T)> {
        self.0.iter().map(|(k, v)| (*k, v))
    }

    /// The value stated at a key.
    pub fn stated(&self, key: usize) -> Option<&T> {
        self.0.iter().find(|(k, _)| *k == key).map(|(_, v)| v)
    }

    /// The value that holds at a key: the last one stated at it or before, else the first one after.
    pub fn at(&self, key: usize) -> Option<&T> {
        self.0.iter().rev().find(|(k, _)| *k <= key).or(self.0.first()).map(|(_, v)| v)
    }
}

/// Which hands act.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Hands {
    /// The strong hand.
    #[default]
    Strong,
    /// The weak hand alone (HamNoSys `hamnondominant`).
    Weak,
    /// Both; with a symmetry the weak hand follows the strong one.
    Both(Option<Symmetry>),
}

/// How the weak hand follows the strong one.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Symmetry {
    /// Mirrored or parallel.
    pub relation: Relation,
    /// Also exchanged up and down (HamNoSys's second symmetry plane).
    pub up_down: bool,
    /// Also exchanged out and in.
    pub out_in: bool,
    /// Half a cycle apart.
    pub alternating: bool,
    /// The hands start crossed over (HamNoSys `hamnonipsi`).
    pub crossed: bool,
}

impl Symmetry {
    /// Mirrored at the midline, nothing else.
    pub const MIRRORED: Symmetry = Symmetry::plain(Relation::Mirrored);
    /// Side by side, nothing else.
    pub const PARALLEL: Symmetry = Symmetry::plain(Relation::Parallel);

    const fn plain(relation: Relation) -> Symmetry {
        Symmetry { relation, up_down: false, out_in: false, alternating: false, crossed: false }
    }
}

/// Mirrored or parallel.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Relation {
    /// Left and right exchanged (HamNoSys `hamsymmlr`).
    Mirrored,
    /// The same directions (HamNoSys `hamsymmpar`).
    Parallel,
}
