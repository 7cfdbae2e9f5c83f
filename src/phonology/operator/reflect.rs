//! Hands and sides exchanged: mirrored, swapped, reflected, and a lexical description for a left-handed signer.
//!
//! *Mirrored* is the paper's operator (§6): one arm copied onto the other, one-handed to two-handed. *Swapped* is the reflection
//! of the two arms (what the strong hand did, the weak one does). *Reflected* is the mirror image of the whole signer.

use super::{Applied, Tables, keys_of, manual, neutral, plain};
use crate::diagnostics::Error;
use crate::phonology::symmetry::{acts, crossed, map_keys, resolve};
use crate::phonology::{
    Action, Configuration, Contact, Direction, Hand, Hands, Heading, Keys, Lateral, Manual, Motion, Movement,
    NonManual, NonManualValue, Orientation, Place, Placement, Relation, Relocation, Side, Sign, Space, Symmetry,
    WristMotion,
};
use glam::DVec3;

/// A reflection of a description: which directions are exchanged, and whether places in space are.
#[derive(Debug, Clone, Copy)]
pub(super) struct Reflection {
    /// Left and right exchanged.
    left_right: bool,
    /// Up and down.
    up_down: bool,
    /// Out and in.
    out_in: bool,
    /// Whether cells and points of space stay where they are.
    keeps_space: bool,
}

impl Reflection {
    /// Left and right.
    const SIDES: Reflection = Reflection { left_right: true, up_down: false, out_in: false, keeps_space: false };

    /// What a symmetry does to the weak hand.
    pub(super) fn of(symmetry: Symmetry) -> Reflection {
        let left_right = symmetry.relation == Relation::Mirrored;
        Reflection { left_right, up_down: symmetry.up_down, out_in: symmetry.out_in, keeps_space: false }
    }

    /// Left and right exchanged once more.
    fn and_sides(self) -> Reflection {
        Reflection { left_right: !self.left_right, ..self }
    }

    fn direction(self, d: Direction) -> Direction {
        let d = if self.left_right { d.mirrored() } else { d };
        let d = if self.up_down { d.flipped_up_down() } else { d };
        if self.out_in { d.flipped_out_in() } else { d }
    }

    fn heading(self, heading: Heading) -> Heading {
        heading.map(|d| self.direction(d))
    }

    /// Whether a turn runs the other way round.
    fn turns_round(self) -> bool {
        self.left_right ^ self.up_down ^ self.out_in
    }

    /// Whether the top of a circle's clock becomes its bottom: the highest point, of a level circle the farthest one.
    fn upsets(self, axis: Direction) -> bool {
        if axis == Direction::UP || axis == Direction::DOWN { self.out_in } else { self.up_down }
    }

    fn place(self, place: &Place) -> Place {
        match place {
            Place::Space(cell) if self.left_right && !self.keeps_space => {
                Place::Space(Space { left: -cell.left, ..*cell })
            }
            Place::Point(p) if self.left_right && !self.keeps_space => Place::Point(DVec3::new(-p.x, p.y, p.z)),
            Place::Between(a, b) => Place::Between(Box::new(self.place(a)), Box::new(self.place(b))),
            Place::Towards(at) => Place::Towards(Box::new(self.place(at))),
            Place::Body(_) | Place::OtherHand(_) | Place::Space(_) | Place::Point(_) | Place::Referent(_) => {
                place.clone()
            }
        }
    }

    pub(super) fn placement(self, p: &Placement) -> Placement {
        let lateral = p.lateral.map(|l| if self.left_right { Lateral { side: l.side.other(), ..l } } else { l });
        let offset = p.offset.map(|(d, metres)| (self.direction(d), metres));
        Placement { place: self.place(&p.place), lateral, offset, ..p.clone() }
    }

    fn orientation(self, o: &Orientation) -> Orientation {
        let heading = |h| self.heading(h);
        Orientation { fingers: o.fingers.map(heading), palm: o.palm.map(heading), ..*o }
    }

