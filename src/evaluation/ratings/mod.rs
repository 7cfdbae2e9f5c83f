//! What people say of synthesized signing: the answers of questionnaires, and their analysis (Naert et al. 2021, §7).
//!
//! The tables are read ([`read_answers`], [`read_key`]), joined ([`join`]) and analysed ([`analyse`]); [`mod@print`] makes a
//! table of the result, [`chart`] a figure like the paper's 15 to 17.
//!
//! # Departs from the paper
//! - The paper says that no significant difference was found, and then that things are equal. A test that finds nothing
//!   does not say so: results here are "differs" or "no significant difference", with p beside it.
//! - Pairs are corrected for being many (Holm), within each comparison.

mod analysis;
mod level;
mod table;

pub mod chart;
pub mod print;

pub use analysis::{Analysis, Cell, Comparison, Group, Measure, Pair, THRESHOLD, analyse};
pub use level::{Level, Levels};
pub use table::{Given, Stimulus, read_answers, read_key};

use crate::diagnostics::Diagnostic;
use std::collections::{BTreeMap, BTreeSet};

/// One answer, with what was shown.
#[derive(Debug, Clone, PartialEq)]
pub struct Answer {
    /// Who.
    pub participant: String,
    /// How well they sign.
    pub level: Option<Level>,
    /// What they saw.
    pub shown: Stimulus,
    /// What they recognised.
    pub answer: Option<String>,
    /// From 1 to 5.
    pub realism: Option<u8>,
}

impl Answer {
    /// Whether it was recognised; `None` where nothing was to be recognised, or nothing was answered.
    pub fn recognised(&self) -> Option<bool> {
        let (correct, answer) = (self.shown.correct.as_ref()?, self.answer.as_ref()?);
        Some(correct.to_lowercase() == answer.to_lowercase())
    }
}

/// Answers with what was shown, by the key or by what the table itself says; of two answers of one person to one stimulus the
/// first counts. Returns the answers, and what there is to say: warnings of what was answered twice.
///
/// # Errors
/// A stimulus that neither the key nor the table explains.
///
/// ```
/// use chereme::diagnostics::Source;
/// use chereme::evaluation::ratings::{join, read_answers, read_key};
/// let given = read_answers(&Source::new("a", "participant,stimulus,answer\nP1,7f,left\n")).unwrap();
/// let key = read_key(&Source::new("k", "stimulus,group,item,version,correct\n7f,bowls,BOL,linear,left\n")).unwrap();
/// let (answers, warnings) = join(given, &key, &mut Default::default()).unwrap();
/// assert!(answers[0].recognised() == Some(true) && warnings.is_empty());
/// ```
pub fn join(
    given: Vec<Given>,
    key: &BTreeMap<String, Stimulus>,
    seen: &mut BTreeSet<(String, String)>,
) -> Result<(Vec<Answer>, Vec<Diagnostic>), Vec<Diagnostic>> {
    let (mut answers, mut warnings, mut faults) = (Vec::new(), Vec::new(), Vec::new());
    for given in given {
        let Some(shown) = key.get(&given.stimulus).cloned().or(given.shown) else {
            let what = format!("nothing says what the stimulus `{}` is", given.stimulus);
            faults.push(Diagnostic::fault(given.span, what).hint(
                "give the key that was written with the questionnaire (--key key.csv), or add the columns group, item, version and correct",
            ));
            continue;
        };
        if !seen.insert((given.participant.clone(), given.stimulus.clone())) {
            let what =
                format!("{} answered about `{}` twice; the first answer counts", given.participant, given.stimulus);
            warnings.push(Diagnostic::warning(given.span, what));
            continue;
        }
        let Given { participant, level, answer, realism, .. } = given;
        answers.push(Answer { participant, level, shown, answer, realism });
    }
    if faults.is_empty() { Ok((answers, warnings)) } else { Err(faults) }
}
