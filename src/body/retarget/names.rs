//! Which joint of a stranger's skeleton is which of ours, by its name and its place in the tree.
//!
//! Every program names joints in its own way: `mixamorig:LeftForeArm`, `lForeArm`, `CC_Base_L_Forearm`, `lowerarm_l`,
//! `lowerarm01.L`, `J_Bip_L_LowerArm`, `leftLowerArm`, `LeftElbow`. A name is taken apart into words; which side, which
//! digit and which part they say is looked up. Trunk and neck are read from the tree: what lies between hips and head.

use crate::motion::skeleton::{JointId, Skeleton};
use std::collections::BTreeMap;

/// What was recognised.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Recognised {
    /// Whose names they are, as far as that can be told: `Mixamo`, `Daz`, `Character Creator`, `Unreal`, `VRM`,
    /// `MakeHuman`, `CMU`, or `other`.
    pub convention: &'static str,
    /// Our joint's name (Mixamo's without prefix) and theirs.
    pub joints: BTreeMap<String, String>,
    /// Their joints that are none of ours, in their order.
    pub unknown: Vec<String>,
}

/// Recognises the joints of a skeleton.
///
/// ```
/// use chereme::{body::retarget::names::recognise, motion::skeleton::Skeleton};
/// let rig = Skeleton::from_json(chereme::avatar::SKELETON).unwrap();
/// let own = recognise(&rig);
/// assert_eq!(own.joints["LeftHandIndex2"], "LeftHandIndex2");
/// assert!(own.unknown.iter().all(|name| name.contains("Twist")), "{:?}", own.unknown);
/// ```
pub fn recognise(skeleton: &Skeleton) -> Recognised {
    let names: Vec<Name> = skeleton.joints().iter().map(|joint| Name::of(&joint.name)).collect();
    let style = Style::of(&names);
    let mut joints: BTreeMap<String, JointId> = BTreeMap::new();
    for (id, name) in skeleton.ids().zip(&names) {
        if let Some(ours) = name.limb(&style).or_else(|| name.middle()) {
            joints.entry(ours).or_insert(id);
        }
    }
    number_thumbs(&names, skeleton, &mut joints);
    trunk(skeleton, &names, &mut joints);
    let unknown = skeleton.ids().filter(|id| joints.values().all(|known| known != id));
    Recognised {
        convention: convention(skeleton),
        unknown: unknown.map(|id| skeleton[id].name.clone()).collect(),
        joints: joints.into_iter().map(|(ours, id)| (ours, skeleton[id].name.clone())).collect(),
    }
}

/// A joint's name taken apart.
struct Name {
    /// `Left` or `Right`, where it says one.
    side: Option<&'static str>,
    /// Lower case, without side, prefix and numbers.
    words: Vec<String>,
    /// The numbers in it, in order.
    numbers: Vec<u32>,
}

/// Prefixes that say whose joint it is, not which.
const PREFIXES: [&str; 9] = ["mixamorig", "mixamo", "bip", "valvebiped", "cc", "base", "j", "jbip", "def"];
/// Words after which a joint is a helper beside the bone.
const HELPERS: [&str; 17] = [
    "twist",
    "roll",
    "share",
    "end",
    "tip",
    "nub",
    "site",
    "effector",
    "ik",
    "breast",
    "ribs",
    "cloth",
    "metatarsal",
    "joint",
    "socket",
    "helper",
    "weapon",
];

impl Name {
    fn of(text: &str) -> Name {
        // `mixamorig:Hips`, `Armature|Hips`.
        let text = text.rsplit([':', '|']).next().unwrap_or(text);
        let (mut side, mut words, mut numbers) = (None, Vec::new(), Vec::new());
        for (at, word) in pieces(text).into_iter().enumerate() {
            match word.to_lowercase().as_str() {
                "l" | "left" => side = side.or(Some("Left")),
                "r" | "right" => side = side.or(Some("Right")),
                "c" | "center" => {}
                digits if digits.bytes().all(|b| b.is_ascii_digit()) => numbers.extend(digits.parse::<u32>().ok()),
                prefix if at < 2 && words.is_empty() && PREFIXES.contains(&prefix) => {}
                other => words.push(other.to_owned()),
            }
        }
        Name { side, words, numbers }
    }

    fn has(&self, any: &[&str]) -> bool {
        self.words.iter().any(|word| any.contains(&word.as_str()))
    }

    /// Whether it is a joint beside the bones.
    fn is_helper(&self) -> bool {
        self.has(&HELPERS) || self.words.iter().any(|w| w.ends_with("twist") || w.ends_with("joint"))
    }

