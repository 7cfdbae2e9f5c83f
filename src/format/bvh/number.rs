//! Decimal numbers from bytes, exact to the last bit and fast.
//!
//! Most numbers of a BVH file have few digits. If the digits without their point are a whole number below 2⁵³ and at
//! most 22 places are to be shifted, both that number and the power of ten are exact in an `f64`, so one
//! multiplication or division rounds correctly (Clinger, "How to read floating point numbers accurately", PLDI 1990).
//! Everything else goes through the standard library, which is correct for any length.

/// Powers of ten that are exact in an `f64`.
const TENS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20,
    1e21, 1e22,
];

/// The number that `bytes` start with and how many bytes it takes, or `None` where they start with none.
///
/// Takes `[+-] digits [. digits] [e [+-] digits]`, where one of the two runs of digits may be empty. A number beyond
/// the range of `f64` is infinite; what follows the number is for the caller to judge.
#[inline(always)]
pub(super) fn number(bytes: &[u8]) -> Option<(f64, usize)> {
    let mut at = 0;
    let negative = match bytes.first() {
        Some(b'-') => {
            at = 1;
            true
        }
        Some(b'+') => {
            at = 1;
            false
        }
        _ => false,
    };
    let mut digits = 0u64;
    let begin = at;
    while let Some(d) = bytes.get(at).map(|b| b.wrapping_sub(b'0')).filter(|d| *d < 10) {
        digits = digits.wrapping_mul(10).wrapping_add(u64::from(d));
        at += 1;
    }
    let mut count = at - begin;
    let mut places = 0;
    if bytes.get(at) == Some(&b'.') {
        at += 1;
        let fraction = at;
        while let Some(d) = bytes.get(at).map(|b| b.wrapping_sub(b'0')).filter(|d| *d < 10) {
            digits = digits.wrapping_mul(10).wrapping_add(u64::from(d));
            at += 1;
        }
        places = at - fraction;
        count += places;
    }
    if count == 0 {
        return None;
    }
    let mut exponent = 0;
    if matches!(bytes.get(at), Some(b'e' | b'E')) {
        (exponent, at) = exponent_at(bytes, at);
    }
    // 19 digits always fit 64 bits; a number with more may have wrapped.
    let shift = exponent - places as i64;
    if count <= 19 && digits <= 1 << 53 && shift.unsigned_abs() < TENS.len() as u64 {
        let power = TENS[shift.unsigned_abs() as usize];
        let value = if shift < 0 { digits as f64 / power } else { digits as f64 * power };
        return Some((if negative { -value } else { value }, at));
    }
    let value = std::str::from_utf8(&bytes[..at]).ok()?.parse().ok()?;
    Some((value, at))
}

/// The exponent that begins at `e`, and where it ends; an `e` without digits is no exponent and is left where it is.
#[cold]
fn exponent_at(bytes: &[u8], e: usize) -> (i64, usize) {
    let negative = bytes.get(e + 1) == Some(&b'-');
    let first = e + 1 + usize::from(matches!(bytes.get(e + 1), Some(b'+' | b'-')));
    let mut exponent = 0i64;
    let mut at = first;
    while let Some(b) = bytes.get(at).filter(|b| b.is_ascii_digit()) {
        exponent = exponent.saturating_mul(10).saturating_add(i64::from(b - b'0')).min(1 << 40);
        at += 1;
    }
    if at == first { (0, e) } else { (if negative { -exponent } else { exponent }, at) }
}
