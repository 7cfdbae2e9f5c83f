//! Signs rebuilt from captured motion (Naert et al. 2021, §3–6): takes of a corpus, edited as motion, joined with described signs.
//!
//! A plan may hold signs that are captured ([`Act::Captured`]). Each is a take of a corpus: its channels are exchanged
//! with those of other takes, the operators of [`super::edit`] are applied, and it is cut to stroke and hold. What stands
//! between is synthesized as ever. Then all is joined by eased ways, which last so long that no joint turns faster than
//! it does in the corpus ([`Pace`]).
//!
//! # Conventions
//! Model space, metres, seconds. Takes move our rig ([`crate::body::retarget`]) and have phase tiers.

mod channel;
mod join;
mod library;
mod operate;
mod pace;

pub use channel::with_channel;
pub use join::least_way;
pub use library::Captures;
pub use pace::Pace;

use super::{Grammar, Options, Performance, synthesize_plan};
use crate::body::channel::Channels;
use crate::body::retarget::Coverage;
use crate::body::signer::Signer;
use crate::diagnostics::Error;
use crate::motion::clip::{Clip, Frame};
use crate::motion::pose::LocalPose;
use crate::motion::skeleton::JointId;
use crate::phonology::handshape::HandAngles;
use crate::phonology::recombination::Taken;
use crate::phonology::{Configuration, Side};
use crate::score::plan::{Act, Captured, CapturedSign, Item, Over, Plan};
use crate::synthesis::edit::track::Phases;
use crate::tier::{Tier, TierValue};
use crate::time::{Fps, FrameIndex, Seconds};
use crate::track::Track;
use join::{Joined, Piece};

/// A take of a corpus: one sign as it was captured.
#[derive(Debug, Clone)]
pub struct Take {
    /// Its name in the corpus.
    pub name: String,
    /// The motion of our rig, and what was annotated on it; one sign, with phase tiers.
    pub track: Track,
    /// What of the body was captured: hands alone ride on the signer as he rests.
    pub covers: Coverage,
}

/// Where takes come from.
pub trait Takes {
    /// The best take of a gloss; `None` where there is none.
    ///
    /// # Errors
    /// A take that cannot be used.
    fn of_gloss(&self, gloss: &str) -> Result<Option<Take>, Error>;

    /// The take of that name.
    ///
    /// # Errors
    /// No such take; one that cannot be used.
    fn named(&self, name: &str) -> Result<Take, Error>;

    /// A captured hand of that configuration, and which frame of which recording it is.
    fn configuration(&self, configuration: &Configuration) -> Option<(HandAngles, String)>;

    /// How fast joints turn in it.
    fn pace(&self) -> &Pace;
}

/// Signs a plan in which signs are captured.
///
/// # Errors
/// Those of [`synthesize_plan`] for what is described; takes that are missing or cannot be edited as is said. The message
/// names the gloss.
pub fn perform(
    plan: &Plan,
    takes: &dyn Takes,
    grammar: &Grammar,
    signer: &Signer,
    options: &Options,
) -> Result<Performance, Error> {
    if !plan.items.iter().any(|item| matches!(item.act, Act::Captured(_))) {
        return synthesize_plan(plan, grammar, signer, options);
    }
    let mut pieces = Vec::new();
    let mut warnings = Vec::new();
    let mut at = 0;
    while at < plan.items.len() {
        let item = &plan.items[at];
        match &item.act {
            Act::Captured(captured) => {
                let made = taken(captured, item, takes, grammar, signer, options);
                let (track, more) = made.map_err(|e| e.context(item.gloss.clone()))?;
                warnings.extend(more.into_iter().map(|w| format!("{}: {w}", item.gloss)));
                pieces.push(Piece::of_sign(&track)?);
                at += 1;
            }
            Act::Hold(_, time) if !pieces.is_empty() => {
                pieces.push(Piece::Hold(time.unwrap_or(Seconds(grammar.movements.timing.hold)).0));
                at += 1;
            }
            Act::Rest(time) => {
                pieces.push(Piece::Rest(time.unwrap_or(Seconds(grammar.movements.timing.hold)).0));
                at += 1;
            }
            Act::Sign(_) | Act::Hold(..) => {
                let end = plan.items[at..].iter().position(|next| matches!(next.act, Act::Captured(_)));
                let end = end.map_or(plan.items.len(), |n| at + n);
                let run = synthesize_plan(&part(plan, at, end), grammar, signer, options)?;
                warnings.extend(run.report.warnings.iter().cloned());
                pieces.push(Piece::cut(&run.track, run.report.stroke_start, run.report.sign_end)?);
                at = end;
            }
        }
    }
    if plan.spans.iter().any(|over| plan.items[over.items.clone()].iter().any(|i| matches!(i.act, Act::Captured(_)))) {
        warnings.push("what the face does over captured signs is as it was captured".to_owned());
    }
    let Joined { track, mut report } = join::join(pieces, takes.pace(), grammar, signer, options)?;
    report.warnings.extend(warnings);
    Ok(Performance { track, report })
}

