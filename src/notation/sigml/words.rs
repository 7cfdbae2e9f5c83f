//! The values of gestural SiGML, read and written by the same tables.

use crate::notation::hamnosys::syntax::{
    Bend, Change, Contact, Ellipse, Face, FeatureKind, FingerPart, RepetitionKind, ShapeClass, Side, Successive, Thumb,
    TierKind, WaveStyle,
};
use crate::phonology::roll::Roll;
use crate::phonology::{Clock, Digit, Direction, Size, WristMotion};

/// What the values of an attribute are called.
pub(super) struct Words<T: 'static> {
    /// What the value is, with its article: "a hand shape".
    pub what: &'static str,
    /// All values, in the order in which they are offered.
    pub all: &'static [T],
    /// Each value's word.
    pub word: fn(T) -> &'static str,
    /// Other words that are read.
    pub also: &'static [(&'static str, T)],
}

impl<T: Copy> Words<T> {
    /// The value of a word.
    pub fn find(&self, word: &str) -> Option<T> {
        let known = self.all.iter().find(|value| (self.word)(**value) == word).copied();
        known.or_else(|| self.also.iter().find(|(also, _)| *also == word).map(|(_, value)| *value))
    }

    /// The words that are offered.
    pub fn list(&self) -> impl Iterator<Item = &'static str> {
        self.all.iter().map(|value| (self.word)(*value))
    }
}

pub(super) const CLASS: Words<ShapeClass> = Words {
    what: "a hand shape",
    all: &[
        ShapeClass::Fist,
        ShapeClass::Flat,
        ShapeClass::Finger2,
        ShapeClass::Finger23,
        ShapeClass::Finger23Spread,
        ShapeClass::Finger2345,
        ShapeClass::Pinch12,
        ShapeClass::PinchAll,
        ShapeClass::Pinch12Open,
        ShapeClass::Cee12,
        ShapeClass::CeeAll,
        ShapeClass::Cee12Open,
    ],
    word: |class| match class {
        ShapeClass::Fist => "fist",
        ShapeClass::Flat => "flat",
        ShapeClass::Finger2 => "finger2",
        ShapeClass::Finger23 => "finger23",
        ShapeClass::Finger23Spread => "finger23spread",
        ShapeClass::Finger2345 => "finger2345",
        ShapeClass::Pinch12 => "pinch12",
        ShapeClass::PinchAll => "pinchall",
        ShapeClass::Pinch12Open => "pinch12open",
        ShapeClass::Cee12 => "cee12",
        ShapeClass::CeeAll => "ceeall",
        ShapeClass::Cee12Open => "cee12open",
    },
    also: &[("flathand", ShapeClass::Flat), ("pinchopen", ShapeClass::Pinch12Open), ("ceeopen", ShapeClass::Cee12Open)],
};

/// Whether the class is a C, whose thumb SiGML writes as its opening.
pub(super) fn is_cee(class: ShapeClass) -> bool {
    match class {
        ShapeClass::Cee12 | ShapeClass::CeeAll | ShapeClass::Cee12Open => true,
        ShapeClass::Fist | ShapeClass::Flat | ShapeClass::Finger2 | ShapeClass::Finger23 => false,
        ShapeClass::Finger23Spread | ShapeClass::Finger2345 => false,
        ShapeClass::Pinch12 | ShapeClass::PinchAll | ShapeClass::Pinch12Open => false,
    }
}

pub(super) const THUMB: Words<Thumb> = Words {
    what: "a position of the thumb",
    all: &[Thumb::Out, Thumb::Across, Thumb::Open],
    word: |thumb| match thumb {
        Thumb::Out => "out",
        Thumb::Across => "across",
        Thumb::Open => "opposed",
    },
    also: &[("open", Thumb::Open)],
};

/// How open a C is, by what the thumb's symbol says. `out` says nothing of it and is written as the thumb's position.
pub(super) const OPENING: Words<Thumb> = Words {
    what: "an opening of a C",
    all: &[Thumb::Across, Thumb::Open],
    word: |thumb| match thumb {
        Thumb::Across => "tight",
        Thumb::Open => "slack",
        Thumb::Out => "out",
    },
    also: &[],
};

