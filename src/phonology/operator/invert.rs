//! A sign played backwards (Naert et al. 2021, §6: CLAIR backwards is FONCÉ).
//!
//! Every manual tier and contact runs from the last key to the first, each movement from its end to its start;
//! non-manuals stay (the paper edits manual channels only). Simple movements are said in plain words (`up` becomes `down`);
//! what has no plain reverse is wrapped in `backwards ( … )`.
//!
//! The phases of a sign come in reverse order, each backwards.
//!
//! Backwards twice is the sign itself in its *normal form*: the place that a movement leads to stands at its key, the first
//! value of a tier stands at the first key, what a hand becomes during a movement at the key after it, what an orientation leaves open is filled from its neighbours, and a hand of which
//! no place is said is at the neutral one. What was inverted once has that form, unless its text says `backwards` itself.

use super::{manual, manual_mut, neutral, phase, posture};
use crate::phonology::movement::{
    Action, Clock, Manner, Motion, Movement, Repeated, Repetition, RepetitionKind, Shift,
};
use crate::phonology::orientation::Orientation;
use crate::phonology::placement::Placement;
use crate::phonology::sign::{Hands, Keys, Manual, Sign};
use crate::phonology::{Direction, Hand, Heading};

/// The sign backwards: configuration, placement, orientation, movement and contact.
///
/// ```
/// use chereme::notation::{Vocabulary, read, write};
/// use chereme::phonology::operator::inverted;
/// let text = "sign A\n  configuration 5 then flat-O\n  placement chest\n  movement up 10cm\n";
/// let sign = &read(text, &Vocabulary::builtin(), "").signs[0].sign;
/// let back = write(&inverted(sign));
/// assert!(back.contains("flat-O then 5") && back.contains("chest at end") && back.contains("down 10cm"), "{back}");
/// ```
pub fn inverted(sign: &Sign) -> Sign {
    phase::backwards(sign, |phase| {
        let mut back = path_inverted(phase);
        for hand in Hand::BOTH {
            let own = manual_mut(&mut back, hand);
            own.configuration = runs_reversed(&own.configuration, phase.intervals);
            own.orientation = runs_reversed(&filled(&own.orientation), phase.intervals);
        }
        back
    })
}

/// The path alone backwards: placement, movement and contact. Several phases are made one first.
pub fn inverted_movement(sign: &Sign) -> Sign {
    // Too long for one: each phase's own path.
    let whole = phase::flattened(sign).unwrap_or_else(|_| sign.clone());
    phase::each(&whole, path_inverted)
}

/// The path of one phase backwards; shapes and orientations stay, said at keys.
fn path_inverted(sign: &Sign) -> Sign {
    let mut back = sign.clone();
    for hand in Hand::BOTH {
        let normal = normal(sign, hand);
        let own = manual_mut(&mut back, hand);
        own.movement = movements(&normal);
        own.placement = reversed(&normal.placement, sign.intervals);
        own.configuration = normal.configuration;
        own.orientation = normal.orientation;
        // What stood inside `backwards` may say a place now.
        targets_at_keys(own);
    }
    back.contact = reversed(&sign.contact, sign.intervals);
    back
}

/// A hand's tiers with the places that movements lead to said at the keys, and the neutral place where none is said.
fn normal(sign: &Sign, hand: Hand) -> Manual {
    let mut own = posture::at_keys(manual(sign, hand));
    targets_at_keys(&mut own);
    let acts = match (sign.hands, hand) {
        (Hands::Strong | Hands::Both(_), Hand::Strong) | (Hands::Weak | Hands::Both(None), Hand::Weak) => true,
        (Hands::Strong, Hand::Weak) | (Hands::Weak, Hand::Strong) => false,
        // It follows the strong hand, unless it has a place or a movement of its own.
        (Hands::Both(Some(_)), Hand::Weak) => false,
    };
    if acts && own.placement.is_empty() {
        own.placement = Keys::one(neutral());
    }
    own
}

