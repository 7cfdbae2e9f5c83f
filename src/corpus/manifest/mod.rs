//! `corpus.yaml`: which recordings a corpus has, whose skeletons they move, and what their annotations mean.
//!
//! A person writes it, or `chereme corpus init` proposes it. It names files beside it and never holds motion itself.
//!
//! # Conventions
//! - Paths are relative to the manifest's folder (those of a table's rows, to the table's). `..` and absolute paths are
//!   allowed, because recordings often lie beside a corpus; `check` tells of them, because such a corpus cannot be moved.
//! - Times are seconds. `offset` is the motion's instant at which an annotation's time begins; `span` counts from the
//!   motion's start, its skipped frames included.
//! - What `defaults` says holds for every recording that does not say otherwise.
//!
//! # What is refused
//! Fields that are not known, values of another kind, names used twice, versions other than 1: each with its place, all
//! at once.

mod fields;
mod read;
mod takes;
mod write;
pub mod yaml;

pub use read::read;
pub(in crate::corpus) use takes::Rows;
pub use takes::{Listing, Take, listing};

use crate::body::retarget::{Mode, SignedAxis};
use crate::corpus::segment::Component;
use crate::diagnostics::Spanned;
use crate::phonology::Side;

/// The name that a manifest has in a corpus's folder.
pub const FILE_NAME: &str = "corpus.yaml";

/// The version of the manifest's form that is read and written.
pub const VERSION: u32 = 1;

/// What `corpus.yaml` says.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Manifest {
    /// What the corpus is called.
    pub title: String,
    /// The sign language, as the folders of a lexicon name it (`lsf`).
    pub language: Option<Spanned<String>>,
    /// Under which licence its recordings may be used, where nothing else is said of them.
    pub licence: Option<Spanned<String>>,
    /// Whom to name, where nothing else is said.
    pub credit: Option<Spanned<String>>,
    /// What holds for all recordings that do not say otherwise.
    pub defaults: Details,
    /// The rigs of the recordings, by name.
    pub skeletons: Vec<Rig>,
    /// Which of our tiers others' tiers are: the first rule that fits counts.
    pub tiers: Vec<TierRule>,
    /// What others' labels mean.
    pub values: Vec<ValueRule>,
    /// Recordings, one by one.
    pub recordings: Vec<Recording>,
    /// Recordings that a table lists.
    pub takes: Vec<Table>,
}

/// What is said of a recording, or of all of them.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Details {
    /// The name of its skeleton. Where none is named, it is the one whose joints the file has; else joints are known by
    /// their names.
    pub skeleton: Option<Spanned<String>>,
    /// Who signs.
    pub signer: Option<Spanned<String>>,
    /// The signer's strong hand; right where nothing is said.
    pub dominant: Option<Spanned<Side>>,
    /// The hands that the recording shows; what its skeleton has, where nothing is said.
    pub hand: Option<Spanned<Hands>>,
    /// Under which licence it may be used.
    pub licence: Option<Spanned<String>>,
    /// Whom to name.
    pub credit: Option<Spanned<String>>,
    /// The motion's instant at which its annotations begin, seconds; 0 where nothing is said.
    pub offset: Option<Spanned<f64>>,
}

/// The hands of a recording.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Hands {
    /// One hand.
    One(Side),
    /// Both.
    Both,
}

impl Hands {
    /// All three.
    pub const ALL: [Hands; 3] = [Hands::One(Side::Right), Hands::One(Side::Left), Hands::Both];

    /// The word in the manifest.
    pub fn word(self) -> &'static str {
        match self {
            Hands::One(side) => side_word(side),
            Hands::Both => "both",
        }
    }

    /// Whether a hand is among them.
    pub fn has(self, side: Side) -> bool {
        self == Hands::Both || self == Hands::One(side)
    }
}

/// The word of a side in the manifest.
pub fn side_word(side: Side) -> &'static str {
    match side {
        Side::Left => "left",
        Side::Right => "right",
    }
}

/// The word of a mode in the manifest.
pub fn mode_word(mode: Mode) -> &'static str {
    match mode {
        Mode::Directions => "directions",
        Mode::Contacts => "contacts",
    }
}

/// A skeleton that recordings move, and what its files do not say about themselves.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Rig {
    /// The name that recordings use.
    pub name: Spanned<String>,
    /// Metres in one unit of the files; proposed from the size of the body, where nothing is said.
    pub unit: Option<Spanned<Unit>>,
    /// The axis that points up in the files' space; proposed where nothing is said.
    pub up: Option<Spanned<SignedAxis>>,
    /// The axis that points to the signer's front; proposed where nothing is said.
    pub front: Option<Spanned<SignedAxis>>,
    /// Frames at the start that are no motion, such as an inserted T-pose.
    pub skip_frames: Spanned<u32>,
    /// How its motion is taken over.
    pub mode: Spanned<Mode>,
    /// Our joint to theirs; joints are known by their names, where nothing is said.
    pub joints: Vec<(Spanned<String>, Spanned<String>)>,
}

/// Metres in one unit of a file.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Unit(pub f64);

