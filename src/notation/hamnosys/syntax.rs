//! HamNoSys and SiGML as they are written: one tree for both.
//!
//! HamNoSys 4 is a string of symbols; H-SiGML the same symbols as XML elements; gestural SiGML the tree that a parser of HamNoSys
//! comes to, with the same distinctions under other names (`round` for `hamfingerbendmod`, `tight` for
//! `hamthumbacrossmod` after a C). This tree keeps what HamNoSys writes; the readers and writers of gestural SiGML translate.
//!
//! Directions are those of space ([`Direction`]); palms are rolls about the finger direction ([`Roll`]), as the symbols say.
//! What these values mean as a sign is the affair of `lower`; this module names no handshape and no place of the inventories.

use crate::diagnostics::Span;
use crate::phonology::roll::Roll;
use crate::phonology::{Digit, Direction, Size, WristMotion};

/// A sign.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Sign {
    /// The gloss, where it has one.
    pub gloss: Option<String>,
    /// What the whole sign's element says of time.
    pub timing: Timing,
    /// Non-manual tiers, in the order written.
    pub nonmanual: Vec<Tier>,
    /// The manual phases, in order; none for a sign that is made with face and body alone.
    pub phases: Vec<Phase>,
    /// Where it was written.
    pub span: Ignored,
}

/// A span that equality passes over.
#[derive(Debug, Clone, Copy, Default)]
pub struct Ignored(pub Span);

impl PartialEq for Ignored {
    fn eq(&self, _: &Ignored) -> bool {
        true
    }
}

impl Eq for Ignored {}

/// SiGML's attributes of a whole sign; all above 0.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Timing {
    /// A factor: 2 is twice as fast.
    pub speed: Option<f64>,
    /// Seconds for the whole sign.
    pub duration: Option<f64>,
    /// A factor of all times: 2 is twice as long.
    pub timescale: Option<f64>,
}

// Non-manuals -------------------------------------------------------------------------------------------------------

/// A non-manual tier.
#[derive(Debug, Clone, PartialEq)]
pub struct Tier {
    /// Which.
    pub kind: TierKind,
    /// What it says; several cues follow each other.
    pub cues: Vec<Cue>,
}

/// The non-manual tiers of gestural SiGML, in its order.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum TierKind {
    /// `shoulder_tier`
    Shoulder,
    /// `body_tier`
    Body,
    /// `head_tier`
    Head,
    /// `eyegaze_tier`
    EyeGaze,
    /// `facialexpr_tier`: brows, lids, nose.
    FacialExpression,
    /// `mouthing_tier`
    Mouthing,
    /// `extra_tier`
    Extra,
}

/// One value of a non-manual tier, or several.
#[derive(Debug, Clone, PartialEq)]
pub enum Cue {
    /// One.
    One(Feature),
    /// At the same time (`…_par`).
    Together(Vec<Cue>),
    /// One after the other (`…_seq`).
    Sequence(Vec<Cue>),
}

/// A non-manual value.
#[derive(Debug, Clone, PartialEq)]
pub struct Feature {
    /// What moves.
    pub kind: FeatureKind,
    /// The tag (`NO`, `L06`), or for a mouth picture its sounds in SAMPA.
    pub value: String,
    /// `amount`: how much, 1 where it is not said.
    pub amount: Option<f64>,
    /// `speed`: how fast, 1 where it is not said.
    pub speed: Option<f64>,
    /// Where the value was written.
    pub span: Ignored,
}

/// What a non-manual value moves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum FeatureKind {
    /// `hnm_shoulder`, `shoulder_movement`
    Shoulder,
    /// `hnm_body`, `body_movement`
    Body,
    /// `hnm_head`, `head_movement`
    Head,
    /// `hnm_eyegaze`, `eye_gaze`
    EyeGaze,
    /// `hnm_eyebrows`, `eye_brows`
    EyeBrows,
    /// `hnm_eyelids`, `eye_lids`
    EyeLids,
    /// `hnm_nose`, `nose`
    Nose,
    /// `hnm_mouthgesture`, `mouth_gesture`
    MouthGesture,
    /// `hnm_mouthpicture`, `mouth_picture`
    MouthPicture,
    /// `hnm_extra`, `extra_movement`
    Extra,
}

