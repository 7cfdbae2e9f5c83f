//! One mistake a file in `tests/suite/errors`, named by its message, with the rendered diagnostics beside it.

use crate::golden;
use chereme::diagnostics::render::render;
use chereme::notation::{Vocabulary, read, source_of_bytes};

#[test]
fn each_mistake_has_its_message() {
    let vocabulary = Vocabulary::builtin();
    golden::beside("errors", "sign", 40, |name, bytes| {
        let (source, fault) = source_of_bytes(name, bytes);
        let mut reading = read(&source.text, &vocabulary, "");
        reading.diagnostics.extend(fault);
        assert!(!reading.diagnostics.is_empty(), "{name} has no fault");
        reading.diagnostics.iter().map(|d| render(d, &source, false) + "\n\n").collect()
    });
}
