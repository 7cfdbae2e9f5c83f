//! HamNoSys text as symbols: characters of the font, names, or both.
//!
//! ```text
//!            hamfist,hamextfingeru,hampalmd          fist extfingeru palmd
//! ```
//! Characters of the private use area are symbols by themselves. Names stand apart by commas, semicolons or white space, with or
//! without `ham`. A comma between names is therefore no symbol; the punctuation of HamNoSys is `hamcomma`. White space, `hamspace`,
//! marks of layout and the mark of the version say nothing and are left out. The braces and the bar of alternatives,
//! `!`, `?` and the full stop are symbols here; `parse` says what becomes of them.

use super::kind::Kind;
use super::symbol::{Spelling, Symbol, spelling};
use crate::diagnostics::{Diagnostic, Span};

/// A symbol and where it was written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Token {
    /// The symbol.
    pub symbol: Symbol,
    /// Where.
    pub span: Span,
}

/// The symbols of a text, and what is wrong with it. What is no symbol is a fault and left out.
///
/// ```
/// use chereme::notation::hamnosys::lex::lex;
/// let (tokens, diagnostics) = lex("\u{e000} hamextfingeru, palmd");
/// assert!(diagnostics.is_empty());
/// assert_eq!(tokens.iter().map(|t| t.symbol.tag()).collect::<Vec<_>>(), ["hamfist", "hamextfingeru", "hampalmd"]);
/// ```
pub fn lex(text: &str) -> (Vec<Token>, Vec<Diagnostic>) {
    let mut tokens = Vec::with_capacity(text.len() / 3);
    let mut diagnostics = Vec::new();
    let mut rest = text.char_indices().peekable();
    while let Some((start, c)) = rest.next() {
        if c.is_ascii_alphanumeric() || c == '_' {
            while rest.next_if(|(_, c)| c.is_ascii_alphanumeric() || *c == '_').is_some() {}
            let end = rest.peek().map_or(text.len(), |(at, _)| *at);
            let (token, wrong) = named(&text[start..end], Span::new(start, end));
            tokens.extend(token);
            diagnostics.extend(wrong);
        } else if !c.is_whitespace() && !matches!(c, ',' | ';' | '\u{feff}') {
            let span = Span::new(start, start + c.len_utf8());
            match Symbol::of_char(c) {
                Some(symbol) if symbol.kind() == Kind::Silent => {}
                Some(symbol) => tokens.push(Token { symbol, span }),
                None => unknown_character(c, span, &mut diagnostics),
            }
        }
    }
    (tokens, diagnostics)
}

/// The symbol of one name, as in SiGML's elements; nothing for marks of layout and for what is no name.
///
/// ```
/// use chereme::{diagnostics::Span, notation::hamnosys::lex::named};
/// let (token, warning) = named("hamindxfinger", Span::new(0, 13));
/// assert_eq!(token.unwrap().symbol.tag(), "hamindexfinger");
/// assert!(warning.unwrap().message.contains("hamindexfinger"));
/// ```
pub fn named(word: &str, span: Span) -> (Option<Token>, Option<Diagnostic>) {
    match spelling(word) {
        Spelling::Layout => (None, None),
        Spelling::Right(symbol) if symbol.kind() == Kind::Silent => (None, None),
        Spelling::Right(symbol) => (Some(Token { symbol, span }), None),
        Spelling::Mended(symbol) => {
            let warning = Diagnostic::warning(span, format!("`{}` is read as `{}`", short(word), symbol.tag()))
                .label(symbol.name())
                .hint(format!("HamNoSys's name is `{}`", symbol.tag()));
            (Some(Token { symbol, span }), Some(warning))
        }
        Spelling::Unknown(near) => {
            let fault = Diagnostic::fault(span, format!("HamNoSys has no symbol `{}`", short(word))).label("no symbol");
            let fault = match near {
                Some(symbol) => fault.hint(format!("did you mean `{}` ({})?", symbol.tag(), symbol.name())),
                None => fault.hint("symbols are characters of the HamNoSys font, or names such as `hamflathand`"),
            };
            (None, Some(fault))
        }
    }
}

/// A word cut to a length that a message can hold.
fn short(word: &str) -> String {
    const LONGEST: usize = 40;
    match word.char_indices().nth(LONGEST) {
        Some((at, _)) => format!("{}…", &word[..at]),
        None => word.to_owned(),
    }
}

/// Says what a character is that is none of HamNoSys; a run of them is told once.
fn unknown_character(c: char, span: Span, diagnostics: &mut Vec<Diagnostic>) {
    const MESSAGE: &str = "this is not HamNoSys";
    if let Some(last) = diagnostics.last_mut()
        && last.message == MESSAGE
        && last.span.end == span.start
    {
        last.span.end = span.end;
        return;
    }
    let fault = Diagnostic::fault(span, MESSAGE).label("no symbol");
    diagnostics.push(match c {
        '<' => {
            fault.hint("text with `<` and `>` is SiGML: give it to the reader of SiGML, as a file that ends in .sigml")
        }
        '\u{e000}'..='\u{f8ff}' => fault
            .hint(format!("U+{:04X} is private, but HamNoSys 4 has nothing there", c as u32))
            .hint("texts in the fonts before HamNoSys 4 and in SignWriting's use other characters"),
        _other => {
            fault.hint("symbols are characters of the HamNoSys font (U+E000 to U+E0F1), or names such as `hamflathand`")
        }
    });
}
