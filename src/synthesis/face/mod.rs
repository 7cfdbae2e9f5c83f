//! Non-manual tiers: face morphs, and turns of head, trunk, shoulders and eyes.
//!
//! Three steps. [`lay_out`] makes *cues* of a tier's values: each a curve between a few keys of posture (`cue`, drawn by
//! `curve`, words by `mouthing`). [`Face`] sorts all cues of a clip by time and lets eyes and head agree. Then it is asked
//! frame by frame; where nothing is said, that is one look-up.
//!
//! Conventions: seconds from the clip's start, radians, the signer's left and right.

mod cue;
mod curve;
mod index;
mod lay_out;
mod mouthing;

pub use cue::{Cue, NonManualState};
pub use index::Face;
pub use lay_out::{Scene, lay_out, lay_out_value};
