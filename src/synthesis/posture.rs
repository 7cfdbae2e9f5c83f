//! One hand's postures: shape and rotation, at keys and at the stops between them.

use super::anchor::Anchor;
use super::plan::{Instead, KeyPosture, Known, Planner};
use super::reach::{from_outside, natural_rotation, strain};
use super::side_of;
use super::site::{Asker, Meeting};
use crate::body::landmarks::ContactPoint;
use crate::diagnostics::Error;
use crate::motion::easing::slerp;
use crate::motion::pose::LocalPose;
use crate::motion::rotation::{angle_between, to_vector};
use crate::phonology::symmetry::Resolved;
use crate::phonology::{Configuration, Distance, Hand, HandPoint, Heading, Orientation, Place, Placement, Side, Sign};
use glam::{DQuat, DVec3};

/// From this angle on, both ways about are looked at: 140°.
const WIDE_TURN: f64 = 140.0 * std::f64::consts::PI / 180.0;

/// A wrist that lies so far behind what touches the skin is in the body, metres: then the wrist touches it.
const WRIST_INSIDE_M: f64 = 0.04;

/// One hand's part of a description.
#[derive(Debug, Clone, Copy)]
pub(super) struct Part<'s> {
    pub sign: &'s Sign,
    pub hand: Hand,
    /// Its tiers, with what follows from a symmetry.
    pub said: &'s Resolved,
    /// What counts instead of a place on the other hand.
    pub instead: Option<Instead>,
}

impl Part<'_> {
    /// The configuration that a key has where nothing became another one.
    pub fn configuration(&self, key: usize) -> Configuration {
        self.said.configuration.at(key).cloned().unwrap_or_else(|| Configuration::named("rest"))
    }
}

/// What a key says of where the hand is.
#[derive(Debug, Clone)]
pub(super) struct Site {
    /// Where the hand's point is placed.
    pub anchor: Option<Anchor>,
    /// The point of the hand, where the key places one.
    pub with: Option<ContactPoint>,
    /// Whether the description names that point.
    pub named: bool,
    /// How the hand is turned, where the place itself says so: a hand that points.
    pub turned: Option<DQuat>,
    /// Whether the hands meet there.
    pub meeting: Meeting,
}

/// What a posture is made of.
pub(super) struct Said<'s> {
    pub configuration: &'s Configuration,
    /// The orientation in force.
    pub orientation: Orientation,
    /// Whether it is stated here, rather than kept.
    pub turns: bool,
    /// How the hand is turned, where the place itself says so.
    pub turned: Option<DQuat>,
    /// The point of the hand that is placed, and where, model space, as far as that is known.
    pub with: &'s ContactPoint,
    pub place: Option<DVec3>,
    /// Out of the skin that is touched.
    pub outward: Option<DVec3>,
}

/// What a hand has to reach in a posture: where its shoulder is, where its contact point should be (model space), and
/// where that point is in the hand, from the wrist; metres.
struct Reach {
    shoulder: DVec3,
    point: DVec3,
    offset: DVec3,
    /// Out of the skin that is touched.
    outward: Option<DVec3>,
}

