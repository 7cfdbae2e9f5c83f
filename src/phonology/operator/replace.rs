//! Values put in the place of a sign's own: derivative bases and shape specifiers (Naert et al. 2021, §5.1), and the same for
//! orientation, placement, movement and face.
//!
//! Without a hand a value is for the strong hand and for a weak hand that shares it: one that follows it, or says the same.
//! As many values as the sign has keys stand at one each; one spreads.

use super::posture::without;
use super::reflect::explicit;
use super::{Applied, keys_of, manual_mut, phase};
use crate::diagnostics::Error;
use crate::phonology::reflection::Reflection;
use crate::phonology::{
    Becoming, Channel, Configuration, Hand, Hands, Keys, Manual, Movement, NonManual, Orientation, Placement, Sign,
};

/// Other hand configurations. Where the sign is a base with attested ones, the meaning follows, and what is not attested is
/// warned of.
pub(super) fn configuration(sign: &Sign, hand: Option<Hand>, values: &Keys<Configuration>) -> Result<Applied, Error> {
    let tier = Tier { name: "configuration", read: |m| &m.configuration, write: |m| &mut m.configuration };
    let mut made = keyed(sign, hand, values, &tier, &|b| b.configuration = None)?;
    let mut warnings = Vec::new();
    if !sign.base.is_empty() {
        let attested = |v: &Configuration| sign.base.iter().find(|a| a.configuration == *v);
        for (_, value) in values.iter().filter(|(_, v)| attested(v).is_none()) {
            let known: Vec<&str> = sign.base.iter().map(|a| a.configuration.base.as_str()).collect();
            warnings.push(format!(
                "{}: the configuration {} is not attested on it; attested are {}",
                sign.name,
                value.base,
                known.join(", ")
            ));
        }
        if let (1, Some(found)) = (values.len(), values.at(0).and_then(attested))
            && !found.meaning.is_empty()
        {
            made.meaning.clone_from(&found.meaning);
        }
    }
    Ok(Applied { sign: made, warnings })
}

/// Other orientations.
pub(super) fn orientation(sign: &Sign, hand: Option<Hand>, values: &Keys<Orientation>) -> Result<Applied, Error> {
    let tier = Tier { name: "orientation", read: |m| &m.orientation, write: |m| &mut m.orientation };
    Ok(keyed(sign, hand, values, &tier, &|b| b.orientation = None)?.into())
}

/// Other placements.
pub(super) fn placement(sign: &Sign, hand: Option<Hand>, values: &Keys<Placement>) -> Result<Applied, Error> {
    let tier = Tier { name: "placement", read: |m| &m.placement, write: |m| &mut m.placement };
    Ok(keyed(sign, hand, values, &tier, &|_| {})?.into())
}

/// Another non-manual tier.
pub(super) fn nonmanual(sign: &Sign, channel: Channel, values: &Keys<NonManual>) -> Result<Applied, Error> {
    fits(values, sign, channel.name())?;
    let mut made = sign.clone();
    made.nonmanual.retain(|(c, _)| *c != channel);
    made.nonmanual.push((channel, values.clone()));
    made.nonmanual.sort_by_key(|(c, _)| *c);
    Ok(made.into())
}

/// Other movements; as many as the sign has, or any number where no tier counts them.
pub(super) fn movement(sign: &Sign, hand: Option<Hand>, movements: &[Movement]) -> Result<Applied, Error> {
    if sign.then.is_empty() {
        return phase_moved(sign, hand, movements).map(Applied::from);
    }
    let intervals = in_phases(sign, hand, |phase| phase.intervals)?;
    if movements.len() != intervals {
        return Err(counts("movement", movements.len(), intervals, "movements in its phases"));
    }
    let mut rest = movements;
    let made = phase::try_each(sign, |phase| {
        if acting(phase, hand).is_err() || phase.intervals == 0 {
            return Ok(phase.clone());
        }
        let (own, after) = rest.split_at(phase.intervals);
        rest = after;
        phase_moved(phase, hand, own)
    });
    made.map(Applied::from)
}

fn phase_moved(sign: &Sign, hand: Option<Hand>, movements: &[Movement]) -> Result<Sign, Error> {
    let hand = acting(sign, hand)?;
    let mut made = sign.clone();
    if movements.len() != sign.intervals {
        let other = if hand.0 == Hand::Strong { &sign.weak.movement } else { &sign.strong.movement };
        if counts_keys(sign) || (!hand.1 && !other.is_empty()) || movements.is_empty() {
            return Err(counts("movement", movements.len(), sign.intervals, "movements"));
        }
        made.intervals = movements.len();
    }
    if let Hands::Both(Some(symmetry)) = sign.hands
        && !hand.1
        && hand.0 == Hand::Strong
        && sign.weak.movement.is_empty()
    {
        // The weak hand keeps what it did while it followed.
        made.weak.movement = sign.strong.movement.iter().map(|m| Reflection::of(symmetry).movement(m)).collect();
    }
    let shares = hand.1 && !sign.weak.movement.is_empty() && sign.weak.movement == sign.strong.movement;
    manual_mut(&mut made, hand.0).movement = movements.to_vec();
    if shares {
        made.weak.movement = movements.to_vec();
    }
    Ok(made)
}