/// The bends that have a name; a bend in quarters has none.
pub(super) const BEND: Words<Bend> = Words {
    what: "a bend of fingers",
    all: &[Bend::Bent, Bend::Round, Bend::Hooked, Bend::DoubleBent, Bend::DoubleHooked, Bend::HalfBent],
    word: |bend| match bend {
        Bend::Bent => "bent",
        Bend::Round => "round",
        Bend::Hooked => "hooked",
        Bend::DoubleBent => "dblbent",
        Bend::DoubleHooked => "dblhooked",
        Bend::HalfBent => "halfbent",
        Bend::Quarters(_) => "",
    },
    also: &[("doublebent", Bend::DoubleBent), ("doublehooked", Bend::DoubleHooked)],
};

pub(super) const PART: Words<FingerPart> = Words {
    what: "a part of a finger",
    all: &[
        FingerPart::Tip,
        FingerPart::Nail,
        FingerPart::Pad,
        FingerPart::MidJoint,
        FingerPart::Base,
        FingerPart::Side,
    ],
    word: |part| match part {
        FingerPart::Tip => "tip",
        FingerPart::Nail => "nail",
        FingerPart::Pad => "pad",
        FingerPart::MidJoint => "midjoint",
        FingerPart::Base => "base",
        FingerPart::Side => "side",
    },
    also: &[],
};

pub(super) const SUCCESSIVE: Words<Successive> = Words {
    what: "an order of fingers",
    all: &[Successive::TowardPinky, Successive::TowardThumb],
    word: |order| match order {
        Successive::TowardPinky => "towards_pinky",
        Successive::TowardThumb => "towards_thumb",
    },
    also: &[],
};

pub(super) const CONTACT: Words<Contact> = Words {
    what: "a contact",
    all: &[Contact::Touch, Contact::Close, Contact::Interlock, Contact::Cross, Contact::ArmExtended],
    word: |contact| match contact {
        Contact::Touch => "touch",
        Contact::Close => "close",
        Contact::Interlock => "interlock",
        Contact::Cross => "cross",
        Contact::ArmExtended => "armextended",
    },
    also: &[],
};

/// To which side of a place, or on which of its faces: one attribute says either.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Flank {
    Side(Side),
    Face(Face),
}

pub(super) const FLANK: Words<Flank> = Words {
    what: "a side of a place",
    all: &[
        Flank::Side(Side::LeftBeside),
        Flank::Side(Side::LeftAt),
        Flank::Side(Side::RightAt),
        Flank::Side(Side::RightBeside),
        Flank::Face(Face::Dorsal),
        Flank::Face(Face::Palmar),
    ],
    word: |flank| match flank {
        Flank::Side(Side::LeftBeside) => "left_beside",
        Flank::Side(Side::LeftAt) => "left_at",
        Flank::Side(Side::RightAt) => "right_at",
        Flank::Side(Side::RightBeside) => "right_beside",
        Flank::Face(Face::Dorsal) => "dorsal",
        Flank::Face(Face::Palmar) => "palmar",
    },
    also: &[],
};

/// Sizes that are written; a plain one is not.
pub(super) const SIZE: Words<Size> = Words {
    what: "a size",
    all: &[Size::Small, Size::Large],
    word: |size| match size {
        Size::Small => "small",
        Size::Normal => "normal",
        Size::Large => "big",
    },
    also: &[("large", Size::Large), ("normal", Size::Normal), ("medium", Size::Normal)],
};

pub(super) const WRIST: Words<WristMotion> = Words {
    what: "a motion of the wrist",
    all: &WristMotion::ALL,
    word: |motion| match motion {
        WristMotion::Nod => "nodding",
        WristMotion::Swing => "swinging",
        WristMotion::Twist => "twisting",
        WristMotion::StirClockwise => "stircw",
        WristMotion::StirCounterclockwise => "stirccw",
    },
    also: &[("nod", WristMotion::Nod), ("swing", WristMotion::Swing), ("twist", WristMotion::Twist)],
};

