//! Files and folders of signs.

use super::Failure;
use crate::diagnostics::{Diagnostic, Source};
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
    /// The file; `None` for standard input.
    pub path: Option<PathBuf>,
    /// What is wrong with its bytes.
    pub fault: Option<Diagnostic>,
}

/// Reads files, folders with their folders, and `-` for standard input.
pub(super) fn read_all(paths: &[PathBuf]) -> Result<Vec<Text>, Failure> {
    let mut texts = Vec::new();
    for path in paths {
        if path.as_os_str() == "-" {
            let mut bytes = Vec::new();
            let read = std::io::stdin().lock().take(LARGEST).read_to_end(&mut bytes);
            read.map_err(|e| Failure::Faults(Some(format!("standard input: {e}"))))?;
            let (source, fault) = source_of_bytes("<standard input>", &bytes);
            texts.push(Text { source, path: None, fault });
        } else if path.is_dir() {
            let mut files = Vec::new();
            collect(path, 0, &mut files)?;
            if files.is_empty() {
                let what = format!("there are no .sign files in `{}`", path.display());
                return Err(Failure::Faults(Some(what)));
            }
            for file in files {
                texts.push(read_file(&file)?);
            }
        } else {
            texts.push(read_file(path)?);
        }
    }
    Ok(texts)
}

/// The `.sign` files of a folder, by name; hidden ones and links to folders are passed over.
pub(super) fn collect(folder: &Path, depth: usize, files: &mut Vec<PathBuf>) -> Result<(), Failure> {
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
        } else if path.extension().is_some_and(|e| e.eq_ignore_ascii_case("sign")) {
            files.push(path);
        }
    }
    Ok(())
}

fn read_file(path: &Path) -> Result<Text, Failure> {
    let (source, fault) = source_of_bytes(&path.to_string_lossy(), &read_bytes(path)?);
    Ok(Text { source, path: Some(path.to_owned()), fault })
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
