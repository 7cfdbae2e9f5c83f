//! docs/notation.md: every example is read and signed, and every mistake gets the message that stands below it.
//!
//! A block marked `sign` is a file, `gloss` is lines, `sign fault` has its message in the `text` block below it.
//! `UPDATE=1 cargo test` writes the messages anew.

use crate::signing::{perform, world};
use chereme::diagnostics::render::render;
use chereme::diagnostics::{Diagnostic, Source};
use chereme::notation::lexicon::{Checked, embedded};
use chereme::notation::{Lexicon, read};
use chereme::phonology::operator::Tables;
use chereme::score::gloss::{self, Known, Settings};
use chereme::synthesis::{Options, synthesize_plan};

/// How far the wrist's limits may turn a hand of an example from what it states.
const MOST_TILT_DEGREES: f64 = 20.0;

/// A fenced block: what stands after the fence, the line after it (from 1) and its text.
struct Block {
    mark: String,
    line: usize,
    text: String,
}

fn path() -> std::path::PathBuf {
    std::path::Path::new(env!("CARGO_MANIFEST_DIR")).join("docs/notation.md")
}

fn document() -> String {
    std::fs::read_to_string(path()).unwrap()
}

fn blocks(document: &str) -> Vec<Block> {
    let mut all: Vec<Block> = Vec::new();
    let mut open = false;
    for (i, line) in document.lines().enumerate() {
        match (line.strip_prefix("```"), all.last_mut()) {
            (Some(_), Some(_)) if open => open = false,
            (Some(mark), _) => {
                open = true;
                all.push(Block { mark: mark.to_owned(), line: i + 2, text: String::new() });
            }
            (None, Some(block)) if open => block.text += &format!("{line}\n"),
            (None, _) => {}
        }
    }
    assert!(!open, "a block is not closed");
    all
}

fn tables() -> Tables<'static> {
    Tables { locations: &world().grammar.locations, movements: &world().grammar.movements }
}

/// The lexicon with texts above it, and what is said of these.
fn lexicon(above: Vec<Source>) -> (Lexicon, Vec<Checked>) {
    let mut lexicon = Lexicon::default();
    let mut below = lexicon.add(embedded(), &world().vocabulary);
    let mut checked = lexicon.add(above, &world().vocabulary);
    let own = checked.len();
    checked.append(&mut below);
    lexicon.link(&tables(), &mut checked);
    checked.truncate(own);
    (lexicon, checked)
}

fn told(diagnostics: &[Diagnostic], source: &Source) -> String {
    diagnostics.iter().map(|d| render(d, source, false) + "\n\n").collect::<String>().trim_end().to_owned()
}

#[test]
fn every_description_is_read_and_signed() {
    let all: Vec<Block> = blocks(&document()).into_iter().filter(|b| b.mark == "sign").collect();
    assert!(all.len() >= 20, "{} descriptions", all.len());
    let name = |b: &Block| format!("lexicon/line {}.sign", b.line);
    let sources = all.iter().map(|b| Source::new(name(b), b.text.as_str())).collect();
    let (lexicon, checked) = lexicon(sources);
    let faults: String = checked.iter().map(|c| told(&c.diagnostics, &c.source)).collect();
    assert!(faults.is_empty(), "{faults}");
    let mut strained = Vec::new();
    for block in &all {
        let signs: Vec<_> = lexicon.entries().filter(|e| e.path == name(block)).collect();
        assert!(!signs.is_empty(), "line {}: no sign", block.line);
        for entry in signs {
            let report = perform(&entry.sign).report;
            if report.tilt.to_degrees() > MOST_TILT_DEGREES || report.residual_m > 0.005 {
                strained.push(format!("line {}: {}: {:?}", block.line, entry.sign.name, report.warnings));
            }
        }
    }
    assert!(strained.is_empty(), "the body cannot do it:\n{}", strained.join("\n"));
}

#[test]
fn every_expression_of_the_tables_is_read() {
    let document = document();
    let all: Vec<&str> = document.split('`').filter(|code| code.starts_with("= ")).collect();
    assert!(all.len() >= 8, "{all:?}");
    let text: String = all
        .iter()
        .enumerate()
        .map(|(i, made)| format!("sign X{i} {made}\n"))
        .fold("language lsf\n".into(), |a, b| a + &b);
    let (lexicon, checked) = lexicon(vec![Source::new("tables.sign", text)]);
    assert_eq!(told(&checked[0].diagnostics, &checked[0].source), "");
    assert_eq!(lexicon.entries().filter(|e| e.path == "tables.sign").count(), all.len());
}

#[test]
fn every_gloss_line_is_read_and_signed() {
    let (lexicon, _) = lexicon(Vec::new());
    let known = Known { lexicon: &lexicon, vocabulary: &world().vocabulary, tables: tables() };
    let document = document();
    let all = blocks(&document).into_iter().filter(|b| b.mark == "gloss");
    let lines: Vec<String> = all.flat_map(|b| b.text.lines().map(str::to_owned).collect::<Vec<_>>()).collect();
    assert!(lines.len() >= 4, "{} lines", lines.len());
    for line in lines {
        let reading = gloss::read(&line, &known, &Settings::default());
        assert_eq!(told(&reading.diagnostics, &Source::new("line", line.as_str())), "");
        synthesize_plan(&reading.plan, &world().grammar, &world().signer, &Options::default())
            .unwrap_or_else(|e| panic!("{line}: {e}"));
    }
}

#[test]
fn every_mistake_has_the_message_below_it() {
    let mut document = document();
    let all = blocks(&document);
    let faults: Vec<(&Block, &Block)> =
        all.windows(2).filter(|w| w[0].mark == "sign fault").map(|w| (&w[0], &w[1])).collect();
    assert!(faults.len() >= 4, "{} mistakes", faults.len());
    let mut wrong = Vec::new();
    for (block, message) in faults {
        assert_eq!(message.mark, "text", "line {}", block.line);
        let source = Source::new("example.sign", block.text.as_str());
        let said = told(&read(&block.text, &world().vocabulary, "").diagnostics, &source);
        assert!(!said.is_empty(), "line {}: no fault", block.line);
        if said != message.text.trim_end() {
            let pair = |text: &str| format!("```sign fault\n{}```\n\n```text\n{}\n```\n", block.text, text.trim_end());
            assert!(document.contains(&pair(&message.text)), "line {}: the message stands elsewhere", message.line);
            document = document.replace(&pair(&message.text), &pair(&said));
            wrong.push(format!("line {}:\n{said}", message.line));
        }
    }
    if std::env::var_os("UPDATE").is_some() {
        std::fs::write(path(), document).unwrap();
    } else {
        assert!(wrong.is_empty(), "{}", wrong.join("\n"));
    }
}

#[test]
fn no_block_is_left_unchecked() {
    for block in blocks(&document()) {
        assert!(["sign", "sign fault", "gloss", "text"].contains(&block.mark.as_str()), "line {}", block.line);
    }
}
