//! Hands and sides exchanged: mirrored, swapped, reflected, and a lexical description for a left-handed signer.
//!
//! *Mirrored* is the paper's operator (§6): one arm copied onto the other, one-handed to two-handed. *Swapped* is the reflection
//! of the two arms (what the strong hand did, the weak one does). *Reflected* is the mirror image of the whole signer.

use super::posture::without;
use super::{Applied, Tables, keys_of, manual, neutral, phase, plain};
use crate::diagnostics::Error;
use crate::phonology::reflection::Reflection;
use crate::phonology::symmetry::{acts, crossed, map_keys, resolve};
use crate::phonology::{
    Action, Becoming, Configuration, Contact, Hand, Hands, Keys, Lateral, Manual, Motion, Place, Placement, Relocation,
    Side, Sign, Symmetry,
};

/// The acting hand copied onto the other, mirrored at the midline; of two different hands, the strong one's.
///
/// A contact of the hands is dropped, with a warning. One hand in neutral space keeps its side, so its arm stays where it was.
///
/// # Errors
/// A hand placed on the other one has no copy.
pub fn mirrored(sign: &Sign, tables: &Tables) -> Result<Applied, Error> {
    let mut warnings = Vec::new();
    let made = phase::try_each(sign, |phase| {
        let mut one = phase_mirrored(phase, tables)?;
        warnings.append(&mut one.warnings);
        Ok(one.sign)
    })?;
    if warnings.is_empty() { Ok(made.into()) } else { Ok(Applied { sign: made, warnings: vec![unmet(sign)] }) }
}

fn unmet(sign: &Sign) -> String {
    format!("{}: mirrored, its hands no longer meet", sign.name)
}

fn phase_mirrored(sign: &Sign, tables: &Tables) -> Result<Applied, Error> {
    let same = sign.hands == Hands::Both(Some(Symmetry::MIRRORED)) && sign.weak.is_empty();
    if same {
        return Ok(sign.clone().into());
    }
    let mut own = match sign.hands {
        Hands::Weak => Reflection::SIDES.manual(&sign.weak),
        Hands::Strong | Hands::Both(_) => sign.strong.clone(),
    };
    match sign.hands {
        Hands::Both(Some(symmetry)) if symmetry.crossed => {
            own.placement = map_keys(&own.placement, |p| crossed(p, Hand::Strong));
        }
        Hands::Both(_) => {}
        Hands::Strong | Hands::Weak => {
            if own.placement.is_empty() {
                own.placement = Keys::one(neutral());
            }
            let is_neutral = |name: &str| tables.locations.get(name).is_none_or(|row| row.id == "neutral");
            own.placement = map_keys(&own.placement, |p| match &p.place {
                Place::Body(name) if p.lateral.is_none() && is_neutral(name) => {
                    Placement { lateral: Some(Lateral { side: Side::Right, beside: false }), ..p.clone() }
                }
                _ => p.clone(),
            });
        }
    }
    if own.movement.is_empty() {
        own.movement = vec![plain(Motion::Change); sign.intervals];
    }
    if own.placement.iter().any(|(_, p)| on_the_other_hand(&p.place)) {
        return Err(Error::new("it cannot be mirrored: each hand would be placed on the other"));
    }
    let meet = |b: &Action| b.becoming.as_ref().is_some_and(|b| b.contact.is_some());
    let meets = !sign.contact.is_empty() || own.movement.iter().any(|m| m.any_action(&meet));
    let apart = |action: &Action| without(action, &|b| b.contact = None);
    own.movement = own.movement.iter().map(|m| m.map_actions(&apart)).collect();
    let warnings = meets.then(|| unmet(sign)).into_iter().collect();
    let sign = Sign {
        hands: Hands::Both(Some(Symmetry::MIRRORED)),
        strong: own,
        weak: Manual::default(),
        contact: Keys::default(),
        ..sign.clone()
    };
    Ok(Applied { sign, warnings })
}

fn on_the_other_hand(place: &Place) -> bool {
    match place {
        Place::OtherHand(_) => true,
        Place::Between(a, b) => on_the_other_hand(&a.place) || on_the_other_hand(&b.place),
        Place::Towards(at) => on_the_other_hand(at),
        Place::Body(_) | Place::Space(_) | Place::Point(_) | Place::Referent(_) => false,
    }
}

/// The hands exchanged, and left and right in their tiers with them. Twice is the sign itself, in the form in which a hand
/// whose other one says more than it says what holds for it (`rest`, the neutral place).
///
/// ```
/// use chereme::phonology::operator::swapped;
/// use chereme::phonology::{Hands, Sign};
/// let weak = swapped(&Sign::named("OK"));
/// assert_eq!(weak.hands, Hands::Weak);
/// assert_eq!(swapped(&weak), Sign::named("OK"));
/// ```
pub fn swapped(sign: &Sign) -> Sign {
    phase::each(sign, |phase| exchanged(phase, Reflection::SIDES))
}

/// The description as a left-handed signer performs it: the hands exchanged, but places in space, points and what is
/// looked at stay, since the addressee stays where they are.
pub fn for_left_hander(sign: &Sign) -> Sign {
    let swapped = phase::each(sign, |phase| exchanged(phase, Reflection::SIDES_OF_SIGNER));
    Sign { relocated: sign.relocated.clone(), ..swapped }
}

/// The mirror image of the whole signer: hands, sides, directions, places in space, head and gaze.
pub fn reflected(sign: &Sign) -> Sign {
    let mut image = swapped(sign);
    for (_, values) in &mut image.nonmanual {
        *values = map_keys(values, |v| Reflection::SIDES.nonmanual(v));
    }
    image
}

