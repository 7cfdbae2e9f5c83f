//! How well a participant knows the sign language, by their own account (Naert et al. 2021, §7.1.2).

use crate::diagnostics::Error;
use std::collections::BTreeSet;
use std::fmt;
use std::str::FromStr;

/// The paper's seven levels, in its order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Level {
    /// No knowledge.
    None,
    /// A beginner.
    Beginner,
    /// Quite good.
    QuiteGood,
    /// Good: the least level that the paper counts.
    Good,
    /// Very good.
    VeryGood,
    /// Native.
    Native,
    /// An interpreter.
    Interpreter,
}

impl Level {
    /// All of them, in order.
    pub const ALL: [Level; 7] = [
        Level::None,
        Level::Beginner,
        Level::QuiteGood,
        Level::Good,
        Level::VeryGood,
        Level::Native,
        Level::Interpreter,
    ];

    /// The word that stands in tables.
    pub fn name(self) -> &'static str {
        match self {
            Level::None => "none",
            Level::Beginner => "beginner",
            Level::QuiteGood => "quite-good",
            Level::Good => "good",
            Level::VeryGood => "very-good",
            Level::Native => "native",
            Level::Interpreter => "interpreter",
        }
    }
}

impl fmt::Display for Level {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

impl FromStr for Level {
    type Err = Error;

    /// Reads a name, whatever its case, with spaces or hyphens.
    fn from_str(text: &str) -> Result<Level, Error> {
        let name = text.trim().to_lowercase().replace([' ', '_'], "-");
        Level::ALL.into_iter().find(|level| level.name() == name).ok_or_else(|| {
            let names = Level::ALL.map(Level::name).join(", ");
            Error::new(format!("`{}` is no level of sign language; there are {names}", text.trim()))
        })
    }
}

/// Which levels are counted: `good+` (this one and above), `good,native` (these).
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Levels(BTreeSet<Level>);

impl Levels {
    /// Whether a level is counted.
    ///
    /// ```
    /// use chereme::evaluation::ratings::{Level, Levels};
    /// let levels: Levels = "good+".parse().unwrap();
    /// assert!(levels.has(Level::Native) && !levels.has(Level::QuiteGood));
    /// assert!("god+".parse::<Levels>().unwrap_err().to_string().contains("very-good"));
    /// ```
    pub fn has(&self, level: Level) -> bool {
        self.0.contains(&level)
    }
}

impl FromStr for Levels {
    type Err = Error;

    fn from_str(text: &str) -> Result<Levels, Error> {
        let mut levels = BTreeSet::new();
        for part in text.split(',') {
            match part.trim().strip_suffix('+') {
                Some(least) => {
                    let least: Level = least.parse()?;
                    levels.extend(Level::ALL.into_iter().filter(|level| *level >= least));
                }
                None => drop(levels.insert(part.parse()?)),
            }
        }
        Ok(Levels(levels))
    }
}

impl fmt::Display for Levels {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0.iter().map(|level| level.name()).collect::<Vec<_>>().join(", "))
    }
}