impl Planner<'_> {
    /// What a key says of where a hand is, as far as its placement says it.
    pub(super) fn site(&self, part: Part, key: usize, known: &mut Known) -> Result<Site, Error> {
        let Part { sign, hand, said, .. } = part;
        let side = side_of(hand);
        let meeting = if sign.contact.stated(key).is_some() { Meeting::Meets } else { Meeting::Apart };
        let asker = Asker::of(part, meeting);
        let mut site = Site { anchor: None, with: None, named: false, turned: None, meeting };
        let Some(placement) = said.placement.stated(key) else { return Ok(site) };
        if let Place::Towards(target) = &placement.place {
            let target = Placement { place: (**target).clone(), ..placement.clone() };
            let target = Asker { meeting: Meeting::Meets, ..asker }.position(self, &target, known)?;
            let palm = said.orientation.at(key).and_then(|o| o.palm).map(|h| h.vector());
            let aim = self.aim(side, &self.shaped(side, &part.configuration(key), sign)?, target, palm);
            site.with = Some(self.signer.landmarks.hand_point(side, HandPoint::WRIST)?);
            site.anchor = Some(Anchor::Fixed(aim.wrist));
            site.turned = Some(aim.rotation);
            return Ok(site);
        }
        site.anchor = Some(self.anchor(placement, asker, known)?);
        site.named = placement.with.is_some();
        site.with = Some(match placement.with {
            Some(point) => self.signer.landmarks.hand_point(side, point)?,
            None => {
                let touching = Touching::of(self.touches(placement));
                let own = self.own_point(&part.configuration(key), sign, side, touching)?;
                match self.turns_away(&own, part, key, placement)? {
                    true => self.signer.landmarks.hand_point(side, HandPoint::WRIST)?,
                    false => own,
                }
            }
        });
        Ok(site)
    }

    /// Whether a hand that touches the body there with a point would be in the body: its fingers point away from the skin.
    fn turns_away(&self, own: &ContactPoint, part: Part, key: usize, placement: &Placement) -> Result<bool, Error> {
        let side = side_of(part.hand);
        let Some(outward) = self.outward(placement, side).filter(|_| placement.distance == Distance::Touch) else {
            return Ok(false);
        };
        let said = part.said.orientation.at(key).and_then(|o| o.fingers.zip(o.palm));
        let rotation =
            |(fingers, palm): (Heading, Heading)| self.signer.arm(side).hand_rotation(fingers.vector(), palm.vector());
        let Some(rotation) = said.and_then(rotation) else { return Ok(false) };
        let shaped = self.shaped(side, &part.configuration(key), part.sign)?;
        Ok((rotation * self.signer.in_hand(side, own, &shaped)).dot(outward) > WRIST_INSIDE_M)
    }

    /// The hand of a side with the fingers of a configuration, everything else at rest.
    fn shaped(&self, side: Side, configuration: &Configuration, sign: &Sign) -> Result<LocalPose, Error> {
        let angles = self.grammar.angles(configuration, sign)?;
        let mut shaped = LocalPose::rest(&self.signer.skeleton);
        self.signer.hand(side).apply(&angles, &mut shaped);
        Ok(shaped)
    }

    /// A posture; `before` is the one that it comes from.
    pub(super) fn posture(
        &self,
        part: Part,
        said: &Said,
        before: Option<&KeyPosture>,
    ) -> Result<(KeyPosture, Option<DQuat>), Error> {
        let side = side_of(part.hand);
        let angles = self.grammar.angles(said.configuration, part.sign)?;
        let shoulder = self.neutral.position(self.signer.arm(side).upper);
        let mut shaped = LocalPose::rest(&self.signer.skeleton);
        self.signer.hand(side).apply(&angles, &mut shaped);
        let reach = Reach {
            shoulder,
            point: said.place.unwrap_or(shoulder + DVec3::new(0.0, -0.1, 0.35)),
            offset: self.signer.in_hand(side, said.with, &shaped),
            outward: said.outward,
        };
        let rotation = match (said.turned, before) {
            (Some(turned), _) => turned,
            (None, Some(b)) if !said.turns => b.rotation,
            (None, before) => self.rotation(side, &said.orientation, &reach, before.map(|b| b.rotation)),
        };
        let via = before.and_then(|b| self.via(side, b.rotation, rotation, &reach));
        Ok((KeyPosture { angles, rotation, along_path: said.orientation.along_path }, via))
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
    pub(super) fn own_point(
        &self,
        shape: &Configuration,
        sign: &Sign,
        side: Side,
        touching: Touching,
    ) -> Result<ContactPoint, Error> {
        let point = match touching {
            Touching::Skin => self.grammar.touches_with(shape, sign)?,
            Touching::Nothing => HandPoint::PALM,
        };
        self.signer.landmarks.hand_point(side, point)
    }
}

/// Whether a hand is at a skin, so that what touches it matters.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Touching {
    Skin,
    Nothing,
}

impl Touching {
    pub(super) fn of(touches: bool) -> Touching {
        if touches { Touching::Skin } else { Touching::Nothing }
    }
}

impl Asker<'_> {
    /// Where a placement is while the body stands neutral, model space, metres.
    fn position(self, planner: &Planner, placement: &Placement, known: &mut Known) -> Result<DVec3, Error> {
        Ok(planner.anchor(placement, self, known)?.position(planner.neutral))
    }
}