pub(super) const ELLIPSE: Words<Ellipse> = Words {
    what: "the long axis of an ellipse",
    all: &[Ellipse::Horizontal, Ellipse::UpRight, Ellipse::Vertical, Ellipse::UpLeft],
    word: |ellipse| match ellipse {
        Ellipse::Horizontal => "h",
        Ellipse::UpRight => "ur",
        Ellipse::Vertical => "v",
        Ellipse::UpLeft => "ul",
    },
    also: &[],
};

pub(super) const WAVE: Words<WaveStyle> = Words {
    what: "a style of waves",
    all: &[WaveStyle::Zigzag, WaveStyle::Wavy],
    word: |style| match style {
        WaveStyle::Zigzag => "zigzag",
        WaveStyle::Wavy => "wavy",
    },
    also: &[],
};

pub(super) const CHANGE: Words<Change> = Words {
    what: "a change of size",
    all: &[Change::Increasing, Change::Decreasing],
    word: |change| match change {
        Change::Increasing => "increasing",
        Change::Decreasing => "decreasing",
    },
    also: &[],
};

pub(super) const REPETITION: Words<RepetitionKind> = Words {
    what: "a repetition",
    all: &[
        RepetitionKind::FromStart,
        RepetitionKind::FromStartSeveral,
        RepetitionKind::Continue,
        RepetitionKind::ContinueSeveral,
        RepetitionKind::Reverse,
        RepetitionKind::ToFroTo,
    ],
    word: |kind| match kind {
        RepetitionKind::FromStart => "fromstart",
        RepetitionKind::FromStartSeveral => "fromstart_several",
        RepetitionKind::Continue => "continue",
        RepetitionKind::ContinueSeveral => "continue_several",
        RepetitionKind::Reverse => "reverse",
        RepetitionKind::ToFroTo => "tofroto",
    },
    also: &[
        ("fromstartseveral", RepetitionKind::FromStartSeveral),
        ("continueseveral", RepetitionKind::ContinueSeveral),
    ],
};

pub(super) const TRUTH: Words<bool> = Words {
    what: "true or false",
    all: &[true, false],
    word: |truth| if truth { "true" } else { "false" },
    also: &[("True", true), ("TRUE", true), ("False", false), ("FALSE", false), ("1", true), ("0", false)],
};

pub(super) const TIER: Words<TierKind> = Words {
    what: "a non-manual tier",
    all: &[
        TierKind::Shoulder,
        TierKind::Body,
        TierKind::Head,
        TierKind::EyeGaze,
        TierKind::FacialExpression,
        TierKind::Mouthing,
        TierKind::Extra,
    ],
    word: |tier| match tier {
        TierKind::Shoulder => "shoulder_tier",
        TierKind::Body => "body_tier",
        TierKind::Head => "head_tier",
        TierKind::EyeGaze => "eyegaze_tier",
        TierKind::FacialExpression => "facialexpr_tier",
        TierKind::Mouthing => "mouthing_tier",
        TierKind::Extra => "extra_tier",
    },
    also: &[],
};

/// The elements for values of a tier at the same time and one after the other.
pub(super) fn groups(tier: TierKind) -> (&'static str, &'static str) {
    match tier {
        TierKind::Shoulder => ("shoulder_par", "shoulder_seq"),
        TierKind::Body => ("body_par", "body_seq"),
        TierKind::Head => ("head_par", "head_seq"),
        TierKind::EyeGaze => ("eye_par", "eye_seq"),
        TierKind::FacialExpression => ("facial_expr_par", "facial_expr_seq"),
        TierKind::Mouthing => ("mouthing_par", "mouthing_seq"),
        TierKind::Extra => ("extra_par", "extra_seq"),
    }
}

const FEATURES: &[FeatureKind] = &[
    FeatureKind::Shoulder,
    FeatureKind::Body,
    FeatureKind::Head,
    FeatureKind::EyeGaze,
    FeatureKind::EyeBrows,
    FeatureKind::EyeLids,
    FeatureKind::Nose,
    FeatureKind::MouthGesture,
    FeatureKind::MouthPicture,
    FeatureKind::Extra,
];

