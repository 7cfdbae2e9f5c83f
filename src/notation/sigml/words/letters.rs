//! Values that are spelled: digits, directions, palms, hours of the clock face, bends in quarters.

use crate::notation::hamnosys::syntax::Bend;
use crate::phonology::roll::Roll;
use crate::phonology::{Clock, Digit, Direction};

/// The digits of a list such as `25`, in its order; `None` where it has anything else.
pub(in crate::notation::sigml) fn digits(word: &str) -> Option<Vec<Digit>> {
    word.chars().map(digit).collect()
}

/// The digit of its number.
pub(in crate::notation::sigml) fn digit(number: char) -> Option<Digit> {
    match number {
        '1' => Some(Digit::Thumb),
        '2' => Some(Digit::Index),
        '3' => Some(Digit::Middle),
        '4' => Some(Digit::Ring),
        '5' => Some(Digit::Pinky),
        _ => None,
    }
}

/// The number of a digit.
pub(in crate::notation::sigml) fn number(digit: Digit) -> char {
    match digit {
        Digit::Thumb => '1',
        Digit::Index => '2',
        Digit::Middle => '3',
        Digit::Ring => '4',
        Digit::Pinky => '5',
    }
}

/// A direction as written: one, or halfway from the first to the second.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::notation::sigml) enum Pointed {
    One(Direction),
    Halfway(Direction, Direction),
}

/// Reads a direction: the letters of its parts in any order; a doubled letter is halfway back to that letter alone, so
/// that `uuo` lies between `u` and `uo`.
///
/// `None` where a letter is unknown, opposite letters meet, or there is none.
pub(in crate::notation::sigml) fn direction(word: &str) -> Option<Pointed> {
    if word.len() > 6 {
        return None;
    }
    let (mut all, mut doubled) = ([0i8; 3], [0i8; 3]);
    for letter in word.bytes() {
        let (axis, sign) = match letter.to_ascii_lowercase() {
            b'l' => (0, 1),
            b'r' => (0, -1),
            b'u' => (1, 1),
            b'd' => (1, -1),
            b'o' => (2, 1),
            b'i' => (2, -1),
            _ => return None,
        };
        match all[axis] {
            0 => all[axis] = sign,
            there if there == sign && doubled[axis] == 0 => doubled[axis] = sign,
            _ => return None,
        }
    }
    let of = |signs: [i8; 3]| Direction::new(signs[0], signs[1], signs[2]);
    let whole = of(all)?;
    Some(match of(doubled) {
        Some(plain) if plain != whole => Pointed::Halfway(plain, whole),
        Some(_) | None => Pointed::One(whole),
    })
}

/// Writes a direction: height, depth, side.
pub(in crate::notation::sigml) fn letters(direction: Direction) -> String {
    let [left, up, out] = direction.signs();
    let parts = [(up, 'u', 'd'), (out, 'o', 'i'), (left, 'l', 'r')];
    let letter = |(sign, more, less): (i8, char, char)| match sign {
        0 => None,
        1.. => Some(more),
        _ => Some(less),
    };
    parts.into_iter().filter_map(letter).collect()
}

/// A palm symbol or the bulge of an arc, its letters in either order.
pub(in crate::notation::sigml) fn roll(word: &str) -> Option<Roll> {
    Roll::from_tag(word).or_else(|| match *word.as_bytes() {
        [a, b] if a != b => Roll::from_tag(&String::from_iter([char::from(b), char::from(a)])),
        _ => None,
    })
}

/// A place of the clock face.
pub(in crate::notation::sigml) fn clock(word: &str) -> Option<Clock> {
    roll(word).and_then(|roll| Roll::all().position(|r| r == roll)).and_then(|i| Clock::new(u8::try_from(i).ok()?))
}

/// The letters of a place of the clock face.
pub(in crate::notation::sigml) fn clock_letters(clock: Clock) -> &'static str {
    Roll::TAGS[usize::from(clock.eighths() % 8)]
}

/// A bend as three quarters of the range of each joint (`410`); with decimals (`0.50.50.5`), rounded, said to be so.
pub(in crate::notation::sigml) fn quarters(word: &str) -> Option<(Bend, Exactness)> {
    let of = |digits: Vec<f64>| -> Option<[u8; 3]> {
        let rounded: Vec<u8> = digits.iter().map(|d| d.round() as u8).filter(|d| *d <= 4).collect();
        rounded.try_into().ok()
    };
    let bytes = word.as_bytes();
    let value = |b: u8| b.is_ascii_digit().then(|| f64::from(b - b'0'));
    if bytes.len() == 3 {
        let digits = bytes.iter().map(|b| value(*b)).collect::<Option<Vec<f64>>>()?;
        return of(digits).map(|q| (Bend::Quarters(q), Exactness::Exact));
    }
    if bytes.len() != 9 {
        return None;
    }
    let decimal = |part: &[u8]| match part {
        [whole, b'.', tenth] => Some(value(*whole)? + value(*tenth)? / 10.0),
        _ => None,
    };
    let digits = bytes.chunks(3).map(decimal).collect::<Option<Vec<f64>>>()?;
    of(digits).map(|q| (Bend::Quarters(q), Exactness::Rounded))
}

/// Whether a number was taken as it stands.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(in crate::notation::sigml) enum Exactness {
    Exact,
    Rounded,
}
