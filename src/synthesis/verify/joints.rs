//! Joints in every frame: numbers, bones, limits, jumps.

use super::Checking;
use super::finding::{Finding, Kind, Worst};
use crate::body::arm::WristLimits;
use crate::motion::arm::ArmAngles;
use crate::motion::clip::{Clip, Frame};
use crate::motion::pose::LocalPose;
use crate::motion::rotation::{angle_between, swing_twist, to_vector, twist_angle};
use crate::phonology::handshape::{HandAngles, HandLimits};
use crate::phonology::{Digit, Side};
use crate::time::{FrameIndex, Seconds};

const DEGREE: f64 = std::f64::consts::PI / 180.0;
/// How much a bone's length may differ, metres: what is computed in `f64` differs by far less.
const BONE: f64 = 1e-5;
/// How far an angle may pass its limit before it is told.
const SLACK: f64 = 1.0 * DEGREE;
/// How far an elbow may turn about other axes than its hinge: a nearly straight arm takes its roll from the frame before.
const OFF_HINGE: f64 = 1.5 * DEGREE;
/// How far an elbow flexes (facts/phonology.md §1).
const FLEXED: f64 = 150.0 * DEGREE;
/// How far a finger joint may be turned as no hand can turn it: on the way between two shapes some degrees come of easing spread and
/// flexion as one turn, and nobody sees them.
const TWISTED: f64 = 5.0 * DEGREE;
/// How fast a joint may turn, a second: 40° a frame at 30 frames a second.
const TURNING: f64 = 40.0 * 30.0 * DEGREE;
const SIDES: [Side; 2] = [Side::Left, Side::Right];

/// The first frame that has a number that is none.
pub(super) fn not_finite(clip: &Clip) -> Option<Finding> {
    let bad = |frame: &Frame| {
        let joints = frame.pose.rotations.iter().filter(|q| !q.is_finite() || q.length_squared() < 1e-12).count();
        let root = usize::from(!frame.pose.root_model.is_finite());
        joints + root + frame.weights.iter().filter(|w| !w.is_finite()).count()
    };
    let mut all = clip.frames().iter().map(bad).enumerate();
    let (frame, count) = all.find(|(_, count)| *count > 0)?;
    let time = clip.fps().time_of(FrameIndex(frame));
    let what = "joints or weights of the face".to_owned();
    Some(Finding { kind: Kind::NotFinite, side: None, time, measured: count as f64, bound: 0.0, what })
}

