//! Opaque names and an order, so that neither tells what a stimulus is.

use super::{Set, Sheet, Stimulus};
use crate::evaluation::statistics::bootstrap::below;
use crate::format::questionnaire::{Questionnaire, Task};
use rand_chacha::ChaCha8Rng;
use rand_chacha::rand_core::{Rng, SeedableRng};
use std::collections::BTreeSet;

/// A questionnaire with opaque names.
#[derive(Debug, Clone, PartialEq)]
pub struct Blind {
    /// The questionnaire, in a random order.
    pub page: Questionnaire,
    /// The opaque name of each stimulus, in the order of the sheet.
    pub names: Vec<String>,
}

/// Names the stimuli of a sheet and puts them in order. The same seed gives the same names and order, another seed others.
///
/// ```
/// use chereme::evaluation::stimuli::{Set, blind};
/// let sheet = Set::Placement.sheet();
/// let one = blind(Set::Placement, &sheet, 1);
/// assert_eq!(one, blind(Set::Placement, &sheet, 1));
/// assert_ne!(one.names, blind(Set::Placement, &sheet, 2).names);
/// ```
pub fn blind(set: Set, sheet: &Sheet, seed: u64) -> Blind {
    let mut random = ChaCha8Rng::seed_from_u64(seed);
    // Two questionnaires of one seed share no names: their answers may be analysed together.
    random.set_stream(set as u64);
    let mut used = BTreeSet::new();
    let mut name = || loop {
        let name = format!("{:06x}", random.next_u32() >> 8);
        if used.insert(name.clone()) {
            return name;
        }
    };
    let names: Vec<String> = sheet.stimuli.iter().map(|_| name()).collect();
    let id = format!("{set}-{}", name());
    let mut order: Vec<usize> = (0..names.len()).collect();
    // Fisher and Yates.
    for last in (1..order.len()).rev() {
        order.swap(last, below(&mut random, last + 1));
    }
    let task = |&i: &usize| Task { stimulus: names[i].clone(), question: sheet.stimuli[i].question };
    let page = Questionnaire {
        id,
        title: sheet.title.clone(),
        introduction: sheet.introduction.clone(),
        questions: sheet.questions.clone(),
        tasks: order.iter().map(task).collect(),
    };
    Blind { page, names }
}

/// The table that says what the opaque names are, as `evaluate ratings --key` reads it.
///
/// ```
/// use chereme::diagnostics::Source;
/// use chereme::evaluation::{ratings::read_key, stimuli::{Set, blind, key}};
/// let sheet = Set::Configuration.sheet();
/// let table = key(&sheet.stimuli, &blind(Set::Configuration, &sheet, 1).names);
/// assert_eq!(read_key(&Source::new("key.csv", table)).unwrap().len(), 15);
/// ```
pub fn key(stimuli: &[Stimulus], names: &[String]) -> String {
    let mut writer = csv::WriterBuilder::new().from_writer(Vec::new());
    let mut whole = writer.write_record(["stimulus", "group", "item", "version", "correct", "line"]).is_ok();
    for (stimulus, name) in stimuli.iter().zip(names) {
        let correct = stimulus.correct.as_deref().unwrap_or("");
        let row = [name, stimulus.group, &stimulus.item, stimulus.version.name(), correct, &stimulus.line];
        whole &= writer.write_record(row).is_ok();
    }
    // Rows of one length into memory cannot fail.
    debug_assert!(whole, "a row was not written");
    String::from_utf8(writer.into_inner().unwrap_or_default()).unwrap_or_default()
}
