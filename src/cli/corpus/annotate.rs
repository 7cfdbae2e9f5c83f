//! `chereme corpus annotate`

use super::super::parallel::Loudness;
use super::super::template::safe;
use super::super::{Failure, files, terminal};
use super::motion::motion_of;
use super::open::{failed, open, signer};
use super::{Named, Opening};
use crate::corpus::annotate::{Annotator, Options};
use crate::format::eaf;
use crate::phonology::{HandshapeInventory, LocationInventory};
use crate::tier::Tier;
use std::path::{Path, PathBuf};

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Of each hand: phases (preparation, stroke, hold, retraction), configuration (the nearest handshape, and how far it is), placement,\norientation, movement. What people annotated stays as it is; the rest is measured. Correct it in ELAN, and name the .eaf in\ncorpus.yaml as an annotation of the recording.\n\nExamples:\n  chereme corpus annotate takes -o tiers/                one .eaf a recording\n  chereme corpus annotate takes --recording eight_3 -o tiers/\n  chereme corpus annotate clip.bvh -o clip.eaf           a file that is in no corpus"
)]
pub(super) struct Annotate {
    #[command(flatten)]
    named: Named,
    /// Where to: a folder (ending in /), or a file for one recording
    #[arg(short, long, value_name = "OUT", required = true)]
    output: PathBuf,
    /// Only these recordings
    #[arg(long, value_name = "NAME", value_delimiter = ',')]
    recording: Vec<String>,
    /// Overwrite files that are there
    #[arg(long)]
    force: bool,
    #[command(flatten)]
    opening: Opening,
}

/// Name, signer, language and tiers of a recording.
type Annotated = (String, String, String, Vec<Tier>);

impl Annotate {
    pub(super) fn run(&self) -> Result<(), Failure> {
        let is_motion = self.named.path.extension().is_some_and(|e| e.eq_ignore_ascii_case("bvh"));
        let all = if is_motion { vec![self.of_file()?] } else { self.of_corpus()? };
        let folder = self.output.to_string_lossy().ends_with(['/', std::path::MAIN_SEPARATOR]) || self.output.is_dir();
        if !folder && all.len() != 1 {
            let n = all.len();
            return Err(Failure::Usage(format!("{n} recordings do not go into one file: end -o in / for a folder")));
        }
        let path = |name: &str| match folder {
            true => self.output.join(format!("{}.eaf", safe(name))),
            false => self.output.clone(),
        };
        for (name, ..) in &all {
            let path = path(name);
            if path.exists() && !self.force {
                return Err(Failure::Usage(format!("{} is there already; --force overwrites it", path.display())));
            }
        }
        for (name, participant, language, tiers) in &all {
            let document = eaf::Document {
                participant: participant.clone(),
                language: language.clone(),
                vocabularies: Vec::new(),
            };
            let text = eaf::write(tiers, &document).map_err(failed)?;
            files::make_folder_of(&path(name))?;
            files::write_whole(&path(name), text.as_bytes())?;
        }
        terminal::err(&format!("{} annotated: {}\n", terminal::count(all.len(), "recording"), self.output.display()));
        Ok(())
    }

    /// A file's motion, measured.
    fn of_file(&self) -> Result<Annotated, Failure> {
        let signer = signer()?;
        let path: &Path = &self.named.path;
        let motion = motion_of(path, &signer)?;
        let places = LocationInventory::builtin();
        let annotator = Annotator::new(&signer, &HandshapeInventory::builtin(), &places);
        let tiers = annotator.annotate(&motion.clip, motion.covers.into(), &Options::default()).tiers();
        let name = path.file_stem().map(|stem| stem.to_string_lossy().into_owned()).unwrap_or_default();
        Ok((name, String::new(), String::new(), tiers))
    }

    fn of_corpus(&self) -> Result<Vec<Annotated>, Failure> {
        let (library, _) = open(&self.named, &self.opening, Loudness::Told)?;
        let language = library.listing().manifest.language.as_ref().map(|l| l.value.clone()).unwrap_or_default();
        if let Some(missing) = self.recording.iter().find(|name| library.find(name).is_none()) {
            return Err(Failure::Faults(Some(format!("the corpus has no recording {missing}"))));
        }
        let wanted = |at: &usize| self.recording.is_empty() || self.recording.contains(&library.take(*at).name);
        let one = |at: usize| {
            let take = library.take(at);
            let signer = take.signer.clone().unwrap_or_default();
            (take.name.clone(), signer, language.clone(), library.tiers(at).to_vec())
        };
        Ok((0..library.len()).filter(wanted).map(one).collect())
    }
}
