//! Hands and the points on them that touch and are touched.

use std::fmt;

/// A hand by its role in the description.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Hand {
    /// The dominant hand: the right one of a right-handed signer.
    Strong,
    /// The other hand.
    Weak,
}

impl Hand {
    /// Both, the strong one first.
    pub const BOTH: [Hand; 2] = [Hand::Strong, Hand::Weak];

    /// The other hand.
    pub fn other(self) -> Hand {
        match self {
            Hand::Strong => Hand::Weak,
            Hand::Weak => Hand::Strong,
        }
    }
}

/// A side of the signer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Side {
    /// The signer's left, +X.
    Left,
    /// The signer's right, −X.
    Right,
}

impl Side {
    /// The other side.
    pub fn other(self) -> Side {
        match self {
            Side::Left => Side::Right,
            Side::Right => Side::Left,
        }
    }

    /// How the names of the hand's tiers begin: `RH`, `LH`.
    ///
    /// ```
    /// use chereme::phonology::Side;
    /// assert_eq!(format!("{} Gloss", Side::Right.hand()), "RH Gloss");
    /// ```
    pub fn hand(self) -> &'static str {
        match self {
            Side::Left => "LH",
            Side::Right => "RH",
        }
    }

    /// +1 for left, −1 for right: the sign of X on that side.
    pub fn sign(self) -> f64 {
        match self {
            Side::Left => 1.0,
            Side::Right => -1.0,
        }
    }
}

/// A finger or the thumb.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Digit {
    /// Digit 1.
    Thumb,
    /// Digit 2.
    Index,
    /// Digit 3.
    Middle,
    /// Digit 4.
    Ring,
    /// Digit 5.
    Pinky,
}

impl Digit {
    /// From the thumb to the little finger.
    pub const ALL: [Digit; 5] = [Digit::Thumb, Digit::Index, Digit::Middle, Digit::Ring, Digit::Pinky];
    /// The four fingers without the thumb.
    pub const FINGERS: [Digit; 4] = [Digit::Index, Digit::Middle, Digit::Ring, Digit::Pinky];

    /// The name in text.
    pub fn name(self) -> &'static str {
        match self {
            Digit::Thumb => "thumb",
            Digit::Index => "index",
            Digit::Middle => "middle",
            Digit::Ring => "ring",
            Digit::Pinky => "pinky",
        }
    }
}

/// A set of digits, written from the thumb to the little finger.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Digits(u8);

impl Digits {
    /// No digit.
    pub const NONE: Digits = Digits(0);
    /// The four fingers.
    pub const FINGERS: Digits = Digits(0b11110);

    /// A set of digits.
    pub fn of(digits: impl IntoIterator<Item = Digit>) -> Digits {
        Digits(digits.into_iter().fold(0, |bits, d| bits | 1 << d as u8))
    }

    /// Whether the digit is in the set.
    pub fn contains(self, digit: Digit) -> bool {
        self.0 & (1 << digit as u8) != 0
    }

    /// Whether the set is empty.
    pub fn is_empty(self) -> bool {
        self.0 == 0
    }

    /// The digits, from the thumb to the little finger.
    pub fn iter(self) -> impl Iterator<Item = Digit> {
        Digit::ALL.into_iter().filter(move |d| self.contains(*d))
    }
}

/// A part of a hand or of an arm that can touch or be touched (HamNoSys U+E060–U+E07A).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum HandPart {
    /// The end of a digit.
    Tip,
    /// The nail of a digit.
    Nail,
    /// The soft side of a digit's last phalanx.
    Pad,
    /// The back of a digit's middle joint.
    Midjoint,
    /// The knuckle.
    Base,
    /// The flank of a digit; which one is said by [`Flank`].
    Side,
    /// The middle of the palm.
    Palm,
    /// The middle of the back of the hand.
    Back,
    /// The edge of the hand on the thumb's side.
    ThumbSide,
    /// The edge of the hand on the little finger's side.
    PinkySide,
    /// The ball of the thumb.
    ThumbBall,
    /// The wrist joint, inside: the point that captured signs are placed with. HamNoSys has no symbol for it.
    Wrist,
    /// The wrist, on the back of the hand's side.
    WristBack,
    /// The wrist, where the pulse is felt.
    WristPulse,
    /// The middle of the forearm.
    LowerArm,
    /// The point of the elbow.
    Elbow,
    /// The crook of the elbow.
    ElbowInside,
    /// The middle of the upper arm.
    UpperArm,
}

impl HandPart {
    /// Parts that belong to a digit.
    pub const OF_A_DIGIT: [HandPart; 6] =
        [HandPart::Tip, HandPart::Nail, HandPart::Pad, HandPart::Midjoint, HandPart::Base, HandPart::Side];
    /// Parts of the whole hand and of the arm that HamNoSys has symbols for.
    pub const OF_THE_LIMB: [HandPart; 11] = [
        HandPart::Palm,
        HandPart::Back,
        HandPart::ThumbSide,
        HandPart::PinkySide,
        HandPart::ThumbBall,
        HandPart::WristBack,
        HandPart::WristPulse,
        HandPart::LowerArm,
        HandPart::Elbow,
        HandPart::ElbowInside,
        HandPart::UpperArm,
    ];

