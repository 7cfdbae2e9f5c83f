//! Interpolations measured on synthesized motion: the rise of a pointing and the first change of shape of DODO.
//!
//! Along one arc in joint space the rate of turning, in mean rates, is the derivative of the easing's weight: 1 for slerp, π/2 for the
//! cosine, 1.875 for minimum jerk, 2.534 for the sigmoid (facts/phonology.md §5).

use chereme::body::signer::Signer;
use chereme::motion::curve::{Measure, Reference, of_clip};
use chereme::motion::easing::Easing;
use chereme::motion::point;
use chereme::motion::rotation::angle_between;
use chereme::notation::Lexicon;
use chereme::notation::{Vocabulary, read};
use chereme::phonology::Sign;
use chereme::synthesis::{Grammar, Options, Performance, synthesize};
use chereme::time::{Fps, Seconds};

/// The laws that are compared; slerp is `linear`.
pub const EASINGS: [Easing; 4] = [Easing::Linear, Easing::Cosine, Easing::Sigmoid { k: 10.0 }, Easing::MinimumJerk];
/// A sign of one posture that points upwards.
pub const POINTING: &str = include_str!("../../tests/suite/profile/pointing-up.sign");

/// One interpolation of one gesture.
#[derive(Debug, Clone)]
pub struct Measured {
    /// What is done, and the point that is followed.
    pub gesture: &'static str,
    /// The law.
    pub easing: Easing,
    /// The point's greatest speed during the stretch, m/s.
    pub peak: f64,
    /// When, as a share of the stretch.
    pub at: f64,
    /// The greatest rate of turning of the joint that leads, in mean rates.
    pub ratio: f64,
}

impl Measured {
    /// The ratio that the law has by its formula.
    pub fn theory(&self) -> f64 {
        self.easing.rate(0.5)
    }
}

/// What is measured of a gesture.
struct Gesture {
    name: &'static str,
    sign: Sign,
    point: &'static str,
    reference: Reference,
    joint: &'static str,
    stretch: fn(&Performance) -> (Seconds, Seconds),
}

/// Both gestures under each law.
///
/// # Panics
/// Where the embedded avatar, inventories and signs do not fit each other.
pub fn measure() -> Vec<Measured> {
    let (grammar, vocabulary) = (Grammar::builtin(), Vocabulary::builtin());
    let signer = chereme::avatar::signer().expect("the embedded avatar");
    let lexicon = Lexicon::builtin();
    let pointing = read(POINTING, &vocabulary, "lsf").signs.remove(0).sign;
    let dodo = lexicon.find("DODO", Some("lsf")).expect("DODO").sign.clone();
    let gestures = [
        Gesture {
            name: "pointing up, wrist",
            sign: pointing,
            point: "RightHand",
            reference: Reference::Floor,
            joint: "RightArm",
            stretch: |p| {
                p.track.phases("RH Phase").first().map_or_else(Default::default, |rise| (rise.start, rise.end))
            },
        },
        Gesture {
            name: "DODO, index tip",
            sign: dodo,
            point: "RightHandIndexTip",
            reference: Reference::Wrist,
            joint: "RightHandIndex2",
            stretch: |p| (p.report.keys[0], p.report.keys[1]),
        },
    ];
    let each = |gesture: &Gesture| EASINGS.map(|easing| of_gesture(gesture, easing, &grammar, &signer));
    gestures.iter().flat_map(each).collect()
}

fn of_gesture(gesture: &Gesture, easing: Easing, grammar: &Grammar, signer: &Signer) -> Measured {
    let fps = Fps::new(240.0).expect("a rate");
    let options = Options { fps, easing, ..Options::default() };
    let performance = synthesize(&gesture.sign, grammar, signer, &options).expect("a sound sign");
    let clip = &performance.track.clip;
    let (start, end) = (gesture.stretch)(&performance);
    let frame = |time: Seconds| (time.0 * fps.get()).round() as usize;
    let (first, last) = (frame(start), frame(end));
    let joint = clip.skeleton().joint(gesture.joint).expect("a joint of the rig");
    let turned = |a: usize, b: usize| {
        angle_between(clip.frames()[a].pose.rotation(joint), clip.frames()[b].pose.rotation(joint))
    };
    let mean = turned(first, last) / (last - first) as f64;
    let fastest = (first..last).map(|i| turned(i, i + 1)).fold(0.0, f64::max);
    let points = point::matching(clip.skeleton(), gesture.point);
    let profile = of_clip(clip, &points, gesture.reference, &[Measure::Speed]).expect("a hand");
    let speeds = &profile.curves()[0].values[first..=last];
    let later = |a: (usize, f64), b: (usize, f64)| if b.1 > a.1 { b } else { a };
    let (at, peak) = speeds.iter().copied().enumerate().reduce(later).unwrap_or_default();
    Measured { gesture: gesture.name, easing, peak, at: at as f64 / (last - first) as f64, ratio: fastest / mean }
}
