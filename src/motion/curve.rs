//! Curves of a motion over time: what a point does, seen from the floor, the body or the wrist.
//!
//! Naert et al. 2021 compare interpolations by such curves: height and speed of the wrist while pointing (figure 6), position and
//! speed of the fingertips from the wrist while spelling (figure 10).
//!
//! # Conventions
//! Seconds from the clip's start; metres, m/s, m/s², m/s³. Seen from the *floor*, the axes are those of model space. Seen from the
//! *body* (the rig's root) or the *wrist* (the hand's joint that the point hangs from), origin and axes are that joint's, so that what
//! the joint does is not seen; `height` is along the vertical all the same, above that origin.

use super::clip::Clip;
use super::point::Point;
use super::profile::{acceleration, jerk, speed};
use super::skeleton::{JointId, Skeleton};
use crate::diagnostics::Error;
use crate::time::{FrameIndex, Seconds};
use glam::DVec3;
use std::collections::BTreeSet;
use std::fmt;
use std::str::FromStr;

/// Where a point is seen from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Reference {
    /// Model space: the floor between the feet.
    Floor,
    /// The rig's root, which the trunk grows from.
    Body,
    /// The hand's joint that the point hangs from.
    Wrist,
}

impl Reference {
    /// All of them.
    pub const ALL: [Reference; 3] = [Reference::Floor, Reference::Body, Reference::Wrist];

    /// The word for it.
    pub fn name(self) -> &'static str {
        match self {
            Reference::Floor => "floor",
            Reference::Body => "body",
            Reference::Wrist => "wrist",
        }
    }

    /// The joint whose axes these are for a point on `joint`; `None` is the floor.
    ///
    /// # Errors
    /// The wrist of a point that hangs from no hand.
    pub fn origin(self, skeleton: &Skeleton, joint: JointId) -> Result<Option<JointId>, Error> {
        match self {
            Reference::Floor => Ok(None),
            Reference::Body => Ok(Some(JointId(0))),
            Reference::Wrist => {
                let mut at = Some(joint);
                while let Some(id) = at {
                    let name = skeleton[id].name.to_ascii_lowercase();
                    if name.ends_with("hand") || name.ends_with("wrist") {
                        return Ok(Some(id));
                    }
                    at = skeleton[id].parent;
                }
                let name = &skeleton[joint].name;
                Err(Error::new(format!("{name} hangs from no hand, so it cannot be seen from the wrist")))
            }
        }
    }
}

/// What is measured of a point.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Measure {
    /// To the left of the origin.
    X,
    /// Above the origin, along the frame's own axis.
    Y,
    /// Before the origin.
    Z,
    /// The distance from the origin.
    Position,
    /// Above the origin, along the vertical.
    Height,
    /// The length of the velocity.
    Speed,
    /// The length of the acceleration.
    Acceleration,
    /// The length of the jerk.
    Jerk,
}

impl Measure {
    /// All of them.
    pub const ALL: [Measure; 8] = [
        Measure::X,
        Measure::Y,
        Measure::Z,
        Measure::Position,
        Measure::Height,
        Measure::Speed,
        Measure::Acceleration,
        Measure::Jerk,
    ];

    /// The word for it.
    pub fn name(self) -> &'static str {
        match self {
            Measure::X => "x",
            Measure::Y => "y",
            Measure::Z => "z",
            Measure::Position => "position",
            Measure::Height => "height",
            Measure::Speed => "speed",
            Measure::Acceleration => "acceleration",
            Measure::Jerk => "jerk",
        }
    }

    /// Its unit.
    ///
    /// ```
    /// assert_eq!(chereme::motion::curve::Measure::Speed.unit(), "m/s");
    /// ```
    pub fn unit(self) -> &'static str {
        match self {
            Measure::X | Measure::Y | Measure::Z | Measure::Position | Measure::Height => "m",
            Measure::Speed => "m/s",
            Measure::Acceleration => "m/s²",
            Measure::Jerk => "m/s³",
        }
    }
}

