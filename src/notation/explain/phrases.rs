//! The words around the values, in each language: closed data.

use super::Tongue;

/// The words of one language.
pub(super) struct Phrases {
    /// Between the name and its language.
    pub of: &'static str,
    /// Around a word that something means.
    pub quotes: [&'static str; 2],
    /// Between a label and what is said.
    pub colon: &'static str,
    /// Where a value comes from.
    pub stated: &'static str,
    pub default: &'static str,
    pub symmetry: &'static str,
    pub counted: &'static str,
    /// Labels.
    pub hands: &'static str,
    pub counts: &'static str,
    pub strong: &'static str,
    pub weak: &'static str,
    pub contact: &'static str,
    pub duration: &'static str,
    /// What heads the first phase and a further one, and what is said there of a hand that does not act.
    pub phase: [&'static str; 2],
    pub other_stays: &'static str,
    pub made_from: &'static str,
    /// Configuration, placement, orientation, movement: its name, and what holds where it is not said.
    pub tiers: [[&'static str; 2]; 4],
    pub strong_alone: &'static str,
    pub weak_alone: &'static str,
    pub each_its_own: &'static str,
    pub both_mirrored: &'static str,
    pub both_parallel: &'static str,
    /// Of a symmetry: up and down, out and in, alternating, crossed.
    pub exchanged: [&'static str; 4],
    pub held: &'static str,
    pub postures: &'static str,
    pub movement_between: &'static str,
    pub movements_between: &'static str,
    pub mirrors: &'static str,
    pub goes_along: &'static str,
    pub joins_keys: &'static str,
    pub from_movements: &'static str,
    /// A phase in a sentence.
    pub sentence: Sentence,
}

/// The words of one language for a phase in a sentence.
pub(super) struct Sentence {
    pub strong: &'static str,
    pub other: &'static str,
    pub both: &'static str,
    /// What the other hand does in what is not said of it.
    pub mirrors: &'static str,
    pub likewise: &'static str,
    pub but: &'static str,
    pub makes: &'static str,
    pub make: &'static str,
    pub held: &'static str,
    pub then: &'static str,
    pub halfway: &'static str,
    pub and: &'static str,
    pub named: &'static str,
}

impl Tongue<'_> {
    pub(super) fn phrases(self) -> &'static Phrases {
        match self {
            Tongue::English => &ENGLISH,
            Tongue::French(_) => &FRENCH,
        }
    }
}

const ENGLISH: Phrases = Phrases {
    of: ", a sign of ",
    quotes: ["“", "”"],
    colon: ": ",
    stated: "stated",
    default: "default",
    symmetry: "symmetry",
    counted: "counted",
    hands: "hands",
    counts: "postures and movements",
    strong: "strong hand ",
    weak: "weak hand ",
    contact: "contact",
    duration: "duration",
    phase: ["phase", "then, phase"],
    other_stays: ", a hand that does not act staying where it was",
    made_from: "made from",
    tiers: [
        ["configuration", "relaxed"],
        ["placement", "the neutral place before the chest"],
        ["orientation", "the comfortable one at that place"],
        ["movement", "none of its own"],
    ],
    strong_alone: "the strong hand alone",
    weak_alone: "the weak hand alone",
    each_its_own: "both, each its own",
    both_mirrored: "both, the weak hand mirrors the strong",
    both_parallel: "both, the weak hand goes with the strong",
    exchanged: [", up and down exchanged", ", out and in exchanged", ", half a cycle apart", ", the arms crossed"],
    held: "1 posture, held",
    postures: " postures, ",
    movement_between: " movement between",
    movements_between: " movements between",
    mirrors: "mirrors the strong hand",
    goes_along: "as the strong hand",
    joins_keys: "changes from posture to posture",
    from_movements: "from the lengths and kinds of the movements",
    sentence: Sentence {
        strong: "the dominant hand",
        other: "the other hand",
        both: "both hands",
        mirrors: ", its mirror image",
        likewise: ", moving with it",
        but: " but for what follows",
        makes: "makes",
        make: "make",
        held: "without movement",
        then: ", then ",
        halfway: "halfway between ",
        and: " and ",
        named: "the handshape ",
    },
};

const FRENCH: Phrases = Phrases {
    of: ", un signe de la langue ",
    quotes: ["« ", " »"],
    colon: " : ",
    stated: "selon le texte",
    default: "par défaut",
    symmetry: "par symétrie",
    counted: "d'après le nombre de valeurs",
    hands: "les mains",
    counts: "postures et mouvements",
    strong: "la main dominante, ",
    weak: "la main dominée, ",
    contact: "le contact",
    duration: "la durée",
    phase: ["la phase", "puis la phase"],
    other_stays: ", une main inactive restant où elle était",
    made_from: "fait à partir de",
    tiers: [
        ["configuration", "la main détendue"],
        ["emplacement", "le lieu neutre devant la poitrine"],
        ["orientation", "celle qui est confortable à cet endroit"],
        ["mouvement", "aucun qui lui soit propre"],
    ],
    strong_alone: "la main dominante seule",
    weak_alone: "la main dominée seule",
    each_its_own: "les deux, chacune pour soi",
    both_mirrored: "les deux, la main dominée en miroir de la main dominante",
    both_parallel: "les deux, la main dominée parallèle à la main dominante",
    exchanged: [
        ", le haut et le bas échangés",
        ", l'avant et l'arrière échangés",
        ", en alternance",
        ", les bras croisés",
    ],
    held: "1 posture, tenue",
    postures: " postures, ",
    movement_between: " mouvement entre elles",
    movements_between: " mouvements entre elles",
    mirrors: "en miroir de la main dominante",
    goes_along: "comme la main dominante",
    joins_keys: "passe d'une posture à l'autre",
    from_movements: "d'après la longueur et le genre des mouvements",
    sentence: Sentence {
        strong: "la main dominante",
        other: "l'autre main",
        both: "les deux mains",
        mirrors: ", son image en miroir",
        likewise: ", en parallèle",
        but: " à ceci près",
        makes: "mouvement :",
        make: "mouvement :",
        held: "sans mouvement",
        then: ", puis ",
        halfway: "à mi-chemin entre ",
        and: " et ",
        named: "la configuration ",
    },
};
