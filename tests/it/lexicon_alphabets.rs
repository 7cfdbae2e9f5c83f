//! The manual alphabets of the lexicon: read without a fault, made without a warning, and saying what they should.

use chereme::body::signer::Signer;
use chereme::motion::rotation::angle_between;
use chereme::notation::{Vocabulary, print, read};
use chereme::phonology::{Hand, HandPoint, Place, Sign};
use chereme::synthesis::{Grammar, Options, Performance, side_of, synthesize};
use std::collections::{BTreeMap, BTreeSet};
use std::path::Path;

const ONE_HANDED: [&str; 4] = ["lsf", "asl", "lsfb", "lis"];
/// Letters of the one-handed alphabets that a body cannot make within 2° and 5 mm: (language, letter).
const EXCEPTIONS: [(&str, &str); 0] = [];

fn text(language: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("lexicon").join(language).join("alphabet.sign");
    std::fs::read_to_string(&path).unwrap_or_else(|e| panic!("{}: {e}", path.display()))
}

/// The letters of a language, by name.
fn alphabet(language: &str) -> BTreeMap<String, Sign> {
    let reading = read(&text(language), &Vocabulary::builtin(), language);
    assert_eq!(reading.diagnostics, [], "{language}");
    reading.signs.into_iter().map(|s| (s.sign.name.clone(), s.sign)).collect()
}

struct Stage {
    grammar: Grammar,
    signer: Signer,
}

impl Stage {
    fn new() -> Stage {
        Stage { grammar: Grammar::builtin(), signer: chereme::avatar::signer().unwrap() }
    }

    fn perform(&self, sign: &Sign) -> Performance {
        let made = synthesize(sign, &self.grammar, &self.signer, &Options::default());
        made.unwrap_or_else(|e| panic!("{} {}: {e}", sign.language, sign.name))
    }

    /// The id of the shape that a letter has at its first key.
    fn shape(&self, sign: &Sign) -> String {
        let base = &sign.strong.configuration.at(0).unwrap().base;
        self.grammar.handshapes.find(base, Some(&sign.language)).unwrap().id.clone()
    }

    /// Millimetres between a point of the strong hand and one of the weak at a key of a sign.
    fn gap_mm(&self, made: &Performance, key: usize, strong: HandPoint, weak: HandPoint) -> f64 {
        let model = made.track.clip.sample(made.report.keys[key]).pose.to_model(&self.signer.skeleton);
        let at = |hand: Hand, point| self.signer.landmarks.hand_point(side_of(hand), point).unwrap().position(&model);
        at(Hand::Strong, strong).distance(at(Hand::Weak, weak)) * 1e3
    }
}

#[test]
fn five_alphabets_have_26_letters_each_and_are_laid_out_as_fmt_prints() {
    let letters: Vec<String> = ('A'..='Z').map(String::from).collect();
    for language in ["lsf", "asl", "lsfb", "lis", "bsl"] {
        let signs = alphabet(language);
        assert_eq!(signs.keys().cloned().collect::<Vec<_>>(), letters, "{language}");
        let text = text(language);
        assert_eq!(print(&chereme::notation::parse(&text).0), text, "{language}");
        for sign in signs.values() {
            assert!(sign.source.is_some() && sign.status.as_deref() == Some("unverified"), "{language} {}", sign.name);
        }
    }
}

