//! Labels of placements: `chest left beside, close`, `other index tip`, `space high left`, `(0.10, 1.20, 0.40)`.

use super::{Features, Reading, Vocabulary};
use crate::phonology::{Digit, Digits, Distance, Flank, HandPart, HandPoint, Lateral, LocationKind, Side, Space};
use glam::DVec3;

/// Words of placements that are no places.
pub(super) const WORDS: [&str; 12] =
    ["left", "right", "beside", "touch", "close", "neutral", "extended", "away", "other", "space", "high", "low"];

/// Where a hand is.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Spot {
    /// On or before the body at rest, arm lengths in model space.
    Body(DVec3),
    /// On the other hand or arm at rest, hand lengths.
    OtherHand(DVec3),
}

impl Spot {
    /// How far apart two are, in the unit of their kind, at most 1; 1 where one is on the body and one on the other hand.
    pub fn distance(&self, other: &Spot) -> f64 {
        match (self, other) {
            (Spot::Body(a), Spot::Body(b)) | (Spot::OtherHand(a), Spot::OtherHand(b)) => a.distance(*b).min(1.0),
            _ => 1.0,
        }
    }
}

/// What is said beside the place.
#[derive(Debug, Default)]
struct Said {
    side: Option<Side>,
    beside: bool,
    distance: Option<Distance>,
}

impl Said {
    fn lateral(&self) -> Option<Lateral> {
        self.side.map(|side| Lateral { side, beside: self.beside })
    }
}

impl Vocabulary {
    /// Reads a placement (folded).
    pub(super) fn placement(&self, text: &str, reading: &mut Reading) -> Features {
        let text = text.trim();
        if let Some(name) = text.strip_prefix("referent ") {
            reading.known(format!("referent {}", name.trim()));
            return Features::Nothing;
        }
        if let Some(at) = text.strip_prefix("pointing at ") {
            // Where the hand is held to point there, the label does not tell. What points at a pointing hand points once.
            let mut inner = Reading::default();
            self.place(at.trim_start_matches("pointing at "), &mut inner);
            reading.known += inner.known;
            reading.unknown.extend(inner.unknown);
            reading.terms.extend(inner.terms.into_iter().map(|term| format!("pointing at {term}")));
            return Features::Nothing;
        }
        if let Some(point) = point(text) {
            reading.known(format!("place {text}"));
            return Features::Places(vec![Spot::Body(point / self.landmarks.arm_length())]);
        }
        match text.split_once('–') {
            Some((first, second)) => self.halfway(first, second, reading),
            None => self.place(text, reading),
        }
    }

    /// Halfway between two places; what is said after the second holds for both.
    fn halfway(&self, first: &str, second: &str, reading: &mut Reading) -> Features {
        let (mut a, mut b) = (Reading::default(), Reading::default());
        let places = (self.place(first, &mut a), self.place(second, &mut b));
        let name = |r: &Reading| r.terms.iter().find_map(|t| t.strip_prefix("place ")).unwrap_or_default().to_owned();
        let between = format!("place {}–{}", name(&a), name(&b));
        reading.known += a.known + b.known;
        reading.terms.extend([a.terms, b.terms].concat().into_iter().filter(|term| !term.starts_with("place ")));
        reading.terms.push(between);
        reading.unknown.extend([a.unknown, b.unknown].concat());
        let (Features::Places(a), Features::Places(b)) = places else { return Features::Nothing };
        let middle = |x: &Spot, y: &Spot| match (x, y) {
            (Spot::Body(p), Spot::Body(q)) => Some(Spot::Body((*p + *q) / 2.0)),
            (Spot::OtherHand(p), Spot::OtherHand(q)) => Some(Spot::OtherHand((*p + *q) / 2.0)),
            _ => None,
        };
        let spots: Vec<Spot> = a.iter().flat_map(|x| b.iter().filter_map(move |y| middle(x, y))).collect();
        if spots.is_empty() { Features::Nothing } else { Features::Places(spots) }
    }

    /// A place with its side and distance.
    fn place(&self, text: &str, reading: &mut Reading) -> Features {
        let text = text.replace([',', ';'], " ");
        let words: Vec<&str> = text.split_whitespace().collect();
        if let Some(at) = words.iter().position(|word| *word == "other") {
            return self.other_hand(&words[..at], &words[at + 1..], reading);
        }
        if words.first() == Some(&"space") {
            return self.cell(&words[1..], reading);
        }
        let mut said = Said::default();
        let mut place = None;
        let mut from = 0;
        while from < words.len() {
            let word = words[from];
            // `neutral` is a place, and after a place a distance.
            let location = self.locations.get(word).filter(|_| place.is_none());
            match location {
                Some(location) => {
                    reading.known(format!("place {}", crate::phonology::grammar::fold(&location.id)));
                    place = Some(location);
                    from += 1;
                }
                None => from += said.take(&words[from..], reading),
            }
        }
        let Some(location) = place else { return Features::Nothing };
        match location.kind {
            LocationKind::Body | LocationKind::Space => self.on_body(&location.id, location.unmarked, &said),
            LocationKind::Limb(part) => self.on_hand(HandPoint::new(Digits::NONE, part, None)),
            LocationKind::Digit(digit) => self.on_hand(HandPoint::of_digit(digit, HandPart::Tip)),
            LocationKind::Part(part) => self.on_hand(HandPoint::new(Digits::FINGERS, part, None)),
        }
    }

