//! A sign in one sentence: who, with which hand shape, pointing and facing where, at what place, does what.

use super::Tongue;
use super::{english, english_movement, english_noun, french, french_movement, french_noun};
use crate::notation::hamnosys::Dictionary;
use crate::notation::hamnosys::raise::shape::shape;
use crate::notation::hamnosys::syntax::{Bend, BentClass, ShapeClass, Thumb, ThumbSpecial};
use crate::phonology::{Configuration, Digits, Hands, Manual, Sign};

/// So many movements are told; of more, how many there are.
const TOLD: usize = 3;

/// The words of a language for a sentence.
struct Words {
    strong: &'static str,
    other: &'static str,
    both: &'static str,
    makes: &'static str,
    make: &'static str,
    held: &'static str,
    then: &'static str,
    halfway: &'static str,
    and: &'static str,
    named: &'static str,
    on: &'static str,
}

const ENGLISH: Words = Words {
    strong: "the dominant hand",
    other: "the other hand",
    both: "both hands",
    makes: "makes",
    make: "make",
    held: "without movement",
    then: ", then ",
    halfway: "halfway between ",
    and: " and ",
    named: "the handshape ",
    on: " of the ",
};

const FRENCH: Words = Words {
    strong: "la main dominante",
    other: "l'autre main",
    both: "les deux mains",
    makes: "mouvement :",
    make: "mouvement :",
    held: "sans mouvement",
    then: ", puis ",
    halfway: "à mi-chemin entre ",
    and: " et ",
    named: "la configuration ",
    on: " : ",
};

/// A phase of a sign of a language in one sentence.
pub(super) fn sentence(sign: &Sign, language: &str, tongue: Tongue) -> String {
    let words = match tongue {
        Tongue::English => &ENGLISH,
        Tongue::French(_) => &FRENCH,
    };
    let one = |who: &str, own: &Manual, verb: &str| part(who, own, verb, (language, words), tongue);
    let said = match sign.hands {
        Hands::Strong => one(words.strong, &sign.strong, words.makes),
        Hands::Weak => one(words.other, &sign.weak, words.makes),
        Hands::Both(Some(_)) if sign.weak.is_empty() => one(words.both, &sign.strong, words.make),
        Hands::Both(_) => {
            format!("{}; {}", one(words.strong, &sign.strong, words.makes), one(words.other, &sign.weak, words.makes))
        }
    };
    let mut letters = said.chars();
    let capital = letters.next().map(|c| c.to_uppercase().to_string()).unwrap_or_default();
    format!("{capital}{}.", letters.as_str())
}

/// What one hand, or both as one, is and does.
fn part(who: &str, own: &Manual, verb: &str, (language, words): (&str, &Words), tongue: Tongue) -> String {
    let mut said = vec![who.to_owned()];
    said.extend(own.configuration.at(0).map(|c| hand_shape(c, language, words, tongue)));
    said.extend(own.orientation.at(0).map(|o| match tongue {
        Tongue::English => english::orientation(o),
        Tongue::French(_) => french::orientation(o),
    }));
    said.extend(own.placement.at(0).map(|p| match tongue {
        Tongue::English => english_noun::placement(p),
        Tongue::French(names) => french_noun::placement(p, names),
    }));
    let movements = own.movement.iter().take(TOLD).map(|m| match tongue {
        Tongue::English => english_movement::movement(m),
        Tongue::French(names) => french_movement::movement(m, names),
    });
    let movements = movements.collect::<Vec<_>>().join(words.then);
    let left = own.movement.len().saturating_sub(TOLD);
    let more = if left > 0 { format!("{}… (+ {left})", words.then) } else { String::new() };
    match movements.as_str() {
        "" => format!("{}, {}", said.join(", "), words.held),
        _ => format!("{}, {verb} {movements}{more}", said.join(", ")),
    }
}

