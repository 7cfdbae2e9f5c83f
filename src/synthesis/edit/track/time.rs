//! A sign backwards, again, and at another speed, with its tiers.

use super::{Phases, about, limbs, marked, rebuild_ways, remapped, side_of};
use crate::body::signer::Signer;
use crate::diagnostics::Error;
use crate::motion::clip::Frame;
use crate::motion::easing::Easing;
use crate::synthesis::edit::{self, Repetition, continue_signs, fits, may_last, remade};
use crate::tier::{Tier, TierValue};
use crate::time::{FrameIndex, Seconds};
use crate::track::Track;

/// The sign backwards: the stroke of both limbs is reversed, what it ended with before is now held at its start's
/// pose, and the ways to and from it are made again. Non-manuals stay.
///
/// # Errors
/// A track of another rig, without phases or with several signs.
pub fn inverted(track: &Track, signer: &Signer, easing: Easing) -> Result<Track, Error> {
    let clip = &track.clip;
    fits(clip, signer)?;
    let phases = Phases::of(track)?;
    let joints = limbs(signer, phases.sides);
    let (first, last) = phases.frames(clip, phases.sign_end);
    let mut frames = clip.frames().to_vec();
    for (i, frame) in frames.iter_mut().enumerate().take(last + 1).skip(first) {
        // The hold at the end holds what the stroke began with.
        let time = clip.fps().time_of(FrameIndex(i)).0.min(phases.stroke_end.0);
        let source = clip.sample(Seconds(phases.stroke.0 + phases.stroke_end.0 - time)).pose;
        joints.iter().for_each(|j| frame.pose.set(*j, source.rotation(*j)));
    }
    rebuild_ways(clip, &mut frames, &joints, (first, last), (phases.start, phases.retracted), easing);
    continue_signs(&mut frames, 1);
    let tiers = track.tiers.iter().map(|tier| inverted_tier(tier, &phases)).collect();
    Ok(Track { clip: remade(clip, frames), tiers })
}

/// Values at keys change places; intervals are turned round in time; what is of the whole sign stays.
fn inverted_tier(tier: &Tier, phases: &Phases) -> Tier {
    let turned = |t: Seconds| Seconds(phases.stroke.0 + phases.stroke_end.0 - t.0.min(phases.stroke_end.0));
    let done = "inverted";
    match (side_of(tier).is_some(), about(tier)) {
        (true, "Movement") => {
            let values = tier.values().iter().map(|v| TierValue {
                start: turned(v.end),
                end: turned(v.start),
                label: format!("{}, inverted", v.label),
                ..marked(v, done)
            });
            remapped(tier, String::new(), values)
        }
        (true, "Configuration" | "Placement" | "Orientation") | (false, "Contact") => {
            let values: Vec<&TierValue> = tier.values().iter().rev().collect();
            let starts: Vec<Seconds> =
                values.iter().enumerate().map(|(i, v)| if i == 0 { phases.stroke } else { turned(v.start) }).collect();
            let made = values.iter().enumerate().map(|(i, v)| TierValue {
                start: starts[i],
                end: starts.get(i + 1).copied().unwrap_or(phases.sign_end),
                ..marked(v, done)
            });
            remapped(tier, String::new(), made)
        }
        _ => tier.clone(),
    }
}

