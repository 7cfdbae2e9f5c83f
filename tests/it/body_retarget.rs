//! Motion of strangers' skeletons on our rig and back: laws on strangers made from ours, goals on captured files.

use crate::moving::any_clip;
use crate::shared::shared;
use crate::signing::world;
use chereme::body::retarget::names::recognise;
use chereme::body::retarget::{Axes, Humanoid, Mode, Options, Retargeted, propose_axes, retarget, to_theirs};
use chereme::format::bvh;
use chereme::motion::clip::Clip;
use chereme::motion::pose::LocalPose;
use chereme::motion::rotation::angle_between;
use chereme::motion::skeleton::{Joint, Skeleton};
use chereme::phonology::Side;
use glam::{DQuat, DVec3};
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;

/// A stranger with our joints under other names, other lengths of bones, and its space turned.
fn stranger(turn: DQuat, lengths: &[f64]) -> (Arc<Skeleton>, BTreeMap<String, String>) {
    let ours = &world().signer.skeleton;
    let mut joints: Vec<Joint> = Vec::new();
    for id in ours.ids() {
        let (joint, scale) = (&ours[id], lengths[id.index() % lengths.len()]);
        let above = joint.parent.map_or(DVec3::ZERO, |p| joints[p.index()].rest_model);
        let rest_model = above + turn * ours.offset(id) * scale;
        let tail_model = rest_model + turn * (joint.tail_model - joint.rest_model) * scale;
        joints.push(Joint { name: format!("their:{}", joint.name), rest_model, tail_model, ..joint.clone() });
    }
    let names = ours.joints().iter().filter(|j| !j.name.contains("Twist"));
    let map = names.map(|j| (j.name.clone(), format!("their:{}", j.name))).collect();
    (Arc::new(Skeleton::new(joints).unwrap()), map)
}

fn any_axes() -> impl Strategy<Value = Axes> {
    let all: Vec<Axes> = ["+x", "-x", "+y", "-y", "+z", "-z"]
        .iter()
        .flat_map(|up| ["+x", "-x", "+y", "-y", "+z", "-z"].map(|front| (up.parse().unwrap(), front.parse().unwrap())))
        .filter_map(|(up, front)| Axes::new(up, front))
        .collect();
    assert_eq!(all.len(), 24);
    prop::sample::select(all)
}

fn options(mode: Mode) -> Options {
    Options { mode, skip_frames: 0, rest: LocalPose::rest(&world().signer.skeleton) }
}

fn onto_us(clip: &Clip, humanoid: &Humanoid, mode: Mode) -> Retargeted {
    retarget(clip, humanoid, &world().signer, &options(mode)).unwrap()
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(24))]

    #[test]
    fn directions_come_back_from_any_stranger(
        clip in any_clip(),
        axes in any_axes(),
        lengths in prop::collection::vec(0.6f64..1.6, 61),
    ) {
        let signer = &world().signer;
        let (skeleton, map) = stranger(axes.turn().conjugate(), &lengths);
        let humanoid = Humanoid::new(&skeleton, &map, axes, signer).unwrap();
        let theirs = to_theirs(&clip, &humanoid, signer).unwrap();
        let back = onto_us(&theirs, &humanoid, Mode::Directions);
        prop_assert!(back.report.worst() < 1e-6, "{:?}", back.report);
        // And they are ours again: each bone looks where it looked.
        for (was, is) in clip.frames().iter().zip(back.clip.frames()) {
            let (was, is) = (was.pose.to_model(&signer.skeleton), is.pose.to_model(&signer.skeleton));
            for bone in ["LeftArm", "RightForeArm", "LeftHand", "RightHandIndex1", "LeftHandThumb2", "Head", "Spine1"] {
                let id = signer.skeleton.joint(bone).unwrap();
                let child = signer.skeleton.ids().find(|c| {
                    signer.skeleton[*c].parent == Some(id) && !signer.skeleton[*c].name.contains("Twist")
                });
                let Some(child) = child.filter(|c| !["LeftEye", "RightEye"].contains(&signer.skeleton[*c].name.as_str()))
                else { continue };
                let way = |m: &chereme::motion::pose::ModelPose| m.position(child) - m.position(id);
                // With other proportions of the palm, the thumb's knuckle is elsewhere on the hand.
                if bone != "LeftHand" {
                    prop_assert!(way(&was).angle_between(way(&is)) < 1e-5, "{bone}");
                }
            }
        }
    }

    #[test]
    fn a_stranger_of_our_build_moves_as_we_do(clip in any_clip(), axes in any_axes(), size in 0.5f64..2.0) {
        let signer = &world().signer;
        let (skeleton, map) = stranger(axes.turn().conjugate(), &[size]);
        let humanoid = Humanoid::new(&skeleton, &map, axes, signer).unwrap();
        let theirs = to_theirs(&clip, &humanoid, signer).unwrap();
        for mode in [Mode::Directions, Mode::Contacts] {
            let back = onto_us(&theirs, &humanoid, mode);
            if mode == Mode::Contacts {
                prop_assert!(back.report.tips_m < 1e-3 && back.report.wrists_m < 1e-3, "{:?}", back.report);
            }
            for (was, is) in clip.frames().iter().zip(back.clip.frames()) {
                let (was, is) = (was.pose.to_model(&signer.skeleton), is.pose.to_model(&signer.skeleton));
                for side in [Side::Left, Side::Right] {
                    let hand = signer.arm(side).hand;
                    prop_assert!(angle_between(was.rotation(hand), is.rotation(hand)) < 1e-5);
                    let (hips, head) = (signer.skeleton.joint("Hips").unwrap(), signer.head());
                    prop_assert!(angle_between(was.rotation(head), is.rotation(head)) < 1e-5);
                    let from_hips = |m: &chereme::motion::pose::ModelPose| m.position(hand) - m.position(hips);
                    let near = if mode == Mode::Contacts { 1e-3 } else { 1e-5 };
                    prop_assert!(from_hips(&was).distance(from_hips(&is)) < near);
                }
            }
        }
    }
}

