//! A sign with what is said of it: `BOL@left++`, `IX(MAISON)`, `fs(LSF)`, `weak(BOL)`.

use super::site::{self, unclosed};
use crate::diagnostics::{Diagnostic, Span, Spanned};
use crate::notation::gloss::syntax::{Head, Signed, Site};
use crate::notation::lex::{Kind, Token, unquote};
use crate::notation::parse::input::{Parsed, Tokens, expected, must, told};
use crate::notation::parse::recombination::operators_alone;
use crate::notation::parse::words::{is_one_of, is_word};
use crate::notation::suggest::nearest;
use crate::notation::syntax::Operator;
use crate::phonology::Hand;
use crate::phonology::recombination::{ManualChannel, Taken};
use unicode_normalization::UnicodeNormalization;

/// The most performances of one sign.
const MOST_PERFORMANCES: u8 = 20;

/// What stands before brackets.
const CALLS: [&str; 5] = ["IX", "wrist", "fs", "take", "weak"];

/// Whether a name means something else in a gloss line, so that as a gloss it stands in quotes.
pub(crate) fn is_reserved(name: &str) -> bool {
    is_one_of(name, &CALLS)
}

/// A sign and its suffixes, up to the next space.
pub(super) fn signed<'a>(input: Tokens<'a>) -> Parsed<'a, Signed> {
    if is_word(input, "weak") {
        return weak(input);
    }
    let (rest, head) = head(input)?;
    let head = Spanned::new(head, input.span_to(rest));
    let one = Spanned::new(1, Span::default());
    let operators = Spanned::new(Vec::new(), Span::default());
    let signed = Signed { head, hand: Hand::Strong, site: None, performances: one, operators };
    let (rest, signed) = suffixes(input, rest, signed)?;
    separated(input, rest)?;
    Ok((rest, signed))
}

/// `weak(GLOSS)`
fn weak<'a>(input: Tokens<'a>) -> Parsed<'a, Signed> {
    let open = opened(input, "which sign does the weak hand make?", "write `weak(BOL)`")?.0;
    if is_word(open.skip(), "weak") {
        return told(Diagnostic::fault(open.skip().span(), "`weak` within `weak`").label("once is enough"));
    }
    let (rest, inner) = must(signed(open.skip()))?;
    if !rest.is(Kind::Close) {
        return unclosed(open, rest, "one sign stands in the brackets: `weak(BOL@left)`");
    }
    let rest = rest.skip();
    if input.touches(rest) && is_suffix(rest) {
        return told(
            Diagnostic::fault(rest.span(), "nothing is said of a sign behind the bracket of `weak`")
                .label("here")
                .hint("say it inside: `weak(BOL@left)`"),
        );
    }
    separated(input, rest)?;
    Ok((rest, Signed { hand: Hand::Weak, ..inner }))
}

/// The bracket that touches a word, or a fault.
fn opened<'a>(input: Tokens<'a>, what: &str, hint: &str) -> Parsed<'a, ()> {
    let rest = input.skip();
    if !rest.is(Kind::Open) {
        return told(Diagnostic::fault(input.span(), what).label("a bracket follows it").hint(hint));
    }
    if !input.touches(rest) {
        return told(
            Diagnostic::fault(input.span_to(rest.skip()), "a space before the bracket")
                .label("without a space")
                .hint(hint),
        );
    }
    Ok((rest, ()))
}

fn head<'a>(input: Tokens<'a>) -> Parsed<'a, Head> {
    let Some(token) = input.first() else { return expected(input, "a sign") };
    match token.kind {
        Kind::Text => gloss(input, unquote(token.text)),
        Kind::Word if is_word(input, "ix") => pointing(input),
        Kind::Word if is_word(input, "wrist") => {
            let open = opened(input, "where is the wrist brought?", "write `wrist(0.3,1.2,0.4)`")?.0;
            must(site::in_brackets(open)).map(|(rest, site)| (rest, Head::Wrist(site)))
        }
        Kind::Word if is_word(input, "fs") => spelled(input),
        Kind::Word if is_word(input, "take") => taken(input),
        Kind::Word => gloss(input, token.text.to_owned()),
        Kind::Open | Kind::Close | Kind::Comma | Kind::Equals | Kind::Mark(_) => no_sign(input),
    }
}

