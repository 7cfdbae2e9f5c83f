//! `chereme corpus list`

use super::super::parallel::Loudness;
use super::super::{Failure, terminal};
use super::open::open;
use super::{Named, Opening};
use crate::body::retarget::Coverage;
use crate::corpus::library::Library;
use serde::Serialize;

#[derive(Debug, clap::Args)]
#[command(after_help = "Examples:\n  chereme corpus list takes\n  chereme corpus list takes --json | jq '.[].gloss'")]
pub(super) struct List {
    #[command(flatten)]
    named: Named,
    #[command(flatten)]
    opening: Opening,
    /// For programs
    #[arg(long)]
    json: bool,
}

/// A recording.
#[derive(Debug, Serialize)]
struct Row<'l> {
    name: &'l str,
    gloss: Option<&'l str>,
    seconds: f64,
    frames_per_second: f64,
    joints: u32,
    covers: Vec<&'static str>,
    /// How far the motion on our rig is off the file's, at most: bones, degrees; fingertips and wrists, millimetres.
    off_degrees: f64,
    off_tips_mm: f64,
    off_wrists_mm: f64,
    tiers: Vec<&'l str>,
    signer: Option<&'l str>,
    licence: Option<&'l str>,
    credit: Option<&'l str>,
}

impl List {
    pub(super) fn run(&self) -> Result<(), Failure> {
        let (library, tally) = open(&self.named, &self.opening, Loudness::Told)?;
        let rows: Vec<Row> = (0..library.len()).map(|at| row(&library, at)).collect();
        if self.json {
            terminal::out(&serde_json::to_string_pretty(&rows).map(|text| text + "\n").unwrap_or_default());
        } else {
            terminal::out(&table(&rows));
        }
        if tally.failed > 0 {
            let left = terminal::count(tally.failed, "recording");
            terminal::err(&format!("{left} with faults left out: `chereme corpus check` tells them\n"));
        }
        Ok(())
    }
}

fn row(library: &Library, at: usize) -> Row<'_> {
    let (take, entry) = (library.take(at), library.entry(at));
    Row {
        name: &take.name,
        gloss: take.gloss.as_deref(),
        seconds: (entry.duration().0 * 1e3).round() / 1e3,
        frames_per_second: (entry.fps.get() * 1e3).round() / 1e3,
        joints: entry.joints,
        covers: covers(entry.covers),
        off_degrees: (entry.off.direction.to_degrees() * 1e3).round() / 1e3,
        off_tips_mm: (entry.off.tip_m * 1e4).round() / 10.0,
        off_wrists_mm: (entry.off.wrist_m * 1e4).round() / 10.0,
        tiers: entry.tiers.iter().map(|tier| tier.name.as_str()).collect(),
        signer: take.signer.as_deref(),
        licence: take.licence.as_deref(),
        credit: take.credit.as_deref(),
    }
}

/// What of the body a recording moves, in words.
fn covers(coverage: Coverage) -> Vec<&'static str> {
    let Coverage { body, arms, hands } = coverage;
    let parts = [
        (body, "body"),
        (arms[0], "left arm"),
        (arms[1], "right arm"),
        (hands[0], "left hand"),
        (hands[1], "right hand"),
    ];
    parts.iter().filter(|(moves, _)| *moves).map(|(_, part)| *part).collect()
}

/// How far the motion is off, where it is: bones look elsewhere, tips and wrists stand elsewhere.
fn off(row: &Row) -> String {
    let parts = [(row.off_degrees, "°"), (row.off_tips_mm, " mm tips"), (row.off_wrists_mm, " mm wrists")];
    let told = parts.iter().filter(|(value, _)| *value >= 0.1).map(|(value, unit)| format!("{value:.1}{unit}"));
    told.collect::<Vec<_>>().join(", ")
}

fn table(rows: &[Row<'_>]) -> String {
    let headings = ["name", "gloss", "seconds", "fps", "joints", "off", "covers", "licence"].map(str::to_owned);
    let cells = |row: &Row| {
        [
            row.name.to_owned(),
            row.gloss.unwrap_or_default().to_owned(),
            format!("{:.2}", row.seconds),
            format!("{:.2}", row.frames_per_second),
            row.joints.to_string(),
            off(row),
            row.covers.join(", "),
            row.licence.unwrap_or_default().to_owned(),
        ]
    };
    let rows: Vec<[String; 8]> = [headings].into_iter().chain(rows.iter().map(cells)).collect();
    let widths: Vec<usize> =
        (0..8).map(|column| rows.iter().map(|row| row[column].chars().count()).max().unwrap_or(0)).collect();
    let line = |row: &[String; 8]| {
        let cells: Vec<String> = row.iter().zip(&widths).map(|(cell, width)| format!("{cell:width$}")).collect();
        cells.join("  ").trim_end().to_owned() + "\n"
    };
    rows.iter().map(line).collect()
}
