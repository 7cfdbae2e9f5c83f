//! What HamNoSys and SiGML mean, and back: reading, lowering, raising and reading again.

use crate::shared::shared;
use chereme::diagnostics::{Severity, Source};
use chereme::notation::formats::{Form, Notation, Words, read_any, write_any};
use chereme::notation::hamnosys::{Dictionary, lower, parse, print, raise};
use chereme::notation::sigml;
use chereme::phonology::{Configuration, Hands, Heading, Keys, Motion, Movement, Sign};

/// The signs of a folder of SiGML, by file.
fn lexicon(folder: &str) -> Option<Vec<(String, Source)>> {
    let root = shared(&format!("data/lexica/{folder}"))?;
    let mut all: Vec<_> = std::fs::read_dir(root).ok()?.map(|e| e.expect("a file").path()).collect();
    all.sort();
    let sigml = |path: &std::path::PathBuf| path.extension().is_some_and(|e| e == "sigml");
    let read = |path: std::path::PathBuf| {
        let text = std::fs::read_to_string(&path).expect("a readable file");
        (path.display().to_string(), Source::new(path.display().to_string(), text))
    };
    Some(all.into_iter().filter(sigml).map(read).collect())
}

fn sign(text: &str) -> Sign {
    let (tree, told) = parse::sign(text);
    assert!(told.iter().all(|d| d.severity != Severity::Fault), "{told:?}");
    lower(&tree.expect("a sign"), Dictionary::builtin(), "").0.expect("a meaning")
}

fn again(text: &str) -> String {
    let raised = raise(&sign(text), Dictionary::builtin()).expect("expressible");
    print::print(&raised.sign, print::Form::Names).expect("printable")
}

#[test]
fn what_is_in_normal_form_comes_back_as_it_was_written() {
    for text in [
        "hamflathand,hamextfingeru,hampalmd,hamchest,hamclose,hammoveo",
        "hamfinger2,hamthumbacrossmod,hamextfingerul,hampalmdl,hamforehead,hamlrat,hamtouch",
        "hamsymmlr,hamfist,hamextfingero,hampalmd,hamshoulders,hammoved,hamrepeatfromstart",
        "hamfinger2345,hamextfingerul,hamextfingeruo,hampalmd,hambetween,hampalmdl,hamneck,hamlrbeside,hamcircleo,hamsmallmod",
        "hamflathand,hamextfingero,hampalmd,hamchest,hamparbegin,hammoveu,hamreplace,hamextfingeru,hamparend",
        "hamfist,hamextfingeru,hampalml,hamchin,hamtouch,hammoveo,hamarcu,hamlargemod,hamfast",
        "hamnondominant,hamflathand,hamextfingero,hampalmu,hamstomach",
    ] {
        assert_eq!(again(text), text);
        assert_eq!(again(&again(text)), again(text));
    }
}

/// Handshapes are written by any of their names, the letters of the sign's own alphabet first.
#[test]
fn other_names_of_handshapes_are_written() {
    let of = |name: &str, language: &str| {
        let mut sign = Sign { language: language.into(), ..Sign::named("X") };
        sign.strong.configuration = Keys::one(Configuration::named(name));
        raise(&sign, Dictionary::builtin())
            .map(|raised| print::print(&raised.sign, print::Form::Names).expect("printable"))
    };
    assert_eq!(of("S", "").as_deref(), Ok("hamfist,hamthumbacrossmod"));
    assert_eq!(of("fist-s", ""), of("S", ""));
    assert_eq!(of("M", "lsf"), of("M-lsf", ""));
    assert!(of("M", "").is_err(), "an M of several alphabets");
}

#[test]
fn a_symmetry_is_followed_and_a_split_is_said_of_each_hand() {
    let both = sign("hamsymmlr,hamflathand,hamextfingerol,hampalmu,hamchest,hammoveu");
    assert!(matches!(both.hands, Hands::Both(Some(_))) && both.weak.is_empty(), "{both:?}");
    let split = sign(
        "hamparbegin,hamfinger2,hamplus,hamflathand,hamparend,hamextfingero,hampalmd,hamchest,hammoved,hamsmallmod",
    );
    assert_eq!(split.hands, Hands::Both(None));
    assert_ne!(split.strong.configuration, split.weak.configuration);
    assert!(split.weak.movement.is_empty());
}

