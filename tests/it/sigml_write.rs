//! Writing SiGML: what is written is read as the same signs.

use crate::sigml_read::files;
use crate::sigml_strategies::sign;
use chereme::diagnostics::{Severity, Source};
use chereme::notation::hamnosys::syntax::*;
use chereme::notation::sigml::{Kind, read, write};
use proptest::prelude::*;

/// Reads what is written; there may be warnings, no faults.
fn again(text: &str) -> Vec<Sign> {
    let (signs, told) = read(&Source::new("again", text));
    let faults: Vec<_> = told.iter().filter(|d| d.severity == Severity::Fault).collect();
    assert!(faults.is_empty(), "{faults:?}\n{text}");
    signs
}

#[test]
fn the_dutch_dictionary_is_written_as_it_was_read() {
    for source in files("data/lexica/ngt") {
        let (signs, _) = read(&source);
        let text = write(&signs, Kind::Gestural).unwrap_or_else(|e| panic!("{}: {e}", source.name));
        assert_eq!(again(&text), signs, "{}\n{text}", source.name);
        assert_eq!(write(&again(&text), Kind::Gestural).unwrap(), text, "{}", source.name);
    }
}

#[test]
fn the_text_is_stable_and_indented() {
    let text = r#"<?xml version="1.0" encoding="UTF-8"?>
<sigml>
  <hamgestural_sign gloss="A &amp; B&#10;" speed="1.5">
    <sign_nonmanual>
      <eyegaze_tier>
        <eye_gaze direction="AD" speed="0.5"/>
      </eyegaze_tier>
    </sign_nonmanual>
    <sign_manual both_hands="true" lr_symm="true" outofphase="true">
      <handconfig handshape="flat" mainbend="round" exempteddigits="12"/>
      <split_handconfig>
        <handconfig extfidir="uo" second_extfidir="u"/>
        <handconfig extfidir="uor"/>
      </split_handconfig>
      <handconfig palmor="dl" second_palmor="l"/>
      <handconstellation contact="touch">
        <location_hand location="tip" digits="2" side="palmar"/>
        <location_hand location="palm"/>
        <location_bodyarm location="chest" second_location="neck" second_side="right_at"/>
      </handconstellation>
      <rpt_motion repetition="fromstart" alternating="true">
        <tgt_motion fast="true">
          <changeposture/>
          <handconfig handshape="fist"/>
          <location_bodyarm location="chin" contact="close"/>
        </tgt_motion>
      </rpt_motion>
    </sign_manual>
  </hamgestural_sign>
</sigml>
"#;
    let signs = again(text);
    assert_eq!(write(&signs, Kind::Gestural).unwrap(), text);
}

/// The one phase with this change, written.
fn refusal(change: impl FnOnce(&mut Phase)) -> String {
    let text = "<hamgestural_sign gloss=\"G\"><sign_manual><nomotion/></sign_manual></hamgestural_sign>";
    let mut signs = again(text);
    change(&mut signs[0].phases[0]);
    write(&signs, Kind::Gestural).unwrap_err().to_string()
}

#[test]
fn what_cannot_be_said_is_named() {
    let part = HandLevel {
        part: HandPlace::Hand("palm".to_owned()),
        approximate: false,
        side: Some(Side::LeftAt),
        face: Some(Face::Dorsal),
    };
    let level = HandLevels { first: part, between: None };
    let site = Site::Hand { level, contact: None, with: None };
    let place = site.clone();
    assert_eq!(
        refusal(|phase| phase.location = Some(Location::One(place))),
        "G: gestural SiGML says the side or the face of a place, not both"
    );
    let weak = Location::Split(None, Some(Site::Named("a".to_owned())));
    assert!(refusal(|phase| phase.location = Some(weak)).contains("weak hand alone"));
    let mut deep = Action::Sequence(Vec::new());
    (0..100).for_each(|_| deep = Action::Sequence(vec![std::mem::replace(&mut deep, Action::Fused(Vec::new()))]));
    assert!(refusal(|phase| phase.actions = vec![deep]).contains("within each other"));
    let named = Location::One(Site::Named("\u{1}".to_owned()));
    assert!(refusal(|phase| phase.location = Some(named)).contains("U+0001"));
}

proptest! {
    #[test]
    fn what_is_written_is_read_as_the_same(signs in prop::collection::vec(sign(), 0..3)) {
        let text = write(&signs, Kind::Gestural).unwrap();
        prop_assert_eq!(&again(&text), &signs, "{}", text);
    }
}
