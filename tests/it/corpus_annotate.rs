//! Motion measured into tiers: laws of the measuring, and signs that give their descriptions back.

use crate::signing::{lexicon, perform, perform_with, sign, world};
use chereme::body::measure::HandForm;
use chereme::body::reflection::{Reflection, exchange_words};
use chereme::corpus::annotate::{Annotation, Annotator, Coverage, Limb, Options, Phase};
use chereme::evaluation::annotation::{Judged, SIX_PLACES, Tally, judge, six_places};
use chereme::motion::clip::{Clip, Frame};
use chereme::motion::pose::LocalPose;
use chereme::phonology::{Direction, Heading, Lateral, LocationKind, Side, Sign};
use chereme::synthesis;
use chereme::tier::Tier;
use chereme::time::Fps;
use glam::{DQuat, DVec3};
use proptest::prelude::*;
use std::sync::OnceLock;

fn annotator() -> &'static Annotator<'static> {
    static ANNOTATOR: OnceLock<Annotator> = OnceLock::new();
    let world = world();
    ANNOTATOR.get_or_init(|| Annotator::new(&world.signer, &world.grammar.handshapes, &world.grammar.locations))
}

fn annotate(clip: &Clip) -> Annotation {
    annotator().annotate(clip, Coverage::WHOLE, &Options::default())
}

fn named(name: &str) -> Sign {
    lexicon().find(name, Some("lsf")).unwrap().sign.clone()
}

fn clip_of(frames: Vec<Frame>, fps: f64) -> Clip {
    let signer = &world().signer;
    Clip::new(signer.skeleton.clone(), Fps::new(fps).unwrap(), signer.morphs.clone(), frames).unwrap()
}

/// One pose held for a third of a second.
fn held(pose: &LocalPose) -> Clip {
    let weights = vec![0.0; world().signer.morphs.len()];
    clip_of(vec![Frame { pose: pose.clone(), weights }; 20], 60.0)
}

/// Labels of all tiers, without sizes.
fn labels(tiers: &[Tier]) -> Vec<String> {
    let value = |tier: &Tier, label: &str| {
        let words = label.split(' ').filter(|word| !word.ends_with("cm") && *word != "small" && *word != "large");
        format!("{}: {}", tier.name, words.collect::<Vec<_>>().join(" "))
    };
    tiers.iter().flat_map(|tier| tier.values().iter().map(|v| value(tier, &v.label)).collect::<Vec<_>>()).collect()
}

#[test]
fn every_handshape_is_recognised_as_itself_or_its_twin() {
    let (world, annotator) = (world(), annotator());
    let forms = annotator.forms();
    for (n, shape) in world.grammar.handshapes.shapes().iter().enumerate() {
        for side in [Side::Left, Side::Right] {
            let mut pose = LocalPose::rest(&world.signer.skeleton);
            world.signer.hand(side).apply(&shape.angles(), &mut pose);
            let hands = Coverage { left: Limb::Hand, right: Limb::Hand };
            let found = annotator.annotate(&held(&pose), hands, &Options::default());
            let values = &found.hand(side).unwrap().configuration;
            assert_eq!(values.len(), 1, "{}", shape.id);
            assert!(forms.are_same(values[0].value.number, n), "{} is taken for {}", shape.id, values[0].value.id);
            assert!(values[0].off < 1e-6);
        }
    }
}

#[test]
fn every_orientation_is_recognised() {
    let world = world();
    for side in [Side::Left, Side::Right] {
        let arm = world.signer.arm(side);
        let across = |f: &Direction, p: &Direction| f.vector().dot(p.vector()).abs() < 1e-9;
        let all = Direction::all().flat_map(|f| Direction::all().map(move |p| (f, p))).filter(|(f, p)| across(f, p));
        for (fingers, palm) in all {
            let mut pose = LocalPose::rest(&world.signer.skeleton);
            pose.set(arm.hand, arm.hand_rotation(fingers.vector(), palm.vector()).unwrap());
            let hands = Coverage { left: Limb::Hand, right: Limb::Hand };
            let found = annotator().annotate(&held(&pose), hands, &Options::default());
            let value = &found.hand(side).unwrap().orientation[0].value;
            let (f, p) = (Some(Heading::Toward(fingers)), Some(Heading::Toward(palm)));
            assert_eq!((value.fingers, value.palm), (f, p));
        }
    }
}

