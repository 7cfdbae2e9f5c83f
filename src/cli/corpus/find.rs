//! `chereme corpus find`

use super::super::parallel::Loudness;
use super::super::{Failure, terminal};
use super::motion::motion_of;
use super::open::{failed, open, signer};
use super::{Named, Opening};
use crate::corpus::example::features::{Options as Features, Reference, features_of};
use crate::corpus::example::{Motion, search};
use crate::corpus::library::{Library, vocabulary_of};
use crate::corpus::query::{Asked, Hit, Options, parse};
use crate::corpus::segment::{Component, Segment};
use crate::diagnostics::Source;
use crate::phonology::Side;
use crate::time::Seconds;
use serde::Serialize;
use std::path::{Path, PathBuf};

#[derive(Debug, clap::Args)]
#[command(
    after_help = "A query is conditions, all of which hold:\n  gloss=hello            exactly, whatever the case; =a|b is either\n  configuration~5        near, the nearest first; ~5:0.3 is no farther than 0.3\n  placement=chest        says at least this: `chest left, close` too\n  configuration=O>K      one after the other\n  configuration=?        not known; !=? known\n  duration<1.2s  start>3s  hand=right  signer=anna  recording=take-1  fingers=up  palm=out  movement=circle\n\nWhat is not known of a segment is not false: such hits come last, and say so; --strict leaves them out.\n\nExamples:\n  chereme corpus find 'gloss=hello hand=right configuration~5 duration<1.2s' takes\n  chereme corpus find --like clip.bvh:1.2-2.0 takes     what moves like this stretch of a file\n  chereme corpus find --like eight_3 takes              like a recording of the corpus"
)]
pub(super) struct Find {
    /// What is asked (not with --like), and the corpus: a folder with a corpus.yaml, or such a file; this folder where it is left out
    #[arg(value_name = "QUERY [CORPUS]", num_args = 0..=2)]
    what: Vec<String>,
    /// An example instead of a query: a BVH file or a recording of the corpus, perhaps with a stretch of it in seconds
    #[arg(long, value_name = "EXAMPLE[:FROM-TO]")]
    like: Option<String>,
    /// The most hits
    #[arg(long, value_name = "N", default_value_t = 20)]
    limit: usize,
    /// Only what is known to meet all conditions
    #[arg(long)]
    strict: bool,
    /// For programs
    #[arg(long)]
    json: bool,
    #[command(flatten)]
    opening: Opening,
}

/// A hit.
#[derive(Debug, Serialize)]
struct Row {
    recording: String,
    gloss: Option<String>,
    hand: Option<&'static str>,
    start: f64,
    end: f64,
    distance: Option<f64>,
    sure: bool,
    values: Vec<String>,
    reasons: Vec<String>,
}

impl Find {
    pub(super) fn run(&self) -> Result<(), Failure> {
        let wrong = |what: &str| Failure::Usage(format!("{what}: see `chereme corpus find --help`"));
        let (query, corpus) = match (&self.like, &self.what[..]) {
            (Some(_), []) => (None, None),
            (Some(_), [corpus]) => (None, Some(corpus)),
            (Some(_), _) => return Err(wrong("a query and an example at once")),
            (None, []) => return Err(wrong("what is to be found?")),
            (None, [query]) => (Some(query), None),
            (None, [query, corpus, ..]) => (Some(query), Some(corpus)),
        };
        let named = Named { path: corpus.map_or_else(|| PathBuf::from("."), PathBuf::from) };
        let (library, _) = open(&named, &self.opening, Loudness::Told)?;
        let rows = match (&self.like, query) {
            (Some(example), _) => self.like(&library, example)?,
            (None, query) => self.asked(&library, query.map_or("", String::as_str))?,
        };
        if self.json {
            terminal::out(&serde_json::to_string_pretty(&rows).map(|text| text + "\n").unwrap_or_default());
        } else if rows.is_empty() {
            terminal::err("nothing is found\n");
        } else {
            terminal::out(&rows.iter().map(line).collect::<String>());
        }
        Ok(())
    }

    fn asked(&self, library: &Library, query: &str) -> Result<Vec<Row>, Failure> {
        let vocabulary = vocabulary_of(library.listing(), &signer()?).map_err(failed)?;
        let source = Source::new("query", query);
        let parsed = parse(&source, &vocabulary).map_err(|faults| {
            terminal::tell(&faults, &source);
            Failure::Faults(Some("the query cannot be used".into()))
        })?;
        terminal::tell(&parsed.warnings, &source);
        let index = library.index(&vocabulary);
        let hits = index.find(&parsed.query, &Options { limit: self.limit, strict: self.strict });
        let near = parsed.query.conditions.iter().any(|c| matches!(c.asked, Asked::Near { .. }));
        let row = |hit: &Hit| {
            let segment = index.segment(hit.segment)?;
            let distance = near.then_some(hit.distance);
            Some(row(&segment, library, distance, hit.sure, index.reasons(&parsed.query, hit)))
        };
        Ok(hits.iter().filter_map(row).collect())
    }

