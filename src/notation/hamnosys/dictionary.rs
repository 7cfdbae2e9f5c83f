//! What HamNoSys and SiGML call the things of our inventories, and back: handshapes, places, non-manual values.
//!
//! Made once from the inventories of `grammar/`; reading and writing signs only looks things up.

use super::syntax::{Phase, Shape, ShapeClass, Split};
use super::{lex, parse};
use crate::diagnostics::Span;
use crate::phonology::expression::Expressions;
use crate::phonology::handshape::HandshapeInventory;
use crate::phonology::{Channel, LocationInventory, LocationKind};
use std::collections::HashMap;
use std::sync::OnceLock;

/// Names on both sides.
#[derive(Debug, Clone, Default)]
pub struct Dictionary {
    /// Handshapes of the inventory that HamNoSys can write, in the inventory's order, one a shape.
    shapes: Vec<(Shape, String)>,
    /// The same by id.
    shape_of: HashMap<String, Shape>,
    /// The inventory, which knows the other names.
    handshapes: HandshapeInventory,
    /// Names of plain classes.
    classes: HashMap<ShapeClass, String>,
    /// Places by tag without `ham`.
    places: HashMap<String, (String, LocationKind)>,
    /// Tags of places without `ham`, by id.
    tag_of: HashMap<String, String>,
    /// Non-manual values by channel and tag.
    values: HashMap<(Channel, String), String>,
    /// Tags by channel and name.
    value_tags: HashMap<(Channel, String), String>,
}

impl Dictionary {
    /// The program's own inventories; made at the first call.
    pub fn builtin() -> &'static Dictionary {
        static BUILTIN: OnceLock<Dictionary> = OnceLock::new();
        BUILTIN.get_or_init(|| {
            Dictionary::of(&HandshapeInventory::builtin(), &LocationInventory::builtin(), &Expressions::embedded())
        })
    }

    /// A dictionary of inventories. Handshapes whose symbols are no HamNoSys are left out.
    ///
    /// ```
    /// use chereme::notation::hamnosys::Dictionary;
    /// use chereme::notation::hamnosys::syntax::{Shape, ShapeClass};
    /// assert_eq!(Dictionary::builtin().handshape(&Shape::of(ShapeClass::Flat)), Some("flat"));
    /// ```
    pub fn of(handshapes: &HandshapeInventory, places: &LocationInventory, expressions: &Expressions) -> Dictionary {
        let mut all = Dictionary { handshapes: handshapes.clone(), ..Dictionary::default() };
        for row in handshapes.shapes() {
            let Some(shape) = shape_of_tags(&row.hamnosys.join(" ")) else { continue };
            let plain = shape == Shape::of(shape.main.class);
            if plain {
                all.classes.entry(shape.main.class).or_insert_with(|| row.id.clone());
            }
            all.shape_of.insert(row.id.clone(), shape.clone());
            if !all.shapes.iter().any(|(known, _)| *known == shape) {
                all.shapes.push((shape, row.id.clone()));
            }
        }
        for row in places.rows() {
            let tag = row.tag.trim_start_matches("ham").to_owned();
            all.places.insert(tag.clone(), (row.id.clone(), row.kind));
            for name in row.names() {
                all.tag_of.insert(crate::phonology::grammar::fold(name), tag.clone());
            }
        }
        for channel in Channel::ALL {
            for row in expressions.of(channel) {
                for tag in row.hamnosys.split_whitespace() {
                    all.values.entry((channel, tag.to_owned())).or_insert_with(|| row.name.clone());
                }
                let Some(first) = row.hamnosys.split_whitespace().next() else { continue };
                for name in std::iter::once(&row.name).chain(&row.aliases) {
                    all.value_tags.entry((channel, name.to_lowercase())).or_insert_with(|| first.to_owned());
                }
            }
        }
        all
    }

    /// The handshape of the inventory that a shape is; `hametc` and the order of change aside.
    pub fn handshape(&self, shape: &Shape) -> Option<&str> {
        self.shapes.iter().find(|(known, _)| known == shape).map(|(_, id)| id.as_str())
    }

    /// The handshape of a class without anything more.
    pub fn class(&self, class: ShapeClass) -> Option<&str> {
        self.classes.get(&class).map(String::as_str)
    }

    /// How HamNoSys writes a handshape of the inventory, by any of its names in a language.
    ///
    /// ```
    /// use chereme::notation::hamnosys::Dictionary;
    /// let dictionary = Dictionary::builtin();
    /// assert_eq!(dictionary.shape("S", None), dictionary.shape("fist-s", None));
    /// assert_eq!(dictionary.shape("M", Some("lsf")), dictionary.shape("M-lsf", None));
    /// ```
    pub fn shape(&self, name: &str, language: Option<&str>) -> Option<&Shape> {
        let row = self.handshapes.find(name, language).ok()?;
        self.shape_of.get(&row.id)
    }

    /// The place of a tag without `ham`, by its id, and what sort of place it is.
    pub fn place(&self, tag: &str) -> Option<(&str, LocationKind)> {
        self.places.get(tag).map(|(id, kind)| (id.as_str(), *kind))
    }

    /// The tag without `ham` of a place by one of its names.
    pub fn place_tag(&self, name: &str) -> Option<&str> {
        self.tag_of.get(&crate::phonology::grammar::fold(name)).map(String::as_str)
    }

    /// The non-manual value of a tag.
    pub fn value(&self, channel: Channel, tag: &str) -> Option<&str> {
        self.values.get(&(channel, tag.to_owned())).map(String::as_str)
    }

    /// The tag of a non-manual value.
    pub fn value_tag(&self, channel: Channel, name: &str) -> Option<&str> {
        self.value_tags.get(&(channel, name.to_lowercase())).map(String::as_str)
    }

    /// The tags of a channel, sorted.
    pub fn tags(&self, channel: Channel) -> Vec<&str> {
        let mut all: Vec<&str> =
            self.values.keys().filter(|(c, _)| *c == channel).map(|(_, tag)| tag.as_str()).collect();
        all.sort_unstable();
        all
    }
}

/// The shape that a list of tags says, where it says one and nothing else.
fn shape_of_tags(tags: &str) -> Option<Shape> {
    let (tokens, faults) = lex::lex(tags);
    if tokens.is_empty() || !faults.is_empty() {
        return None;
    }
    let end = Span::new(tags.len(), tags.len());
    let [phase] = <[Phase; 1]>::try_from(parse::phases(&tokens, end).0?).ok()?;
    let Some(Split::Both(shape)) = phase.posture.shape else { return None };
    let alone = phase.posture.fingers.is_none() && phase.posture.palm.is_none() && phase.location.is_none();
    (alone && phase.actions.is_empty()).then_some(shape)
}