    /// Our name of a joint of an arm, a hand or a leg.
    fn limb(&self, style: &Style) -> Option<String> {
        let side = self.side.filter(|_| !self.is_helper())?;
        if let Some(digit) = self.digit() {
            return (!self.has(&["toe", "foot"]))
                .then(|| self.phalanx().map(|n| format!("{side}Hand{digit}{n}")))
                .flatten();
        }
        let joined: String = self.words.concat();
        let part = match joined.as_str() {
            "clavicle" | "collar" | "collarbone" => "Shoulder",
            "shoulder" | "shldr" if style.shoulder_is_upper_arm => "Arm",
            "shoulder" if self.numbers.is_empty() => "Shoulder",
            "arm" | "upperarm" | "uparm" | "shldr" => "Arm",
            "forearm" | "lowerarm" | "lowarm" | "loarm" | "elbow" => "ForeArm",
            "hand" | "wrist" => "Hand",
            "upleg" | "upperleg" | "thigh" => "UpLeg",
            "hip" if style.hip_is_upper_leg => "UpLeg",
            "leg" if style.has_thigh => "Leg",
            "lowerleg" | "lowleg" | "loleg" | "calf" | "shin" | "knee" => "Leg",
            "foot" | "ankle" => "Foot",
            "toebase" | "toe" | "toes" | "ball" | "forefoot" if self.numbers.is_empty() => "ToeBase",
            "eye" => "Eye",
            _ => return None,
        };
        // Of a bone in several pieces (`upperarm01`, `upperarm02`) the first is the joint.
        self.numbers.first().is_none_or(|n| *n <= 1).then(|| format!("{side}{part}"))
    }

    /// The digit that it belongs to; MakeHuman numbers them from the thumb.
    fn digit(&self) -> Option<&'static str> {
        const DIGITS: [(&str, &[&str]); 5] = [
            ("Thumb", &["thumb"]),
            ("Index", &["index", "pointer"]),
            ("Middle", &["middle", "mid"]),
            ("Ring", &["ring"]),
            ("Pinky", &["pinky", "little", "small"]),
        ];
        if self.has(&["finger"])
            && let [digit, _] = self.numbers[..]
        {
            return DIGITS.get(digit.checked_sub(1)? as usize).map(|d| d.0);
        }
        let short = self.words.len() <= 2 || self.has(&["hand"]);
        DIGITS.iter().find(|(_, words)| short && self.has(words)).map(|d| d.0)
    }

    /// The joint's number in its digit, from the hand: 1 to 3.
    fn phalanx(&self) -> Option<u32> {
        if self.has(&["proximal", "prox"]) {
            return Some(1);
        }
        if self.has(&["intermediate", "inter"]) {
            return Some(2);
        }
        if self.has(&["distal", "dist"]) {
            return Some(3);
        }
        self.numbers.last().copied().filter(|n| (1..=3).contains(n) && !self.has(&["metacarpal"]))
    }

    /// Our name of hips or head; the trunk between them is read from the tree.
    fn middle(&self) -> Option<String> {
        let alone = self.side.is_none() && !self.is_helper();
        let joined: String = self.words.concat();
        match joined.as_str() {
            "hips" | "hip" | "pelvis" if alone => Some("Hips".into()),
            "head" if alone => Some("Head".into()),
            _ => None,
        }
    }
}

/// The words and numbers of a name: at capitals, digits and whatever is neither.
fn pieces(text: &str) -> Vec<String> {
    let mut pieces: Vec<String> = Vec::new();
    let mut before = ' ';
    for c in text.chars() {
        let begins = !c.is_alphanumeric()
            || !before.is_alphanumeric()
            || (c.is_uppercase() && !before.is_uppercase())
            || c.is_ascii_digit() != before.is_ascii_digit();
        if c.is_alphanumeric() {
            match pieces.last_mut().filter(|_| !begins) {
                Some(piece) => piece.push(c),
                None => pieces.push(c.to_string()),
            }
        }
        before = c;
    }
    // `LHipJoint`: a side's letter before a word.
    let sided = |piece: String| {
        let letters: Vec<char> = piece.chars().collect();
        match letters[..] {
            [side @ ('L' | 'R'), second, third, ..] if second.is_uppercase() && third.is_lowercase() => {
                vec![side.to_string(), letters[1..].iter().collect()]
            }
            _ => vec![piece],
        }
    };
    pieces.into_iter().flat_map(sided).collect()
}

/// What a word means depends on what else the skeleton has.
struct Style {
    /// There is a collar too, or an elbow: `LeftShoulder` is the upper arm.
    shoulder_is_upper_arm: bool,
    /// There is a knee and no thigh: `LeftHip` is the upper leg.
    hip_is_upper_leg: bool,
    /// `LeftLeg` is the lower one where there is an upper one.
    has_thigh: bool,
}

impl Style {
    fn of(names: &[Name]) -> Style {
        let any = |words: &[&str]| names.iter().any(|n| n.side.is_some() && words.contains(&n.words.concat().as_str()));
        let thigh = any(&["upleg", "upperleg", "thigh"]);
        let upper_arm = any(&["arm", "upperarm", "uparm"]);
        Style {
            shoulder_is_upper_arm: !upper_arm && (any(&["clavicle", "collar", "collarbone", "elbow", "forearm"])),
            hip_is_upper_leg: !thigh,
            has_thigh: thigh || any(&["hip"]),
        }
    }
}

