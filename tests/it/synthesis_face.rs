//! Non-manuals on the avatar: morphs, head, trunk, eyes, shoulders; and hands that stay where the head goes.

use crate::signing::{body_at, perform, sign, world};
use chereme::diagnostics::Source;
use chereme::motion::rotation::angle_between;
use chereme::phonology::expression::Expressions;
use chereme::phonology::movement_table::MovementTable;
use chereme::phonology::{Channel, Digit, HandPart, HandPoint, Side};
use chereme::synthesis::Performance;
use chereme::time::Seconds;
use glam::DQuat;

fn middle(performance: &Performance) -> Seconds {
    (performance.report.stroke_start + performance.report.sign_end) * 0.5
}

fn weight(performance: &Performance, time: Seconds, morph: &str) -> f32 {
    let clip = &performance.track.clip;
    let at = clip.morphs().iter().position(|m| m == morph).expect("a morph of the avatar");
    clip.sample(time).weights[at]
}

#[test]
fn every_morph_of_the_inventory_is_on_the_avatar() {
    let expressions = Expressions::embedded();
    let mut named = 0;
    for channel in Channel::ALL {
        for row in expressions.of(channel) {
            for morph in row.morphs.keys() {
                assert!(world().signer.morphs.contains(morph), "{} {}: {morph}", channel.name(), row.name);
                named += 1;
            }
        }
    }
    assert!(named > 40);
}

#[test]
fn a_value_comes_before_the_stroke_holds_and_goes() {
    let performance = perform(&sign("sign X\n movement up 10cm\n brows raised\n cheeks puffed slight\n"));
    let end = performance.track.clip.duration();
    for (morph, held) in [("eyebrows-left-up", 1.0), ("eyebrows-right-up", 1.0), ("cheek-left-puff", 0.5)] {
        assert!((weight(&performance, middle(&performance), morph) - held).abs() < 1e-3, "{morph}");
        assert_eq!(weight(&performance, Seconds(0.0), morph), 0.0);
        assert_eq!(weight(&performance, end, morph), 0.0);
    }
}

#[test]
fn mouthing_shapes_the_mouth_sound_by_sound() {
    let performance = perform(&sign("sign X\n movement up 20cm duration 1s\n mouth mouthing \"bOl\"\n"));
    let (start, end) = (performance.report.stroke_start.0, performance.report.sign_end.0);
    let at = |share: f64, morph: &str| weight(&performance, Seconds(start + share * (end - start)), morph);
    // b closes the lips, o rounds them, l opens them a little.
    assert!(at(1.0 / 6.0, "mouth-compression") > 0.5 && at(0.5, "mouth-compression") < 0.05);
    assert!(at(0.5, "mouth-protusion") > 0.6 && at(1.0 / 6.0, "mouth-protusion") < 0.05);
    assert!(at(0.8, "tongue-up") > 0.05 && at(0.8, "mouth-open") > 0.1);
}

#[test]
fn head_trunk_eyes_and_shoulders_turn_the_way_they_are_told() {
    let text = "sign X\n movement hold\n head turned-left\n torso forward\n gaze towards up\n shoulders raised\n";
    let performance = perform(&sign(text));
    let (rest, body) = (body_at(&performance, Seconds(0.0)), body_at(&performance, middle(&performance)));
    let skeleton = &world().signer.skeleton;
    let joint = |name: &str| skeleton.joint(name).unwrap();
    let face = body.rotation(joint("Head")) * glam::DVec3::Z;
    assert!(face.x > 0.3, "the head looks to the left: {face}");
    assert!(body.position(joint("Head")).z > rest.position(joint("Head")).z + 0.02, "the trunk leans forward");
    let eye = performance.track.clip.sample(middle(&performance)).pose.rotation(joint("LeftEye")) * glam::DVec3::Z;
    assert!(eye.y > 0.5, "the eyes look up: {eye}");
    let lift = |p: &chereme::motion::pose::ModelPose| p.position(joint("LeftArm")).y - p.position(joint("Spine2")).y;
    assert!(lift(&body) > lift(&rest) + 0.01, "the shoulders are raised");
    assert_eq!(performance.track.clip.sample(Seconds(0.0)).pose.rotation(joint("Head")), DQuat::IDENTITY);
}

