//! A stranger's skeleton beside ours: which joints are which, and how its rest pose lies to our T-pose.
//!
//! At rest our rig stands in a T-pose with identity rotations. A file's joints rest with identity rotations too, but in any
//! pose: arms down, forward, all bones along one axis, the body lying. For each bone there is one rotation that takes our bone at rest to
//! theirs at rest; with it a model rotation of the one becomes one of the other.
//!
//! # Conventions
//! *Ours* and *theirs* are model rotations of corresponding joints: `ours = turn · theirs · lie`, `turn` from the file's
//! axes to ours.

use super::Coverage;
use super::axes::Axes;
use crate::body::signer::Signer;
use crate::diagnostics::Error;
use crate::motion::pose::LocalPose;
use crate::motion::rotation::{frame_to_frame, perpendicular, shortest_arc, unit};
use crate::motion::skeleton::{Joint, JointId, Skeleton};
use crate::phonology::{Digit, Side};
use glam::{DMat3, DQuat, DVec3};
use std::collections::BTreeMap;
use std::sync::Arc;

/// Where a bone ends.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum End {
    /// At a joint.
    Joint(JointId),
    /// At the tail of its last joint.
    Tail,
}

/// A bone that both skeletons have.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Bone {
    pub ours: JointId,
    pub our_end: End,
    pub theirs: JointId,
    pub their_end: End,
    /// Takes our bone at rest to theirs at rest.
    pub lie: DQuat,
    /// Whether its direction is carried over; not that of hips, which are turned as a whole, nor of a bone without length.
    pub directed: bool,
}

/// A stranger's skeleton with its joints found.
#[derive(Debug, Clone)]
pub struct Humanoid {
    pub(super) skeleton: Arc<Skeleton>,
    pub(super) turn: DQuat,
    /// In the order of our joints.
    pub(super) bones: Vec<Bone>,
    of_ours: Vec<Option<usize>>,
    covers: Coverage,
}

/// Our bones along which directions are carried over, with what each ends at where that is mapped; else the next in the
/// list of those that begin with the same joint.
const ENDS: [(&str, &[&str]); 12] = [
    ("Hips", &["Spine", "Spine2", "Neck", "Head"]),
    ("Spine", &["Spine1", "Spine2", "Neck", "Head"]),
    ("Spine1", &["Spine2", "Neck", "Head"]),
    ("Spine2", &["Neck", "Head"]),
    ("Neck", &["Head"]),
    ("Shoulder", &["Arm"]),
    ("Arm", &["ForeArm"]),
    ("ForeArm", &["Hand"]),
    ("Hand", &["HandMiddle1", "HandRing1", "HandIndex1"]),
    ("UpLeg", &["Leg"]),
    ("Leg", &["Foot"]),
    ("Foot", &["ToeBase"]),
];

impl Humanoid {
    /// Finds the bones of a skeleton by the names of its joints, ours first.
    ///
    /// # Errors
    /// A joint that one of the two lacks; neither a body nor a hand among them.
    pub fn new(
        skeleton: &Arc<Skeleton>,
        joints: &BTreeMap<String, String>,
        axes: Axes,
        signer: &Signer,
    ) -> Result<Humanoid, Error> {
        Humanoid::standing(skeleton, &LocalPose::rest(skeleton), joints, axes, signer)
    }

    /// The same where another pose than the rest is the one in which the body stands: some files rest with all bones along one
    /// axis, and begin with a T-pose. How bones are rolled is read from that pose.
    ///
    /// # Errors
    /// Those of [`Humanoid::new`]; a pose of another skeleton.
    pub fn standing(
        skeleton: &Arc<Skeleton>,
        pose: &LocalPose,
        joints: &BTreeMap<String, String>,
        axes: Axes,
        signer: &Signer,
    ) -> Result<Humanoid, Error> {
        if pose.rotations.len() != skeleton.len() {
            return Err(Error::new("the pose has another skeleton"));
        }
        let model = pose.to_model(skeleton);
        let joint = |(id, joint): (JointId, &Joint)| Joint {
            rest_model: model.position(id),
            tail_model: model.point(id, joint.tail_model - joint.rest_model),
            ..joint.clone()
        };
        let stood = Skeleton::new(skeleton.ids().zip(skeleton.joints()).map(joint).collect())?;
        let mut map = vec![None; signer.skeleton.len()];
        for (ours, theirs) in joints {
            let missing = |whose: &str, name: &str| Error::new(format!("{whose} skeleton has no joint `{name}`"));
            let our = signer.skeleton.find(ours).ok_or_else(|| missing("our", ours))?;
            let their = skeleton.find(theirs).ok_or_else(|| missing("the file's", theirs))?;
            map[our.index()] = Some(their);
        }
        let covers = coverage(&map, signer);
        if !covers.body && covers.arms == [false; 2] && covers.hands == [false; 2] {
            let message = "the joints make neither a body (hips, spine, head), nor an arm, nor a hand with four digits";
            return Err(Error::new(message));
        }
        let lies = Lies::new(&stood, &map, axes, signer);
        // From the pose in which the body stands back to its rest.
        let rested = |bone: Bone| Bone { lie: unit(model.rotation(bone.theirs).conjugate() * bone.lie), ..bone };
        let bones: Vec<Bone> = signer.skeleton.ids().filter_map(|our| lies.bone(our)).map(rested).collect();
        let mut of_ours = vec![None; signer.skeleton.len()];
        for (at, bone) in bones.iter().enumerate() {
            of_ours[bone.ours.index()] = Some(at);
        }
        Ok(Humanoid { skeleton: skeleton.clone(), turn: axes.turn(), bones, of_ours, covers })
    }

