//! What a hand does: straight, arc, circle, of the wrist, of the fingers.

use super::input::{Mistake, Parsed, Tokens, expected, must, told};
use super::tier::MOST_KEYS;
use super::words::{
    choice, count, digits, direction, distance_covered, heading, is_one_of, is_word, keyword, must_direction,
    must_heading, number,
};
use crate::diagnostics::{Diagnostic, Spanned};
use crate::notation::lex::Kind;
use crate::notation::suggest::nearest;
use crate::notation::syntax::{Extent, Motion};
use crate::phonology::{Clock, Direction, Heading, Overlay, Size, WristMotion};

/// The words that a movement can begin with, besides directions.
const MOTIONS: [&str; 17] = [
    "straight",
    "arc",
    "circle",
    "hold",
    "change",
    "to",
    "nod",
    "swing",
    "twist",
    "stir-clockwise",
    "stir-counterclockwise",
    "wiggle",
    "fused",
    "back",
    "backwards",
    "between",
    "stir",
];
/// The clock face, eighths of a turn from the top.
pub(crate) const CLOCK: [&str; 8] = ["12", "1:30", "3", "4:30", "6", "7:30", "9", "10:30"];
/// The most turns of a circle.
const MOST_TURNS: f64 = 50.0;

/// One motion without target, manner or repetition.
pub(crate) fn motion<'a>(input: Tokens<'a>) -> Parsed<'a, Motion> {
    for (word, motion) in [("hold", Motion::Hold), ("change", Motion::Change)] {
        if is_word(input, word) {
            return Ok((input.skip(), motion));
        }
    }
    if is_word(input, "back") {
        return back(input);
    }
    if is_word(input, "straight") {
        return straight(input.skip());
    }
    if is_word(input, "arc") {
        return arc(input);
    }
    if is_word(input, "circle") {
        return circle(input.skip());
    }
    if is_word(input, "wiggle") {
        return digits(input.skip()).map(|(rest, digits)| (rest, Motion::Wiggle(digits)));
    }
    if let Ok((rest, wrist)) = wrist(input) {
        let (rest, size) = size(rest);
        return Ok((rest, Motion::Wrist(wrist, size)));
    }
    if is_word(input, "between") || direction(input).is_ok() {
        return straight(input);
    }
    no_motion(input)
}

/// `back [to key N]`
fn back<'a>(input: Tokens<'a>) -> Parsed<'a, Motion> {
    let rest = input.skip();
    if is_word(rest, "to") && is_word(rest.skip(), "key") {
        let (after, key) = must(count(rest.skip_n(2), MOST_KEYS))?;
        return Ok((after, Motion::Return(Spanned::new(key.into(), input.span_to(after)))));
    }
    if is_word(rest, "to") && !is_word(rest.skip(), "and") {
        return told(
            Diagnostic::fault(input.span_to(rest.skip()), "`back` goes to a key, not to a place")
                .label("here")
                .hint("write `back`, `back to key 2`, or only `to` and the place"),
        );
    }
    Ok((rest, Motion::Return(Spanned::new(1, input.span()))))
}

fn no_motion<'a, T>(input: Tokens<'a>) -> Parsed<'a, T> {
    let word = input.word();
    if word.is_empty() || word.eq_ignore_ascii_case("then") || word.eq_ignore_ascii_case("while") {
        return expected(input, "a movement such as `up 10cm`, `arc …`, `circle …` or `hold`");
    }
    let fault = Diagnostic::fault(input.span(), format!("`{word}` is not a movement")).label("expected a movement");
    if word.starts_with(|c: char| c.is_ascii_digit()) {
        return told(fault.hint("the direction comes before the size: `up 10cm`"));
    }
    if word.split('-').all(|part| part.parse::<Direction>().is_ok()) {
        return told(
            fault.hint("each axis of a direction is said once; movements that follow each other are joined by `then`"),
        );
    }
    if is_one_of(word, &["zigzag", "wavy"]) {
        return told(fault.hint(format!("say the direction first: `left 20cm {word}`")));
    }
    if is_one_of(word, &["small", "large", "fast", "slow", "tense"]) {
        return told(fault.hint(format!("say what moves first, then how: `up {word}`")));
    }
    let directions: Vec<String> = Direction::all().map(|d| d.to_string()).collect();
    told(match nearest(word, MOTIONS.into_iter().chain(directions.iter().map(String::as_str))) {
        Some(near) => fault.hint(format!("did you mean `{near}`?")),
        None => fault.hint(
            "movements are a direction (`up 10cm`), `arc`, `circle`, `nod`, `swing`, `twist`, `stir-clockwise`, `wiggle`, `hold`, `change`, `to` a place",
        ),
    })
}

