//! Queries: what the index finds is what reading every segment finds; the language, its faults, and reasons.

use crate::corpus_scan::scan;
use chereme::avatar::SKELETON;
use chereme::corpus::cut::segments;
use chereme::corpus::index::{About, Index};
use chereme::corpus::label::Vocabulary;
use chereme::corpus::query::{Options, Query, parse};
use chereme::corpus::segment::{Component, Segment, Value};
use chereme::diagnostics::{Diagnostic, Source};
use chereme::motion::skeleton::Skeleton;
use chereme::phonology::Side;
use chereme::tier::Tier;
use chereme::time::Seconds;
use proptest::prelude::*;
use std::sync::LazyLock;

pub static VOCABULARY: LazyLock<Vocabulary> =
    LazyLock::new(|| Vocabulary::builtin(&Skeleton::from_json(SKELETON).unwrap(), None).unwrap());

/// Labels of each component: known, changed, in two, half known, unknown.
const LABELS: [&[&str]; 4] = [
    &["5", "4", "round-B", "round-B, thumb", "B", "1–5", "O", "K", "claw-of-mine", "?", "U, thumb out", "M"],
    &["chest", "Breast, touch", "chest left beside, close", "cheek", "other index tip", "neutral", "somewhere", "?"],
    &["fingers up, palm out", "palm up", "fingers out", "fingers between up and out, palm left", "askew"],
    &[
        "arc up-right 15cm",
        "down, then up",
        "hold",
        "(circle about up) ×3",
        "twist",
        "to chest ×2",
        "jiggle",
        "left small",
    ],
];

const CONDITIONS: &[&str] = &[
    "gloss=hello",
    "gloss=HELLO|\"good bye\"",
    "gloss!=hello",
    "gloss=?",
    "gloss!=?",
    "hand=right",
    "hand!=left",
    "hand=strong",
    "hand=weak|left",
    "hand=?",
    "recording=\"take 1\"",
    "recording!=\"take 2\"",
    "signer=anna",
    "signer!=anna|ben",
    "signer=?",
    "configuration=5",
    "configuration=5|round-b",
    "configuration!=5",
    "configuration=O>K",
    "configuration!=5>4",
    "configuration=5>B>5|O",
    "configuration=?",
    "configuration!=?",
    "configuration=claw-of-mine",
    "configuration~5",
    "configuration~5:0.1",
    "configuration~B|O:0.3",
    "configuration~5>O",
    "configuration~5>O:0.25",
    "placement=chest",
    "placement=\"chest left\"",
    "placement!=breast",
    "placement~chest",
    "placement~\"cheek left\":0.5",
    "placement~\"other palm\"",
    "orientation=\"palm up\"",
    "fingers=up",
    "palm!=up",
    "palm=?",
    "fingers~out",
    "orientation~\"fingers up, palm left\":0.4",
    "movement=arc",
    "movement=up",
    "movement=down>up",
    "movement~\"arc up\"",
    "movement~twist:0.5",
    "duration<1.2s",
    "duration!=800ms",
    "start>=1|0.5",
];

fn value(component: usize) -> impl Strategy<Value = Value> {
    (prop::sample::select(LABELS[component]), 0.0..2.0f64, 0.0..1.0f64).prop_map(|(label, start, length)| Value {
        label: label.to_owned(),
        start: Seconds(start),
        end: Seconds(start + length),
    })
}

fn segment() -> impl Strategy<Value = Segment> {
    let side = prop::sample::select(vec![None, Some(Side::Left), Some(Side::Right)]);
    let gloss = prop::sample::select(vec![None, Some("hello"), Some("Hello"), Some("good bye"), Some("bol")]);
    let time = prop::sample::select(vec![0.0, 0.5, 1.0, 1.0 + 1e-9]);
    let values = (0..4).map(|c| prop::collection::vec(value(c), 0..4)).collect::<Vec<_>>();
    (0..4usize, side, time, prop::sample::select(vec![0.0, 0.8, 1.2, 3.0]), gloss, values).prop_map(
        |(recording, side, start, length, gloss, values)| Segment {
            recording,
            side,
            start: Seconds(start),
            end: Seconds(start + length),
            gloss: gloss.map(str::to_owned),
            values: values.try_into().unwrap(),
        },
    )
}

