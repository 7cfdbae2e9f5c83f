//! One hand's part of a sign, made concrete: postures, the points that touch, legs with anchors at both ends.

use super::anchor::Anchor;
use super::leg::{Leg, done_at};
use super::posture::Part;
use super::walk::Walk;
use super::{Grammar, side_of};
use crate::body::landmarks::ContactPoint;
use crate::body::signer::Signer;
use crate::diagnostics::Error;
use crate::motion::easing::{Easing, slerp};
use crate::motion::pose::ModelPose;
use crate::phonology::handshape::HandAngles;
use crate::phonology::symmetry::{acts, resolve};
use crate::phonology::{Hand, Hands, Side, Sign};
use glam::{DQuat, DVec3};
use std::collections::BTreeMap;

/// A hand's shape and rotation.
#[derive(Debug, Clone)]
pub struct KeyPosture {
    /// Joint angles of the fingers.
    pub angles: HandAngles,
    /// The hand's rotation, model space.
    pub rotation: DQuat,
    /// Turning with the path.
    pub along_path: bool,
}

/// A part of a change between two of a list, postures or points of the hand.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Change {
    /// Number in the list.
    pub from: usize,
    /// Number in the list.
    pub to: usize,
    /// How much of the change is done at the leg's start and at its end, 0 to 1.
    pub share: (f64, f64),
}

impl Change {
    /// No change.
    pub fn none(at: usize) -> Change {
        Change { from: at, to: at, share: (0.0, 0.0) }
    }

    /// How much is done at a share of the leg's time.
    pub fn done(&self, time: f64, easing: Easing) -> f64 {
        done_at(self.share, time, easing)
    }
}

/// A leg with where it starts and ends.
#[derive(Debug, Clone)]
pub struct PlacedLeg {
    /// The leg.
    pub leg: Leg,
    /// The interval it belongs to.
    pub interval: usize,
    /// Where it starts.
    pub from: Anchor,
    /// Where it ends.
    pub to: Anchor,
    /// The postures that it leads from and to, of [`HandPlan::postures`].
    pub posture: Change,
    /// Where the hand turns through on its way, where the turn is so wide that the short way about is not the bodily one.
    pub via: Option<DQuat>,
    /// The points of the hand that are placed, of [`HandPlan::points`].
    pub with: Change,
    /// What is touched half way: where, and with which point.
    pub brush: Option<(Anchor, usize)>,
    /// Whether it takes the other hand's motion along.
    pub hold: Riding,
}

/// Whether a hand that is on the other one goes where that one goes.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Riding {
    /// It stays on it.
    Rides,
    /// Both move away from where they met: its way starts there, and is its own.
    LetsGo,
}

/// One hand's part of a sign.
#[derive(Debug, Clone)]
pub struct HandPlan {
    /// Which side of the body.
    pub side: Side,
    /// The postures: at the N + 1 keys, and in between.
    pub postures: Vec<KeyPosture>,
    /// The points of the hand that are placed.
    pub points: Vec<ContactPoint>,
    /// The legs, in order; none for a sign without intervals.
    pub legs: Vec<PlacedLeg>,
    /// Where it is when there is no leg.
    pub start: Anchor,
    /// Whether its places depend on the other hand.
    pub on_other_hand: bool,
    /// Whether the description says nothing of its orientation.
    pub free_hand: bool,
    /// Whether it touches the body or the other hand.
    pub touching: bool,
    /// The wrist's own way, where the hand is placed by its wrist as in the paper: in relocated signs.
    pub wrist_path: Option<WristPath>,
}

impl HandPlan {
    /// Moves the whole stroke by a vector of model space, metres.
    pub fn shift(&mut self, by: DVec3) {
        self.start = self.start.clone().moved(by);
        for leg in &mut self.legs {
            leg.from = leg.from.clone().moved(by);
            leg.to = leg.to.clone().moved(by);
            if let Some((anchor, _)) = &mut leg.brush {
                *anchor = anchor.clone().moved(by);
            }
        }
        if let Some(path) = &mut self.wrist_path {
            path.places.iter_mut().for_each(|place| *place += by);
        }
    }
}

/// The way of a wrist through a stroke, sampled evenly over the stroke's time; as many places as rotations, at least one.
#[derive(Debug, Clone, PartialEq)]
pub struct WristPath {
    /// Where the wrist is, model space, metres.
    pub places: Vec<DVec3>,
    /// How the hand is turned, model space.
    pub rotations: Vec<DQuat>,
}

impl WristPath {
    /// Place and rotation at a share of the stroke's time.
    pub fn at(&self, share: f64) -> (DVec3, DQuat) {
        let last = self.places.len() - 1;
        let at = share.clamp(0.0, 1.0) * last as f64;
        let (i, w) = ((at.floor() as usize).min(last), at.fract());
        let j = (i + 1).min(last);
        (self.places[i].lerp(self.places[j], w), slerp(self.rotations[i], self.rotations[j], w))
    }
}

/// What is found out about a sign while its hands are planned.
#[derive(Debug, Clone, Default)]
pub struct Known {
    /// Places that movements gave a name to.
    pub referents: BTreeMap<String, Anchor>,
    /// Sentences for the author.
    pub warnings: Vec<String>,
}

