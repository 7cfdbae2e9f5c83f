//! A sign's values in French words.
//!
//! Names of handshapes and of non-manual values are those of the inventories, as they are written in a sign.

use super::french_movement::movement;
use super::french_noun::{digit, fingers, grows, heading, length, number, of, part, place, placement, point, to};
use super::{Tier, keys};
use crate::phonology::operator::Operator;
use crate::phonology::recombination::{Base, Recombination};
use crate::phonology::{
    Amount, Becoming, Bend, Channel, Configuration, Contact, ContactKind, Digits, HandPoint, HandshapeChange, Keys,
    LocationInventory, Manual, NonManual, NonManualValue, Opening, Orientation, Place, Sign, ThumbPosition,
};

/// One manual tier.
pub(super) fn tier(manual: &Manual, intervals: usize, tier: Tier, names: &LocationInventory) -> String {
    match tier {
        Tier::Configuration => keys(&manual.configuration, intervals, JOIN, configuration),
        Tier::Placement => keys(&manual.placement, intervals, JOIN, |p| placement(p, names)),
        Tier::Orientation => keys(&manual.orientation, intervals, JOIN, orientation),
        Tier::Movement => manual.movement.iter().map(|m| movement(m, names)).collect::<Vec<_>>().join(JOIN[0]),
    }
}

/// Between values, and before the number of a key.
const JOIN: [&str; 2] = [", puis ", "posture"];

/// How the hands meet.
pub(super) fn contacts(sign: &Sign) -> String {
    keys(&sign.contact, sign.intervals, JOIN, contact)
}

/// Duration and speed, where they are stated: label and words.
pub(super) fn times(sign: &Sign) -> Vec<(&'static str, String)> {
    let mut all = Vec::new();
    if let Some(long) = sign.duration {
        all.push(("la durée", format!("{} s", number(long.0))));
    }
    if sign.speed != 1.0 {
        all.push(("la vitesse", format!("{} fois la vitesse habituelle", number(sign.speed))));
    }
    all
}

