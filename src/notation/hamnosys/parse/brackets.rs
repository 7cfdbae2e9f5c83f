//! Before the grammar: what says nothing goes, alternatives are chosen, brackets are paired and mended.

use super::cursor::Lexeme;
use crate::diagnostics::{Diagnostic, Span};
use crate::notation::hamnosys::kind::{Bracket, Kind};
use crate::notation::hamnosys::lex::Token;
use crate::notation::hamnosys::symbol::Symbol;

/// How deep brackets may nest.
const DEEPEST: usize = 64;

/// The symbols that the grammar reads, with the partner of each bracket.
pub(super) struct Prepared {
    pub lexemes: Vec<Lexeme>,
    /// For each bracket the index of its partner; elsewhere the index itself.
    pub partner: Vec<usize>,
    pub diagnostics: Vec<Diagnostic>,
}

/// Prepares the symbols of a text that ends at `end`.
pub(super) fn prepare(tokens: &[Token], end: Span) -> Prepared {
    let mut pairing = Pairing {
        out: Prepared {
            lexemes: Vec::with_capacity(tokens.len()),
            partner: Vec::with_capacity(tokens.len()),
            diagnostics: Vec::new(),
        },
        open: Vec::new(),
    };
    let mut choice = Choice::default();
    for (i, token) in tokens.iter().enumerate() {
        let lexeme = Lexeme { kind: token.symbol.kind(), symbol: token.symbol, span: token.span };
        if choice.passes(&lexeme, &mut pairing.out.diagnostics) {
            pairing.take(lexeme, i + 1 == tokens.len());
        }
    }
    choice.end(&mut pairing.out.diagnostics);
    while let Some((_, bracket, at)) = pairing.open.last().copied() {
        let opened = pairing.out.lexemes[at];
        pairing.out.diagnostics.push(
            Diagnostic::warning(opened.span, format!("`{}` is never closed", opened.symbol.tag()))
                .label("read as closed at the end"),
        );
        pairing.close(bracket, end);
    }
    pairing.out
}

/// Alternatives `{a|b}`: of each the first is read.
#[derive(Default)]
struct Choice {
    /// For each pair of braces that is open: where it began, and whether the first alternative is over.
    open: Vec<(Span, Over)>,
    /// A bar outside braces ends the text.
    over: bool,
}

#[derive(PartialEq)]
enum Over {
    No,
    Yes,
}

impl Choice {
    /// Whether a symbol is outside alternatives or in the first of each.
    fn passes(&mut self, lexeme: &Lexeme, diagnostics: &mut Vec<Diagnostic>) -> bool {
        match lexeme.kind {
            Kind::AlternativesBegin => self.open.push((lexeme.span, Over::No)),
            Kind::Or => match self.open.last_mut() {
                Some((_, over)) => *over = Over::Yes,
                None if self.over => {}
                None => {
                    self.over = true;
                    let message = "only the first of the alternatives is read";
                    diagnostics.push(Diagnostic::warning(lexeme.span, message).label("what follows is passed over"));
                }
            },
            Kind::AlternativesEnd => match self.open.pop() {
                Some((start, Over::Yes)) => {
                    let message = "only the first of the alternatives is read";
                    diagnostics.push(Diagnostic::warning(start.to(lexeme.span), message).label("alternatives"));
                }
                Some((start, Over::No)) => {
                    let message = "braces around one alternative say nothing";
                    diagnostics.push(Diagnostic::warning(start.to(lexeme.span), message).label("passed over"));
                }
                None => {
                    diagnostics.push(Diagnostic::warning(lexeme.span, "this brace closes nothing").label("passed over"))
                }
            },
            _other => return !self.over && self.open.iter().all(|(_, over)| *over == Over::No),
        }
        false
    }

    fn end(&self, diagnostics: &mut Vec<Diagnostic>) {
        if let Some((start, _)) = self.open.first() {
            diagnostics.push(Diagnostic::warning(*start, "this brace is never closed").label("read to the end"));
        }
    }
}

/// Pairs brackets.
struct Pairing {
    out: Prepared,
    /// What is open: how many brackets are above it, its kind, where it is.
    open: Vec<(usize, Bracket, usize)>,
}