macro_rules! named {
    ($type:ty, $what:literal) => {
        impl fmt::Display for $type {
            fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
                f.write_str(self.name())
            }
        }

        impl FromStr for $type {
            type Err = Error;

            fn from_str(text: &str) -> Result<Self, Error> {
                let known = Self::ALL.into_iter().find(|value| value.name().eq_ignore_ascii_case(text));
                known.ok_or_else(|| {
                    let names = Self::ALL.map(|value| value.name()).join(", ");
                    Error::new(format!(concat!("there is no ", $what, " called `{}`; there are {}"), text, names))
                })
            }
        }
    };
}
named!(Reference, "frame");
named!(Measure, "measure");

/// One measure of one point over time.
#[derive(Debug, Clone, PartialEq)]
pub struct Curve {
    /// The point's name.
    pub point: String,
    /// Where it is seen from.
    pub reference: Reference,
    /// What is measured.
    pub measure: Measure,
    /// One value an instant of the [`Profile`], in the measure's unit.
    pub values: Vec<f64>,
}

impl Curve {
    /// The curve in words: `RightHand floor speed`.
    pub fn name(&self) -> String {
        format!("{} {} {}", self.point, self.reference, self.measure)
    }

    /// From the least value to the greatest.
    pub fn range(&self) -> f64 {
        let (low, high) =
            self.values.iter().fold((f64::INFINITY, f64::NEG_INFINITY), |(l, h), v| (l.min(*v), h.max(*v)));
        (high - low).max(0.0)
    }
}

/// A stretch of the motion with a name, such as `stroke`.
#[derive(Debug, Clone, PartialEq)]
pub struct Phase {
    /// What it is.
    pub name: String,
    /// Where it begins.
    pub start: Seconds,
    /// Where it ends.
    pub end: Seconds,
}

/// Curves over the same instants, with the phases of the motion.
///
/// Invariant: at least one instant; instants finite and increasing; each curve has one finite value an instant; no two curves are of one
/// point, reference and measure; names are not empty and of one line; phases are in order and do not overlap.
#[derive(Debug, Clone, PartialEq)]
pub struct Profile {
    times: Vec<Seconds>,
    curves: Vec<Curve>,
    phases: Vec<Phase>,
}

impl Profile {
    /// Curves over instants.
    ///
    /// # Errors
    /// Says in what the curves and instants break the invariant.
    pub fn new(times: Vec<Seconds>, curves: Vec<Curve>) -> Result<Profile, Error> {
        if times.is_empty() {
            return Err(Error::new("a profile has at least one instant"));
        }
        let increasing = times.windows(2).all(|pair| pair[0] < pair[1]);
        if !increasing || !times.iter().all(|t| t.0.is_finite()) {
            return Err(Error::new("the instants of a profile are finite and increase"));
        }
        let mut seen = BTreeSet::new();
        for curve in &curves {
            let name = curve.name();
            if curve.point.is_empty() || curve.point.chars().any(char::is_control) {
                return Err(Error::new(format!("{:?} is no name for a point", curve.point)));
            }
            if curve.values.len() != times.len() || !curve.values.iter().all(|v| v.is_finite()) {
                return Err(Error::new(format!("{name} has not one finite value an instant")));
            }
            if !seen.insert((&curve.point, curve.reference, curve.measure)) {
                return Err(Error::new(format!("{name} is there twice")));
            }
        }
        Ok(Profile { times, curves, phases: Vec::new() })
    }

    /// The same curves with phases; they are put in order, each ends where the next begins at the latest, and those
    /// without length or name are left out.
    pub fn with_phases(mut self, mut phases: Vec<Phase>) -> Profile {
        phases.retain(|p| p.start < p.end && !p.name.is_empty());
        phases.sort_by(|a, b| a.start.0.total_cmp(&b.start.0));
        for i in 1..phases.len() {
            let next = phases[i].start;
            let before = &mut phases[i - 1];
            before.end = if before.end > next { next } else { before.end };
        }
        phases.retain(|p| p.start < p.end);
        self.phases = phases;
        self
    }

    /// The instants, increasing.
    pub fn times(&self) -> &[Seconds] {
        &self.times
    }

    /// The curves, in the order they were made.
    pub fn curves(&self) -> &[Curve] {
        &self.curves
    }

    /// The phases, in order.
    pub fn phases(&self) -> &[Phase] {
        &self.phases
    }

    /// The curve of the same point, reference and measure.
    pub fn like(&self, other: &Curve) -> Option<&Curve> {
        let same = |c: &&Curve| (&c.point, c.reference, c.measure) == (&other.point, other.reference, other.measure);
        self.curves.iter().find(same)
    }

