//! A sign's values in English words.
//!
//! Names of handshapes and of non-manual values are those of the inventories, as they are written in a sign.

use super::english_movement::movement;
use super::english_noun::{digit, fingers, grows, heading, length, number, part, place, placement, point};
use super::{Tier, keys};
use crate::phonology::operator::Operator;
use crate::phonology::recombination::{Base, Recombination};
use crate::phonology::{
    Amount, Becoming, Bend, Configuration, Contact, ContactKind, HandPoint, HandshapeChange, Keys, Manual, NonManual,
    NonManualValue, Opening, Orientation, Sign, ThumbPosition,
};

/// One manual tier.
pub(super) fn tier(manual: &Manual, intervals: usize, tier: Tier) -> String {
    match tier {
        Tier::Configuration => keys(&manual.configuration, intervals, JOIN, configuration),
        Tier::Placement => keys(&manual.placement, intervals, JOIN, placement),
        Tier::Orientation => keys(&manual.orientation, intervals, JOIN, orientation),
        Tier::Movement => manual.movement.iter().map(movement).collect::<Vec<_>>().join(JOIN[0]),
    }
}

/// Between values, and before the number of a key.
const JOIN: [&str; 2] = [", then ", "posture"];

/// How the hands meet.
pub(super) fn contacts(sign: &Sign) -> String {
    keys(&sign.contact, sign.intervals, JOIN, contact)
}

/// Duration and speed, where they are stated: label and words.
pub(super) fn times(sign: &Sign) -> Vec<(&'static str, String)> {
    let mut all = Vec::new();
    if let Some(long) = sign.duration {
        all.push(("duration", format!("{} s", number(long.0))));
    }
    if sign.speed != 1.0 {
        all.push(("speed", format!("{} times the usual one", number(sign.speed))));
    }
    all
}

/// What is said of the whole sign.
pub(super) fn whole(sign: &Sign) -> Vec<(&'static str, String)> {
    let channels = sign.nonmanual.iter();
    let mut all: Vec<(&'static str, String)> =
        channels.map(|(channel, v)| (channel.name(), keys(v, sign.intervals, JOIN, nonmanual))).collect();
    if !sign.base.is_empty() {
        let attested: Vec<String> = sign.base.iter().map(|a| configuration(&a.configuration)).collect();
        all.push(("derivative base, attested configurations", attested.join("; ")));
    }
    if let Some(moved) = &sign.relocated {
        all.push(("the sign is moved", format!("to {}", place(&moved.place))));
    }
    let texts = [("source", &sign.source), ("status", &sign.status), ("note", &sign.note)];
    all.extend(texts.into_iter().filter_map(|(label, text)| Some((label, text.clone()?))));
    all
}

/// How a sign is made from others.
pub(super) fn making(from: &Recombination) -> String {
    let part = |p: &Recombination| match (&p.base, p.operators.is_empty()) {
        (Base::Named(_) | Base::Spelled(_), true) => making(p),
        _ => format!("({})", making(p)),
    };
    let mut text = match &from.base {
        Base::Named(name) => name.clone(),
        Base::Spelled(word) => format!("the letters of {word}, from shape to shape"),
        Base::Pointing(at) => format!("a pointing at {}", place(at)),
        Base::WristAt(point) => {
            let [x, y, z] = point.to_array().map(number);
            format!("the wrist at the point {x} m to the left, {y} m up, {z} m forward")
        }
        Base::Chain(parts) => parts.iter().map(part).collect::<Vec<_>>().join(", then "),
        Base::Hands(strong, weak) => {
            format!("{} on the strong hand and {} on the weak hand", part(strong), part(weak))
        }
    };
    for operator in &from.operators {
        text.push_str(", ");
        text.push_str(&doing(operator));
    }
    text
}

fn doing(operator: &Operator) -> String {
    match operator {
        Operator::Inverted => "played backwards".into(),
        Operator::InvertedMovement => "its path played backwards, the hands shaped and turned as before".into(),
        Operator::Mirrored => "one hand copied onto the other, mirrored".into(),
        Operator::Swapped => "the hands exchanged".into(),
        Operator::Reflected => "its mirror image, face and gaze included".into(),
        Operator::Repeated { times, growth, .. } => format!("performed {times} times in all{}", grows(*growth)),
        Operator::Configuration(_, v) => format!("with the configuration {}", joined(v, configuration)),
        Operator::Orientation(_, v) => format!("with the orientation {}", joined(v, orientation)),
        Operator::Placement(_, v) => format!("placed {}", joined(v, placement)),
        Operator::Movement(_, all) => {
            let all: Vec<String> = all.iter().map(movement).collect();
            format!("with the movement {}", all.join(JOIN[0]))
        }
        Operator::NonManual(channel, v) => format!("with {} {}", channel.name(), joined(v, nonmanual)),
        Operator::At(moved) => format!("moved to {}", place(&moved.place)),
        Operator::Speed(factor) => format!("{} times as fast", number(*factor)),
        Operator::Size(factor) => format!("its paths {} times as large", number(*factor)),
    }
}

fn joined<T>(values: &Keys<T>, say: impl Fn(&T) -> String) -> String {
    values.iter().map(|(_, v)| say(v)).collect::<Vec<_>>().join(JOIN[0])
}

fn configuration(v: &Configuration) -> String {
    let mixed = |name: &str, own: &[HandshapeChange]| match own {
        [] => name.to_owned(),
        own => format!("({name}{})", changes(own)),
    };
    let base = match &v.between {
        None => v.base.clone(),
        Some(b) => format!("halfway between {} and {}", mixed(&v.base, &b.first), mixed(&b.second, &b.changes)),
    };
    base + &changes(&v.changes)
}

/// Changes, each with a comma before it.
fn changes(all: &[HandshapeChange]) -> String {
    all.iter().map(|one| format!(", {}", change(*one))).collect()
}

fn change(v: HandshapeChange) -> String {
    match v {
        HandshapeChange::Thumb(ThumbPosition::Along) => "the thumb along the hand".into(),
        HandshapeChange::Thumb(ThumbPosition::Out) => "the thumb out".into(),
        HandshapeChange::Thumb(ThumbPosition::Across) => "the thumb across the palm".into(),
        HandshapeChange::Thumb(ThumbPosition::Opposed) => "the thumb facing the fingers".into(),
        HandshapeChange::Thumb(ThumbPosition::Enclosed) => "the thumb under the closed fingers".into(),
        HandshapeChange::Bend(digits, bend) if digits.is_empty() => format!("the chosen fingers {}", bent(bend)),
        HandshapeChange::Bend(digits, bend) => format!("{} {}", fingers(digits), bent(bend)),
        HandshapeChange::Spread(true) => "the fingers spread".into(),
        HandshapeChange::Spread(false) => "the fingers together".into(),
        HandshapeChange::Cross(over, under) => format!("{} in front of {}", digit(over), digit(under)),
        HandshapeChange::ThumbBetween(a, b) => format!("the thumb between {} and {}", digit(a), digit(b)),
        HandshapeChange::On(digits) => format!("made with {}", fingers(digits)),
        HandshapeChange::Except(digits) => format!("{} left as before", fingers(digits)),
        HandshapeChange::Opening(Opening::Tight) => "nearly closed".into(),
        HandshapeChange::Opening(Opening::Slack) => "wide open".into(),
        HandshapeChange::Meet(one, at, other) => {
            format!("{} touching the {} of {}", digit(one), part(at), digit(other))
        }
        HandshapeChange::ThumbAt(at) => format!("the thumb touching the fingers at the {}", part(at)),
        HandshapeChange::Joints(digits, [knuckle, middle, last]) => {
            let of = if digits.is_empty() { "the chosen fingers".into() } else { fingers(digits) };
            format!("{of} bent by {knuckle}, {middle} and {last} quarters at knuckle, middle and last joint")
        }
    }
}

fn bent(bend: Bend) -> &'static str {
    match bend {
        Bend::Straight => "straight",
        Bend::Bent => "bent at the knuckle",
        Bend::HalfBent => "half bent at the knuckle",
        Bend::Round => "rounded",
        Bend::Hooked => "hooked",
        Bend::DoubleBent => "bent at knuckle and middle joint",
        Bend::DoubleHooked => "hooked at every joint",
        Bend::Closed => "closed",
    }
}

