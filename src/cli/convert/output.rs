//! Which signs go into which file.

use super::super::Failure;
use super::super::signs::Found;
use super::super::template::{self, Origin, Replacing, Template};
use crate::phonology::Sign;
use std::collections::BTreeMap;
use std::path::PathBuf;

/// Where `-o` points.
pub(super) enum Target {
    /// Standard output.
    StandardOutput,
    /// One file, or with fields several.
    Files(Template),
}

/// Signs that go into one text.
pub(super) struct Group {
    /// The file; `None` for standard output.
    pub path: Option<PathBuf>,
    /// The signs, in their order.
    pub signs: Vec<Sign>,
}

impl Target {
    /// Reads an `-o`.
    pub(super) fn of(output: &str) -> Result<Target, Failure> {
        match output {
            "-" => Ok(Target::StandardOutput),
            _ if output.ends_with(['/', std::path::MAIN_SEPARATOR]) || PathBuf::from(output).is_dir() => {
                let folder = output.trim_end_matches(['/', std::path::MAIN_SEPARATOR]);
                Err(Failure::Usage(format!(
                    "-o {output} is a folder: name the files in it, such as -o '{folder}/{{stem}}.sign'"
                )))
            }
            _ => Ok(Target::Files(Template::of(output)?)),
        }
    }

    /// The texts to write. The signs of one file may share one; where those of several would, `-o` must tell them apart, unless it names one
    /// file for all.
    pub(super) fn groups(&self, found: Vec<Found>, replacing: Replacing) -> Result<Vec<Group>, Failure> {
        let template = match self {
            Target::StandardOutput => {
                let signs = found.into_iter().map(|found| found.sign).collect();
                return Ok(vec![Group { path: None, signs }]);
            }
            Target::Files(template) => template,
        };
        let mut groups: Vec<(Origin, PathBuf, Vec<Sign>)> = Vec::new();
        let mut by_path: BTreeMap<PathBuf, usize> = BTreeMap::new();
        for Found { sign, origin, .. } in found {
            let path = template.path(&origin);
            match by_path.get(&path) {
                Some(at) if !template.has_fields() || groups[*at].0.is_of_one_file_with(&origin) => {
                    groups[*at].2.push(sign);
                }
                // A second group of that name, which the check below tells of.
                Some(_) => groups.push((origin, path, vec![sign])),
                None => {
                    by_path.insert(path.clone(), groups.len());
                    groups.push((origin, path, vec![sign]));
                }
            }
        }
        template::check(groups.iter().map(|(origin, path, _)| (origin, path)), replacing)?;
        Ok(groups.into_iter().map(|(_, path, signs)| Group { path: Some(path), signs }).collect())
    }
}
