//! A fast 64-bit hash of bytes: eight bytes are multiplied in at a time and the product's halves folded together (the
//! mixing step of wyhash, Wang Yi 2019). For telling damage and changes, not against forgers.

const STEP: u64 = 0xa076_1d64_78bd_642f;
const START: u64 = 0xe703_7ed1_a0b4_28db;

fn fold(a: u64, b: u64) -> u64 {
    let product = u128::from(a) * u128::from(b);
    (product >> 64) as u64 ^ product as u64
}

/// The hash of bytes.
///
/// ```
/// use chereme::corpus::cache::hash;
/// assert_eq!(hash(b"BOL"), hash(b"BOL"));
/// assert_ne!(hash(b"BOL"), hash(b"BOL\0"));
/// ```
pub fn hash(bytes: &[u8]) -> u64 {
    let mut state = START ^ bytes.len() as u64;
    let mut words = bytes.chunks_exact(8);
    for word in words.by_ref() {
        let word = u64::from_le_bytes(word.try_into().unwrap_or_default());
        state = fold(state ^ word, STEP).wrapping_add(word.rotate_left(32));
    }
    let mut last = [0; 8];
    last[..words.remainder().len()].copy_from_slice(words.remainder());
    let last = u64::from_le_bytes(last);
    fold(fold(state ^ last, STEP) ^ last.rotate_left(17), START)
}
