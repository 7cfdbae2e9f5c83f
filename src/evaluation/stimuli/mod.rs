//! The paper's stimuli (Naert et al. 2021, §7.1, §7.2 and table 2): what is signed, by which interpolation, and what is asked.
//!
//! A [`Set`] is one questionnaire; [`blind`] gives its stimuli opaque names and an order, and [`key`] is the table that says
//! what they are.
//!
//! # Departs from the paper
//! - Its ground truth is captured LSF, which is not published: a captured version stands where a recording is given, and is left out
//!   elsewhere.
//! - Spatialization has six answers and five synthesized places; here each of the six is shown once, so that every answer is
//!   right once. Which six the paper had is not said.
//! - The 24 answers of the configuration set are its stimuli and other words that are close to them: ours, the paper does
//!   not list its own.

mod blind;
mod configuration;
mod placement;

pub use blind::{Blind, blind, key};

use crate::format::questionnaire::{Choice, Question, Words};
use crate::motion::easing::Easing;
use std::fmt;
use std::str::FromStr;

/// A questionnaire of the paper.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Set {
    /// §7.1: BOL at places, and pointing.
    Placement,
    /// §7.2: exchanged configurations, and signs derived from dactylology.
    Configuration,
}

impl Set {
    /// Both.
    pub const ALL: [Set; 2] = [Set::Placement, Set::Configuration];

    /// Its name.
    pub fn name(self) -> &'static str {
        match self {
            Set::Placement => "placement",
            Set::Configuration => "configuration",
        }
    }

    /// What it shows and asks.
    ///
    /// ```
    /// use chereme::evaluation::stimuli::Set;
    /// let sheet = Set::Configuration.sheet();
    /// assert_eq!((sheet.stimuli.len(), sheet.questions[0].choices.len()), (15, 24));
    /// ```
    pub fn sheet(self) -> Sheet {
        match self {
            Set::Placement => placement::sheet(),
            Set::Configuration => configuration::sheet(),
        }
    }
}

impl fmt::Display for Set {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Set {
    type Err = crate::diagnostics::Error;

    fn from_str(text: &str) -> Result<Set, Self::Err> {
        let known = Set::ALL.into_iter().find(|set| set.name() == text.trim().to_lowercase());
        known.ok_or_else(|| {
            crate::diagnostics::Error::new(format!(
                "there are no stimuli `{text}`; there are placement and configuration"
            ))
        })
    }
}

/// What a questionnaire shows and asks.
#[derive(Debug, Clone, PartialEq)]
pub struct Sheet {
    /// The heading.
    pub title: Words,
    /// What people read first.
    pub introduction: Words,
    /// The questions.
    pub questions: Vec<Question>,
    /// What is shown.
    pub stimuli: Vec<Stimulus>,
}

/// Something that is shown.
#[derive(Debug, Clone, PartialEq)]
pub struct Stimulus {
    /// The comparison that it belongs to.
    pub group: &'static str,
    /// What is signed.
    pub item: String,
    /// How it is made.
    pub version: Version,
    /// The gloss line that is synthesized, in LSF.
    pub line: String,
    /// The value of the right answer, where something is to be recognised.
    pub correct: Option<String>,
    /// The number of its question.
    pub question: usize,
}

/// How a stimulus is made.
#[derive(Debug, Clone, PartialEq)]
pub enum Version {
    /// Synthesized, with this name in the results.
    Synthesized(String, Easing),
    /// A recording, the paper's ground truth.
    Captured,
}

impl Version {
    /// Its name in the results.
    pub fn name(&self) -> &str {
        match self {
            Version::Synthesized(name, _) => name,
            Version::Captured => "captured",
        }
    }
}

impl Sheet {
    /// Items that a recording may stand for.
    pub fn items(&self) -> Vec<&str> {
        let mut items: Vec<&str> = Vec::new();
        for stimulus in &self.stimuli {
            if !items.contains(&stimulus.item.as_str()) {
                items.push(&stimulus.item);
            }
        }
        items
    }

    /// Adds a captured version of an item (letter case does not matter); `None` where there is no such item.
    pub fn with_captured(&mut self, item: &str) -> Option<&Stimulus> {
        let like = self.stimuli.iter().find(|s| s.item.to_lowercase() == item.to_lowercase())?.clone();
        self.stimuli.push(Stimulus { version: Version::Captured, ..like });
        self.stimuli.last()
    }
}

fn choice(value: &str, en: &str, fr: &str) -> Choice {
    Choice { value: value.to_owned(), label: Words::new(en, fr) }
}
