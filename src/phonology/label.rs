//! Labels: phonological values in the few words that a tier has room for.
//!
//! The tiers of a synthesized track and those of an annotation have the same words, so that one can be compared with the other.
//!
//! ```
//! use chereme::phonology::{Distance, Place, Placement, label};
//! let placement = Placement { distance: Distance::Touch, ..Placement::at(Place::Body("chest".into())) };
//! assert_eq!(label::placement(&placement), "chest, touch");
//! ```

use super::{
    Action, Configuration, Contact, ContactKind, Distance, Extent, HandPoint, HandshapeChange, Lateral, Motion,
    Movement, NonManual, NonManualValue, Opening, Orientation, Place, Placement, Side, Sited, Size, Space,
};

/// The label of a configuration: its base, and in a word what is changed.
pub fn configuration(c: &Configuration) -> String {
    let mut label = c.base.clone();
    if let Some(other) = &c.between {
        label += &format!("–{}", other.second);
    }
    for change in &c.changes {
        label += match change {
            HandshapeChange::Thumb(_) => ", thumb",
            HandshapeChange::Bend(..) => ", bent",
            HandshapeChange::Spread(true) => ", spread",
            HandshapeChange::Spread(false) => ", together",
            HandshapeChange::Cross(..) => ", crossed",
            HandshapeChange::ThumbBetween(..) => ", thumb between",
            HandshapeChange::On(_) => ", other fingers",
            HandshapeChange::Except(_) => ", some fingers left",
            HandshapeChange::Opening(opening) => match opening {
                Opening::Tight => ", tight",
                Opening::Slack => ", slack",
            },
            HandshapeChange::Meet(..) => ", fingers touching",
            HandshapeChange::ThumbAt(_) => ", thumb touching",
            HandshapeChange::Joints(..) => ", joints bent",
        };
    }
    label
}

/// The label of a placement: the place, its side, how near (`chest left, touch`).
pub fn placement(p: &Placement) -> String {
    let mut label = of_place(&p.place);
    label += &of_side(p.lateral);
    label += &match p.distance {
        Distance::Unmarked => String::new(),
        Distance::Touch => ", touch".to_owned(),
        Distance::Close => ", close".to_owned(),
        Distance::Neutral => ", neutral".to_owned(),
        Distance::Extended => ", extended".to_owned(),
        Distance::Metres(metres) => format!(", {:.0}cm away", metres * 100.0),
    };
    label
}

fn of_side(lateral: Option<Lateral>) -> String {
    lateral.map_or(String::new(), |l| {
        let side = match l.side {
            Side::Left => "left",
            Side::Right => "right",
        };
        format!(" {side}{}", if l.beside { " beside" } else { "" })
    })
}

fn of_place(place: &Place) -> String {
    match place {
        Place::Body(name) => name.clone(),
        Place::OtherHand(point) => format!("other {point}"),
        Place::Space(cell) => space(*cell),
        Place::Point(p) => format!("({:.2}, {:.2}, {:.2})", p.x, p.y, p.z),
        Place::Between(a, b) => {
            let half = |sited: &Sited| format!("{}{}", of_place(&sited.place), of_side(sited.lateral));
            format!("{}–{}", half(a), half(b))
        }
        Place::Referent(name) => format!("referent {name}"),
        Place::Towards(at) => format!("pointing at {}", of_place(at)),
    }
}

/// The label of an orientation: `fingers up, palm out`.
pub fn orientation(o: &Orientation) -> String {
    let parts = [o.fingers.map(|h| format!("fingers {h}")), o.palm.map(|h| format!("palm {h}"))];
    parts.into_iter().flatten().collect::<Vec<_>>().join(", ")
}

/// The label of a movement: `down 10cm`, `arc up-right`, `nod ×2`.
pub fn movement(m: &Movement) -> String {
    let join = |parts: &[Movement], by: &str| parts.iter().map(movement).collect::<Vec<_>>().join(by);
    match m {
        Movement::Action(action) => of_action(action),
        Movement::Sequence(parts) => join(parts, ", then "),
        Movement::Together(parts) => join(parts, " while "),
        Movement::Fused(parts) => join(parts, " into "),
        Movement::Repeated(group) => format!("({}) ×{}", movement(&group.movement), group.repetition.times),
        Movement::Backwards(inner) => format!("backwards {}", movement(inner)),
    }
}

fn of_action(action: &Action) -> String {
    let mut label = match &action.motion {
        Motion::Hold => "hold".into(),
        Motion::Change => "change".into(),
        Motion::Return { key: 0 } => "back".into(),
        Motion::Return { key } => format!("back to key {}", key + 1),
        Motion::Straight { direction, extent, .. } => format!("{direction}{}", extent_words(*extent)),
        Motion::Arc { direction, extent, .. } => format!("arc {direction}{}", extent_words(*extent)),
        Motion::Circle { axis, .. } => format!("circle about {axis}"),
        Motion::Wrist(motion, _) => motion.name().into(),
        Motion::Wiggle(_) => "wiggle".to_string(),
    };
    if let Some(target) = &action.target {
        label += &format!(" to {}", placement(target));
    }
    if let Some(repetition) = action.repetition {
        label += &format!(" ×{}", repetition.times);
    }
    label
}

fn extent_words(extent: Extent) -> String {
    match extent {
        Extent::Size(Size::Small) => " small".into(),
        Extent::Size(Size::Normal) => String::new(),
        Extent::Size(Size::Large) => " large".into(),
        Extent::Metres(metres) => format!(" {:.0}cm", metres * 100.0),
    }
}

/// The label of a contact of the two hands: `index tip touches palm`.
pub fn contact(c: &Contact) -> String {
    let kind = match c.kind {
        ContactKind::Touch => "touches",
        ContactKind::Close => "near",
        ContactKind::Crossed => "crossed on",
        ContactKind::Interlocked => "interlocked with",
        ContactKind::Metres(_) => "apart from",
    };
    let point = |of: Option<HandPoint>| of.map_or_else(|| "hand".to_owned(), |point| point.to_string());
    format!("{} {kind} {}", point(c.strong), point(c.weak))
}

/// The label of a non-manual value.
pub fn non_manual(n: &NonManual) -> String {
    let join = |parts: &[NonManual], by: &str| parts.iter().map(non_manual).collect::<Vec<_>>().join(by);
    match &n.value {
        NonManualValue::Named(name) => name.clone(),
        NonManualValue::Towards(heading) => format!("towards {heading}"),
        NonManualValue::At(at) => format!("at {}", placement(at)),
        NonManualValue::Mouthing(sounds) => format!("[{sounds}]"),
        NonManualValue::Sequence(parts) => join(parts, ", then "),
        NonManualValue::Together(parts) => join(parts, " while "),
    }
}

/// A cell of signing space in the words that a description has for it: `space centre`, `space right high`.
fn space(cell: Space) -> String {
    let words = [(cell.left, "left", "right"), (cell.high, "high", "low"), (cell.far, "far", "near")];
    let said = words.iter().filter(|(sign, ..)| *sign != 0).map(|(sign, up, down)| if *sign > 0 { *up } else { *down });
    let said: Vec<&str> = said.collect();
    if said.is_empty() { "space centre".into() } else { format!("space {}", said.join(" ")) }
}
