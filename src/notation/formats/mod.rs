//! The notations that signs are written in: which one a text is in, and one way to read and to write them all.
//!
//! Whoever takes signs from a file asks [`Notation::of`] what it is and [`read_any`] for its signs, and need not know more: a
//! notation is added here, and every command takes it. [`write_any`] goes the other way; a [`Form`] is how a notation is spelt.
//!
//! # What it refuses
//! A sign that cannot be used, or cannot be said in a form, is left out with the reason; the others are read and written.

mod trees;

use super::hamnosys::Dictionary;
use super::lower::{Derived, Lowered};
use super::read::{Reading, read};
use super::syntax::{Begins, Content};
use super::vocabulary::Vocabulary;
use super::{print, raise};
use crate::diagnostics::{Diagnostic, Severity, Source};
use crate::phonology::expression::Expressions;
use crate::phonology::handshape::HandshapeInventory;
use crate::phonology::{LocationInventory, Sign};
use std::sync::Arc;

/// How much of a file is looked at to know its notation, bytes.
const LOOKED_AT: usize = 64 * 1024;

/// A notation that signs are read from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Notation {
    /// Chereme's own: one tier a line.
    Sign,
    /// Strings of HamNoSys symbols, or of their names.
    HamNoSys,
    /// SiGML: HamNoSys as XML, gestural (`hamgestural_sign`) or symbol by symbol (`hns_sign`).
    SiGml,
    /// A table with a column of HamNoSys strings: TSV, CSV, JSON, JSON lines.
    Table,
}

impl Notation {
    /// All notations.
    pub const ALL: [Notation; 4] = [Notation::Sign, Notation::HamNoSys, Notation::SiGml, Notation::Table];

    /// What people call it.
    pub fn name(self) -> &'static str {
        match self {
            Notation::Sign => ".sign",
            Notation::HamNoSys => "HamNoSys",
            Notation::SiGml => "SiGML",
            Notation::Table => "a table of HamNoSys",
        }
    }

    /// The notation that a file's extension promises, whatever is in it.
    ///
    /// ```
    /// use chereme::notation::formats::Notation;
    /// assert_eq!(Notation::of_extension("dgs/HAUS.sigml"), Some(Notation::SiGml));
    /// assert_eq!(Notation::of_extension("notes.md"), None);
    /// ```
    pub fn of_extension(name: &str) -> Option<Notation> {
        match extension(name).as_str() {
            "sign" => Some(Notation::Sign),
            "sigml" | "xml" => Some(Notation::SiGml),
            "ham" | "hamnosys" | "hns" => Some(Notation::HamNoSys),
            "tsv" | "csv" | "json" | "jsonl" => Some(Notation::Table),
            _ => None,
        }
    }

    /// The notation of a file that may be anything, such as one found in a folder; `None` where it holds no signs as far as can
    /// be seen. `.sign`, `.sigml`, `.ham`, `.hamnosys` and `.hns` are taken at their word; `.xml`, `.txt`, `.tsv`, `.csv`,
    /// `.json` and `.jsonl` are looked into.
    ///
    /// ```
    /// use chereme::notation::formats::Notation;
    /// assert_eq!(Notation::of("a.xml", b"<sigml/>"), Some(Notation::SiGml));
    /// assert_eq!(Notation::of("a.xml", b"<svg/>"), None);
    /// assert_eq!(Notation::of("a.txt", "HAUS \u{e001}".as_bytes()), Some(Notation::HamNoSys));
    /// ```
    pub fn of(name: &str, bytes: &[u8]) -> Option<Notation> {
        let start = String::from_utf8_lossy(&bytes[..bytes.len().min(LOOKED_AT)]);
        let promised = Notation::of_extension(name);
        match (promised, extension(name).as_str()) {
            (Some(Notation::Sign), _) | (_, "sigml") => promised,
            // Symbols as XML are kept under names of HamNoSys too.
            (Some(Notation::HamNoSys), _) if is_sigml(&start) => Some(Notation::SiGml),
            (Some(Notation::HamNoSys), _) => promised,
            (Some(Notation::SiGml), _) => promised.filter(|_| is_sigml(&start)),
            (Some(Notation::Table), _) => promised.filter(|_| start.chars().any(is_symbol) || has_names(&start)),
            (None, "txt") => start.chars().any(is_symbol).then_some(Notation::HamNoSys),
            (None, _) => None,
        }
    }

    /// The notation of a text without a name, such as standard input.
    ///
    /// ```
    /// use chereme::notation::formats::Notation;
    /// assert_eq!(Notation::of_content("sign BOL\n  movement up\n"), Notation::Sign);
    /// assert_eq!(Notation::of_content("hamfist,hamextfingeru,hampalmd"), Notation::HamNoSys);
    /// assert_eq!(Notation::of_content("gloss\thamnosys\nHAUS\t\u{e001}\n"), Notation::Table);
    /// ```
    pub fn of_content(text: &str) -> Notation {
        let text = text.trim_start_matches('\u{feff}').trim_start();
        let says_sign = |line: &str| ["sign ", "language "].iter().any(|word| line.trim_start().starts_with(word));
        if text.starts_with('<') {
            Notation::SiGml
        } else if text.lines().any(says_sign) || !(text.chars().any(is_symbol) || has_names(text)) {
            Notation::Sign
        } else if text.starts_with(['{', '[']) || text.lines().next().is_some_and(|line| line.contains('\t')) {
            Notation::Table
        } else {
            Notation::HamNoSys
        }
    }
}

