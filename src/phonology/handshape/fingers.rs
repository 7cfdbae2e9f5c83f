//! Changes of fingers: bent, spread, crossed, and which of them the handshape is about.

use super::angles::FingerAngles;
use super::change::Shaping;
use super::shape::{Handshape, ThumbGoal};
use super::thumb::Wish;
use crate::phonology::{Bend, Digit, Digits, HandPart};

/// Spread of all fingers of a spread hand (the inventory's 5), degrees.
const SPREAD_ALL: [f64; 4] = [15.0, 0.0, 12.0, 25.0];
/// Spread where index and middle alone are stretched (V), degrees.
const SPREAD_PAIR: [f64; 4] = [12.0, -8.0, 0.0, 0.0];
/// The range of knuckle, middle and last joint that quarters divide, degrees.
const RANGE: [f64; 3] = [90.0, 105.0, 70.0];

impl Handshape {
    /// The fingers among the selected digits.
    pub(super) fn selected_fingers(&self) -> Digits {
        Digits::of(self.selected.iter().filter(|d| *d != Digit::Thumb))
    }
}

impl Shaping<'_> {
    /// The fingers that a change without digits means: the selected ones, or all where none is.
    fn own_fingers(&self) -> Digits {
        if self.selected.is_empty() { Digits::FINGERS } else { self.selected }
    }

    pub(super) fn bend_by(&mut self, digits: Digits, bend: Bend) {
        let whole = digits.is_empty();
        if whole {
            self.bend = Some(bend);
        }
        let digits = if whole { without(self.own_fingers(), self.kept) } else { digits };
        if digits.contains(Digit::Thumb) {
            self.thumb.bend = Some(bend);
        }
        for (i, digit) in Digit::FINGERS.into_iter().enumerate().filter(|(_, d)| digits.contains(*d)) {
            self.fingers[i] = match self.meeting_finger(digit, bend) {
                Some(finger) if whole => finger,
                Some(_) | None => self.bent(i, bend),
            };
        }
    }

    /// A finger of a pinch or C with a bend: round and hooked ones differ from the plain by nothing that would meet the thumb.
    fn meeting_finger(&self, digit: Digit, bend: Bend) -> Option<FingerAngles> {
        let written = self.row.written.filter(|w| w.meets_thumb())?;
        let bend = Some(bend).filter(|b| *b == Bend::Bent);
        let row = if written.is_cee() { self.inventory.cee(bend) } else { self.inventory.pinch(bend) };
        row?.angles().finger(digit).copied()
    }

    /// A finger bent so, as solved in the first row that bends it so, else as named; with its share of the spread.
    fn bent(&self, finger: usize, bend: Bend) -> FingerAngles {
        let level = self.inventory.bent(finger, bend);
        match bend {
            Bend::Closed => level,
            Bend::Straight
            | Bend::Bent
            | Bend::HalfBent
            | Bend::Round
            | Bend::Hooked
            | Bend::DoubleBent
            | Bend::DoubleHooked => FingerAngles { abduction: self.spread[finger] * level.mcp.cos(), ..level },
        }
    }

    /// Joints bent by quarters of their range.
    pub(super) fn quarters(&mut self, digits: Digits, quarters: [u8; 3]) {
        let digits = if digits.is_empty() { without(self.own_fingers(), self.kept) } else { digits };
        let angle = |k: usize| (f64::from(quarters[k].min(4)) / 4.0 * RANGE[k]).to_radians();
        for (i, digit) in Digit::FINGERS.into_iter().enumerate() {
            if digits.contains(digit) {
                let mcp = angle(0);
                let abduction = self.spread[i] * mcp.cos();
                self.fingers[i] = FingerAngles { mcp, abduction, pip: angle(1), dip: angle(2) };
            }
        }
        if digits.contains(Digit::Thumb) {
            let bends = [quarters[1], quarters[2]].map(|q| q.min(4) >= 2);
            self.thumb.bend = Some(match bends {
                [true, true] => Bend::DoubleHooked,
                [true, false] => Bend::Bent,
                [false, true] => Bend::Hooked,
                [false, false] => Bend::Straight,
            });
        }
    }

    /// The fingers take the part of the handshape's own ones, which take that of the rest.
    pub(super) fn on(&mut self, fingers: Digits) {
        let fingers = without(fingers, Digits::of([Digit::Thumb]));
        if fingers == self.selected || fingers.is_empty() {
            return;
        }
        let own = self.selected.iter().next().and_then(index_of);
        let rest = without(Digits::FINGERS, self.selected).iter().next().and_then(index_of);
        let pattern = own.map(|i| self.fingers[i]).unwrap_or_default();
        let closed = rest.is_none_or(|i| self.row.table.fingers[i].pip > 1.0);
        let spreads = own.is_some_and(|_| self.selected.iter().filter_map(index_of).any(|i| self.row.spread[i] != 0.0));
        for (i, digit) in Digit::FINGERS.into_iter().enumerate() {
            if fingers.contains(digit) {
                self.spread[i] = if spreads { SPREAD_ALL[i].to_radians() } else { 0.0 };
                let bend = self.bend.or(self.row.written.and_then(|w| w.bend)).unwrap_or(Bend::Straight);
                let abduction = self.spread[i] * pattern.mcp.cos();
                let own = FingerAngles { abduction, ..pattern };
                self.fingers[i] = self.meeting_finger(digit, bend).unwrap_or(own);
            } else if closed {
                self.fingers[i] = self.bent(i, Bend::Closed);
            } else if self.selected.contains(digit) {
                self.spread[i] = SPREAD_ALL[i].to_radians() / 2.0;
                self.fingers[i] = self.bent(i, Bend::Straight);
            }
        }
        self.selected = fingers;
        // A pinch of other fingers: the thumb goes to them.
        let pinches =
            matches!(self.row.thumb, ThumbGoal::Touch(..)) && self.row.written.is_some_and(|w| w.meets_thumb());
        if pinches && self.thumb.wish == Wish::Own {
            self.thumb.wish = Wish::At(HandPart::Pad);
        }
    }

    pub(super) fn spread_out(&mut self, spread: bool) {
        let selected = self.own_fingers();
        let pair = selected == Digits::of([Digit::Index, Digit::Middle]);
        let degrees = if pair { SPREAD_PAIR } else { SPREAD_ALL };
        for (i, digit) in Digit::FINGERS.into_iter().enumerate() {
            if selected.contains(digit) {
                self.spread[i] = if spread { degrees[i].to_radians() } else { 0.0 };
                let finger = &mut self.fingers[i];
                finger.abduction = self.spread[i] * finger.mcp.cos();
            }
        }
    }

    /// Two neighbours crossed, as index and middle finger are in R.
    pub(super) fn cross(&mut self, front: Digit, behind: Digit) {
        let (Some(f), Some(b)) = (index_of(front), index_of(behind)) else { return };
        if f == b {
            return;
        }
        // Positive abduction of index and middle finger is toward the thumb, of the others away from it.
        let toward = |from: usize, to: usize| if (to < from) == (from <= 1) { 1.0 } else { -1.0 };
        let over = &mut self.fingers[f];
        *over = FingerAngles {
            mcp: over.mcp + 10f64.to_radians(),
            abduction: 12f64.to_radians() * toward(f, b),
            pip: over.pip + 15f64.to_radians(),
            dip: over.dip + 10f64.to_radians(),
        };
        self.fingers[b].abduction = 10f64.to_radians() * toward(b, f);
    }

    /// A digit touches a part of another: fingers cross, the thumb comes to the finger.
    pub(super) fn meet(&mut self, a: Digit, part: HandPart, b: Digit) {
        match (a, b) {
            (Digit::Thumb, Digit::Thumb) => {}
            (Digit::Thumb, finger) | (finger, Digit::Thumb) => {
                self.thumb.wish = Wish::Touch(part, finger);
            }
            (first, second) => self.cross(first, second),
        }
    }
}

fn index_of(digit: Digit) -> Option<usize> {
    Digit::FINGERS.into_iter().position(|d| d == digit)
}

fn without(digits: Digits, others: Digits) -> Digits {
    Digits::of(digits.iter().filter(|d| !others.contains(*d)))
}
