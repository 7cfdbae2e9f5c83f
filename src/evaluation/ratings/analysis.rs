//! What the ratings say: recognition and realism per stimulus and version, and which versions differ.

use super::{Answer, Levels};
use crate::evaluation::statistics::describe::{Summary, summary};
use crate::evaluation::statistics::{KruskalWallis, MannWhitney, Rate, holm, kruskal_wallis, mann_whitney, wilson};
use std::collections::{BTreeMap, BTreeSet};
use std::fmt;

/// The paper's threshold (its note 5).
pub const THRESHOLD: f64 = 0.01;

/// What is compared.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
pub enum Measure {
    /// The 5-point ratings.
    Realism,
    /// Whether the answer was right: 1 or 0.
    Recognition,
}

impl fmt::Display for Measure {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Measure::Realism => "realism",
            Measure::Recognition => "recognition",
        })
    }
}

/// All that is said of a questionnaire.
#[derive(Debug, Clone, PartialEq)]
pub struct Analysis {
    /// How many people are counted.
    pub participants: usize,
    /// How many are left out by their level.
    pub left_out: usize,
    /// By name.
    pub groups: Vec<Group>,
}

/// The stimuli of one question.
#[derive(Debug, Clone, PartialEq)]
pub struct Group {
    /// Its name.
    pub name: String,
    /// What was measured of each item in each version, then of each version over all items.
    pub cells: Vec<Cell>,
    /// Versions against one another: over all items, then within items of several versions.
    pub comparisons: Vec<Comparison>,
}

/// The answers about one item in one version.
#[derive(Debug, Clone, PartialEq)]
pub struct Cell {
    /// What is signed; `None` for all items of the version together.
    pub item: Option<String>,
    /// How it was made.
    pub version: String,
    /// The ratings; `None` where none was given.
    pub realism: Option<Summary>,
    /// How often it was recognised, of how many answers; `None` where nothing was to be recognised.
    pub recognition: Option<(usize, usize, Rate)>,
}

/// Versions against one another.
#[derive(Debug, Clone, PartialEq)]
pub struct Comparison {
    /// What is compared.
    pub measure: Measure,
    /// The item; `None` for all of them.
    pub item: Option<String>,
    /// Whether any version differs; `None` where all values are equal.
    pub all: Option<KruskalWallis>,
    /// Each two versions.
    pub pairs: Vec<Pair>,
}

/// Two versions against one another.
#[derive(Debug, Clone, PartialEq)]
pub struct Pair {
    /// A version.
    pub first: String,
    /// Another.
    pub second: String,
    /// The test.
    pub test: MannWhitney,
    /// Its p, corrected by Holm for the pairs of this comparison.
    pub p_holm: f64,
}

/// The values of a version, of one item or of all.
type Values<'a> = BTreeMap<(Option<&'a str>, &'a str), Vec<f64>>;

/// Analyses answers; people whose level is not among `levels` (or is not known) are left out, everybody counts without it.
///
/// ```
/// use chereme::evaluation::ratings::{Answer, Stimulus, analyse};
/// let shown = |version: &str| Stimulus { group: "g".into(), item: "BOL".into(), version: version.into(), correct: None };
/// let rate = |person: &str, version, realism| Answer { participant: person.into(), level: None, shown: shown(version), answer: None, realism: Some(realism) };
/// let answers = [rate("P1", "linear", 2), rate("P1", "sigmoid", 4), rate("P2", "linear", 3), rate("P2", "sigmoid", 5)];
/// let analysis = analyse(&answers, None);
/// assert_eq!(analysis.participants, 2);
/// assert_eq!(analysis.groups[0].comparisons[0].pairs[0].test.rank_biserial, -1.0);
/// ```
pub fn analyse(answers: &[Answer], levels: Option<&Levels>) -> Analysis {
    let counted = |a: &&Answer| levels.is_none_or(|levels| a.level.is_some_and(|level| levels.has(level)));
    let everybody: BTreeSet<&str> = answers.iter().map(|a| a.participant.as_str()).collect();
    let kept: Vec<&Answer> = answers.iter().filter(counted).collect();
    let participants = kept.iter().map(|a| a.participant.as_str()).collect::<BTreeSet<_>>().len();
    let names: BTreeSet<&str> = kept.iter().map(|a| a.shown.group.as_str()).collect();
    let of_group = |name: &&str| kept.iter().copied().filter(|a| a.shown.group == **name).collect::<Vec<_>>();
    let groups = names.iter().map(|name| group(name, &of_group(name))).collect();
    Analysis { participants, left_out: everybody.len() - participants, groups }
}

