//! Channels of one take in another, phase by phase.

use super::Take;
use crate::body::channel::Channels;
use crate::body::signer::Signer;
use crate::diagnostics::Error;
use crate::motion::easing::Easing;
use crate::motion::pose::LocalPose;
use crate::motion::rotation::unit;
use crate::motion::short_arc::ShortArc;
use crate::phonology::Side;
use crate::phonology::recombination::ManualChannel;
use crate::synthesis::edit::track::{self, Phases};
use crate::synthesis::edit::{rewritten, turn_hand};
use crate::tier::Tier;
use crate::time::{FrameIndex, Seconds};
use crate::track::Track;
use glam::DQuat;

/// The sign of a track with one channel of its hands as in a take. The take is warped in time, so that its preparation,
/// stroke, hold and retraction fall on the track's. The channel comes in the preparation and goes in the retraction; every
/// other joint of the track stays as it was, but that a wrist makes up for an arm that goes elsewhere.
///
/// A take that is made with the other hand is swapped first.
///
/// # Errors
/// Tracks of other rigs, without phases or with several signs.
pub fn with_channel(
    base: &Track,
    take: &Take,
    channel: ManualChannel,
    signer: &Signer,
    easing: Easing,
) -> Result<Track, Error> {
    let phases = Phases::of(base)?;
    let (other, theirs) = exchanged(take, &phases, signer)?;
    let sides: Vec<Side> =
        phases.sides.each().iter().copied().filter(|side| theirs.sides.each().contains(side)).collect();
    let warp = Warp::new(&phases, &theirs);
    let weights = phases.extent(easing).weights(&base.clip);
    let chest = signer.skeleton.joint("Spine2")?;
    let joints: Vec<_> = sides.iter().flat_map(|side| touched(signer, *side, channel)).collect();
    let mut turned = [0.0; 2];
    let clip = rewritten(&base.clip, &joints, |i, pose| {
        let weight = weights[i];
        if weight <= 0.0 {
            return;
        }
        let own = pose.clone();
        let before = own.to_model(&signer.skeleton);
        let source = other.clip.sample(warp.at(base.clip.fps().time_of(FrameIndex(i)))).pose;
        for &side in &sides {
            let arm = signer.arm(side);
            match channel {
                ManualChannel::Configuration => {
                    for joint in signer.hand(side).joints() {
                        pose.set(joint, source.rotation(joint));
                    }
                }
                ManualChannel::Orientation => {
                    let model = source.to_model(&signer.skeleton);
                    let in_trunk = model.rotation(chest).conjugate() * model.rotation(arm.hand);
                    face(signer, side, before.rotation(chest) * in_trunk, &mut turned, pose);
                }
                ManualChannel::Placement => {
                    for joint in Channels::of(signer, side).placement {
                        pose.set(joint, source.rotation(joint));
                    }
                    face(signer, side, before.rotation(arm.hand), &mut turned, pose);
                }
            }
        }
        if weight < 1.0 {
            for joint in &joints {
                pose.set(*joint, ShortArc::new(own.rotation(*joint), pose.rotation(*joint)).eased(easing, weight));
            }
        }
    });
    let tiers = tiers(base, &other.tiers, &sides, channel, &warp, &phases);
    Ok(Track { clip, tiers })
}

/// The take as the hands of the sign make it.
fn exchanged(take: &Take, phases: &Phases, signer: &Signer) -> Result<(Track, Phases), Error> {
    let own = Phases::of(&take.track)?;
    if own.sides.each().iter().any(|side| phases.sides.each().contains(side)) {
        return Ok((take.track.clone(), own));
    }
    let swapped = track::swapped(&take.track, signer)?;
    let phases = Phases::of(&swapped)?;
    Ok((swapped, phases))
}

/// The joints that a channel changes: its own, and the wrist's where the arm goes elsewhere.
fn touched(signer: &Signer, side: Side, channel: ManualChannel) -> Vec<crate::motion::skeleton::JointId> {
    let channels = Channels::of(signer, side);
    match channel {
        ManualChannel::Configuration => channels.configuration.to_vec(),
        ManualChannel::Orientation => channels.orientation,
        ManualChannel::Placement => channels.placement.into_iter().chain(channels.orientation).collect(),
    }
}

/// Turns a hand in model space.
fn face(signer: &Signer, side: Side, hand: DQuat, turned: &mut [f64; 2], pose: &mut LocalPose) {
    let arm = signer.arm(side);
    let fore = pose.to_model(&signer.skeleton).rotation(arm.fore);
    turn_hand(arm, unit(fore.conjugate() * hand), &mut turned[side as usize], pose);
}

/// From instants of one sign to those of another, phase by phase.
struct Warp([(f64, f64); 5]);

impl Warp {
    fn new(from: &Phases, to: &Phases) -> Warp {
        let of = |p: &Phases| [p.start.0, p.stroke.0, p.stroke_end.0, p.sign_end.0, p.retracted.0];
        let (from, to) = (of(from), of(to));
        Warp(std::array::from_fn(|i| (from[i], to[i])))
    }

    /// The instant in the other sign; before the first phase and after the last one time goes on as it does.
    fn at(&self, time: Seconds) -> Seconds {
        self.map(time.0, false)
    }

    fn back(&self, time: Seconds) -> Seconds {
        self.map(time.0, true)
    }

    fn map(&self, time: f64, back: bool) -> Seconds {
        let pair = |(a, b): (f64, f64)| if back { (b, a) } else { (a, b) };
        let marks = self.0.map(pair);
        let next = marks.iter().position(|(from, _)| time < *from);
        Seconds(match next {
            Some(0) => marks[0].1 + (time - marks[0].0),
            None => marks[4].1 + (time - marks[4].0),
            Some(n) => {
                let ((a, b), (c, d)) = (marks[n - 1], marks[n]);
                b + (d - b) * ((time - a) / (c - a).max(1e-9))
            }
        })
    }
}

/// The track's tiers with the channel's values as in the other take.
fn tiers(
    base: &Track,
    others: &[Tier],
    sides: &[Side],
    channel: ManualChannel,
    warp: &Warp,
    phases: &Phases,
) -> Vec<Tier> {
    let kinds: &[&str] = match channel {
        ManualChannel::Configuration => &["Configuration"],
        ManualChannel::Orientation => &["Orientation"],
        ManualChannel::Placement => &["Placement", "Movement"],
    };
    let mut tiers = base.tiers.clone();
    for side in sides {
        let prefix = side.hand();
        for kind in kinds {
            let name = format!("{prefix} {kind}");
            let mut made = Tier::new(name.clone());
            for v in others.iter().filter(|tier| tier.name == name).flat_map(Tier::values) {
                let (start, end) = (warp.back(v.start), warp.back(v.end));
                if end > phases.start && start < phases.retracted {
                    made.push(start, end, v.label.clone(), v.source.clone());
                }
            }
            tiers.retain(|tier| tier.name != name);
            if !made.values().is_empty() {
                tiers.push(made);
            }
        }
    }
    track::in_order(tiers)
}
