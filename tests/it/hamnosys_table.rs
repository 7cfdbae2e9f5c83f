//! Tables of HamNoSys strings: which column is which, places, and rows that cannot be read.

use crate::golden;
use chereme::diagnostics::render::render;
use chereme::diagnostics::{Source, Span};
use chereme::notation::hamnosys::table::{Format, Options, Row, rows};
use proptest::prelude::*;

fn read(name: &str, text: &str) -> Vec<Row> {
    let source = Source::new(name, text);
    let (rows, told) = rows(&source, &Options::default());
    assert!(told.is_empty(), "{text}: {told:?}");
    for row in &rows {
        assert_eq!(source.line_column(row.span.start).0, row.line, "{text}: {row:?}");
    }
    rows
}

/// Gloss, notation and mouthing of each row.
fn check(name: &str, text: &str, expected: &[[&str; 3]]) {
    let rows = read(name, text);
    let of = |part: &Option<String>| part.clone().unwrap_or_default();
    let found: Vec<_> = rows.iter().map(|row| [of(&row.gloss), row.notation.clone(), of(&row.mouthing)]).collect();
    assert_eq!(found, expected, "{text}");
}

const FIST: &str = "\u{e000}\u{e020}";

#[test]
fn columns_are_found_by_their_headings() {
    check(
        "a.tsv",
        "id\tMouth picture\tHamNoSys\n1\tjEs\thamfist hamextfingeru\n",
        &[["1", "hamfist hamextfingeru", "jEs"]],
    );
    check(
        "a.csv",
        &format!("\u{feff}Gloss;Notation;Sampa\r\nA;{FIST};a\r\nB;{FIST};\r\n"),
        &[["A", FIST, "a"], ["B", FIST, ""]],
    );
    check("a", "transcription,name\n\"hamfist,hampalmd\",X\n", &[["X", "hamfist,hampalmd", ""]]);
}

#[test]
fn without_headings_symbols_show_the_column() {
    check("a.tsv", &format!("1\tYES\t{FIST}\n2\tNO\t{FIST}\n"), &[["1", FIST, ""], ["2", FIST, ""]]);
    check("a.csv", &format!("{FIST}\n\n{FIST}\n"), &[["", FIST, ""], ["", FIST, ""]]);
    check("a.tsv", &format!("mot\tsignes\nOUI\t{FIST}\n"), &[["OUI", FIST, ""]]);
}

#[test]
fn names_that_nobody_quoted_are_one_string() {
    let table = "name,hamnosys,mouthing\nA,hamfist,hamextfingeru, hampalmd,a\nB,hamfist,b\n";
    check("a.csv", table, &[["A", "hamfist,hamextfingeru, hampalmd", "a"], ["B", "hamfist", "b"]]);
}

#[test]
fn cells_in_quotation_marks_hold_anything() {
    let table = "gloss,hamnosys\n\"A, \"\"b\"\"\n\",\"hamfist\n hampalmd\"\nC,hamfist\n";
    check("a.csv", table, &[["A, \"b\"", "hamfist\n hampalmd", ""], ["C", "hamfist", ""]]);
    check("a.tsv", "gloss\thamnosys\n\"A\" b\t\"hamfist\"\n", &[["\"A\" b", "hamfist", ""]]);
}

