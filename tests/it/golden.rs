//! Inputs of `tests/suite` with the expected text beside each; `UPDATE=1 cargo test` writes the expectations anew.

use std::fs;
use std::path::Path;

/// Compares what `told` says of each file of a folder (name, bytes) with the `.txt` beside it.
///
/// Fails where one differs, and where there are fewer than `least` files.
pub fn beside(folder: &str, extension: &str, least: usize, told: impl Fn(&str, &[u8]) -> String) {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/suite").join(folder);
    let update = std::env::var_os("UPDATE").is_some();
    let (mut wrong, mut count) = (Vec::new(), 0);
    let mut files: Vec<_> = fs::read_dir(&folder).unwrap().map(|e| e.unwrap().path()).collect();
    files.sort();
    for path in files.iter().filter(|p| p.extension().is_some_and(|e| e == extension)) {
        count += 1;
        let name = path.file_name().unwrap().to_string_lossy().into_owned();
        let text = told(&name, &fs::read(path).unwrap());
        let beside = path.with_extension("txt");
        if update {
            fs::write(&beside, text.trim_end().to_owned() + "\n").unwrap();
        } else if fs::read_to_string(&beside).unwrap_or_default().trim_end() != text.trim_end() {
            wrong.push(format!("{name}:\n{text}"));
        }
    }
    assert!(count >= least, "{count} files");
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
