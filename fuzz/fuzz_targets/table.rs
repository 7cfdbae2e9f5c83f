//! Tables of HamNoSys strings in each format: any text is read, rows are where they say.
#![no_main]

use chereme::diagnostics::Source;
use chereme::diagnostics::render::render;
use chereme::notation::hamnosys::parse;
use chereme::notation::hamnosys::table::{Format, Options, rows};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let source = Source::new("fuzz", String::from_utf8_lossy(bytes));
    for format in [None, Some(Format::Tsv), Some(Format::Csv), Some(Format::Json)] {
        let (rows, told) = rows(&source, &Options { format, ..Options::default() });
        for told in told.iter().take(20) {
            render(told, &source, false);
        }
        for row in rows {
            assert!(source.text.get(row.span.start..row.span.end).is_some(), "{row:?}");
            assert_eq!(source.line_column(row.span.start).0, row.line, "{row:?}");
            let (_, told) = parse::sign(&row.notation);
            for told in told.iter().take(20) {
                let place = row.place(told.span);
                assert!(row.span.start <= place.start && place.end <= row.span.end, "{row:?} {told:?}");
            }
        }
    }
});
