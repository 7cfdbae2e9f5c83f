//! A manifest as text, with a word on each part for whoever edits it.

use super::{Details, Hands, Manifest, Recording, Rig, Table, Unit, VERSION, mode_word, side_word};
use crate::corpus::segment::Component;
use std::fmt::Write;

impl Manifest {
    /// The manifest as YAML with comments; always in the same order. [`read`](super::read()) reads the same again.
    ///
    /// ```
    /// use chereme::corpus::manifest::{self, Manifest};
    /// let manifest = Manifest { title: "Numbers: one to ten".to_owned(), ..Manifest::default() };
    /// let text = manifest.to_yaml();
    /// assert!(text.contains("\ntitle: \"Numbers: one to ten\"\n"));
    /// assert_eq!(manifest::read(&text).unwrap(), manifest);
    /// ```
    pub fn to_yaml(&self) -> String {
        let mut out = Out(String::new());
        out.comment(&["A corpus: recordings of signing, whose skeletons they move, and what their annotations mean."]);
        out.comment(&["Paths are relative to this file. `chereme corpus check` tells what is missing or odd."]);
        out.line(0, &format!("version: {VERSION}"));
        out.line(0, &format!("title: {}", scalar(&self.title)));
        out.text(0, "language", self.language.as_ref().map(|l| l.value.as_str()));
        out.text(0, "licence", self.licence.as_ref().map(|l| l.value.as_str()));
        out.text(0, "credit", self.credit.as_ref().map(|l| l.value.as_str()));
        self.write_defaults(&mut out);
        self.write_rigs(&mut out);
        self.write_tiers(&mut out);
        self.write_values(&mut out);
        self.write_takes(&mut out);
        out.0
    }

    fn write_defaults(&self, out: &mut Out) {
        out.blank();
        out.comment(&[
            "What holds for every recording that does not say otherwise: skeleton, signer, dominant (right or left),",
            "hand (right, left or both), licence, credit, offset (the motion's second at which annotations begin).",
        ]);
        if self.defaults == Details::default() {
            return out.line(0, "defaults: {}");
        }
        out.line(0, "defaults:");
        details(out, 2, &self.defaults);
    }

    fn write_rigs(&self, out: &mut Out) {
        if self.skeletons.is_empty() {
            return;
        }
        out.blank();
        out.comment(&[
            "The skeletons of the recordings. unit: m, cm, mm, inch, cmu, or metres in one unit; up and front: axes of the",
            "files; skip_frames: frames at the start that are no motion (an inserted T-pose); mode: directions keeps bone",
            "directions, contacts keeps fingertips where they touch; joints: our joint's name and theirs.",
        ]);
        out.line(0, "skeletons:");
        self.skeletons.iter().for_each(|own| rig(out, own));
    }

    fn write_tiers(&self, out: &mut Out) {
        if self.tiers.is_empty() {
            return;
        }
        out.blank();
        out.comment(&[
            "Which of our tiers the annotations' tiers are; `*` stands for any letters, the first that fits counts.",
        ]);
        out.line(0, "tiers:");
        for rule in &self.tiers {
            out.entry(2, &rule.theirs.value, &scalar(&rule.ours.value));
        }
    }

    fn write_values(&self, out: &mut Out) {
        if self.values.is_empty() {
            return;
        }
        out.blank();
        out.comment(&["What the annotations' labels mean: theirs, and the name that our inventory has for it."]);
        out.line(0, "values:");
        for component in Component::ALL {
            let mut own = self.values.iter().filter(|rule| rule.component == component).peekable();
            if own.peek().is_some() {
                out.line(2, &format!("{}:", component.title()));
            }
            for rule in own {
                out.entry(4, &rule.theirs.value, &scalar(&rule.ours.value));
            }
        }
    }

    fn write_takes(&self, out: &mut Out) {
        out.blank();
        out.comment(&[
            "The recordings: name, motion, annotations (files), gloss (of a take that is one sign), span ([start, end] in",
            "seconds), and what differs from the defaults.",
        ]);
        if self.recordings.is_empty() {
            out.line(0, "recordings: []");
        } else {
            out.line(0, "recordings:");
            self.recordings.iter().for_each(|own| recording(out, own));
        }
        if !self.takes.is_empty() {
            out.blank();
            out.comment(&[
                "Tables that list recordings, a row each: a recording's field, and the heading of its column.",
            ]);
            out.line(0, "takes:");
            self.takes.iter().for_each(|own| table(out, own));
        }
    }
}

/// Text that grows line by line.
struct Out(String);

impl Out {
    fn line(&mut self, depth: usize, text: &str) {
        // A string takes everything.
        let _ = writeln!(self.0, "{:depth$}{text}", "");
    }

    /// A key that may be any text, and its value. YAML 1.2 (section 7.4.2) lets a key stand before its `:` up to 1024 letters
    /// of text only; a longer one is written with `?`.
    fn entry(&mut self, depth: usize, key: &str, value: &str) {
        const LONGEST: usize = 1000;
        let key = scalar(key);
        let before = if key.len() > LONGEST { format!("? {key}\n{:depth$}", "") } else { key };
        self.line(depth, format!("{before}: {value}").trim_end());
    }

