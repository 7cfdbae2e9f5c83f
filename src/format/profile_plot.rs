//! Kinematic profiles as figures: one measure a row; motions laid over one another, side by side, or against a golden one.
//!
//! Side by side is how Naert et al. 2021 print figures 6 and 10: a column an interpolation, a colour a fingertip.

use super::svg::{Base, Column, Figure, Line, Mark, Panel, Row};
use crate::diagnostics::Error;
use crate::motion::curve::{Curve, Measure, Profile, Reference, of_clip};
use crate::motion::difference::Tolerance;
use crate::motion::point::Point;
use crate::time::Seconds;
use crate::track::Track;

/// A profile under the name of its motion.
#[derive(Debug, Clone, PartialEq)]
pub struct Motion {
    /// The motion's name: a sign's, a file's, an easing's.
    pub name: String,
    /// What was measured.
    pub profile: Profile,
    /// Letters at key instants.
    pub marks: Vec<Mark>,
}

impl Motion {
    /// Height and speed of the wrists that act in a track, with its phases: what is shown of a sign where nothing else is asked.
    ///
    /// # Errors
    /// A rig without hands.
    pub fn of_track(name: &str, track: &Track) -> Result<Motion, Error> {
        let (right, left) = (track.phases("RH Phase"), track.phases("LH Phase"));
        let names: &[&str] = match (right.is_empty(), left.is_empty()) {
            (false, false) => &["RightHand", "LeftHand"],
            (true, false) => &["LeftHand"],
            (_, true) => &["RightHand"],
        };
        let skeleton = track.clip.skeleton();
        let point = |name: &&str| skeleton.joint(name).map(|joint| Point::of_joint(skeleton, joint));
        let points = names.iter().map(point).collect::<Result<Vec<_>, _>>()?;
        let profile = of_clip(&track.clip, &points, Reference::Floor, &[Measure::Height, Measure::Speed])?;
        let profile = profile.with_phases(if right.is_empty() { left } else { right });
        Ok(Motion { name: name.to_owned(), profile, marks: Vec::new() })
    }
}

/// How several motions stand in a figure.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Layout {
    /// One column, a colour a motion and point.
    Overlaid,
    /// A column a motion, a colour a point.
    Columns,
}

/// What a row shows: the curves of one measure from one reference.
type Kind = (Reference, Measure);

/// The figure of motions.
///
/// ```
/// use chereme::format::profile_plot::{Layout, Motion, figure};
/// use chereme::motion::curve::{Curve, Measure, Profile, Reference};
/// use chereme::time::Seconds;
/// let curve = Curve {
///     point: "RightHand".into(), reference: Reference::Floor, measure: Measure::Speed, values: vec![0.0, 1.0, 0.0],
/// };
/// let profile = Profile::new(vec![Seconds(0.0), Seconds(0.5), Seconds(1.0)], vec![curve]).unwrap();
/// let motion = |name: &str| Motion { name: name.into(), profile: profile.clone(), marks: vec![] };
/// let both = figure("BOL", &[motion("cosine"), motion("sigmoid")], Layout::Columns);
/// assert_eq!((both.columns.len(), both.rows.len(), both.rows[0].title.as_str()), (2, 1, "speed (m/s)"));
/// ```
pub fn figure(title: &str, motions: &[Motion], layout: Layout) -> Figure {
    let kinds = kinds(motions);
    let mut points: Vec<&str> = Vec::new();
    for curve in motions.iter().flat_map(|m| m.profile.curves()) {
        if !points.contains(&curve.point.as_str()) {
            points.push(&curve.point);
        }
    }
    let number = |curve: &Curve| points.iter().position(|p| *p == curve.point).unwrap_or_default();
    let mut figure = Figure { title: title.to_owned(), ..Figure::default() };
    match layout {
        Layout::Columns => {
            figure.keys = points.iter().map(|p| (*p).to_owned()).collect();
            figure.columns = motions.iter().map(|m| column(m, &m.name)).collect();
            let panel = |m: &Motion, kind| Panel { lines: lines(&m.profile, kind, number) };
            let row = |kind: &Kind| row(*kind, motions.iter().map(|m| panel(m, *kind)).collect());
            figure.rows = kinds.iter().map(row).collect();
        }
        Layout::Overlaid => {
            let name = |m: &Motion, p: &str| match (motions.len(), points.len()) {
                (1, _) => p.to_owned(),
                (_, 1) => m.name.clone(),
                _ => format!("{}, {p}", m.name),
            };
            figure.keys = motions.iter().flat_map(|m| points.iter().map(move |p| name(m, p))).collect();
            if motions.len() > 1 && points.len() == 1 {
                figure.subtitle = points[0].to_owned();
            }
            figure.columns = vec![shared_column(motions)];
            let lines = |kind: Kind| {
                let of = |(i, m): (usize, &Motion)| lines(&m.profile, kind, |c| i * points.len() + number(c));
                motions.iter().enumerate().flat_map(of).collect()
            };
            figure.rows = kinds.iter().map(|kind| row(*kind, vec![Panel { lines: lines(*kind) }])).collect();
        }
    }
    figure
}

