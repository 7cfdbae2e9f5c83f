//! One integration binary; the tree mirrors `src/`.
mod format_glb;
mod format_glb_write;
mod format_html;
