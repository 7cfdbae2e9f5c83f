//! `chereme render`: signs to motion, as pages or files.

use super::{Failure, Sources, files, terminal, world};
use crate::diagnostics::{Error, Severity};
use crate::format::{glb, html};
use crate::motion::easing::Easing;
use crate::notation::lexicon::language_of_path;
use crate::notation::{Vocabulary, read};
use crate::phonology::Sign;
use crate::synthesis::{Grammar, Options, Performance, synthesize};
use crate::time::Fps;
use crate::{avatar, body::signer::Signer};
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Examples:\n  chereme render lexicon/lsf/bol.sign -o bol.html      a page: the avatar signs, open it in a browser\n  chereme render BOL -o bol.html -o bol.glb             several outputs at once\n  chereme render lexicon/lsf -o pages/                  one page a sign, into a folder\n  chereme render lexicon/lsf/alphabet.sign --sign A,B -o letters/ --format html,glb\n  chereme render BOL --speed 0.5 --easing minimum-jerk -o slow.html"
)]
pub(super) struct Render {
    /// Files or folders of signs, names of signs, or - for standard input
    #[arg(value_name = "FILE|NAME", required = true)]
    what: Vec<String>,
    /// Where to: a file (.html or .glb), a folder (ending in /) for one file a sign, or - for standard output; repeatable
    #[arg(short, long, value_name = "OUT", required = true)]
    output: Vec<String>,
    /// Formats written into folders and to standard output
    #[arg(long, value_name = "FORMAT", value_delimiter = ',', default_value = "html")]
    format: Vec<Format>,
    /// Only these signs of the files
    #[arg(long, value_name = "NAME", value_delimiter = ',')]
    sign: Vec<String>,
    /// The language of signs given by name, where several have one of that name
    #[arg(long, value_name = "NAME")]
    language: Option<String>,
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
    /// Overwrite files that are there
    #[arg(long)]
    force: bool,
    /// Say nothing but faults
    #[arg(short, long)]
    quiet: bool,
}

/// What a rendered sign is written as.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Format {
    /// A page with the avatar, to be opened in a browser
    Html,
    /// Binary glTF 2.0: the avatar with its animation
    Glb,
}

impl Format {
    fn extension(self) -> &'static str {
        match self {
            Format::Html => "html",
            Format::Glb => "glb",
        }
    }
}

/// Where one sign goes.
#[derive(Debug)]
enum Target {
    File(PathBuf, Format),
    Folder(PathBuf),
    StandardOutput,
}

impl Render {
    pub(super) fn run(&self, sources: &Sources) -> Result<(), Failure> {
        let fps = Fps::new(self.fps).ok_or_else(|| {
            Failure::Usage(format!("--fps {}: frames a second lie above 0 and up to {}", self.fps, Fps::MAX))
        })?;
        let options = Options { fps, easing: self.easing, speed: self.speed, paper: self.paper, ..Options::default() };
        let targets = self.output.iter().map(|o| target(o)).collect::<Result<Vec<_>, _>>()?;
        let grammar = world::grammar(sources)?;
        let vocabulary = Vocabulary::of(&grammar.handshapes, &grammar.locations, &grammar.expressions);
        let (signs, mut faulty) = self.signs(sources, &vocabulary)?;
        let single = targets.iter().any(|t| !matches!(t, Target::Folder(_)));
        if single && signs.len() > 1 {
            let names: Vec<&str> = signs.iter().take(8).map(|s| s.name.as_str()).collect();
            return Err(Failure::Usage(format!(
                "{} signs do not go into one file: choose with --sign (there are {}{}), or write into a folder with -o out/",
                signs.len(),
                names.join(", "),
                if signs.len() > 8 { ", ..." } else { "" }
            )));
        }
        if signs.is_empty() && !faulty {
            return Err(Failure::Faults(Some("there is no sign to render".into())));
        }
        let mut job = Job { signer: None, grammar: &grammar, options, command: self, taken: BTreeSet::new() };
        // What cannot be written is said before the work.
        for sign in &signs {
            let all: Vec<_> = targets.iter().flat_map(|t| job.files(t, sign)).collect();
            for (path, _) in all {
                job.free(&path)?;
            }
        }
        for sign in &signs {
            if let Err(failure) = job.render(sign, &targets) {
                match failure {
                    Failure::Faults(message) => {
                        terminal::err(&format!("chereme: {}\n", message.unwrap_or_default()));
                        faulty = true;
                    }
                    usage => return Err(usage),
                }
            }
        }
        if faulty { Err(Failure::Faults(None)) } else { Ok(()) }
    }

    /// The signs asked for, and whether some text had faults.
    fn signs(&self, sources: &Sources, vocabulary: &Vocabulary) -> Result<(Vec<Sign>, bool), Failure> {
        let mut signs = Vec::new();
        let mut faulty = false;
        let mut lexicon = None;
        for what in &self.what {
            let path = Path::new(what);
            if what != "-" && !what.ends_with(".sign") && !path.exists() {
                let known = match &lexicon {
                    Some(known) => known,
                    None => lexicon.insert(world::lexicon(sources, vocabulary)?),
                };
                let entry = known.find(what, self.language.as_deref());
                signs.push(entry.map_err(|e| Failure::Faults(Some(e.to_string())))?.sign.clone());
                continue;
            }
            for text in files::read_all(&[path.to_owned()])? {
                let mut reading = read(&text.source.text, vocabulary, language_of_path(&text.source.name));
                reading.diagnostics.extend(text.fault);
                terminal::tell(&reading.diagnostics, &text.source);
                faulty |= reading.diagnostics.iter().any(|d| d.severity == Severity::Fault);
                signs.extend(reading.signs.into_iter().map(|s| s.sign));
            }
        }
        if !self.sign.is_empty() {
            let wanted: Vec<String> = self.sign.iter().map(|n| crate::phonology::grammar::fold(n)).collect();
            let folded = |s: &Sign| crate::phonology::grammar::fold(&s.name);
            if let Some(missing) = wanted.iter().position(|w| !signs.iter().any(|s| folded(s) == *w)) {
                return Err(Failure::Faults(Some(format!("there is no sign {} in what was read", self.sign[missing]))));
            }
            signs.retain(|s| wanted.contains(&folded(s)));
        }
        Ok((signs, faulty))
    }
}

