//! Lines and words: the text cut into tokens, with comments apart.
//!
//! A line is words, texts in double quotes, and the marks `, ( ) =`. A `#` outside a text begins a comment.
//! Gloss lines have more marks and no comments.

use crate::diagnostics::{Diagnostic, Span};
use nom::branch::alt;
use nom::bytes::complete::take_while1;
use nom::character::complete::{char, one_of};
use nom::combinator::{map, recognize};
use nom::{IResult, Parser};

/// What a token is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    /// A run of anything that is not a space, a mark or a quote: words, numbers, names.
    Word,
    /// A text in double quotes, the quotes included.
    Text,
    /// `,`
    Comma,
    /// `(`
    Open,
    /// `)`
    Close,
    /// `=`
    Equals,
    /// A mark of gloss lines alone: one of `@ + [ ] { } < > & : . #`, and `/` for `//`.
    Mark(char),
}

/// Which marks cut a text into tokens.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) enum Dialect {
    /// Descriptions of signs.
    Sign,
    /// Gloss lines.
    Gloss,
}

/// A token of a line.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(crate) struct Token<'a> {
    pub kind: Kind,
    pub text: &'a str,
    pub span: Span,
}

/// A line cut into tokens.
#[derive(Debug)]
pub(crate) struct LexedLine<'a> {
    pub tokens: Vec<Token<'a>>,
    pub comment: Option<&'a str>,
}

/// The lines of a text with their byte offsets, without line ends (LF, CRLF, lone CR). White space after the last line end is none.
pub(crate) fn lines(text: &str) -> impl Iterator<Item = (usize, &str)> {
    let body = text.strip_prefix('\u{feff}').unwrap_or(text);
    let mut offset = text.len() - body.len();
    let body = match body.rsplit_once('\n') {
        Some((before, last)) if last.trim().is_empty() => &body[..=before.len()],
        Some(_) | None => body,
    };
    body.split_inclusive('\n').flat_map(move |raw| {
        let start = offset;
        offset += raw.len();
        let line = raw.strip_suffix('\n').unwrap_or(raw);
        let line = line.strip_suffix('\r').unwrap_or(line);
        let mut at = start;
        line.split('\r').map(move |part| {
            let here = at;
            at += part.len() + 1;
            (here, part)
        })
    })
}

/// Cuts a line into tokens.
///
/// # Errors
/// A text without its closing quote, or a control character.
pub(crate) fn lex(line: &str, offset: usize, dialect: Dialect) -> Result<LexedLine<'_>, Box<Diagnostic>> {
    let mut rest = line;
    let mut tokens = Vec::with_capacity(8);
    loop {
        rest = rest.trim_start_matches(is_space);
        let at = offset + (line.len() - rest.len());
        if rest.is_empty() {
            return Ok(LexedLine { tokens, comment: None });
        }
        if dialect == Dialect::Sign
            && let Some(comment) = rest.strip_prefix('#')
        {
            return Ok(LexedLine { tokens, comment: Some(comment.trim()) });
        }
        let Ok((after, (kind, text))) = token(rest, dialect) else { return Err(unreadable(rest, at)) };
        if kind == Kind::Word
            && let Some(bad) = text.find(char::is_control)
        {
            return Err(unreadable(&text[bad..], at + bad));
        }
        tokens.push(Token { kind, text, span: Span::new(at, at + text.len()) });
        rest = after;
    }
}

fn is_space(c: char) -> bool {
    c.is_whitespace()
}

fn token(rest: &str, dialect: Dialect) -> IResult<&str, (Kind, &str)> {
    if dialect == Dialect::Gloss
        && let Some((c, length)) = gloss_mark(rest)
    {
        return Ok((&rest[length..], (Kind::Mark(c), &rest[..length])));
    }
    alt((
        map(recognize(char(',')), |t| (Kind::Comma, t)),
        map(recognize(char('(')), |t| (Kind::Open, t)),
        map(recognize(char(')')), |t| (Kind::Close, t)),
        map(recognize(char('=')), |t| (Kind::Equals, t)),
        map(quoted, |t| (Kind::Text, t)),
        map(|rest| word(rest, dialect), |t| (Kind::Word, t)),
    ))
    .parse(rest)
}

