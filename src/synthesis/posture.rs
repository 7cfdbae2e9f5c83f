//! One hand's posture at each key: shape, rotation, and the point of the hand that is placed.

use super::anchor::Anchor;
use super::plan::{KeyPosture, Planner};
use super::reach::{from_outside, natural_rotation, strain};
use super::side_of;
use crate::body::landmarks::ContactPoint;
use crate::diagnostics::Error;
use crate::motion::easing::slerp;
use crate::motion::pose::LocalPose;
use crate::motion::rotation::{angle_between, to_vector};
use crate::phonology::symmetry::{Resolved, points, resolve};
use crate::phonology::{
    Configuration, ContactKind, Hand, HandPart, HandPoint, Hands, Orientation, Place, Placement, Side, Sign,
};
use glam::{DQuat, DVec3};

/// Points that are `close` to each other on two hands, arm lengths apart.
const HANDS_CLOSE_ARMS: f64 = 0.06;

/// From this angle on, both ways about are looked at: 140°.
const WIDE_TURN: f64 = 140.0 * std::f64::consts::PI / 180.0;

/// One hand's part of a description.
#[derive(Debug, Clone, Copy)]
pub(super) struct Part<'s> {
    pub sign: &'s Sign,
    pub hand: Hand,
    /// Its tiers, with what follows from a symmetry.
    pub said: &'s Resolved,
}

/// What a key says of where the hand is.
#[derive(Debug, Clone, Default)]
pub(super) struct Site {
    /// Where the hand's point is placed.
    pub anchor: Option<Anchor>,
    /// The point of the hand, where the key places one.
    pub with: Option<ContactPoint>,
    /// How the hand is turned, where the place itself says so: a hand that points.
    turned: Option<DQuat>,
}

impl Site {
    /// Whether the place itself says how the hand is turned.
    pub(super) fn is_turned(&self) -> bool {
        self.turned.is_some()
    }
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

impl Planner<'_> {
    /// What a key says of where a hand is.
    pub(super) fn site(&self, part: Part, key: usize, on_other_hand: &mut bool) -> Result<Site, Error> {
        let Part { sign, hand, said } = part;
        let side = side_of(hand);
        let contact = sign.contact.stated(key).copied();
        let mut site = match said.placement.stated(key) {
            None => Site::default(),
            Some(placement) => match &placement.place {
                Place::Towards(target) => {
                    let target = Placement { place: (**target).clone(), ..placement.clone() };
                    let target = self.anchor(&target, sign, side, true, on_other_hand)?.position(self.neutral);
                    let palm = said.orientation.at(key).and_then(|o| o.palm).map(|h| h.vector());
                    let aim = self.aim(side, &self.shaped(side, said, key, sign)?, target, palm);
                    let wrist = HandPoint::new(Default::default(), HandPart::Wrist, None);
                    let wrist = wrist.ok_or_else(|| Error::new("a wrist has no digits"))?;
                    let with = self.signer.landmarks.hand_point(side, wrist)?;
                    Site { anchor: Some(Anchor::Fixed(aim.wrist)), with: Some(with), turned: Some(aim.rotation) }
                }
                _ => {
                    let anchor = self.anchor(placement, sign, side, contact.is_some(), on_other_hand)?;
                    let with = match placement.with {
                        Some(point) => self.signer.landmarks.hand_point(side, point)?,
                        None => self.own_point(said.configuration.at(key), sign, side, self.touches(placement))?,
                    };
                    Site { anchor: Some(anchor), with: Some(with), turned: None }
                }
            },
        };
        if let Some(contact) = contact {
            let (own, other) = points(&contact, hand);
            site.with = Some(match own {
                Some(point) => self.signer.landmarks.hand_point(side, point)?,
                None => self.own_point(said.configuration.at(key), sign, side, true)?,
            });
            let apart = match contact.kind {
                ContactKind::Touch | ContactKind::Crossed | ContactKind::Interlocked => 0.0,
                ContactKind::Close => HANDS_CLOSE_ARMS * self.signer.landmarks.arm_length(),
                ContactKind::Metres(metres) => metres,
            };
            if matches!(sign.hands, Hands::Both(Some(_))) {
                // Both hands come to the middle.
                let middle = site.anchor.map_or_else(|| self.default_place(sign, side), Ok)?;
                site.anchor = Some(middle.moved(DVec3::X * side.sign() * apart / 2.0));
            } else if hand == Hand::Strong {
                *on_other_hand = true;
                let point = match other {
                    Some(point) => self.signer.landmarks.hand_point(side.other(), point)?,
                    None => {
                        let weak = resolve(sign, Hand::Weak);
                        self.own_point(weak.configuration.at(key), sign, side.other(), true)?
                    }
                };
                site.anchor = Some(Anchor::over_contact(&point, apart));
            }
        }
        Ok(site)
    }

    /// The hand of a side with the fingers that a key has, everything else at rest.
    fn shaped(&self, side: Side, said: &Resolved, key: usize, sign: &Sign) -> Result<LocalPose, Error> {
        let unsaid = Configuration::named("rest");
        let angles = self.grammar.angles(said.configuration.at(key).unwrap_or(&unsaid), sign)?;
        let mut shaped = LocalPose::rest(&self.signer.skeleton);
        self.signer.hand(side).apply(&angles, &mut shaped);
        Ok(shaped)
    }

    /// A hand's posture at a key. `place` is where its point is, as far as that is known.
    pub(super) fn posture(
        &self,
        part: Part,
        key: usize,
        before: Option<&KeyPosture>,
        site: &Site,
        place: Option<&Anchor>,
    ) -> Result<KeyPosture, Error> {
        let Part { sign, hand, said } = part;
        let side = side_of(hand);
        let unsaid = Configuration::named("rest");
        let configuration = said.configuration.at(key);
        let angles = self.grammar.angles(configuration.unwrap_or(&unsaid), sign)?;
        let with = site.with.clone().or_else(|| before.map(|b| b.with.clone()));
        let with = with.map_or_else(|| self.own_point(configuration, sign, side, false), Ok)?;
        let orientation = said.orientation.at(key).copied().unwrap_or_default();
        let shoulder = self.neutral.position(self.signer.arm(side).upper);
        let shaped = self.shaped(side, said, key, sign)?;
        let place = place.map(|a| a.position(self.neutral));
        let reach = Reach {
            shoulder,
            point: place.unwrap_or(shoulder + DVec3::new(0.0, -0.1, 0.35)),
            offset: self.signer.in_hand(side, &with, &shaped),
            outward: said.placement.stated(key).and_then(|p| self.outward(p, side)),
        };
        let rotation = match (site.turned, before) {
            (Some(turned), _) => turned,
            (None, Some(b)) if said.orientation.stated(key).is_none() => b.rotation,
            (None, before) => self.rotation(side, &orientation, &reach, before.map(|b| b.rotation)),
        };
        let via = before.and_then(|b| self.via(side, b.rotation, rotation, &reach));
        let anchor = site.anchor.clone();
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
    fn own_point(
        &self,
        shape: Option<&Configuration>,
        sign: &Sign,
        side: Side,
        touching: bool,
    ) -> Result<ContactPoint, Error> {
        let unsaid = Configuration::named("rest");
        let shape = shape.unwrap_or(&unsaid);
        let palm = HandPoint::new(Default::default(), HandPart::Palm, None);
        let point = if touching { Some(self.grammar.touches_with(shape, sign)?) } else { palm };
        let point = point.ok_or_else(|| Error::new("a palm has no digits"))?;
        self.signer.landmarks.hand_point(side, point)
    }
}
