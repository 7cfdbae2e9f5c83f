//! Movements in French words: noun phrases, so that they join with `puis` and `et en même temps`.

use super::french::becoming;
use super::french_noun::{grows, heading, length, number, of_fingers, place, placement, towards};
use crate::phonology::{
    Action, Digits, Extent, LocationInventory, Manner, Motion, Movement, Overlay, Repetition, RepetitionKind, Size,
    WristMotion,
};

/// What a hand changes to that only changes.
pub(super) const NEXT: &str = "la posture suivante";

pub(super) fn movement(v: &Movement, names: &LocationInventory) -> String {
    let parts = |all: &[Movement], by: &str| all.iter().map(|m| part(m, names)).collect::<Vec<_>>().join(by);
    match v {
        Movement::Action(action) => said(action, names),
        Movement::Sequence(all) => parts(all, ", puis "),
        Movement::Together(all) => parts(all, " et en même temps "),
        Movement::Fused(all) => format!("fondus en un seul geste : {}", parts(all, " et ")),
        Movement::Repeated(r) => {
            let turns = if r.alternating { ", les mains tour à tour" } else { "" };
            format!("({}), le tout {}{turns}", movement(&r.movement, names), repeated(r.repetition))
        }
        Movement::Backwards(inner) => format!("à rebours : {}", part(inner, names)),
    }
}

fn part(v: &Movement, names: &LocationInventory) -> String {
    match v {
        Movement::Action(_) => movement(v, names),
        Movement::Sequence(_)
        | Movement::Together(_)
        | Movement::Fused(_)
        | Movement::Repeated(_)
        | Movement::Backwards(_) => {
            format!("({})", movement(v, names))
        }
    }
}

fn said(v: &Action, names: &LocationInventory) -> String {
    let mut text = motion(&v.motion);
    let mut add = |more: String| {
        text.push_str(", ");
        text.push_str(&more);
    };
    if let Some(target) = &v.target {
        add(format!("jusqu'{}", placement(target, names)));
    }
    if let Some(brushed) = &v.brushing {
        add(format!("en frôlant {}", place(&brushed.place, names)));
    }
    for manner in &v.manner {
        add(match manner {
            Manner::Fast => "rapidement",
            Manner::Slow => "lentement",
            Manner::Tense => "avec tension",
            Manner::Rest => "après une pause",
            Manner::Halt => "avec un arrêt net",
            Manner::Bouncing => "avec un rebond",
            Manner::TowardPinky => "un doigt après l'autre jusqu'à l'auriculaire",
            Manner::TowardThumb => "un doigt après l'autre jusqu'au pouce",
        }
        .into());
    }
    if let Some(repetition) = v.repetition {
        add(repeated(repetition));
    }
    if let Some(long) = v.duration {
        add(format!("en {} s", number(long.0)));
    }
    if v.pace != 1.0 {
        add(format!("{} fois plus vite", number(v.pace)));
    }
    if v.alternating {
        add("les mains tour à tour".into());
    }
    if let Some(posture) = &v.becoming {
        add(format!("la main devenant entre-temps {}", becoming(posture)));
    }
    if let Some(name) = &v.names {
        add(format!("jusqu'à un lieu nommé « {name} »"));
    }
    text
}

fn repeated(v: Repetition) -> String {
    let way = match v.kind {
        RepetitionKind::FromStart => "en revenant chaque fois au départ",
        RepetitionKind::Continue => "chaque fois à partir de l'arrivée",
        RepetitionKind::ToAndFro => "en va-et-vient",
    };
    let times = match (v.kind, v.times) {
        (RepetitionKind::ToAndFro, n) => format!("{way}, {n} fois"),
        (RepetitionKind::FromStart | RepetitionKind::Continue, n) => format!("{n} fois en tout, {way}"),
    };
    let shift = v.shift.map(|s| {
        let far = match s.size {
            Size::Small => "un peu ",
            Size::Normal => "",
            Size::Large => "loin ",
        };
        format!(", en se déplaçant {far}{}", towards(s.direction))
    });
    format!("{times}{}{}", grows(v.growth), shift.unwrap_or_default())
}

