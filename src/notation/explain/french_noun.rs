//! French nouns with their articles, so that `de` and `à` contract as they must: numbers, fingers, places, directions.

use crate::phonology::{
    Digit, Digits, Direction, Distance, Flank, HandPart, HandPoint, Heading, Lateral, LocationInventory, Place,
    Placement, Side, Sited,
};

/// `de` with a noun: du front, des yeux, de la joue, de l'oreille.
pub(super) fn of(noun: &str) -> String {
    contracted(noun, ["du ", "des ", "de "])
}

/// `à` with a noun: au front, aux yeux, à la joue, à l'oreille.
pub(super) fn to(noun: &str) -> String {
    contracted(noun, ["au ", "aux ", "à "])
}

fn contracted(noun: &str, [le, les, other]: [&str; 3]) -> String {
    match (noun.strip_prefix("le "), noun.strip_prefix("les ")) {
        (Some(rest), _) => format!("{le}{rest}"),
        (_, Some(rest)) => format!("{les}{rest}"),
        (None, None) => format!("{other}{noun}"),
    }
}

/// With a comma, and two decimals at most.
pub(super) fn number(value: f64) -> String {
    let text = format!("{value:.2}");
    text.trim_end_matches('0').trim_end_matches('.').replace('.', ",")
}

/// Metres as centimetres.
pub(super) fn length(metres: f64) -> String {
    format!("{} cm", number(metres * 100.0))
}

pub(super) fn grows(growth: i8) -> &'static str {
    match growth.signum() {
        1 => ", de plus en plus ample",
        -1 => ", de moins en moins ample",
        _ => "",
    }
}

/// A list with `et` before its last.
pub(super) fn and(all: &[&str]) -> String {
    match all {
        [] => String::new(),
        [one] => (*one).to_owned(),
        [first @ .., last] => format!("{} et {last}", first.join(", ")),
    }
}

pub(super) fn digit(digit: Digit) -> &'static str {
    match digit {
        Digit::Thumb => "le pouce",
        Digit::Index => "l'index",
        Digit::Middle => "le majeur",
        Digit::Ring => "l'annulaire",
        Digit::Pinky => "l'auriculaire",
    }
}

/// Digits with their articles.
pub(super) fn fingers(digits: Digits) -> String {
    if digits == Digits::FINGERS {
        return "les quatre doigts".to_owned();
    }
    and(&digits.iter().map(digit).collect::<Vec<_>>())
}

/// `de l'index et du majeur`.
pub(super) fn of_fingers(digits: Digits) -> String {
    if digits == Digits::FINGERS {
        return "des quatre doigts".to_owned();
    }
    let all: Vec<String> = digits.iter().map(|d| of(digit(d))).collect();
    and(&all.iter().map(String::as_str).collect::<Vec<_>>())
}

/// A part of a hand or an arm, with its article.
pub(super) fn part(part: HandPart) -> &'static str {
    match part {
        HandPart::Tip => "le bout",
        HandPart::Nail => "l'ongle",
        HandPart::Pad => "la pulpe",
        HandPart::Midjoint => "l'articulation du milieu",
        HandPart::Base => "la base",
        HandPart::Side => "le côté",
        HandPart::Palm => "la paume",
        HandPart::Back => "le dos",
        HandPart::ThumbSide => "le bord du pouce",
        HandPart::PinkySide => "le bord de l'auriculaire",
        HandPart::ThumbBall => "l'éminence du pouce",
        HandPart::Wrist => "le poignet",
        HandPart::WristBack => "le dos du poignet",
        HandPart::WristPulse => "l'intérieur du poignet",
        HandPart::LowerArm => "l'avant-bras",
        HandPart::Elbow => "le coude",
        HandPart::ElbowInside => "le creux du coude",
        HandPart::UpperArm => "le haut du bras",
    }
}

/// A part of a hand or an arm, or halfway between two.
pub(super) fn point(of: HandPoint) -> String {
    match of.second() {
        None => spot(of),
        Some(second) => format!("le point à mi-chemin entre {} et {}", spot(of.first()), spot(second)),
    }
}

fn spot(point: HandPoint) -> String {
    let part = part(point.part());
    let flank = match point.flank() {
        None => "",
        Some(Flank::Radial) => " (côté pouce)",
        Some(Flank::Ulnar) => " (côté auriculaire)",
        Some(Flank::Dorsal) => " (côté dos)",
        Some(Flank::Palmar) => " (côté paume)",
    };
    if point.digits().is_empty() {
        format!("{part}{flank}")
    } else {
        format!("{part} {}{flank}", of_fingers(point.digits()))
    }
}

