//! The thumb of a changed handshape: that of the row whose thumb does the same and whose fingers are most alike.

use super::angles::{FingerAngles, ThumbAngles};
use super::change::Shaping;
use super::shape::{Handshape, ThumbGoal, ThumbTarget};
use crate::phonology::{Bend, Digit, Digits, HandPart, ThumbPosition};

/// The thumb while changes are applied.
pub(super) struct Thumb {
    /// As the base has it.
    pub angles: ThumbAngles,
    /// What the changes ask of it.
    pub wish: Wish,
    /// How it is bent.
    pub bend: Option<Bend>,
}

/// What a thumb shall do.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Wish {
    /// What it does in the base, suited to the fingers.
    Own,
    /// Stay as it is.
    Kept,
    /// Lie over the closed index alone.
    OverIndex,
    /// Stand in a position.
    Position(ThumbPosition),
    /// Come out between two fingers.
    Between(Digit, Digit),
    /// Touch that part of the fingers that it meets.
    At(HandPart),
    /// Touch that part of a finger.
    Touch(HandPart, Digit),
}

impl Shaping<'_> {
    /// The thumb for the fingers as they are.
    pub(super) fn suited_thumb(&self) -> ThumbAngles {
        let thumb = match self.thumb.wish {
            Wish::Kept => self.thumb.angles,
            Wish::Own if self.fingers == self.row.angles().fingers => self.thumb.angles,
            Wish::Own => match self.row.thumb_position() {
                Some(position) => self.in_position(position),
                None => self.nearest(|row| same_family(&row.thumb, &self.row.thumb)),
            },
            Wish::OverIndex => self.nearest(|row| match row.thumb {
                ThumbGoal::Touch(_, digits, ThumbTarget::MiddleBack) => digits == Digits::of([Digit::Index]),
                ThumbGoal::Touch(..) | ThumbGoal::Posture(_) | ThumbGoal::Between(..) | ThumbGoal::Gap(..) => false,
            }),
            Wish::Position(position) => self.in_position(position),
            Wish::Between(a, b) => self.nearest(|row| row.thumb_between() == Some((a, b))),
            Wish::At(part) => self.touching(part, self.selected.iter().next().unwrap_or(Digit::Index)),
            Wish::Touch(part, finger) => self.touching(part, finger),
        };
        match self.thumb.bend {
            None => thumb,
            Some(bend) => {
                let (mcp, ip) = thumb_bend(bend);
                ThumbAngles { mcp: mcp.to_radians(), ip: ip.to_radians(), ..thumb }
            }
        }
    }

    fn in_position(&self, position: ThumbPosition) -> ThumbAngles {
        match position {
            // Stretched fingers enclose nothing: there it lies in the palm.
            ThumbPosition::Enclosed => self.nearest(|row| {
                row.thumb_position() == Some(position) || matches!(row.thumb, ThumbGoal::Touch(_, _, ThumbTarget::Palm))
            }),
            ThumbPosition::Along | ThumbPosition::Out | ThumbPosition::Across | ThumbPosition::Opposed => {
                self.nearest(|row| row.thumb_position() == Some(position))
            }
        }
    }

    /// The thumb at a part of a finger: of a row where it touches that part of that finger, else of the finger's pinch.
    fn touching(&self, part: HandPart, finger: Digit) -> ThumbAngles {
        let touches = |row: &Handshape, wanted: fn(ThumbTarget) -> bool| match row.thumb {
            ThumbGoal::Touch(_, digits, target) => digits.contains(finger) && wanted(target),
            ThumbGoal::Posture(_) | ThumbGoal::Between(..) | ThumbGoal::Gap(..) => false,
        };
        let wanted: fn(ThumbTarget) -> bool = match part {
            HandPart::Nail => |t| t == ThumbTarget::Nail,
            HandPart::Midjoint | HandPart::Base | HandPart::Side => {
                |t| matches!(t, ThumbTarget::MiddleFront | ThumbTarget::ProximalRadial)
            }
            HandPart::Tip
            | HandPart::Pad
            | HandPart::Palm
            | HandPart::Back
            | HandPart::ThumbSide
            | HandPart::PinkySide
            | HandPart::ThumbBall
            | HandPart::Wrist
            | HandPart::WristBack
            | HandPart::WristPulse
            | HandPart::LowerArm
            | HandPart::Elbow
            | HandPart::ElbowInside
            | HandPart::UpperArm => |t| t == ThumbTarget::Pad,
        };
        // Of several fingers that meet the thumb, one that touches them all is best.
        let all = |row: &Handshape| self.selected.iter().all(|digit| touched(&row.thumb, digit));
        let found = self.nearest_row(|row| touches(row, wanted) && all(row));
        let found = found.or_else(|| self.nearest_row(|row| touches(row, wanted)));
        let found = found.or_else(|| self.nearest_row(|row| touches(row, |t| t == ThumbTarget::Pad)));
        found.map_or(self.thumb.angles, |row| row.angles().thumb)
    }

    /// The thumb of the nearest row that passes the test; as it is where none does.
    fn nearest(&self, test: impl Fn(&Handshape) -> bool) -> ThumbAngles {
        self.nearest_row(test).map_or(self.thumb.angles, |row| row.angles().thumb)
    }

    /// The row that passes the test and whose fingers are most like this hand's.
    fn nearest_row(&self, test: impl Fn(&Handshape) -> bool) -> Option<&Handshape> {
        let rows = self.inventory.shapes().iter().filter(|row| test(row));
        let measured = rows.map(|row| (self.unlike(row), row));
        measured.min_by(|a, b| a.0.total_cmp(&b.0)).map(|(_, row)| row)
    }

    /// How unlike a row's fingers are, radians; those that its thumb touches count most.
    fn unlike(&self, row: &Handshape) -> f64 {
        let other = row.angles().fingers;
        let weight = |digit: Digit| if touched(&row.thumb, digit) { 3.0 } else { 1.0 };
        let each = Digit::FINGERS.into_iter().zip(self.fingers.iter().zip(&other));
        each.map(|(digit, (a, b))| weight(digit) * finger_distance(a, b)).sum()
    }
}