fn motion(v: &Motion) -> String {
    match v {
        Motion::Hold => "posture tenue".into(),
        Motion::Change => format!("passage à {NEXT}"),
        Motion::Return { key: 0 } => "retour au départ".into(),
        Motion::Return { key } => format!("retour à la posture {}", key + 1),
        Motion::Straight { direction, extent, overlay } => {
            format!("{} {}{}", sized("trajet droit", *extent), heading(*direction), waves(*overlay))
        }
        Motion::Arc { direction, extent, bulge, depth, overlay } => {
            let bend = match depth {
                Size::Small => "peu bombé",
                Size::Normal => "bombé",
                Size::Large => "très bombé",
            };
            let arc = sized("arc", *extent);
            format!("{arc} {}, {bend} {}{}", heading(*direction), heading(*bulge), waves(*overlay))
        }
        Motion::Circle { axis, extent, start, turns, ellipse, growth, overlay } => {
            let mut text = match extent {
                Extent::Metres(metres) => format!("cercle de {} de rayon", length(*metres)),
                Extent::Size(_) => sized("cercle", *extent),
            };
            text.push_str(&format!(" dans le sens horaire pour qui regarde {}", heading(*axis)));
            if start.eighths() != 0 {
                text.push_str(&format!(", depuis {}", hour(start.eighths())));
            }
            if *turns != 1.0 {
                let tours = if *turns >= 2.0 { "tours" } else { "tour" };
                text.push_str(&format!(", {} {tours}", number(*turns)));
            }
            if let Some((ratio, along)) = ellipse {
                text.push_str(&format!(", aplati à {}, son grand axe {}", number(*ratio), towards(*along)));
            }
            text + grows(*growth) + &waves(*overlay)
        }
        Motion::Wrist(way, size) => {
            let way = match way {
                WristMotion::Nod => "flexions du poignet",
                WristMotion::Swing => "balancement latéral du poignet",
                WristMotion::Twist => "rotations de l'avant-bras",
                WristMotion::StirClockwise => "brassage du poignet dans le sens horaire",
                WristMotion::StirCounterclockwise => "brassage du poignet dans le sens antihoraire",
            };
            match size {
                Size::Small => format!("{way}, de faible amplitude"),
                Size::Normal => way.into(),
                Size::Large => format!("{way}, de grande amplitude"),
            }
        }
        Motion::Wiggle(digits) if digits.is_empty() || *digits == Digits::FINGERS => "jeu des doigts".into(),
        Motion::Wiggle(digits) => format!("jeu {}", of_fingers(*digits)),
    }
}

/// `petit arc`, `arc de 15 cm`.
fn sized(noun: &str, extent: Extent) -> String {
    match extent {
        Extent::Size(Size::Small) => format!("petit {noun}"),
        Extent::Size(Size::Normal) => noun.to_owned(),
        Extent::Size(Size::Large) => format!("grand {noun}"),
        Extent::Metres(metres) => format!("{noun} de {}", length(metres)),
    }
}

fn waves(overlay: Option<Overlay>) -> String {
    let Some(Overlay { zigzag, size, across, growth }) = overlay else { return String::new() };
    let way = if zigzag { "en zigzag" } else { "en ondulant" };
    let mut text = match size {
        Size::Small => format!(", {way} un peu"),
        Size::Normal => format!(", {way}"),
        Size::Large => format!(", {way} beaucoup"),
    };
    if let Some(across) = across {
        text.push_str(&format!(" {}", towards(across)));
    }
    text + grows(growth)
}

/// The hour of a place on the clock face, in eighths of a turn from the top.
fn hour(eighths: u8) -> &'static str {
    ["12 heures", "1 h 30", "3 heures", "4 h 30", "6 heures", "7 h 30", "9 heures", "10 h 30"][usize::from(eighths % 8)]
}
