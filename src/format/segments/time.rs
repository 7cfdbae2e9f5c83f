//! Times as tables have them: seconds, milliseconds, or hours, minutes and seconds with colons.

use crate::time::Seconds;

/// How a column of times is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Unit {
    /// Seconds, or with colons.
    Seconds,
    Milliseconds,
}

/// The time of a cell; `None` where it is none.
pub(super) fn time(text: &str, unit: Unit) -> Option<Seconds> {
    if text.contains(':') {
        return clock(text).map(Seconds);
    }
    let value = number(text)?;
    match unit {
        Unit::Seconds => Some(Seconds(value)),
        Unit::Milliseconds => Some(Seconds(value / 1000.0)),
    }
}

/// A finite number without words such as `inf`.
fn number(text: &str) -> Option<f64> {
    let plain = |b: u8| b.is_ascii_digit() || matches!(b, b'.' | b'-' | b'+' | b'e' | b'E');
    text.parse().ok().filter(|v: &f64| v.is_finite() && text.bytes().all(plain))
}

/// `h:mm:ss.sss` or `m:ss.sss`, the last part with any number of decimals.
fn clock(text: &str) -> Option<f64> {
    let (negative, rest) = text.strip_prefix('-').map_or((false, text), |rest| (true, rest));
    let parts: Vec<&str> = rest.split(':').collect();
    let (seconds, before) = parts.split_last().filter(|(_, before)| (1..=2).contains(&before.len()))?;
    if !seconds.bytes().all(|b| b.is_ascii_digit() || b == b'.') {
        return None;
    }
    let mut minutes = 0u64;
    for part in before {
        let value: u64 = part.parse::<u32>().ok()?.into();
        minutes = minutes * 60 + value;
    }
    let seconds: f64 = seconds.parse().ok().filter(|s| *s < 60.0)?;
    // Added as thousandths where there are no more decimals than that, or 0:00:01.040 would not be 1.04.
    let thousandths = (seconds * 1000.0).round();
    let exact = (minutes * 60_000) as f64 + thousandths;
    let value = if thousandths / 1000.0 == seconds { exact / 1000.0 } else { (minutes * 60) as f64 + seconds };
    Some(if negative { -value } else { value })
}
