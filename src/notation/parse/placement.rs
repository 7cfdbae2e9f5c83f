//! Placements: a place, its side, how near, with which point of the hand.

use super::input::{Parsed, Tokens, expected, must, told};
use super::words::{
    direction, hand_point, is_one_of, is_percentage, is_word, keyword, length, mark, must_direction, name, number, text,
};
use crate::diagnostics::Diagnostic;
use crate::notation::lex::Kind;
use crate::notation::suggest::nearest;
use crate::notation::syntax::{Distance, Place, Placement, Sited};
use crate::phonology::{Side, Space};

/// Words that end the name of a place: what joins values, and what is said of a movement or a gaze; its side.
pub(crate) const STOPS: [&str; 29] = [
    "then",
    "at",
    "and",
    "while",
    "to",
    "brushing",
    "fast",
    "slow",
    "tense",
    "rest",
    "halt",
    "bouncing",
    "toward-pinky",
    "toward-thumb",
    "repeated",
    "continued",
    "growing",
    "shrinking",
    "duration",
    "alternating",
    "speed",
    "becoming",
    "named",
    "moving",
    "slight",
    "strong",
    "forced",
    "left",
    "right",
];
/// Words that a place other than a named one begins with.
pub(crate) const HEADS: [&str; 10] =
    ["behind", "beside", "between", "other", "space", "point", "pointing", "referent", "the", "key"];

/// How deep `between` may nest.
const DEEPEST: usize = 16;
/// The furthest coordinate, in metres.
pub(crate) const FURTHEST_M: f64 = 10.0;

/// `[behind] [beside] PLACE [left|right] {, ATTRIBUTE}`
pub(crate) fn placement<'a>(input: Tokens<'a>) -> Parsed<'a, Placement> {
    let behind = is_word(input, "behind");
    let rest = if behind { input.skip() } else { input };
    let beside = is_word(rest, "beside");
    let from = if beside { rest.skip() } else { rest };
    let (rest, (place, side)) = sided_place(from)?;
    if beside && side.is_none() {
        return beside_which(input, rest);
    }
    let mut placement =
        Placement { behind, place, side: side.map(|side| (side, beside)), distance: None, with: None, offset: None };
    let mut rest = rest;
    while rest.is(Kind::Comma) {
        match attribute(rest.skip(), &mut placement) {
            Ok((after, ())) => rest = after,
            // The comma belongs to what follows the placement.
            Err(nom::Err::Error(_)) => break,
            Err(other) => return Err(other),
        }
    }
    Ok((rest, placement))
}

/// A place with its side before or after it: `left ear`, `forehead right`.
fn sided_place<'a>(input: Tokens<'a>) -> Parsed<'a, (Place, Option<Side>)> {
    let input = without_the(input);
    let before = side(input);
    // `left` alone is no place: it would be a direction in the wrong tier.
    let from = if before.is_some() { input.skip() } else { input };
    let (rest, place) = place(from, 0)?;
    let after = side(rest);
    match (before, after) {
        (Some(_), Some(_)) => told(
            Diagnostic::fault(input.span_to(rest.skip()), "the side of the place is given twice")
                .label("left or right, once"),
        ),
        (None, Some(side)) => Ok((rest.skip(), (place, Some(side)))),
        (before, None) => Ok((rest, (place, before))),
    }
}

/// `the left ear` reads as well as `left ear`.
fn without_the(input: Tokens) -> Tokens {
    if is_word(input, "the") { input.skip() } else { input }
}

fn side(input: Tokens) -> Option<Side> {
    if is_word(input, "left") {
        Some(Side::Left)
    } else if is_word(input, "right") {
        Some(Side::Right)
    } else {
        None
    }
}