/// The figure of a motion against its golden one: both curves of each row, and below them their difference with its tolerance.
pub fn against(title: &str, golden: &Motion, found: &Motion, tolerance: impl Fn(Measure) -> Tolerance) -> Figure {
    let both = [golden.clone(), found.clone()];
    let mut figure = figure(title, &both, Layout::Overlaid);
    figure.columns = vec![column(golden, "")];
    let per_motion = figure.keys.len() / 2;
    let mut rows = Vec::new();
    for (row, kind) in figure.rows.into_iter().zip(kinds(&both)) {
        rows.push(row);
        let mut allowed: f64 = 0.0;
        let mut lines = Vec::new();
        for (i, curve) in golden.profile.curves().iter().filter(|c| (c.reference, c.measure) == kind).enumerate() {
            let Some(other) = found.profile.like(curve) else { continue };
            allowed = allowed.max(tolerance(curve.measure).of(curve));
            let apart = |(time, value): (&Seconds, &f64)| (time.0, found.profile.at(other, *time) - value);
            lines.push(Line {
                key: per_motion + i,
                points: golden.profile.times().iter().zip(&curve.values).map(apart).collect(),
            });
        }
        if !lines.is_empty() {
            let title = format!("difference in {}, tolerance ±{allowed:.3}", heading(kind));
            rows.push(Row { title, base: Base::Tolerance(allowed), panels: vec![Panel { lines }] });
        }
    }
    figure.rows = rows;
    figure
}

/// The rows that motions need, in the order they are met.
fn kinds(motions: &[Motion]) -> Vec<Kind> {
    let mut kinds: Vec<Kind> = Vec::new();
    for curve in motions.iter().flat_map(|m| m.profile.curves()) {
        if !kinds.contains(&(curve.reference, curve.measure)) {
            kinds.push((curve.reference, curve.measure));
        }
    }
    kinds
}

/// What stands behind motions that are laid over one another: the first one's phases and letters where all have them at the same
/// times, else nothing, because they would be read as those of every curve.
fn shared_column(motions: &[Motion]) -> Column {
    const SAME: f64 = 0.02;
    let Some((first, others)) = motions.split_first() else { return Column::default() };
    let same = |a: Seconds, b: Seconds| (a - b).0.abs() <= SAME;
    let agrees = |other: &Motion| {
        let (p, q) = (first.profile.phases(), other.profile.phases());
        p.len() == q.len()
            && p.iter().zip(q).all(|(p, q)| p.name == q.name && same(p.start, q.start) && same(p.end, q.end))
    };
    match others.iter().all(agrees) {
        true => column(first, ""),
        false => Column::default(),
    }
}

fn column(motion: &Motion, title: &str) -> Column {
    Column { title: title.to_owned(), phases: motion.profile.phases().to_vec(), marks: motion.marks.clone() }
}

fn row((reference, measure): Kind, panels: Vec<Panel>) -> Row {
    let base = match measure {
        Measure::X | Measure::Y | Measure::Z | Measure::Position | Measure::Height => Base::Data,
        Measure::Speed | Measure::Acceleration | Measure::Jerk => Base::Zero,
    };
    Row { title: heading((reference, measure)), base, panels }
}

fn heading((reference, measure): Kind) -> String {
    let from = match reference {
        Reference::Floor => "",
        Reference::Body => " from the body",
        Reference::Wrist => " from the wrist",
    };
    format!("{measure}{from} ({})", measure.unit())
}

/// The curves of a kind, each under the number of its key.
fn lines(profile: &Profile, kind: Kind, key: impl Fn(&Curve) -> usize) -> Vec<Line> {
    let wanted = profile.curves().iter().filter(|c| (c.reference, c.measure) == kind);
    let points = |c: &Curve| profile.times().iter().map(|t| t.0).zip(c.values.iter().copied()).collect();
    wanted.map(|c| Line { key: key(c), points: points(c) }).collect()
}