#[test]
fn every_place_of_the_skin_is_recognised_where_it_is_touched() {
    let world = world();
    let landmarks = &world.signer.landmarks;
    let model = LocalPose::rest(&world.signer.skeleton).to_model(&world.signer.skeleton);
    let tip = world.grammar.handshapes.find("1", None).unwrap().touches_with;
    let mut count = 0;
    for row in world.grammar.locations.rows().iter().filter(|row| row.kind == LocationKind::Body) {
        let sides = [Side::Left, Side::Right].into_iter();
        let lateral = sides.flat_map(|side| [false, true].map(|beside| Some(Lateral { side, beside })));
        for lateral in std::iter::once(None).chain(lateral) {
            let Ok(landmark) = landmarks.body_place(&row.id, lateral) else { continue };
            let at = landmark.position(&model);
            let (placed, off) = annotator().placer().name(Side::Right, (tip, at), at + DVec3::Z, &model).unwrap();
            let there = annotator().placer().point_of(&placed, Side::Right, &model).unwrap();
            // Teeth and tongue lie behind the lips.
            assert!(off < 5e-3 && there.distance(at) < 5e-3, "{} {lateral:?} is taken for {placed:?}", row.id);
            count += 1;
        }
    }
    assert!(count > 80, "{count}");
}

#[test]
fn the_frame_rate_changes_nothing() {
    for name in ["BOL", "OUI", "CHIEN", "TRAVAIL", "DONNER", "PLUIE"] {
        let sign = named(name);
        let tiers = |fps: f64| {
            let options = synthesis::Options { fps: Fps::new(fps).unwrap(), ..Default::default() };
            annotate(&perform_with(&sign, &options).track.clip).tiers()
        };
        let (slow, usual, fast) = (tiers(30.0), tiers(60.0), tiers(120.0));
        assert_eq!(labels(&slow), labels(&usual), "{name}");
        assert_eq!(labels(&fast), labels(&usual), "{name}");
        let times = |tiers: &[Tier]| tiers.iter().flat_map(|t| t.values().to_vec()).collect::<Vec<_>>();
        for (a, b) in times(&slow).iter().zip(times(&fast)) {
            let apart = (a.start.0 - b.start.0).abs().max((a.end.0 - b.end.0).abs());
            assert!(apart < 0.1, "{name} {} {apart}", a.label);
        }
    }
}

#[test]
fn later_is_later_and_nothing_else() {
    let clip = perform(&named("BOL")).track.clip;
    let mut frames = vec![clip.frames()[0].clone(); 30];
    frames.extend(clip.frames().iter().cloned());
    let (now, later) = (annotate(&clip).tiers(), annotate(&clip_of(frames, 60.0)).tiers());
    assert_eq!(labels(&now), labels(&later));
    for (a, b) in now.iter().zip(&later) {
        for (a, b) in a.values().iter().zip(b.values()) {
            assert!((b.start.0 - a.start.0 - 0.5).abs() < 1e-9 && (b.end.0 - a.end.0 - 0.5).abs() < 1e-9);
        }
    }
}