/// Reads an `-o`.
fn target(output: &str) -> Result<Target, Failure> {
    let path = PathBuf::from(output);
    if output == "-" {
        return Ok(Target::StandardOutput);
    }
    if output.ends_with('/') || output.ends_with(std::path::MAIN_SEPARATOR) || path.is_dir() {
        return Ok(Target::Folder(path));
    }
    let extension = path.extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default();
    match extension.as_str() {
        "html" | "htm" => Ok(Target::File(path, Format::Html)),
        "glb" => Ok(Target::File(path, Format::Glb)),
        "" => Err(Failure::Usage(format!("-o {output}: end it in .html or .glb, or in / for a folder"))),
        other => Err(Failure::Usage(format!("-o {output}: .{other} cannot be written yet; .html and .glb can"))),
    }
}

struct Job<'a> {
    signer: Option<Signer>,
    grammar: &'a Grammar,
    options: Options,
    command: &'a Render,
    /// Files of this run, so that two signs of one name do not overwrite each other.
    taken: BTreeSet<PathBuf>,
}

impl Job<'_> {
    /// The files that a sign goes to.
    fn files(&self, target: &Target, sign: &Sign) -> Vec<(PathBuf, Format)> {
        match target {
            Target::File(path, format) => vec![(path.clone(), *format)],
            Target::Folder(folder) => {
                let name: String = sign.name.chars().map(|c| if "/\\:*?\"<>|".contains(c) { '_' } else { c }).collect();
                let file = |format: &Format| (folder.join(format!("{name}.{}", format.extension())), *format);
                self.command.format.iter().map(file).collect()
            }
            Target::StandardOutput => Vec::new(),
        }
    }

    /// Refuses a file that is there, or that this run has written for another sign.
    fn free(&mut self, path: &Path) -> Result<(), Failure> {
        if !self.taken.insert(path.to_owned()) {
            return Err(Failure::Usage(format!("two signs would both be written to {}", path.display())));
        }
        if path.exists() && !self.command.force {
            return Err(Failure::Usage(format!("{} is there already; --force overwrites it", path.display())));
        }
        Ok(())
    }

    fn render(&mut self, sign: &Sign, targets: &[Target]) -> Result<(), Failure> {
        let failed = |e: Error| Failure::Faults(Some(e.to_string()));
        if self.signer.is_none() {
            self.signer = Some(avatar::signer().map_err(failed)?);
        }
        let Some(signer) = &self.signer else { return Ok(()) };
        let performance = synthesize(sign, self.grammar, signer, &self.options).map_err(failed)?;
        for warning in &performance.report.warnings {
            terminal::err(&format!("warning: {}: {warning}\n", sign.name));
        }
        for target in targets {
            if let Target::StandardOutput = target {
                for format in &self.command.format {
                    terminal::out_bytes(&bytes(*format, sign, &performance).map_err(failed)?);
                }
            }
            for (path, format) in self.files(target, sign) {
                if let Some(folder) = path.parent().filter(|f| !f.as_os_str().is_empty()) {
                    let made = std::fs::create_dir_all(folder);
                    made.map_err(|e| Failure::Faults(Some(format!("{}: {e}", folder.display()))))?;
                }
                files::write_whole(&path, &bytes(format, sign, &performance).map_err(failed)?)?;
                if !self.command.quiet {
                    let (clip, report) = (&performance.track.clip, &performance.report);
                    let whole = clip.duration();
                    let stroke = report.sign_end - report.stroke_start;
                    terminal::err(&format!("{}: {} ({whole}, the sign {stroke})\n", sign.name, path.display()));
                }
            }
        }
        Ok(())
    }
}

fn bytes(format: Format, sign: &Sign, performance: &Performance) -> Result<Vec<u8>, Error> {
    match format {
        Format::Html => html::write(avatar::GLB, &performance.track, &page(sign)).map(String::into_bytes),
        Format::Glb => glb::write(avatar::GLB, &performance.track),
    }
}

/// What the page says of the sign beside its motion.
fn page(sign: &Sign) -> html::Page {
    let mut facts: Vec<(String, String)> = Vec::new();
    if !sign.meaning.is_empty() {
        let meanings: Vec<String> =
            sign.meaning.iter().map(|(language, words)| format!("{words} ({language})")).collect();
        facts.push(("meaning".into(), meanings.join(", ")));
    }
    facts.extend(sign.source.iter().map(|s| ("source".into(), s.clone())));
    let status = sign.status.clone().unwrap_or_else(|| "unverified".into());
    facts.push(("status".into(), status));
    facts.extend(sign.note.iter().map(|n| ("note".into(), n.clone())));
    html::Page { title: sign.name.clone(), language: sign.language.clone(), facts }
}