pub(super) const FEATURE: Words<FeatureKind> = Words {
    what: "a non-manual value",
    all: FEATURES,
    word: |kind| match kind {
        FeatureKind::Shoulder => "shoulder_movement",
        FeatureKind::Body => "body_movement",
        FeatureKind::Head => "head_movement",
        FeatureKind::EyeGaze => "eye_gaze",
        FeatureKind::EyeBrows => "eye_brows",
        FeatureKind::EyeLids => "eye_lids",
        FeatureKind::Nose => "nose",
        FeatureKind::MouthGesture => "mouth_gesture",
        FeatureKind::MouthPicture => "mouth_picture",
        FeatureKind::Extra => "extra_movement",
    },
    also: &[],
};

/// The same in H-SiGML.
pub(super) const PLAIN_FEATURE: Words<FeatureKind> = Words {
    what: "a non-manual value",
    all: FEATURES,
    word: |kind| match kind {
        FeatureKind::Shoulder => "hnm_shoulder",
        FeatureKind::Body => "hnm_body",
        FeatureKind::Head => "hnm_head",
        FeatureKind::EyeGaze => "hnm_eyegaze",
        FeatureKind::EyeBrows => "hnm_eyebrows",
        FeatureKind::EyeLids => "hnm_eyelids",
        FeatureKind::Nose => "hnm_nose",
        FeatureKind::MouthGesture => "hnm_mouthgesture",
        FeatureKind::MouthPicture => "hnm_mouthpicture",
        FeatureKind::Extra => "hnm_extra",
    },
    also: &[("hns_extra", FeatureKind::Extra)],
};

/// The tier that a value belongs to.
pub(super) fn tier_of(kind: FeatureKind) -> TierKind {
    match kind {
        FeatureKind::Shoulder => TierKind::Shoulder,
        FeatureKind::Body => TierKind::Body,
        FeatureKind::Head => TierKind::Head,
        FeatureKind::EyeGaze => TierKind::EyeGaze,
        FeatureKind::EyeBrows | FeatureKind::EyeLids | FeatureKind::Nose => TierKind::FacialExpression,
        FeatureKind::MouthGesture | FeatureKind::MouthPicture => TierKind::Mouthing,
        FeatureKind::Extra => TierKind::Extra,
    }
}

/// Places of head and trunk, by their symbols without `ham`, and those that gestural SiGML adds.
pub(super) const BODY: &[&str] = &[
    "head",
    "headtop",
    "forehead",
    "eyebrows",
    "eyes",
    "uppereyelid",
    "lowereyelid",
    "nose",
    "nostrils",
    "ear",
    "earlobe",
    "cheek",
    "lips",
    "upperlip",
    "lowerlip",
    "tongue",
    "teeth",
    "chin",
    "underchin",
    "neck",
    "shouldertop",
    "shoulders",
    "chest",
    "stomach",
    "belowstomach",
];

/// Places of the arm and of the whole hand: both kinds of location may name them.
pub(super) const ARM: &[&str] = &[
    "upperarm",
    "elbow",
    "elbowinside",
    "lowerarm",
    "wristback",
    "wristpulse",
    "thumbball",
    "palm",
    "handback",
    "thumbside",
    "pinkyside",
];

/// The digits of a list such as `25`, in its order; `None` where it has anything else.
pub(super) fn digits(word: &str) -> Option<Vec<Digit>> {
    word.chars().map(digit).collect()
}

/// The digit of its number.
pub(super) fn digit(number: char) -> Option<Digit> {
    match number {
        '1' => Some(Digit::Thumb),
        '2' => Some(Digit::Index),
        '3' => Some(Digit::Middle),
        '4' => Some(Digit::Ring),
        '5' => Some(Digit::Pinky),
        _ => None,
    }
}

/// The number of a digit.
pub(super) fn number(digit: Digit) -> char {
    match digit {
        Digit::Thumb => '1',
        Digit::Index => '2',
        Digit::Middle => '3',
        Digit::Ring => '4',
        Digit::Pinky => '5',
    }
}