    /// A place of the body: on both sides where it comes in two and the label does not say which.
    fn on_body(&self, id: &str, unmarked: Distance, said: &Said) -> Features {
        let found = match self.landmarks.body_place(id, said.lateral()) {
            Ok(landmark) => vec![landmark],
            Err(_) if said.side.is_none() => {
                let of = |side| self.landmarks.body_place(id, Some(Lateral { side, beside: said.beside })).ok();
                [Side::Right, Side::Left].into_iter().filter_map(of).collect()
            }
            Err(_) => Vec::new(),
        };
        let arm = self.landmarks.arm_length();
        let spots = found.iter().map(|landmark| {
            let (at, normal) = (landmark.position(&self.rest), landmark.normal(&self.rest));
            // Both arms reach as far; the side of the place decides whose shoulder it is, the right one in the middle.
            let side = if at.x > 0.01 { Side::Left } else { Side::Right };
            let shoulder = self.rest.position(self.landmarks.shoulder(side));
            // The neutral place is a point of space: it has no skin to be away from.
            let distance = if id == "neutral" { Distance::Touch } else { said.distance.unwrap_or(Distance::Unmarked) };
            let metres = self.landmarks.metres(distance, unmarked, (at, normal), shoulder, arm);
            Spot::Body((at + normal * metres) / arm)
        });
        let spots: Vec<Spot> = spots.collect();
        if spots.is_empty() { Features::Nothing } else { Features::Places(spots) }
    }

    fn on_hand(&self, point: Option<HandPoint>) -> Features {
        let found = point.and_then(|p| self.landmarks.hand_point(Side::Left, p).ok());
        let unit = self.landmarks.hand_length();
        found.map_or(Features::Nothing, |p| Features::Places(vec![Spot::OtherHand(p.position(&self.rest) / unit)]))
    }

    /// A point of the other hand, with what is said around it.
    fn other_hand(&self, before: &[&str], words: &[&str], reading: &mut Reading) -> Features {
        let mut said = Said::default();
        let mut from = 0;
        while from < before.len() {
            from += said.take(&before[from..], reading);
        }
        let (mut digits, mut part, mut flank, mut known) = (Vec::new(), None, None, Vec::new());
        let mut from = 0;
        while from < words.len() {
            let word = words[from];
            if let Some(digit) = Digit::ALL.into_iter().find(|d| d.name() == word) {
                digits.push(digit);
            } else if let Some(found) = HandPart::all().find(|p| p.name() == word) {
                part = Some(found);
            } else if let Some(found) = Flank::ALL.into_iter().find(|f| f.name() == word) {
                flank = Some(found);
            } else if word != "hand" {
                from += said.take(&words[from..], reading);
                continue;
            }
            known.push(word);
            from += 1;
        }
        reading.known(format!("place other {}", known.join(" ")));
        reading.terms.push("place other".to_owned());
        let part = part.unwrap_or(if digits.is_empty() { HandPart::Palm } else { HandPart::Tip });
        let digits = if part.needs_digit() { Digits::of(digits) } else { Digits::NONE };
        self.on_hand(HandPoint::new(digits, part, flank))
    }

    /// A cell of signing space; the middle one where nothing is said.
    fn cell(&self, words: &[&str], reading: &mut Reading) -> Features {
        let mut cell = Space::default();
        reading.known("place space");
        for word in words.iter().flat_map(|word| word.split('-')) {
            match word {
                "left" => cell.left = 1,
                "right" => cell.left = -1,
                "high" => cell.high = 1,
                "low" => cell.high = -1,
                "far" => cell.far = 1,
                "near" => cell.far = -1,
                "centre" | "center" | "middle" | "mid" => {}
                _ => {
                    reading.unknown(word);
                    continue;
                }
            }
            reading.known(format!("cell {word}"));
        }
        let at = self.landmarks.space(cell).position(&self.rest);
        Features::Places(vec![Spot::Body(at / self.landmarks.arm_length())])
    }
}

impl Said {
    /// Reads a side or a distance; how many words it takes.
    fn take(&mut self, words: &[&str], reading: &mut Reading) -> usize {
        let metres = |word: &str| word.strip_suffix("cm").and_then(|n| n.parse::<f64>().ok()).filter(|n| n.is_finite());
        let distance = match words[0] {
            "left" | "right" => {
                self.side = Some(if words[0] == "left" { Side::Left } else { Side::Right });
                reading.known(format!("side {}", words[0]));
                return 1;
            }
            "beside" => {
                self.beside = true;
                reading.known("beside");
                return 1;
            }
            "touch" | "touching" => Distance::Touch,
            "close" | "near" => Distance::Close,
            "neutral" => Distance::Neutral,
            "extended" | "far" => Distance::Extended,
            word => match metres(word) {
                // Farther than any arm is no distance from a body.
                Some(cm) if (0.0..=300.0).contains(&cm) => Distance::Metres(cm / 100.0),
                _ => {
                    reading.unknown(word);
                    return 1;
                }
            },
        };
        self.distance = Some(distance);
        reading.known(match distance {
            Distance::Touch => "distance touch".to_owned(),
            Distance::Close => "distance close".to_owned(),
            Distance::Neutral => "distance neutral".to_owned(),
            Distance::Extended => "distance extended".to_owned(),
            Distance::Metres(_) | Distance::Unmarked => format!("distance {}", words[0]),
        });
        1 + usize::from(words.get(1) == Some(&"away"))
    }
}

/// A point in model space, metres: `(0.10, 1.20, 0.40)`.
fn point(text: &str) -> Option<DVec3> {
    let inner = text.strip_prefix('(')?.strip_suffix(')')?;
    let numbers: Result<Vec<f64>, _> = inner.split(',').map(|n| n.trim().parse::<f64>()).collect();
    let [x, y, z] = numbers.ok()?[..] else { return None };
    let point = DVec3::new(x, y, z);
    point.is_finite().then_some(point)
}
