//! Changes of handshapes: each does what it says; limits hold for any; the thumb stays out of the fingers.

use crate::body_hand::skeleton;
use chereme::avatar;
use chereme::body::hand::HandRig;
use chereme::body::hand_skin::{HandBone, HandSkin, PosedHand};
use chereme::motion::pose::LocalPose;
use chereme::phonology::handshape::{HandAngles, HandLimits, HandshapeInventory, ThumbPart, ThumbTarget};
use chereme::phonology::{
    Bend, Between, Configuration, Digit, Digits, HandPart, HandshapeChange, Opening, Side, ThumbPosition,
};
use glam::DVec3;
use proptest::prelude::*;
use std::sync::LazyLock;

static INVENTORY: LazyLock<HandshapeInventory> = LazyLock::new(HandshapeInventory::builtin);

fn angles(configuration: &Configuration) -> HandAngles {
    INVENTORY.angles(configuration, None).expect("known handshapes")
}

fn changed(base: &str, changes: &[HandshapeChange]) -> HandAngles {
    angles(&Configuration { changes: changes.to_vec(), ..Configuration::named(base) })
}

fn row(id: &str) -> HandAngles {
    INVENTORY.find(id, None).expect("a known handshape").angles()
}

/// Halfway between two handshapes, each with changes.
fn halfway(first: (&str, &[HandshapeChange]), second: (&str, &[HandshapeChange])) -> Configuration {
    let between = Between { first: first.1.to_vec(), second: second.0.to_owned(), changes: second.1.to_vec() };
    Configuration { between: Some(Box::new(between)), ..Configuration::named(first.0) }
}

/// The tips of the left hand, thumb first: +X along the fingers, −Y out of the palm, +Z to the thumb's side; metres.
fn tips(hand: &HandAngles) -> [DVec3; 5] {
    let skeleton = skeleton();
    let rig = HandRig::new(&skeleton, Side::Left).expect("the avatar has hands");
    let mut pose = LocalPose::rest(&skeleton);
    rig.apply(hand, &mut pose);
    let model = pose.to_model(&skeleton);
    Digit::ALL.map(|d| {
        let last = rig.of_digit(d)[2];
        model.point(last, skeleton[last].tail_model - skeleton[last].rest_model)
    })
}

const INDEX: Digits = Digits::NONE;

fn only(digit: Digit) -> Digits {
    Digits::of([digit])
}

#[test]
fn a_list_of_fingers_takes_the_part_of_the_shapes_own_fingers() {
    assert_eq!(changed("1", &[HandshapeChange::On(only(Digit::Pinky))]), row("I"));
    assert_eq!(changed("L", &[HandshapeChange::On(only(Digit::Pinky))]), row("Y"));
    let three = Digits::of([Digit::Index, Digit::Middle, Digit::Ring]);
    assert_eq!(changed("V", &[HandshapeChange::On(three)]), row("W"));
    assert_eq!(changed("F", &[HandshapeChange::On(only(Digit::Middle))]), row("8"));
    let hooked = changed("1", &[HandshapeChange::Bend(INDEX, Bend::Hooked), HandshapeChange::On(only(Digit::Pinky))]);
    assert_eq!(hooked, row("bent-I"));
    // Two that no row has: middle and ring finger stretched.
    let two = Digits::of([Digit::Middle, Digit::Ring]);
    let hand = changed("U", &[HandshapeChange::On(two)]);
    let bent = hand.fingers.map(|f| f.pip > 1.0);
    assert_eq!(bent, [true, false, false, true]);
}

#[test]
fn a_pinch_meets_the_listed_fingers() {
    for digit in Digit::FINGERS {
        let at = tips(&changed("O-index", &[HandshapeChange::On(only(digit))]));
        let gap = at[0].distance(at[digit as usize]);
        assert!(gap < 0.024, "{}: the thumb is {gap} m away", digit.name());
    }
    let both = tips(&changed("O-index", &[HandshapeChange::On(Digits::of([Digit::Index, Digit::Middle]))]));
    assert!(both[0].distance(both[1]) < 0.03 && both[0].distance(both[2]) < 0.03, "{both:?}");
}