/// A direction as written: one, or halfway from the first to the second.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Pointed {
    One(Direction),
    Halfway(Direction, Direction),
}

/// Reads a direction: the letters of its parts in any order; a doubled letter is halfway back to that letter alone, so
/// that `uuo` lies between `u` and `uo`.
///
/// `None` where a letter is unknown, opposite letters meet, or there is none.
pub(super) fn direction(word: &str) -> Option<Pointed> {
    if word.len() > 6 {
        return None;
    }
    let (mut all, mut doubled) = ([0i8; 3], [0i8; 3]);
    for letter in word.bytes() {
        let (axis, sign) = match letter.to_ascii_lowercase() {
            b'l' => (0, 1),
            b'r' => (0, -1),
            b'u' => (1, 1),
            b'd' => (1, -1),
            b'o' => (2, 1),
            b'i' => (2, -1),
            _ => return None,
        };
        match all[axis] {
            0 => all[axis] = sign,
            there if there == sign && doubled[axis] == 0 => doubled[axis] = sign,
            _ => return None,
        }
    }
    let of = |signs: [i8; 3]| Direction::new(signs[0], signs[1], signs[2]);
    let whole = of(all)?;
    Some(match of(doubled) {
        Some(plain) if plain != whole => Pointed::Halfway(plain, whole),
        Some(_) | None => Pointed::One(whole),
    })
}

/// Writes a direction: height, depth, side.
pub(super) fn letters(direction: Direction) -> String {
    let [left, up, out] = direction.signs();
    let parts = [(up, 'u', 'd'), (out, 'o', 'i'), (left, 'l', 'r')];
    let letter = |(sign, more, less): (i8, char, char)| match sign {
        0 => None,
        1.. => Some(more),
        _ => Some(less),
    };
    parts.into_iter().filter_map(letter).collect()
}

/// A palm symbol or the bulge of an arc, its letters in either order.
pub(super) fn roll(word: &str) -> Option<Roll> {
    Roll::from_tag(word).or_else(|| match *word.as_bytes() {
        [a, b] if a != b => Roll::from_tag(&String::from_iter([char::from(b), char::from(a)])),
        _ => None,
    })
}

/// A place of the clock face.
pub(super) fn clock(word: &str) -> Option<Clock> {
    roll(word).and_then(|roll| Roll::all().position(|r| r == roll)).and_then(|i| Clock::new(u8::try_from(i).ok()?))
}

/// The letters of a place of the clock face.
pub(super) fn clock_letters(clock: Clock) -> &'static str {
    Roll::TAGS[usize::from(clock.eighths() % 8)]
}

/// A bend as three quarters of the range of each joint (`410`); with decimals (`0.50.50.5`), rounded, said to be so.
pub(super) fn quarters(word: &str) -> Option<(Bend, Exactness)> {
    let of = |digits: Vec<f64>| -> Option<[u8; 3]> {
        let rounded: Vec<u8> = digits.iter().map(|d| d.round() as u8).filter(|d| *d <= 4).collect();
        rounded.try_into().ok()
    };
    let bytes = word.as_bytes();
    let value = |b: u8| b.is_ascii_digit().then(|| f64::from(b - b'0'));
    if bytes.len() == 3 {
        let digits = bytes.iter().map(|b| value(*b)).collect::<Option<Vec<f64>>>()?;
        return of(digits).map(|q| (Bend::Quarters(q), Exactness::Exact));
    }
    if bytes.len() != 9 {
        return None;
    }
    let decimal = |part: &[u8]| match part {
        [whole, b'.', tenth] => Some(value(*whole)? + value(*tenth)? / 10.0),
        _ => None,
    };
    let digits = bytes.chunks(3).map(decimal).collect::<Option<Vec<f64>>>()?;
    of(digits).map(|q| (Bend::Quarters(q), Exactness::Rounded))
}

/// Whether a number was taken as it stands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) enum Exactness {
    Exact,
    Rounded,
}
