//! Hand configuration (Naert et al. 2021, §7.2 and table 2): exchanged configurations, and signs from dactylology.

use super::{Sheet, Stimulus, Version, choice};
use crate::format::questionnaire::{Question, Words};
use crate::motion::easing::Easing;

/// Group, item, version, gloss, right answer of the signs whose configuration is exchanged. The paper's rooster (§7.2) is its
/// chicken (§5.1): the cat's walk with 3; its H is the shape of K.
const EXCHANGED: [(&str, &str, &str, &str, &str); 5] = [
    ("snails", "ESCARGOT", "Y (described)", "ESCARGOT", "snail"),
    ("snails", "ESCARGOT", "H", "ESCARGOT-H", "snail"),
    ("snails", "LIMACE", "U", "LIMACE", "slug"),
    ("walks", "CHAT-MARCHE", "U (described)", "CHAT-MARCHE", "cat"),
    ("walks", "POULE-MARCHE", "3", "POULE-MARCHE", "rooster"),
];

/// Signs derived from dactylology, with their right answers.
const SPELLED: [(&str, &str); 5] =
    [("LSF", "lsf"), ("SALON", "living-room"), ("WEEK-END", "weekend"), ("OR", "gold"), ("OK", "ok")];

/// The 24 answers, by their French words: the stimuli, other animals and their gaits, other signs that are spelled or near to it.
const ANSWERS: [(&str, &str, &str); 24] = [
    ("comic", "comic strip (BD)", "BD"),
    ("cd", "CD", "CD"),
    ("cat", "a cat walks", "le chat marche"),
    ("rooster", "a rooster (a hen) walks", "le coq (la poule) marche"),
    ("nap", "nap (DODO)", "dodo"),
    ("dvd", "DVD", "DVD"),
    ("snail", "snail", "escargot"),
    ("slug", "slug", "limace"),
    ("lion", "a lion walks", "le lion marche"),
    ("lsf", "LSF (French Sign Language)", "LSF"),
    ("ok", "OK", "OK"),
    ("gold", "gold", "or"),
    ("pc", "PC", "PC"),
    ("rer", "RER (train)", "RER"),
    ("living-room", "living room", "salon"),
    ("snake", "snake", "serpent"),
    ("sms", "SMS", "SMS"),
    ("mouse", "mouse", "souris"),
    ("tgv", "TGV (train)", "TGV"),
    ("tortoise", "tortoise", "tortue"),
    ("cow", "a cow walks", "la vache marche"),
    ("worm", "worm", "ver de terre"),
    ("wc", "WC", "WC"),
    ("weekend", "weekend", "week-end"),
];

pub(super) fn sheet() -> Sheet {
    let choices = ANSWERS.iter().map(|(value, en, fr)| choice(value, en, fr)).collect();
    let prompt = Words::new("Which sign is it?", "De quel signe s’agit-il ?");
    let exchanged = EXCHANGED.iter().map(|(group, item, version, line, correct)| Stimulus {
        group,
        item: (*item).to_owned(),
        version: Version::Synthesized((*version).to_owned(), Easing::default()),
        line: (*line).to_owned(),
        correct: Some((*correct).to_owned()),
        question: 0,
    });
    let mut stimuli: Vec<Stimulus> = exchanged.collect();
    for (item, correct) in SPELLED {
        for (version, easing) in [("slerp", Easing::Linear), ("sigmoid", Easing::default())] {
            stimuli.push(Stimulus {
                group: "dactylology",
                item: item.to_owned(),
                version: Version::Synthesized(version.into(), easing),
                line: item.to_owned(),
                correct: Some(correct.to_owned()),
                question: 0,
            });
        }
    }
    Sheet {
        title: Words::new("Configurations of the hand", "Configurations de la main"),
        introduction: Words::new(
            "You will see an avatar sign in French Sign Language. Say which sign it is, and how realistic the movement looks. Signs may come more than once. You may watch as often as you wish. It takes about five minutes.",
            "Vous allez voir un avatar s’exprimer en langue des signes française. Dites de quel signe il s’agit, et si le mouvement vous semble réaliste. Un signe peut revenir plusieurs fois. Vous pouvez revoir chaque séquence autant de fois que vous le souhaitez. Comptez environ cinq minutes.",
        ),
        questions: vec![Question { prompt, choices }],
        stimuli,
    }
}