/// The places that movements lead to, said at the keys.
fn targets_at_keys(own: &mut Manual) {
    let mut places: Vec<(usize, Placement)> = own.placement.iter().map(|(k, p)| (k, p.clone())).collect();
    for (interval, movement) in own.movement.iter_mut().enumerate() {
        let key = interval + 1;
        // A way back leads to where an earlier key says.
        let returned = match movement {
            Movement::Action(action) => match action.motion {
                Motion::Return { key } => places.iter().find(|(k, _)| *k == key).map(|(_, p)| p.clone()),
                _ => None,
            },
            _ => None,
        };
        let Some(target) = last_target(movement).or(returned) else { continue };
        let stated = places.iter().find(|(k, _)| *k == key).map(|(_, p)| p.clone());
        let plain = matches!(movement, Movement::Action(action) if action.repetition.is_none());
        match stated {
            None => places.push((key, target.clone())),
            Some(stated) if stated == target => {}
            // Two places at one key: the movement keeps its own.
            Some(_) => continue,
        }
        if let Movement::Action(action) = movement
            && plain
        {
            action.target = None;
        }
    }
    places.sort_by_key(|(key, _)| *key);
    own.placement = Keys::new(places).unwrap_or_default();
}

/// The place that a movement ends at.
fn last_target(movement: &Movement) -> Option<Placement> {
    match movement {
        Movement::Action(action) => {
            let returns = action.repetition.is_some_and(|r| r.kind == RepetitionKind::ToAndFro);
            action.target.clone().filter(|_| !returns)
        }
        Movement::Sequence(parts) => parts.last().and_then(last_target),
        Movement::Repeated(r) => match r.repetition.kind {
            RepetitionKind::FromStart | RepetitionKind::Continue => last_target(&r.movement),
            RepetitionKind::ToAndFro => None,
        },
        Movement::Together(_) | Movement::Fused(_) | Movement::Backwards(_) => None,
    }
}

/// The movements from the last interval to the first, each backwards.
fn movements(own: &Manual) -> Vec<Movement> {
    let one = |(interval, movement): (usize, &Movement)| {
        let movement = plain_words(movement);
        // A movement to a stated place from one that only the movements before lead to: only going back from the key
        // after finds where it ends.
        let from_nowhere = own.placement.stated(interval + 1).is_some()
            && own.placement.stated(interval).is_none()
            && own.placement.iter().any(|(key, _)| key < interval);
        match movement {
            Movement::Backwards(inner) => *inner,
            movement if from_nowhere => Movement::Backwards(Box::new(movement)),
            movement => rewritten(&movement).unwrap_or_else(|| Movement::Backwards(Box::new(movement))),
        }
    };
    own.movement.iter().enumerate().rev().map(one).collect()
}

/// `backwards ( … )` around what has a plain reverse, in plain words.
fn plain_words(movement: &Movement) -> Movement {
    match movement {
        Movement::Backwards(inner) => match plain_words(inner) {
            Movement::Backwards(twice) => *twice,
            inner => rewritten(&inner).unwrap_or_else(|| Movement::Backwards(Box::new(inner))),
        },
        other => other.clone(),
    }
}

/// A movement backwards in plain words; `None` where there are none.
fn rewritten(movement: &Movement) -> Option<Movement> {
    let all = |parts: &[Movement]| parts.iter().map(part).collect::<Option<Vec<_>>>();
    let backwards = |parts: Option<Vec<Movement>>| parts.map(|all| all.into_iter().rev().collect::<Vec<_>>());
    match movement {
        Movement::Action(action) => action_backwards(action).map(|a| Movement::Action(Box::new(a))),
        Movement::Sequence(parts) => backwards(all(parts)).map(Movement::Sequence),
        Movement::Together(parts) => all(parts).map(Movement::Together),
        Movement::Fused(parts) => backwards(all(parts)).map(Movement::Fused),
        Movement::Repeated(r) => repeated_backwards(r).map(|r| Movement::Repeated(Box::new(r))),
        Movement::Backwards(_) => None,
    }
}

