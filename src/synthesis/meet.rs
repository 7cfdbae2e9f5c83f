//! Where two hands meet, and with which points.
//!
//! Hands of a symmetry both come to the middle of where they would be; else one goes to the other: the strong one,
//! unless the weak one is said to be on it, or is the only one that acts. A hand that does not act is touched where it
//! hangs.

use super::anchor::Anchor;
use super::plan::{Known, Planner};
use super::posture::{Part, Site};
use super::shape::within;
use super::side_of;
use super::site::{Asker, Meeting};
use super::walk::Walk;
use crate::body::landmarks::ContactPoint;
use crate::diagnostics::Error;
use crate::phonology::symmetry::points;
use crate::phonology::{Contact, ContactKind, Digit, Hand, HandPoint, Hands, Side};
use glam::DVec3;

/// Points that are `close` to each other on two hands, arm lengths apart.
const HANDS_CLOSE_ARMS: f64 = 0.06;
/// The palms of hands that are close to each other without a word of which points, arm lengths apart: side by side before
/// the body.
const HANDS_BESIDE_ARMS: f64 = 0.38;
/// How much farther from the other hand one stays that goes over to it.
const FARTHER: f64 = 2.2;
/// Places nearer to each other are the same, metres.
const SAME_PLACE_M: f64 = 1e-6;
/// How far from the knuckle the fingers of interlocked hands cross, as a part of the first phalanx.
const WEB: f64 = 0.45;

