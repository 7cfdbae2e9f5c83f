//! What a symbol is for: the classes of symbols that the grammar speaks of, with the values that they say.

use super::syntax::{Bend, Change, Clock, Contact, Ellipse, FingerPart, RepetitionKind, ShapeClass, Thumb, WaveStyle};
use crate::phonology::roll::Roll;
use crate::phonology::{Digit, Direction, Size, WristMotion};

/// The class of a symbol, with its value.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(crate) enum Kind {
    Class(ShapeClass),
    Thumb(Thumb),
    Bend(Bend),
    Fingers(Direction),
    Palm(Roll),
    /// A place of head or trunk.
    Body(&'static str),
    /// A place of the arm above the wrist.
    Arm(&'static str),
    /// A part of the hand, the wrist included.
    Hand(&'static str),
    Digit(Digit),
    Part(FingerPart),
    Neutral,
    Beside,
    At,
    NamesPlace,
    NamedPlace,
    Arrow(Direction),
    Circle(Direction),
    Wrist(WristMotion),
    FingerPlay,
    Replace,
    Crossing,
    Nothing,
    Clock(Clock),
    FullTurn,
    Arc(Roll),
    Wave(WaveStyle),
    Ellipse(Ellipse),
    Growth(Change),
    Size(Size),
    Manner(Manner),
    Contact(Contact),
    Behind,
    Brushing,
    Repeat(RepetitionKind),
    Alternating,
    Open(Bracket),
    Close(Bracket),
    Between,
    Plus,
    Symmetry(Reflection),
    Weak,
    NonIpsi,
    Etc,
    Relative,
    Mime,
    /// Marks of whole utterances: `!`, `?`, full stop, comma.
    Punctuation,
    AlternativesBegin,
    Or,
    AlternativesEnd,
    /// Space and the mark of the version.
    Silent,
}

/// The three pairs of brackets.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Bracket {
    Together,
    Sequence,
    Fusion,
}

/// The two operators of symmetry.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Reflection {
    Parallel,
    LeftRight,
}

/// How a movement is made.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Manner {
    Fast,
    Slow,
    Tense,
    Rest,
    Halt,
}

/// The class of the symbol with this tag, given without `ham`; nothing for a tag that is none.
pub(crate) fn kind_of(tag: &'static str) -> Option<Kind> {
    hand_kind(tag).or_else(|| place_kind(tag)).or_else(|| motion_kind(tag)).or_else(|| other_kind(tag))
}

/// A direction of a tag's ending: letters of `udlroi`.
fn direction(letters: &str) -> Option<Direction> {
    let (mut left, mut up, mut out) = (0, 0, 0);
    for letter in letters.chars() {
        let (axis, sign) = match letter {
            'u' => (&mut up, 1),
            'd' => (&mut up, -1),
            'l' => (&mut left, 1),
            'r' => (&mut left, -1),
            'o' => (&mut out, 1),
            'i' => (&mut out, -1),
            _other => return None,
        };
        if *axis != 0 {
            return None;
        }
        *axis = sign;
    }
    Direction::new(left, up, out)
}

fn hand_kind(tag: &str) -> Option<Kind> {
    let class = match tag {
        "fist" => ShapeClass::Fist,
        "flathand" => ShapeClass::Flat,
        "finger2" => ShapeClass::Finger2,
        "finger23" => ShapeClass::Finger23,
        "finger23spread" => ShapeClass::Finger23Spread,
        "finger2345" => ShapeClass::Finger2345,
        "pinch12" => ShapeClass::Pinch12,
        "pinchall" => ShapeClass::PinchAll,
        "pinch12open" => ShapeClass::Pinch12Open,
        "cee12" => ShapeClass::Cee12,
        "ceeall" => ShapeClass::CeeAll,
        "ceeopen" => ShapeClass::Cee12Open,
        "thumboutmod" => return Some(Kind::Thumb(Thumb::Out)),
        "thumbacrossmod" => return Some(Kind::Thumb(Thumb::Across)),
        "thumbopenmod" => return Some(Kind::Thumb(Thumb::Open)),
        "fingerstraightmod" => return Some(Kind::Bend(Bend::Bent)),
        "fingerbendmod" => return Some(Kind::Bend(Bend::Round)),
        "fingerhookmod" => return Some(Kind::Bend(Bend::Hooked)),
        "doublebent" => return Some(Kind::Bend(Bend::DoubleBent)),
        "doublehooked" => return Some(Kind::Bend(Bend::DoubleHooked)),
        "thumb" => return Some(Kind::Digit(Digit::Thumb)),
        "indexfinger" => return Some(Kind::Digit(Digit::Index)),
        "middlefinger" => return Some(Kind::Digit(Digit::Middle)),
        "ringfinger" => return Some(Kind::Digit(Digit::Ring)),
        "pinky" => return Some(Kind::Digit(Digit::Pinky)),
        "fingertip" => return Some(Kind::Part(FingerPart::Tip)),
        "fingernail" => return Some(Kind::Part(FingerPart::Nail)),
        "fingerpad" => return Some(Kind::Part(FingerPart::Pad)),
        "fingermidjoint" => return Some(Kind::Part(FingerPart::MidJoint)),
        "fingerbase" => return Some(Kind::Part(FingerPart::Base)),
        "fingerside" => return Some(Kind::Part(FingerPart::Side)),
        _other => return directed_kind(tag),
    };
    Some(Kind::Class(class))
}

