//! Laws of the notation, on random signs and random bytes.

use crate::strategies::{Words, sign};
use chereme::diagnostics::Source;
use chereme::diagnostics::render::render;
use chereme::notation::{Vocabulary, explain, parse, print, read, source_of_bytes, write};
use chereme::phonology::Sign;
use proptest::prelude::*;

fn reads_back(sign: &Sign, vocabulary: &Vocabulary) -> Result<(), TestCaseError> {
    let text = write(sign);
    let reading = read(&text, vocabulary, "");
    let source = Source::new("random.sign", text.clone());
    let faults: Vec<String> = reading
        .diagnostics
        .iter()
        .filter(|d| !d.message.starts_with("nothing is said"))
        .map(|d| render(d, &source, false))
        .collect();
    prop_assert!(faults.is_empty(), "{}\n{text}", faults.join("\n"));
    prop_assert_eq!(&reading.signs[0].sign, sign, "{}", text);
    prop_assert_eq!(print(&reading.file), text.clone(), "fmt changes what was written");
    prop_assert!(explain(sign).starts_with(&sign.name));
    Ok(())
}

/// Words of the language in any order: far likelier than random bytes to come deep into the parser.
fn babble() -> impl Strategy<Value = String> {
    let words = [
        "sign",
        "BOL",
        "language",
        "lsf",
        "configuration",
        "placement",
        "orientation",
        "movement",
        "contact",
        "hands",
        "both",
        "mirrored",
        "strong",
        "weak",
        "then",
        "at",
        "end",
        "key",
        "2",
        "between",
        "and",
        "(",
        ")",
        ",",
        "=",
        "\"x\"",
        "#",
        "\n",
        "\n  ",
        "up",
        "down-left",
        "10cm",
        "arc",
        "circle",
        "axis",
        "bulging",
        "fingers",
        "palm",
        "index",
        "tip",
        "other",
        "space",
        "point",
        "while",
        "fused",
        "repeated",
        "continued",
        "flat",
        "chest",
        "touch",
        "beside",
        "left",
        "brows",
        "gaze",
        "towards",
        "meaning",
        "en",
        "\t",
        "\r\n",
        "\u{feff}",
        "é",
        "1,5cm",
    ];
    proptest::collection::vec(proptest::sample::select(words.to_vec()), 0..60).prop_map(|w| w.join(" "))
}

fn survives(text: &str, vocabulary: &Vocabulary) -> Result<(), TestCaseError> {
    let source = Source::new("random.sign", text);
    let reading = read(text, vocabulary, "lsf");
    for fault in &reading.diagnostics {
        prop_assert!(fault.span.start <= fault.span.end && fault.span.end <= text.len(), "{fault:?}");
        render(fault, &source, false);
    }
    let laid_out = print(&reading.file);
    let again = print(&parse(&laid_out).0);
    prop_assert_eq!(again, laid_out);
    for lowered in &reading.signs {
        let written = write(&lowered.sign);
        let back = read(&written, vocabulary, "");
        prop_assert_eq!(&back.signs[0].sign, &lowered.sign, "{}", written);
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 400, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn what_is_written_reads_back(sign in sign(Words::any())) {
        reads_back(&sign, &Vocabulary::open())?;
    }

    #[test]
    fn known_names_pass_the_vocabulary(sign in sign(Words::known())) {
        thread_local!(static VOCABULARY: Vocabulary = Vocabulary::builtin());
        VOCABULARY.with(|v| reads_back(&sign, v))?;
    }

    #[test]
    fn any_bytes_are_survived(bytes in proptest::collection::vec(any::<u8>(), 0..300)) {
        let (source, _) = source_of_bytes("random", &bytes);
        survives(&source.text, &Vocabulary::open())?;
    }

    #[test]
    fn babble_is_survived(text in babble()) {
        survives(&text, &Vocabulary::open())?;
    }

    #[test]
    fn cut_short_it_is_survived(sign in sign(Words::any()), part in 0.0f64..1.0) {
        let text = write(&sign);
        let cut = (text.len() as f64 * part) as usize;
        let (source, _) = source_of_bytes("cut", &text.as_bytes()[..cut]);
        survives(&source.text, &Vocabulary::open())?;
    }
}

#[test]
fn comments_stay_beside_lines_that_are_left_out() {
    for text in ["sign\n#\n  configuration  sign\n#\n", "sign \n  hands both\n# a\n\n# b\n", "sign X\nsign\n#\n"] {
        survives(text, &Vocabulary::open()).unwrap();
    }
}

#[test]
fn great_and_deep_texts_are_refused_in_time() {
    let open = Vocabulary::open();
    let deep = format!("sign A\n movement {}up\n", "( ".repeat(100_000));
    assert!(read(&deep, &open, "").has_faults());
    let deep = format!("sign A\n placement {}chest\n", "between ".repeat(100_000));
    assert!(read(&deep, &open, "").has_faults());
    let nested = format!("sign A\n movement {}up{}\n", "( ".repeat(20), " ) continued 50".repeat(20));
    assert!(read(&nested, &open, "").has_faults());
    let long = format!("sign A\n movement up{}\n", " then up".repeat(100_000));
    assert!(read(&long, &open, "").has_faults());
    let huge = format!("sign A\n movement up {}cm\n duration 1e999s\n", "9".repeat(1000));
    assert_eq!(read(&huge, &open, "").diagnostics.len(), 2);
    let many = "sign A\n".repeat(50_000) + &"flat\n".repeat(50_000);
    read(&many, &open, "");
}
