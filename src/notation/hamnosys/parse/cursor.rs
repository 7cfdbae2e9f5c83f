//! Where the reader is, what it may see, and what it says.

use super::brackets::{Prepared, prepare};
use crate::diagnostics::{Diagnostic, Severity, Span};
use crate::notation::hamnosys::kind::{Bracket, Kind};
use crate::notation::hamnosys::lex::Token;
use crate::notation::hamnosys::symbol::Symbol;

/// A symbol with its class.
#[derive(Debug, Clone, Copy)]
pub(super) struct Lexeme {
    pub kind: Kind,
    pub symbol: Symbol,
    pub span: Span,
}

/// A fault was told; the phase cannot be read on.
#[derive(Debug)]
pub(super) struct Stop;

/// What a part of the grammar comes to.
pub(super) type Read<T> = Result<T, Stop>;

/// Which hands the sign is of: some symbols mean another thing in signs of two hands.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(in crate::notation::hamnosys) enum Handed {
    One,
    Two,
}

/// A reader over prepared symbols.
pub(super) struct Parser {
    lexemes: Vec<Lexeme>,
    partner: Vec<usize>,
    pub diagnostics: Vec<Diagnostic>,
    pub at: usize,
    /// What may be read ends here: the end of a bracket, of its first part, or of all.
    pub limit: usize,
    pub handed: Handed,
    end: Span,
}

impl Parser {
    pub fn new(tokens: &[Token], end: Span) -> Parser {
        let Prepared { lexemes, partner, diagnostics } = prepare(tokens, end);
        let limit = if diagnostics.iter().any(|d| d.severity == Severity::Fault) { 0 } else { lexemes.len() };
        Parser { lexemes, partner, diagnostics, at: 0, limit, handed: Handed::One, end }
    }

    /// The class of the symbol here.
    pub fn peek(&self) -> Option<Kind> {
        self.ahead(0)
    }

    /// The class of the symbol some places on.
    pub fn ahead(&self, steps: usize) -> Option<Kind> {
        self.kind(self.at + steps)
    }

    /// The class of the symbol at an index, within the limit.
    pub fn kind(&self, at: usize) -> Option<Kind> {
        (at < self.limit).then(|| self.lexemes[at].kind)
    }

    /// Goes on by one.
    pub fn next(&mut self) {
        self.at += 1;
    }

    /// Goes on by one if this kind is here.
    pub fn take(&mut self, kind: Kind) -> bool {
        let here = self.peek() == Some(kind);
        if here {
            self.at += 1;
        }
        here
    }

    /// The index of the end of the bracket that opens at an index.
    pub fn closing(&self, open: usize) -> usize {
        self.partner[open]
    }

    /// Reads the inside of the bracket here with a function, which may leave nothing behind, and goes on after it.
    pub fn inside<T>(&mut self, read: impl FnOnce(&mut Parser) -> Read<T>) -> Read<T> {
        let close = self.closing(self.at);
        let limit = std::mem::replace(&mut self.limit, close);
        self.at += 1;
        let result = read(self);
        if result.is_ok() && self.at < close {
            return self.unexpected(&["the end of the bracket"]);
        }
        self.limit = limit;
        self.at = close + 1;
        result
    }

    /// The index of the first plus between here and the limit, outside inner brackets.
    pub fn plus_ahead(&self, from: usize, limit: usize) -> Option<usize> {
        let mut at = from;
        while at < limit {
            match self.lexemes[at].kind {
                Kind::Plus => return Some(at),
                Kind::Open(_) => at = self.partner[at],
                _other => {}
            }
            at += 1;
        }
        None
    }

    /// Whether what is read ends with parallel brackets that hold no plus.
    pub fn in_unsplit_brackets(&self) -> bool {
        match self.lexemes.get(self.limit).map(|l| l.kind) {
            Some(Kind::Close(Bracket::Together)) => self.plus_ahead(self.partner[self.limit] + 1, self.limit).is_none(),
            _other => false,
        }
    }

    /// Whether a bracket of this kind opens here.
    pub fn opens(&self, bracket: Bracket) -> bool {
        self.peek() == Some(Kind::Open(bracket))
    }

    /// Where the symbol here is; the end of the text at the end.
    pub fn span(&self) -> Span {
        self.lexemes.get(self.at).map_or(self.end, |l| l.span)
    }

    /// Where the last symbol was.
    pub fn span_before(&self) -> Span {
        self.at.checked_sub(1).and_then(|at| self.lexemes.get(at)).map_or(self.end, |l| l.span)
    }

    /// Warns of the symbol here; the message begins with its tag.
    pub fn warn(&mut self, what: &str) {
        match self.lexemes.get(self.at) {
            Some(l) => {
                let message = format!("`{}` {what}", l.symbol.tag());
                self.diagnostics.push(Diagnostic::warning(l.span, message).label(l.symbol.name()));
            }
            None => self.diagnostics.push(Diagnostic::warning(self.end, what)),
        }
    }

    /// Warns of something at a place.
    pub fn warn_at(&mut self, span: Span, message: &str, label: &str) {
        self.diagnostics.push(Diagnostic::warning(span, message).label(label));
    }

    /// Warns that the symbol here is passed over, and goes on.
    pub fn skip(&mut self, why: &str) {
        self.warn(&format!("{why}; it is passed over"));
        self.next();
    }

    /// A fault: what stands here cannot stand here, and what could.
    pub fn unexpected<T>(&mut self, expected: &[&str]) -> Read<T> {
        let expected = listed(expected);
        let fault = match self.lexemes.get(self.at) {
            Some(l) if self.at < self.limit || matches!(l.kind, Kind::Close(_) | Kind::Plus) => {
                Diagnostic::fault(l.span, format!("`{}` ({}) cannot stand here", l.symbol.tag(), l.symbol.name()))
            }
            Some(_) | None => Diagnostic::fault(self.end, "the text ends too early"),
        };
        self.diagnostics.push(fault.label(format!("expected {expected}")));
        Err(Stop)
    }

    /// A fault of the symbol here, in words of its own; the message begins with its tag.
    pub fn fault<T>(&mut self, what: &str, hint: &str) -> Read<T> {
        let (span, message, name) = match self.lexemes.get(self.at) {
            Some(l) => (l.span, format!("`{}` {what}", l.symbol.tag()), l.symbol.name()),
            None => (self.end, format!("the text ends too early: this {what}"), "the end"),
        };
        self.diagnostics.push(Diagnostic::fault(span, message).label(name).hint(hint));
        Err(Stop)
    }
}

/// `a`, `a or b`, `a, b or c`.
fn listed(words: &[&str]) -> String {
    match words {
        [] => "nothing more".to_owned(),
        [one] => (*one).to_owned(),
        [most @ .., last] => format!("{} or {last}", most.join(", ")),
    }
}
