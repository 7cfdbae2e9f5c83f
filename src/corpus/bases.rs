//! Derivative bases: signs that share placement and movement and differ in configuration (Naert et al. 2021, §5.1: ESCARGOT and
//! LIMACE), from which one is made of the other by exchanging the hand's shape.
//!
//! A sign is what all hands do under one gloss at one time. Values that are not known join nothing: a sign that lacks a placement, a
//! movement or a configuration of a hand that acts is left out.

use super::label::{Features, Label, Vocabulary};
use super::segment::{Component, Segment};
use crate::phonology::Side;
use crate::phonology::grammar::fold;
use std::collections::BTreeMap;

/// How alike signs of one base must be.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct Options {
    /// The orientation must be shared too.
    pub orientation: bool,
    /// The greatest distance of placements and of movements (and orientations) of one base; `None`: what is said must be the same.
    pub tolerance: Option<f64>,
}

/// One way to make a sign of a base.
#[derive(Debug, Clone, PartialEq)]
pub struct Member {
    /// The gloss as it first stands.
    pub gloss: String,
    /// The configurations of the hands, as they first stand: `right U`.
    pub configuration: String,
    /// The segments, as numbers in the list that was given, sorted.
    pub segments: Vec<usize>,
}

/// Signs that share everything but the configuration.
#[derive(Debug, Clone, PartialEq)]
pub struct Base {
    /// What they share, of each hand: `right placement forehead`, `right movement up`.
    pub shared: Vec<String>,
    /// The signs, by gloss, then configuration; of at least two glosses and two configurations.
    pub members: Vec<Member>,
}

/// What a sign is compared by.
struct Sign {
    gloss: String,
    segments: Vec<usize>,
    /// For each hand, in order: its side and the components that are shared, each a row of labels.
    shared: Vec<(Option<Side>, Vec<Vec<Label>>)>,
    /// For each hand the labels of its configurations.
    configuration: Vec<Vec<Label>>,
}

/// The bases among segments, those with the most signs first, then by what they share.
///
/// With a tolerance a sign joins the first base whose first sign is near enough, in the order of the segments: bases are no
/// chains of ever more distant signs.
///
/// ```
/// use chereme::corpus::bases::{Options, bases};
/// use chereme::corpus::{label::Vocabulary, segment::{Segment, Value}};
/// use chereme::motion::skeleton::Skeleton;
/// use chereme::time::Seconds;
/// let rig = Skeleton::from_json(chereme::avatar::SKELETON).unwrap();
/// let vocabulary = Vocabulary::builtin(&rig, None).unwrap();
/// let sign = |gloss: &str, shape: &str, start| {
///     let value = |label: &str| vec![Value { label: label.into(), start: Seconds(start), end: Seconds(start + 1.0) }];
///     let values = [value(shape), value("forehead"), value("fingers up"), value("up")];
///     Segment { gloss: Some(gloss.into()), start: Seconds(start), end: Seconds(start + 1.0), values, ..Segment::default() }
/// };
/// let found = bases(&[sign("ESCARGOT", "V", 0.0), sign("LIMACE", "U", 1.0)], &vocabulary, &Options::default());
/// assert_eq!(found[0].members.iter().map(|m| m.gloss.as_str()).collect::<Vec<_>>(), ["ESCARGOT", "LIMACE"]);
/// ```
pub fn bases(segments: &[Segment], vocabulary: &Vocabulary, options: &Options) -> Vec<Base> {
    let mut groups: Vec<Vec<Sign>> = Vec::new();
    let mut exact: BTreeMap<Vec<String>, usize> = BTreeMap::new();
    for sign in signs(segments, vocabulary, options) {
        let same = match options.tolerance {
            None => exact.get(&key(&sign)).copied(),
            Some(tolerance) => groups.iter().position(|group| is_near(&group[0], &sign, tolerance)),
        };
        match same {
            Some(group) => groups[group].push(sign),
            None => {
                exact.insert(key(&sign), groups.len());
                groups.push(vec![sign]);
            }
        }
    }
    let mut found: Vec<Base> = groups.iter().filter_map(|group| base(group, options)).collect();
    found.sort_by(|a, b| b.members.len().cmp(&a.members.len()).then_with(|| a.shared.cmp(&b.shared)));
    found
}

/// The signs whose shared values and configurations are known.
fn signs(segments: &[Segment], vocabulary: &Vocabulary, options: &Options) -> Vec<Sign> {
    // Hands that act under one gloss at one time are one sign.
    let mut order: Vec<usize> = (0..segments.len()).filter(|i| segments[*i].gloss.is_some()).collect();
    let name = |i: usize| fold(segments[i].gloss.as_deref().unwrap_or_default());
    order.sort_by(|a, b| {
        let (s, t) = (&segments[*a], &segments[*b]);
        s.recording.cmp(&t.recording).then(s.start.0.total_cmp(&t.start.0)).then(side(s).cmp(&side(t))).then(a.cmp(b))
    });
    let mut together: Vec<Vec<usize>> = Vec::new();
    // Of each recording the last sign of each gloss, to which another hand may belong.
    let mut last: BTreeMap<(usize, String), usize> = BTreeMap::new();
    for i in order {
        let place = (segments[i].recording, name(i));
        let belongs = |hands: &Vec<usize>| {
            let overlaps = |j: &usize| segments[*j].start < segments[i].end && segments[i].start < segments[*j].end;
            hands.iter().all(|j| segments[*j].side != segments[i].side) && hands.iter().any(overlaps)
        };
        match last.get(&place).copied().filter(|n| belongs(&together[*n])) {
            Some(n) => together[n].push(i),
            None => {
                last.insert(place, together.len());
                together.push(vec![i]);
            }
        }
    }
    together.into_iter().filter_map(|hands| sign(hands, segments, vocabulary, options)).collect()
}

