//! The signer: a rig with its arms, trunk, head and eyes found, and how it stands at rest.

use super::arm::ArmRig;
use super::hand::HandRig;
use super::landmarks::{ContactPoint, Landmarks};
use super::solid::Solid;
use crate::diagnostics::Error;
use crate::motion::arm::orient;
use crate::motion::pose::{LocalPose, ModelPose};
use crate::motion::skeleton::{JointId, Skeleton};
use crate::phonology::Side;
use crate::phonology::handshape::HandAngles;
use glam::{DQuat, DVec3, EulerRot};
use std::sync::Arc;

/// Everything of a body that signing needs.
#[derive(Debug, Clone)]
pub struct Signer {
    /// The joints.
    pub skeleton: Arc<Skeleton>,
    /// Names of the face morphs, in the order of a clip's weights.
    pub morphs: Arc<Vec<String>>,
    /// Named places on the skin.
    pub landmarks: Landmarks,
    /// The room that trunk and head take up.
    pub solid: Solid,
    /// How the signer stands before and after signing, where that was captured (Naert et al. 2021, §4.2: neutral poses from
    /// the data); made up where it was not.
    pub resting: Option<LocalPose>,
    arms: [ArmRig; 2],
    hands: [HandRig; 2],
    spine: Vec<JointId>,
    neck: JointId,
    head: JointId,
    eyes: [Option<JointId>; 2],
}

/// Shoulders at rest hang a little lower than in the rig's T-pose, radians.
const SHOULDER_AT_REST: f64 = -4.0 * std::f64::consts::PI / 180.0;

/// Turns of head, trunk or eyes: pitch (+ forward or down), yaw (+ left), roll (+ left), radians.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Turn {
    /// Forward or down.
    pub pitch: f64,
    /// To the signer's left.
    pub yaw: f64,
    /// Tilted to the signer's left.
    pub roll: f64,
}

impl Turn {
    /// A share of the turn, as a rotation (yaw, then pitch, then roll, each in the turned axes).
    pub fn rotation(self, share: f64) -> DQuat {
        DQuat::from_euler(EulerRot::YXZ, self.yaw * share, self.pitch * share, -self.roll * share)
    }

    /// Whether there is no turn.
    pub fn is_zero(self) -> bool {
        self == Turn::default()
    }
}

/// How a shoulder stands away from its rest, radians.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Shoulder {
    /// Up.
    pub raised: f64,
    /// Towards the front.
    pub forward: f64,
}

impl Shoulder {
    /// The turn of the clavicle.
    pub fn rotation(self, side: Side) -> DQuat {
        DQuat::from_rotation_y(-self.forward * side.sign()) * DQuat::from_rotation_z(self.raised * side.sign())
    }

    /// Whether it is at rest.
    pub fn is_zero(self) -> bool {
        self == Shoulder::default()
    }
}

impl Signer {
    /// Finds the parts of a body.
    ///
    /// # Errors
    /// Names the joint that the rig lacks, or the landmark. Eyes may be missing.
    pub fn new(skeleton: Arc<Skeleton>, morphs: Vec<String>, landmarks: Landmarks) -> Result<Signer, Error> {
        let arms = [ArmRig::new(&skeleton, Side::Left)?, ArmRig::new(&skeleton, Side::Right)?];
        let hands = [HandRig::new(&skeleton, Side::Left)?, HandRig::new(&skeleton, Side::Right)?];
        let spine = ["Spine", "Spine1", "Spine2"].iter().map(|n| skeleton.joint(n)).collect::<Result<_, _>>()?;
        let (neck, head) = (skeleton.joint("Neck")?, skeleton.joint("Head")?);
        let eyes = [skeleton.find("LeftEye"), skeleton.find("RightEye")];
        let solid = Solid::new(&skeleton, &landmarks)?;
        Ok(Signer {
            skeleton,
            morphs: Arc::new(morphs),
            landmarks,
            solid,
            resting: None,
            arms,
            hands,
            spine,
            neck,
            head,
            eyes,
        })
    }

    /// An arm.
    pub fn arm(&self, side: Side) -> &ArmRig {
        match side {
            Side::Left => &self.arms[0],
            Side::Right => &self.arms[1],
        }
    }

    /// A hand.
    pub fn hand(&self, side: Side) -> &HandRig {
        match side {
            Side::Left => &self.hands[0],
            Side::Right => &self.hands[1],
        }
    }

    /// The head's joint.
    pub fn head(&self) -> JointId {
        self.head
    }

