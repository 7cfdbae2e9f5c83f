//! A sign's values in French words.
//!
//! Names of handshapes and of non-manual values are those of the inventories, as they are written in a sign.

use super::french_movement::movement;
use super::french_noun::{digit, fingers, grows, heading, length, number, of, place, placement, point, to};
use crate::phonology::operator::Operator;
use crate::phonology::recombination::{Base, Recombination};
use crate::phonology::{
    Amount, Bend, Channel, Configuration, Contact, ContactKind, HandPoint, HandshapeChange, Keys, LocationInventory,
    Manual, NonManual, NonManualValue, Opening, Orientation, Place, Sign, ThumbPosition,
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

/// Values at keys; the keys are named where not all of them have a value.
fn keys<T>(values: &Keys<T>, intervals: usize, say: impl Fn(&T) -> String) -> String {
    let everywhere = values.len() == intervals + 1 || values.len() == 1 && values.stated(0).is_some();
    if everywhere {
        return joined(values, say);
    }
    let all: Vec<String> = values.iter().map(|(k, v)| format!("{} (posture {})", say(v), k + 1)).collect();
    all.join(", puis ")
}

fn configuration(v: &Configuration) -> String {
    let mut text = match &v.between {
        None => v.base.clone(),
        Some(other) => format!("à mi-chemin entre {} et {}", v.base, other.second),
    };
    for change in &v.changes {
        text.push_str(", ");
        text.push_str(&match *change {
            HandshapeChange::Thumb(ThumbPosition::Along) => "le pouce le long de la main".to_owned(),
            HandshapeChange::Thumb(ThumbPosition::Out) => "le pouce écarté".to_owned(),
            HandshapeChange::Thumb(ThumbPosition::Across) => "le pouce en travers".to_owned(),
            HandshapeChange::Thumb(ThumbPosition::Opposed) => "le pouce opposé aux doigts".to_owned(),
            HandshapeChange::Thumb(ThumbPosition::Enclosed) => "le pouce sous les doigts fermés".to_owned(),
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
            HandshapeChange::On(digits) => format!("avec {}", fingers(digits)),
            HandshapeChange::Except(digits) => format!("sauf {}", fingers(digits)),
            HandshapeChange::Opening(Opening::Tight) => "presque fermée".to_owned(),
            HandshapeChange::Opening(Opening::Slack) => "grande ouverte".to_owned(),
            HandshapeChange::Meet(..) | HandshapeChange::ThumbAt(_) | HandshapeChange::Joints(..) => {
                "les doigts comme décrits".to_owned()
            }
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

fn orientation(v: &Orientation) -> String {
    let fingers = v.fingers.map(|h| format!("doigts {}", heading(h)));
    let palm = v.palm.map(|h| format!("paume {}", heading(h)));
    let along = v.along_path.then(|| "en tournant avec le trajet".to_owned());
    [fingers, palm, along].into_iter().flatten().collect::<Vec<_>>().join(", ")
}

fn contact(v: &Contact) -> String {
    let named = |of: Option<HandPoint>| of.map_or_else(|| "une partie".to_owned(), point);
    let (strong, weak) = (named(v.strong), named(v.weak));
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
        NonManualValue::Sequence(parts) => {
            parts.iter().map(|p| nonmanual(p, names)).collect::<Vec<_>>().join(", puis ")
        }
        NonManualValue::Together(parts) => {
            parts.iter().map(|p| nonmanual(p, names)).collect::<Vec<_>>().join(" et en même temps ")
        }
    };
    match v.amount {
        Amount::Slight => format!("{text}, légèrement"),
        Amount::Plain => text,
        Amount::Strong => format!("{text}, fortement"),
        Amount::Percent(percent) => format!("{text}, à {percent} %"),
    }
}