fn side(segment: &Segment) -> u8 {
    match segment.side {
        None => 0,
        Some(Side::Right) => 1,
        Some(Side::Left) => 2,
    }
}

fn sign(mut hands: Vec<usize>, segments: &[Segment], vocabulary: &Vocabulary, options: &Options) -> Option<Sign> {
    hands.sort_by_key(|i| (side(&segments[*i]), *i));
    let mut components = vec![Component::Placement, Component::Movement];
    if options.orientation {
        components.push(Component::Orientation);
    }
    let read = |i: usize, component: Component| -> Option<Vec<Label>> {
        let values = segments[i].of(component);
        let labels: Vec<Label> = values.iter().map(|value| vocabulary.read(component, &value.label)).collect();
        // A label that says nothing is not known, and neither is its whole row.
        (!labels.is_empty() && labels.iter().all(|label| !label.terms.is_empty())).then_some(labels)
    };
    let (mut shared, mut configuration) = (Vec::new(), Vec::new());
    for i in &hands {
        shared.push((segments[*i].side, components.iter().map(|c| read(*i, *c)).collect::<Option<_>>()?));
        configuration.push(read(*i, Component::Configuration)?);
    }
    let gloss = segments[*hands.first()?].gloss.clone()?;
    hands.sort_unstable();
    Some(Sign { gloss, segments: hands, shared, configuration })
}

/// What the hands share with others, as terms.
fn key(sign: &Sign) -> Vec<String> {
    let of_hand = |(side, rows): &(Option<Side>, Vec<Vec<Label>>)| {
        let row = |labels: &Vec<Label>| labels.iter().map(|l| l.terms.join(";")).collect::<Vec<_>>().join(" > ");
        std::iter::once(format!("{side:?}")).chain(rows.iter().map(row)).collect::<Vec<_>>()
    };
    sign.shared.iter().flat_map(of_hand).collect()
}

/// Whether two signs are made by the same hands, and their shared values one by one are within a distance.
fn is_near(a: &Sign, b: &Sign, tolerance: f64) -> bool {
    let labels = |a: &Label, b: &Label| match (&a.features, &b.features) {
        // What has no features is the same or it is not.
        (Features::Nothing, _) | (_, Features::Nothing) => a.terms == b.terms,
        (x, y) => x.distance(y).is_some_and(|distance| distance <= tolerance),
    };
    let rows = |a: &Vec<Label>, b: &Vec<Label>| a.len() == b.len() && a.iter().zip(b).all(|(x, y)| labels(x, y));
    a.shared.len() == b.shared.len()
        && a.shared.iter().zip(&b.shared).all(|(x, y)| x.0 == y.0 && x.1.iter().zip(&y.1).all(|(p, q)| rows(p, q)))
}

/// A group as a base, where it has two glosses and two configurations at least.
fn base(group: &[Sign], options: &Options) -> Option<Base> {
    let terms = |sign: &Sign| -> Vec<Vec<String>> {
        let of_hand = |labels: &Vec<Label>| labels.iter().map(|l| l.terms.join(";")).collect();
        sign.configuration.iter().map(of_hand).collect()
    };
    let mut members: BTreeMap<(String, Vec<Vec<String>>), Member> = BTreeMap::new();
    for sign in group {
        let member = members.entry((fold(&sign.gloss), terms(sign))).or_insert_with(|| Member {
            gloss: sign.gloss.clone(),
            configuration: shown(sign.shared.iter().map(|(side, _)| *side).zip(&sign.configuration)),
            segments: Vec::new(),
        });
        member.segments.extend(&sign.segments);
    }
    let different = |of: fn(&(String, Vec<Vec<String>>)) -> String| {
        let mut all: Vec<String> = members.keys().map(of).collect();
        all.sort();
        all.dedup();
        all.len()
    };
    if different(|key| key.0.clone()) < 2 || different(|key| format!("{:?}", key.1)) < 2 {
        return None;
    }
    let titles =
        if options.orientation { &["placement", "movement", "orientation"][..] } else { &["placement", "movement"] };
    let shared = group[0].shared.iter().flat_map(|(side, rows)| {
        titles.iter().zip(rows).map(|(title, row)| format!("{}{title} {}", of_side(*side), texts(row)))
    });
    let shared = shared.collect();
    let members = members.into_values().map(|mut member| {
        member.segments.sort_unstable();
        member
    });
    Some(Base { shared, members: members.collect() })
}

fn shown<'a>(hands: impl Iterator<Item = (Option<Side>, &'a Vec<Label>)>) -> String {
    hands.map(|(side, labels)| format!("{}{}", of_side(side), texts(labels))).collect::<Vec<_>>().join(", ")
}

fn texts(labels: &[Label]) -> String {
    labels.iter().map(|label| label.text.as_str()).collect::<Vec<_>>().join(" > ")
}

fn of_side(side: Option<Side>) -> &'static str {
    match side {
        None => "",
        Some(Side::Right) => "right ",
        Some(Side::Left) => "left ",
    }
}
