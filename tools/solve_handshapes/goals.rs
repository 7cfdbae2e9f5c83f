//! What a handshape demands of 21 angles, as residuals in millimetres.

use chereme::body::hand_skin::{HandBone, HandSkin, Patch, PosedHand};
use chereme::phonology::Digit;
use chereme::phonology::handshape::{HandAngles, HandLimits, Handshape, ThumbGoal, ThumbPart, ThumbTarget};
use glam::DVec3;

/// How far a finger may go from the table, radians.
const FROM_TABLE: f64 = 14.9 * std::f64::consts::PI / 180.0;
/// How deep skin may press into skin without a penalty, millimetres: pads give.
const PRESS_MM: f64 = 0.7;

/// Everything demanded of one handshape.
pub struct Goals<'a> {
    hand: &'a HandSkin,
    shape: &'a Handshape,
    contact: Option<(Patch, Vec<Patch>)>,
    /// Vertices and the part that they must stay out of.
    apart: Vec<(Vec<usize>, Vec<usize>, f64)>,
    /// Sides of neighbouring fingers that lie together, with a weight.
    together: Vec<(Patch, Patch, f64)>,
    /// Last phalanges of closed fingers.
    closed: Vec<(Patch, f64)>,
    palm: Vec<usize>,
    /// Backs of the crossing finger, which lie on the vertices of the other.
    crossing: Option<(Vec<Patch>, Vec<usize>)>,
}

impl<'a> Goals<'a> {
    /// The goals of a row.
    pub fn new(hand: &'a HandSkin, shape: &'a Handshape) -> Goals<'a> {
        let palm = vertices(hand, |b| b == HandBone::Palm);
        let inside = matches!(shape.thumb, ThumbGoal::Touch(ThumbPart::Tip, _, ThumbTarget::MiddleFront))
            || matches!(shape.thumb, ThumbGoal::Between(..));
        // Under a thumb laid across, the ball of the thumb takes the fingertip's place on the palm.
        let covered = |i: usize| match shape.thumb {
            ThumbGoal::Touch(_, digits, ThumbTarget::MiddleBack) => digits.contains(Digit::FINGERS[i]),
            _ => false,
        };
        let closed = (0..4).filter(|i| shape.flexion[*i] == "closed" && !inside && !covered(*i));
        let places = closed.flat_map(|i| [(i, 0.75, 0.4), (i, 0.3, 0.12)]);
        let closed = places.filter_map(|(i, share, weight)| {
            hand.finger_patch(Digit::FINGERS[i], 2, share, -DVec3::Y).map(|patch| (patch, weight))
        });
        let closed = closed.collect();
        let contact = hand.patches(&shape.thumb);
        let crossing = shape.crossing.map(|(front, behind)| {
            let backs = [(1, 0.8), (2, 0.4)].map(|(k, share)| hand.finger_patch(front, k, share, DVec3::Y));
            let other = vertices(hand, |b| matches!(b, HandBone::Phalanx(d, k) if d == behind && k >= 1));
            (backs.into_iter().flatten().collect(), other)
        });
        Goals {
            hand,
            shape,
            contact,
            apart: pairs(hand, &palm),
            together: together(hand, shape),
            closed,
            palm,
            crossing,
        }
    }

    /// The angles brought within limits and near the table.
    pub fn clamp(&self, x: [f64; 21]) -> [f64; 21] {
        let table = self.shape.table.to_array();
        let near = |i: usize| if i < 16 { x[i].clamp(table[i] - FROM_TABLE, table[i] + FROM_TABLE) } else { x[i] };
        HandLimits::ANATOMICAL.clamp(&HandAngles::from_array(std::array::from_fn(near))).to_array()
    }

    /// The array as a hand.
    pub fn hand_angles(&self, x: [f64; 21]) -> HandAngles {
        HandAngles::from_array(x)
    }

    /// All residuals, always as many and in the same order.
    pub fn residuals(&self, x: [f64; 21]) -> Vec<f64> {
        let posed = self.hand.pose(&HandAngles::from_array(x));
        let mut rows = Vec::with_capacity(4096);
        self.contact_rows(&posed, &mut rows);
        for (own, other, weight) in &self.apart {
            rows.extend(own.iter().map(|v| (posed.depth_mm(*v, other) - PRESS_MM).max(0.0) * weight));
        }
        for (a, b, weight) in &self.together {
            let ((p, n), (q, _)) = (posed.middle(a), posed.middle(b));
            rows.push(((q - p).dot(n) * 1000.0 - 0.3) * weight);
        }
        for (patch, weight) in &self.closed {
            rows.push((posed.above_mm(posed.middle(patch).0, &self.palm) - 0.5) * weight);
        }
        if let Some((backs, other)) = &self.crossing {
            rows.extend(backs.iter().map(|b| (distance_mm(&posed, posed.middle(b).0, other) - 2.0).max(0.0) * 0.5));
        }
        self.near_the_table(x, &mut rows);
        rows
    }

    fn contact_rows(&self, posed: &PosedHand, rows: &mut Vec<f64>) {
        let Some((thumb, targets)) = &self.contact else { return };
        let (p, n) = posed.middle(thumb);
        let count = targets.len() as f64;
        let (mut q, mut m) = (DVec3::ZERO, DVec3::ZERO);
        for target in targets {
            let (point, normal) = posed.middle(target);
            q += point / count;
            m += normal / count;
        }
        let (m, off) = (m.normalize_or(DVec3::Y), (p - q) * 1000.0);
        let facing = (n + m) * 4.0;
        match self.shape.thumb {
            ThumbGoal::Gap(_, mm) => {
                let along = off.dot(m);
                rows.push(off.length() - f64::from(mm));
                rows.extend(((off - m * along) * 0.2).to_array());
                rows.extend((facing * 0.5).to_array());
            }
            ThumbGoal::Between(..) => {
                rows.extend((off * 0.4).to_array());
                rows.extend(targets.iter().map(|t| posed.above_mm(posed.middle(t).0, thumb.vertices())));
            }
            ThumbGoal::Touch(part, _, target) => {
                let pad_to_pad = target == ThumbTarget::Pad;
                let along = off.dot(m);
                let aside = off - m * along;
                rows.push(along * 1.5);
                let exact = match targets.len() {
                    1 if pad_to_pad => 0.7,
                    1 => 0.45,
                    _ => 0.25,
                };
                rows.extend((aside * exact).to_array());
                let weight = match part {
                    ThumbPart::Pad => 1.0,
                    ThumbPart::Joint => 0.5,
                    ThumbPart::Tip | ThumbPart::Side => 0.2,
                };
                rows.extend((facing * weight).to_array());
                if targets.len() > 1 || part == ThumbPart::Joint {
                    let reach = |t: &Patch| distance_mm(posed, posed.middle(t).0, thumb.vertices()) - 1.0;
                    rows.extend(targets.iter().map(|t| reach(t).max(0.0)));
                }
            }
            ThumbGoal::Posture(_) => {}
        }
    }

    /// Weak springs: to the table, of like-bent neighbours to one another, of neighbouring knuckles.
    fn near_the_table(&self, x: [f64; 21], rows: &mut Vec<f64>) {
        let table = self.shape.table.to_array();
        let straight_thumb = matches!(self.shape.thumb, ThumbGoal::Touch(ThumbPart::Joint, ..));
        let gap = matches!(self.shape.thumb, ThumbGoal::Gap(..));
        let free_thumb = matches!(self.shape.thumb, ThumbGoal::Posture(_));
        for i in 0..21 {
            let weight = match i {
                // The stretched middle finger is the hand's axis; a thumb alongside must not draw the others over,
                // and crossed fingers stay crossed.
                5 if table[4] < 0.3 => 0.6,
                1 if straight_thumb || self.crossing.is_some() => 0.6,
                0..16 => 0.12,
                _ if free_thumb => 0.5,
                19.. if straight_thumb => 0.3,
                _ if gap => 0.1,
                _ => 0.03,
            };
            rows.push((x[i] - table[i]).to_degrees() * weight);
        }
        for i in 0..3 {
            let alike = self.shape.flexion[i] == self.shape.flexion[i + 1] && !self.shape.flexion[i].is_empty();
            for k in [0, 2, 3] {
                let difference = (x[4 * i + k] - x[4 * i + 4 + k]).to_degrees();
                rows.push(if alike { difference * 0.2 } else { 0.0 });
            }
        }
        let hand = HandAngles::from_array(x);
        for pair in hand.fingers.windows(2) {
            let beyond = (pair[0].mcp - pair[1].mcp).abs() - HandLimits::COMFORTABLE_NEIGHBOURS;
            rows.push(beyond.max(0.0).to_degrees() * 0.02);
        }
    }
}

