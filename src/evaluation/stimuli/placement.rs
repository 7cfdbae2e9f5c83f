//! Hand placement (Naert et al. 2021, §7.1): where the bowl is, and how pointing looks.

use super::{Sheet, Stimulus, Version, choice};
use crate::format::questionnaire::{Question, Words};
use crate::motion::easing::Easing;

/// The places of the bowl, as gloss lines say them, with what people read; sides are the signer's.
const PLACES: [(&str, &str, &str); 6] = [
    ("left", "on the signer’s left", "à gauche du signeur"),
    ("right", "on the signer’s right", "à droite du signeur"),
    ("high", "high up", "en haut"),
    ("low", "low down", "en bas"),
    ("near", "close to the signer", "tout près du signeur"),
    ("far", "far from the signer", "loin du signeur"),
];

/// Pointing gestures between rests, 2 to 5 a sequence: to the left, up from the floor, out, metres.
const SEQUENCES: [(&str, &[[f64; 3]]); 3] = [
    ("two", &[[0.45, 1.35, 0.45], [-0.4, 1.25, 0.5]]),
    ("three", &[[-0.35, 1.6, 0.4], [0.1, 1.15, 0.6], [0.5, 1.5, 0.3]]),
    ("five", &[[0.3, 1.2, 0.5], [-0.2, 1.2, 0.55], [-0.55, 1.45, 0.25], [0.0, 1.65, 0.45], [0.5, 1.1, 0.35]]),
];

pub(super) fn sheet() -> Sheet {
    let choices = PLACES.iter().map(|(value, en, fr)| choice(value, en, fr)).collect();
    let where_is = Question { prompt: Words::new("Where is the bowl?", "Où est le bol ?"), choices };
    let pointing = Question { prompt: Words::new("Pointing gestures", "Pointages"), choices: Vec::new() };
    let bowl = |(place, _, _): &(&str, &str, &str)| Stimulus {
        group: "spatialization",
        item: format!("BOL {place}"),
        version: Version::Synthesized("synthesized".into(), Easing::default()),
        line: format!("BOL@{place}"),
        correct: Some((*place).to_owned()),
        question: 0,
    };
    let mut stimuli: Vec<Stimulus> = PLACES.iter().map(bowl).collect();
    for (name, points) in SEQUENCES {
        let pointing = |[x, y, z]: &[f64; 3]| format!("IX({x},{y},{z})");
        let line = points.iter().map(pointing).collect::<Vec<_>>().join(" <REST 0.2s> ");
        for (version, easing) in [("linear", Easing::Linear), ("sigmoid", Easing::default())] {
            stimuli.push(Stimulus {
                group: "pointing",
                item: format!("pointing {name}"),
                version: Version::Synthesized(version.into(), easing),
                line: line.clone(),
                correct: None,
                question: 1,
            });
        }
    }
    Sheet {
        title: Words::new("Placement of signs", "Placement des signes"),
        introduction: Words::new(
            "You will see an avatar sign in French Sign Language. Some of the sequences show a bowl: say where it is. Some show pointing. Say each time how realistic the movement looks. You may watch as often as you wish. It takes about five minutes.",
            "Vous allez voir un avatar s’exprimer en langue des signes française. Certaines séquences montrent un bol : dites où il se trouve. D’autres montrent des pointages. Dites à chaque fois si le mouvement vous semble réaliste. Vous pouvez revoir chaque séquence autant de fois que vous le souhaitez. Comptez environ cinq minutes.",
        ),
        questions: vec![where_is, pointing],
        stimuli,
    }
}
