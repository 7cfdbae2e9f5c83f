//! The layers of docs/ARCHITECTURE.md hold: no module reaches for one that its row does not name.
//!
//! The table is read from the document, so that what people read is what is checked.

mod scan;

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

/// Modules that may touch files, the environment and the terminal.
const OUTSIDE: [&str; 2] = ["cli", "main"];

/// The one part of another module that may touch files: those of a corpus's cache.
const CACHE: [&str; 2] = ["corpus", "cache"];

/// A row of the table.
#[derive(Debug)]
struct Row {
    coming: bool,
    /// `None`: all.
    may_use: Option<BTreeSet<String>>,
}

fn root() -> PathBuf {
    PathBuf::from(env!("CARGO_MANIFEST_DIR"))
}

/// The rows of the layers table of a document, by module.
fn table(document: &str) -> BTreeMap<String, Row> {
    let mut rows = BTreeMap::new();
    let lines = document.lines().skip_while(|line| !line.starts_with("| module | owns | may use |"));
    for line in lines.skip(2).take_while(|line| line.starts_with('|')) {
        let cells: Vec<&str> = line.trim_matches('|').split('|').map(str::trim).collect();
        let [module, _, may_use] = cells[..] else { panic!("a row of three cells, not {line:?}") };
        let names = |cell: &str| cell.split('`').skip(1).step_by(2).map(str::to_owned).collect::<Vec<_>>();
        let may_use = match may_use {
            "all" => None,
            "–" => Some(BTreeSet::new()),
            list => Some(list.split(',').map(|name| name.trim().trim_matches('`').to_owned()).collect()),
        };
        for name in names(module) {
            let row = Row { coming: module.contains("coming"), may_use: may_use.clone() };
            assert!(rows.insert(name.clone(), row).is_none(), "`{name}` has two rows");
        }
    }
    rows
}

/// The source files below a folder.
fn sources(folder: &Path) -> Vec<PathBuf> {
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        if path.is_dir() {
            found.extend(sources(&path));
        } else if path.extension().is_some_and(|e| e == "rs") {
            found.push(path);
        }
    }
    found.sort();
    found
}

/// The module path of a source file, such as `["motion", "easing"]`; `["main"]` for the program, empty for the library's root.
fn module_of(path: &Path) -> Vec<String> {
    let inside = path.strip_prefix(root().join("src")).unwrap().with_extension("");
    let mut parts: Vec<String> = inside.iter().map(|p| p.to_str().unwrap().to_owned()).collect();
    if parts.last().is_some_and(|p| p == "mod") || parts == ["lib"] {
        parts.pop();
    }
    parts
}

/// Faults of one file: edges that the table does not have, names that are no module, what only the outside may touch.
fn faults(text: &str, module: &[&str], rows: &BTreeMap<String, Row>) -> Vec<String> {
    // The library's root only names the modules.
    let Some(top) = module.first().copied() else { return Vec::new() };
    // The program is a crate of its own, whose way into the library is `chereme::`.
    let here = if top == "main" { &[] } else { module };
    let mut found = Vec::new();
    for path in scan::paths(text, here) {
        let written = path.join("::");
        if path[0] == "crate" || path[0] == env!("CARGO_PKG_NAME") {
            let Some(target) = path.get(1).filter(|name| *name != "*") else {
                found.push(format!("`{written}` takes the whole crate in; name the module"));
                continue;
            };
            if target == top {
                continue;
            }
            let Some(Row { may_use, .. }) = rows.get(top) else { continue };
            if !rows.contains_key(target) {
                found.push(format!("`{written}`: `{target}` is no module of the table"));
            } else if may_use.as_ref().is_some_and(|names| !names.contains(target)) {
                found.push(format!("`{written}`: `{top}` may not use `{target}`"));
            }
        } else if !OUTSIDE.contains(&top) && !module.starts_with(&CACHE) && is_outside(&path) {
            found.push(format!("`{written}`: only {} may touch files, clock and terminal", OUTSIDE.join(" and ")));
        }
    }
    found
}

/// Whether a path is a file, the environment, a process, the network, the clock or the terminal.
fn is_outside(path: &[String]) -> bool {
    let path: Vec<&str> = path.iter().map(String::as_str).collect();
    match path[..] {
        [name] => matches!(name, "print!" | "println!" | "eprint!" | "eprintln!" | "dbg!"),
        ["std", "fs" | "env" | "net" | "process", ..] => true,
        ["std", "time", "Instant" | "SystemTime" | "*", ..] | ["std", "*"] => true,
        ["std", "io", "stdin" | "stdout" | "stderr" | "*", ..] => true,
        ["fs" | "env", ..] | ["io", "stdin" | "stdout" | "stderr", ..] => true,
        ["Instant" | "SystemTime", "now", ..] => true,
        _ => false,
    }
}

