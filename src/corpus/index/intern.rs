//! Texts kept once, with a number each.

use std::collections::HashMap;

/// How many texts of late are remembered without the hash map.
const RECENT: usize = 4096;

/// Gives each text a number, in the order in which texts are first met.
///
/// The labels of a corpus are few and come again and again. A small table that forgets stands before the hash map, whose hash is slow
/// because it withstands texts made to collide.
#[derive(Default)]
pub(super) struct Interner<'a> {
    numbers: HashMap<&'a str, u32>,
    texts: Vec<&'a str>,
    recent: Vec<u32>,
}

impl<'a> Interner<'a> {
    /// The number of a text.
    pub(super) fn number(&mut self, text: &'a str) -> u32 {
        if self.recent.is_empty() {
            self.recent = vec![u32::MAX; RECENT];
        }
        let slot = quick_hash(text.as_bytes()) % RECENT;
        let recent = self.recent[slot];
        if self.texts.get(recent as usize).is_some_and(|known| *known == text) {
            return recent;
        }
        let next = self.texts.len() as u32;
        let number = *self.numbers.entry(text).or_insert(next);
        if number == next {
            self.texts.push(text);
        }
        self.recent[slot] = number;
        number
    }

    /// The texts, in the order of their numbers.
    pub(super) fn into_texts(self) -> Vec<String> {
        self.texts.into_iter().map(str::to_owned).collect()
    }
}

/// A hash of length, first and last eight bytes.
fn quick_hash(bytes: &[u8]) -> usize {
    let word = |part: &[u8]| part.iter().fold(0u64, |all, byte| all << 8 | u64::from(*byte));
    let (first, last) = (&bytes[..bytes.len().min(8)], &bytes[bytes.len().saturating_sub(8)..]);
    let mixed = (word(first) ^ word(last).rotate_left(23) ^ bytes.len() as u64).wrapping_mul(0x9E37_79B9_7F4A_7C15);
    (mixed >> 40) as usize
}
