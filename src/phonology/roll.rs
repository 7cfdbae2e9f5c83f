//! HamNoSys palm symbols: rolls about the finger direction, and the directions in space they come to.
//!
//! A palm symbol is not a direction in space. A hand that points out and whose palm faces down is rolled by the
//! symbol (as if the arrow were drawn on the plane across the fingers), then raised to the fingers' height and
//! turned to their side (facts/phonology.md §3). `.sign` text says directions; the readers and writers of
//! HamNoSys convert.

use super::direction::{Direction, Heading};
use glam::{DQuat, DVec3};

/// One of HamNoSys's eight palm symbols, in its order: up, then clockwise as drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Roll(u8);

impl Roll {
    /// The names in HamNoSys's tags (`hampalmu`, `hampalmur`, ...).
    pub const TAGS: [&'static str; 8] = ["u", "ur", "r", "dr", "d", "dl", "l", "ul"];

    /// All eight.
    pub fn all() -> impl Iterator<Item = Roll> {
        (0..8).map(Roll)
    }

    /// The symbol of a tag's ending, such as `dl`.
    pub fn from_tag(tag: &str) -> Option<Roll> {
        Roll::TAGS.iter().position(|t| *t == tag).map(|i| Roll(i as u8))
    }

    /// The tag's ending.
    pub fn tag(self) -> &'static str {
        Roll::TAGS[self.0 as usize]
    }

    /// Where the palm faces, a unit vector of model space, for fingers that point along `fingers`.
    ///
    /// ```
    /// use chereme::phonology::{Direction, roll::Roll};
    /// let facing = |fingers: Direction, tag| Roll::from_tag(tag).unwrap().palm(fingers.vector());
    /// // Fingers up: the symbol "down" faces away from the signer.
    /// assert!((facing(Direction::UP, "d") - Direction::OUT.vector()).length() < 1e-12);
    /// // Fingers left: the symbol "left" faces the signer.
    /// assert!((facing(Direction::LEFT, "l") - Direction::IN.vector()).length() < 1e-12);
    /// // A hand that points back to the signer: left is left still.
    /// assert!((facing(Direction::IN, "l") - Direction::LEFT.vector()).length() < 1e-12);
    /// ```
    pub fn palm(self, fingers: DVec3) -> DVec3 {
        let fingers = fingers.normalize_or(DVec3::Z);
        let elevation = fingers.y.clamp(-1.0, 1.0).asin();
        let level = fingers.x.hypot(fingers.z);
        let azimuth = if level < 1e-9 { 0.0 } else { fingers.x.atan2(fingers.z) };
        // Clockwise from up as the signer sees it; the signer's right is −X. Left and right stay the signer's where the
        // fingers point back to the signer.
        let turned = if fingers.z < -1e-9 { -1.0 } else { 1.0 };
        let angle = turned * f64::from(self.0) * std::f64::consts::FRAC_PI_4;
        let drawn = DVec3::new(-angle.sin(), angle.cos(), 0.0);
        DQuat::from_rotation_y(azimuth) * (DQuat::from_rotation_x(-elevation) * drawn)
    }

    /// The symbol nearest to a palm that faces along `palm`, for fingers along `fingers`.
    pub fn nearest(fingers: DVec3, palm: DVec3) -> Roll {
        let nearness = |roll: &Roll| roll.palm(fingers).dot(palm);
        Roll::all().max_by(|a, b| nearness(a).total_cmp(&nearness(b))).unwrap_or(Roll(0))
    }

    /// The heading, among the 26 directions and the middles of two of them, that a palm with this symbol faces.
    ///
    /// The nearest one once projected onto the plane across the fingers; plain directions are preferred.
    pub fn heading(self, fingers: Heading) -> Heading {
        facing(fingers, self.palm(fingers.vector()))
    }
}

/// The heading, among the 26 directions and the middles of two of them, that is nearest to a palm's direction once it is
/// projected onto the plane across the fingers; plain directions are preferred.
pub fn facing(fingers: Heading, palm: DVec3) -> Heading {
    let fingers = fingers.vector();
    let miss = |h: Heading| {
        let across = h.vector() - fingers * h.vector().dot(fingers);
        // What lies nearly along the fingers says nothing of the palm.
        if across.length() < 0.3 { f64::INFINITY } else { across.angle_between(palm) }
    };
    // The plainest of several that say the same: `left` before `up-in-left`.
    let axes = |d: &Direction| d.signs().iter().filter(|s| **s != 0).count();
    let plain = (1..=3).flat_map(|n| Direction::all().filter(move |d| axes(d) == n)).map(Heading::Toward);
    let between = Direction::all().flat_map(|a| {
        Direction::all()
            .filter(move |b| a < *b && a.vector().dot(b.vector()) > 0.0)
            .map(move |b| Heading::Between(a, b))
    });
    let mut best = (f64::INFINITY, Heading::Toward(Direction::UP));
    for heading in plain.chain(between) {
        let off = miss(heading);
        if off + 1e-6 < best.0 {
            best = (off, heading);
        }
    }
    best.1
}