#[test]
fn a_replacement_is_said_at_the_key_after_it_and_in_brackets_by_the_movement() {
    let key = sign("hamflathand,hamextfingero,hampalmd,hamchest,hamparbegin,hammoveu,hamreplace,hamfist,hamparend");
    assert_eq!(key.intervals, 1);
    assert!(key.strong.configuration.stated(1).is_some());
    let inside = sign(
        "hamflathand,hamextfingero,hampalmd,hamchest,hamseqbegin,hammoveu,hamreplace,hamfist,hammoved,hamseqend,hamrepeatfromstart",
    );
    assert!(inside.strong.configuration.stated(1).is_none());
    let becomes = |m: &Movement| m.any_action(&|a| a.becoming.is_some());
    assert!(inside.strong.movement.iter().any(becomes), "{:?}", inside.strong.movement);
}

#[test]
fn palms_of_fingers_that_point_to_the_signer_keep_left_and_right() {
    let facing = |text: &str| {
        let o = *sign(text).strong.orientation.stated(0).expect("an orientation");
        o.palm.map(Heading::vector).expect("a palm")
    };
    // The palm of a hand on the chest, fingers left and in, symbol right: to the body.
    let chest = facing("hamflathand,hamextfingeril,hampalmr,hamchest,hamtouch");
    let fingers = (glam::DVec3::X - glam::DVec3::Z).normalize();
    let across = chest - fingers * chest.dot(fingers);
    assert!(across.x < 0.0 && across.z < 0.0, "{across}");
    assert!(facing("hamflathand,hamextfingerui,hampalml,hamforehead,hamtouch").x > 0.9);
}

#[test]
fn circles_count_their_turns() {
    let turns = |text: &str| match &sign(&format!("hamfist,hamextfingero,hampalmd,hamchest,{text}")).strong.movement[0]
    {
        Movement::Action(action) => match action.motion {
            Motion::Circle { turns, .. } => turns,
            ref other => panic!("{other:?}"),
        },
        other => panic!("{other:?}"),
    };
    assert_eq!(turns("hamcircleo"), 1.0);
    assert_eq!(turns("hamcircleo,hamclocku,hamclockd"), 0.5);
    assert_eq!(turns("hamcircleo,hamclocku,hamclockfull,hamclockd"), 1.5);
}

/// Reading, meaning and writing again: the second time nothing changes any more.
#[test]
fn every_sign_of_the_lexica_has_a_normal_form() {
    let dictionary = Dictionary::builtin();
    for (folder, least_read) in [("ngt", 1.0), ("isl", 0.97)] {
        let Some(files) = lexicon(folder) else {
            return;
        };
        let (mut read, mut exact, mut wrong) = (0, 0, Vec::new());
        for (name, source) in &files {
            let signs = sigml::read(source).0;
            let meant: Vec<_> = signs.iter().filter_map(|tree| Some((tree, lower(tree, dictionary, "").0?))).collect();
            read += usize::from(!meant.is_empty());
            for (tree, sign) in meant {
                let once = raise(&sign, dictionary).unwrap_or_else(|e| panic!("{name}: {e:?}")).sign;
                let twice = lower(&once, dictionary, "").0.and_then(|s| raise(&s, dictionary).ok());
                exact += usize::from(once == *tree);
                if twice.is_none_or(|twice| twice.sign != once) {
                    wrong.push(name.clone());
                }
            }
        }
        println!("{folder}: {read} of {} files read, {exact} signs written again exactly as they were", files.len());
        assert!(wrong.is_empty(), "{wrong:?}");
        assert!(read as f64 >= least_read * files.len() as f64, "{folder}: {read} of {}", files.len());
    }
}

#[test]
fn any_notation_is_converted_to_any_other() {
    let words = Words::default();
    let text = "hamflathand,hamextfingeru,hampalmd,hamchest,hamclose,hammoveo";
    let source = Source::new("one.ham", format!("HELLO\t{text}\n"));
    let read = read_any(&source, Notation::HamNoSys, &words, "x");
    assert!(read.diagnostics.is_empty() && read.refused == 0, "{:?}", read.diagnostics);
    let first = &read.signs[0].sign;
    assert_eq!(first.name, "HELLO");
    for (form, notation) in [
        (Form::SiGml, Notation::SiGml),
        (Form::HSiGml, Notation::SiGml),
        (Form::HamNoSys, Notation::HamNoSys),
        (Form::Names, Notation::HamNoSys),
        (Form::Sign, Notation::Sign),
    ] {
        let written = write_any(&[first], form, &words);
        assert!(written.refused.is_empty() && !written.text.is_empty(), "{form:?}: {:?}", written.refused);
        let again = read_any(&Source::new("two", written.text.clone()), notation, &words, "x");
        assert_eq!(again.signs.iter().map(|s| &s.sign).collect::<Vec<_>>(), [first], "{form:?}: {}", written.text);
    }
    let unsayable = Sign { relocated: None, ..sign_at_a_point() };
    assert_eq!(write_any(&[&unsayable], Form::SiGml, &words).refused[0].reasons, ["HamNoSys has no points in metres"]);
}

