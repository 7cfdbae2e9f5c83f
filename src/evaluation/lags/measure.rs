//! The movements of wrist, palm and fingers in a clip, and which go on at the same time.

use super::{Rule, Stop, Stretch};
use crate::evaluation::kinematics::cut::transitions;
use crate::evaluation::kinematics::{Hand, distance, hands, smoothed, speed};
use crate::motion::clip::Clip;
use crate::time::{Fps, Seconds};
use glam::DVec3;

/// The movements of a clip's wrists, each with what its hand does at the same time. A wrist is seen from the chest, or
/// from the floor where there is no arm.
///
/// ```
/// use chereme::evaluation::lags::{Rule, find};
/// use chereme::motion::{clip::{Clip, Frame}, easing::Easing, pose::LocalPose, skeleton::{Joint, Skeleton}};
/// use chereme::time::Fps;
/// use glam::DVec3;
/// use std::sync::Arc;
/// let joint = Joint { name: "RightHand".into(), parent: None, rest_model: DVec3::ZERO, tail_model: DVec3::ZERO };
/// let rig = Arc::new(Skeleton::new(vec![joint]).unwrap());
/// let frame = |i: i32| {
///     let mut pose = LocalPose::rest(&rig);
///     pose.root_model = DVec3::X * 0.3 * Easing::MinimumJerk.weight(f64::from(i - 20) / 30.0);
///     Frame { pose, weights: vec![] }
/// };
/// let clip = Clip::new(Arc::clone(&rig), Fps::DEFAULT, vec![].into(), (0..70).map(frame).collect()).unwrap();
/// let stops = find("take", &clip, &Rule::default());
/// assert!(stops.len() == 1 && stops[0].palm.is_none() && stops[0].wrist.end.0 > 0.7);
/// ```
pub fn find(take: &str, clip: &Clip, rule: &Rule) -> Vec<Stop> {
    hands(clip).iter().flat_map(|hand| of_hand(take, clip, hand, rule)).collect()
}

fn of_hand(take: &str, clip: &Clip, hand: &Hand, rule: &Rule) -> Vec<Stop> {
    let [mut wrist, mut palm, mut tips] = [const { Vec::new() }; 3];
    for frame in clip.frames() {
        let pose = frame.pose.to_model(clip.skeleton());
        let (place, turn) = (pose.position(hand.wrist), pose.rotation(hand.wrist));
        let (from, about) = hand.chest.map_or((DVec3::ZERO, glam::DQuat::IDENTITY), |chest| {
            (pose.position(chest), pose.rotation(chest).inverse())
        });
        wrist.push(vec![about * (place - from)]);
        palm.push(DVec3::AXES.map(|axis| about * (turn * axis)).to_vec());
        tips.push(hand.tips.iter().map(|tip| turn.inverse() * (tip.position(&pose) - place)).collect());
    }
    let fps = clip.fps();
    // The mean square way of three unit axes in a turn.
    let turn = (8.0f64 / 3.0).sqrt() * (rule.least_turn / 2.0).sin();
    let palms = stretches(&palm, fps, turn, rule);
    let changes = if hand.tips.is_empty() { Vec::new() } else { stretches(&tips, fps, rule.least_fingers, rule) };
    let stop = |wrist: Stretch| Stop {
        take: take.to_owned(),
        side: hand.side,
        wrist,
        configuration: meanwhile(wrist, &changes),
        palm: meanwhile(wrist, &palms),
    };
    stretches(&wrist, fps, rule.least_wrist, rule).into_iter().map(stop).collect()
}

/// From when to when points move at least so far.
fn stretches(frames: &[Vec<DVec3>], fps: Fps, least: f64, rule: &Rule) -> Vec<Stretch> {
    let smooth = smoothed(frames, fps, rule.smoothing);
    let cuts = transitions(&speed(&smooth, fps), rule.rest);
    let far = cuts.into_iter().filter(|cut| distance(&smooth[cut.start], &smooth[cut.end]) >= least);
    let all = far.map(|cut| Stretch { start: Seconds(cut.go / fps.get()), end: Seconds(cut.stop / fps.get()) });
    all.filter(|s| (rule.lasts.0.0..=rule.lasts.1.0).contains(&(s.end.0 - s.start.0))).collect()
}

/// The stretch that goes on at the same time: for at least half of the shorter of the two, and longest of all.
fn meanwhile(wrist: Stretch, others: &[Stretch]) -> Option<Stretch> {
    let shared = |s: &Stretch| s.end.0.min(wrist.end.0) - s.start.0.max(wrist.start.0);
    let lasts = |s: &Stretch| s.end.0 - s.start.0;
    let together = |s: &&Stretch| shared(s) >= 0.5 * lasts(s).min(lasts(&wrist));
    others.iter().filter(together).max_by(|a, b| shared(a).total_cmp(&shared(b))).copied()
}
