//! A sign in one sentence: who, with which hand shape, pointing and facing where, at what place, does what.

use super::Tongue;
use super::phrases::Sentence;
use super::{english, english_movement, english_noun, french, french_movement, french_noun};
use crate::notation::hamnosys::Dictionary;
use crate::notation::hamnosys::raise::shape::shape;
use crate::notation::hamnosys::syntax::{Bend, BentClass, ShapeClass, Thumb, ThumbSpecial};
use crate::phonology::{Configuration, Digits, Hands, Manual, Movement, Orientation, Relation, Sign};

/// So many movements are told; of more, how many there are.
const TOLD: usize = 3;

/// A phase of a sign of a language in one sentence.
pub(super) fn sentence(sign: &Sign, language: &str, tongue: Tongue) -> String {
    let words = &tongue.phrases().sentence;
    let teller = Teller { language, words, tongue };
    let strong = || teller.hand(words.strong, &sign.strong, words.makes);
    let said = match sign.hands {
        Hands::Strong => strong(),
        Hands::Weak => teller.hand(words.other, &sign.weak, words.makes),
        Hands::Both(Some(_)) if sign.weak.is_empty() => teller.hand(words.both, &sign.strong, words.make),
        Hands::Both(Some(symmetry)) => {
            let like = match symmetry.relation {
                Relation::Mirrored => words.mirrors,
                Relation::Parallel => words.likewise,
            };
            let (own, movement) = teller.parts(&sign.weak, words.makes);
            let own: Vec<String> = own.into_iter().chain(movement).collect();
            format!("{}; {}{like}{}{}{}", strong(), words.other, words.but, teller.colon(), own.join(", "))
        }
        Hands::Both(None) => format!("{}; {}", strong(), teller.hand(words.other, &sign.weak, words.makes)),
    };
    let mut letters = said.chars();
    let capital = letters.next().map(|c| c.to_uppercase().to_string()).unwrap_or_default();
    format!("{capital}{}.", letters.as_str())
}

/// Who tells: of which sign language, in which words.
struct Teller<'a> {
    language: &'a str,
    words: &'a Sentence,
    tongue: Tongue<'a>,
}

impl Teller<'_> {
    /// What one hand, or both as one, is and does.
    fn hand(&self, who: &str, own: &Manual, verb: &str) -> String {
        let (stands, movement) = self.parts(own, verb);
        let movement = movement.unwrap_or_else(|| self.words.held.to_owned());
        if stands.is_empty() {
            return format!("{who} {movement}");
        }
        format!("{who}, {}, {movement}", stands.join(", "))
    }

    /// Shape, orientation and place at the start, as far as they are stated; and the movements.
    fn parts(&self, own: &Manual, verb: &str) -> (Vec<String>, Option<String>) {
        let shape = own.configuration.at(0).map(|c| self.shape(c));
        let orientation = own.orientation.at(0).map(|o| self.orientation(o));
        let placement = own.placement.at(0).map(|p| match self.tongue {
            Tongue::English => english_noun::placement(p),
            Tongue::French(names) => french_noun::placement(p, names),
        });
        let movements: Vec<String> =
            own.movement.iter().enumerate().take(TOLD).map(|m| self.movement(m, own)).collect();
        let left = own.movement.len().saturating_sub(TOLD);
        let more = if left > 0 { format!("{}… (+ {left})", self.words.then) } else { String::new() };
        let movement = (!movements.is_empty()).then(|| format!("{verb} {}{more}", movements.join(self.words.then)));
        ([shape, orientation, placement].into_iter().flatten().collect(), movement)
    }

    /// The movement from one posture to the next. If the hand only changes to that, it is told what it then is.
    fn movement(&self, (key, movement): (usize, &Movement), own: &Manual) -> String {
        let (said, next) = match self.tongue {
            Tongue::English => (english_movement::movement(movement), english_movement::NEXT),
            Tongue::French(names) => (french_movement::movement(movement, names), french_movement::NEXT),
        };
        let shape = own.configuration.stated(key + 1).map(|c| self.shape(c));
        let orientation = own.orientation.stated(key + 1).map(|o| self.orientation(o));
        let becomes: Vec<String> = [shape, orientation].into_iter().flatten().collect();
        if becomes.is_empty() { said } else { said.replace(next, &format!("{next} ({})", becomes.join(", "))) }
    }

    fn orientation(&self, of: &Orientation) -> String {
        match self.tongue {
            Tongue::English => english::orientation(of),
            Tongue::French(_) => french::orientation(of),
        }
    }

    fn colon(&self) -> &'static str {
        self.tongue.phrases().colon
    }

    /// A hand shape in words, where HamNoSys has it; else by its name.
    fn shape(&self, of: &Configuration) -> String {
        let Teller { language, words, tongue } = self;
        let language = (!language.is_empty()).then_some(*language);
        let Ok(shape) = shape(of, language, Dictionary::builtin()) else {
            return format!("{}{}", words.named, of.base);
        };
        let listed = Digits::of(shape.fingers.iter().map(|f| f.finger));
        let listed = match tongue {
            _ if listed.is_empty() => String::new(),
            Tongue::English => format!(" ({})", english_noun::fingers(listed)),
            Tongue::French(_) => format!(" ({})", french_noun::fingers(listed)),
        };
        let first = bent_class(shape.main, &listed, *tongue);
        let text = match shape.between {
            None => first,
            Some(second) => format!("{}{first}{}{}", words.halfway, words.and, bent_class(second, "", *tongue)),
        };
        let thumb = match (shape.thumb, tongue) {
            (Some(ThumbSpecial::Between(..)), Tongue::English) => ", the thumb between two fingers",
            (Some(ThumbSpecial::Between(..)), Tongue::French(_)) => ", le pouce entre deux doigts",
            (Some(ThumbSpecial::Enclosed), Tongue::English) => ", the thumb under the fingers",
            (Some(ThumbSpecial::Enclosed), Tongue::French(_)) => ", le pouce sous les doigts",
            (Some(ThumbSpecial::Exempted | ThumbSpecial::At(_)) | None, _) => "",
        };
        text + thumb
    }
}

/// A class with the fingers that it is made of, where they are not the usual ones, its thumb and bend: "a flat hand with the
/// thumb out".
fn bent_class(bent: BentClass, fingers: &str, tongue: Tongue) -> String {
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
    format!("{class}{fingers}{thumb}{bend}")
}