fn sign_at_a_point() -> Sign {
    let text = "sign P\n  configuration flat\n  placement point 0.1 1.2 0.4\n";
    let read = read_any(&Source::new("p.sign", text), Notation::Sign, &Words::default(), "");
    read.signs[0].sign.clone()
}

/// What `.sign` text says, in names of symbols and read again.
fn through_hamnosys(text: &str) -> (Sign, Sign) {
    let reading = chereme::notation::read(text, &chereme::notation::Vocabulary::builtin(), "");
    assert_eq!(reading.diagnostics, [], "{text}");
    let said = reading.signs[0].sign.clone();
    let raised = raise(&said, Dictionary::builtin()).unwrap_or_else(|e| panic!("{text}: {e:?}"));
    let again = lower(&raised.sign, Dictionary::builtin(), "").0.expect("a meaning");
    (said, again)
}

#[test]
fn two_hands_of_which_the_same_is_said_stay_two() {
    for text in [
        "sign X\n  hands both\n  configuration flat\n  placement chest\n",
        "sign X\n  hands both\n  configuration flat\n  strong movement up\n",
        "sign X\n  hands both\n  orientation fingers up, palm out\n",
        "sign X\n  hands both\n  placement chest, close\n",
    ] {
        let (said, again) = through_hamnosys(text);
        assert_eq!(again.hands, Hands::Both(None), "{text}");
        assert_eq!((&again.strong, &again.weak), (&said.strong, &said.weak), "{text}");
    }
    let nothing = chereme::notation::read("sign X\n  hands both\n", &chereme::notation::Vocabulary::builtin(), "");
    let told = raise(&nothing.signs[0].sign, Dictionary::builtin()).unwrap_err();
    assert!(told[0].contains("second hand"), "{told:?}");
}

#[test]
fn a_constellation_names_what_is_touched_first() {
    let tip = sign(
        "hamparbegin,hamfinger2,hamplus,hamflathand,hamparend,hamparbegin,hamextfingerl,hamplus,hamextfingeror,hamparend,\
         hampalmd,hamparbegin,hampalm,hamplus,hamfingertip,hamindexfinger,hamparend,hamtouch,hammoved,hamsmallmod",
    );
    let contact = tip.contact.stated(0).expect("a contact");
    let part = |point: Option<chereme::phonology::HandPoint>| point.map(|p| p.part());
    use chereme::phonology::HandPart;
    assert_eq!((part(contact.strong), part(contact.weak)), (Some(HandPart::Tip), Some(HandPart::Palm)));
    let (said, again) = through_hamnosys(
        "sign X\n  hands both\n  strong configuration index\n  weak configuration flat\n  contact strong index tip touches weak palm at start\n",
    );
    assert_eq!(said.contact, again.contact);
}

#[test]
fn three_turns_and_the_speed_of_brackets_come_back() {
    let (said, again) = through_hamnosys("sign X\n  configuration flat\n  movement circle axis out small turns 3\n");
    assert_eq!(said.strong.movement, again.strong.movement);
    let cue = |sign: &Sign| sign.nonmanual.clone();
    let (_, once) = through_hamnosys("sign X\n  configuration flat\n  head (nod then shake)\n");
    assert!(!cue(&once).is_empty());
}

#[test]
fn mouth_gestures_that_are_words_are_known() {
    let text = r#"<sigml><hns_sign gloss="X"><hamnosys_nonmanual><hnm_mouthgesture tag="sad"/></hamnosys_nonmanual>
        <hamnosys_manual><hamflathand/><hamextfingeru/><hampalml/></hamnosys_manual></hns_sign></sigml>"#;
    let (signs, told) = sigml::read(&Source::new("x.sigml", text));
    assert!(told.is_empty(), "{told:?}");
    let (sign, told) = lower(&signs[0], Dictionary::builtin(), "");
    assert!(told.is_empty(), "{told:?}");
    assert_eq!(sign.expect("a meaning").nonmanual.len(), 1);
}