#[test]
fn exempted_digits_stay_as_they_were() {
    let bent =
        changed("flat", &[HandshapeChange::Except(only(Digit::Pinky)), HandshapeChange::Bend(INDEX, Bend::Bent)]);
    assert!(bent.fingers[3].mcp < 0.1 && bent.fingers[0].mcp > 1.2, "{bent:?}");
    let late =
        changed("flat", &[HandshapeChange::Bend(INDEX, Bend::Bent), HandshapeChange::Except(only(Digit::Pinky))]);
    assert_eq!(late, row("bent-B"), "it applies to bends that follow");
}

#[test]
fn openings_are_tighter_and_wider() {
    for base in ["C-index", "C", "open-F"] {
        let gap = |changes: &[HandshapeChange]| {
            let at = tips(&changed(base, changes));
            at[0].distance(at[1])
        };
        let [tight, slack] = [Opening::Tight, Opening::Slack].map(|o| gap(&[HandshapeChange::Opening(o)]));
        let plain = gap(&[]);
        assert!(tight < plain - 0.005 && plain + 0.01 < slack, "{base}: {tight} {plain} {slack}");
    }
}

#[test]
fn the_thumb_meets_what_is_named() {
    let nail = changed("F", &[HandshapeChange::Meet(Digit::Thumb, HandPart::Nail, Digit::Index)]);
    assert_eq!(nail, row("F-lsf"));
    let middle = [
        HandshapeChange::Bend(only(Digit::Middle), Bend::Bent),
        HandshapeChange::Meet(Digit::Thumb, HandPart::Midjoint, Digit::Middle),
    ];
    assert_eq!(changed("V-along", &middle), row("K"));
    let turned = [middle[0], HandshapeChange::Meet(Digit::Middle, HandPart::Midjoint, Digit::Thumb)];
    assert_eq!(changed("V-along", &turned), row("K"), "in either order");
    let crossed = changed("U", &[HandshapeChange::Meet(Digit::Index, HandPart::Nail, Digit::Middle)]);
    assert_eq!(crossed, row("R"));
    let at = changed("O-index", &[HandshapeChange::ThumbAt(HandPart::Pad)]);
    let tips = tips(&at);
    assert!(tips[0].distance(tips[1]) < 0.024);
}

#[test]
fn quarters_are_shares_of_the_range() {
    let hand = changed("flat", &[HandshapeChange::Joints(only(Digit::Index), [4, 1, 0])]);
    let index = hand.fingers[0];
    assert!((index.mcp - 90f64.to_radians()).abs() < 1e-9 && (index.pip - 26.25f64.to_radians()).abs() < 1e-9);
    assert!(index.dip.abs() < 1e-9 && hand.fingers[1].mcp < 0.1);
    let four = changed("1", &[HandshapeChange::Joints(Digits::NONE, [2, 2, 2])]);
    assert!(four.fingers[0].mcp > 0.7 && four.fingers[1] == changed("1", &[]).fingers[1]);
}

#[test]
fn thumbs_stand_where_they_are_said_to() {
    for base in ["flat", "5-along", "1-along", "U-along", "V-along", "fist-a"] {
        let tip = |position| tips(&changed(base, &[HandshapeChange::Thumb(position)]))[0];
        let [along, out] = [ThumbPosition::Along, ThumbPosition::Out].map(tip);
        let [across, opposed] = [ThumbPosition::Across, ThumbPosition::Opposed].map(tip);
        assert!(out.z > along.z + 0.03, "{base}: out is to the side");
        assert!(across.z < along.z - 0.03, "{base}: across is before the palm");
        assert!(opposed.y < along.y - 0.04 && opposed.y < across.y - 0.02, "{base}: opposed stands out of the palm");
    }
}

