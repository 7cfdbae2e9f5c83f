//! A motion checked against its description and against what bodies can do.
//!
//! This is no part of making a motion: it looks at the finished clip, poses the body frame by frame with forward kinematics, and
//! measures on landmarks and joints. What it expects at a key it takes from the description and the inventories again, not from the
//! plan that the motion was made from, so that a fault of the planner is seen too.
//!
//! # What it measures
//! Everything finite; bones as long as at rest; elbow, wrist and fingers within their limits, no finger twisted; no joint turning
//! faster than a body's; no hand in the body; wrists' speed; how long the sign takes; at the keys, contacts within a centimetre,
//! fingers and palm within five degrees.
//!
//! # Conventions
//! One finding a kind, hand and key (or joint), the worst of its frames. A [`Weight::Fault`] is a motion that nobody can use; a
//! [`Weight::Warning`] is worth a look; an [`Weight::Exception`] is what the synthesis has reported itself: out of reach, or turned as
//! far as a wrist goes.

mod contact;
mod finding;
mod inside;
mod joints;
mod key;
mod pace;
mod turn;

use super::{Grammar, Performance};
use crate::body::signer::Signer;
use crate::motion::pose::ModelPose;
use crate::phonology::Sign;
pub use finding::{Finding, Kind, Unit, Weight};

/// What a motion is checked against.
struct Checking<'a> {
    sign: &'a Sign,
    performance: &'a Performance,
    grammar: &'a Grammar,
    signer: &'a Signer,
    /// The body in every frame, model space.
    frames: Vec<ModelPose>,
}

/// Checks the motion of one sign.
///
/// ```
/// use chereme::notation::Lexicon;
/// use chereme::synthesis::verify::{Weight, verify};
/// use chereme::synthesis::{Grammar, Options, synthesize};
/// let (grammar, signer) = (Grammar::builtin(), chereme::avatar::signer().unwrap());
/// let sign = &Lexicon::builtin().find("BOL", Some("lsf")).unwrap().sign.clone();
/// let performance = synthesize(sign, &grammar, &signer, &Options::default()).unwrap();
/// let findings = verify(sign, &performance, &grammar, &signer);
/// assert!(findings.iter().all(|finding| finding.kind.weight() != Weight::Fault), "{findings:?}");
/// ```
pub fn verify(sign: &Sign, performance: &Performance, grammar: &Grammar, signer: &Signer) -> Vec<Finding> {
    // Nothing can be measured on what is no number.
    if let Some(finding) = joints::not_finite(&performance.track.clip) {
        return vec![finding];
    }
    let clip = &performance.track.clip;
    let frames = clip.frames().iter().map(|frame| frame.pose.to_model(clip.skeleton())).collect();
    let checking = Checking { sign, performance, grammar, signer, frames };
    let mut findings = checking.bones();
    findings.extend(checking.arms());
    findings.extend(checking.fingers());
    findings.extend(checking.jumps());
    findings.extend(checking.inside());
    findings.extend(checking.pace());
    for key in checking.keys() {
        findings.extend(checking.contacts(&key));
        findings.extend(checking.turns(&key));
    }
    findings
}
