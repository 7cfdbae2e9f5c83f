//! Movements to the actions that HamNoSys writes.

use super::super::lower::action::{drawn, flatness};
use super::super::lower::orientation::eighths;
use super::super::syntax::{
    Action, Change, Circle, Ellipse, Growth, Location, Motion, Move, Posture, Repetition, RepetitionKind, Shift, Split,
    Straight, Successive, Times, WaveStyle, Waves,
};
use super::phase::Raising;
use super::{location, orientation};
use crate::phonology::roll::Roll;
use crate::phonology::{self, Becoming, Clock, Direction, Extent, Hand, Heading, Manner, Movement, Overlay, Size};

/// What the key after an interval changes of a hand's posture: the first plain change of the movement takes it.
pub(super) type Pending = Option<Posture>;

impl Raising<'_> {
    /// A movement as an action; `pending` is taken by the change that it belongs to.
    pub(super) fn action(&mut self, movement: &Movement, hand: Hand, pending: &mut Pending) -> Action {
        let mut all = |raising: &mut Self, parts: &[Movement]| -> Vec<Action> {
            parts.iter().map(|m| raising.action(m, hand, pending)).collect()
        };
        match movement {
            Movement::Action(action) => self.single(action, hand, pending),
            Movement::Together(parts) => {
                let mut written = all(self, parts);
                // A change that another one has said already adds nothing.
                let says = |a: &Action| !matches!(a, Action::Move(one) if one.motion == Motion::Nothing);
                if written.iter().any(says) {
                    written.retain(says);
                }
                match (written.len(), written.pop()) {
                    (1, Some(one)) => one,
                    (_, last) => {
                        written.extend(last);
                        Action::Together(written)
                    }
                }
            }
            // Within a sequence a change says itself what it changes.
            Movement::Sequence(parts) => Action::Sequence(self.inside(parts, hand)),
            Movement::Fused(parts) => Action::Fused(self.inside(parts, hand)),
            Movement::Repeated(r) => {
                let there_and_back = r.repetition.kind == phonology::RepetitionKind::ToAndFro;
                let inner = match there_and_back {
                    true => self.action(&r.movement, hand, &mut None),
                    false => self.action(&r.movement, hand, pending),
                };
                let repeated = self.repeated(inner, r.repetition);
                if r.alternating { alternating(repeated) } else { repeated }
            }
            Movement::Backwards(_) => {
                self.fail("HamNoSys has no movements backwards");
                Action::Move(Box::new(Move::of(Motion::Nothing)))
            }
        }
    }

    fn inside(&mut self, parts: &[Movement], hand: Hand) -> Vec<Action> {
        parts.iter().map(|m| self.action(m, hand, &mut None)).collect()
    }

    fn single(&mut self, action: &phonology::Action, hand: Hand, pending: &mut Pending) -> Action {
        let becoming = action.becoming.as_ref().map(|b| (self.becoming(b, hand), b.contact));
        let (changed, contact) = becoming.unwrap_or_default();
        let plain = matches!(action.motion, phonology::Motion::Change);
        let mut one = Move::of(self.motion(&action.motion));
        let mut beside = None;
        if plain {
            let own = if changed.is_empty() { pending.take() } else { Some(changed) };
            one.motion = own.map_or(Motion::Nothing, Motion::Replace);
        } else if !changed.is_empty() {
            beside = Some(changed);
        }
        self.manner(action, &mut one);
        one.names.clone_from(&action.names);
        if let Some(place) = &action.brushing {
            one.brushing = self.ok(location::site(place, hand, self.dictionary));
        }
        let mut written = Action::Move(Box::new(one));
        if let Some(posture) = beside {
            let replace = Action::Move(Box::new(Move::of(Motion::Replace(posture))));
            written = Action::Together(vec![written, replace]);
        }
        if let Some(contact) = contact {
            let met = self.ok(location::constellation(&contact, None, self.dictionary));
            written = target(written, met.map(Location::Constellation));
        }
        if let Some(place) = &action.target {
            let site = self.ok(location::site(place, hand, self.dictionary));
            written = target(written, site.map(Location::One));
        }
        if action.duration.is_some() {
            self.warn("HamNoSys has no durations of single movements");
        }
        if let Some(repetition) = action.repetition {
            written = self.repeated(written, repetition);
        }
        if action.alternating { alternating(written) } else { written }
    }

    /// A posture that a bracket changes to.
    fn becoming(&mut self, becoming: &Becoming, hand: Hand) -> Posture {
        let shape = becoming.configuration.as_ref().and_then(|c| self.shape(c));
        let (fingers, palm) = match &becoming.orientation {
            None => (None, None),
            Some(o) => {
                let known = self.known(hand);
                let palm = orientation::palm(o, known.heading);
                let fingers = orientation::fingers(o);
                let (fingers, palm) = known.changed(fingers, palm);
                known.take(o, fingers, palm);
                (fingers, palm)
            }
        };
        Posture { shape: shape.map(Split::Both), fingers: fingers.map(Split::Both), palm: palm.map(Split::Both) }
    }

    fn manner(&mut self, action: &phonology::Action, one: &mut Move) {
        if action.pace != 1.0 {
            one.speed = Some(action.pace);
        }
        for manner in &action.manner {
            match manner {
                Manner::Fast => one.fast = true,
                Manner::Slow => one.slow = true,
                Manner::Tense => one.tense = true,
                Manner::Rest => one.rest = true,
                Manner::Halt => one.halt = true,
                Manner::Bouncing => one.bouncing = true,
                Manner::TowardPinky => self.successive(one, Successive::TowardPinky),
                Manner::TowardThumb => self.successive(one, Successive::TowardThumb),
            }
        }
    }

    fn successive(&mut self, one: &mut Move, way: Successive) {
        if let Motion::Replace(Posture { shape: Some(shape), .. }) = &mut one.motion {
            match shape {
                Split::Both(shape) => shape.successive = Some(way),
                Split::Each(a, b) => a.iter_mut().chain(b).for_each(|s| s.successive = Some(way)),
            }
        } else {
            self.warn("fingers change one after the other where the hand shape changes");
        }
    }

    fn motion(&mut self, motion: &phonology::Motion) -> Motion {
        match motion {
            phonology::Motion::Hold | phonology::Motion::Change => Motion::Nothing,
            phonology::Motion::Return { .. } => {
                self.fail("HamNoSys has no way back to an earlier posture");
                Motion::Nothing
            }
            phonology::Motion::Straight { direction, extent, overlay } => {
                Motion::Straight(self.straight(*direction, *extent, None, *overlay))
            }
            phonology::Motion::Arc { direction, extent, bulge, depth, overlay } => {
                let side = nearest_quarter(*direction, *bulge);
                Motion::Straight(self.straight(*direction, *extent, Some((side, *depth)), *overlay))
            }
            phonology::Motion::Circle { axis, extent, start, turns, ellipse, growth, overlay } => {
                let (axis_of, between) = ends(*axis);
                let (full, end) = self.turns(*turns, *start);
                Motion::Circle(Circle {
                    axis: axis_of,
                    size: self.size(*extent, [0.035, 0.075]),
                    between,
                    start: (*start != Clock::default() || end.is_some()).then_some(*start),
                    full,
                    end,
                    ellipse: ellipse.map(|(flat, long)| (drawn_as(long, *axis), flat_size(flat))),
                    waves: overlay.map(|o| waves(o, *axis)),
                    growth: growth_of(*growth),
                })
            }
            phonology::Motion::Wrist(motion, size) => Motion::Wrist(*motion, *size),
            phonology::Motion::Wiggle(digits) => Motion::FingerPlay(digits.iter().collect()),
        }
    }

    fn straight(
        &mut self,
        direction: Heading,
        extent: Extent,
        arc: Option<(Roll, Size)>,
        overlay: Option<Overlay>,
    ) -> Straight {
        let (direction_of, between) = ends(direction);
        Straight {
            direction: direction_of,
            size: self.size(extent, [0.09, 0.16]),
            between,
            arc,
            waves: overlay.map(|o| waves(o, direction)),
            growth: overlay.and_then(|o| growth_of(o.growth)),
        }
    }

    /// A size; lengths in metres are the nearest one, with a warning.
    fn size(&mut self, extent: Extent, bounds: [f64; 2]) -> Size {
        match extent {
            Extent::Size(size) => size,
            Extent::Metres(metres) => {
                self.warn("HamNoSys has three sizes: lengths in centimetres are written as the nearest");
                match metres {
                    m if m < bounds[0] => Size::Small,
                    m if m < bounds[1] => Size::Normal,
                    _ => Size::Large,
                }
            }
        }
    }

    /// Full turns and the end of a circle.
    fn turns(&mut self, turns: f64, start: Clock) -> (Option<Times>, Option<Clock>) {
        let eighths = (turns * 8.0).round();
        if (eighths - turns * 8.0).abs() > 0.01 {
            self.warn("HamNoSys counts circles in eighths of a turn");
        }
        let eighths = eighths.clamp(1.0, 24.0) as u8;
        let (whole, part) = (eighths / 8, eighths % 8);
        if turns > 3.0 {
            self.warn("HamNoSys has no circles of more than three turns");
        }
        let end = Clock::new((start.eighths() + part) % 8).filter(|_| part > 0);
        // A single turn goes without saying; with an end, full turns come before it.
        let full = match (whole, part) {
            (0, _) | (1, 0) => None,
            (1, _) | (2, 0) => Some(Times::Once),
            (_, _) => Some(Times::Twice),
        };
        (full, end)
    }

    fn repeated(&mut self, action: Action, r: phonology::Repetition) -> Action {
        use RepetitionKind as Kind;
        let (one, several, again) = match r.kind {
            phonology::RepetitionKind::FromStart => {
                (Kind::FromStart, Kind::FromStartSeveral, r.times.saturating_sub(1))
            }
            phonology::RepetitionKind::Continue => (Kind::Continue, Kind::ContinueSeveral, r.times.saturating_sub(1)),
            phonology::RepetitionKind::ToAndFro => (Kind::Reverse, Kind::ToFroTo, r.times),
        };
        let (kind, second) = match (again, r.kind) {
            (0 | 1, _) => (one, None),
            (2, phonology::RepetitionKind::ToAndFro) => (one, Some(one)),
            (2, _) => (several, None),
            (3, _) => (one, Some(several)),
            (_, _) => (several, Some(several)),
        };
        if again > 4 {
            self.warn("HamNoSys counts no more than five performances");
        }
        let shift = r.shift.map(|s| Shift { direction: s.direction, size: s.size, growth: None });
        let repetition = Repetition { kind, second, approximate: false, growth: growth_of(r.growth), shift };
        Action::Repeated(Box::new(action), repetition)
    }
}

