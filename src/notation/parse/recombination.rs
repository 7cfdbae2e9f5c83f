//! Signs made from others: `CLAIR inverted`, `spelled "OK"`, `( A then B ) mirrored`, `A & B`.
//!
//! Operators bind tighter than `&`, and `&` tighter than `then`. A value after `with` goes on up to the next operator, so a
//! `then` after it joins values; brackets end it.

use super::configuration::configuration;
use super::input::{Parsed, Tokens, expected, must, told};
use super::leftover;
use super::motion::sign_of_growth;
use super::movement::movements;
use super::nonmanual::nonmanual;
use super::orientation::orientation;
use super::placement::{place, placement, point};
use super::repetition::times;
use super::whole::{relocation, speed};
use super::words::{duration, is_one_of, is_word, keyword, mark, number, text};
use crate::diagnostics::{Diagnostic, Spanned};
use crate::notation::lex::{Dialect, Kind, lex};
use crate::notation::suggest::nearest;
use crate::notation::syntax::{Base, Expression, Operator};
use crate::phonology::operator::{BIG, FAST, SIZES, SLOW, SMALL};
use crate::phonology::{Channel, Hand};
use unicode_normalization::UnicodeNormalization;

/// Operators that are one word.
const ALONE: [&str; 8] = ["inverted", "mirrored", "swapped", "reflected", "fast", "slow", "big", "small"];
/// Operators that something follows.
const WITH_MORE: [&str; 5] = ["repeated", "with", "at", "speed", "size"];
/// Operators that are words of a movement too, and its own where they follow it.
pub(crate) const KEPT_BY_MOVEMENTS: [&str; 5] = ["repeated", "fast", "slow", "small", "speed"];
/// Words that begin a base that is no name.
pub(crate) const HEADS: [&str; 3] = ["spelled", "pointing", "wrist"];
/// How deep brackets may nest.
const DEEPEST: usize = 16;
/// The most parts of a compound.
const MOST_PARTS: usize = 64;

/// A list of operators that stands alone, such as that between the brackets of a gloss: `inverted, big`.
pub(crate) fn operators_alone<'a>(input: Tokens<'a>) -> Parsed<'a, Vec<Operator>> {
    let (rest, all) = operators(input)?;
    if rest.is_empty() { Ok((rest, all)) } else { no_operator(rest) }
}

/// Reads a text that is a list of operators. `offset` is where it begins in its source.
///
/// # Errors
/// The first fault.
pub(crate) fn operators_of(written: &str, offset: usize) -> Result<Vec<Operator>, Box<Diagnostic>> {
    let lexed = lex(written, offset, Dialect::Sign)?;
    let input = Tokens::new(&lexed.tokens);
    match operators_alone(input) {
        Ok((_, all)) => Ok(all),
        Err(error) => Err(Box::new(super::diagnostic(error, input))),
    }
}

/// `{ [,] OPERATOR }`
pub(crate) fn operators<'a>(input: Tokens<'a>) -> Parsed<'a, Vec<Operator>> {
    let mut all = Vec::new();
    let mut rest = input;
    loop {
        let from = if rest.is(Kind::Comma) { rest.skip() } else { rest };
        if !begins_operator(from) {
            return Ok((rest, all));
        }
        let (after, one) = must(operator(from))?;
        all.push(one);
        rest = after;
    }
}

/// The whole right side of `sign NAME = …`.
pub(crate) fn expression<'a>(input: Tokens<'a>) -> Parsed<'a, Expression> {
    let (rest, made) = chain(input, 0)?;
    if rest.is_empty() { Ok((rest, made)) } else { no_operator(rest) }
}

