//! A text as words and braces, with their places.

use crate::diagnostics::Span;

/// Where reading stands in a text. All steps go forward.
#[derive(Debug, Clone)]
pub(super) struct Words<'a> {
    pub text: &'a str,
    pub at: usize,
}

/// A word, or a brace by itself.
#[derive(Debug, Clone, Copy, PartialEq)]
pub(super) struct Word<'a> {
    pub text: &'a str,
    pub span: Span,
}

impl Word<'_> {
    /// Whether this is a keyword, in any case.
    pub fn is(self, keyword: &str) -> bool {
        self.text.eq_ignore_ascii_case(keyword)
    }
}

impl<'a> Words<'a> {
    /// At the start of a text, behind a byte order mark.
    pub fn new(text: &'a str) -> Words<'a> {
        Words { text, at: if text.starts_with('\u{feff}') { 3 } else { 0 } }
    }

    fn byte(&self) -> Option<u8> {
        self.text.as_bytes().get(self.at).copied()
    }

    /// Goes over spaces and tabs, not over the end of the line.
    fn skip_blanks(&mut self) {
        while self.byte().is_some_and(is_blank) {
            self.at += 1;
        }
    }

    /// The next word of this line: up to a blank, a brace or the end of the line.
    pub fn next_on_line(&mut self) -> Option<Word<'a>> {
        self.skip_blanks();
        let start = self.at;
        match self.byte()? {
            b'\n' | b'\r' => return None,
            b'{' | b'}' => self.at += 1,
            _ => {
                while self.byte().is_some_and(|b| !(is_blank(b) || matches!(b, b'\n' | b'\r' | b'{' | b'}'))) {
                    self.at += 1;
                }
            }
        }
        Some(Word { text: &self.text[start..self.at], span: Span::new(start, self.at) })
    }

    /// The next word, on this line or below.
    pub fn next(&mut self) -> Option<Word<'a>> {
        loop {
            if let Some(word) = self.next_on_line() {
                return Some(word);
            }
            self.byte()?;
            self.at += 1;
        }
    }

    /// The next word, without going there.
    pub fn peek(&self) -> Option<Word<'a>> {
        self.clone().next()
    }

    /// What stands up to the end of the line or to a brace, without blanks at its ends; possibly nothing.
    pub fn rest_of_line(&mut self) -> Word<'a> {
        self.skip_blanks();
        let start = self.at;
        while self.byte().is_some_and(|b| !matches!(b, b'\n' | b'\r' | b'{' | b'}')) {
            self.at += 1;
        }
        let whole = &self.text[start..self.at];
        let text = whole.trim();
        let start = start + (whole.len() - whole.trim_start().len());
        Word { text, span: Span::new(start, start + text.len()) }
    }

    /// Where a thing that is missing would stand: right behind the last word.
    pub fn here(&self) -> Span {
        Span::new(self.at, self.at)
    }
}

/// Blanks between words and numbers; a line feed ends a row.
#[inline(always)]
pub(super) fn is_blank(byte: u8) -> bool {
    matches!(byte, b' ' | b'\t' | b'\x0b' | b'\x0c')
}
