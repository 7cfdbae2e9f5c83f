//! Numbers as text with a fixed number of decimals.

/// Decimals of offsets, positions and angles: half a unit of the last one is 5 nm of our centimetres, 9e-9 rad of degrees.
const DECIMALS: usize = 6;
const SCALE: f64 = 1e6;
const UNIT: u64 = 1_000_000;

/// Writes a finite number with six decimals, or with none where all six are 0.
pub(super) fn push(out: &mut Vec<u8>, value: f64) {
    let scaled = (value * SCALE).round();
    // Beyond this, neighbouring numbers are a millionth apart already.
    if scaled.abs() >= 9e15 {
        out.extend_from_slice(format!("{value}").as_bytes());
        return;
    }
    if scaled < 0.0 {
        out.push(b'-');
    }
    let all = scaled.abs() as u64;
    let (mut whole, mut fraction) = (all / UNIT, all % UNIT);
    let mut digits = [b'0'; 24];
    let mut at = digits.len();
    if fraction != 0 {
        for _ in 0..DECIMALS {
            at -= 1;
            digits[at] = b'0' + (fraction % 10) as u8;
            fraction /= 10;
        }
        at -= 1;
        digits[at] = b'.';
    }
    loop {
        at -= 1;
        digits[at] = b'0' + (whole % 10) as u8;
        whole /= 10;
        if whole == 0 {
            break;
        }
    }
    out.extend_from_slice(&digits[at..]);
}
