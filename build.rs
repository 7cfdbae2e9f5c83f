//! Embeds the `lexicon/` folder: a list of (path, text) pairs, so that the program has its signs wherever it runs.
//!
//! A build script of forty lines rather than the `include_dir` crate: one dependency less, a sorted list that is
//! the same on every machine, `/` in paths on all systems, and only `.sign` files.

use std::fmt::Write as _;
use std::path::{Path, PathBuf};
use std::{env, fs};

fn main() {
    let root = PathBuf::from(env::var("CARGO_MANIFEST_DIR").expect("cargo sets it"));
    println!("cargo::rerun-if-changed=lexicon");
    println!("cargo::rerun-if-changed=build.rs");
    let mut files = Vec::new();
    collect(&root.join("lexicon"), &mut files);
    files.sort();
    let mut list = String::from("&[\n");
    for file in files {
        let name: Vec<_> = file.strip_prefix(&root).expect("inside").iter().map(|p| p.to_string_lossy()).collect();
        println!("cargo::rerun-if-changed={}", file.display());
        writeln!(list, "    ({:?}, include_str!({:?})),", name.join("/"), file).expect("a string takes it");
    }
    list.push(']');
    let out = PathBuf::from(env::var("OUT_DIR").expect("cargo sets it")).join("lexicon.rs");
    fs::write(&out, list).expect("the build folder can be written");
}

/// The `.sign` files of a folder and its folders; none where there is no folder.
fn collect(folder: &Path, files: &mut Vec<PathBuf>) {
    let Ok(entries) = fs::read_dir(folder) else { return };
    for path in entries.flatten().map(|e| e.path()) {
        if path.is_dir() {
            collect(&path, files);
        } else if path.extension().is_some_and(|e| e == "sign") {
            files.push(path);
        }
    }
}
