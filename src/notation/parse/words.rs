//! The small parts that every tier uses: keywords, names, numbers with units, directions, points of the hand.

use super::input::{Parsed, Tokens, expected, told};
use crate::diagnostics::{Diagnostic, Spanned};
use crate::notation::lex::{Kind, unquote};
use crate::notation::suggest::nearest;
use crate::notation::syntax::{Duration, Length, LengthUnit};
use crate::phonology::{Digit, Digits, Direction, Flank, HandPart, HandPoint, Heading};
use nom::multi::fold_many0;

/// The longest way that a hand can mean, in metres; more is a slip of the unit.
const LONGEST_M: f64 = 3.0;
/// The longest duration, in seconds.
const LONGEST_S: f64 = 60.0;

/// One word, any case.
pub(crate) fn keyword<'a>(word: &'static str) -> impl Fn(Tokens<'a>) -> Parsed<'a, ()> {
    move |input| if is_word(input, word) { Ok((input.skip(), ())) } else { expected(input, word) }
}

/// Whether the next token is that word.
pub(crate) fn is_word(input: Tokens, word: &str) -> bool {
    input.word().eq_ignore_ascii_case(word)
}

/// A mark.
pub(crate) fn mark<'a>(kind: Kind, what: &'static str) -> impl Fn(Tokens<'a>) -> Parsed<'a, ()> {
    move |input| if input.is(kind) { Ok((input.skip(), ())) } else { expected(input, what) }
}

/// A text in double quotes.
pub(crate) fn text<'a>(input: Tokens<'a>) -> Parsed<'a, String> {
    match input.first() {
        Some(t) if t.kind == Kind::Text => Ok((input.skip(), unquote(t.text))),
        Some(t) if t.text.starts_with(['“', '”', '„', '«', '‘', '’', '\'']) => told(
            Diagnostic::fault(t.span, "this text stands in typographic quotes")
                .label("here")
                .hint("use straight double quotes: \"…\""),
        ),
        _ => expected(input, "a text in double quotes"),
    }
}

/// A bracket closed where `rest` begins; `open` is where it opened.
pub(crate) fn closed<'a>(open: Tokens<'a>, rest: Tokens<'a>, tier: &str, hint: &str) -> Parsed<'a, ()> {
    if rest.is(Kind::Close) {
        return Ok((rest.skip(), ()));
    }
    if rest.is_empty() {
        let fault = Diagnostic::fault(open.span(), "this bracket is not closed").label("opened here");
        return told(fault.hint(hint));
    }
    super::leftover(rest, tier)
}

/// Whether a word is a percentage: `60%`.
pub(crate) fn is_percentage(word: &str) -> bool {
    word.ends_with('%') && word.starts_with(|c: char| c.is_ascii_digit())
}

/// A name: a text in quotes, or words up to a mark, a word of `stops` or a percentage.
pub(crate) fn name<'a>(input: Tokens<'a>, stops: &[&str], what: &'static str) -> Parsed<'a, Spanned<String>> {
    if input.is(Kind::Text) {
        let (rest, value) = text(input)?;
        return Ok((rest, Spanned::new(value, input.span_to(rest))));
    }
    let mut rest = input;
    let mut value = String::new();
    while rest.is(Kind::Word) && !is_one_of(rest.word(), stops) && !is_percentage(rest.word()) {
        if !value.is_empty() {
            value.push(' ');
        }
        value.push_str(rest.word());
        rest = rest.skip();
    }
    if value.is_empty() {
        return expected(input, what);
    }
    Ok((rest, Spanned::new(value, input.span_to(rest))))
}

/// Whether a word is one of a few, any case.
pub(crate) fn is_one_of(word: &str, words: &[&str]) -> bool {
    words.iter().any(|w| w.eq_ignore_ascii_case(word))
}

/// A value of a closed list, by its name.
pub(crate) fn choice<'a, T: Copy>(
    input: Tokens<'a>,
    all: &[T],
    name: impl Fn(T) -> &'static str,
    what: &'static str,
) -> Parsed<'a, T> {
    match all.iter().find(|v| is_word(input, name(**v))) {
        Some(value) => Ok((input.skip(), *value)),
        None => expected(input, what),
    }
}