fn chain<'a>(input: Tokens<'a>, depth: usize) -> Parsed<'a, Expression> {
    let (mut rest, first) = hands(input, depth)?;
    let mut parts = vec![first];
    while is_word(rest, "then") {
        let (after, next) = hands(rest.skip(), depth)?;
        if parts.len() == MOST_PARTS {
            return told(Diagnostic::fault(rest.span(), "this compound has too many parts").label("here"));
        }
        parts.push(next);
        rest = after;
    }
    match parts.pop() {
        Some(only) if parts.is_empty() => Ok((rest, only)),
        last => {
            parts.extend(last);
            Ok((rest, Expression { base: Base::Chain(parts), operators: Vec::new() }))
        }
    }
}

fn hands<'a>(input: Tokens<'a>, depth: usize) -> Parsed<'a, Expression> {
    let (rest, strong) = item(input, depth)?;
    if !is_word(rest, "&") {
        return Ok((rest, strong));
    }
    let (after, weak) = item(rest.skip(), depth)?;
    if is_word(after, "&") {
        return told(
            Diagnostic::fault(after.span(), "there are two hands")
                .label("a third sign begins here")
                .hint("`A & B` is A on the strong hand and B on the weak one; brackets join more"),
        );
    }
    let base = Base::Hands(Box::new(strong), Box::new(weak));
    Ok((after, Expression { base, operators: Vec::new() }))
}

fn item<'a>(input: Tokens<'a>, depth: usize) -> Parsed<'a, Expression> {
    let (rest, mut made) = primary(input, depth)?;
    let (rest, more) = operators(rest)?;
    made.operators.extend(more);
    Ok((rest, made))
}

fn primary<'a>(input: Tokens<'a>, depth: usize) -> Parsed<'a, Expression> {
    let of = |base| Expression { base, operators: Vec::new() };
    if depth > DEEPEST {
        return told(Diagnostic::fault(input.span(), "brackets are nested too deeply").label("here"));
    }
    if input.is(Kind::Open) {
        let (rest, inner) = chain(input.skip(), depth + 1)?;
        if rest.is_empty() {
            return told(
                Diagnostic::fault(input.span(), "this bracket is not closed").label("opened here").hint("add `)`"),
            );
        }
        return match mark(Kind::Close, "a closing bracket")(rest) {
            Ok((rest, ())) => Ok((rest, inner)),
            Err(_) => no_operator(rest),
        };
    }
    if is_word(input, "spelled") {
        let (rest, word) = match input.skip().first() {
            Some(t) if t.kind == Kind::Word => (input.skip_n(2), t.text.to_owned()),
            _ => must(text(input.skip()))?,
        };
        if crate::phonology::recombination::letters(&word).next().is_none() {
            return told(Diagnostic::fault(input.skip().span(), "a word without letters").label("here"));
        }
        return Ok((rest, of(Base::Spelled(word))));
    }
    if is_word(input, "pointing") {
        let (rest, ()) = must(keyword("at")(input.skip()))?;
        let (cut, after) = up_to_operator(rest, &[], Many::One);
        let (left, at) = must(place(cut, 0))?;
        return if left.is_empty() { Ok((after, of(Base::Pointing(at)))) } else { leftover(left, "placement") };
    }
    if is_word(input, "wrist") {
        let (rest, ()) = must(keyword("at")(input.skip()))?;
        let (rest, [x, y, z]) = point(rest)?;
        return Ok((rest, of(Base::WristAt([x, y, z]))));
    }
    let name = match input.first() {
        Some(t) if t.kind == Kind::Text => text(input)?.1,
        Some(t) if t.kind == Kind::Word && !is_one_of(t.text, &["then", "&"]) => t.text.to_owned(),
        _ => return must(expected(input, "the name of a sign, `spelled`, `pointing at` or a bracket")),
    };
    let name = Spanned::new(name.trim().nfc().collect(), input.span());
    Ok((input.skip(), of(Base::Named(name))))
}

