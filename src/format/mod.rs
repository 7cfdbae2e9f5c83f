//! File formats: bytes to plain data and back, one format a file.
//!
//! Readers take any bytes and answer with data or an [`Error`](crate::diagnostics::Error); writers
//! return bytes or text. Nothing here opens a file or knows what a sign is.

pub mod bvh;
pub mod csv;
pub mod eaf;
pub mod glb;
pub mod html;
pub mod profile_plot;
pub mod questionnaire;
pub mod svg;
