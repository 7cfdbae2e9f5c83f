//! The sign gesture track: motion and the tiers that say what it is.

use crate::motion::clip::Clip;
use crate::motion::curve::Phase;
use crate::tier::Tier;

/// The values of the Phase tiers, in the order in which signs have them; a transition leads from one sign to the next.
pub const PHASES: [&str; 5] = ["preparation", "transition", "stroke", "hold", "retraction"];

/// A clip with its tiers; what `synthesis` makes, `format` writes and `dance` moves to music.
///
/// Tiers are named `RH`/`LH` × Gloss, Phase, Configuration, Placement, Orientation, Movement, plus
/// Contact, Head, Torso, Gaze, Brows, Mouth where a sign has them.
#[derive(Debug, Clone)]
pub struct Track {
    /// The motion.
    pub clip: Clip,
    /// What the motion means, in the order they are shown.
    pub tiers: Vec<Tier>,
}

impl Track {
    /// The tier of that name, if there is one.
    pub fn tier(&self, name: &str) -> Option<&Tier> {
        self.tiers.iter().find(|t| t.name == name)
    }

    /// The phases that the tier of that name says, such as `RH Phase`; none where there is no such tier.
    pub fn phases(&self, name: &str) -> Vec<Phase> {
        let values = self.tier(name).map_or(&[][..], Tier::values);
        values.iter().map(|v| Phase { name: v.label.clone(), start: v.start, end: v.end }).collect()
    }
}
