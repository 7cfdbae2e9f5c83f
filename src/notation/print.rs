//! [`syntax`](super::syntax) to text, laid out: this is `fmt`.
//!
//! A sign's tiers stand two spaces in, their values in one column; comments stay where they were, single blank
//! lines too. Printing what was just printed changes nothing.

mod movement;
pub(crate) mod recombination;
pub(crate) mod words;

use super::lex::quote;
use super::syntax::{Content, File, Line, OtherHand, TierLine, Value};
use crate::phonology::Hand;
use movement::movements;
use words::{
    bare, base, configuration, contact, duration, hands, meanings, nonmanual, orientation, placement, relocation,
    values,
};

pub use movement::movement_text;
pub(crate) use recombination::expression;

/// The column of the values, from the left, where no keyword is longer: `configuration` and two spaces.
const LEAST_WIDTH: usize = "configuration".len();

/// Prints a file. Lines with faults cannot be printed; they are left out, so print only what has none.
///
/// ```
/// use chereme::notation::{parse, print};
/// let (file, _) = parse("sign  BOL # a bowl\nhands   both  mirrored");
/// assert_eq!(print(&file), "sign BOL  # a bowl\n  hands          both mirrored\n");
/// ```
pub fn print(file: &File) -> String {
    let is_broken = |line: &Line| matches!(line.content, Some(Content::Broken(_)));
    if !file.lines.iter().any(is_broken) {
        return print_sound(file);
    }
    // What is left out must not lend its place to the comments beside it: read again, it would be gone.
    print_sound(&File { lines: file.lines.iter().filter(|line| !is_broken(line)).cloned().collect() })
}

fn print_sound(file: &File) -> String {
    let mut out = String::new();
    let mut width = LEAST_WIDTH;
    let mut blank = true;
    for (i, line) in file.lines.iter().enumerate() {
        let text = match &line.content {
            None if line.comment.is_none() => {
                blank = true;
                continue;
            }
            None => String::new(),
            Some(Content::Broken(_)) => continue,
            Some(Content::Language(name)) => format!("language {}", name.value),
            Some(Content::Sign(name, made)) => {
                width = width_of_sign(&file.lines[i + 1..]);
                let made = made.as_ref().map(|made| format!(" = {}", expression(made))).unwrap_or_default();
                format!("sign {}{made}", sign_name(&name.value))
            }
            Some(Content::Then(OtherHand::Free)) => "then".to_owned(),
            Some(Content::Then(OtherHand::Stays)) => "then other hand stays".to_owned(),
            Some(Content::Tier(tier)) => {
                let keyword = keyword(tier);
                format!("  {keyword:width$}  {}", value(&tier.value))
            }
        };
        let heads = heads_sign(&file.lines[i..]);
        let first_of_head = heads && !(i > 0 && is_comment(&file.lines[i - 1]));
        if !out.is_empty() && (blank || first_of_head) {
            out.push('\n');
        }
        let indent = match line.content {
            // A comment of its own belongs to the sign it stands in, or heads the next.
            None if !heads && in_body(file, i, blank) => "  ",
            _ => "",
        };
        blank = false;
        out.push_str(indent);
        out.push_str(&text);
        if let Some(comment) = &line.comment {
            if !text.is_empty() {
                out.push_str("  ");
            }
            out.push('#');
            if !comment.is_empty() {
                out.push(' ');
                out.push_str(comment);
            }
        }
        out.push('\n');
    }
    out
}

fn is_comment(line: &Line) -> bool {
    line.content.is_none() && line.comment.is_some()
}

/// Whether these lines begin with a `sign` line, or comments right before one.
fn heads_sign(lines: &[Line]) -> bool {
    let next = lines.iter().find(|l| !is_comment(l));
    next.is_some_and(|l| matches!(l.content, Some(Content::Sign(..))))
}

/// Whether a comment stands among the tiers of a sign.
fn in_body(file: &File, at: usize, after_blank: bool) -> bool {
    let before = file.lines[..at].iter().rev().find(|l| l.content.is_some());
    let after = file.lines[at..].iter().find(|l| l.content.is_some());
    let inside = matches!(
        before.and_then(|l| l.content.as_ref()),
        Some(Content::Sign(..) | Content::Then(_) | Content::Tier(_))
    );
    let tier_follows = matches!(after.and_then(|l| l.content.as_ref()), Some(Content::Then(_) | Content::Tier(_)));
    // After a blank line with no tier to come it is a remark between signs; comments in a row stand alike.
    let row = file.lines[..at].iter().rev().take_while(|l| is_comment(l)).count();
    let row_after_blank = if row == 0 { after_blank } else { at == row || is_blank(&file.lines[at - row - 1]) };
    inside && (tier_follows || !row_after_blank)
}

fn is_blank(line: &Line) -> bool {
    line.content.is_none() && line.comment.is_none()
}

/// The width of the longest keyword up to the next sign.
fn width_of_sign(lines: &[Line]) -> usize {
    let tiers = lines.iter().map_while(|line| match &line.content {
        Some(Content::Sign(..)) => None,
        Some(Content::Tier(tier)) => Some(keyword(tier).len()),
        _ => Some(0),
    });
    tiers.max().unwrap_or(0).max(LEAST_WIDTH)
}

fn keyword(tier: &TierLine) -> String {
    let word = tier.value.keyword();
    match tier.hand {
        None => word.to_owned(),
        Some(Hand::Strong) => format!("strong {word}"),
        Some(Hand::Weak) => format!("weak {word}"),
    }
}

/// The name of a sign, in quotes where it needs them.
pub(crate) fn sign_name(name: &str) -> String {
    if name.contains(' ') { quote(name) } else { bare(name, &[], &[]) }
}

/// The values of a tier as text.
pub(crate) fn value(value: &Value) -> String {
    match value {
        Value::Meaning(all) => meanings(all),
        Value::Source(text) | Value::Note(text) => quote(text),
        Value::Status(text) => bare(text, &[], &[]),
        Value::Hands(h) => hands(*h),
        Value::Configuration(v) => values(v, configuration),
        Value::Placement(v) => values(v, placement),
        Value::Orientation(v) => values(v, orientation),
        Value::Movement(v) => movements(v),
        Value::Contact(v) => values(v, contact),
        Value::NonManual(_, v) => values(v, nonmanual),
        Value::Duration(d) => duration(*d),
        Value::Speed(factor) => factor.to_string(),
        Value::Base(all) => base(all),
        Value::At(to) => relocation(to),
    }
}
