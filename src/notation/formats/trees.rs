//! HamNoSys, SiGML and tables of strings through the tree that they share: read to signs, and signs written.

use super::{AnyReading, Form, Notation, Refused, Words, Written};
use crate::diagnostics::{Diagnostic, Severity, Source, Span};
use crate::notation::hamnosys::syntax::{self, Cue, Feature, FeatureKind, Tier, TierKind};
use crate::notation::hamnosys::{lower, parse, print, raise, table};
use crate::notation::lower::Lowered;
use crate::notation::sigml;
use crate::phonology::Sign;
use unicode_normalization::UnicodeNormalization;

/// A tree as it was read, and where its text begins in the source.
struct Found {
    tree: Option<syntax::Sign>,
    diagnostics: Vec<Diagnostic>,
}

/// Reads SiGML.
pub(super) fn sigml(source: &Source, words: &Words, language: &str) -> AnyReading {
    let (trees, diagnostics) = sigml::read(source);
    let begun: usize = ["<hns_sign", "<hamgestural_sign"].iter().map(|tag| source.text.matches(tag).count()).sum();
    let refused = begun.saturating_sub(trees.len());
    let mut reading = empty(Notation::SiGml, diagnostics, refused);
    let many = trees.len() > 1;
    for (i, tree) in trees.into_iter().enumerate() {
        take(&mut reading, tree, Span::default(), source, many.then_some(i + 1), words, language);
    }
    if begun == 0 && !reading.has_faults() {
        let fault = Diagnostic::fault(Span::new(0, 0), "there is no sign in this SiGML")
            .label("expected hns_sign or hamgestural_sign");
        reading.diagnostics.push(fault);
        reading.refused = 1;
    }
    sorted(reading)
}

/// Reads strings of HamNoSys, a sign a line, perhaps after a gloss and a tab; lines that begin with `#` are remarks.
pub(super) fn strings(source: &Source, words: &Words, language: &str) -> AnyReading {
    let mut reading = empty(Notation::HamNoSys, Vec::new(), 0);
    let is_said = |line: &str| !line.trim().is_empty() && !line.trim_start().starts_with('#');
    let many = source.text.lines().filter(|line| is_said(line)).count() > 1;
    let (mut at, mut number) = (0, 0);
    for line in source.text.split_inclusive('\n') {
        let start = at;
        at += line.len();
        if !is_said(line) {
            continue;
        }
        number += 1;
        let (gloss, string) = match line.split_once('\t') {
            Some((gloss, string)) => (Some(gloss.trim()), string),
            None => (None, line),
        };
        let from = start + line.len() - string.len();
        let found = string_at(string.trim_end(), |span| Span::new(span.start + from, span.end + from), gloss, None);
        let span = Span::new(start, start + line.trim_end().len());
        add(&mut reading, found, span, source, many.then_some(number), words, language);
    }
    sorted(reading)
}

/// Reads a table of strings.
pub(super) fn table(source: &Source, words: &Words, language: &str) -> AnyReading {
    let (rows, diagnostics) = table::rows(source, &table::Options::default());
    let refused = diagnostics.iter().filter(|d| d.severity == Severity::Fault).count();
    let mut reading = empty(Notation::Table, diagnostics, refused);
    for (i, row) in rows.iter().enumerate() {
        let found = string_at(&row.notation, |span| row.place(span), row.gloss.as_deref(), row.mouthing.as_deref());
        add(&mut reading, found, row.span, source, Some(i + 1), words, language);
    }
    sorted(reading)
}

fn empty(notation: Notation, diagnostics: Vec<Diagnostic>, refused: usize) -> AnyReading {
    AnyReading { notation, signs: Vec::new(), derived: Vec::new(), refused, diagnostics }
}

fn sorted(mut reading: AnyReading) -> AnyReading {
    reading.diagnostics.sort_by_key(|d| d.span.start);
    reading
}

/// One string with its gloss and mouthing; `place` leads from the string's spans to the source's.
fn string_at(string: &str, place: impl Fn(Span) -> Span, gloss: Option<&str>, mouthing: Option<&str>) -> Found {
    let (tree, diagnostics) = parse::sign(string);
    let moved = |mut d: Diagnostic| {
        d.span = place(d.span);
        d.related = d.related.map(|(span, what)| (place(span), what));
        d
    };
    let tree = tree.map(|mut tree| {
        tree.gloss = gloss.filter(|g| !g.is_empty()).map(str::to_owned).or(tree.gloss);
        tree.span.0 = place(tree.span.0);
        tree.phases.iter_mut().for_each(|phase| phase.span.0 = place(phase.span.0));
        tree.nonmanual.extend(mouthing.filter(|m| !m.trim().is_empty()).map(mouthed));
        tree
    });
    Found { tree, diagnostics: diagnostics.into_iter().map(moved).collect() }
}

