//! Moves: the stretches in which something changes, and the stops between them.
//!
//! A profile of speed has a move about each of its peaks; between two moves it falls to stillness, or to a valley that is
//! low against both peaks (hysteresis). What lies between two moves is a stop, which may be as short as the valley's lowest frame.

use crate::motion::profile::peaks;
use std::ops::RangeInclusive;

/// A stretch of change, frames.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Move {
    /// The last frame that is still before it.
    pub start: usize,
    /// The fastest frame.
    pub peak: usize,
    /// The first frame that is still after it.
    pub end: usize,
}

/// What counts as stillness, and as a move.
#[derive(Debug, Clone, Copy)]
pub(super) struct Thresholds {
    /// Slower than this is still.
    pub still: f64,
    /// The peak of a move is at least so fast.
    pub least: f64,
    /// A valley parts two moves that is this part of the lower peak at most.
    pub valley: f64,
}

/// The moves of a profile, in order.
pub(super) fn moves(profile: &[f64], thresholds: Thresholds) -> Vec<Move> {
    let Thresholds { still, least, valley } = thresholds;
    // Peaks that are parted from one another, the higher of two that are not.
    let mut kept: Vec<usize> = Vec::new();
    for peak in peaks(profile, least) {
        let mut peak = peak;
        while let Some(&last) = kept.last() {
            let lowest = profile[lowest(profile, last..=peak)];
            if lowest <= still.max(valley * profile[last].min(profile[peak])) {
                break;
            }
            peak = if profile[peak] > profile[last] { peak } else { last };
            kept.pop();
        }
        kept.push(peak);
    }
    let last = profile.len().saturating_sub(1);
    let between = |i: usize| lowest(profile, kept[i]..=kept[i + 1]);
    (0..kept.len())
        .map(|i| {
            let (from, to) =
                (if i == 0 { 0 } else { between(i - 1) }, if i + 1 == kept.len() { last } else { between(i) });
            let start = (from..kept[i]).rev().find(|f| profile[*f] <= still).unwrap_or(from);
            let end = (kept[i]..=to).find(|f| profile[*f] <= still).unwrap_or(to);
            Move { start, peak: kept[i], end }
        })
        .collect()
}

/// The lowest frame of a stretch, the first of equals.
pub(super) fn lowest(profile: &[f64], stretch: RangeInclusive<usize>) -> usize {
    let first = *stretch.start();
    stretch.reduce(|best, f| if profile[f] < profile[best] { f } else { best }).unwrap_or(first)
}

/// A stop: where it is best looked at, and for how long its value holds, frames.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) struct Stop {
    /// The stillest frame.
    pub at: usize,
    /// From the fastest frame before, or the stretch's start.
    pub from: usize,
    /// To the fastest frame after, or the stretch's end.
    pub to: usize,
}

/// The stops of a stretch of a profile: one before each of the moves that lie in it, and one after the last.
pub(super) fn stops(profile: &[f64], moves: &[Move], stretch: RangeInclusive<usize>) -> Vec<Stop> {
    let (first, last) = (*stretch.start(), *stretch.end());
    let inside: Vec<&Move> = moves.iter().filter(|m| m.peak > first && m.peak < last).collect();
    (0..=inside.len())
        .map(|i| {
            let before = i.checked_sub(1).map(|b| inside[b]);
            let after = inside.get(i);
            let (from, to) = (before.map_or(first, |m| m.peak), after.map_or(last, |m| m.peak));
            let (still_from, still_to) =
                (before.map_or(first, |m| m.end).clamp(from, to), after.map_or(last, |m| m.start).clamp(from, to));
            let at = if still_from <= still_to { lowest(profile, still_from..=still_to) } else { still_from };
            Stop { at, from, to }
        })
        .collect()
}