// Manual phases -----------------------------------------------------------------------------------------------------

/// A manual phase: a posture and what is done from there (`sign1`, `sign2`, `sign_manual`).
#[derive(Debug, Clone, PartialEq)]
pub struct Phase {
    /// Which hands act, and how.
    pub hands: Hands,
    /// The other hand keeps what the phase before left it with (`hamnomotion` first; `holdover`).
    pub holds_over: bool,
    /// What parts of the body do at the start, `hamseqbegin bodypart action hamseqend` before the hand configuration.
    pub body: Vec<Action>,
    /// The posture at the start.
    pub posture: Posture,
    /// Where the hand or hands are at the start.
    pub location: Option<Location>,
    /// What is done, one after the other.
    pub actions: Vec<Action>,
    /// Where it was written.
    pub span: Ignored,
}

/// Which hands act.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Hands {
    /// The strong hand; the weak one has a posture where the posture is split, and does nothing but what split actions say.
    Strong,
    /// The weak hand alone (`hamnondominant`).
    Weak,
    /// Both, the weak following the strong.
    Both(Symmetry),
}

/// The symmetry of two hands.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Symmetry {
    /// `hamsymmlr` rather than `hamsymmpar` (`lr_symm`).
    pub left_right: bool,
    /// `hamlargemod` after it (`ud_symm`).
    pub up_down: bool,
    /// `hamfingerstraightmod` after it (`oi_symm`).
    pub out_in: bool,
    /// `hamalternatingmotion` (`outofphase`).
    pub alternating: bool,
    /// `hamnonipsi` (`realspace`).
    pub non_ipsi: bool,
}

/// One value for both hands, or one each.
#[derive(Debug, Clone, PartialEq)]
pub enum Split<T> {
    /// For the hand or hands that act.
    Both(T),
    /// `hampar` strong `hamplus` weak; where one is not said, that hand stays as it is.
    Each(Option<T>, Option<T>),
}

/// The posture of the hand or hands; what is not said stays.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Posture {
    /// Hand shape.
    pub shape: Option<Split<Shape>>,
    /// Extended finger direction.
    pub fingers: Option<Split<Fingers>>,
    /// Palm orientation.
    pub palm: Option<Split<Palm>>,
}

impl Posture {
    /// Whether nothing is said.
    pub fn is_empty(&self) -> bool {
        *self == Posture::default()
    }
}

/// A hand shape.
#[derive(Debug, Clone, PartialEq)]
pub struct Shape {
    /// The class with its thumb and bend.
    pub main: BentClass,
    /// `hametc`: something like it.
    pub approximate: bool,
    /// Halfway to another class (`hambetween`; `second_handshape`).
    pub between: Option<BentClass>,
    /// The list of fingers, in the order written (`fingernothumb`): by class they are special fingers, or exempted from the bend
    /// (see [`Shape::lists`]).
    pub fingers: Vec<ListedFinger>,
    /// Bends of single digits (`bend2`); `None` is a bend without a digit, which means the index.
    pub bends: Vec<(Option<Digit>, Bend)>,
    /// Digits that touch (`contactpair`, `contactkind`): the first touches a part of the second; at most two.
    pub crossings: Vec<(Digit, FingerPart, Digit)>,
    /// What the thumb does beyond its position.
    pub thumb: Option<ThumbSpecial>,
    /// In a replacement: the fingers change one after the other.
    pub successive: Option<Successive>,
}

impl Shape {
    /// A plain class.
    pub fn of(class: ShapeClass) -> Shape {
        Shape {
            main: BentClass { class, thumb: None, bend: None },
            approximate: false,
            between: None,
            fingers: Vec::new(),
            bends: Vec::new(),
            crossings: Vec::new(),
            thumb: None,
            successive: None,
        }
    }

