//! Names of glosses, recordings and signers, and the segments that have them.

use super::NONE;
use super::postings::Postings;
use crate::phonology::grammar::fold;
use std::collections::BTreeMap;

/// What queries name.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::corpus) enum Named {
    Gloss,
    Recording,
    Signer,
}

/// Names of glosses, recordings or signers, and the segments of each; spellings that differ in case are one name.
#[derive(Debug, Clone, PartialEq)]
pub(in crate::corpus) struct Names {
    /// Folded names and their numbers.
    by_name: BTreeMap<String, u32>,
    /// For each gloss or recording, the number of its name; [`NONE`] where it has none.
    numbers: Vec<u32>,
    segments: Postings,
}

impl Names {
    /// The names of things, and of which thing each segment is.
    pub(super) fn of<'a>(names: impl Iterator<Item = Option<&'a str>>, things: &[u32]) -> Names {
        let mut by_name = BTreeMap::new();
        let number = |name: Option<&str>| {
            let next = by_name.len() as u32;
            name.map_or(NONE, |name| *by_name.entry(fold(name)).or_insert(next))
        };
        let numbers: Vec<u32> = names.map(number).collect();
        let own = things.iter().map(|thing| numbers.get(*thing as usize).copied().unwrap_or(NONE));
        let segments = Postings::one_each(own, by_name.len());
        Names { by_name, numbers, segments }
    }

    /// The number of a folded name.
    pub(in crate::corpus) fn number(&self, folded: &str) -> Option<u32> {
        self.by_name.get(folded).copied()
    }

    /// The number of a thing's name; `None` where it has none, or is not there.
    pub(super) fn of_thing(&self, thing: u32) -> Option<u32> {
        self.numbers.get(thing as usize).copied().filter(|n| *n != NONE)
    }

    /// The segments of a name.
    pub(in crate::corpus) fn segments(&self, number: u32) -> &[u32] {
        self.segments.of(number as usize)
    }
}