/// The letters `mm`, `cm`, `m`, `s`, `ms` after a number, or nothing.
fn number_and_unit(word: &str) -> Option<(f64, &str)> {
    let cut = word.find(|c: char| !(c.is_ascii_digit() || ".-+".contains(c))).unwrap_or(word.len());
    let (digits, unit) = word.split_at(cut);
    // `1e5cm`: the shortest form of very small and very great numbers.
    let (digits, unit) = match unit.strip_prefix(['e', 'E']) {
        Some(after) => {
            let more = after.find(|c: char| !(c.is_ascii_digit() || "-+".contains(c))).unwrap_or(after.len());
            if more == 0 { (digits, unit) } else { (&word[..cut + 1 + more], &after[more..]) }
        }
        None => (digits, unit),
    };
    if !digits.contains(|c: char| c.is_ascii_digit()) {
        return None;
    }
    Some((digits.parse().ok()?, unit))
}

/// A number without a unit.
pub(crate) fn number<'a>(input: Tokens<'a>) -> Parsed<'a, f64> {
    refuse_decimal_comma(input)?;
    match number_and_unit(input.word()) {
        Some((value, "")) if value.is_finite() => Ok((input.skip(), value)),
        _ => expected(input, "a number"),
    }
}

/// A whole number from 1 to `most`.
pub(crate) fn count<'a>(input: Tokens<'a>, most: u16) -> Parsed<'a, u16> {
    let (rest, value) = number(input)?;
    if value.fract() != 0.0 || value < 1.0 || value > f64::from(most) {
        return told(
            Diagnostic::fault(input.span(), format!("this must be a whole number from 1 to {most}")).label("here"),
        );
    }
    // In range: checked above.
    Ok((rest, value as u16))
}

/// `1,5cm`: a number, a comma and a number without a space between.
fn refuse_decimal_comma<'a>(input: Tokens<'a>) -> Parsed<'a, ()> {
    let [whole, comma, part, ..] = input.all() else { return Ok((input, ())) };
    let touches = whole.span.end == comma.span.start && comma.span.end == part.span.start;
    let digits = |t: &str| !t.is_empty() && t.bytes().all(|b| b.is_ascii_digit());
    if touches && comma.kind == Kind::Comma && digits(whole.text) && part.text.starts_with(|c: char| c.is_ascii_digit())
    {
        return told(
            Diagnostic::fault(whole.span.to(part.span), "a decimal comma")
                .label("here")
                .hint(format!("write the number with a point: `{}.{}`", whole.text, part.text)),
        );
    }
    Ok((input, ()))
}

/// A number with one of two kinds of unit, which may stand apart from it (`15 cm`).
fn quantity<'a>(input: Tokens<'a>, what: &'static str) -> Parsed<'a, (f64, &'a str)> {
    refuse_decimal_comma(input)?;
    match number_and_unit(input.word()) {
        Some((value, "")) => {
            let unit = input.skip().word();
            let known = ["mm", "cm", "m", "s", "ms", "sec", "seconds"];
            if is_one_of(unit, &known) { Ok((input.skip_n(2), (value, unit))) } else { Ok((input.skip(), (value, ""))) }
        }
        Some((value, unit)) => Ok((input.skip(), (value, unit))),
        None => expected(input, what),
    }
}

/// A length with its unit, from 0 up to what arms reach.
pub(crate) fn length<'a>(input: Tokens<'a>) -> Parsed<'a, Length> {
    let (rest, (number, unit)) = quantity(input, "a length such as `15cm`")?;
    let span = input.span_to(rest);
    let Some(unit) = LengthUnit::ALL.into_iter().find(|u| u.name().eq_ignore_ascii_case(unit)) else {
        let fault = if unit.is_empty() {
            Diagnostic::fault(span, "a length without a unit")
                .hint(format!("write `{number}cm`, `{number}mm` or `{number}m`"))
        } else {
            Diagnostic::fault(span, format!("`{unit}` is not a unit of length")).hint("lengths are in mm, cm or m")
        };
        return told(fault.label("here"));
    };
    let length = Length { number, unit };
    if !(0.0..=LONGEST_M).contains(&length.metres()) {
        let fault = Diagnostic::fault(span, "a length must lie between 0 and 3 m").label("here");
        return told(if unit == LengthUnit::M && (0.0..=300.0).contains(&number) {
            fault.hint(format!("did you mean `{number}cm`?"))
        } else {
            fault
        });
    }
    Ok((rest, length))
}

/// A length above 0.
pub(crate) fn distance_covered<'a>(input: Tokens<'a>) -> Parsed<'a, Length> {
    let (rest, value) = length(input)?;
    if value.metres() > 0.0 {
        return Ok((rest, value));
    }
    told(
        Diagnostic::fault(input.span_to(rest), "a movement over no distance")
            .label("here")
            .hint("write `hold` where the hand stays"),
    )
}

