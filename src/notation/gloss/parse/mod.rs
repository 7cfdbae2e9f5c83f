//! Text to [`GlossLine`]: item by item, so that a fault spoils one item and no more.

mod face;
mod signed;
mod site;

use super::syntax::{GlossLine, Item, Pause, What};
use crate::diagnostics::{Diagnostic, Span};
use crate::notation::lex::{Dialect, Kind, lex};
use crate::notation::parse::diagnostic;
use crate::notation::parse::input::{Parsed, Tokens, expected, must, told};
use crate::notation::parse::words::{duration, is_word};
use crate::notation::suggest::nearest;
use crate::notation::syntax::{Duration, Ignored};
use crate::phonology::Hand;
use nom::Parser;
use nom::branch::alt;
pub(crate) use signed::is_reserved;
pub(crate) use site::is_place;

/// The most items of a line: more than any song.
const MOST_ITEMS: usize = 10_000;
/// The most faults told of a line.
const MOST_FAULTS: usize = 100;
/// How deep braces may nest.
const DEEPEST: usize = 16;

/// Reads a gloss line; line ends in it are spaces. Items with faults are left out, each with its diagnostic.
///
/// ```
/// let (line, faults) = chereme::notation::gloss::parse("BOL@left IX(0.6,1.4,0.5) TRAVAIL++ fs(OK)");
/// assert!(faults.is_empty());
/// assert_eq!(line.items.len(), 4);
/// ```
pub fn parse(text: &str) -> (GlossLine, Vec<Diagnostic>) {
    let lexed = match lex(text, 0, Dialect::Gloss) {
        Ok(lexed) => lexed,
        Err(fault) => return (GlossLine::default(), vec![*fault]),
    };
    let mut reading = Reading::default();
    let mut rest = Tokens::new(&lexed.tokens);
    let mut items = Vec::new();
    while !rest.is_empty() && !reading.stopped {
        rest = self::items(rest, 0, &mut items, &mut reading);
        if rest.is_mark('}') {
            reading.told(Diagnostic::fault(rest.span(), "this brace was never opened").label("here"));
            rest = rest.skip();
        }
    }
    reading.faults.sort_by_key(|fault| fault.span.start);
    (GlossLine { items }, reading.faults)
}

/// What was found on the way.
#[derive(Default)]
struct Reading {
    faults: Vec<Diagnostic>,
    count: usize,
    /// Nothing more is read: there is too much of it.
    stopped: bool,
}

impl Reading {
    fn told(&mut self, fault: Diagnostic) {
        self.faults.push(fault);
        self.stopped |= self.faults.len() >= MOST_FAULTS;
    }

    fn stop(&mut self, at: Span, why: String, hint: &str) {
        if !self.stopped {
            self.told(Diagnostic::fault(at, why).label("here").hint(hint));
            self.stopped = true;
        }
    }
}

/// Items up to a closing brace or the end.
fn items<'a>(input: Tokens<'a>, depth: usize, all: &mut Vec<Item>, reading: &mut Reading) -> Tokens<'a> {
    let mut rest = input;
    while !rest.is_empty() && !rest.is_mark('}') && !reading.stopped {
        reading.count += 1;
        if reading.count > MOST_ITEMS {
            reading.stop(rest.span(), format!("more than {MOST_ITEMS} items in one line"), "cut it into several lines");
            break;
        }
        if rest.is_mark('{') {
            rest = face::face(rest, depth, all, reading);
            continue;
        }
        match item(rest) {
            Ok((after, what)) => {
                all.push(Item { what, span: Ignored(rest.span_to(after)) });
                rest = after;
            }
            Err(error) => {
                let fault = diagnostic(error, rest);
                rest = past(rest, fault.span);
                reading.told(fault);
            }
        }
    }
    rest
}

/// Where reading goes on after a fault: past what it covers, the brackets that it opens, and what touches it.
fn past<'a>(input: Tokens<'a>, fault: Span) -> Tokens<'a> {
    let mut depth = 0usize;
    let mut rest = input;
    let mut end = input.span().start;
    while let Some(token) = rest.first() {
        let covered = token.span.start < fault.end || token.span.start == end;
        match token.kind {
            Kind::Mark('{' | '}') if end > input.span().start => break,
            _ if depth == 0 && !covered => break,
            Kind::Open | Kind::Mark('[' | '<') => depth += 1,
            Kind::Close | Kind::Mark(']' | '>') => depth = depth.saturating_sub(1),
            Kind::Word | Kind::Text | Kind::Comma | Kind::Equals | Kind::Mark(_) => {}
        }
        end = token.span.end;
        rest = rest.skip();
    }
    rest
}

