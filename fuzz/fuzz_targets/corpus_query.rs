//! Queries of a corpus: any text is understood or refused; what is understood is asked of a small index, and each hit has reasons.
#![no_main]

use chereme::corpus::index::{About, Index};
use chereme::corpus::label::Vocabulary;
use chereme::corpus::query::{Options, parse};
use chereme::corpus::segment::{Segment, Value};
use chereme::diagnostics::Source;
use chereme::diagnostics::render::render;
use chereme::motion::skeleton::Skeleton;
use chereme::phonology::Side;
use chereme::time::Seconds;
use libfuzzer_sys::fuzz_target;
use std::sync::LazyLock;

static VOCABULARY: LazyLock<Vocabulary> = LazyLock::new(|| {
    let rig = Skeleton::from_json(chereme::avatar::SKELETON).expect("it is ours");
    Vocabulary::builtin(&rig, None).expect("it is ours")
});

/// Three recordings; every label has its time to itself.
static INDEX: LazyLock<Index> = LazyLock::new(|| {
    let about = |name: &str, signer: Option<&str>, dominant| About {
        name: name.into(),
        signer: signer.map(str::to_owned),
        dominant,
    };
    let recordings = [
        about("take 1", Some("Anna"), Some(Side::Right)),
        about("Take 2", Some("ben"), Some(Side::Left)),
        about("take 3", None, None),
    ];
    let segment = |recording, side, gloss: Option<&str>, labels: [&[&str]; 4]| Segment {
        recording,
        side,
        start: Seconds(recording as f64),
        end: Seconds(recording as f64 + 1.5),
        gloss: gloss.map(str::to_owned),
        values: labels.map(|labels| {
            let value = |(at, label): (usize, &&str)| Value {
                label: (*label).to_owned(),
                start: Seconds(at as f64),
                end: Seconds(at as f64 + 1.0),
            };
            labels.iter().enumerate().map(value).collect()
        }),
    };
    let (right, left) = (Some(Side::Right), Some(Side::Left));
    let segments = [
        segment(
            0,
            right,
            Some("Hello"),
            [&["5"], &["chest, touch"], &["fingers up, palm out"], &["arc up-right 15cm"]],
        ),
        segment(0, left, Some("Hello"), [&["round-B", "O"], &["neutral"], &["palm up"], &["(circle about up) ×3"]]),
        segment(1, right, Some("good bye"), [&["O", "K", "claw-of-mine"], &["cheek"], &["askew"], &["down, then up"]]),
        segment(1, None, None, [&["?"], &["other index tip"], &[], &["hold"]]),
        segment(2, left, Some("été"), [&[], &[], &["fingers between up and out, palm left"], &["to chest ×2"]]),
        segment(7, None, None, [&[], &[], &[], &[]]),
    ];
    Index::build(&recordings, &segments, &VOCABULARY)
});

fuzz_target!(|bytes: &[u8]| {
    let source = Source::new("query", String::from_utf8_lossy(bytes));
    let told = match parse(&source, &VOCABULARY) {
        Ok(parsed) => {
            let all = INDEX.find(&parsed.query, &Options::default());
            for hit in &all {
                assert!(hit.segment < INDEX.len() && hit.distance >= 0.0, "{hit:?}");
                INDEX.reasons(&parsed.query, hit);
            }
            let strict = INDEX.find(&parsed.query, &Options { strict: true, ..Options::default() });
            assert!(all.iter().filter(|hit| hit.sure).eq(&strict));
            let first = INDEX.find(&parsed.query, &Options { limit: 1, strict: false });
            assert!(first.iter().eq(all.first()));
            parsed.warnings
        }
        Err(told) => {
            assert!(!told.is_empty());
            told
        }
    };
    for told in told.iter().take(20) {
        render(told, &source, false);
    }
});
