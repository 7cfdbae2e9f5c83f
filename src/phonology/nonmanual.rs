//! Non-manual features: head, trunk, gaze and face.
//!
//! The values are names of the inventory (`grammar/nonmanuals.ron`); directions and mouthed words are kept as such.

use super::direction::Heading;
use super::placement::Placement;

/// A tier of non-manual values.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Channel {
    /// Nods, shakes, turns and tilts.
    Head,
    /// The trunk.
    Torso,
    /// The shoulders.
    Shoulders,
    /// Where the eyes look.
    Gaze,
    /// The eyebrows.
    Brows,
    /// The eyelids.
    Lids,
    /// The nose.
    Nose,
    /// The cheeks.
    Cheeks,
    /// Mouth gestures, mouth shapes and mouthed words.
    Mouth,
}

impl Channel {
    /// All of them, in the order they are written.
    pub const ALL: [Channel; 9] = [
        Channel::Head,
        Channel::Torso,
        Channel::Shoulders,
        Channel::Gaze,
        Channel::Brows,
        Channel::Lids,
        Channel::Nose,
        Channel::Cheeks,
        Channel::Mouth,
    ];

    /// The name of its tier in tracks and annotations: `Brows`.
    pub fn title(self) -> String {
        let name = self.name();
        format!("{}{}", name[..1].to_uppercase(), &name[1..])
    }

    /// The keyword in text.
    pub fn name(self) -> &'static str {
        match self {
            Channel::Head => "head",
            Channel::Torso => "torso",
            Channel::Shoulders => "shoulders",
            Channel::Gaze => "gaze",
            Channel::Brows => "brows",
            Channel::Lids => "lids",
            Channel::Nose => "nose",
            Channel::Cheeks => "cheeks",
            Channel::Mouth => "mouth",
        }
    }
}

/// One non-manual value.
#[derive(Debug, Clone, PartialEq)]
pub struct NonManual {
    /// What.
    pub value: NonManualValue,
    /// How much.
    pub amount: Amount,
    /// How fast it comes, beats and goes: its times are divided by it; 1 where nothing is said (SiGML `speed`).
    pub pace: f64,
}

impl NonManual {
    /// A value of which nothing more is said.
    pub fn plain(value: NonManualValue) -> NonManual {
        NonManual { value, amount: Amount::Plain, pace: 1.0 }
    }
}

/// What a non-manual tier says.
#[derive(Debug, Clone, PartialEq)]
pub enum NonManualValue {
    /// A value of the inventory for that tier: `raised`, `puffed`, `nod`.
    Named(String),
    /// Turned or looking that way: `towards up-left`.
    Towards(Heading),
    /// Turned or looking at a place: `at other palm`.
    At(Placement),
    /// A word mouthed, in SAMPA: `mouthing "ZuR"`.
    Mouthing(String),
    /// One after the other, in the time of the whole: `(puffed then mouthing "ba")`.
    Sequence(Vec<NonManual>),
    /// At the same time: `(nod while tilted-left)`.
    Together(Vec<NonManual>),
}

/// How much of a value.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Amount {
    /// Half.
    Slight,
    /// As the inventory says.
    #[default]
    Plain,
    /// Half as much again, as far as the face goes.
    Strong,
    /// A percentage, from 1 to 300; 50, 100 and 150 are the three above.
    Percent(u16),
}

impl Amount {
    /// The amount of a factor: a named one where there is one.
    pub fn of(factor: f64) -> Amount {
        match (factor * 100.0).round().clamp(1.0, 300.0) as u16 {
            50 => Amount::Slight,
            100 => Amount::Plain,
            150 => Amount::Strong,
            percent => Amount::Percent(percent),
        }
    }

    /// The factor by which the inventory's value is multiplied.
    pub fn factor(self) -> f64 {
        match self {
            Amount::Slight => 0.5,
            Amount::Plain => 1.0,
            Amount::Strong => 1.5,
            Amount::Percent(percent) => f64::from(percent) / 100.0,
        }
    }
}
