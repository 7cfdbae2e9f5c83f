//! One integration binary; the tree mirrors `src/`.
mod format_glb;

mod motion_arm;
mod motion_easing;
mod motion_fabrik;
mod motion_profile;
mod motion_rotation;
mod notation_signs;
