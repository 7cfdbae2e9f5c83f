//! Text to [`syntax`](super::syntax): line by line, so that a fault spoils one line and no more.

mod becoming;
pub(crate) mod configuration;
pub(crate) mod input;
pub(crate) mod motion;
mod movement;
pub(crate) mod nonmanual;
mod orientation;
pub(crate) mod placement;
pub(crate) mod recombination;
mod repetition;
mod tier;
mod whole;
pub(crate) mod words;

use super::lex::{Dialect, Kind, Token, lex, lines};
use super::suggest::nearest;
use super::syntax::{Begins, Content, File, Ignored, Line, OtherHand, TierLine, Value};
use crate::diagnostics::{Diagnostic, Span, Spanned};
use crate::phonology::{Channel, Hand};
use input::{Mistake, Parsed, Tokens, expected, must, told};
use unicode_normalization::UnicodeNormalization;
use words::{duration, is_word, keyword, text};

/// The keywords that begin a tier's line, besides the non-manual channels.
pub(crate) const TIERS: [&str; 13] = [
    "meaning",
    "source",
    "status",
    "note",
    "hands",
    "configuration",
    "placement",
    "orientation",
    "movement",
    "contact",
    "speed",
    "base",
    "at",
];

/// Reads a text. Lines with faults come back as [`Content::Broken`], each with its diagnostic.
///
/// ```
/// let (file, faults) = chereme::notation::parse("sign BOL\n  configuration round-B\n");
/// assert!(faults.is_empty());
/// assert_eq!(file.lines.len(), 2);
/// ```
pub fn parse(text: &str) -> (File, Vec<Diagnostic>) {
    let mut file = File::default();
    let mut faults = Vec::new();
    for (offset, raw) in lines(text) {
        let span = Ignored(Span::new(offset, offset + raw.len()));
        match lex(raw, offset, Dialect::Sign) {
            Err(fault) => {
                faults.push(*fault);
                let mut words = raw.split_whitespace();
                let content = Content::Broken(begins(words.next().unwrap_or(""), words.next().unwrap_or("")));
                file.lines.push(Line { content: Some(content), comment: None, span });
            }
            Ok(lexed) => {
                let content = (!lexed.tokens.is_empty()).then(|| content(&lexed.tokens, &mut faults));
                file.lines.push(Line { content, comment: lexed.comment.map(str::to_owned), span });
            }
        }
    }
    // `split_inclusive` gives no last empty line; a text of nothing has no lines.
    (file, faults)
}

fn content(tokens: &[Token], faults: &mut Vec<Diagnostic>) -> Content {
    let input = Tokens::new(tokens);
    let result =
        line(input).and_then(
            |(rest, content)| {
                if rest.is_empty() { Ok(content) } else { leftover(rest, input.word()).map(|(_, c)| c) }
            },
        );
    match result {
        Ok(content) => content,
        Err(error) => {
            faults.push(diagnostic(error, input));
            Content::Broken(begins(input.word(), input.skip().word()))
        }
    }
}

/// What is told where a line could not be read.
pub(crate) fn diagnostic(error: nom::Err<Mistake>, line: Tokens) -> Diagnostic {
    match error {
        nom::Err::Error(Mistake::Told(fault)) | nom::Err::Failure(Mistake::Told(fault)) => *fault,
        nom::Err::Error(Mistake::Expected { at, what }) | nom::Err::Failure(Mistake::Expected { at, what }) => {
            let what = if what.contains([' ', '`']) { what.to_owned() } else { format!("`{what}`") };
            match line.all().iter().find(|t| t.span == at) {
                Some(token) => Diagnostic::fault(at, format!("expected {what}, found `{}`", token.text)),
                None => Diagnostic::fault(at, format!("the line ends too early: expected {what}")),
            }
            .label(format!("expected {what}"))
        }
        // Nothing here reads a stream.
        nom::Err::Incomplete(_) => Diagnostic::fault(line.span(), "the line ends too early"),
    }
}

/// What a line was to begin, by its first two words.
fn begins(first: &str, second: &str) -> Begins {
    if first.eq_ignore_ascii_case("sign") {
        Begins::Sign
    } else if (first.eq_ignore_ascii_case("then") && (second.is_empty() || second.eq_ignore_ascii_case("other")))
        || first.eq_ignore_ascii_case("phase")
    {
        Begins::Phase
    } else {
        Begins::Line
    }
}