    /// The stretches of recordings that move like the example, with both hands where it has both.
    fn like(&self, library: &Library, example: &str) -> Result<Vec<Row>, Failure> {
        let (what, span) = stretch(example);
        let signer = signer()?;
        let (clip, covers) = match library.find(&what) {
            Some(at) => (library.clip(at).map_err(failed)?, library.coverage(at)),
            None if Path::new(&what).is_file() => {
                let motion = motion_of(&PathBuf::from(&what), &signer)?;
                (motion.clip, motion.covers)
            }
            None => return Err(Failure::Usage(format!("`{what}` is neither a recording of the corpus nor a file"))),
        };
        let sides: Vec<Side> =
            [Side::Right, Side::Left].into_iter().filter(|side| covers.hands[*side as usize]).collect();
        if sides.is_empty() {
            return Err(Failure::Faults(Some(format!("{what} has no hands to compare"))));
        }
        // Places are comparable where both have bodies.
        let reference = if covers.body { Reference::Body } else { Reference::Space };
        let features = Features { reference, ..Features::default() };
        let example = features_of(&clip, &sides, &features).map_err(failed)?;
        let frame = |seconds: f64| (seconds * features.fps.get()).round().max(0.0) as usize;
        let [from, to] = span.unwrap_or([0.0, f64::from(u32::MAX)]);
        let none = || Failure::Usage(format!("{what} lasts {}: nothing lies in that stretch", clip.duration()));
        let example = example.part(frame(from), frame(to).saturating_add(1)).ok_or_else(none)?;
        let mut numbers = Vec::new();
        let mut motions: Vec<Motion> = Vec::new();
        for at in (0..library.len()).filter(|at| sides.iter().all(|s| library.coverage(*at).hands[*s as usize])) {
            motions.push(features_of(&library.clip(at).map_err(failed)?, &sides, &features).map_err(failed)?);
            numbers.push(at);
        }
        let found = search(&example, &motions, self.limit).map_err(failed)?;
        Ok(found.iter().map(|found| stretch_row(library, numbers[found.recording], found)).collect())
    }
}

/// `clip.bvh:1.2-2.0`: a file and a stretch of it, seconds.
fn stretch(text: &str) -> (String, Option<[f64; 2]>) {
    let parsed = text.rsplit_once(':').and_then(|(what, span)| {
        let (from, to) = span.split_once('-')?;
        let [from, to] = [from, to].map(|t| t.trim().trim_end_matches('s').parse::<f64>().ok());
        Some((what.to_owned(), [from?, to?]))
    });
    match parsed {
        Some((what, span)) => (what, Some(span)),
        None => (text.to_owned(), None),
    }
}

fn stretch_row(library: &Library, at: usize, found: &crate::corpus::example::Found) -> Row {
    let overlaps = |start: Seconds, end: Seconds| end.0.min(found.end.0) - start.0.max(found.start.0);
    let glosses = library.tiers(at).iter().filter(|tier| tier.name.ends_with("Gloss")).flat_map(|tier| tier.values());
    let gloss = glosses.max_by(|a, b| overlaps(a.start, a.end).total_cmp(&overlaps(b.start, b.end)));
    Row {
        recording: library.take(at).name.clone(),
        gloss: gloss.map(|v| v.label.clone()),
        hand: None,
        start: found.start.0,
        end: found.end.0,
        distance: Some(found.distance),
        sure: true,
        values: Vec::new(),
        reasons: Vec::new(),
    }
}

fn row(segment: &Segment, library: &Library, distance: Option<f64>, sure: bool, reasons: Vec<String>) -> Row {
    let said = |component: &Component| {
        let labels: Vec<&str> = segment.of(*component).iter().map(|v| v.label.as_str()).collect();
        (!labels.is_empty()).then(|| labels.join(" > "))
    };
    Row {
        recording: library.take(segment.recording).name.clone(),
        gloss: segment.gloss.clone(),
        hand: segment.side.map(|side| if side == Side::Right { "right" } else { "left" }),
        start: segment.start.0,
        end: segment.end.0,
        distance,
        sure,
        values: Component::ALL.iter().filter_map(said).collect(),
        reasons,
    }
}

/// A hit for people.
fn line(row: &Row) -> String {
    let mut text = format!("{}  {:.2}-{:.2} s", row.recording, row.start, row.end);
    text.extend(row.hand.map(|hand| format!("  {hand}")));
    text.extend(row.gloss.as_ref().map(|gloss| format!("  {gloss}")));
    text.extend(row.distance.map(|distance| format!("  distance {distance:.3}")));
    if !row.values.is_empty() {
        text.push_str(&format!("\n    {}", row.values.join("; ")));
    }
    if !row.reasons.is_empty() {
        text.push_str(&format!("\n    {}", row.reasons.join("; ")));
    }
    text + "\n"
}
