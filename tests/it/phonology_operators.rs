//! Laws of the operators on descriptions (facts §9, 16 to 25), on random signs and on the lexicon's, and their motion.

use crate::signing::{body_at, perform, sign as one, signs_of, tables, world};
use crate::strategies::{Words, sign};
use chereme::notation::{Vocabulary, read, write};
use chereme::phonology::operator::*;
use chereme::phonology::*;
use chereme::time::Seconds;
use proptest::prelude::*;

fn lsf(name: &str) -> Sign {
    signs_of("lsf").into_iter().find(|s| s.name == name).unwrap_or_else(|| panic!("{name}"))
}

fn applied(operator: Operator, sign: &Sign) -> Applied {
    apply(&operator, sign, &tables()).unwrap_or_else(|e| panic!("{e}"))
}

/// A sign that reads back from its text has a form that people can write.
fn reads_back(sign: &Sign) -> Result<(), TestCaseError> {
    let text = write(sign);
    let reading = read(&text, &Vocabulary::open(), "");
    let faults = reading.diagnostics.iter().filter(|d| !d.message.starts_with("nothing is said"));
    prop_assert_eq!(faults.count(), 0, "{:?}\n{}", reading.diagnostics, text);
    prop_assert_eq!(&reading.signs[0].sign, sign, "{}", text);
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 250, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn backwards_twice_is_the_same_from_the_first_time_on(sign in sign(Words::known())) {
        let twice = |s: &Sign| inverted(&inverted(s));
        let back = inverted(&sign);
        // A text that says `backwards` itself may need a second turn to come to its plain words.
        let plain = twice(&back);
        prop_assert_eq!(&twice(&plain), &plain);
        let path = inverted_movement(&inverted_movement(&inverted_movement(&sign)));
        prop_assert_eq!(&inverted_movement(&inverted_movement(&path)), &path);
        if sign.then.is_empty() {
            prop_assert_eq!(&back.nonmanual, &sign.nonmanual);
        }
        let there: Vec<usize> = sign.phases().map(|phase| phase.intervals).collect();
        let here: Vec<usize> = back.phases().map(|phase| phase.intervals).rev().collect();
        prop_assert_eq!(here, there);
        reads_back(&back)?;
    }

    #[test]
    fn swapped_and_reflected_are_involutions(sign in sign(Words::known())) {
        let once = swapped(&sign);
        prop_assert_eq!(&swapped(&swapped(&once)), &once);
        prop_assert_eq!(&reflected(&swapped(&sign)), &swapped(&reflected(&sign)));
        let image = reflected(&sign);
        prop_assert_eq!(&reflected(&reflected(&image)), &image);
        let left = for_left_hander(&sign);
        prop_assert_eq!(&for_left_hander(&for_left_hander(&left)), &left);
        if sign.phases().all(|phase| !matches!(phase.hands, Hands::Both(_))) {
            prop_assert_eq!(&swapped(&once), &sign);
        }
        reads_back(&once)?;
    }

    #[test]
    fn mirrored_twice_is_mirrored_once(sign in sign(Words::known())) {
        if let Ok(once) = mirrored(&sign, &tables()) {
            prop_assert!(once.sign.phases().all(|phase| phase.hands == Hands::Both(Some(Symmetry::MIRRORED))));
            prop_assert_eq!(mirrored(&once.sign, &tables()).unwrap().sign, once.sign.clone());
            reads_back(&once.sign)?;
        }
    }

    #[test]
    fn repetition_counts_performances(sign in sign(Words::known()), times in 2u8..5) {
        let sign = Sign { duration: None, ..sign };
        prop_assert_eq!(&repeated(&sign, 1, None, 0, &tables()).unwrap(), &sign);
        let made = repeated(&sign, times, Some(Seconds(0.3)), 0, &tables()).unwrap();
        if sign.then.is_empty() {
            prop_assert_eq!(made.intervals, usize::from(times) * (sign.intervals + 1) - 1);
        } else {
            prop_assert_eq!(made.phases().count(), usize::from(times) * sign.phases().count());
        }
        reads_back(&made)?;
    }

    #[test]
    fn replacing_by_itself_and_scaling_by_one_change_nothing(sign in sign(Words::known())) {
        let sign = Sign { base: Vec::new(), ..sign };
        let becomes = |a: &Action| a.becoming.is_some();
        let changes = sign.strong.movement.iter().any(|m| m.any_action(&becomes));
        let whole = matches!(sign.hands, Hands::Strong) && sign.then.is_empty() && !changes;
        if whole && sign.strong.configuration.len() == 1 {
            let same = Operator::Configuration(None, sign.strong.configuration.clone());
            prop_assert_eq!(&apply(&same, &sign, &tables()).unwrap().sign, &sign);
        }
        prop_assert_eq!(&applied(Operator::Size(1.0), &sign).sign, &sign);
        prop_assert_eq!(&applied(Operator::Speed(1.0), &sign).sign, &sign);
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 100, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn every_operator_keeps_what_can_be_written(sign in sign(Words::known()), other in sign(Words::known())) {
        let space = Place::Space(Space::default());
        let operators = [
            Operator::Size(0.5),
            Operator::Configuration(None, Keys::one(Configuration::named("U"))),
            Operator::Placement(None, Keys::one(Placement::at(Place::Body("chest".into())))),
            Operator::At(Relocation { place: space, forced: Forced::Yes }),
        ];
        for operator in operators {
            let made = apply(&operator, &sign, &tables()).map_err(|e| TestCaseError::fail(e.to_string()))?;
            reads_back(&made.sign)?;
        }
        reads_back(&inverted_movement(&sign))?;
        let compound = chain(&[sign.clone(), other.clone()], "AB").map_err(|e| TestCaseError::fail(e.to_string()))?;
        prop_assert!(compound.then.is_empty());
        reads_back(&compound)?;
        if let Ok(both) = on_each_hand(&sign, &other) {
            reads_back(&both)?;
        }
    }
}

/// A sign of two phases: both hands, then one, the other staying.
fn two_phases() -> Sign {
    one(
        "sign A\n  meaning en \"a\"\n  hands both mirrored\n  configuration flat\n  placement chest, 20cm away\n  movement up 10cm\n  brows raised\n\
         then other hand stays\n  configuration 5 then fist-s\n  placement chin, 10cm away\n  duration 0.8s\n",
    )
}

#[test]
fn phases_come_back_in_reverse_order() {
    let back = inverted(&two_phases());
    let text = write(&back);
    let shapes: Vec<&str> =
        back.phases().flat_map(|p| p.strong.configuration.iter()).map(|(_, c)| c.base.as_str()).collect();
    assert_eq!(shapes, ["fist-s", "5", "flat"], "{text}");
    assert_eq!((back.hands, back.then[0].hands), (Hands::Strong, Hands::Both(Some(Symmetry::MIRRORED))));
    // What is said of the whole sign stays in front; a phase that comes there has no time of its own.
    assert_eq!((back.duration, back.then[0].duration, back.then[0].holds_over), (None, None, true));
    assert_eq!((back.meaning.len(), back.nonmanual.len()), (1, 1));
    assert!(text.contains("then other hand stays") && text.contains("down 10cm"), "{text}");
}

#[test]
fn a_value_of_an_operator_is_that_of_all_phases() {
    let sign = two_phases();
    let with = |shapes: &[&str]| {
        let keys = shapes.iter().enumerate().map(|(key, name)| (key, Configuration::named(*name)));
        apply(&Operator::Configuration(None, Keys::new(keys.collect()).unwrap()), &sign, &tables())
    };
    assert!(with(&["U"]).unwrap().sign.phases().all(|p| p.strong.configuration.at(0).unwrap().base == "U"));
    let four = with(&["U", "V", "L", "Y"]).unwrap().sign;
    assert_eq!(four.then[0].strong.configuration.at(1).unwrap().base, "Y");
    let error = with(&["U", "V"]).unwrap_err().to_string();
    assert!(error.contains("4 keys in its phases"), "{error}");
    // The weak hand acts in the first phase only.
    let chest = Keys::one(Placement::at(Place::Body("chest".into())));
    let weak = applied(Operator::Placement(Some(Hand::Weak), chest), &sign).sign;
    assert!(!weak.weak.placement.is_empty() && weak.then == sign.then);
    // One after the other as one: a change between.
    let flat = chain(std::slice::from_ref(&sign), "A").unwrap();
    assert_eq!((flat.intervals, flat.then.len()), (3, 0));
    let twice = repeated(&sign, 2, None, 1, &tables()).unwrap();
    assert_eq!((twice.phases().count(), twice.then[1].holds_over), (4, false));
    assert!(write(&twice).contains("up 13cm"), "{}", write(&twice));
}

#[test]
fn what_a_hand_becomes_is_said_at_keys_when_it_runs_backwards() {
    let sign =
        one("sign A\n  configuration flat\n  placement chest\n  movement up 10cm, becoming ( configuration 5 )\n");
    let text = write(&inverted(&sign));
    assert!(text.contains("5 then flat") && text.contains("movement       down 10cm\n"), "{text}");
    let group = one("sign A\n  configuration flat\n  movement ( up then left ) to and fro once moving right\n");
    let text = write(&inverted(&group));
    assert!(text.contains("( up then left ) to and fro once moving left"), "{text}");
    let replaced = applied(Operator::Configuration(None, Keys::one(Configuration::named("U"))), &sign).sign;
    assert!(!write(&replaced).contains("becoming"), "{}", write(&replaced));
}

#[test]
fn signs_of_the_lexicon_come_back_from_backwards() {
    let all = signs_of("lsf");
    let same = all.iter().filter(|s| inverted(&inverted(s)) == **s).count();
    assert!(2 * same > all.len(), "{same} of {}", all.len());
    for sign in all {
        reads_back(&inverted(&sign)).unwrap();
    }
}

/// The wrist of a side at a share of the stroke, metres.
fn wrist(sign: &Sign, side: Side, share: f64) -> glam::DVec3 {
    let made = perform(sign);
    let (start, end) = (made.report.keys[0].0, made.report.keys.last().unwrap().0);
    let hand = world().signer.arm(side).hand;
    body_at(&made, Seconds(start + share * (end - start))).position(hand)
}

#[test]
fn the_inverse_goes_the_same_way_back() {
    for name in ["CLAIR", "DONNER", "AIMER"] {
        let sign = lsf(name);
        let back = inverted(&sign);
        for share in [0.0, 0.25, 0.5, 0.75, 1.0] {
            let (there, here) = (wrist(&sign, Side::Right, 1.0 - share), wrist(&back, Side::Right, share));
            assert!(there.distance(here) < 0.02, "{name} at {share}: {there} and {here}");
        }
    }
}

#[test]
fn places_inside_a_sign_come_back_in_turn() {
    let sign = one(
        "sign A\n  configuration flat\n  placement space low\n  movement ( to space left then to space high ) then up 6cm then back to key 2\n",
    );
    let back = inverted(&sign);
    for share in [0.0, 1.0] {
        let (there, here) = (wrist(&sign, Side::Right, 1.0 - share), wrist(&back, Side::Right, share));
        assert!(there.distance(here) < 0.01, "{share}: {there} and {here}\n{}", write(&back));
    }
    let (a, b) = (perform(&sign), perform(&back));
    let hand = world().signer.arm(Side::Right).hand;
    for key in 0..=3 {
        let there = body_at(&a, a.report.keys[key]).position(hand);
        let here = body_at(&b, b.report.keys[3 - key]).position(hand);
        assert!(there.distance(here) < 0.01, "key {key}: {there} and {here}\n{}", write(&back));
    }
}

#[test]
fn swapped_is_the_mirror_image_of_the_arms() {
    for name in ["DONNER", "BOIRE"] {
        let sign = lsf(name);
        let left = swapped(&sign);
        for share in [0.0, 0.5, 1.0] {
            let (r, l) = (wrist(&sign, Side::Right, share), wrist(&left, Side::Left, share));
            assert!(glam::DVec3::new(-r.x, r.y, r.z).distance(l) < 0.01, "{name}: {r} and {l}");
        }
    }
}

#[test]
fn a_repeated_inverse_is_an_inverse_repeated() {
    let sign = lsf("DONNER");
    let twice = |s: &Sign| repeated(s, 2, Some(Seconds(0.3)), 0, &tables()).unwrap();
    let (a, b) = (inverted(&twice(&sign)), twice(&inverted(&sign)));
    for share in [0.0, 0.3, 0.5, 0.8, 1.0] {
        let (a, b) = (wrist(&a, Side::Right, share), wrist(&b, Side::Right, share));
        assert!(a.distance(b) < 0.03, "{share}: {a} and {b}");
    }
}

#[test]
fn signs_on_the_body_are_anchored() {
    let left = |forced| Operator::At(Relocation { place: Place::Space(Space { left: 1, ..Space::default() }), forced });
    for (name, moves) in [("PENSER", false), ("CHIEN", false), ("BOL", true), ("CLAIR", true)] {
        let sign = lsf(name);
        let moved = apply(&left(Forced::No), &sign, &tables());
        assert_eq!(moved.is_ok(), moves, "{name}");
        let forced = apply(&left(Forced::Yes), &sign, &tables()).unwrap().sign;
        assert!(forced.relocated.is_some() && Sign { relocated: None, ..forced } == sign);
    }
}

#[test]
fn configurations_of_a_base_bring_their_meaning() {
    let snail = lsf("ESCARGOT");
    let with = |shape: &str| applied(Operator::Configuration(None, Keys::one(Configuration::named(shape))), &snail);
    let slug = with("U");
    assert_eq!((slug.sign.meaning[0].1.as_str(), slug.warnings.len()), ("slug", 0));
    // The weak hand is another shape of its own: it stays.
    assert_eq!(slug.sign.weak, snail.weak);
    assert!(with("5").warnings[0].contains("attested are Y, K, U"));
    assert_eq!(with("Y").sign, snail);
    assert_eq!(lsf("LIMACE").meaning, slug.sign.meaning);
}

#[test]
fn the_papers_signs_come_out() {
    assert_eq!(lsf("FONCÉ").strong.configuration.at(0).unwrap().base, "5");
    // Two performances and the way back between.
    assert_eq!(lsf("TRAVAIL").intervals, 3);
    let shapes = |s: &Sign| s.strong.configuration.iter().map(|(_, c)| c.base.clone()).collect::<String>();
    assert_eq!(shapes(&lsf("DODO")), "DODO");
    assert_eq!((lsf("LSF").intervals, lsf("LSF").strong.movement.len()), (2, 2));
    assert!(perform(&lsf("ÊTRE-DÉGOÛTÉ")).report.residual_m < 0.01);
}

#[test]
fn spelled_words_hold_each_letter_and_slide_on_doubles() {
    let letter = |name: &str| lsf(name);
    let word = spelled(&[letter("B"), letter("E"), letter("L"), letter("L"), letter("E")], Spelling::Held).unwrap();
    // Five holds, four transitions.
    assert_eq!((word.intervals, word.strong.placement.len()), (9, 1));
    let motion = |i: usize| match &word.strong.movement[i] {
        Movement::Action(action) => action.motion.clone(),
        other => panic!("{other:?}"),
    };
    assert_eq!((0..9).filter(|i| motion(*i) == Motion::Hold).count(), 5);
    assert!(matches!(motion(5), Motion::Straight { .. }) && motion(7) == Motion::Return { key: 0 });
    assert!(spelled(&[], Spelling::Derived).is_err());
}

#[test]
fn compounds_and_hands_keep_their_parts() {
    let (a, b) = (lsf("CLAIR"), lsf("DONNER"));
    let whole = chain(&[a.clone(), b.clone()], "AB").unwrap();
    assert_eq!(whole.intervals, a.intervals + b.intervals + 1);
    let both = on_each_hand(&b, &lsf("OK")).unwrap();
    assert_eq!((both.hands, both.strong.placement.clone()), (Hands::Both(None), b.strong.placement.clone()));
    for sign in [whole, both] {
        assert!(perform(&sign).report.residual_m < 0.03, "{}", sign.name);
        reads_back(&sign).unwrap();
    }
}