fn gloss<'a>(input: Tokens<'a>, name: String) -> Parsed<'a, Head> {
    let rest = input.skip();
    let written = input.is(Kind::Word);
    if name.trim().is_empty() {
        return told(Diagnostic::fault(input.span(), "the name of this sign is empty").label("here"));
    }
    if written && name.contains('+') {
        return told(
            Diagnostic::fault(input.span(), "`+` is followed by something")
                .label("here")
                .hint("each `+` behind a gloss adds a performance: `TRAVAIL++` is made three times")
                .hint("a name that has a `+` in it stands in quotes"),
        );
    }
    if rest.is(Kind::Open) && input.touches(rest) {
        let fault = Diagnostic::fault(input.span_to(rest.skip()), format!("`{name}` takes no brackets")).label("here");
        return told(match nearest(&name, CALLS.into_iter().chain(["INDEX", "POINT"])) {
            Some("INDEX" | "POINT") => fault.hint("pointing is `IX(0.6,1.4,0.5)`, `IX@left` or `IX(MAISON)`"),
            Some(near) => fault.hint(format!("did you mean `{near}(…)`?")),
            None => fault
                .hint(format!(
                    "a place stands after `@`: `{name}@(0.3,1.2,0.4)`; changes in square brackets: `{name}[big]`"
                ))
                .hint("brackets follow IX, wrist, fs, take and weak"),
        });
    }
    Ok((rest, Head::Gloss(name.trim().nfc().collect())))
}

fn pointing<'a>(input: Tokens<'a>) -> Parsed<'a, Head> {
    let hint = "write `IX(0.6,1.4,0.5)`, `IX@left` or, at a sign made before, `IX(MAISON)`; operators stand behind it";
    let rest = input.skip();
    if rest.is_mark('@') && input.touches(rest) {
        let (rest, site) = must(site::site(rest.skip()))?;
        return Ok((rest, Head::Pointing(site)));
    }
    let open = opened(input, "what is pointed at?", hint)?.0;
    let (rest, site) = must(site::in_brackets(open))?;
    Ok((rest, Head::Pointing(site)))
}

/// `fs(LSF)`, `fs("week-end")`: what stands between the brackets, as it stands.
fn spelled<'a>(input: Tokens<'a>) -> Parsed<'a, Head> {
    let open = opened(input, "which word is spelled?", "write `fs(LSF)`")?.0;
    let mut rest = open.skip();
    let mut word = String::new();
    while !rest.is(Kind::Close) {
        let ends = rest.is(Kind::Open) || ['{', '}', '<', '['].into_iter().any(|mark| rest.is_mark(mark));
        let Some(token) = rest.first().filter(|_| !ends) else {
            return unclosed(open, rest, "write `fs(LSF)`; a word with marks stands in quotes: `fs(\"a.b\")`");
        };
        if !word.is_empty() && !open.skip().touches(rest) {
            word.push(' ');
        }
        word.push_str(&if token.kind == Kind::Text { unquote(token.text) } else { token.text.to_owned() });
        rest = rest.skip();
    }
    let word: String = word.trim().nfc().collect();
    if word.is_empty() {
        return told(Diagnostic::fault(open.span_to(rest.skip()), "which word is spelled?").label("it is missing"));
    }
    Ok((rest.skip(), Head::Spelled(word)))
}

/// `take(father_3)`, `take(father_3, configuration eight_2)`: takes of a corpus by their names.
fn taken<'a>(input: Tokens<'a>) -> Parsed<'a, Head> {
    const HINT: &str = "write `take(father_3)`, or with another take's fingers `take(father_3, configuration eight_2)`";
    let open = opened(input, "which take of the corpus?", HINT)?.0;
    let (mut rest, take) = take_name(open, open.skip(), HINT)?;
    let mut channels: Vec<(ManualChannel, String)> = Vec::new();
    while rest.is(Kind::Comma) {
        let at = rest.skip();
        let Some(channel) = ManualChannel::ALL.into_iter().find(|channel| is_word(at, channel.name())) else {
            return told(
                Diagnostic::fault(at.span(), "what comes from another take?")
                    .label("expected configuration, orientation or placement")
                    .hint(HINT),
            );
        };
        if channels.iter().any(|(taken, _)| *taken == channel) {
            return told(
                Diagnostic::fault(at.span(), format!("the {} comes from one take only", channel.name()))
                    .label("said again"),
            );
        }
        let (after, take) = take_name(open, at.skip(), HINT)?;
        channels.push((channel, take));
        rest = after;
    }
    if !rest.is(Kind::Close) {
        return unclosed(open, rest, HINT);
    }
    Ok((rest.skip(), Head::Taken(Taken { take, channels })))
}

