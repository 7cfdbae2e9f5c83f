//! Labels of orientations: `fingers up-left, palm between out and down`.

use super::{Features, Reading};
use crate::phonology::{Direction, Heading, Orientation};

/// Words of orientations.
pub(super) const WORDS: [&str; 8] = ["fingers", "palm", "up", "down", "left", "right", "out", "in"];

/// Reads an orientation (folded): `fingers` and `palm`, each with a heading, in any order.
pub(super) fn read(text: &str, reading: &mut Reading) -> Features {
    let text = text.replace([',', ';'], " ");
    let words: Vec<&str> = text.split_whitespace().collect();
    let mut orientation = Orientation::default();
    let mut at = 0;
    while at < words.len() {
        let of = words[at];
        let heading = if matches!(of, "fingers" | "palm") { heading(&words[at + 1..]) } else { None };
        match heading {
            Some((heading, used)) => {
                reading.known(format!("{of} {heading}"));
                match of {
                    "fingers" => orientation.fingers = Some(heading),
                    _ => orientation.palm = Some(heading),
                }
                at += 1 + used;
            }
            None => {
                reading.unknown(of);
                at += 1;
            }
        }
    }
    if orientation == Orientation::default() { Features::Nothing } else { Features::Orientation(orientation) }
}

/// A heading at the start of words, and how many words it takes. Opposites have no middle: of these nothing is read.
pub(super) fn heading(words: &[&str]) -> Option<(Heading, usize)> {
    match words {
        ["between", a, "and", b, ..] => {
            let (a, b): (Direction, Direction) = (a.parse().ok()?, b.parse().ok()?);
            (a.opposite() != b).then_some((Heading::Between(a, b), 4))
        }
        [first, ..] => Some((first.parse::<Direction>().ok()?.into(), 1)),
        [] => None,
    }
}
