//! From a described sign to motion, channel by channel (Naert et al. 2021, §3–6; docs/DESIGN.md, "Synthesis").

pub mod legs;
pub mod path;
