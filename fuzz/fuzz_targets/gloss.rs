//! Gloss lines: any text is read; what is read without a fault is printed and read again as the same.
#![no_main]

use chereme::diagnostics::render::render;
use chereme::diagnostics::{Severity, Source};
use chereme::notation::gloss::{parse, print};
use libfuzzer_sys::fuzz_target;

fuzz_target!(|bytes: &[u8]| {
    let source = Source::new("fuzz", String::from_utf8_lossy(bytes));
    let (line, told) = parse(&source.text);
    for told in told.iter().take(20) {
        render(told, &source, false);
    }
    if told.iter().all(|told| told.severity != Severity::Fault) {
        let printed = print(&line);
        assert_eq!(parse(&printed).0, line, "{printed}");
    }
});
