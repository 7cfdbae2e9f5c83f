//! Signs joined: compounds (one after the other as one sign) and one sign on each hand (Naert et al. 2021, §6: "the
//! parallel production of two signs").

use super::invert::possible;
use super::phase::flattened;
use super::reflect::{hand_of, later};
use super::{keys_of, manual_mut, neutral, plain, swapped};
use crate::diagnostics::Error;
use crate::phonology::symmetry::acts;
use crate::phonology::{
    Configuration, Contact, Hand, Hands, Keys, Manual, Motion, Movement, NonManual, Placement, Sign,
};

/// One sign after the other as one sign: each part's postures and movements, a `change` from one part to the next.
///
/// A part of several phases is made one. The places of each part stand at its keys. Hands that act in one part only stay where they are in the others. What a
/// non-manual tier says holds until the next part that says something of it.
///
/// # Errors
/// No part; more movements than a sign may have.
///
/// ```
/// use chereme::phonology::Sign;
/// use chereme::phonology::operator::chain;
/// let sign = chain(&[Sign::named("A"), Sign::named("B")], "AB").unwrap();
/// assert_eq!((sign.name.as_str(), sign.intervals), ("AB", 1));
/// ```
pub fn chain(parts: &[Sign], name: impl Into<String>) -> Result<Sign, Error> {
    let parts = parts.iter().map(flattened).collect::<Result<Vec<Sign>, Error>>()?;
    let parts: Vec<Part> = parts.iter().map(|sign| Part { sign, before: plain(Motion::Change) }).collect();
    joined(&parts, name.into(), Unsaid::Neutral)
}

/// A sign of a chain and the movement that leads to it; that of the first is passed over.
pub(super) struct Part<'s> {
    pub sign: &'s Sign,
    pub before: Movement,
}

/// Where a hand is at the start of a part that says no place.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Unsaid {
    /// At the neutral place.
    Neutral,
    /// Where the part before ended.
    Stays,
}

/// Signs one after the other.
pub(super) fn joined(parts: &[Part], name: String, unsaid: Unsaid) -> Result<Sign, Error> {
    let Some(first) = parts.first().map(|p| p.sign) else {
        return Err(Error::new(format!("{name} is made of no sign")));
    };
    let intervals = parts.iter().map(|p| p.sign.intervals).sum::<usize>() + parts.len() - 1;
    if intervals > Sign::MOST_INTERVALS {
        return Err(Error::new(format!(
            "{name} has {intervals} movements; a sign has {} at most",
            Sign::MOST_INTERVALS
        )));
    }
    let alike = parts.iter().all(|p| p.sign.hands == first.hands);
    let hands = if alike { first.hands } else { Hands::Both(None) };
    let mut made = Sign { language: first.language.clone(), hands, intervals, ..Sign::named(name) };
    if parts.iter().all(|p| p.sign.speed == first.speed) {
        made.speed = first.speed;
    }
    for hand in Hand::BOTH {
        let own =
            |part: &Part| if alike { Some(super::manual(part.sign, hand).clone()) } else { hand_of(part.sign, hand) };
        if !acts(&made, hand) {
            continue;
        }
        *manual_mut(&mut made, hand) = hand_joined(parts, own, hand == Hand::Strong || !follows(hands), unsaid);
    }
    let (mut offset, mut contact): (usize, Vec<(usize, Contact)>) = (0, Vec::new());
    for part in parts {
        contact.extend(part.sign.contact.iter().map(|(key, c)| (offset + key, *c)));
        for (channel, values) in &part.sign.nonmanual {
            let moved: Vec<(usize, NonManual)> = said_from_start(values, offset);
            match made.nonmanual.iter_mut().find(|(c, _)| c == channel) {
                Some((_, all)) => *all = keys_of(all.iter().map(|(k, v)| (k, v.clone())).chain(moved).collect()),
                None => made.nonmanual.push((*channel, keys_of(moved))),
            }
        }
        offset += part.sign.intervals + 1;
    }
    made.contact = keys_of(contact);
    made.nonmanual.sort_by_key(|(channel, _)| *channel);
    Ok(made)
}

fn follows(hands: Hands) -> bool {
    matches!(hands, Hands::Both(Some(_)))
}

