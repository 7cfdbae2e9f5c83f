//! One hand's part of a sign, made concrete: postures at keys, legs in intervals, anchors at both ends of each.

use super::anchor::Anchor;
use super::legs::{Leg, LegEnd, change, lay_out};
use super::reach::{from_outside, natural_rotation, strain};
use super::{Grammar, side_of};
use crate::body::landmarks::ContactPoint;
use crate::body::signer::Signer;
use crate::diagnostics::Error;
use crate::motion::easing::slerp;
use crate::motion::pose::{LocalPose, ModelPose};
use crate::motion::rotation::{angle_between, to_vector};
use crate::phonology::handshape::HandAngles;
use crate::phonology::symmetry::{Resolved, acts, points, resolve};
use crate::phonology::{Configuration, ContactKind, Hand, HandPart, HandPoint, Hands, Orientation, Side, Sign};
use glam::{DQuat, DVec3};

/// Points that are `close` to each other on two hands, arm lengths apart.
const HANDS_CLOSE_ARMS: f64 = 0.06;

/// From this angle on, both ways about are looked at: 140°.
const WIDE_TURN: f64 = 140.0 * std::f64::consts::PI / 180.0;

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

/// What a hand has to reach at a key: where its shoulder is, where its contact point should be (model space), and where
/// that point is in the hand, from the wrist; metres.
struct Reach {
    shoulder: DVec3,
    point: DVec3,
    offset: DVec3,
    /// Out of the skin that is touched.
    outward: Option<DVec3>,
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
        let mut keys: Vec<KeyPosture> = Vec::with_capacity(sign.intervals + 1);
        let mut on_other_hand = false;
        for key in 0..=sign.intervals {
            let before = keys.last();
            let posture = self
                .posture(sign, hand, &said, key, before, &mut on_other_hand)
                .map_err(|e| e.context(format_args!("key {} of the {}", key + 1, name_of(hand))))?;
            keys.push(posture);
        }
        let intervals = self.laid_out(sign, &said);
        let start = match going_back(&intervals, &keys, 0) {
            Some(start) => start,
            None => self.default_place(sign, side)?,
        };
        let legs = self.legs(sign, hand, &intervals, &keys, &start, &mut on_other_hand)?;
        // A hand that touches the body comes from outside; elsewhere it may follow the forearm.
        let touching = said.placement.iter().any(|(_, p)| self.outward(p, side).is_some());
        let free_hand = said.orientation.is_empty() && !touching;
        Ok(HandPlan { side, keys, legs, start, on_other_hand, free_hand })
    }

    fn posture(
        &self,
        sign: &Sign,
        hand: Hand,
        said: &Resolved,
        key: usize,
        before: Option<&KeyPosture>,
        on_other_hand: &mut bool,
    ) -> Result<KeyPosture, Error> {
        let side = side_of(hand);
        let unsaid = Configuration::named("rest");
        let configuration = said.configuration.at(key).unwrap_or(&unsaid);
        let angles = self.grammar.angles(configuration, sign)?;
        let stated = said.placement.stated(key);
        let contact = sign.contact.stated(key).copied();
        let mut anchor = match stated {
            Some(p) => Some(self.anchor(p, sign, side, contact.is_some(), on_other_hand)?),
            None => None,
        };
        let touching = stated.is_some_and(|p| self.touches(p));
        let mut with = match stated.and_then(|p| p.with) {
            Some(point) => Some(self.signer.landmarks.hand_point(side, point)?),
            None if stated.is_some() || before.is_none() => {
                Some(self.own_point(configuration, sign, side, touching)?)
            }
            None => None,
        };
        if let Some(contact) = contact {
            let (own, other) = points(&contact, hand);
            with = Some(self.signer.landmarks.hand_point(side, own)?);
            let apart = match contact.kind {
                ContactKind::Touch | ContactKind::Crossed | ContactKind::Interlocked => 0.0,
                ContactKind::Close => HANDS_CLOSE_ARMS * self.signer.landmarks.arm_length(),
                ContactKind::Metres(metres) => metres,
            };
            if matches!(sign.hands, Hands::Both(Some(_))) {
                // Both hands come to the middle.
                let middle = match anchor {
                    Some(a) => a,
                    None => self.default_place(sign, side)?,
                };
                anchor = Some(middle.moved(DVec3::X * side.sign() * apart / 2.0));
            } else if hand == Hand::Strong {
                *on_other_hand = true;
                let point = self.signer.landmarks.hand_point(side.other(), other)?;
                anchor = Some(Anchor::over_contact(&point, apart));
            }
        }
        let with = with.or_else(|| before.map(|b| b.with.clone()));
        let with = with.map_or_else(|| self.own_point(configuration, sign, side, touching), Ok)?;
        let orientation = said.orientation.at(key).copied().unwrap_or_default();
        let place = anchor.as_ref().map(|a| a.position(self.neutral));
        let shoulder = self.neutral.position(self.signer.arm(side).upper);
        let mut shaped = LocalPose::rest(&self.signer.skeleton);
        self.signer.hand(side).apply(&angles, &mut shaped);
        let reach = Reach {
            shoulder,
            point: place.unwrap_or(shoulder + DVec3::new(0.0, -0.1, 0.35)),
            offset: self.signer.in_hand(side, &with, &shaped),
            outward: stated.and_then(|p| self.outward(p, side)),
        };
        let rotation = match before {
            Some(b) if said.orientation.stated(key).is_none() => b.rotation,
            _ => self.rotation(side, &orientation, &reach, before.map(|b| b.rotation)),
        };
        let via = before.and_then(|b| self.via(side, b.rotation, rotation, &reach));
        Ok(KeyPosture { angles, rotation, via, along_path: orientation.along_path, with, anchor })
    }

    /// The hand's rotation at a key. What is not stated stays as it was, or is what strains the wrist least.
    fn rotation(&self, side: Side, said: &Orientation, reach: &Reach, before: Option<DQuat>) -> DQuat {
        let arm = self.signer.arm(side);
        let (fingers, palm) = (said.fingers.map(|h| h.vector()), said.palm.map(|h| h.vector()));
        if let (Some(f), Some(p)) = (fingers, palm)
            && let Some(rotation) = arm.hand_rotation(f, p)
        {
            return rotation;
        }
        if let Some(before) = before {
            let (f, p) = arm.fingers_and_palm(before);
            let kept = arm.hand_rotation(fingers.unwrap_or(f), palm.unwrap_or(p));
            if let Some(rotation) = kept {
                return rotation;
            }
        }
        match (fingers, palm, reach.outward) {
            (None, None, Some(outward)) => from_outside(arm, reach.shoulder, reach.point, reach.offset, outward),
            _ => natural_rotation(arm, reach.shoulder, reach.point, reach.offset, fingers, palm),
        }
    }

    /// The middle of a wide turn: of the two ways about the same axis the one that strains the wrist less.
    fn via(&self, side: Side, from: DQuat, to: DQuat, reach: &Reach) -> Option<DQuat> {
        if angle_between(from, to) < WIDE_TURN {
            return None;
        }
        let arm = self.signer.arm(side);
        let short = slerp(from, to, 0.5);
        // The same turn the other way round has its middle half a turn away.
        let axis = to_vector(to * from.inverse()).try_normalize()?;
        let long = DQuat::from_axis_angle(axis, std::f64::consts::PI) * short;
        let strained = |q: DQuat| strain(arm, reach.shoulder, reach.point, reach.offset, q);
        (strained(long) < strained(short)).then_some(long)
    }

    /// The point that a hand places when none is named: what its shape touches with, or its palm in space.
    fn own_point(&self, shape: &Configuration, sign: &Sign, side: Side, touching: bool) -> Result<ContactPoint, Error> {
        let palm = HandPoint::new(Default::default(), HandPart::Palm, None);
        let point = if touching { Some(self.grammar.touches_with(shape, sign)?) } else { palm };
        let point = point.ok_or_else(|| Error::new("a palm has no digits"))?;
        self.signer.landmarks.hand_point(side, point)
    }

    /// The legs of each interval.
    fn laid_out(&self, sign: &Sign, said: &Resolved) -> Vec<Vec<Leg>> {
        let table = &self.grammar.movements;
        let reflected = |mut leg: Leg| {
            leg.path = leg.path.reflected(said.signs);
            leg.end = leg.end.reflected(said.signs);
            leg
        };
        let of = |interval| match said.movement.get(interval) {
            Some(movement) => lay_out(movement, table, said.turns).into_iter().map(reflected).collect(),
            None => vec![change(table.timing.change)],
        };
        (0..sign.intervals).map(of).collect()
    }

    fn legs(
        &self,
        sign: &Sign,
        hand: Hand,
        intervals: &[Vec<Leg>],
        keys: &[KeyPosture],
        start: &Anchor,
        on_other_hand: &mut bool,
    ) -> Result<Vec<PlacedLeg>, Error> {
        let side = side_of(hand);
        let mut placed: Vec<PlacedLeg> = Vec::new();
        // Where the hand is at each key that it has come to.
        let mut been = vec![start.clone()];
        let mut at = start.clone();
        for (interval, legs) in intervals.iter().enumerate() {
            let first = placed.len();
            for leg in legs {
                let from = at;
                let stated = keys[interval + 1].anchor.as_ref().filter(|_| leg.posture.1 >= 1.0);
                let displaced = || from.clone().moved(leg.path.end());
                let (end, by) = match &leg.end {
                    LegEnd::Off(end, by) => (&**end, *by),
                    end => (end, DVec3::ZERO),
                };
                let to = match (end, stated) {
                    (LegEnd::At(placement), _) => self.anchor(placement, sign, side, false, on_other_hand)?,
                    (LegEnd::StartOf(n), _) => placed[first + n].from.clone(),
                    (LegEnd::AtKey(key), _) => been.get(*key).cloned().unwrap_or_else(displaced),
                    (LegEnd::Displaced, Some(anchor)) => anchor.clone(),
                    (LegEnd::NextKey, _) => going_back(intervals, keys, interval + 1).unwrap_or_else(displaced),
                    (LegEnd::Displaced | LegEnd::Off(..), _) => displaced(),
                };
                let to = to.moved(by);
                at = to.clone();
                placed.push(PlacedLeg { leg: leg.clone(), interval, from, to });
            }
            been.push(at.clone());
        }
        Ok(placed)
    }
}

/// Where a hand is at a key: as the key says, else going back along the movements from the next key that says it;
/// `None` where none does, or a movement between has no way of its own.
fn going_back(intervals: &[Vec<Leg>], keys: &[KeyPosture], key: usize) -> Option<Anchor> {
    let mut way = DVec3::ZERO;
    for at in key..keys.len() {
        if let Some(anchor) = &keys[at].anchor {
            return Some(anchor.clone().moved(-way));
        }
        for leg in intervals.get(at)? {
            if leg.end != LegEnd::Displaced {
                return None;
            }
            way += leg.path.end();
        }
    }
    None
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