    pub(super) fn movement(self, movement: &Movement) -> Movement {
        let all = |parts: &[Movement]| parts.iter().map(|m| self.movement(m)).collect();
        match movement {
            Movement::Action(action) => Movement::Action(Box::new(Action {
                motion: self.motion(&action.motion),
                target: action.target.as_ref().map(|p| self.placement(p)),
                brushing: action.brushing.as_ref().map(|p| self.placement(p)),
                ..(**action).clone()
            })),
            Movement::Sequence(parts) => Movement::Sequence(all(parts)),
            Movement::Together(parts) => Movement::Together(all(parts)),
            Movement::Fused(parts) => Movement::Fused(all(parts)),
            Movement::Backwards(inner) => Movement::Backwards(Box::new(self.movement(inner))),
        }
    }

    fn motion(self, motion: &Motion) -> Motion {
        match motion {
            Motion::Hold | Motion::Change | Motion::Return { .. } | Motion::Wiggle(_) => motion.clone(),
            Motion::Straight { direction, extent, overlay } => {
                Motion::Straight { direction: self.heading(*direction), extent: *extent, overlay: *overlay }
            }
            Motion::Arc { direction, extent, bulge, depth, overlay } => Motion::Arc {
                direction: self.heading(*direction),
                extent: *extent,
                bulge: self.direction(*bulge),
                depth: *depth,
                overlay: *overlay,
            },
            Motion::Circle { axis, extent, start, turns, ellipse, growth } => Motion::Circle {
                // An axis of rotation: its mirror image turns the other way round.
                axis: if self.turns_round() { self.direction(*axis).opposite() } else { self.direction(*axis) },
                extent: *extent,
                start: if self.upsets(*axis) { start.opposite() } else { *start },
                turns: *turns,
                ellipse: ellipse.map(|(part, long)| (part, self.direction(long))),
                growth: *growth,
            },
            Motion::Wrist(wrist, size) => Motion::Wrist(
                match wrist {
                    WristMotion::StirClockwise if self.turns_round() => WristMotion::StirCounterclockwise,
                    WristMotion::StirCounterclockwise if self.turns_round() => WristMotion::StirClockwise,
                    other => *other,
                },
                *size,
            ),
        }
    }

    fn manual(self, own: &Manual) -> Manual {
        Manual {
            configuration: own.configuration.clone(),
            placement: map_keys(&own.placement, |p| self.placement(p)),
            orientation: map_keys(&own.orientation, |o| self.orientation(o)),
            movement: own.movement.iter().map(|m| self.movement(m)).collect(),
        }
    }

    fn nonmanual(self, value: &NonManual) -> NonManual {
        let what = match &value.value {
            NonManualValue::Named(name) => NonManualValue::Named(sides_exchanged(name)),
            NonManualValue::Towards(heading) => NonManualValue::Towards(self.heading(*heading)),
            NonManualValue::At(placement) => NonManualValue::At(self.placement(placement)),
            NonManualValue::Mouthing(sounds) => NonManualValue::Mouthing(sounds.clone()),
        };
        NonManual { value: what, amount: value.amount }
    }
}

/// `tilted-left` as `tilted-right`.
fn sides_exchanged(name: &str) -> String {
    let word = |word| match word {
        "left" => "right",
        "right" => "left",
        other => other,
    };
    name.split('-').map(word).collect::<Vec<_>>().join("-")
}