fn target(action: Action, location: Option<Location>) -> Action {
    match location {
        Some(location) => Action::Target(Box::new(action), Box::new(location)),
        None => action,
    }
}

fn alternating(action: Action) -> Action {
    Action::Alternating(Box::new(action), Times::Once)
}

/// A heading as one direction or two.
fn ends(heading: Heading) -> (Direction, Option<Direction>) {
    match heading {
        Heading::Toward(d) => (d, None),
        Heading::Between(a, b) => (a, Some(b)),
    }
}

/// The arc symbol (up, right, down, left as drawn) nearest to a bulge.
fn nearest_quarter(direction: Heading, bulge: Heading) -> Roll {
    let along = direction.vector();
    let quarters = Roll::all().filter(|r| eighths(*r).is_multiple_of(2));
    let nearest = quarters.max_by(|a, b| {
        let near = |r: &Roll| r.palm(along).dot(bulge.vector());
        near(a).total_cmp(&near(b))
    });
    nearest.unwrap_or_else(|| Roll::nearest(along, bulge.vector()))
}

fn waves(overlay: Overlay, along: Heading) -> Waves {
    let style = if overlay.zigzag { WaveStyle::Zigzag } else { WaveStyle::Wavy };
    Waves { style, size: overlay.size, plane: overlay.across.map(|d| drawn_as(d, along)) }
}

/// The ellipse symbol that is drawn nearest to a direction.
fn drawn_as(long: Direction, across: Heading) -> Ellipse {
    let all = [Ellipse::Horizontal, Ellipse::Vertical, Ellipse::UpRight, Ellipse::UpLeft];
    let near = |e: &Ellipse| drawn(*e, across).vector().dot(long.vector()).abs();
    all.into_iter().max_by(|a, b| near(a).total_cmp(&near(b))).unwrap_or(Ellipse::Horizontal)
}

fn flat_size(flat: f64) -> Size {
    let off = |size: &Size| (flatness(*size) - flat).abs();
    let all = [Size::Normal, Size::Small, Size::Large];
    all.into_iter().min_by(|a, b| off(a).total_cmp(&off(b))).unwrap_or_default()
}

fn growth_of(growth: i8) -> Option<Growth> {
    let change = match growth.signum() {
        1 => Change::Increasing,
        -1 => Change::Decreasing,
        _ => return None,
    };
    Some(Growth { change, size: Size::Normal })
}
