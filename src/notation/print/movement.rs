//! Movements as text.

use super::words::{configuration, contact, digits, duration, growth, orientation, placement};
use crate::notation::lex::quote;
use crate::notation::parse::motion::{CLOCK, size_name};
use crate::notation::syntax::{Action, Becoming, Extent, Motion, Movement};
use crate::phonology::{Overlay, Repetition, RepetitionKind, Size};

/// Movements of the intervals, joined by `then`.
pub(super) fn movements(all: &[Movement]) -> String {
    let all: Vec<String> = all.iter().map(movement_text).collect();
    all.join(" then ")
}

/// One movement as text.
pub fn movement_text(v: &Movement) -> String {
    match v {
        Movement::Action(action) => action_text(action),
        Movement::Group { fused, parts } => format!("{}( {} )", if *fused { "fused " } else { "" }, movements(parts)),
        Movement::Backwards(inner) => match &**inner {
            Movement::Group { fused: false, .. } => format!("backwards {}", movement_text(inner)),
            other => format!("backwards ( {} )", movement_text(other)),
        },
        Movement::Together(parts) => {
            let parts: Vec<String> = parts
                .iter()
                .map(|p| match p {
                    Movement::Together(_) => format!("( {} )", movement_text(p)),
                    other => movement_text(other),
                })
                .collect();
            parts.join(" while ")
        }
        Movement::Repeated(r) => {
            let inside = match &r.movement {
                Movement::Group { fused: false, .. } => movement_text(&r.movement),
                other => format!("( {} )", movement_text(other)),
            };
            let turns = if r.alternating { " alternating" } else { "" };
            format!("{inside} {}{turns}", repetition_text(r.repetition))
        }
    }
}

fn action_text(v: &Action) -> String {
    let mut text = match (&v.motion, &v.target) {
        (Motion::Change, Some(place)) => format!("to {}", placement(place)),
        (motion, Some(place)) => format!("{} to {}", motion_text(motion), placement(place)),
        (motion, None) => motion_text(motion),
    };
    if let Some(place) = &v.brushing {
        text.push_str(&format!(", brushing {}", placement(place)));
    }
    for manner in &v.manner {
        text.push_str(&format!(", {}", manner.name()));
    }
    if let Some(r) = v.repetition {
        text.push_str(&format!(", {}", repetition_text(r)));
    }
    if let Some(long) = v.duration {
        text.push_str(&format!(", duration {}", duration(long)));
    }
    if let Some(pace) = v.pace {
        text.push_str(&format!(", speed {pace}"));
    }
    if v.alternating {
        text.push_str(", alternating");
    }
    if let Some(posture) = &v.becoming {
        text.push_str(&format!(", becoming ( {} )", becoming(posture)));
    }
    if let Some(name) = &v.names {
        text.push_str(&format!(", named {}", quote(name)));
    }
    text
}

fn becoming(v: &Becoming) -> String {
    let shape = v.configuration.as_ref().map(|c| format!("configuration {}", configuration(c)));
    let turned = v.orientation.as_ref().map(|o| format!("orientation {}", orientation(o)));
    let meets = v.contact.as_ref().map(|c| format!("contact {}", contact(c)));
    [shape, turned, meets].into_iter().flatten().collect::<Vec<_>>().join(" and ")
}

fn motion_text(v: &Motion) -> String {
    match v {
        Motion::Hold => "hold".to_owned(),
        Motion::Change => "change".to_owned(),
        Motion::Return(key) if key.value == 1 => "back".to_owned(),
        Motion::Return(key) => format!("back to key {}", key.value),
        Motion::Straight { direction, extent: e, overlay: o } => format!("{direction}{}{}", extent(*e), overlay(*o)),
        Motion::Arc { direction, extent: e, bulge, depth, overlay: o } => {
            let bulge = bulge.map(|b| format!(" bulging {b}")).unwrap_or_default();
            let depth = if *depth == Size::Normal { String::new() } else { format!(" {} bend", size_name(*depth)) };
            format!("arc {direction}{}{bulge}{depth}{}", extent(*e), overlay(*o))
        }
        Motion::Circle { axis, extent: e, start, turns, ellipse, growth: g, overlay: o } => {
            let radius = match e {
                Extent::Size(_) => extent(*e),
                Extent::Length(length) => format!(" radius {length}"),
            };
            let from = match CLOCK.get(usize::from(start.eighths())) {
                Some(hour) if start.eighths() > 0 => format!(" from {hour}"),
                _ => String::new(),
            };
            let turns = if *turns == 1.0 { String::new() } else { format!(" turns {turns}") };
            let flat = ellipse.map(|(part, long)| format!(" flattened {part} along {long}")).unwrap_or_default();
            format!("circle axis {axis}{radius}{from}{turns}{flat}{}{}", growth(*g), overlay(*o))
        }
        Motion::Wrist(wrist, size) => format!("{}{}", wrist.name(), extent(Extent::Size(*size))),
        Motion::Wiggle(fingers) if fingers.is_empty() => "wiggle".to_owned(),
        Motion::Wiggle(fingers) => format!("wiggle {}", digits(*fingers)),
    }
}

fn extent(v: Extent) -> String {
    match v {
        Extent::Size(Size::Normal) => String::new(),
        Extent::Size(size) => format!(" {}", size_name(size)),
        Extent::Length(length) => format!(" {length}"),
    }
}

fn overlay(v: Option<Overlay>) -> String {
    let Some(o) = v else { return String::new() };
    let across = o.across.map(|way| format!(" across {way}")).unwrap_or_default();
    let kind = if o.zigzag { "zigzag" } else { "wavy" };
    format!(" {kind}{}{across}{}", extent(Extent::Size(o.size)), growth(o.growth))
}

fn repetition_text(v: Repetition) -> String {
    let word = match v.kind {
        RepetitionKind::FromStart => "repeated",
        RepetitionKind::Continue => "continued",
        RepetitionKind::ToAndFro => "to and fro",
    };
    let times = if v.times == 1 { "once".to_owned() } else { v.times.to_string() };
    let shift = v.shift.map(|s| format!(" moving {}{}", s.direction, extent(Extent::Size(s.size)))).unwrap_or_default();
    format!("{word} {times}{}{shift}", growth(v.growth))
}