pub(crate) fn place<'a>(input: Tokens<'a>, depth: usize) -> Parsed<'a, Place> {
    if depth > DEEPEST {
        return told(Diagnostic::fault(input.span(), "places are nested too deeply").label("here"));
    }
    if input.is(Kind::Open) {
        let (rest, inner) = must(place(input.skip(), depth + 1))?;
        let (rest, ()) = must(mark(Kind::Close, "a closing bracket")(rest))?;
        return Ok((rest, inner));
    }
    if is_word(input, "between") {
        return between(input.skip(), depth + 1);
    }
    if is_word(input, "other") {
        let from = if is_word(input.skip(), "hand") { input.skip_n(2) } else { input.skip() };
        let (rest, point) = must(hand_point(from))?;
        return Ok((rest, Place::OtherHand(point)));
    }
    if is_word(input, "space") {
        return space(input.skip());
    }
    if is_word(input, "point") {
        return point(input.skip()).map(|(rest, at)| (rest, Place::Point(at)));
    }
    if is_word(input, "pointing") {
        let (rest, ()) = must(keyword("at")(input.skip()))?;
        let (rest, at) = must(place(rest, depth + 1))?;
        return Ok((rest, Place::Towards(Box::new(at))));
    }
    if is_word(input, "referent") {
        let (rest, name) = must(text(input.skip()))?;
        return Ok((rest, Place::Referent(name)));
    }
    named(input)
}

/// `SIDED and SIDED`. A side behind the second place is that of the whole.
fn between<'a>(input: Tokens<'a>, depth: usize) -> Parsed<'a, Place> {
    let (rest, a) = must(sided(input, depth))?;
    if side(rest).is_some() {
        return told(
            Diagnostic::fault(rest.span(), "inside `between` a side stands before its place")
                .label("here")
                .hint("write for example `between right shoulders and chest`"),
        );
    }
    let (rest, ()) = must(keyword("and")(rest))?;
    let (rest, b) = must(sided(rest, depth))?;
    Ok((rest, Place::Between(Box::new(a), Box::new(b))))
}

/// `[[beside] SIDE] PLACE`
fn sided<'a>(input: Tokens<'a>, depth: usize) -> Parsed<'a, Sited> {
    let beside = is_word(input, "beside");
    let from = without_the(if beside { input.skip() } else { input });
    let found = side(from);
    if beside && found.is_none() {
        return beside_which(input, from);
    }
    let (rest, place) = place(if found.is_some() { from.skip() } else { from }, depth)?;
    Ok((rest, Sited { place, side: found.map(|side| (side, beside)) }))
}

fn beside_which<'a, T>(start: Tokens<'a>, rest: Tokens<'a>) -> Parsed<'a, T> {
    told(
        Diagnostic::fault(start.span_to(rest), "beside which side of the place?")
            .label("a side is missing")
            .hint("write `beside left ear` or `beside forehead right`"),
    )
}

fn named<'a>(input: Tokens<'a>) -> Parsed<'a, Place> {
    let (rest, found) = name(without_the(input), &STOPS, "a place")?;
    Ok((rest, Place::Named(found)))
}

pub(crate) fn space<'a>(input: Tokens<'a>) -> Parsed<'a, Place> {
    let mut cell = Space::default();
    let mut said = [false; 3];
    let mut rest = input;
    loop {
        let Some((axis, value)) = step(rest.word()) else { return Ok((rest, Place::Space(cell))) };
        if said[axis] {
            return told(
                Diagnostic::fault(rest.span(), "this axis of the space is said twice")
                    .label("here")
                    .hint("say one of left, centre, right; one of high, low; one of near, far"),
            );
        }
        said[axis] = true;
        take_step(&mut cell, axis, value);
        rest = rest.skip();
    }
}

/// The words of the grid: an axis (left, high, far) and a step on it.
pub(crate) const STEPS: [(&str, (usize, i8)); 9] = [
    ("left", (0, 1)),
    ("centre", (0, 0)),
    ("center", (0, 0)),
    ("right", (0, -1)),
    ("high", (1, 1)),
    ("mid-height", (1, 0)),
    ("low", (1, -1)),
    ("far", (2, 1)),
    ("near", (2, -1)),
];

/// The axis and the step of a word of the grid.
pub(crate) fn step(word: &str) -> Option<(usize, i8)> {
    STEPS.iter().find(|(name, _)| name.eq_ignore_ascii_case(word)).map(|(_, step)| *step)
}

/// Goes a step on an axis of the grid.
pub(crate) fn take_step(cell: &mut Space, axis: usize, value: i8) {
    match axis {
        0 => cell.left = value,
        1 => cell.high = value,
        _ => cell.far = value,
    }
}