impl Pairing {
    fn take(&mut self, lexeme: Lexeme, last: bool) {
        match lexeme.kind {
            Kind::Silent => {}
            Kind::Mime => self.warn(lexeme, "says that what follows is mimed; it is read as it is written"),
            Kind::Punctuation => self.punctuation(lexeme, last),
            Kind::Open(bracket) => {
                let above = self.open.len();
                if above == DEEPEST {
                    let message = format!("brackets nest deeper than {DEEPEST}");
                    self.out.diagnostics.push(Diagnostic::fault(lexeme.span, message).label("too deep"));
                }
                self.open.push((above, bracket, self.out.lexemes.len()));
                self.push(lexeme);
            }
            Kind::Close(bracket) => self.closing(lexeme, bracket),
            kind if doubled(kind) && self.out.lexemes.last().is_some_and(|l| l.kind == kind) => {
                self.warn(lexeme, "is written twice in a row; it is read once");
            }
            _other => self.push(lexeme),
        }
    }

    /// A mark of utterances: in the middle it parts signs, elsewhere it says nothing of a sign.
    fn punctuation(&mut self, lexeme: Lexeme, last: bool) {
        let parts = !last && self.open.is_empty() && !self.out.lexemes.is_empty();
        if parts {
            self.warn(lexeme, "parts signs; they are read as one, one after the other");
            self.push(Lexeme { kind: Kind::Plus, ..lexeme });
        } else {
            self.warn(lexeme, "says nothing of a sign; it is passed over");
        }
    }

    fn closing(&mut self, lexeme: Lexeme, bracket: Bracket) {
        let Some(&(_, top, _)) = self.open.last() else {
            return self.warn(lexeme, "closes nothing; it is passed over");
        };
        if top == bracket {
            return self.close(bracket, lexeme.span);
        }
        if !self.open.iter().any(|(_, open, _)| *open == bracket) {
            self.warn(lexeme, &format!("closes `{}`; it is read as `{}`", begin(top).tag(), end(top).tag()));
            return self.close(top, lexeme.span);
        }
        while let Some(&(_, top, at)) = self.open.last() {
            if top != bracket {
                let opened = self.out.lexemes[at];
                self.warn(opened, &format!("is not closed; it is read as closed before `{}`", lexeme.symbol.tag()));
            }
            self.close(top, lexeme.span);
            if top == bracket {
                return;
            }
        }
    }

    /// Closes the innermost bracket.
    fn close(&mut self, bracket: Bracket, span: Span) {
        if let Some((_, _, at)) = self.open.pop() {
            let here = self.out.lexemes.len();
            self.out.partner[at] = here;
            self.out.lexemes.push(Lexeme { kind: Kind::Close(bracket), symbol: end(bracket), span });
            self.out.partner.push(at);
        }
    }

    fn push(&mut self, lexeme: Lexeme) {
        self.out.partner.push(self.out.lexemes.len());
        self.out.lexemes.push(lexeme);
    }

    fn warn(&mut self, lexeme: Lexeme, what: &str) {
        let message = format!("`{}` {what}", lexeme.symbol.tag());
        self.out.diagnostics.push(Diagnostic::warning(lexeme.span, message).label(lexeme.symbol.name()));
    }
}

/// Symbols that say nothing more when they stand twice.
fn doubled(kind: Kind) -> bool {
    matches!(
        kind,
        Kind::Class(_)
            | Kind::Thumb(_)
            | Kind::Fingers(_)
            | Kind::Palm(_)
            | Kind::Body(_)
            | Kind::Arm(_)
            | Kind::Contact(_)
            | Kind::Size(_)
            | Kind::Manner(_)
            | Kind::Symmetry(_)
            | Kind::Etc
            | Kind::Between
            | Kind::Plus
    )
}

/// The symbol that opens a bracket.
pub(super) fn begin(bracket: Bracket) -> Symbol {
    Symbol::known(match bracket {
        Bracket::Together => "hamparbegin",
        Bracket::Sequence => "hamseqbegin",
        Bracket::Fusion => "hamfusionbegin",
    })
}

/// The symbol that closes a bracket.
pub(super) fn end(bracket: Bracket) -> Symbol {
    Symbol::known(match bracket {
        Bracket::Together => "hamparend",
        Bracket::Sequence => "hamseqend",
        Bracket::Fusion => "hamfusionend",
    })
}
