//! Landmarks: on the skin of the avatar, normals outward, mirror images, within reach.

use chereme::body::landmarks::{Landmark, Landmarks};
use chereme::diagnostics::Source;
use chereme::format::glb::read::{self, GlbModel};
use chereme::motion::pose::{LocalPose, ModelPose};
use chereme::motion::skeleton::Skeleton;
use chereme::phonology::location::{LocationInventory, LocationKind};
use chereme::phonology::{Digit, Digits, Distance, Flank, HandPart, HandPoint, Lateral, Side, Space};
use glam::{DQuat, DVec3};

const SIDES: [Side; 2] = [Side::Left, Side::Right];

struct Avatar {
    skeleton: Skeleton,
    landmarks: Landmarks,
    rest: ModelPose,
}

fn avatar() -> Avatar {
    let skeleton = Skeleton::from_json(include_str!("../../assets/avatar.skeleton.json")).unwrap();
    let landmarks = Landmarks::builtin(&skeleton).unwrap();
    let rest = LocalPose::rest(&skeleton).to_model(&skeleton);
    Avatar { skeleton, landmarks, rest }
}

fn laterals() -> impl Iterator<Item = Option<Lateral>> {
    let some = SIDES.into_iter().flat_map(|side| [false, true].map(|beside| Some(Lateral { side, beside })));
    std::iter::once(None).chain(some)
}

/// Every place of the body with each of its sides, by name.
fn body_landmarks(avatar: &Avatar) -> Vec<(String, Landmark)> {
    let inventory = LocationInventory::builtin();
    let places = inventory.rows().iter().filter(|r| r.kind == LocationKind::Body);
    let all = places.flat_map(|row| laterals().map(move |lateral| (row, lateral)));
    all.filter(|(row, lateral)| !(row.paired && lateral.is_none()))
        .map(|(row, lateral)| {
            (format!("{} {lateral:?}", row.id), avatar.landmarks.body_place(&row.id, lateral).unwrap())
        })
        .collect()
}

/// Every part of a hand and arm, of every digit, with every face and with none.
fn hand_points() -> Vec<HandPoint> {
    let flanks = || std::iter::once(None).chain(Flank::ALL.map(Some));
    let limb =
        HandPart::OF_THE_LIMB.into_iter().flat_map(|p| flanks().map(move |f| HandPoint::new(Digits::NONE, p, f)));
    let digits = Digit::ALL.into_iter().flat_map(|d| HandPart::OF_A_DIGIT.map(|p| (d, p)));
    let parts = digits.flat_map(|(d, p)| flanks().map(move |f| HandPoint::new(Digits::of([d]), p, f)));
    limb.chain(parts).map(Option::unwrap).collect()
}

/// The triangles of the avatar at rest.
fn triangles() -> Vec<[DVec3; 3]> {
    let model: GlbModel = read::read(include_bytes!("../../assets/avatar.glb")).unwrap();
    let corners =
        |part: &read::GlbPart| part.triangles.iter().map(|t| t.map(|i| part.positions[i as usize])).collect::<Vec<_>>();
    model.parts.iter().filter(|part| part.material != "lashes").flat_map(corners).collect()
}

