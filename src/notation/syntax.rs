//! What was written in a `.sign` file: lines with their comments, values with their spans.
//!
//! This is the text as a tree and nothing more: names are not looked up, keys are not counted, lengths keep
//! their units. What it means is [`crate::phonology::Sign`]; [`super::lower()`] goes there and [`super::raise()`] back.
//! Words that mean the same in text and meaning (directions, digits, manners) are the phonology's own types.

mod movement;
mod recombination;

use crate::diagnostics::{Span, Spanned};
use crate::phonology::{
    Amount, Channel, Direction, Forced, Hand, HandPoint, Hands, HandshapeChange, Heading, Side, Space,
};

pub use movement::{Action, Becoming, Extent, Motion, Movement, Repeated};
pub use recombination::{Base, Expression, Operator};

/// A whole file, line by line.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct File {
    /// Every line, blank ones included.
    pub lines: Vec<Line>,
}

/// One line.
#[derive(Debug, Clone, PartialEq)]
pub struct Line {
    /// What it says; `None` for blank lines and lines that are a comment only.
    pub content: Option<Content>,
    /// The comment after `#`, without the sign and the spaces around it.
    pub comment: Option<String>,
    /// Where the line stands.
    pub span: Ignored<Span>,
}

/// A value that equality passes over (a place in the text).
#[derive(Debug, Clone, Copy, Default)]
pub struct Ignored<T>(pub T);

impl<T> PartialEq for Ignored<T> {
    fn eq(&self, _: &Self) -> bool {
        true
    }
}

/// What a line says.
#[derive(Debug, Clone, PartialEq)]
pub enum Content {
    /// `language lsf`
    Language(Spanned<String>),
    /// `sign BOL`, `sign FONCÉ = CLAIR inverted`
    Sign(Spanned<String>, Option<Expression>),
    /// A tier.
    Tier(TierLine),
    /// `then`, `then other hand stays`: what follows is a further phase of the sign.
    Then(OtherHand),
    /// A line with a fault.
    Broken(Begins),
}

/// What a hand that does not act in a phase does.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum OtherHand {
    /// What it would do without a phase before it.
    Free,
    /// It stays as the phase before left it: `other hand stays`.
    Stays,
}

/// What a line with a fault was to begin.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Begins {
    /// A sign.
    Sign,
    /// A phase of a sign.
    Phase,
    /// A tier, or what nobody knows.
    Line,
}

/// A tier's line: `strong configuration  flat then fist`.
#[derive(Debug, Clone, PartialEq)]
pub struct TierLine {
    /// The hand, where the line says one.
    pub hand: Option<Hand>,
    /// Where the keyword stands.
    pub keyword: Ignored<Span>,
    /// The values.
    pub value: Value,
}

/// The values of a tier.
#[derive(Debug, Clone, PartialEq)]
pub enum Value {
    /// `meaning en "bowl", fr "bol"`
    Meaning(Vec<(String, String)>),
    /// `source "…"`
    Source(String),
    /// `status unverified`
    Status(String),
    /// `note "…"`
    Note(String),
    /// `hands both mirrored`
    Hands(Hands),
    /// `configuration flat then fist`
    Configuration(Values<Configuration>),
    /// `placement chest, touch`
    Placement(Values<Placement>),
    /// `orientation fingers up, palm left`
    Orientation(Values<Orientation>),
    /// `movement up 10cm then down 10cm`: one movement an interval.
    Movement(Vec<Movement>),
    /// `contact strong palm touches weak back`
    Contact(Values<Contact>),
    /// A non-manual tier.
    NonManual(Channel, Values<NonManual>),
    /// `duration 0.9s`
    Duration(Duration),
    /// `speed 1.5`
    Speed(f64),
    /// `base Y en "snail" then U en "slug"`
    Base(Vec<Attested>),
    /// `at space left, forced`
    At(Relocation),
}

