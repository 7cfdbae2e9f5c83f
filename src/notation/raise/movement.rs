//! Movements as one would write them.

use super::{configuration, contact, duration, orientation, placement, plain};
use crate::notation::lower::default_bulge;
use crate::notation::syntax::{self, Length};
use crate::phonology::{Becoming, Extent, Motion, Movement};

fn extent(v: Extent) -> syntax::Extent {
    match v {
        Extent::Size(size) => syntax::Extent::Size(size),
        Extent::Metres(far) => syntax::Extent::Length(Length::from_metres(far)),
    }
}

/// A movement as one would write it.
pub(crate) fn movement(v: &Movement) -> syntax::Movement {
    let all = |parts: &[Movement]| parts.iter().map(movement).collect::<Vec<_>>();
    match v {
        Movement::Sequence(parts) => syntax::Movement::Group { fused: false, parts: all(parts) },
        Movement::Fused(parts) => syntax::Movement::Group { fused: true, parts: all(parts) },
        Movement::Together(parts) => syntax::Movement::Together(all(parts)),
        Movement::Repeated(r) => syntax::Movement::Repeated(Box::new(syntax::Repeated {
            movement: movement(&r.movement),
            repetition: r.repetition,
            alternating: r.alternating,
        })),
        Movement::Backwards(inner) => syntax::Movement::Backwards(Box::new(movement(inner))),
        Movement::Action(action) => syntax::Movement::Action(Box::new(syntax::Action {
            motion: motion(&action.motion),
            target: action.target.as_ref().map(placement),
            brushing: action.brushing.as_ref().map(placement),
            manner: action.manner.clone(),
            repetition: action.repetition,
            duration: action.duration.map(|d| duration(d.0)),
            pace: (action.pace != 1.0).then_some(action.pace),
            alternating: action.alternating,
            becoming: action.becoming.as_deref().filter(|b| !b.is_empty()).map(|b| Box::new(becoming(b))),
            names: action.names.clone(),
        })),
    }
}

fn motion(v: &Motion) -> syntax::Motion {
    match *v {
        Motion::Hold => syntax::Motion::Hold,
        Motion::Change => syntax::Motion::Change,
        Motion::Return { key } => syntax::Motion::Return(plain(key + 1)),
        Motion::Straight { direction, extent: e, overlay } => {
            syntax::Motion::Straight { direction, extent: extent(e), overlay }
        }
        Motion::Arc { direction, extent: e, bulge, depth, overlay } => syntax::Motion::Arc {
            direction,
            extent: extent(e),
            bulge: (bulge != default_bulge(direction).into()).then_some(bulge),
            depth,
            overlay,
        },
        Motion::Circle { axis, extent: e, start, turns, ellipse, growth, overlay } => {
            syntax::Motion::Circle { axis, extent: extent(e), start, turns, ellipse, growth, overlay }
        }
        Motion::Wrist(wrist, size) => syntax::Motion::Wrist(wrist, size),
        Motion::Wiggle(digits) => syntax::Motion::Wiggle(digits),
    }
}

fn becoming(v: &Becoming) -> syntax::Becoming {
    syntax::Becoming {
        configuration: v.configuration.as_ref().map(configuration),
        orientation: v.orientation.as_ref().map(orientation),
        contact: v.contact.map(contact),
    }
}