impl Planner<'_> {
    /// A site with what a contact at its key says of this hand.
    pub(super) fn met(&self, part: Part, key: usize, mut site: Site, known: &mut Known) -> Result<Site, Error> {
        let Some(contact) = part.sign.contact.stated(key) else { return Ok(site) };
        site.with = Some(self.meeting_point(part, contact, key)?);
        site.named = true;
        // Where nothing says a place before, the way begins so that it ends where the hands meet.
        let unsaid = site.anchor.is_none() && part.said.placement.iter().all(|(stated, _)| stated > key);
        match part.sign.hands {
            Hands::Both(Some(_)) => {
                let middle = match site.anchor.take() {
                    Some(anchor) => Some(anchor),
                    None if unsaid => Some(self.default_place(Asker::of(part, Meeting::Meets), known)?),
                    None => None,
                };
                site.anchor = middle.map(|middle| middle.moved(self.aside(contact, side_of(part.hand))));
            }
            Hands::Both(None) if part.hand == Hand::Weak => {}
            Hands::Both(None) | Hands::Strong | Hands::Weak => {
                if unsaid {
                    site.anchor = Some(self.over_other(part, contact, key)?);
                }
            }
        }
        Ok(site)
    }

    /// Says where the hands are at a key at which they meet; their walks have come as far as they would without it.
    pub(super) fn meet(&self, walks: &mut [Walk], key: usize, known: &mut Known) -> Result<(), Error> {
        let Some(contact) = walks.first().and_then(|w| w.part.sign.contact.stated(key)).copied() else { return Ok(()) };
        let site = |walk: &Walk| walk.sites[key].anchor.clone();
        match walks {
            [walk] => {
                let anchor = self.over_other(walk.part, &contact, key)?;
                self.come(walk, key, anchor);
            }
            [strong, weak] if matches!(strong.part.sign.hands, Hands::Both(Some(_))) => {
                let there = |walk: &Walk| site(walk).unwrap_or_else(|| walk.at.clone());
                let (a, b) = (there(strong), there(weak));
                let (to_a, to_b) = (self.aside(&contact, strong.side), self.aside(&contact, weak.side));
                let apart = (a.position(self.neutral) - to_a).distance(b.position(self.neutral) - to_b);
                if apart < SAME_PLACE_M {
                    // Both come to the same middle as it is.
                    self.come(strong, key, a);
                    self.come(weak, key, b);
                } else {
                    let middle = Anchor::Middle(vec![a, b]);
                    self.come(strong, key, middle.clone().moved(to_a));
                    self.come(weak, key, middle.moved(to_b));
                }
            }
            [strong, weak] => {
                let on_strong = self.signer.arm(strong.side).clavicle;
                let weak_comes = site(weak).is_some_and(|a| a.rides_on(on_strong, &self.signer.skeleton));
                if weak_comes {
                    let anchor = self.over_other(weak.part, &contact, key)?;
                    self.come(weak, key, anchor);
                    return Ok(());
                }
                // A weak hand of which no place is said is where the strong one is said to be.
                let placement = strong.part.said.placement.stated(key);
                if key == 0
                    && weak.part.said.placement.is_empty()
                    && let Some(placement) = placement
                    && !matches!(placement.place, crate::phonology::Place::OtherHand(_))
                {
                    let place = self.anchor(placement, Asker::of(strong.part, Meeting::Meets), known)?;
                    self.come(weak, key, place);
                }
                let anchor = self.over_other(strong.part, &contact, key)?;
                self.come(strong, key, anchor);
            }
            _ => {}
        }
        Ok(())
    }

    /// A hand is at a place at a key.
    fn come(&self, walk: &mut Walk, key: usize, anchor: Anchor) {
        if key == 0 {
            walk.starts_at(anchor.clone());
            if let Some(point) = walk.sites[0].with.clone() {
                walk.starts_with(point);
            }
        }
        walk.sites[key].anchor = Some(anchor);
    }

    /// Where a hand is whose contact is with the other one, wherever that is.
    fn over_other(&self, part: Part, contact: &Contact, key: usize) -> Result<Anchor, Error> {
        let other = Part { hand: part.hand.other(), ..part };
        let point = self.meeting_point(other, contact, key)?;
        // A hand that goes over to the other stays farther off than two that come to one middle.
        let named = contact.strong.is_some() || contact.weak.is_some();
        let farther = if contact.kind == ContactKind::Close && named { FARTHER } else { 1.0 };
        Ok(Anchor::over_contact(&point, farther * self.apart(contact)))
    }

    /// Where a leg ends that leads the hands together within an interval: the strong hand goes to the weak one, which
    /// comes to the middle where it follows the strong one.
    pub(super) fn meeting_end(
        &self,
        walk: &Walk,
        contact: &Contact,
        displaced: Anchor,
        key: usize,
    ) -> Result<Anchor, Error> {
        match (walk.part.sign.hands, walk.part.hand) {
            (Hands::Both(Some(_)), Hand::Weak) => {
                let aside = displaced.position(self.neutral).x;
                let apart = self.apart(contact) / 2.0 * walk.side.sign();
                Ok(displaced.moved(DVec3::X * (apart - aside)))
            }
            (Hands::Both(None), Hand::Weak) => Ok(displaced),
            (Hands::Both(_) | Hands::Strong, Hand::Strong) | (Hands::Strong | Hands::Weak, _) => {
                self.over_other(walk.part, contact, key)
            }
        }
    }

    /// How far apart the points are, metres.
    fn apart(&self, contact: &Contact) -> f64 {
        match contact.kind {
            ContactKind::Touch | ContactKind::Crossed | ContactKind::Interlocked => 0.0,
            ContactKind::Close if contact.strong.is_none() && contact.weak.is_none() => {
                HANDS_BESIDE_ARMS * self.signer.landmarks.arm_length()
            }
            ContactKind::Close => HANDS_CLOSE_ARMS * self.signer.landmarks.arm_length(),
            ContactKind::Metres(metres) => within(metres, 0.0, 3.0, 0.0),
        }
    }

    /// From the middle to a hand's own point.
    fn aside(&self, contact: &Contact, side: Side) -> DVec3 {
        DVec3::X * side.sign() * self.apart(contact) / 2.0
    }

    /// The point of a hand that meets the other one.
    pub(super) fn meeting_point(&self, part: Part, contact: &Contact, key: usize) -> Result<ContactPoint, Error> {
        let side = side_of(part.hand);
        let (own, _) = points(contact, part.hand);
        let landmarks = &self.signer.landmarks;
        let point = match (own, contact.kind) {
            (Some(point), _) => landmarks.hand_point(side, point)?,
            (None, ContactKind::Interlocked) => self.webs(side),
            (None, ContactKind::Crossed) => {
                // The strong hand lies on the weak one.
                let lies = if part.hand == Hand::Strong { HandPoint::PALM } else { HandPoint::BACK };
                landmarks.hand_point(side, lies)?
            }
            (None, ContactKind::Close) => landmarks.hand_point(side, HandPoint::PALM)?,
            (None, ContactKind::Touch | ContactKind::Metres(_)) => {
                let point = self.open_point(part.sign, part.hand, key)?;
                landmarks.hand_point(side, point)?
            }
        };
        Ok(match contact.kind {
            ContactKind::Interlocked => point.moved(self.beside_fingers(part.hand)),
            ContactKind::Touch | ContactKind::Close | ContactKind::Crossed | ContactKind::Metres(_) => point,
        })
    }

    /// The middle of the roots of the four fingers.
    fn webs(&self, side: Side) -> ContactPoint {
        let skeleton = &self.signer.skeleton;
        let parts = Digit::FINGERS.map(|digit| {
            let joint = self.signer.hand(side).of_digit(digit)[0];
            let bone = skeleton[joint].tail_model - skeleton[joint].rest_model;
            crate::body::landmarks::Landmark { joint, offset: bone * WEB, normal: -DVec3::Y }
        });
        ContactPoint::of(parts.to_vec())
    }

    /// Half of half the way from one finger to the next, to one side for each hand: so the fingers of one come between
    /// those of the other. In the hand's rest axes, metres.
    fn beside_fingers(&self, hand: Hand) -> DVec3 {
        let skeleton = &self.signer.skeleton;
        let root = |digit| skeleton[self.signer.hand(side_of(hand)).of_digit(digit)[0]].rest_model;
        let step = root(Digit::Index).distance(root(Digit::Middle));
        DVec3::Z * step / 4.0 * if hand == Hand::Strong { 1.0 } else { -1.0 }
    }
}