fn extension(name: &str) -> String {
    let file = name.rsplit(['/', '\\']).next().unwrap_or_default();
    file.rsplit_once('.').map(|(_, extension)| extension.to_lowercase()).unwrap_or_default()
}

/// Whether a character lies where HamNoSys's font has its symbols.
fn is_symbol(c: char) -> bool {
    ('\u{e000}'..='\u{e0ff}').contains(&c)
}

/// Whether a text names a symbol: a word such as `hamfist`.
fn has_names(text: &str) -> bool {
    text.split(|c: char| !c.is_ascii_alphanumeric()).any(is_name)
}

fn is_name(word: &str) -> bool {
    word.len() > 4 && word.starts_with("ham") && word.chars().all(|c| c.is_ascii_lowercase() || c.is_ascii_digit())
}

fn is_sigml(text: &str) -> bool {
    ["<sigml", "<hns_sign", "<hamgestural_sign"].iter().any(|tag| text.contains(tag))
}

/// Whether an argument of a command line is itself a string of HamNoSys: symbols, or names joined by commas or spaces.
///
/// ```
/// use chereme::notation::formats::is_string;
/// assert!(is_string("\u{e000}\u{e00c}") && is_string("hamfist,hamextfingeru"));
/// assert!(!is_string("BOL@left") && !is_string("hamster"));
/// ```
pub fn is_string(argument: &str) -> bool {
    let words: Vec<&str> = argument.split([',', ' ']).filter(|word| !word.is_empty()).collect();
    argument.chars().any(is_symbol) || words.len() > 1 && words.iter().all(|word| is_name(word))
}

/// What readers and writers look names up in.
#[derive(Debug, Clone)]
pub struct Words {
    /// The names that `.sign` texts may use.
    pub vocabulary: Vocabulary,
    /// What HamNoSys and SiGML call them.
    pub dictionary: Arc<Dictionary>,
}

/// Every name in `.sign` texts; the built-in inventories for HamNoSys.
impl Default for Words {
    fn default() -> Words {
        Words { vocabulary: Vocabulary::open(), dictionary: Arc::new(Dictionary::builtin().clone()) }
    }
}

impl Words {
    /// The words of inventories.
    pub fn of(handshapes: &HandshapeInventory, places: &LocationInventory, expressions: &Expressions) -> Words {
        Words {
            vocabulary: Vocabulary::of(handshapes, places, expressions),
            dictionary: Arc::new(Dictionary::of(handshapes, places, expressions)),
        }
    }
}

/// What a text holds, whatever its notation.
#[derive(Debug, Clone)]
pub struct AnyReading {
    /// The notation that it was read in.
    pub notation: Notation,
    /// The signs without faults, in the order they were written, with where their names (or they themselves) stand.
    pub signs: Vec<Lowered>,
    /// The signs without faults that are made from others; `.sign` alone has them.
    pub derived: Vec<Derived>,
    /// How many signs have a fault and are left out.
    pub refused: usize,
    /// All faults and warnings, by their place in the text.
    pub diagnostics: Vec<Diagnostic>,
}

impl AnyReading {
    /// Whether something cannot be used as it is written.
    pub fn has_faults(&self) -> bool {
        self.diagnostics.iter().any(|d| d.severity == Severity::Fault)
    }
}

impl From<Reading> for AnyReading {
    fn from(reading: Reading) -> AnyReading {
        let begins = |content: &&Content| matches!(content, Content::Sign(..) | Content::Broken(Begins::Sign));
        let begun = reading.file.lines.iter().filter_map(|line| line.content.as_ref()).filter(begins).count();
        let sound = reading.signs.len() + reading.derived.len();
        AnyReading {
            notation: Notation::Sign,
            refused: begun.saturating_sub(sound),
            signs: reading.signs,
            derived: reading.derived,
            diagnostics: reading.diagnostics,
        }
    }
}

/// Reads a text in a notation; `language` is that of signs whose text does not say it (the folder's name).
///
/// ```
/// use chereme::diagnostics::Source;
/// use chereme::notation::formats::{Notation, Words, read_any};
/// let source = Source::new("lsf/bol.sign", "sign BOL\n  hands both\nsign X\n  movement ark\n");
/// let reading = read_any(&source, Notation::Sign, &Words::default(), "lsf");
/// assert_eq!((reading.signs[0].sign.name.as_str(), reading.refused), ("BOL", 1));
/// ```
pub fn read_any(source: &Source, notation: Notation, words: &Words, language: &str) -> AnyReading {
    match notation {
        Notation::Sign => read(&source.text, &words.vocabulary, language).into(),
        Notation::HamNoSys => trees::strings(source, words, language),
        Notation::SiGml => trees::sigml(source, words, language),
        Notation::Table => trees::table(source, words, language),
    }
}

