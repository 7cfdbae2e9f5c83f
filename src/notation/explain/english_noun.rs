//! English nouns and directions: numbers, fingers, points of the hand, places.

use crate::phonology::{
    Digit, Digits, Direction, Distance, Flank, HandPart, HandPoint, Heading, Lateral, Place, Placement, Side, Sited,
};

/// With two decimals at most.
pub(super) fn number(value: f64) -> String {
    let text = format!("{value:.2}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

/// Metres as centimetres.
pub(super) fn length(metres: f64) -> String {
    format!("{} cm", number(metres * 100.0))
}

pub(super) fn grows(growth: i8) -> &'static str {
    match growth.signum() {
        1 => ", larger each time",
        -1 => ", smaller each time",
        _ => "",
    }
}

/// A list with `and` before its last.
pub(super) fn and(all: &[&str]) -> String {
    match all {
        [] => String::new(),
        [one] => (*one).to_owned(),
        [first @ .., last] => format!("{} and {last}", first.join(", ")),
    }
}

pub(super) fn digit(digit: Digit) -> &'static str {
    match digit {
        Digit::Thumb => "the thumb",
        Digit::Index => "the index finger",
        Digit::Middle => "the middle finger",
        Digit::Ring => "the ring finger",
        Digit::Pinky => "the little finger",
    }
}

/// Digits with their articles.
pub(super) fn fingers(digits: Digits) -> String {
    if digits == Digits::FINGERS {
        return "the four fingers".to_owned();
    }
    and(&digits.iter().map(digit).collect::<Vec<_>>())
}

/// A part of a finger, without an article.
pub(super) fn part(part: HandPart) -> &'static str {
    match part {
        HandPart::Tip => "tip",
        HandPart::Nail => "nail",
        HandPart::Pad => "pad",
        HandPart::Midjoint => "middle joint",
        HandPart::Base => "knuckle",
        HandPart::Side => "side",
        HandPart::Palm => "palm",
        HandPart::Back => "back",
        HandPart::ThumbSide => "thumb's edge",
        HandPart::PinkySide => "little finger's edge",
        HandPart::ThumbBall => "ball of the thumb",
        HandPart::Wrist => "wrist",
        HandPart::WristBack => "back of the wrist",
        HandPart::WristPulse => "inside of the wrist",
        HandPart::LowerArm => "forearm",
        HandPart::Elbow => "elbow",
        HandPart::ElbowInside => "crook of the elbow",
        HandPart::UpperArm => "upper arm",
    }
}

/// A part of a hand or an arm, or halfway between two.
pub(super) fn point(of: HandPoint) -> String {
    match of.second() {
        None => spot(of),
        Some(second) => format!("the point halfway from {} to {}", spot(of.first()), spot(second)),
    }
}

fn spot(point: HandPoint) -> String {
    let flank = match point.flank() {
        None => "",
        Some(Flank::Radial) => " (on the thumb's side)",
        Some(Flank::Ulnar) => " (on the little finger's side)",
        Some(Flank::Dorsal) => " (on the back)",
        Some(Flank::Palmar) => " (on the palm's side)",
    };
    if point.digits().is_empty() {
        format!("the {}{flank}", part(point.part()))
    } else {
        format!("the {} of {}{flank}", part(point.part()), fingers(point.digits()))
    }
}

/// A place as a noun with its article.
pub(super) fn place(v: &Place) -> String {
    match v {
        Place::Body(name) if name == "neutral" => "the neutral place before the chest".to_owned(),
        Place::Body(name) => format!("the {}", name.replace('-', " ")),
        Place::OtherHand(of) => {
            let arm = [HandPart::LowerArm, HandPart::Elbow, HandPart::ElbowInside, HandPart::UpperArm];
            let limb = if arm.contains(&of.part()) { "the other arm" } else { "the other hand" };
            format!("{} of {limb}", point(*of))
        }
        Place::Space(cell) => {
            let axes = [
                one_of(cell.left, "on the right", "on the left"),
                one_of(cell.high, "low", "high"),
                one_of(cell.far, "near", "far"),
            ];
            let words: Vec<&str> = axes.into_iter().flatten().collect();
            let words = if words.is_empty() { "in the middle".to_owned() } else { words.join(", ") };
            format!("the space before the signer ({words})")
        }
        Place::Point(p) => {
            format!("the point {} m to the left, {} m up, {} m forward", number(p.x), number(p.y), number(p.z))
        }
        Place::Between(a, b) if a.place == b.place => {
            let sides = [a.lateral.map_or("the middle", flank), b.lateral.map_or("the middle", flank)];
            format!("the point halfway between {} and {} of {}", sides[0], sides[1], place(&a.place))
        }
        Place::Between(a, b) => format!("the point halfway between {} and {}", sited(a), sited(b)),
        Place::Referent(name) => format!("the place of “{name}”"),
        Place::Towards(at) => format!("the point from which the hand points at {}", place(at)),
    }
}

fn sited(v: &Sited) -> String {
    match v.lateral {
        None => place(&v.place),
        Some(lateral) => format!("{} ({})", place(&v.place), side(lateral)),
    }
}

/// On which side of a place.
fn side(v: Lateral) -> &'static str {
    match v {
        Lateral { side: Side::Left, beside: false } => "on the left side",
        Lateral { side: Side::Right, beside: false } => "on the right side",
        Lateral { side: Side::Left, beside: true } => "beside it on the left",
        Lateral { side: Side::Right, beside: true } => "beside it on the right",
    }
}

/// A side of a place, as a noun.
fn flank(v: Lateral) -> &'static str {
    match v {
        Lateral { side: Side::Left, beside: false } => "the left side",
        Lateral { side: Side::Right, beside: false } => "the right side",
        Lateral { side: Side::Left, beside: true } => "the left outside",
        Lateral { side: Side::Right, beside: true } => "the right outside",
    }
}

pub(super) fn placement(v: &Placement) -> String {
    let noun = place(&v.place);
    let mut text = match v.distance {
        Distance::Unmarked => format!("at {noun}"),
        Distance::Touch => format!("touching {noun}"),
        Distance::Close => format!("close to {noun}"),
        Distance::Neutral => format!("at the usual distance from {noun}"),
        Distance::Extended => format!("the arm stretched towards {noun}"),
        Distance::Metres(metres) => format!("{} from {noun}", length(metres)),
    };
    if let Some(lateral) = v.lateral {
        text.push_str(&format!(", {}", side(lateral)));
    }
    if v.behind {
        text.push_str(", from behind");
    }
    if let Some(with) = v.with {
        text.push_str(&format!(", with {}", point(with)));
    }
    if let Some((way, metres)) = v.offset {
        text.push_str(&format!(", {} {} of there", length(metres), direction(way)));
    }
    text
}

/// `up, forward and to the left`.
pub(super) fn direction(v: Direction) -> String {
    let [left, up, out] = v.signs();
    let parts = [
        one_of(up, "down", "up"),
        one_of(out, "towards the body", "forward"),
        one_of(left, "to the right", "to the left"),
    ];
    and(&parts.into_iter().flatten().collect::<Vec<_>>())
}

/// The word of a negative or a positive number.
fn one_of(value: i8, minus: &'static str, plus: &'static str) -> Option<&'static str> {
    match value.signum() {
        -1 => Some(minus),
        1 => Some(plus),
        _ => None,
    }
}

pub(super) fn heading(v: Heading) -> String {
    match v {
        Heading::Toward(way) => direction(way),
        Heading::Between(a, b) => format!("halfway between “{}” and “{}”", direction(a), direction(b)),
    }
}