fn wrist<'a>(input: Tokens<'a>) -> Parsed<'a, WristMotion> {
    if is_word(input, "stir") {
        if is_word(input.skip(), "clockwise") {
            return Ok((input.skip_n(2), WristMotion::StirClockwise));
        }
        if is_word(input.skip(), "counterclockwise") {
            return Ok((input.skip_n(2), WristMotion::StirCounterclockwise));
        }
    }
    choice(input, &WristMotion::ALL, WristMotion::name, "a movement of the wrist")
}

/// `small` or `large`, unless it belongs to `bend`.
pub(crate) fn size(input: Tokens) -> (Tokens, Size) {
    if is_word(input.skip(), "bend") {
        return (input, Size::Normal);
    }
    if is_word(input, "small") {
        (input.skip(), Size::Small)
    } else if is_word(input, "large") {
        (input.skip(), Size::Large)
    } else {
        (input, Size::Normal)
    }
}

fn extent<'a>(input: Tokens<'a>) -> Parsed<'a, Extent> {
    match distance_covered(input) {
        Ok((rest, length)) => Ok((rest, Extent::Length(length))),
        Err(nom::Err::Error(_)) => {
            let (rest, size) = size(input);
            Ok((rest, Extent::Size(size)))
        }
        Err(other) => Err(other),
    }
}

/// `zigzag|wavy [SIZE] [across DIR] [growing|shrinking [N]]`, or nothing.
fn overlay<'a>(input: Tokens<'a>) -> Parsed<'a, Option<Overlay>> {
    let from = if input.is(Kind::Comma) { input.skip() } else { input };
    let zigzag = is_word(from, "zigzag");
    if !zigzag && !is_word(from, "wavy") {
        return Ok((input, None));
    }
    let (rest, size) = size(from.skip());
    let (rest, across) = if is_word(rest, "across") {
        must_direction(rest.skip()).map(|(rest, way)| (rest, Some(way)))?
    } else {
        (rest, None)
    };
    let (rest, growth) = sign_of_growth(rest)?;
    Ok((rest, Some(Overlay { zigzag, size, across, growth })))
}

/// `HEADING [EXTENT] [WAVES]`
fn straight<'a>(input: Tokens<'a>) -> Parsed<'a, Motion> {
    let (rest, direction) = must_heading(input)?;
    let (rest, extent) = extent(rest)?;
    let (rest, overlay) = overlay(rest)?;
    Ok((rest, Motion::Straight { direction, extent, overlay }))
}

/// `arc HEADING [EXTENT] [bulging HEADING] [small bend|large bend] [WAVES]`
fn arc<'a>(input: Tokens<'a>) -> Parsed<'a, Motion> {
    let (rest, direction) = match heading(input.skip()) {
        Err(nom::Err::Error(_)) if input.skip().word().is_empty() => {
            return told(
                Diagnostic::fault(input.span(), "an arc in which direction?")
                    .label("a direction stands after it")
                    .hint("write `arc up-right 15cm`: the way from its start to its end"),
            );
        }
        Err(nom::Err::Error(_)) => must_heading(input.skip())?,
        other => other?,
    };
    let (rest, extent) = extent(rest)?;
    let (rest, bulge) = if is_word(rest, "bulging") {
        let (after, bulge) = must_heading(rest.skip())?;
        if bulge.vector().cross(direction.vector()).length() < 0.2 {
            return told(
                Diagnostic::fault(rest.span_to(after), format!("an arc {direction} cannot bulge {bulge}"))
                    .label("along the arc's own direction")
                    .hint("the bulge is the side to which the path bends"),
            );
        }
        (after, Some(bulge))
    } else {
        (rest, None)
    };
    let (rest, depth) = if is_word(rest.skip(), "bend") {
        let (after, depth) = choice(rest, &[Size::Small, Size::Large], size_name, "`small bend` or `large bend`")
            .or_else(|_: nom::Err<Mistake>| must(expected(rest, "`small bend` or `large bend`")))?;
        (after.skip(), depth)
    } else {
        (rest, Size::Normal)
    };
    let (rest, overlay) = overlay(rest)?;
    Ok((rest, Motion::Arc { direction, extent, bulge, depth, overlay }))
}

/// The name of a size that is said.
pub(crate) fn size_name(size: Size) -> &'static str {
    match size {
        Size::Small => "small",
        Size::Normal => "normal",
        Size::Large => "large",
    }
}

