//! A sign moved to a place: spatialization (Naert et al. 2021, §4.1), and what forbids it.
//!
//! Signs on the body (PENSER at the head, CHIEN at the thigh) are anchored: their place is a part of them. Signs in space (BOL)
//! may be moved. A place of the body at a distance (`chest, 24cm away`) is in space.

use super::Tables;
use super::reflect::hand_of;
use crate::diagnostics::Error;
use crate::phonology::{
    Distance, Forced, Hand, LocationInventory, Manual, Movement, Place, Placement, Relocation, Sign,
};

/// From this distance to the skin on, metres, a placement no longer counts as touching.
const NEAR_M: f64 = 0.06;

/// Whether a placement is at or near the skin, so that what touches matters.
pub fn touches(placement: &Placement, locations: &LocationInventory) -> bool {
    let distance = match (&placement.place, placement.distance) {
        // In the signing space before a region the hand is away from the skin.
        (Place::Body(name), Distance::Close | Distance::Unmarked)
            if locations.get(name).is_some_and(|row| row.space.is_some()) =>
        {
            Distance::Neutral
        }
        (Place::Body(name), Distance::Unmarked) => match locations.get(name) {
            Some(row) if row.id != "neutral" => row.unmarked,
            _ => Distance::Neutral,
        },
        (Place::OtherHand(_), Distance::Unmarked) => Distance::Touch,
        // Between two places a hand touches where it would touch both.
        (Place::Between(a, b), _) => {
            let half = |place: &Place| touches(&Placement { place: place.clone(), ..placement.clone() }, locations);
            return half(&a.place) && half(&b.place);
        }
        (_, distance) => distance,
    };
    match distance {
        Distance::Touch | Distance::Close => true,
        Distance::Metres(metres) => metres < NEAR_M,
        Distance::Unmarked | Distance::Neutral | Distance::Extended => false,
    }
}

/// The name of the place on the body that a sign is anchored at, where it is.
///
/// ```
/// use chereme::phonology::operator::anchored;
/// use chereme::phonology::{Distance, Keys, LocationInventory, Place, Placement, Sign};
/// let mut sign = Sign::named("PENSER");
/// let temple = Placement { distance: Distance::Touch, ..Placement::at(Place::Body("temple".into())) };
/// sign.strong.placement = Keys::one(temple);
/// assert_eq!(anchored(&sign, &LocationInventory::builtin()).as_deref(), Some("temple"));
/// ```
pub fn anchored(sign: &Sign, locations: &LocationInventory) -> Option<String> {
    let hands = sign.phases().flat_map(|phase| Hand::BOTH.into_iter().filter_map(|hand| hand_of(phase, hand)));
    hands.into_iter().find_map(|own| on_body(&own, locations))
}

fn on_body(own: &Manual, locations: &LocationInventory) -> Option<String> {
    let mut all: Vec<&Placement> = own.placement.iter().map(|(_, p)| p).collect();
    own.movement.iter().for_each(|m| targets(m, &mut all));
    all.into_iter().filter(|p| touches(p, locations)).find_map(|p| body_place(&p.place, locations))
}

/// The places that a movement goes to.
fn targets<'m>(movement: &'m Movement, all: &mut Vec<&'m Placement>) {
    match movement {
        Movement::Action(action) => all.extend(&action.target),
        Movement::Sequence(parts) | Movement::Together(parts) | Movement::Fused(parts) => {
            parts.iter().for_each(|m| targets(m, all));
        }
        Movement::Repeated(r) => targets(&r.movement, all),
        Movement::Backwards(inner) => targets(inner, all),
    }
}

fn body_place(place: &Place, locations: &LocationInventory) -> Option<String> {
    match place {
        Place::Body(name) => {
            let neutral = locations.get(name).is_some_and(|row| row.id == "neutral");
            (!neutral).then(|| name.clone())
        }
        Place::Between(a, b) => body_place(&a.place, locations).or_else(|| body_place(&b.place, locations)),
        Place::OtherHand(_) | Place::Space(_) | Place::Point(_) | Place::Referent(_) | Place::Towards(_) => None,
    }
}

/// The sign with the place that it is moved to.
pub(super) fn at(sign: &Sign, to: &Relocation, tables: &Tables) -> Result<Sign, Error> {
    match (anchored(sign, tables.locations), to.forced) {
        (Some(place), Forced::No) => Err(Error::new(format!(
            "it is anchored on the body ({place}), and its place cannot change; `at …, forced` moves it all the same"
        ))),
        (Some(_), Forced::Yes) | (None, _) => Ok(Sign { relocated: Some(to.clone()), ..sign.clone() }),
    }
}
