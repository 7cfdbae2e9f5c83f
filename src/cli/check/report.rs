//! What a check comes to: a summary for people, a report for programs.

use super::super::terminal::count;
use super::super::world::{Checkup, Described};
use super::motion::Motion;
use super::reasons::{Example, Reason, reasons, word};
use super::warned;
use crate::diagnostics::Severity;
use serde::Serialize;

/// The report of a check. Everything is in the order of the texts.
#[derive(Debug, Serialize)]
pub(super) struct Report {
    /// How many texts were read.
    files: usize,
    /// How many signs can be used.
    signs: usize,
    /// How many of them have warnings.
    with_warnings: usize,
    /// How many signs have a fault and are left out.
    refused: usize,
    faults: usize,
    warnings: usize,
    /// What is wrong how often.
    reasons: Vec<Reason>,
    diagnostics: Vec<Told>,
    /// What `--motion` found.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) motion: Option<Motion>,
}

/// A fault or a warning.
#[derive(Debug, Serialize)]
struct Told {
    severity: &'static str,
    #[serde(flatten)]
    message: Example,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    hints: Vec<String>,
}

impl Report {
    /// The report of texts and of the signs that they hold.
    pub(super) fn of(checkups: &[Checkup], signs: &[Described]) -> Report {
        let all = || checkups.iter().flat_map(|checkup| checkup.diagnostics.iter().map(move |d| (checkup, d)));
        let of = |severity: Severity| all().filter(|(_, d)| d.severity == severity).count();
        let told = |(checkup, d): (&Checkup, &crate::diagnostics::Diagnostic)| Told {
            severity: word(d.severity),
            message: Example::of(d, checkup),
            hints: d.hints.clone(),
        };
        Report {
            files: checkups.len(),
            signs: signs.len(),
            with_warnings: warned(checkups, signs),
            refused: checkups.iter().map(|checkup| checkup.refused).sum(),
            faults: of(Severity::Fault),
            warnings: of(Severity::Warning),
            reasons: reasons(checkups),
            diagnostics: all().map(told).collect(),
            motion: None,
        }
    }

    /// Whether nothing has a fault, and every sign could be signed.
    pub(super) fn is_fine(&self) -> bool {
        self.faults == 0 && self.motion.as_ref().is_none_or(Motion::is_fine)
    }

    /// For programs.
    pub(super) fn json(&self) -> String {
        serde_json::to_string_pretty(self).map(|text| text + "\n").unwrap_or_default()
    }

    /// For people.
    pub(super) fn text(&self) -> String {
        let faults = if self.faults == 0 { "no faults".to_owned() } else { count(self.faults, "fault") };
        let mut text = format!("{} in {}: {faults}", count(self.signs, "sound sign"), count(self.files, "file"));
        if self.warnings > 0 {
            text.push_str(&format!(", {}", count(self.warnings, "warning")));
        }
        text.push('\n');
        if !self.reasons.is_empty() {
            let (refused, warned) = (count(self.refused, "sign"), count(self.with_warnings, "sign"));
            text.push_str(&format!("{refused} refused, {warned} with warnings\n"));
        }
        for severity in ["fault", "warning"] {
            let mut of = self.reasons.iter().filter(|reason| reason.severity == severity).peekable();
            if of.peek().is_some() {
                text.push_str(&format!("\n{severity}s by kind, the most frequent first:\n"));
            }
            for Reason { count, kind, example, .. } in of {
                let Example { file, line, column, message } = example;
                text.push_str(&format!("{count:6}  {kind}\n        such as {file}:{line}:{column}: {message}\n"));
            }
        }
        if let Some(motion) = &self.motion {
            text.push('\n');
            text.push_str(&motion.text());
        }
        text
    }
}
