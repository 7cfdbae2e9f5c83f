//! What hands touch at the keys, measured between landmarks of the posed body.

use super::Checking;
use super::finding::{Finding, Kind};
use super::key::Key;
use crate::body::landmarks::ContactPoint;
use crate::phonology::operator::touches;
use crate::phonology::symmetry::resolve;
use crate::phonology::{
    Configuration, Contact, ContactKind, Distance, Hand, HandPoint, Keys, Lateral, Movement, Place, Placement, Side,
};
use glam::DVec3;

/// How far a contact point may be from its place, metres.
const OFF: f64 = 0.01;
/// A point of the hand that lies so much farther out than the wrist is no point to touch with, metres.
const AWAY: f64 = 0.03;
/// How far a measured distance may differ from what the report admits and still be the same, metres: the instant of a key lies between
/// two frames.
const SAME: f64 = 3e-3;

impl Checking<'_> {
    /// Contact points that are away from what the key says they touch.
    pub(super) fn contacts(&self, key: &Key) -> Vec<Finding> {
        // The whole sign is elsewhere than its tiers say.
        if key.phase.relocated.is_some() {
            return Vec::new();
        }
        let measured = match key.phase.contact.stated(key.number) {
            // Measured once, not from both sides.
            Some(contact) if key.hand == Hand::Strong => {
                self.between_hands(contact, key).map(|off| (off, "the other hand".to_owned()))
            }
            Some(_) => None,
            None => placement(key).and_then(|p| self.at_place(p, key).map(|off| (off, name_of(&p.place)))),
        };
        let Some((measured, place)) = measured.filter(|(off, _)| *off > OFF) else { return Vec::new() };
        let report = &self.performance.report;
        let admitted = measured <= report.residual_m.max(report.aside_m) + SAME;
        vec![Finding {
            kind: if admitted { Kind::OutOfReach } else { Kind::Contact },
            side: Some(key.side),
            time: key.time,
            measured,
            bound: OFF,
            what: format!("from {place} {}", key.name()),
        }]
    }

    /// How far the hands' points are from being as far apart as a contact says, metres; `None` where it says nothing that points tell.
    fn between_hands(&self, contact: &Contact, key: &Key) -> Option<f64> {
        let apart = match contact.kind {
            ContactKind::Touch => 0.0,
            ContactKind::Metres(metres) => metres,
            // Hands that are near each other have no contact.
            ContactKind::Close | ContactKind::Crossed | ContactKind::Interlocked => return None,
        };
        let weak = resolve(key.phase, Hand::Weak);
        let strong = self.point(contact.strong, &key.said.configuration, key, key.side)?;
        let weak = self.point(contact.weak, &weak.configuration, key, key.side.other())?;
        Some((strong.position(&key.body).distance(weak.position(&key.body)) - apart).abs())
    }

    /// How far a hand is from its place, metres; `None` where it touches nothing there.
    fn at_place(&self, placement: &Placement, key: &Key) -> Option<f64> {
        if !touches(placement, &self.grammar.locations) {
            return None;
        }
        // Of two hands that are each said to be on the other, the strong one is.
        let strong_is_on_it = || {
            let strong = resolve(key.phase, Hand::Strong).placement;
            strong.stated(key.number).is_some_and(|p| matches!(p.place, Place::OtherHand(_)))
        };
        if key.hand == Hand::Weak && matches!(placement.place, Place::OtherHand(_)) && strong_is_on_it() {
            return None;
        }
        let moved = placement.offset.map_or(DVec3::ZERO, |(direction, metres)| direction.vector() * metres);
        let targets = self.targets(placement, key);
        let own = self.own_points(placement, key).into_iter().map(|point| point.position(&key.body));
        let away = own.flat_map(|own| targets.iter().map(move |target| own.distance(*target + moved)));
        away.min_by(f64::total_cmp)
    }

    /// The points of the hand that may be meant to be at a place: the one that is said; else the one that its shape touches with, or
    /// where a movement leads there the one that it began with.
    fn own_points(&self, placement: &Placement, key: &Key) -> Vec<ContactPoint> {
        let shape = &key.said.configuration;
        let mut said = vec![placement.with];
        if placement.with.is_none() && self.points_away(placement, key) {
            said.push(Some(HandPoint::WRIST));
        }
        if placement.with.is_none() && key.said.placement.stated(key.number).is_none() {
            let before = key.said.placement.at(key.number);
            let in_space = before.is_none_or(|before| !touches(before, &self.grammar.locations));
            said.push(before.and_then(|before| before.with).or_else(|| in_space.then_some(HandPoint::PALM)));
        }
        said.into_iter().filter_map(|point| self.point(point, shape, key, key.side)).collect()
    }

    /// Whether the hand's fingers point away from the skin that it is said to touch: then it touches with its wrist, which lies behind
    /// what its shape touches with.
    fn points_away(&self, placement: &Placement, key: &Key) -> bool {
        let (Place::Body(name), Distance::Touch) = (&placement.place, placement.distance) else { return false };
        let Some(row) = self.grammar.locations.get(name) else { return false };
        let lateral = placement.lateral.or(row.paired.then_some(Lateral { side: key.side, beside: false }));
        let of_hand = |point| self.point(point, &key.said.configuration, key, key.side).map(|p| p.position(&key.body));
        match (self.signer.landmarks.body_place(&row.id, lateral), of_hand(None), of_hand(Some(HandPoint::WRIST))) {
            (Ok(skin), Some(own), Some(wrist)) => (own - wrist).dot(skin.normal(&key.body)) > AWAY,
            _ => false,
        }
    }

    /// Where the place is in the body's pose; several where the description leaves its side open.
    fn targets(&self, placement: &Placement, key: &Key) -> Vec<DVec3> {
        let landmarks = &self.signer.landmarks;
        let metres = |unmarked: Distance, from: (DVec3, DVec3)| {
            let shoulder = key.body.position(landmarks.shoulder(key.side));
            let metres = landmarks.metres(placement.distance, unmarked, from, shoulder, landmarks.arm_length());
            if placement.behind { -landmarks.hand_length() - metres } else { metres }
        };
        match &placement.place {
            Place::Body(name) => {
                let Some(row) = self.grammar.locations.get(name) else { return Vec::new() };
                let sides = [Side::Left, Side::Right].map(|side| Some(Lateral { side, beside: false }));
                let laterals = match placement.lateral {
                    Some(lateral) => vec![Some(lateral)],
                    None => [None].into_iter().chain(sides).collect(),
                };
                let found = laterals.into_iter().filter_map(|lateral| landmarks.body_place(&row.id, lateral).ok());
                let over = |(point, out): (DVec3, DVec3)| point + out * metres(row.unmarked, (point, out));
                found.map(|landmark| over((landmark.position(&key.body), landmark.normal(&key.body)))).collect()
            }
            Place::OtherHand(point) => {
                let Ok(point) = landmarks.hand_point(key.side.other(), *point) else { return Vec::new() };
                // Away from several fingers is away from each of them.
                let parts = point.parts().iter().map(|part| {
                    let (at, out) = (part.position(&key.body), part.normal(&key.body));
                    at + out * metres(Distance::Touch, (at, out))
                });
                vec![parts.sum::<DVec3>() / point.parts().len().max(1) as f64]
            }
            Place::Space(_) | Place::Point(_) | Place::Between(..) | Place::Referent(_) | Place::Towards(_) => {
                Vec::new()
            }
        }
    }

    /// The point of a hand that is said, else the one that its shape touches with.
    fn point(
        &self,
        said: Option<HandPoint>,
        shape: &Keys<Configuration>,
        key: &Key,
        side: Side,
    ) -> Option<ContactPoint> {
        let unsaid = Configuration::named("rest");
        let shape = shape.at(key.number).unwrap_or(&unsaid);
        let point = match said {
            Some(point) => point,
            None => self.grammar.touches_with(shape, key.phase).ok()?,
        };
        self.signer.landmarks.hand_point(side, point).ok()
    }
}

/// Where the hand is at a key: as the key says, else as the movement that ends there does.
fn placement<'k>(key: &'k Key) -> Option<&'k Placement> {
    let led =
        || key.number.checked_sub(1).and_then(|interval| key.said.movement.get(interval)).and_then(Movement::leads_to);
    key.said.placement.stated(key.number).or_else(led)
}

fn name_of(place: &Place) -> String {
    match place {
        Place::Body(name) => name.clone(),
        Place::OtherHand(_) => "the other hand".into(),
        Place::Space(_) | Place::Point(_) => "a place in space".into(),
        Place::Between(..) => "between two places".into(),
        Place::Referent(name) => name.clone(),
        Place::Towards(_) => "what it points at".into(),
    }
}
