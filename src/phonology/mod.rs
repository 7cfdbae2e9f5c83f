//! The phonology of signs: hand configuration, placement, orientation, movement, non-manuals.
//!
//! One model for every notation. It was shaped with the whole of HamNoSys 4 at hand, so that reading
//! HamNoSys or SiGML adds a reader and not a second model.
//!
//! # Conventions
//! Hands are *strong* (dominant) and *weak*; *left* and *right*, *up*, *out* are the signer's. Sizes are
//! metres, angles radians, as everywhere inside the program. Names of handshapes, places and
//! non-manual values are data (`grammar/`); what code branches on is a closed enum.
//!
//! This module knows no rig and no frames.

pub mod configuration;
pub mod direction;
pub mod distance;
pub mod expression;
pub mod grammar;
pub mod hand;
pub mod handshape;
pub mod label;
pub mod location;
mod location_table;
pub mod movement;
pub mod movement_table;
pub mod nonmanual;
pub mod operator;
pub mod orientation;
pub mod placement;
pub mod recombination;
pub(crate) mod reflection;
pub mod roll;
pub mod sampa;
pub mod sign;
pub mod symmetry;

pub use configuration::{Bend, Between, Configuration, HandshapeChange, Opening, ThumbPosition};
pub use direction::{Direction, Heading};
pub use hand::{Digit, Digits, Flank, Hand, HandPart, HandPoint, Side};
pub use handshape::{HandAngles, Handshape, HandshapeInventory};
pub use location::{Location, LocationInventory, LocationKind};
pub use movement::{
    Action, Becoming, Clock, Extent, Manner, Motion, Movement, Overlay, Repeated, Repetition, RepetitionKind, Shift,
    Size, WristMotion,
};
pub use nonmanual::{Amount, Channel, NonManual, NonManualValue};
pub use orientation::Orientation;
pub use placement::{Contact, ContactKind, Distance, Forced, Lateral, Place, Placement, Relocation, Sited, Space};
pub use sign::{Attested, Hands, Keys, Manual, Relation, Sign, Symmetry};
