//! Which unit of length a file is in: a guess from the skeleton's size, for the caller to take or leave.

use super::data::Bvh;
use glam::DVec3;

/// A unit that makes the skeleton as large as a person.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct UnitProposal {
    /// Metres in one unit of the file.
    pub metres_per_unit: f64,
    /// The unit's name, for a message.
    pub name: &'static str,
    /// The skeleton's largest extent at rest (height, or span of the arms), in metres if the unit is this one.
    pub extent_m: f64,
}

/// Units that occur, the frequent ones first.
const UNITS: [(f64, &str); 5] = [
    (0.01, "centimetre"),
    (1.0, "metre"),
    (0.0254, "inch"),
    (0.001, "millimetre"),
    // The recordings of Carnegie Mellon: inches times 0.45.
    (0.0254 / 0.45, "CMU's 1/0.45 inch"),
];

/// The extents that count as a whole person's, metres: from a child to a tall adult with arms spread.
const PERSON_M: std::ops::Range<f64> = 1.2..2.3;

/// Parts of names that a whole person's skeleton has and a hand's has not: a hand in millimetres is as large as a person
/// in centimetres.
const OF_A_BODY: [&str; 8] = ["hip", "pelvis", "spine", "chest", "neck", "head", "leg", "foot"];

/// The unit in which the skeleton's largest extent at rest is a person's; `None` where there is none, and for a hand alone
/// (no joint has a name like `Hips`, `Spine`, `Head` or `Leg`).
///
/// ```
/// use chereme::format::bvh;
/// let text = "HIERARCHY\nROOT Hips {\n OFFSET 0 0 0\n CHANNELS 0\n End Site {\n OFFSET 0 170 0 } }\nMOTION\nFrames: 0\nFrame Time: .1\n";
/// let bvh = bvh::read(text.as_bytes()).unwrap().bvh;
/// assert_eq!(bvh::propose_unit(&bvh).unwrap().metres_per_unit, 0.01);
/// ```
pub fn propose_unit(bvh: &Bvh) -> Option<UnitProposal> {
    let of_a_body = |name: &str| OF_A_BODY.iter().any(|part| name.to_lowercase().contains(part));
    if !bvh.joints().iter().any(|joint| of_a_body(&joint.name)) {
        return None;
    }
    let rest = bvh.rest_positions();
    let ends = bvh.joints().iter().zip(&rest).flat_map(|(j, at)| j.end_sites.iter().map(move |e| *at + *e));
    let points = || rest.iter().copied().chain(ends.clone());
    let (low, high) = points().fold((DVec3::INFINITY, DVec3::NEG_INFINITY), |(l, h), p| (l.min(p), h.max(p)));
    let extent = (high - low).max_element();
    UNITS
        .iter()
        .map(|&(metres_per_unit, name)| UnitProposal { metres_per_unit, name, extent_m: extent * metres_per_unit })
        .find(|proposal| PERSON_M.contains(&proposal.extent_m))
}