fn read(path: &Path) -> Option<Clip> {
    let reading = bvh::read(&std::fs::read(path).unwrap()).ok()?;
    let metres_per_unit = bvh::propose_unit(&reading.bvh).map_or(0.001, |unit| unit.metres_per_unit);
    bvh::to_clip(&reading.bvh, &bvh::ClipOptions { metres_per_unit, roots: bvh::Roots::First }).ok().map(|c| c.clip)
}

/// File, convention, axes, arms, hands.
const RECOGNISED: [(&str, &str, &str, bool, bool); 19] = [
    ("sign_body/ISL_Thanks_final.bvh", "Mixamo", "+y+z", true, true),
    ("sign_body/create_db_m.bvh", "Mixamo", "-z+y", true, true),
    ("sign_body/kateBVH.bvh", "Mixamo", "+y+z", true, true),
    ("sign_body/Idle.bvh", "Mixamo", "+y+z", true, true),
    ("cmu_dance/05_02.bvh", "Character Creator", "+y+z", true, true),
    ("cmu_dance/05_16.bvh", "Character Creator", "+y+z", true, true),
    ("cmu_body/01_01.bvh", "CMU", "+y+z", true, false),
    ("dance_misc/pirouette.bvh", "Daz", "+y+z", true, false),
    ("style/xia_neutral_16_000.bvh", "CMU", "+y-x", true, false),
    ("bvh_oddities/bvh-python__test_mocapbank.bvh", "other", "+y+z", true, false),
    ("bvh_oddities/pybvh__bvh_test2.bvh", "other", "+y-z", true, false),
    ("bvh_oddities/pybvh__bvh_test3.bvh", "Mixamo", "+z+y", true, true),
    ("bvh_oddities/bvhio__example.bvh", "other", "+y-z", true, false),
    ("bvh_oddities/bvh-toolbox__walk01.bvh", "Mixamo", "+y+z", true, false),
    ("bvh_oddities/makehuman__zombieWalk1.bvh", "MakeHuman", "+z-y", true, true),
    ("bvh_oddities/makehuman__tpose.bvh", "MakeHuman", "+z-y", true, true),
    ("sign_hand_tsl/eight_0_right.bvh", "Mixamo", "+y-z", false, true),
    ("hand_leap_jaanga/clenching.bvh", "Daz", "+y-z", false, true),
    ("hand_leap_playback/leap_three-claps_L.bvh", "Mixamo", "+y-z", false, true),
];

#[test]
fn captured_files_are_recognised_and_keep_their_directions() {
    let Some(folder) = shared("data/mocap") else { return };
    for (file, convention, axes, arms, hands) in RECOGNISED {
        let clip = read(&folder.join(file)).unwrap();
        let known = recognise(clip.skeleton());
        assert_eq!(known.convention, convention, "{file}");
        let found = propose_axes(&clip, &known.joints);
        assert_eq!(format!("{}{}", found.up(), found.front()), axes, "{file}");
        let humanoid = Humanoid::new(clip.skeleton(), &known.joints, found, &world().signer).unwrap();
        let covers = humanoid.covers();
        assert_eq!((covers.arms[0] && covers.arms[1], covers.hands[0] || covers.hands[1]), (arms, hands), "{file}");
        let kept = onto_us(&clip, &humanoid, Mode::Directions);
        assert!(kept.report.worst() < 2f64.to_radians(), "{file}: {:?}", kept.report.directions);
        let touching = onto_us(&clip, &humanoid, Mode::Contacts);
        assert!(touching.report.tips_m < 0.01, "{file}: tips {} m", touching.report.tips_m);
        assert!(kept.clip.frames().iter().all(|f| f.pose.rotations.iter().all(|q| q.is_finite() && q.is_normalized())));
    }
}

