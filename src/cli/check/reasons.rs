//! What is wrong how often: messages that differ in names and numbers only are one reason.

use super::super::world::Checkup;
use crate::diagnostics::{Diagnostic, Severity};
use serde::Serialize;
use std::collections::BTreeMap;

/// A kind of message and how often it comes.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(super) struct Reason {
    /// `fault` or `warning`.
    pub severity: &'static str,
    /// The message without its names and numbers.
    pub kind: String,
    /// How often.
    pub count: usize,
    /// In how many texts.
    pub files: usize,
    /// The first of its kind.
    pub example: Example,
}

/// A message and where it stands.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub(super) struct Example {
    /// The text's name.
    pub file: String,
    /// From 1.
    pub line: usize,
    /// From 1, in characters.
    pub column: usize,
    /// The message.
    pub message: String,
}

impl Example {
    pub(super) fn of(diagnostic: &Diagnostic, checkup: &Checkup) -> Example {
        let source = &checkup.text.source;
        let (line, column) = source.line_column(diagnostic.span.start);
        Example { file: source.name.clone(), line, column, message: diagnostic.message.clone() }
    }
}

/// The word for a severity.
pub(super) fn word(severity: Severity) -> &'static str {
    match severity {
        Severity::Warning => "warning",
        Severity::Fault => "fault",
    }
}

/// The reasons of all texts: faults before warnings, the most frequent first.
pub(super) fn reasons(checkups: &[Checkup]) -> Vec<Reason> {
    // By severity and kind: the reason and the number of the last text that it was seen in.
    let mut all: BTreeMap<(&'static str, String), (Reason, usize)> = BTreeMap::new();
    for (number, checkup) in checkups.iter().enumerate() {
        for diagnostic in &checkup.diagnostics {
            let (severity, kind) =
                (word(diagnostic.severity), generalised(nameless(&diagnostic.message, &checkup.text.source.text)));
            let first = || {
                let example = Example::of(diagnostic, checkup);
                (Reason { severity, kind: kind.clone(), count: 0, files: 0, example }, usize::MAX)
            };
            let (reason, seen) = all.entry((severity, kind.clone())).or_insert_with(first);
            reason.count += 1;
            reason.files += usize::from(*seen != number);
            *seen = number;
        }
    }
    let mut reasons: Vec<Reason> = all.into_values().map(|(reason, _)| reason).collect();
    // Stable: of equally frequent ones by severity ("fault" before "warning") and kind.
    reasons.sort_by(|a, b| a.severity.cmp(b.severity).then(b.count.cmp(&a.count)));
    reasons
}

/// A message without the gloss that it begins with: one that the text names in quotes, or the number of a sign.
fn nameless<'m>(message: &'m str, text: &str) -> &'m str {
    let Some((name, rest)) = message.split_once(": ") else { return message };
    let numbered = name.strip_prefix("sign ").is_some_and(|n| n.bytes().all(|b| b.is_ascii_digit()));
    let is_gloss = || ['"', '\''].iter().any(|quote| text.contains(&format!("{quote}{name}{quote}")));
    if numbered || (!name.contains('`') && is_gloss()) { rest } else { message }
}

/// A message with `…` for what is quoted, `N` for numbers and `…` for symbols of HamNoSys.
fn generalised(message: &str) -> String {
    let mut kind = String::with_capacity(message.len());
    let mut chars = message.chars().peekable();
    while let Some(c) = chars.next() {
        match c {
            '`' => {
                chars.by_ref().take_while(|c| *c != '`').for_each(drop);
                kind.push_str("`…`");
            }
            '"' => {
                chars.by_ref().take_while(|c| *c != '"').for_each(drop);
                kind.push_str("\"…\"");
            }
            c if c.is_ascii_digit() => {
                while chars.next_if(|c| c.is_ascii_digit() || *c == '.').is_some() {}
                kind.push('N');
            }
            '\u{e000}'..='\u{f8ff}' => {
                while chars.next_if(|c| ('\u{e000}'..='\u{f8ff}').contains(c)).is_some() {}
                kind.push('…');
            }
            c => kind.push(c),
        }
    }
    kind
}
