//! Values put in the place of a sign's own: derivative bases and shape specifiers (Naert et al. 2021, §5.1), and the same for
//! orientation, placement, movement and face.
//!
//! Without a hand a value is for the strong hand and for a weak hand that shares it: one that follows it, or says the same.
//! As many values as the sign has keys stand at one each; one spreads.

use super::reflect::explicit;
use super::{Applied, manual_mut};
use crate::diagnostics::Error;
use crate::phonology::reflection::Reflection;
use crate::phonology::{
    Channel, Configuration, Hand, Hands, Keys, Manual, Movement, NonManual, Orientation, Placement, Sign,
};

/// Other hand configurations. Where the sign is a base with attested ones, the meaning follows, and what is not attested is
/// warned of.
pub(super) fn configuration(sign: &Sign, hand: Option<Hand>, values: &Keys<Configuration>) -> Result<Applied, Error> {
    fits(values, sign, "configuration")?;
    let mut made = keyed(sign, hand, values, |m| &mut m.configuration, |m| &m.configuration)?;
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
    fits(values, sign, "orientation")?;
    Ok(keyed(sign, hand, values, |m| &mut m.orientation, |m| &m.orientation)?.into())
}

/// Other placements.
pub(super) fn placement(sign: &Sign, hand: Option<Hand>, values: &Keys<Placement>) -> Result<Applied, Error> {
    fits(values, sign, "placement")?;
    Ok(keyed(sign, hand, values, |m| &mut m.placement, |m| &m.placement)?.into())
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
    Ok(made.into())
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

fn keyed<T: Clone + PartialEq>(
    sign: &Sign,
    hand: Option<Hand>,
    values: &Keys<T>,
    tier: fn(&mut Manual) -> &mut Keys<T>,
    read: fn(&Manual) -> &Keys<T>,
) -> Result<Sign, Error> {
    let (hand, shared) = acting(sign, hand)?;
    let mut made = sign.clone();
    let both = matches!(sign.hands, Hands::Both(_));
    if both && shared && !read(&sign.weak).is_empty() && read(&sign.weak) == read(&sign.strong) {
        *tier(&mut made.weak) = values.clone();
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
        *tier(&mut made.weak) = read(&weak).clone();
    }
    *tier(manual_mut(&mut made, hand)) = values.clone();
    Ok(made)
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