fn line<'a>(input: Tokens<'a>) -> Parsed<'a, Content> {
    if is_word(input, "then") {
        return phase(input);
    }
    if is_word(input, "sign") {
        return sign(input);
    }
    if is_word(input, "language") {
        let rest = input.skip();
        let word = rest.word();
        if word.is_empty() {
            return expected(rest, "the language's short name, such as `lsf`");
        }
        return Ok((rest.skip(), Content::Language(Spanned::new(word.nfc().collect(), rest.span()))));
    }
    let hand = if is_word(input, "strong") {
        Some(Hand::Strong)
    } else if is_word(input, "weak") {
        Some(Hand::Weak)
    } else {
        None
    };
    let from = if hand.is_some() { input.skip() } else { input };
    let (rest, value) = tier(from, hand)?;
    Ok((rest, Content::Tier(TierLine { hand, keyword: Ignored(input.span_to(from.skip())), value })))
}

/// `then [other hand stays]`
fn phase<'a>(input: Tokens<'a>) -> Parsed<'a, Content> {
    let rest = input.skip();
    if rest.is_empty() {
        return Ok((rest, Content::Then(OtherHand::Free)));
    }
    if is_word(rest, "other") {
        let (rest, ()) = must(keyword("hand")(rest.skip()))?;
        let (rest, ()) = must(keyword("stays")(rest))?;
        return Ok((rest, Content::Then(OtherHand::Stays)));
    }
    told(
        Diagnostic::fault(input.span(), "a line that begins with `then` begins a further phase of the sign")
            .label("nothing but `other hand stays` stands after it")
            .hint("values that follow each other stand on one line; the tiers of a phase stand below its `then`"),
    )
}

fn sign<'a>(input: Tokens<'a>) -> Parsed<'a, Content> {
    let rest = input.skip();
    let (after, name) = match rest.first() {
        Some(t) if t.kind == Kind::Text => {
            let (after, name) = text(rest)?;
            (after, name)
        }
        Some(t) if t.kind == Kind::Word => (rest.skip(), t.text.to_owned()),
        _ => {
            return told(
                Diagnostic::fault(input.span(), "this sign has no name")
                    .label("a name stands after it")
                    .hint("write `sign BOL`; a name with spaces or marks stands in quotes: `sign \"GOOD MORNING\"`, `sign \"#OK\"`"),
            );
        }
    };
    if name.trim().is_empty() {
        return told(Diagnostic::fault(rest.span(), "the name of this sign is empty").label("here"));
    }
    if after.is(Kind::Equals) {
        let (end, made) = must(recombination::expression(after.skip()))?;
        let name = name.trim().nfc().collect();
        return Ok((end, Content::Sign(Spanned::new(name, rest.span()), Some(made))));
    }
    if after.is(Kind::Word) {
        let all: Vec<&str> = rest.all().iter().take_while(|t| t.kind == Kind::Word).map(|t| t.text).collect();
        return told(
            Diagnostic::fault(after.span(), "a name with spaces stands in quotes")
                .label("the name ended before this")
                .hint(format!("write `sign \"{}\"` or `sign {}`", all.join(" "), all.join("-"))),
        );
    }
    let name = name.trim().nfc().collect();
    Ok((after, Content::Sign(Spanned::new(name, rest.span()), None)))
}

