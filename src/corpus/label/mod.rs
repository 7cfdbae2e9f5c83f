//! Labels of phonological tiers as features: what can be compared of `round-B, thumb`, `chest left beside, close`,
//! `fingers up, palm out` or `arc up-right 15cm ×2`.
//!
//! Tiers hold strings, as synthesis writes them, as automatic annotation writes them, or as a person typed them in ELAN. Reading
//! is lenient: a word that is not known lowers the certainty, and never fails. Every label comes to *terms* (`place breast`,
//! `side left`), by which exact queries ask, and to features, between which there are distances.
//!
//! # Distances
//! From 0 to 1. Configuration, orientation and movement: [`crate::phonology::distance`]. Placement: how far the two places are from each
//! other on the body at rest, in arm lengths, side and distance from the skin included; one arm length and more is 1. Places on
//! the other hand are compared with one another, in hand lengths; a place there and one on the body are at distance 1.

mod configuration;
mod movement;
mod orientation;
mod placement;

pub use placement::Spot;

use super::cut::says_something;
use super::segment::Component;
use crate::body::landmarks::Landmarks;
use crate::diagnostics::Error;
use crate::diagnostics::suggest::nearest;
use crate::motion::pose::{LocalPose, ModelPose};
use crate::motion::skeleton::Skeleton;
use crate::phonology::distance::{Course, HandPoints, courses, orientations};
use crate::phonology::grammar::fold;
use crate::phonology::movement_table::MovementTable;
use crate::phonology::{HandshapeInventory, LocationInventory, Orientation};

/// What a label comes to.
#[derive(Debug, Clone, PartialEq)]
pub struct Label {
    /// The component that it is a value of.
    pub component: Component,
    /// The label as it stands.
    pub text: String,
    /// What it says, as folded terms, sorted, each once: `base round-b`, `place breast`, `fingers up`, `kind arc`.
    pub terms: Vec<String>,
    /// What of it can be compared.
    pub features: Features,
    /// Its words that are not known, as they stand.
    pub unknown: Vec<String>,
    /// How much of it is understood: the share of its words that are known, 0 to 1.
    pub certainty: f64,
}

/// What of a label can be compared.
#[derive(Debug, Clone, PartialEq)]
pub enum Features {
    /// Nothing: no known value is in the label.
    Nothing,
    /// The joints and tips of a hand.
    Hand(Box<HandPoints>),
    /// Where a hand is: several where the label leaves open which of two (a cheek).
    Places(Vec<Spot>),
    /// Where fingers and palm look, at least one of them.
    Orientation(Orientation),
    /// The movements one after the other, at least one.
    Courses(Vec<Course>),
}

impl Features {
    /// How different two are, 0 to 1; `None` where they have nothing to compare.
    pub fn distance(&self, other: &Features) -> Option<f64> {
        match (self, other) {
            (Features::Hand(a), Features::Hand(b)) => Some(a.distance(b)),
            (Features::Places(a), Features::Places(b)) => {
                let pairs = a.iter().flat_map(|x| b.iter().map(move |y| x.distance(y)));
                pairs.min_by(f64::total_cmp)
            }
            (Features::Orientation(a), Features::Orientation(b)) => orientations(a, b),
            (Features::Courses(a), Features::Courses(b)) => Some(courses(a, b)),
            _ => None,
        }
    }
}

/// Whether a value is what is asked for, where knowledge may be missing (Kleene's strong three-valued logic).
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Truth {
    /// It is not.
    No,
    /// Nobody knows.
    Unknown,
    /// It is.
    Yes,
}

impl Truth {
    /// Yes or no.
    pub fn of(is: bool) -> Truth {
        if is { Truth::Yes } else { Truth::No }
    }
}

impl std::ops::Not for Truth {
    type Output = Truth;

    /// The opposite; what is not known stays so.
    fn not(self) -> Truth {
        match self {
            Truth::No => Truth::Yes,
            Truth::Unknown => Truth::Unknown,
            Truth::Yes => Truth::No,
        }
    }
}

impl Label {
    /// Whether this value says all that the pattern says; more may be said. An orientation that tells nothing of the
    /// fingers, or of the palm, neither matches nor fails a pattern that asks for them.
    pub fn matches(&self, pattern: &Label) -> Truth {
        let truth = |term: &String| match self.terms.binary_search(term) {
            Ok(_) => Truth::Yes,
            Err(_) if self.leaves_open(term) => Truth::Unknown,
            Err(_) => Truth::No,
        };
        if !says_something(&self.text) {
            return Truth::Unknown;
        }
        pattern.terms.iter().map(truth).min().unwrap_or(Truth::Yes)
    }

    /// Whether a term is of a kind that this label may say and does not.
    fn leaves_open(&self, term: &str) -> bool {
        let kind = |term: &str| ["fingers ", "palm "].into_iter().find(|kind| term.starts_with(kind));
        self.component == Component::Orientation
            && kind(term).is_some_and(|wanted| !self.terms.iter().any(|own| own.starts_with(wanted)))
    }