pub(crate) fn point<'a>(input: Tokens<'a>) -> Parsed<'a, [f64; 3]> {
    let mut at = [0.0; 3];
    let mut rest = input;
    for coordinate in &mut at {
        let (after, value) = must(number(rest)).map_err(|error| three_numbers(error, rest))?;
        if value.abs() > FURTHEST_M {
            return told(
                Diagnostic::fault(rest.span(), "this point is out of reach")
                    .label("coordinates are metres, from -10 to 10"),
            );
        }
        *coordinate = value;
        rest = after;
    }
    Ok((rest, at))
}

fn three_numbers(error: nom::Err<super::input::Mistake>, at: Tokens) -> nom::Err<super::input::Mistake> {
    if matches!(error, nom::Err::Failure(super::input::Mistake::Told(_))) {
        return error;
    }
    nom::Err::Failure(super::input::Mistake::Told(Box::new(
        Diagnostic::fault(at.span(), "a point is three numbers: left, up, out, in metres")
            .label("a number is missing")
            .hint("write for example `point 0.1 1.2 0.4`; in a point no unit is written"),
    )))
}

/// `touch`, `close`, `neutral distance`, `extended`, `3cm away`, `with index tip`, `offset up 5cm`.
fn attribute<'a>(input: Tokens<'a>, placement: &mut Placement) -> Parsed<'a, ()> {
    if is_word(input, "with") {
        let (rest, point) = must(hand_point(input.skip()))?;
        return set(&mut placement.with, point, input, rest, "the point of the hand");
    }
    if is_word(input, "offset") {
        let (rest, way) = must_direction(input.skip())?;
        let (rest, far) = must(length(rest))?;
        return set(&mut placement.offset, (way, far), input, rest, "the offset");
    }
    let (rest, distance) = distance(input)?;
    set(&mut placement.distance, distance, input, rest, "the distance")
}

fn set<'a, T>(slot: &mut Option<T>, value: T, start: Tokens<'a>, rest: Tokens<'a>, what: &str) -> Parsed<'a, ()> {
    if slot.is_some() {
        return told(Diagnostic::fault(start.span_to(rest), format!("{what} is given twice")).label("the second"));
    }
    *slot = Some(value);
    Ok((rest, ()))
}

fn distance<'a>(input: Tokens<'a>) -> Parsed<'a, Distance> {
    let named = [
        ("touch", Distance::Touch),
        ("touching", Distance::Touch),
        ("close", Distance::Close),
        ("neutral", Distance::Neutral),
        ("extended", Distance::Extended),
    ];
    let from = if is_word(input, "arm") && is_word(input.skip(), "extended") { input.skip() } else { input };
    if let Some((_, distance)) = named.iter().find(|(word, _)| is_word(from, word)) {
        let rest = from.skip();
        return Ok((if is_word(rest, "distance") { rest.skip() } else { rest }, *distance));
    }
    // What a gaze at a place is said with: `, 60%`.
    if is_percentage(input.word()) {
        return expected(input, "`touch` or a distance");
    }
    if input.word().starts_with(|c: char| c.is_ascii_digit() || c == '-') {
        let (rest, far) = must(length(input))?;
        let (rest, ()) = must(keyword("away")(rest))?;
        return Ok((rest, Distance::Length(far)));
    }
    let word = input.word();
    if let Ok((_, d)) = direction(input) {
        return told(
            Diagnostic::fault(input.span(), format!("`{d}` after a comma says nothing of the place"))
                .label("here")
                .hint(format!("write `offset {d} 5cm`, or the side without a comma: `forehead {d}`")),
        );
    }
    let known = ["touch", "close", "neutral", "extended", "with", "offset"];
    match nearest(word, known) {
        Some(near) if !is_one_of(word, &known) && !is_one_of(word, &STOPS) => told(
            Diagnostic::fault(input.span(), format!("`{word}` says nothing of a placement"))
                .label("here")
                .hint(format!("did you mean `{near}`?")),
        ),
        _ => expected(input, "`touch`, `close`, `neutral distance`, `extended`, `3cm away`, `with …` or `offset …`"),
    }
}
