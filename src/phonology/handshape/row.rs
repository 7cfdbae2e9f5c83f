//! Rows of `grammar/handshapes.ron` as they are written, and their checking.

use super::angles::{FingerAngles, HandAngles, ThumbAngles};
use super::limits::HandLimits;
use super::shape::{Handshape, Solved, ThumbGoal, ThumbPart, ThumbStance, ThumbTarget};
use super::written::Written;
use crate::phonology::{Digit, Digits, Flank, HandPart, HandPoint};
use serde::Deserialize;
use std::collections::BTreeMap;

/// Flexion of knuckle, middle and last joint, degrees.
pub(super) type Level = (f64, f64, f64);

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Table {
    #[serde(default)]
    pub levels: BTreeMap<String, Level>,
    #[serde(default)]
    pub handshapes: Vec<Row>,
}

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Row {
    pub id: String,
    #[serde(default)]
    pub aliases: Vec<String>,
    #[serde(default)]
    hamnosys: String,
    #[serde(default)]
    iswa: String,
    selected: String,
    touches_with: String,
    flexion: (String, String, String, String),
    #[serde(default)]
    spread: (f64, f64, f64, f64),
    #[serde(default)]
    over: Option<(String, String)>,
    thumb: ThumbRow,
    thumb_table: (f64, f64, f64, f64, f64),
    #[serde(default)]
    note: String,
    #[serde(default)]
    solved: Option<SolvedRow>,
}

#[derive(Deserialize)]
enum ThumbRow {
    Posture(ThumbStance),
    Touch(ThumbPart, String, ThumbTarget),
    Between(String, String),
    Gap(String, u32),
}

type FingerRow = (f64, f64, f64, f64);

#[derive(Deserialize)]
#[serde(deny_unknown_fields)]
struct SolvedRow {
    fingers: (FingerRow, FingerRow, FingerRow, FingerRow),
    thumb: (f64, f64, f64, f64, f64),
    residual_mm: f64,
}

impl Row {
    /// The handshape, or what is wrong with the row, with the word to point at.
    pub(super) fn check(&self, levels: &BTreeMap<String, Level>) -> Result<Handshape, (String, String)> {
        let about = |word: &str, message: String| (word.to_owned(), message);
        let (a, b, c, d) = &self.flexion;
        let mut angles = [(0.0, 0.0, 0.0); 4];
        for (slot, name) in angles.iter_mut().zip([a, b, c, d]) {
            *slot = level(name, levels)
                .ok_or_else(|| about(name, format!("there is no flexion `{name}`, and it is not three numbers")))?;
        }
        let spread = <[f64; 4]>::from(self.spread).map(f64::to_radians);
        let fingers = std::array::from_fn(|i| {
            let (mcp, pip, dip) = angles[i];
            let mcp = mcp.to_radians();
            FingerAngles { mcp, abduction: spread[i] * mcp.cos(), pip: pip.to_radians(), dip: dip.to_radians() }
        });
        let table = HandAngles { fingers, thumb: thumb_angles(self.thumb_table) };
        let solved = self.solved.as_ref().map(SolvedRow::solved);
        for (what, hand) in [("table", Some(table)), ("solved", solved.map(|s| s.angles))] {
            if hand.is_some_and(|h| !h.to_array().iter().all(|a| a.is_finite()) || !HandLimits::ANATOMICAL.hold(&h)) {
                return Err(about(&self.id, format!("the {what} angles of `{}` go beyond a hand's limits", self.id)));
            }
        }
        let flexion = [a, b, c, d].map(|n| if levels.contains_key(n) { n.clone() } else { String::new() });
        let hamnosys: Vec<String> = self.hamnosys.split_whitespace().map(str::to_owned).collect();
        Ok(Handshape {
            id: self.id.clone(),
            aliases: self.aliases.clone(),
            written: Written::of(&hamnosys),
            hamnosys,
            iswa: self.iswa.clone(),
            selected: digits(&self.selected)?,
            touches_with: hand_point(&self.touches_with).ok_or_else(|| {
                about(&self.touches_with, format!("`{}` is not a point of a hand", self.touches_with))
            })?,
            flexion,
            spread,
            crossing: match &self.over {
                Some((front, behind)) => Some((finger(front)?, finger(behind)?)),
                None => None,
            },
            thumb: self.thumb.goal()?,
            table,
            solved,
            note: self.note.clone(),
        })
    }
}