/// Whether a thumb touches a finger or faces it.
fn touched(goal: &ThumbGoal, digit: Digit) -> bool {
    match goal {
        ThumbGoal::Posture(_) => false,
        ThumbGoal::Touch(_, digits, _) | ThumbGoal::Gap(digits, _) => digits.contains(digit),
        ThumbGoal::Between(a, b) => *a == digit || *b == digit,
    }
}

/// Whether two thumbs do the same: touch the same part of whichever fingers, or face fingers.
fn same_family(a: &ThumbGoal, b: &ThumbGoal) -> bool {
    match (a, b) {
        (ThumbGoal::Touch(p, _, s), ThumbGoal::Touch(q, _, t)) => p == q && s == t,
        (ThumbGoal::Gap(..), ThumbGoal::Gap(..)) | (ThumbGoal::Between(..), ThumbGoal::Between(..)) => true,
        (ThumbGoal::Posture(a), ThumbGoal::Posture(b)) => a == b,
        (ThumbGoal::Posture(_) | ThumbGoal::Touch(..) | ThumbGoal::Between(..) | ThumbGoal::Gap(..), _) => false,
    }
}

fn finger_distance(a: &FingerAngles, b: &FingerAngles) -> f64 {
    (a.mcp - b.mcp).abs() + (a.pip - b.pip).abs() + (a.dip - b.dip).abs() + (a.abduction - b.abduction).abs()
}

/// Knuckle and last joint of a bent thumb, degrees.
fn thumb_bend(bend: Bend) -> (f64, f64) {
    match bend {
        Bend::Straight => (0.0, 0.0),
        Bend::Bent => (45.0, 0.0),
        Bend::HalfBent => (25.0, 0.0),
        Bend::Round => (20.0, 30.0),
        Bend::Hooked => (0.0, 65.0),
        Bend::DoubleBent => (45.0, 30.0),
        Bend::DoubleHooked => (45.0, 65.0),
        Bend::Closed => (55.0, 70.0),
    }
}