/// Thumbs whose joints are called metacarpal, proximal and distal: the metacarpal is the first of three.
fn number_thumbs(names: &[Name], skeleton: &Skeleton, joints: &mut BTreeMap<String, JointId>) {
    for (id, name) in skeleton.ids().zip(names) {
        let (Some(side), true) = (name.side, name.digit() == Some("Thumb") && name.has(&["metacarpal"])) else {
            continue;
        };
        let key = |n: u32| format!("{side}HandThumb{n}");
        if let (Some(proximal), None) = (joints.get(&key(1)).copied(), joints.get(&key(2))) {
            joints.insert(key(2), proximal);
            joints.insert(key(1), id);
        }
    }
}

/// Spine and neck: the joints between hips and head. Those up to where the arms begin are the spine: the first, the middle
/// and the last of them; the first of the others that has a length of its own is the neck.
fn trunk(skeleton: &Skeleton, names: &[Name], joints: &mut BTreeMap<String, JointId>) {
    let root = JointId(0);
    let has_legs = joints.contains_key("LeftUpLeg") || joints.contains_key("RightUpLeg");
    let hips = match joints.get("Hips").copied() {
        // A pelvis below a joint that is called hip: the root of both, trunk and legs, moves the body.
        Some(hips) => Some(hips),
        None if has_legs => Some(root),
        None => None,
    };
    let Some(head) = joints.get("Head").copied().or_else(|| last_before_face(skeleton, names)) else { return };
    let chain: Vec<JointId> = above(skeleton, head);
    let hips = hips.filter(|hips| chain.contains(hips)).or(has_legs.then_some(root));
    if let Some(hips) = hips {
        joints.insert("Hips".into(), hips);
    }
    joints.insert("Head".into(), head);
    let mut between: Vec<JointId> = chain.into_iter().take_while(|id| Some(*id) != hips).collect();
    between.reverse();
    let of_arms = ["LeftShoulder", "RightShoulder", "LeftArm", "RightArm"];
    let arm = of_arms.iter().find_map(|name| joints.get(*name));
    let carries = |id: &JointId| arm.is_some_and(|arm| above(skeleton, *arm).contains(id));
    let chest = between.iter().rposition(carries);
    let named_neck = |id: &JointId| names[id.index()].has(&["neck"]);
    let spine_ends = chest.map_or_else(|| between.iter().position(named_neck).unwrap_or(between.len()), |at| at + 1);
    let (spine, neck) = between.split_at(spine_ends);
    let spine: &[JointId] = match spine {
        // Where the joint that carries the arms is called neck, the spine ends before it.
        [lower @ .., last] if !lower.is_empty() && named_neck(last) => lower,
        all => all,
    };
    let picks: &[(&str, usize)] = match spine.len() {
        0 => &[],
        1 => &[("Spine", 0)],
        2 => &[("Spine", 0), ("Spine2", 1)],
        n => &[("Spine", 0), ("Spine1", n / 2), ("Spine2", n - 1)],
    };
    for (name, at) in picks {
        joints.insert((*name).into(), spine[*at]);
    }
    let has_length = |id: &&JointId| skeleton.offset(**id).length() > 1e-6;
    if let Some(neck) = neck.iter().find(has_length).or(neck.first()) {
        joints.insert("Neck".into(), *neck);
    }
}

/// The joints above one, the nearest first.
fn above(skeleton: &Skeleton, joint: JointId) -> Vec<JointId> {
    std::iter::successors(skeleton[joint].parent, |id| skeleton[*id].parent).collect()
}

/// The last joint of the neck, where none is called head.
fn last_before_face(skeleton: &Skeleton, names: &[Name]) -> Option<JointId> {
    skeleton.ids().filter(|id| names[id.index()].has(&["neck"])).last()
}

/// Whose names these are.
fn convention(skeleton: &Skeleton) -> &'static str {
    let any = |test: &dyn Fn(&str) -> bool| skeleton.joints().iter().any(|joint| test(&joint.name));
    match () {
        () if any(&|n| n.starts_with("CC_Base_")) => "Character Creator",
        () if any(&|n| n.starts_with("J_Bip_") || n == "leftUpperArm") => "VRM",
        () if any(&|n| n.starts_with("mixamorig")) => "Mixamo",
        () if any(&|n| n == "LHipJoint" || n == "LowerBack") => "CMU",
        () if any(&|n| n == "lShldr" || n == "rForeArm") => "Daz",
        () if any(&|n| n == "lowerarm_l" || n == "spine_01") => "Unreal",
        () if any(&|n| n == "lowerarm01.L" || n == "UpArm_L") => "MakeHuman",
        () if any(&|n| n == "LeftHandIndex1" || n == "RightHandIndex1" || n == "LeftForeArm") => "Mixamo",
        () => "other",
    }
}
