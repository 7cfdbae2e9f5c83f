//! Files and folders of signs.

use super::Failure;
use crate::diagnostics::{Diagnostic, Source};
use crate::notation::formats::Notation;
use crate::notation::source_of_bytes;
use std::fs;
use std::io::Read;
use std::path::{Path, PathBuf};

/// The largest text that is read, in bytes.
const LARGEST: u64 = 64 * 1024 * 1024;
/// How deep folders may nest.
const DEEPEST: usize = 32;

/// A text, where it was read, and whether it is not UTF-8.
pub(super) struct Text {
    /// The text with its name.
    pub source: Source,
    /// The notation that it is in.
    pub notation: Notation,
    /// The file; `None` for standard input.
    pub path: Option<PathBuf>,
    /// The folder that it stands in, as seen from the folder that was asked for; empty for a file that was asked for itself.
    pub folder: PathBuf,
    /// What is wrong with its bytes.
    pub fault: Option<Diagnostic>,
}

/// Reads files, folders with their folders, and `-` for standard input, in any notation.
pub(super) fn read_all(paths: &[PathBuf]) -> Result<Vec<Text>, Failure> {
    read_in(paths, &Notation::ALL)
}

/// Reads files, of folders those in certain notations only, and `-` for standard input.
pub(super) fn read_in(paths: &[PathBuf], notations: &[Notation]) -> Result<Vec<Text>, Failure> {
    let mut texts = Vec::new();
    for path in paths {
        if path.as_os_str() == "-" {
            texts.push(standard_input(None)?);
        } else if path.is_dir() {
            let found = read_folder(path, notations)?;
            if found.is_empty() {
                let what = format!("there are no .sign files in `{}`, nor other notations of signs", path.display());
                return Err(Failure::Faults(Some(what)));
            }
            texts.extend(found);
        } else {
            let bytes = read_bytes(path)?;
            let promised = || Notation::of_extension(&path.to_string_lossy());
            let notation = Notation::of(&path.to_string_lossy(), &bytes).or_else(promised).unwrap_or(Notation::Sign);
            texts.push(text_of(path, &bytes, notation, PathBuf::new()));
        }
    }
    Ok(texts)
}

/// What stands on standard input, in a notation or in the one that it seems to be in.
pub(super) fn standard_input(notation: Option<Notation>) -> Result<Text, Failure> {
    let mut bytes = Vec::new();
    let read = std::io::stdin().lock().take(LARGEST).read_to_end(&mut bytes);
    read.map_err(|e| Failure::Faults(Some(format!("standard input: {e}"))))?;
    let (source, fault) = source_of_bytes("<standard input>", &bytes);
    let notation = notation.unwrap_or_else(|| Notation::of_content(&source.text));
    Ok(Text { source, notation, path: None, folder: PathBuf::new(), fault })
}

/// The texts of a folder and of its folders that are in certain notations, by name.
pub(super) fn read_folder(folder: &Path, notations: &[Notation]) -> Result<Vec<Text>, Failure> {
    let mut files = Vec::new();
    collect(folder, 0, &mut files)?;
    let mut texts = Vec::new();
    for file in files {
        let bytes = read_bytes(&file)?;
        if let Some(notation) = Notation::of(&file.to_string_lossy(), &bytes).filter(|n| notations.contains(n)) {
            let within = file.parent().and_then(|parent| parent.strip_prefix(folder).ok()).map(Path::to_owned);
            texts.push(text_of(&file, &bytes, notation, within.unwrap_or_default()));
        }
    }
    Ok(texts)
}

fn text_of(path: &Path, bytes: &[u8], notation: Notation, folder: PathBuf) -> Text {
    let (source, fault) = source_of_bytes(&path.to_string_lossy(), bytes);
    Text { source, notation, path: Some(path.to_owned()), folder, fault }
}

/// The files of a folder that may hold signs, by name; hidden ones and links to folders are passed over.
fn collect(folder: &Path, depth: usize, files: &mut Vec<PathBuf>) -> Result<(), Failure> {
    let told = |e: std::io::Error| Failure::Usage(format!("{}: {e}", folder.display()));
    let mut paths = Vec::new();
    for entry in fs::read_dir(folder).map_err(told)? {
        paths.push(entry.map_err(told)?.path());
    }
    paths.sort();
    for path in paths {
        let hidden = path.file_name().is_some_and(|n| n.to_string_lossy().starts_with('.'));
        if hidden {
            continue;
        }
        if path.is_dir() {
            if depth < DEEPEST && !path.is_symlink() {
                collect(&path, depth + 1, files)?;
            }
        } else if may_hold_signs(&path) {
            files.push(path);
        }
    }
    Ok(())
}

/// Whether a file's extension is one of those that signs are kept under.
fn may_hold_signs(path: &Path) -> bool {
    Notation::of_extension(&path.to_string_lossy()).is_some()
        || path.extension().is_some_and(|e| e.eq_ignore_ascii_case("txt"))
}

/// Reads a file that is not too large.
pub(super) fn read_bytes(path: &Path) -> Result<Vec<u8>, Failure> {
    let told = |e: std::io::Error| match e.kind() {
        std::io::ErrorKind::NotFound => Failure::Usage(format!("there is no file `{}`", path.display())),
        _ => Failure::Usage(format!("{}: {e}", path.display())),
    };
    let size = fs::metadata(path).map_err(told)?.len();
    if size > LARGEST {
        return Err(Failure::Usage(format!("{}: more than 64 MiB is not read", path.display())));
    }
    fs::read(path).map_err(told)
}

/// Makes the folder that a file is to stand in.
pub(super) fn make_folder_of(path: &Path) -> Result<(), Failure> {
    match path.parent().filter(|f| !f.as_os_str().is_empty()) {
        Some(folder) => {
            let made = fs::create_dir_all(folder);
            made.map_err(|e| Failure::Faults(Some(format!("{}: {e}", folder.display()))))
        }
        None => Ok(()),
    }
}

/// Writes a file whole or not at all: first beside it, then renamed over it.
pub(super) fn write_whole(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    let told = |e: std::io::Error| Failure::Faults(Some(format!("{}: {e}", path.display())));
    // A link stays a link: its target is replaced.
    let target = fs::canonicalize(path).unwrap_or_else(|_| path.to_owned());
    let name = target.file_name().map(|n| n.to_string_lossy().into_owned()).unwrap_or_default();
    let beside = target.with_file_name(format!(".{name}.{}.new", std::process::id()));
    let written = fs::write(&beside, bytes)
        .and_then(|()| match fs::metadata(&target) {
            Ok(old) => fs::set_permissions(&beside, old.permissions()),
            Err(_) => Ok(()),
        })
        .and_then(|()| fs::rename(&beside, &target));
    if written.is_err() {
        let _ = fs::remove_file(&beside);
    }
    written.map_err(told)
}
