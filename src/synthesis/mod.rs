//! From a described sign to motion, channel by channel (Naert et al. 2021, §3–6; docs/DESIGN.md, "Synthesis").
//!
//! Placement is the path of the hand's contact point, solved by FABRIK; orientation the hand's rotation within the
//! wrist's limits; configuration the fingers; non-manuals face, head, trunk and eyes. Preparation and retraction
//! are eased in joint space between the neutral pose and the stroke.
//!
//! # Conventions
//! Model space, metres, seconds from the clip's start. The signer is right-handed: the strong hand is the right one.

pub mod anchor;
pub mod edit;
mod expression;
pub mod face;
mod fingers;
pub mod legs;
pub mod path;
mod path_of_hand;
pub mod plan;
pub mod reach;
mod site;
pub mod symmetry;
mod tiers;
mod timeline;
mod ways;
mod write;

use crate::body::arm::WristLimits;
use crate::body::signer::Signer;
use crate::diagnostics::Error;
use crate::motion::clip::Clip;
use crate::motion::easing::Easing;
use crate::phonology::expression::Expressions;
use crate::phonology::handshape::{HandAngles, HandshapeInventory};
use crate::phonology::location::LocationInventory;
use crate::phonology::movement_table::MovementTable;
use crate::phonology::{Configuration, Hand, HandPoint, Side, Sign};
use crate::time::{Fps, Seconds};
use crate::track::Track;

/// The inventories that synthesis looks names up in.
#[derive(Debug, Clone)]
pub struct Grammar {
    /// Hand configurations.
    pub handshapes: HandshapeInventory,
    /// Places.
    pub locations: LocationInventory,
    /// Sizes and times of movements.
    pub movements: MovementTable,
    /// Non-manual values.
    pub expressions: Expressions,
}

impl Grammar {
    /// The inventories that come with the program.
    pub fn builtin() -> Grammar {
        Grammar {
            handshapes: HandshapeInventory::builtin(),
            locations: LocationInventory::builtin(),
            movements: MovementTable::embedded(),
            expressions: Expressions::embedded(),
        }
    }

    /// The joint angles of a configuration of a sign.
    fn angles(&self, configuration: &Configuration, sign: &Sign) -> Result<HandAngles, Error> {
        self.handshapes.angles(configuration, language(sign)).map_err(|e| Error::new(e.to_string()))
    }

    /// The point with which a configuration of a sign touches where nothing else is said.
    fn touches_with(&self, configuration: &Configuration, sign: &Sign) -> Result<HandPoint, Error> {
        let shape = self.handshapes.find(&configuration.base, language(sign));
        shape.map(|s| s.touches_with).map_err(|e| Error::new(e.to_string()))
    }
}

/// Knobs of synthesis.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// Frames per second of the clip.
    pub fps: Fps,
    /// How configuration, orientation and transitions are eased.
    pub easing: Easing,
    /// 2 is twice as fast.
    pub speed: f64,
    /// The paper's own procedure where ours departs from it: the wrist is placed, not the contact point; no limits, no
    /// help from the clavicle.
    pub paper: bool,
}

impl Default for Options {
    fn default() -> Options {
        Options { fps: Fps::DEFAULT, easing: Easing::default(), speed: 1.0, paper: false }
    }
}

/// A synthesized sign and what there is to say about it.
#[derive(Debug, Clone)]
pub struct Performance {
    /// Motion and tiers.
    pub track: Track,
    /// Measures and warnings.
    pub report: Report,
}

/// What was measured while a sign was made.
#[derive(Debug, Clone, Default)]
pub struct Report {
    /// When the stroke begins, from the clip's start.
    pub stroke_start: Seconds,
    /// The instants of the sign's keys, from the clip's start.
    pub keys: Vec<Seconds>,
    /// When the sign (stroke and hold) ends.
    pub sign_end: Seconds,
    /// The greatest speed of a wrist, metres a second.
    pub wrist_speed: f64,
    /// The greatest distance of a contact point from its target during the stroke, metres.
    pub residual_m: f64,
    /// How far a hand was turned away from the stated orientation by the wrist's limits, at most, radians.
    pub tilt: f64,
    /// Sentences for the author.
    pub warnings: Vec<String>,
}

/// The language whose letters and aliases are looked up first.
fn language(sign: &Sign) -> Option<&str> {
    (!sign.language.is_empty()).then_some(sign.language.as_str())
}

/// The side of a hand of a right-handed signer.
pub fn side_of(hand: Hand) -> Side {
    match hand {
        Hand::Strong => Side::Right,
        Hand::Weak => Side::Left,
    }
}

/// Signs one sign: from the neutral pose, through preparation, stroke and hold, back to the neutral pose.
///
/// # Errors
/// Names that the inventories lack, hands that depend on each other, an impossible rate or speed; the message names
/// the sign, the hand and the key.
pub fn synthesize(sign: &Sign, grammar: &Grammar, signer: &Signer, options: &Options) -> Result<Performance, Error> {
    if !(options.speed.is_finite() && options.speed >= 0.05 && options.speed <= 20.0) {
        return Err(Error::new(format!("the speed {} does not lie between 0.05 and 20", options.speed)));
    }
    write::perform(sign, grammar, signer, options).map_err(|e| e.context(&sign.name))
}

/// The wrist's limits in force.
fn limits(options: &Options) -> Option<WristLimits> {
    (!options.paper).then_some(WristLimits::ANATOMICAL)
}

/// A clip from its frames.
fn clip(signer: &Signer, fps: Fps, frames: Vec<crate::motion::clip::Frame>) -> Result<Clip, Error> {
    Clip::new(signer.skeleton.clone(), fps, signer.morphs.clone(), frames)
        .ok_or_else(|| Error::new("the frames do not fit the rig"))
}
