//! One integration binary; the tree mirrors `src/`.
mod body_hand;
mod body_skin;
mod body_landmarks;
mod format_glb;
mod phonology_handshape;

mod cli;
mod format_glb_write;
mod format_html;
mod layers;
mod motion_arm;
mod motion_easing;
mod motion_fabrik;
mod motion_profile;
mod motion_rotation;
mod notation_errors;
mod notation_format;
mod notation_laws;
mod notation_lexicon;
mod notation_signs;
mod phonology_location;
mod phonology_orientation;
mod phonology_tables;
mod shared;
mod strategies;
