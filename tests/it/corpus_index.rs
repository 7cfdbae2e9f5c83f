//! The index as bytes: the same back, any other bytes refused.

use crate::corpus_query::{VOCABULARY, recordings, some_segments};
use chereme::corpus::index::{Index, Postings};
use proptest::prelude::*;

proptest! {
    #![proptest_config(ProptestConfig { cases: 48, ..ProptestConfig::default() })]

    #[test]
    fn bytes_come_back_as_the_same_index(all in some_segments(0..30)) {
        let index = Index::build(&recordings(), &all, &VOCABULARY);
        let bytes = index.to_bytes();
        prop_assert_eq!(&bytes, &Index::build(&recordings(), &all, &VOCABULARY).to_bytes());
        prop_assert_eq!(Index::from_bytes(&bytes, &VOCABULARY).unwrap(), index);
    }

    #[test]
    fn damaged_bytes_are_refused(all in some_segments(1..10), at in any::<prop::sample::Index>(), bit in 0..8u8, cut in any::<prop::sample::Index>()) {
        let bytes = Index::build(&recordings(), &all, &VOCABULARY).to_bytes();
        let mut flipped = bytes.clone();
        flipped[at.index(bytes.len())] ^= 1 << bit;
        prop_assert!(Index::from_bytes(&flipped, &VOCABULARY).is_err());
        prop_assert!(Index::from_bytes(&bytes[..cut.index(bytes.len())], &VOCABULARY).is_err());
    }

    /// Bytes whose checksum was made to fit: they are read as something sound or refused, and never panic.
    #[test]
    fn forged_bytes_do_no_harm(
        all in some_segments(1..10),
        changes in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 1..4),
    ) {
        let mut bytes = Index::build(&recordings(), &all, &VOCABULARY).to_bytes();
        let body = bytes.len() - 8;
        for (at, byte) in changes {
            bytes[8 + at.index(body - 8)] = byte;
        }
        let sum = checksum(&bytes[..body]).to_le_bytes();
        bytes[body..].copy_from_slice(&sum);
        if let Ok(index) = Index::from_bytes(&bytes, &VOCABULARY) {
            prop_assert_eq!(Index::from_bytes(&index.to_bytes(), &VOCABULARY).unwrap(), index);
        }
    }

    #[test]
    fn any_bytes_do_no_harm(bytes in prop::collection::vec(any::<u8>(), 0..200)) {
        prop_assert!(Index::from_bytes(&bytes, &VOCABULARY).is_err());
    }

    #[test]
    fn lists_have_each_segment_once_and_sorted(things in prop::collection::vec(prop::collection::vec(0..6u32, 0..5), 0..40)) {
        let lists = Postings::several_each(things.len(), 5, |segment, put| things[segment].iter().for_each(|t| put(*t)));
        for thing in 0..6u32 {
            let expected: Vec<u32> =
                (0..things.len() as u32).filter(|s| thing < 5 && things[*s as usize].contains(&thing)).collect();
            prop_assert_eq!(lists.of(thing as usize), expected);
        }
    }
}

/// The checksum of the format, as `corpus::index` describes it: FNV-1a over words of eight bytes, then the rest.
fn checksum(bytes: &[u8]) -> u64 {
    const PRIME: u64 = 0x0100_0000_01B3;
    let words = bytes.chunks_exact(8);
    let rest = words.remainder();
    let sum = words.fold(0xCBF2_9CE4_8422_2325u64, |sum, word| {
        let sum = (sum ^ u64::from_le_bytes(word.try_into().unwrap())).wrapping_mul(PRIME);
        sum ^ (sum >> 32)
    });
    rest.iter().fold(sum, |sum, byte| (sum ^ u64::from(*byte)).wrapping_mul(PRIME))
}
