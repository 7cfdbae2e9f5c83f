//! Descriptions and what they mean: one check a feature.

use chereme::diagnostics::render::render;
use chereme::diagnostics::{Severity, Source};
use chereme::notation::{Vocabulary, read, write};
use chereme::phonology::*;

fn sign(text: &str) -> Sign {
    let reading = read(text, &Vocabulary::open(), "lsf");
    let source = Source::new("test.sign", text);
    let all: Vec<String> = reading.diagnostics.iter().map(|d| render(d, &source, false)).collect();
    assert!(all.is_empty(), "{}", all.join("\n"));
    assert_eq!(reading.signs.len(), 1, "{text}");
    reading.signs[0].sign.clone()
}

/// Says the tiers of a sign and what is written back.
fn check(tiers: &str, written: &str) {
    let body = |tiers: &str| {
        tiers.split("; ").fold("sign X\n".to_owned(), |text, tier| {
            let words = if tier.starts_with("strong ") || tier.starts_with("weak ") { 2 } else { 1 };
            let at = tier.match_indices(' ').nth(words - 1).map_or(tier.len(), |(i, _)| i);
            format!("{text}  {} {}\n", &tier[..at], &tier[at..])
        })
    };
    let first = sign(&body(tiers));
    let text = write(&first);
    let flat: Vec<String> = text.lines().skip(3).map(|l| l.split_whitespace().collect::<Vec<_>>().join(" ")).collect();
    assert_eq!(flat.join("; "), written);
    assert_eq!(sign(&text), first, "{text}");
}

fn same(tiers: &str) {
    check(tiers, tiers);
}

#[test]
fn the_bowl() {
    let bowl = sign(
        "language lsf\nsign BOL\n  meaning        en \"bowl\", fr \"bol\"\n  hands          both mirrored\n  configuration  round-B\n  \
         placement      chest, neutral distance\n  orientation    fingers out-left, palm up\n  movement       arc up-right 15cm\n",
    );
    assert_eq!(bowl.name, "BOL");
    assert_eq!(bowl.meaning[1], ("fr".to_owned(), "bol".to_owned()));
    assert_eq!(bowl.hands, Hands::Both(Some(Symmetry::MIRRORED)));
    assert_eq!(bowl.intervals, 1);
    assert_eq!(bowl.strong.placement.at(1).unwrap().distance, Distance::Neutral);
    let Movement::Action(action) = &bowl.strong.movement[0] else { panic!() };
    assert!(matches!(action.motion, Motion::Arc { extent: Extent::Metres(m), .. } if m == 0.15));
    assert!(bowl.weak.is_empty());
}

#[test]
fn keys_and_intervals() {
    let letters =
        sign("sign LSF # 3 keys, 2 movements\n configuration L then S then F\n movement down 10cm then up 10cm");
    assert_eq!(letters.intervals, 2);
    assert_eq!(letters.strong.configuration.at(1).unwrap().base, "S");
    let changes = sign("sign LSF\n configuration L then S then F");
    assert_eq!(changes.intervals, 2);
    assert_eq!(changes.strong.movement.len(), 2);
    let held = sign("sign A\n configuration A");
    assert_eq!((held.intervals, held.strong.movement.len()), (0, 0));
    let placed = sign("sign A\n configuration A at start then B at end\n movement up then down");
    assert_eq!(placed.strong.configuration.stated(2).unwrap().base, "B");
    same("configuration L then S then F");
    same("configuration L at middle; movement down 10cm then up 10cm");
    same("configuration L at start then S at key 3; movement down then up then left");
    same("configuration flat at end; movement up");
    check("configuration flat then fist at end; movement up", "configuration flat then fist; movement up");
}

#[test]
fn configurations() {
    same("configuration U, thumb out, index hooked");
    same("configuration between A and B");
    same("configuration flat, spread, index over middle, thumb between index middle");
    same("configuration flat, bent");
    same("configuration 5, index middle half-bent, fingers round, together");
    same("configuration LSF S");
    same("configuration between ( flat, thumb out ) and ( 5, round ), index hooked");
    same("configuration between ( A, bent ) and B, tight then C, slack");
    same("configuration 1, on ring pinky, except index, thumb enclosed, joints 4 1 0, index middle joints 0 0 4");
    same("configuration flat, index touching middle nail, thumb touching pad at middle; movement up then down");
    check("configuration 1, thumb touching index tip", "configuration 1, thumb touching index tip");
    check("configuration \"then\"", "configuration \"then\"");
}

#[test]
fn placements() {
    same("placement forehead right, touch, with index tip");
    same("placement beside left ear, 3cm away");
    check("placement beside left ear, 3 cm away", "placement beside left ear, 3cm away");
    check("placement left ear", "placement ear left");
    same("hands both; strong placement other palm, touch; weak placement chest");
    same("placement space left high near");
    same("placement left space left high near");
    same("placement point 0.1 1.2 0.4");
    same("placement between chest and other index tip");
    same("placement between chest and (between belly and chin)");
    same("placement behind head, close, offset up 5cm");
    same("placement referent \"A\", extended");
    check("placement chest, arm extended", "placement chest, extended");
    check("placement the left ear", "placement ear left");
    same("placement between right shoulders and beside left chest, 5cm away");
    check("placement between the right ear and chin left", "placement left between right ear and chin");
    same("placement chin, touch, with index tip to index midjoint");
    same("movement up to chin, with index middle tip to palm, brushing other index tip, to and fro 2");
}

