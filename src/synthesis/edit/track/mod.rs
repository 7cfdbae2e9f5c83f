//! Operators on a track: the motion, with the tiers that say what it is carried along.
//!
//! The phase tiers tell stroke and hold from preparation and retraction, so an operator changes the sign alone and the
//! ways from and to the neutral pose are made again, eased in joint space (Naert et al. 2021, §4.2).
//!
//! # Conventions
//! A track has one sign. Both hands share one stroke: from the earlier beginning to the later end, so they stay together.
//! Non-manual channels (trunk, head, eyes, face) stay as they are in time. Each changed value says so in its source.
//!
//! # What they refuse
//! Tracks without a phase tier, or with several signs. Contacts with a head or trunk that moves are not solved again.

mod arms;
mod channels;
mod time;

pub(in crate::synthesis) use arms::in_order;
pub use arms::{mirrored, on_each_hand, reflected, swapped};
pub use channels::{Relocated, relocated_by, relocated_to, with_configuration};
pub use time::{at_speed, inverted, repeated};

use super::Sides;
use super::extent::Extent;
use crate::body::channel::Channels;
use crate::body::signer::Signer;
use crate::diagnostics::Error;
use crate::motion::clip::{Clip, Frame};
use crate::motion::easing::Easing;
use crate::motion::short_arc::ShortArc;
use crate::motion::skeleton::JointId;
use crate::phonology::Side;
use crate::tier::{Tier, TierValue};
use crate::time::{FrameIndex, Seconds};
use crate::track::Track;

/// When the one sign of a track is what, and which hands act in it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Phases {
    /// The hands that have a phase tier.
    pub sides: Sides,
    /// Preparation begins.
    pub start: Seconds,
    /// The stroke begins.
    pub stroke: Seconds,
    /// The stroke ends, and the hold begins.
    pub stroke_end: Seconds,
    /// The hold, and with it the sign, ends.
    pub sign_end: Seconds,
    /// Retraction ends.
    pub retracted: Seconds,
}

impl Phases {
    /// Reads the phases of a track's sign from its `RH Phase` and `LH Phase` tiers.
    ///
    /// # Errors
    /// No phase tier, one without stroke and hold, or more than one sign.
    ///
    /// ```
    /// # use chereme::synthesis::{Grammar, Options, edit, synthesize};
    /// # let signer = chereme::avatar::signer().unwrap();
    /// # let sign = chereme::notation::read("sign X\n movement up\n", &chereme::notation::Vocabulary::builtin(), "lsf");
    /// let made = synthesize(&sign.signs[0].sign, &Grammar::builtin(), &signer, &Options::default()).unwrap();
    /// let phases = edit::track::Phases::of(&made.track).unwrap();
    /// assert_eq!((phases.stroke, phases.sign_end), (made.report.stroke_start, made.report.sign_end));
    /// ```
    pub fn of(track: &Track) -> Result<Phases, Error> {
        let tier = |side: Side| track.tier(&format!("{} Phase", side.hand()));
        let sides = match (tier(Side::Right), tier(Side::Left)) {
            (Some(_), Some(_)) => Sides::Both,
            (Some(_), None) => Sides::Right,
            (None, Some(_)) => Sides::Left,
            (None, None) => return Err(Error::new("the track has no phase tier that tells stroke from transition")),
        };
        let values = || sides.each().iter().filter_map(|s| tier(*s)).flat_map(|t| t.values());
        let glosses = |side: Side| track.tier(&format!("{} Gloss", side.hand())).map_or(0, |t| t.values().len());
        if sides.each().iter().any(|s| glosses(*s) > 1) {
            return Err(Error::new("the track has several signs: edit them one by one"));
        }
        let named = |names: &'static [&str]| values().filter(move |v| names.contains(&v.label.as_str()));
        let first = |names| named(names).map(|v| v.start.0).reduce(f64::min);
        let last = |names| named(names).map(|v| v.end.0).reduce(f64::max);
        let sign = first(&["stroke", "hold"]).zip(last(&["stroke", "hold"]));
        let (stroke, sign_end) = sign.ok_or_else(|| Error::new("the phase tiers have neither stroke nor hold"))?;
        Ok(Phases {
            sides,
            start: Seconds(first(&["preparation"]).unwrap_or(stroke)),
            stroke: Seconds(stroke),
            stroke_end: Seconds(last(&["stroke"]).unwrap_or(stroke)),
            sign_end: Seconds(sign_end),
            retracted: Seconds(last(&["retraction"]).unwrap_or(sign_end)),
        })
    }