    /// What the list of fingers means (gestural SiGML has an attribute for each meaning): with a fist, a flat hand or all
    /// fingers the listed ones are exempted from the bend; one listed finger with `finger2`, two or more with `finger23`
    /// and its spread sister are the fingers that are stretched, one with the latter is exempted; with a pinch or C of single
    /// fingers they are those that meet the thumb, and in a bent pinch also exempted; with all fingers they are exempted.
    pub fn lists(&self) -> FingerList {
        let bent = self.main.bend.is_some() || self.between.is_some_and(|b| b.bend.is_some());
        match self.main.class {
            ShapeClass::Fist | ShapeClass::Flat | ShapeClass::Finger2345 => FingerList::Exempted,
            ShapeClass::Finger2 => FingerList::Special,
            ShapeClass::Finger23 | ShapeClass::Finger23Spread => match self.fingers.len() {
                0 | 1 => FingerList::Exempted,
                _ => FingerList::Special,
            },
            ShapeClass::PinchAll | ShapeClass::CeeAll => FingerList::Exempted,
            ShapeClass::Pinch12 | ShapeClass::Pinch12Open if bent => FingerList::SpecialAndExempted,
            ShapeClass::Pinch12 | ShapeClass::Pinch12Open | ShapeClass::Cee12 | ShapeClass::Cee12Open => {
                FingerList::Special
            }
        }
    }
}

/// What the list of fingers of a shape means.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum FingerList {
    /// The fingers that act (`specialfingers`).
    Special,
    /// The digits that the bend leaves alone (`exempteddigits`).
    Exempted,
    /// Both.
    SpecialAndExempted,
}

/// A finger of a shape's list.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct ListedFinger {
    /// The finger; never the thumb.
    pub finger: Digit,
    /// The thumb is opposed to it (`opposedfinger`).
    pub opposed: bool,
}

/// A class of hand shapes with thumb and bend.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct BentClass {
    /// The class.
    pub class: ShapeClass,
    /// The thumb's modifier; with a C it says how open it is (`across` tight, `open` slack).
    pub thumb: Option<Thumb>,
    /// The bend of the fingers.
    pub bend: Option<Bend>,
}

/// HamNoSys's twelve classes.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ShapeClass {
    /// `hamfist`
    Fist,
    /// `hamflathand`
    Flat,
    /// `hamfinger2`
    Finger2,
    /// `hamfinger23`
    Finger23,
    /// `hamfinger23spread`
    Finger23Spread,
    /// `hamfinger2345`
    Finger2345,
    /// `hampinch12`
    Pinch12,
    /// `hampinchall`
    PinchAll,
    /// `hampinch12open`
    Pinch12Open,
    /// `hamcee12`
    Cee12,
    /// `hamceeall`
    CeeAll,
    /// `hamceeopen`, `hamcee12open`
    Cee12Open,
}

impl ShapeClass {
    /// All of them.
    pub const ALL: [ShapeClass; 12] = {
        use ShapeClass::*;
        [
            Fist,
            Flat,
            Finger2,
            Finger23,
            Finger23Spread,
            Finger2345,
            Pinch12,
            PinchAll,
            Pinch12Open,
            Cee12,
            CeeAll,
            Cee12Open,
        ]
    };
}

/// Modifiers of the thumb.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Thumb {
    /// `hamthumboutmod`
    Out,
    /// `hamthumbacrossmod`
    Across,
    /// `hamthumbopenmod` (`opposed`)
    Open,
}

/// Bends of fingers.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Bend {
    /// `hamfingerstraightmod`: straight fingers bent at the knuckles (`bent`).
    Bent,
    /// `hamfingerbendmod` (`round`).
    Round,
    /// `hamfingerhookmod` (`hooked`).
    Hooked,
    /// `hamdoublebent` (`dblbent`).
    DoubleBent,
    /// `hamdoublehooked` (`dblhooked`).
    DoubleHooked,
    /// Gestural SiGML alone: `halfbent`.
    HalfBent,
    /// Gestural SiGML alone: knuckle, middle and last joint in quarters of their range, `410`.
    Quarters([u8; 3]),
}

/// What the thumb does beyond its position.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum ThumbSpecial {
    /// `hambetween` finger finger (`thumbbetween`): it comes out between them.
    Between(Digit, Digit),
    /// `hambetween` alone (`thumbenclosed`): the fingers enclose it.
    Enclosed,
    /// `hamthumb` (`exempteddigits="1"`): the bend leaves it alone.
    Exempted,
    /// A finger part (`thumbcontact`): where on the finger the thumb touches.
    At(FingerPart),
}

