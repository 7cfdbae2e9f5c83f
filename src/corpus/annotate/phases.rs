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

/// How far a hand goes at least from one sign to the next, and its digits' ends in it, metres.
const LEADS_ON: (f64, f64) = (0.06, 0.03);

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

    /// Strokes with the transitions and holds between them.
    fn signing(&mut self, inner: &[Move], start: usize, end: usize, options: &Options) {
        let long = (options.hold.0 * self.signals.fps.get()).max(1.0) as usize;
        let within = |m: &Move| Move { start: m.start.max(start), peak: m.peak, end: m.end.min(end) };
        let moves: Vec<Move> = inner.iter().filter(|m| m.peak > start && m.peak < end).map(within).collect();
        let mut spans: Vec<(Phase, usize, usize)> = Vec::new();
        let mut at = start;
        for (n, m) in moves.iter().enumerate() {
            let leads_on = n > 0 && n + 1 < moves.len() && self.leads_on(m);
            let phase = if leads_on { Phase::Transition } else { Phase::Stroke };
            let held = m.start.saturating_sub(at) >= long;
            if held {
                spans.push((Phase::Hold, at, m.start));
            }
            match spans.last_mut() {
                Some((before, _, to)) if *before == phase && !held => *to = m.end,
                _ => spans.push((phase, if held { m.start } else { at }, m.end)),
            }
            at = m.end;
        }
        spans.push((Phase::Hold, at, end));
        spans.into_iter().for_each(|(phase, from, to)| self.tell(phase, from, to));
    }

    /// Whether a move looks like the way from one sign to the next: the hand goes far, and comes there with another shape. A guess:
    /// nothing but the language tells signs apart for certain.
    fn leads_on(&self, of: &Move) -> bool {
        let Move { start, end, .. } = *of;
        let far = self.signals.palm[start].distance(self.signals.palm[end]);
        let formed = self.signals.forms[start].tips_apart(&self.signals.forms[end]);
        far > LEADS_ON.0 && formed > LEADS_ON.1
    }
}
