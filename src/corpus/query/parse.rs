//! From text to a query, with all faults at once.

use super::scan::{Cursor, Piece};
use super::{Asked, Condition, Field, HandName, Order, Pattern, Query};
use crate::corpus::label::{Features, Label, Vocabulary};
use crate::diagnostics::suggest::nearest;
use crate::diagnostics::{Diagnostic, Source, Span};
use crate::phonology::Side;
use crate::phonology::grammar::fold;

/// A query that was understood, and what is odd about it.
#[derive(Debug, Clone, PartialEq)]
pub struct Parsed {
    /// The query.
    pub query: Query,
    /// Values with words that no inventory has: a corpus may have them all the same.
    pub warnings: Vec<Diagnostic>,
}

/// Other names of fields.
const ALSO: [(&str, Field); 9] = [
    ("config", Field::Value(crate::corpus::segment::Component::Configuration)),
    ("handshape", Field::Value(crate::corpus::segment::Component::Configuration)),
    ("hc", Field::Value(crate::corpus::segment::Component::Configuration)),
    ("place", Field::Value(crate::corpus::segment::Component::Placement)),
    ("location", Field::Value(crate::corpus::segment::Component::Placement)),
    ("finger", Field::Fingers),
    ("side", Field::Hand),
    ("take", Field::Recording),
    ("length", Field::Duration),
];

/// Reads a query; see the module for the language.
///
/// # Errors
/// All faults: unknown fields (with the nearest known one), operators that a field does not have, values that are none, quotes
/// without an end.
///
/// ```
/// use chereme::corpus::{label::Vocabulary, query::parse};
/// use chereme::diagnostics::Source;
/// use chereme::motion::skeleton::Skeleton;
/// let rig = Skeleton::from_json(chereme::avatar::SKELETON).unwrap();
/// let vocabulary = Vocabulary::builtin(&rig, None).unwrap();
/// let read = |text: &str| parse(&Source::new("query", text), &vocabulary);
/// assert_eq!(read("gloss=hello configuration~5:0.3 duration<1.2s").unwrap().query.conditions.len(), 3);
/// assert_eq!(read("glos=hello").unwrap_err()[0].hints, ["did you mean `gloss`?"]);
/// ```
pub fn parse(source: &Source, vocabulary: &Vocabulary) -> Result<Parsed, Vec<Diagnostic>> {
    let mut reader = Reader { cursor: Cursor::new(&source.text), vocabulary, faults: Vec::new(), warnings: Vec::new() };
    let mut query = Query::default();
    loop {
        reader.cursor.skip_space();
        if reader.cursor.rest().is_empty() {
            break;
        }
        match reader.condition() {
            Ok(condition) => query.conditions.push(condition),
            Err(fault) => {
                reader.faults.push(fault);
                reader.cursor.give_up();
            }
        }
    }
    let Reader { faults, warnings, .. } = reader;
    if faults.is_empty() { Ok(Parsed { query, warnings }) } else { Err(faults) }
}

struct Reader<'a> {
    cursor: Cursor<'a>,
    vocabulary: &'a Vocabulary,
    faults: Vec<Diagnostic>,
    warnings: Vec<Diagnostic>,
}

impl<'a> Reader<'a> {
    fn condition(&mut self) -> Result<Condition, Diagnostic> {
        let name = self.cursor.name();
        let Some((operator, at)) = self.cursor.operator() else { return Err(no_operator(&name, self.cursor.at)) };
        let field = field(&name);
        self.cursor.skip_space();
        let begin = self.cursor.at;
        let alternatives = self.alternatives(operator == "~")?;
        let end = self.cursor.at;
        let bound = if operator == "~" && self.cursor.takes(':') { Some(self.bound()?) } else { None };
        let field = field?;
        let written = self.cursor_text(begin, end);
        let asked = self.asked(field, (operator, at), &alternatives, bound)?;
        let span = name.span.to(Span::new(begin, self.cursor.at));
        Ok(Condition { field, negated: operator == "!=", asked, written, span })
    }

    /// The value as it was written, its quotes left out.
    fn cursor_text(&self, begin: usize, end: usize) -> String {
        self.cursor.text_between(begin, end).replace(['"', '\''], "")
    }

