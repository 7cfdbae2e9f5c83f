//! The values of gestural SiGML, read and written by the same tables.

mod letters;
mod nonmanual;

use crate::notation::hamnosys::syntax::{
    Bend, Change, Contact, Ellipse, Face, FingerPart, RepetitionKind, ShapeClass, Side, Successive, Thumb, WaveStyle,
};
use crate::phonology::{Size, WristMotion};
pub(super) use letters::*;
pub(super) use nonmanual::*;

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
    all: &ShapeClass::ALL,
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
