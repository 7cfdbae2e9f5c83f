//! Where a hand is at an instant of the stroke: point, rotation, fingers.

use super::leg::Leg;
use super::plan::{Change, HandPlan, PlacedLeg};
use crate::body::landmarks::ContactPoint;
use crate::motion::easing::{Easing, slerp, smoothstep};
use crate::motion::pose::ModelPose;
use crate::phonology::WristMotion;
use glam::{DQuat, DVec3};
use std::f64::consts::TAU;

/// A hand at an instant of the stroke.
#[derive(Debug, Clone, Copy)]
pub struct Instant {
    /// The leg, if there is one.
    pub leg: Option<usize>,
    /// The share of the leg's time.
    pub share: f64,
    /// How much of the leg's change of posture is done, 0 to 1.
    pub done: f64,
    /// How much of the change from one point of the hand to another is done, 0 to 1.
    pub with_done: f64,
}

/// The instant of a hand `time` seconds after the stroke's start, at the description's own speed.
pub fn instant(plan: &HandPlan, time: f64, easing: Easing) -> Instant {
    let mut left = time.max(0.0);
    for (i, placed) in plan.legs.iter().enumerate() {
        let last = i + 1 == plan.legs.len();
        if left < placed.leg.duration || last {
            let share = (left / placed.leg.duration.max(1e-9)).clamp(0.0, 1.0);
            let (done, with_done) = (placed.posture.done(share, easing), placed.with.done(share, easing));
            return Instant { leg: Some(i), share, done, with_done };
        }
        left -= placed.leg.duration;
    }
    Instant { leg: None, share: 0.0, done: 0.0, with_done: 0.0 }
}

