//! Gloss lines: laws on random lines and random text.

use crate::strategies::heading;
use chereme::diagnostics::render::render;
use chereme::diagnostics::{Source, Span, Spanned};
use chereme::notation::gloss::syntax::*;
use chereme::notation::gloss::{parse, print};
use chereme::notation::syntax::{
    Configuration, Distance, Duration, Ignored, NonManual, NonManualWhat, Operator, Place, Placement,
};
use chereme::phonology::recombination::{ManualChannel, Taken};
use chereme::phonology::{Amount, Channel, Hand, Space};
use proptest::collection::vec;
use proptest::option::of;
use proptest::prelude::*;
use proptest::sample::{select, subsequence};

fn here<T>(value: T) -> Spanned<T> {
    Spanned::new(value, Span::default())
}

/// Glosses as people write them, and names that are hard to write.
fn name() -> impl Strategy<Value = String> {
    let hard = [
        "ix",
        "fs",
        "take",
        "configuration",
        "WEAK",
        "wrist",
        "left",
        "mid-height",
        "1",
        "-.5",
        "#OK",
        "A+",
        "A+1",
        "A.",
        "A.B",
        "a//b",
        "GOOD MORNING",
        "a:b",
        "a:1",
        "{",
        "]",
        "<HOLD>",
        "HOLD",
        "&",
        "@",
        "É",
        "\"",
        "\\",
        "a  b",
        "“x”",
        "//",
        ".",
        "brows",
    ];
    prop_oneof![2 => "[A-ZÉ][A-Z0-9-]{0,7}", 1 => select(hard.to_vec()).prop_map(str::to_owned), 1 => "[ -~]{1,6}"]
        .prop_map(|name| name.trim().to_owned())
        .prop_filter("a name", |name| !name.is_empty())
}

fn site() -> impl Strategy<Value = Site> {
    let step = || select(vec![-1i8, 0, 1]);
    prop_oneof![
        (step(), step(), step()).prop_map(|(left, high, far)| Site::Space(Space { left, high, far })),
        [-10.0f64..10.0, -0.5f64..2.0, -1e-9f64..1e-9].prop_map(Site::Point),
        name().prop_map(Site::Referent),
    ]
}

/// A few operators; what they may hold is tested with signs made from others.
fn operators() -> impl Strategy<Value = Vec<Operator>> {
    let configuration = name().prop_map(|n| {
        Operator::Configuration(None, vec![Configuration { base: here(n), between: None, changes: Vec::new() }])
    });
    let some = vec![Operator::Inverted, Operator::Mirrored, Operator::Speed(1.3), Operator::Size(2.0)];
    prop_oneof![3 => Just(Vec::new()), 1 => vec(prop_oneof![select(some), configuration], 1..3)]
}

fn signed() -> impl Strategy<Value = Signed> {
    let hand = select(Hand::BOTH.to_vec());
    let gloss = (name(), of(site()), 1u8..20).prop_map(|(name, site, n)| (Head::Gloss(name), site, n));
    let spelled = (name(), of(site())).prop_map(|(word, site)| (Head::Spelled(word), site, 1));
    let pointing = (site(), any::<bool>(), 1u8..4)
        .prop_map(|(site, wrist, n)| (if wrist { Head::Wrist(site) } else { Head::Pointing(site) }, None, n));
    let channels = subsequence(ManualChannel::ALL.to_vec(), 0..=3);
    let taken = (name(), channels, name(), of(site())).prop_map(|(take, channels, other, site)| {
        let channels = channels.into_iter().map(|channel| (channel, other.clone())).collect();
        (Head::Taken(Taken { take, channels }), site, 1)
    });
    (prop_oneof![3 => gloss, 1 => spelled, 1 => pointing, 1 => taken], hand, operators()).prop_map(
        |((head, site, performances), hand, operators)| Signed {
            head: here(head),
            hand,
            site: site.map(here),
            performances: here(performances),
            operators: here(operators),
        },
    )
}

fn duration() -> impl Strategy<Value = Option<Duration>> {
    of((0.01f64..60.0, any::<bool>()).prop_map(|(number, milliseconds)| Duration { number, milliseconds }))
}

