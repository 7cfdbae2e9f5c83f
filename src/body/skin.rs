//! The body's surface: skinned by a pose, and measured.
//!
//! Linear blend skinning, as every viewer does it: a vertex is the mean of where its joints carry it. The rig
//! rests with identity rotations, so a joint carries a point by its own turn and its displacement alone.
//!
//! # Conventions
//! Model space, metres. Triangles are counter-clockwise seen from outside; signed distances are negative inside.

use crate::diagnostics::Error;
use crate::motion::pose::ModelPose;
use crate::motion::skeleton::{JointId, Skeleton};
use glam::DVec3;

/// A part of the surface as it is given: the arrays a vertex are of one length.
#[derive(Debug, Clone, Default)]
pub struct SkinPart {
    /// Such as `hands`, `face`, `suit`.
    pub name: String,
    /// Vertices at rest, model space, metres.
    pub positions: Vec<DVec3>,
    /// Unit normals at rest.
    pub normals: Vec<DVec3>,
    /// Three vertices of this part each.
    pub triangles: Vec<[u32; 3]>,
    /// Four joints a vertex.
    pub joints: Vec<[JointId; 4]>,
    /// Their shares; they sum to one.
    pub weights: Vec<[f64; 4]>,
}

/// A surface bound to a skeleton. Invariant: triangles and joints point at what is there.
#[derive(Debug, Clone)]
pub struct Skin {
    positions: Vec<DVec3>,
    normals: Vec<DVec3>,
    triangles: Vec<[u32; 3]>,
    joints: Vec<[JointId; 4]>,
    weights: Vec<[f64; 4]>,
    /// For each vertex the number of its part.
    part: Vec<u16>,
    parts: Vec<String>,
    rest: Vec<DVec3>,
}

/// Some triangles of a [`Skin`], to which a search is restricted.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Region(Vec<u32>);

impl Region {
    /// The triangles' numbers.
    pub fn triangles(&self) -> &[u32] {
        &self.0
    }
}

/// A point of the surface: a triangle and the shares of its corners, carried along with the surface.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct SkinPoint {
    /// The triangle's number.
    pub triangle: u32,
    /// The shares of its corners; they sum to one.
    pub shares: DVec3,
}

/// What lies nearest to a point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Nearest {
    /// The place on the surface.
    pub at: SkinPoint,
    /// The place, model space, metres.
    pub point: DVec3,
    /// The surface's normal there.
    pub normal: DVec3,
    /// Metres; negative where the point lies behind the surface.
    pub signed_m: f64,
}

/// A surface in a pose, model space.
#[derive(Debug, Clone)]
pub struct PosedSkin<'a> {
    skin: &'a Skin,
    /// Vertices, metres.
    pub positions: Vec<DVec3>,
    /// Unit normals.
    pub normals: Vec<DVec3>,
}

impl Skin {
    /// Binds parts to the skeleton in which they rest.
    ///
    /// # Errors
    /// Arrays of unequal length, triangles or joints that point at what is not there.
    pub fn new(skeleton: &Skeleton, parts: &[SkinPart]) -> Result<Skin, Error> {
        let rest = skeleton.joints().iter().map(|j| j.rest_model).collect();
        let mut skin = Skin {
            positions: Vec::new(),
            normals: Vec::new(),
            triangles: Vec::new(),
            joints: Vec::new(),
            weights: Vec::new(),
            part: Vec::new(),
            parts: parts.iter().map(|p| p.name.clone()).collect(),
            rest,
        };
        for (number, part) in parts.iter().enumerate() {
            part.check(skeleton).map_err(|e| e.context(format!("skin part {}", part.name)))?;
            let first = skin.positions.len() as u32;
            skin.positions.extend(&part.positions);
            skin.normals.extend(&part.normals);
            skin.triangles.extend(part.triangles.iter().map(|t| t.map(|v| v + first)));
            skin.joints.extend(&part.joints);
            skin.weights.extend(&part.weights);
            skin.part.resize(skin.positions.len(), number as u16);
        }
        Ok(skin)
    }

    /// How many vertices there are.
    pub fn len(&self) -> usize {
        self.positions.len()
    }

    /// Whether there is no vertex.
    pub fn is_empty(&self) -> bool {
        self.positions.is_empty()
    }

    /// Three vertices each, counter-clockwise seen from outside.
    pub fn triangles(&self) -> &[[u32; 3]] {
        &self.triangles
    }

    /// The part that a vertex belongs to.
    pub fn part_of(&self, vertex: usize) -> &str {
        &self.parts[usize::from(self.part[vertex])]
    }

