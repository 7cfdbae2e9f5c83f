//! `chereme convert`: signs from any notation to any other.

mod output;

use super::parallel::{self, Loudness, Progress};
use super::signs::{Finder, Found};
use super::template::Replacing;
use super::{Failure, Sources, files, terminal, world};
use crate::notation::formats::{Form, Notation, Refused, Words, Written, write_any};
use crate::phonology::Sign;
use output::{Group, Target};
use std::collections::BTreeMap;
use std::time::Instant;

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Examples:\n  chereme convert ngt -o 'out/{stem}.ham' --manual         HamNoSys of the hands, from SiGML with faces\n  chereme convert bol.sign -o bol.sigml\n  chereme convert haus.sigml -o haus.sign\n  chereme convert corpus -o 'out/{folder}/{stem}.sign'    a file for each file, on all cores\n  chereme convert all.sigml -o 'out/{name}.sign'          a file for each sign\n  chereme convert BOL CHIEN --as names                    two signs of the lexicon, to standard output\n  chereme convert lexicon/lsf -o lsf.sigml --as hns       a folder into one file\n  chereme convert - --from sigml --as sign < haus.sigml\n\nForms: sign (.sign), sigml (gestural SiGML), hns (SiGML, symbol by symbol), hamnosys (symbols), names (their names).\nExit codes: 0 fine (warnings included), 1 a sign cannot be read or cannot be said in the form, 2 wrong usage."
)]
pub(super) struct Convert {
    /// Files or folders of signs in any notation, names of signs, strings of HamNoSys, or - for standard input
    #[arg(value_name = "FILE|NAME", required = true)]
    what: Vec<String>,
    /// Where to: a file, a name with {stem}, {name}, {language}, {folder} or {number} (as in render --each), or - for standard output
    #[arg(short, long, value_name = "OUT", default_value = "-")]
    output: String,
    /// The form to write [default: by the extension of -o]
    #[arg(long = "as", value_name = "FORM")]
    form: Option<Spelling>,
    /// The notation of files and of standard input [default: by extension, else by content]
    #[arg(long, value_name = "NOTATION")]
    from: Option<Original>,
    /// Write the hands alone: leave out what face, head and body do, for which HamNoSys has no symbols
    #[arg(long)]
    manual: bool,
    /// The language of signs given by name, where several have one of that name
    #[arg(long, value_name = "NAME")]
    language: Option<String>,
    /// How many cores to work on; all without it
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..))]
    jobs: Option<u16>,
    /// Overwrite files that are there
    #[arg(long)]
    force: bool,
    /// Say nothing but faults
    #[arg(short, long)]
    quiet: bool,
}

/// A form, as a word.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Spelling {
    /// .sign text
    Sign,
    /// Gestural SiGML
    Sigml,
    /// H-SiGML: HamNoSys symbols as XML
    Hns,
    /// HamNoSys symbols
    Hamnosys,
    /// Names of HamNoSys symbols
    Names,
}

impl Spelling {
    fn form(self) -> Form {
        match self {
            Spelling::Sign => Form::Sign,
            Spelling::Sigml => Form::SiGml,
            Spelling::Hns => Form::HSiGml,
            Spelling::Hamnosys => Form::HamNoSys,
            Spelling::Names => Form::Names,
        }
    }
}

/// A notation, as a word.
#[derive(Debug, Clone, Copy, PartialEq, Eq, clap::ValueEnum)]
enum Original {
    /// .sign text
    Sign,
    /// SiGML, gestural or symbol by symbol
    Sigml,
    /// HamNoSys symbols or their names
    Hamnosys,
    /// A table with a column of HamNoSys
    Table,
}

impl Original {
    fn notation(self) -> Notation {
        match self {
            Original::Sign => Notation::Sign,
            Original::Sigml => Notation::SiGml,
            Original::Hamnosys => Notation::HamNoSys,
            Original::Table => Notation::Table,
        }
    }
}