/// A repeated group backwards; `None` where it says where it goes, or is not alike each time.
fn repeated_backwards(r: &Repeated) -> Option<Repeated> {
    if r.repetition.growth != 0 || goes_somewhere(&r.movement) {
        return None;
    }
    let movement = match r.repetition.kind {
        // There and back again is its own reverse.
        RepetitionKind::ToAndFro => r.movement.clone(),
        RepetitionKind::FromStart | RepetitionKind::Continue => part(&r.movement)?,
    };
    Some(Repeated { movement, repetition: repetition_backwards(r.repetition), alternating: r.alternating })
}

/// A repetition whose last performance is the first.
fn repetition_backwards(r: Repetition) -> Repetition {
    Repetition { shift: r.shift.map(|s| Shift { direction: s.direction.opposite(), ..s }), ..r }
}

/// A part of a group backwards; `None` where a place or a key in it says where it goes.
fn part(movement: &Movement) -> Option<Movement> {
    if goes_somewhere(movement) {
        return None;
    }
    match movement {
        Movement::Backwards(inner) => Some((**inner).clone()),
        other => Some(rewritten(other).unwrap_or_else(|| Movement::Backwards(Box::new(other.clone())))),
    }
}

fn goes_somewhere(movement: &Movement) -> bool {
    movement.any_action(&|action| is_led(action) || matches!(action.motion, Motion::Return { .. }))
}

/// Whether an action says where it leads, to a place or to a posture.
fn is_led(action: &Action) -> bool {
    action.target.is_some() || action.becoming.is_some() || action.names.is_some()
}

fn action_backwards(action: &Action) -> Option<Action> {
    let grows = action.repetition.is_some_and(|r| r.growth != 0);
    if is_led(action) || grows {
        return None;
    }
    let manner = action.manner.iter().map(|manner| match manner {
        // A rest before it becomes a stop after it.
        Manner::Rest => Manner::Halt,
        Manner::Halt => Manner::Rest,
        // The fingers that changed last change first.
        Manner::TowardPinky => Manner::TowardThumb,
        Manner::TowardThumb => Manner::TowardPinky,
        Manner::Fast | Manner::Slow | Manner::Tense | Manner::Bouncing => *manner,
    });
    let to_and_fro = action.repetition.is_some_and(|r| r.kind == RepetitionKind::ToAndFro);
    // There and back again is its own reverse.
    let motion = if to_and_fro { action.motion.clone() } else { motion_backwards(&action.motion)? };
    let repetition = action.repetition.map(repetition_backwards);
    Some(Action { motion, manner: manner.collect(), repetition, ..action.clone() })
}

fn motion_backwards(motion: &Motion) -> Option<Motion> {
    Some(match motion {
        Motion::Hold | Motion::Change | Motion::Wiggle(_) => motion.clone(),
        Motion::Wrist(wrist, size) => Motion::Wrist(wrist.reversed(), *size),
        Motion::Straight { direction, extent, overlay: None } => {
            Motion::Straight { direction: direction.opposite(), extent: *extent, overlay: None }
        }
        Motion::Arc { direction, extent, bulge, depth, overlay: None } => Motion::Arc {
            direction: direction.opposite(),
            extent: *extent,
            bulge: *bulge,
            depth: *depth,
            overlay: None,
        },
        // Waves begin to one side, and end there only backwards.
        Motion::Straight { .. } | Motion::Arc { .. } | Motion::Return { .. } => return None,
        Motion::Circle { growth, .. } if *growth != 0 => return None,
        Motion::Circle { overlay: Some(_), .. } => return None,
        Motion::Circle { axis, extent, start, turns, ellipse, growth, overlay: None } => {
            let eighths = turns * 8.0;
            if eighths.fract() != 0.0 || eighths > 1e6 {
                return None;
            }
            // Seen from the other side, the clock runs the other way and starts where it ended.
            let end = (u32::from(start.eighths()) + eighths as u32) % 8;
            Motion::Circle {
                axis: axis.opposite(),
                extent: *extent,
                start: Clock::new(((8 - end) % 8) as u8)?,
                turns: *turns,
                ellipse: *ellipse,
                growth: *growth,
                overlay: None,
            }
        }
    })
}