/// Whether some tier has values at several keys, so that the number of keys cannot change.
fn counts_keys(sign: &Sign) -> bool {
    fn several<T>(keys: &Keys<T>) -> bool {
        keys.iter().any(|(key, _)| key > 0)
    }
    let hand = |m: &Manual| several(&m.configuration) || several(&m.placement) || several(&m.orientation);
    hand(&sign.strong)
        || hand(&sign.weak)
        || several(&sign.contact)
        || sign.nonmanual.iter().any(|(_, keys)| several(keys))
}

/// The hand that a value is for, and whether the other one may share it.
fn acting(sign: &Sign, hand: Option<Hand>) -> Result<(Hand, bool), Error> {
    match (sign.hands, hand) {
        (Hands::Weak, None) => Ok((Hand::Weak, false)),
        (_, None) => Ok((Hand::Strong, true)),
        (Hands::Strong, Some(Hand::Weak)) => Err(Error::new("the weak hand does not act in it")),
        (Hands::Weak, Some(Hand::Strong)) => Err(Error::new("the strong hand does not act in it")),
        (_, Some(hand)) => Ok((hand, false)),
    }
}

/// A tier of values at keys.
struct Tier<T> {
    name: &'static str,
    read: fn(&Manual) -> &Keys<T>,
    write: fn(&mut Manual) -> &mut Keys<T>,
}

/// Other values of a tier. Of several phases, one value is that of each in which the hand acts, several stand at the keys
/// of all of these, counted through. What movements would make of the tier is `forgotten`.
fn keyed<T: Clone + PartialEq>(
    sign: &Sign,
    hand: Option<Hand>,
    values: &Keys<T>,
    tier: &Tier<T>,
    forgotten: &impl Fn(&mut Becoming),
) -> Result<Sign, Error> {
    if sign.then.is_empty() {
        fits(values, sign, tier.name)?;
        return phase_keyed(sign, hand, values, tier, forgotten);
    }
    let mut offset = 0;
    let one_for_all = values.len() == 1 && values.stated(0).is_some();
    let keys = in_phases(sign, hand, |phase| phase.intervals + 1)?;
    if !one_for_all && (values.len() != keys || values.iter().any(|(key, _)| key >= keys)) {
        return Err(counts(tier.name, values.len(), keys, "keys in its phases"));
    }
    phase::try_each(sign, |phase| {
        if acting(phase, hand).is_err() {
            return Ok(phase.clone());
        }
        if one_for_all {
            return phase_keyed(phase, hand, values, tier, forgotten);
        }
        let own = values.iter().filter(|(key, _)| (offset..=offset + phase.intervals).contains(key));
        let own = keys_of(own.map(|(key, value)| (key - offset, value.clone())).collect());
        offset += phase.intervals + 1;
        phase_keyed(phase, hand, &own, tier, forgotten)
    })
}

/// What the phases have together in which a hand acts.
fn in_phases(sign: &Sign, hand: Option<Hand>, count: impl Fn(&Sign) -> usize) -> Result<usize, Error> {
    let acting_in: Vec<&Sign> = sign.phases().filter(|phase| acting(phase, hand).is_ok()).collect();
    if acting_in.is_empty() {
        acting(sign, hand)?;
    }
    Ok(acting_in.into_iter().map(count).sum())
}

fn phase_keyed<T: Clone + PartialEq>(
    sign: &Sign,
    hand: Option<Hand>,
    values: &Keys<T>,
    tier: &Tier<T>,
    forgotten: &impl Fn(&mut Becoming),
) -> Result<Sign, Error> {
    let (hand, shared) = acting(sign, hand)?;
    let mut made = sign.clone();
    let both = matches!(sign.hands, Hands::Both(_));
    let (read, write) = (tier.read, tier.write);
    if both && shared && !read(&sign.weak).is_empty() && read(&sign.weak) == read(&sign.strong) {
        *write(&mut made.weak) = values.clone();
    }
    if both && shared && (read(&sign.weak).is_empty() || read(&sign.weak) == read(&sign.strong)) {
        forget(&mut made.weak, forgotten);
    }
    if both && !shared && hand == Hand::Strong && read(&sign.weak).is_empty() {
        // The weak hand keeps what it had while it followed.
        let weak = match sign.hands {
            Hands::Both(Some(symmetry)) => explicit(sign, symmetry),
            // Of two different hands, only the shape is shared by saying nothing.
            Hands::Strong | Hands::Weak | Hands::Both(None) => {
                Manual { configuration: sign.strong.configuration.clone(), ..Manual::default() }
            }
        };
        *write(&mut made.weak) = read(&weak).clone();
    }
    let own = manual_mut(&mut made, hand);
    *write(own) = values.clone();
    forget(own, forgotten);
    Ok(made)
}

fn forget(own: &mut Manual, forgotten: &impl Fn(&mut Becoming)) {
    own.movement = own.movement.iter().map(|m| m.map_actions(&|action| without(action, forgotten))).collect();
}

/// One value, or one at each key.
fn fits<T>(values: &Keys<T>, sign: &Sign, tier: &str) -> Result<(), Error> {
    let within = values.iter().all(|(key, _)| key <= sign.intervals);
    if within && (values.len() == 1 || values.len() == sign.intervals + 1) {
        return Ok(());
    }
    Err(counts(tier, values.len(), sign.intervals + 1, "keys"))
}

fn counts(tier: &str, given: usize, has: usize, what: &str) -> Error {
    let values = if given == 1 { "1 value".to_owned() } else { format!("{given} values") };
    Error::new(format!("{tier} is given {values}, but it has {has} {what}"))
}