fn tier<'a>(input: Tokens<'a>, hand: Option<Hand>) -> Parsed<'a, Value> {
    let rest = input.skip();
    let keyword = input.word().to_ascii_lowercase();
    let one_hand = ["configuration", "placement", "orientation", "movement"].contains(&keyword.as_str());
    if hand.is_some() && !one_hand && (TIERS.contains(&keyword.as_str()) || keyword == "duration") {
        return told(
            Diagnostic::fault(input.span(), format!("`{keyword}` belongs to no one hand"))
                .label("here")
                .hint("`strong` and `weak` stand before configuration, placement, orientation and movement"),
        );
    }
    match keyword.as_str() {
        "meaning" => must(meaning(rest)).map(|(r, v)| (r, Value::Meaning(v))),
        "source" => must(text(rest)).map(|(r, v)| (r, Value::Source(v))),
        "note" => must(text(rest)).map(|(r, v)| (r, Value::Note(v))),
        "status" => must(words::name(rest, &[], "a word such as `unverified`, or a text"))
            .map(|(r, v)| (r, Value::Status(v.value))),
        "hands" => must(orientation::hands(rest)).map(|(r, v)| (r, Value::Hands(v))),
        "configuration" => tier::values(rest, configuration::configuration).map(|(r, v)| (r, Value::Configuration(v))),
        "placement" => tier::values(rest, placement::placement).map(|(r, v)| (r, Value::Placement(v))),
        "orientation" => tier::values(rest, orientation::orientation).map(|(r, v)| (r, Value::Orientation(v))),
        "movement" => movement::movements(rest).map(|(r, v)| (r, Value::Movement(v))),
        "contact" => tier::values(rest, orientation::contact).map(|(r, v)| (r, Value::Contact(v))),
        "duration" => must(duration(rest)).map(|(r, v)| (r, Value::Duration(v))),
        "speed" => must(whole::speed(rest)).map(|(r, v)| (r, Value::Speed(v))),
        "base" => must(whole::base(rest)).map(|(r, v)| (r, Value::Base(v))),
        "at" => must(whole::relocation(rest)).map(|(r, v)| (r, Value::At(v))),
        _ => match Channel::ALL.into_iter().find(|c| c.name() == keyword) {
            Some(_) if hand.is_some() => {
                told(Diagnostic::fault(input.span(), format!("`{keyword}` is no tier of a hand")).label("here"))
            }
            Some(channel) => tier::values(rest, nonmanual::nonmanual).map(|(r, v)| (r, Value::NonManual(channel, v))),
            None => no_tier(input, hand),
        },
    }
}

/// `en "bowl", fr "bol"`
fn meaning<'a>(input: Tokens<'a>) -> Parsed<'a, Vec<(String, String)>> {
    let mut all = Vec::new();
    let mut rest = input;
    loop {
        let language = rest.word();
        if language.is_empty() {
            if rest.is(Kind::Text) {
                return told(
                    Diagnostic::fault(rest.span(), "in which language is this meaning?")
                        .label("here")
                        .hint(format!("write `en {}`", rest.first().map_or("\"…\"", |t| t.text))),
                );
            }
            return expected(rest, "a language and a text, such as `en \"bowl\"`");
        }
        let (after, words) = must(text(rest.skip()))?;
        all.push((language.to_owned(), words));
        if !after.is(Kind::Comma) {
            return Ok((after, all));
        }
        rest = after.skip();
    }
}

/// Words of the field for the tiers that we call otherwise.
const SYNONYMS: [(&str, &str); 18] = [
    ("handshape", "configuration"),
    ("shape", "configuration"),
    ("handconfig", "configuration"),
    ("location", "placement"),
    ("place", "placement"),
    ("position", "placement"),
    ("palm", "orientation"),
    ("fingers", "orientation"),
    ("motion", "movement"),
    ("path", "movement"),
    ("gloss", "sign"),
    ("name", "sign"),
    ("eyebrows", "brows"),
    ("eyes", "gaze"),
    ("body", "torso"),
    ("eyelids", "lids"),
    ("touch", "contact"),
    ("phase", "then"),
];

/// Our word for a word of the field.
pub(crate) fn synonym(word: &str) -> Option<&'static str> {
    SYNONYMS.iter().find(|(said, _)| word.eq_ignore_ascii_case(said)).map(|(_, ours)| *ours)
}