fn item<'a>(input: Tokens<'a>) -> Parsed<'a, What> {
    alt((pause, angle, signs)).parse(input)
}

fn pause<'a>(input: Tokens<'a>) -> Parsed<'a, What> {
    match input.first().map(|t| t.kind) {
        Some(Kind::Comma) => Ok((input.skip(), What::Pause(Pause::Short))),
        Some(Kind::Mark('.' | '/')) => Ok((input.skip(), What::Pause(Pause::Long))),
        _ => expected(input, "a pause"),
    }
}

/// `<HOLD weak 0.5s>`, `<REST 1s>`
fn angle<'a>(input: Tokens<'a>) -> Parsed<'a, What> {
    if !input.is_mark('<') {
        return expected(input, "`<HOLD>` or `<REST>`");
    }
    let at = input.skip();
    let hold = is_word(at, "hold");
    if !hold && !is_word(at, "rest") {
        let fault = Diagnostic::fault(at.span(), "between `<` and `>` stands HOLD or REST").label("here");
        return told(match nearest(at.word(), ["HOLD", "REST"]) {
            Some(near) => fault.hint(format!("did you mean `<{near}>`?")),
            None => {
                fault.hint("`<HOLD 0.5s>` keeps the posture, `<HOLD weak>` that of one hand, `<REST>` lowers the hands")
            }
        });
    }
    let rest = at.skip();
    let (rest, hand) = hand(rest);
    let (rest, long) = length(rest)?;
    // `<HOLD 0.5s weak>` reads as well.
    let (rest, hand) = if hand.is_none() { self::hand(rest) } else { (rest, hand) };
    if !rest.is_mark('>') {
        let fault = Diagnostic::fault(rest.span(), "the closing `>` is missing").label("expected here");
        return told(
            fault
                .hint("write `<HOLD>`, `<HOLD 0.5s>`, `<HOLD weak>`, `<REST>` or `<REST 1s>`")
                .related(input.span(), "opened here"),
        );
    }
    match (hold, hand) {
        (true, hand) => Ok((rest.skip(), What::Hold(hand, long))),
        (false, None) => Ok((rest.skip(), What::Rest(long))),
        (false, Some(_)) => told(
            Diagnostic::fault(input.span_to(rest.skip()), "both hands rest, or none")
                .label("here")
                .hint("one hand can be held: `<HOLD weak>`"),
        ),
    }
}

fn hand(input: Tokens) -> (Tokens, Option<Hand>) {
    if is_word(input, "weak") {
        (input.skip(), Some(Hand::Weak))
    } else if is_word(input, "strong") {
        (input.skip(), Some(Hand::Strong))
    } else {
        (input, None)
    }
}

fn length<'a>(input: Tokens<'a>) -> Parsed<'a, Option<Duration>> {
    if input.word().starts_with(|c: char| c.is_ascii_digit() || ".+-".contains(c)) {
        return must(duration(input)).map(|(rest, long)| (rest, Some(long)));
    }
    Ok((input, None))
}

/// A sign, or two at the same time.
fn signs<'a>(input: Tokens<'a>) -> Parsed<'a, What> {
    let (rest, strong) = signed::signed(input)?;
    if !rest.is_mark('&') {
        return Ok((rest, What::Signed(Box::new(strong))));
    }
    let (after, weak) = must(signed::signed(rest.skip()))?;
    let fault = if after.is_mark('&') {
        Diagnostic::fault(after.span(), "three signs at the same time").hint("there are two hands: `A & B`")
    } else if strong.hand == Hand::Weak || weak.hand == Hand::Weak {
        Diagnostic::fault(rest.span(), "`&` gives the first sign to the strong hand, the second to the weak one")
            .hint("leave out `weak(…)`")
    } else {
        return Ok((after, What::Together(Box::new(strong), Box::new(weak))));
    };
    told(fault.label("here"))
}