#[test]
fn one_handed_letters_are_made_where_a_body_can_make_them() {
    let stage = Stage::new();
    let mut faults = Vec::new();
    for language in ONE_HANDED {
        for (letter, sign) in alphabet(language) {
            let report = stage.perform(&sign).report;
            let strained = report.tilt.to_degrees() > 2.0 || report.residual_m > 5e-3 || !report.warnings.is_empty();
            if strained != EXCEPTIONS.contains(&(language, letter.as_str())) {
                let (tilt, residual) = (report.tilt.to_degrees(), report.residual_m * 1e3);
                faults.push(format!(
                    "{language} {letter}: tilt {tilt:.1}°, residual {residual:.1} mm {:?}",
                    report.warnings
                ));
            }
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
}

/// facts/phonology.md §9, expectation 38: the part that needs no spelling.
#[test]
fn at_each_key_the_fingers_have_the_pose_of_the_shape() {
    let stage = Stage::new();
    for language in ["lsf", "asl", "lsfb", "lis", "bsl"] {
        for (letter, sign) in alphabet(language) {
            let made = stage.perform(&sign);
            for (key, time) in made.report.keys.iter().enumerate() {
                let pose = made.track.clip.sample(*time).pose;
                for (hand, said) in [(Hand::Strong, &sign.strong), (Hand::Weak, &sign.weak)] {
                    let Some(configuration) = said.configuration.at(key) else { continue };
                    let angles = stage.grammar.handshapes.angles(configuration, Some(language)).unwrap();
                    let mut wanted = pose.clone();
                    stage.signer.hand(side_of(hand)).apply(&angles, &mut wanted);
                    for joint in stage.signer.skeleton.ids() {
                        let off = angle_between(pose.rotation(joint), wanted.rotation(joint));
                        let name = &stage.signer.skeleton[joint].name;
                        assert!(off < 1e-3, "{language} {letter}, key {}: {name} is {off} rad off", key + 1);
                    }
                }
            }
        }
    }
}

/// facts/phonology.md §9, expectation 39; facts/papers-decisions.md §8.
#[test]
fn lsf_has_22_shapes_in_19_classes() {
    let stage = Stage::new();
    let letters = alphabet("lsf");
    let shape = |letter: &str| stage.shape(&letters[letter]);
    for same in ["JI", "HK", "KP", "GQ"] {
        assert_eq!(shape(&same[..1]), shape(&same[1..]), "{same}");
    }
    let shapes: BTreeSet<String> = letters.keys().map(|l| shape(l)).collect();
    assert_eq!(shapes.len(), 22, "{shapes:?}");
    let classes: BTreeSet<String> = letters
        .keys()
        .map(|letter| match letter.as_str() {
            "M" => shape("W"),
            "N" => shape("U"),
            "Z" => shape("D"),
            "Q" => shape("G"),
            other => shape(other),
        })
        .collect();
    assert_eq!(classes.len(), 19, "{classes:?}");
}

/// facts/phonology.md §9, expectation 39.
#[test]
fn of_the_asl_letters_only_j_and_z_move() {
    let moving: Vec<String> =
        alphabet("asl").into_values().filter(|s| !s.strong.movement.is_empty()).map(|s| s.name).collect();
    assert_eq!(moving, ["J", "Z"]);
}

/// The points of the strong and of the weak hand that `placement other WEAK, with STRONG` names.
fn points(strong: &str, weak: &str) -> (HandPoint, HandPoint) {
    let text = format!("sign X\n  placement other {weak}, with {strong}\n");
    let reading = read(&text, &Vocabulary::builtin(), "bsl");
    assert_eq!(reading.diagnostics, [], "{text}");
    let placement = reading.signs[0].sign.strong.placement.at(0).unwrap().clone();
    let Place::OtherHand(weak) = placement.place else { panic!("{text}") };
    (placement.with.unwrap(), weak)
}

/// Where the hands of the BSL letters meet: key (from 1), the strong hand's point, the weak hand's.
const CONTACTS: &[(&str, usize, &str, &str)] = &[
    ("A", 2, "index tip", "thumb tip"),
    ("B", 2, "thumb index tip", "thumb index tip"),
    ("D", 2, "thumb index tip", "palmar index midjoint"),
    ("E", 2, "index tip", "index tip"),
    ("F", 2, "palmar index middle midjoint", "dorsal index middle midjoint"),
    ("G", 2, "pinky-side", "thumb-side"),
    ("H", 1, "palm", "thumb-ball"),
    ("H", 2, "palm", "palmar middle midjoint"),
    ("I", 2, "index tip", "middle tip"),
    ("J", 1, "index tip", "middle tip"),
    ("J", 2, "index tip", "palm"),
    ("J", 3, "index tip", "thumb tip"),
    ("K", 2, "dorsal index midjoint", "palmar index midjoint"),
    ("L", 2, "index pad", "palm"),
    ("M", 2, "index middle ring pad", "palm"),
    ("N", 2, "index middle pad", "palm"),
    ("O", 2, "index tip", "ring tip"),
    ("P", 2, "thumb index tip", "index pad"),
    ("Q", 2, "palmar index midjoint", "thumb index tip"),
    ("R", 2, "index tip", "palm"),
    ("S", 2, "palmar pinky midjoint", "palmar pinky midjoint"),
    ("T", 2, "index tip", "pinky-side"),
    ("U", 2, "index tip", "pinky tip"),
    ("V", 2, "index middle pad", "palm"),
    ("W", 2, "fingers midjoint", "fingers midjoint"),
    ("X", 2, "palmar index midjoint", "dorsal index midjoint"),
    ("Y", 2, "palmar index midjoint", "radial index base"),
    ("Z", 2, "middle tip", "palm"),
];

#[test]
fn the_hands_of_bsl_letters_meet_within_5_mm() {
    let stage = Stage::new();
    let letters = alphabet("bsl");
    let mut faults = Vec::new();
    for (letter, key, strong, weak) in CONTACTS {
        let made = stage.perform(&letters[*letter]);
        let (a, b) = points(strong, weak);
        let gap = stage.gap_mm(&made, key - 1, a, b);
        if gap > 5.0 {
            faults.push(format!("{letter}, key {key}: {strong} is {gap:.1} mm from {weak}"));
        }
    }
    assert!(faults.is_empty(), "{}", faults.join("\n"));
    let touching: BTreeSet<&str> = CONTACTS.iter().map(|(letter, ..)| *letter).collect();
    assert_eq!(touching.len(), 25, "all letters but C");
}