#[test]
fn in_a_mirror_left_is_right() {
    let signer = &world().signer;
    let reflection = Reflection::new(&signer.skeleton, &signer.morphs);
    for name in ["BOL", "CHIEN", "DONNER", "MAISON", "PENSER", "ALLER", "PLUIE"] {
        let clip = perform(&named(name)).track.clip;
        let mirrored = clip_of(clip.frames().iter().map(|f| reflection.frame(f)).collect(), 60.0);
        let hand = |annotation: &Annotation, side: Side| {
            let mut one = annotation.clone();
            one.hands.retain(|hand| hand.side == side);
            one.contact.clear();
            let words = labels(&one.tiers());
            words.into_iter().map(|w| w[2..].to_owned()).collect::<Vec<_>>()
        };
        let (here, there) = (annotate(&clip), annotate(&mirrored));
        for side in [Side::Left, Side::Right] {
            let seen: Vec<String> = hand(&there, side.other()).iter().map(|w| exchange_words(w)).collect();
            assert_eq!(seen, hand(&here, side), "{name}");
        }
    }
}

#[test]
fn what_is_done_again_is_counted() {
    for times in 2..=4 {
        for movement in ["down 10cm", "arc out 12cm bulging up", "circle axis left radius 8cm"] {
            let text = format!(
                "sign X\n  configuration  flat\n  placement      chest right, 24cm away\n  orientation    fingers out, palm down\n  movement       {movement}, repeated {times}\n"
            );
            let found = annotate(&perform(&sign(&text)).track.clip);
            let movements = found.tiers().into_iter().find(|t| t.name == "RH Movement").unwrap();
            assert_eq!(movements.values().len(), 1, "{movements:?}");
            assert!(movements.values()[0].label.ends_with(&format!(" ×{times}")), "{movements:?}");
        }
    }
}

#[test]
fn a_hand_goes_from_rest_to_rest() {
    let found = annotate(&perform(&named("BOL")).track.clip);
    for side in [Side::Left, Side::Right] {
        let phases: Vec<Phase> = found.hand(side).unwrap().phases.iter().map(|p| p.value).collect();
        assert_eq!(phases, [Phase::Preparation, Phase::Stroke, Phase::Hold, Phase::Retraction]);
    }
    // A hand that has nothing to do has no values.
    let found = annotate(&perform(&named("MOI")).track.clip);
    assert!(found.hand(Side::Left).unwrap().phases.is_empty());
}

#[test]
fn a_hand_without_an_arm_has_shapes_and_phases_but_no_place() {
    let text = "sign X\n  configuration  flat then fist-s then V\n  placement      chest right, 24cm away\n  orientation    fingers up, palm out\n  movement       change then change\n";
    let clip = perform(&sign(text)).track.clip;
    let hand = Coverage { left: Limb::None, right: Limb::Hand };
    let found = annotator().annotate(&clip, hand, &Options::default());
    assert!(found.hand(Side::Left).is_none());
    let right = found.hand(Side::Right).unwrap();
    let shapes: Vec<&str> = right.configuration.iter().map(|v| v.value.id.as_str()).collect();
    let at = |id: &str| shapes.iter().position(|s| *s == id).unwrap_or_else(|| panic!("{id} in {shapes:?}"));
    assert!(at("flat") < at("fist-s") && at("fist-s") < at("V"));
    assert!(right.placement.is_empty() && right.phases.iter().any(|p| p.value == Phase::Stroke));
}

#[test]
fn noise_of_a_recording_changes_no_shape_and_no_phase() {
    let clip = perform(&named("BOL")).track.clip;
    let mut seed = 7u64;
    let mut noise = || {
        seed = seed.wrapping_mul(6364136223846793005).wrapping_add(1442695040888963407);
        ((seed >> 33) as f64 / f64::from(1u32 << 31) - 0.5) * 0.012
    };
    let shaken = clip.frames().iter().map(|frame| {
        let mut frame = frame.clone();
        frame
            .pose
            .rotations
            .iter_mut()
            .for_each(|q| *q = DQuat::from_scaled_axis(DVec3::new(noise(), noise(), noise())) * *q);
        frame
    });
    let (still, shaken) = (annotate(&clip), annotate(&clip_of(shaken.collect(), 60.0)));
    for (a, b) in still.hands.iter().zip(&shaken.hands) {
        let phases =
            |h: &chereme::corpus::annotate::HandAnnotation| h.phases.iter().map(|p| p.value).collect::<Vec<_>>();
        assert_eq!(phases(a), phases(b));
        let shapes = |h: &chereme::corpus::annotate::HandAnnotation| {
            h.configuration.iter().map(|c| c.value.id.clone()).collect::<Vec<_>>()
        };
        assert_eq!(shapes(a), shapes(b));
    }
}

