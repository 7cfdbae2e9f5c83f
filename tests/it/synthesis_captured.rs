//! Signs rebuilt from takes: what an edit does not touch stays, ways keep the pace, the tiers tell the source.
//!
//! The takes here are synthesized signs: what a corpus holds is motion of the rig with tiers, whoever made it.

use crate::moving::wrist_path;
use crate::signing::{lexicon, sign, tables, world};
use chereme::body::channel::Channels;
use chereme::body::retarget::Coverage;
use chereme::diagnostics::Error;
use chereme::motion::rotation::angle_between;
use chereme::motion::skeleton::JointId;
use chereme::notation::Vocabulary;
use chereme::phonology::handshape::HandAngles;
use chereme::phonology::recombination::ManualChannel;
use chereme::phonology::{Configuration, Side};
use chereme::score::gloss::{CapturedGlosses, Known, Reading, Settings, read};
use chereme::synthesis::captured::{Pace, Take, Takes, perform, with_channel};
use chereme::synthesis::edit::track::Phases;
use chereme::synthesis::{Grammar, Options, Performance, synthesize};
use chereme::time::{FrameIndex, Seconds};
use chereme::track::Track;
use glam::DVec3;
use std::sync::LazyLock;

/// A body with arms and hands.
const WHOLE: Coverage = Coverage { body: true, arms: [true; 2], hands: [true; 2] };

struct Shelf {
    takes: Vec<Take>,
    pace: Pace,
}

impl Takes for Shelf {
    fn of_gloss(&self, gloss: &str) -> Result<Option<Take>, Error> {
        Ok(self.takes.iter().find(|take| take.name.starts_with(&format!("{}_", gloss.to_lowercase()))).cloned())
    }

    fn named(&self, name: &str) -> Result<Take, Error> {
        let found = self.takes.iter().find(|take| take.name == name).cloned();
        found.ok_or_else(|| Error::new(format!("there is no take {name}")))
    }

    fn configuration(&self, _: &Configuration) -> Option<(HandAngles, String)> {
        None
    }

    fn pace(&self) -> &Pace {
        &self.pace
    }
}

fn performed(text: &str) -> Track {
    let world = world();
    synthesize(&sign(text), &world.grammar, &world.signer, &Options::default()).unwrap().track
}

/// Two takes of one hand, one of two.
static SHELF: LazyLock<Shelf> = LazyLock::new(|| {
    let take = |name: &str, text: &str| Take { name: name.into(), track: performed(text), covers: WHOLE };
    let takes = vec![
        take(
            "father_1",
            "sign FATHER\n configuration 5\n placement chest, neutral distance\n orientation fingers up, palm left\n movement up 12cm\n",
        ),
        take(
            "mother_1",
            "sign MOTHER\n configuration fist-s\n placement stomach, neutral distance\n orientation fingers out-left, palm down\n movement left 10cm then right 10cm\n",
        ),
        take(
            "bowl_1",
            "sign BOWL\n hands both mirrored\n configuration round-B\n placement chest right, neutral distance\n orientation fingers out-left, palm up\n movement arc up-right 15cm\n",
        ),
    ];
    let joints: Vec<JointId> = world().signer.skeleton.ids().collect();
    let pace = Pace::of(takes.iter().map(|take| (&take.track.clip, &joints[..])));
    Shelf { takes, pace }
});

fn line(text: &str, preferred: bool) -> Reading {
    let vocabulary = Vocabulary::builtin();
    let known = Known { lexicon: lexicon(), vocabulary: &vocabulary, tables: tables() };
    let glosses = ["father", "mother", "bowl"].map(str::to_owned).into();
    let captured = CapturedGlosses { glosses, preferred };
    read(text, &known, &Settings { captured, language: Some("lsf".into()), ..Settings::default() })
}

fn signed(text: &str) -> Performance {
    let reading = line(text, true);
    assert!(!reading.has_faults(), "{:?}", reading.diagnostics);
    let world = world();
    perform(&reading.plan, &*SHELF, &world.grammar, &world.signer, &Options::default()).unwrap()
}

fn frames(track: &Track, start: Seconds, end: Seconds) -> Vec<Vec<glam::DQuat>> {
    let fps = track.clip.fps().get();
    let (a, b) = ((start.0 * fps).round() as usize, (end.0 * fps).round() as usize);
    track.clip.frames()[a..=b].iter().map(|frame| frame.pose.rotations.clone()).collect()
}

#[test]
fn a_take_is_played_back_between_eased_ways() {
    let made = signed("take(father_1)");
    let source = &SHELF.takes[0].track;
    let own = Phases::of(source).unwrap();
    let again = frames(&made.track, made.report.stroke_start, made.report.sign_end);
    let before = frames(source, own.stroke, own.sign_end);
    assert_eq!(again.len(), before.len());
    for (a, b) in again.iter().flatten().zip(before.iter().flatten()) {
        assert!(angle_between(*a, *b) < 1e-6);
    }
    let phases: Vec<String> = made.track.phases("RH Phase").into_iter().map(|p| p.name).collect();
    assert_eq!(phases, ["preparation", "stroke", "hold", "retraction"]);
    assert_eq!(made.track.tier("RH Gloss").unwrap().values()[0].label, "take(father_1)");
}