/// A hand shape in words, where HamNoSys has it; else by its name.
fn hand_shape(configuration: &Configuration, language: &str, words: &Words, tongue: Tongue) -> String {
    let named = || format!("{}{}", words.named, configuration.base);
    let language = (!language.is_empty()).then_some(language);
    let Ok(shape) = shape(configuration, language, Dictionary::builtin()) else { return named() };
    let one = |bent: BentClass| bent_class(bent, tongue);
    let mut text = match shape.between {
        None => one(shape.main),
        Some(second) => format!("{}{}{}{}", words.halfway, one(shape.main), words.and, one(second)),
    };
    let listed = Digits::of(shape.fingers.iter().map(|f| f.finger));
    if !listed.is_empty() {
        let fingers = match tongue {
            Tongue::English => english_noun::fingers(listed),
            Tongue::French(_) => french_noun::fingers(listed),
        };
        text.push_str(&format!("{}{fingers}", words.on));
    }
    let thumb = match (shape.thumb, tongue) {
        (Some(ThumbSpecial::Between(..)), Tongue::English) => " and between two fingers",
        (Some(ThumbSpecial::Between(..)), Tongue::French(_)) => " et entre deux doigts",
        (Some(ThumbSpecial::Enclosed), Tongue::English) => " under the fingers",
        (Some(ThumbSpecial::Enclosed), Tongue::French(_)) => " sous les doigts",
        (Some(ThumbSpecial::Exempted | ThumbSpecial::At(_)) | None, _) => "",
    };
    text + thumb
}

/// A class with its thumb and bend: "a flat hand with the thumb out".
fn bent_class(bent: BentClass, tongue: Tongue) -> String {
    let pick = |[english, french]: [&'static str; 2]| match tongue {
        Tongue::English => english,
        Tongue::French(_) => french,
    };
    let class = pick(match bent.class {
        ShapeClass::Fist => ["a fist", "un poing"],
        ShapeClass::Flat => ["a flat hand", "une main plate"],
        ShapeClass::Finger2 => ["one finger stretched", "un doigt tendu"],
        ShapeClass::Finger23 => ["two fingers stretched together", "deux doigts tendus joints"],
        ShapeClass::Finger23Spread => ["two fingers stretched and spread", "deux doigts tendus écartés"],
        ShapeClass::Finger2345 => ["all fingers spread", "tous les doigts écartés"],
        ShapeClass::Pinch12 => ["thumb and finger pinched", "pouce et doigt en pince"],
        ShapeClass::PinchAll => ["all fingertips at the thumb", "tous les doigts au contact du pouce"],
        ShapeClass::Pinch12Open => {
            ["thumb and finger pinched, the others open", "pouce et doigt en pince, les autres ouverts"]
        }
        ShapeClass::Cee12 => ["thumb and finger in a C", "pouce et doigt en C"],
        ShapeClass::CeeAll => ["a hand in a C", "une main en C"],
        ShapeClass::Cee12Open => {
            ["thumb and finger in a C, the others open", "pouce et doigt en C, les autres ouverts"]
        }
    });
    let is_c = matches!(bent.class, ShapeClass::Cee12 | ShapeClass::CeeAll | ShapeClass::Cee12Open);
    let thumb = match (bent.thumb, is_c) {
        (None, _) => "",
        (Some(Thumb::Out), _) => pick([" with the thumb out", ", le pouce écarté"]),
        (Some(Thumb::Across), false) => pick([" with the thumb across", ", le pouce replié"]),
        (Some(Thumb::Open), false) => pick([" with the thumb opposed", ", le pouce opposé"]),
        (Some(Thumb::Across), true) => pick([" that is nearly closed", " presque fermé"]),
        (Some(Thumb::Open), true) => pick([" that is wide open", " grand ouvert"]),
    };
    let bend = match bent.bend {
        None => String::new(),
        Some(Bend::Bent) => pick([", bent at the knuckles", ", plié aux articulations"]).to_owned(),
        Some(Bend::HalfBent) => pick([", half bent", ", à demi plié"]).to_owned(),
        Some(Bend::Round) => pick([", rounded", ", arrondi"]).to_owned(),
        Some(Bend::Hooked) => pick([", hooked", ", en crochet"]).to_owned(),
        Some(Bend::DoubleBent) => pick([", doubly bent", ", doublement plié"]).to_owned(),
        Some(Bend::DoubleHooked) => pick([", closed to a claw", ", en griffe"]).to_owned(),
        Some(Bend::Quarters([a, b, c])) => format!(", {a}/{b}/{c}"),
    };
    format!("{class}{thumb}{bend}")
}
