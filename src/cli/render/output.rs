//! Where what is rendered goes: files, folders with one file a sign, standard output; and as what.

use super::super::template::safe;
use super::super::{Failure, files, terminal};
use super::Render;
use super::input::Asked;
use super::rig::Theirs;
use crate::avatar;
use crate::diagnostics::Error;
use crate::format::{bvh, csv, eaf, glb, html, profile_plot, svg};
use crate::notation::Vocabulary;
use crate::notation::vocabulary::Names;
use crate::track::{PHASES, Track};
use clap::ValueEnum;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};

/// What a rendered sign is written as.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, clap::ValueEnum)]
pub(super) enum Format {
    /// A page with the avatar, to be opened in a browser
    Html,
    /// Binary glTF 2.0: the avatar with its animation
    Glb,
    /// Biovision motion capture: joints in centimetres, no face
    Bvh,
    /// The tiers as ELAN annotations
    Eaf,
    /// Height and speed of the wrists, a row a frame
    Csv,
    /// Height and speed of the wrists, as a figure
    Svg,
}

impl Format {
    pub(super) fn extension(self) -> &'static str {
        match self {
            Format::Html => "html",
            Format::Glb => "glb",
            Format::Bvh => "bvh",
            Format::Eaf => "eaf",
            Format::Csv => "csv",
            Format::Svg => "svg",
        }
    }

    /// The format of a file's name, by its extension.
    pub(super) fn of_path(path: &Path) -> Result<Format, Failure> {
        let extension = path.extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default();
        if extension == "htm" {
            return Ok(Format::Html);
        }
        let all = Format::value_variants();
        all.iter().copied().find(|f| f.extension() == extension).ok_or_else(|| {
            let known = all.iter().map(|f| format!(".{}", f.extension())).collect::<Vec<_>>().join(", ");
            Failure::Usage(match extension.as_str() {
                "" => format!("-o {}: end it in {known}, or in / for a folder", path.display()),
                other => format!("-o {}: .{other} cannot be written; {known} can", path.display()),
            })
        })
    }

    /// A performance in this format; on another rig than the avatar's where there is one and the format is its own.
    pub(super) fn bytes(
        self,
        asked: &Asked,
        track: &Track,
        vocabulary: &Vocabulary,
        rig: Option<&Theirs>,
    ) -> Result<Vec<u8>, Error> {
        if let Some(rig) = rig.filter(|rig| rig.extension() == self.extension()) {
            return rig.bytes(&track.clip);
        }
        match self {
            Format::Html => html::write(avatar::GLB, track, &asked.page).map(String::into_bytes),
            Format::Glb => glb::write(avatar::GLB, track),
            Format::Bvh => bvh::write(&track.clip, &bvh::Options::default()).map(String::into_bytes),
            Format::Eaf => eaf::write(&track.tiers, &document(asked, vocabulary)).map(String::into_bytes),
            Format::Csv => {
                let motion = profile_plot::Motion::of_track(&asked.name, track)?;
                Ok(csv::write(&motion.profile, csv::DECIMALS).into_bytes())
            }
            Format::Svg => {
                let motion = profile_plot::Motion::of_track(&asked.name, track)?;
                let figure = profile_plot::figure(&asked.name, &[motion], profile_plot::Layout::Overlaid);
                Ok(svg::write(&figure).into_bytes())
            }
        }
    }
}

/// Where one `-o` points.
#[derive(Debug)]
enum Target {
    File(PathBuf, Format),
    Folder(PathBuf),
    StandardOutput,
}

impl Target {
    fn of(output: &str) -> Result<Target, Failure> {
        let path = PathBuf::from(output);
        if output == "-" {
            return Ok(Target::StandardOutput);
        }
        if output.ends_with('/') || output.ends_with(std::path::MAIN_SEPARATOR) || path.is_dir() {
            return Ok(Target::Folder(path));
        }
        let format = Format::of_path(&path)?;
        Ok(Target::File(path, format))
    }
}

/// All outputs of a command line.
pub(super) struct Outputs<'a> {
    targets: Vec<Target>,
    command: &'a Render,
    vocabulary: &'a Vocabulary,
    rig: Option<&'a Theirs>,
}

