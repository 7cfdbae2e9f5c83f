//! From the bytes of a TextGrid to what it says, or to what is wrong with it.

use super::token::{Token, Tokens};
use super::{GridTier, Kind, TextGrid};
use crate::diagnostics::xml::short;
use crate::diagnostics::{Diagnostic, Span};
use crate::format::text;
use crate::format::told::Told;
use crate::tier::Tier;
use crate::time::Seconds;

/// A file that could be read.
#[derive(Debug, Clone, PartialEq)]
pub struct Reading {
    /// What it says.
    pub grid: TextGrid,
    /// What is odd about it, by place: intervals that overlap.
    pub warnings: Vec<Diagnostic>,
}

/// Reads a TextGrid of either text form.
///
/// # Errors
/// What is wrong, with places in the text that [`source_of_bytes`](crate::format::text::source_of_bytes) gives. A count that
/// does not fit ends the reading, because what follows would be guessed.
///
/// ```
/// use chereme::format::textgrid;
/// let short = "File type = \"ooTextFile\"\nObject class = \"TextGrid\"\n\n0\n2\n<exists>\n1\n\"IntervalTier\"\n\"RH\"\n0\n2\n2\n0\n1.2\n\"BOL\"\n1.2\n2\n\"\"\n";
/// let grid = textgrid::read(short.as_bytes()).unwrap().grid;
/// let values = grid.tiers[0].tier.values();
/// assert_eq!((values.len(), values[0].label.as_str(), values[0].end.0), (1, "BOL", 1.2));
/// let faults = textgrid::read(short.replace("<exists>\n1", "<exists>\n2").as_bytes()).unwrap_err();
/// assert_eq!(faults[0].message, "the file ends too early");
/// ```
pub fn read(bytes: &[u8]) -> Result<Reading, Vec<Diagnostic>> {
    let mut told = Told::default();
    if bytes.starts_with(b"ooBinaryFile") {
        let fault = Diagnostic::fault(Span::new(0, 12), "this is a binary TextGrid").label("not read here");
        told.say(fault.hint("in Praat, Save as text file"));
        return Err(told.finish());
    }
    let (text, note) = text::decode(bytes);
    note.into_iter().for_each(|note| told.say(note));
    let mut reader = Reader { tokens: Tokens::new(&text), told };
    let grid = reader.file();
    match grid {
        Ok(grid) => reader.told.judge(grid).map(|(grid, warnings)| Reading { grid, warnings }),
        Err(fault) => {
            reader.told.say(*fault);
            Err(reader.told.finish())
        }
    }
}

/// A fault that makes the rest unreadable.
type Stop = Box<Diagnostic>;

struct Reader<'a> {
    tokens: Tokens<'a>,
    told: Told,
}

impl<'a> Reader<'a> {
    fn file(&mut self) -> Result<TextGrid, Stop> {
        let (kind, span) = self.text("the file type \"ooTextFile\"")?;
        if !kind.starts_with("ooTextFile") {
            let fault = Diagnostic::fault(span, "this is no text file of Praat").label("expected \"ooTextFile\"");
            return Err(fault.hint("a TextGrid begins: File type = \"ooTextFile\"").into());
        }
        let (class, span) = self.text("the object class \"TextGrid\"")?;
        if class != "TextGrid" {
            let fault = Diagnostic::fault(span, format!("this is a {} of Praat, no TextGrid", short(&class)));
            let hint = "select the TextGrid alone before saving it (not a collection of objects)";
            return Err(fault.label("expected \"TextGrid\"").hint(hint).into());
        }
        let (start, end) = self.extent("the grid")?;
        let mut tiers = Vec::new();
        match self.any("<exists>, or <absent> where there are no tiers")? {
            (Token::Flag("exists"), _) => {
                let (count, _) = self.count("how many tiers there are")?;
                for _ in 0..count {
                    tiers.push(self.tier()?);
                }
            }
            (Token::Flag("absent"), _) => {}
            (_, span) => return Err(expected(span, "<exists>, or <absent> where there are no tiers")),
        }
        if let Some((_, span)) = self.tokens.next() {
            let fault = Diagnostic::fault(span, "there is more than the counts say").label("expected the end");
            return Err(fault.hint("is a `size` too small, or are these two files in one?").into());
        }
        Ok(TextGrid { start, end, tiers })
    }