/// Of the recordings of random segments one is not in the list.
pub fn recordings() -> Vec<About> {
    let about = |name: &str, signer: Option<&str>, dominant| About {
        name: name.to_owned(),
        signer: signer.map(str::to_owned),
        dominant,
    };
    vec![
        about("Take 1", Some("Anna"), Some(Side::Right)),
        about("take 2", Some("ben"), Some(Side::Left)),
        about("take 3", None, None),
    ]
}

pub fn some_segments(count: std::ops::Range<usize>) -> impl Strategy<Value = Vec<Segment>> {
    prop::collection::vec(segment(), count)
}

fn read(text: &str) -> Result<(Query, Vec<Diagnostic>), Vec<Diagnostic>> {
    parse(&Source::new("query", text), &VOCABULARY).map(|parsed| (parsed.query, parsed.warnings))
}

fn query(text: &str) -> Query {
    read(text).unwrap_or_else(|faults| panic!("{text}: {faults:?}")).0
}

/// The segments in the index's order.
fn in_order(mut segments: Vec<Segment>) -> Vec<Segment> {
    let hand = |s: &Segment| s.side.map_or(0, |side| if side == Side::Right { 1 } else { 2 });
    segments.sort_by(|a, b| {
        a.recording.cmp(&b.recording).then(a.start.0.total_cmp(&b.start.0)).then(hand(a).cmp(&hand(b)))
    });
    segments
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 96, ..ProptestConfig::default() })]

    #[test]
    fn the_index_finds_what_reading_every_segment_finds(
        all in some_segments(0..60),
        conditions in prop::collection::vec(prop::sample::select(CONDITIONS), 0..4),
        limit in prop::sample::select(vec![0usize, 1, 3, 20, 1000]),
        strict in any::<bool>(),
    ) {
        let (recordings, sorted) = (recordings(), in_order(all.clone()));
        let index = Index::build(&recordings, &all, &VOCABULARY);
        for (number, segment) in sorted.iter().enumerate() {
            prop_assert_eq!(index.segment(number), Some(segment.clone()));
        }
        let text = conditions.join("  ");
        let (query, options) = (query(&text), Options { limit, strict });
        let hits = index.find(&query, &options);
        let found: Vec<(usize, bool, f64)> = hits.iter().map(|hit| (hit.segment, hit.sure, hit.distance)).collect();
        prop_assert_eq!(&found, &scan(&query, &recordings, &sorted, &VOCABULARY, &options), "{}", text);
        for hit in &hits {
            let reasons = index.reasons(&query, hit);
            prop_assert_eq!(reasons.len(), query.conditions.len());
            let unknown = reasons.iter().any(|reason| reason.contains("is not known"));
            prop_assert!(hit.sure || unknown, "{:?}", reasons);
        }
    }

    #[test]
    fn a_condition_and_its_opposite_share_what_is_not_known_and_part_the_rest(
        all in some_segments(0..60),
        (condition, opposite) in prop::sample::select(vec![
            ("gloss=hello", "gloss!=hello"),
            ("hand=strong", "hand!=strong"),
            ("configuration=5|B", "configuration!=5|B"),
            ("fingers=up", "fingers!=up"),
            ("placement=?", "placement!=?"),
        ]),
    ) {
        let index = Index::build(&recordings(), &all, &VOCABULARY);
        let find = |text: &str| index.find(&query(text), &Options { limit: 1000, strict: false });
        let (yes, no) = (find(condition), find(opposite));
        let of = |hits: &[chereme::corpus::query::Hit], sure: bool| -> Vec<usize> {
            hits.iter().filter(|hit| hit.sure == sure).map(|hit| hit.segment).collect()
        };
        prop_assert_eq!(of(&yes, false), of(&no, false));
        let mut every = [of(&yes, true), of(&no, true), of(&yes, false)].concat();
        every.sort_unstable();
        prop_assert_eq!(every, (0..all.len()).collect::<Vec<_>>());
    }

    #[test]
    fn any_text_is_a_query_or_has_faults_with_a_place(text in "\\PC{0,60}|[a-z=!~<>:|\"? .0-9]{0,60}") {
        if let Err(faults) = read(&text) {
            prop_assert!(!faults.is_empty());
            for fault in faults {
                prop_assert!(fault.span.start <= text.len() + 1, "{:?}", fault);
                chereme::diagnostics::render::render(&fault, &Source::new("query", text.clone()), false);
            }
        }
    }

    #[test]
    fn any_label_is_read(text in "\\PC{0,80}|[a-z ,()×–0-9-]{0,80}") {
        for component in Component::ALL {
            let label = VOCABULARY.read(component, &text);
            prop_assert!((0.0..=1.0).contains(&label.certainty));
            prop_assert!(label.terms.is_sorted());
            if let Some(distance) = label.features.distance(&label.features) {
                prop_assert_eq!(distance, 0.0);
            }
        }
    }
}

