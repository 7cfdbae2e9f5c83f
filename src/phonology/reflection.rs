//! Descriptions in a mirror: directions, sides and places exchanged.
//!
//! A symmetry exchanges them between the hands of one sign, the operators between signs.

use super::movement::{Action, Becoming, Motion, Movement, Overlay, Repetition, Shift};
use super::nonmanual::{NonManual, NonManualValue};
use super::orientation::Orientation;
use super::placement::{Lateral, Place, Placement, Sited, Space};
use super::sign::{Manual, Relation, Symmetry};
use super::symmetry::map_keys;
use super::{Direction, Heading};
use glam::DVec3;

/// A reflection of a description: which directions are exchanged, and whether places in space are.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Reflection {
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
    pub(crate) const SIDES: Reflection =
        Reflection { left_right: true, up_down: false, out_in: false, keeps_space: false };

    /// Left and right of the signer, whose surroundings stay.
    pub(crate) const SIDES_OF_SIGNER: Reflection = Reflection { keeps_space: true, ..Reflection::SIDES };

    /// What a symmetry does to the weak hand.
    pub(crate) fn of(symmetry: Symmetry) -> Reflection {
        let left_right = symmetry.relation == Relation::Mirrored;
        Reflection { left_right, up_down: symmetry.up_down, out_in: symmetry.out_in, keeps_space: false }
    }

    /// The same with the surroundings as in another one.
    pub(crate) fn with_space_as(self, other: Reflection) -> Reflection {
        Reflection { keeps_space: other.keeps_space, ..self }
    }

    /// Left and right exchanged once more.
    pub(crate) fn and_sides(self) -> Reflection {
        Reflection { left_right: !self.left_right, ..self }
    }

    pub(crate) fn direction(self, d: Direction) -> Direction {
        let d = if self.left_right { d.mirrored() } else { d };
        let d = if self.up_down { d.flipped_up_down() } else { d };
        if self.out_in { d.flipped_out_in() } else { d }
    }

    /// A vector of model space in the mirror.
    pub(crate) fn vector(self, v: DVec3) -> DVec3 {
        let sign = |exchanged: bool| if exchanged { -1.0 } else { 1.0 };
        v * DVec3::new(sign(self.left_right), sign(self.up_down), sign(self.out_in))
    }

    fn heading(self, heading: Heading) -> Heading {
        heading.map(|d| self.direction(d))
    }

    /// Whether a turn runs the other way round.
    fn turns_round(self) -> bool {
        self.left_right ^ self.up_down ^ self.out_in
    }

    /// Whether the top of a circle's clock becomes its bottom: the highest point, of a level circle the farthest one.
    fn upsets(self, axis: Heading) -> bool {
        if axis.is_upright() { self.out_in } else { self.up_down }
    }

    pub(crate) fn place(self, place: &Place) -> Place {
        match place {
            Place::Space(cell) if self.left_right && !self.keeps_space => {
                Place::Space(Space { left: -cell.left, ..*cell })
            }
            Place::Point(p) if self.left_right && !self.keeps_space => Place::Point(DVec3::new(-p.x, p.y, p.z)),
            Place::Between(a, b) => Place::Between(Box::new(self.sited(a)), Box::new(self.sited(b))),
            Place::Towards(at) => Place::Towards(Box::new(self.place(at))),
            Place::Body(_) | Place::OtherHand(_) | Place::Space(_) | Place::Point(_) | Place::Referent(_) => {
                place.clone()
            }
        }
    }

    fn sited(self, of: &Sited) -> Sited {
        Sited { place: self.place(&of.place), lateral: of.lateral.map(|l| self.lateral(l)) }
    }

    fn lateral(self, l: Lateral) -> Lateral {
        if self.left_right { Lateral { side: l.side.other(), ..l } } else { l }
    }

    pub(crate) fn placement(self, p: &Placement) -> Placement {
        let lateral = p.lateral.map(|l| self.lateral(l));
        let offset = p.offset.map(|(d, metres)| (self.direction(d), metres));
        Placement { place: self.place(&p.place), lateral, offset, ..p.clone() }
    }

    pub(crate) fn orientation(self, o: &Orientation) -> Orientation {
        let heading = |h| self.heading(h);
        Orientation { fingers: o.fingers.map(heading), palm: o.palm.map(heading), ..*o }
    }

    pub(crate) fn movement(self, movement: &Movement) -> Movement {
        movement
            .map_actions(&|action| Action {
                motion: self.motion(&action.motion),
                target: action.target.as_ref().map(|p| self.placement(p)),
                brushing: action.brushing.as_ref().map(|p| self.placement(p)),
                repetition: action.repetition.map(|r| self.repetition(r)),
                becoming: action.becoming.as_ref().map(|b| Box::new(self.becoming(b))),
                ..action.clone()
            })
            .map_repetitions(&|r| self.repetition(r))
    }

    fn repetition(self, r: Repetition) -> Repetition {
        let shift = r.shift.map(|s| Shift { direction: self.direction(s.direction), ..s });
        Repetition { shift, ..r }
    }

    pub(super) fn becoming(self, b: &Becoming) -> Becoming {
        Becoming { orientation: b.orientation.map(|o| self.orientation(&o)), ..b.clone() }
    }

    fn overlay(self, overlay: Option<Overlay>) -> Option<Overlay> {
        overlay.map(|o| Overlay { across: o.across.map(|d| self.direction(d)), ..o })
    }

    fn motion(self, motion: &Motion) -> Motion {
        match motion {
            Motion::Hold | Motion::Change | Motion::Return { .. } | Motion::Wiggle(_) => motion.clone(),
            Motion::Straight { direction, extent, overlay } => Motion::Straight {
                direction: self.heading(*direction),
                extent: *extent,
                overlay: self.overlay(*overlay),
            },
            Motion::Arc { direction, extent, bulge, depth, overlay } => Motion::Arc {
                direction: self.heading(*direction),
                extent: *extent,
                bulge: self.heading(*bulge),
                depth: *depth,
                overlay: self.overlay(*overlay),
            },
            Motion::Circle { axis, extent, start, turns, ellipse, growth, overlay } => Motion::Circle {
                // An axis of rotation: its mirror image turns the other way round.
                axis: if self.turns_round() { self.heading(*axis).opposite() } else { self.heading(*axis) },
                extent: *extent,
                start: if self.upsets(*axis) { start.opposite() } else { *start },
                turns: *turns,
                ellipse: ellipse.map(|(part, long)| (part, self.direction(long))),
                growth: *growth,
                overlay: self.overlay(*overlay),
            },
            Motion::Wrist(wrist, size) => {
                Motion::Wrist(if self.turns_round() { wrist.reversed() } else { *wrist }, *size)
            }
        }
    }

    pub(crate) fn manual(self, own: &Manual) -> Manual {
        Manual {
            configuration: own.configuration.clone(),
            placement: map_keys(&own.placement, |p| self.placement(p)),
            orientation: map_keys(&own.orientation, |o| self.orientation(o)),
            movement: own.movement.iter().map(|m| self.movement(m)).collect(),
        }
    }

    pub(crate) fn nonmanual(self, value: &NonManual) -> NonManual {
        let what = match &value.value {
            NonManualValue::Named(name) => NonManualValue::Named(sides_exchanged(name)),
            NonManualValue::Towards(heading) => NonManualValue::Towards(self.heading(*heading)),
            NonManualValue::At(placement) => NonManualValue::At(self.placement(placement)),
            NonManualValue::Mouthing(sounds) => NonManualValue::Mouthing(sounds.clone()),
            NonManualValue::Sequence(parts) => NonManualValue::Sequence(self.nonmanuals(parts)),
            NonManualValue::Together(parts) => NonManualValue::Together(self.nonmanuals(parts)),
        };
        NonManual { value: what, amount: value.amount, pace: value.pace }
    }

    fn nonmanuals(self, parts: &[NonManual]) -> Vec<NonManual> {
        parts.iter().map(|part| self.nonmanual(part)).collect()
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
