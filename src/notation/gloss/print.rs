//! A [`GlossLine`] as text, laid out: one space between items, none before punctuation.

use super::parse::is_reserved;
use super::syntax::{Face, GlossLine, Head, Item, Pause, Signed, Site, What};
use crate::diagnostics::Spanned;
use crate::notation::lex::quote;
use crate::notation::print::recombination::operators;
use crate::notation::print::words::{bare, cell_words, duration, nonmanual};
use crate::notation::syntax::{Duration, NonManual};
use crate::phonology::recombination::ManualChannel;
use crate::phonology::{Channel, Hand, Space};

/// Prints a line; what is printed reads back as the same line.
///
/// ```
/// use chereme::notation::gloss::{parse, print};
/// let (line, _) = parse("BOL@left-high++ ,  IX@(0.6, 1.4, 0.5) {brows  up: TOI}//");
/// assert_eq!(print(&line), "BOL@left-high++, IX(0.6,1.4,0.5) {brows up: TOI}.");
/// ```
pub fn print(line: &GlossLine) -> String {
    let mut out = String::new();
    items(&line.items, &mut out);
    out
}

fn items(all: &[Item], out: &mut String) {
    for (i, item) in all.iter().enumerate() {
        if i > 0 && !matches!(item.what, What::Pause(_)) {
            out.push(' ');
        }
        match &item.what {
            What::Signed(one) => out.push_str(&signed(one)),
            What::Together(strong, weak) => out.push_str(&format!("{} & {}", signed(strong), signed(weak))),
            What::Pause(Pause::Short) => out.push(','),
            What::Pause(Pause::Long) => out.push('.'),
            What::Hold(hand, long) => {
                let hand = match hand {
                    None => "",
                    Some(Hand::Strong) => " strong",
                    Some(Hand::Weak) => " weak",
                };
                out.push_str(&format!("<HOLD{hand}{}>", length(*long)));
            }
            What::Rest(long) => out.push_str(&format!("<REST{}>", length(*long))),
            What::Face(face) => self::face(face, out),
        }
    }
}

fn length(long: Option<Duration>) -> String {
    long.map(|long| format!(" {}", duration(long))).unwrap_or_default()
}

fn face(face: &Face, out: &mut String) {
    out.push_str(&format!("{{{}: ", face_text(&face.values)));
    items(&face.items, out);
    out.push('}');
}

/// What head, trunk and face do: `brows raised, head tilted-left`.
pub(crate) fn face_text(values: &[(Spanned<Channel>, NonManual)]) -> String {
    let values: Vec<String> = values.iter().map(|(c, v)| format!("{} {}", c.value.name(), nonmanual(v))).collect();
    values.join(", ")
}

/// A cell of the grid in words: `left-high`.
pub(crate) fn cell_text(cell: Space) -> String {
    cell_words(cell).join("-")
}

/// A sign with its suffixes, as the gloss tier shows it.
pub(crate) fn signed(v: &Signed) -> String {
    let mut text = match &v.head.value {
        Head::Gloss(name) if is_reserved(name) => quote(name),
        Head::Gloss(name) => name_text(name),
        Head::Pointing(Site::Space(cell)) => format!("IX@{}", cell_text(*cell)),
        Head::Pointing(site) => format!("IX({})", site_text(site)),
        Head::Wrist(site) => format!("wrist({})", site_text(site)),
        Head::Spelled(word) => format!("fs({})", self::word(word)),
        Head::Taken(taken) => {
            let others = taken.channels.iter().map(|(channel, take)| format!(", {} {}", channel.name(), quoted(take)));
            format!("take({}{})", quoted(&taken.take), others.collect::<String>())
        }
    };
    if let Some(site) = &v.site {
        match &site.value {
            Site::Point(_) => text.push_str(&format!("@({})", site_text(&site.value))),
            Site::Space(_) | Site::Referent(_) => text.push_str(&format!("@{}", site_text(&site.value))),
        }
    }
    text.extend(std::iter::repeat_n('+', usize::from(v.performances.value.saturating_sub(1))));
    if !v.operators.value.is_empty() {
        text.push_str(&format!("[{}]", operators(&v.operators.value)));
    }
    match v.hand {
        Hand::Strong => text,
        Hand::Weak => format!("weak({text})"),
    }
}

/// A word to be spelled, in quotes where it has marks.
pub(crate) fn word(word: &str) -> String {
    bare(word, &[], &[])
}

/// The name of a take, in quotes where it has spaces or marks, or is a channel's.
fn quoted(take: &str) -> String {
    if ManualChannel::ALL.iter().any(|channel| take.eq_ignore_ascii_case(channel.name())) {
        return quote(take);
    }
    name_text(take)
}

/// A name, in quotes where it has spaces or marks.
fn name_text(name: &str) -> String {
    if name.contains([' ', '+']) { quote(name) } else { bare(name, &[], &[]) }
}

/// A site without its bracket.
fn site_text(site: &Site) -> String {
    match site {
        Site::Space(cell) => cell_text(*cell),
        Site::Point([x, y, z]) => format!("{x},{y},{z}"),
        Site::Referent(name) if super::parse::is_place(name) => quote(name),
        Site::Referent(name) => name_text(name),
    }
}