    /// Whether some question about this value has no answer: it lacks features, or says half of an orientation.
    pub fn is_partial(&self) -> bool {
        let half = |o: &Orientation| o.fingers.is_none() || o.palm.is_none();
        match &self.features {
            Features::Nothing => true,
            Features::Orientation(orientation) => half(orientation),
            Features::Hand(_) | Features::Places(_) | Features::Courses(_) => false,
        }
    }
}

/// The words of the inventories and the body on which they are places: what labels are read with.
#[derive(Debug, Clone)]
pub struct Vocabulary {
    handshapes: HandshapeInventory,
    locations: LocationInventory,
    movements: MovementTable,
    landmarks: Landmarks,
    rest: ModelPose,
    language: Option<String>,
}

impl Vocabulary {
    /// The words of inventories; places are on the landmarks of a rig at rest. Letters of the language's alphabet come first
    /// (`M` in `lsf` is `LSF M`).
    pub fn new(
        handshapes: HandshapeInventory,
        locations: LocationInventory,
        landmarks: Landmarks,
        skeleton: &Skeleton,
        language: Option<&str>,
    ) -> Vocabulary {
        let rest = LocalPose::rest(skeleton).to_model(skeleton);
        let (movements, language) = (MovementTable::embedded(), language.map(str::to_owned));
        Vocabulary { handshapes, locations, movements, landmarks, rest, language }
    }

    /// The program's own inventories, on its avatar's rig.
    ///
    /// # Errors
    /// Never for the built-in data; the type is that of the readers of rigs and landmarks.
    ///
    /// ```
    /// use chereme::corpus::{label::Vocabulary, segment::Component};
    /// use chereme::motion::skeleton::Skeleton;
    /// let rig = Skeleton::from_json(chereme::avatar::SKELETON).unwrap();
    /// let vocabulary = Vocabulary::builtin(&rig, None).unwrap();
    /// let label = vocabulary.read(Component::Placement, "chest left, close");
    /// assert_eq!(label.terms, ["distance close", "place chest", "side left"]);
    /// ```
    pub fn builtin(skeleton: &Skeleton, language: Option<&str>) -> Result<Vocabulary, Error> {
        let (handshapes, locations) = (HandshapeInventory::builtin(), LocationInventory::builtin());
        Ok(Vocabulary::new(handshapes, locations, Landmarks::builtin(skeleton)?, skeleton, language))
    }

    /// Reads a label of a component.
    pub fn read(&self, component: Component, text: &str) -> Label {
        let mut reading = Reading::default();
        let features = match component {
            _ if !says_something(text) => Features::Nothing,
            Component::Configuration => self.configuration(text, &mut reading),
            Component::Placement => self.placement(&fold(text), &mut reading),
            Component::Orientation => orientation::read(&fold(text), &mut reading),
            Component::Movement => self.movement(&fold(text), &mut reading),
        };
        reading.terms.sort();
        reading.terms.dedup();
        let words = (reading.known + reading.unknown.len()).max(1);
        let certainty = reading.known as f64 / words as f64;
        let (terms, unknown) = (reading.terms, reading.unknown);
        Label { component, text: text.trim().to_owned(), terms, features, unknown, certainty }
    }

    /// Words that a value of a component may have, for "did you mean".
    pub fn words(&self, component: Component) -> Vec<&str> {
        match component {
            Component::Configuration => self.handshapes.shapes().iter().flat_map(|shape| shape.names()).collect(),
            Component::Placement => self.locations.names().chain(placement::WORDS).collect(),
            Component::Orientation => orientation::WORDS.to_vec(),
            Component::Movement => movement::WORDS.to_vec(),
        }
    }

    /// Guesses at what an unknown word of a value may be, each a sentence.
    pub fn guesses(&self, label: &Label) -> Vec<String> {
        let nothing = label.component == Component::Configuration && label.features == Features::Nothing;
        if let Some(doubt) = Some(&label.text).filter(|_| nothing).and_then(|text| self.doubt(text)) {
            return vec![doubt];
        }
        let known = self.words(label.component);
        let near = |word: &String| nearest(word, known.iter().copied()).map(|near| format!("did you mean `{near}`?"));
        label.unknown.iter().filter_map(near).collect()
    }

    /// The language whose alphabet comes first.
    fn language(&self) -> Option<&str> {
        self.language.as_deref()
    }
}

/// What is read of a label so far.
#[derive(Debug, Default)]
struct Reading {
    terms: Vec<String>,
    unknown: Vec<String>,
    /// Words that are known.
    known: usize,
}

impl Reading {
    /// Words that are known, as a term.
    fn known(&mut self, term: impl Into<String>) {
        self.terms.push(term.into());
        self.known += 1;
    }

    /// A word that is not known; it is a term all the same, so that the same word is found.
    fn unknown(&mut self, word: &str) {
        self.terms.push(format!("word {}", fold(word)));
        self.unknown.push(word.to_owned());
    }
}
