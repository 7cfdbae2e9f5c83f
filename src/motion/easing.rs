//! Easing between two poses (placeholder module comment, written out with the interpolation family).

use glam::DQuat;

/// Spherical linear interpolation along the short arc: Naert et al. 2021, equation 1.
///
/// Returns `from` exactly where the two are the same rotation (`q` and `−q` included).
pub fn slerp(from: DQuat, to: DQuat, w: f64) -> DQuat {
    let to = if from.dot(to) < 0.0 { -to } else { to };
    from.slerp(to, w).normalize()
}