impl<'a> Outputs<'a> {
    /// Reads the `-o` options. The names of the vocabulary are those that ELAN offers.
    pub(super) fn of(
        command: &'a Render,
        vocabulary: &'a Vocabulary,
        rig: Option<&'a Theirs>,
    ) -> Result<Outputs<'a>, Failure> {
        let targets = command.output.iter().map(|o| Target::of(o)).collect::<Result<Vec<_>, _>>()?;
        if command.format.len() > 1 && targets.iter().any(|t| matches!(t, Target::StandardOutput)) {
            return Err(Failure::Usage("one format goes to standard output: choose it with --format".into()));
        }
        Ok(Outputs { targets, command, vocabulary, rig })
    }

    /// Says what cannot be written, before the work: several things into one file, one file twice, a file that is
    /// there already.
    pub(super) fn check(&self, asked: &[Asked]) -> Result<(), Failure> {
        if asked.len() > 1 && self.targets.iter().any(|t| !matches!(t, Target::Folder(_))) {
            let names: Vec<&str> = asked.iter().take(8).map(|a| a.name.as_str()).collect();
            return Err(Failure::Usage(format!(
                "{} signs do not go into one file: choose with --sign (there are {}{}), one file a sign with -o out/ or --each",
                asked.len(),
                names.join(", "),
                if asked.len() > 8 { ", ..." } else { "" }
            )));
        }
        let mut taken = BTreeSet::new();
        for (path, _) in asked.iter().flat_map(|a| self.files(a)) {
            if path.exists() && !self.command.force {
                return Err(Failure::Usage(format!("{} is there already; --force overwrites it", path.display())));
            }
            let name = path.display().to_string();
            if !taken.insert(path) {
                return Err(Failure::Usage(format!("{name} would be written twice")));
            }
        }
        Ok(())
    }

    /// The files that a performance goes to, with their formats.
    fn files(&self, asked: &Asked) -> Vec<(PathBuf, Format)> {
        let name = safe(&asked.name);
        let of_target = |target: &Target| match target {
            Target::File(path, format) => vec![(path.clone(), *format)],
            Target::Folder(folder) => {
                let formats: BTreeSet<Format> = self.command.format.iter().copied().collect();
                formats.iter().map(|f| (folder.join(format!("{name}.{}", f.extension())), *f)).collect()
            }
            Target::StandardOutput => Vec::new(),
        };
        self.targets.iter().flat_map(of_target).collect()
    }

    /// Writes a performance everywhere; gives the files.
    pub(super) fn write(&self, asked: &Asked, track: &Track) -> Result<Vec<PathBuf>, Failure> {
        let bytes = |format: Format| {
            format.bytes(asked, track, self.vocabulary, self.rig).map_err(|e| Failure::Faults(Some(e.to_string())))
        };
        if self.targets.iter().any(|t| matches!(t, Target::StandardOutput)) {
            for format in &self.command.format {
                terminal::out_bytes(&bytes(*format)?);
            }
        }
        let mut written = Vec::new();
        for (path, format) in self.files(asked) {
            if let Some(folder) = path.parent().filter(|f| !f.as_os_str().is_empty()) {
                let made = std::fs::create_dir_all(folder);
                made.map_err(|e| Failure::Faults(Some(format!("{}: {e}", folder.display()))))?;
            }
            files::write_whole(&path, &bytes(format)?)?;
            written.push(path);
        }
        Ok(written)
    }
}

/// What an EAF file says besides the tiers.
fn document(asked: &Asked, vocabulary: &Vocabulary) -> eaf::Document {
    let all = |kind: &str, names: &Names| (kind.to_owned(), names.ids().map(str::to_owned).collect());
    let mut vocabularies: Vec<(String, Vec<String>)> = vec![
        ("Phase".into(), PHASES.map(str::to_owned).to_vec()),
        all("Configuration", &vocabulary.handshapes),
        all("Placement", &vocabulary.places),
    ];
    vocabularies.extend(vocabulary.nonmanuals.iter().map(|(channel, names)| all(&channel.title(), names)));
    eaf::Document {
        participant: "avatar".into(),
        language: asked.page.language.clone(),
        vocabularies: vocabularies.into_iter().map(|(kind, values)| eaf::Vocabulary { kind, values }).collect(),
    }
}