/// Whether an operator begins here. `with` is one before a tier, as `, with index tip` belongs to a placement.
fn begins_operator(input: Tokens) -> bool {
    if is_word(input, "with") {
        let of_hand = is_word(input.skip(), "strong") || is_word(input.skip(), "weak");
        let tier = if of_hand { input.skip_n(2) } else { input.skip() };
        let tiers = ["configuration", "placement", "orientation", "movement"];
        return is_one_of(tier.word(), &tiers) || Channel::ALL.iter().any(|c| is_word(tier, c.name()));
    }
    is_one_of(input.word(), &ALONE) || is_one_of(input.word(), &WITH_MORE)
}

/// Whether values joined by `then` may stand there.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Many {
    One,
    Several,
}

/// What stands before the next operator, `&` or closing bracket, and what from there on. Operators of `kept` are words of
/// the value.
fn up_to_operator<'a>(input: Tokens<'a>, kept: &[&str], many: Many) -> (Tokens<'a>, Tokens<'a>) {
    let (mut depth, mut n) = (0usize, 0);
    let mut rest = input;
    // After these a value goes on, whatever the word.
    let mut open = true;
    while let Some(token) = rest.first() {
        match token.kind {
            Kind::Open => depth += 1,
            Kind::Close if depth == 0 => break,
            Kind::Close => depth -= 1,
            Kind::Word if depth == 0 && is_word(rest, "&") => break,
            Kind::Word if depth == 0 && many == Many::One && is_word(rest, "then") => break,
            Kind::Word if depth == 0 && !open && begins_operator(rest) && !is_one_of(token.text, kept) => break,
            Kind::Word | Kind::Text | Kind::Comma | Kind::Equals | Kind::Mark(_) => {}
        }
        n += 1;
        open = is_one_of(rest.word(), &["then", "pointing", "between", "and"]);
        rest = rest.skip();
    }
    let comma = n > 1 && input.skip_n(n - 1).is(Kind::Comma) && !rest.is_empty() && begins_operator(rest);
    (input.first_n(if comma { n - 1 } else { n }), rest)
}

fn operator<'a>(input: Tokens<'a>) -> Parsed<'a, Operator> {
    let rest = input.skip();
    let one = |operator| Ok((rest, operator));
    match input.word().to_ascii_lowercase().as_str() {
        "inverted" if is_word(rest, "movement") => Ok((rest.skip(), Operator::InvertedMovement)),
        "inverted" => one(Operator::Inverted),
        "mirrored" => one(Operator::Mirrored),
        "swapped" => one(Operator::Swapped),
        "reflected" => one(Operator::Reflected),
        "fast" => one(Operator::Speed(FAST)),
        "slow" => one(Operator::Speed(SLOW)),
        "big" => one(Operator::Size(BIG)),
        "small" => one(Operator::Size(SMALL)),
        "speed" => must(speed(rest)).map(|(r, factor)| (r, Operator::Speed(factor))),
        "size" => size(rest),
        "repeated" => repeated(input),
        "at" => {
            let (cut, after) = up_to_operator(rest, &[], Many::One);
            let (left, to) = relocation(cut)?;
            if left.is_empty() || left.is(Kind::Comma) && left.skip().is_empty() {
                Ok((after, Operator::At(to)))
            } else {
                leftover(left, "placement")
            }
        }
        "with" => with(rest),
        _ => no_operator(input),
    }
}

fn size<'a>(input: Tokens<'a>) -> Parsed<'a, Operator> {
    let (rest, factor) = must(number(input))?;
    if SIZES.contains(&factor) {
        return Ok((rest, Operator::Size(factor)));
    }
    told(
        Diagnostic::fault(input.span(), "a size lies between 0.1 and 5")
            .label("here")
            .hint("2 makes its paths twice as large"),
    )
}

/// `repeated COUNT [gap DURATION] [growing|shrinking]`
fn repeated<'a>(input: Tokens<'a>) -> Parsed<'a, Operator> {
    let (rest, times) = times(input.skip(), "repeated")?;
    let (rest, gap) = if is_word(rest, "gap") {
        let (rest, gap) = must(duration(rest.skip()))?;
        (rest, Some(gap))
    } else {
        (rest, None)
    };
    let (rest, growth) = sign_of_growth(rest)?;
    Ok((rest, Operator::Repeated { times, gap, growth }))
}

