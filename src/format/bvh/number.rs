//! Decimal numbers from bytes, exact to the last bit and fast.
//!
//! Most numbers of a BVH file have few digits. If the digits without their point are a whole number below 2⁵³ and at
//! most 22 places are to be shifted, both that number and the power of ten are exact in an `f64`, so one
//! multiplication or division rounds correctly (Clinger, "How to read floating point numbers accurately", PLDI 1990).
//! Everything else goes through the standard library, which is correct for any length.
//!
//! [`few_digits`] does this for numbers of fewer than 16 characters all at once instead of character by character: sixteen
//! bytes are one `u128`, in which the point and the end are found, the point is taken out and the digits are added up
//! by pairs, fours and eights (Lemire, "Number parsing at a gigabyte per second", Software: Practice and Experience
//! 51, 2021, section 4, has the last step). It does not branch on how long a number is, which no processor guesses.

/// Powers of ten that are exact in an `f64`.
const TENS: [f64; 23] = [
    1e0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6, 1e7, 1e8, 1e9, 1e10, 1e11, 1e12, 1e13, 1e14, 1e15, 1e16, 1e17, 1e18, 1e19, 1e20,
    1e21, 1e22,
];

/// A short number at a place and where it ends, if a blank or the end of its line comes right after it.
///
/// Takes `[-] digits [. digits]` of at most 15 digits, where one of the two runs may be empty. `None` says nothing about
/// what is there: it may be longer, have an exponent or a `+`, end the text, or be no number.
#[inline(always)]
pub(super) fn few_digits(bytes: &[u8], at: usize) -> Option<(f64, usize)> {
    let negative = *bytes.get(at)? == b'-';
    let at = at + usize::from(negative);
    let text = bytes.get(at..)?.first_chunk::<16>()?;
    let digits = u128::from_le_bytes(*text) ^ each(b'0');
    // The highest bit of each byte that is no digit.
    let others = (((digits & each(0x7f)) + each(0x76)) | digits) & each(0x80);
    let after_first = others & others.wrapping_sub(1);
    let point = others.trailing_zeros() / 8;
    let has_point = text[point as usize % 16] == b'.';
    let end = if has_point { after_first.trailing_zeros() / 8 } else { point };
    let count = end - u32::from(has_point);
    if end == 16 || count == 0 || !matches!(text[end as usize % 16], b' ' | b'\n' | b'\r' | b'\t') {
        return None;
    }
    // All bits of the bytes before the point.
    let before = ((others ^ after_first).wrapping_sub(1)) >> 7;
    let joined = (digits & before) | (if has_point { digits >> 8 } else { digits } & !before);
    // The last digit in the last byte, zeros before the first.
    let value = sixteen(joined << (8 * (16 - count)));
    let value = value as f64 / TENS[(count - point) as usize];
    Some((if negative { -value } else { value }, at + end as usize))
}

/// A byte, sixteen times.
const fn each(byte: u8) -> u128 {
    u128::from_le_bytes([byte; 16])
}

/// The number of sixteen digits, each a byte from 0 to 9, the first in the lowest.
#[inline(always)]
fn sixteen(digits: u128) -> u64 {
    eight(digits as u64) * 100_000_000 + eight((digits >> 64) as u64)
}

/// The number of eight digits: neighbours become pairs, these fours, these eight.
#[inline(always)]
fn eight(digits: u64) -> u64 {
    let pairs = (digits * 10 + (digits >> 8)) & 0x00ff_00ff_00ff_00ff;
    let fours = (pairs * 100 + (pairs >> 16)) & 0x0000_ffff_0000_ffff;
    (fours * 10_000 + (fours >> 32)) & 0xffff_ffff
}

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