#[test]
fn a_nod_beats() {
    let performance = perform(&sign("sign X\n movement hold duration 1.5s\n head nod\n"));
    let head = world().signer.head();
    let (start, end) = (performance.report.stroke_start.0, performance.report.sign_end.0);
    let pitch: Vec<f64> = (0..200)
        .map(|i| performance.track.clip.sample(Seconds(start + (end - start) * f64::from(i) / 200.0)))
        .map(|f| angle_between(f.pose.rotation(head), DQuat::IDENTITY))
        .collect();
    let peaks = pitch.windows(3).filter(|w| w[1] > w[0] && w[1] >= w[2] && w[1] > 0.05).count();
    assert!((2..=4).contains(&peaks), "{peaks} nods");
}

#[test]
fn a_hand_on_the_forehead_goes_with_the_head() {
    let text = "sign X\n configuration index\n placement forehead right, touch, with index tip\n movement hold duration 1s\n head nod strong\n";
    let performance = perform(&sign(text));
    let landmarks = &world().signer.landmarks;
    let tip = HandPoint::of_digit(Digit::Index, HandPart::Tip).unwrap();
    let right = chereme::phonology::Lateral { side: Side::Right, beside: false };
    let (start, end) = (performance.report.stroke_start.0, performance.report.sign_end.0);
    let fps = performance.track.clip.fps().get();
    for i in (start * fps).ceil() as usize..(end * fps) as usize {
        let body = body_at(&performance, Seconds(i as f64 / fps));
        let own = landmarks.hand_point(Side::Right, tip).unwrap().position(&body);
        let place = landmarks.body_place("forehead", Some(right)).unwrap().position(&body);
        assert!(own.distance(place) < 5e-3, "frame {i}: {:.1} mm", own.distance(place) * 1e3);
    }
}

#[test]
fn an_unknown_value_is_refused_with_its_tier() {
    let mut sign = sign("sign X\n movement hold\n brows raised\n");
    let value = chereme::phonology::NonManualValue::Named("purple".into());
    sign.nonmanual = vec![(Channel::Brows, chereme::phonology::Keys::one(chereme::phonology::NonManual::plain(value)))];
    let world = world();
    let error = chereme::synthesis::synthesize(&sign, &world.grammar, &world.signer, &Default::default()).unwrap_err();
    assert!(error.to_string().contains("brows") && error.to_string().contains("purple"), "{error}");
}

#[test]
fn tables_of_movements_and_non_manuals_name_the_place_of_a_fault() {
    let table = include_str!("../../grammar/movements.ron");
    let broken = table.replace("straight: (small: 0.06", "straight: (smal: 0.06");
    let source = Source::new("movements.ron", broken);
    let fault = MovementTable::read(&source).unwrap_err();
    assert_eq!(
        source.line_column(fault.span.start).0,
        table[..table.find("straight:").unwrap()].matches('\n').count() + 1
    );
    for wrong in ["move_time: -1", "move_time: inf", "handshape_lead: 2.0", "least: 0.0"] {
        let name = &wrong[..wrong.find(':').unwrap()];
        let at = table.find(&format!("{name}:")).unwrap();
        let end = at + table[at..].find(',').unwrap();
        let text = format!("{}{wrong}{}", &table[..at], &table[end..]);
        assert!(MovementTable::read(&Source::new("m", text)).is_err(), "{wrong}");
    }
    for (rows, word) in [
        (r#"[(channel: "ears", name: "up")]"#, "ears"),
        (r#"[(channel: "head", name: "up"), (channel: "head", name: "UP")]"#, "twice"),
        (r#"[(channel: "nose", name: "up", morphs: {"nose-compression": 2.0})]"#, "between 0 and 1"),
        (r#"[(channel: "head", name: "up", turn: (200, 0, 0))]"#, "90"),
    ] {
        let fault = Expressions::read(&Source::new("n", rows)).unwrap_err();
        assert!(fault.message.contains(word), "{}", fault.message);
    }
    assert!(Expressions::read(&Source::new("n", "")).is_err());
}