#[test]
fn signs_of_the_lexicon_give_their_descriptions_back() {
    let world = world();
    let mut tally = Tally::default();
    for entry in lexicon().entries().step_by(6) {
        let performance = perform(&entry.sign);
        let found = annotate(&performance.track.clip);
        tally.add(&judge(&entry.sign, &performance, &found, annotator(), &world.grammar, &world.signer));
    }
    let goal =
        |judged, least: f64, share: f64| assert!(share >= least, "{judged:?} {share}\n{:?}", tally.confusions(judged));
    goal(Judged::Configuration, 0.98, tally.share(Judged::Configuration, true).strict());
    goal(Judged::Placement, 0.80, tally.share(Judged::Placement, true).strict());
    goal(Judged::Placement, 0.90, tally.share(Judged::Placement, true).loose());
    goal(Judged::Orientation, 0.95, tally.share(Judged::Orientation, true).strict());
    goal(Judged::Movement, 0.85, tally.share(Judged::Movement, true).strict());
}

#[test]
fn the_six_places_of_a_bowl_are_named() {
    let world = world();
    let named = six_places(&named("BOL"), annotator(), &world.grammar, &world.signer).unwrap();
    assert_eq!(named, SIX_PLACES.map(Some));
}

#[test]
fn forms_of_both_hands_compare() {
    let world = world();
    let angles = world.grammar.handshapes.find("Y", None).unwrap().angles();
    let mut pose = LocalPose::rest(&world.signer.skeleton);
    for side in [Side::Left, Side::Right] {
        world.signer.hand(side).apply(&angles, &mut pose);
    }
    let [left, right] = [Side::Left, Side::Right].map(|side| HandForm::of(&world.signer, side, &pose));
    assert!(left.tips_apart(&right) < 1e-9 && left.is_same(&HandForm::of_angles(&world.signer, &angles)));
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 24, ..ProptestConfig::default() })]

    #[test]
    fn any_motion_is_annotated_without_fault(turns in prop::collection::vec(-3.0f64..3.0, 12..200), odd in 0usize..4, fps in 1.0f64..240.0) {
        let signer = &world().signer;
        let rest = LocalPose::rest(&signer.skeleton);
        let frames = turns.chunks(4).enumerate().map(|(n, chunk)| {
            let mut pose = rest.clone();
            for (k, turn) in chunk.iter().enumerate() {
                let joint = signer.arm(if k % 2 == 0 { Side::Left } else { Side::Right }).joints()[k % 4];
                pose.set(joint, DQuat::from_rotation_y(*turn) * DQuat::from_rotation_z(*turn * 0.7));
            }
            if n == odd && odd > 1 {
                pose.set(signer.arm(Side::Right).hand, DQuat::from_xyzw(f64::NAN, 0.0, 0.0, 1.0));
            }
            Frame { pose, weights: vec![0.0; signer.morphs.len()] }
        });
        let clip = clip_of(frames.collect(), fps);
        for coverage in [Coverage::WHOLE, Coverage { left: Limb::None, right: Limb::Hand }] {
            let found = annotator().annotate(&clip, coverage, &Options::default());
            for tier in found.tiers() {
                prop_assert!(tier.values().iter().all(|v| v.start.0 <= v.end.0 && v.end.0 <= clip.duration().0 + 1e-9));
            }
        }
    }
}
