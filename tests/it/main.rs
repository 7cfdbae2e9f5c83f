//! One integration binary; the tree mirrors `src/`.
mod format_glb;
mod format_glb_write;
mod format_html;
mod layers;
mod motion_arm;
mod motion_easing;
mod motion_fabrik;
mod motion_profile;
mod motion_rotation;
mod phonology_tables;
mod shared;