#[test]
fn an_enclosed_thumb_is_under_the_fingers() {
    let fist = changed("fist-a", &[HandshapeChange::Thumb(ThumbPosition::Enclosed)]);
    assert_eq!(fist, row("fist-thumb-in"));
    let flat = changed("flat", &[HandshapeChange::Thumb(ThumbPosition::Enclosed)]);
    assert!(tips(&flat)[0].z < tips(&row("flat"))[0].z - 0.03);
}

#[test]
fn halfway_mixes_whole_hands() {
    let out = [HandshapeChange::Thumb(ThumbPosition::Out)];
    let half = angles(&halfway(("flat", &[]), ("flat", &out)));
    let mean = row("flat").lerp(&row("flat-thumb-out"), 0.5);
    assert!(half.max_difference(&mean) < 1e-9);
    let bent = [HandshapeChange::Bend(Digits::NONE, Bend::Bent)];
    let hand = angles(&halfway(("flat", &bent), ("flat", &[])));
    assert!((hand.fingers[1].mcp - 44f64.to_radians()).abs() < 0.12, "{hand:?}");
    let mut pinky = halfway(("1", &[]), ("1", &bent));
    pinky.changes = vec![HandshapeChange::On(only(Digit::Pinky))];
    let pinky = angles(&pinky);
    assert!(pinky.fingers[3].pip < 0.3 && pinky.fingers[3].mcp > 0.5 && pinky.fingers[0].pip > 1.2);
}

#[test]
fn rows_are_written_as_hamnosys_writes() {
    let mut seen = Vec::new();
    for shape in INVENTORY.shapes().iter().filter(|s| !s.hamnosys.is_empty()) {
        let tokens = shape.hamnosys.iter().map(String::as_str);
        assert_eq!(INVENTORY.of_hamnosys(tokens).map(|s| &s.id), Some(&shape.id));
        assert!(!seen.contains(&&shape.hamnosys), "{} is written as another row", shape.id);
        seen.push(&shape.hamnosys);
        assert!(shape.hamnosys.iter().all(|t| t.starts_with("ham")), "{}: {:?}", shape.id, shape.hamnosys);
    }
    for class in ["fist", "flathand", "finger2", "finger23", "finger23spread", "finger2345"].into_iter().chain([
        "pinch12",
        "pinchall",
        "pinch12open",
        "cee12",
        "ceeall",
        "ceeopen",
    ]) {
        let token = format!("ham{class}");
        assert!(INVENTORY.of_hamnosys([token.as_str()]).is_some(), "{class}");
    }
}

fn any_digits() -> impl Strategy<Value = Digits> {
    proptest::array::uniform5(any::<bool>())
        .prop_map(|said| Digits::of(Digit::ALL.into_iter().zip(said).filter(|(_, s)| *s).map(|(d, _)| d)))
}

fn any_change() -> impl Strategy<Value = HandshapeChange> {
    let digit = || proptest::sample::select(Digit::ALL.to_vec());
    let part = || proptest::sample::select(HandPart::OF_A_DIGIT.to_vec());
    prop_oneof![
        proptest::sample::select(ThumbPosition::ALL.to_vec()).prop_map(HandshapeChange::Thumb),
        (any_digits(), proptest::sample::select(Bend::ALL.to_vec())).prop_map(|(d, b)| HandshapeChange::Bend(d, b)),
        any::<bool>().prop_map(HandshapeChange::Spread),
        (digit(), digit()).prop_map(|(a, b)| HandshapeChange::Cross(a, b)),
        (digit(), digit()).prop_map(|(a, b)| HandshapeChange::ThumbBetween(a, b)),
        any_digits().prop_map(HandshapeChange::On),
        any_digits().prop_map(HandshapeChange::Except),
        proptest::sample::select(Opening::ALL.to_vec()).prop_map(HandshapeChange::Opening),
        (digit(), part(), digit()).prop_map(|(a, p, b)| HandshapeChange::Meet(a, p, b)),
        part().prop_map(HandshapeChange::ThumbAt),
        (any_digits(), proptest::array::uniform3(0u8..6)).prop_map(|(d, q)| HandshapeChange::Joints(d, q)),
    ]
}