/// One hand's tiers of all parts. What the first key of a part leaves unsaid is said: the part does not begin as the one
/// before ended. A hand that follows the other one needs nothing of its own.
fn hand_joined(parts: &[Part], own: impl Fn(&Part) -> Option<Manual>, leads: bool, unsaid: Unsaid) -> Manual {
    let (mut configuration, mut placement, mut orientation) = (Vec::new(), Vec::new(), Vec::new());
    let mut movement = Vec::new();
    let all: Vec<Option<Manual>> = parts.iter().map(own).collect();
    let any = |said: fn(&Manual) -> bool| all.iter().flatten().any(said);
    let shapes = any(|m| !m.configuration.is_empty());
    let places = any(|m| !m.placement.is_empty());
    let moves = leads || any(|m| !m.movement.is_empty());
    let mut offset = 0;
    for (i, (part, own)) in parts.iter().zip(&all).enumerate() {
        let n = part.sign.intervals;
        if moves && i > 0 {
            movement.push(part.before.clone());
        }
        let Some(own) = own else {
            movement.extend(moves.then(|| vec![plain(Motion::Hold); n]).into_iter().flatten());
            offset += n + 1;
            continue;
        };
        configuration.extend(said_from_start(&own.configuration, offset));
        orientation.extend(said_from_start(&own.orientation, offset));
        placement.extend(own.placement.iter().map(|(key, p)| (offset + key, p.clone())));
        if shapes && own.configuration.is_empty() && leads {
            configuration.push((offset, Configuration::named("rest")));
        }
        if places && own.placement.is_empty() && leads && unsaid == Unsaid::Neutral {
            placement.push((offset, neutral()));
        }
        match own.movement.is_empty() {
            false => movement.extend(own.movement.iter().map(|m| super::repeat::moved(m, offset))),
            true if moves => movement.extend(vec![plain(Motion::Change); n]),
            true => {}
        }
        offset += n + 1;
    }
    let placement: Vec<(usize, Placement)> = placement;
    Manual {
        configuration: keys_of(configuration),
        placement: keys_of(placement),
        orientation: possible(&keys_of(orientation)),
        movement,
    }
}

/// Values at later keys, the first one at the first key.
fn said_from_start<T: Clone>(values: &Keys<T>, by: usize) -> Vec<(usize, T)> {
    let first = values.at(0).map(|v| (by, v.clone()));
    first.into_iter().chain(later(values, by).iter().map(|(k, v)| (k, v.clone()))).collect()
}

/// One sign on each hand: the strong hand of the first, the second on the weak hand. The shorter one holds its end.
///
/// # Errors
/// A hand that the sign needs does not act in it.
///
/// ```
/// use chereme::phonology::operator::on_each_hand;
/// use chereme::phonology::{Hands, Sign};
/// assert_eq!(on_each_hand(&Sign::named("A"), &Sign::named("B")).unwrap().hands, Hands::Both(None));
/// ```
pub fn on_each_hand(strong: &Sign, weak: &Sign) -> Result<Sign, Error> {
    let (strong, weak) = (&flattened(strong)?, &flattened(weak)?);
    let missing = |sign: &Sign| Error::new(format!("{} has no hand to take part", sign.name));
    let of_first = match strong.hands {
        Hands::Weak => hand_of(&swapped(strong), Hand::Strong),
        Hands::Strong | Hands::Both(_) => hand_of(strong, Hand::Strong),
    };
    let of_second = match weak.hands {
        Hands::Strong => hand_of(&swapped(weak), Hand::Weak),
        Hands::Weak | Hands::Both(_) => hand_of(weak, Hand::Weak),
    };
    let (mut first, mut second) = (of_first.ok_or_else(|| missing(strong))?, of_second.ok_or_else(|| missing(weak))?);
    let intervals = strong.intervals.max(weak.intervals);
    for own in [&mut first, &mut second] {
        own.movement.resize(intervals, plain(Motion::Hold));
        if own.configuration.is_empty() {
            own.configuration = Keys::one(Configuration::named("rest"));
        }
        if own.placement.is_empty() {
            own.placement = Keys::one(neutral());
        }
    }
    let mut nonmanual = strong.nonmanual.clone();
    let free = |channel| !strong.nonmanual.iter().any(|(c, _)| *c == channel);
    nonmanual.extend(weak.nonmanual.iter().filter(|(c, _)| free(*c)).cloned());
    nonmanual.sort_by_key(|(channel, _)| *channel);
    Ok(Sign {
        name: format!("{} & {}", strong.name, weak.name),
        meaning: Vec::new(),
        hands: Hands::Both(None),
        intervals,
        strong: first,
        weak: second,
        contact: Keys::default(),
        nonmanual,
        duration: None,
        base: Vec::new(),
        ..strong.clone()
    })
}