/// A duration with its unit.
pub(crate) fn duration<'a>(input: Tokens<'a>) -> Parsed<'a, Duration> {
    let (rest, (number, unit)) = quantity(input, "a duration such as `0.4s`")?;
    let span = input.span_to(rest);
    let milliseconds = match unit {
        "s" | "sec" | "seconds" => false,
        "ms" => true,
        "" => {
            return told(
                Diagnostic::fault(span, "a duration without a unit")
                    .label("here")
                    .hint(format!("write `{number}s` or `{number}ms`")),
            );
        }
        other => {
            return told(
                Diagnostic::fault(span, format!("`{other}` is not a unit of time"))
                    .label("here")
                    .hint("durations are in s or ms"),
            );
        }
    };
    let duration = Duration { number, milliseconds };
    if !(duration.seconds() > 0.0 && duration.seconds() <= LONGEST_S) {
        return told(Diagnostic::fault(span, "a duration must lie above 0 and at most at 60 s").label("here"));
    }
    Ok((rest, duration))
}

/// One of the 26 directions.
pub(crate) fn direction<'a>(input: Tokens<'a>) -> Parsed<'a, Direction> {
    if let Ok(direction) = input.word().parse() {
        return Ok((input.skip(), direction));
    }
    expected(input, "a direction such as `up` or `down-left`")
}

/// A direction that must stand here: a word that is none is told, with the nearest.
pub(crate) fn must_direction<'a>(input: Tokens<'a>) -> Parsed<'a, Direction> {
    direction(input).or_else(|_| not_a_direction(input))
}

fn not_a_direction<'a, T>(input: Tokens<'a>) -> Parsed<'a, T> {
    let word = input.word();
    if word.is_empty() {
        return Err(nom::Err::Failure(super::input::Mistake::Expected {
            at: input.span(),
            what: "a direction such as `up` or `down-left`",
        }));
    }
    let fault = Diagnostic::fault(input.span(), format!("`{word}` is not a direction")).label("expected a direction");
    let parts: Vec<&str> = word.split('-').collect();
    let names: Vec<String> = Direction::all().map(|d| d.to_string()).collect();
    if parts.iter().all(|p| p.parse::<Direction>().is_ok()) {
        return told(fault.hint("each axis is said once: up or down, out or in, left or right"));
    }
    if is_one_of(word, &["forward", "forwards", "front", "away", "ahead"]) {
        return told(fault.hint("away from the signer is `out`, towards the signer is `in`"));
    }
    if is_one_of(word, &["back", "backward", "backwards", "inward", "inwards"]) {
        return told(fault.hint("towards the signer is `in`, away from the signer is `out`"));
    }
    told(match nearest(word, names.iter().map(String::as_str)) {
        Some(near) => fault.hint(format!("did you mean `{near}`?")),
        None => {
            fault.hint("directions are up, down, left, right, out, in, joined by hyphens: `up-left`, `down-out-right`")
        }
    })
}

/// A direction, or `between A and B`.
pub(crate) fn heading<'a>(input: Tokens<'a>) -> Parsed<'a, Heading> {
    if !is_word(input, "between") {
        return direction(input).map(|(rest, d)| (rest, Heading::Toward(d)));
    }
    let (rest, a) = must_direction(input.skip())?;
    let (rest, ()) = super::input::must(keyword("and")(rest))?;
    let (rest, b) = must_direction(rest)?;
    if a == b.opposite() {
        return told(
            Diagnostic::fault(input.span_to(rest), format!("there is no direction between {a} and {b}"))
                .label("these are opposite"),
        );
    }
    Ok((rest, Heading::Between(a, b)))
}

/// A heading that must stand here.
pub(crate) fn must_heading<'a>(input: Tokens<'a>) -> Parsed<'a, Heading> {
    match heading(input) {
        Err(nom::Err::Error(_)) => not_a_direction(input),
        other => other,
    }
}

/// A finger or the thumb.
pub(crate) fn digit<'a>(input: Tokens<'a>) -> Parsed<'a, Digit> {
    if is_word(input, "little") {
        return Ok((input.skip(), Digit::Pinky));
    }
    choice(input, &Digit::ALL, Digit::name, "a finger: index, middle, ring, pinky or thumb")
}

