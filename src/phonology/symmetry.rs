//! What the weak hand does when it follows the strong one.

use super::configuration::Configuration;
use super::hand::{Hand, HandPoint, Side};
use super::movement::{Action, Movement};
use super::orientation::Orientation;
use super::placement::{Contact, Lateral, Placement};
use super::reflection::Reflection;
use super::sign::{Hands, Keys, Manual, Relation, Sign, Symmetry};
use glam::DVec3;

/// Whether a hand takes turns with the other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Turns {
    /// It follows the other hand: movements marked as alternating put it half a cycle behind.
    pub follower: bool,
    /// All its movements are half a cycle behind.
    pub behind: bool,
}

impl Turns {
    /// Whether an action is half a cycle behind.
    pub fn behind(self, action: &Action) -> bool {
        self.behind || self.follower && action.alternating
    }
}

/// The tiers of one hand with everything that follows from a symmetry filled in.
#[derive(Debug, Clone)]
pub struct Resolved {
    /// Configuration at keys; empty where nothing is said.
    pub configuration: Keys<Configuration>,
    /// Placement at keys.
    pub placement: Keys<Placement>,
    /// Orientation at keys.
    pub orientation: Keys<Orientation>,
    /// Movement in intervals, with the places that it leads to; empty where the hand is only carried from key to key.
    pub movement: Vec<Movement>,
    /// The signs that the movement's paths are multiplied by (−1 for an exchanged axis).
    pub signs: DVec3,
    /// Whether this hand takes turns with the other.
    pub turns: Turns,
}

/// Whether a hand acts in a sign.
pub fn acts(sign: &Sign, hand: Hand) -> bool {
    match (sign.hands, hand) {
        (Hands::Strong, Hand::Strong) | (Hands::Weak, Hand::Weak) | (Hands::Both(_), _) => true,
        (Hands::Strong, Hand::Weak) | (Hands::Weak, Hand::Strong) => false,
    }
}

/// The tiers of a hand of a sign.
pub fn resolve(sign: &Sign, hand: Hand) -> Resolved {
    let own = match hand {
        Hand::Strong => &sign.strong,
        Hand::Weak => &sign.weak,
    };
    match (sign.hands, hand) {
        (Hands::Both(Some(symmetry)), Hand::Weak) => following(&sign.strong, own, symmetry),
        (Hands::Both(Some(symmetry)), Hand::Strong) if symmetry.crossed => {
            let place = |p: &Placement| crossed(p, Hand::Strong);
            let placement = map_keys(&own.placement, place);
            Resolved { placement, movement: own.movement.iter().map(|m| placed(m, &place)).collect(), ..plain(own) }
        }
        (Hands::Both(None), Hand::Weak) if own.configuration.is_empty() => {
            // Two hands without a symmetry: a weak hand of which nothing is said has the strong one's shape.
            Resolved { configuration: sign.strong.configuration.clone(), ..plain(own) }
        }
        _ => plain(own),
    }
}

fn plain(own: &Manual) -> Resolved {
    Resolved {
        configuration: own.configuration.clone(),
        placement: own.placement.clone(),
        orientation: own.orientation.clone(),
        movement: own.movement.clone(),
        signs: DVec3::ONE,
        turns: Turns::default(),
    }
}

fn following(strong: &Manual, own: &Manual, symmetry: Symmetry) -> Resolved {
    let reflection = Reflection::of(symmetry);
    let sign = |exchanged: bool| if exchanged { -1.0 } else { 1.0 };
    let stated_movement = !own.movement.is_empty();
    let place = |p: &Placement| {
        let reflected = reflection.placement(p);
        if symmetry.crossed { crossed(&reflected, Hand::Weak) } else { reflected }
    };
    Resolved {
        configuration: or_else(&own.configuration, || strong.configuration.clone()),
        placement: or_else(&own.placement, || map_keys(&strong.placement, place)),
        orientation: or_else(&own.orientation, || map_keys(&strong.orientation, |o| reflection.orientation(o))),
        movement: if stated_movement {
            own.movement.clone()
        } else {
            let turned = |m: Movement| m.map_actions(&|action| becoming_reflected(action, reflection));
            strong.movement.iter().map(|m| turned(placed(m, &place))).collect()
        },
        signs: if stated_movement {
            DVec3::ONE
        } else {
            let mirrored = symmetry.relation == Relation::Mirrored;
            DVec3::new(sign(mirrored), sign(symmetry.up_down), sign(symmetry.out_in))
        },
        turns: Turns { follower: true, behind: symmetry.alternating },
    }
}

fn or_else<T: Clone>(own: &Keys<T>, other: impl Fn() -> Keys<T>) -> Keys<T> {
    if own.is_empty() { other() } else { own.clone() }
}

pub(super) fn map_keys<T, U>(keys: &Keys<T>, f: impl Fn(&T) -> U) -> Keys<U> {
    Keys::new(keys.iter().map(|(k, v)| (k, f(v))).collect()).unwrap_or_default()
}

/// A movement with the places that it leads to and brushes changed.
fn placed(movement: &Movement, place: &impl Fn(&Placement) -> Placement) -> Movement {
    movement.map_actions(&|action| Action {
        target: action.target.as_ref().map(place),
        brushing: action.brushing.as_ref().map(place),
        ..action.clone()
    })
}

/// An action with the orientation that the hand takes on meanwhile reflected; its path is reflected by `signs`.
fn becoming_reflected(action: &Action, reflection: Reflection) -> Action {
    let becoming = action.becoming.as_deref().map(|b| Box::new(reflection.becoming(b)));
    Action { becoming, ..action.clone() }
}

/// The hands crossed over: each on the other's side.
pub(super) fn crossed(p: &Placement, hand: Hand) -> Placement {
    let other_side = match hand {
        Hand::Strong => Side::Left,
        Hand::Weak => Side::Right,
    };
    let lateral = p.lateral.or(Some(Lateral { side: other_side, beside: false }));
    Placement { lateral, ..p.clone() }
}

/// A contact seen from a hand: its own point, and the other's.
pub fn points(contact: &Contact, hand: Hand) -> (Option<HandPoint>, Option<HandPoint>) {
    match hand {
        Hand::Strong => (contact.strong, contact.weak),
        Hand::Weak => (contact.weak, contact.strong),
    }
}
