//! Does annotating a synthesized sign give its description back? Each component of each key held against what was measured there.
//!
//! A sign is synthesized and its clip annotated ([`crate::corpus::annotate`]), without a word of times or keys; what the annotation
//! says at the instant of each key is compared with what the description says.
//!
//! # What is right
//! * *Configuration*: the shape's form is the same as the described one's (no digit's end 4 mm apart), or it is the same as the
//!   inventory's nearest shape to what the description changes or mixes, or as near (within 1 mm of the mean distance).
//! * *Placement*: strictly, the same place on the same side, and the distance one step off at most (touch, close, at ease, extended), or a
//!   name of the same point within 1.5 cm; a description with numbers (`chest, 24cm away, offset up 3cm`) is first given the nearest name.
//!   Where hands meet, the place of both and that on the other hand are both measured, and either may be the described one. Loosely, the
//!   measured place lies within 5 cm, or half of half the region's width, of the described one.
//! * *Orientation*: strictly, fingers and palm are each the described one of the 26 directions; loosely, each within 27.5° (half a
//!   cell and a tolerance of 5°). The palm is meant across the fingers.
//! * *Movement*: strictly, each described movement of the interval was measured in order, of its kind, its direction (that of the
//!   path, of the chord, of the axis; or of the way between the described places) within 45°; a hold or a change of posture where no way was
//!   measured. Loosely, its kind. Sizes do not count.
//! * *Repetition*: as many performances.
//! * *Phase*: in the middle of each stroke and each transition of the track, the same was measured; loosely, a hand that does
//!   nothing in a stroke may hold. A phase that the track does not have counts nowhere.

mod aggregate;
mod expected;
mod key;
mod motion;
mod place;
mod six;

use crate::body::signer::Signer;
use crate::corpus::annotate::{Annotation, Annotator};
use crate::phonology::Sign;
use crate::synthesis::verify::{Finding, verify};
use crate::synthesis::{Grammar, Performance};
pub use aggregate::{Confusion, Share, Tally};
pub use six::{SIX_PLACES, choose, six_places};

/// What is judged.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub enum Judged {
    /// The hand's shape.
    Configuration,
    /// Where it is.
    Placement,
    /// Where the fingers look.
    Fingers,
    /// Where the palm looks.
    Palm,
    /// Both of them.
    Orientation,
    /// What the hand does.
    Movement,
    /// How often it does so.
    Repetition,
    /// Stroke or transition, in the middle of each.
    Phase,
}

impl Judged {
    /// All, in the order of a table.
    pub const ALL: [Judged; 8] = [
        Judged::Configuration,
        Judged::Placement,
        Judged::Orientation,
        Judged::Fingers,
        Judged::Palm,
        Judged::Movement,
        Judged::Repetition,
        Judged::Phase,
    ];

    /// In a word.
    pub fn name(self) -> &'static str {
        match self {
            Judged::Configuration => "configuration",
            Judged::Placement => "placement",
            Judged::Fingers => "fingers",
            Judged::Palm => "palm",
            Judged::Orientation => "orientation",
            Judged::Movement => "movement",
            Judged::Repetition => "repetition",
            Judged::Phase => "phase",
        }
    }
}

/// One value of a description held against what was measured.
#[derive(Debug, Clone, PartialEq)]
pub struct Judgement {
    /// The component.
    pub judged: Judged,
    /// What the description says, in the words of a tier.
    pub described: String,
    /// What was measured there; `nothing` where nothing was.
    pub measured: String,
    /// Right in the strict sense.
    pub strict: bool,
    /// Right in the loose sense; whatever is strictly right is so too.
    pub loose: bool,
    /// The synthesis itself reports at this key that it could not do what was said: out of reach, beyond the wrist's limits, or a
    /// finding of its check.
    pub excepted: bool,
}

/// Holds an annotation of a sign's motion against its description.
///
/// ```
/// use chereme::corpus::annotate::{self, Annotator, Coverage};
/// use chereme::evaluation::annotation::{Judged, judge};
/// use chereme::notation::Lexicon;
/// use chereme::synthesis::{Grammar, Options, synthesize};
/// let (grammar, signer) = (Grammar::builtin(), chereme::avatar::signer().unwrap());
/// let sign = &Lexicon::builtin().find("BOL", Some("lsf")).unwrap().sign.clone();
/// let performance = synthesize(sign, &grammar, &signer, &Options::default()).unwrap();
/// let annotator = Annotator::new(&signer, &grammar.handshapes, &grammar.locations);
/// let annotation = annotator.annotate(&performance.track.clip, Coverage::WHOLE, &annotate::Options::default());
/// let judgements = judge(sign, &performance, &annotation, &annotator, &grammar, &signer);
/// let shapes = || judgements.iter().filter(|j| j.judged == Judged::Configuration);
/// assert!(shapes().count() >= 2 && shapes().all(|j| j.strict));
/// ```
pub fn judge(
    sign: &Sign,
    performance: &Performance,
    annotation: &Annotation,
    annotator: &Annotator,
    grammar: &Grammar,
    signer: &Signer,
) -> Vec<Judgement> {
    let findings = verify(sign, performance, grammar, signer);
    let judge = Judge { sign, performance, annotation, annotator, grammar, signer, findings };
    judge.all()
}

/// What judging needs.
struct Judge<'a> {
    sign: &'a Sign,
    performance: &'a Performance,
    annotation: &'a Annotation,
    annotator: &'a Annotator<'a>,
    grammar: &'a Grammar,
    signer: &'a Signer,
    findings: Vec<Finding>,
}
