//! How fast joints turn in captured motion.

use crate::motion::clip::Clip;
use crate::motion::rotation::angle_between;
use crate::motion::skeleton::JointId;

/// The share of frames that may be faster than what counts as fastest: a tracker's leaps.
const LEAPS: f64 = 0.005;
/// A joint is followed over this long, seconds: from one frame to the next a tracker's noise is as fast as signing.
const OVER_S: f64 = 0.05;
/// What no recording covers turns no faster than this, radians a second.
const UNKNOWN: f64 = 6.0;
/// Nothing counts as slower than this, radians a second: a trunk that hardly turns in a few clips does not say how fast it could.
const SLOWEST: f64 = 1.0;

/// The greatest speed of each joint of the rig, radians a second.
///
/// ```
/// use chereme::motion::{clip::{Clip, Frame}, pose::LocalPose};
/// use chereme::synthesis::captured::Pace;
/// let signer = chereme::avatar::signer().unwrap();
/// let neck = signer.skeleton.joint("Neck").unwrap();
/// let frame = |i: usize| {
///     let mut pose = LocalPose::rest(&signer.skeleton);
///     pose.set(neck, glam::DQuat::from_rotation_x(0.05 * i as f64));
///     Frame { pose, weights: vec![] }
/// };
/// let clip = Clip::new(signer.skeleton.clone(), chereme::time::Fps::DEFAULT, Default::default(), (0..40).map(frame).collect()).unwrap();
/// let pace = Pace::of([(&clip, &[neck][..])]);
/// assert!((pace.of_joint(neck) - 3.0).abs() < 1e-6);
/// ```
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Pace {
    fastest: Vec<Option<f64>>,
}

impl Pace {
    /// The pace of clips of one rig, each with the joints that it covers.
    pub fn of<'c>(clips: impl IntoIterator<Item = (&'c Clip, &'c [JointId])>) -> Pace {
        let mut speeds: Vec<Vec<f32>> = Vec::new();
        for (clip, joints) in clips {
            speeds.resize_with(speeds.len().max(clip.skeleton().len()), Vec::new);
            let over = ((OVER_S * clip.fps().get()).round() as usize).max(1);
            let seconds = over as f64 / clip.fps().get();
            for pair in clip.frames().windows(over + 1) {
                for joint in joints {
                    let turn = angle_between(pair[0].pose.rotation(*joint), pair[over].pose.rotation(*joint));
                    speeds[joint.index()].push((turn / seconds) as f32);
                }
            }
        }
        let fastest = speeds.into_iter().map(|mut all| {
            all.sort_by(f32::total_cmp);
            let at = ((all.len() as f64 * (1.0 - LEAPS)) as usize).min(all.len().checked_sub(1)?);
            Some(f64::from(all[at]).max(SLOWEST))
        });
        Pace { fastest: fastest.collect() }
    }

    /// The greatest speed of a joint, radians a second; of one that was never captured, what signers' joints are usually under.
    pub fn of_joint(&self, joint: JointId) -> f64 {
        self.fastest.get(joint.index()).copied().flatten().unwrap_or(UNKNOWN)
    }
}
