//! Which channel of the hand ends first: the end of a configuration change and of a palm turn against the stop of the wrist.
//!
//! Synthesis lets the configuration of a transition end before the wrist does (the share 0.8 of it); here the same is measured of captured
//! takes. Each channel is cut from rest to rest by its own speed ([`super::kinematics::cut`]); a wrist movement is paired with the change of
//! configuration and the turn of the palm that go on at the same time.
//!
//! # Conventions
//! A lag is the end of the channel less the end of the wrist's movement, seconds: negative is earlier. A share is the
//! channel's end in the wrist's movement: 0 at its start, 1 at its stop. Ends are where the speed falls to the threshold, a share of the
//! movement's own peak, between frames. The palm is the whole rotation of the hand: turns of the forearm and bends of the wrist.

mod measure;
pub mod print;

pub use measure::find;

use super::statistics::bootstrap::{DRAWS, Estimate, Statistic, estimate};
use crate::time::Seconds;
use std::collections::BTreeMap;
use std::fmt;

/// What counts as a movement of a channel.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Rule {
    /// Rest is at most this share of a movement's own peak speed.
    pub rest: f64,
    /// Standard deviation of the Gaussian that paths are smoothed by.
    pub smoothing: Seconds,
    /// The least way of the wrist, metres.
    pub least_wrist: f64,
    /// The least way of the fingertips (root mean square of the five), metres.
    pub least_fingers: f64,
    /// The least turn of the palm, radians.
    pub least_turn: f64,
    /// The shortest and the longest duration of each.
    pub lasts: (Seconds, Seconds),
}

impl Default for Rule {
    fn default() -> Rule {
        Rule {
            rest: 0.1,
            smoothing: Seconds(0.02),
            least_wrist: 0.05,
            least_fingers: 0.015,
            least_turn: 0.25,
            lasts: (Seconds(0.1), Seconds(2.0)),
        }
    }
}

/// A channel that is held against the wrist.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Channel {
    /// The fingertips seen from the wrist.
    Configuration,
    /// The rotation of the hand.
    Palm,
}

impl Channel {
    /// Both.
    pub const ALL: [Channel; 2] = [Channel::Configuration, Channel::Palm];
}

impl fmt::Display for Channel {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Channel::Configuration => "configuration",
            Channel::Palm => "palm",
        })
    }
}

/// From when to when something moves, seconds from the take's start.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretch {
    /// Where its speed rises from rest.
    pub start: Seconds,
    /// Where its speed falls to rest.
    pub end: Seconds,
}

/// One movement of a wrist, with what the hand does at the same time.
#[derive(Debug, Clone, PartialEq)]
pub struct Stop {
    /// The take that it comes from.
    pub take: String,
    /// `Right` or `Left`.
    pub side: &'static str,
    /// The wrist's movement.
    pub wrist: Stretch,
    /// The change of configuration at the same time.
    pub configuration: Option<Stretch>,
    /// The turn of the palm at the same time.
    pub palm: Option<Stretch>,
}

impl Stop {
    /// What a channel does at the same time.
    pub fn of(&self, channel: Channel) -> Option<Stretch> {
        match channel {
            Channel::Configuration => self.configuration,
            Channel::Palm => self.palm,
        }
    }

    /// The end of a channel less the wrist's, seconds.
    pub fn lag(&self, channel: Channel) -> Option<f64> {
        self.of(channel).map(|own| own.end.0 - self.wrist.end.0)
    }

    /// Where the channel ends in the wrist's movement: 0 its start, 1 its stop.
    pub fn share(&self, channel: Channel) -> Option<f64> {
        let lasts = self.wrist.end.0 - self.wrist.start.0;
        self.of(channel).filter(|_| lasts > 0.0).map(|own| (own.end.0 - self.wrist.start.0) / lasts)
    }
}

/// What is said of two ends.
#[derive(Debug, Clone, PartialEq)]
pub struct Summary {
    /// Whose end: `configuration before wrist`.
    pub what: String,
    /// Median lag, seconds.
    pub lag: Option<Estimate>,
    /// Median share of the wrist's movement at which the channel ends; `None` where two channels are compared.
    pub share: Option<Estimate>,
    /// The share of movements in which it ends earlier.
    pub earlier: f64,
}

/// Medians with intervals over takes: each channel against the wrist, and configuration against palm; the seed is the bootstrap's.
///
/// ```
/// use chereme::{evaluation::lags::{Stop, Stretch, summarise}, time::Seconds};
/// let stretch = |start, end| Stretch { start: Seconds(start), end: Seconds(end) };
/// let stop = Stop { take: "t".into(), side: "Right", wrist: stretch(0.0, 1.0), configuration: Some(stretch(0.1, 0.75)), palm: None };
/// let summaries = summarise(&[stop], 0);
/// assert_eq!((summaries[0].lag.unwrap().value, summaries[0].share.unwrap().value), (-0.25, 0.75));
/// ```
pub fn summarise(stops: &[Stop], seed: u64) -> Vec<Summary> {
    let mut all: Vec<Summary> = Channel::ALL
        .into_iter()
        .map(|channel| {
            let share = over(stops, seed, |stop| stop.share(channel));
            summary(format!("{channel} against wrist"), stops, seed, share, |stop| stop.lag(channel))
        })
        .collect();
    let between = |stop: &Stop| Some(stop.configuration?.end.0 - stop.palm?.end.0);
    all.push(summary("configuration against palm".into(), stops, seed, None, between));
    all
}

fn summary(
    what: String,
    stops: &[Stop],
    seed: u64,
    share: Option<Estimate>,
    lag: impl Fn(&Stop) -> Option<f64>,
) -> Summary {
    let lags: Vec<f64> = stops.iter().filter_map(&lag).collect();
    let earlier = lags.iter().filter(|l| **l < 0.0).count() as f64 / lags.len().max(1) as f64;
    Summary { what, lag: over(stops, seed, lag), share, earlier }
}

fn over(stops: &[Stop], seed: u64, value: impl Fn(&Stop) -> Option<f64>) -> Option<Estimate> {
    let mut takes: BTreeMap<&str, Vec<f64>> = BTreeMap::new();
    stops.iter().for_each(|stop| takes.entry(&stop.take).or_default().extend(value(stop)));
    let clusters: Vec<Vec<f64>> = takes.into_values().collect();
    estimate(&clusters, Statistic::Median, DRAWS, seed)
}