/// The fingers change one after the other.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Successive {
    /// `hamreplace hamincreasing` (`towards_pinky`).
    TowardPinky,
    /// `hamreplace hamdecreasing` (`towards_thumb`).
    TowardThumb,
}

/// Parts of a digit.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum FingerPart {
    /// `hamfingertip`
    Tip,
    /// `hamfingernail`
    Nail,
    /// `hamfingerpad`
    Pad,
    /// `hamfingermidjoint`
    MidJoint,
    /// `hamfingerbase`
    Base,
    /// `hamfingerside`
    Side,
}

/// Where the (stretched) fingers point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Fingers {
    /// The direction.
    pub direction: Direction,
    /// Halfway to another.
    pub between: Option<Direction>,
    /// `hamorirelative`: relative to the movement (`rel_extfidir`).
    pub relative: bool,
}

/// Where the palm faces.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Palm {
    /// The palm symbol.
    pub facing: Facing,
    /// Halfway to another.
    pub between: Option<Facing>,
    /// `hamorirelative` (`rel_palmor`).
    pub relative: bool,
    /// `hametc` (`approx_palmor`).
    pub approximate: bool,
}

/// One value of a palm.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Facing {
    /// A roll about the finger direction: what the eight symbols say.
    Roll(Roll),
    /// A direction of space (`abs_palmor`, and values of `palmor` that are none of the eight).
    Toward(Direction),
}

// Locations ---------------------------------------------------------------------------------------------------------

/// Where the hands are (`location2`).
#[derive(Debug, Clone, PartialEq)]
pub enum Location {
    /// The place of the hand, or of both.
    One(Site),
    /// A place each, strong and weak; where one is not said, that hand's is open.
    Split(Option<Site>, Option<Site>),
    /// The hands are at each other.
    Constellation(Constellation),
}

/// Two hands at each other (`handconstellation`).
#[derive(Debug, Clone, PartialEq)]
pub struct Constellation {
    /// The parts of the hands, where they are said: first what is touched, a part of the weak hand, then what touches it, a part of the
    /// strong one. Places are said like that everywhere, the place before the part of the hand that is there; brackets of places of
    /// their own ([`Location::Split`]) name the strong hand first.
    pub points: Option<(HandLevels, HandLevels)>,
    /// How they meet; with points and none said, they are beside each other.
    pub contact: Option<Contact>,
    /// Where both are.
    pub at: Option<Site>,
}

/// A place with how near the hand is (`location1`).
#[derive(Debug, Clone, PartialEq)]
pub enum Site {
    /// On or before the body or the other arm; `level` is `None` in neutral space (`hamneutralspace`).
    Body {
        /// The place.
        level: Option<BodyLevels>,
        /// `hambehind`
        behind: bool,
        /// How near.
        contact: Option<Contact>,
        /// The part of the acting hand that is there.
        with: Option<HandLevels>,
    },
    /// On the other hand.
    Hand {
        /// The place.
        level: HandLevels,
        /// How near.
        contact: Option<Contact>,
        /// The part of the acting hand that is there.
        with: Option<HandLevels>,
    },
    /// A place that was named before (`hamcorefref`; `use_locname`).
    Named(String),
}

/// How near or in what way.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Contact {
    /// `hamtouch`
    Touch,
    /// `hamclose`
    Close,
    /// `haminterlock`
    Interlock,
    /// `hamcross`
    Cross,
    /// `hamarmextended`
    ArmExtended,
}

/// A place of the body or arm, or halfway between two.
#[derive(Debug, Clone, PartialEq)]
pub struct BodyLevels {
    /// The place.
    pub first: BodyLevel,
    /// Halfway to another.
    pub between: Option<BodyLevel>,
}

/// A place of the body or arm.
#[derive(Debug, Clone, PartialEq)]
pub struct BodyLevel {
    /// The tag of the symbol without `ham`: `shoulders`, `lowerarm`.
    pub place: String,
    /// `hametc` (`approx_location`).
    pub approximate: bool,
    /// To which side.
    pub side: Option<Side>,
    /// For the arm: on which face.
    pub face: Option<Face>,
}

/// The sides of a place. Left and right are the signer's; symbols write the left side before the place.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Side {
    /// `hamlrbeside` before the place.
    LeftBeside,
    /// `hamlrat` before the place.
    LeftAt,
    /// `hamlrat` after the place.
    RightAt,
    /// `hamlrbeside` after the place.
    RightBeside,
}

