//! `chereme evaluate ratings`: the answers of questionnaires.

use super::super::{Failure, terminal};
use super::output::{Output, expand, text, told};
use crate::evaluation::ratings::{self, Answer, Levels, chart, join, print, read_answers, read_key};
use crate::format::svg;
use std::collections::{BTreeMap, BTreeSet};
use std::path::PathBuf;

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Examples:\n  chereme evaluate ratings answers/*.csv --key key.csv               a table\n  chereme evaluate ratings answers/ --key key.csv --level good+ -o ratings.csv -o ratings.svg\n  cat answers.csv | chereme evaluate ratings - --level native,interpreter\n\nAnswers: CSV with the columns participant, stimulus, and level, answer, realism (1 to 5) as they were asked for. The key, as `evaluate stimuli`\nwrites it: stimulus, group, item, version, correct; these columns may stand in the answers instead. Versions are compared within a group:\nKruskal–Wallis, then Mann–Whitney for each two, corrected by Holm. \"No significant difference\" is not equality.\nExit codes: 0 fine, 1 faults in a table, 2 wrong usage."
)]
pub(super) struct Ratings {
    /// Tables of answers (.csv), folders of them, or - for standard input
    #[arg(value_name = "FILE", required = true)]
    answers: Vec<PathBuf>,
    /// What each stimulus is (.csv), as `evaluate stimuli --key` writes it; repeatable
    #[arg(short, long, value_name = "FILE")]
    key: Vec<PathBuf>,
    /// Only people of these levels: good+ (good and above, as the paper counts), or a list: none, beginner, quite-good, good, very-good,
    /// native, interpreter
    #[arg(long, value_name = "LEVELS")]
    level: Option<Levels>,
    /// Below this p a difference is significant
    #[arg(long, value_name = "P", default_value_t = ratings::THRESHOLD)]
    threshold: f64,
    #[command(flatten)]
    output: Output,
}

impl Ratings {
    pub(super) fn run(&self) -> Result<(), Failure> {
        if !(self.threshold > 0.0 && self.threshold < 1.0) {
            return Err(Failure::Usage(format!("--threshold {}: it lies between 0 and 1", self.threshold)));
        }
        self.output.check()?;
        let answers = self.answers()?;
        if answers.is_empty() {
            return Err(Failure::Faults(Some("there is no answer in what was read".into())));
        }
        let analysis = ratings::analyse(&answers, self.level.as_ref());
        if analysis.participants == 0 {
            return Err(Failure::Faults(Some(format!(
                "no participant is left: of {} none has one of the levels {}",
                analysis.left_out,
                self.level.as_ref().map_or(String::new(), Levels::to_string)
            ))));
        }
        let title = match &self.level {
            Some(levels) => format!("Ratings (level: {levels})"),
            None => "Ratings".into(),
        };
        let figure = || svg::chart::write(&chart::chart(&analysis, &title));
        self.output.write(&print::text(&analysis, self.threshold), || print::csv(&analysis), figure)
    }

    /// All answers, with what was shown; faults are told.
    fn answers(&self) -> Result<Vec<Answer>, Failure> {
        let mut key = BTreeMap::new();
        for path in &self.key {
            let source = text(path)?;
            for (name, stimulus) in read_key(&source).map_err(|faults| told(&faults, &source))? {
                if key.get(&name).is_some_and(|known| *known != stimulus) {
                    let what = format!("{}: another key says otherwise of `{name}`", source.name);
                    return Err(Failure::Faults(Some(what)));
                }
                key.insert(name, stimulus);
            }
        }
        let mut answers = Vec::new();
        let mut seen = BTreeSet::new();
        for path in expand(&self.answers, &["csv"])? {
            let source = text(&path)?;
            let given = read_answers(&source).map_err(|faults| told(&faults, &source))?;
            let (joined, warnings) = join(given, &key, &mut seen).map_err(|faults| told(&faults, &source))?;
            if !self.output.quiet {
                terminal::tell(&warnings, &source);
            }
            answers.extend(joined);
        }
        Ok(answers)
    }
}