    /// The skeleton.
    pub fn skeleton(&self) -> &Arc<Skeleton> {
        &self.skeleton
    }

    /// What of a body it has.
    pub fn covers(&self) -> Coverage {
        self.covers
    }

    /// The bone that begins at one of our joints.
    pub(super) fn bone(&self, ours: JointId) -> Option<&Bone> {
        self.of_ours[ours.index()].map(|at| &self.bones[at])
    }
}

/// What of a body is mapped.
fn coverage(map: &[Option<JointId>], signer: &Signer) -> Coverage {
    let has = |id: JointId| map[id.index()].is_some();
    let named = |name: &str| signer.skeleton.find(name).is_some_and(has);
    let sides = [Side::Left, Side::Right];
    let arm = |side: Side| {
        let arm = signer.arm(side);
        has(arm.upper) && has(arm.fore) && has(arm.hand)
    };
    let hand = |side: Side| {
        let whole = |digit: &&Digit| signer.hand(side).of_digit(**digit).iter().all(|joint| has(*joint));
        has(signer.arm(side).hand) && Digit::ALL.iter().filter(whole).count() >= 4
    };
    let spine = ["Spine", "Spine1", "Spine2"].iter().any(|name| named(name));
    Coverage { body: named("Hips") && spine && named("Head"), arms: sides.map(arm), hands: sides.map(hand) }
}

/// The rest poses of both skeletons side by side.
struct Lies<'a> {
    theirs: &'a Skeleton,
    ours: &'a Skeleton,
    map: &'a [Option<JointId>],
    signer: &'a Signer,
    /// Takes our body at rest to theirs.
    body: DQuat,
    /// The same of each hand, left and right.
    hands: [Option<DQuat>; 2],
}