/// The stroke performed several times between one preparation and one retraction.
///
/// Non-manuals last as long as the sign does: over the strokes they are slower by as much as these are more.
///
/// # Errors
/// As [`edit::repeated`], and a track without phases or with several signs.
pub fn repeated(track: &Track, signer: &Signer, how: &Repetition) -> Result<Track, Error> {
    let clip = &track.clip;
    fits(clip, signer)?;
    let phases = Phases::of(track)?;
    let (first, last) = phases.frames(clip, phases.stroke_end);
    let stroke = remade(clip, clip.frames()[first..=last].to_vec());
    let performed = edit::repeated(&stroke, signer, &Repetition { sides: phases.sides, ..*how })?;
    let more = performed.frames().len() - stroke.frames().len();
    may_last((clip.frames().len() + more) as f64)?;

    let fps = clip.fps();
    let longer = Seconds(more as f64 / fps.get());
    let warp = |time: Seconds| -> Seconds {
        let (start, length) = (phases.stroke, phases.stroke_end - phases.stroke);
        if time <= start || length.0 <= 0.0 {
            time
        } else if time <= phases.stroke_end + longer {
            start + (time - start) * (length.0 / (length + longer).0)
        } else {
            time - longer
        }
    };
    let joints = limbs(signer, phases.sides);
    let mut frames: Vec<Frame> = Vec::with_capacity(clip.frames().len() + more);
    for i in 0..clip.frames().len() + more {
        let mut frame = clip.sample(warp(fps.time_of(FrameIndex(i))));
        let limb = match i {
            i if i < first => &clip.frames()[i].pose,
            i if i <= last + more => &performed.frames()[i - first].pose,
            // The hold stands where the last performance ended.
            i if Seconds((i - more) as f64 / fps.get()) <= phases.sign_end => &frames[i - 1].pose,
            i => &clip.frames()[i - more].pose,
        };
        joints.iter().for_each(|j| frame.pose.set(*j, limb.rotation(*j)));
        frames.push(frame);
    }
    if how.growth != 1.0 {
        let held = phases.frames(clip, phases.sign_end).1 + more;
        let ends = (phases.start, phases.retracted + longer);
        rebuild_ways(clip, &mut frames, &joints, (first, held), ends, how.easing);
    }
    continue_signs(&mut frames, 1);
    let period = longer * (1.0 / f64::from(how.times.max(2) - 1));
    let tiers = track.tiers.iter().map(|tier| repeated_tier(tier, &phases, how.times, period, longer)).collect();
    Ok(Track { clip: remade(clip, frames), tiers })
}

fn repeated_tier(tier: &Tier, phases: &Phases, times: u32, period: Seconds, longer: Seconds) -> Tier {
    let manual = side_of(tier).is_some() && about(tier) != "Gloss" || tier.name == "Contact";
    let late = |t: Seconds| if t >= phases.stroke_end { t + longer } else { t };
    let mut values = Vec::new();
    for v in tier.values() {
        let in_stroke = v.start >= phases.stroke && v.start < phases.sign_end && v.label != "hold";
        if !(manual && in_stroke) {
            values.push(TierValue { start: late(v.start), end: late(v.end), ..v.clone() });
            continue;
        }
        for n in 0..times {
            let shift = period * f64::from(n);
            let (start, end) = (v.start + shift, v.end + shift);
            // A value that lasts into the hold ends, before the last performance, where the next one begins.
            let end = if n + 1 < times && v.end > phases.stroke_end { phases.stroke + shift + period } else { end };
            let value = if n == 0 { v.clone() } else { marked(v, "repeated") };
            values.push(TierValue { start, end, ..value });
        }
    }
    remapped(tier, String::new(), values)
}

/// The track at another speed: 2 is twice as fast. The tiers' times are divided with it.
///
/// # Errors
/// As [`edit::at_speed`].
///
/// ```
/// # use chereme::synthesis::{Grammar, Options, edit, synthesize};
/// # let signer = chereme::avatar::signer().unwrap();
/// # let sign = chereme::notation::read("sign X\n movement up\n", &chereme::notation::Vocabulary::builtin(), "lsf");
/// let track = synthesize(&sign.signs[0].sign, &Grammar::builtin(), &signer, &Options::default()).unwrap().track;
/// let slow = edit::track::at_speed(&track, 0.5).unwrap();
/// assert_eq!(slow.tiers[0].values()[0].start.0, 2.0 * track.tiers[0].values()[0].start.0);
/// ```
pub fn at_speed(track: &Track, factor: f64) -> Result<Track, Error> {
    let clip = edit::at_speed(&track.clip, factor)?;
    let time = |t: Seconds| t * (1.0 / factor);
    let tiers = track.tiers.iter().map(|tier| {
        let values = tier.values().iter().map(|v| TierValue { start: time(v.start), end: time(v.end), ..v.clone() });
        remapped(tier, String::new(), values)
    });
    Ok(Track { clip, tiers: tiers.collect() })
}
