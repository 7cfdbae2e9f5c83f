//! One mistake a file in `tests/suite/errors`, named by its message, with the rendered diagnostics beside it.
//!
//! `UPDATE=1 cargo test` writes the expectations anew.

use chereme::diagnostics::render::render;
use chereme::notation::{Vocabulary, read, source_of_bytes};
use std::fs;
use std::path::Path;

#[test]
fn each_mistake_has_its_message() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/suite/errors");
    let vocabulary = Vocabulary::builtin();
    let update = std::env::var_os("UPDATE").is_some();
    let (mut wrong, mut count) = (Vec::new(), 0);
    let mut files: Vec<_> = fs::read_dir(&folder).unwrap().map(|e| e.unwrap().path()).collect();
    files.sort();
    for path in files.iter().filter(|p| p.extension().is_some_and(|e| e == "sign")) {
        count += 1;
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        let (source, fault) = source_of_bytes(&name, &fs::read(path).unwrap());
        let mut reading = read(&source.text, &vocabulary, "");
        reading.diagnostics.extend(fault);
        assert!(!reading.diagnostics.is_empty(), "{name} has no fault");
        let text: String = reading.diagnostics.iter().map(|d| render(d, &source, false) + "\n\n").collect();
        let beside = path.with_extension("txt");
        if update {
            fs::write(&beside, text.trim_end().to_owned() + "\n").unwrap();
        } else if fs::read_to_string(&beside).unwrap_or_default().trim_end() != text.trim_end() {
            wrong.push(format!("{name}:\n{text}"));
        }
    }
    assert!(count >= 40, "{count} files");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