    /// The sign as an extent: it comes with the preparation and goes with the retraction.
    pub fn extent(&self, easing: Easing) -> Extent {
        let extent = Extent::between(self.stroke, self.sign_end);
        Extent { easing, ..extent.eased(self.stroke - self.start, self.retracted - self.sign_end) }
    }

    /// The frames of the sign: from the first of the stroke to the last before `end`.
    fn frames(&self, clip: &Clip, end: Seconds) -> (usize, usize) {
        let last = clip.frames().len() - 1;
        let first = ((self.stroke.0 * clip.fps().get() - 1e-6).ceil().max(0.0) as usize).min(last);
        (first, ((end.0 * clip.fps().get() + 1e-6).floor().max(0.0) as usize).clamp(first, last))
    }
}

/// The side whose hand a tier belongs to.
fn side_of(tier: &Tier) -> Option<Side> {
    [Side::Right, Side::Left].into_iter().find(|side| tier.name.starts_with(&format!("{} ", side.hand())))
}

/// What a tier of a hand is about, such as `Phase`; the whole name for a tier of no hand.
fn about(tier: &Tier) -> &str {
    if side_of(tier).is_some() { &tier.name[3..] } else { &tier.name }
}

/// A tier under a name, with its values made anew.
fn remapped(tier: &Tier, name: String, values: impl IntoIterator<Item = TierValue>) -> Tier {
    let mut made = Tier::new(if name.is_empty() { tier.name.clone() } else { name });
    for v in values {
        made.push(v.start, v.end, v.label, v.source);
    }
    made
}

/// A value that says in its source what was done to it.
fn marked(value: &TierValue, done: &str) -> TierValue {
    TierValue { source: format!("{}, {done}", value.source), ..value.clone() }
}

/// The limbs' joints of the hands that act.
fn limbs(signer: &Signer, sides: Sides) -> Vec<JointId> {
    sides.each().iter().flat_map(|s| Channels::of(signer, *s).limb().collect::<Vec<_>>()).collect()
}

/// Makes the ways again: `joints` ease from where they are at `start` to frame `first`, and from `last` to where they
/// are at `retracted`. Frames outside stay.
fn rebuild_ways(
    clip: &Clip,
    frames: &mut [Frame],
    joints: &[JointId],
    (first, last): (usize, usize),
    (start, retracted): (Seconds, Seconds),
    easing: Easing,
) {
    let time = |i: usize| clip.fps().time_of(FrameIndex(i)).0;
    let still = |at: Seconds| {
        let nearest = (at.0 * clip.fps().get()).round().max(0.0) as usize;
        frames[nearest.min(frames.len() - 1)].pose.clone()
    };
    let (from, to) = (still(start), still(retracted));
    let (begun, ended) = (frames[first].pose.clone(), frames[last].pose.clone());
    for (i, frame) in frames.iter_mut().enumerate() {
        let (a, b, share) = if i < first && time(i) > start.0 {
            (&from, &begun, (time(i) - start.0) / (time(first) - start.0))
        } else if i > last && time(i) < retracted.0 {
            (&ended, &to, (time(i) - time(last)) / (retracted.0 - time(last)))
        } else {
            continue;
        };
        let weight = easing.weight(share);
        for joint in joints {
            let arc = ShortArc::new(a.rotation(*joint), b.rotation(*joint));
            frame.pose.set(*joint, arc.eased(easing, weight));
        }
    }
}
