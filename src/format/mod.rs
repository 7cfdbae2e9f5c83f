//! File formats: bytes to plain data and back, one format a file.
//!
//! Readers take any bytes and answer with data or an [`Error`](crate::diagnostics::Error); writers
//! return bytes or text. Nothing here opens a file or knows what a sign is.

pub mod bvh;
mod cells;
pub mod csv;
pub mod eaf;
pub mod glb;
pub mod html;
pub mod markers;
pub mod profile_plot;
pub mod questionnaire;
pub mod segments;
pub mod svg;
pub mod text;
pub mod textgrid;
mod told;