    /// Values between `|`, each of one or several between `>`.
    fn alternatives(&mut self, bound: bool) -> Result<Vec<Vec<Piece<'a>>>, Diagnostic> {
        let mut all = vec![Vec::new()];
        loop {
            let piece = self.cursor.value(bound).map_err(|span| {
                Diagnostic::fault(span, "this quote has no end")
                    .label("opened here")
                    .hint("close it with the same quote")
            })?;
            if piece.text.trim().is_empty() {
                return Err(Diagnostic::fault(piece.span, "here a value is missing").label("expected a value"));
            }
            if let Some(last) = all.last_mut() {
                last.push(piece);
            }
            if self.cursor.takes('|') {
                all.push(Vec::new());
            } else if !self.cursor.takes('>') {
                return Ok(all);
            }
        }
    }

    fn bound(&mut self) -> Result<f64, Diagnostic> {
        let piece = self.cursor.value(false).map_err(|span| Diagnostic::fault(span, "this quote has no end"))?;
        let number = piece.text.parse::<f64>().ok().filter(|n| (0.0..=1.0).contains(n));
        number.ok_or_else(|| {
            let message = format!("`{}` is no distance", piece.text);
            Diagnostic::fault(piece.span, message).label("expected a number from 0 (the same) to 1 (nothing alike)")
        })
    }

    fn asked(
        &mut self,
        field: Field,
        (operator, at): (&str, Span),
        alternatives: &[Vec<Piece<'a>>],
        bound: Option<f64>,
    ) -> Result<Asked, Diagnostic> {
        let is_time = matches!(field, Field::Duration | Field::Start);
        let ordered = matches!(operator, "<" | "<=" | ">" | ">=");
        if ordered && !is_time || operator == "~" && field.component().is_none() {
            return Err(wrong_operator(field, operator, at));
        }
        if let [only] = alternatives
            && let [piece] = &only[..]
            && piece.text == "?"
            && !piece.quoted
            && matches!(operator, "=" | "!=")
        {
            return Ok(Asked::Missing);
        }
        let component = field.component();
        if let Some(long) = alternatives.iter().find(|parts| parts.len() > 1 && component.is_none()) {
            let message = format!("`{}` has one value, no sequence", field.name());
            return Err(Diagnostic::fault(long[1].span, message).label("not expected here"));
        }
        let pieces = || alternatives.iter().flatten();
        match field {
            Field::Gloss | Field::Recording | Field::Signer => {
                Ok(Asked::Names(pieces().map(|piece| fold(piece.text.trim())).collect()))
            }
            Field::Hand => Ok(Asked::Hands(pieces().map(hand).collect::<Result<_, _>>()?)),
            Field::Duration | Field::Start => {
                let order = match operator {
                    "<" => Order::Less,
                    "<=" => Order::AtMost,
                    ">" => Order::More,
                    ">=" => Order::AtLeast,
                    _ => Order::Equal,
                };
                Ok(Asked::Times(order, pieces().map(time).collect::<Result<_, _>>()?))
            }
            Field::Value(_) | Field::Fingers | Field::Palm => self.values(field, operator == "~", alternatives, bound),
        }
    }

    fn values(
        &mut self,
        field: Field,
        near: bool,
        alternatives: &[Vec<Piece<'a>>],
        bound: Option<f64>,
    ) -> Result<Asked, Diagnostic> {
        let mut patterns = Vec::with_capacity(alternatives.len());
        for parts in alternatives {
            let parts = parts.iter().map(|piece| self.label(field, near, piece)).collect::<Result<_, _>>()?;
            patterns.push(Pattern { parts });
        }
        Ok(if near { Asked::Near { patterns, bound } } else { Asked::Values(patterns) })
    }

    /// A value as a label; a warning where words are unknown, a fault where nothing is left to compare.
    fn label(&mut self, field: Field, near: bool, piece: &Piece<'a>) -> Result<Label, Diagnostic> {
        let component = field.component().unwrap_or(crate::corpus::segment::Component::Configuration);
        let text = match field {
            Field::Fingers | Field::Palm => format!("{} {}", field.name(), piece.text.trim()),
            _ => piece.text.to_owned(),
        };
        let label = self.vocabulary.read(component, &text);
        let guesses = self.vocabulary.guesses(&label);
        let with_guesses = |diagnostic: Diagnostic| guesses.iter().fold(diagnostic, |d, guess| d.hint(guess.clone()));
        if near && label.features == Features::Nothing {
            let message = format!("`{}` is no {} that can be compared", piece.text, field.name());
            return Err(with_guesses(Diagnostic::fault(piece.span, message).label("not known")));
        }
        if let Some(word) = label.unknown.first() {
            let message = format!("no inventory has `{word}`: only values written so are found");
            self.warnings.push(with_guesses(Diagnostic::warning(piece.span, message).label("not known")));
        }
        Ok(label)
    }
}

fn field(name: &Piece) -> Result<Field, Diagnostic> {
    let folded = fold(name.text);
    let known = Field::ALL.into_iter().find(|field| field.name() == folded);
    let also = || ALSO.into_iter().find(|(other, _)| *other == folded).map(|(_, field)| field);
    known.or_else(also).ok_or_else(|| {
        let names = Field::ALL.map(Field::name);
        let message = match folded.as_str() {
            "" => "here the name of what is compared is missing".to_owned(),
            _ => format!("segments have no `{}`", name.text),
        };
        let fault = Diagnostic::fault(name.span, message).label("expected a field");
        match nearest(&folded, names) {
            Some(near) => fault.hint(format!("did you mean `{near}`?")),
            None => fault.hint(format!("the fields are {}", names.join(", "))),
        }
    })
}

fn no_operator(name: &Piece, at: usize) -> Diagnostic {
    let hint = match fold(name.text).as_str() {
        "and" | "&&" | "&" => "conditions stand side by side, without a word between them",
        "or" => "alternatives stand in one value: configuration=5|B",
        _ => "a condition is a field, an operator and a value: gloss=hello, configuration~5, duration<1.2s",
    };
    let span = if name.span.start == name.span.end { Span::new(at, at + 1) } else { name.span };
    Diagnostic::fault(span, "this is no condition").label("expected =, !=, ~, <, <=, > or >= after it").hint(hint)
}

fn wrong_operator(field: Field, operator: &str, at: Span) -> Diagnostic {
    let (has, instead) = match field {
        Field::Duration | Field::Start => {
            ("=, !=, <, <=, > and >=", "a time is near another where two conditions hold")
        }
        Field::Gloss | Field::Hand | Field::Recording | Field::Signer => ("= and !=", "only components can be near"),
        Field::Value(_) | Field::Fingers | Field::Palm => ("=, != and ~", "a sequence is written in the value: O>K"),
    };
    let message = format!("`{}` cannot be compared with `{operator}`", field.name());
    Diagnostic::fault(at, message).label(format!("it has {has}")).hint(instead)
}

fn hand(piece: &Piece) -> Result<HandName, Diagnostic> {
    match fold(piece.text).as_str() {
        "right" | "rh" | "r" => Ok(HandName::Side(Side::Right)),
        "left" | "lh" | "l" => Ok(HandName::Side(Side::Left)),
        "strong" | "dominant" => Ok(HandName::Strong),
        "weak" | "non-dominant" => Ok(HandName::Weak),
        other => {
            let fault = Diagnostic::fault(piece.span, format!("`{}` is no hand", piece.text));
            let fault = fault.label("expected right, left, strong or weak");
            let near = nearest(other, ["right", "left", "strong", "weak"]);
            Err(near.map_or(fault.clone(), |near| fault.hint(format!("did you mean `{near}`?"))))
        }
    }
}

/// Seconds: `1.2s`, `800ms`, `1.2`.
fn time(piece: &Piece) -> Result<f64, Diagnostic> {
    let text = fold(piece.text.trim());
    let (number, unit) = match (text.strip_suffix("ms"), text.strip_suffix('s')) {
        (Some(number), _) => (number, 0.001),
        (None, Some(number)) => (number, 1.0),
        (None, None) => (text.as_str(), 1.0),
    };
    let seconds = number.trim().parse::<f64>().ok().map(|n| n * unit).filter(|n| n.is_finite());
    seconds.ok_or_else(|| {
        let fault = Diagnostic::fault(piece.span, format!("`{}` is no time", piece.text));
        let fault = fault.label("expected seconds or milliseconds: 1.2s, 800ms");
        if text.contains(',') { fault.hint("the decimal mark is a point: 1.2s") } else { fault }
    })
}
