//! Where results go: tables and figures, and a table for the eye on standard output.

use super::super::{Failure, files, terminal};
use std::path::{Path, PathBuf};

/// Where results go.
#[derive(Debug, clap::Args)]
pub(super) struct Output {
    /// Where to: a table (.csv), a figure (.svg), or - for the table as CSV on standard output; repeatable
    #[arg(short, long, value_name = "OUT")]
    output: Vec<String>,
    /// Overwrite files that are there
    #[arg(long)]
    force: bool,
    /// Say nothing but results and faults
    #[arg(short, long)]
    pub quiet: bool,
}

/// What one `-o` asks for.
enum Target<'a> {
    Table(&'a Path),
    Figure(&'a Path),
    StandardOutput,
}

impl Output {
    fn targets(&self) -> Result<Vec<Target<'_>>, Failure> {
        let extension = |path: &Path| path.extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default();
        let mut targets = Vec::new();
        for output in &self.output {
            let path = Path::new(output);
            targets.push(match (output.as_str(), extension(path).as_str()) {
                ("-", _) => Target::StandardOutput,
                (_, "csv") => Target::Table(path),
                (_, "svg") => Target::Figure(path),
                _ => {
                    let what = format!("-o {output}: end it in .svg for a figure or .csv for a table");
                    return Err(Failure::Usage(what));
                }
            });
        }
        Ok(targets)
    }

    /// Refuses what cannot be written, before the work begins.
    pub(super) fn check(&self) -> Result<(), Failure> {
        for target in self.targets()? {
            if let Target::Table(path) | Target::Figure(path) = target {
                refuse(path, self.force)?;
            }
        }
        Ok(())
    }

    /// Prints the text (unless the table goes to standard output), and writes table and figure wherever they are asked for.
    pub(super) fn write(
        &self,
        text: &str,
        table: impl Fn() -> String,
        figure: impl Fn() -> String,
    ) -> Result<(), Failure> {
        let targets = self.targets()?;
        if !targets.iter().any(|t| matches!(t, Target::StandardOutput)) {
            terminal::out(text);
        }
        for target in targets {
            match target {
                Target::StandardOutput => terminal::out(&table()),
                Target::Table(path) => self.file(path, &table())?,
                Target::Figure(path) => self.file(path, &figure())?,
            }
        }
        Ok(())
    }

    fn file(&self, path: &Path, text: &str) -> Result<(), Failure> {
        save(path, text.as_bytes())?;
        if !self.quiet {
            terminal::err(&format!("{}\n", path.display()));
        }
        Ok(())
    }
}

/// Refuses a file that is there.
pub(super) fn refuse(path: &Path, force: bool) -> Result<(), Failure> {
    match path.exists() && !force {
        true => Err(Failure::Usage(format!("{} is there already; --force overwrites it", path.display()))),
        false => Ok(()),
    }
}

/// Writes a file whole, in a folder that is made where there is none.
pub(super) fn save(path: &Path, bytes: &[u8]) -> Result<(), Failure> {
    files::make_folder_of(path)?;
    files::write_whole(path, bytes)
}

/// A text by its path; `-` is standard input.
pub(super) fn text(path: &Path) -> Result<crate::diagnostics::Source, Failure> {
    use crate::notation::source_of_bytes;
    if path.as_os_str() == "-" {
        let read = files::standard_input(None)?;
        return match read.fault {
            Some(fault) => Err(told(&[fault], &read.source)),
            None => Ok(read.source),
        };
    }
    let (source, fault) = source_of_bytes(&path.to_string_lossy(), &files::read_bytes(path)?);
    match fault {
        Some(fault) => Err(told(&[fault], &source)),
        None => Ok(source),
    }
}

/// Faults of a text, told; the text cannot be used.
pub(super) fn told(faults: &[crate::diagnostics::Diagnostic], source: &crate::diagnostics::Source) -> Failure {
    terminal::tell(faults, source);
    Failure::Faults(Some(format!("{} cannot be used", source.name)))
}

/// The files of a folder with a certain extension, by name, and of its folders; a file itself; `-` as it is.
pub(super) fn expand(paths: &[PathBuf], extensions: &[&str]) -> Result<Vec<PathBuf>, Failure> {
    const DEEPEST: usize = 32;
    fn collect(folder: &Path, extensions: &[&str], depth: usize, found: &mut Vec<PathBuf>) -> Result<(), Failure> {
        let failed = |e: std::io::Error| Failure::Usage(format!("{}: {e}", folder.display()));
        let mut paths = Vec::new();
        for entry in std::fs::read_dir(folder).map_err(failed)? {
            paths.push(entry.map_err(failed)?.path());
        }
        paths.sort();
        for path in paths {
            let has = |e: &&str| path.extension().is_some_and(|own| own.eq_ignore_ascii_case(e));
            if path.is_dir() && depth < DEEPEST && !path.is_symlink() {
                collect(&path, extensions, depth + 1, found)?;
            } else if extensions.iter().any(has) {
                found.push(path);
            }
        }
        Ok(())
    }
    let mut found = Vec::new();
    for path in paths {
        if !path.is_dir() {
            found.push(path.clone());
            continue;
        }
        let before = found.len();
        collect(path, extensions, 0, &mut found)?;
        if found.len() == before {
            let kinds = extensions.iter().map(|e| format!(".{e}")).collect::<Vec<_>>().join(" or ");
            return Err(Failure::Usage(format!("there are no {kinds} files in `{}`", path.display())));
        }
    }
    Ok(found)
}
