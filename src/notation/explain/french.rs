//! Values in French words: nouns with their articles, so that `de` and `à` contract as they must.
//!
//! Names of handshapes and of non-manual values are those of the inventories, as they are written in a sign.

use super::french_movement::movement;
use crate::phonology::operator::Operator;
use crate::phonology::recombination::{Base, Recombination};
use crate::phonology::{
    Amount, Bend, Channel, Configuration, Contact, ContactKind, Digit, Digits, Direction, Distance, Flank, HandPart,
    HandPoint, HandshapeChange, Heading, Keys, Lateral, LocationInventory, Manual, NonManual, NonManualValue,
    Orientation, Place, Placement, Side, Sign, ThumbPosition,
};

/// One manual tier by its number in the tables: configuration, placement, orientation, movement.
pub(super) fn tier(manual: &Manual, intervals: usize, number: usize, names: &LocationInventory) -> String {
    match number {
        0 => keys(&manual.configuration, intervals, configuration),
        1 => keys(&manual.placement, intervals, |p| placement(p, names)),
        2 => keys(&manual.orientation, intervals, orientation),
        _ => {
            let all: Vec<String> = manual.movement.iter().map(|m| movement(m, names)).collect();
            all.join(", puis ")
        }
    }
}

/// The tiers of the whole sign: label and words.
pub(super) fn whole(sign: &Sign, names: &LocationInventory) -> Vec<(&'static str, String)> {
    let mut all = Vec::new();
    if !sign.contact.is_empty() {
        all.push(("le contact", keys(&sign.contact, sign.intervals, contact)));
    }
    for (channel, values) in &sign.nonmanual {
        all.push((channel_name(*channel), keys(values, sign.intervals, |v| nonmanual(v, names))));
    }
    if let Some(long) = sign.duration {
        all.push(("la durée", format!("{} s", number(long.0))));
    }
    if sign.speed != 1.0 {
        all.push(("la vitesse", format!("{} fois la vitesse habituelle", number(sign.speed))));
    }
    if !sign.base.is_empty() {
        let attested = sign.base.iter().map(|a| configuration(&a.configuration)).collect::<Vec<_>>();
        all.push(("base dérivationnelle, configurations attestées", attested.join(", ")));
    }
    if let Some(moved) = &sign.relocated {
        all.push(("le signe est déplacé", to(&place(&moved.place, names))));
    }
    let texts = [("la source", &sign.source), ("le statut", &sign.status), ("une remarque", &sign.note)];
    all.extend(texts.into_iter().filter_map(|(label, text)| Some((label, text.clone()?))));
    all
}

/// How a sign is made from others.
pub(super) fn making(from: &Recombination, names: &LocationInventory) -> String {
    let part = |p: &Recombination| match &p.base {
        Base::Named(_) | Base::Spelled(_) if p.operators.is_empty() => making(p, names),
        Base::Named(_) | Base::Spelled(_) | Base::Pointing(_) | Base::WristAt(_) | Base::Chain(_) | Base::Hands(..) => {
            format!("({})", making(p, names))
        }
    };
    let mut text = match &from.base {
        Base::Named(name) => name.clone(),
        Base::Spelled(word) => format!("l'épellation de {word}, d'une forme à l'autre"),
        Base::Pointing(at) => format!("un pointage vers {}", place(at, names)),
        Base::WristAt(point) => format!("le poignet {}", to(&place(&Place::Point(*point), names))),
        Base::Chain(parts) => parts.iter().map(part).collect::<Vec<_>>().join(", puis "),
        Base::Hands(strong, weak) => {
            format!("{} de la main dominante et {} de la main dominée", part(strong), part(weak))
        }
    };
    for operator in &from.operators {
        text.push_str(", ");
        text.push_str(&doing(operator, names));
    }
    text
}

fn doing(operator: &Operator, names: &LocationInventory) -> String {
    match operator {
        Operator::Inverted => "joué à rebours".into(),
        Operator::InvertedMovement => "son trajet joué à rebours".into(),
        Operator::Mirrored => "une main copiée en miroir sur l'autre".into(),
        Operator::Swapped => "les mains échangées".into(),
        Operator::Reflected => "vu dans un miroir, visage et regard compris".into(),
        Operator::Repeated { times, growth, .. } => format!("fait {times} fois en tout{}", grows(*growth)),
        Operator::Configuration(_, v) => format!("avec la configuration {}", joined(v, configuration)),
        Operator::Orientation(_, v) => format!("avec l'orientation {}", joined(v, orientation)),
        Operator::Placement(_, v) => format!("placé {}", joined(v, |p| placement(p, names))),
        Operator::Movement(_, all) => {
            let all: Vec<String> = all.iter().map(|m| movement(m, names)).collect();
            format!("avec le mouvement {}", all.join(", puis "))
        }
        Operator::NonManual(channel, v) => {
            format!("avec {} {}", channel_name(*channel), joined(v, |n| nonmanual(n, names)))
        }
        Operator::At(moved) => format!("déplacé {}", to(&place(&moved.place, names))),
        Operator::Speed(factor) => format!("{} fois plus vite", number(*factor)),
        Operator::Size(factor) => format!("ses trajets {} fois plus grands", number(*factor)),
    }
}

fn joined<T>(values: &Keys<T>, say: impl Fn(&T) -> String) -> String {
    values.iter().map(|(_, v)| say(v)).collect::<Vec<_>>().join(", puis ")
}