/// The point of a triangle nearest to `p` (Ericson 2005, Real-Time Collision Detection, 5.1.5).
fn nearest_on(p: DVec3, [a, b, c]: [DVec3; 3]) -> DVec3 {
    let (ab, ac, ap) = (b - a, c - a, p - a);
    let (d1, d2) = (ab.dot(ap), ac.dot(ap));
    if d1 <= 0.0 && d2 <= 0.0 {
        return a;
    }
    let bp = p - b;
    let (d3, d4) = (ab.dot(bp), ac.dot(bp));
    if d3 >= 0.0 && d4 <= d3 {
        return b;
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        return a + ab * (d1 / (d1 - d3));
    }
    let cp = p - c;
    let (d5, d6) = (ab.dot(cp), ac.dot(cp));
    if d6 >= 0.0 && d5 <= d6 {
        return c;
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        return a + ac * (d2 / (d2 - d6));
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 - d3 >= 0.0 && d5 - d6 >= 0.0 {
        return b + (c - b) * ((d4 - d3) / ((d4 - d3) + (d5 - d6)));
    }
    let sum = va + vb + vc;
    a + ab * (vb / sum) + ac * (vc / sum)
}

/// Distance to the nearest triangle and the outward direction of that triangle's face.
fn skin_near(p: DVec3, skin: &[[DVec3; 3]]) -> (f64, DVec3) {
    let distance = |t: &[DVec3; 3]| nearest_on(p, *t).distance(p);
    let best = skin.iter().min_by(|a, b| distance(a).total_cmp(&distance(b))).unwrap();
    (distance(best), (best[1] - best[0]).cross(best[2] - best[0]).normalize())
}

#[test]
fn every_landmark_lies_on_the_skin_and_looks_outward() {
    let avatar = avatar();
    let skin = triangles();
    let mut all = body_landmarks(&avatar);
    for point in hand_points() {
        for side in SIDES {
            let contact = avatar.landmarks.hand_point(side, point).unwrap();
            assert_eq!(contact.parts().len(), 1);
            all.push((format!("{side:?} {point}"), contact.parts()[0]));
        }
    }
    assert_eq!(all.len(), 17 * 5 + 4 * 4 + 2 * (11 + 30) * 5);
    for (name, landmark) in all {
        let (distance, face) = skin_near(landmark.position(&avatar.rest), &skin);
        assert!(distance < 0.003, "{name} is {distance} m off the skin");
        let normal = landmark.normal(&avatar.rest);
        assert!((normal.length() - 1.0).abs() < 1e-12, "{name}");
        assert!(normal.dot(face) > 0.0, "{name} looks into the body: {normal} on a face towards {face}");
    }
}

#[test]
fn the_right_is_the_mirror_image_of_the_left() {
    let avatar = avatar();
    let flip = DVec3::new(-1.0, 1.0, 1.0);
    let check = |name: &str, left: Landmark, right: Landmark| {
        assert_eq!(left.position(&avatar.rest) * flip, right.position(&avatar.rest), "{name}");
        assert_eq!(left.normal(&avatar.rest) * flip, right.normal(&avatar.rest), "{name}");
    };
    for row in LocationInventory::builtin()
        .rows()
        .iter()
        .filter(|r| matches!(r.kind, LocationKind::Body | LocationKind::Space))
    {
        for beside in [false, true] {
            let [left, right] =
                SIDES.map(|side| avatar.landmarks.body_place(&row.id, Some(Lateral { side, beside })).unwrap());
            check(&row.id, left, right);
            assert!(left.position(&avatar.rest).x > 0.0, "{} left is not on the left", row.id);
        }
        if !row.paired {
            assert_eq!(avatar.landmarks.body_place(&row.id, None).unwrap().position(&avatar.rest).x, 0.0, "{}", row.id);
        }
    }
    for point in hand_points() {
        let [left, right] = SIDES.map(|side| avatar.landmarks.hand_point(side, point).unwrap().parts()[0]);
        check(&point.to_string(), left, right);
    }
}

#[test]
fn sides_are_half_and_one_and_a_half_half_widths_away_where_the_front_reaches() {
    let avatar = avatar();
    let arm = avatar.landmarks.arm_length();
    for row in LocationInventory::builtin().rows().iter().filter(|r| !r.paired) {
        if !matches!(row.kind, LocationKind::Body | LocationKind::Space) {
            continue;
        }
        let x = |beside| {
            let lateral = Some(Lateral { side: Side::Left, beside });
            avatar.landmarks.body_place(&row.id, lateral).unwrap().position(&avatar.rest).x
        };
        assert!((x(false) - row.at_arms() * arm).abs() < 2e-5, "{} {} {}", row.id, x(false), row.at_arms() * arm);
        // Beside may pass the outline; it then lies on the flank, still further out.
        assert!(x(true) > x(false) + 0.005 && x(true) < row.beside_arms() * arm + 2e-5, "{} {}", row.id, x(true));
    }
}

/// Expectation 44 (facts/phonology.md §9).
#[test]
fn all_places_are_within_reach() {
    let avatar = avatar();
    let arm = avatar.landmarks.arm_length();
    let to = |side: Side, p: DVec3| avatar.rest.position(avatar.landmarks.shoulder(side)).distance(p);
    for (name, landmark) in body_landmarks(&avatar) {
        let p = landmark.position(&avatar.rest);
        let nearer = to(Side::Left, p).min(to(Side::Right, p));
        let reach = if name.starts_with("belowstomach") { arm + avatar.landmarks.hand_length() } else { arm };
        assert!(nearer <= reach, "{name}: {nearer} m from the shoulder, reach {reach}");
    }
    let far_ear = avatar.landmarks.body_place("ear", Some(Lateral { side: Side::Left, beside: false })).unwrap();
    assert!(to(Side::Right, far_ear.position(&avatar.rest)) <= arm + avatar.landmarks.hand_length());
}

#[test]
fn places_stand_in_their_order_from_the_head_down() {
    let avatar = avatar();
    let height = |id: &str| {
        let place = avatar.landmarks.body_place(id, None);
        let place =
            place.or_else(|_| avatar.landmarks.body_place(id, Some(Lateral { side: Side::Left, beside: false })));
        place.unwrap().position(&avatar.rest).y
    };
    let order = [
        "headtop",
        "forehead",
        "eyebrows",
        "eyes",
        "nose",
        "nostrils",
        "lips",
        "chin",
        "underchin",
        "neck",
        "shouldertop",
        "shoulders",
        "chest",
        "stomach",
        "belowstomach",
    ];
    for pair in order.windows(2) {
        assert!(height(pair[0]) > height(pair[1]) + 0.002, "{pair:?} {} {}", height(pair[0]), height(pair[1]));
    }
    assert!(height("ear") > height("earlobe"));
}

#[test]
fn faces_of_the_hand_look_their_way() {
    let avatar = avatar();
    let normal = |text: (Option<Digit>, HandPart)| {
        let point = HandPoint::new(Digits::of(text.0), text.1, None).unwrap();
        avatar.landmarks.hand_point(Side::Left, point).unwrap().normal(&avatar.rest)
    };
    // Rest: palms down, fingers to the side, thumbs to the front.
    assert!(normal((None, HandPart::Palm)).y < -0.9);
    assert!(normal((None, HandPart::Back)).y > 0.9);
    assert!(normal((None, HandPart::ThumbSide)).z > 0.8);
    assert!(normal((None, HandPart::PinkySide)).z < -0.8);
    assert!(normal((None, HandPart::WristPulse)).y < -0.9);
    assert!(normal((None, HandPart::Elbow)).z < -0.9);
    for finger in Digit::FINGERS {
        assert!(normal((Some(finger), HandPart::Tip)).x > 0.8, "{finger:?}");
        assert!(normal((Some(finger), HandPart::Pad)).y < -0.8, "{finger:?}");
        assert!(normal((Some(finger), HandPart::Nail)).y > 0.8, "{finger:?}");
        assert!(normal((Some(finger), HandPart::Midjoint)).y > 0.9, "{finger:?}");
    }
    // A side that is not named is the thumb's, and the little finger's outer one.
    assert!(normal((Some(Digit::Index), HandPart::Side)).z > 0.8);
    assert!(normal((Some(Digit::Pinky), HandPart::Side)).z < -0.8);
}

#[test]
fn several_digits_mean_their_middle() {
    let avatar = avatar();
    let at = |digits: &[Digit]| {
        let point = HandPoint::new(Digits::of(digits.iter().copied()), HandPart::Tip, None).unwrap();
        avatar.landmarks.hand_point(Side::Right, point).unwrap().position(&avatar.rest)
    };
    let middle = (at(&[Digit::Index]) + at(&[Digit::Middle])) / 2.0;
    assert!(at(&[Digit::Index, Digit::Middle]).distance(middle) < 1e-12);
}

#[test]
fn landmarks_ride_on_their_joints() {
    let avatar = avatar();
    let mut pose = LocalPose::rest(&avatar.skeleton);
    let joint = avatar.skeleton.joint("LeftHandIndex1").unwrap();
    pose.set(joint, DQuat::from_rotation_z(-std::f64::consts::FRAC_PI_2));
    let pose = pose.to_model(&avatar.skeleton);
    let tip = HandPoint::of_digit(Digit::Index, HandPart::Tip).unwrap();
    let tip = avatar.landmarks.hand_point(Side::Left, tip).unwrap();
    let knuckle = avatar.rest.position(joint);
    assert!((tip.position(&pose).distance(knuckle) - tip.position(&avatar.rest).distance(knuckle)).abs() < 1e-12);
    assert!(tip.normal(&pose).y < -0.8 && tip.position(&pose).y < knuckle.y - 0.08);
    let nose = avatar.landmarks.body_place("nose", None).unwrap();
    assert_eq!(nose.position(&pose), nose.position(&avatar.rest));
}

#[test]
fn distances_and_the_grid_of_space() {
    let avatar = avatar();
    let (landmarks, arm) = (&avatar.landmarks, avatar.landmarks.arm_length());
    let chest = landmarks.body_place("chest", None).unwrap();
    let from = (chest.position(&avatar.rest), chest.normal(&avatar.rest));
    let shoulder = avatar.rest.position(landmarks.shoulder(Side::Right));
    let metres = |d| landmarks.metres(d, Distance::Neutral, from, shoulder, arm);
    assert_eq!(metres(Distance::Touch), 0.0);
    assert!((metres(Distance::Close) - 0.12 * arm).abs() < 1e-12);
    assert!((metres(Distance::Unmarked) - 0.42 * arm).abs() < 1e-12);
    assert_eq!(metres(Distance::Metres(0.2)), 0.2);
    let out = from.0 + from.1 * metres(Distance::Extended);
    assert!((out.distance(shoulder) - 0.95 * arm).abs() < 1e-9);
    let cell = |left, high, far| landmarks.space(Space { left, high, far }).position(&avatar.rest);
    let neutral = landmarks.body_place("neutral", None).unwrap().position(&avatar.rest);
    assert_eq!(cell(0, 0, 0), neutral);
    assert!((cell(1, -1, 1) - neutral - DVec3::new(0.4, -0.3, 0.25) * arm).length() < 1e-12);
    let middle = (avatar.rest.position(landmarks.shoulder(Side::Left)) + shoulder) / 2.0;
    assert!((neutral - middle - DVec3::new(0.0, -0.28, 0.648) * arm).length() < 1e-12);
}

#[test]
fn faults_name_what_is_missing() {
    let avatar = avatar();
    let fault = |r: Result<Landmark, chereme::diagnostics::Error>| r.unwrap_err().to_string();
    assert_eq!(fault(avatar.landmarks.body_place("knee", None)), "there is no landmark for the place knee");
    assert_eq!(fault(avatar.landmarks.body_place("ear", None)), "ear comes in two: say left or right");
    let text = Landmarks::builtin_source().text;
    let load = |text: String| {
        Landmarks::from_source(&Source::new("mine.ron", text), &avatar.skeleton).unwrap_err().to_string()
    };
    assert_eq!(load(text.replacen("\"Head\"", "\"Helmet\"", 1)), "landmark headtop: the rig has no joint Helmet");
    let misspelt = load(text.replacen("at: (", "att: (", 1));
    let line = text[..text.find("at: (").unwrap()].matches('\n').count() + 1;
    assert!(misspelt.starts_with(&format!("mine.ron:{line}:")), "{misspelt}");
}