/// `circle axis HEADING [radius EXTENT] [from CLOCK] [turns N] [flattened N along DIR] [growing|shrinking [N]] [WAVES]`
fn circle<'a>(input: Tokens<'a>) -> Parsed<'a, Motion> {
    if !is_word(input, "axis") {
        let fault =
            Diagnostic::fault(input.span(), "a circle about which axis?").label("expected `axis` and a direction");
        return told(match direction(input) {
            Ok((_, d)) => fault.hint(format!("did you mean `circle axis {d}`?")),
            Err(_) => fault.hint("write `circle axis out`: clockwise for one who looks along the axis"),
        });
    }
    let (rest, axis) = must_heading(input.skip())?;
    let (rest, extent) = radius(rest)?;
    let (rest, start) = match keyword("from")(rest) {
        Ok((rest, ())) => clock(rest)?,
        Err(_) => (rest, Clock::default()),
    };
    let (rest, turns) = turns(rest)?;
    let (rest, ellipse) = flattened(rest, axis)?;
    let (rest, growth) = sign_of_growth(rest)?;
    let (rest, overlay) = overlay(rest)?;
    Ok((rest, Motion::Circle { axis, extent, start, turns, ellipse, growth, overlay }))
}

fn radius<'a>(input: Tokens<'a>) -> Parsed<'a, Extent> {
    if !is_word(input, "radius") {
        if let Ok((rest, _)) = distance_covered(input) {
            return told(
                Diagnostic::fault(input.span_to(rest), "is this the radius or the width of the circle?")
                    .label("here")
                    .hint("write `radius` before it: `radius 5cm`"),
            );
        }
        let (rest, size) = size(input);
        return Ok((rest, Extent::Size(size)));
    }
    match extent(input.skip())? {
        (_, Extent::Size(Size::Normal)) => must(expected(input.skip(), "a length such as `5cm`")),
        found => Ok(found),
    }
}

fn clock<'a>(input: Tokens<'a>) -> Parsed<'a, Clock> {
    let found = CLOCK.iter().position(|c| is_word(input, c)).and_then(|i| Clock::new(i as u8));
    match found {
        Some(clock) => Ok((input.skip(), clock)),
        None => told(
            Diagnostic::fault(input.span(), "a circle starts at a place of the clock face")
                .label(format!("expected {}", CLOCK.join(", ")))
                .hint("12 is the top, 3 a quarter of a turn clockwise"),
        ),
    }
}

fn turns<'a>(input: Tokens<'a>) -> Parsed<'a, f64> {
    if !is_word(input, "turns") {
        return Ok((input, 1.0));
    }
    let (rest, value) = must(number(input.skip()))?;
    if value > 0.0 && value <= MOST_TURNS {
        return Ok((rest, value));
    }
    told(
        Diagnostic::fault(input.skip().span(), "turns must lie above 0 and at most at 50")
            .label("here")
            .hint("to turn the other way, turn the axis round: `axis in` for `axis out`"),
    )
}

fn flattened<'a>(input: Tokens<'a>, axis: Heading) -> Parsed<'a, Option<(f64, Direction)>> {
    if !is_word(input, "flattened") {
        return Ok((input, None));
    }
    let (rest, part) = must(number(input.skip()))?;
    if !(part > 0.0 && part < 1.0) {
        return told(
            Diagnostic::fault(input.skip().span(), "an ellipse's short axis is a part of its long one")
                .label("expected a number between 0 and 1")
                .hint("write `flattened 0.5 along left` for half as high as wide"),
        );
    }
    let (rest, ()) = must(keyword("along")(rest))?;
    let (after, long) = must_direction(rest)?;
    if long.vector().cross(axis.vector()).length() < 0.2 {
        return told(
            Diagnostic::fault(rest.span_to(after), format!("a circle about {axis} has no width along {long}"))
                .label("along the circle's own axis"),
        );
    }
    Ok((after, Some((part, long))))
}

/// `growing`, `shrinking 2`, or nothing: +1, −2, 0.
pub(crate) fn sign_of_growth<'a>(input: Tokens<'a>) -> Parsed<'a, i8> {
    let sign = if is_word(input, "growing") {
        1
    } else if is_word(input, "shrinking") {
        -1
    } else {
        return Ok((input, 0));
    };
    match count(input.skip(), 9) {
        Ok((rest, n)) => Ok((rest, sign * n as i8)),
        Err(nom::Err::Error(_)) => Ok((input.skip(), sign)),
        Err(other) => Err(other),
    }
}
