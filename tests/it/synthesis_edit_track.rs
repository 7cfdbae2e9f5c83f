//! Operators on tracks: the motion and its tiers together, and the routes by motion and by description compared.

use crate::moving::{apart, is_sound, same_but, strokes_apart, turned, wrist_path};
use crate::signing::{perform, sign, signs_of, world};
use chereme::body::channel::Channels;
use chereme::motion::easing::Easing;
use chereme::motion::rotation::angle_between;
use chereme::motion::skeleton::JointId;
use chereme::phonology::Side;
use chereme::synthesis::edit::track::{self, Phases};
use chereme::synthesis::edit::{HandKept, Repetition, Sides};
use chereme::time::{FrameIndex, Seconds};
use chereme::track::Track;
use glam::DVec3;

fn made(name: &str) -> Track {
    let sign = signs_of("lsf").into_iter().find(|s| s.name == name).expect("a sign of the lexicon");
    perform(&sign).track
}

fn limbs(sides: Sides) -> Vec<JointId> {
    let channels = sides.each().iter().map(|s| Channels::of(&world().signer, *s));
    channels.flat_map(|c| c.limb().collect::<Vec<_>>()).collect()
}

fn labels(track: &Track, tier: &str) -> Vec<String> {
    track.tier(tier).map_or(vec![], |t| t.values().iter().map(|v| v.label.clone()).collect())
}

#[test]
fn inverted_the_stroke_ends_where_it_began_and_the_face_stays() {
    let signer = &world().signer;
    for name in ["CLAIR", "BOL", "PUNIR", "AIMER", "LSF"] {
        let source = made(name);
        let phases = Phases::of(&source).unwrap();
        let back = track::inverted(&source, signer, Easing::default()).unwrap();
        assert!(is_sound(&back.clip), "{name}");
        assert!(same_but(&back.clip, &source.clip, &limbs(phases.sides)), "{name}");
        assert_eq!(Phases::of(&back).unwrap(), phases);
        let fps = source.clip.fps();
        let limb = limbs(phases.sides);
        for i in 0..source.clip.frames().len() {
            let time = fps.time_of(FrameIndex(i));
            let other = if time < phases.start || time > phases.retracted {
                time
            } else if time >= phases.stroke && time <= phases.sign_end {
                Seconds(phases.stroke.0 + phases.stroke_end.0 - time.0.min(phases.stroke_end.0))
            } else {
                continue;
            };
            let wanted = source.clip.sample(other).pose;
            let found = &back.clip.frames()[i].pose;
            let worst = limb.iter().map(|j| angle_between(found.rotation(*j), wanted.rotation(*j))).fold(0.0, f64::max);
            assert!(worst < 1e-9, "{name} at {time}: {worst}");
        }
        // The ways are made again: no step is larger than a hand goes in a frame at 5 m/s.
        for &side in phases.sides.each() {
            let path = wrist_path(&back.clip, side);
            let step = path.windows(2).map(|w| w[0].distance(w[1])).fold(0.0, f64::max);
            assert!(step < 5.0 / 60.0, "{name}: {step} m in a frame");
        }
    }
    let clair = made("CLAIR");
    let fonce = track::inverted(&clair, signer, Easing::default()).unwrap();
    assert_eq!(labels(&clair, "RH Configuration"), ["flat-O", "5"]);
    assert_eq!(labels(&fonce, "RH Configuration"), ["5", "flat-O"]);
    let spans =
        |t: &Track| t.tier("RH Configuration").unwrap().values().iter().map(|v| (v.start, v.end)).collect::<Vec<_>>();
    for (found, wanted) in spans(&fonce).iter().zip(spans(&clair)) {
        // Counted back from the end, a time may differ in its last bit.
        assert!(
            (found.0.0 - wanted.0.0).abs() < 1e-9 && (found.1.0 - wanted.1.0).abs() < 1e-9,
            "{found:?}, {wanted:?}"
        );
    }
}

#[test]
fn exchanged_and_mirrored_tracks_take_their_tiers_along() {
    let signer = &world().signer;
    let source = made("WEEK-END");
    let count = |t: &Track, prefix: &str| t.tiers.iter().filter(|t| t.name.starts_with(prefix)).count();
    let own = count(&source, "RH ");
    assert!(own >= 5 && count(&source, "LH ") == 0);
    let swapped = track::swapped(&source, signer).unwrap();
    assert_eq!((count(&swapped, "RH "), count(&swapped, "LH ")), (0, own));
    assert_eq!(labels(&swapped, "LH Movement"), ["left 10cm"]);
    let again = track::swapped(&swapped, signer).unwrap();
    for tier in &source.tiers {
        assert_eq!(labels(&again, &tier.name), labels(&source, &tier.name));
    }
    let both = track::mirrored(&source, signer, Side::Right).unwrap();
    assert_eq!((count(&both, "RH "), count(&both, "LH ")), (own, own));
    assert_eq!(Phases::of(&both).unwrap().sides, Sides::Both);
    assert!(chereme::synthesis::edit::beyond_midline(&both.clip, signer, Side::Right).unwrap() < 0.0);
    let reflected = track::reflected(&source);
    assert_eq!(labels(&reflected, "LH Orientation"), labels(&swapped, "LH Orientation"));
    // The trunk of WEEK-END does not turn, so swap and reflection put the left wrist in one place.
    assert!(apart(&wrist_path(&reflected.clip, Side::Left), &wrist_path(&swapped.clip, Side::Left)) < 1e-9);
}