/// How signs are written: a notation and its spelling.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub enum Form {
    /// `.sign` text.
    Sign,
    /// Gestural SiGML.
    SiGml,
    /// H-SiGML: the symbols as XML elements.
    HSiGml,
    /// HamNoSys symbols, a string a line.
    HamNoSys,
    /// The names of HamNoSys symbols joined by commas, a sign a line.
    Names,
}

impl Form {
    /// All forms.
    pub const ALL: [Form; 5] = [Form::Sign, Form::SiGml, Form::HSiGml, Form::HamNoSys, Form::Names];

    /// The word for it on a command line.
    pub fn name(self) -> &'static str {
        match self {
            Form::Sign => "sign",
            Form::SiGml => "sigml",
            Form::HSiGml => "hns",
            Form::HamNoSys => "hamnosys",
            Form::Names => "names",
        }
    }

    /// The form that a file's extension asks for.
    ///
    /// ```
    /// use chereme::notation::formats::Form;
    /// assert_eq!(Form::of_extension("out/{stem}.sigml"), Some(Form::SiGml));
    /// ```
    pub fn of_extension(name: &str) -> Option<Form> {
        match extension(name).as_str() {
            "sign" => Some(Form::Sign),
            "sigml" | "xml" => Some(Form::SiGml),
            "ham" | "hamnosys" | "hns" | "txt" => Some(Form::HamNoSys),
            _ => None,
        }
    }
}

/// A text of signs, and which of them it leaves out.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Written {
    /// The text; empty where every sign was refused.
    pub text: String,
    /// What could not be said.
    pub refused: Vec<Refused>,
    /// What is said only nearly, such as lengths in centimetres.
    pub nearly: Vec<Refused>,
}

/// A sign that a form cannot say, or not all of it.
#[derive(Debug, Clone, PartialEq)]
pub struct Refused {
    /// The sign's number among those given, from 0.
    pub sign: usize,
    /// Why, each a sentence.
    pub reasons: Vec<String>,
}

/// Writes signs in a form, one after the other in one text. What cannot be said in it is left out, with the reasons.
///
/// ```
/// use chereme::notation::formats::{Form, Words, write_any};
/// use chereme::phonology::Sign;
/// let written = write_any(&[&Sign::named("A"), &Sign::named("B")], Form::Sign, &Words::default());
/// assert_eq!(written.text, "sign A\n\nsign B\n");
/// ```
pub fn write_any(signs: &[&Sign], form: Form, words: &Words) -> Written {
    match form {
        Form::Sign => write_signs(signs, words),
        Form::SiGml | Form::HSiGml | Form::HamNoSys | Form::Names => trees::write(signs, form, words),
    }
}

/// Signs as `.sign` text. A text is in one language: signs of others than the first one's are refused.
fn write_signs(signs: &[&Sign], words: &Words) -> Written {
    let mut written = Written::default();
    let mut language: Option<&str> = None;
    for (number, sign) in signs.iter().enumerate() {
        let said = said(sign, words).and_then(|text| match language {
            Some(first) if first != sign.language => Err(vec![format!(
                "a .sign text is in one language: this one is in {}, the sign in {}",
                named(first),
                named(&sign.language)
            )]),
            Some(_) => Ok(format!("\n{}", without_language(&text))),
            None => Ok(text),
        });
        match said {
            Ok(text) => {
                language = Some(&sign.language);
                written.text.push_str(&text);
            }
            Err(reasons) => written.refused.push(Refused { sign: number, reasons }),
        }
    }
    written
}

fn named(language: &str) -> &str {
    if language.is_empty() { "none that is named" } else { language }
}

/// A sign's text, read again to see that it says the same sign.
fn said(sign: &Sign, words: &Words) -> Result<String, Vec<String>> {
    let text = print(&raise(sign));
    let again = read(&text, &words.vocabulary, "");
    match again.signs.as_slice() {
        [one] if one.sign == *sign => Ok(text),
        [_] => Err(vec!["a .sign text cannot say all of it".into()]),
        _ => {
            let faults = again.diagnostics.iter().filter(|d| d.severity == Severity::Fault);
            Err(faults.map(|fault| fault.message.clone()).collect())
        }
    }
}

/// A sign's text without the language's line and the empty one after it.
fn without_language(text: &str) -> &str {
    match text.strip_prefix("language ").and_then(|rest| rest.split_once('\n')) {
        Some((_, rest)) => rest.trim_start_matches('\n'),
        None => text,
    }
}
