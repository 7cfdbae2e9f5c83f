//! What is to be signed, in order: plans of signs, made from gloss lines and, later, from songs.
//!
//! A [`plan::Plan`] knows signs and not yet times: `synthesis::measure` says what each item takes, and whoever has a
//! clock to follow (a song, a recording) allots the times before `synthesis` renders them.

pub mod gloss;
pub mod plan;