/// A place as a noun with its article.
pub(super) fn place(v: &Place, names: &LocationInventory) -> String {
    match v {
        Place::Body(name) => match names.get(name) {
            Some(row) if !row.french.is_empty() => row.french.clone(),
            _ => format!("le lieu « {name} »"),
        },
        Place::OtherHand(of) => {
            let limb = match of.part() {
                HandPart::LowerArm | HandPart::Elbow | HandPart::ElbowInside | HandPart::UpperArm => "l'autre bras",
                HandPart::Tip
                | HandPart::Nail
                | HandPart::Pad
                | HandPart::Midjoint
                | HandPart::Base
                | HandPart::Side
                | HandPart::Palm
                | HandPart::Back
                | HandPart::ThumbSide
                | HandPart::PinkySide
                | HandPart::ThumbBall
                | HandPart::Wrist
                | HandPart::WristBack
                | HandPart::WristPulse => "l'autre main",
            };
            format!("{} de {limb}", point(*of))
        }
        Place::Space(cell) => {
            let axes = [
                one_of(cell.left, "à droite", "à gauche"),
                one_of(cell.high, "en bas", "en haut"),
                one_of(cell.far, "près", "loin"),
            ];
            let words: Vec<&str> = axes.into_iter().flatten().collect();
            let words = if words.is_empty() { "au centre".to_owned() } else { words.join(", ") };
            format!("l'espace devant le signeur ({words})")
        }
        Place::Point(p) => {
            format!("le point à {} m à gauche, {} m de haut, {} m devant", number(p.x), number(p.y), number(p.z))
        }
        Place::Between(a, b) if a.place == b.place => {
            let sides = [a.lateral.map_or("le milieu", flank), b.lateral.map_or("le milieu", flank)];
            format!("le point à mi-chemin entre {} et {} {}", sides[0], sides[1], of(&place(&a.place, names)))
        }
        Place::Between(a, b) => format!("le milieu entre {} et {}", sited(a, names), sited(b, names)),
        Place::Referent(name) => format!("le lieu de « {name} »"),
        Place::Towards(at) => format!("l'endroit d'où la main pointe vers {}", place(at, names)),
    }
}

fn sited(v: &Sited, names: &LocationInventory) -> String {
    match v.lateral {
        None => place(&v.place, names),
        Some(lateral) => format!("{} ({})", place(&v.place, names), side(lateral)),
    }
}

/// On which side of a place.
fn side(v: Lateral) -> &'static str {
    match v {
        Lateral { side: Side::Left, beside: false } => "du côté gauche",
        Lateral { side: Side::Right, beside: false } => "du côté droit",
        Lateral { side: Side::Left, beside: true } => "sur la gauche, à côté",
        Lateral { side: Side::Right, beside: true } => "sur la droite, à côté",
    }
}

/// A side of a place, as a noun.
fn flank(v: Lateral) -> &'static str {
    match v {
        Lateral { side: Side::Left, beside: false } => "le côté gauche",
        Lateral { side: Side::Right, beside: false } => "le côté droit",
        Lateral { side: Side::Left, beside: true } => "l'extérieur gauche",
        Lateral { side: Side::Right, beside: true } => "l'extérieur droit",
    }
}

pub(super) fn placement(v: &Placement, names: &LocationInventory) -> String {
    let noun = place(&v.place, names);
    let mut text = match v.distance {
        Distance::Unmarked => to(&noun),
        Distance::Touch => format!("au contact {}", of(&noun)),
        Distance::Close => format!("à proximité {}", of(&noun)),
        Distance::Neutral => format!("à distance neutre {}", of(&noun)),
        Distance::Extended => format!("à bout de bras {}", of(&noun)),
        Distance::Metres(metres) => format!("à {} {}", length(metres), of(&noun)),
    };
    if let Some(lateral) = v.lateral {
        text.push_str(&format!(", {}", side(lateral)));
    }
    if v.behind {
        text.push_str(", par derrière");
    }
    if let Some(with) = v.with {
        text.push_str(&format!(", avec {}", point(with)));
    }
    if let Some((way, metres)) = v.offset {
        text.push_str(&format!(", avec un décalage de {} {}", length(metres), towards(way)));
    }
    text
}

/// `vers le haut, l'avant et la gauche`.
pub(super) fn towards(v: Direction) -> String {
    let [left, up, out] = v.signs();
    let parts =
        [one_of(up, "le bas", "le haut"), one_of(out, "le corps", "l'avant"), one_of(left, "la droite", "la gauche")];
    format!("vers {}", and(&parts.into_iter().flatten().collect::<Vec<_>>()))
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
        Heading::Toward(way) => towards(way),
        Heading::Between(a, b) => format!("à mi-chemin entre « {} » et « {} »", towards(a), towards(b)),
    }
}
