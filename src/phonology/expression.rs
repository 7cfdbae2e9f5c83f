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
    /// The tags of SiGML's non-manual tiers, separated by spaces; the first is the one to write.
    #[serde(default)]
    pub hamnosys: String,
    /// Weights of face morphs, 0 to 1.
    #[serde(default)]
    pub morphs: BTreeMap<String, f32>,
    /// Pitch (+ forward), yaw (+ left) and roll (+ left) in degrees.
    #[serde(default)]
    pub turn: (f64, f64, f64),
    /// How far the head is pushed forward over the trunk without turning, degrees of the neck.
    #[serde(default)]
    pub push: f64,
    /// How far the left and the right shoulder are raised, degrees.
    #[serde(default)]
    pub raise: (f64, f64),
    /// How far the left and the right shoulder come forward, degrees.
    #[serde(default)]
    pub hunch: (f64, f64),
    /// What it goes through, one after the other, beside what it does all the time.
    #[serde(default)]
    pub steps: Vec<Step>,
    /// Cycles a second of a movement to and fro, or of the steps; 0 where the value is held.
    #[serde(default)]
    pub beats: f64,
    /// How many cycles there are at most; 0 for as many as there is time for.
    #[serde(default)]
    pub times: u32,
    /// The word that the mouth says, in SAMPA: `boam`.
    #[serde(default)]
    pub says: String,
    /// What the eyes follow.
    #[serde(default)]
    pub look: Option<Look>,
    /// The sounds (SAMPA, one character each) that this mouth shape stands for.
    #[serde(default)]
    pub sounds: String,
    /// How little the sounds beside it change this mouth shape, 0 to 1.
    #[serde(default = "whole")]
    pub firm: f64,
}

/// One step of a value that goes through several.
#[derive(Debug, Clone, Default, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Step {
    /// Its part of the time, relative to the other steps.
    #[serde(default = "whole")]
    pub share: f64,
    /// Weights of face morphs, 0 to 1.
    #[serde(default)]
    pub morphs: BTreeMap<String, f32>,
    /// Pitch (+ forward), yaw (+ left) and roll (+ left) in degrees.
    #[serde(default)]
    pub turn: (f64, f64, f64),
    /// How far the head is pushed forward, degrees of the neck.
    #[serde(default)]
    pub push: f64,
    /// How far the left and the right shoulder are raised, degrees.
    #[serde(default)]
    pub raise: (f64, f64),
    /// How far the left and the right shoulder come forward, degrees.
    #[serde(default)]
    pub hunch: (f64, f64),
}

/// What eyes follow, or head and eyes together.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
pub enum Look {
    /// Straight ahead in space, however the head is turned.
    Ahead,
    /// Between the signer's hands.
    Hands,
    /// The strong hand.
    Strong,
    /// The weak hand.
    Weak,
    /// The head goes where the eyes go.
    Gaze,
}

fn whole() -> f64 {
    1.0
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
            row.check().map_err(fault)?;
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

    /// The value of a tier that a tag of SiGML means: `NO` of the head is a nod.
    ///
    /// ```
    /// use chereme::phonology::{Channel, expression::Expressions};
    /// let expressions = Expressions::embedded();
    /// assert_eq!(expressions.tagged(Channel::Head, "NO").map(|row| row.name.as_str()), Some("nod"));
    /// ```
    pub fn tagged(&self, channel: Channel, tag: &str) -> Option<&Expression> {
        self.of(channel).find(|row| row.hamnosys.split_whitespace().any(|own| own == tag))
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

    /// What it does all the time, as a step.
    pub fn base(&self) -> Step {
        Step {
            share: 1.0,
            morphs: self.morphs.clone(),
            turn: self.turn,
            push: self.push,
            raise: self.raise,
            hunch: self.hunch,
        }
    }

    /// Whether it beats to both sides of the middle (a shake) rather than going and coming back (a nod).
    pub fn swings(&self) -> bool {
        self.beats > 0.0 && self.steps.is_empty() && (self.turn.1 != 0.0 || self.turn.2 != 0.0)
    }

    fn check(&self) -> Result<(), String> {
        let all = || std::iter::once(self.base()).chain(self.steps.iter().cloned());
        if all().any(|step| step.morphs.values().any(|w| !(0.0..=1.0).contains(w))) {
            return Err(format!("{}: a morph's weight lies between 0 and 1", self.name));
        }
        let degrees = |s: &Step| [s.turn.0, s.turn.1, s.turn.2, s.push, s.raise.0, s.raise.1, s.hunch.0, s.hunch.1];
        if all().any(|s| !degrees(&s).iter().all(|d| d.abs() <= 90.0)) || !(0.0..=10.0).contains(&self.beats) {
            return Err(format!("{}: degrees lie within ±90, beats between 0 and 10", self.name));
        }
        if self.steps.iter().any(|s| !(0.01..=100.0).contains(&s.share)) || !(0.0..=1.0).contains(&self.firm) {
            return Err(format!("{}: shares lie between 0.01 and 100, `firm` between 0 and 1", self.name));
        }
        Ok(())
    }
}
