//! One mistake a file in `tests/suite/errors`, named by its message, with the rendered diagnostics beside it.

use crate::golden;
use chereme::diagnostics::render::render;
use chereme::notation::suggest::nearest;
use chereme::notation::{Vocabulary, read, source_of_bytes};
use proptest::collection;
use proptest::prelude::*;

#[test]
fn each_mistake_has_its_message() {
    let vocabulary = Vocabulary::builtin();
    golden::beside("errors", "sign", 40, |name, bytes| {
        let (source, fault) = source_of_bytes(name, bytes);
        let mut reading = read(&source.text, &vocabulary, "");
        reading.diagnostics.extend(fault);
        assert!(!reading.diagnostics.is_empty(), "{name} has no fault");
        reading.diagnostics.iter().map(|d| render(d, &source, false) + "\n\n").collect()
    });
}

/// Letters left out, put in, exchanged or swapped with the next, counted the long way.
fn slips(a: &[u8], b: &[u8]) -> usize {
    let (Some((x, rest_a)), Some((y, rest_b))) = (a.split_first(), b.split_first()) else { return a.len() + b.len() };
    if x == y {
        return slips(rest_a, rest_b);
    }
    let mut least = slips(rest_a, rest_b).min(slips(rest_a, b)).min(slips(a, rest_b)) + 1;
    if let (Some(next_a), Some(next_b)) = (rest_a.first(), rest_b.first())
        && x == next_b
        && y == next_a
    {
        least = least.min(slips(&rest_a[1..], &rest_b[1..]) + 1);
    }
    least
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 256, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn the_nearest_word_is_the_nearest(word in "[abc]{2,6}", known in collection::vec("[abc]{2,6}", 1..8)) {
        let far = |other: &str| slips(word.as_bytes(), other.as_bytes());
        let near = nearest(&word, known.iter().map(String::as_str));
        let least = known.iter().map(|other| far(other)).min().filter(|least| *least <= (word.len() / 3).max(1));
        prop_assert_eq!(near.map(far), least, "{:?}", near);
    }
}
