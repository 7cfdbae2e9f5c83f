//! Where profiles go: figures, tables, standard output.

use super::super::{Failure, files, terminal};
use super::input::has_extension;
use super::{Arrangement, ProfileArgs};
use crate::format::profile_plot::{Layout, Motion, figure};
use crate::format::svg::Figure;
use crate::format::{csv, svg};
use std::path::{Path, PathBuf};

/// Where one `-o` points.
enum Target {
    Figure(PathBuf),
    Table(PathBuf),
    StandardOutput,
}

/// All `-o` of a command line.
pub(super) struct Outputs<'a> {
    args: &'a ProfileArgs,
    targets: Vec<Target>,
}

impl Outputs<'_> {
    /// Reads the `-o`s, and refuses files that are there.
    pub(super) fn of(args: &ProfileArgs) -> Result<Outputs<'_>, Failure> {
        let mut targets = Vec::new();
        for output in &args.output {
            let path = PathBuf::from(output);
            targets.push(match output.as_str() {
                "-" => Target::StandardOutput,
                _ if has_extension(output, "svg") => Target::Figure(path),
                _ if has_extension(output, "csv") => Target::Table(path),
                _ => {
                    return Err(Failure::Usage(format!(
                        "-o {output}: end it in .svg for a figure or .csv for a table"
                    )));
                }
            });
        }
        for path in targets.iter().filter_map(Target::path) {
            if path.exists() && !args.force {
                return Err(Failure::Usage(format!("{} is there already; --force overwrites it", path.display())));
            }
        }
        Ok(Outputs { args, targets })
    }

    /// Refuses what does not go into one table.
    pub(super) fn check(&self, motions: &[Motion]) -> Result<(), Failure> {
        let tables = self.targets.iter().any(|t| !matches!(t, Target::Figure(_)));
        match tables && motions.len() > 1 {
            true => Err(Failure::Usage(format!(
                "{} motions do not go into one table: write a figure (-o x.svg), or one table at a time",
                motions.len()
            ))),
            false => Ok(()),
        }
    }

    /// Writes motions everywhere; `figure` draws them.
    pub(super) fn write(&self, motions: &[Motion], figure: impl Fn() -> Figure) -> Result<(), Failure> {
        for target in &self.targets {
            let table = || motions.first().map_or(String::new(), |m| csv::write(&m.profile, self.args.decimals));
            match target {
                Target::StandardOutput => terminal::out(&table()),
                Target::Table(path) => self.file(path, &table())?,
                Target::Figure(path) => self.file(path, &svg::write(&figure()))?,
            }
        }
        Ok(())
    }

    fn file(&self, path: &Path, text: &str) -> Result<(), Failure> {
        files::make_folder_of(path)?;
        files::write_whole(path, text.as_bytes())?;
        if !self.args.quiet {
            terminal::err(&format!("{}\n", path.display()));
        }
        Ok(())
    }

    /// The figure of all motions.
    pub(super) fn figure(&self, motions: &[Motion]) -> Figure {
        let points = motions.first().map_or(0, |m| {
            let mut names: Vec<&str> = m.profile.curves().iter().map(|c| c.point.as_str()).collect();
            names.sort_unstable();
            names.dedup();
            names.len()
        });
        let usual = if motions.len() > 1 && points > 1 { Layout::Columns } else { Layout::Overlaid };
        figure(&self.title(motions), motions, self.args.layout.map_or(usual, Arrangement::layout))
    }

    /// What stands above a figure.
    pub(super) fn title(&self, motions: &[Motion]) -> String {
        if let Some(title) = &self.args.title {
            return title.clone();
        }
        match (self.args.what.as_slice(), motions) {
            // One sign under several easings.
            ([what], [_, _, ..]) => Path::new(what).file_stem().map_or(what.clone(), |s| s.to_string_lossy().into()),
            _ => motions.iter().map(|m| m.name.as_str()).collect::<Vec<_>>().join(", "),
        }
    }
}

impl Target {
    fn path(&self) -> Option<&Path> {
        match self {
            Target::Figure(path) | Target::Table(path) => Some(path),
            Target::StandardOutput => None,
        }
    }
}