/// `[strong|weak] TIER VALUE { then VALUE }`
fn with<'a>(input: Tokens<'a>) -> Parsed<'a, Operator> {
    let hand = [("strong", Hand::Strong), ("weak", Hand::Weak)].into_iter().find(|(w, _)| is_word(input, w));
    let tier = if hand.is_some() { input.skip() } else { input };
    let hand = hand.map(|(_, hand)| hand);
    let rest = tier.skip();
    let word = tier.word().to_ascii_lowercase();
    match word.as_str() {
        "configuration" => values(rest, configuration, |v| Operator::Configuration(hand, v)),
        "placement" => values(rest, placement, |v| Operator::Placement(hand, v)),
        "orientation" => values(rest, orientation, |v| Operator::Orientation(hand, v)),
        "movement" => {
            let kept = KEPT_BY_MOVEMENTS;
            let (cut, after) = up_to_operator(rest, &kept, Many::Several);
            let (left, all) = movements(cut)?;
            if left.is_empty() { Ok((after, Operator::Movement(hand, all))) } else { leftover(left, "movement") }
        }
        _ => match Channel::ALL.into_iter().find(|c| c.name() == word) {
            Some(_) if hand.is_some() => {
                told(Diagnostic::fault(tier.span(), format!("`{word}` is no tier of a hand")).label("here"))
            }
            Some(channel) => values(rest, nonmanual, |v| Operator::NonManual(channel, v)),
            None => must(expected(tier, "a tier such as `configuration`")),
        },
    }
}

/// Values joined by `then`, up to the next operator.
fn values<'a, T>(
    input: Tokens<'a>,
    value: impl Fn(Tokens<'a>) -> Parsed<'a, T>,
    make: impl Fn(Vec<T>) -> Operator,
) -> Parsed<'a, Operator> {
    let (cut, after) = up_to_operator(input, &[], Many::Several);
    let mut all = Vec::new();
    let mut rest = cut;
    loop {
        let (left, one) = must(value(rest))?;
        all.push(one);
        if !is_word(left, "then") {
            return if left.is_empty() { Ok((after, make(all))) } else { leftover(left, "placement") };
        }
        rest = left.skip();
    }
}

fn no_operator<'a, T>(input: Tokens<'a>) -> Parsed<'a, T> {
    let Some(token) = input.first() else { return expected(input, "an operator such as `inverted`") };
    let fault = Diagnostic::fault(token.span, format!("`{}` is not an operator on signs", token.text)).label("here");
    if token.kind == Kind::Close {
        return told(Diagnostic::fault(token.span, "this bracket was never opened").label("here"));
    }
    if token.kind == Kind::Comma && input.skip().is_empty() {
        return told(fault.hint("leave out the comma at the end of the line"));
    }
    let word = if token.kind == Kind::Comma { input.skip().word() } else { input.word() };
    if is_word(input, "with") {
        return told(
            fault.hint("`with` is followed by a tier: `with configuration U`, `with weak orientation fingers up`, `with brows raised`"),
        );
    }
    let meant = [
        ("backwards", "inverted"),
        ("reversed", "inverted"),
        ("twice", "repeated 2"),
        ("large", "big"),
        ("left-handed", "swapped"),
    ];
    let meant = meant.iter().find(|(said, _)| word.eq_ignore_ascii_case(said)).map(|(_, ours)| *ours);
    told(match meant.or_else(|| nearest(word, ALONE.into_iter().chain(WITH_MORE))) {
        Some(near) => fault.hint(format!("did you mean `{near}`?")),
        None => fault.hint(format!("operators are {}, {}", ALONE.join(", "), WITH_MORE.join(", "))),
    })
}
