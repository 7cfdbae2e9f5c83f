//! Automatic annotation: the motion of a clip on our rig, measured into phonological tiers.
//!
//! Each hand is measured for itself: its phases (`phases`); at its stops the handshape (`configuration`), the place (`placement`) and
//! where fingers and palm look (`orientation`); between them what it does (`movement`). A synthesized sign that is annotated gives its
//! description back; how far is measured by `evaluation::annotation`.
//!
//! # Conventions
//! Times from the clip's start. Values have the words of the tiers of a synthesized track ([`crate::phonology::label`]), so that both
//! compare; the source of each says how far the motion is off the value (`measured: 0.12`), in the unit of its component: configuration
//! and placement in metres, orientation in radians, movement in the mean distance of its path from the shape, metres.
//! A hand at rest has no values. Nothing is read but the motion.

mod annotation;
mod configuration;
mod contact;
mod movement;
mod moves;
mod orientation;
mod phases;
mod placement;
mod placer;
mod play;
mod repetition;
mod shape;
mod signals;

use crate::body::measure::{HandForm, HandForms};
use crate::body::retarget;
use crate::body::signer::Signer;
use crate::motion::clip::Clip;
use crate::motion::pose::ModelPose;
use crate::phonology::Side;
use crate::phonology::handshape::HandshapeInventory;
use crate::phonology::location::LocationInventory;
use crate::time::Seconds;
pub use annotation::{Annotation, HandAnnotation, Phase, Placed, Shape, Value};
pub use placer::{Meeting, Placer};
use signals::Signals;

/// How much of a limb a recording has.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Limb {
    /// Nothing: no tiers.
    None,
    /// The hand without an arm: no places and no paths, and no rest; where it looks is as the recording has it.
    Hand,
    /// Arm and hand.
    #[default]
    Arm,
}

/// What a recording has of the body.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub struct Coverage {
    /// The left limb.
    pub left: Limb,
    /// The right limb.
    pub right: Limb,
}

impl Coverage {
    /// Both arms and hands.
    pub const WHOLE: Coverage = Coverage { left: Limb::Arm, right: Limb::Arm };

    /// The limb of a side.
    pub fn of(self, side: Side) -> Limb {
        match side {
            Side::Left => self.left,
            Side::Right => self.right,
        }
    }
}

impl From<retarget::Coverage> for Coverage {
    /// What annotation may look at of a recording.
    fn from(covers: retarget::Coverage) -> Coverage {
        let limb = |side: Side| match (covers.arms[side as usize], covers.hands[side as usize]) {
            (true, _) => Limb::Arm,
            (false, true) => Limb::Hand,
            (false, false) => Limb::None,
        };
        Coverage { left: limb(Side::Left), right: limb(Side::Right) }
    }
}

/// Knobs of annotation.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Options {
    /// How far the smoothing window reaches to each side.
    pub smoothing: Seconds,
    /// A hand that does less is still, metres a second (its way, a tenth of a metre's turning and its forming together).
    pub still: f64,
    /// A hand moves that does as much at its fastest, metres a second.
    pub least: f64,
    /// Stillness that lasts as long is a hold.
    pub hold: Seconds,
}

impl Default for Options {
    fn default() -> Options {
        Options { smoothing: Seconds(0.05), still: 0.06, least: 0.15, hold: Seconds(0.1) }
    }
}

/// Measures clips of one signer's body; what does not depend on a clip is made once.
#[derive(Debug, Clone)]
pub struct Annotator<'a> {
    signer: &'a Signer,
    forms: HandForms,
    placer: Placer<'a>,
}