    /// The joint with the greatest share in a vertex.
    pub fn main_joint(&self, vertex: usize) -> JointId {
        let weights = &self.weights[vertex];
        let greatest = (1..4).fold(0, |best, i| if weights[i] > weights[best] { i } else { best });
        self.joints[vertex][greatest]
    }

    /// The triangles all of whose corners belong mainly to joints that pass the test.
    pub fn region(&self, of_joint: impl Fn(JointId) -> bool) -> Region {
        let inside: Vec<bool> = (0..self.len()).map(|v| of_joint(self.main_joint(v))).collect();
        let whole = |t: &[u32; 3]| t.iter().all(|v| inside[*v as usize]);
        Region((0u32..).zip(&self.triangles).filter(|(_, t)| whole(t)).map(|(i, _)| i).collect())
    }

    /// The triangles all of whose corners are among the vertices.
    pub fn region_of_vertices(&self, vertices: &[usize]) -> Region {
        let mut inside = vec![false; self.len()];
        for v in vertices {
            inside[*v] = true;
        }
        let whole = |t: &[u32; 3]| t.iter().all(|v| inside[*v as usize]);
        Region((0u32..).zip(&self.triangles).filter(|(_, t)| whole(t)).map(|(i, _)| i).collect())
    }

    /// The surface of those joints alone: a smaller skin that is faster to pose.
    pub fn subset(&self, of_joint: impl Fn(JointId) -> bool) -> Skin {
        let keep: Vec<usize> = (0..self.len()).filter(|v| of_joint(self.main_joint(*v))).collect();
        let mut new_number = vec![None; self.len()];
        for (new, old) in keep.iter().enumerate() {
            new_number[*old] = Some(new as u32);
        }
        let renumber = |t: &[u32; 3]| {
            let [a, b, c] = t.map(|v| new_number[v as usize]);
            Some([a?, b?, c?])
        };
        Skin {
            positions: keep.iter().map(|v| self.positions[*v]).collect(),
            normals: keep.iter().map(|v| self.normals[*v]).collect(),
            triangles: self.triangles.iter().filter_map(renumber).collect(),
            joints: keep.iter().map(|v| self.joints[*v]).collect(),
            weights: keep.iter().map(|v| self.weights[*v]).collect(),
            part: keep.iter().map(|v| self.part[*v]).collect(),
            parts: self.parts.clone(),
            rest: self.rest.clone(),
        }
    }

    /// The surface carried by a pose of the skeleton it was bound to.
    pub fn pose(&self, pose: &ModelPose) -> PosedSkin<'_> {
        let mut positions = Vec::with_capacity(self.len());
        let mut normals = Vec::with_capacity(self.len());
        for v in 0..self.len() {
            let (mut at, mut normal) = (DVec3::ZERO, DVec3::ZERO);
            for (joint, weight) in self.joints[v].iter().zip(self.weights[v]).filter(|(_, w)| *w > 0.0) {
                let turn = pose.rotation(*joint);
                at += (pose.position(*joint) + turn * (self.positions[v] - self.rest[joint.index()])) * weight;
                normal += turn * self.normals[v] * weight;
            }
            positions.push(at);
            normals.push(normal.normalize_or(DVec3::Y));
        }
        PosedSkin { skin: self, positions, normals }
    }
}

impl SkinPart {
    fn check(&self, skeleton: &Skeleton) -> Result<(), Error> {
        let count = self.positions.len();
        if [self.normals.len(), self.joints.len(), self.weights.len()].iter().any(|n| *n != count) {
            return Err(Error::new("has arrays of unequal length"));
        }
        if self.triangles.iter().flatten().any(|v| *v as usize >= count) {
            return Err(Error::new("has a triangle with a vertex that is not there"));
        }
        if self.joints.iter().flatten().any(|j| j.index() >= skeleton.len()) {
            return Err(Error::new("has a vertex with a joint that is not there"));
        }
        Ok(())
    }
}