/// Any number of fingers, with or without `and`; `fingers` is the four of them.
pub(crate) fn digits<'a>(input: Tokens<'a>) -> Parsed<'a, Digits> {
    if is_word(input, "fingers") {
        return Ok((input.skip(), Digits::FINGERS));
    }
    let more = fold_many0(digit, Vec::new, |mut all, d| {
        all.push(d);
        all
    });
    let (rest, all) = { more }.parse_tokens(input)?;
    Ok((rest, Digits::of(all)))
}

/// nom's `Parser::parse`, named so that it is not mistaken for `str::parse`.
trait ParseTokens<'a, T> {
    fn parse_tokens(self, input: Tokens<'a>) -> Parsed<'a, T>;
}

impl<'a, T, P: nom::Parser<Tokens<'a>, Output = T, Error = super::input::Mistake>> ParseTokens<'a, T> for P {
    fn parse_tokens(mut self, input: Tokens<'a>) -> Parsed<'a, T> {
        self.parse(input)
    }
}

/// A point of a hand or an arm, or halfway between two: `index tip`, `index tip to index midjoint`.
pub(crate) fn hand_point<'a>(input: Tokens<'a>) -> Parsed<'a, HandPoint> {
    let (rest, first) = spot(input)?;
    if !is_word(rest, "to") || !begins_spot(rest.skip()) {
        return Ok((rest, first));
    }
    let (rest, second) = spot(rest.skip())?;
    Ok((rest, first.halfway(second)))
}

/// Whether a part of the hand is named here, so that a `to` before it does not lead to a place.
fn begins_spot(input: Tokens) -> bool {
    let parts = HandPart::all().map(HandPart::name);
    let mut known = parts.chain(Digit::ALL.map(Digit::name)).chain(Flank::ALL.map(Flank::name)).chain(["fingers"]);
    known.any(|word| is_word(input, word))
}

/// One named point: `index tip`, `radial index side`, `palm`.
fn spot<'a>(input: Tokens<'a>) -> Parsed<'a, HandPoint> {
    let (rest, flank) = match choice(input, &Flank::ALL, Flank::name, "a face") {
        Ok((rest, flank)) => (rest, Some(flank)),
        Err(_) => (input, None),
    };
    let (rest, fingers) = digits(rest)?;
    let parts: Vec<HandPart> = HandPart::all().collect();
    let Ok((after, part)) = choice(rest, &parts, HandPart::name, "a point of the hand") else {
        return no_hand_point(input, rest, fingers);
    };
    match HandPoint::new(fingers, part, flank) {
        Some(point) => Ok((after, point)),
        None if part.needs_digit() => told(
            Diagnostic::fault(rest.span(), format!("which finger's {}?", part.name()))
                .label("a finger stands before it")
                .hint(format!("say the finger first: `index {}`", part.name())),
        ),
        None if fingers.is_empty() => told(
            Diagnostic::fault(input.span_to(after), "the wrist is a joint, and has no faces")
                .label("here")
                .hint("on the skin there are `wrist-back` and `wrist-pulse`"),
        ),
        None => told(
            Diagnostic::fault(input.span_to(after), format!("the {} belongs to no finger", part.name()))
                .label("here")
                .hint(format!("write `{}` alone", part.name())),
        ),
    }
}

fn no_hand_point<'a, T>(start: Tokens<'a>, rest: Tokens<'a>, fingers: Digits) -> Parsed<'a, T> {
    let parts = || HandPart::all().map(HandPart::name);
    let word = rest.word();
    if !fingers.is_empty() {
        let fault = Diagnostic::fault(start.span_to(rest), "which part of the finger?").label("a part stands after it");
        return told(match nearest(word, parts()) {
            Some(near) => fault.hint(format!("did you mean `{near}`?")),
            None => fault.hint("the parts of a finger are tip, nail, pad, midjoint, base and side"),
        });
    }
    if word.is_empty() {
        return expected(rest, "a point of the hand such as `palm` or `index tip`");
    }
    let fault = Diagnostic::fault(rest.span(), format!("`{word}` is not a point of the hand")).label("here");
    let known = parts().chain(Digit::ALL.map(Digit::name)).chain(Flank::ALL.map(Flank::name));
    told(match nearest(word, known) {
        Some(near) => fault.hint(format!("did you mean `{near}`?")),
        None => fault.hint("points are palm, back, thumb-side, pinky-side, …, or a finger and its part: `index tip`"),
    })
}