impl Value {
    /// The tier's keyword.
    pub fn keyword(&self) -> &'static str {
        match self {
            Value::Meaning(_) => "meaning",
            Value::Source(_) => "source",
            Value::Status(_) => "status",
            Value::Note(_) => "note",
            Value::Hands(_) => "hands",
            Value::Configuration(_) => "configuration",
            Value::Placement(_) => "placement",
            Value::Orientation(_) => "orientation",
            Value::Movement(_) => "movement",
            Value::Contact(_) => "contact",
            Value::NonManual(channel, _) => channel.name(),
            Value::Duration(_) => "duration",
            Value::Speed(_) => "speed",
            Value::Base(_) => "base",
            Value::At(_) => "at",
        }
    }
}

/// Values joined by `then`.
pub type Values<T> = Vec<Placed<T>>;

/// A value and, where it says so, its key.
#[derive(Debug, Clone, PartialEq)]
pub struct Placed<T> {
    /// The value.
    pub value: T,
    /// The key it stands at.
    pub at: Option<Spanned<Key>>,
    /// Where the value stands.
    pub span: Ignored<Span>,
}

/// Where a value stands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Key {
    /// `at start`
    Start,
    /// `at middle`
    Middle,
    /// `at end`
    End,
    /// `at key 2`: counted from 1, the start.
    Number(usize),
}

/// A handshape as written.
#[derive(Debug, Clone, PartialEq)]
pub struct Configuration {
    /// Its name.
    pub base: Spanned<String>,
    /// `between A and B`: what there is besides the first's name.
    pub between: Option<Box<Between>>,
    /// Changes after commas.
    pub changes: Vec<HandshapeChange>,
}

/// What a handshape lies halfway to, as written: `between ( flat, thumb out ) and ( 5, round )`.
#[derive(Debug, Clone, PartialEq)]
pub struct Between {
    /// Changes in brackets with the first.
    pub first: Vec<HandshapeChange>,
    /// The second one's name.
    pub second: Spanned<String>,
    /// Changes in brackets with the second.
    pub changes: Vec<HandshapeChange>,
}

/// A placement as written.
#[derive(Debug, Clone, PartialEq)]
pub struct Placement {
    /// `behind …`
    pub behind: bool,
    /// The place.
    pub place: Place,
    /// `right`, `beside left`.
    pub side: Option<(Side, bool)>,
    /// `touch`, `3cm away`.
    pub distance: Option<Distance>,
    /// `with index tip`
    pub with: Option<HandPoint>,
    /// `offset up 5cm`
    pub offset: Option<(Direction, Length)>,
}

/// A place as written.
#[derive(Debug, Clone, PartialEq)]
pub enum Place {
    /// A named place.
    Named(Spanned<String>),
    /// `other palm`
    OtherHand(HandPoint),
    /// `space left high near`
    Space(Space),
    /// `point 0.1 1.2 0.4`
    Point([f64; 3]),
    /// `between X and Y`
    Between(Box<Sited>, Box<Sited>),
    /// `referent "A"`
    Referent(String),
    /// `pointing at PLACE`
    Towards(Box<Place>),
}

/// One of the two places that a placement lies between, as written: `beside right ear`.
#[derive(Debug, Clone, PartialEq)]
pub struct Sited {
    /// The place.
    pub place: Place,
    /// `right`, `beside right`.
    pub side: Option<(Side, bool)>,
}

/// A configuration attested on a base, as written: `Y en "snail", fr "escargot"`.
#[derive(Debug, Clone, PartialEq)]
pub struct Attested {
    /// The configuration.
    pub configuration: Configuration,
    /// What the sign means with it.
    pub meaning: Vec<(String, String)>,
}

/// Where a sign is moved to, as written.
#[derive(Debug, Clone, PartialEq)]
pub struct Relocation {
    /// The place.
    pub place: Place,
    /// `forced`
    pub forced: Forced,
}

