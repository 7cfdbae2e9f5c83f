//! Reading SiGML: the dictionaries of the field, oddities of hand-written files, and files made to do harm.

use crate::golden;
use crate::shared::shared;
use chereme::diagnostics::render::render;
use chereme::diagnostics::{Diagnostic, Severity, Source};
use chereme::notation::hamnosys::syntax::*;
use chereme::notation::sigml::{MOST_BYTES, MOST_DEEP, read};
use chereme::phonology::{Digit, Direction, Size};
use proptest::prelude::*;
use std::time::{Duration, Instant};

/// The files of a folder of `../shared`, by name.
pub fn files(folder: &str) -> Vec<Source> {
    let Some(folder) = shared(folder) else { return Vec::new() };
    let mut paths: Vec<_> = std::fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()).collect();
    paths.retain(|path| path.extension().is_some_and(|e| e == "sigml"));
    paths.sort();
    let name = |path: &std::path::Path| path.file_name().unwrap().to_string_lossy().into_owned();
    paths.iter().map(|path| Source::new(name(path), std::fs::read_to_string(path).unwrap())).collect()
}

fn faults(told: &[Diagnostic]) -> Vec<&str> {
    told.iter().filter(|d| d.severity == Severity::Fault).map(|d| d.message.as_str()).collect()
}

/// The one sign of a gestural body.
fn sign(body: &str) -> (Sign, Vec<String>) {
    let text = format!("<sigml><hamgestural_sign gloss=\"X\">{body}</hamgestural_sign></sigml>");
    let (mut signs, told) = read(&Source::new("x.sigml", text));
    assert!(faults(&told).is_empty() && signs.len() == 1, "{body}: {told:?}");
    (signs.remove(0), told.into_iter().map(|d| d.message).collect())
}

/// The one phase of what stands in a `sign_manual`.
fn phase(content: &str) -> (Phase, Vec<String>) {
    let (mut sign, told) = sign(&format!("<sign_manual>{content}</sign_manual>"));
    assert_eq!(sign.phases.len(), 1, "{content}");
    (sign.phases.remove(0), told)
}

fn shape(attributes: &str) -> (Shape, Vec<String>) {
    let (phase, told) = phase(&format!("<handconfig {attributes}/>"));
    let Some(Split::Both(shape)) = phase.posture.shape else { panic!("{attributes}: {phase:?}") };
    (shape, told)
}

fn fingers(attributes: &str) -> (Fingers, Vec<String>) {
    let (phase, told) = phase(&format!("<handconfig {attributes}/>"));
    let Some(Split::Both(fingers)) = phase.posture.fingers else { panic!("{attributes}: {phase:?}") };
    (fingers, told)
}

fn to(letters: &str) -> Direction {
    let word = |c| match c {
        'u' => "up",
        'd' => "down",
        'o' => "out",
        'i' => "in",
        'l' => "left",
        _ => "right",
    };
    letters.chars().map(word).collect::<Vec<_>>().join("-").parse().unwrap()
}

#[test]
fn the_dutch_dictionary_is_read_whole() {
    let files = files("data/lexica/ngt");
    let (mut signs, mut phases, mut warned) = (0, 0, 0);
    for source in &files {
        let (read, told) = read(source);
        assert!(faults(&told).is_empty(), "{}: {:?}", source.name, faults(&told));
        assert_eq!(read.len(), 1, "{}", source.name);
        signs += read.len();
        phases += read[0].phases.len();
        warned += usize::from(!told.is_empty());
        for told in told.iter().filter(|_| std::env::var_os("TOLD").is_some()) {
            println!("{}", render(told, source, false));
        }
    }
    println!("{signs} signs with {phases} phases, {warned} with warnings");
    assert!(files.is_empty() || (signs, phases) == (2203, 2435));
}

/// What a fault is about, without the sign and what it names.
fn reason(message: &str) -> String {
    let message = message.split_once(": ").map_or(message, |(_, message)| message);
    message.split('`').step_by(2).collect::<Vec<_>>().join("…")
}

#[test]
fn most_of_the_indian_dictionary_is_read_and_the_rest_has_its_reasons() {
    let files = files("data/lexica/isl");
    let (mut signs, mut without, mut warned, mut refused) = (0, 0, 0, 0);
    let mut reasons = std::collections::BTreeMap::<String, usize>::new();
    for source in &files {
        let (read, told) = read(source);
        signs += read.len();
        let faults = faults(&told);
        refused += usize::from(!faults.is_empty());
        warned += usize::from(faults.is_empty() && !told.is_empty());
        without += usize::from(told.is_empty());
        faults.first().into_iter().for_each(|fault| *reasons.entry(reason(fault)).or_default() += 1);
    }
    println!(
        "{signs} signs; files: {without} without a word, {warned} with warnings, {refused} with faults: {reasons:#?}"
    );
    assert!(files.is_empty() || (files.len() == 849 && without > 650 && refused < 43), "{without} {refused}");
}

