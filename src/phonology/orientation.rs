//! Hand orientation: where the fingers point and where the palm faces.

use super::direction::Heading;

/// Extended-finger direction and palm, each a direction in space.
///
/// The finger direction runs from the wrist to the middle knuckle. The palm is projected onto the plane
/// across the fingers. What is not stated stays as it was at the key before.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, Default)]
pub struct Orientation {
    /// Where the (stretched) fingers point.
    pub fingers: Option<Heading>,
    /// Where the palm faces.
    pub palm: Option<Heading>,
    /// Relative to the path instead of to the signer (HamNoSys `hamorirelative`): the hand turns with the movement.
    pub along_path: bool,
}