fn any_configuration() -> impl Strategy<Value = Configuration> {
    let name = || (0..INVENTORY.shapes().len()).prop_map(|i| INVENTORY.shapes()[i].id.clone());
    let changes = || proptest::collection::vec(any_change(), 0..4);
    let between =
        (changes(), name(), changes()).prop_map(|(first, second, changes)| Between { first, second, changes });
    (name(), proptest::option::of(between), changes()).prop_map(|(base, between, changes)| Configuration {
        base,
        between: between.map(Box::new),
        changes,
    })
}

proptest! {
    #[test]
    fn any_configuration_is_within_a_hands_limits(configuration in any_configuration()) {
        prop_assert!(HandLimits::ANATOMICAL.hold(&angles(&configuration)));
    }
}

/// How deep the thumb lies in the fingers or a finger in the thumb, millimetres.
fn thumb_depth(hand: &HandSkin, posed: &PosedHand) -> f64 {
    let of = |test: &dyn Fn(HandBone) -> bool| {
        (0..hand.bones().len()).filter(|v| test(hand.bones()[*v])).collect::<Vec<_>>()
    };
    let thumb = of(&|b| matches!(b, HandBone::Phalanx(Digit::Thumb, 1..)));
    let fingers = of(&|b| matches!(b, HandBone::Phalanx(d, 0..) if d != Digit::Thumb));
    let outer = of(&|b| matches!(b, HandBone::Phalanx(d, 1..) if d != Digit::Thumb));
    posed.deepest_mm(&thumb, &fingers).max(posed.deepest_mm(&outer, &thumb))
}

#[test]
fn the_thumb_stays_out_of_the_fingers() {
    let skeleton = skeleton();
    let hand = HandSkin::new(&skeleton, &avatar::skin(&skeleton).expect("a skin"), Side::Left).expect("a hand");
    let across = [HandshapeChange::Thumb(ThumbPosition::Across)];
    let mut used = vec![halfway(("fist-a", &[]), ("fist-a", &across))];
    for base in ["fist-a", "flat", "1-along", "U-along", "V-along", "5-along"] {
        for position in [ThumbPosition::Along, ThumbPosition::Out, ThumbPosition::Across, ThumbPosition::Opposed] {
            let thumb = HandshapeChange::Thumb(position);
            used.push(Configuration { changes: vec![thumb], ..Configuration::named(base) });
            for bend in [Bend::Bent, Bend::Round, Bend::Hooked].into_iter().filter(|_| base != "fist-a") {
                let changes = vec![thumb, HandshapeChange::Bend(Digits::NONE, bend)];
                used.push(Configuration { changes, ..Configuration::named(base) });
            }
        }
    }
    for configuration in &used {
        let depth = thumb_depth(&hand, &hand.pose(&angles(configuration)));
        assert!(depth < THUMB_DEPTH_MM, "{depth} mm: {configuration:?}");
    }
}

/// Skin gives: pads and the ball of the thumb press in by some millimetres.
const THUMB_DEPTH_MM: f64 = 7.0;

#[test]
fn names_of_parts_are_still_what_the_solver_touches() {
    // The rows that `Meet` relies on.
    let goal = |id: &str| INVENTORY.find(id, None).expect("a known handshape").thumb;
    use chereme::phonology::handshape::ThumbGoal::Touch;
    assert!(matches!(goal("F-lsf"), Touch(ThumbPart::Pad, _, ThumbTarget::Nail)));
    assert!(matches!(goal("K"), Touch(ThumbPart::Pad, _, ThumbTarget::ProximalRadial)));
}
