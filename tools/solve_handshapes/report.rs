//! The solver's results: back into the table, as lines to read, as rotations to draw.

use chereme::body::hand::HandRig;
use chereme::body::hand_skin::{HandBone, HandSkin};
use chereme::diagnostics::Error;
use chereme::motion::pose::LocalPose;
use chereme::motion::skeleton::Skeleton;
use chereme::phonology::handshape::{HandAngles, HandLimits, Handshape, ThumbGoal};
use chereme::phonology::{Digit, Side};
use std::fmt::Write;

/// The angles as the table keeps them: tenths of a degree, still within limits (the limit of abduction is no round
/// number).
pub fn rounded(hand: &HandAngles) -> HandAngles {
    let tenths = |round: fn(f64) -> f64, angle: f64| (round(angle.to_degrees() * 10.0) / 10.0).to_radians();
    let mut kept = HandAngles::from_array(hand.to_array().map(|a| tenths(f64::round, a)));
    for (finger, limits) in kept.fingers.iter_mut().zip(HandLimits::ANATOMICAL.fingers) {
        let inside = limits.abduction_at(finger.mcp).clamp(finger.abduction);
        if inside != finger.abduction {
            finger.abduction = tenths(f64::trunc, inside);
        }
    }
    kept
}

/// The table's text with every row's `solved` line set anew; all else stays as it was written.
pub fn with_solutions(text: &str, shapes: &[Handshape]) -> String {
    let mut out = String::with_capacity(text.len() * 2);
    let mut current: Option<&Handshape> = None;
    for line in text.lines() {
        let word = line.trim_start();
        if word.starts_with("solved:") {
            continue;
        }
        if let Some(rest) = word.strip_prefix("id: \"") {
            let id = rest.split('"').next().unwrap_or_default();
            current = shapes.iter().find(|s| s.id == id);
        }
        if word == "),"
            && let Some(shape) = current.take()
        {
            out.push_str(&solved_line(shape));
        }
        out.push_str(line);
        out.push('\n');
    }
    out
}

fn solved_line(shape: &Handshape) -> String {
    let Some(solved) = &shape.solved else { return String::new() };
    let degrees = |angles: &[f64]| {
        let numbers = angles.iter().map(|a| format!("{:.1}", a.to_degrees() + 0.0).replace("-0.0", "0.0"));
        format!("({})", numbers.collect::<Vec<_>>().join(", "))
    };
    let all = solved.angles.to_array();
    let fingers: Vec<String> = all[..16].chunks(4).map(degrees).collect();
    let (fingers, thumb) = (fingers.join(", "), degrees(&all[16..]));
    let mm = solved.residual_mm;
    format!("            solved: Some((fingers: ({fingers}), thumb: {thumb}, residual_mm: {mm:.1})),\n")
}

/// How deep the digits of a hand lie in the palm and in one another.
pub struct Depth {
    /// The deepest fingertip in the palm, millimetres.
    pub palm_mm: f64,
    /// Whose it is.
    pub in_palm: &'static str,
    /// The deepest digit in another, millimetres.
    pub digits_mm: f64,
    /// Which in which.
    pub digits: String,
}

/// Measures a hand's depths.
pub fn depth(hand: &HandSkin, angles: &HandAngles) -> Depth {
    let posed = hand.pose(angles);
    let of = |test: &dyn Fn(HandBone) -> bool| {
        (0..hand.bones().len()).filter(|v| test(hand.bones()[*v])).collect::<Vec<_>>()
    };
    let palm = of(&|b| b == HandBone::Palm);
    let mut depth = Depth { palm_mm: 0.0, in_palm: "", digits_mm: 0.0, digits: String::new() };
    for a in Digit::ALL {
        let in_palm = posed.deepest_mm(&of(&|b| b == HandBone::Phalanx(a, 2)), &palm);
        if in_palm > depth.palm_mm {
            (depth.palm_mm, depth.in_palm) = (in_palm, a.name());
        }
        let own = of(&|b| matches!(b, HandBone::Phalanx(d, k) if d == a && k >= 1));
        for b in Digit::ALL.into_iter().filter(|b| *b != a) {
            let other =
                of(&|bone| matches!(bone, HandBone::Phalanx(d, k) if d == b && k >= usize::from(b == Digit::Thumb)));
            let mm = posed.deepest_mm(&own, &other);
            if mm > depth.digits_mm {
                (depth.digits_mm, depth.digits) = (mm, format!("{}>{}", a.name(), b.name()));
            }
        }
    }
    depth
}

/// One line on a solved shape: residual, greatest depth of fingertips in the palm and of digits in one another.
pub fn line(hand: &HandSkin, shape: &Handshape) -> String {
    let angles = shape.angles();
    let depth = depth(hand, &angles);
    let table = shape.table.to_array();
    let moved = angles.to_array()[..16].iter().zip(table).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    let kind = match shape.thumb {
        ThumbGoal::Posture(_) => "free",
        ThumbGoal::Touch(..) | ThumbGoal::Between(..) => "touch",
        ThumbGoal::Gap(..) => "gap",
    };
    let t = angles.thumb;
    let thumb = [t.radial, t.palmar, t.pronation, t.mcp, t.ip].map(|a| a.to_degrees().round());
    format!(
        "{:18} {kind:5} {:5.1} mm  in palm {:4.1} {:6} in one another {:4.1} {:13} from table {:4.1}°  thumb {thumb:?}",
        shape.id,
        hand.pose(&angles).residual_mm(&shape.thumb),
        depth.palm_mm,
        depth.in_palm,
        depth.digits_mm,
        depth.digits,
        moved.to_degrees()
    )
}

/// The right hand's finger joints of every shape, as quaternions x, y, z, w, in JSON.
pub fn rotations(skeleton: &Skeleton, hands: &[(String, HandAngles)]) -> Result<String, Error> {
    let rig = HandRig::new(skeleton, Side::Right)?;
    let mut out = String::from("[");
    for (i, (name, angles)) in hands.iter().enumerate() {
        let mut pose = LocalPose::rest(skeleton);
        rig.apply(angles, &mut pose);
        let comma = if i == 0 { "" } else { "," };
        let _ = write!(out, "{comma}\n{{\"id\":\"{name}\",\"joints\":{{");
        for (k, joint) in rig.joints().into_iter().enumerate() {
            let q = pose.rotation(joint);
            let comma = if k == 0 { "" } else { "," };
            let name = &skeleton[joint].name;
            let _ = write!(out, "{comma}\"{name}\":[{:.6},{:.6},{:.6},{:.6}]", q.x, q.y, q.z, q.w);
        }
        out.push_str("}}");
    }
    out.push_str("\n]\n");
    Ok(out)
}