/// A distance as written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Distance {
    /// `touch`
    Touch,
    /// `close`
    Close,
    /// `neutral distance`
    Neutral,
    /// `extended`
    Extended,
    /// `3cm away`
    Length(Length),
}

/// An orientation as written.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Orientation {
    /// `fingers up`
    pub fingers: Option<Spanned<Heading>>,
    /// `palm left`
    pub palm: Option<Spanned<Heading>>,
    /// `along path`
    pub along_path: bool,
}

/// A length with the unit it was written in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Length {
    /// The number.
    pub number: f64,
    /// The unit.
    pub unit: LengthUnit,
}

/// Units of length.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum LengthUnit {
    /// Millimetres.
    Mm,
    /// Centimetres.
    Cm,
    /// Metres.
    M,
}

impl LengthUnit {
    /// All of them.
    pub const ALL: [LengthUnit; 3] = [LengthUnit::Mm, LengthUnit::Cm, LengthUnit::M];

    /// The letters after the number.
    pub fn name(self) -> &'static str {
        match self {
            LengthUnit::Mm => "mm",
            LengthUnit::Cm => "cm",
            LengthUnit::M => "m",
        }
    }
}

impl Length {
    /// In metres.
    ///
    /// ```
    /// use chereme::notation::syntax::{Length, LengthUnit};
    /// assert_eq!(Length { number: 15.0, unit: LengthUnit::Cm }.metres(), 0.15);
    /// ```
    pub fn metres(self) -> f64 {
        match self.unit {
            LengthUnit::Mm => self.number / 1000.0,
            LengthUnit::Cm => self.number / 100.0,
            LengthUnit::M => self.number,
        }
    }

    /// The length that reads back as exactly these metres: in centimetres where they have at most two decimals.
    ///
    /// ```
    /// use chereme::notation::syntax::Length;
    /// assert_eq!(Length::from_metres(0.15).to_string(), "15cm");
    /// ```
    pub fn from_metres(metres: f64) -> Length {
        let number = (metres * 10_000.0).round() / 100.0;
        let centimetres = Length { number, unit: LengthUnit::Cm };
        if centimetres.metres() == metres { centimetres } else { Length { number: metres, unit: LengthUnit::M } }
    }
}

/// A duration with the unit it was written in.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Duration {
    /// The number.
    pub number: f64,
    /// Whether it is milliseconds rather than seconds.
    pub milliseconds: bool,
}

impl Duration {
    /// In seconds.
    pub fn seconds(self) -> f64 {
        if self.milliseconds { self.number / 1000.0 } else { self.number }
    }
}

/// A contact of the two hands as written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Contact {
    /// `strong index tip`; `strong hand` names none.
    pub strong: Option<HandPoint>,
    /// `touches`, …
    pub kind: ContactKind,
    /// `weak palm`
    pub weak: Option<HandPoint>,
}

/// The way hands meet, as written.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum ContactKind {
    /// `touches`
    Touches,
    /// `close to`
    CloseTo,
    /// `crosses`
    Crosses,
    /// `interlocks`
    Interlocks,
    /// `3cm from`
    LengthFrom(Length),
}

/// A non-manual value as written.
#[derive(Debug, Clone, PartialEq)]
pub struct NonManual {
    /// What.
    pub what: NonManualWhat,
    /// `slight`, `strong`, `60%`.
    pub amount: Amount,
    /// `speed 1.5`
    pub pace: Option<f64>,
}

/// What a non-manual value says.
#[derive(Debug, Clone, PartialEq)]
pub enum NonManualWhat {
    /// A name of the inventory.
    Named(Spanned<String>),
    /// `towards up-left`
    Towards(Heading),
    /// `at other palm`
    At(Box<Placement>),
    /// `mouthing "bOl"`
    Mouthing(String),
    /// `( puffed then blowing )`
    Sequence(Vec<NonManual>),
    /// `( nod while tilted-left )`
    Together(Vec<NonManual>),
}
