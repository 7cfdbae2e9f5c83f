//! `chereme render`: signs to motion, as pages or files.

mod captured;
mod each;
mod input;
mod output;
mod rig;

use super::corpus::open::open;
use super::corpus::{Named, Opening};
use super::parallel::Loudness;
use super::{Failure, Sources, terminal, world};
use crate::avatar;
use crate::body::signer::Signer;
use crate::corpus::library::Library;
use crate::diagnostics::Error;
use crate::motion::easing::Easing;
use crate::synthesis::Options;
use crate::time::Fps;
use input::Request;
use output::{Format, Outputs};
use rig::Theirs;
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Examples:\n  chereme render lexicon/lsf/bol.sign -o bol.html      a page: the avatar signs, open it in a browser\n  chereme render BOL -o bol.html -o bol.glb -o bol.eaf  several outputs at once\n  chereme render lexicon/lsf -o pages/                  one page a sign, into a folder\n  chereme render lexicon --each -o 'out/{language}/{stem}.bvh' --jobs 4\n                                                        one file a sign, on four cores\n  chereme render lexicon/lsf/alphabet.sign --sign A,B -o letters/ --format html,glb\n  chereme render \"BONJOUR, CHIEN BOL@left fs(LSF)\" -o line.html     a gloss line, as one motion\n  chereme render \"HELLO@left take(father_3)[inverted]\" --corpus takes -o line.html\n                                                        captured signs, edited as motion\n  chereme render BOL --rig theirs.bvh -o bol.bvh        for somebody else's rig\n  chereme render BOL --speed 0.5 --easing minimum-jerk -o slow.html"
)]
pub(super) struct Render {
    /// Files or folders of signs (.sign, SiGML, HamNoSys), names of signs, gloss lines, strings of HamNoSys, or - for standard input
    #[arg(value_name = "FILE|NAME|LINE", required = true)]
    what: Vec<String>,
    /// Where to: a file (.html, .glb, .bvh, .eaf, .csv, .svg), a folder (ending in /) for one file a sign, a name with {stem} or the
    /// like for --each, or - for standard output; repeatable
    #[arg(short, long, value_name = "OUT", required = true)]
    output: Vec<String>,
    /// One file a sign, on all cores: in -o, {stem} is the name of its file, {name} its gloss, {language}, {folder} where its file is
    /// below the folder asked for, {number} its number in its file. What cannot be signed is told and left out
    #[arg(long)]
    each: bool,
    /// How many cores --each works on; all without it
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    jobs: Option<u16>,
    /// Formats written into folders and to standard output
    #[arg(long, value_name = "FORMAT", value_delimiter = ',', default_value = "html")]
    format: Vec<Format>,
    /// Only these signs of the files
    #[arg(long, value_name = "NAME", value_delimiter = ',')]
    sign: Vec<String>,
    /// The language of signs given by name and of gloss lines, where several have one of that name
    #[arg(long, value_name = "NAME")]
    language: Option<String>,
    /// The signer's strong hand is the left one; places in space stay where they are
    #[arg(long)]
    left_handed: bool,
    /// Frames a second
    #[arg(long, value_name = "N", default_value_t = Fps::DEFAULT.get())]
    fps: f64,
    /// How fast: 2 is twice as fast
    #[arg(long, value_name = "FACTOR", default_value_t = 1.0)]
    speed: f64,
    /// How joints ease between poses: sigmoid, sigmoid:K, cosine, linear, minimum-jerk, paper-cosine, paper-sigmoid
    #[arg(long, value_name = "NAME", default_value = "sigmoid")]
    easing: Easing,
    /// The paper's own procedure: the wrist is placed, it has no limits, the shoulder does not help
    #[arg(long)]
    paper: bool,
    /// How much performances differ from their descriptions and from each other: 0 not at all, 1 visibly, up to 3
    #[arg(long, value_name = "AMOUNT", default_value_t = 0.0)]
    variation: f64,
    /// Which of the possible performances, with --variation
    #[arg(long, value_name = "N", default_value_t = 0)]
    seed: u64,
    /// Take signs from this corpus of captured motion (a folder with a corpus.yaml); `take(NAME)` in a gloss line is exactly that take
    #[arg(long, value_name = "DIR")]
    corpus: Option<PathBuf>,
    /// What is taken where the corpus and the lexicon both have a sign, or a hand configuration
    #[arg(long, value_name = "SOURCE", default_value = "corpus")]
    prefer: Prefer,
    /// Where the corpus's cache is, instead of .chereme beside its corpus.yaml
    #[arg(long, value_name = "DIR")]
    corpus_cache: Option<PathBuf>,
    /// Write .bvh or .glb files for this rig instead of the avatar: a BVH file, or a GLB file with a skin; its joints are found
    /// by their names
    #[arg(long, value_name = "FILE")]
    rig: Option<PathBuf>,
    /// Overwrite files that are there
    #[arg(long)]
    force: bool,
    /// Say nothing but faults
    #[arg(short, long)]
    quiet: bool,
}