fn group(name: &str, answers: &[&Answer]) -> Group {
    let realism = values(answers, |a| a.realism.map(f64::from));
    let right = values(answers, |a| a.recognised().map(|right| if right { 1.0 } else { 0.0 }));
    // Items first, all items of a version after them.
    let mut names: Vec<_> = realism.keys().chain(right.keys()).copied().collect::<BTreeSet<_>>().into_iter().collect();
    names.sort_by_key(|(item, version)| (item.is_none(), *item, *version));
    let cell = |&(item, version): &(Option<&str>, &str)| Cell {
        item: item.map(str::to_owned),
        version: version.to_owned(),
        realism: realism.get(&(item, version)).and_then(|values| summary(values)),
        recognition: right.get(&(item, version)).and_then(|values| {
            let hits = values.iter().filter(|v| **v > 0.5).count();
            wilson(hits, values.len()).map(|rate| (hits, values.len(), rate))
        }),
    };
    let mut comparisons = comparisons(Measure::Realism, &realism);
    comparisons.extend(self::comparisons(Measure::Recognition, &right));
    Group { name: name.to_owned(), cells: names.iter().map(cell).collect(), comparisons }
}

/// One measure of answers, by item and version, and by version alone.
fn values<'a>(answers: &[&'a Answer], measure: impl Fn(&Answer) -> Option<f64>) -> Values<'a> {
    let mut values = Values::new();
    for answer in answers {
        let Some(value) = measure(answer) else { continue };
        let version = answer.shown.version.as_str();
        values.entry((Some(answer.shown.item.as_str()), version)).or_default().push(value);
        values.entry((None, version)).or_default().push(value);
    }
    values
}

fn comparisons(measure: Measure, values: &Values) -> Vec<Comparison> {
    let items: BTreeSet<Option<&str>> = values.keys().map(|(item, _)| *item).collect();
    // Where there is one item, it is the same as all of them.
    let lone = items.len() <= 2;
    let of = |item: &Option<&str>| comparison(measure, *item, values);
    items.iter().filter(|item| item.is_none() || !lone).filter_map(of).collect()
}

fn comparison(measure: Measure, item: Option<&str>, values: &Values) -> Option<Comparison> {
    let versions: Vec<(&str, &[f64])> =
        values.iter().filter(|((i, _), _)| *i == item).map(|((_, version), v)| (*version, v.as_slice())).collect();
    if versions.len() < 2 {
        return None;
    }
    let all = kruskal_wallis(&versions.iter().map(|(_, v)| *v).collect::<Vec<_>>());
    let mut pairs = Vec::new();
    for (i, (first, a)) in versions.iter().enumerate() {
        for (second, b) in &versions[i + 1..] {
            let test = mann_whitney(a, b)?;
            pairs.push(Pair { first: (*first).to_owned(), second: (*second).to_owned(), test, p_holm: test.p });
        }
    }
    let corrected = holm(&pairs.iter().map(|pair| pair.test.p).collect::<Vec<_>>());
    pairs.iter_mut().zip(corrected).for_each(|(pair, p)| pair.p_holm = p);
    Some(Comparison { measure, item: item.map(str::to_owned), all, pairs })
}
