//! Single motions, and what may be said of each.

use super::action::GrowthWords;
use super::place::PLACES;
use super::reader::{Attr, Node, Reader, attributes, elements, tag_span};
use super::words::{ELLIPSE, SIZE, WAVE, WRIST, clock, roll};
use crate::notation::hamnosys::syntax::{Action, Circle, Clock, Ellipse, Motion, Move, Site, Straight, Times, Waves};
use crate::phonology::Size;
use crate::phonology::roll::Roll;

/// The elements that are one motion.
pub(super) const MOTIONS: [&str; 7] =
    ["directedmotion", "circularmotion", "wristmotion", "fingerplay", "nomotion", "no_motion", "crossmotion"];

/// What may be said of a motion.
#[derive(Default)]
pub(super) struct Manner {
    fast: bool,
    slow: bool,
    tense: bool,
    rest: bool,
    halt: bool,
    bouncing: bool,
    speed: Option<f64>,
    names: Option<String>,
    alternating: bool,
    second_alternating: bool,
}

impl Manner {
    /// Whether nothing is said but that hands take turns.
    pub(super) fn is_plain(&self) -> bool {
        let marks = [self.fast, self.slow, self.tense, self.rest, self.halt, self.bouncing];
        !marks.contains(&true) && self.speed.is_none() && self.names.is_none()
    }

    pub(super) fn alternating(&self) -> Option<Times> {
        match (self.alternating, self.second_alternating) {
            (false, false) => None,
            (true, true) => Some(Times::Twice),
            (true, false) | (false, true) => Some(Times::Once),
        }
    }

    /// Says it of a motion; what the motion says of its own speed and name holds.
    pub(super) fn apply(&self, moved: &mut Move) {
        moved.fast |= self.fast;
        moved.slow |= self.slow;
        moved.tense |= self.tense;
        moved.rest |= self.rest;
        moved.halt |= self.halt;
        moved.bouncing |= self.bouncing;
        moved.speed = moved.speed.or(self.speed);
        if moved.names.is_none() {
            moved.names.clone_from(&self.names);
        }
    }
}

/// Attributes of any motion.
const MANNERS: [&str; 11] = [
    "fast",
    "slow",
    "tense",
    "rest",
    "halt",
    "bouncing",
    "speed",
    "manner",
    "def_locname",
    "alternating",
    "second_alternating",
];