pub(super) fn orientation(v: &Orientation) -> String {
    // A path leads to the left, a palm faces left.
    let way = |h| heading(h).replace("to the ", "");
    let fingers = v.fingers.map(|h| format!("fingers pointing {}", way(h)));
    let palm = v.palm.map(|h| format!("palm facing {}", way(h)));
    let along = v.along_path.then(|| "turning with the path".to_owned());
    [fingers, palm, along].into_iter().flatten().collect::<Vec<_>>().join(", ")
}

fn contact(v: &Contact) -> String {
    let named = |of: Option<HandPoint>, hand: &str| match of {
        None => format!("the {hand} hand"),
        Some(of) => format!("{} of the {hand} hand", point(of)),
    };
    let meets = match v.kind {
        ContactKind::Touch => "touches".to_owned(),
        ContactKind::Close => "is close to".to_owned(),
        ContactKind::Crossed => "crosses".to_owned(),
        ContactKind::Interlocked => "interlocks with".to_owned(),
        ContactKind::Metres(metres) => format!("is {} from", length(metres)),
    };
    format!("{} {meets} {}", named(v.strong, "strong"), named(v.weak, "weak"))
}

/// What a hand becomes during a movement.
pub(super) fn becoming(v: &Becoming) -> String {
    let shape = v.configuration.as_ref().map(configuration);
    let turned = v.orientation.as_ref().map(orientation);
    let meets = v.contact.as_ref().map(|c| format!("{} then", contact(c)));
    [shape, turned, meets].into_iter().flatten().collect::<Vec<_>>().join(", ")
}

fn nonmanual(v: &NonManual) -> String {
    let all = |parts: &[NonManual], by: &str| parts.iter().map(nonmanual).collect::<Vec<_>>().join(by);
    let text = match &v.value {
        NonManualValue::Named(name) => name.clone(),
        NonManualValue::Towards(h) => format!("turned {}", heading(*h)),
        NonManualValue::At(at) => format!("towards {}", place(&at.place)),
        NonManualValue::Mouthing(sounds) => format!("mouthing “{sounds}”"),
        NonManualValue::Sequence(parts) => format!("({})", all(parts, ", then ")),
        NonManualValue::Together(parts) => format!("({})", all(parts, " and at the same time ")),
    };
    let amount = match v.amount {
        Amount::Slight => ", slightly".to_owned(),
        Amount::Plain => String::new(),
        Amount::Strong => ", strongly".to_owned(),
        Amount::Percent(percent) => format!(", at {percent} %"),
    };
    let pace = if v.pace == 1.0 { String::new() } else { format!(", {} times as fast", number(v.pace)) };
    text + &amount + &pace
}