#[test]
fn every_value_tells_where_it_came_from() {
    let made = signed("father@left take(mother_1, configuration father_1) BONJOUR bowl[inverted]++");
    for tier in &made.track.tiers {
        for v in tier.values() {
            let known = ["corpus: ", "procedure", "description", "default", "configuration", "grammar"];
            assert!(known.iter().any(|k| v.source.starts_with(k)), "{}: {} from {:?}", tier.name, v.label, v.source);
        }
    }
    let configurations = made.track.tier("RH Configuration").unwrap().values();
    let from: Vec<(&str, &str)> = configurations.iter().map(|v| (v.label.as_str(), v.source.as_str())).collect();
    assert!(from[0] == ("5", "corpus: father_1, description"), "{from:?}");
    assert!(from[1] == ("5", "corpus: father_1, description"), "{from:?}");
    assert!(from.iter().any(|(label, source)| *label == "round-B" && source.starts_with("corpus: bowl_1")), "{from:?}");
    assert!(from.iter().any(|(_, source)| *source == "description"), "{from:?}");
}

#[test]
fn no_joint_turns_faster_on_a_way_than_in_the_corpus() {
    let made = signed("take(father_1) take(mother_1) <REST 0.3s> take(bowl_1) BONJOUR");
    let (clip, skeleton) = (&made.track.clip, &world().signer.skeleton);
    let ways: Vec<_> = ["RH Phase", "LH Phase"]
        .iter()
        .flat_map(|name| made.track.phases(name))
        .filter(|phase| ["preparation", "transition", "retraction"].contains(&phase.name.as_str()))
        .collect();
    assert!(ways.len() >= 5, "{ways:?}");
    let described = made.track.tier("RH Gloss").unwrap().values().iter().find(|v| v.label == "BONJOUR").unwrap().start;
    for (i, pair) in clip.frames().windows(2).enumerate() {
        let (a, b) = (clip.fps().time_of(FrameIndex(i)), clip.fps().time_of(FrameIndex(i + 1)));
        let on_way = ways.iter().any(|way| way.start <= a && b <= way.end) && b < described;
        for joint in skeleton.ids().filter(|_| on_way) {
            let speed = angle_between(pair[0].pose.rotation(joint), pair[1].pose.rotation(joint)) * clip.fps().get();
            let most = SHELF.pace.of_joint(joint);
            assert!(speed <= most * 1.01 + 1e-6, "{} at {a}: {speed} of {most}", skeleton[joint].name);
        }
    }
    assert!(made.report.wrist_speed < 3.1, "{}", made.report.wrist_speed);
}

#[test]
fn one_channel_of_another_take_leaves_the_rest_bit_for_bit() {
    let signer = &world().signer;
    let (father, mother) = (&SHELF.takes[0].track, &SHELF.takes[1]);
    let made = with_channel(father, mother, ManualChannel::Configuration, signer, Default::default()).unwrap();
    let fingers = Channels::of(signer, Side::Right).configuration;
    let (own, theirs) = (Phases::of(father).unwrap(), Phases::of(&mother.track).unwrap());
    for (i, (was, is)) in father.clip.frames().iter().zip(made.clip.frames()).enumerate() {
        for joint in signer.skeleton.ids().filter(|joint| !fingers.contains(joint)) {
            assert_eq!(was.pose.rotation(joint), is.pose.rotation(joint));
        }
        let time = father.clip.fps().time_of(FrameIndex(i)).0;
        if (own.stroke.0..=own.stroke_end.0).contains(&time) {
            let share = (time - own.stroke.0) / (own.stroke_end.0 - own.stroke.0);
            let at = Seconds(theirs.stroke.0 + share * (theirs.stroke_end.0 - theirs.stroke.0));
            let wanted = mother.track.clip.sample(at).pose;
            assert!(fingers.iter().all(|j| angle_between(wanted.rotation(*j), is.pose.rotation(*j)) < 1e-6));
        }
    }
    // The arm of one, the turned hand and the fingers of the other.
    let placed = with_channel(father, mother, ManualChannel::Placement, signer, Default::default()).unwrap();
    let hand = signer.arm(Side::Right).hand;
    let middle = Seconds((own.stroke.0 + own.stroke_end.0) / 2.0);
    let at = |track: &Track| track.clip.sample(middle).pose.to_model(&signer.skeleton);
    assert!(angle_between(at(father).rotation(hand), at(&placed).rotation(hand)) < 1e-3);
    assert!(at(father).position(hand).distance(at(&placed).position(hand)) > 0.05);
    let turned = with_channel(father, mother, ManualChannel::Orientation, signer, Default::default()).unwrap();
    assert!(at(father).position(hand).distance(at(&turned).position(hand)) < 1e-9);
    assert!(angle_between(at(father).rotation(hand), at(&turned).rotation(hand)) > 0.5);
    // Of a sign of two hands both take it.
    let bowl = with_channel(&SHELF.takes[2].track, mother, ManualChannel::Configuration, signer, Default::default());
    assert!(bowl.is_ok());
}

