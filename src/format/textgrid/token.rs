//! What Praat sees of a text file: free-standing numbers, texts, flags.

use crate::diagnostics::Span;
use std::borrow::Cow;

/// One of them.
#[derive(Debug, Clone, PartialEq)]
pub(super) enum Token<'a> {
    Number(f64),
    Text(Cow<'a, str>),
    /// `<exists>`, without the brackets.
    Flag(&'a str),
    /// A text whose quotation mark is not closed.
    Open,
}

/// Where reading stands.
#[derive(Debug, Clone)]
pub(super) struct Tokens<'a> {
    text: &'a str,
    at: usize,
}

impl<'a> Tokens<'a> {
    pub fn new(text: &'a str) -> Tokens<'a> {
        Tokens { text, at: 0 }
    }

    /// The place right behind the last token.
    pub fn here(&self) -> Span {
        let at = self.at.min(self.text.len());
        Span::new(at, at)
    }

    /// The next token and its place; words and what follows a `!` are comments.
    pub fn next(&mut self) -> Option<(Token<'a>, Span)> {
        let bytes = self.text.as_bytes();
        loop {
            while bytes.get(self.at).is_some_and(u8::is_ascii_whitespace) {
                self.at += 1;
            }
            let start = self.at;
            match *bytes.get(start)? {
                b'"' => return Some(self.quoted(start)),
                b'!' => self.skip(|b| b == b'\n' || b == b'\r'),
                _ => {
                    self.skip(|b| b.is_ascii_whitespace());
                    let word = &self.text[start..self.at];
                    if let Some(token) = standing(word) {
                        return Some((token, Span::new(start, self.at)));
                    }
                }
            }
        }
    }

    fn skip(&mut self, ends: impl Fn(u8) -> bool) {
        let rest = &self.text.as_bytes()[self.at..];
        self.at += rest.iter().position(|b| ends(*b)).unwrap_or(rest.len());
    }

    fn quoted(&mut self, start: usize) -> (Token<'a>, Span) {
        let bytes = self.text.as_bytes();
        let mut at = start + 1;
        let mut doubled = false;
        loop {
            match bytes[at..].iter().position(|b| *b == b'"') {
                None => {
                    self.at = self.text.len();
                    let line = self.text[start..].find(['\n', '\r']).map_or(self.at, |i| start + i);
                    return (Token::Open, Span::new(start, line));
                }
                Some(i) if bytes.get(at + i + 1) == Some(&b'"') => {
                    doubled = true;
                    at += i + 2;
                }
                Some(i) => {
                    at += i;
                    break;
                }
            }
        }
        let inner = &self.text[start + 1..at];
        self.at = at + 1;
        let text = if doubled { inner.replace("\"\"", "\"").into() } else { inner.into() };
        (Token::Text(text), Span::new(start, self.at))
    }
}

/// A word that is a number or a flag.
fn standing(word: &str) -> Option<Token<'_>> {
    if let Some(flag) = word.strip_prefix('<').and_then(|w| w.strip_suffix('>')) {
        return Some(Token::Flag(flag));
    }
    let begins = |b: &u8| b.is_ascii_digit() || matches!(b, b'-' | b'+' | b'.');
    let number = word.as_bytes().first().is_some_and(begins).then(|| word.parse().ok()).flatten();
    number.filter(|n: &f64| n.is_finite()).map(Token::Number)
}