/// Faces of hand and arm (`hampalm`, `hamhandback` after the place; gestural SiGML's `side`).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Face {
    /// The side of the back of the hand.
    Dorsal,
    /// The side of the palm.
    Palmar,
}

/// A part of a hand, or halfway between two.
#[derive(Debug, Clone, PartialEq)]
pub struct HandLevels {
    /// The part.
    pub first: HandLevel,
    /// Halfway to another.
    pub between: Option<HandLevel>,
}

/// A part of a hand.
#[derive(Debug, Clone, PartialEq)]
pub struct HandLevel {
    /// What part.
    pub part: HandPlace,
    /// `hametc` (`approx_location`).
    pub approximate: bool,
    /// To which side.
    pub side: Option<Side>,
    /// On which face.
    pub face: Option<Face>,
}

/// What part of a hand.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum HandPlace {
    /// A part of the whole hand or arm, by its tag without `ham`: `palm`, `handback`, `thumbball`, `thumbside`, `pinkyside`,
    /// `wristback`, `wristpulse`, `lowerarm`, `elbow`, ...
    Hand(String),
    /// A part of digits, in the order written; without digits, those of the hand shape; without a part, the whole digits.
    Digits(Vec<Digit>, Option<FingerPart>),
}

// Actions -----------------------------------------------------------------------------------------------------------

/// What is done.
#[derive(Debug, Clone, PartialEq)]
pub enum Action {
    /// One movement.
    Move(Box<Move>),
    /// An action that ends at a place (`tgt_motion`). A target without a movement of its own wraps `Motion::Nothing`.
    Target(Box<Action>, Box<Location>),
    /// At the same time (`hamparbegin`, `par_motion`).
    Together(Vec<Action>),
    /// One after the other (`hamseqbegin`, `seq_motion`).
    Sequence(Vec<Action>),
    /// Blended into one (`hamfusionbegin`, `fused`).
    Fused(Vec<Action>),
    /// One for the strong hand and one for the weak (`hamplus`, `split_motion`); `None` is `hamnomotion`.
    Split(Option<Box<Action>>, Option<Box<Action>>),
    /// More than once (`rpt_motion`).
    Repeated(Box<Action>, Repetition),
    /// With the hands taking turns (`hamalternatingmotion`, `alternating`); twice where it is written twice.
    Alternating(Box<Action>, Times),
    /// A part of the body does it (`hamseqbegin bodypart action hamseqend`, `nonman_motion`).
    OfBody(BodyLevel, Box<Action>),
}

/// Written once or twice.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Times {
    /// Once.
    Once,
    /// Twice.
    Twice,
}

/// One movement with what may be said of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Move {
    /// What is done.
    pub motion: Motion,
    /// `hamfast`
    pub fast: bool,
    /// `hamslow`
    pub slow: bool,
    /// `hamtense`
    pub tense: bool,
    /// `hamrest`
    pub rest: bool,
    /// `hamhalt`
    pub halt: bool,
    /// `bouncing` (gestural SiGML alone).
    pub bouncing: bool,
    /// `speed`, a factor (gestural SiGML alone).
    pub speed: Option<f64>,
    /// The place brushed (`hamseqbegin hambrushing place hamseqend`).
    pub brushing: Option<Site>,
    /// The name that the place reached gets (`hamcoreftag`; `def_locname`).
    pub names: Option<String>,
    /// Where it was written.
    pub span: Ignored,
}

impl Move {
    /// A motion of which nothing more is said.
    pub fn of(motion: Motion) -> Move {
        Move {
            motion,
            fast: false,
            slow: false,
            tense: false,
            rest: false,
            halt: false,
            bouncing: false,
            speed: None,
            brushing: None,
            names: None,
            span: Ignored::default(),
        }
    }
}

/// What a hand does.
#[derive(Debug, Clone, PartialEq)]
pub enum Motion {
    /// `hamnomotion`
    Nothing,
    /// A straight or bent path.
    Straight(Straight),
    /// A circle.
    Circle(Circle),
    /// Nodding, swinging, twisting, stirring.
    Wrist(WristMotion, Size),
    /// `hamfingerplay`, of these digits where they are said.
    FingerPlay(Vec<Digit>),
    /// `hamreplace`: the posture changes to this one (`changeposture`).
    Replace(Posture),
    /// The obsolete `hammovecross` and `hammoveX`: the arms cross.
    Cross,
}

