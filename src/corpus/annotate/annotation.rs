//! What was measured of a clip, as values and as tiers.

use super::Meeting;
use crate::phonology::{Contact, HandPoint, Movement, Orientation, Place, Placement, Side, label};
use crate::tier::Tier;
use crate::time::Seconds;

/// A phase of a hand's motion.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Phase {
    /// From rest to where the hand signs.
    Preparation,
    /// From one stroke to another.
    Transition,
    /// The hand does something.
    Stroke,
    /// The hand is still while it signs.
    Hold,
    /// Back to rest.
    Retraction,
}

impl Phase {
    /// Its label, as in the tiers of a track.
    pub fn name(self) -> &'static str {
        match self {
            Phase::Preparation => "preparation",
            Phase::Transition => "transition",
            Phase::Stroke => "stroke",
            Phase::Hold => "hold",
            Phase::Retraction => "retraction",
        }
    }
}

/// What was measured, and when it holds.
#[derive(Debug, Clone, PartialEq)]
pub struct Value<T> {
    /// When it begins, from the clip's start.
    pub start: Seconds,
    /// When it ends.
    pub end: Seconds,
    /// The value.
    pub value: T,
    /// How far the motion is off it, in the component's unit.
    pub off: f64,
}

/// A handshape of the inventory.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Shape {
    /// Its number in the inventory.
    pub number: usize,
    /// Its id.
    pub id: String,
}

/// A place, and the point of the hand that is there.
#[derive(Debug, Clone, PartialEq)]
pub struct Placed {
    /// The place.
    pub placement: Placement,
    /// The point of the hand that it was measured with.
    pub with: HandPoint,
    /// Where the hand is on the other one, if it is.
    pub meeting: Option<Meeting>,
}

impl Placed {
    /// A place where no hands meet.
    pub(super) fn at(placement: Placement, with: HandPoint) -> Placed {
        Placed { placement, with, meeting: None }
    }

    /// The place on the other hand, where that is the hand's place.
    pub fn on_other(&self) -> Option<Placement> {
        let met = self.meeting.filter(|met| met.is_place)?;
        Some(Placement { distance: met.distance, ..Placement::at(Place::OtherHand(met.other)) })
    }
}

/// What one hand does.
#[derive(Debug, Clone, PartialEq)]
pub struct HandAnnotation {
    /// Which hand.
    pub side: Side,
    /// Its phases.
    pub phases: Vec<Value<Phase>>,
    /// Its handshapes; `off` is the distance of the forms, metres.
    pub configuration: Vec<Value<Shape>>,
    /// Where it is; `off` in metres.
    pub placement: Vec<Value<Placed>>,
    /// Where fingers and palm look; `off` is the larger of both angles, radians.
    pub orientation: Vec<Value<Orientation>>,
    /// What it does; `off` in metres. Moves that come again are one.
    pub movement: Vec<Value<Movement>>,
    /// The same move by move, before those that come again are joined.
    pub moves: Vec<Value<Movement>>,
}

/// What was measured of a clip.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Annotation {
    /// The hands that the recording has, the right one first.
    pub hands: Vec<HandAnnotation>,
    /// Where they meet, the right one's point as the strong one's; `off` in metres.
    pub contact: Vec<Value<Contact>>,
}

impl Annotation {
    /// The hand of a side.
    pub fn hand(&self, side: Side) -> Option<&HandAnnotation> {
        self.hands.iter().find(|hand| hand.side == side)
    }

    /// The tiers, named as those of a track (`RH Phase`, `RH Configuration`, …, `Contact`); those without a value are left out.
    pub fn tiers(&self) -> Vec<Tier> {
        let mut tiers = Vec::new();
        for hand in &self.hands {
            let name = |kind: &str| format!("{} {kind}", hand.side.hand());
            tiers.push(tier(name("Phase"), &hand.phases, |phase| phase.name().to_owned()));
            tiers.push(tier(name("Configuration"), &hand.configuration, |shape| shape.id.clone()));
            tiers.push(tier(name("Placement"), &hand.placement, |placed| {
                label::placement(placed.on_other().as_ref().unwrap_or(&placed.placement))
            }));
            tiers.push(tier(name("Orientation"), &hand.orientation, label::orientation));
            tiers.push(tier(name("Movement"), &hand.movement, label::movement));
        }
        tiers.push(tier("Contact".to_owned(), &self.contact, label::contact));
        tiers.retain(|tier| !tier.values().is_empty());
        tiers
    }
}

fn tier<T>(name: String, values: &[Value<T>], label: impl Fn(&T) -> String) -> Tier {
    let mut tier = Tier::new(name);
    for value in values {
        tier.push(value.start, value.end, label(&value.value), format!("measured: {:.3}", value.off));
    }
    tier
}
