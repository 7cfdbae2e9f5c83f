//! The names that a description may use: handshapes, places, non-manual values.
//!
//! Filled from the inventories of `grammar/`; plain names here, so that `notation` knows no joints and no landmarks.

use super::suggest::{fold, nearest};
use crate::phonology::Channel;
use std::collections::{BTreeMap, HashMap};

/// Names with their aliases, each leading to an id.
#[derive(Debug, Clone, Default)]
pub struct Names {
    ids: Vec<String>,
    exact: HashMap<String, usize>,
    /// Lower case without accents; `None` where two ids share it.
    folded: BTreeMap<String, Option<usize>>,
}

impl Names {
    /// Adds an id and its other names. An id found before keeps its names: the first source wins.
    pub fn add<'a>(&mut self, id: &'a str, aliases: impl IntoIterator<Item = &'a str>) {
        let index = self.ids.len();
        self.ids.push(id.to_owned());
        for name in std::iter::once(id).chain(aliases) {
            let name = name.split_whitespace().collect::<Vec<_>>().join(" ");
            // An id always means itself, even where an earlier one has it as an alias.
            if name == id {
                self.exact.insert(name.clone(), index);
            }
            self.exact.entry(name.clone()).or_insert(index);
            self.folded.entry(fold(&name)).and_modify(|at| *at = at.filter(|i| *i == index)).or_insert(Some(index));
        }
    }

    /// The id of a name: exactly as written, else in any case where that is one.
    pub fn id(&self, name: &str) -> Option<&str> {
        let exact = self.exact.get(name).copied();
        let index = exact.or_else(|| self.folded.get(&fold(name)).copied().flatten())?;
        self.ids.get(index).map(String::as_str)
    }

    /// The known name nearest to a mistyped one.
    pub fn nearest(&self, name: &str) -> Option<&str> {
        // Aliases first come out in no order; sorted, the answer is always the same.
        let mut names: Vec<&str> = self.exact.keys().map(String::as_str).collect();
        names.sort_unstable();
        nearest(name, names)
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

    /// The id of a handshape. In a language its own aliases come first: `S` in `lsf` is `LSF S`.
    pub fn handshape(&self, name: &str, language: &str) -> Option<&str> {
        if !language.is_empty()
            && let Some(id) = self.handshapes.id(&format!("{} {name}", language.to_uppercase()))
        {
            return Some(id);
        }
        self.handshapes.id(name)
    }

    /// Whether there are two of a place, left and right.
    pub fn is_paired(&self, place: &str) -> bool {
        self.places.id(place).is_some_and(|id| self.paired.iter().any(|p| p == id))
    }

    /// Adds a non-manual value.
    pub fn add_nonmanual<'a>(&mut self, channel: Channel, id: &'a str, aliases: impl IntoIterator<Item = &'a str>) {
        self.nonmanuals.entry(channel).or_default().add(id, aliases);
    }
}