    /// All of them.
    pub fn all() -> impl Iterator<Item = HandPart> {
        HandPart::OF_A_DIGIT.into_iter().chain(HandPart::OF_THE_LIMB).chain([HandPart::Wrist])
    }

    /// Whether the part belongs to a digit.
    pub fn needs_digit(self) -> bool {
        HandPart::OF_A_DIGIT.contains(&self)
    }

    /// The name in text.
    pub fn name(self) -> &'static str {
        match self {
            HandPart::Tip => "tip",
            HandPart::Nail => "nail",
            HandPart::Pad => "pad",
            HandPart::Midjoint => "midjoint",
            HandPart::Base => "base",
            HandPart::Side => "side",
            HandPart::Palm => "palm",
            HandPart::Back => "back",
            HandPart::ThumbSide => "thumb-side",
            HandPart::PinkySide => "pinky-side",
            HandPart::ThumbBall => "thumb-ball",
            HandPart::Wrist => "wrist",
            HandPart::WristBack => "wrist-back",
            HandPart::WristPulse => "wrist-pulse",
            HandPart::LowerArm => "lower-arm",
            HandPart::Elbow => "elbow",
            HandPart::ElbowInside => "elbow-inside",
            HandPart::UpperArm => "upper-arm",
        }
    }
}

/// Which face of a digit or of a limb (HamNoSys's dorsal, palmar and side modifiers).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Flank {
    /// The thumb's side.
    Radial,
    /// The little finger's side.
    Ulnar,
    /// The back of the hand's side.
    Dorsal,
    /// The palm's side.
    Palmar,
}

impl Flank {
    /// All four.
    pub const ALL: [Flank; 4] = [Flank::Radial, Flank::Ulnar, Flank::Dorsal, Flank::Palmar];

    /// The name in text.
    pub fn name(self) -> &'static str {
        match self {
            Flank::Radial => "radial",
            Flank::Ulnar => "ulnar",
            Flank::Dorsal => "dorsal",
            Flank::Palmar => "palmar",
        }
    }
}

/// A point of a hand or arm: part, digits where the part needs them (several: their middle), face; or halfway to another
/// such point.
///
/// Written `index tip`, `index middle pad`, `radial index side`, `palm`, `index tip to index midjoint`.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct HandPoint {
    first: Spot,
    second: Option<Spot>,
}

/// A named spot of a hand or arm.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
struct Spot {
    digits: Digits,
    part: HandPart,
    flank: Option<Flank>,
}

impl HandPoint {
    /// The palm.
    pub const PALM: HandPoint = HandPoint::of_limb(HandPart::Palm);
    /// The back of the hand.
    pub const BACK: HandPoint = HandPoint::of_limb(HandPart::Back);
    /// The wrist.
    pub const WRIST: HandPoint = HandPoint::of_limb(HandPart::Wrist);

    /// A part that no digit has.
    const fn of_limb(part: HandPart) -> HandPoint {
        HandPoint { first: Spot { digits: Digits::NONE, part, flank: None }, second: None }
    }

    /// A point; `None` where a part of a digit has no digit, or a part of the limb has one, and for a face of the
    /// wrist joint.
    pub fn new(digits: Digits, part: HandPart, flank: Option<Flank>) -> Option<HandPoint> {
        let sound = part.needs_digit() != digits.is_empty() && (part != HandPart::Wrist || flank.is_none());
        sound.then_some(HandPoint { first: Spot { digits, part, flank }, second: None })
    }

    /// Halfway between two points (HamNoSys "between"); what they are halfway to themselves is left out.
    pub fn halfway(self, to: HandPoint) -> HandPoint {
        HandPoint { first: self.first, second: Some(to.first) }
    }

    /// The point that this one lies halfway to.
    pub fn second(self) -> Option<HandPoint> {
        self.second.map(|first| HandPoint { first, second: None })
    }

    /// The first of the two points that this one lies between; itself where it lies between none.
    pub fn first(self) -> HandPoint {
        HandPoint { first: self.first, second: None }
    }

    /// A part of one digit.
    pub fn of_digit(digit: Digit, part: HandPart) -> Option<HandPoint> {
        HandPoint::new(Digits::of([digit]), part, None)
    }

    /// The digits; empty for parts of the whole limb. Of the first point where it lies between two, as all that follow.
    pub fn digits(self) -> Digits {
        self.first.digits
    }

    /// The part.
    pub fn part(self) -> HandPart {
        self.first.part
    }

    /// The face, where stated.
    pub fn flank(self) -> Option<Flank> {
        self.first.flank
    }
}

impl fmt::Display for HandPoint {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.second {
            None => self.first.fmt(f),
            Some(second) => write!(f, "{} to {second}", self.first),
        }
    }
}

impl fmt::Display for Spot {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        if let Some(flank) = self.flank {
            write!(f, "{} ", flank.name())?;
        }
        for digit in self.digits.iter() {
            write!(f, "{} ", digit.name())?;
        }
        f.write_str(self.part.name())
    }
}
