//! Configurations as gestural SiGML writes them (`handshape=flat thumbpos=out mainbend=round`), measured and drawn.
//!
//! For each line: where the fingertips are, in the frame and unit of the comparison of motions, and how deep the digits lie in
//! one another and in the palm.

use super::report;
use chereme::body::hand::HandRig;
use chereme::body::hand_skin::HandSkin;
use chereme::diagnostics::Error;
use chereme::motion::pose::LocalPose;
use chereme::motion::skeleton::Skeleton;
use chereme::phonology::handshape::{HandAngles, HandshapeInventory};
use chereme::phonology::{
    Bend, Between, Configuration, Digit, Digits, HandPart, HandshapeChange, Opening, Side, ThumbPosition,
};

/// Each line's angles, with the line; lines that say nothing known are left out with a note.
pub fn hands(inventory: &HandshapeInventory, text: &str) -> Vec<(String, HandAngles)> {
    let mut hands = Vec::new();
    for line in text.lines().filter(|l| !l.trim().is_empty()) {
        match configuration(inventory, line).map(|c| inventory.angles(&c, None)) {
            Some(Ok(angles)) => hands.push((line.to_owned(), angles)),
            Some(Err(fault)) => eprintln!("{line}: {fault}"),
            None => eprintln!("{line}: not understood"),
        }
    }
    hands
}

/// Prints a line of JSON for each hand.
pub fn measure(skeleton: &Skeleton, hand: &HandSkin, hands: &[(String, HandAngles)]) -> Result<(), Error> {
    let rig = HandRig::new(skeleton, Side::Right)?;
    for (key, angles) in hands {
        let tips = tips(&rig, skeleton, angles).map(|t| format!("[{:.4},{:.4},{:.4}]", t[0], t[1], t[2])).join(",");
        let depth = report::depth(hand, angles);
        let degrees = angles.to_array().map(|a| format!("{:.0}", a.to_degrees())).join(",");
        println!(
            "{{\"key\":\"{key}\",\"tips\":[{tips}],\"palm\":{:.1},\"palm_what\":\"{}\",\"deep\":{:.1},\"what\":\"{}\",\"angles\":[{degrees}]}}",
            depth.palm_mm, depth.in_palm, depth.digits_mm, depth.digits
        );
    }
    Ok(())
}

/// The five tips along the hand, out of the palm and to the side; the unit is 1.95 times wrist to middle knuckle.
fn tips(rig: &HandRig, skeleton: &Skeleton, angles: &HandAngles) -> [[f64; 3]; 5] {
    let mut pose = LocalPose::rest(skeleton);
    rig.apply(angles, &mut pose);
    let model = pose.to_model(skeleton);
    let knuckle = |digit: Digit| model.position(rig.of_digit(digit)[0]);
    let wrist = model.position(rig.hand());
    let along = knuckle(Digit::Middle) - wrist;
    let size = along.length() * 1.95;
    let finger = along.normalize();
    let across = (knuckle(Digit::Index) - knuckle(Digit::Pinky)).normalize();
    let palm = finger.cross(across).normalize();
    let side = palm.cross(finger).normalize();
    Digit::ALL.map(|digit| {
        let last = rig.of_digit(digit)[2];
        let tip = model.point(last, skeleton[last].tail_model - skeleton[last].rest_model) - wrist;
        [finger, palm, side].map(|axis| tip.dot(axis) / size)
    })
}

fn configuration(inventory: &HandshapeInventory, line: &str) -> Option<Configuration> {
    let value = |key: &str| line.split_whitespace().find_map(|w| w.strip_prefix(key)?.strip_prefix('='));
    let (base, class) = base(inventory, value("handshape")?)?;
    let mut first = Vec::new();
    let listed = value("specialfingers").map(digits).unwrap_or_default();
    if !listed.is_empty() {
        first.push(HandshapeChange::On(listed));
    }
    let kept = value("exempteddigits").map(digits).unwrap_or_default();
    if !kept.is_empty() {
        first.push(HandshapeChange::Except(kept));
    }
    let own = |prefix: &str, changes: &mut Vec<HandshapeChange>| {
        let at = |key: &str| value(&format!("{prefix}{key}"));
        changes.extend(at("thumbpos").and_then(thumb).map(HandshapeChange::Thumb));
        changes.extend(at("mainbend").and_then(|b| bend(Digits::NONE, b)));
        changes.extend(at("ceeopening").and_then(opening).map(HandshapeChange::Opening));
    };
    let mut whole = Vec::new();
    for n in 1..=5 {
        let digit = Digit::ALL[n - 1];
        whole.extend(value(&format!("bend{n}")).and_then(|b| bend(Digits::of([digit]), b)));
    }
    if let (Some(pair), Some(part)) = (value("contactpair"), value("contactkind").and_then(part)) {
        let mut pair = pair.chars().filter_map(digit);
        whole.push(HandshapeChange::Meet(pair.next()?, part, pair.next()?));
    }
    if value("thumbenclosed").is_some() {
        first.push(HandshapeChange::Thumb(ThumbPosition::Enclosed));
    }
    own("", &mut first);
    if value("thumbenclosed").is_some() {
        first.push(HandshapeChange::Thumb(ThumbPosition::Enclosed));
    }
    first.extend(value("thumbcontact").and_then(part).map(HandshapeChange::ThumbAt));
    let _ = class;
    let Some(second) = value("second_handshape").or(value("second_mainbend").and(value("handshape"))) else {
        first.extend(whole);
        return Some(Configuration { changes: first, ..Configuration::named(base) });
    };
    let (second, _) = self::base(inventory, second)?;
    let mut changes: Vec<_> =
        first.iter().copied().filter(|c| matches!(c, HandshapeChange::On(_) | HandshapeChange::Except(_))).collect();
    own("second_", &mut changes);
    let between = Between { first, second, changes };
    Some(Configuration { base, between: Some(Box::new(between)), changes: whole })
}

fn base(inventory: &HandshapeInventory, name: &str) -> Option<(String, String)> {
    let token = match name {
        "flat" => "hamflathand".to_owned(),
        "cee12open" => "hamceeopen".to_owned(),
        _ => format!("ham{name}"),
    };
    inventory.of_hamnosys([token.as_str()]).map(|row| (row.id.clone(), token.clone()))
}

fn digit(c: char) -> Option<Digit> {
    Digit::ALL.get(c.to_digit(10)?.checked_sub(1)? as usize).copied()
}

fn digits(text: &str) -> Digits {
    Digits::of(text.chars().filter_map(digit))
}

fn thumb(name: &str) -> Option<ThumbPosition> {
    ThumbPosition::ALL.into_iter().find(|p| p.name() == name)
}

fn opening(name: &str) -> Option<Opening> {
    Opening::ALL.into_iter().find(|o| o.name() == name)
}

fn part(name: &str) -> Option<HandPart> {
    HandPart::OF_A_DIGIT.into_iter().find(|p| p.name() == name)
}

fn bend(digits: Digits, name: &str) -> Option<HandshapeChange> {
    let bend = match name {
        "bent" => Bend::Bent,
        "round" => Bend::Round,
        "hooked" => Bend::Hooked,
        "dblbent" => Bend::DoubleBent,
        "dblhooked" => Bend::DoubleHooked,
        "halfbent" => Bend::HalfBent,
        other => {
            let quarters: Option<Vec<u8>> = other.chars().map(|c| c.to_digit(10).map(|d| d as u8)).collect();
            let quarters: [u8; 3] = quarters?.try_into().ok()?;
            return Some(HandshapeChange::Joints(digits, quarters));
        }
    };
    Some(HandshapeChange::Bend(digits, bend))
}