fn no_tier<'a, T>(input: Tokens<'a>, hand: Option<Hand>) -> Parsed<'a, T> {
    let Some(token) = input.first() else {
        return expected(input, "a tier such as `configuration`");
    };
    let word = token.text;
    let fault = Diagnostic::fault(token.span, format!("`{word}` is not a tier")).label("expected a tier");
    if hand.is_some() && is_word(input, "hand") {
        return told(fault.hint("leave `hand` out: `strong configuration flat`"));
    }
    if word.starts_with("ham") && word.len() > 5 || word.chars().any(|c| ('\u{e000}'..='\u{f8ff}').contains(&c)) {
        return told(fault.hint("this looks like HamNoSys; a `.sign` file describes a sign in words, one tier a line"));
    }
    if word.starts_with('<') {
        return told(fault.hint("this looks like SiGML or another XML; a `.sign` file describes a sign in words"));
    }
    if word.starts_with("//") || word.starts_with(';') {
        return told(fault.hint("comments begin with `#`"));
    }
    if word.ends_with(':') {
        return told(fault.hint(format!("leave the colon out: `{}`", word.trim_end_matches(':'))));
    }
    if input.skip().is(Kind::Equals) {
        return told(fault.hint("a tier's value stands after its keyword without `=`"));
    }
    if word.chars().all(|c| c.is_uppercase() || c == '-') && input.skip().is_empty() {
        return told(fault.hint(format!("did you mean `sign {word}`?")));
    }
    let known = TIERS.into_iter().filter(|t| *t != "at").chain(["sign", "language", "duration", "strong", "weak"]);
    let known = known.chain(Channel::ALL.map(Channel::name));
    told(match synonym(word).or_else(|| nearest(word, known)) {
        Some(near) => fault.hint(format!("did you mean `{near}`?")),
        None => fault.hint(format!(
            "tiers are {}, duration, {}",
            TIERS.join(", "),
            Channel::ALL.map(Channel::name).join(", ")
        )),
    })
}

/// What stands after a value that was read to its end.
fn leftover<'a, T>(rest: Tokens<'a>, tier: &str) -> Parsed<'a, T> {
    let Some(token) = rest.first() else { return expected(rest, "something more") };
    let next = rest.skip();
    let fault = Diagnostic::fault(token.span, format!("`{}` is not expected here", token.text))
        .label("the value ended before this");
    let word = token.text.to_ascii_lowercase();
    let fault = match (token.kind, tier.to_ascii_lowercase().as_str()) {
        (Kind::Close, _) => fault.hint("this bracket was never opened"),
        (Kind::Equals, _) => fault.hint("only a `sign` line may have `=`"),
        (Kind::Comma, _) if next.is_empty() => fault.hint("leave out the comma at the end of the line"),
        (Kind::Comma, "movement") if next.word().parse::<crate::phonology::Direction>().is_ok() => {
            fault.hint("movements that follow each other are joined by `then`, simultaneous ones by `while`")
        }
        (Kind::Comma, _) if next.is(Kind::Word) => {
            return unknown_after_comma(next);
        }
        (Kind::Word, _) if word == "and" || word == "und" || word == "et" => {
            fault.hint("values that follow each other are joined by `then`")
        }
        (Kind::Word, "movement") if word == "at" => fault.hint("a movement fills its interval; only values at keys take `at`"),
        (Kind::Word, "placement") if ["touch", "close", "extended", "with", "offset"].contains(&word.as_str()) => {
            fault.hint(format!("a comma is missing: `…, {word}`"))
        }
        (Kind::Word, "hands") if ["mirrored", "parallel"].contains(&word.as_str()) => {
            fault.hint(format!("write `both {word}`"))
        }
        (Kind::Word, "hands") => fault.hint("write `one`, `weak`, `both`, or `both mirrored` or `both parallel` with up-down, out-in, alternating, crossed"),
        (Kind::Text, "meaning") => fault.hint("meanings are separated by commas: `en \"bowl\", fr \"bol\"`"),
        _ => match nearest(&word, ["then", "while", "at", "to", "brushing", "repeated", "continued", "fast", "slow", "duration", "speed", "becoming", "named", "moving"]) {
            Some(near) if near != word => fault.hint(format!("did you mean `{near}`?")),
            _ => fault,
        },
    };
    told(fault)
}

fn unknown_after_comma<'a, T>(at: Tokens<'a>) -> Parsed<'a, T> {
    let word = at.word();
    let fault = Diagnostic::fault(at.span(), format!("`{word}` is not expected after this comma")).label("here");
    let known = [
        "touch",
        "close",
        "neutral",
        "extended",
        "with",
        "offset",
        "fast",
        "slow",
        "tense",
        "rest",
        "halt",
        "repeated",
        "continued",
        "brushing",
        "duration",
        "alternating",
        "zigzag",
        "wavy",
        "speed",
        "becoming",
        "named",
        "bouncing",
        "moving",
    ];
    told(match nearest(word, known) {
        Some(near) => fault.hint(format!("did you mean `{near}`?")),
        None => fault,
    })
}