impl ThumbRow {
    fn goal(&self) -> Result<ThumbGoal, (String, String)> {
        Ok(match self {
            ThumbRow::Posture(stance) => ThumbGoal::Posture(*stance),
            ThumbRow::Touch(part, fingers, target) => ThumbGoal::Touch(*part, some_fingers(fingers)?, *target),
            ThumbRow::Between(a, b) => ThumbGoal::Between(finger(a)?, finger(b)?),
            ThumbRow::Gap(fingers, mm) => ThumbGoal::Gap(some_fingers(fingers)?, *mm),
        })
    }
}

impl SolvedRow {
    fn solved(&self) -> Solved {
        let (a, b, c, d) = self.fingers;
        let fingers = [a, b, c, d].map(|(mcp, abduction, pip, dip)| FingerAngles {
            mcp: mcp.to_radians(),
            abduction: abduction.to_radians(),
            pip: pip.to_radians(),
            dip: dip.to_radians(),
        });
        Solved { angles: HandAngles { fingers, thumb: thumb_angles(self.thumb) }, residual_mm: self.residual_mm }
    }
}

fn thumb_angles((radial, palmar, pronation, mcp, ip): (f64, f64, f64, f64, f64)) -> ThumbAngles {
    let [radial, palmar, pronation, mcp, ip] = [radial, palmar, pronation, mcp, ip].map(f64::to_radians);
    ThumbAngles { radial, palmar, pronation, mcp, ip }
}

/// A named level, or three numbers such as `20/95/63`.
fn level(text: &str, levels: &BTreeMap<String, Level>) -> Option<Level> {
    if let Some(level) = levels.get(text) {
        return Some(*level);
    }
    let numbers = text.split('/').map(|n| n.trim().parse().ok()).collect::<Option<Vec<f64>>>()?;
    let &[mcp, pip, dip] = numbers.as_slice() else { return None };
    Some((mcp, pip, dip))
}

fn finger(name: &str) -> Result<Digit, (String, String)> {
    let found = Digit::FINGERS.into_iter().find(|d| d.name() == name);
    found.ok_or_else(|| (name.to_owned(), format!("`{name}` is not index, middle, ring or pinky")))
}

fn some_fingers(text: &str) -> Result<Digits, (String, String)> {
    let fingers = text.split_whitespace().map(finger).collect::<Result<Vec<_>, _>>()?;
    match fingers.is_empty() {
        true => Err((String::new(), "the thumb's goal names no finger".to_owned())),
        false => Ok(Digits::of(fingers)),
    }
}

fn digits(text: &str) -> Result<Digits, (String, String)> {
    let digit = |name: &str| {
        let found = Digit::ALL.into_iter().find(|d| d.name() == name);
        found.ok_or_else(|| (name.to_owned(), format!("`{name}` is not a digit")))
    };
    Ok(Digits::of(text.split_whitespace().map(digit).collect::<Result<Vec<_>, _>>()?))
}

/// A point as [`HandPoint`] displays it: face, digits, part.
fn hand_point(text: &str) -> Option<HandPoint> {
    let mut words = text.split_whitespace().peekable();
    let flank = words.peek().and_then(|w| Flank::ALL.into_iter().find(|f| f.name() == *w));
    if flank.is_some() {
        words.next();
    }
    let mut digits = Vec::new();
    while let Some(digit) = words.peek().and_then(|w| Digit::ALL.into_iter().find(|d| d.name() == *w)) {
        digits.push(digit);
        words.next();
    }
    let part = words.next()?;
    let part = HandPart::OF_A_DIGIT.into_iter().chain(HandPart::OF_THE_LIMB).find(|p| p.name() == part)?;
    if words.next().is_some() { None } else { HandPoint::new(Digits::of(digits), part, flank) }
}