#[test]
fn long_labels_cost_neither_stack_nor_hours() {
    let begin = "pointing at ".repeat(50_000);
    for component in Component::ALL {
        for text in
            [begin.clone(), "to ".repeat(100_000), "a–".repeat(100_000), "x".repeat(400_000), "(".repeat(100_000)]
        {
            VOCABULARY.read(component, &text);
        }
    }
}

#[test]
fn names_of_the_inventories_stand_for_one_another() {
    let terms = |component, text: &str| VOCABULARY.read(component, text).terms;
    assert_eq!(terms(Component::Placement, "chest"), terms(Component::Placement, "BREAST"));
    assert_eq!(terms(Component::Configuration, "A-bar"), terms(Component::Configuration, "fist-thumb-up"));
    let lsf = Vocabulary::builtin(&Skeleton::from_json(SKELETON).unwrap(), Some("lsf")).unwrap();
    assert_eq!(lsf.read(Component::Configuration, "M").terms, ["base m-lsf"]);
    assert_eq!(VOCABULARY.read(Component::Configuration, "M").certainty, 0.0);
}

#[test]
fn faults_say_where_and_what_instead() {
    let cases = [
        ("glos=hello", "segments have no `glos`", "did you mean `gloss`?"),
        (
            "gloss hello",
            "this is no condition",
            "a condition is a field, an operator and a value: gloss=hello, configuration~5, duration<1.2s",
        ),
        (
            "gloss=hello and hand=right",
            "this is no condition",
            "conditions stand side by side, without a word between them",
        ),
        ("configuration<5", "`configuration` cannot be compared with `<`", "a sequence is written in the value: O>K"),
        ("hand=rigth", "`rigth` is no hand", "did you mean `right`?"),
        ("duration<1,2s", "`1,2s` is no time", "the decimal mark is a point: 1.2s"),
        ("gloss=\"hello", "this quote has no end", "close it with the same quote"),
        ("placement~chset", "`chset` is no placement that can be compared", "did you mean `chest`?"),
    ];
    for (text, message, hint) in cases {
        let faults = read(text).unwrap_err();
        assert_eq!(faults[0].message, message, "{text}");
        assert_eq!(faults[0].hints, [hint], "{text}");
    }
    let both = read("glos=hello hand=middle").unwrap_err();
    assert_eq!(both.len(), 2);
    let warned = read("configuration=round-C placement=elbowe").unwrap().1;
    assert!(warned.iter().any(|warning| warning.message.contains("elbowe")), "{warned:?}");
    assert_eq!(read("configuration~5:7").unwrap_err()[0].message, "`7` is no distance");
}

