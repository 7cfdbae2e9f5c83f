//! Directions in the signer's space.
//!
//! HamNoSys has 18 extended-finger directions and writes the 8 corners as "between" two of them: 26 in
//! all. SiGML's `second_extfidir` asks for midpoints of neighbours, which [`Heading::Between`] holds.

use glam::DVec3;
use std::fmt;

/// One of the 26 directions: each axis negative, zero or positive, not all zero.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Direction {
    left: i8,
    up: i8,
    out: i8,
}

impl Direction {
    /// Towards the ceiling.
    pub const UP: Direction = Direction { left: 0, up: 1, out: 0 };
    /// Towards the floor.
    pub const DOWN: Direction = Direction { left: 0, up: -1, out: 0 };
    /// Towards the signer's left.
    pub const LEFT: Direction = Direction { left: 1, up: 0, out: 0 };
    /// Towards the signer's right.
    pub const RIGHT: Direction = Direction { left: -1, up: 0, out: 0 };
    /// Away from the signer.
    pub const OUT: Direction = Direction { left: 0, up: 0, out: 1 };
    /// Towards the signer.
    pub const IN: Direction = Direction { left: 0, up: 0, out: -1 };

    /// A direction from the signs of its parts along left, up and out; `None` where all are zero.
    pub fn new(left: i8, up: i8, out: i8) -> Option<Direction> {
        let d = Direction { left: left.signum(), up: up.signum(), out: out.signum() };
        ((d.left, d.up, d.out) != (0, 0, 0)).then_some(d)
    }

    /// All 26, in a fixed order.
    pub fn all() -> impl Iterator<Item = Direction> {
        let axis = || [1i8, 0, -1].into_iter();
        axis().flat_map(move |up| {
            axis().flat_map(move |out| axis().filter_map(move |left| Direction::new(left, up, out)))
        })
    }

    /// The unit vector, model space (X left, Y up, Z out).
    ///
    /// ```
    /// use chereme::phonology::Direction;
    /// let v = "up-left".parse::<Direction>().unwrap().vector();
    /// assert!((v.x - v.y).abs() < 1e-12 && (v.length() - 1.0).abs() < 1e-12);
    /// ```
    pub fn vector(self) -> DVec3 {
        DVec3::new(self.left.into(), self.up.into(), self.out.into()).normalize()
    }

    /// The direction nearest to a vector; `None` for the zero vector and what is not finite.
    pub fn nearest(vector: DVec3) -> Option<Direction> {
        let unit = vector.try_normalize()?;
        Direction::all().max_by(|a, b| a.vector().dot(unit).total_cmp(&b.vector().dot(unit)))
    }

    /// −1, 0 or 1 along left, up and out.
    pub fn signs(self) -> [i8; 3] {
        [self.left, self.up, self.out]
    }

    /// The opposite direction.
    pub fn opposite(self) -> Direction {
        Direction { left: -self.left, up: -self.up, out: -self.out }
    }

    /// Left and right exchanged.
    pub fn mirrored(self) -> Direction {
        Direction { left: -self.left, ..self }
    }

    /// Up and down exchanged.
    pub fn flipped_up_down(self) -> Direction {
        Direction { up: -self.up, ..self }
    }

    /// Out and in exchanged.
    pub fn flipped_out_in(self) -> Direction {
        Direction { out: -self.out, ..self }
    }
}

/// Written as words joined by hyphens: height, depth, side (`up-out-left`).
impl fmt::Display for Direction {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let words = [(self.up, "up", "down"), (self.out, "out", "in"), (self.left, "left", "right")];
        let mut first = true;
        for (sign, positive, negative) in words {
            if sign != 0 {
                if !first {
                    f.write_str("-")?;
                }
                f.write_str(if sign > 0 { positive } else { negative })?;
                first = false;
            }
        }
        Ok(())
    }
}

impl std::str::FromStr for Direction {
    type Err = ();

    /// Words in any order, each axis at most once.
    fn from_str(text: &str) -> Result<Direction, ()> {
        let (mut left, mut up, mut out) = (0i8, 0i8, 0i8);
        for word in text.split('-') {
            let (axis, sign) = match word.to_ascii_lowercase().as_str() {
                "up" => (&mut up, 1),
                "down" => (&mut up, -1),
                "left" => (&mut left, 1),
                "right" => (&mut left, -1),
                "out" => (&mut out, 1),
                "in" => (&mut out, -1),
                _ => return Err(()),
            };
            if *axis != 0 {
                return Err(());
            }
            *axis = sign;
        }
        Direction::new(left, up, out).ok_or(())
    }
}

/// A direction, or the middle of two.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Heading {
    /// One of the 26.
    Toward(Direction),
    /// Halfway between two that are not opposite: written `between A and B`.
    Between(Direction, Direction),
}

impl Heading {
    /// The unit vector, model space.
    pub fn vector(self) -> DVec3 {
        match self {
            Heading::Toward(d) => d.vector(),
            // The reader refuses opposites; the fallback keeps the function total.
            Heading::Between(a, b) => (a.vector() + b.vector()).try_normalize().unwrap_or(a.vector()),
        }
    }

    /// The opposite heading.
    pub fn opposite(self) -> Heading {
        self.map(Direction::opposite)
    }

    /// Whether it lies nearer to the upright than 26 degrees, so that a circle about it is level.
    pub(crate) fn is_upright(self) -> bool {
        self.vector().y.abs() > 0.9
    }

    /// The heading with each of its directions changed.
    pub fn map(self, f: impl Fn(Direction) -> Direction) -> Heading {
        match self {
            Heading::Toward(d) => Heading::Toward(f(d)),
            Heading::Between(a, b) => Heading::Between(f(a), f(b)),
        }
    }
}

impl From<Direction> for Heading {
    fn from(direction: Direction) -> Heading {
        Heading::Toward(direction)
    }
}

impl fmt::Display for Heading {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Heading::Toward(d) => d.fmt(f),
            Heading::Between(a, b) => write!(f, "between {a} and {b}"),
        }
    }
}