    fn blank(&mut self) {
        self.0.push('\n');
    }

    fn comment(&mut self, lines: &[&str]) {
        lines.iter().for_each(|text| self.line(0, &format!("# {text}")));
    }

    fn text(&mut self, depth: usize, name: &str, value: Option<&str>) {
        if let Some(value) = value {
            self.line(depth, &format!("{name}: {}", scalar(value)));
        }
    }
}

fn details(out: &mut Out, depth: usize, details: &Details) {
    out.text(depth, "skeleton", details.skeleton.as_ref().map(|s| s.value.as_str()));
    out.text(depth, "signer", details.signer.as_ref().map(|s| s.value.as_str()));
    out.text(depth, "dominant", details.dominant.map(|s| side_word(s.value)));
    out.text(depth, "hand", details.hand.map(|s| Hands::word(s.value)));
    out.text(depth, "licence", details.licence.as_ref().map(|s| s.value.as_str()));
    out.text(depth, "credit", details.credit.as_ref().map(|s| s.value.as_str()));
    if let Some(offset) = details.offset {
        out.line(depth, &format!("offset: {}", offset.value));
    }
}

fn rig(out: &mut Out, rig: &Rig) {
    out.entry(2, &rig.name.value, "");
    if let Some(Unit(metres)) = rig.unit.map(|unit| unit.value) {
        out.line(4, &format!("unit: {}", Unit(metres).name().map_or_else(|| metres.to_string(), str::to_owned)));
    }
    if let Some(up) = rig.up {
        out.line(4, &format!("up: {}", up.value));
    }
    if let Some(front) = rig.front {
        out.line(4, &format!("front: {}", front.value));
    }
    out.line(4, &format!("skip_frames: {}", rig.skip_frames.value));
    out.line(4, &format!("mode: {}", mode_word(rig.mode.value)));
    if !rig.joints.is_empty() {
        out.line(4, "joints:");
        for (ours, theirs) in &rig.joints {
            out.entry(6, &ours.value, &scalar(&theirs.value));
        }
    }
}

fn recording(out: &mut Out, recording: &Recording) {
    out.line(2, &format!("- name: {}", scalar(&recording.name.value)));
    out.line(4, &format!("motion: {}", scalar(&recording.motion.value)));
    if !recording.annotations.is_empty() {
        let files: Vec<String> = recording.annotations.iter().map(|file| scalar(&file.value)).collect();
        out.line(4, &format!("annotations: [{}]", files.join(", ")));
    }
    out.text(4, "gloss", recording.gloss.as_ref().map(|g| g.value.as_str()));
    if let Some([start, end]) = recording.span.map(|span| span.value) {
        out.line(4, &format!("span: [{start}, {end}]"));
    }
    details(out, 4, &recording.details);
}

fn table(out: &mut Out, table: &Table) {
    out.line(2, &format!("- table: {}", scalar(&table.table.value)));
    out.line(4, "columns:");
    for (field, heading) in &table.columns {
        out.line(6, &format!("{}: {}", field.value.word(), scalar(&heading.value)));
    }
    details(out, 4, &table.details);
}

/// A text as YAML reads it as a text again: as it is where nothing in it means something, else in double quotes.
fn scalar(text: &str) -> String {
    let plain = |c: char| c.is_alphanumeric() || "_-./ ".contains(c);
    let begins = text.chars().next().is_some_and(|c| c.is_alphabetic() || c == '_');
    // Words that a reader may take for nothing or for a boolean are quoted, so that a person is not left to wonder.
    let taken = ["null", "true", "false", "yes", "no", "on", "off", "y", "n"].contains(&text.to_lowercase().as_str());
    if begins && !taken && text.chars().all(plain) && !text.ends_with(' ') {
        return text.to_owned();
    }
    let mut quoted = String::from("\"");
    for c in text.chars() {
        match c {
            '"' => quoted.push_str("\\\""),
            '\\' => quoted.push_str("\\\\"),
            '\n' => quoted.push_str("\\n"),
            '\r' => quoted.push_str("\\r"),
            '\t' => quoted.push_str("\\t"),
            // What is not seen, and what some readers take for the end of a line or refuse.
            c if c.is_control() || !is_printable(c) => {
                let _ = write!(quoted, "\\U{:08x}", u32::from(c));
            }
            c => quoted.push(c),
        }
    }
    quoted + "\""
}

/// What YAML 1.2 lets stand in a text as it is, less the line ends of Unicode and the byte order mark.
fn is_printable(c: char) -> bool {
    matches!(c, ' '..='~' | '\u{a0}'..='\u{2027}' | '\u{202a}'..='\u{d7ff}' | '\u{e000}'..='\u{fefe}' | '\u{ff00}'..='\u{fffd}' | '\u{10000}'..)
}
