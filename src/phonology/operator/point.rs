//! Pointing gestures (Naert et al. 2021, §4.2): a hand configuration and a place, no movement of its own.

use crate::phonology::{Configuration, Digits, HandPart, HandPoint, Keys, Place, Placement, Sign};
use glam::DVec3;

/// A hand held so that it points at a place; with the index finger where no configuration is given.
///
/// ```
/// use chereme::phonology::operator::pointing;
/// use chereme::phonology::Place;
/// let sign = pointing(None, Place::Body("chest".into()));
/// assert_eq!(sign.strong.configuration.at(0).unwrap().base, "index");
/// ```
pub fn pointing(configuration: Option<Configuration>, at: Place) -> Sign {
    let mut sign = Sign::named("IX");
    let at = match at {
        already @ Place::Towards(_) => already,
        place => Place::Towards(Box::new(place)),
    };
    sign.strong.configuration = Keys::one(configuration.unwrap_or_else(|| Configuration::named("index")));
    sign.strong.placement = Keys::one(Placement::at(at));
    sign
}

/// The paper's own pointing: the wrist at a point, model space, metres; the hand's index finger is stretched.
pub fn wrist_at(point: DVec3) -> Sign {
    let mut sign = Sign::named("IX");
    sign.strong.configuration = Keys::one(Configuration::named("index"));
    let wrist = HandPoint::new(Digits::NONE, HandPart::Wrist, None);
    sign.strong.placement = Keys::one(Placement { with: wrist, ..Placement::at(Place::Point(point)) });
    sign
}
