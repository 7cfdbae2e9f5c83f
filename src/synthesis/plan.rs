//! One hand's part of a sign, made concrete: postures at keys, legs in intervals, anchors at both ends of each.

use super::anchor::Anchor;
use super::legs::Leg;
use super::placed::going_back;
use super::posture::{Part, Site};
use super::{Grammar, side_of};
use crate::body::landmarks::ContactPoint;
use crate::body::signer::Signer;
use crate::diagnostics::Error;
use crate::motion::easing::slerp;
use crate::motion::pose::ModelPose;
use crate::phonology::handshape::HandAngles;
use crate::phonology::symmetry::{acts, resolve};
use crate::phonology::{Hand, Side, Sign};
use glam::{DQuat, DVec3};

/// A hand's posture at one key.
#[derive(Debug, Clone)]
pub struct KeyPosture {
    /// Joint angles of the fingers.
    pub angles: HandAngles,
    /// The hand's rotation, model space.
    pub rotation: DQuat,
    /// Where the hand turns through on its way from the key before, where the turn is so wide that the short way
    /// about is not the bodily one.
    pub via: Option<DQuat>,
    /// Turning with the path.
    pub along_path: bool,
    /// The point of the hand that is placed.
    pub with: ContactPoint,
    /// Where it is placed, where the key says so.
    pub anchor: Option<Anchor>,
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
}

/// One hand's part of a sign.
#[derive(Debug, Clone)]
pub struct HandPlan {
    /// Which side of the body.
    pub side: Side,
    /// N + 1 postures.
    pub keys: Vec<KeyPosture>,
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
    /// Unknown names; hands that depend on each other; a sign in which no hand is left.
    pub fn plan(&self, sign: &Sign) -> Result<Vec<HandPlan>, Error> {
        let hands: Vec<Hand> = Hand::BOTH.into_iter().filter(|h| acts(sign, *h)).collect();
        let mut plans = hands.iter().map(|h| self.plan_hand(sign, *h)).collect::<Result<Vec<_>, _>>()?;
        if plans.iter().filter(|p| p.on_other_hand).count() > 1 {
            return Err(Error::new("each hand is placed on the other; say where one of them is"));
        }
        plans.sort_by_key(|p| p.on_other_hand);
        same_times(&mut plans, sign.intervals);
        if let Some(stated) = sign.duration {
            let whole: f64 = plans.first().map_or(0.0, |p| p.legs.iter().map(|l| l.leg.duration).sum());
            if whole > 0.0 {
                stretch(&mut plans, stated.0 / whole);
            }
        }
        Ok(plans)
    }

    fn plan_hand(&self, sign: &Sign, hand: Hand) -> Result<HandPlan, Error> {
        let said = resolve(sign, hand);
        let side = side_of(hand);
        let mut on_other_hand = false;
        let at_key = |key: usize| move |e: Error| e.context(format_args!("key {} of the {}", key + 1, name_of(hand)));
        let part = Part { sign, hand, said: &said };
        let mut sites = Vec::with_capacity(sign.intervals + 1);
        for key in 0..=sign.intervals {
            sites.push(self.site(part, key, &mut on_other_hand).map_err(at_key(key))?);
        }
        let intervals = self.intervals(sign, &said);
        let derived = going_back(&intervals, &sites, 0);
        if sites[0].with.is_none() && derived.is_some() {
            // Going back from a place that is said later, the hand goes with the same point.
            sites[0].with = sites.iter().find_map(|s| s.with.clone());
        }
        let start = derived.clone().map_or_else(|| self.default_place(sign, side), Ok)?;
        let mut keys: Vec<KeyPosture> = Vec::with_capacity(sites.len());
        for (key, site) in sites.iter().enumerate() {
            let place = site.anchor.as_ref().or(derived.as_ref().filter(|_| key == 0));
            let posture = self.posture(part, key, keys.last(), site, place).map_err(at_key(key))?;
            keys.push(posture);
        }
        let legs = self.legs(sign, hand, &intervals, &sites, &start, &mut on_other_hand)?;
        // A hand that touches the body comes from outside; elsewhere it may follow the forearm.
        let on_skin = said.placement.iter().any(|(_, p)| self.outward(p, side).is_some());
        let touching = on_skin || !sign.contact.is_empty();
        let free_hand = said.orientation.is_empty() && !on_skin && !sites.iter().any(Site::is_turned);
        Ok(HandPlan { side, keys, legs, start, on_other_hand, free_hand, touching, wrist_path: None })
    }
}

fn name_of(hand: Hand) -> &'static str {
    match hand {
        Hand::Strong => "strong hand",
        Hand::Weak => "weak hand",
    }
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

/// Makes every leg longer or shorter.
pub fn stretch(plans: &mut [HandPlan], factor: f64) {
    plans.iter_mut().flat_map(|p| &mut p.legs).for_each(|l| l.leg.duration *= factor);
}
