//! The tiers of a synthesized sign: what each stretch of the motion is, and where it came from.

use super::plan::HandPlan;
use super::side_of;
use super::symmetry::{acts, resolve};
use super::timeline::Timeline;
use crate::phonology::{
    Action, Configuration, Contact, ContactKind, Distance, Hand, HandshapeChange, Keys, Motion, Movement, NonManual,
    NonManualValue, Orientation, Place, Placement, Side, Sign,
};
use crate::tier::Tier;
use crate::time::Seconds;

const STATED: &str = "description";
const FOLLOWS: &str = "description, by symmetry";
const PROCEDURE: &str = "procedure";

/// The tiers of a sign, hand by hand, then contact and non-manuals.
pub(super) fn of_sign(sign: &Sign, timeline: &Timeline, plans: &[HandPlan]) -> Vec<Tier> {
    let mut tiers = Vec::new();
    for hand in Hand::BOTH {
        let side = side_of(hand);
        if !acts(sign, hand) || !plans.iter().any(|p| p.side == side) {
            continue;
        }
        let prefix = match side {
            Side::Left => "LH",
            Side::Right => "RH",
        };
        let said = resolve(sign, hand);
        let own = match hand {
            Hand::Strong => &sign.strong,
            Hand::Weak => &sign.weak,
        };
        let source = |own: bool| if own { STATED } else { FOLLOWS };
        let mut gloss = Tier::new(format!("{prefix} Gloss"));
        gloss.push(Seconds(timeline.stroke), Seconds(timeline.hold_end), &sign.name, STATED);
        tiers.push(gloss);
        tiers.push(phases(&format!("{prefix} Phase"), timeline, sign.intervals));
        let configuration = source(!own.configuration.is_empty());
        tiers.push(keyed(
            &format!("{prefix} Configuration"),
            &said.configuration,
            timeline,
            configuration_label,
            configuration,
        ));
        let placement = source(!own.placement.is_empty());
        tiers.push(keyed(&format!("{prefix} Placement"), &said.placement, timeline, placement_label, placement));
        let orientation = source(!own.orientation.is_empty());
        tiers.push(keyed(
            &format!("{prefix} Orientation"),
            &said.orientation,
            timeline,
            orientation_label,
            orientation,
        ));
        let mut movement = Tier::new(format!("{prefix} Movement"));
        for (i, m) in said.movement.iter().enumerate() {
            let span = (timeline.keys.get(i), timeline.keys.get(i + 1));
            if let (Some(start), Some(end)) = span {
                movement.push(Seconds(*start), Seconds(*end), movement_label(m), source(!own.movement.is_empty()));
            }
        }
        tiers.push(movement);
    }
    if !sign.contact.is_empty() {
        tiers.push(keyed("Contact", &sign.contact, timeline, contact_label, STATED));
    }
    for (channel, values) in &sign.nonmanual {
        tiers.push(keyed(&channel.title(), values, timeline, non_manual_label, STATED));
    }
    tiers.retain(|t| !t.values().is_empty());
    tiers
}

fn phases(name: &str, timeline: &Timeline, intervals: usize) -> Tier {
    let mut tier = Tier::new(name);
    let stroke_end = timeline.keys.last().copied().unwrap_or(timeline.stroke);
    let spans = [
        (timeline.start, timeline.stroke, "preparation"),
        (timeline.stroke, stroke_end, "stroke"),
        (stroke_end, timeline.hold_end, "hold"),
        (timeline.hold_end, timeline.retracted, "retraction"),
    ];
    for (start, end, label) in spans {
        if end > start && (label != "stroke" || intervals > 0) {
            tier.push(Seconds(start), Seconds(end), label, PROCEDURE);
        }
    }
    tier
}

/// Values at keys as spans: each holds from its key to the next stated one.
fn keyed<T>(name: &str, keys: &Keys<T>, timeline: &Timeline, label: fn(&T) -> String, source: &str) -> Tier {
    let mut tier = Tier::new(name);
    let stated: Vec<(usize, &T)> = keys.iter().collect();
    for (i, (key, value)) in stated.iter().enumerate() {
        let at = |k: usize| timeline.keys.get(k).copied().unwrap_or(timeline.hold_end);
        let start = if i == 0 { timeline.stroke } else { at(*key) };
        let end = stated.get(i + 1).map_or(timeline.hold_end, |(next, _)| at(*next));
        tier.push(Seconds(start), Seconds(end), label(value), source);
    }
    tier
}

