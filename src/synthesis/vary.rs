//! Small differences between performances: nobody signs twice in quite the same way.
//!
//! Times of strokes and transitions, and the place of signs in space, differ a little from item to item and from seed
//! to seed. What makes a sign that sign stays: contacts, configurations, orientations, the shape of the path. The
//! amounts are ours, meant to be seen and not to disturb; the paper notes that such noise may help (Naert et al. 2021,
//! §4.2, note 2).

use super::Options;
use glam::DVec3;
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};

/// At full variation times differ by this part, at one standard deviation.
const OF_TIME: f64 = 0.08;
/// At full variation places in space differ by this much along each axis, metres, at one standard deviation.
const OF_PLACE: f64 = 0.008;

/// How one item differs from its description.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Difference {
    /// The stroke's time is multiplied by it.
    pub stroke: f64,
    /// The time of the way there is multiplied by it.
    pub way: f64,
    /// A sign in space is moved by it, metres.
    pub place: DVec3,
}

/// How an item of a plan differs; not at all without variation.
pub(super) fn difference(options: &Options, item: usize) -> Difference {
    if options.variation <= 0.0 {
        return Difference { stroke: 1.0, way: 1.0, place: DVec3::ZERO };
    }
    let mut random = ChaCha8Rng::seed_from_u64(options.seed);
    random.set_stream(item as u64);
    let mut normal = || {
        // The sum of twelve even numbers is near enough to a normal one, and never far out.
        let sum: f64 = (0..12).map(|_| f64::from(random.next_u32()) / f64::from(u32::MAX)).sum();
        (sum - 6.0) * options.variation
    };
    let stroke = (OF_TIME * normal()).exp();
    let way = (OF_TIME * normal()).exp();
    let place = DVec3::new(normal(), normal(), normal()) * OF_PLACE;
    Difference { stroke, way, place }
}
