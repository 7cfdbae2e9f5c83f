//! A sign made from others, as written: names, and what is done with them.

use super::{Configuration, Duration, Movement, NonManual, Orientation, Place, Placement, Relocation};
use crate::diagnostics::Spanned;
use crate::phonology::{Channel, Hand};

/// A sign made from others, as written: `CLAIR inverted`.
#[derive(Debug, Clone, PartialEq)]
pub struct Expression {
    /// What it is made from.
    pub base: Base,
    /// What is done with that, one after the other.
    pub operators: Vec<Operator>,
}

/// What an expression begins with.
#[derive(Debug, Clone, PartialEq)]
pub enum Base {
    /// `CLAIR`
    Named(Spanned<String>),
    /// `spelled "OK"`
    Spelled(String),
    /// `pointing at PLACE`
    Pointing(Place),
    /// `wrist at 0.1 1.2 0.4`
    WristAt([f64; 3]),
    /// `A then B`
    Chain(Vec<Expression>),
    /// `A & B`
    Hands(Box<Expression>, Box<Expression>),
}

/// An operator as written; values after `with` stand at one key each, or spread.
#[derive(Debug, Clone, PartialEq)]
pub enum Operator {
    /// `inverted`
    Inverted,
    /// `inverted movement`
    InvertedMovement,
    /// `mirrored`
    Mirrored,
    /// `swapped`
    Swapped,
    /// `reflected`
    Reflected,
    /// `repeated 2 gap 0.2s growing`
    Repeated {
        /// Performances in all.
        times: u8,
        /// `gap 0.2s`
        gap: Option<Duration>,
        /// `growing`, `shrinking 2`
        growth: i8,
    },
    /// `with configuration U`
    Configuration(Option<Hand>, Vec<Configuration>),
    /// `with orientation fingers up`
    Orientation(Option<Hand>, Vec<Orientation>),
    /// `with weak placement chest`
    Placement(Option<Hand>, Vec<Placement>),
    /// `with movement up 10cm`
    Movement(Option<Hand>, Vec<Movement>),
    /// `with brows raised`
    NonManual(Channel, Vec<NonManual>),
    /// `at left, forced`
    At(Relocation),
    /// `speed 1.5`, `fast`, `slow`
    Speed(f64),
    /// `size 1.5`, `big`, `small`
    Size(f64),
}