#[test]
fn plain_symbols_come_as_elements_nested_and_as_text() {
    let read = |manual: &str| {
        let text = format!("<hns_sign gloss='A'><hamnosys_manual>{manual}</hamnosys_manual></hns_sign>");
        let (mut signs, told) = read(&Source::new("plain.sigml", text));
        assert!(faults(&told).is_empty(), "{manual}: {told:?}");
        signs.remove(0).phases
    };
    let flat = read("<hamfist/><hamextfingeru/><hampalml/><hammoveo/>");
    assert_eq!(flat.len(), 1);
    assert_eq!(read("<hamfist><hamextfingeru/><hampalml>  </hampalml></hamfist><hammoveo/>"), flat);
    assert_eq!(read("hamfist, hamextfingeru<!-- palm --><hampalml/>moveo"), flat);
    assert_eq!(read("&#xE000;\u{E020}<hampalml/><hammoveo/>"), flat);
    assert!(read("").is_empty());
}

#[test]
fn plain_values_of_one_tier_are_at_the_same_time() {
    let text = r#"<hns_sign><hamnosys_nonmanual><hnm_head tag="NO"/><hnm_mouthpicture picture="n@U"/>
        <hnm_eyebrows tag="RB"/><hnm_head tag="TL"/><hnm_nose tag="WR"/></hamnosys_nonmanual></hns_sign>"#;
    let (signs, told) = read(&Source::new("plain.sigml", text));
    assert!(told.is_empty(), "{told:?}");
    let together = |tier: &Tier| matches!(&tier.cues[..], [Cue::Together(cues)] if cues.len() == 2);
    let told: Vec<_> = signs[0].nonmanual.iter().map(|tier| (tier.kind, together(tier))).collect();
    assert_eq!(told, [(TierKind::Head, true), (TierKind::Mouthing, false), (TierKind::FacialExpression, true)]);
}

#[test]
fn every_part_of_a_posture_is_read() {
    let (phase, told) = phase(
        r#"<handconfig handshape="finger2" thumbpos="out"/><handconfig extfidir="uo" second_extfidir="u"/>
           <handconfig palmor="dl"/><location_bodyarm location="chest" side="right_at" contact="close"/>"#,
    );
    assert!(told.is_empty(), "{told:?}");
    let main = BentClass { class: ShapeClass::Finger2, thumb: Some(Thumb::Out), bend: None };
    assert_eq!(phase.posture.shape, Some(Split::Both(Shape { main, ..Shape::of(ShapeClass::Finger2) })));
    let pointed = Fingers { direction: to("uo"), between: Some(to("u")), relative: false };
    assert_eq!(phase.posture.fingers, Some(Split::Both(pointed)));
    let Some(Location::One(Site::Body { level: Some(levels), contact, .. })) = phase.location else { panic!() };
    assert_eq!((levels.first.side, contact), (Some(Side::RightAt), Some(Contact::Close)));
}

#[test]
fn split_postures_are_of_each_hand_and_add_up() {
    let (phase, told) = phase(
        r#"<handconfig handshape="flat"/>
           <split_handconfig><handconfig extfidir="u"/><handconfig extfidir="d" palmor="l"/></split_handconfig>"#,
    );
    assert!(told.is_empty(), "{told:?}");
    let pointed = |letters| Some(Fingers { direction: to(letters), between: None, relative: false });
    assert_eq!(phase.posture.fingers, Some(Split::Each(pointed("u"), pointed("d"))));
    assert!(matches!(phase.posture.palm, Some(Split::Each(None, Some(_)))));
    assert!(matches!(phase.posture.shape, Some(Split::Both(_))));
}

