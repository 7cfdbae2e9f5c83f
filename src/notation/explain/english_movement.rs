//! Movements in English words: noun phrases, so that they join with `then` and `while`.

use super::english::becoming;
use super::english_noun::{direction, fingers, grows, heading, length, number, place, placement};
use crate::phonology::{
    Action, Digits, Extent, Manner, Motion, Movement, Overlay, Repetition, RepetitionKind, Shift, Size, WristMotion,
};

/// What a hand changes to that only changes.
pub(super) const NEXT: &str = "the next posture";

pub(super) fn movement(v: &Movement) -> String {
    let parts = |all: &[Movement], by: &str| all.iter().map(part).collect::<Vec<_>>().join(by);
    match v {
        Movement::Action(action) => said(action),
        Movement::Sequence(all) => parts(all, ", then "),
        Movement::Together(all) => parts(all, " and at the same time "),
        Movement::Fused(all) => format!("blended into one: {}", parts(all, " and ")),
        Movement::Repeated(r) => {
            let turns = if r.alternating { ", the hands taking turns" } else { "" };
            format!("({}), the whole {}{turns}", movement(&r.movement), repeated(r.repetition))
        }
        Movement::Backwards(inner) => format!("backwards: {}", part(inner)),
    }
}

fn part(v: &Movement) -> String {
    match v {
        Movement::Action(_) => movement(v),
        Movement::Sequence(_)
        | Movement::Together(_)
        | Movement::Fused(_)
        | Movement::Repeated(_)
        | Movement::Backwards(_) => format!("({})", movement(v)),
    }
}

fn said(v: &Action) -> String {
    let mut text = motion(&v.motion);
    let mut add = |more: String| {
        text.push_str(", ");
        text.push_str(&more);
    };
    if let Some(target) = &v.target {
        add(format!("ending {}", placement(target)));
    }
    if let Some(brushed) = &v.brushing {
        add(format!("brushing {}", place(&brushed.place)));
    }
    v.manner.iter().for_each(|how| add(manner(*how).into()));
    if let Some(repetition) = v.repetition {
        add(repeated(repetition));
    }
    if let Some(long) = v.duration {
        add(format!("in {} s", number(long.0)));
    }
    if v.pace != 1.0 {
        add(format!("{} times as fast", number(v.pace)));
    }
    if v.alternating {
        add("the hands taking turns".into());
    }
    if let Some(posture) = &v.becoming {
        add(format!("the hand becoming meanwhile {}", becoming(posture)));
    }
    if let Some(name) = &v.names {
        add(format!("to a place that is named “{name}”"));
    }
    text
}

fn manner(v: Manner) -> &'static str {
    match v {
        Manner::Fast => "fast",
        Manner::Slow => "slowly",
        Manner::Tense => "tensely",
        Manner::Rest => "after a pause",
        Manner::Halt => "with a sudden stop",
        Manner::Bouncing => "bouncing back a little at its end",
        Manner::TowardPinky => "finger by finger, the little finger last",
        Manner::TowardThumb => "finger by finger, the thumb last",
    }
}

fn repeated(v: Repetition) -> String {
    let times = match v.times {
        1 => "once".to_owned(),
        2 => "twice".to_owned(),
        n => format!("{n} times"),
    };
    let mut text = match v.kind {
        RepetitionKind::FromStart => format!("{times} in all, each time from the start"),
        RepetitionKind::Continue => format!("{times} in all, each time from where it ended"),
        RepetitionKind::ToAndFro => format!("to and fro {times}"),
    };
    text.push_str(grows(v.growth));
    if let Some(Shift { direction: way, size }) = v.shift {
        let far = match size {
            Size::Small => "a little",
            Size::Normal => "some way",
            Size::Large => "far",
        };
        text.push_str(&format!(", moving {far} {} meanwhile", direction(way)));
    }
    text
}

fn motion(v: &Motion) -> String {
    match v {
        Motion::Hold => "a hold".into(),
        Motion::Change => format!("a change to {NEXT}"),
        Motion::Return { key: 0 } => "back to the start".into(),
        Motion::Return { key } => format!("back to posture {}", key + 1),
        Motion::Straight { direction, extent, overlay } => {
            format!("{} {}{}", sized("straight path", *extent), heading(*direction), waves(*overlay))
        }
        Motion::Arc { direction, extent, bulge, depth, overlay } => {
            let bend = match depth {
                Size::Small => "bending a little",
                Size::Normal => "bending",
                Size::Large => "bending far",
            };
            let arc = sized("arc", *extent);
            format!("{arc} {}, {bend} {}{}", heading(*direction), heading(*bulge), waves(*overlay))
        }
        Motion::Circle { axis, extent, start, turns, ellipse, growth, overlay } => {
            let mut text = match extent {
                Extent::Metres(metres) => format!("a circle of {} radius", length(*metres)),
                Extent::Size(_) => sized("circle", *extent),
            };
            text.push_str(&format!(", clockwise for one who looks {}", heading(*axis)));
            if start.eighths() != 0 {
                text.push_str(&format!(", from {}", hour(start.eighths())));
            }
            if *turns != 1.0 {
                text.push_str(&format!(", {} turns", number(*turns)));
            }
            if let Some((ratio, along)) = ellipse {
                text.push_str(&format!(", flattened to {}, its long axis {}", number(*ratio), direction(*along)));
            }
            text + grows(*growth) + &waves(*overlay)
        }
        Motion::Wrist(way, size) => wrist(*way, *size),
        Motion::Wiggle(digits) if digits.is_empty() || *digits == Digits::FINGERS => "the fingers playing".into(),
        Motion::Wiggle(digits) => format!("{} playing", fingers(*digits)),
    }
}

fn wrist(way: WristMotion, size: Size) -> String {
    let way = match way {
        WristMotion::Nod => "the wrist nodding",
        WristMotion::Swing => "the wrist swinging sideways",
        WristMotion::Twist => "the forearm twisting",
        WristMotion::StirClockwise => "the wrist stirring clockwise",
        WristMotion::StirCounterclockwise => "the wrist stirring counterclockwise",
    };
    match size {
        Size::Small => format!("{way} a little"),
        Size::Normal => way.into(),
        Size::Large => format!("{way} far"),
    }
}

/// `a small arc`, `an arc of 15 cm`.
fn sized(noun: &str, extent: Extent) -> String {
    let article = if noun.starts_with('a') { "an" } else { "a" };
    match extent {
        Extent::Size(Size::Small) => format!("a small {noun}"),
        Extent::Size(Size::Normal) => format!("{article} {noun}"),
        Extent::Size(Size::Large) => format!("a large {noun}"),
        Extent::Metres(metres) => format!("{article} {noun} of {}", length(metres)),
    }
}

fn waves(overlay: Option<Overlay>) -> String {
    let Some(Overlay { zigzag, size, across, growth }) = overlay else { return String::new() };
    let way = if zigzag { "zigzags" } else { "waves" };
    let mut text = match size {
        Size::Small => format!(", in small {way}"),
        Size::Normal => format!(", in {way}"),
        Size::Large => format!(", in large {way}"),
    };
    if let Some(across) = across {
        text.push_str(&format!(" that swing {}", direction(across)));
    }
    text + grows(growth)
}

/// The hour of a place on the clock face, in eighths of a turn from the top.
fn hour(eighths: u8) -> &'static str {
    ["12 o'clock", "1:30", "3 o'clock", "4:30", "6 o'clock", "7:30", "9 o'clock", "10:30"][usize::from(eighths % 8)]
}