/// The acting hand copied onto the other, mirrored at the midline; of two different hands, the strong one's.
///
/// A contact of the hands is dropped, with a warning. One hand in neutral space keeps its side, so its arm stays where it was.
///
/// # Errors
/// A hand placed on the other one has no copy.
pub fn mirrored(sign: &Sign, tables: &Tables) -> Result<Applied, Error> {
    let same = sign.hands == Hands::Both(Some(Symmetry::MIRRORED)) && sign.weak.is_empty();
    if same {
        return Ok(sign.clone().into());
    }
    let mut own = match sign.hands {
        Hands::Weak => Reflection::SIDES.manual(&sign.weak),
        Hands::Strong | Hands::Both(_) => sign.strong.clone(),
    };
    match sign.hands {
        Hands::Both(Some(symmetry)) if symmetry.crossed => {
            own.placement = map_keys(&own.placement, |p| crossed(p, Hand::Strong));
        }
        Hands::Both(_) => {}
        Hands::Strong | Hands::Weak => {
            if own.placement.is_empty() {
                own.placement = Keys::one(neutral());
            }
            let is_neutral = |name: &str| tables.locations.get(name).is_none_or(|row| row.id == "neutral");
            own.placement = map_keys(&own.placement, |p| match &p.place {
                Place::Body(name) if p.lateral.is_none() && is_neutral(name) => {
                    Placement { lateral: Some(Lateral { side: Side::Right, beside: false }), ..p.clone() }
                }
                _ => p.clone(),
            });
        }
    }
    if own.movement.is_empty() {
        own.movement = vec![plain(Motion::Change); sign.intervals];
    }
    if own.placement.iter().any(|(_, p)| on_the_other_hand(&p.place)) {
        return Err(Error::new("it cannot be mirrored: each hand would be placed on the other"));
    }
    let mut warnings = Vec::new();
    if !sign.contact.is_empty() {
        warnings.push(format!("{}: mirrored, its hands no longer meet", sign.name));
    }
    let sign = Sign {
        hands: Hands::Both(Some(Symmetry::MIRRORED)),
        strong: own,
        weak: Manual::default(),
        contact: Keys::default(),
        ..sign.clone()
    };
    Ok(Applied { sign, warnings })
}

fn on_the_other_hand(place: &Place) -> bool {
    match place {
        Place::OtherHand(_) => true,
        Place::Between(a, b) => on_the_other_hand(a) || on_the_other_hand(b),
        Place::Towards(at) => on_the_other_hand(at),
        Place::Body(_) | Place::Space(_) | Place::Point(_) | Place::Referent(_) => false,
    }
}

/// The hands exchanged, and left and right in their tiers with them. Twice is the sign itself, in the form in which a hand
/// whose other one says more than it says what holds for it (`rest`, the neutral place).
///
/// ```
/// use chereme::phonology::operator::swapped;
/// use chereme::phonology::{Hands, Sign};
/// let weak = swapped(&Sign::named("OK"));
/// assert_eq!(weak.hands, Hands::Weak);
/// assert_eq!(swapped(&weak), Sign::named("OK"));
/// ```
pub fn swapped(sign: &Sign) -> Sign {
    exchanged(sign, Reflection::SIDES)
}

/// The description as a left-handed signer performs it: the hands exchanged, but places in space, points and what is
/// looked at stay, since the addressee stays where they are.
pub fn for_left_hander(sign: &Sign) -> Sign {
    let swapped = exchanged(sign, Reflection { keeps_space: true, ..Reflection::SIDES });
    Sign { relocated: sign.relocated.clone(), ..swapped }
}

/// The mirror image of the whole signer: hands, sides, directions, places in space, head and gaze.
pub fn reflected(sign: &Sign) -> Sign {
    let mut image = swapped(sign);
    for (_, values) in &mut image.nonmanual {
        *values = map_keys(values, |v| Reflection::SIDES.nonmanual(v));
    }
    image
}

fn exchanged(sign: &Sign, sides: Reflection) -> Sign {
    let sign = &spelled_out(sign);
    let (strong, weak) = match sign.hands {
        Hands::Strong | Hands::Weak => (sides.manual(&sign.weak), sides.manual(&sign.strong)),
        Hands::Both(None) => {
            let (mut strong, mut weak) = (sides.manual(&sign.weak), sides.manual(&sign.strong));
            if sign.weak.configuration.is_empty() {
                // The weak hand shares the strong one's shape, then as before.
                std::mem::swap(&mut strong.configuration, &mut weak.configuration);
            }
            (strong, weak)
        }
        Hands::Both(Some(symmetry)) => following(sign, symmetry, sides),
    };
    let contact = map_keys(&sign.contact, |c| Contact { strong: c.weak, weak: c.strong, kind: c.kind });
    let relocated = sign.relocated.as_ref().map(|to| Relocation { place: sides.place(&to.place), forced: to.forced });
    let hands = match sign.hands {
        Hands::Strong => Hands::Weak,
        Hands::Weak => Hands::Strong,
        both @ Hands::Both(_) => both,
    };
    Sign { hands, strong, weak, contact, relocated, ..sign.clone() }
}