/// Values that hold at their own keys, from the last key to the first.
fn reversed<T: Clone>(keys: &Keys<T>, last: usize) -> Keys<T> {
    let all: Vec<(usize, &T)> = keys.iter().filter(|(key, _)| *key <= last).collect();
    Keys::new(all.into_iter().rev().map(|(key, value)| (last - key, value.clone())).collect()).unwrap_or_default()
}

/// Values that hold until the next one, from the last key to the first.
fn runs_reversed<T: Clone>(keys: &Keys<T>, last: usize) -> Keys<T> {
    let all: Vec<(usize, &T)> = keys.iter().filter(|(key, _)| *key <= last).collect();
    let ends = all.iter().skip(1).map(|(next, _)| next - 1).chain([last]);
    let mut runs: Vec<(usize, T)> =
        all.iter().zip(ends).map(|((_, value), end)| (last - end, (*value).clone())).collect();
    runs.reverse();
    Keys::new(runs).unwrap_or_default()
}

/// Orientations with what each leaves open filled from those before it, then from those after it.
///
/// Where the neighbour's direction would lie along the own one, the hand is turned by a right angle instead: a palm does
/// not face along the fingers, and what is left open would be read as the neighbour's.
pub(super) fn filled(keys: &Keys<Orientation>) -> Keys<Orientation> {
    let mut all: Vec<(usize, Orientation)> = keys.iter().map(|(key, o)| (key, *o)).collect();
    let fill = |into: &mut Orientation, from: Orientation| {
        into.palm = into.palm.or_else(|| across(from.palm, into.fingers, from.fingers));
        into.fingers = into.fingers.or_else(|| across(from.fingers, into.palm, from.palm));
    };
    for i in 1..all.len() {
        let before = all[i - 1].1;
        fill(&mut all[i].1, before);
    }
    for i in (1..all.len()).rev() {
        let after = all[i].1;
        fill(&mut all[i - 1].1, after);
    }
    Keys::new(all).unwrap_or_default()
}

/// Orientations of which none lets a palm face along fingers that hold from before: those are turned by a right angle.
pub(super) fn possible(keys: &Keys<Orientation>) -> Keys<Orientation> {
    let (mut fingers, mut palm) = (None, None);
    let one = |(key, stated): (usize, &Orientation)| {
        let mut o = *stated;
        let along = |a: Option<Heading>, b: Option<Heading>| across(a, b, None) != a;
        if o.fingers.is_none() && along(fingers, o.palm) {
            o.fingers = across(fingers, o.palm, palm);
        }
        if o.palm.is_none() && along(palm, o.fingers) {
            o.palm = across(palm, o.fingers, fingers);
        }
        fingers = o.fingers.or(fingers);
        palm = o.palm.or(palm);
        (key, o)
    };
    Keys::new(keys.iter().map(one).collect()).unwrap_or_default()
}

/// A direction to take over, unless it lies along `own`: then `instead`, or any direction across.
fn across(wanted: Option<Heading>, own: Option<Heading>, instead: Option<Heading>) -> Option<Heading> {
    let wanted = wanted?;
    let Some(own) = own else { return Some(wanted) };
    let is_across = |heading: &Heading| heading.vector().cross(own.vector()).length() > 0.1;
    let any = || Direction::all().map(Heading::Toward).find(|heading| heading.vector().dot(own.vector()).abs() < 0.1);
    Some(wanted).filter(is_across).or_else(|| instead.filter(is_across)).or_else(any)
}
