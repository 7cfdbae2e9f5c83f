//! How far the joints of a hand go: American Academy of Orthopaedic Surgeons and hand-model literature,
//! as collected in facts/phonology.md §1.
//!
//! Departs from the collection in one number: the little finger may close by 10° toward the ring finger,
//! because our zero is fingers in parallel, in which a real little finger already stands away.

use super::angles::{FingerAngles, HandAngles, ThumbAngles};
use std::f64::consts::PI;

/// The range of one joint angle, radians.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Limits {
    /// Least.
    pub least: f64,
    /// Greatest.
    pub greatest: f64,
}

impl Limits {
    const fn degrees(least: f64, greatest: f64) -> Limits {
        Limits { least: least * PI / 180.0, greatest: greatest * PI / 180.0 }
    }

    /// The nearest angle inside.
    pub fn clamp(self, angle: f64) -> f64 {
        angle.clamp(self.least, self.greatest)
    }

    /// Whether the angle lies inside, with a thousandth of a degree to spare for rounding.
    pub fn holds(self, angle: f64) -> bool {
        (angle - self.clamp(angle)).abs() < 2e-5
    }
}

/// The ranges of a finger.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct FingerLimits {
    /// Knuckle.
    pub mcp: Limits,
    /// Abduction of the stretched finger; see [`FingerLimits::abduction_at`].
    pub abduction: Limits,
    /// Middle joint.
    pub pip: Limits,
    /// Last joint.
    pub dip: Limits,
}

impl FingerLimits {
    /// Abduction at a flexion of the knuckle: the ligaments tighten, so that a share 1 − cos(MCP) is lost;
    /// 5° of passive play remain.
    pub fn abduction_at(&self, mcp: f64) -> Limits {
        let share = mcp.cos().max(0.0);
        let play = 5.0 * PI / 180.0;
        let least = (self.abduction.least * share).min(-play);
        Limits { least, greatest: (self.abduction.greatest * share).max(play) }
    }

    fn clamp(&self, f: &FingerAngles) -> FingerAngles {
        let mcp = self.mcp.clamp(f.mcp);
        let abduction = self.abduction_at(mcp).clamp(f.abduction);
        FingerAngles { mcp, abduction, pip: self.pip.clamp(f.pip), dip: self.dip.clamp(f.dip) }
    }
}

/// The ranges of a hand.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HandLimits {
    /// Index, middle, ring and little finger.
    pub fingers: [FingerLimits; 4],
    /// The thumb's radial abduction.
    pub radial: Limits,
    /// The thumb's palmar abduction.
    pub palmar: Limits,
    /// The thumb's pronation.
    pub pronation: Limits,
    /// The thumb's knuckle.
    pub thumb_mcp: Limits,
    /// The thumb's last joint.
    pub thumb_ip: Limits,
}

const fn finger(least_abduction: f64, greatest_abduction: f64) -> FingerLimits {
    FingerLimits {
        mcp: Limits::degrees(-20.0, 100.0),
        abduction: Limits::degrees(least_abduction, greatest_abduction),
        pip: Limits::degrees(0.0, 115.0),
        dip: Limits::degrees(-5.0, 90.0),
    }
}

impl HandLimits {
    /// A healthy hand.
    pub const ANATOMICAL: HandLimits = HandLimits {
        fingers: [finger(-20.0, 20.0), finger(-15.0, 15.0), finger(-20.0, 20.0), finger(-10.0, 30.0)],
        radial: Limits::degrees(-25.0, 60.0),
        palmar: Limits::degrees(0.0, 70.0),
        pronation: Limits::degrees(0.0, 90.0),
        thumb_mcp: Limits::degrees(-10.0, 65.0),
        thumb_ip: Limits::degrees(-15.0, 80.0),
    };

    /// The difference of neighbouring knuckles' flexion that is comfortable; beyond it the tendons pull. Soft.
    pub const COMFORTABLE_NEIGHBOURS: f64 = 50.0 * PI / 180.0;

    /// Every angle brought inside.
    pub fn clamp(&self, hand: &HandAngles) -> HandAngles {
        let t = &hand.thumb;
        HandAngles {
            fingers: std::array::from_fn(|i| self.fingers[i].clamp(&hand.fingers[i])),
            thumb: ThumbAngles {
                radial: self.radial.clamp(t.radial),
                palmar: self.palmar.clamp(t.palmar),
                pronation: self.pronation.clamp(t.pronation),
                mcp: self.thumb_mcp.clamp(t.mcp),
                ip: self.thumb_ip.clamp(t.ip),
            },
        }
    }

    /// Whether every angle lies inside (a thousandth of a degree to spare).
    pub fn hold(&self, hand: &HandAngles) -> bool {
        hand.max_difference(&self.clamp(hand)) < 2e-5
    }

    /// How far neighbouring knuckles differ beyond what is comfortable, the sum over neighbours, radians.
    pub fn discomfort(&self, hand: &HandAngles) -> f64 {
        let pairs = hand.fingers.windows(2).map(|w| (w[0].mcp - w[1].mcp).abs());
        pairs.map(|d| (d - HandLimits::COMFORTABLE_NEIGHBOURS).max(0.0)).sum()
    }
}