#[test]
fn phases() {
    same(
        "hands both mirrored; movement up; brows raised; then other hand stays; configuration 5; duration 0.5s; then; hands weak; speed 2",
    );
    let two = sign("language lsf\nsign A\n configuration L\n movement up\nthen\n configuration S then F\n");
    assert_eq!(two.phases().map(|p| p.intervals).collect::<Vec<_>>(), [1, 1]);
    assert_eq!((two.then[0].name.as_str(), two.then[0].language.as_str()), ("", ""));
    assert_eq!(
        write(&two),
        "language lsf\n\nsign A\n  configuration  L\n  movement       up\nthen\n  configuration  S then F\n"
    );
    // Comments stay where they are.
    let text = "sign A\n  configuration  L\n  # before\nthen  # a phase\n  # after\n  configuration  S\n";
    assert_eq!(chereme::notation::print(&chereme::notation::parse(text).0), text);
}

#[test]
fn orientations() {
    same("orientation fingers up-left, palm in");
    same("orientation fingers between up and up-left, palm in, along path");
    check("orientation palm down", "orientation palm down");
    same("orientation fingers up, palm left then palm right");
}

#[test]
fn movements() {
    same("movement up 10cm");
    check("movement straight up 10cm", "movement up 10cm");
    same("movement arc up-right 15cm");
    same("movement arc left 15cm bulging out large bend zigzag small");
    check("movement arc left bulging up", "movement arc left");
    same("movement circle axis out radius 5cm from 1:30 turns 2 flattened 0.5 along left growing");
    same("movement circle axis out small");
    same("movement hold then change");
    same("movement to forehead, touch, fast");
    same("movement up 2cm to forehead right, touch, with index tip, brushing chest, tense, duration 0.4s, alternating");
    check("movement up to chest fast repeated 3", "movement up to chest, fast, repeated 3");
    same("movement nod large, repeated 3 shrinking 2");
    check("movement stir clockwise", "movement stir-clockwise");
    same("movement wiggle while up 10cm");
    same("movement wiggle index middle then wiggle fingers");
    same("movement ( up then down ) while left 10cm");
    same("movement fused ( up then left ) then hold");
    same("movement up 10cm wavy large, to and fro 2");
    same("movement ( up while left ) while out");
    same("movement ( up then down ) continued 2");
    check("movement ( up then down ), repeated twice, alternating", "movement ( up then down ) repeated 2 alternating");
    same("movement ( up ) to and fro 2 then fused ( up then left )");
    check("movement up to and fro 1", "movement up, to and fro once");
    same("movement right 5cm, repeated 3 growing moving down small");
    same("movement arc left bulging between up and out");
    same("movement circle axis between up and out radius 5cm from 3 growing wavy small across up shrinking 2");
    same("movement left 20cm zigzag small across up growing");
    check("movement up fast bouncing speed 1.2", "movement up, fast, bouncing, speed 1.2");
    same("movement change, toward-pinky, becoming ( configuration 5, spread and orientation palm up )");
    same("movement up 10cm, becoming ( orientation fingers up, palm out ), named \"A\" then to referent \"A\"");
    check("movement ( up )", "movement up");
}

#[test]
fn hands_and_contact() {
    same("hands both parallel up-down out-in alternating crossed; movement up");
    same("hands weak; configuration flat; movement up");
    same("hands both; configuration flat; movement down; contact strong index tip touches weak palm at end");
    same(
        "hands both; strong configuration 1; weak configuration flat; movement down; contact strong index tip 3cm from weak palm",
    );
    same("hands both mirrored; configuration 1; weak configuration flat; movement up; weak movement hold");
    same("hands both; contact strong radial index side crosses weak dorsal lower-arm");
    same("hands both; contact strong hand touches weak index tip to index midjoint");
}

#[test]
fn nonmanuals_and_the_rest() {
    same("movement up; head nod slight then shake; torso forward; gaze towards up-left; brows raised strong");
    check("movement up; head nod 50% then shake 100%", "movement up; head nod slight then shake");
    same("movement up; head ( nod 60% while tilted-left ) speed 1.5; gaze at chest, 60% speed 2");
    same("movement up; cheeks ( puffed then ( neutral while sucked-in ) ) strong");
    check("movement up; head ( nod )", "movement up; head nod");
    same("movement up; gaze at other palm, slight; mouth mouthing \"bOl\"");
    same("source \"D. Bouchauveau, \\\"Lexique\\\"\"; status unverified; note \"a note\"; duration 0.9s");
}

#[test]
fn a_broken_sign_is_skipped_and_the_rest_loads() {
    let text = "sign A\n movement ark up\nsign B\n movement up\nsign\n movement up\nsign C\n hands one\n";
    let reading = read(text, &Vocabulary::open(), "");
    let names: Vec<&str> = reading.signs.iter().map(|s| s.sign.name.as_str()).collect();
    assert_eq!(names, ["B", "C"]);
    assert_eq!(reading.diagnostics.iter().filter(|d| d.severity == Severity::Fault).count(), 2);
}
