//! A line in plain words, item by item.

use super::Reading;
use crate::notation::gloss::print::{cell_text, face_text};
use crate::notation::gloss::syntax::{Face, Head, Item, Signed, Site, What};
use crate::notation::print::recombination::operators;
use crate::phonology::{Hand, Sign};
use crate::score::plan::Act;
use crate::time::Seconds;
use std::collections::BTreeMap;

/// Says each item of a line in words: which sign, how often, with which hand, where; then what the face does meanwhile.
///
/// Items with a fault are left out, as they are of the plan.
pub fn explain(reading: &Reading) -> String {
    let mut written = BTreeMap::new();
    let mut faces = Vec::new();
    flatten(&reading.line.items, &mut written, &mut faces);
    let width = reading.plan.items.iter().map(|i| i.gloss.chars().count()).max().unwrap_or(0);
    let mut out = String::new();
    for (i, item) in reading.plan.items.iter().enumerate() {
        let what = item.span.and_then(|span| written.get(&span.start).copied());
        let words = match &item.act {
            Act::Sign(sign) => what.map(|what| signs(what, sign)).unwrap_or_default(),
            Act::Hold(None, long) => format!("the posture is held{}", seconds(*long)),
            Act::Hold(Some(Hand::Strong), long) => {
                format!("the right hand stays{} while the left one goes on", seconds(*long))
            }
            Act::Hold(Some(Hand::Weak), long) => {
                format!("the left hand stays{} while the right one goes on", seconds(*long))
            }
            Act::Rest(long) => format!("the hands rest{}", seconds(*long)),
            Act::Captured(_) => what.map(captured).unwrap_or_default(),
        };
        let label: String = item.gloss.split_whitespace().collect::<Vec<_>>().join(" ");
        out.push_str(&format!("{:>3}  {label:width$}  {words}\n", i + 1));
    }
    for face in faces {
        let (start, end) = ends(&face.items);
        let within = |i: &&(usize, usize)| start <= i.1 && i.1 < end;
        let starts: Vec<(usize, usize)> =
            reading.plan.items.iter().enumerate().filter_map(|(n, i)| i.span.map(|s| (n + 1, s.start))).collect();
        let inside: Vec<usize> = starts.iter().filter(within).map(|(n, _)| *n).collect();
        if let (Some(first), Some(last)) = (inside.first(), inside.last()) {
            out.push_str(&format!("     {}  from {first} to {last}\n", face_text(&face.values)));
        }
    }
    out
}

/// The items by where they begin, and the braces.
fn flatten<'g>(items: &'g [Item], written: &mut BTreeMap<usize, &'g What>, faces: &mut Vec<&'g Face>) {
    for item in items {
        match &item.what {
            What::Face(face) => {
                faces.push(face);
                // Braces nest only as deep as the parser lets them.
                flatten(&face.items, written, faces);
            }
            What::Signed(_) | What::Together(..) | What::Pause(_) | What::Hold(..) | What::Rest(_) => {
                written.insert(item.span.0.start, &item.what);
            }
        }
    }
}

/// Where items begin and end in the text.
fn ends(items: &[Item]) -> (usize, usize) {
    (items.first().map_or(0, |i| i.span.0.start), items.last().map_or(0, |i| i.span.0.end))
}

fn seconds(long: Option<Seconds>) -> String {
    long.map(|s| format!(" for {} s", s.0)).unwrap_or_default()
}

fn captured(what: &What) -> String {
    match what {
        What::Signed(one) => format!("as it was captured: {}", signed(one, None)),
        What::Together(..) | What::Pause(_) | What::Hold(..) | What::Rest(_) | What::Face(_) => String::new(),
    }
}

fn signs(what: &What, sign: &Sign) -> String {
    match what {
        What::Signed(one) => signed(one, Some(sign)),
        What::Together(strong, weak) => {
            format!("at the same time: {}; and, with the other hand, {}", signed(strong, None), signed(weak, None))
        }
        What::Pause(_) | What::Hold(..) | What::Rest(_) | What::Face(_) => String::new(),
    }
}

fn signed(written: &Signed, sign: Option<&Sign>) -> String {
    let mut words = match &written.head.value {
        Head::Gloss(name) => {
            let of = sign.filter(|s| !s.language.is_empty()).map(|s| format!(" of {}", s.language)).unwrap_or_default();
            let meaning: Vec<String> =
                sign.into_iter().flat_map(|s| &s.meaning).map(|(tag, words)| format!("“{words}” ({tag})")).collect();
            let colon = if meaning.is_empty() { "" } else { ": " };
            if sign.is_some() { format!("a sign{of}{colon}{}", meaning.join(", ")) } else { name.clone() }
        }
        Head::Pointing(site) => format!("the index points {}", place(site)),
        Head::Wrist(site) => format!("the wrist is brought {}", place(site)),
        Head::Spelled(word) => {
            let letters: Vec<String> = word.chars().map(|c| c.to_uppercase().to_string()).collect();
            format!("spelled {}", letters.join(" "))
        }
        Head::Taken(taken) => {
            let others = taken.channels.iter().map(|(channel, take)| format!(", its {} from {take}", channel.name()));
            format!("the take {}{}", taken.take, others.collect::<String>())
        }
    };
    if !written.operators.value.is_empty() {
        words.push_str(&format!(", {}", operators(&written.operators.value)));
    }
    if written.performances.value > 1 {
        words.push_str(&format!(", made {} times", written.performances.value));
    }
    if written.hand == Hand::Weak {
        words.push_str(", with the weak hand");
    }
    if let Some(site) = &written.site {
        words.push_str(&format!(", made {}", place(&site.value)));
    }
    words
}

fn place(site: &Site) -> String {
    match site {
        Site::Space(cell) => format!("in space, {}", cell_text(*cell)),
        Site::Point([x, y, z]) => format!("at the point {x} m left, {y} m up, {z} m out"),
        Site::Referent(name) => format!("where {name} was made"),
    }
}