/// The symbols whose tags end in a direction or in a letter that is drawn.
fn directed_kind(tag: &str) -> Option<Kind> {
    let after = |prefix: &str| tag.strip_prefix(prefix);
    let ellipse = |ending: &str| match ending {
        "h" => Some(Ellipse::Horizontal),
        "ur" => Some(Ellipse::UpRight),
        "v" => Some(Ellipse::Vertical),
        "ul" => Some(Ellipse::UpLeft),
        _other => None,
    };
    (after("extfinger").and_then(direction).map(Kind::Fingers))
        .or_else(|| after("palm").and_then(Roll::from_tag).map(Kind::Palm))
        .or_else(|| after("move").and_then(direction).map(Kind::Arrow))
        .or_else(|| after("circle").and_then(direction).map(Kind::Circle))
        .or_else(|| after("arc").and_then(Roll::from_tag).map(Kind::Arc))
        .or_else(|| after("clock").and_then(clock).map(Kind::Clock))
        .or_else(|| after("ellipse").and_then(ellipse).map(Kind::Ellipse))
}

fn clock(ending: &str) -> Option<Clock> {
    let eighths = Roll::TAGS.iter().position(|t| *t == ending)?;
    Clock::new(eighths as u8)
}

fn place_kind(tag: &'static str) -> Option<Kind> {
    Some(match tag {
        "head" | "headtop" | "forehead" | "eyebrows" | "eyes" | "nose" | "nostrils" | "ear" | "earlobe" | "cheek"
        | "lips" | "tongue" | "teeth" | "chin" | "underchin" | "neck" | "shouldertop" | "shoulders" | "chest"
        | "stomach" | "belowstomach" => Kind::Body(tag),
        "upperarm" | "elbow" | "elbowinside" | "lowerarm" => Kind::Arm(tag),
        "wristback" | "wristpulse" | "thumbball" | "palm" | "handback" | "thumbside" | "pinkyside" => Kind::Hand(tag),
        // Obsolete: the nearest places of today.
        "wristtopulse" => Kind::Hand("wristpulse"),
        "wristtoback" => Kind::Hand("wristback"),
        "wristtothumb" => Kind::Hand("thumbside"),
        "wristtopinky" => Kind::Hand("pinkyside"),
        "neutralspace" => Kind::Neutral,
        "lrbeside" => Kind::Beside,
        "lrat" => Kind::At,
        "coreftag" => Kind::NamesPlace,
        "corefref" => Kind::NamedPlace,
        "behind" => Kind::Behind,
        "touch" => Kind::Contact(Contact::Touch),
        "close" => Kind::Contact(Contact::Close),
        "interlock" => Kind::Contact(Contact::Interlock),
        "cross" => Kind::Contact(Contact::Cross),
        "armextended" => Kind::Contact(Contact::ArmExtended),
        _other => return None,
    })
}

fn motion_kind(tag: &str) -> Option<Kind> {
    Some(match tag {
        "fingerplay" => Kind::FingerPlay,
        "nodding" => Kind::Wrist(WristMotion::Nod),
        "swinging" => Kind::Wrist(WristMotion::Swing),
        "twisting" => Kind::Wrist(WristMotion::Twist),
        "stircw" => Kind::Wrist(WristMotion::StirClockwise),
        "stirccw" => Kind::Wrist(WristMotion::StirCounterclockwise),
        "replace" => Kind::Replace,
        "movecross" | "moveX" => Kind::Crossing,
        "nomotion" => Kind::Nothing,
        "clockfull" => Kind::FullTurn,
        "wavy" => Kind::Wave(WaveStyle::Wavy),
        "zigzag" => Kind::Wave(WaveStyle::Zigzag),
        "increasing" => Kind::Growth(Change::Increasing),
        "decreasing" => Kind::Growth(Change::Decreasing),
        "smallmod" => Kind::Size(Size::Small),
        "largemod" => Kind::Size(Size::Large),
        "fast" => Kind::Manner(Manner::Fast),
        "slow" => Kind::Manner(Manner::Slow),
        "tense" => Kind::Manner(Manner::Tense),
        "rest" => Kind::Manner(Manner::Rest),
        "halt" => Kind::Manner(Manner::Halt),
        "brushing" => Kind::Brushing,
        "repeatfromstart" => Kind::Repeat(RepetitionKind::FromStart),
        "repeatfromstartseveral" => Kind::Repeat(RepetitionKind::FromStartSeveral),
        "repeatcontinue" => Kind::Repeat(RepetitionKind::Continue),
        "repeatcontinueseveral" => Kind::Repeat(RepetitionKind::ContinueSeveral),
        "repeatreverse" => Kind::Repeat(RepetitionKind::Reverse),
        "alternatingmotion" => Kind::Alternating,
        _other => return None,
    })
}

fn other_kind(tag: &str) -> Option<Kind> {
    Some(match tag {
        "seqbegin" => Kind::Open(Bracket::Sequence),
        "seqend" => Kind::Close(Bracket::Sequence),
        "parbegin" => Kind::Open(Bracket::Together),
        "parend" => Kind::Close(Bracket::Together),
        "fusionbegin" => Kind::Open(Bracket::Fusion),
        "fusionend" => Kind::Close(Bracket::Fusion),
        "between" => Kind::Between,
        "plus" => Kind::Plus,
        "symmpar" => Kind::Symmetry(Reflection::Parallel),
        "symmlr" => Kind::Symmetry(Reflection::LeftRight),
        "nondominant" => Kind::Weak,
        "nonipsi" => Kind::NonIpsi,
        "etc" => Kind::Etc,
        "orirelative" => Kind::Relative,
        "mime" => Kind::Mime,
        "exclaim" | "query" | "fullstop" | "comma" => Kind::Punctuation,
        "altbegin" => Kind::AlternativesBegin,
        "metaalt" => Kind::Or,
        "altend" => Kind::AlternativesEnd,
        "space" | "version40" => Kind::Silent,
        _other => return None,
    })
}