/// A mouth picture as a tier.
fn mouthed(sounds: &str) -> Tier {
    let value = sounds.trim().to_owned();
    let one = Feature { kind: FeatureKind::MouthPicture, value, amount: None, speed: None, span: Default::default() };
    Tier { kind: TierKind::Mouthing, cues: vec![Cue::One(one)] }
}

fn add(
    reading: &mut AnyReading,
    found: Found,
    span: Span,
    source: &Source,
    number: Option<usize>,
    words: &Words,
    language: &str,
) {
    reading.diagnostics.extend(found.diagnostics);
    match found.tree {
        Some(tree) => take(reading, tree, span, source, number, words, language),
        None => reading.refused += 1,
    }
}

/// Takes the sign of a tree into a reading. One without a gloss is named after its file, and numbered where it is one of many.
fn take(
    reading: &mut AnyReading,
    tree: syntax::Sign,
    span: Span,
    source: &Source,
    number: Option<usize>,
    words: &Words,
    language: &str,
) {
    let (sign, diagnostics) = lower(&tree, &words.dictionary, language);
    reading.diagnostics.extend(diagnostics);
    let Some(mut sign) = sign else {
        reading.refused += 1;
        return;
    };
    if sign.name.trim().is_empty() {
        let file = source.name.rsplit(['/', '\\']).next().unwrap_or_default();
        let stem = file.rsplit_once('.').map_or(file, |(stem, _)| stem);
        let stem = if stem.is_empty() || stem.starts_with('<') { "sign" } else { stem };
        sign.name = number.map_or(stem.to_owned(), |n| format!("{stem}-{n}"));
    }
    sign.name = sign.name.trim().nfc().collect();
    let name_span = if span == Span::default() { tree.span.0 } else { span };
    reading.signs.push(Lowered { sign, name_span });
}

/// Writes signs in one of the forms that share the tree.
pub(super) fn write(signs: &[&Sign], form: Form, words: &Words) -> Written {
    let mut written = Written::default();
    let mut trees = Vec::new();
    for (number, sign) in signs.iter().enumerate() {
        let said =
            raise(sign, &words.dictionary).and_then(|raised| one(raised.sign, form).map(|o| (o, raised.warnings)));
        match said {
            Ok((one, warnings)) => {
                written.nearly.extend((!warnings.is_empty()).then_some(Refused { sign: number, reasons: warnings }));
                trees.push(one);
            }
            Err(reasons) => written.refused.push(Refused { sign: number, reasons }),
        }
    }
    if trees.is_empty() {
        return written;
    }
    let kind = match form {
        Form::SiGml => Some(sigml::Kind::Gestural),
        Form::HSiGml => Some(sigml::Kind::HamNoSys),
        Form::Sign | Form::HamNoSys | Form::Names => None,
    };
    written.text = match kind {
        None => trees.iter().map(|one| format!("{}\n", one.text)).collect(),
        Some(kind) => {
            let trees: Vec<syntax::Sign> = trees.into_iter().map(|one| one.tree).collect();
            // Each was written alone before, so together they can be.
            sigml::write(&trees, kind).unwrap_or_default()
        }
    };
    written
}

/// A sign that can be written.
struct One {
    tree: syntax::Sign,
    /// The gloss, a tab and the string; empty for SiGML.
    text: String,
}

fn one(tree: syntax::Sign, form: Form) -> Result<One, Vec<String>> {
    let string = |form| {
        let string = print::print(&tree, form)?;
        Ok(match &tree.gloss {
            Some(gloss) => format!("{}\t{string}", gloss.replace(['\t', '\n', '\r'], " ")),
            None => string,
        })
    };
    let alone = |kind| {
        // Who is told knows which sign it is about.
        let nameless = syntax::Sign { gloss: None, ..tree.clone() };
        let written = sigml::write(&[nameless], kind);
        written.map(|_| String::new()).map_err(|e| vec![e.to_string()])
    };
    let text = match form {
        Form::HamNoSys => string(print::Form::Unicode),
        Form::Names => string(print::Form::Names),
        Form::SiGml => alone(sigml::Kind::Gestural),
        Form::HSiGml => alone(sigml::Kind::HamNoSys),
        Form::Sign => Ok(String::new()),
    };
    text.map(|text| One { tree, text })
}
