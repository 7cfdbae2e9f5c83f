//! The analyses of the paper, on our own material: how captured motion moves, how synthesized motion compares, and what people say of it
//! (Naert et al. 2021, §4.2, §5.2, §7).

pub mod annotation;
pub mod interpolation;
pub mod kinematics;
pub mod lags;
pub mod ratings;
pub mod statistics;
pub mod stimuli;
