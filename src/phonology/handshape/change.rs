//! From a described configuration to joint angles: `between` and changes.
//!
//! A change takes its angles from the inventory where it can: a thumb laid across is the thumb of the row
//! whose fingers are most alike and whose thumb lies across, so that what was solved on the mesh is used.

use super::angles::{FingerAngles, HandAngles, ThumbAngles};
use super::inventory::{HandshapeInventory, NotFound};
use super::limits::HandLimits;
use super::shape::Handshape;
use crate::phonology::{Bend, Configuration, Digit, Digits, HandshapeChange};

/// A hand while changes are applied to it.
struct Shaping<'a> {
    inventory: &'a HandshapeInventory,
    hand: HandAngles,
    /// Spread of the stretched fingers, radians.
    spread: [f64; 4],
    selected: Digits,
}

/// Spread of all fingers of a spread hand (the inventory's 5), degrees.
const SPREAD_ALL: [f64; 4] = [15.0, 0.0, 12.0, 25.0];
/// Spread where index and middle alone are stretched (V), degrees.
const SPREAD_PAIR: [f64; 4] = [12.0, -8.0, 0.0, 0.0];

impl HandshapeInventory {
    /// The joint angles of a described configuration: its named handshape as solved on the avatar, halfway to
    /// the second where one is named, with the changes applied in order, within a hand's limits.
    ///
    /// # Errors
    /// A name that no handshape, or several, answer to.
    pub fn angles(&self, configuration: &Configuration, language: Option<&str>) -> Result<HandAngles, NotFound> {
        let base = self.find(&configuration.base, language)?;
        let mut shaping =
            Shaping { inventory: self, hand: base.angles(), spread: base.spread, selected: base.selected };
        if let Some(second) = &configuration.between {
            let second = self.find(&second.second, language)?;
            shaping.hand = shaping.hand.lerp(&second.angles(), 0.5);
            shaping.spread = std::array::from_fn(|i| (base.spread[i] + second.spread[i]) / 2.0);
        }
        for change in &configuration.changes {
            shaping.apply(*change);
        }
        Ok(HandLimits::ANATOMICAL.clamp(&shaping.hand))
    }
}

impl Shaping<'_> {
    fn apply(&mut self, change: HandshapeChange) {
        match change {
            HandshapeChange::Thumb(position) => {
                self.take_thumb(|shape| shape.thumb_position() == Some(position));
            }
            HandshapeChange::ThumbBetween(a, b) => {
                let pair = |shape: &Handshape| shape.thumb_between().map(|(c, d)| (c.min(d), c.max(d)));
                self.take_thumb(|shape| pair(shape) == Some((a.min(b), a.max(b))));
            }
            HandshapeChange::Bend(digits, bend) => self.bend(digits, bend),
            HandshapeChange::Spread(spread) => self.spread(spread),
            HandshapeChange::Cross(front, behind) => self.cross(front, behind),
            // Not made yet.
            HandshapeChange::On(_)
            | HandshapeChange::Except(_)
            | HandshapeChange::Opening(_)
            | HandshapeChange::Meet(..)
            | HandshapeChange::ThumbAt(_)
            | HandshapeChange::Joints(..) => {}
        }
    }

    /// The thumb of the row that passes the test and whose fingers are most like this hand's.
    fn take_thumb(&mut self, test: impl Fn(&Handshape) -> bool) {
        let alike = |shape: &&Handshape| {
            let other = shape.angles();
            self.hand.fingers.iter().zip(&other.fingers).map(|(a, b)| finger_distance(a, b)).sum::<f64>()
        };
        let rows = self.inventory.shapes().iter().filter(|s| test(s));
        let nearest = rows.map(|s| (alike(&s), s)).min_by(|a, b| a.0.total_cmp(&b.0));
        if let Some((_, shape)) = nearest {
            self.hand.thumb = shape.angles().thumb;
        }
    }

    /// The fingers that a change without digits means: the selected ones, or all where none is.
    fn selected_fingers(&self) -> Digits {
        let fingers = Digits::of(self.selected.iter().filter(|d| *d != Digit::Thumb));
        if fingers.is_empty() { Digits::FINGERS } else { fingers }
    }

    fn bend(&mut self, digits: Digits, bend: Bend) {
        let digits = if digits.is_empty() { self.selected_fingers() } else { digits };
        if digits.contains(Digit::Thumb) {
            let thumb = self.hand.thumb;
            let (mcp, ip) = thumb_bend(bend);
            self.hand.thumb = ThumbAngles { mcp: mcp.to_radians(), ip: ip.to_radians(), ..thumb };
        }
        for (i, digit) in Digit::FINGERS.into_iter().enumerate() {
            if digits.contains(digit) {
                let (mcp, pip, dip) = self.level(i, bend);
                self.hand.fingers[i] = FingerAngles { mcp, abduction: self.spread[i] * mcp.cos(), pip, dip };
            }
        }
    }

    /// Knuckle, middle and last joint of a finger bent so: as solved in the first row that bends it so, else as named.
    fn level(&self, finger: usize, bend: Bend) -> (f64, f64, f64) {
        let solved = self.inventory.shapes().iter().find(|s| s.flexion[finger] == bend.name());
        if let Some(shape) = solved {
            let f = shape.angles().fingers[finger];
            return (f.mcp, f.pip, f.dip);
        }
        let (mcp, pip, dip) = self.inventory.level(bend.name()).unwrap_or_else(|| fallback(bend));
        (mcp.to_radians(), pip.to_radians(), dip.to_radians())
    }

    fn spread(&mut self, spread: bool) {
        let selected = self.selected_fingers();
        let pair = selected == Digits::of([Digit::Index, Digit::Middle]);
        let degrees = if pair { SPREAD_PAIR } else { SPREAD_ALL };
        for (i, digit) in Digit::FINGERS.into_iter().enumerate() {
            if selected.contains(digit) {
                self.spread[i] = if spread { degrees[i].to_radians() } else { 0.0 };
                let finger = &mut self.hand.fingers[i];
                finger.abduction = self.spread[i] * finger.mcp.cos();
            }
        }
    }

    /// Two neighbours crossed, as index and middle finger are in R.
    fn cross(&mut self, front: Digit, behind: Digit) {
        let place = |digit: Digit| Digit::FINGERS.into_iter().position(|d| d == digit);
        let (Some(f), Some(b)) = (place(front), place(behind)) else { return };
        // Positive abduction of index and middle finger is toward the thumb, of the others away from it.
        let toward = |from: usize, to: usize| if (to < from) == (from <= 1) { 1.0 } else { -1.0 };
        let over = &mut self.hand.fingers[f];
        *over = FingerAngles {
            mcp: over.mcp + 10f64.to_radians(),
            abduction: 12f64.to_radians() * toward(f, b),
            pip: over.pip + 15f64.to_radians(),
            dip: over.dip + 10f64.to_radians(),
        };
        self.hand.fingers[b].abduction = 10f64.to_radians() * toward(b, f);
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

/// Where the table has no level of that name, degrees.
fn fallback(bend: Bend) -> (f64, f64, f64) {
    match bend {
        Bend::Straight => (0.0, 0.0, 0.0),
        Bend::Bent => (80.0, 5.0, 3.0),
        Bend::HalfBent => (45.0, 5.0, 3.0),
        Bend::Round => (35.0, 45.0, 30.0),
        Bend::Hooked => (5.0, 90.0, 60.0),
        Bend::DoubleBent => (85.0, 95.0, 10.0),
        Bend::DoubleHooked => (72.0, 95.0, 63.0),
        Bend::Closed => (85.0, 100.0, 67.0),
    }
}
