//! TEMPORARY stand-in until the hands branch lands.
#![allow(missing_docs)]
use super::*;
use crate::diagnostics::Error;
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct HandAngles(pub [f64; 21]);
#[derive(Debug, Clone)]
pub struct HandshapeInventory { rows: Vec<(String, [f64; 21])> }
impl HandshapeInventory {
    pub fn builtin() -> Self {
        let mut rows = vec![];
        for l in include_str!("/work/shared/data/phonology/handshapes.tsv").lines().skip(1) {
            let c: Vec<&str> = l.split('\t').collect();
            rows.push((c[0].to_string(), std::array::from_fn(|i| c[6 + i].parse::<f64>().unwrap_or(0.0).to_radians())));
        }
        Self { rows }
    }
    pub fn angles(&self, c: &Configuration, _l: &str) -> Result<HandAngles, Error> {
        self.rows.iter().find(|r| r.0 == c.base).map(|r| HandAngles(r.1)).ok_or_else(|| Error::new(format!("no {}", c.base)))
    }
    pub fn touches_with(&self, _c: &Configuration, _l: &str) -> Result<HandPoint, Error> {
        Ok(HandPoint::of_digit(Digit::Index, HandPart::Tip).unwrap())
    }
}