/// The tiers of the whole sign: label and words.
pub(super) fn whole(sign: &Sign, names: &LocationInventory) -> Vec<(&'static str, String)> {
    let mut all = Vec::new();
    for (channel, values) in &sign.nonmanual {
        all.push((channel_name(*channel), keys(values, sign.intervals, JOIN, |v| nonmanual(v, names))));
    }
    if !sign.base.is_empty() {
        let attested = sign.base.iter().map(|a| configuration(&a.configuration)).collect::<Vec<_>>();
        all.push(("base dérivationnelle, configurations attestées", attested.join(", ")));
    }
    if let Some(moved) = &sign.relocated {
        all.push(("le signe est déplacé", to(&place(&moved.place, names))));
    }
    let status = sign.status.as_deref().map(|s| if s == "unverified" { "non vérifié" } else { s });
    let texts = [("la source", sign.source.as_deref()), ("le statut", status), ("une remarque", sign.note.as_deref())];
    all.extend(texts.into_iter().filter_map(|(label, text)| Some((label, text?.to_owned()))));
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

fn configuration(v: &Configuration) -> String {
    let mixed = |name: &str, own: &[HandshapeChange]| match own {
        [] => name.to_owned(),
        own => format!("({name}{})", changes(own)),
    };
    let base = match &v.between {
        None => v.base.clone(),
        Some(b) => format!("à mi-chemin entre {} et {}", mixed(&v.base, &b.first), mixed(&b.second, &b.changes)),
    };
    base + &changes(&v.changes)
}

/// Changes, each with a comma before it.
fn changes(all: &[HandshapeChange]) -> String {
    all.iter().map(|one| format!(", {}", change(*one))).collect()
}

fn change(v: HandshapeChange) -> String {
    match v {
        HandshapeChange::Thumb(ThumbPosition::Along) => "le pouce le long de la main".into(),
        HandshapeChange::Thumb(ThumbPosition::Out) => "le pouce écarté".into(),
        HandshapeChange::Thumb(ThumbPosition::Across) => "le pouce en travers".into(),
        HandshapeChange::Thumb(ThumbPosition::Opposed) => "le pouce opposé aux doigts".into(),
        HandshapeChange::Thumb(ThumbPosition::Enclosed) => "le pouce sous les doigts fermés".into(),
        HandshapeChange::Bend(digits, bend) if digits.is_empty() => format!("les doigts choisis {}s", bend_name(bend)),
        HandshapeChange::Bend(digits, bend) => format!("{} {}{}", fingers(digits), bend_name(bend), plural(digits)),
        HandshapeChange::Spread(true) => "les doigts écartés".into(),
        HandshapeChange::Spread(false) => "les doigts joints".into(),
        HandshapeChange::Cross(over, under) => format!("{} devant {}", digit(over), digit(under)),
        HandshapeChange::ThumbBetween(a, b) => format!("le pouce entre {} et {}", digit(a), digit(b)),
        HandshapeChange::On(digits) => format!("formée par {}", fingers(digits)),
        HandshapeChange::Except(digits) => format!("{} resté{} comme avant", fingers(digits), plural(digits)),
        HandshapeChange::Opening(Opening::Tight) => "presque fermée".into(),
        HandshapeChange::Opening(Opening::Slack) => "grande ouverte".into(),
        HandshapeChange::Meet(one, at, other) => {
            format!("{} contre {} {}", digit(one), part(at), of(digit(other)))
        }
        HandshapeChange::ThumbAt(at) => format!("le pouce contre {} des doigts", part(at)),
        HandshapeChange::Joints(digits, [base, middle, last]) => {
            let (who, many) =
                if digits.is_empty() { ("les doigts choisis".into(), "s") } else { (fingers(digits), plural(digits)) };
            format!("{who} plié{many} de {base}, {middle} et {last} quarts à la base, au milieu et au bout")
        }
    }
}

fn plural(digits: Digits) -> &'static str {
    if digits.iter().count() > 1 { "s" } else { "" }
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

pub(super) fn orientation(v: &Orientation) -> String {
    let fingers = v.fingers.map(|h| format!("doigts {}", heading(h)));
    let palm = v.palm.map(|h| format!("paume {}", heading(h)));
    let along = v.along_path.then(|| "en tournant avec le trajet".to_owned());
    [fingers, palm, along].into_iter().flatten().collect::<Vec<_>>().join(", ")
}

fn contact(v: &Contact) -> String {
    let named = |of: Option<HandPoint>, hand: &str| match of {
        None => format!("la main {hand}"),
        Some(of) => format!("{} de la main {hand}", point(of)),
    };
    let (strong, weak) = (named(v.strong, "dominante"), named(v.weak, "dominée"));
    let meets = match v.kind {
        ContactKind::Touch => format!("touche {weak}"),
        ContactKind::Close => format!("est tout près {}", of(&weak)),
        ContactKind::Crossed => format!("croise {weak}"),
        ContactKind::Interlocked => format!("s'entrelace avec {weak}"),
        ContactKind::Metres(metres) => format!("est à {} {}", length(metres), of(&weak)),
    };
    format!("{strong} {meets}")
}

/// What a hand becomes during a movement.
pub(super) fn becoming(v: &Becoming) -> String {
    let shape = v.configuration.as_ref().map(configuration);
    let turned = v.orientation.as_ref().map(orientation);
    let meets = v.contact.as_ref().map(|c| format!("puis {}", contact(c)));
    [shape, turned, meets].into_iter().flatten().collect::<Vec<_>>().join(", ")
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
    let all = |parts: &[NonManual], by: &str| parts.iter().map(|p| nonmanual(p, names)).collect::<Vec<_>>().join(by);
    let text = match &v.value {
        NonManualValue::Named(name) => format!("« {name} »"),
        NonManualValue::Towards(h) => heading(*h),
        NonManualValue::At(at) => format!("vers {}", place(&at.place, names)),
        NonManualValue::Mouthing(sounds) => format!("articule « {sounds} » sans voix"),
        NonManualValue::Sequence(parts) => format!("({})", all(parts, ", puis ")),
        NonManualValue::Together(parts) => format!("({})", all(parts, " et en même temps ")),
    };
    let amount = match v.amount {
        Amount::Slight => ", légèrement".to_owned(),
        Amount::Plain => String::new(),
        Amount::Strong => ", fortement".to_owned(),
        Amount::Percent(percent) => format!(", à {percent} %"),
    };
    let pace = if v.pace == 1.0 { String::new() } else { format!(", {} fois plus vite", number(v.pace)) };
    text + &amount + &pace
}