impl PosedSkin<'_> {
    /// A point of the surface in this pose, model space, metres.
    pub fn point(&self, at: SkinPoint) -> DVec3 {
        let corners = self.corners(at.triangle);
        corners[0] * at.shares.x + corners[1] * at.shares.y + corners[2] * at.shares.z
    }

    /// The unit normal at a point of the surface in this pose.
    pub fn normal(&self, at: SkinPoint) -> DVec3 {
        let [a, b, c] = self.skin.triangles[at.triangle as usize].map(|v| self.normals[v as usize]);
        (a * at.shares.x + b * at.shares.y + c * at.shares.z).normalize_or(DVec3::Y)
    }

    /// What of the region (of the whole surface, without one) lies nearest to a point; `None` where it has no triangle.
    ///
    /// The sign is that of the interpolated normals; at the edge of a region it says little.
    pub fn nearest(&self, point: DVec3, region: Option<&Region>) -> Option<Nearest> {
        let mut best: Option<(f64, u32, DVec3)> = None;
        let mut look = |triangle: u32| {
            let corners = self.corners(triangle);
            let shares = nearest_shares(point, corners);
            let at = corners[0] * shares.x + corners[1] * shares.y + corners[2] * shares.z;
            let distance = at.distance_squared(point);
            if best.is_none_or(|(d, ..)| distance < d) {
                best = Some((distance, triangle, shares));
            }
        };
        match region {
            Some(region) => region.0.iter().copied().for_each(&mut look),
            None => (0..self.skin.triangles.len() as u32).for_each(&mut look),
        }
        let (squared, triangle, shares) = best?;
        let at = SkinPoint { triangle, shares };
        let (place, normal) = (self.point(at), self.normal(at));
        let sign = if (point - place).dot(normal) < 0.0 { -1.0 } else { 1.0 };
        Some(Nearest { at, point: place, normal, signed_m: squared.sqrt() * sign })
    }

    /// The first point of the region that a ray meets within `reach_m` metres.
    pub fn first_hit(&self, from: DVec3, along: DVec3, reach_m: f64, region: &Region) -> Option<SkinPoint> {
        let hit = |t: &u32| ray_hit(from, along, self.corners(*t)).map(|(s, shares)| (s, *t, shares));
        let inside = region.0.iter().filter_map(hit).filter(|(s, ..)| *s <= reach_m);
        inside.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, triangle, shares)| SkinPoint { triangle, shares })
    }

    fn corners(&self, triangle: u32) -> [DVec3; 3] {
        self.skin.triangles[triangle as usize].map(|v| self.positions[v as usize])
    }
}

/// The shares of the corners at the point of a triangle nearest to `p` (Ericson 2005, Real-Time Collision
/// Detection, §5.1.5: by the Voronoi regions of corners and edges).
fn nearest_shares(p: DVec3, [a, b, c]: [DVec3; 3]) -> DVec3 {
    let (ab, ac, ap) = (b - a, c - a, p - a);
    let (d1, d2) = (ab.dot(ap), ac.dot(ap));
    if d1 <= 0.0 && d2 <= 0.0 {
        return DVec3::X;
    }
    let bp = p - b;
    let (d3, d4) = (ab.dot(bp), ac.dot(bp));
    if d3 >= 0.0 && d4 <= d3 {
        return DVec3::Y;
    }
    let vc = d1 * d4 - d3 * d2;
    if vc <= 0.0 && d1 >= 0.0 && d3 <= 0.0 {
        let v = ratio(d1, d1 - d3);
        return DVec3::new(1.0 - v, v, 0.0);
    }
    let cp = p - c;
    let (d5, d6) = (ab.dot(cp), ac.dot(cp));
    if d6 >= 0.0 && d5 <= d6 {
        return DVec3::Z;
    }
    let vb = d5 * d2 - d1 * d6;
    if vb <= 0.0 && d2 >= 0.0 && d6 <= 0.0 {
        let w = ratio(d2, d2 - d6);
        return DVec3::new(1.0 - w, 0.0, w);
    }
    let va = d3 * d6 - d5 * d4;
    if va <= 0.0 && d4 >= d3 && d5 >= d6 {
        let w = ratio(d4 - d3, (d4 - d3) + (d5 - d6));
        return DVec3::new(0.0, 1.0 - w, w);
    }
    let (v, w) = (ratio(vb, va + vb + vc), ratio(vc, va + vb + vc));
    DVec3::new(1.0 - v - w, v, w)
}

/// A quotient, or zero for a triangle without area.
fn ratio(above: f64, below: f64) -> f64 {
    if below.abs() > f64::MIN_POSITIVE { above / below } else { 0.0 }
}

/// How far along a ray a triangle lies, and the shares of its corners there (Möller & Trumbore 1997).
fn ray_hit(from: DVec3, along: DVec3, [a, b, c]: [DVec3; 3]) -> Option<(f64, DVec3)> {
    let (ab, ac) = (b - a, c - a);
    let p = along.cross(ac);
    let det = ab.dot(p);
    if det.abs() < 1e-15 {
        return None;
    }
    let t = from - a;
    let v = t.dot(p) / det;
    let q = t.cross(ab);
    let w = along.dot(q) / det;
    let s = ac.dot(q) / det;
    (v >= 0.0 && w >= 0.0 && v + w <= 1.0 && s >= 0.0).then(|| (s, DVec3::new(1.0 - v - w, v, w)))
}