#[test]
fn fingers_are_listed_by_what_the_class_makes_of_them() {
    let listed = |attributes| shape(attributes).0.fingers.iter().map(|f| (f.finger, f.opposed)).collect::<Vec<_>>();
    assert_eq!(listed(r#"handshape="finger2" specialfingers="5""#), [(Digit::Pinky, false)]);
    assert_eq!(listed(r#"handshape="flat" mainbend="bent" exempteddigits="32""#).len(), 2);
    let opposed = r#"handshape="cee12open" specialfingers="34" opposedfinger="4""#;
    assert_eq!(listed(opposed), [(Digit::Middle, false), (Digit::Ring, true)]);
    let (pinch, told) = shape(r#"handshape="pinch12" mainbend="bent" specialfingers="23" exempteddigits="23""#);
    assert!(told.is_empty() && pinch.lists() == FingerList::SpecialAndExempted, "{told:?}");
    let (thumb, told) = shape(r#"handshape="flat" mainbend="round" exempteddigits="1""#);
    assert!(told.is_empty() && thumb.thumb == Some(ThumbSpecial::Exempted) && thumb.fingers.is_empty());
    let (fist, told) = shape(r#"handshape="fist" specialfingers="2""#);
    assert!(fist.lists() == FingerList::Exempted && told.len() == 1, "{told:?}");
}

#[test]
fn bends_have_names_or_quarters() {
    let bend = |word: &str| shape(&format!("handshape=\"flat\" mainbend=\"{word}\"")).0.main.bend;
    assert_eq!(bend("bent"), Some(Bend::Bent));
    assert_eq!(bend("halfbent"), Some(Bend::HalfBent));
    assert_eq!(bend("410"), Some(Bend::Quarters([4, 1, 0])));
    assert_eq!(bend("0.50.50.5"), Some(Bend::Quarters([1, 1, 1])));
    let (cee, _) = shape(r#"handshape="ceeall" ceeopening="slack" bend2="111" bend5="hooked""#);
    assert_eq!(cee.main.thumb, Some(Thumb::Open));
    let bends = [(Some(Digit::Index), Bend::Quarters([1; 3])), (Some(Digit::Pinky), Bend::Hooked)];
    assert_eq!(cee.bends, bends);
}

#[test]
fn oddities_of_directions_are_read_as_they_are_meant() {
    let (up, told) = fingers(r#"extfidir="uuo""#);
    assert_eq!((up.direction, up.between), (to("u"), Some(to("uo"))));
    assert!(told.is_empty());
    let (between, told) = fingers(r#"extfidir="uo" second_extfidir="uul""#);
    assert_eq!((between.between, told.len()), (Some(to("ul")), 1));
    assert_eq!(fingers(r#"extfidir="lou""#).0.direction, to("uol"));
    let palm = |attributes: &str| {
        let (phase, told) = phase(&format!("<handconfig {attributes}/>"));
        let Some(Split::Both(palm)) = phase.posture.palm else { panic!("{attributes}") };
        assert!(told.is_empty(), "{told:?}");
        palm.facing
    };
    assert_eq!(palm(r#"palmor="il""#), Facing::Toward(to("il")));
    assert_eq!(palm(r#"palmor="od""#), Facing::Toward(to("do")));
    assert_eq!(palm(r#"palmor="dl" abs_palmor="true""#), Facing::Toward(to("dl")));
    assert!(matches!(palm(r#"palmor="ld""#), Facing::Roll(_)));
    assert!(matches!(palm(r#"palmor="ll""#), Facing::Roll(_)));
    let (_, told) = phase(r#"<directedmotion direction="uir" second_direction="oi"/>"#);
    assert!(told.len() == 1 && told[0].contains("opposite"), "{told:?}");
}

#[test]
fn places_are_of_the_body_of_the_hand_and_between() {
    let place = |content: &str| phase(content).0.location.unwrap();
    let Location::One(Site::Body { level, .. }) = place("<location_bodyarm contact=\"armextended\"/>") else {
        panic!()
    };
    assert_eq!(level, None, "neutral space");
    let hand = place(
        r#"<location_hand digits="2" location="base" second_digits="3" second_location="midjoint" side="palmar">
           <location_hand digits="12" location="tip"/></location_hand>"#,
    );
    let Location::One(Site::Hand { level, with: Some(with), .. }) = hand else { panic!() };
    assert_eq!(level.first.part, HandPlace::Digits(vec![Digit::Index], Some(FingerPart::Base)));
    assert_eq!(level.first.face, Some(Face::Palmar));
    assert!(level.between.is_some_and(|between| between.face.is_none()));
    assert_eq!(with.first.part, HandPlace::Digits(vec![Digit::Thumb, Digit::Index], Some(FingerPart::Tip)));
    let both = place(
        r#"<handconstellation contact="touch"><location_hand location="palm"/><location_hand location="handback"/>
           <location_bodyarm location="chest"/></handconstellation>"#,
    );
    assert!(matches!(both, Location::Constellation(Constellation { points: Some(_), at: Some(_), .. })));
    let (misplaced, told) = phase(r#"<location_hand location="chin"/>"#);
    assert!(matches!(misplaced.location, Some(Location::One(Site::Body { .. }))) && told.len() == 1);
}

#[test]
fn a_change_of_posture_may_have_a_target() {
    let (phase, told) = phase(
        r#"<tgt_motion fast="true"><changeposture/><handconfig handshape="fist"/><location_bodyarm location="chin"/>
           </tgt_motion><tgt_motion><directedmotion direction="u"/><location_bodyarm/></tgt_motion>
           <tgt_motion><handconstellation contact="touch"/></tgt_motion>"#,
    );
    assert!(told.is_empty(), "{told:?}");
    let [Action::Target(change, _), Action::Target(up, _), Action::Target(still, _)] = &phase.actions[..] else {
        panic!("{:?}", phase.actions)
    };
    assert!(matches!(&**change, Action::Move(m) if matches!(m.motion, Motion::Replace(_)) && m.fast));
    assert!(matches!(&**up, Action::Move(m) if matches!(m.motion, Motion::Straight(_))));
    assert!(matches!(&**still, Action::Move(m) if m.motion == Motion::Nothing));
}

#[test]
fn manners_that_stand_on_the_wrong_element_are_read_with_a_warning() {
    let (phase, told) = phase(
        r#"<rpt_motion repetition="fromstart" speed="2"><split_motion manner="slow"><directedmotion direction="u"/>
           <nomotion/></split_motion></rpt_motion>"#,
    );
    assert_eq!(told.len(), 2, "{told:?}");
    let Action::Repeated(split, _) = &phase.actions[0] else { panic!() };
    let Action::Split(Some(strong), None) = &**split else { panic!("{split:?}") };
    assert!(matches!(&**strong, Action::Move(m) if m.slow && m.speed == Some(2.0)));
}

#[test]
fn phases_nest_to_any_depth_and_keep_their_order() {
    let (sign, told) = sign(
        r#"<sign_manual><sign_manual><handconfig handshape="fist"/></sign_manual>
           <sign_manual><sign_manual holdover="true"/><sign_manual nondominant="true"><nomotion/></sign_manual>
           </sign_manual></sign_manual>"#,
    );
    assert!(told.is_empty(), "{told:?}");
    assert_eq!(sign.phases.iter().map(|p| p.holds_over).collect::<Vec<_>>(), [false, true, false]);
    assert_eq!(sign.phases[2].hands, Hands::Weak);
}

#[test]
fn repetitions_move_on_and_alternate() {
    let (phase, told) = phase(
        r#"<rpt_motion repetition="fromstart_several" second_repetition="reverse" approx_repetition="true"
            repetition_baseshift="d" baseshift_size="small" alternating="true" second_alternating="true">
            <wristmotion motion="nodding" size="big"/></rpt_motion>"#,
    );
    assert!(told.is_empty(), "{told:?}");
    let Action::Alternating(repeated, Times::Twice) = &phase.actions[0] else { panic!() };
    let Action::Repeated(_, repetition) = &**repeated else { panic!() };
    assert_eq!(repetition.second, Some(RepetitionKind::Reverse));
    assert_eq!(repetition.shift, Some(Shift { direction: Direction::DOWN, size: Size::Small, growth: None }));
}

#[test]
fn tiers_hold_values_together_and_in_sequence() {
    let (sign, told) = sign(
        r#"<sign_nonmanual><head_tier><head_seq><head_movement movement="NO" amount="0.5"/><head_par>
           <head_movement movement="TL" speed="0.3"/><shoulder_movement movement="UL"/></head_par></head_seq></head_tier>
           <mouthing_tier fitpicturetomanual="true"><mouth_picture picture="hVi:s"/></mouthing_tier></sign_nonmanual>"#,
    );
    assert!(told.is_empty(), "{told:?}");
    let [Cue::Sequence(cues)] = &sign.nonmanual[0].cues[..] else { panic!() };
    assert!(matches!(&cues[..], [Cue::One(no), Cue::Together(two)] if no.amount == Some(0.5) && two.len() == 2));
    assert_eq!(sign.nonmanual[1].kind, TierKind::Mouthing);
}

#[test]
fn a_bad_sign_leaves_the_others() {
    let text = r#"<sigml><!-- two and one -->
        <hamgestural_sign gloss="A"><sign_manual><directedmotion direction="x"/></sign_manual></hamgestural_sign>
        <signing_ref uri="other.sigml"/>
        <hamgestural_sign gloss="B"><sign_manual><wristmotion motion="nodding"/></sign_manual></hamgestural_sign>
        <h:hns_sign xmlns:h="urn:x" h:id="1" gloss="C"/></sigml>"#;
    let (signs, told) = read(&Source::new("three.sigml", text));
    let glosses: Vec<_> = signs.iter().map(|sign| sign.gloss.as_deref().unwrap()).collect();
    assert_eq!(glosses, ["B", "C"]);
    assert_eq!(faults(&told).len(), 1);
    assert!(told[0].message.starts_with("A: "), "{}", told[0].message);
}

#[test]
fn each_mistake_has_its_message() {
    golden::beside("sigml", "sigml", 20, |name, bytes| {
        let source = Source::new(name, String::from_utf8_lossy(bytes));
        let (_, told) = read(&source);
        assert!(!told.is_empty(), "{name} has no fault");
        told.iter().map(|d| render(d, &source, false) + "\n\n").collect()
    });
}

/// Reading refuses the text, and soon.
fn refused(text: String, expected: &str) {
    let started = Instant::now();
    let (signs, told) = read(&Source::new("harm.sigml", text));
    assert!(started.elapsed() < Duration::from_secs(2), "{expected}: {:?}", started.elapsed());
    assert!(signs.is_empty() && faults(&told).iter().any(|m| m.contains(expected)), "{expected}: {:?}", faults(&told));
}

#[test]
fn files_made_to_do_harm_are_refused_at_once() {
    let bomb = "<!DOCTYPE a [<!ENTITY a \"aaaaaaaaaa\"><!ENTITY b \"&a;&a;&a;&a;&a;&a;&a;&a;\">]><sigml>&b;</sigml>";
    refused(bomb.to_owned(), "document type");
    refused("<!-- <!DOCTYPE --><sigml>&lol;</sigml>".to_owned(), "no entity");
    refused("<sigml>".repeat(1_000_000), "within each other");
    let many: String = (0..300_000).map(|i| format!(" a{i}=\"\"")).collect();
    refused(format!("<sigml{many}/>"), "attributes");
    let names: String = (0..50).map(|i| format!(" xmlns:a{i}=\"u{i}\"")).collect();
    refused(format!("<sigml{names}><sigml{names}>"), "namespaces");
    refused(" ".repeat(MOST_BYTES + 1), "larger");
}

#[test]
fn many_faults_are_counted_not_kept() {
    let text = format!("<sigml><hamgestural_sign>{}</hamgestural_sign></sigml>", "<x/>".repeat(100_000));
    let (signs, told) = read(&Source::new("many.sigml", text));
    assert!(signs.len() == 1 && told.len() == 1001, "{}", told.len());
    assert!(told[1000].message.contains("99000 more"), "{}", told[1000].message);
}

#[test]
fn nesting_up_to_the_limit_is_read() {
    let deep = MOST_DEEP - 3;
    let text = format!(
        "<sigml><hamgestural_sign><sign_manual>{}{}</sign_manual></hamgestural_sign></sigml>",
        "<par_motion>".repeat(deep),
        "</par_motion>".repeat(deep)
    );
    assert_eq!(read(&Source::new("deep.sigml", text)).0.len(), 1);
}

/// Words of SiGML, put together at random.
const WORDS: &[&str] = &[
    "<sigml>",
    "</sigml>",
    "<hamgestural_sign gloss=\"A\">",
    "</hamgestural_sign>",
    "<hns_sign>",
    "</hns_sign>",
    "<hamnosys_manual>",
    "</hamnosys_manual>",
    "<hamflathand/>",
    "<sign_manual both_hands=\"true\">",
    "</sign_manual>",
    "<handconfig handshape=\"",
    "<handconfig palmor=\"",
    "mainbend=\"0.50.50.5\"",
    "flat\"/>",
    "uuo\"/>",
    "<tgt_motion>",
    "</tgt_motion>",
    "<rpt_motion repetition=\"fromstart\">",
    "</rpt_motion>",
    "<location_hand digits=\"12345\">",
    "</location_hand>",
    "<split_motion/>",
    "<!--",
    "-->",
    "<![CDATA[",
    "]]>",
    "<!DOCTYPE",
    "&amp;",
    "&#xE000;",
    "\"",
    "=",
    ">",
    " ",
    "é",
    "\u{E000}",
];

proptest! {
    #[test]
    fn no_text_makes_it_panic(text in any::<String>()) {
        read(&Source::new("any", text));
    }

    #[test]
    fn no_mixture_of_its_words_makes_it_panic(words in prop::collection::vec(prop::sample::select(WORDS), 0..60)) {
        read(&Source::new("any", words.concat()));
    }
}
