//! `.sign` text: any bytes are read; what is read without a fault is printed and read again as the same.
#![no_main]

use chereme::diagnostics::render::render;
use chereme::notation::syntax::{File, Line};
use chereme::notation::{Vocabulary, parse, print, read, source_of_bytes, write};
use libfuzzer_sys::fuzz_target;
use std::sync::OnceLock;

fuzz_target!(|bytes: &[u8]| {
    static VOCABULARY: OnceLock<Vocabulary> = OnceLock::new();
    let vocabulary = VOCABULARY.get_or_init(Vocabulary::builtin);
    let (source, _) = source_of_bytes("fuzz.sign", bytes);
    let reading = read(&source.text, vocabulary, "lsf");
    for told in reading.diagnostics.iter().take(20) {
        render(told, &source, false);
    }
    if reading.has_faults() {
        return;
    }
    let printed = print(&reading.file);
    // Signs come to stand apart, so blank lines are no part of what is said.
    let said = |file: &File| -> Vec<Line> {
        file.lines.iter().filter(|line| line.content.is_some() || line.comment.is_some()).cloned().collect()
    };
    assert_eq!(said(&parse(&printed).0), said(&reading.file), "{printed}");
    assert_eq!(print(&parse(&printed).0), printed);
    for named in &reading.signs {
        let written = write(&named.sign);
        let again = read(&written, vocabulary, "");
        assert!(!again.has_faults(), "{written}\n{:?}", again.diagnostics);
        assert_eq!(again.signs[0].sign, named.sign, "{written}");
    }
});