    /// From the first instant to the last.
    pub fn duration(&self) -> Seconds {
        self.times[self.times.len() - 1] - self.times[0]
    }

    /// A curve of this profile at an instant: linear between samples, still before the first and after the last.
    ///
    /// ```
    /// use chereme::{motion::curve::{Curve, Measure, Profile, Reference}, time::Seconds};
    /// let curve = Curve {
    ///     point: "RightHand".into(), reference: Reference::Floor, measure: Measure::Height, values: vec![1.0, 2.0],
    /// };
    /// let profile = Profile::new(vec![Seconds(0.0), Seconds(0.5)], vec![curve]).unwrap();
    /// assert_eq!(profile.at(&profile.curves()[0], Seconds(0.25)), 1.5);
    /// ```
    pub fn at(&self, curve: &Curve, time: Seconds) -> f64 {
        let after = self.times.partition_point(|t| *t <= time);
        match (after.checked_sub(1), curve.values.get(after)) {
            (None, Some(first)) => *first,
            (Some(before), Some(next)) => {
                let (t, u) = (self.times[before].0, self.times[after].0);
                let value = curve.values[before];
                value + (next - value) * (time.0 - t) / (u - t)
            }
            (_, None) => curve.values.last().copied().unwrap_or_default(),
        }
    }
}

/// Measures points of a clip, frame by frame: the curves are in the order of the points, then of the measures.
///
/// # Errors
/// A point that cannot be seen from the wrist; the same point or measure twice.
///
/// ```
/// use chereme::motion::clip::{Clip, Frame};
/// use chereme::motion::curve::{Measure, Reference, of_clip};
/// use chereme::motion::{point, pose::LocalPose, skeleton::Skeleton};
/// use chereme::time::Fps;
/// let rig = Skeleton::from_json(chereme::avatar::SKELETON).unwrap();
/// let tip = point::matching(&rig, "RightHandIndexTip");
/// let frame = Frame { pose: LocalPose::rest(&rig), weights: vec![] };
/// let clip = Clip::new(rig.into(), Fps::DEFAULT, vec![].into(), vec![frame]).unwrap();
/// let profile = of_clip(&clip, &tip, Reference::Wrist, &[Measure::Position]).unwrap();
/// assert!((profile.curves()[0].values[0] - 0.18).abs() < 0.02);
/// ```
pub fn of_clip(clip: &Clip, points: &[Point], reference: Reference, measures: &[Measure]) -> Result<Profile, Error> {
    let skeleton = clip.skeleton();
    let origins = points.iter().map(|p| reference.origin(skeleton, p.joint)).collect::<Result<Vec<_>, _>>()?;
    let frames = clip.frames().len();
    let mut seen = vec![(Vec::with_capacity(frames), Vec::with_capacity(frames)); points.len()];
    for frame in clip.frames() {
        let pose = frame.pose.to_model(skeleton);
        for ((point, origin), (path, heights)) in points.iter().zip(&origins).zip(&mut seen) {
            let at = point.position(&pose);
            let from = origin.map_or(at, |joint| at - pose.position(joint));
            heights.push(from.y);
            path.push(origin.map_or(at, |joint| pose.rotation(joint).inverse() * from));
        }
    }
    let mut curves = Vec::with_capacity(points.len() * measures.len());
    for (point, (path, heights)) in points.iter().zip(&seen) {
        for &measure in measures {
            let values = values(clip, measure, path, heights);
            curves.push(Curve { point: point.name.clone(), reference, measure, values });
        }
    }
    Profile::new((0..frames).map(|i| clip.fps().time_of(FrameIndex(i))).collect(), curves)
}

fn values(clip: &Clip, measure: Measure, path: &[DVec3], heights: &[f64]) -> Vec<f64> {
    let each = |value: fn(&DVec3) -> f64| path.iter().map(value).collect();
    match measure {
        Measure::X => each(|p| p.x),
        Measure::Y => each(|p| p.y),
        Measure::Z => each(|p| p.z),
        Measure::Position => each(|p| p.length()),
        Measure::Height => heights.to_vec(),
        Measure::Speed => speed(path, clip.fps()),
        Measure::Acceleration => acceleration(path, clip.fps()),
        Measure::Jerk => jerk(path, clip.fps()),
    }
}
