//! The names that a description may use: handshapes, places, non-manual values.
//!
//! Filled from the inventories of `grammar/`; plain names here, so that `notation` knows no joints and no landmarks.

use super::suggest::{fold, nearest};
use crate::phonology::expression::Expressions;
use crate::phonology::handshape::HandshapeInventory;
use crate::phonology::{Channel, LocationInventory, LocationKind};
use std::collections::BTreeMap;

/// Names with their aliases, each leading to an id. Case and accents do not matter.
#[derive(Debug, Clone, Default)]
pub struct Names {
    ids: Vec<String>,
    by_id: BTreeMap<String, usize>,
    by_alias: BTreeMap<String, Vec<usize>>,
    /// Letters without their language: `S` of `LSF S`.
    by_letter: BTreeMap<String, Vec<usize>>,
    written: Vec<String>,
}

/// What a name leads to.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Found<'n> {
    /// One id.
    One(&'n str),
    /// Several ids.
    Several(Vec<&'n str>),
    /// None.
    Unknown,
}

impl Names {
    /// Adds an id and its other names. `LSF S` also answers to `S`, where no other name does.
    pub fn add<'a>(&mut self, id: &str, aliases: impl IntoIterator<Item = &'a str>) {
        let index = self.ids.len();
        self.ids.push(id.to_owned());
        self.by_id.insert(fold(id), index);
        self.written.push(id.to_owned());
        let to = |map: &mut BTreeMap<String, Vec<usize>>, name: &str| {
            let all = map.entry(fold(name)).or_default();
            if !all.contains(&index) {
                all.push(index);
            }
        };
        for alias in aliases {
            to(&mut self.by_alias, alias);
            self.written.push(alias.to_owned());
            if let Some((language, letter)) = alias.split_once(' ')
                && language.len() >= 2
                && language.chars().all(char::is_uppercase)
            {
                to(&mut self.by_letter, letter);
            }
        }
    }

    /// What a name leads to: an id first, then an alias, then a letter of one language.
    pub fn find(&self, name: &str) -> Found<'_> {
        let name = fold(name);
        let id = |index: &usize| self.ids[*index].as_str();
        if let Some(index) = self.by_id.get(&name) {
            return Found::One(id(index));
        }
        match self.by_alias.get(&name).or_else(|| self.by_letter.get(&name)).map(Vec::as_slice) {
            None | Some([]) => Found::Unknown,
            Some([one]) => Found::One(id(one)),
            Some(several) => Found::Several(several.iter().map(id).collect()),
        }
    }

    /// The id of a name, where there is exactly one.
    pub fn id(&self, name: &str) -> Option<&str> {
        match self.find(name) {
            Found::One(id) => Some(id),
            Found::Several(_) | Found::Unknown => None,
        }
    }

    /// The known name nearest to a mistyped one.
    pub fn nearest(&self, name: &str) -> Option<&str> {
        nearest(name, self.written.iter().map(String::as_str))
    }

    /// The ids, in the order they were added.
    pub fn ids(&self) -> impl Iterator<Item = &str> {
        self.ids.iter().map(String::as_str)
    }

    /// Whether there is none: then every name is accepted.
    pub fn is_empty(&self) -> bool {
        self.ids.is_empty()
    }
}

/// All names that a description may use.
#[derive(Debug, Clone, Default)]
pub struct Vocabulary {
    /// Handshapes.
    pub handshapes: Names,
    /// Places on the body and in space.
    pub places: Names,
    /// Ids of places that there are two of: ears, cheeks.
    pub paired: Vec<String>,
    /// Non-manual values by channel.
    pub nonmanuals: BTreeMap<Channel, Names>,
}

impl Vocabulary {
    /// No names at all: every name is accepted unseen.
    pub fn open() -> Vocabulary {
        Vocabulary::default()
    }

    /// The names of the program's own inventories.
    ///
    /// ```
    /// use chereme::notation::{Vocabulary, vocabulary::Found};
    /// assert_eq!(Vocabulary::builtin().handshape("M", "lsf"), Found::One("M-lsf"));
    /// ```
    pub fn builtin() -> Vocabulary {
        Vocabulary::of(&HandshapeInventory::builtin(), &LocationInventory::builtin(), &Expressions::embedded())
    }

    /// The names of inventories.
    pub fn of(handshapes: &HandshapeInventory, places: &LocationInventory, expressions: &Expressions) -> Vocabulary {
        let mut all = Vocabulary::default();
        for shape in handshapes.shapes() {
            all.handshapes.add(&shape.id, shape.aliases.iter().map(String::as_str));
        }
        // Parts of the hand are written `other palm`, and are no names of places.
        for place in places.rows().iter().filter(|p| matches!(p.kind, LocationKind::Body | LocationKind::Space)) {
            all.places.add(&place.id, place.aliases.iter().map(String::as_str));
            if place.paired {
                all.paired.push(place.id.clone());
            }
        }
        for channel in Channel::ALL {
            for value in expressions.of(channel) {
                all.add_nonmanual(channel, &value.name, value.aliases.iter().map(String::as_str));
            }
        }
        all
    }

    /// The id of a handshape. In a language its own aliases come first: `S` in `lsf` is `LSF S`.
    pub fn handshape(&self, name: &str, language: &str) -> Found<'_> {
        if !language.is_empty()
            && let Some(own) = self.handshapes.by_alias.get(&fold(&format!("{language} {name}")))
            && let [one] = own.as_slice()
        {
            return Found::One(&self.handshapes.ids[*one]);
        }
        self.handshapes.find(name)
    }

    /// Whether there are two of a place, left and right.
    pub fn is_paired(&self, place: &str) -> bool {
        self.places.id(place).is_some_and(|id| self.paired.iter().any(|p| p == id))
    }

    /// Adds a non-manual value.
    pub fn add_nonmanual<'a>(&mut self, channel: Channel, id: &str, aliases: impl IntoIterator<Item = &'a str>) {
        self.nonmanuals.entry(channel).or_default().add(id, aliases);
    }
}
