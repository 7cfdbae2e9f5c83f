//! Movements: groups as they are meant, keys that a hand goes back to, lengths in metres.

use super::value::{self, Names};
use crate::diagnostics::{Diagnostic, Span};
use crate::notation::syntax::{self, Ignored, Placed};
use crate::phonology::{Action, Becoming, Direction, Extent, Heading, Motion, Movement, Repeated};
use crate::time::Seconds;
use glam::DVec3;

/// The most parts that a tier's movements may have, each counted as often as it is performed.
const MOST_PARTS: usize = 1000;

impl Names<'_> {
    /// One movement for each interval.
    pub(super) fn movements(
        &self,
        written: &[syntax::Movement],
        span: Span,
        faults: &mut Vec<Diagnostic>,
    ) -> Vec<Movement> {
        let mut parts = 0;
        let mut out = Vec::with_capacity(written.len());
        for (interval, movement) in written.iter().enumerate() {
            check_returns(movement, interval, written.len() - 1 - interval, faults);
            match self.movement(movement, span, &mut parts, faults) {
                Some(movement) => out.push(movement),
                None => return Vec::new(),
            }
        }
        out
    }

    fn movement(
        &self,
        written: &syntax::Movement,
        span: Span,
        parts: &mut usize,
        faults: &mut Vec<Diagnostic>,
    ) -> Option<Movement> {
        *parts += 1;
        if *parts > MOST_PARTS {
            return too_many(span, faults);
        }
        let mut all = |movements: &[syntax::Movement]| {
            movements.iter().map(|m| self.movement(m, span, parts, faults)).collect::<Option<Vec<_>>>()
        };
        match written {
            syntax::Movement::Group { fused: true, parts } => all(parts).map(Movement::Fused),
            syntax::Movement::Group { fused: false, parts } => all(parts).map(Movement::Sequence),
            syntax::Movement::Together(parts) => all(parts).map(Movement::Together),
            syntax::Movement::Backwards(inner) => match &**inner {
                syntax::Movement::Group { fused: false, parts } => all(parts).map(Movement::Sequence),
                other => self.movement(other, span, parts, faults),
            }
            .map(|inner| Movement::Backwards(Box::new(inner))),
            syntax::Movement::Repeated(r) => {
                let (repetition, alternating) = (r.repetition, r.alternating);
                let before = *parts;
                let movement = self.movement(&r.movement, span, parts, faults)?;
                *parts += (*parts - before) * usize::from(repetition.times.saturating_sub(1));
                if *parts > MOST_PARTS {
                    return too_many(span, faults);
                }
                Some(Movement::Repeated(Box::new(Repeated { movement, repetition, alternating })))
            }
            syntax::Movement::Action(action) => {
                self.action(action, faults).map(|action| Movement::Action(Box::new(action)))
            }
        }
    }

    fn action(&self, written: &syntax::Action, faults: &mut Vec<Diagnostic>) -> Option<Action> {
        let before = faults.len();
        let mut to = |place: &Option<syntax::Placement>| place.as_ref().and_then(|p| self.placement(p, faults));
        let (target, brushing) = (to(&written.target), to(&written.brushing));
        let becoming = written.becoming.as_ref().map(|b| Box::new(self.becoming(b, faults)));
        (faults.len() == before).then(|| Action {
            motion: motion(&written.motion),
            target,
            brushing,
            manner: written.manner.clone(),
            repetition: written.repetition,
            duration: written.duration.map(|d| Seconds(d.seconds())),
            pace: written.pace.unwrap_or(1.0),
            alternating: written.alternating,
            becoming,
            names: written.names.clone(),
        })
    }

    fn becoming(&self, written: &syntax::Becoming, faults: &mut Vec<Diagnostic>) -> Becoming {
        if let Some(orientation) = &written.orientation {
            let placed = Placed { value: orientation.clone(), at: None, span: Ignored(Span::default()) };
            value::check_palms(&vec![placed], faults);
        }
        Becoming {
            configuration: written.configuration.as_ref().and_then(|c| self.configuration(c, faults)),
            orientation: written.orientation.as_ref().map(value::orientation),
            contact: written.contact.as_ref().map(value::contact),
        }
    }
}

