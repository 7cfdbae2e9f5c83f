//! Queries answered by reading every segment: slow, obvious, and what the index must agree with.

use chereme::corpus::index::About;
use chereme::corpus::label::{Label, Truth, Vocabulary};
use chereme::corpus::query::{Asked, Condition, Field, HandName, Options, Pattern, Query};
use chereme::corpus::segment::{Component, Segment};
use chereme::phonology::Side;
use chereme::phonology::grammar::fold;

/// The hits of a query among segments in the index's order: number, whether sure, distance.
pub fn scan(
    query: &Query,
    recordings: &[About],
    segments: &[Segment],
    vocabulary: &Vocabulary,
    options: &Options,
) -> Vec<(usize, bool, f64)> {
    let mut found = Vec::new();
    for (number, segment) in segments.iter().enumerate() {
        let judged: Vec<(Truth, Option<f64>)> =
            query.conditions.iter().map(|c| judge(c, recordings.get(segment.recording), segment, vocabulary)).collect();
        let truth = judged.iter().map(|(truth, _)| *truth).min().unwrap_or(Truth::Yes);
        let distance = judged.iter().fold(0.0, |sum, (_, distance)| sum + distance.unwrap_or(0.0));
        if truth == Truth::Yes || (truth == Truth::Unknown && !options.strict) {
            found.push((number, truth == Truth::Yes, distance));
        }
    }
    found.sort_by(|a, b| b.1.cmp(&a.1).then(a.2.total_cmp(&b.2)).then(a.0.cmp(&b.0)));
    found.truncate(options.limit);
    found
}

fn judge(
    condition: &Condition,
    about: Option<&About>,
    segment: &Segment,
    vocabulary: &Vocabulary,
) -> (Truth, Option<f64>) {
    let name = match condition.field {
        Field::Gloss => segment.gloss.clone(),
        Field::Recording => about.map(|a| a.name.clone()),
        Field::Signer => about.and_then(|a| a.signer.clone()),
        _ => None,
    };
    let labels: Vec<Label> = condition.field.component().map_or(Vec::new(), |component| {
        segment.of(component).iter().map(|value| vocabulary.read(component, &value.label)).collect()
    });
    let mut distance = None;
    let truth = match &condition.asked {
        Asked::Missing => Truth::of(missing(condition.field, &name, &labels, segment)),
        Asked::Names(names) => name.map_or(Truth::Unknown, |n| Truth::of(names.contains(&fold(&n)))),
        Asked::Hands(hands) => {
            let dominant = about.and_then(|a| a.dominant);
            hands.iter().map(|hand| of_hand(*hand, segment.side, dominant)).max().unwrap()
        }
        Asked::Values(patterns) => patterns.iter().map(|pattern| in_row(&labels, pattern)).max().unwrap(),
        Asked::Near { patterns, bound } => {
            distance = patterns.iter().filter_map(|p| mean_distance(&labels, p)).min_by(f64::total_cmp);
            let comparable = |label: &Label| {
                patterns.iter().flat_map(|p| &p.parts).all(|part| label.features.distance(&part.features).is_some())
            };
            match distance {
                Some(d) if bound.is_none_or(|bound| d <= bound) => Truth::Yes,
                _ if labels.is_empty() || !labels.iter().all(comparable) => Truth::Unknown,
                _ => Truth::No,
            }
        }
        Asked::Times(order, times) => {
            let time = if condition.field == Field::Start { segment.start.0 } else { segment.duration().0 };
            Truth::of(times.iter().any(|asked| order.holds(time, *asked)))
        }
    };
    (if condition.negated { !truth } else { truth }, distance)
}

fn missing(field: Field, name: &Option<String>, labels: &[Label], segment: &Segment) -> bool {
    let says = |word: &str| labels.iter().any(|l| l.terms.iter().any(|t| t.starts_with(word)));
    match field {
        Field::Gloss | Field::Recording | Field::Signer => name.is_none(),
        Field::Hand => segment.side.is_none(),
        Field::Value(
            Component::Configuration | Component::Placement | Component::Orientation | Component::Movement,
        ) => labels.is_empty(),
        Field::Fingers => !says("fingers "),
        Field::Palm => !says("palm "),
        Field::Duration | Field::Start => false,
    }
}

fn of_hand(hand: HandName, side: Option<Side>, dominant: Option<Side>) -> Truth {
    let Some(side) = side else { return Truth::Unknown };
    match (hand, dominant) {
        (HandName::Side(wanted), _) => Truth::of(side == wanted),
        (HandName::Strong, Some(dominant)) => Truth::of(side == dominant),
        (HandName::Weak, Some(dominant)) => Truth::of(side != dominant),
        (HandName::Strong | HandName::Weak, None) => Truth::Unknown,
    }
}

/// All ways to choose as many labels as a pattern has parts, in order.
fn choices(labels: usize, parts: usize) -> Vec<Vec<usize>> {
    if parts == 0 {
        return vec![Vec::new()];
    }
    let mut all = Vec::new();
    for last in 0..labels {
        for mut choice in choices(last, parts - 1) {
            choice.push(last);
            all.push(choice);
        }
    }
    all
}

fn in_row(labels: &[Label], pattern: &Pattern) -> Truth {
    if labels.is_empty() {
        return Truth::Unknown;
    }
    let truth = |choice: &Vec<usize>| {
        choice.iter().zip(&pattern.parts).map(|(i, part)| labels[*i].matches(part)).min().unwrap()
    };
    choices(labels.len(), pattern.parts.len()).iter().map(truth).max().unwrap_or(Truth::No)
}

fn mean_distance(labels: &[Label], pattern: &Pattern) -> Option<f64> {
    let mean = |choice: &Vec<usize>| {
        let each = choice.iter().zip(&pattern.parts).map(|(i, part)| labels[*i].features.distance(&part.features));
        each.sum::<Option<f64>>().map(|sum| sum / pattern.parts.len() as f64)
    };
    choices(labels.len(), pattern.parts.len()).iter().filter_map(mean).min_by(f64::total_cmp)
}