impl<'a> Reader<'a> {
    /// An attribute of any motion; `others` are those that its element has besides.
    pub(super) fn manner(&mut self, manner: &mut Manner, attr: &Attr, others: &[&'static str]) {
        let mark = match (attr.name, attr.value) {
            ("fast", _) | ("manner", "fast") => &mut manner.fast,
            ("slow", _) | ("manner", "slow") => &mut manner.slow,
            ("tense", _) | ("manner", "tense") => &mut manner.tense,
            ("rest", _) | ("manner", "rest") => &mut manner.rest,
            ("halt", _) | ("manner", "halt") => &mut manner.halt,
            ("bouncing", _) => &mut manner.bouncing,
            ("alternating", _) => &mut manner.alternating,
            ("second_alternating", _) => &mut manner.second_alternating,
            ("speed", _) => {
                manner.speed = self.factor(attr);
                return;
            }
            ("def_locname", _) => {
                manner.names = Some(attr.raw.to_owned());
                return;
            }
            ("manner", _) => {
                self.no_value(attr, "a manner", ["fast", "slow", "tense", "rest", "halt"].into_iter());
                return;
            }
            ("abs_motion", _) => return,
            _ => {
                self.unknown_attribute(attr, &[others, &MANNERS].concat());
                return;
            }
        };
        *mark |= attr.name == "manner" || self.truth(attr);
    }

    /// One motion.
    pub(super) fn movement(&mut self, node: Node<'a>) -> Option<Action> {
        let mut manner = Manner::default();
        let motion = match node.tag_name().name() {
            "directedmotion" => self.straight(node, &mut manner)?,
            "circularmotion" => self.circle(node, &mut manner)?,
            "wristmotion" => self.wrist(node, &mut manner)?,
            "fingerplay" => self.finger_play(node, &mut manner)?,
            name => {
                attributes(node).for_each(|attr| self.manner(&mut manner, &attr, &[]));
                if name == "crossmotion" { Motion::Cross } else { Motion::Nothing }
            }
        };
        let mut moved = Move::of(motion);
        moved.span.0 = tag_span(node);
        moved.brushing = self.brushing(node)?;
        manner.apply(&mut moved);
        Some(manner.alternate(Action::Move(Box::new(moved))))
    }

    /// The place that a motion brushes; `None` where it is at fault.
    fn brushing(&mut self, node: Node<'a>) -> Option<Option<Site>> {
        self.no_text(node);
        let mut site = None;
        for child in elements(node) {
            match child.tag_name().name() {
                "location_bodyarm" | "location_hand" | "use_locname" if site.is_none() => {
                    site = Some(self.site(child)?)
                }
                _ => self.unknown_element(child, &PLACES),
            }
        }
        Some(site)
    }

    fn straight(&mut self, node: Node<'a>, manner: &mut Manner) -> Option<Motion> {
        let (mut direction, mut arc, mut size) = ([None, None], [None, None], Size::Normal);
        let (mut growth, mut waves, mut plane) = (GrowthWords::default(), WaveWords::default(), None);
        for attr in attributes(node) {
            match attr.name {
                "direction" => direction[0] = Some(attr),
                "second_direction" => direction[1] = Some(attr),
                "size" => size = self.size(&attr),
                "curve" => arc[0] = Some(attr),
                "curve_size" => arc[1] = Some(attr),
                "zigzag_style" => waves.style = Some(attr),
                "zigzag_size" => waves.size = Some(attr),
                "ellipse_direction" => plane = Some(attr),
                "incrdecr" => growth.change = Some(attr),
                "incrdecr_size" => growth.size = Some(attr),
                _ => self.manner(manner, &attr, &["direction", "second_direction", "size", "curve", "curve_size"]),
            }
        }
        let [Some(first), second] = direction else { return self.missing(node, "direction") };
        let (direction, between) = self.direction(&first, second)?;
        let arc = self.arc(arc);
        let mut waves = self.waves(&waves);
        match (&mut waves, plane) {
            (Some(waves), Some(attr)) => waves.plane = self.value(&attr, &ELLIPSE),
            (None, Some(attr)) => self.odd(&attr, "only waves lie in a plane of their own: passed over"),
            (_, None) => {}
        }
        let growth = self.growth(&growth);
        Some(Motion::Straight(Straight { direction, size, between, arc, waves, growth }))
    }

    fn circle(&mut self, node: Node<'a>, manner: &mut Manner) -> Option<Motion> {
        let (mut axis, mut size, mut ellipse, mut ellipse_size) = ([None, None], Size::Normal, None, None);
        let (mut start, mut end, mut full, mut again) = (None, None, false, false);
        let (mut growth, mut waves) = (GrowthWords::default(), WaveWords::default());
        for attr in attributes(node) {
            match attr.name {
                "axis" => axis[0] = Some(attr),
                "second_axis" => axis[1] = Some(attr),
                "size" => size = self.size(&attr),
                "start" => start = self.clock(&attr),
                "end" => end = self.clock(&attr),
                "clockplus" => full = self.truth(&attr),
                "second_clockplus" => again = self.truth(&attr),
                "ellipse_direction" => ellipse = self.value(&attr, &ELLIPSE),
                "ellipse_size" => ellipse_size = Some(attr),
                "zigzag_style" => waves.style = Some(attr),
                "zigzag_size" => waves.size = Some(attr),
                "incrdecr" => growth.change = Some(attr),
                "incrdecr_size" => growth.size = Some(attr),
                _ => self.manner(manner, &attr, &["axis", "second_axis", "size", "start", "end", "clockplus"]),
            }
        }
        let [Some(first), second] = axis else { return self.missing(node, "axis") };
        let (axis, between) = self.direction(&first, second)?;
        let full = match (full, again) {
            (false, false) => None,
            (true, true) => Some(Times::Twice),
            (true, false) | (false, true) => Some(Times::Once),
        };
        let ellipse = self.ellipse(ellipse, ellipse_size);
        let (waves, growth) = (self.waves(&waves), self.growth(&growth));
        Some(Motion::Circle(Circle { axis, size, between, start, full, end, ellipse, waves, growth }))
    }

    fn ellipse(&mut self, axis: Option<Ellipse>, size: Option<Attr>) -> Option<(Ellipse, Size)> {
        match (axis, size) {
            (Some(axis), size) => Some((axis, size.map_or(Size::Normal, |attr| self.size(&attr)))),
            (None, Some(attr)) => {
                self.odd(&attr, "this says nothing without `ellipse_direction`: passed over");
                None
            }
            (None, None) => None,
        }
    }

    fn wrist(&mut self, node: Node<'a>, manner: &mut Manner) -> Option<Motion> {
        let (mut motion, mut size) = (None, Size::Normal);
        for attr in attributes(node) {
            match attr.name {
                "motion" => motion = Some(attr),
                "size" => size = self.size(&attr),
                _ => self.manner(manner, &attr, &["motion", "size"]),
            }
        }
        let Some(motion) = motion else { return self.missing(node, "motion") };
        Some(Motion::Wrist(self.value(&motion, &WRIST)?, size))
    }

    fn finger_play(&mut self, node: Node<'a>, manner: &mut Manner) -> Option<Motion> {
        let mut digits = Vec::new();
        for attr in attributes(node) {
            match attr.name {
                "digits" => digits = self.digits(&attr)?,
                _ => self.manner(manner, &attr, &["digits"]),
            }
        }
        Some(Motion::FingerPlay(digits))
    }

    fn missing(&mut self, node: Node<'a>, name: &str) -> Option<Motion> {
        let message = format!("`{}` has no `{name}`", node.tag_name().name());
        self.say(self.fault(tag_span(node), &message).label(format!("expected `{name}=\"…\"`")));
        None
    }

    fn size(&mut self, attr: &Attr) -> Size {
        self.value(attr, &SIZE).unwrap_or(Size::Normal)
    }

    fn clock(&mut self, attr: &Attr) -> Option<Clock> {
        let found = clock(attr.value);
        if found.is_none() {
            self.no_value(attr, "a place of the clock face", Roll::TAGS.into_iter());
        }
        found
    }

    /// The bend of a path.
    fn arc(&mut self, [toward, size]: [Option<Attr>; 2]) -> Option<(Roll, Size)> {
        match (toward, size) {
            (Some(attr), size) => {
                let found = roll(attr.value);
                if found.is_none() {
                    self.no_value(&attr, "the side of a bend", Roll::TAGS.into_iter());
                }
                found.map(|toward| (toward, size.map_or(Size::Normal, |attr| self.size(&attr))))
            }
            (None, Some(attr)) => {
                self.odd(&attr, "`curve_size` says nothing without `curve`: passed over");
                None
            }
            (None, None) => None,
        }
    }

    fn waves(&mut self, words: &WaveWords) -> Option<Waves> {
        match (words.style, words.size) {
            (Some(attr), size) => {
                let size = size.map_or(Size::Normal, |attr| self.size(&attr));
                self.value(&attr, &WAVE).map(|style| Waves { style, size, plane: None })
            }
            (None, Some(attr)) => {
                self.odd(&attr, "`zigzag_size` says nothing without `zigzag_style`: passed over");
                None
            }
            (None, None) => None,
        }
    }
}

#[derive(Default)]
struct WaveWords<'a> {
    style: Option<Attr<'a>>,
    size: Option<Attr<'a>>,
}
