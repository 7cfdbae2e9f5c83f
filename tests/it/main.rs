//! One integration binary; the tree mirrors `src/`.
mod body_hand;
mod body_skin;
mod format_glb;
mod phonology_handshape;

mod motion_arm;
mod motion_easing;
mod motion_fabrik;
mod motion_profile;
mod motion_rotation;
mod format_glb_write;
mod format_html;