/// From a point to the nearest of the vertices, millimetres.
fn distance_mm(posed: &PosedHand, point: DVec3, part: &[usize]) -> f64 {
    part.iter().map(|v| posed.skin.positions[*v].distance(point) * 1000.0).fold(f64::INFINITY, f64::min)
}

fn vertices(hand: &HandSkin, of: impl Fn(HandBone) -> bool) -> Vec<usize> {
    (0..hand.bones().len()).filter(|v| of(hand.bones()[*v])).collect()
}

/// What must stay out of what: outer phalanges out of the palm, each digit out of each other.
fn pairs(hand: &HandSkin, palm: &[usize]) -> Vec<(Vec<usize>, Vec<usize>, f64)> {
    let of = |d: Digit, least: usize| {
        vertices(hand, |b| matches!(b, HandBone::Phalanx(digit, k) if digit == d && k >= least))
    };
    let mut pairs = Vec::new();
    for d in Digit::ALL {
        let outer = of(d, if d == Digit::Thumb { 2 } else { 1 });
        pairs.push((outer.clone(), palm.to_vec(), 2.5));
        for other in Digit::ALL.into_iter().filter(|o| *o != d) {
            let least = usize::from(other == Digit::Thumb);
            pairs.push((outer.clone(), of(other, least), 0.9));
        }
    }
    pairs
}

/// The facing sides of neighbours that are bent alike and not spread.
fn together(hand: &HandSkin, shape: &Handshape) -> Vec<(Patch, Patch, f64)> {
    let mut found = Vec::new();
    for i in 0..3 {
        let (a, b) = (shape.table.fingers[i], shape.table.fingers[i + 1]);
        let alike = (a.mcp - b.mcp).abs() < 0.2 && (a.pip - b.pip).abs() < 0.2;
        if !alike || shape.spread[i].abs() > 0.02 || shape.spread[i + 1].abs() > 0.02 || shape.crossing.is_some() {
            continue;
        }
        for (phalanx, weight) in [(1, 0.4), (2, 0.3)] {
            let a = hand.finger_patch(Digit::FINGERS[i], phalanx, 0.5, -DVec3::Z);
            let b = hand.finger_patch(Digit::FINGERS[i + 1], phalanx, 0.5, DVec3::Z);
            if let (Some(a), Some(b)) = (a, b) {
                found.push((a, b, weight));
            }
        }
    }
    found
}