fn exchanged(sign: &Sign, sides: Reflection) -> Sign {
    let sign = &spelled_out(sign);
    let (strong, weak) = match sign.hands {
        Hands::Strong | Hands::Weak => (sides.manual(&sign.weak), sides.manual(&sign.strong)),
        Hands::Both(None) => {
            let (mut strong, mut weak) = (sides.manual(&sign.weak), sides.manual(&sign.strong));
            if sign.weak.configuration.is_empty() {
                // The weak hand shares the strong one's shape, then as before.
                std::mem::swap(&mut strong.configuration, &mut weak.configuration);
            }
            (strong, weak)
        }
        Hands::Both(Some(symmetry)) => following(sign, symmetry, sides),
    };
    let contact = map_keys(&sign.contact, other_way_round);
    let (strong, weak) = (contacts_exchanged(strong), contacts_exchanged(weak));
    let relocated = sign.relocated.as_ref().map(|to| Relocation { place: sides.place(&to.place), forced: to.forced });
    let hands = match sign.hands {
        Hands::Strong => Hands::Weak,
        Hands::Weak => Hands::Strong,
        both @ Hands::Both(_) => both,
    };
    Sign { hands, strong, weak, contact, relocated, ..sign.clone() }
}

fn other_way_round(c: &Contact) -> Contact {
    Contact { strong: c.weak, weak: c.strong, kind: c.kind }
}

/// The contacts that are made during movements, with the hands exchanged.
fn contacts_exchanged(own: Manual) -> Manual {
    let exchanged = |action: &Action| {
        let becoming = action.becoming.clone().map(|b| {
            let contact = b.contact.as_ref().map(other_way_round);
            Box::new(Becoming { contact, ..*b })
        });
        Action { becoming, ..action.clone() }
    };
    Manual { movement: own.movement.iter().map(|m| m.map_actions(&exchanged)).collect(), ..own }
}

/// The two hands of a symmetry exchanged: each tier that the weak hand has of its own changes places with the strong
/// one's; one that follows keeps following.
fn following(sign: &Sign, symmetry: Symmetry, sides: Reflection) -> (Manual, Manual) {
    let through = Reflection::of(symmetry).and_sides().with_space_as(sides);
    let (s, w) = (&sign.strong, &sign.weak);
    let (through_s, sides_s, sides_w) = (through.manual(s), sides.manual(s), sides.manual(w));
    fn pick<T>(own: bool, strong: T, follows: T, weak: T, none: T) -> (T, T) {
        if own { (weak, strong) } else { (follows, none) }
    }
    let (c, p) = (!w.configuration.is_empty(), !w.placement.is_empty());
    let (o, m) = (!w.orientation.is_empty(), !w.movement.is_empty());
    let none = Manual::default;
    let configuration =
        pick(c, sides_s.configuration, through_s.configuration, sides_w.configuration, none().configuration);
    let placement = pick(p, sides_s.placement, through_s.placement, sides_w.placement, none().placement);
    let orientation = pick(o, sides_s.orientation, through_s.orientation, sides_w.orientation, none().orientation);
    let movement = pick(m, sides_s.movement, through_s.movement, sides_w.movement, none().movement);
    let hand =
        |configuration, placement, orientation, movement| Manual { configuration, placement, orientation, movement };
    (
        hand(configuration.0, placement.0, orientation.0, movement.0),
        hand(configuration.1, placement.1, orientation.1, movement.1),
    )
}

/// What the strong hand leaves unsaid where the weak hand says something of its own, said.
fn spelled_out(sign: &Sign) -> Sign {
    let mut said = sign.clone();
    let (s, w) = (&mut said.strong, &sign.weak);
    if !matches!(sign.hands, Hands::Both(_)) {
        return said;
    }
    if s.configuration.is_empty() && !w.configuration.is_empty() {
        s.configuration = Keys::one(Configuration::named("rest"));
    }
    if let Hands::Both(Some(symmetry)) = sign.hands {
        if s.placement.is_empty() && !w.placement.is_empty() {
            s.placement = Keys::one(neutral());
        }
        if s.movement.is_empty() && !w.movement.is_empty() {
            s.movement = vec![plain(Motion::Change); sign.intervals];
        }
        if s.orientation.is_empty() && !w.orientation.is_empty() {
            // An orientation cannot say that nothing is said; the hands are described apart.
            said.weak = explicit(sign, symmetry);
            said.hands = Hands::Both(None);
        }
    }
    said
}

/// The weak hand of a symmetry with everything that it follows in.
pub(super) fn explicit(sign: &Sign, symmetry: Symmetry) -> Manual {
    let resolved = resolve(sign, Hand::Weak);
    let movement = if sign.weak.movement.is_empty() {
        sign.strong.movement.iter().map(|m| Reflection::of(symmetry).movement(m)).collect()
    } else {
        resolved.movement
    };
    Manual {
        configuration: resolved.configuration,
        placement: resolved.placement,
        orientation: resolved.orientation,
        movement,
    }
}

/// A hand's tiers with everything that it follows in; `None` where it does not act.
pub(super) fn hand_of(sign: &Sign, hand: Hand) -> Option<Manual> {
    if !acts(sign, hand) {
        return None;
    }
    Some(match (sign.hands, hand) {
        (Hands::Both(Some(symmetry)), Hand::Weak) => explicit(sign, symmetry),
        _ => {
            let resolved = resolve(sign, hand);
            let configuration = resolved.configuration;
            Manual { configuration, placement: resolved.placement, ..manual(sign, hand).clone() }
        }
    })
}

/// Values moved to later keys.
pub(super) fn later<T: Clone>(keys: &Keys<T>, by: usize) -> Keys<T> {
    keys_of(keys.iter().map(|(key, value)| (key + by, value.clone())).collect())
}