impl Known {
    /// Warns, once.
    pub(super) fn warn(&mut self, warning: String) {
        if !self.warnings.contains(&warning) {
            self.warnings.push(warning);
        }
    }
}

/// What plans are made with.
pub struct Planner<'a> {
    /// The inventories.
    pub grammar: &'a Grammar,
    /// The body.
    pub signer: &'a Signer,
    /// The signer standing neutral, model space.
    pub neutral: &'a ModelPose,
}

impl Planner<'_> {
    /// The plans of the acting hands, the one that the other depends on first.
    ///
    /// # Errors
    /// Unknown names.
    pub fn plan(&self, sign: &Sign, known: &mut Known) -> Result<Vec<HandPlan>, Error> {
        let before = known.clone();
        let mut plans = self.plan_with(sign, known, None)?;
        if plans.iter().filter(|p| p.on_other_hand).count() > 1 {
            // Each is placed on the other: the weak one is where it would be without the strong one.
            *known = before;
            let keeps = match sign.hands {
                Hands::Both(Some(_)) => Instead::Middle,
                Hands::Both(None) | Hands::Strong | Hands::Weak => {
                    known.warn("each hand is placed on the other; the weak hand keeps its own place".to_owned());
                    Instead::OwnPlace
                }
            };
            plans = self.plan_with(sign, known, Some(keeps))?;
        }
        plans.sort_by_key(|p| p.on_other_hand);
        same_times(&mut plans, sign.intervals);
        bound(&mut plans, known);
        if let Some(stated) = sign.duration {
            let whole: f64 = plans.first().map_or(0.0, |p| p.legs.iter().map(|l| l.leg.duration).sum());
            if whole > 0.0 && stated.0.is_finite() {
                stretch(&mut plans, stated.0.clamp(0.01, LONGEST_STATED) / whole);
            }
        }
        Ok(plans)
    }

    fn plan_with(&self, sign: &Sign, known: &mut Known, weak: Option<Instead>) -> Result<Vec<HandPlan>, Error> {
        let hands: Vec<Hand> = Hand::BOTH.into_iter().filter(|h| acts(sign, *h)).collect();
        let said: Vec<_> = hands.iter().map(|hand| resolve(sign, *hand)).collect();
        let mut walks = Vec::with_capacity(hands.len());
        for (hand, said) in hands.iter().zip(&said) {
            let instead = weak.filter(|_| *hand == Hand::Weak);
            let part = Part { sign, hand: *hand, said, instead };
            walks.push(self.walk(part, known).map_err(|e| named(e, *hand))?);
        }
        self.begin_apart(&mut walks);
        self.meet(&mut walks, 0, known)?;
        for interval in 0..sign.intervals {
            self.step(&mut walks, interval, known)?;
        }
        let moving: Vec<Vec<bool>> = walks.iter().map(Walk::moving).collect();
        let mut plans = Vec::with_capacity(walks.len());
        for (n, mut walk) in walks.into_iter().enumerate() {
            if let Some(other) = moving.get(1 - n.min(1)).filter(|_| moving.len() == 2) {
                self.let_go(&mut walk, other);
            }
            let hand = walk.part.hand;
            plans.push(self.postures(walk).map_err(|e| named(e, hand))?);
        }
        Ok(plans)
    }
}

/// Where a weak hand is that is said to be on a strong hand that is on it.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Instead {
    /// In the middle, where both meet.
    Middle,
    /// In its own half of the neutral space.
    OwnPlace,
}

fn named(error: Error, hand: Hand) -> Error {
    error.context(match side_of(hand) {
        Side::Right => "the strong hand",
        Side::Left => "the weak hand",
    })
}

/// Gives every interval the same time in both hands: that of the slower one.
fn same_times(plans: &mut [HandPlan], intervals: usize) {
    let time = |plan: &HandPlan, i: usize| -> f64 {
        plan.legs.iter().filter(|l| l.interval == i).map(|l| l.leg.duration).sum()
    };
    for i in 0..intervals {
        let longest = plans.iter().map(|p| time(p, i)).fold(0.0, f64::max);
        for plan in plans.iter_mut() {
            let own = time(plan, i);
            if own > 0.0 {
                plan.legs.iter_mut().filter(|l| l.interval == i).for_each(|l| l.leg.duration *= longest / own);
            }
        }
    }
}

/// No stroke lasts longer, seconds, whatever repeats how often.
const LONGEST: f64 = 120.0;
/// No stroke lasts longer, seconds, although its author says so.
const LONGEST_STATED: f64 = 1200.0;

/// Brings a stroke without end to an end.
fn bound(plans: &mut [HandPlan], known: &mut Known) {
    let whole: f64 = plans.first().map_or(0.0, |p| p.legs.iter().map(|l| l.leg.duration).sum());
    if whole > LONGEST {
        stretch(plans, LONGEST / whole);
        known.warn(format!("the movement would last {whole:.0} s; it is made in {LONGEST:.0} s"));
    }
}

/// Makes every leg longer or shorter.
pub fn stretch(plans: &mut [HandPlan], factor: f64) {
    plans.iter_mut().flat_map(|p| &mut p.legs).for_each(|l| l.leg.duration *= factor);
}