impl<'a> Annotator<'a> {
    /// An annotator that knows these handshapes and places.
    pub fn new(signer: &'a Signer, handshapes: &HandshapeInventory, locations: &'a LocationInventory) -> Annotator<'a> {
        Annotator { signer, forms: HandForms::new(handshapes, signer), placer: Placer::new(signer, locations) }
    }

    /// The forms of the handshapes that it knows.
    pub fn forms(&self) -> &HandForms {
        &self.forms
    }

    /// What tells places.
    pub fn placer(&self) -> &Placer<'a> {
        &self.placer
    }

    /// Measures a clip whose skeleton is the signer's.
    ///
    /// A clip of another skeleton (other joints) has no annotation.
    ///
    /// ```
    /// use chereme::corpus::annotate::{Annotator, Coverage, Options};
    /// use chereme::notation::Lexicon;
    /// use chereme::synthesis::{self, Grammar};
    /// let (grammar, signer) = (Grammar::builtin(), chereme::avatar::signer().unwrap());
    /// let sign = &Lexicon::builtin().find("OUI", Some("lsf")).unwrap().sign.clone();
    /// let clip = synthesis::synthesize(sign, &grammar, &signer, &synthesis::Options::default()).unwrap().track.clip;
    /// let annotator = Annotator::new(&signer, &grammar.handshapes, &grammar.locations);
    /// let tiers = annotator.annotate(&clip, Coverage::WHOLE, &Options::default()).tiers();
    /// assert_eq!(tiers[0].name, "RH Phase");
    /// assert_eq!(tiers[0].values()[0].label, "preparation");
    /// ```
    pub fn annotate(&self, clip: &Clip, coverage: Coverage, options: &Options) -> Annotation {
        if clip.skeleton().len() != self.signer.skeleton.len() {
            return Annotation::default();
        }
        let models: Vec<ModelPose> = clip.frames().iter().map(|f| f.pose.to_model(clip.skeleton())).collect();
        let mut annotation = Annotation::default();
        let sides = [Side::Right, Side::Left].into_iter().filter(|side| coverage.of(*side) != Limb::None);
        let all: Vec<(Limb, Signals)> = sides
            .map(|side| (coverage.of(side), Signals::new(clip, &models, self.signer, side, coverage.of(side), options)))
            .collect();
        for (n, (limb, signals)) in all.iter().enumerate() {
            // Of two hands the one that goes farther goes to the other.
            let goes = all.get(1 - n.min(1)).is_some_and(|(_, other)| way(signals) >= way(other));
            annotation.hands.push(self.hand(signals, &models, *limb, all.len() == 2 && goes, options));
        }
        if coverage == Coverage::WHOLE {
            annotation.contact = contact::contacts(&annotation);
        }
        annotation
    }

    fn hand(
        &self,
        signals: &Signals,
        models: &[ModelPose],
        limb: Limb,
        goes_to_other: bool,
        options: &Options,
    ) -> HandAnnotation {
        let (phases, signing) = phases::phases(signals, limb, options);
        let mut hand = HandAnnotation {
            side: signals.side,
            phases,
            configuration: Vec::new(),
            placement: Vec::new(),
            orientation: Vec::new(),
            movement: Vec::new(),
            moves: Vec::new(),
        };
        let own = |form: &HandForm| {
            let shape = self.forms.nearest(form)?.shape;
            self.signer.landmarks.hand_point(signals.side, self.forms.shapes()[shape].touches_with).ok()
        };
        for stretch in signing {
            let seen = Seen { signals, models, start: stretch.start, end: stretch.end, goes_to_other };
            let movement = movement::movements(&seen, &own);
            let wiggling: Vec<(Seconds, Seconds)> =
                movement.moves.iter().filter(|m| play::wiggles(&m.value)).map(|m| (m.start, m.end)).collect();
            let shapes = configuration::configurations(&seen, &self.forms, &wiggling);
            if limb == Limb::Arm {
                hand.placement.extend(placement::placements(&seen, &shapes, &self.forms, &self.placer));
            }
            hand.configuration.extend(shapes);
            hand.orientation.extend(orientation::orientations(&seen));
            hand.movement.extend(movement.joined);
            hand.moves.extend(movement.moves);
        }
        hand
    }
}

/// A stretch of a hand's signing, with everything that is followed of it.
pub(crate) struct Seen<'s> {
    signals: &'s Signals,
    models: &'s [ModelPose],
    start: usize,
    end: usize,
    /// Whether this hand is the one that goes to the other where they meet.
    goes_to_other: bool,
}

impl Seen<'_> {
    /// The instant of a frame.
    fn time(&self, frame: usize) -> Seconds {
        self.signals.fps.time_of(crate::time::FrameIndex(frame))
    }
}

/// Adds a value, or lets the one before go on where it is the same.
fn push_or_extend<T>(values: &mut Vec<Value<T>>, value: Value<T>, same: impl Fn(&T, &T) -> bool) {
    match values.last_mut() {
        Some(last) if same(&last.value, &value.value) => {
            last.end = value.end;
            last.off = last.off.min(value.off);
        }
        _ => values.push(value),
    }
}

/// How far a hand goes in a clip, metres.
fn way(signals: &Signals) -> f64 {
    signals.path_speed.iter().sum::<f64>() / signals.fps.get()
}
