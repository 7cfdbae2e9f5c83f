//! The signing space before the regions of the body: where a hand is that is `close`, at ease or `extended` there.
//!
//! A placement at the trunk, the neck or the head as a whole that touches nothing is no point over the skin but a height before the
//! body; how far out and to the sides was measured on the field's reference engine of HamNoSys (docs/reference.md).

use crate::phonology::Distance;

/// One hand before the middle of the body is a little to its own side, arm lengths.
pub const ONE_HAND_ARMS: f64 = 0.01;

/// How much farther before the body two hands meet than one hand is, arm lengths.
pub const MEETING_OUT_ARMS: f64 = 0.016;

/// The signing space before a region of the body: how far out it is, and how far to the sides; arm lengths from the middle of
/// the shoulders.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Before {
    /// Out of the body.
    pub out: f64,
    /// To a side that is said.
    pub at: f64,
    /// Beside it.
    pub beside: f64,
    /// Each of two hands of which no side is said.
    pub apart: f64,
}

/// Where a hand is that is somewhere before a region; `None` where its distance is from the skin.
///
/// ```
/// use chereme::{body::signing_space::before_the_body, phonology::Distance};
/// let [near, far] = [Distance::Close, Distance::Extended].map(|d| before_the_body(d).unwrap().out);
/// assert!(near < far && before_the_body(Distance::Touch).is_none());
/// ```
pub fn before_the_body(distance: Distance) -> Option<Before> {
    match distance {
        Distance::Close => Some(Before { out: 0.74, at: 0.29, beside: 0.61, apart: 0.18 }),
        Distance::Unmarked => Some(Before { out: 0.88, at: 0.33, beside: 0.65, apart: 0.26 }),
        Distance::Extended => Some(Before { out: 1.02, at: 0.38, beside: 0.70, apart: 0.42 }),
        Distance::Touch | Distance::Neutral | Distance::Metres(_) => None,
    }
}