impl<'a> Lies<'a> {
    fn new(theirs: &'a Skeleton, map: &'a [Option<JointId>], axes: Axes, signer: &'a Signer) -> Lies<'a> {
        let ours = &*signer.skeleton;
        let mut lies = Lies { theirs, ours, map, signer, body: DQuat::IDENTITY, hands: [None; 2] };
        lies.body = lies.body_at_rest().unwrap_or(axes.turn().conjugate());
        lies.hands = [Side::Left, Side::Right].map(|side| lies.hand_at_rest(side));
        lies
    }

    fn find(&self, name: &str) -> Option<(JointId, JointId)> {
        let ours = self.ours.find(name)?;
        self.map[ours.index()].map(|theirs| (ours, theirs))
    }

    fn between(&self, from: &str, to: &str) -> Option<DVec3> {
        let ((_, from), (_, to)) = self.find(from).zip(self.find(to))?;
        let way = self.theirs[to].rest_model - self.theirs[from].rest_model;
        (way.length() > 1e-6).then_some(way)
    }

    /// Left, up and front of their body at rest.
    fn body_at_rest(&self) -> Option<DQuat> {
        let across = ["UpLeg", "Arm", "Shoulder"];
        let mut sides = across.iter().filter_map(|part| self.between(&format!("Right{part}"), &format!("Left{part}")));
        let left = sides.next()?.normalize();
        let up = ["Head", "Neck", "Spine2", "Spine1"].iter().find_map(|top| self.between("Hips", top));
        let up = up.or_else(|| self.between("Spine", "Head")).or_else(|| self.between("Spine", "Neck"))?;
        // The line of the hips is kept, what leans is the trunk.
        let up = (up - left * up.dot(left)).try_normalize()?;
        Some(DQuat::from_mat3(&DMat3::from_cols(left, up, left.cross(up))).normalize())
    }

    fn hand_at_rest(&self, side: Side) -> Option<DQuat> {
        let knuckles = |digits: [Digit; 3], of: &dyn Fn(JointId) -> Option<DVec3>| {
            let hand = of(self.signer.arm(side).hand)?;
            let [index, middle, pinky] = digits.map(|digit| of(self.signer.hand(side).of_digit(digit)[0]));
            hand_axes(side, hand, middle?, index? - pinky?)
        };
        let ours = |joint: JointId| Some(self.ours[joint].rest_model);
        let theirs = |joint: JointId| self.map[joint.index()].map(|theirs| self.theirs[theirs].rest_model);
        // A hand without a little finger, or without an index.
        let choices = [
            [Digit::Index, Digit::Middle, Digit::Pinky],
            [Digit::Index, Digit::Middle, Digit::Ring],
            [Digit::Middle, Digit::Ring, Digit::Pinky],
        ];
        let pair = |digits: [Digit; 3]| knuckles(digits, &theirs).zip(knuckles(digits, &ours));
        let (theirs, ours) = choices.into_iter().find_map(pair)?;
        Some(frame_to_frame(ours, theirs))
    }

    fn bone(&self, ours: JointId) -> Option<Bone> {
        let theirs = self.map[ours.index()]?;
        let name = self.ours[ours].name.as_str();
        let (side, part) = match name {
            _ if name.starts_with("Left") => (Some(Side::Left), &name[4..]),
            _ if name.starts_with("Right") => (Some(Side::Right), &name[5..]),
            _ => (None, name),
        };
        let (our_end, their_end) = self.ends(ours, theirs, side, part);
        let our_way = end_at_rest(self.ours, ours, our_end) - self.ours[ours].rest_model;
        let their_way = end_at_rest(self.theirs, theirs, their_end) - self.theirs[theirs].rest_model;
        let base = self.base(side, part);
        let has_length = our_way.length() > 1e-6 && their_way.length() > 1e-6;
        let directed = has_length && part != "Hips" && part != "Eye" && !(part == "Head" && their_end == End::Tail);
        let lie = match part {
            "HandThumb1" | "HandThumb2" | "HandThumb3" if has_length => {
                self.thumb(side?, ours, base, our_way, their_way)
            }
            _ if directed => {
                let along = base * our_way;
                let fallback = base * DVec3::Z;
                unit(shortest_arc(along, their_way, perpendicular(fallback, along.normalize())) * base)
            }
            _ => base,
        };
        Some(Bone { ours, our_end, theirs, their_end, lie, directed })
    }

    /// What a bone is turned with before its own direction counts: the hand for its digits, else the body.
    fn base(&self, side: Option<Side>, part: &str) -> DQuat {
        match side {
            Some(side) if part.starts_with("Hand") => self.hands[side as usize].unwrap_or_else(|| {
                let prefix = self.signer.arm(side).fore;
                // A hand without knuckles lies as its forearm does.
                let fore = self.map[prefix.index()].and_then(|_| self.bone(prefix));
                fore.map_or(self.body, |bone| bone.lie)
            }),
            _ => self.body,
        }
    }

    /// Where the bone ends in each skeleton.
    fn ends(&self, ours: JointId, theirs: JointId, side: Option<Side>, part: &str) -> (End, End) {
        let prefix = match side {
            Some(Side::Left) => "Left",
            Some(Side::Right) => "Right",
            None => "",
        };
        let listed = ENDS.iter().find(|(begin, _)| *begin == part).map_or(&[][..], |(_, ends)| *ends);
        let mut next: Vec<String> = listed.iter().map(|end| format!("{prefix}{end}")).collect();
        if let Some(number) = part.strip_prefix("Hand").and_then(|digit| digit.chars().last()?.to_digit(10)) {
            let stem = &self.ours[ours].name[..self.ours[ours].name.len() - 1];
            next.push(format!("{stem}{}", number + 1));
        }
        let apart = |end: JointId| self.theirs[end].rest_model.distance(self.theirs[theirs].rest_model) > 1e-6;
        let end = next.iter().filter_map(|name| self.find(name)).find(|(_, end)| apart(*end));
        match end {
            Some((our_end, their_end)) => (End::Joint(our_end), End::Joint(their_end)),
            None => (End::Tail, End::Tail),
        }
    }

    /// A thumb that rests along the fingers (as sensors write it) has its pad where the palm is; else what leads its
    /// direction over leads its pad over.
    fn thumb(&self, side: Side, ours: JointId, hand: DQuat, our_way: DVec3, their_way: DVec3) -> DQuat {
        const ALONG: f64 = 0.35;
        let along = their_way.normalize();
        let fingers = hand * (self.signer.arm(side).rest_fingers());
        if along.angle_between(fingers) > ALONG {
            return unit(shortest_arc(hand * our_way, their_way, hand * DVec3::Y) * hand);
        }
        let (bone, pad) = (our_way.normalize(), self.signer.hand(side).thumb_pad_at_rest(ours));
        frame_to_frame((bone, perpendicular(pad, bone)), (along, perpendicular(hand * -DVec3::Y, along)))
    }
}

/// Where a bone ends at rest.
pub(super) fn end_at_rest(skeleton: &Skeleton, joint: JointId, end: End) -> DVec3 {
    match end {
        End::Joint(end) => skeleton[end].rest_model,
        End::Tail => skeleton[joint].tail_model,
    }
}

/// Along the hand and out of its palm: from the wrist, the middle knuckle, and the way from the little finger's side to the
/// index's.
fn hand_axes(side: Side, wrist: DVec3, middle: DVec3, radial: DVec3) -> Option<(DVec3, DVec3)> {
    let along = (middle - wrist).try_normalize()?;
    // On a left hand at rest, along +X, the thumb's side is +Z, and the palm looks to −Y.
    let palm = (along.cross(radial) * side.sign()).try_normalize()?;
    Some((along, palm))
}