#[test]
fn a_captured_sign_is_moved_to_a_place() {
    let made = signed("take(father_1)@(-0.15,1.2,0.3)");
    let phases = Phases::of(&made.track).unwrap();
    let fps = made.track.clip.fps().get();
    let (a, b) = ((phases.stroke.0 * fps).round() as usize, (phases.stroke_end.0 * fps).round() as usize);
    let path = wrist_path(&made.track.clip, Side::Right);
    let mean = path[a..=b].iter().sum::<DVec3>() / (b - a + 1) as f64;
    assert!(mean.distance(DVec3::new(-0.15, 1.2, 0.3)) < 0.004, "{mean}");
}

#[test]
fn glosses_are_captured_where_that_is_preferred_or_nothing_else_is_known() {
    let kinds = |text: &str, preferred: bool| -> Vec<bool> {
        let reading = line(text, preferred);
        assert!(!reading.has_faults(), "{:?}", reading.diagnostics);
        let captured = |item: &chereme::score::plan::Item| matches!(item.act, chereme::score::plan::Act::Captured(_));
        reading.plan.items.iter().map(captured).collect()
    };
    assert_eq!(kinds("FATHER BONJOUR", true), [true, false]);
    assert_eq!(kinds("FATHER BONJOUR", false), [true, false]);
    let reading = line("take(nobody)", true);
    let world = world();
    let told = perform(&reading.plan, &*SHELF, &world.grammar, &world.signer, &Options::default()).unwrap_err();
    assert!(told.to_string().contains("there is no take nobody"), "{told}");
    let reading = line("take(father_1)[with orientation fingers up]", true);
    let told = perform(&reading.plan, &*SHELF, &world.grammar, &world.signer, &Options::default()).unwrap_err();
    assert!(told.to_string().contains("no description"), "{told}");
}

#[test]
fn captured_hands_and_rest_poses_stand_in_for_made_ones() {
    let world = world();
    let mut grammar: Grammar = world.grammar.clone();
    let shape = grammar.handshapes.find("fist-s", None).unwrap();
    let mut angles = shape.angles();
    angles.fingers[0].mcp -= 0.2;
    grammar.captured.insert(shape.id.clone(), (angles, "corpus: eight_3 at 0.51 s".into()));
    let mut signer = world.signer.clone();
    let mut rest = signer.neutral(&HandAngles::default());
    rest.set(signer.head(), glam::DQuat::from_rotation_x(0.1));
    signer.resting = Some(rest.clone());
    let said = sign("sign X\n configuration 5 then fist-s\n");
    let made = synthesize(&said, &grammar, &signer, &Options::default()).unwrap();
    let end = made.track.clip.sample(made.report.sign_end).pose;
    let made_of = signer.hand(Side::Right).angles_of(&end);
    assert!((made_of.fingers[0].mcp - angles.fingers[0].mcp).abs() < 1e-3, "{made_of:?}");
    let told: Vec<&str> =
        made.track.tier("RH Configuration").unwrap().values().iter().map(|v| v.source.as_str()).collect();
    assert_eq!(told, ["description", "corpus: eight_3 at 0.51 s"]);
    let frames = made.track.clip.frames();
    for ends in [&frames[0], &frames[frames.len() - 1]] {
        assert!(ends.pose.rotations.iter().zip(&rest.rotations).all(|(a, b)| angle_between(*a, *b) < 1e-6));
    }
}

#[test]
fn a_hand_alone_rides_on_the_signer_as_he_rests() {
    let world = world();
    let mut signer = world.signer.clone();
    let mut rest = signer.neutral(&HandAngles::default());
    let spine = signer.skeleton.joint("Spine2").unwrap();
    rest.set(spine, glam::DQuat::from_rotation_x(0.2));
    signer.resting = Some(rest.clone());
    let alone = Coverage { hands: [false, true], ..Coverage::default() };
    let takes = vec![Take { covers: alone, ..SHELF.takes[0].clone() }];
    let shelf = Shelf { takes, pace: SHELF.pace.clone() };
    let made =
        perform(&line("take(father_1)", true).plan, &shelf, &world.grammar, &signer, &Options::default()).unwrap();
    let right: Vec<JointId> = Channels::of(&signer, Side::Right).limb().collect();
    for frame in made.track.clip.frames() {
        for joint in signer.skeleton.ids().filter(|joint| !right.contains(joint)) {
            assert!(angle_between(frame.pose.rotation(joint), rest.rotation(joint)) < 1e-6);
        }
    }
}
