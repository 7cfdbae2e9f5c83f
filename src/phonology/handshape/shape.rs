//! One handshape of the inventory: names, features, angles.

use super::angles::HandAngles;
use super::written::Written;
use crate::phonology::{Digit, Digits, HandPoint, ThumbPosition};
use serde::Deserialize;

/// A handshape.
#[derive(Debug, Clone, PartialEq)]
pub struct Handshape {
    /// The name in text.
    pub id: String,
    /// Other names; letters of alphabets with the language in front (`LSF S`).
    pub aliases: Vec<String>,
    /// HamNoSys symbols, by the names of its tokens.
    pub hamnosys: Vec<String>,
    /// What they mean, where they are one class.
    pub(super) written: Option<Written>,
    /// The base symbol of the International SignWriting Alphabet, hexadecimal, perhaps with a remark.
    pub iswa: String,
    /// The digits that carry the distinction; changes without digits apply to their fingers.
    pub selected: Digits,
    /// The point of the hand that touches a place, where the sign does not say.
    pub touches_with: HandPoint,
    /// Named flexion of index, middle, ring and little finger; empty where the row gives numbers.
    pub flexion: [String; 4],
    /// Spread of the stretched fingers, radians, before a bent finger loses its share.
    pub spread: [f64; 4],
    /// The first finger crosses in front (palmar) of the second.
    pub crossing: Option<(Digit, Digit)>,
    /// What the thumb does.
    pub thumb: ThumbGoal,
    /// Angles from the table, made on a generic hand; abduction as it stands.
    pub table: HandAngles,
    /// Angles found on the avatar's mesh.
    pub solved: Option<Solved>,
    /// A remark.
    pub note: String,
}

/// The result of the solver for one handshape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Solved {
    /// The angles.
    pub angles: HandAngles,
    /// How far the named contact (or gap) is missed on the mesh, millimetres; 0 where the thumb stands free.
    pub residual_mm: f64,
}

/// What the thumb does in a handshape.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum ThumbGoal {
    /// It stands free.
    Posture(ThumbStance),
    /// A part of it touches a place on some fingers.
    Touch(ThumbPart, Digits, ThumbTarget),
    /// Its tip stands between two fingers.
    Between(Digit, Digit),
    /// Its pad faces the pads of some fingers at a distance in millimetres. A soft goal.
    Gap(Digits, u32),
}

/// How a free thumb stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
pub enum ThumbStance {
    /// Away from the hand.
    Out,
    /// Along the index.
    Along,
    /// Across the palm.
    Across,
    /// Facing the fingers.
    Opposed,
    /// At rest.
    Relaxed,
}

/// A part of the thumb that touches.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
pub enum ThumbPart {
    /// The soft side of the last phalanx.
    Pad,
    /// The end.
    Tip,
    /// The last joint, on the side of the index.
    Joint,
    /// The side of the last phalanx that looks to the fingers.
    Side,
}

/// A place on fingers that the thumb touches.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Deserialize)]
pub enum ThumbTarget {
    /// Back of the middle phalanx.
    MiddleBack,
    /// Palm's side of the middle phalanx.
    MiddleFront,
    /// The pad.
    Pad,
    /// The nail.
    Nail,
    /// The end.
    Tip,
    /// The first phalanx, on the thumb's side.
    ProximalRadial,
    /// The palm below the knuckle.
    Palm,
}

impl Handshape {
    /// The angles to show: solved on the avatar where the solver has run, else the table's.
    pub fn angles(&self) -> HandAngles {
        self.solved.map_or(self.table, |s| s.angles)
    }

    /// Whether a named contact is demanded of the thumb (a gap or a free posture is none).
    pub fn has_contact(&self) -> bool {
        matches!(self.thumb, ThumbGoal::Touch(..) | ThumbGoal::Between(..))
    }

    /// How the thumb would be described by a change, where it stands free, across or along.
    pub fn thumb_position(&self) -> Option<ThumbPosition> {
        if self.written.is_some_and(|w| w.thumb == ThumbPosition::Enclosed) {
            return Some(ThumbPosition::Enclosed);
        }
        match self.thumb {
            ThumbGoal::Posture(ThumbStance::Out) => Some(ThumbPosition::Out),
            ThumbGoal::Posture(ThumbStance::Along) => Some(ThumbPosition::Along),
            ThumbGoal::Posture(ThumbStance::Across) => Some(ThumbPosition::Across),
            ThumbGoal::Posture(ThumbStance::Opposed) => Some(ThumbPosition::Opposed),
            ThumbGoal::Touch(ThumbPart::Pad, _, ThumbTarget::MiddleBack) => Some(ThumbPosition::Across),
            ThumbGoal::Touch(ThumbPart::Tip, _, ThumbTarget::Palm) => Some(ThumbPosition::Across),
            ThumbGoal::Touch(ThumbPart::Joint, _, ThumbTarget::ProximalRadial) => Some(ThumbPosition::Along),
            ThumbGoal::Posture(ThumbStance::Relaxed)
            | ThumbGoal::Touch(..)
            | ThumbGoal::Between(..)
            | ThumbGoal::Gap(..) => None,
        }
    }

    /// The two fingers that the thumb stands between, as HamNoSys writes it; the nearer to the thumb first.
    pub fn thumb_between(&self) -> Option<(Digit, Digit)> {
        self.written.and_then(|w| w.between)
    }
}
