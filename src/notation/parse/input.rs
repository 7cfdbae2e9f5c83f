//! The tokens of a line as nom's input, and our error: where, and what was expected.

use crate::diagnostics::{Diagnostic, Span};
use crate::notation::lex::{Kind, Token};
use nom::error::{ErrorKind, ParseError};
use nom::{IResult, Input, Needed};

/// What is left of a line.
#[derive(Debug, Clone, Copy)]
pub(crate) struct Tokens<'a> {
    rest: &'a [Token<'a>],
    /// Where the line's last token ends: the place of what is missing at the end.
    end: usize,
}

impl<'a> Tokens<'a> {
    pub(crate) fn new(rest: &'a [Token<'a>]) -> Tokens<'a> {
        Tokens { rest, end: rest.last().map_or(0, |t| t.span.end) }
    }

    /// The next token.
    pub(crate) fn first(self) -> Option<Token<'a>> {
        self.rest.first().copied()
    }

    /// The text of the next token where it is a word, else the empty text.
    pub(crate) fn word(self) -> &'a str {
        self.first().filter(|t| t.kind == Kind::Word).map_or("", |t| t.text)
    }

    /// Whether the next token is of that kind.
    pub(crate) fn is(self, kind: Kind) -> bool {
        self.first().is_some_and(|t| t.kind == kind)
    }

    /// Whether the next token is that mark of gloss lines.
    pub(crate) fn is_mark(self, mark: char) -> bool {
        self.is(Kind::Mark(mark))
    }

    /// Whether no space stands between what was read, from here on, and the rest of it.
    pub(crate) fn touches(self, after: Tokens<'a>) -> bool {
        !after.is_empty() && self.span_to(after).end == after.span().start
    }

    /// Past the next token.
    pub(crate) fn skip(self) -> Tokens<'a> {
        self.skip_n(1)
    }

    /// Past some tokens.
    pub(crate) fn skip_n(self, n: usize) -> Tokens<'a> {
        Tokens { rest: self.rest.get(n..).unwrap_or(&[]), end: self.end }
    }

    /// Only the next tokens; what is missing after them is missing where the next one stands.
    pub(crate) fn first_n(self, n: usize) -> Tokens<'a> {
        let end = self.rest.get(n).map_or(self.end, |t| t.span.start);
        Tokens { rest: self.rest.get(..n).unwrap_or(self.rest), end }
    }

    /// Where the next token stands, or the end of the line.
    pub(crate) fn span(self) -> Span {
        self.first().map_or(Span::new(self.end, self.end), |t| t.span)
    }

    /// From here to where another part of the same line begins.
    pub(crate) fn span_to(self, after: Tokens<'a>) -> Span {
        let used = self.rest.len().saturating_sub(after.rest.len());
        let first = self.span();
        self.rest.get(used.wrapping_sub(1)).map_or(first, |last| first.to(last.span))
    }

    pub(crate) fn is_empty(self) -> bool {
        self.rest.is_empty()
    }

    pub(crate) fn all(self) -> &'a [Token<'a>] {
        self.rest
    }
}

/// Lets nom's own combinators (`alt`, `many0`, `opt`, …) run over tokens.
impl<'a> Input for Tokens<'a> {
    type Item = Token<'a>;
    type Iter = std::iter::Copied<std::slice::Iter<'a, Token<'a>>>;
    type IterIndices = std::iter::Enumerate<Self::Iter>;

    fn input_len(&self) -> usize {
        self.rest.len()
    }
    fn take(&self, index: usize) -> Self {
        Tokens { rest: &self.rest[..index], end: self.end }
    }
    fn take_from(&self, index: usize) -> Self {
        Tokens { rest: &self.rest[index..], end: self.end }
    }
    fn take_split(&self, index: usize) -> (Self, Self) {
        (self.take_from(index), self.take(index))
    }
    fn position<P: Fn(Self::Item) -> bool>(&self, predicate: P) -> Option<usize> {
        self.rest.iter().position(|t| predicate(*t))
    }
    fn iter_elements(&self) -> Self::Iter {
        self.rest.iter().copied()
    }
    fn iter_indices(&self) -> Self::IterIndices {
        self.rest.iter().copied().enumerate()
    }
    fn slice_index(&self, count: usize) -> Result<usize, Needed> {
        if count <= self.rest.len() { Ok(count) } else { Err(Needed::new(count - self.rest.len())) }
    }
}

/// Why a parser did not succeed.
#[derive(Debug)]
pub(crate) enum Mistake {
    /// Something else was expected there; another alternative may still fit.
    Expected { at: Span, what: &'static str },
    /// The fault is known, and told.
    Told(Box<Diagnostic>),
}

impl<'a> ParseError<Tokens<'a>> for Mistake {
    fn from_error_kind(input: Tokens<'a>, _: ErrorKind) -> Self {
        Mistake::Expected { at: input.span(), what: "something else" }
    }
    fn append(_: Tokens<'a>, _: ErrorKind, other: Self) -> Self {
        other
    }
    /// Of two alternatives the one that came further knows better.
    fn or(self, other: Self) -> Self {
        match (&self, &other) {
            (Mistake::Expected { at, .. }, Mistake::Expected { at: later, .. }) if later.start < at.start => self,
            (Mistake::Told(_), _) => self,
            _ => other,
        }
    }
}

/// The result of a parser over tokens.
pub(crate) type Parsed<'a, T> = IResult<Tokens<'a>, T, Mistake>;

/// Another alternative may fit.
pub(crate) fn expected<'a, T>(at: Tokens<'a>, what: &'static str) -> Parsed<'a, T> {
    Err(nom::Err::Error(Mistake::Expected { at: at.span(), what }))
}

/// The fault is certain: no other alternative is tried.
pub(crate) fn told<'a, T>(diagnostic: Diagnostic) -> Parsed<'a, T> {
    Err(nom::Err::Failure(Mistake::Told(Box::new(diagnostic))))
}

/// Makes what the parser expects certain: past this point nothing else can be meant.
pub(crate) fn must<'a, T>(result: Parsed<'a, T>) -> Parsed<'a, T> {
    result.map_err(|error| match error {
        nom::Err::Error(mistake) => nom::Err::Failure(mistake),
        other => other,
    })
}