    /// Turns the trunk, spread over the spine.
    pub fn turn_torso(&self, turn: Turn, pose: &mut LocalPose) {
        let share = 1.0 / self.spine.len() as f64;
        for joint in &self.spine {
            pose.set(*joint, turn.rotation(share));
        }
    }

    /// Turns the head, two fifths of it in the neck.
    pub fn turn_head(&self, turn: Turn, pose: &mut LocalPose) {
        pose.set(self.neck, turn.rotation(0.4));
        pose.set(self.head, turn.rotation(0.6));
    }

    /// Pushes the head forward over the trunk, or back: the neck leans and the face stays upright. Radians of the neck.
    pub fn push_head(&self, angle: f64, pose: &mut LocalPose) {
        pose.set(self.neck, pose.rotation(self.neck) * DQuat::from_rotation_x(angle));
        pose.set(self.head, DQuat::from_rotation_x(-angle) * pose.rotation(self.head));
    }

    /// Turns the eyes.
    pub fn turn_eyes(&self, turn: Turn, pose: &mut LocalPose) {
        for joint in self.eyes.iter().flatten() {
            pose.set(*joint, turn.rotation(1.0));
        }
    }

    /// Moves a shoulder by the clavicle from where it rests; the arm hangs as it hung.
    pub fn move_shoulder(&self, side: Side, shoulder: Shoulder, pose: &mut LocalPose) {
        let arm = self.arm(side);
        let before = pose.rotation(arm.clavicle);
        let raised = Shoulder { raised: SHOULDER_AT_REST + shoulder.raised, ..shoulder }.rotation(side);
        pose.set(arm.clavicle, raised);
        pose.set(arm.upper, (raised.inverse() * before * pose.rotation(arm.upper)).normalize());
    }

    /// How the signer stands before and after signing: as captured ([`Signer::resting`]), else arms hanging, hands loose, `relaxed`
    /// fingers.
    pub fn neutral(&self, relaxed: &HandAngles) -> LocalPose {
        if let Some(captured) = &self.resting {
            return captured.clone();
        }
        let mut pose = LocalPose::rest(&self.skeleton);
        for side in [Side::Left, Side::Right] {
            self.move_shoulder(side, Shoulder::default(), &mut pose);
            self.hand(side).apply(relaxed, &mut pose);
        }
        let model = pose.to_model(&self.skeleton);
        for side in [Side::Left, Side::Right] {
            let arm = self.arm(side);
            let out = side.sign();
            // Hanging a little away from the body, the elbow a little bent, the palm to the thigh.
            let shoulder = model.position(arm.upper);
            let elbow = shoulder + DVec3::new(0.16 * out, -0.98, -0.06).normalize() * arm.upper_m;
            let wrist = elbow + DVec3::new(0.06 * out, -0.95, 0.30).normalize() * arm.fore_m;
            let fingers = DVec3::new(-0.02 * out, -0.97, 0.24);
            let hand = arm.hand_rotation(fingers, DVec3::new(-out, -0.1, -0.25)).unwrap_or(DQuat::IDENTITY);
            let parent = model.rotation(arm.clavicle);
            let solved = orient(&arm.rest, parent, [shoulder, elbow, wrist], hand, None);
            arm.write(&solved, &mut pose);
        }
        pose
    }

    /// Where a contact point of a hand is in the hand's own axes, from the wrist, metres, for the fingers of a pose.
    ///
    /// A point of the arm above the wrist is as far from the wrist as at rest.
    pub fn in_hand(&self, side: Side, contact: &ContactPoint, pose: &LocalPose) -> DVec3 {
        let (skeleton, hand) = (&self.skeleton, self.arm(side).hand);
        let one = |joint: JointId, offset: DVec3| {
            let (mut point, mut at) = (offset, joint);
            while at != hand {
                match skeleton[at].parent {
                    Some(parent) => {
                        point = skeleton.offset(at) + pose.rotation(at) * point;
                        at = parent;
                    }
                    None => return skeleton[joint].rest_model + offset - skeleton[hand].rest_model,
                }
            }
            point
        };
        let parts = contact.parts();
        parts.iter().map(|part| one(part.joint, part.offset)).sum::<DVec3>() / parts.len() as f64
    }

    /// Where the eyes are, model space: between them, or the head's joint where the rig has none.
    pub fn gaze_origin(&self, model: &ModelPose) -> DVec3 {
        match self.eyes {
            [Some(l), Some(r)] => (model.position(l) + model.position(r)) / 2.0,
            _ => model.position(self.head),
        }
    }
}
