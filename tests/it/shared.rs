//! The tables, recordings and papers that lie beside the repository, and are not in it.

use std::path::{Path, PathBuf};

/// A file or folder of `../shared`, or of the folder that `CHEREME_SHARED` names.
///
/// Without it the calling test says "skipped" and ends; with `CI=true` a missing file is a fault.
pub fn shared(path: &str) -> Option<PathBuf> {
    let beside = || Path::new(env!("CARGO_MANIFEST_DIR")).join("../shared");
    let file = std::env::var_os("CHEREME_SHARED").map_or_else(beside, PathBuf::from).join(path);
    if file.exists() {
        return Some(file);
    }
    assert!(std::env::var("CI").as_deref() != Ok("true"), "{} is missing, and CI=true", file.display());
    println!("skipped: {} is not there", file.display());
    None
}

/// The column of a tab-separated table, by its heading.
pub fn column(table: &Path, heading: &str) -> Vec<String> {
    let text = std::fs::read_to_string(table).unwrap();
    let mut lines = text.lines().map(|line| line.split('\t'));
    let at = lines.next().and_then(|mut names| names.position(|name| name == heading)).expect("the heading");
    lines.filter_map(|mut cells| cells.nth(at)).map(str::to_owned).collect()
}