/// Values at keys; the keys are named where not all of them have a value.
fn keys<T>(values: &Keys<T>, intervals: usize, say: impl Fn(&T) -> String) -> String {
    let everywhere = values.len() == intervals + 1 || values.len() == 1 && values.stated(0).is_some();
    if everywhere {
        return joined(values, say);
    }
    let all: Vec<String> = values.iter().map(|(k, v)| format!("{} (posture {})", say(v), k + 1)).collect();
    all.join(", puis ")
}

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

fn configuration(v: &Configuration) -> String {
    let mut text = match &v.between {
        None => v.base.clone(),
        Some(second) => format!("à mi-chemin entre {} et {second}", v.base),
    };
    for change in &v.changes {
        text.push_str(", ");
        text.push_str(&match *change {
            HandshapeChange::Thumb(ThumbPosition::Along) => "le pouce le long de la main".to_owned(),
            HandshapeChange::Thumb(ThumbPosition::Out) => "le pouce écarté".to_owned(),
            HandshapeChange::Thumb(ThumbPosition::Across) => "le pouce en travers".to_owned(),
            HandshapeChange::Thumb(ThumbPosition::Opposed) => "le pouce opposé aux doigts".to_owned(),
            HandshapeChange::Bend(digits, bend) if digits.is_empty() => {
                format!("les doigts choisis {}s", bend_name(bend))
            }
            HandshapeChange::Bend(digits, bend) => {
                let plural = if digits.iter().count() > 1 { "s" } else { "" };
                format!("{} {}{plural}", fingers(digits), bend_name(bend))
            }
            HandshapeChange::Spread(true) => "les doigts écartés".to_owned(),
            HandshapeChange::Spread(false) => "les doigts joints".to_owned(),
            HandshapeChange::Cross(over, under) => format!("{} devant {}", digit(over), digit(under)),
            HandshapeChange::ThumbBetween(a, b) => format!("le pouce entre {} et {}", digit(a), digit(b)),
        });
    }
    text
}

/// Masculine; the plural adds an s.
fn bend_name(bend: Bend) -> &'static str {
    match bend {
        Bend::Straight => "tendu",
        Bend::Bent => "plié",
        Bend::HalfBent => "à demi plié",
        Bend::Round => "arrondi",
        Bend::Hooked => "recourbé",
        Bend::DoubleBent => "doublement plié",
        Bend::DoubleHooked => "doublement recourbé",
        Bend::Closed => "fermé",
    }
}

fn digit(digit: Digit) -> &'static str {
    match digit {
        Digit::Thumb => "le pouce",
        Digit::Index => "l'index",
        Digit::Middle => "le majeur",
        Digit::Ring => "l'annulaire",
        Digit::Pinky => "l'auriculaire",
    }
}

/// Digits with their articles.
fn fingers(digits: Digits) -> String {
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
fn point(point: HandPoint) -> String {
    let part = match point.part() {
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
    };
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
        Place::Between(a, b) => format!("le milieu entre {} et {}", place(a, names), place(b, names)),
        Place::Referent(name) => format!("le lieu de « {name} »"),
        Place::Towards(at) => format!("l'endroit d'où la main pointe vers {}", place(at, names)),
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
    text.push_str(match v.lateral {
        None => "",
        Some(Lateral { side: Side::Left, beside: false }) => ", du côté gauche",
        Some(Lateral { side: Side::Right, beside: false }) => ", du côté droit",
        Some(Lateral { side: Side::Left, beside: true }) => ", sur la gauche, à côté",
        Some(Lateral { side: Side::Right, beside: true }) => ", sur la droite, à côté",
    });
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

fn orientation(v: &Orientation) -> String {
    let fingers = v.fingers.map(|h| format!("doigts {}", heading(h)));
    let palm = v.palm.map(|h| format!("paume {}", heading(h)));
    let along = v.along_path.then(|| "en tournant avec le trajet".to_owned());
    [fingers, palm, along].into_iter().flatten().collect::<Vec<_>>().join(", ")
}

fn contact(v: &Contact) -> String {
    let (strong, weak) = (point(v.strong), point(v.weak));
    let meets = match v.kind {
        ContactKind::Touch => format!("touche {weak}"),
        ContactKind::Close => format!("est tout près {}", of(&weak)),
        ContactKind::Crossed => format!("croise {weak}"),
        ContactKind::Interlocked => format!("s'entrelace avec {weak}"),
        ContactKind::Metres(metres) => format!("est à {} {}", length(metres), of(&weak)),
    };
    format!("{strong} de la main dominante {meets} de la main dominée")
}

fn channel_name(channel: Channel) -> &'static str {
    match channel {
        Channel::Head => "la tête",
        Channel::Torso => "le buste",
        Channel::Shoulders => "les épaules",
        Channel::Gaze => "le regard",
        Channel::Brows => "les sourcils",
        Channel::Lids => "les paupières",
        Channel::Nose => "le nez",
        Channel::Cheeks => "les joues",
        Channel::Mouth => "la bouche",
    }
}

fn nonmanual(v: &NonManual, names: &LocationInventory) -> String {
    let text = match &v.value {
        NonManualValue::Named(name) => format!("« {name} »"),
        NonManualValue::Towards(h) => heading(*h),
        NonManualValue::At(at) => format!("vers {}", place(&at.place, names)),
        NonManualValue::Mouthing(sounds) => format!("articule « {sounds} » sans voix"),
    };
    match v.amount {
        Amount::Slight => format!("{text}, légèrement"),
        Amount::Plain => text,
        Amount::Strong => format!("{text}, fortement"),
    }
}