fn too_many<T>(span: Span, faults: &mut Vec<Diagnostic>) -> Option<T> {
    faults.push(
        Diagnostic::fault(span, format!("this movement comes to more than {MOST_PARTS} parts"))
            .label("here")
            .hint("a sign this long is several signs"),
    );
    None
}

/// Faults for ways back to keys that the hand has not come to: `before` movements stand before this one, `after` behind it.
fn check_returns(written: &syntax::Movement, before: usize, after: usize, faults: &mut Vec<Diagnostic>) {
    match written {
        syntax::Movement::Action(action) => {
            if let syntax::Motion::Return(key) = action.motion
                && key.value > before + 1
            {
                faults.push(
                    Diagnostic::fault(key.span, format!("the hand has not been at key {} yet", key.value))
                        .label(format!("this movement begins at key {}", before + 1))
                        .hint("`back` goes to a key before it; key 1 is the start"),
                );
            }
        }
        syntax::Movement::Group { parts, .. } | syntax::Movement::Together(parts) => {
            parts.iter().for_each(|part| check_returns(part, before, after, faults));
        }
        syntax::Movement::Repeated(r) => check_returns(&r.movement, before, after, faults),
        // Keys in it count from the sign's end.
        syntax::Movement::Backwards(inner) => check_returns(inner, after, before, faults),
    }
}

fn extent(written: syntax::Extent) -> Extent {
    match written {
        syntax::Extent::Size(size) => Extent::Size(size),
        syntax::Extent::Length(length) => Extent::Metres(length.metres()),
    }
}

fn motion(written: &syntax::Motion) -> Motion {
    match *written {
        syntax::Motion::Hold => Motion::Hold,
        syntax::Motion::Change => Motion::Change,
        syntax::Motion::Return(key) => Motion::Return { key: key.value.saturating_sub(1) },
        syntax::Motion::Straight { direction, extent: e, overlay } => {
            Motion::Straight { direction, extent: extent(e), overlay }
        }
        syntax::Motion::Arc { direction, extent: e, bulge, depth, overlay } => Motion::Arc {
            direction,
            extent: extent(e),
            bulge: bulge.unwrap_or_else(|| default_bulge(direction).into()),
            depth,
            overlay,
        },
        syntax::Motion::Circle { axis, extent: e, start, turns, ellipse, growth, overlay } => {
            Motion::Circle { axis, extent: extent(e), start, turns, ellipse, growth, overlay }
        }
        syntax::Motion::Wrist(wrist, size) => Motion::Wrist(wrist, size),
        syntax::Motion::Wiggle(digits) => Motion::Wiggle(digits),
    }
}

/// The side to which an arc bulges where it is not said: up for a level one; for one that rises or falls, its
/// own level part (a scoop: `arc up-right` bulges right); out for one straight up or down.
///
/// ```
/// use chereme::notation::lower::default_bulge;
/// use chereme::phonology::Direction;
/// let toward = |text: &str| text.parse::<Direction>().unwrap().into();
/// assert_eq!(default_bulge(toward("left")), Direction::UP);
/// assert_eq!(default_bulge(toward("up-right")), Direction::RIGHT);
/// assert_eq!(default_bulge(toward("down")), Direction::OUT);
/// ```
pub fn default_bulge(direction: Heading) -> Direction {
    let v = direction.vector();
    let level = DVec3::new(v.x, 0.0, v.z);
    if v.y.abs() < 0.2 {
        Direction::UP
    } else if level.length() < 0.2 {
        Direction::OUT
    } else {
        Direction::nearest(level).unwrap_or(Direction::OUT)
    }
}