impl Convert {
    pub(super) fn run(&self, sources: &Sources) -> Result<(), Failure> {
        let began = Instant::now();
        let target = Target::of(&self.output)?;
        let form = self.form()?;
        let words = world::words(&world::grammar(sources)?);
        let mut finder = Finder::new(sources, &words, self.language.as_deref());
        finder.notation = self.from.map(Original::notation);
        let mut found: Vec<Found> = Vec::new();
        for what in &self.what {
            found.extend(finder.find(what)?);
        }
        if self.manual {
            found.iter_mut().for_each(|found| found.sign.nonmanual.clear());
        }
        if found.is_empty() && !finder.faulty {
            return Err(Failure::Faults(Some("there is no sign to convert".into())));
        }
        let (refused, faulty) = (finder.refused, finder.faulty);
        let replacing = if self.force { Replacing::Forced } else { Replacing::Refused };
        let groups = target.groups(found, replacing)?;
        let loudness = if self.quiet { Loudness::Quiet } else { Loudness::Told };
        let (converted, files, unsaid) = self.write(groups, form, &words, loudness)?;
        let refused = (refused + unsaid).max(usize::from(faulty));
        if loudness == Loudness::Told && self.output != "-" || refused > 0 {
            let (signs, files) = (terminal::count(converted, "sign"), terminal::count(files, "file"));
            let seconds = began.elapsed().as_secs_f64();
            terminal::err(&format!("{signs} converted into {files}, {refused} refused, {seconds:.1} s\n"));
        }
        if refused > 0 { Err(Failure::Faults(None)) } else { Ok(()) }
    }

    /// The form that the options ask for.
    fn form(&self) -> Result<Form, Failure> {
        match (self.form, Form::of_extension(&self.output)) {
            (Some(spelling), _) => Ok(spelling.form()),
            (None, Some(form)) => Ok(form),
            (None, None) => Err(Failure::Usage(format!(
                "-o {}: --as says the form: {}",
                self.output,
                Form::ALL.map(Form::name).join(", ")
            ))),
        }
    }

    /// Writes every group; how many signs went into how many files, and how many the form cannot say.
    fn write(
        &self,
        groups: Vec<Group>,
        form: Form,
        words: &Words,
        loudness: Loudness,
    ) -> Result<(usize, usize, usize), Failure> {
        let pool = parallel::pool(self.jobs)?;
        let progress = Progress::new(groups.iter().map(|group| group.signs.len()).sum(), loudness);
        let (mut converted, mut files, mut unsaid, mut failed) = (0, 0, 0, None);
        let work = |group: Group| {
            let signs: Vec<&Sign> = group.signs.iter().collect();
            let written = write_any(&signs, form, words);
            let done = put(&group, &written);
            signs.iter().for_each(|_| progress.step());
            (group, written, done)
        };
        let mut reasons = Reasons::default();
        parallel::in_order(&pool, groups, work, |(group, written, done)| {
            for one in &written.refused {
                reasons.tell("chereme", &group.signs[one.sign].name, one, &progress);
            }
            for one in written.nearly.iter().filter(|_| loudness == Loudness::Told) {
                reasons.tell("warning", &group.signs[one.sign].name, one, &progress);
            }
            unsaid += written.refused.len();
            match done {
                Ok(()) => {
                    converted += group.signs.len() - written.refused.len();
                    files += usize::from(!written.text.is_empty());
                }
                Err(failure) => failed = failed.take().or(Some(failure)),
            }
        });
        reasons.finish(&progress);
        drop(progress);
        match failed {
            Some(failure) => Err(failure),
            None => Ok((converted, files, unsaid)),
        }
    }
}

/// What was told of how many signs, so that the same is not told of hundreds.
#[derive(Default)]
struct Reasons(BTreeMap<String, usize>);

impl Reasons {
    /// Of so many signs a reason is told.
    const TOLD: usize = 8;

    fn tell(&mut self, what: &str, name: &str, one: &Refused, progress: &Progress) {
        let reason = one.reasons.join("; ");
        let line = format!("{what}: {name}: {reason}\n");
        let count = self.0.entry(reason).or_default();
        *count += 1;
        if *count <= Self::TOLD {
            progress.say(&line);
        }
    }

    fn finish(&self, progress: &Progress) {
        for (reason, count) in self.0.iter().filter(|(_, count)| **count > Self::TOLD) {
            progress.say(&format!("and {} more: {reason}\n", count - Self::TOLD));
        }
        if self.0.keys().any(|reason| reason.contains("non-manual")) {
            progress.say("help: --manual writes the hands alone\n");
        }
    }
}

/// Puts a text where it belongs; where no sign of it could be said, nothing is written.
fn put(group: &Group, written: &Written) -> Result<(), Failure> {
    match &group.path {
        _ if written.text.is_empty() => Ok(()),
        None => {
            terminal::out(&written.text);
            Ok(())
        }
        Some(path) => {
            files::make_folder_of(path)?;
            files::write_whole(path, written.text.as_bytes())
        }
    }
}
