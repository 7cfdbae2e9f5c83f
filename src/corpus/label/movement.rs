//! Labels of movements: `arc up-right 15cm ×2`, `down 10cm, then twist`, `(circle about up) ×3`.

use super::orientation::heading;
use super::{Features, Reading, Vocabulary};
use crate::phonology::distance::{Course, CourseKind};
use crate::phonology::movement_table::BySize;
use crate::phonology::{Extent, Size};

/// Words of movements.
pub(super) const WORDS: [&str; 22] = [
    "hold", "change", "back", "straight", "arc", "circle", "about", "nod", "swing", "twist", "stir", "wiggle", "small",
    "large", "up", "down", "left", "right", "out", "in", "then", "while",
];

/// The longest movement that is read, in parts: a label is no text to exhaust memory with.
const MOST_PARTS: usize = 64;

impl Vocabulary {
    /// Reads a movement (folded): its parts, each a kind, a direction, a size, a target, a count. Parts made at the same time
    /// are compared as if made one after the other: a label does not say how they are joined in time.
    pub(super) fn movement(&self, text: &str, reading: &mut Reading) -> Features {
        let text = text.replace(['(', ')', ','], " ").replace('×', " ×");
        let words: Vec<&str> = text.split_whitespace().collect();
        let mut courses: Vec<Course> = Vec::new();
        for part in words.split(|word| matches!(*word, "then" | "while" | "into")).take(MOST_PARTS) {
            if let Some(course) = self.course(part, reading) {
                courses.push(course);
            }
        }
        if courses.is_empty() { Features::Nothing } else { Features::Courses(courses) }
    }

    fn course(&self, words: &[&str], reading: &mut Reading) -> Option<Course> {
        let mut part = Part { kind: None, direction: None, extent: None, times: 1, target: false };
        let mut at = 0;
        while at < words.len() {
            at += match part.take(&words[at..], reading) {
                Some(used) => used,
                None if words[at] == "to" => {
                    let end = words[at..].iter().position(|word| word.starts_with('×')).map_or(words.len(), |n| at + n);
                    part.target |= self.target(&words[at + 1..end], reading);
                    end - at
                }
                None => {
                    reading.unknown(words[at]);
                    1
                }
            };
        }
        part.course(&self.movements.straight, &self.movements.circle_radius)
    }

    /// The place that a movement leads to; whether there is one.
    fn target(&self, words: &[&str], reading: &mut Reading) -> bool {
        let mut inner = Reading::default();
        self.placement(&words.join(" "), &mut inner);
        reading.terms.extend(inner.terms.iter().map(|term| format!("to {term}")));
        reading.known += inner.known;
        reading.unknown.extend(inner.unknown);
        inner.known > 0
    }
}

/// One part while it is read.
struct Part {
    kind: Option<CourseKind>,
    direction: Option<crate::phonology::Heading>,
    extent: Option<Extent>,
    times: u8,
    target: bool,
}

impl Part {
    /// Reads what begins here; how many words it takes, `None` where it is no word of movements.
    fn take(&mut self, words: &[&str], reading: &mut Reading) -> Option<usize> {
        let word = words[0];
        if word == "back" && words.get(1..3) == Some(&["to", "key"]) {
            self.kind = Some(CourseKind::Return);
            reading.known("kind back");
            return Some(words.len().min(4));
        }
        if let Some(kind) = kind(word) {
            self.kind = Some(kind);
            // Both ways to stir are stirring, each with its own name.
            reading.known(format!("kind {word}"));
            if word.starts_with("stir-") {
                reading.terms.push("kind stir".to_owned());
            }
            return Some(1);
        }
        if let Some((heading, used)) = heading(words) {
            self.direction = Some(heading);
            reading.known(format!("direction {heading}"));
            return Some(used);
        }
        if let Some(extent) = extent(word) {
            self.extent = Some(extent);
            reading.known(format!("size {word}"));
            return Some(1);
        }
        let count = word.strip_prefix('×').or_else(|| word.strip_prefix('x')).and_then(|n| n.parse::<u8>().ok());
        if let Some(times) = count.filter(|times| *times > 0) {
            self.times = times;
            reading.known(format!("times {times}"));
            return Some(1);
        }
        if matches!(word, "about" | "backwards" | "repeated") {
            reading.known += 1;
            if word == "backwards" {
                reading.terms.push(word.to_owned());
            }
            return Some(1);
        }
        None
    }

    /// The movement, where there is any; a direction, a length or a target alone is a straight path.
    fn course(&self, straight: &BySize, radius: &BySize) -> Option<Course> {
        let path = self.direction.is_some() || self.extent.is_some() || self.target;
        let kind = self.kind.or(path.then_some(CourseKind::Straight))?;
        let metres = match (kind, self.extent) {
            (CourseKind::Straight | CourseKind::Arc, extent) if extent.is_some() || !self.target => {
                Some(straight.metres(extent.unwrap_or(Extent::Size(Size::Normal))))
            }
            (CourseKind::Circle, extent) => Some(radius.metres(extent.unwrap_or(Extent::Size(Size::Normal)))),
            _ => None,
        };
        Some(Course { kind, direction: self.direction, metres, times: self.times })
    }
}

fn kind(word: &str) -> Option<CourseKind> {
    Some(match word {
        "hold" | "none" => CourseKind::Hold,
        "change" => CourseKind::Change,
        "back" => CourseKind::Return,
        "straight" => CourseKind::Straight,
        "arc" => CourseKind::Arc,
        "circle" => CourseKind::Circle,
        "nod" => CourseKind::Nod,
        "swing" => CourseKind::Swing,
        "twist" => CourseKind::Twist,
        "stir" | "stir-clockwise" | "stir-counterclockwise" => CourseKind::Stir,
        "wiggle" => CourseKind::Wiggle,
        _ => return None,
    })
}

fn extent(word: &str) -> Option<Extent> {
    match word {
        "small" => return Some(Extent::Size(Size::Small)),
        "normal" => return Some(Extent::Size(Size::Normal)),
        "large" => return Some(Extent::Size(Size::Large)),
        _ => {}
    }
    let (number, metres) = match (word.strip_suffix("cm"), word.strip_suffix("mm"), word.strip_suffix('m')) {
        (Some(number), ..) => (number, 0.01),
        (_, Some(number), _) => (number, 0.001),
        (_, _, number) => (number?, 1.0),
    };
    let length = number.parse::<f64>().ok()? * metres;
    (length > 0.0 && length.is_finite()).then_some(Extent::Metres(length))
}