fn take_name<'a>(open: Tokens<'a>, at: Tokens<'a>, hint: &str) -> Parsed<'a, String> {
    let name = at.first().and_then(|token| match token.kind {
        Kind::Text => Some(unquote(token.text)),
        Kind::Word => Some(token.text.to_owned()),
        Kind::Open | Kind::Close | Kind::Comma | Kind::Equals | Kind::Mark(_) => None,
    });
    match name.map(|name| name.trim().nfc().collect::<String>()) {
        Some(name) if !name.is_empty() => Ok((at.skip(), name)),
        Some(_) => told(Diagnostic::fault(at.span(), "the name of this take is empty").label("here").hint(hint)),
        None if at.first().is_none() => unclosed(open, at, hint),
        None => told(
            Diagnostic::fault(at.span(), "the name of a take is missing")
                .label("expected a name")
                .hint("a name with marks stands in quotes: `take(\"a.b\")`"),
        ),
    }
}

/// What cannot begin an item.
fn no_sign<'a, T>(input: Tokens<'a>) -> Parsed<'a, T> {
    let Some(token) = input.first() else { return expected(input, "a sign") };
    let fault = |message: &str| Diagnostic::fault(token.span, message).label("here");
    told(match token.kind {
        Kind::Open => fault("a bracket that belongs to nothing").hint(
            "brackets follow IX, wrist, fs, take and weak without a space; items are grouped by `{brows raised: …}`",
        ),
        Kind::Close | Kind::Mark(']' | '>') => fault("this bracket was never opened"),
        Kind::Mark('@' | '+' | '[') => fault(&format!("`{}` belongs to a sign", token.text))
            .hint("it stands behind the gloss without a space: `BOL@left`"),
        Kind::Mark('&') => {
            fault("`&` joins two signs").hint("the strong hand's sign stands before it, the weak hand's after it")
        }
        Kind::Mark('#') => fault("`#` means nothing in a gloss line")
            .hint("a spelled word is `fs(OK)`; a name that has a `#` stands in quotes: `\"#OK\"`"),
        Kind::Mark(':') => {
            fault("a colon outside braces").hint("what the face does stands in braces: `{brows raised: TOI NOM QUOI}`")
        }
        Kind::Equals => {
            fault("`=` means nothing in a gloss line").hint("signs are described and recombined in `.sign` files")
        }
        Kind::Word | Kind::Text | Kind::Comma | Kind::Mark(_) => fault("expected a sign"),
    })
}

fn is_suffix(rest: Tokens) -> bool {
    rest.is_mark('@') || rest.is_mark('+') || rest.is_mark('[')
}

/// `@place`, `+…` and `[operators]`, in any order, each at most once.
fn suffixes<'a>(input: Tokens<'a>, from: Tokens<'a>, mut signed: Signed) -> Parsed<'a, Signed> {
    let mut rest = from;
    let mut counted = false;
    while is_suffix(rest) {
        let token = rest;
        if !input.touches(rest) {
            return told(
                Diagnostic::fault(input.span_to(rest.skip()), format!("a space before `{}`", rest.all()[0].text))
                    .label("without a space")
                    .hint("what is said of a sign touches its gloss: `BOL@left`, `TRAVAIL++`"),
            );
        }
        if rest.is_mark('@') {
            let (after, site) = placed(&signed, rest)?;
            signed.site = Some(Spanned::new(site, rest.span_to(after)));
            rest = after;
        } else if rest.is_mark('[') {
            let (after, operators) = changes(&signed, rest)?;
            signed.operators = Spanned::new(operators, rest.span_to(after));
            rest = after;
        } else {
            while rest.is_mark('+') && (token.all().len() == rest.all().len() || token.touches(rest)) {
                rest = rest.skip();
            }
            let span = token.span_to(rest);
            let number = (rest_difference(token, rest) + 1).min(usize::from(u8::MAX)) as u8;
            performed(&signed, counted, number, span)?;
            counted = true;
            signed.performances = Spanned::new(number, span);
        }
    }
    Ok((rest, signed))
}