#[test]
fn json_has_many_shapes() {
    let yes = [["YES", FIST, ""], ["NO", "hamfist", ""]];
    check(
        "a.json",
        &format!(r#"[{{"gloss": "YES", "hamnosys": "{FIST}"}}, {{"name": "NO", "x": [1], "ham": "hamfist"}}]"#),
        &yes,
    );
    check("a.json", &format!("{{\n \"YES\": \"{FIST}\",\n \"NO\": \"hamfist\"}}"), &yes);
    check("a.json", r#"{"YES": {"hamnosys": "\uE000\uE020"}, "NO": {"id": 7, "notation": "hamfist"}}"#, &yes);
    check(
        "a",
        &format!("{{\"id\": \"YES\", \"hns\": \"{FIST}\"}}\n\n{{\"id\": \"NO\", \"hns\": \"hamfist\"}}\n"),
        &yes,
    );
    check("a.json", r#"{"id": 5, "hamnosys": "hamfist", "mouthing": "aI"}"#, &[["5", "hamfist", "aI"]]);
    check("a.json", r#"["hamfist"]"#, &[["", "hamfist", ""]]);
}

#[test]
fn columns_may_be_named_or_numbered() {
    let table = Source::new("a.txt", "A|a\thamfist\thampalmd\nB\thamfist\thampalmu\n");
    let ask = |notation: &str, gloss: Option<&str>| {
        let gloss = gloss.map(str::to_owned);
        let options = Options { notation: Some(notation.to_owned()), gloss, format: Some(Format::Tsv), mouthing: None };
        rows(&table, &options)
    };
    let (found, told) = ask("3", Some("1"));
    assert!(told.is_empty() && found.len() == 2 && found[1].notation == "hampalmu", "{told:?} {found:?}");
    let (found, told) = ask("left", None);
    assert!(found.is_empty() && told[0].message.contains("no column `left`"), "{told:?}");
}

#[test]
fn places_in_strings_are_places_in_tables() {
    let text = "gloss,hamnosys\nA,\"hamfist,hampalmd\"\n";
    let row = &read("a.csv", text)[0];
    let place = row.place(Span::new(8, 16));
    assert_eq!(&text[place.start..place.end], "hampalmd");
    let text = r#"{"A": "hamfist\u002champalmd"}"#;
    let row = &read("a.json", text)[0];
    assert_eq!(row.place(Span::new(8, 16)), row.span, "with escapes, the whole string");
}

#[test]
fn each_mistake_has_its_message() {
    for (ending, least) in [("csv", 3), ("tsv", 3), ("json", 4), ("jsonl", 1)] {
        golden::beside("table", ending, least, |name, bytes| {
            let source = Source::new(name, String::from_utf8_lossy(bytes));
            let (rows, told) = rows(&source, &Options::default());
            assert!(!told.is_empty(), "{name} has no fault");
            let told: String = told.iter().map(|d| render(d, &source, false) + "\n\n").collect();
            format!("{told}{} rows are read.", rows.len())
        });
    }
}

#[test]
fn large_tables_take_no_time_out_of_proportion() {
    let started = std::time::Instant::now();
    for (name, text) in [
        ("a.csv", "\"a,".repeat(300_000)),
        ("a.csv", "\"\"\"a,".repeat(300_000)),
        ("a.csv", format!("\"{}", "\"\"a,".repeat(300_000))),
        ("a.tsv", "\"a\t".repeat(300_000)),
        ("a.tsv", "hamfist\t".repeat(300_000)),
        ("a.csv", "hamfist,\n".repeat(100_000)),
        ("a.json", "[".repeat(1_000_000)),
        ("a.json", format!("[{}0]", "0,".repeat(500_000))),
        ("a.jsonl", "{\"hns\":\"hamfist\"}\n".repeat(50_000)),
        ("a.jsonl", "{}\n{\n".repeat(50_000)),
    ] {
        rows(&Source::new(name, text), &Options::default());
    }
    assert!(started.elapsed() < std::time::Duration::from_secs(10), "{:?}", started.elapsed());
}

/// Parts of tables, put together at random.
const PARTS: &[&str] = &[
    "hamnosys",
    "gloss",
    "mouthing",
    "hamfist",
    "\u{e000}",
    ",",
    ";",
    "\t",
    "\n",
    "\r\n",
    "\"",
    "\"\"",
    "{",
    "}",
    "[",
    "]",
    ":",
    " ",
    "\\u",
    "{\"gloss\":\"A\",\"hamnosys\":\"hamfist\"}",
    "\u{feff}",
    "é",
    "1",
];

proptest! {
    #[test]
    fn no_table_makes_it_panic(parts in prop::collection::vec(prop::sample::select(PARTS), 0..40), format in 0..4usize) {
        let source = Source::new("any", parts.concat());
        let formats = [None, Some(Format::Tsv), Some(Format::Csv), Some(Format::Json)];
        let (rows, _) = rows(&source, &Options { format: formats[format], ..Options::default() });
        for row in rows {
            prop_assert!(source.text.get(row.span.start..row.span.end).is_some(), "{:?}", row);
            prop_assert_eq!(source.line_column(row.span.start).0, row.line);
        }
    }

    #[test]
    fn what_csv_holds_is_read(cells in prop::collection::vec(("[a-z\",;\n ]{0,8}", "ham(fist|palmd)(,hampalmu)?"), 1..6)) {
        let mut writer = csv::Writer::from_writer(Vec::new());
        writer.write_record(["gloss", "hamnosys"]).unwrap();
        for (gloss, notation) in &cells {
            writer.write_record([gloss, notation]).unwrap();
        }
        let text = String::from_utf8(writer.into_inner().unwrap()).unwrap();
        let options = Options { format: Some(Format::Csv), ..Options::default() };
        let (rows, told) = rows(&Source::new("a.csv", text), &options);
        prop_assert!(told.is_empty());
        let found: Vec<_> = rows.into_iter().map(|row| (row.gloss.unwrap_or_default(), row.notation)).collect();
        let cells: Vec<_> = cells.into_iter().map(|(gloss, notation)| (gloss.trim().to_owned(), notation)).collect();
        prop_assert_eq!(found, cells);
    }
}