/// The two hands of a symmetry exchanged: each tier that the weak hand has of its own changes places with the strong
/// one's; one that follows keeps following.
fn following(sign: &Sign, symmetry: Symmetry, sides: Reflection) -> (Manual, Manual) {
    let keeps_space = sides.keeps_space;
    let through = Reflection { keeps_space, ..Reflection::of(symmetry).and_sides() };
    let (s, w) = (&sign.strong, &sign.weak);
    let (through_s, sides_s, sides_w) = (through.manual(s), sides.manual(s), sides.manual(w));
    fn pick<T>(own: bool, strong: T, follows: T, weak: T, none: T) -> (T, T) {
        if own { (weak, strong) } else { (follows, none) }
    }
    let (c, p) = (!w.configuration.is_empty(), !w.placement.is_empty());
    let (o, m) = (!w.orientation.is_empty(), !w.movement.is_empty());
    let none = Manual::default;
    let configuration =
        pick(c, sides_s.configuration, through_s.configuration, sides_w.configuration, none().configuration);
    let placement = pick(p, sides_s.placement, through_s.placement, sides_w.placement, none().placement);
    let orientation = pick(o, sides_s.orientation, through_s.orientation, sides_w.orientation, none().orientation);
    let movement = pick(m, sides_s.movement, through_s.movement, sides_w.movement, none().movement);
    let hand =
        |configuration, placement, orientation, movement| Manual { configuration, placement, orientation, movement };
    (
        hand(configuration.0, placement.0, orientation.0, movement.0),
        hand(configuration.1, placement.1, orientation.1, movement.1),
    )
}

/// What the strong hand leaves unsaid where the weak hand says something of its own, said.
fn spelled_out(sign: &Sign) -> Sign {
    let mut said = sign.clone();
    let (s, w) = (&mut said.strong, &sign.weak);
    if !matches!(sign.hands, Hands::Both(_)) {
        return said;
    }
    if s.configuration.is_empty() && !w.configuration.is_empty() {
        s.configuration = Keys::one(Configuration::named("rest"));
    }
    if let Hands::Both(Some(symmetry)) = sign.hands {
        if s.placement.is_empty() && !w.placement.is_empty() {
            s.placement = Keys::one(neutral());
        }
        if s.movement.is_empty() && !w.movement.is_empty() {
            s.movement = vec![plain(Motion::Change); sign.intervals];
        }
        if s.orientation.is_empty() && !w.orientation.is_empty() {
            // An orientation cannot say that nothing is said; the hands are described apart.
            said.weak = explicit(sign, symmetry);
            said.hands = Hands::Both(None);
        }
    }
    said
}

/// The weak hand of a symmetry with everything that it follows in.
pub(super) fn explicit(sign: &Sign, symmetry: Symmetry) -> Manual {
    let resolved = resolve(sign, Hand::Weak);
    let movement = if sign.weak.movement.is_empty() {
        sign.strong.movement.iter().map(|m| Reflection::of(symmetry).movement(m)).collect()
    } else {
        resolved.movement
    };
    Manual {
        configuration: resolved.configuration,
        placement: resolved.placement,
        orientation: resolved.orientation,
        movement,
    }
}

/// A hand's tiers with everything that it follows in; `None` where it does not act.
pub(super) fn hand_of(sign: &Sign, hand: Hand) -> Option<Manual> {
    if !acts(sign, hand) {
        return None;
    }
    Some(match (sign.hands, hand) {
        (Hands::Both(Some(symmetry)), Hand::Weak) => explicit(sign, symmetry),
        _ => {
            let resolved = resolve(sign, hand);
            let configuration = resolved.configuration;
            Manual { configuration, placement: resolved.placement, ..manual(sign, hand).clone() }
        }
    })
}

/// Values moved to later keys.
pub(super) fn later<T: Clone>(keys: &Keys<T>, by: usize) -> Keys<T> {
    keys_of(keys.iter().map(|(key, value)| (key + by, value.clone())).collect())
}