#[test]
fn hits_say_why() {
    let value = |label: &str| vec![Value { label: label.into(), start: Seconds(0.0), end: Seconds(1.0) }];
    let known = Segment {
        side: Some(Side::Right),
        end: Seconds(0.8),
        gloss: Some("HELLO".into()),
        values: [value("4"), value("chest"), value("palm up"), Vec::new()],
        ..Segment::default()
    };
    let index = Index::build(&recordings(), &[known], &VOCABULARY);
    let asked = query(
        "gloss=hello configuration~5 placement=breast palm=up fingers=out movement=arc duration<1.2s signer!=ben",
    );
    let hits = index.find(&asked, &Options::default());
    let reasons = index.reasons(&asked, &hits[0]);
    assert_eq!(reasons[0], "gloss is HELLO");
    assert!(reasons[1].starts_with("configuration 4 is 0.") && reasons[1].ends_with(" from 5"), "{}", reasons[1]);
    let rest = [
        "placement is chest",
        "palm is palm up",
        "fingers is not known, only palm up",
        "movement is not known",
        "duration is 0.80 s, below 1.2s",
        "signer is Anna, not ben",
    ];
    assert_eq!(reasons[2..], rest);
}

fn tier(name: &str, values: &[(f64, f64, &str)]) -> Tier {
    let mut tier = Tier::new(name);
    values.iter().for_each(|(start, end, label)| tier.push(Seconds(*start), Seconds(*end), *label, "test"));
    tier
}

#[test]
fn segments_are_cut_by_gloss_by_stroke_or_not_at_all() {
    let shapes = [(0.0, 1.1, "S"), (1.1, 2.5, "5"), (2.5, 3.0, "?"), (3.0, 4.0, "B")];
    let glossed =
        segments(7, &[tier("rh gloss", &[(1.0, 2.0, "one"), (2.0, 4.0, "")]), tier("RH Configuration", &shapes)]);
    let labels = |s: &Segment| s.of(Component::Configuration).iter().map(|v| v.label.clone()).collect::<Vec<_>>();
    assert_eq!(glossed.len(), 2);
    assert_eq!((labels(&glossed[0]), glossed[0].gloss.as_deref()), (vec!["S".to_owned(), "5".to_owned()], Some("one")));
    assert_eq!(glossed[0].of(Component::Configuration)[1].end, Seconds(2.5), "values are whole");
    assert_eq!((labels(&glossed[1]), glossed[1].gloss.as_deref()), (vec!["5".to_owned(), "B".to_owned()], None));
    assert!(glossed.iter().all(|s| s.recording == 7 && s.side == Some(Side::Right)));

    let phases = tier("LH Phase", &[(0.0, 1.0, "preparation"), (1.0, 2.0, "stroke"), (3.0, 3.5, "stroke")]);
    let strokes = segments(0, &[phases, tier("LH Configuration", &shapes)]);
    assert_eq!(strokes.iter().map(|s| s.start.0).collect::<Vec<_>>(), [1.0, 3.0]);
    let whole = segments(0, &[tier("LH Configuration", &shapes)]);
    assert_eq!((whole.len(), whole[0].start, whole[0].end), (1, Seconds(0.0), Seconds(4.0)));

    let shared = tier("Gloss", &[(0.0, 0.5, "one"), (1.0, 2.0, "two"), (5.0, 6.0, "three")]);
    let by_hand = segments(0, &[shared.clone(), tier("LH Configuration", &shapes)]);
    let of = |s: &Segment| (s.gloss.clone().unwrap(), s.side);
    let expected = [("one", Some(Side::Left)), ("two", Some(Side::Left)), ("three", None)];
    assert_eq!(by_hand.iter().map(of).collect::<Vec<_>>(), expected.map(|(g, s)| (g.to_owned(), s)));
    assert!(segments(0, &[shared]).iter().all(|s| s.side.is_none()));
    assert!(segments(0, &[]).is_empty());
}