/// What is taken where captured motion and a description are both there.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
pub(super) enum Prefer {
    /// Captured motion
    Corpus,
    /// The description
    Procedure,
}

impl Render {
    pub(super) fn run(&self, sources: &Sources) -> Result<(), Failure> {
        let options = self.options()?;
        let grammar = world::grammar(sources)?;
        let words = world::words(&grammar);
        let failed = |e: Error| Failure::Faults(Some(e.to_string()));
        let mut signer = avatar::signer().map_err(failed)?;
        let rig = self.rig(&signer)?;
        let library = self.library()?;
        if self.each || self.output.iter().any(|o| o.contains('{')) {
            let captured = captured::Stock::of(library.as_ref(), self.prefer, &mut signer)?;
            return each::run(self, sources, &grammar, &words, &options, (rig.as_ref(), &captured, &signer));
        }
        let outputs = Outputs::of(self, &words.vocabulary, rig.as_ref())?;
        let captured = captured::Stock::of(library.as_ref(), self.prefer, &mut signer)?;
        let Request { asked, mut faulty, .. } = input::request(self, sources, &grammar, &words, &captured.glosses)?;
        if asked.is_empty() && !faulty {
            return Err(Failure::Faults(Some("there is no sign to render".into())));
        }
        outputs.check(&asked)?;
        for asked in &asked {
            // What one sign cannot do does not keep the others from being written.
            let performance = match captured.perform(&asked.plan, &grammar, &signer, &options) {
                Ok(performance) => performance,
                Err(error) => {
                    terminal::err(&format!("chereme: {error}\n"));
                    faulty = true;
                    continue;
                }
            };
            for warning in &performance.report.warnings {
                terminal::err(&format!("warning: {}: {warning}\n", asked.name));
            }
            let whole = performance.track.clip.duration();
            let sign = performance.report.sign_end - performance.report.stroke_start;
            for path in outputs.write(asked, &performance.track)? {
                if !self.quiet {
                    terminal::err(&format!("{}: {} ({whole}, the sign {sign})\n", asked.name, path.display()));
                }
            }
        }
        if faulty { Err(Failure::Faults(None)) } else { Ok(()) }
    }

    /// The corpus that signs are taken from.
    fn library(&self) -> Result<Option<Library>, Failure> {
        let Some(path) = &self.corpus else { return Ok(None) };
        let loudness = if self.quiet { Loudness::Quiet } else { Loudness::Told };
        let opening = Opening { cache: self.corpus_cache.clone(), jobs: self.jobs };
        let (library, tally) = open(&Named { path: path.clone() }, &opening, loudness)?;
        if tally.failed > 0 {
            let left = terminal::count(tally.failed, "recording");
            terminal::err(&format!("{left} of the corpus left out: `chereme corpus check` tells why\n"));
        }
        Ok(Some(library))
    }

    /// The rig that motion is written for, where it is not the avatar's.
    fn rig(&self, signer: &Signer) -> Result<Option<Theirs>, Failure> {
        let Some(path) = &self.rig else { return Ok(None) };
        let rig = Theirs::read(path, signer.clone(), self.quiet)?;
        let ends = format!(".{}", rig.extension());
        let formats = self.format.iter().any(|format| format.extension() == rig.extension());
        if !formats && !self.output.iter().any(|output| output.to_lowercase().ends_with(&ends)) {
            return Err(Failure::Usage(format!(
                "--rig {}: write a {ends} file with it (-o NAME{ends})",
                path.display()
            )));
        }
        Ok(Some(rig))
    }

    /// The knobs of synthesis that the options state.
    fn options(&self) -> Result<Options, Failure> {
        let fps = Fps::new(self.fps).ok_or_else(|| {
            Failure::Usage(format!("--fps {}: frames a second lie above 0 and up to {}", self.fps, Fps::MAX))
        })?;
        Ok(Options {
            fps,
            easing: self.easing,
            speed: self.speed,
            paper: self.paper,
            variation: self.variation,
            seed: self.seed,
        })
    }
}
