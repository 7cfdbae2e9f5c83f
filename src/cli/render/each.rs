//! `render --each`: one file a sign, on all cores. What one sign cannot do does not keep the others from being written.
//!
//! Every file's name is known, and whether it may be written, before the first sign is signed. A core signs a sign, writes it and
//! forgets it; what there is to say comes in the order of the signs.

use super::super::parallel::{self, Loudness, Progress};
use super::super::template::{self, Replacing, Template};
use super::super::{Failure, Sources, files, terminal};
use super::Render;
use super::captured::Stock;
use super::input::{self, Asked, Request};
use super::output::Format;
use super::rig::Theirs;
use crate::body::signer::Signer;
use crate::notation::formats::Words;
use crate::synthesis::{Grammar, Options};
use std::collections::BTreeSet;
use std::panic::{AssertUnwindSafe, catch_unwind};
use std::path::{MAIN_SEPARATOR, Path, PathBuf};
use std::time::Instant;

/// What signs are signed with.
struct Stage<'a> {
    grammar: &'a Grammar,
    words: &'a Words,
    signer: &'a Signer,
    options: &'a Options,
    rig: Option<&'a Theirs>,
    captured: &'a Stock<'a>,
}

/// A sign and its files.
struct Job {
    asked: Asked,
    files: Vec<(PathBuf, Format)>,
}

/// What became of a sign.
enum Outcome {
    /// Its files are there; warnings of its motion.
    Written(Vec<String>),
    /// Why they are not.
    Refused(String),
}

/// Renders each sign that a command line names into files of its own.
pub(super) fn run(
    command: &Render,
    sources: &Sources,
    grammar: &Grammar,
    words: &Words,
    options: &Options,
    (rig, captured, signer): (Option<&Theirs>, &Stock, &Signer),
) -> Result<(), Failure> {
    let began = Instant::now();
    let targets = targets(command)?;
    let Request { asked, faulty, refused } = input::request(command, sources, grammar, words, &captured.glosses)?;
    if asked.is_empty() && !faulty {
        return Err(Failure::Faults(Some("there is no sign to render".into())));
    }
    let jobs = jobs(command, &targets, asked)?;
    let pool = parallel::pool(command.jobs)?;
    let stage = Stage { grammar, words, signer, options, rig, captured };
    let loudness = if command.quiet { Loudness::Quiet } else { Loudness::Told };
    let progress = Progress::new(jobs.len(), loudness);
    let (mut rendered, mut failed) = (0, refused);
    let work = |job: Job| {
        let outcome = stage.write(&job);
        progress.step();
        (job.asked.name, outcome)
    };
    parallel::in_order(&pool, jobs, work, |(name, outcome)| match outcome {
        Outcome::Written(warnings) => {
            rendered += 1;
            if loudness == Loudness::Told {
                warnings.iter().for_each(|warning| progress.say(&format!("warning: {name}: {warning}\n")));
            }
        }
        Outcome::Refused(why) => {
            failed += 1;
            // Most reasons name the sign already.
            let whose = if why.starts_with(&name) { String::new() } else { format!("{name}: ") };
            progress.say(&format!("chereme: {whose}{why}\n"));
        }
    });
    drop(progress);
    let failed = failed.max(usize::from(faulty));
    if loudness == Loudness::Told || failed > 0 {
        let seconds = began.elapsed().as_secs_f64();
        let rate = rendered as f64 / seconds.max(1e-9);
        let signs = terminal::count(rendered, "sign");
        terminal::err(&format!("{signs} rendered, {failed} refused, {seconds:.1} s, {rate:.1} signs/s\n"));
    }
    if failed > 0 { Err(Failure::Faults(None)) } else { Ok(()) }
}

/// The names of files that the options ask for, with their formats; a folder takes a file a sign in each `--format`.
fn targets(command: &Render) -> Result<Vec<(Template, Format)>, Failure> {
    let mut all = Vec::new();
    for output in &command.output {
        if output == "-" {
            return Err(Failure::Usage("--each writes files, not to standard output".into()));
        }
        if output.ends_with('/') || output.ends_with(MAIN_SEPARATOR) || Path::new(output).is_dir() {
            let formats: BTreeSet<Format> = command.format.iter().copied().collect();
            for format in formats {
                let folder = output.trim_end_matches(['/', MAIN_SEPARATOR]);
                all.push((Template::of(&format!("{folder}/{{name}}.{}", format.extension()))?, format));
            }
            continue;
        }
        all.push((Template::of(output)?, Format::of_path(Path::new(output))?));
    }
    Ok(all)
}

/// Each sign with its files, none of which is written twice or there already.
fn jobs(command: &Render, targets: &[(Template, Format)], asked: Vec<Asked>) -> Result<Vec<Job>, Failure> {
    if asked.len() > 1 && targets.iter().any(|(template, _)| !template.has_fields()) {
        let what = format!("{} signs go into files of their own: write {{name}} or {{stem}} in -o", asked.len());
        return Err(Failure::Usage(format!("{what}, such as -o 'out/{{name}}.bvh'")));
    }
    let files = |asked: &Asked| targets.iter().map(|(t, format)| (t.path(&asked.origin), *format)).collect();
    let jobs: Vec<Job> = asked.into_iter().map(|asked| Job { files: files(&asked), asked }).collect();
    let replacing = if command.force { Replacing::Forced } else { Replacing::Refused };
    template::check(jobs.iter().flat_map(|j| j.files.iter().map(|(path, _)| (&j.asked.origin, path))), replacing)?;
    Ok(jobs)
}

impl Stage<'_> {
    /// Signs a sign and writes its files.
    fn write(&self, job: &Job) -> Outcome {
        // A fault of the program in one sign of thousands must not cost the others.
        match catch_unwind(AssertUnwindSafe(|| self.try_write(job))) {
            Ok(Ok(warnings)) => Outcome::Written(warnings),
            Ok(Err(why)) => Outcome::Refused(why),
            Err(_) => Outcome::Refused("the program failed at this sign; please report it".into()),
        }
    }

    fn try_write(&self, job: &Job) -> Result<Vec<String>, String> {
        let performance = self.captured.perform(&job.asked.plan, self.grammar, self.signer, self.options);
        let performance = performance.map_err(|e| e.to_string())?;
        for (path, format) in &job.files {
            let bytes = format.bytes(&job.asked, &performance.track, &self.words.vocabulary, self.rig);
            let bytes = bytes.map_err(|e| e.to_string())?;
            let written = files::make_folder_of(path).and_then(|()| files::write_whole(path, &bytes));
            written.map_err(|failure| match failure {
                Failure::Faults(why) => why.unwrap_or_default(),
                Failure::Usage(why) => why,
            })?;
        }
        Ok(performance.report.warnings)
    }
}