    fn tier(&mut self) -> Result<GridTier, Stop> {
        let (class, span) = self.text("\"IntervalTier\" or \"TextTier\"")?;
        let kind = match class.as_str() {
            "IntervalTier" => Kind::Intervals,
            "TextTier" => Kind::Points,
            _ => return Err(expected(span, "\"IntervalTier\" or \"TextTier\"")),
        };
        let (name, _) = self.text("the tier's name")?;
        self.extent(&format!("the tier `{}`", short(&name)))?;
        let (count, said) = self.count("how many intervals or points the tier has")?;
        let mut values: Vec<(Seconds, Seconds, String)> = Vec::new();
        for done in 0..count {
            let (start, span) = self.number("a time").map_err(|fault| miscounted(*fault, said, count, done))?;
            let end = if kind == Kind::Points { start } else { self.number("an end")?.0 };
            let (label, _) = self.text("a text")?;
            if end < start {
                let message = format!("this interval ends ({end}) before it begins ({start})");
                self.told.say(Diagnostic::fault(span, message).label("expected an end after the beginning"));
            }
            if values.last().is_some_and(|(_, before, _)| before.0 > start) {
                self.told.say(Diagnostic::warning(span, "this begins before the one before it ends").label("here"));
            }
            if kind == Kind::Points || !label.is_empty() {
                values.push((Seconds(start), Seconds(end), label));
            }
        }
        values.sort_by(|a, b| a.0.0.total_cmp(&b.0.0));
        let mut tier = Tier::new(name);
        values.into_iter().for_each(|(start, end, label)| tier.push(start, end, label, ""));
        Ok(GridTier { tier, kind })
    }

    fn extent(&mut self, of: &str) -> Result<(Seconds, Seconds), Stop> {
        let (start, _) = self.number(&format!("when {of} begins"))?;
        let (end, span) = self.number(&format!("when {of} ends"))?;
        if end < start {
            let fault = Diagnostic::fault(span, format!("{of} ends ({end}) before it begins ({start})"));
            self.told.say(fault.label("expected a later time"));
        }
        Ok((Seconds(start), Seconds(end)))
    }

    fn count(&mut self, what: &str) -> Result<(u64, Span), Stop> {
        let (number, span) = self.number(what)?;
        // Beyond this no file has as many; the loop over it ends with the file.
        match number {
            n if n >= 0.0 && n.fract() == 0.0 && n <= 1e15 => Ok((n as u64, span)),
            _ => Err(expected(span, &format!("{what}, a whole number"))),
        }
    }

    fn number(&mut self, what: &str) -> Result<(f64, Span), Stop> {
        match self.any(what)? {
            (Token::Number(number), span) => Ok((number, span)),
            (_, span) => Err(expected(span, &format!("{what}, a number"))),
        }
    }

    fn text(&mut self, what: &str) -> Result<(String, Span), Stop> {
        match self.any(what)? {
            (Token::Text(text), span) => Ok((text.into_owned(), span)),
            (Token::Open, span) => {
                let fault = Diagnostic::fault(span, "this text has no end").label("its quotation mark is not closed");
                Err(fault.hint("a quotation mark within a text is doubled: \"\"").into())
            }
            (_, span) => Err(expected(span, &format!("{what}, in quotation marks"))),
        }
    }

    fn any(&mut self, what: &str) -> Result<(Token<'a>, Span), Stop> {
        self.tokens.next().ok_or_else(|| {
            let fault = Diagnostic::fault(self.tokens.here(), "the file ends too early");
            fault.label(format!("expected {what}")).hint("was the file cut off, or is a `size` too large?").into()
        })
    }
}

fn expected(span: Span, what: &str) -> Stop {
    Diagnostic::fault(span, "this comes at the wrong place").label(format!("expected {what}")).into()
}

/// The same fault with the count that may be the mistake.
fn miscounted(fault: Diagnostic, said: Span, count: u64, done: u64) -> Stop {
    fault.related(said, format!("{count} are said here, and {done} were read")).into()
}
