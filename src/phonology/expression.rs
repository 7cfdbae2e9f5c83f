//! The inventory of non-manual values (`grammar/nonmanuals.ron`): names, and what the face and head do.
//!
//! A value is held or beats to and fro; it moves named face morphs and turns head, trunk or eyes by
//! anatomical angles. Which joints those are is the body's affair.

use super::grammar::read_table;
use super::nonmanual::Channel;
use crate::diagnostics::{Diagnostic, Source, Span};
use serde::Deserialize;
use std::collections::BTreeMap;

/// One value of a non-manual tier.
#[derive(Debug, Clone, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Expression {
    channel: String,
    /// The name in text.
    pub name: String,
    /// Other names.
    #[serde(default)]
    pub aliases: Vec<String>,
    /// The tag of SiGML's non-manual tiers.
    #[serde(default)]
    pub hamnosys: String,
    /// Weights of face morphs, 0 to 1.
    #[serde(default)]
    pub morphs: BTreeMap<String, f32>,
    /// Pitch (+ forward), yaw (+ left) and roll (+ left) in degrees.
    #[serde(default)]
    pub turn: (f64, f64, f64),
    /// How far the left and the right shoulder are raised, degrees.
    #[serde(default)]
    pub raise: (f64, f64),
    /// Cycles a second of a movement to and fro; 0 where the value is held.
    #[serde(default)]
    pub beats: f64,
    /// The sounds (SAMPA, one character each) that this mouth shape stands for.
    #[serde(default)]
    pub sounds: String,
}

/// All non-manual values.
#[derive(Debug, Clone, Default)]
pub struct Expressions {
    rows: Vec<(Channel, Expression)>,
}

impl Expressions {
    /// Reads and checks the table.
    ///
    /// # Errors
    /// The place where the text is not such a table, an unknown tier, a name given twice, a weight outside 0 to 1.
    pub fn read(source: &Source) -> Result<Expressions, Diagnostic> {
        let rows: Vec<Expression> = read_table(source)?;
        let mut checked: Vec<(Channel, Expression)> = Vec::with_capacity(rows.len());
        for row in rows {
            let at = source.text.find(&format!("\"{}\"", row.name)).unwrap_or(0);
            let fault = |message: String| Diagnostic::fault(Span::new(at, at + row.name.len() + 2), message);
            let Some(channel) = Channel::ALL.into_iter().find(|c| c.name() == row.channel) else {
                return Err(fault(format!("there is no non-manual tier `{}`", row.channel)));
            };
            if row.morphs.values().any(|w| !(0.0..=1.0).contains(w)) {
                return Err(fault(format!("{}: a morph's weight lies between 0 and 1", row.name)));
            }
            let numbers = [row.turn.0, row.turn.1, row.turn.2, row.raise.0, row.raise.1];
            if !numbers.iter().all(|d| d.abs() <= 90.0) || !(0.0..=10.0).contains(&row.beats) {
                return Err(fault(format!("{}: degrees lie within ±90, beats between 0 and 10", row.name)));
            }
            let twice = checked.iter().any(|(c, other)| *c == channel && other.answers_to(&row.name));
            if twice {
                return Err(fault(format!("{} has {} twice", channel.name(), row.name)));
            }
            checked.push((channel, row));
        }
        Ok(Expressions { rows: checked })
    }

    /// The program's own table.
    pub fn embedded() -> Expressions {
        let source = Source::new("grammar/nonmanuals.ron", include_str!("../../grammar/nonmanuals.ron"));
        Expressions::read(&source).expect("the embedded table is read by a test")
    }

    /// These values with those of another table put in place of the ones of the same tier and name, or added.
    pub fn overridden_by(mut self, other: Expressions) -> Expressions {
        for (channel, row) in other.rows {
            match self.rows.iter_mut().find(|(c, r)| *c == channel && r.name.eq_ignore_ascii_case(&row.name)) {
                Some(old) => *old = (channel, row),
                None => self.rows.push((channel, row)),
            }
        }
        self
    }

    /// A value of a tier, by its name or an alias, letter case aside.
    ///
    /// ```
    /// use chereme::phonology::{Channel, expression::Expressions};
    /// assert!(Expressions::embedded().find(Channel::Brows, "raised").is_some());
    /// ```
    pub fn find(&self, channel: Channel, name: &str) -> Option<&Expression> {
        self.of(channel).find(|row| row.answers_to(name))
    }

    /// The mouth shape of a sound, one character of SAMPA.
    pub fn viseme(&self, sound: char) -> Option<&Expression> {
        self.of(Channel::Mouth).find(|row| row.sounds.contains(sound))
    }

    /// The values of a tier, in the table's order.
    pub fn of(&self, channel: Channel) -> impl Iterator<Item = &Expression> {
        self.rows.iter().filter(move |(c, _)| *c == channel).map(|(_, row)| row)
    }
}

impl Expression {
    fn answers_to(&self, name: &str) -> bool {
        let name = name.to_lowercase();
        self.name.to_lowercase() == name || self.aliases.iter().any(|a| a.to_lowercase() == name)
    }
}
