//! Gloss lines made plans: glosses looked up in the lexicon, places resolved, signs recombined.
//!
//! The line's language is the one that it is said to be in, else the one that knows most of its glosses; names are
//! looked up there first, then in all. A gloss in brackets, `IX(MAISON)`, is the place where that sign was made last
//! in the line, and a fault where it was not placed.
//!
//! # Conventions
//! The labels of the plan's items are the glosses as written. A pause is a hold: 0.2 s for a comma, 0.5 s for a point.
//! Of two values of one channel, the inner braces' holds within them.

mod captured;
mod explain;
mod line;
mod lookup;
mod signed;
mod spelling;

pub use explain::explain;

use super::plan::Plan;
use crate::diagnostics::{Diagnostic, Severity};
use crate::notation::gloss::parse;
use crate::notation::gloss::syntax::GlossLine;
use crate::notation::{Lexicon, Vocabulary};
use crate::phonology::Hand;
use crate::phonology::grammar::fold;
use crate::phonology::operator::Tables;
use std::collections::BTreeSet;

/// How a line is read.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct Settings {
    /// The line's language, short name; found from its glosses where `None`.
    pub language: Option<String>,
    /// The language whose alphabet spells words; the line's where `None`.
    pub alphabet: Option<String>,
    /// The signer's strong hand.
    pub handedness: Handedness,
    /// What becomes of glosses that the lexicon does not know.
    pub missing: Missing,
    /// Glosses that a corpus has captured.
    pub captured: CapturedGlosses,
}

/// Glosses of which a corpus has motion.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct CapturedGlosses {
    /// The glosses, in any case.
    pub glosses: BTreeSet<String>,
    /// Whether motion is preferred to a description; else it stands in only where there is none.
    pub preferred: bool,
}

impl CapturedGlosses {
    /// Whether motion of that gloss was captured.
    pub fn has(&self, gloss: &str) -> bool {
        let folded = fold(gloss);
        self.glosses.iter().any(|known| fold(known) == folded)
    }
}

/// The signer's strong hand.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Handedness {
    /// The right one.
    #[default]
    Right,
    /// The left one: signs exchange their hands, places in space stay where they are.
    Left,
}

impl Handedness {
    /// The hand of a plan that plays a role in the signer's signs: in a plan, strong is right.
    ///
    /// ```
    /// use chereme::{phonology::Hand, score::gloss::Handedness};
    /// assert_eq!(Handedness::Left.hand(Hand::Strong), Hand::Weak);
    /// ```
    pub fn hand(self, role: Hand) -> Hand {
        match self {
            Handedness::Right => role,
            Handedness::Left => role.other(),
        }
    }
}

/// What becomes of glosses that the lexicon does not know.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Missing {
    /// A fault, with the nearest known gloss.
    #[default]
    Refuse,
    /// They are spelled, with a warning.
    Fingerspell,
    /// They are left out, with a warning.
    Skip,
}

/// What a line is read against.
#[derive(Debug, Clone, Copy)]
pub struct Known<'k> {
    /// Signs and alphabets.
    pub lexicon: &'k Lexicon,
    /// Names of non-manual values and places.
    pub vocabulary: &'k Vocabulary,
    /// What operators look up.
    pub tables: Tables<'k>,
}

/// A line that was read.
#[derive(Debug, Clone, Default)]
pub struct Reading {
    /// What was written.
    pub line: GlossLine,
    /// The language that names were looked up in first; empty where none could be told.
    pub language: String,
    /// What is signed; items with a fault are left out.
    pub plan: Plan,
    /// All faults and warnings, by their place in the line.
    pub diagnostics: Vec<Diagnostic>,
}

impl Reading {
    /// Whether something cannot be used as it is written.
    pub fn has_faults(&self) -> bool {
        self.diagnostics.iter().any(|d| d.severity == Severity::Fault)
    }
}

/// Reads a gloss line.
///
/// ```
/// use chereme::notation::{Lexicon, Vocabulary, lexicon::embedded};
/// use chereme::phonology::{LocationInventory, movement_table::MovementTable, operator::Tables};
/// use chereme::score::gloss::{Known, Settings, read};
/// let (locations, movements) = (LocationInventory::builtin(), MovementTable::embedded());
/// let vocabulary = Vocabulary::builtin();
/// let mut lexicon = Lexicon::default();
/// lexicon.add(embedded(), &vocabulary);
/// let tables = Tables { locations: &locations, movements: &movements };
/// let known = Known { lexicon: &lexicon, vocabulary: &vocabulary, tables };
/// let reading = read("BONJOUR, {brows raised: BOL@left} fs(LSF)", &known, &Settings::default());
/// assert_eq!(reading.diagnostics, []);
/// assert_eq!(reading.language, "lsf");
/// assert_eq!(reading.plan.items.len(), 4);
/// ```
pub fn read(text: &str, known: &Known, settings: &Settings) -> Reading {
    let (line, mut diagnostics) = parse(text);
    let language = settings.language.clone().or_else(|| lookup::language(&line, known.lexicon)).unwrap_or_default();
    let lookup = lookup::Lookup { lexicon: known.lexicon, language: &language, settings };
    let plan = line::lower(&line, text, &lookup, known, &mut diagnostics);
    diagnostics.sort_by_key(|d| d.span.start);
    Reading { line, language, plan, diagnostics }
}
