//! One integration binary; the tree mirrors `src/`.
mod body_hand;
mod format_glb;
mod phonology_handshape;