impl Unit {
    /// The units that have names; `cmu` is Carnegie Mellon's inch times 0.45.
    pub const NAMED: [(&'static str, f64); 5] =
        [("m", 1.0), ("cm", 0.01), ("mm", 0.001), ("inch", 0.0254), ("cmu", 0.0254 / 0.45)];

    /// The unit of a name.
    pub fn named(name: &str) -> Option<Unit> {
        Unit::NAMED.iter().find(|(known, _)| *known == name).map(|(_, metres)| Unit(*metres))
    }

    /// Its name, where it has one.
    pub fn name(self) -> Option<&'static str> {
        Unit::NAMED.iter().find(|(_, metres)| *metres == self.0).map(|(name, _)| *name)
    }
}

/// Others' tier and ours.
#[derive(Debug, Clone, PartialEq)]
pub struct TierRule {
    /// Their tier's name; `*` stands for any letters, and case does not matter.
    pub theirs: Spanned<String>,
    /// Our tier's name, such as `RH Gloss`.
    pub ours: Spanned<String>,
}

impl TierRule {
    /// Whether a tier's name fits.
    ///
    /// ```
    /// use chereme::{corpus::manifest::TierRule, diagnostics::{Span, Spanned}};
    /// let of = |text: &str| Spanned::new(text.to_owned(), Span::default());
    /// let rule = TierRule { theirs: of("gloss*right"), ours: of("RH Gloss") };
    /// assert!(rule.fits("Gloss_Right") && !rule.fits("Gloss left"));
    /// ```
    pub fn fits(&self, name: &str) -> bool {
        fits(&self.theirs.value.to_lowercase(), &name.to_lowercase())
    }
}

/// Whether a pattern with `*` fits a whole text: its pieces are found one after the other, each as early as can be.
fn fits(pattern: &str, text: &str) -> bool {
    let mut pieces = pattern.split('*');
    let first = pieces.next().unwrap_or_default();
    let Some(mut rest) = text.strip_prefix(first) else { return false };
    let Some(last) = pieces.next_back() else { return rest.is_empty() };
    for piece in pieces {
        match rest.find(piece) {
            Some(at) => rest = &rest[at + piece.len()..],
            None => return false,
        }
    }
    rest.ends_with(last)
}

/// Others' label and ours, of a component.
#[derive(Debug, Clone, PartialEq)]
pub struct ValueRule {
    /// The component.
    pub component: Component,
    /// Their label.
    pub theirs: Spanned<String>,
    /// Ours, such as `round-B`.
    pub ours: Spanned<String>,
}

/// A recording.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Recording {
    /// Its name, which no other has.
    pub name: Spanned<String>,
    /// Its motion's file.
    pub motion: Spanned<String>,
    /// Files of its annotations.
    pub annotations: Vec<Spanned<String>>,
    /// Its gloss, where it is one sign from start to end.
    pub gloss: Option<Spanned<String>>,
    /// What of the motion to use, seconds.
    pub span: Option<Spanned<[f64; 2]>>,
    /// What it says otherwise than the defaults.
    pub details: Details,
}

/// A table that lists recordings, a row each.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Table {
    /// The table's file: tab-separated, or CSV.
    pub table: Spanned<String>,
    /// A recording's field and the heading of the column that has it.
    pub columns: Vec<(Spanned<Field>, Spanned<String>)>,
    /// What holds for all rows.
    pub details: Details,
}

/// A field of a recording that a column can give.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash, Default)]
pub enum Field {
    /// Its motion's file.
    #[default]
    Motion,
    /// Its name; the motion's path without extension, where no column gives it.
    Name,
    /// Its gloss.
    Gloss,
    /// A file of its annotations; several are separated by `;`.
    Annotations,
    /// When to begin, seconds.
    Start,
    /// When to end, seconds.
    End,
    /// See [`Details::offset`].
    Offset,
    /// See [`Details::hand`].
    Hand,
    /// See [`Details::signer`].
    Signer,
    /// See [`Details::dominant`].
    Dominant,
    /// See [`Details::skeleton`].
    Skeleton,
    /// See [`Details::licence`].
    Licence,
    /// See [`Details::credit`].
    Credit,
}

impl Field {
    /// All of them.
    pub const ALL: [Field; 13] = [
        Field::Motion,
        Field::Name,
        Field::Gloss,
        Field::Annotations,
        Field::Start,
        Field::End,
        Field::Offset,
        Field::Hand,
        Field::Signer,
        Field::Dominant,
        Field::Skeleton,
        Field::Licence,
        Field::Credit,
    ];

    /// The word in the manifest.
    pub fn word(self) -> &'static str {
        match self {
            Field::Motion => "motion",
            Field::Name => "name",
            Field::Gloss => "gloss",
            Field::Annotations => "annotations",
            Field::Start => "start",
            Field::End => "end",
            Field::Offset => "offset",
            Field::Hand => "hand",
            Field::Signer => "signer",
            Field::Dominant => "dominant",
            Field::Skeleton => "skeleton",
            Field::Licence => "licence",
            Field::Credit => "credit",
        }
    }
}

/// The tiers that others' tiers can be: each hand's, and those of face and body.
///
/// ```
/// assert!(chereme::corpus::manifest::our_tiers().any(|name| name == "RH Configuration"));
/// ```
pub fn our_tiers() -> impl Iterator<Item = String> {
    let manual = ["Gloss", "Phase", "Configuration", "Placement", "Orientation", "Movement"];
    let hands = ["RH", "LH"].into_iter().flat_map(move |hand| manual.map(|tier| format!("{hand} {tier}")));
    hands.chain(["Contact", "Head", "Torso", "Gaze", "Brows", "Mouth"].map(str::to_owned))
}