impl Checking<'_> {
    pub(super) fn time_of(&self, frame: usize) -> Seconds {
        self.performance.track.clip.fps().time_of(FrameIndex(frame))
    }

    fn poses(&self) -> impl Iterator<Item = (usize, &LocalPose)> {
        self.performance.track.clip.frames().iter().map(|frame| &frame.pose).enumerate()
    }

    /// Bones whose length is not that of the skeleton.
    pub(super) fn bones(&self) -> Vec<Finding> {
        let skeleton = &self.signer.skeleton;
        let mut worst = Worst::default();
        for (number, frame) in self.frames.iter().enumerate() {
            for id in skeleton.ids() {
                let Some(parent) = skeleton[id].parent else { continue };
                let length = frame.position(id).distance(frame.position(parent));
                let off = (length - skeleton.offset(id).length()).abs();
                worst.look(off, BONE, number, || format!("from {} to {}", skeleton[parent].name, skeleton[id].name));
            }
        }
        worst.finding(Kind::BoneLength, None, |frame| self.time_of(frame)).into_iter().collect()
    }

    /// Elbows and wrists beyond their limits.
    pub(super) fn arms(&self) -> Vec<Finding> {
        let mut findings = Vec::new();
        for side in SIDES {
            let rig = self.signer.arm(side);
            let (mut elbow, mut wrist) = (Worst::default(), Worst::default());
            for (frame, pose) in self.poses() {
                let hinge = rig.rest.hinge();
                let bent = pose.rotation(rig.fore);
                let off = to_vector(swing_twist(bent, hinge).swing).length();
                elbow.look(off, OFF_HINGE, frame, || "turned about another axis than its own".into());
                let flexed = twist_angle(bent, hinge);
                elbow.look(-flexed, OFF_HINGE, frame, || "bent backwards".into());
                elbow.look(flexed, FLEXED + SLACK, frame, || "flexed".into());
                let angles = rig.rest.angles(pose.rotation(rig.hand));
                for (value, limit, way) in wrist_ways(&angles, &WristLimits::ANATOMICAL) {
                    wrist.look(value, limit + SLACK, frame, || way.to_owned());
                }
            }
            findings.extend(elbow.finding(Kind::Elbow, Some(side), |frame| self.time_of(frame)));
            findings.extend(wrist.finding(Kind::Wrist, Some(side), |frame| self.time_of(frame)));
        }
        findings
    }

    /// Fingers beyond their limits, and such as no hand can be turned to.
    pub(super) fn fingers(&self) -> Vec<Finding> {
        let mut findings = Vec::new();
        let limits = HandLimits::ANATOMICAL;
        let mut again = LocalPose::rest(&self.signer.skeleton);
        for side in SIDES {
            let rig = self.signer.hand(side);
            let (mut bent, mut twisted) = (Worst::default(), Worst::default());
            for (frame, pose) in self.poses() {
                let angles = rig.angles_of(pose);
                let (is, inside) = (angles.to_array(), limits.clamp(&angles).to_array());
                for (i, (is, inside)) in is.into_iter().zip(inside).enumerate() {
                    // Shown as the angle and the limit that it passes.
                    let (value, limit) = if is < inside { (-is, -inside) } else { (is, inside) };
                    bent.look(value, limit + SLACK, frame, || angle_name(i));
                }
                rig.apply(&angles, &mut again);
                for (i, joint) in rig.joints().into_iter().enumerate() {
                    let off = angle_between(pose.rotation(joint), again.rotation(joint));
                    twisted.look(off, TWISTED, frame, || format!("{} joint {}", Digit::ALL[i / 3].name(), i % 3 + 1));
                }
            }
            findings.extend(bent.finding(Kind::Finger, Some(side), |frame| self.time_of(frame)));
            findings.extend(twisted.finding(Kind::FingerTwist, Some(side), |frame| self.time_of(frame)));
        }
        findings
    }

    /// Joints that turn too far from a frame to the next.
    pub(super) fn jumps(&self) -> Vec<Finding> {
        let skeleton = &self.signer.skeleton;
        let most = (TURNING / self.performance.track.clip.fps().get()).min(std::f64::consts::PI);
        let mut worst = Worst::default();
        let frames = self.performance.track.clip.frames();
        for (number, pair) in frames.windows(2).enumerate() {
            for id in skeleton.ids() {
                let turn = angle_between(pair[0].pose.rotation(id), pair[1].pose.rotation(id));
                worst.look(turn, most, number + 1, || format!("{} from one frame to the next", skeleton[id].name));
            }
        }
        worst.finding(Kind::Jump, None, |frame| self.time_of(frame)).into_iter().collect()
    }
}

/// Each way that a wrist goes, how far it goes there, and its limit.
fn wrist_ways(angles: &ArmAngles, limits: &WristLimits) -> [(f64, f64, &'static str); 5] {
    [
        (angles.flexion, limits.flexion, "bent to the palm"),
        (-angles.flexion, limits.extension, "bent to the back of the hand"),
        (angles.radial, limits.radial, "bent to the thumb"),
        (-angles.radial, limits.ulnar, "bent to the little finger"),
        (angles.twist.abs(), limits.twist, "turned with the forearm"),
    ]
}

/// The name of an angle, in the order of [`HandAngles::to_array`].
fn angle_name(i: usize) -> String {
    const FINGER: [&str; 4] = ["knuckle", "spread", "middle joint", "last joint"];
    const THUMB: [&str; HandAngles::COUNT - 16] = ["sideways", "out of the palm", "pronation", "knuckle", "last joint"];
    match i.checked_sub(16) {
        None => format!("{} {}", Digit::FINGERS[i / 4].name(), FINGER[i % 4]),
        Some(i) => format!("thumb {}", THUMB[i]),
    }
}
