//! Hand placement: the place, how near, and with which part of the hand.

use super::direction::Direction;
use super::hand::{HandPoint, Side};
use glam::DVec3;

/// Where a hand is.
#[derive(Debug, Clone, PartialEq)]
pub struct Placement {
    /// The place.
    pub place: Place,
    /// To which side of the place; for paired places (ear, cheek) which one.
    pub lateral: Option<Lateral>,
    /// How far from the place, along its normal.
    pub distance: Distance,
    /// Behind the place instead of in front (HamNoSys `hambehind`).
    pub behind: bool,
    /// The part of the hand that is at the place; the configuration's own contact point where `None`.
    pub with: Option<HandPoint>,
    /// Moved from there: direction and metres.
    pub offset: Option<(Direction, f64)>,
}

impl Placement {
    /// A place with nothing more said.
    pub fn at(place: Place) -> Placement {
        Placement { place, lateral: None, distance: Distance::Unmarked, behind: false, with: None, offset: None }
    }
}

/// A place on the body, on the other arm or hand, or in space.
#[derive(Debug, Clone, PartialEq)]
pub enum Place {
    /// A named place of the inventory (`grammar/locations.ron`), as written: `chest`, `forehead`, `neutral`.
    Body(String),
    /// A point of the other hand or arm: `other palm`, `other index tip`.
    OtherHand(HandPoint),
    /// A cell of the grid before the signer.
    Space(Space),
    /// A point in model space, metres.
    Point(DVec3),
    /// Halfway between two places, each perhaps with a side of its own.
    Between(Box<Sited>, Box<Sited>),
    /// A place given a name by coreference (HamNoSys `hamcoreftag`, `hamcorefref`).
    Referent(String),
    /// Where a hand is held to point at a place: its pointing ray passes through it (Naert et al. 2021, §4.2).
    Towards(Box<Place>),
}

/// A place with its side: one of the two that a placement lies between.
#[derive(Debug, Clone, PartialEq)]
pub struct Sited {
    /// The place.
    pub place: Place,
    /// To which side of it; where it is not said, that of the whole placement.
    pub lateral: Option<Lateral>,
}

impl From<Place> for Sited {
    fn from(place: Place) -> Sited {
        Sited { place, lateral: None }
    }
}

/// A sign moved to a place as a whole: spatialization (Naert et al. 2021, §4.1).
#[derive(Debug, Clone, PartialEq)]
pub struct Relocation {
    /// Where to.
    pub place: Place,
    /// Whether a sign that the body anchors is moved all the same.
    pub forced: Forced,
}

/// Whether a relocation holds for signs whose place on the body is a part of them.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub enum Forced {
    /// Such a sign is refused.
    #[default]
    No,
    /// Such a sign is moved too.
    Yes,
}

/// A cell of signing space: each axis −1, 0 or +1 (right/centre/left, low/middle/high, near/middle/far).
///
/// Steps are ±0.4, ±0.3 and ±0.25 arm lengths about the neutral place (docs/DESIGN.md).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Space {
    /// −1 right, 0 centre, +1 left.
    pub left: i8,
    /// −1 low, 0 middle, +1 high.
    pub high: i8,
    /// −1 near, 0 middle, +1 far.
    pub far: i8,
}

/// To the side of a place.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Lateral {
    /// The signer's left or right.
    pub side: Side,
    /// Beside the place rather than on that part of it (`hamlrbeside`, `hamlrat`).
    pub beside: bool,
}

/// How far from a place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Distance {
    /// Not said: the inventory has a distance for each place.
    Unmarked,
    /// On the skin.
    Touch,
    /// 0.12 arm lengths.
    Close,
    /// 0.42 arm lengths.
    Neutral,
    /// The arm nearly stretched.
    Extended,
    /// Metres from the skin, along the place's normal.
    Metres(f64),
}

/// How the two hands meet (HamNoSys hand constellation).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// The point of the strong hand; where it is not said, what its configuration touches with.
    pub strong: Option<HandPoint>,
    /// The point of the weak hand.
    pub weak: Option<HandPoint>,
    /// In what way.
    pub kind: ContactKind,
}

/// The way two hands meet.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ContactKind {
    /// The points touch.
    Touch,
    /// The points are near each other (0.06 arm lengths).
    Close,
    /// The hands lie crossed on each other.
    Crossed,
    /// The fingers are interlocked.
    Interlocked,
    /// Metres between the points.
    Metres(f64),
}

impl ContactKind {
    /// The kinds that have a name in text.
    pub const NAMED: [ContactKind; 4] =
        [ContactKind::Touch, ContactKind::Close, ContactKind::Crossed, ContactKind::Interlocked];
}