fn word(rest: &str, dialect: Dialect) -> IResult<&str, &str> {
    let ends = |at: usize, c: char| {
        is_space(c) || ",()=\"#".contains(c) || dialect == Dialect::Gloss && gloss_mark(&rest[at..]).is_some()
    };
    match rest.char_indices().find(|&(at, c)| ends(at, c)) {
        Some((0, _)) => Err(nom::Err::Error(nom::error::Error::new(rest, nom::error::ErrorKind::TakeTill1))),
        Some((at, _)) => Ok((&rest[at..], &rest[..at])),
        None => Ok((&rest[rest.len()..], rest)),
    }
}

/// A mark of gloss lines at the front, and its length in bytes. `+`, `:` and `.` before a digit belong to a number
/// (`+1.4`, `1:30`, `.5`), a point before a letter to a name (`GIVE.TO`).
pub(crate) fn gloss_mark(rest: &str) -> Option<(char, usize)> {
    let mut chars = rest.chars();
    let first = chars.next()?;
    let next = chars.next().unwrap_or(' ');
    let then_digit = |rest: std::str::Chars| rest.as_str().starts_with(|c: char| c.is_ascii_digit());
    let is_mark = match first {
        '@' | '[' | ']' | '{' | '}' | '<' | '>' | '&' | '#' => true,
        '+' => !(next.is_ascii_digit() || next == '.' && then_digit(chars)),
        ':' => !next.is_ascii_digit(),
        '.' => !next.is_alphanumeric(),
        '/' => next == '/',
        _ => false,
    };
    is_mark.then_some((first, if first == '/' { 2 } else { 1 }))
}

/// A text with its quotes; `\` takes the next character as it is.
fn quoted(rest: &str) -> IResult<&str, &str> {
    let inside = nom::multi::fold_many0(
        alt((recognize(take_while1(|c: char| c != '"' && c != '\\')), recognize((char('\\'), one_of("\"\\ntru0"))))),
        || (),
        |(), _| (),
    );
    recognize((char('"'), inside, char('"'))).parse(rest)
}

fn unreadable(rest: &str, at: usize) -> Box<Diagnostic> {
    Box::new(if rest.starts_with('"') {
        Diagnostic::fault(Span::new(at, at + rest.len()), "this text has no closing quote")
            .label("begins here")
            .hint("texts stand between two straight quotes on one line; write a quote inside one as \\\"")
    } else {
        let c = rest.chars().next().unwrap_or('\0');
        Diagnostic::fault(
            Span::new(at, at + c.len_utf8()),
            format!("the control character U+{:04X} cannot stand in a text", u32::from(c)),
        )
        .label("here")
        .hint("the file may have been damaged, or may not be text at all")
    })
}

/// The text between the quotes of a [`Kind::Text`] token, with the escapes `\" \\ \n \t \r \u{…}` read.
pub(crate) fn unquote(text: &str) -> String {
    let inside = text.strip_prefix('"').and_then(|t| t.strip_suffix('"')).unwrap_or(text);
    let mut out = String::with_capacity(inside.len());
    let mut chars = inside.chars();
    while let Some(c) = chars.next() {
        if c != '\\' {
            out.push(c);
            continue;
        }
        match chars.next() {
            Some('n') => out.push('\n'),
            Some('t') => out.push('\t'),
            Some('r') => out.push('\r'),
            Some('0') => out.push('\0'),
            Some('u') => match unicode(chars.as_str()) {
                Some((c, used)) => {
                    out.push(c);
                    chars = chars.as_str()[used..].chars();
                }
                None => out.push('u'),
            },
            Some(other) => out.push(other),
            None => {}
        }
    }
    out
}

/// `{1F600}` at the front: the character and the bytes used.
fn unicode(rest: &str) -> Option<(char, usize)> {
    let close = rest.bytes().take(9).position(|b| b == b'}')?;
    let digits = rest.get(..close)?.strip_prefix('{')?;
    Some((char::from_u32(u32::from_str_radix(digits, 16).ok()?)?, close + 1))
}

/// A text in quotes, as [`unquote`] reads it.
pub(crate) fn quote(text: &str) -> String {
    let mut out = String::with_capacity(text.len() + 2);
    out.push('"');
    for c in text.chars() {
        match c {
            '"' => out.push_str("\\\""),
            '\\' => out.push_str("\\\\"),
            '\n' => out.push_str("\\n"),
            '\t' => out.push_str("\\t"),
            c if c.is_control() || c == '\u{feff}' => out.push_str(&format!("\\u{{{:X}}}", u32::from(c))),
            c => out.push(c),
        }
    }
    out.push('"');
    out
}