fn nonmanual() -> impl Strategy<Value = NonManual> {
    let at = |name| Placement {
        behind: false,
        place: Place::Named(here(name)),
        side: None,
        distance: Some(Distance::Touch),
        with: None,
        offset: None,
    };
    let what = prop_oneof![
        name().prop_map(|n| NonManualWhat::Named(here(n))),
        heading().prop_map(NonManualWhat::Towards),
        name().prop_map(move |n| NonManualWhat::At(Box::new(at(n)))),
        ".{0,5}".prop_map(NonManualWhat::Mouthing),
    ];
    let amount = || select(vec![Amount::Slight, Amount::Plain, Amount::Strong, Amount::Percent(60)]);
    let pace = || proptest::option::of(0.05f64..20.0);
    let leaf = (what, amount(), pace()).prop_map(|(what, amount, pace)| NonManual { what, amount, pace });
    leaf.prop_recursive(2, 6, 3, move |inner| {
        let parts = vec(inner, 2..4);
        let group =
            prop_oneof![parts.clone().prop_map(NonManualWhat::Sequence), parts.prop_map(NonManualWhat::Together)];
        (group, amount(), pace()).prop_map(|(what, amount, pace)| NonManual { what, amount, pace })
    })
}

fn item(depth: u32) -> BoxedStrategy<What> {
    let strong = || signed().prop_map(|s| Box::new(Signed { hand: Hand::Strong, ..s }));
    let flat = prop_oneof![
        6 => signed().prop_map(|s| What::Signed(Box::new(s))),
        1 => (strong(), strong()).prop_map(|(a, b)| What::Together(a, b)),
        2 => select(vec![Pause::Short, Pause::Long]).prop_map(What::Pause),
        1 => (of(select(Hand::BOTH.to_vec())), duration()).prop_map(|(hand, long)| What::Hold(hand, long)),
        1 => duration().prop_map(What::Rest),
    ];
    if depth == 0 {
        return flat.boxed();
    }
    let values = proptest::sample::subsequence(Channel::ALL.to_vec(), 1..4)
        .prop_flat_map(|all| all.into_iter().map(|c| (Just(here(c)), nonmanual())).collect::<Vec<_>>());
    let face = (values, items(depth - 1, 1)).prop_map(|(values, items)| What::Face(Face { values, items }));
    prop_oneof![4 => flat, 1 => face].boxed()
}

fn items(depth: u32, least: usize) -> BoxedStrategy<Vec<Item>> {
    vec(item(depth).prop_map(|what| Item { what, span: Ignored::default() }), least..5).boxed()
}

/// Pieces of gloss lines in any order, touching or apart.
fn babble() -> impl Strategy<Value = String> {
    let pieces = [
        "BOL",
        "IX",
        "(0.5,1.3,0.6)",
        "@left",
        "@",
        "(",
        ")",
        "++",
        "+",
        "[",
        "]",
        "inverted",
        "big",
        "{",
        "}",
        ":",
        "brows",
        "up",
        ",",
        ".",
        "//",
        "<HOLD",
        "<REST>",
        ">",
        "0.5s",
        "weak",
        "weak(",
        "fs(OK)",
        "fs",
        "&",
        "\"x y\"",
        "\"",
        "#",
        "=",
        " ",
        " ",
        " ",
        "\n",
        "é",
        "1,5s",
        "\u{feff}",
        "\u{0}",
        "{brows raised: ",
        "gaze at",
        "with configuration",
        "IX(BOL)",
    ];
    vec(select(pieces.to_vec()), 0..40).prop_map(|p| p.concat())
}

fn survives(text: &str) -> Result<(), TestCaseError> {
    let (line, faults) = parse(text);
    let source = Source::new("line", text);
    for fault in &faults {
        prop_assert!(fault.span.start <= fault.span.end && fault.span.end <= text.len(), "{fault:?}");
        render(fault, &source, false);
    }
    let printed = print(&line);
    // What a fault left out may leave braces empty, which cannot be written.
    if faults.is_empty() {
        let (back, more) = parse(&printed);
        prop_assert_eq!(more, vec![], "{}", printed);
        prop_assert_eq!(back, line, "{}", printed);
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 200, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn what_is_printed_reads_back(items in items(2, 0)) {
        let line = GlossLine { items };
        let text = print(&line);
        let (back, faults) = parse(&text);
        let source = Source::new("line", text.as_str());
        let told: Vec<String> = faults.iter().map(|d| render(d, &source, false)).collect();
        prop_assert!(told.is_empty(), "{}\n{text}", told.join("\n"));
        prop_assert_eq!(&back, &line, "{}", text);
        prop_assert_eq!(print(&back), text);
    }

    #[test]
    fn any_text_is_survived(text in any::<String>()) {
        survives(&text)?;
    }

    #[test]
    fn babble_is_survived(text in babble()) {
        survives(&text)?;
    }
}

#[test]
fn great_and_deep_lines_are_refused_in_time() {
    for text in ["{brows up: ", "{", "(", "weak(", "[", "IX(", "A[", "A @", "<", "\"", "}", "A+", "+", "A & "] {
        let (_, faults) = parse(&text.repeat(50_000));
        assert!(!faults.is_empty() && faults.len() <= 101, "{text}: {}", faults.len());
    }
    assert_eq!(parse(&"A ".repeat(50_000)).1.len(), 1);
}
