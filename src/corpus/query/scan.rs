//! The text of a query in pieces: names, operators, values.

use crate::diagnostics::Span;

/// A piece of a query.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Piece<'a> {
    pub(super) text: &'a str,
    pub(super) span: Span,
    /// Whether it stood in quotes.
    pub(super) quoted: bool,
}

/// Walks through a text.
#[derive(Debug, Clone)]
pub(super) struct Cursor<'a> {
    text: &'a str,
    pub(super) at: usize,
}

/// Operators, the longer ones first.
const OPERATORS: [(&str, &str); 11] = [
    ("!=", "!="),
    ("<=", "<="),
    (">=", ">="),
    ("==", "="),
    ("≠", "!="),
    ("≤", "<="),
    ("≥", ">="),
    ("=", "="),
    ("~", "~"),
    ("<", "<"),
    (">", ">"),
];

impl<'a> Cursor<'a> {
    pub(super) fn new(text: &'a str) -> Cursor<'a> {
        Cursor { text, at: 0 }
    }

    pub(super) fn rest(&self) -> &'a str {
        &self.text[self.at..]
    }

    pub(super) fn skip_space(&mut self) {
        self.at = self.text.len() - self.rest().trim_start().len();
    }

    /// The characters up to one that does not belong to a word.
    fn word(&mut self, ends: impl Fn(char) -> bool) -> Piece<'a> {
        let length = self.rest().find(ends).unwrap_or(self.rest().len());
        let (start, text) = (self.at, &self.rest()[..length]);
        self.at += length;
        Piece { text, span: Span::new(start, self.at), quoted: false }
    }

    /// The name of a field; empty where an operator stands there.
    pub(super) fn name(&mut self) -> Piece<'a> {
        self.word(|c| c.is_whitespace() || "=!~<>≠≤≥\"'|:".contains(c))
    }

    /// An operator, perhaps after spaces, as its plain form.
    pub(super) fn operator(&mut self) -> Option<(&'static str, Span)> {
        let mut ahead = self.clone();
        ahead.skip_space();
        let (written, plain) = OPERATORS.into_iter().find(|(written, _)| ahead.rest().starts_with(written))?;
        let span = Span::new(ahead.at, ahead.at + written.len());
        self.at = span.end;
        Some((plain, span))
    }

    /// A value: in quotes, or up to a space, `|` or `>`; `:` ends it where a bound may follow. `Err` is a quote that nothing ends.
    pub(super) fn value(&mut self, bound: bool) -> Result<Piece<'a>, Span> {
        let Some(quote) = self.rest().chars().next().filter(|c| matches!(c, '"' | '\'')) else {
            return Ok(self.word(|c| c.is_whitespace() || "|>".contains(c) || (bound && c == ':')));
        };
        let start = self.at + 1;
        let Some(length) = self.text[start..].find(quote) else {
            let span = Span::new(self.at, self.text.len());
            self.at = self.text.len();
            return Err(span);
        };
        self.at = start + length + 1;
        Ok(Piece { text: &self.text[start..start + length], span: Span::new(start, start + length), quoted: true })
    }

    /// Takes a character if it is next.
    pub(super) fn takes(&mut self, wanted: char) -> bool {
        let is = self.rest().starts_with(wanted);
        if is {
            self.at += wanted.len_utf8();
        }
        is
    }

    /// Passes what is left of a condition that is not understood.
    pub(super) fn give_up(&mut self) {
        self.at += self.rest().find(char::is_whitespace).unwrap_or(self.rest().len());
    }
}

impl<'a> Cursor<'a> {
    /// The text between two places.
    pub(super) fn text_between(&self, start: usize, end: usize) -> &'a str {
        &self.text[start..end]
    }
}
