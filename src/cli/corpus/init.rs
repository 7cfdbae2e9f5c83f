//! `chereme corpus init`

use super::super::Failure;
use super::super::files::{make_folder_of, write_whole};
use super::super::parallel::{Loudness, Progress, in_order, pool};
use super::super::terminal::{self, count};
use super::disk::Disk;
use crate::corpus::files::Files;
use crate::corpus::manifest::FILE_NAME;
use crate::corpus::propose::{HeadedTable, propose, seen};
use crate::format::bvh;
use std::fs;
use std::path::{Path, PathBuf};

/// How deep folders may nest.
const DEEPEST: usize = 32;

#[derive(Debug, clap::Args)]
#[command(
    after_help = "It finds motions (.bvh), annotations of the same name beside them (.eaf, .TextGrid, .tsv), and tables (.tsv, .csv) with a\ncolumn of motion files. Joint names, units and axes are guessed, and every guess is told. The recordings are only read.\n\nExamples:\n  chereme corpus init takes\n  chereme corpus init /data/takes -o my/corpus.yaml"
)]
pub(super) struct Init {
    /// The folder of recordings
    #[arg(value_name = "FOLDER")]
    folder: PathBuf,
    /// The file to write; FOLDER/corpus.yaml without it
    #[arg(short, long, value_name = "FILE")]
    output: Option<PathBuf>,
    /// What the corpus is called; the folder's name without it
    #[arg(long)]
    title: Option<String>,
    /// Write over a corpus.yaml that is there
    #[arg(long)]
    force: bool,
}

/// The files of a folder, by what they may be; paths from the folder, with `/`.
#[derive(Default)]
struct Found {
    motions: Vec<String>,
    annotations: Vec<String>,
    tables: Vec<String>,
}

impl Init {
    pub(super) fn run(&self) -> Result<(), Failure> {
        if !self.folder.is_dir() {
            return Err(Failure::Usage(format!("there is no folder `{}`", self.folder.display())));
        }
        let output = self.output.clone().unwrap_or_else(|| self.folder.join(FILE_NAME));
        if output.exists() && !self.force {
            return Err(Failure::Usage(format!("{} is there already; --force overwrites it", output.display())));
        }
        let mut found = Found::default();
        walk(&self.folder, "", 0, &mut found)?;
        if found.motions.is_empty() {
            return Err(Failure::Faults(Some(format!("there are no .bvh files in `{}`", self.folder.display()))));
        }
        let prefix = self.prefix(&output)?;
        let (motions, unreadable) = self.look(&found)?;
        let tables: Vec<HeadedTable> = found.tables.iter().filter_map(|path| self.table(path)).collect();
        let title = self.title.clone().unwrap_or_else(|| self.folder_name());
        let mut proposal = propose(&title, &motions, &found.annotations, &tables);
        let manifest = &mut proposal.manifest;
        for path in manifest.recordings.iter_mut().flat_map(|own| own.annotations.iter_mut().chain([&mut own.motion])) {
            path.value = format!("{prefix}{}", path.value);
        }
        manifest.takes.iter_mut().for_each(|table| table.table.value = format!("{prefix}{}", table.table.value));
        make_folder_of(&output)?;
        write_whole(&output, manifest.to_yaml().as_bytes())?;
        let mut text = format!("{} of {} read\n", count(motions.len(), "motion"), found.motions.len());
        unreadable.iter().for_each(|why| text.push_str(&format!("- left out: {why}\n")));
        proposal.notes.iter().for_each(|note| text.push_str(&format!("- {note}\n")));
        text.push_str(&format!("{} is written; look it over, then: chereme corpus check {0}\n", output.display()));
        terminal::out(&text);
        Ok(())
    }

    /// What stands before paths, so that they lead from the manifest to the folder.
    fn prefix(&self, output: &Path) -> Result<String, Failure> {
        let told = |path: &Path, e: std::io::Error| Failure::Usage(format!("{}: {e}", path.display()));
        let whole = |path: &Path| fs::canonicalize(path).map_err(|e| told(path, e));
        let folder = whole(&self.folder)?;
        make_folder_of(output)?;
        let beside = output.parent().filter(|parent| !parent.as_os_str().is_empty()).unwrap_or(Path::new("."));
        let beside = whole(beside)?;
        let inside = folder.strip_prefix(&beside).map_or(folder.as_path(), |inside| inside);
        let text = inside.to_string_lossy();
        Ok(if text.is_empty() { String::new() } else { format!("{text}/") })
    }

    fn folder_name(&self) -> String {
        let whole = fs::canonicalize(&self.folder).unwrap_or_else(|_| self.folder.clone());
        whole.file_name().map(|name| name.to_string_lossy().into_owned()).unwrap_or_default()
    }

    /// Looks at all motions, on all cores; those that cannot be read are told.
    fn look(&self, found: &Found) -> Result<(Vec<crate::corpus::propose::Seen>, Vec<String>), Failure> {
        let progress = Progress::of(found.motions.len(), "motions", Loudness::Told);
        let (mut motions, mut unreadable) = (Vec::new(), Vec::new());
        let work = |path: &String| {
            let bytes = Disk.read(&self.folder.join(path)).map_err(|e| e.to_string())?;
            seen(path, &bytes).map_err(|faults| {
                let (line, column) = bvh::source_of_bytes(path, &bytes).line_column(faults[0].span.start);
                format!("{path}:{line}:{column}: {}", faults[0].message)
            })
        };
        in_order(&pool(None)?, found.motions.iter().collect(), work, |done| {
            progress.step();
            match done {
                Ok(seen) => motions.push(seen),
                Err(why) => unreadable.push(why),
            }
        });
        Ok((motions, unreadable))
    }

    fn table(&self, path: &str) -> Option<HeadedTable> {
        let bytes = Disk.read(&self.folder.join(path)).ok()?;
        HeadedTable::of(path, &String::from_utf8_lossy(&bytes)).ok()
    }
}

/// The files of a folder and its folders, by name; hidden ones and links to folders are passed over.
fn walk(folder: &Path, inside: &str, depth: usize, found: &mut Found) -> Result<(), Failure> {
    let told = |e: std::io::Error| Failure::Usage(format!("{}: {e}", folder.display()));
    let mut names = Vec::new();
    for entry in fs::read_dir(folder).map_err(told)? {
        // A name that is no UTF-8 cannot be written in a manifest.
        names.extend(entry.map_err(told)?.file_name().into_string());
    }
    names.sort();
    for name in names.iter().filter(|name| !name.starts_with('.')) {
        let (path, shown) = (folder.join(name), format!("{inside}{name}"));
        if path.is_dir() {
            if depth < DEEPEST && !path.is_symlink() {
                walk(&path, &format!("{shown}/"), depth + 1, found)?;
            }
            continue;
        }
        let extension = path.extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default();
        match extension.as_str() {
            "bvh" => found.motions.push(shown),
            "eaf" | "textgrid" => found.annotations.push(shown),
            "tsv" => {
                found.tables.push(shown.clone());
                found.annotations.push(shown);
            }
            "csv" => found.tables.push(shown),
            _ => {}
        }
    }
    Ok(())
}
