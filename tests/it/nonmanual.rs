//! The inventory of non-manuals: every tag that lexica use has a value, every value shows, words shape the mouth.

use crate::shared::shared;
use crate::signing::{perform, sign, world};
use chereme::phonology::expression::{Expression, Look};
use chereme::phonology::{Amount, Channel, NonManual, NonManualValue, sampa};
use chereme::synthesis::face::{Cue, Face, NonManualState, Scene, lay_out_value};
use glam::DVec3;
use proptest::prelude::*;

/// The tags of each tier, as the notation's authors list them.
const TAGS: [(&[Channel], &str); 8] = [
    (&[Channel::Shoulders], "UL UR UB HL HR HB SL SR SB"),
    (&[Channel::Torso], "RL RR TL TR TF TB SI HE ST RD"),
    (&[Channel::Head], "NO SH SR SL TR TL NF NB PF PB LI"),
    (&[Channel::Gaze], "AD FR HD HI HC UP DN LE RI NO RO LU LD RU RD"),
    (&[Channel::Brows], "RB RR RL FU"),
    (&[Channel::Lids], "WB WR WL SB SR SL CB CR CL TB TR TL BB"),
    (&[Channel::Nose], "WR TW WI"),
    (&[Channel::Mouth, Channel::Cheeks], ""),
];

fn has(channels: &[Channel], tag: &str) -> bool {
    channels.iter().any(|c| world().grammar.expressions.tagged(*c, tag).is_some())
}

fn laid_out(channel: Channel, value: &NonManual, start: f64, end: f64) -> Vec<Cue> {
    let hands = |look: Look| match look {
        Look::Weak => vec![],
        Look::Ahead | Look::Hands | Look::Strong | Look::Gaze => vec![(start, DVec3::new(-0.2, -0.4, 0.4))],
    };
    let scene = Scene {
        expressions: &world().grammar.expressions,
        morphs: &world().signer.morphs,
        locate: &|_| Ok(Some(DVec3::new(1.0, 0.0, 1.0))),
        follow: &hands,
    };
    lay_out_value(channel, value, (start, end), &scene).unwrap_or_else(|e| panic!("{e}"))
}

fn face(channel: Channel, value: &NonManual, start: f64, end: f64) -> Face {
    Face::new(laid_out(channel, value, start, end))
}

fn named(name: &str) -> NonManual {
    NonManual::plain(NonManualValue::Named(name.into()))
}

fn mouthing(word: &str) -> NonManual {
    NonManual::plain(NonManualValue::Mouthing(word.into()))
}

fn weight(state: &NonManualState, morph: &str) -> f64 {
    let at = world().signer.morphs.iter().position(|m| m == morph).expect("a morph of the avatar");
    state.morphs.iter().filter(|(m, _)| *m == at).map(|(_, w)| w).sum()
}

/// How much of a state can be seen: the weights of morphs, and angles in radians.
fn shown(state: &NonManualState) -> f64 {
    let turn = |t: chereme::body::signer::Turn| t.pitch.abs() + t.yaw.abs() + t.roll.abs();
    let shoulders: f64 = state.shoulders.iter().map(|s| s.raised.abs() + s.forward.abs()).sum();
    let morphs: f64 = state.morphs.iter().map(|(_, w)| w.abs()).sum();
    morphs + turn(state.head) + turn(state.torso) + turn(state.eyes) + shoulders + state.push.abs()
}

#[test]
fn every_tag_of_the_notation_has_a_value() {
    for (channels, tags) in TAGS {
        for tag in tags.split_whitespace() {
            assert!(has(channels, tag), "{channels:?} {tag}");
        }
    }
    for (letter, last) in [("D", 9), ("J", 4), ("L", 35), ("C", 13), ("T", 17)] {
        for number in 1..=last {
            assert!(has(&[Channel::Mouth, Channel::Cheeks], &format!("{letter}{number:02}")), "{letter}{number:02}");
        }
    }
}

#[test]
fn every_tag_of_real_lexica_has_a_value() {
    let Some(table) = shared("data/phonology/gsigml_attributes.tsv") else { return };
    let text = std::fs::read_to_string(table).unwrap();
    let mut seen = 0;
    for line in text.lines() {
        let cells: Vec<&str> = line.split('\t').collect();
        let [tier, attribute, tag, _] = cells[..] else { continue };
        if !["movement", "direction", "tag"].contains(&attribute) {
            continue;
        }
        let channels: &[Channel] = match tier {
            "shoulder_movement" | "hnm_shoulder" => &[Channel::Shoulders],
            "body_movement" | "hnm_body" => &[Channel::Torso],
            "head_movement" | "hnm_head" => &[Channel::Head],
            "eye_gaze" | "hnm_eyegaze" => &[Channel::Gaze],
            "eye_brows" | "hnm_eyebrows" => &[Channel::Brows],
            "eye_lids" | "hnm_eyelids" => &[Channel::Lids],
            "nose" | "hnm_nose" => &[Channel::Nose],
            "mouth_gesture" | "hnm_mouthgesture" => &[Channel::Mouth, Channel::Cheeks],
            _ => continue,
        };
        assert!(has(channels, tag), "{tier} {tag}");
        seen += 1;
    }
    assert!(seen > 90, "{seen}");
}

