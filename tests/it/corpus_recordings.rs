//! Small recordings for tests of corpora: our rig, waving, as BVH.

use chereme::avatar;
use chereme::format::bvh;
use chereme::motion::clip::{Clip, Frame};
use chereme::motion::pose::LocalPose;
use chereme::motion::skeleton::Skeleton;
use chereme::time::Fps;
use glam::{DQuat, DVec3};
use std::sync::{Arc, LazyLock};

pub static RIG: LazyLock<Arc<Skeleton>> = LazyLock::new(|| Arc::new(Skeleton::from_json(avatar::SKELETON).unwrap()));

/// A wave of the right arm and fingers, `seed` making each another.
pub fn wave(frames: usize, seed: usize) -> Clip {
    let joints = ["RightArm", "RightForeArm", "RightHand", "RightHandIndex1", "RightHandMiddle1"];
    let ids = joints.map(|name| RIG.joint(name).unwrap());
    let frame = |at: usize| {
        let mut pose = LocalPose::rest(&RIG);
        for (n, id) in ids.iter().enumerate() {
            let phase = at as f64 * 0.1 + n as f64 + seed as f64 * 0.7;
            pose.set(*id, DQuat::from_rotation_z(0.3 * phase.sin()) * DQuat::from_rotation_y(0.2 * phase.cos()));
        }
        pose.root_model += DVec3::X * 0.01 * (at as f64 * 0.05).sin();
        Frame { pose, weights: vec![] }
    };
    Clip::new(RIG.clone(), Fps::new(60.0).unwrap(), Arc::new(vec![]), (0..frames).map(frame).collect()).unwrap()
}

/// The same as a file.
pub fn wave_bvh(frames: usize, seed: usize) -> String {
    bvh::write(&wave(frames, seed), &bvh::Options::default()).unwrap()
}

/// Right hand alone, in millimetres.
pub fn hand_bvh(frames: usize) -> String {
    let bone = |name: &str, depth: usize, offset: &str| {
        let pad = "  ".repeat(depth);
        format!("{pad}JOINT {name}\n{pad}{{\n{pad}OFFSET {offset}\n{pad}CHANNELS 3 Zrotation Xrotation Yrotation\n")
    };
    let mut text = "HIERARCHY\nROOT RightHand\n{\nOFFSET 0 0 0\n\
                    CHANNELS 6 Xposition Yposition Zposition Zrotation Xrotation Yrotation\n"
        .to_owned();
    for (at, finger) in ["Thumb", "Index", "Middle", "Ring", "Pinky"].iter().enumerate() {
        text += &bone(&format!("RightHand{finger}1"), 1, &format!("{} 0 -80", at * 15));
        text += &bone(&format!("RightHand{finger}2"), 2, "0 0 -40");
        text += &bone(&format!("RightHand{finger}3"), 3, "0 0 -25");
        text += "End Site\n{\nOFFSET 0 0 -20\n}\n}\n}\n}\n";
    }
    text += &format!("}}\nMOTION\nFrames: {frames}\nFrame Time: 0.02\n");
    for at in 0..frames {
        let row: Vec<String> = (0..51).map(|c| format!("{:.3}", 5.0 * ((at + c) as f64 * 0.1).sin())).collect();
        text += &(row.join(" ") + "\n");
    }
    text
}
