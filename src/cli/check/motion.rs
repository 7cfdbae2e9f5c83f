//! `check --motion`: every sign signed, and its motion checked.

use super::super::Failure;
use super::super::parallel::{Loudness, Progress, in_order, pool};
use super::super::terminal::count;
use super::super::world::{Checkup, Described};
use crate::avatar;
use crate::phonology::{Side, Sign};
use crate::synthesis::verify::{Finding, Kind, Weight, verify};
use crate::synthesis::{Grammar, Options, synthesize};
use crate::time::Fps;
use serde::Serialize;
use std::collections::BTreeSet;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::time::Instant;

/// How many findings of a kind are listed, the worst first.
const LISTED: usize = 10;

/// What `check --motion` is asked for.
pub(super) struct Asked {
    /// Frames a second.
    pub fps: Fps,
    /// Cores; all where it is not said.
    pub jobs: Option<u16>,
    /// Whether a bar may be drawn.
    pub loudness: Loudness,
}

/// What the motion of all signs came to.
#[derive(Debug, Serialize)]
pub(super) struct Motion {
    frames_per_second: f64,
    /// How many signs were signed.
    signs: usize,
    /// How many of them nothing was found of.
    without_findings: usize,
    /// What was found how often, the gravest first.
    kinds: Vec<OfKind>,
    /// Signs that cannot be signed.
    refused: Vec<Refused>,
    /// All that was found, in the order of the signs.
    findings: Vec<Found>,
    #[serde(skip)]
    seconds: f64,
}

/// How often a kind was found.
#[derive(Debug, Serialize)]
struct OfKind {
    kind: &'static str,
    weight: &'static str,
    signs: usize,
    findings: usize,
    /// The numbers of the worst findings, the worst first.
    #[serde(skip)]
    worst: Vec<usize>,
}

/// A sign that cannot be signed.
#[derive(Debug, Serialize)]
struct Refused {
    sign: String,
    file: String,
    why: String,
}

/// A finding and whose it is.
#[derive(Debug, Serialize)]
struct Found {
    sign: String,
    file: String,
    kind: &'static str,
    weight: &'static str,
    side: Option<&'static str>,
    seconds: f64,
    measured: f64,
    bound: f64,
    unit: &'static str,
    what: String,
    #[serde(skip)]
    finding: Finding,
    /// The number of the sign.
    #[serde(skip)]
    number: usize,
}

impl Found {
    fn of(finding: Finding, number: usize, sign: &str, file: &str) -> Found {
        let unit = finding.kind.unit();
        Found {
            sign: sign.to_owned(),
            file: file.to_owned(),
            kind: finding.kind.name(),
            weight: finding.kind.weight().name(),
            side: finding.side.map(|side| match side {
                Side::Left => "left",
                Side::Right => "right",
            }),
            seconds: rounded(finding.time.0),
            measured: rounded(unit.shown(finding.measured)),
            bound: rounded(unit.shown(finding.bound)),
            unit: unit.symbol().trim(),
            what: finding.what.clone(),
            finding,
            number,
        }
    }
}

/// To a thousandth, so that reports can be compared.
fn rounded(value: f64) -> f64 {
    (value * 1e3).round() / 1e3
}

/// Signs all signs and checks their motion, on several cores.
pub(super) fn check(
    signs: Vec<Described>,
    checkups: &[Checkup],
    grammar: &Grammar,
    asked: &Asked,
) -> Result<Motion, Failure> {
    let began = Instant::now();
    let signer = avatar::signer().map_err(|e| Failure::Faults(Some(e.to_string())))?;
    let options = Options { fps: asked.fps, ..Options::default() };
    let pool = pool(asked.jobs)?;
    let progress = Progress::new(signs.len(), asked.loudness);
    let try_one = |sign: &Sign| match synthesize(sign, grammar, &signer, &options) {
        Ok(performance) => Ok(verify(sign, &performance, grammar, &signer)),
        Err(error) => Err(error.to_string()),
    };
    let work = |Described { sign, text, .. }: Described| {
        // A fault of the program in one sign of thousands must not cost the others.
        let found = catch_unwind(AssertUnwindSafe(|| try_one(&sign)))
            .unwrap_or_else(|_| Err("the program failed at this sign; please report it".into()));
        progress.step();
        (sign.name, text, found)
    };
    let (mut number, mut without, mut findings, mut refused) = (0, 0, Vec::new(), Vec::new());
    in_order(&pool, signs, work, |(sign, text, found)| {
        let file = &checkups[text].text.source.name;
        match found {
            Err(why) => {
                refused.push(Refused { sign, file: file.clone(), why });
            }
            Ok(found) => {
                without += usize::from(found.is_empty());
                findings.extend(found.into_iter().map(|finding| Found::of(finding, number, &sign, file)));
                number += 1;
            }
        }
    });
    Ok(Motion {
        frames_per_second: asked.fps.get(),
        signs: number,
        without_findings: without,
        kinds: Kind::ALL.into_iter().filter_map(|kind| of_kind(kind, &findings)).collect(),
        refused,
        findings,
        seconds: began.elapsed().as_secs_f64(),
    })
}

/// How often a kind was found; `None` where it was not.
fn of_kind(kind: Kind, findings: &[Found]) -> Option<OfKind> {
    let mut own: Vec<usize> = (0..findings.len()).filter(|n| findings[*n].finding.kind == kind).collect();
    let signs: BTreeSet<usize> = own.iter().map(|n| findings[*n].number).collect();
    let (signs, found) = (signs.len(), own.len());
    own.sort_by(|a, b| findings[*b].finding.excess().total_cmp(&findings[*a].finding.excess()));
    own.truncate(LISTED);
    let (name, weight) = (kind.name(), kind.weight().name());
    (found > 0).then_some(OfKind { kind: name, weight, signs, findings: found, worst: own })
}

impl Motion {
    /// Whether every sign could be signed, and every motion can be used.
    pub(super) fn is_fine(&self) -> bool {
        self.refused.is_empty() && self.findings.iter().all(|f| f.finding.kind.weight() != Weight::Fault)
    }

    /// For people.
    pub(super) fn text(&self) -> String {
        let (signs, fps, seconds) = (count(self.signs, "sign"), self.frames_per_second, self.seconds);
        let mut text = format!(
            "{signs} signed at {fps} frames a second and checked in {seconds:.1} s: {} without a finding, {} that cannot be signed\n",
            self.without_findings,
            self.refused.len()
        );
        if !self.refused.is_empty() {
            text.push_str(&format!("\nfault: cannot be signed: {}\n", count(self.refused.len(), "sign")));
        }
        for Refused { sign, file, why } in self.refused.iter().take(LISTED) {
            text.push_str(&format!("  {sign} ({file}): {why}\n"));
        }
        for OfKind { kind, weight, signs, findings, worst } in &self.kinds {
            let (signs, findings) = (count(*signs, "sign"), count(*findings, "finding"));
            text.push_str(&format!("\n{weight}: {kind}: {signs}, {findings}\n"));
            for n in worst {
                let Found { sign, file, finding, .. } = &self.findings[*n];
                text.push_str(&format!("  {sign} ({file}): {finding}\n"));
            }
        }
        text
    }
}