fn layers() -> BTreeMap<String, Row> {
    let rows = table(&std::fs::read_to_string(root().join("docs/ARCHITECTURE.md")).unwrap());
    assert!(rows.len() > 10, "docs/ARCHITECTURE.md has no layers table");
    rows
}

#[test]
fn no_module_uses_one_that_its_row_does_not_name() {
    let rows = layers();
    let mut found = Vec::new();
    for file in sources(&root().join("src")) {
        let module = module_of(&file);
        let module: Vec<&str> = module.iter().map(String::as_str).collect();
        let text = std::fs::read_to_string(&file).unwrap();
        let name = file.strip_prefix(root()).unwrap().display().to_string();
        found.extend(faults(&text, &module, &rows).into_iter().map(|fault| format!("{name}: {fault}")));
    }
    assert!(found.is_empty(), "see the layers in docs/ARCHITECTURE.md\n{}", found.join("\n"));
}

#[test]
fn every_module_has_a_row_and_every_row_a_module() {
    let rows = layers();
    let there: BTreeSet<String> =
        sources(&root().join("src")).iter().filter_map(|file| module_of(file).into_iter().next()).collect();
    let mut found = Vec::new();
    for module in &there {
        match rows.get(module) {
            None => found.push(format!("src has `{module}`, the table has not")),
            Some(row) if row.coming => found.push(format!("`{module}` has come: take the mark `coming` from its row")),
            Some(_) => {}
        }
    }
    for (module, row) in &rows {
        if !row.coming && !there.contains(module) {
            found.push(format!("the table has `{module}`, src has not"));
        }
        for used in row.may_use.iter().flatten().filter(|used| !rows.contains_key(*used)) {
            found.push(format!("`{module}` may use `{used}`, which has no row"));
        }
    }
    assert!(found.is_empty(), "docs/ARCHITECTURE.md\n{}", found.join("\n"));
}

#[test]
fn the_layers_have_no_circle() {
    let rows = layers();
    let mut placed: BTreeSet<&String> =
        rows.iter().filter(|(_, row)| row.may_use.is_none()).map(|(name, _)| name).collect();
    while placed.len() < rows.len() {
        let next = rows.iter().find(|(name, row)| {
            !placed.contains(name) && row.may_use.iter().flatten().all(|used| placed.contains(used))
        });
        let Some((name, _)) = next else {
            panic!("a circle among {:?}", rows.keys().filter(|name| !placed.contains(name)).collect::<Vec<_>>())
        };
        placed.insert(name);
    }
}

#[test]
fn each_kind_of_fault_is_seen() {
    let rows = table(
        "| module | owns | may use |\n|---|---|---|\n| `time` | t | – |\n| `motion` | m | time |\n\
         | `phonology` (coming) | p | `time` |\n\
         | `corpus` | r | – |\n| `cli`, `main` | c | all |\n\nAfter the table.",
    );
    assert_eq!(rows.len(), 6);
    assert!(rows["phonology"].coming && !rows["cli"].coming && rows["main"].may_use.is_none());
    let check = |text: &str, module: &[&str], expected: &str| {
        let found = faults(text, module, &rows);
        if expected.is_empty() {
            assert!(found.is_empty(), "{found:?}");
        } else {
            assert!(found.len() == 1 && found[0].contains(expected), "{found:?}, not {expected}");
        }
    };
    check("use crate::time::Fps; use super::clip; mod t { use super::*; }", &["motion", "easing"], "");
    check("use super::super::phonology::Sign;", &["motion", "easing"], "`motion` may not use `phonology`");
    check("use super::{time, phonology};", &["motion"], "`motion` may not use `phonology`");
    check("use crate::Sign;", &["motion"], "`Sign` is no module");
    check("use super::*;", &["motion"], "takes the whole crate in");
    check("use crate::motion;", &["time"], "`time` may not use `motion`");
    check("fn f() { let t = std::fs::read(\"a\"); }", &["motion"], "only cli and main");
    check("use std::io::{self, Write}; fn f() { io::stdout(); }", &["motion", "pose"], "only cli and main");
    check("fn f() { eprintln!(\"crate::phonology\") }", &["time"], "only cli and main");
    check("fn f() { println!(\"{:?}\", std::env::args()); chereme::motion::f(); }", &["main"], "");
    check("use std::fs; fn f() { fs::read(\"a\"); }", &["corpus", "cache", "disk"], "");
    check("fn f() { std::fs::read(\"a\"); }", &["corpus", "library"], "only cli and main");
    check("use std::{collections::HashMap, io::Write, fmt, time::Duration};", &["time"], "");
}
