//! The places of the body, of space, and of the hands and arms, by name (`grammar/locations.ron`).
//!
//! One row a location of HamNoSys 4 (U+E040–U+E07A, 44 of them), with readable aliases, what a placement
//! means that says no distance, and how wide the region is.
//!
//! # Conventions
//! Names are NFC and case-insensitive; ids and aliases share one space of names. Widths are in arm lengths
//! (shoulder to elbow to wrist). Where a place lies on a body is not known here: no joints, no metres.
//!
//! A table is refused with all its faults at once where a name, tag or symbol stands twice, a symbol is not a
//! hexadecimal code point, a kind names an unknown part, or a width is negative or not a number.

use super::grammar::fold;
use super::hand::{Digit, HandPart};
use super::location_table;
use super::placement::Distance;
use crate::diagnostics::{Diagnostic, Source};
use std::collections::HashMap;

/// What sort of place a location is.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum LocationKind {
    /// A place on head or trunk.
    Body,
    /// A point in space before the signer.
    Space,
    /// A part of the (other) hand or arm as a whole.
    Limb(HandPart),
    /// A digit; which part of it is said apart.
    Digit(Digit),
    /// A part of a digit; which digit is said apart.
    Part(HandPart),
}

/// One row of the inventory.
#[derive(Debug, Clone, PartialEq)]
pub struct Location {
    /// The name, unique whatever the case.
    pub id: String,
    /// The French name with its article (`la joue`), for people; empty where the table gives none.
    pub french: String,
    /// Other names, just as unique.
    pub aliases: Vec<String>,
    /// The HamNoSys tag, such as `hamchest`.
    pub tag: String,
    /// The HamNoSys symbol, in the private use area.
    pub symbol: char,
    /// What sort of place it is.
    pub kind: LocationKind,
    /// The body has a left and a right one: a side chooses which, and is not a shift.
    pub paired: bool,
    /// The distance that a placement without one means; never [`Distance::Unmarked`].
    pub unmarked: Distance,
    /// The height of the signing space before the place, arm lengths above the middle of the shoulders, where the place also
    /// means that space: a hand that does not touch the trunk, the neck or the head as a whole is not over a point of
    /// its skin but at its height before the body.
    pub space: Option<f64>,
    /// Half the width of the region, arm lengths; 0 for places of hand and arm.
    pub half_width_arms: f64,
    /// A remark for the reader of a listing; may be empty.
    pub note: String,
    /// Remarks on single sign languages: (language, remark).
    pub languages: Vec<(String, String)>,
}

impl Location {
    /// How far to the side `left` and `right` of this place are: half of the half-width, arm lengths.
    pub fn at_arms(&self) -> f64 {
        0.5 * self.half_width_arms
    }

    /// How far to the side `left beside` and `right beside` this place are: one and a half half-widths, arm lengths.
    pub fn beside_arms(&self) -> f64 {
        1.5 * self.half_width_arms
    }
}

/// A checked table of locations.
///
/// ```
/// use chereme::phonology::location::{LocationInventory, LocationKind};
/// let inventory = LocationInventory::builtin();
/// let chest = inventory.get("Breast").unwrap();
/// assert_eq!((chest.id.as_str(), chest.tag.as_str(), chest.kind), ("chest", "hamchest", LocationKind::Body));
/// ```
#[derive(Debug, Clone)]
pub struct LocationInventory {
    rows: Vec<Location>,
    by_name: HashMap<String, usize>,
}

impl LocationInventory {
    /// The inventory that comes with the program.
    pub fn builtin() -> LocationInventory {
        LocationInventory::from_source(&LocationInventory::builtin_source())
            .unwrap_or_else(|faults| unreachable!("the embedded table is tested to be sound: {faults:?}"))
    }

    /// The text of the inventory that comes with the program.
    pub fn builtin_source() -> Source {
        Source::new("grammar/locations.ron", include_str!("../../grammar/locations.ron"))
    }

    /// Reads and checks a table.
    ///
    /// # Errors
    /// Every fault of the table, with its place in the text.
    pub fn from_source(source: &Source) -> Result<LocationInventory, Vec<Diagnostic>> {
        location_table::read(source).map(LocationInventory::of)
    }

    /// This inventory with the rows of another put in place of those with the same id, or added.
    ///
    /// # Errors
    /// One message a name, tag or symbol that two different rows would then have.
    pub fn overridden_by(&self, other: &LocationInventory) -> Result<LocationInventory, Vec<String>> {
        let mut rows = self.rows.clone();
        for row in &other.rows {
            match rows.iter_mut().find(|r| fold(&r.id) == fold(&row.id)) {
                Some(old) => *old = row.clone(),
                None => rows.push(row.clone()),
            }
        }
        let mut clashes = Vec::new();
        for (i, a) in rows.iter().enumerate() {
            for b in &rows[..i] {
                for name in a.names().filter(|n| b.names().any(|m| fold(m) == fold(n))) {
                    clashes.push(format!("\"{name}\" names both the place {} and the place {}", b.id, a.id));
                }
                if a.tag == b.tag || a.symbol == b.symbol {
                    clashes.push(format!("the places {} and {} have one HamNoSys symbol", b.id, a.id));
                }
            }
        }
        if clashes.is_empty() { Ok(LocationInventory::of(rows)) } else { Err(clashes) }
    }

    fn of(rows: Vec<Location>) -> LocationInventory {
        let by_name =
            rows.iter().enumerate().flat_map(|(i, row)| row.names().map(move |name| (fold(name), i))).collect();
        LocationInventory { rows, by_name }
    }

    /// The place of that id or alias, in any case.
    pub fn get(&self, name: &str) -> Option<&Location> {
        self.by_name.get(&fold(name)).map(|&i| &self.rows[i])
    }

    /// The place of that HamNoSys tag (`hamchest`).
    pub fn by_tag(&self, tag: &str) -> Option<&Location> {
        self.rows.iter().find(|row| row.tag == tag)
    }

    /// The place of that HamNoSys symbol.
    pub fn by_symbol(&self, symbol: char) -> Option<&Location> {
        self.rows.iter().find(|row| row.symbol == symbol)
    }

    /// All rows, in the order of the table.
    pub fn rows(&self) -> &[Location] {
        &self.rows
    }

    /// All ids and aliases, as written: what a "did you mean" chooses from.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        self.rows.iter().flat_map(Location::names)
    }
}

impl Location {
    /// The id, then the aliases.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        std::iter::once(self.id.as_str()).chain(self.aliases.iter().map(String::as_str))
    }
}
