//! From a described sign to motion, channel by channel (Naert et al. 2021, §3–6; docs/DESIGN.md, "Synthesis").
//!
//! Placement is the path of the hand's contact point, solved by FABRIK; orientation the hand's rotation within the
//! wrist's limits; configuration the fingers; non-manuals face, head, trunk and eyes. Preparation and retraction
//! are eased in joint space between the neutral pose and the stroke.
//!
//! # Conventions
//! Model space, metres, seconds from the clip's start. The signer is right-handed: the strong hand is the right one.

mod aim;
pub mod anchor;
pub mod captured;
mod clear;
pub mod edit;
mod expression;
pub mod face;
mod layout;
mod leg;
pub mod legs;
mod meet;
pub mod path;
mod path_of_hand;
mod perform;
mod phased;
mod placed;
pub mod plan;
mod posture;
mod prepare;
pub mod reach;
mod relocate;
mod repeat;
mod report;
pub mod schedule;
mod shape;
mod site;
mod smooth;
mod stage;
mod stroke;
mod tiers;
mod timeline;
mod together;
mod vary;
pub mod verify;
mod walk;
mod ways;

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
use crate::score::plan::Plan;
use crate::time::Fps;
use crate::track::Track;
pub use report::Report;
use schedule::{Measured, Schedule};
use std::collections::BTreeMap;

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
    /// Hands that were captured, by the id of their handshape, and which frame of which recording they are: they stand in for the
    /// inventory's (Naert et al. 2021, §5).
    pub captured: BTreeMap<String, (HandAngles, String)>,
}

impl Grammar {
    /// The inventories that come with the program.
    pub fn builtin() -> Grammar {
        Grammar {
            handshapes: HandshapeInventory::builtin(),
            locations: LocationInventory::builtin(),
            movements: MovementTable::embedded(),
            expressions: Expressions::embedded(),
            captured: BTreeMap::new(),
        }
    }

    /// The captured hand of a configuration that is named and not changed.
    fn captured_hand(&self, configuration: &Configuration, language: Option<&str>) -> Option<&(HandAngles, String)> {
        let plain = configuration.changes.is_empty() && configuration.between.is_none() && !self.captured.is_empty();
        let shape = plain.then(|| self.handshapes.find(&configuration.base, language).ok()).flatten()?;
        self.captured.get(&shape.id)
    }

    /// The joint angles of a configuration of a sign.
    fn angles(&self, configuration: &Configuration, sign: &Sign) -> Result<HandAngles, Error> {
        if let Some((angles, _)) = self.captured_hand(configuration, language(sign)) {
            return Ok(*angles);
        }
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
    /// How much performances differ from their descriptions and from each other: 0 not at all, 1 visibly; to 3.
    pub variation: f64,
    /// Which of the possible performances, where they differ.
    pub seed: u64,
}

impl Default for Options {
    fn default() -> Options {
        Options { fps: Fps::DEFAULT, easing: Easing::default(), speed: 1.0, paper: false, variation: 0.0, seed: 0 }
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
    synthesize_plan(&Plan::of(sign.clone()), grammar, signer, options)
}

/// Signs a plan from the neutral pose and back to it, without rest between its signs.
///
/// # Errors
/// Those of [`synthesize`]; the message names the gloss.
pub fn synthesize_plan(
    plan: &Plan,
    grammar: &Grammar,
    signer: &Signer,
    options: &Options,
) -> Result<Performance, Error> {
    perform::perform(plan, &perform::stage(grammar, signer, options)?)
}

/// How long the phases of a plan last: as they come when nothing presses, and at least.
///
/// The least times follow from the wrists' speed, and holds give way first: that of a sign that moves may vanish.
///
/// # Errors
/// Those of [`synthesize_plan`].
pub fn measure(plan: &Plan, grammar: &Grammar, signer: &Signer, options: &Options) -> Result<Measured, Error> {
    perform::measure(plan, &perform::stage(grammar, signer, options)?)
}

/// Signs a plan at times that were allotted from outside, such as those of a song; they are kept unchanged.
///
/// # Errors
/// Those of [`synthesize_plan`], and of [`Schedule::check`].
pub fn render(
    plan: &Plan,
    schedule: &Schedule,
    grammar: &Grammar,
    signer: &Signer,
    options: &Options,
) -> Result<Performance, Error> {
    perform::render(plan, schedule, &perform::stage(grammar, signer, options)?)
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