/// How many tokens stand between two places of a line.
fn rest_difference(from: Tokens, to: Tokens) -> usize {
    from.all().len().saturating_sub(to.all().len())
}

/// `@place` of a sign that has none yet.
fn placed<'a>(signed: &Signed, at: Tokens<'a>) -> Parsed<'a, Site> {
    let (rest, site) = must(site::site(at.skip()))?;
    let fault = match (&signed.head.value, &signed.site) {
        (_, Some(first)) => Diagnostic::fault(at.span_to(rest), "the place of this sign is given twice")
            .label("the second")
            .related(first.span, "the first"),
        (Head::Pointing(_) | Head::Wrist(_), None) => {
            Diagnostic::fault(at.span_to(rest), "it is said already where this points").label("here")
        }
        (Head::Gloss(_) | Head::Spelled(_) | Head::Taken(_), None) => return Ok((rest, site)),
    };
    told(fault)
}

/// `[inverted, big]`
fn changes<'a>(signed: &Signed, open: Tokens<'a>) -> Parsed<'a, Vec<Operator>> {
    let from = open.skip();
    let ends = |t: &Token| matches!(t.kind, Kind::Mark('[' | ']' | '{' | '}'));
    let length = from.all().iter().position(ends).unwrap_or(from.all().len());
    let close = from.skip_n(length);
    if !close.is_mark(']') {
        return told(
            Diagnostic::fault(open.span(), "this bracket is never closed")
                .label("opened here")
                .hint("operators stand in it, separated by commas: `BOL[big, slow]`"),
        );
    }
    let whole = open.span_to(close.skip());
    if !signed.operators.value.is_empty() {
        return told(
            Diagnostic::fault(whole, "the operators are given twice")
                .label("the second")
                .related(signed.operators.span, "the first")
                .hint("write them in one pair of brackets, separated by commas"),
        );
    }
    let inside = Tokens::new(&from.all()[..length]);
    if inside.is_empty() {
        return told(
            Diagnostic::fault(whole, "which operators?")
                .label("none is said")
                .hint("write for example `BOL[big, slow]`"),
        );
    }
    if inside.all().len() == 1 && is_word(inside, "weak") {
        return told(
            Diagnostic::fault(whole, "the weak hand is said before the sign").label("here").hint("write `weak(BOL)`"),
        );
    }
    let (_, operators) = must(operators_alone(inside))?;
    Ok((close.skip(), operators))
}

fn performed(
    signed: &Signed,
    counted: bool,
    number: u8,
    at: Span,
) -> Result<(), nom::Err<crate::notation::parse::input::Mistake>> {
    let fault = if counted {
        Diagnostic::fault(at, "the performances are given twice")
            .label("the second")
            .related(signed.performances.span, "the first")
    } else if number > MOST_PERFORMANCES {
        Diagnostic::fault(at, format!("a sign is made at most {MOST_PERFORMANCES} times")).label("here")
    } else if let Head::Spelled(word) = &signed.head.value {
        Diagnostic::fault(at, "a spelled word is not repeated by `+`")
            .label("here")
            .hint(format!("write it again: `fs({word}) fs({word})`"))
    } else {
        return Ok(());
    };
    told::<()>(fault).map(|_| ())
}

/// A fault where the next sign touches this one.
fn separated<'a>(input: Tokens<'a>, rest: Tokens<'a>) -> Parsed<'a, ()> {
    let next = rest.is(Kind::Word) || rest.is(Kind::Text) || rest.is(Kind::Open) || rest.is_mark('<');
    if next && input.touches(rest) {
        return told(
            Diagnostic::fault(rest.span(), "a space is missing between two signs")
                .label("before this")
                .hint("a name with spaces or marks stands in quotes"),
        );
    }
    Ok((rest, ()))
}