/// A straight or bent path (`directedmotion`).
#[derive(Debug, Clone, PartialEq)]
pub struct Straight {
    /// The direction of its chord.
    pub direction: Direction,
    /// How far.
    pub size: Size,
    /// Halfway to another direction.
    pub between: Option<Direction>,
    /// The bend: to which side as drawn (a roll about the direction, as a palm's), and how much.
    pub arc: Option<(Roll, Size)>,
    /// Waves.
    pub waves: Option<Waves>,
    /// `hamincreasing`, `hamdecreasing`
    pub growth: Option<Growth>,
}

/// Waves along a path.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Waves {
    /// `hamzigzag` or `hamwavy`.
    pub style: WaveStyle,
    /// How large.
    pub size: Size,
    /// In which plane.
    pub plane: Option<Ellipse>,
}

/// Sharp or round waves.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum WaveStyle {
    /// `hamzigzag`
    Zigzag,
    /// `hamwavy`
    Wavy,
}

/// A circle or a part of it (`circularmotion`).
#[derive(Debug, Clone, PartialEq)]
pub struct Circle {
    /// The axis, `hamcircleo`; clockwise for one who looks along it.
    pub axis: Direction,
    /// How large.
    pub size: Size,
    /// Halfway to another axis.
    pub between: Option<Direction>,
    /// Where it starts, eighths of a turn clockwise from the top.
    pub start: Option<Clock>,
    /// Full turns, `hamclockfull` once or twice.
    pub full: Option<Times>,
    /// Where it ends.
    pub end: Option<Clock>,
    /// An ellipse and how flat it is.
    pub ellipse: Option<(Ellipse, Size)>,
    /// Waves.
    pub waves: Option<Waves>,
    /// `hamincreasing`, `hamdecreasing`
    pub growth: Option<Growth>,
}

/// A place of the clock face: eighths of a turn clockwise from the top, 0 to 7 (`hamclocku` is 0, `hamclockur` 1).
pub use crate::phonology::Clock;

/// The long axis of an ellipse as drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Ellipse {
    /// `hamellipseh`
    Horizontal,
    /// `hamellipseur`
    UpRight,
    /// `hamellipsev`
    Vertical,
    /// `hamellipseul`
    UpLeft,
}

/// `hamincreasing` or `hamdecreasing`, with a size where one is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub struct Growth {
    /// Which.
    pub change: Change,
    /// How much.
    pub size: Size,
}

/// Larger or smaller.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Change {
    /// `hamincreasing`
    Increasing,
    /// `hamdecreasing`
    Decreasing,
}

/// How an action repeats.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Repetition {
    /// The symbol.
    pub kind: RepetitionKind,
    /// A second symbol.
    pub second: Option<RepetitionKind>,
    /// `hametc` (`approx_repetition`).
    pub approximate: bool,
    /// Each larger or smaller than the one before.
    pub growth: Option<Growth>,
    /// Moved on from one to the next (`hamseqbegin repetition arrow hamseqend`; `repetition_baseshift`).
    pub shift: Option<Shift>,
}

impl Repetition {
    /// A repetition symbol alone.
    pub fn of(kind: RepetitionKind) -> Repetition {
        Repetition { kind, second: None, approximate: false, growth: None, shift: None }
    }
}

/// How a repeated action moves on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Shift {
    /// Where to.
    pub direction: Direction,
    /// How far (`baseshift_size`).
    pub size: Size,
    /// `baseshift_incrdecr`
    pub growth: Option<Growth>,
}

/// The repetition symbols.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum RepetitionKind {
    /// `hamrepeatfromstart`
    FromStart,
    /// `hamrepeatfromstartseveral`
    FromStartSeveral,
    /// `hamrepeatcontinue`
    Continue,
    /// `hamrepeatcontinueseveral`
    ContinueSeveral,
    /// `hamrepeatreverse`
    Reverse,
    /// Gestural SiGML alone: `tofroto`.
    ToFroTo,
}
