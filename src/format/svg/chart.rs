//! Charts of what was measured many times: boxes, bars with intervals, estimates, mean curves in a band.
//!
//! Panels stand below one another, each with its own scales; colours mean the same in all of them. The box plots are drawn as in Naert
//! et al. 2021, figures 15 and 17: the median a line, the mean dotted, whiskers to 1.5 interquartile ranges.
//!
//! # Conventions
//! As the figures of [`super`]: one file without references, for light and dark surroundings, all text escaped, the same
//! chart gives the same bytes.

use super::draw::{EDGE, LETTER, RIGHT, STYLE, class, cut, escaped, legend, put};
use super::scale::Scale;
use std::fmt::Write;

const WIDTH: f64 = 860.0;
const LEFT: f64 = 62.0;
const HEIGHT: f64 = 210.0;
/// Above a panel, for its heading.
const HEADING: f64 = 34.0;
/// Below a panel, for ticks and the name of its axis.
const FOOT: f64 = 44.0;

const MORE: &str = "\
.area{stroke:none;fill-opacity:.16}.body{fill-opacity:.2;stroke-width:1.4}.thin{stroke-width:1.4;fill:none}.strong{stroke-width:2.6;fill:none}
.mean{stroke-width:1.8;stroke-dasharray:2 3;fill:none}
.f0{fill:#1f6fb4}.f1{fill:#d1495b}.f2{fill:#23895f}.f3{fill:#8456bd}.f4{fill:#c07a12}.f5{fill:#11889a}.f6{fill:#b03f8a}.f7{fill:#6b7078}
@media (prefers-color-scheme:dark){.f0{fill:#62aeea}.f1{fill:#f0808d}.f2{fill:#55c596}.f3{fill:#b794e6}.f4{fill:#e8ab4e}.f5{fill:#48c3d4}.f6{fill:#e382c0}.f7{fill:#a6adb6}}
";

/// What is drawn.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Chart {
    /// The heading.
    pub title: String,
    /// A line below the heading; may be empty.
    pub subtitle: String,
    /// What each colour means; marks name them by number.
    pub keys: Vec<String>,
    /// From top to bottom.
    pub panels: Vec<Panel>,
}

/// One pair of axes.
#[derive(Debug, Clone, PartialEq)]
pub struct Panel {
    /// What is measured, with its unit.
    pub title: String,
    /// What lies to the right.
    pub across: Across,
    /// Values that the upward scale holds at least.
    pub holds: Vec<f64>,
    /// What stands in it, the last uppermost.
    pub marks: Vec<Mark>,
}

/// The axis to the right.
#[derive(Debug, Clone, PartialEq)]
pub enum Across {
    /// Names in a row: the middle of name i is at i.
    Names(Vec<String>),
    /// Numbers from the least to the greatest of the marks, and what they are.
    Numbers(String),
}

/// Something measured.
#[derive(Debug, Clone, PartialEq)]
pub struct Mark {
    /// The number of its key.
    pub key: usize,
    /// What it is.
    pub shape: Shape,
}

/// What a mark looks like. `at` is a place on the axis to the right, `width` how much of it is taken up.
#[derive(Debug, Clone, PartialEq)]
pub enum Shape {
    /// A box plot: whiskers, quartiles, median (a line), mean (dotted).
    Box {
        /// Its middle.
        at: f64,
        /// Its width.
        width: f64,
        /// Lower whisker, lower quartile, median, upper quartile, upper whisker.
        five: [f64; 5],
        /// The mean.
        mean: f64,
    },
    /// A bar from zero, with an interval.
    Bar {
        /// Its middle.
        at: f64,
        /// Its width.
        width: f64,
        /// Its height.
        value: f64,
        /// The interval.
        interval: (f64, f64),
    },
    /// A dot with an interval.
    Dot {
        /// Its place.
        at: f64,
        /// Its height.
        value: f64,
        /// The interval.
        interval: (f64, f64),
    },
    /// A curve.
    Line(Vec<(f64, f64)>),
    /// What lies between two curves: places, lower and upper values.
    Band(Vec<(f64, f64, f64)>),
}

impl Shape {
    /// The places and values that the scales must hold.
    fn extent(&self) -> Vec<(f64, f64)> {
        match self {
            Shape::Box { at, width, five, mean } => {
                five.iter().chain([mean]).flat_map(|v| [(at - width / 2.0, *v), (at + width / 2.0, *v)]).collect()
            }
            Shape::Bar { at, width, value, interval } => [0.0, *value, interval.0, interval.1]
                .into_iter()
                .flat_map(|v| [(at - width / 2.0, v), (at + width / 2.0, v)])
                .collect(),
            Shape::Dot { at, value, interval } => [*value, interval.0, interval.1].map(|v| (*at, v)).to_vec(),
            Shape::Line(points) => points.clone(),
            Shape::Band(points) => points.iter().flat_map(|(x, low, high)| [(*x, *low), (*x, *high)]).collect(),
        }
    }
}

/// The chart as an SVG document.
///
/// ```
/// use chereme::format::svg::chart::{Across, Chart, Mark, Panel, Shape, write};
/// let shape = Shape::Box { at: 0.0, width: 0.5, five: [1.0, 2.0, 3.0, 4.0, 5.0], mean: 3.2 };
/// let panel = Panel { title: "realism".into(), across: Across::Names(vec!["BOL".into()]), holds: vec![1.0, 5.0], marks: vec![Mark { key: 0, shape }] };
/// let svg = write(&Chart { title: "ratings".into(), keys: vec!["sigmoid".into()], panels: vec![panel], ..Chart::default() });
/// assert!(svg.starts_with("<svg ") && svg.contains(">BOL<"));
/// ```
pub fn write(chart: &Chart) -> String {
    let mut body = String::new();
    put(&mut body, "title", EDGE, 32.0, "start", &cut(&chart.title, WIDTH - EDGE - RIGHT, 10.0));
    let mut y = 32.0;
    if !chart.subtitle.is_empty() {
        y += 21.0;
        put(&mut body, "soft", EDGE, y, "start", &cut(&chart.subtitle, WIDTH - EDGE - RIGHT, LETTER));
    }
    y = legend(&mut body, &chart.keys, WIDTH, y);
    for panel in &chart.panels {
        y += HEADING;
        draw(&mut body, panel, y);
        y += HEIGHT + FOOT;
    }
    let height = y + 8.0;
    let title = escaped(&chart.title);
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{WIDTH}\" height=\"{height}\" viewBox=\"0 0 {WIDTH} {height}\" role=\"img\">\n\
         <title>{title}</title>\n<style>\n{STYLE}{MORE}</style>\n<rect class=\"paper\" width=\"{WIDTH}\" height=\"{height}\"/>\n{body}</svg>\n"
    )
}

/// Draws a panel whose upper edge is at `top`.
fn draw(body: &mut String, panel: &Panel, top: f64) {
    let (left, right, bottom) = (LEFT, WIDTH - RIGHT, top + HEIGHT);
    let extent: Vec<(f64, f64)> = panel.marks.iter().flat_map(|m| m.shape.extent()).collect();
    let span = |values: &mut dyn Iterator<Item = f64>| {
        values.filter(|v| v.is_finite()).fold((f64::INFINITY, f64::NEG_INFINITY), |(a, b), v| (a.min(v), b.max(v)))
    };
    let y = Scale::new(span(&mut extent.iter().map(|p| p.1).chain(panel.holds.iter().copied())), (bottom, top), 4.0)
        .rounded();
    let x = match &panel.across {
        Across::Names(names) => Scale::new((-0.5, names.len().max(1) as f64 - 0.5), (left, right), 4.0),
        Across::Numbers(_) => Scale::new(span(&mut extent.iter().map(|p| p.0)), (left, right), 10.0),
    };
    put(body, "head", EDGE, top - 9.0, "start", &panel.title);
    for (value, text) in y.ticks() {
        let at = y.at(value);
        let _ =
            writeln!(body, "<line class=\"grid\" x1=\"{left:.1}\" x2=\"{right:.1}\" y1=\"{at:.1}\" y2=\"{at:.1}\"/>");
        put(body, "small soft", left - 8.0, at + 4.0, "end", &text);
    }
    for mark in &panel.marks {
        shape(body, mark, &x, &y);
    }
    let _ = writeln!(body, "<path class=\"axis\" d=\"M{left:.1} {top:.1}V{bottom:.1}H{right:.1}\"/>");
    match &panel.across {
        Across::Names(names) => {
            let room = (right - left) / names.len().max(1) as f64;
            for (i, name) in names.iter().enumerate() {
                put(body, "small", x.at(i as f64), bottom + 17.0, "middle", &cut(name, room, LETTER));
            }
        }
        Across::Numbers(what) => {
            for (value, text) in x.ticks() {
                put(body, "small soft", x.at(value), bottom + 17.0, "middle", &text);
            }
            put(body, "small soft", right, bottom + 34.0, "end", what);
        }
    }
}

fn shape(body: &mut String, mark: &Mark, x: &Scale, y: &Scale) {
    let (stroke, fill) = (class(mark.key), format!("f{}", mark.key % 8));
    let stroke = stroke.trim_start_matches("line ").to_owned();
    match &mark.shape {
        Shape::Box { at, width, five, mean } => {
            let (from, to, middle) = (x.at(at - width / 2.0), x.at(at + width / 2.0), x.at(*at));
            let [low, q1, median, q3, high] = five.map(|v| y.at(v));
            let _ = writeln!(
                body,
                "<path class=\"thin {stroke}\" d=\"M{middle:.1} {low:.1}V{q1:.1}M{middle:.1} {q3:.1}V{high:.1}\"/>"
            );
            area(body, &stroke, &fill, (from, to), (q3, q1));
            let _ = writeln!(body, "<path class=\"strong {stroke}\" d=\"M{from:.1} {median:.1}H{to:.1}\"/>");
            let _ = writeln!(body, "<path class=\"mean {stroke}\" d=\"M{from:.1} {:.1}H{to:.1}\"/>", y.at(*mean));
        }
        Shape::Bar { at, width, value, interval } => {
            area(body, &stroke, &fill, (x.at(at - width / 2.0), x.at(at + width / 2.0)), (y.at(*value), y.at(0.0)));
            let middle = x.at(*at);
            let _ = writeln!(
                body,
                "<path class=\"thin {stroke}\" d=\"M{middle:.1} {:.1}V{:.1}\"/>",
                y.at(interval.0),
                y.at(interval.1)
            );
        }
        Shape::Dot { at, value, interval } => {
            let middle = x.at(*at);
            let _ = writeln!(
                body,
                "<path class=\"thin {stroke}\" d=\"M{middle:.1} {:.1}V{:.1}\"/>",
                y.at(interval.0),
                y.at(interval.1)
            );
            let _ = writeln!(body, "<circle class=\"{fill}\" cx=\"{middle:.1}\" cy=\"{:.1}\" r=\"4\"/>", y.at(*value));
        }
        Shape::Line(points) => {
            let points = pixels(points.iter().copied(), x, y);
            let _ = writeln!(body, "<polyline class=\"{}\" points=\"{points}\"/>", class(mark.key));
        }
        Shape::Band(points) => {
            let upper = points.iter().map(|(at, _, high)| (*at, *high));
            let lower = points.iter().rev().map(|(at, low, _)| (*at, *low));
            let points = pixels(upper.chain(lower), x, y);
            let _ = writeln!(body, "<polygon class=\"area {fill}\" points=\"{points}\"/>");
        }
    }
}

fn area(body: &mut String, stroke: &str, fill: &str, (from, to): (f64, f64), (top, bottom): (f64, f64)) {
    let (width, height) = (to - from, (bottom - top).max(0.0));
    let _ = writeln!(
        body,
        "<rect class=\"body {stroke} {fill}\" x=\"{from:.1}\" y=\"{top:.1}\" width=\"{width:.1}\" height=\"{height:.1}\"/>"
    );
}

/// Points as an attribute; what is not finite is left out.
fn pixels(points: impl Iterator<Item = (f64, f64)>, x: &Scale, y: &Scale) -> String {
    let finite = points.filter(|(a, b)| a.is_finite() && b.is_finite());
    finite.map(|(a, b)| format!("{:.1},{:.1}", x.at(a), y.at(b))).collect::<Vec<_>>().join(" ")
}