impl Instant {
    /// The leg under way and the share of its time.
    pub fn leg<'a>(&self, plan: &'a HandPlan) -> Option<(&'a PlacedLeg, f64)> {
        self.leg.map(|i| (&plan.legs[i], self.share))
    }

    /// The change of posture under way, of `postures`.
    pub fn change(&self, plan: &HandPlan) -> Change {
        self.leg(plan).map_or(Change::none(0), |(placed, _)| placed.posture)
    }

    /// Where the contact point should be, given the body in model space.
    pub fn point(&self, plan: &HandPlan, model: &ModelPose) -> DVec3 {
        match self.leg(plan) {
            None => plan.start.position(model),
            Some((placed, share)) => brushed(placed, share, model),
        }
    }

    /// Where the contact point is in the hand, given where each point of the plan is.
    pub fn offset(&self, plan: &HandPlan, of: impl Fn(&ContactPoint) -> DVec3) -> DVec3 {
        let Some((placed, share)) = self.leg(plan) else { return of(&plan.points[0]) };
        let Change { from, to, .. } = placed.with;
        let (a, b) = (&plan.points[from], &plan.points[to]);
        let own = if from == to { of(a) } else { of(a).lerp(of(b), self.with_done.clamp(0.0, 1.0)) };
        match &placed.brush {
            Some((_, with)) if *with != from || *with != to => own.lerp(of(&plan.points[*with]), bell(share)),
            Some(_) | None => own,
        }
    }

    /// The hand's rotation, without the wrist's play.
    pub fn rotation(&self, plan: &HandPlan, model: &ModelPose) -> DQuat {
        let Change { from, to, .. } = self.change(plan);
        let (a, b) = (&plan.postures[from], &plan.postures[to]);
        let via = self.leg(plan).and_then(|(placed, _)| placed.via);
        let turned = match self.done {
            d if d <= 0.0 => a.rotation,
            d if d >= 1.0 => b.rotation,
            // Eased already: the posture's share follows the easing.
            d => match via {
                None => slerp(a.rotation, b.rotation, d),
                Some(via) if d < 0.5 => slerp(a.rotation, via, 2.0 * d),
                Some(via) => slerp(via, b.rotation, 2.0 * d - 1.0),
            },
        };
        if !a.along_path {
            return turned;
        }
        let Some((placed, share)) = self.leg(plan) else { return turned };
        let way = |s: f64| {
            let (s0, s1) = ((s - 0.02).max(0.0), (s + 0.02).min(1.0));
            point_of(placed, s1, model) - point_of(placed, s0, model)
        };
        crate::motion::rotation::shortest_arc(way(0.02), way(share), DVec3::Y) * turned
    }

    /// The wrist's play on top, in the hand's own axes; `out` is +1 for the left hand and −1 for the right.
    pub fn play(&self, plan: &HandPlan) -> DQuat {
        let Some((placed, share)) = self.leg(plan) else { return DQuat::IDENTITY };
        let out = plan.side.sign();
        // A turn about the forearm is its own mirror image: both hands begin outward, palm up.
        let (flexion, radial, along) = (-DVec3::Z * out, -DVec3::Y * out, -DVec3::X);
        let mut play = DQuat::IDENTITY;
        for w in &placed.leg.wrist {
            let share = w.part.0 + (w.part.1 - w.part.0) * share;
            let phase = TAU * (share * w.cycles + w.phase);
            let level = w.amplitude * soft(share);
            let turn = |axis: DVec3, wave: f64| DQuat::from_axis_angle(axis, level * wave);
            play *= match w.motion {
                WristMotion::Nod => turn(flexion, phase.sin()),
                WristMotion::Swing => turn(radial, phase.sin()),
                WristMotion::Twist => turn(along, phase.sin()),
                WristMotion::StirClockwise => turn(flexion, phase.sin()) * turn(radial, phase.cos() * out),
                WristMotion::StirCounterclockwise => turn(flexion, phase.sin()) * turn(radial, -phase.cos() * out),
            };
        }
        play
    }

    /// How much each finger (index to little finger) is bent on top at its knuckle, radians.
    pub fn wiggle(&self, plan: &HandPlan) -> Option<[f64; 4]> {
        let (placed, share) = self.leg(plan)?;
        if placed.leg.wiggle.is_empty() {
            return None;
        }
        let mut bends = [0.0; 4];
        for w in &placed.leg.wiggle {
            let share = w.part.0 + (w.part.1 - w.part.0) * share;
            for (i, digit) in crate::phonology::Digit::FINGERS.into_iter().enumerate() {
                if w.digits.contains(digit) {
                    let phase = TAU * (share * w.cycles - 0.25 * i as f64);
                    bends[i] += w.amplitude * soft(share) * (1.0 - phase.cos()) / 2.0;
                }
            }
        }
        Some(bends)
    }
}

/// A point on a leg's way, drawn to what it brushes half way, model space.
fn brushed(placed: &PlacedLeg, share: f64, model: &ModelPose) -> DVec3 {
    let own = point_of(placed, share, model);
    match &placed.brush {
        None => own,
        Some((anchor, _)) => own + (anchor.position(model) - point_of(placed, 0.5, model)) * bell(share),
    }
}

/// 1 half way, nothing at both ends, and level there.
fn bell(share: f64) -> f64 {
    smoothstep(2.0 * share.min(1.0 - share))
}

/// A point on a leg's way, model space.
fn point_of(placed: &PlacedLeg, share: f64, model: &ModelPose) -> DVec3 {
    let PlacedLeg { leg, from, to, .. } = placed;
    let (from, to) = (from.position(model), to.position(model));
    let chord = to - from;
    let scale = bent(leg, chord);
    // What the path itself does not lead to is made up along the way.
    let rest = chord - leg.path.end() * scale;
    from + leg.path.at(share) * scale + rest * Easing::MinimumJerk.weight(share)
}

/// The scale of an arc whose end is a place: its bend goes with its true chord.
fn bent(leg: &Leg, chord: DVec3) -> f64 {
    match &leg.path {
        super::path::Path::Arc { chord: said, .. } if said.length() > 1e-6 => chord.length() / said.length(),
        _ => 1.0,
    }
}

/// Rises and falls within a sixth of the time at each end.
fn soft(share: f64) -> f64 {
    smoothstep(6.0 * share.min(1.0 - share))
}
