//! One integration binary; the tree mirrors `src/`.
mod format_glb;