fn configuration_label(c: &Configuration) -> String {
    let mut label = c.base.clone();
    if let Some(other) = &c.between {
        label += &format!("–{other}");
    }
    for change in &c.changes {
        label += match change {
            HandshapeChange::Thumb(_) => ", thumb",
            HandshapeChange::Bend(..) => ", bent",
            HandshapeChange::Spread(true) => ", spread",
            HandshapeChange::Spread(false) => ", together",
            HandshapeChange::Cross(..) => ", crossed",
            HandshapeChange::ThumbBetween(..) => ", thumb between",
        };
    }
    label
}

fn placement_label(p: &Placement) -> String {
    let mut label = place_label(&p.place);
    if let Some(lateral) = p.lateral {
        let side = match lateral.side {
            Side::Left => "left",
            Side::Right => "right",
        };
        label += &format!(" {side}{}", if lateral.beside { " beside" } else { "" });
    }
    label += match p.distance {
        Distance::Unmarked => "",
        Distance::Touch => ", touch",
        Distance::Close => ", close",
        Distance::Neutral => ", neutral",
        Distance::Extended => ", extended",
        Distance::Metres(_) => ", away",
    };
    label
}

fn place_label(place: &Place) -> String {
    match place {
        Place::Body(name) => name.clone(),
        Place::OtherHand(point) => format!("other {point}"),
        Place::Space(_) => "space".into(),
        Place::Point(p) => format!("({:.2}, {:.2}, {:.2})", p.x, p.y, p.z),
        Place::Between(a, b) => format!("{}–{}", place_label(a), place_label(b)),
        Place::Referent(name) => format!("referent {name}"),
    }
}

fn orientation_label(o: &Orientation) -> String {
    let parts = [o.fingers.map(|h| format!("fingers {h}")), o.palm.map(|h| format!("palm {h}"))];
    parts.into_iter().flatten().collect::<Vec<_>>().join(", ")
}

fn movement_label(m: &Movement) -> String {
    let join = |parts: &[Movement], by: &str| parts.iter().map(movement_label).collect::<Vec<_>>().join(by);
    match m {
        Movement::Action(action) => action_label(action),
        Movement::Sequence(parts) => join(parts, ", then "),
        Movement::Together(parts) => join(parts, " while "),
        Movement::Fused(parts) => join(parts, " into "),
    }
}

fn action_label(action: &Action) -> String {
    let mut label = match &action.motion {
        Motion::Hold => "hold".into(),
        Motion::Change => "change".into(),
        Motion::Straight { direction, .. } => direction.to_string(),
        Motion::Arc { direction, .. } => format!("arc {direction}"),
        Motion::Circle { axis, .. } => format!("circle about {axis}"),
        Motion::Wrist(motion, _) => motion.name().into(),
        Motion::Wiggle(_) => "wiggle".to_string(),
    };
    if let Some(target) = &action.target {
        label += &format!(" to {}", placement_label(target));
    }
    if let Some(repetition) = action.repetition {
        label += &format!(" ×{}", repetition.times);
    }
    label
}

fn contact_label(c: &Contact) -> String {
    let kind = match c.kind {
        ContactKind::Touch => "touches",
        ContactKind::Close => "near",
        ContactKind::Crossed => "crossed on",
        ContactKind::Interlocked => "interlocked with",
        ContactKind::Metres(_) => "apart from",
    };
    format!("{} {kind} {}", c.strong, c.weak)
}

fn non_manual_label(n: &NonManual) -> String {
    match &n.value {
        NonManualValue::Named(name) => name.clone(),
        NonManualValue::Towards(heading) => format!("towards {heading}"),
        NonManualValue::At(placement) => format!("at {}", placement_label(placement)),
        NonManualValue::Mouthing(sounds) => format!("[{sounds}]"),
    }
}