#[test]
fn no_tag_means_two_values() {
    for channel in Channel::ALL {
        let mut tags: Vec<&str> =
            world().grammar.expressions.of(channel).flat_map(|r| r.hamnosys.split_whitespace()).collect();
        let all = tags.len();
        tags.sort_unstable();
        tags.dedup();
        assert_eq!(tags.len(), all, "{}", channel.name());
    }
}

#[test]
fn every_value_shows() {
    // What is a return to rest shows nothing of itself.
    let at_rest = |row: &Expression| row.name == "closed" || row.look.is_some();
    for channel in Channel::ALL {
        for row in world().grammar.expressions.of(channel) {
            let face = face(channel, &named(&row.name), 0.5, 2.0);
            let most = (0..150).map(|i| shown(&face.state_at(f64::from(i) / 60.0))).fold(0.0, f64::max);
            assert!(most > 0.08 || at_rest(row), "{} {}: {most}", channel.name(), row.name);
            assert!(most.is_finite());
            for far in [-1e9, -1.0, 0.0, 3.0, 1e9] {
                assert_eq!(shown(&face.state_at(far)), 0.0, "{} {} at {far}", channel.name(), row.name);
            }
        }
    }
}

#[test]
fn left_and_right_come_in_pairs() {
    for channel in Channel::ALL {
        for row in world().grammar.expressions.of(channel) {
            let other: Vec<&str> = row
                .name
                .split('-')
                .map(|word| match word {
                    "left" => "right",
                    "right" => "left",
                    same => same,
                })
                .collect();
            let other = other.join("-");
            assert!(world().grammar.expressions.find(channel, &other).is_some(), "{} {other}", channel.name());
        }
    }
}

#[test]
fn words_are_read_as_people_write_them() {
    let signs = |word: &str| sampa::read(word).iter().map(|s| s.sign).collect::<String>();
    for (word, read) in [
        ("zev@@nfeRt@x", "zev@nfeRt@x"),
        ("so:nmud", "sonmud"),
        ("AAssee", "Ase"),
        ("si@ro", "si@ro"),
        ("ta_Im", "taIm"),
        ("xUm@r", "xUm@r"),
        ("e:n", "en"),
        ("h9ys", "h9ys"),
        ("b2:", "b2"),
        ("T.aI", "TaI"),
        ("kara~TEne:", "karaTEne"),
        ("b§ZuR", "boZuR"),
        ("m_~a", "ma"),
        ("\"dZes't", "dZeSt"),
        ("Œ 😀 ()", ""),
        ("", ""),
    ] {
        assert_eq!(signs(word), read, "{word}");
    }
    let length = |word: &str, n: usize| sampa::read(word)[n].length;
    assert!(length("e:n", 0) > length("en", 0) && length("een", 0) == length("e:n", 0));
    assert!(length("aI", 1) > length("a_I", 1), "the end of a tied diphthong is short");
    assert!(length("ma", 1) > length("ma", 0), "vowels are longer than consonants");
}

#[test]
fn every_sound_has_a_mouth_shape() {
    for sound in sampa::SOUNDS.chars() {
        assert!(world().grammar.expressions.viseme(sound).is_some(), "{sound}");
    }
    assert!(sampa::VOWELS.chars().all(|v| sampa::SOUNDS.contains(v)));
}

#[test]
fn lips_close_within_m_however_short() {
    for (word, time) in [("ama", 0.6), ("ama", 0.15), ("ObEpamo", 0.4), ("afa", 0.2)] {
        let face = face(Channel::Mouth, &mouthing(word), 1.0, 1.0 + time);
        let open = |state: &NonManualState| weight(state, "mouth-open") + weight(state, "mouth-part-later");
        let states: Vec<NonManualState> = (0..600).map(|i| face.state_at(0.8 + f64::from(i) * 2e-3)).collect();
        let shut: Vec<bool> = states.iter().map(|s| !s.morphs.is_empty() && open(s) < 1e-6).collect();
        let firm = word.chars().filter(|c| "mbpfv".contains(*c)).count();
        let times = shut.windows(2).filter(|w| !w[0] && w[1]).count();
        assert_eq!(times, firm, "{word} in {time} s");
        // Long enough for a frame of 30 a second.
        assert!(shut.iter().filter(|s| **s).count() as f64 * 2e-3 > 0.033 * firm as f64, "{word} in {time} s");
    }
}

#[test]
fn a_word_too_long_for_its_time_keeps_what_lips_show() {
    let face = face(Channel::Mouth, &mouthing("strAksmAk@l@kxeef"), 0.0, 0.3);
    let most = |morph: &str| (0..200).map(|i| weight(&face.state_at(f64::from(i) * 2e-3), morph)).fold(0.0, f64::max);
    assert!(most("mouth-compression") > 0.55 && most("mouth-elevation") > 0.45);
}

