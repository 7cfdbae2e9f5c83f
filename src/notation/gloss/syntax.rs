//! What was written in a gloss line: items with their spans, names not looked up.

use crate::diagnostics::{Span, Spanned};
use crate::notation::syntax::{Duration, Ignored, NonManual, Operator};
use crate::phonology::recombination::Taken;
use crate::phonology::{Channel, Hand, Space};

/// A whole line.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct GlossLine {
    /// One after the other.
    pub items: Vec<Item>,
}

/// One item of a line.
#[derive(Debug, Clone, PartialEq)]
pub struct Item {
    /// What it says.
    pub what: What,
    /// Where it stands.
    pub span: Ignored<Span>,
}

/// What an item says.
#[derive(Debug, Clone, PartialEq)]
pub enum What {
    /// A sign: `BOL@left`, `IX(MAISON)`, `fs(LSF)`.
    Signed(Box<Signed>),
    /// `A & B`: the strong hand's sign and the weak hand's, at the same time.
    Together(Box<Signed>, Box<Signed>),
    /// `,` and `.`: the posture reached is held for a moment.
    Pause(Pause),
    /// `<HOLD 0.5s>`, `<HOLD weak>`
    Hold(Option<Hand>, Option<Duration>),
    /// `<REST>`
    Rest(Option<Duration>),
    /// `{brows raised: TOI NOM QUOI}`
    Face(Face),
}

/// Punctuation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Pause {
    /// `,`
    Short,
    /// `.` or `//`
    Long,
}

impl Pause {
    /// How long the hands stay, seconds.
    ///
    /// ```
    /// use chereme::notation::gloss::syntax::Pause;
    /// assert!(Pause::Short.seconds() < Pause::Long.seconds());
    /// ```
    pub fn seconds(self) -> f64 {
        match self {
            Pause::Short => 0.2,
            Pause::Long => 0.5,
        }
    }
}

/// A sign with what is said of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Signed {
    /// Which sign.
    pub head: Spanned<Head>,
    /// The hand that makes it: the weak one in `weak(GLOSS)`.
    pub hand: Hand,
    /// `@left`: where it is made.
    pub site: Option<Spanned<Site>>,
    /// How often it is made in all: one, and one for each `+`.
    pub performances: Spanned<u8>,
    /// `[inverted, big]`: how it is changed; empty where it is not.
    pub operators: Spanned<Vec<Operator>>,
}

/// Which sign.
#[derive(Debug, Clone, PartialEq)]
pub enum Head {
    /// A name of the lexicon.
    Gloss(String),
    /// `IX(0.6,1.4,0.5)`, `IX@left`, `IX(MAISON)`: the index points there.
    Pointing(Site),
    /// `wrist(0.3,1.2,0.4)`: the wrist is brought there, as in the paper.
    Wrist(Site),
    /// `fs(LSF)`
    Spelled(String),
    /// `take(father_3, configuration eight_2)`: exactly this take of a corpus, its fingers from another one.
    Taken(Taken),
}

/// Where a sign is made, or what is pointed at.
#[derive(Debug, Clone, PartialEq)]
pub enum Site {
    /// `left-high`: a cell of the grid before the signer.
    Space(Space),
    /// `(0.6,1.4,0.5)`: left, up, out in metres.
    Point([f64; 3]),
    /// `MAISON`: where that sign was made before in the line.
    Referent(String),
}

/// Non-manuals over items.
#[derive(Debug, Clone, PartialEq)]
pub struct Face {
    /// What head, trunk and face do.
    pub values: Vec<(Spanned<Channel>, NonManual)>,
    /// Meanwhile.
    pub items: Vec<Item>,
}