/// The items from one to before another, with what the face does over them.
fn part(plan: &Plan, start: usize, end: usize) -> Plan {
    let within = |over: &Over| {
        let items = over.items.start.max(start)..over.items.end.min(end);
        (items.start < items.end).then(|| Over { items: items.start - start..items.end - start, ..over.clone() })
    };
    Plan { items: plan.items[start..end].to_vec(), spans: plan.spans.iter().filter_map(within).collect() }
}

/// A captured sign with all that is said of it, and warnings.
fn taken(
    captured: &Captured,
    item: &Item,
    takes: &dyn Takes,
    grammar: &Grammar,
    signer: &Signer,
    options: &Options,
) -> Result<(Track, Vec<String>), Error> {
    let (take, channels) = match &captured.what {
        CapturedSign::Gloss(gloss) => {
            let take = takes.of_gloss(gloss)?;
            (take.ok_or_else(|| Error::new(format!("the corpus has no take of {gloss}")))?, &[][..])
        }
        CapturedSign::Take(Taken { take, channels }) => (takes.named(take)?, &channels[..]),
    };
    let relaxed = grammar.handshapes.angles(&Configuration::named("rest"), None);
    let neutral = signer.neutral(&relaxed.map_err(|e| Error::new(e.to_string()))?);
    let mut track = at_rate(&take, signer, &neutral, options.fps)?;
    for (channel, name) in channels {
        let other = takes.named(name)?;
        let sampled = Take { track: at_rate(&other, signer, &neutral, options.fps)?, ..other };
        track = with_channel(&track, &sampled, *channel, signer, options.easing)?;
    }
    let mut warnings = Vec::new();
    track = operate::operated(track, captured, takes, grammar, signer, options, &mut warnings)?;
    named(&mut track, &item.gloss, &take.name)?;
    Ok((track, warnings))
}

/// A take at the frame rate and with the morphs of what is made, its values told to come from it.
fn at_rate(take: &Take, signer: &Signer, neutral: &LocalPose, fps: Fps) -> Result<Track, Error> {
    let clip = &take.track.clip;
    let count = fps.frame_count(clip.duration());
    super::edit::may_last(count as f64)?;
    if clip.skeleton().len() != signer.skeleton.len() {
        return Err(Error::new("the take moves another rig than the signer's"));
    }
    let Coverage { body, arms, hands } = take.covers;
    let sides = [Side::Left, Side::Right].into_iter().filter(|side| arms[*side as usize] || hands[*side as usize]);
    let limbs: Vec<JointId> = sides.flat_map(|side| Channels::of(signer, side).limb().collect::<Vec<_>>()).collect();
    let frame = |i| {
        let sampled = clip.sample(fps.time_of(FrameIndex(i))).pose;
        let pose = match body {
            true => sampled,
            false => {
                let mut pose = neutral.clone();
                limbs.iter().for_each(|joint| pose.set(*joint, sampled.rotation(*joint)));
                pose
            }
        };
        Frame { pose, weights: vec![0.0; signer.morphs.len()] }
    };
    let frames = (0..count).map(frame).collect();
    let fits = Clip::new(signer.skeleton.clone(), fps, signer.morphs.clone(), frames);
    let clip = fits.ok_or_else(|| Error::new("the take moves another rig than the signer's"))?;
    let tiers = take.track.tiers.iter().map(|tier| {
        let mut made = Tier::new(tier.name.clone());
        for v in tier.values() {
            made.push(v.start, v.end, v.label.clone(), source_of(v, &take.name));
        }
        made
    });
    Ok(Track { clip, tiers: tiers.collect() })
}

/// Where a value of a take comes from.
fn source_of(value: &TierValue, take: &str) -> String {
    match value.source.as_str() {
        "" => format!("corpus: {take}"),
        how => format!("corpus: {take}, {how}"),
    }
}

/// Writes the gloss over stroke and hold of the hands that act.
fn named(track: &mut Track, gloss: &str, take: &str) -> Result<(), Error> {
    let phases = Phases::of(track)?;
    track.tiers.retain(|tier| !tier.name.ends_with("Gloss"));
    for (at, side) in phases.sides.each().iter().enumerate() {
        let prefix = side.hand();
        let mut tier = Tier::new(format!("{prefix} Gloss"));
        tier.push(phases.stroke, phases.sign_end, gloss, format!("corpus: {take}"));
        track.tiers.insert(at, tier);
    }
    Ok(())
}