#[test]
fn repeated_the_track_has_several_strokes_between_one_way_there_and_back() {
    let signer = &world().signer;
    for growth in [1.0, 0.8] {
        let source = made("PUNIR");
        let phases = Phases::of(&source).unwrap();
        let how = Repetition { times: 3, gap: Seconds(0.1), growth, ..Repetition::default() };
        let thrice = track::repeated(&source, signer, &how).unwrap();
        assert!(is_sound(&thrice.clip));
        let strokes = thrice.tier("RH Phase").unwrap().values().iter().filter(|v| v.label == "stroke").count();
        assert_eq!(strokes, 3);
        let now = Phases::of(&thrice).unwrap();
        let more = thrice.clip.duration() - source.clip.duration();
        assert!((now.stroke_end - phases.stroke_end - more).0.abs() < 1e-9);
        assert_eq!(now.stroke, phases.stroke);
        let path = wrist_path(&thrice.clip, Side::Right);
        let step = path.windows(2).map(|w| w[0].distance(w[1])).fold(0.0, f64::max);
        assert!(step < 5.0 / 60.0, "{step} m in a frame");
        let ends = |t: &Track| [0, t.clip.frames().len() - 1].map(|i| t.clip.frames()[i].pose.rotations.clone());
        for (a, b) in ends(&thrice).iter().zip(&ends(&source)) {
            assert!(turned(a, b) < 1e-9);
        }
        for tier in &thrice.tiers {
            let end = thrice.clip.duration().0 + 1.0 / 60.0;
            assert!(tier.values().iter().all(|v| v.start <= v.end && v.end.0 <= end), "{tier:?}");
        }
    }
}

#[test]
fn another_configuration_or_place_leaves_the_rest_and_is_named() {
    let signer = &world().signer;
    let source = made("BOL");
    let phases = Phases::of(&source).unwrap();
    let shape = world().grammar.handshapes.find("fist-s", None).unwrap().angles();
    let fist = track::with_configuration(&source, signer, Sides::Both, ("fist-s", &shape), Easing::default()).unwrap();
    assert_eq!(labels(&fist, "LH Configuration"), ["fist-s"]);
    let middle = fist.clip.sample(Seconds((phases.stroke.0 + phases.sign_end.0) / 2.0)).pose;
    assert!(signer.hand(Side::Left).angles_of(&middle).max_difference(&shape) < 1e-4);
    assert!(is_sound(&fist.clip));

    let target = DVec3::new(0.15, 1.2, 0.3);
    let there = track::relocated_to(&source, signer, target, HandKept::Global).unwrap();
    assert!(is_sound(&there.track.clip) && there.residual_m < 1e-6, "{}", there.residual_m);
    let extent = chereme::synthesis::edit::Extent::between(phases.stroke, phases.stroke_end);
    let place = chereme::synthesis::edit::mean_place(&there.track.clip, signer, Sides::Both, &extent).unwrap();
    assert!(place.distance(target) < 1e-4, "{place}");
    assert_eq!(there.track.clip.frames()[0], source.clip.frames()[0]);
    assert!(labels(&there.track, "RH Placement").iter().all(|l| l.ends_with("elsewhere")));
}

#[test]
fn a_track_without_phases_or_with_several_signs_is_refused() {
    let signer = &world().signer;
    let mut several = made("PUNIR");
    let gloss = several.tiers.iter_mut().find(|t| t.name == "RH Gloss").unwrap();
    gloss.push(Seconds(2.0), Seconds(3.0), "OK", "test");
    let refused = track::inverted(&several, signer, Easing::default()).unwrap_err();
    assert!(refused.to_string().contains("several signs"));
    several.tiers.clear();
    assert!(track::relocated_by(&several, signer, DVec3::X, HandKept::Global).is_err());
}

/// A sign of which another description changes some words. Its place has a side stated: where none is, the description
/// of two hands sets them apart, which a copied motion does not.
fn described(hands: &str, configuration: &str, offset: &str, movement: &str) -> Track {
    let text = format!(
        "sign X\n hands {hands}\n configuration {configuration}\n placement right shoulders, 20cm away, offset {offset}\n \
         orientation fingers up, palm out\n movement {movement}\n"
    );
    perform(&sign(&text)).track
}

fn agree(by_motion: &Track, by_description: &Track, side: Side) {
    let (metres, radians) = strokes_apart(by_motion, by_description, side);
    assert!(metres < 5e-3 && radians.to_degrees() < 3.0, "{metres} m, {}°", radians.to_degrees());
}

#[test]
fn the_routes_by_motion_and_by_description_agree() {
    let signer = &world().signer;
    let easing = Easing::default();
    let forth = described("strong", "flat", "left 2cm", "left 10cm");
    let back = described("strong", "flat", "left 12cm", "right 10cm");
    agree(&track::inverted(&forth, signer, easing).unwrap(), &back, Side::Right);
    let both = described("both mirrored", "flat", "left 2cm", "left 10cm");
    let mirrored = track::mirrored(&forth, signer, Side::Right).unwrap();
    agree(&mirrored, &both, Side::Right);
    agree(&mirrored, &both, Side::Left);
    let shape = world().grammar.handshapes.find("5", None).unwrap().angles();
    let spread = track::with_configuration(&forth, signer, Sides::Right, ("5", &shape), easing).unwrap();
    agree(&spread, &described("strong", "5", "left 2cm", "left 10cm"), Side::Right);
}