#[test]
fn sequences_follow_each_other_and_what_is_together_coincides() {
    let both = [named("puffed"), named("sucked-in")];
    let sequence = face(Channel::Cheeks, &NonManual::plain(NonManualValue::Sequence(both.to_vec())), 1.0, 3.0);
    let (early, late) = (sequence.state_at(1.4), sequence.state_at(2.6));
    assert!(weight(&early, "cheek-left-puff") > 0.99 && weight(&early, "cheek-left-suck") == 0.0);
    assert!(weight(&late, "cheek-left-puff") == 0.0 && weight(&late, "cheek-left-suck") > 0.99);
    let together = face(
        Channel::Head,
        &NonManual::plain(NonManualValue::Together(vec![named("forward"), named("tilted-left")])),
        1.0,
        2.0,
    );
    let state = together.state_at(1.5);
    assert!(state.head.pitch > 0.2 && state.head.roll > 0.2);
}

#[test]
fn amounts_multiply_and_pace_quickens() {
    let with = |amount: Amount| NonManual { amount, ..named("turned-left") };
    let yaw = |value: &NonManual| face(Channel::Head, value, 1.0, 2.0).state_at(1.5).head.yaw;
    assert!((yaw(&with(Amount::Percent(30))) / yaw(&named("turned-left")) - 0.3).abs() < 1e-9);
    let whole = NonManual {
        amount: Amount::Percent(50),
        ..NonManual::plain(NonManualValue::Sequence(vec![with(Amount::Slight)]))
    };
    assert!((yaw(&whole) / yaw(&named("turned-left")) - 0.25).abs() < 1e-9);
    let nods = |pace: f64| {
        let face = face(Channel::Head, &NonManual { pace, ..named("nod") }, 0.0, 3.0);
        let pitch: Vec<f64> = (0..900).map(|i| face.state_at(f64::from(i) / 300.0).head.pitch).collect();
        pitch.windows(3).filter(|w| w[1] > w[0] && w[1] >= w[2]).count()
    };
    assert_eq!((nods(0.5), nods(1.0), nods(2.0)), (3, 6, 12));
}

#[test]
fn eyes_lead_the_head_and_keep_their_aim() {
    let mut cues = laid_out(Channel::Head, &named("turned-left"), 1.0, 2.0);
    cues.extend(laid_out(Channel::Gaze, &named("left"), 1.0, 2.0));
    let face = Face::new(cues);
    let first =
        |of: fn(&NonManualState) -> f64| (0..2000).map(|i| f64::from(i) * 1e-3).find(|t| of(&face.state_at(*t)) > 0.02);
    let (eyes, head) = (first(|s| s.eyes.yaw).unwrap(), first(|s| s.head.yaw).unwrap());
    assert!((0.05..0.2).contains(&(head - eyes)), "eyes {eyes}, head {head}");
    // Where nothing is said, the eyes stay behind a little; told to look at the addressee, they do.
    let alone = Face::new(laid_out(Channel::Head, &named("turned-left"), 1.0, 2.0)).state_at(1.5);
    assert!(alone.eyes.yaw < 0.0 && alone.head.yaw + alone.eyes.yaw > 0.2);
    let mut cues = laid_out(Channel::Head, &named("turned-left"), 1.0, 2.0);
    cues.extend(laid_out(Channel::Gaze, &named("addressee"), 1.0, 2.0));
    let state = Face::new(cues).state_at(1.5);
    assert!((state.head.yaw + state.eyes.yaw).abs() < 1e-9);
    // A head that goes with the gaze turns where the eyes do.
    let mut cues = laid_out(Channel::Head, &named("with-gaze"), 1.0, 2.0);
    cues.extend(laid_out(Channel::Gaze, &named("right"), 1.0, 2.0));
    assert!(Face::new(cues).state_at(1.5).head.yaw < -0.2);
}

#[test]
fn eyes_follow_the_hand_they_are_told_to() {
    let text = "sign X\n placement stomach, 20cm away\n movement up 40cm duration 1s\n gaze strong-hand\n";
    let performance = perform(&sign(text));
    let eye = world().signer.skeleton.joint("RightEye").unwrap();
    let look = |t: f64| performance.track.clip.sample(chereme::time::Seconds(t)).pose.rotation(eye) * DVec3::Z;
    let (first, last) = (performance.report.stroke_start.0 + 0.1, performance.report.sign_end.0 - 0.1);
    assert!(look(first).y < -0.3 && look(last).y > look(first).y + 0.1, "{} {}", look(first), look(last));
}

proptest! {
    #[test]
    fn any_text_is_mouthed(word in "\\PC{0,40}", start in -1.0..3.0f64, time in 0.0..4.0f64, pace in 0.01..50.0f64) {
        let value = NonManual { pace, ..mouthing(&word) };
        let face = face(Channel::Mouth, &value, start, start + time);
        for i in 0..60 {
            let state = face.state_at(start - 0.5 + (time + 1.0) * f64::from(i) / 59.0);
            prop_assert!(state.morphs.iter().all(|(_, w)| w.is_finite() && (-1e-9..=1.6).contains(w)));
        }
    }
}