#[test]
fn hands_of_unreal_and_vrm_are_found_by_name() {
    let make = |names: &[(&str, Option<usize>)]| {
        let joints = names.iter().enumerate().map(|(i, (name, parent))| Joint {
            name: (*name).into(),
            parent: parent.map(|p| chereme::motion::skeleton::JointId(p as u16)),
            rest_model: DVec3::new(0.1 * i as f64, i as f64, 0.0),
            tail_model: DVec3::new(0.1 * i as f64, i as f64 + 0.5, 0.0),
        });
        recognise(&Skeleton::new(joints.collect()).unwrap())
    };
    let unreal = make(&[
        ("root", None),
        ("pelvis", Some(0)),
        ("spine_01", Some(1)),
        ("spine_02", Some(2)),
        ("spine_03", Some(3)),
        ("clavicle_l", Some(4)),
        ("upperarm_l", Some(5)),
        ("upperarm_twist_01_l", Some(6)),
        ("lowerarm_l", Some(6)),
        ("hand_l", Some(8)),
        ("index_metacarpal_l", Some(9)),
        ("index_01_l", Some(10)),
        ("thumb_03_l", Some(9)),
        ("neck_01", Some(4)),
        ("head", Some(13)),
        ("thigh_l", Some(1)),
        ("calf_l", Some(15)),
        ("foot_l", Some(16)),
        ("ball_l", Some(17)),
    ]);
    assert_eq!(unreal.convention, "Unreal");
    let expected = [
        ("Head", "head"),
        ("Hips", "pelvis"),
        ("LeftArm", "upperarm_l"),
        ("LeftFoot", "foot_l"),
        ("LeftForeArm", "lowerarm_l"),
        ("LeftHand", "hand_l"),
        ("LeftHandIndex1", "index_01_l"),
        ("LeftHandThumb3", "thumb_03_l"),
        ("LeftLeg", "calf_l"),
        ("LeftShoulder", "clavicle_l"),
        ("LeftToeBase", "ball_l"),
        ("LeftUpLeg", "thigh_l"),
        ("Neck", "neck_01"),
        ("Spine", "spine_01"),
        ("Spine1", "spine_02"),
        ("Spine2", "spine_03"),
    ];
    let of = |pairs: &[(&str, &str)]| {
        pairs.iter().map(|(a, b)| ((*a).to_owned(), (*b).to_owned())).collect::<BTreeMap<_, _>>()
    };
    assert_eq!(unreal.joints, of(&expected));
    assert_eq!(unreal.unknown, ["root", "upperarm_twist_01_l", "index_metacarpal_l"]);
    let vrm = make(&[
        ("J_Bip_C_Hips", None),
        ("J_Bip_C_Spine", Some(0)),
        ("J_Bip_C_Chest", Some(1)),
        ("J_Bip_C_UpperChest", Some(2)),
        ("J_Bip_R_Shoulder", Some(3)),
        ("J_Bip_R_UpperArm", Some(4)),
        ("J_Bip_R_LowerArm", Some(5)),
        ("J_Bip_R_Hand", Some(6)),
        ("J_Bip_R_Little2", Some(7)),
        ("J_Bip_C_Neck", Some(3)),
        ("J_Bip_C_Head", Some(9)),
        ("rightThumbMetacarpal", Some(7)),
        ("rightThumbProximal", Some(11)),
        ("rightThumbDistal", Some(12)),
    ]);
    assert_eq!(vrm.convention, "VRM");
    let expected = [
        ("Head", "J_Bip_C_Head"),
        ("Hips", "J_Bip_C_Hips"),
        ("Neck", "J_Bip_C_Neck"),
        ("RightArm", "J_Bip_R_UpperArm"),
        ("RightForeArm", "J_Bip_R_LowerArm"),
        ("RightHand", "J_Bip_R_Hand"),
        ("RightHandPinky2", "J_Bip_R_Little2"),
        ("RightHandThumb1", "rightThumbMetacarpal"),
        ("RightHandThumb2", "rightThumbProximal"),
        ("RightHandThumb3", "rightThumbDistal"),
        ("RightShoulder", "J_Bip_R_Shoulder"),
        ("Spine", "J_Bip_C_Spine"),
        ("Spine1", "J_Bip_C_Chest"),
        ("Spine2", "J_Bip_C_UpperChest"),
    ];
    assert_eq!(vrm.joints, of(&expected));
}

#[test]
fn what_cannot_be_mapped_is_told() {
    let signer = &world().signer;
    let skeleton = &signer.skeleton;
    let map = |pairs: &[(&str, &str)]| pairs.iter().map(|(a, b)| ((*a).to_owned(), (*b).to_owned())).collect();
    let told =
        |pairs: &[(&str, &str)]| Humanoid::new(skeleton, &map(pairs), Axes::OURS, signer).unwrap_err().to_string();
    assert_eq!(told(&[("Hips", "Pelvis")]), "the file's skeleton has no joint `Pelvis`");
    assert_eq!(told(&[("Hip", "Hips")]), "our skeleton has no joint `Hip`");
    assert!(told(&[("Hips", "Hips")]).contains("make neither a body"));
    let clip = any_clip().new_tree(&mut Default::default()).unwrap().current();
    let humanoid = Humanoid::new(skeleton, &recognise(skeleton).joints, Axes::OURS, signer).unwrap();
    let late = Options { skip_frames: 1000, ..options(Mode::Directions) };
    assert!(retarget(&clip, &humanoid, signer, &late).unwrap_err().to_string().contains("no frame is left"));
}
