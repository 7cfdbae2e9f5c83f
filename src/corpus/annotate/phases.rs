//! Phases: when a hand rests, prepares, strokes, holds and goes back, each hand for itself (Naert et al. 2021, §3: both hands are
//! often not synchronous).

use super::moves::{Move, Thresholds, moves};
use super::signals::Signals;
use super::{Limb, Options, Phase, Value};
use crate::time::{FrameIndex, Seconds};

/// A stretch in which a hand signs, frames: from the end of its preparation to the start of its retraction.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Signing {
    pub start: usize,
    pub end: usize,
}

/// The phases of a hand and the stretches in which it signs.
pub(super) fn phases(signals: &Signals, limb: Limb, options: &Options) -> (Vec<Value<Phase>>, Vec<Signing>) {
    let activity = signals.activity();
    let all = moves(&activity, Thresholds { still: options.still, least: options.least, valley: 0.4 });
    // The ways from and to rest are told by the arm: fingers may play before it has come.
    let ways = match limb {
        Limb::Arm => moves(&signals.path_speed, Thresholds { still: options.still, least: options.least, valley: 0.4 }),
        Limb::Hand | Limb::None => all.clone(),
    };
    let mut told = Teller { signals, values: Vec::new() };
    let mut stretches = Vec::new();
    for (from, to) in raised(signals, limb) {
        let last = activity.len() - 1;
        let inner: Vec<Move> = all.iter().copied().filter(|m| m.end > from && m.start < to).collect();
        // A hand that is raised from the first frame on has no preparation, and one that stays raised no retraction.
        let whole: Vec<Move> = ways.iter().copied().filter(|m| m.end > from && m.start < to).collect();
        let comes = whole.first().filter(|m| from > 0 && m.start <= from);
        let goes = whole.last().filter(|m| to < last && m.end >= to);
        let profile = if limb == Limb::Arm { &signals.path_speed } else { &activity };
        let start = comes.map_or(from, |m| arrival(profile, m));
        let end = goes.map_or(to, |m| departure(profile, m)).max(start);
        if let Some(m) = comes {
            told.tell(Phase::Preparation, m.start, start);
        }
        if start < end {
            told.signing(&inner, start, end, options);
            stretches.push(Signing { start, end });
        }
        if let Some(m) = goes {
            told.tell(Phase::Retraction, end, m.end);
        }
    }
    (told.values, stretches)
}

/// A way from rest is over where its speed is at a low so far below its peak, though the hand goes on slowly.
const ARRIVED: f64 = 0.15;

/// The frame at which a way from rest is over.
fn arrival(profile: &[f64], of: &Move) -> usize {
    let low = |f: &usize| profile[*f] < ARRIVED * profile[of.peak] && profile[f + 1] >= profile[*f];
    (of.peak..of.end).find(low).unwrap_or(of.end)
}

/// The frame at which a way to rest begins.
fn departure(profile: &[f64], of: &Move) -> usize {
    let low = |f: &usize| profile[*f] < ARRIVED * profile[of.peak] && profile[f - 1] >= profile[*f];
    (of.start + 1..of.peak).rev().find(low).unwrap_or(of.start)
}

/// The stretches in which the hand is not at rest, frames. Without an arm it never is.
fn raised(signals: &Signals, limb: Limb) -> Vec<(usize, usize)> {
    let last = signals.hangs.len() - 1;
    match limb {
        Limb::None => Vec::new(),
        Limb::Hand => vec![(0, last)],
        Limb::Arm => {
            let mut found: Vec<(usize, usize)> = Vec::new();
            for (i, _) in signals.hangs.iter().enumerate().filter(|(_, hangs)| !**hangs) {
                match found.last_mut() {
                    Some((_, to)) if *to + 1 == i => *to = i,
                    _ => found.push((i, i)),
                }
            }
            found
        }
    }
}

struct Teller<'a> {
    signals: &'a Signals,
    values: Vec<Value<Phase>>,
}

impl Teller<'_> {
    fn tell(&mut self, phase: Phase, from: usize, to: usize) {
        if to <= from {
            return;
        }
        let at = |frame: usize| -> Seconds { self.signals.fps.time_of(FrameIndex(frame)) };
        self.values.push(Value { start: at(from), end: at(to), value: phase, off: 0.0 });
    }

    /// Strokes with the holds between them.
    fn signing(&mut self, inner: &[Move], start: usize, end: usize, options: &Options) {
        let fps = self.signals.fps.get();
        let long = (options.hold.0 * fps).max(1.0) as usize;
        let mut stroke: Option<(usize, usize)> = None;
        let mut at = start;
        let within = |m: &Move| Move { start: m.start.max(start), peak: m.peak, end: m.end.min(end) };
        for m in inner.iter().filter(|m| m.peak > start && m.peak < end).map(within) {
            let gap = m.start.saturating_sub(at);
            match stroke {
                Some((from, _)) if gap < long => stroke = Some((from, m.end)),
                Some((from, to)) => {
                    self.tell(Phase::Stroke, from, to);
                    self.tell(Phase::Hold, to, m.start);
                    stroke = Some((m.start, m.end));
                }
                None if gap < long => stroke = Some((at, m.end)),
                None => {
                    self.tell(Phase::Hold, at, m.start);
                    stroke = Some((m.start, m.end));
                }
            }
            at = m.end;
        }
        if let Some((from, to)) = stroke {
            self.tell(Phase::Stroke, from, to);
            at = to;
        }
        self.tell(Phase::Hold, at, end);
    }
}
