//! `chereme evaluate stimuli`: the paper's stimuli as a blind questionnaire.

use super::super::{Failure, Sources, files, gloss, terminal, world};
use super::output::{refuse, save, told};
use crate::avatar;
use crate::body::signer::Signer;
use crate::diagnostics::Error;
use crate::evaluation::stimuli::{Set, Stimulus, Version, blind, key};
use crate::format::{bvh, questionnaire};
use crate::motion::clip::{Clip, Frame};
use crate::motion::pose::LocalPose;
use crate::score::gloss::Settings;
use crate::synthesis::{Options, synthesize_plan};
use crate::track::Track;
use rayon::prelude::*;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// How far a recording's joints may be from the avatar's at rest, metres.
const SAME_RIG: f64 = 0.02;

#[derive(Debug, clap::Args)]
#[command(
    after_help = "Examples:\n  chereme evaluate stimuli placement -o placement.html --key placement-key.csv\n  chereme evaluate stimuli configuration -o page.html --key key.csv --seed 7\n  chereme evaluate stimuli configuration -o page.html --key key.csv --captured LSF=lsf.bvh\n\nThe page is one file that works offline: give it to participants, and let them send back the CSV that it offers at the end. It does not say how a\nstimulus was made; the key does, and stays with you: chereme evaluate ratings answers/ --key key.csv --level good+\nThe paper's captured signs are not published: a captured version is shown where a recording on the avatar's rig is given.\nExit codes: 0 fine, 1 a stimulus cannot be made, 2 wrong usage."
)]
pub(super) struct Stimuli {
    /// The stimuli: placement (BOL at places, pointing) or configuration (table 2)
    #[arg(value_name = "placement|configuration")]
    set: Set,
    /// The page (.html)
    #[arg(short, long, value_name = "PAGE")]
    output: PathBuf,
    /// Where to write what the stimuli are (.csv)
    #[arg(short, long, value_name = "FILE")]
    key: PathBuf,
    /// Which order and names
    #[arg(long, value_name = "N", default_value_t = 0)]
    seed: u64,
    /// A recording (.bvh, on the avatar's rig) as the captured version of an item; repeatable
    #[arg(long, value_name = "ITEM=FILE")]
    captured: Vec<String>,
    /// Overwrite files that are there
    #[arg(long)]
    force: bool,
    /// Say nothing but faults
    #[arg(short, long)]
    quiet: bool,
}

fn failed(error: Error) -> Failure {
    Failure::Faults(Some(error.to_string()))
}

impl Stimuli {
    pub(super) fn run(&self, sources: &Sources) -> Result<(), Failure> {
        if self.output == self.key {
            return Err(Failure::Usage("the key would overwrite the page: give --key another name".into()));
        }
        refuse(&self.output, self.force)?;
        refuse(&self.key, self.force)?;
        let mut sheet = self.set.sheet();
        let signer = avatar::signer().map_err(failed)?;
        let mut recordings = Vec::new();
        for captured in &self.captured {
            let Some((item, file)) = captured.split_once('=') else {
                return Err(Failure::Usage(format!("--captured {captured}: write it as ITEM=FILE.bvh")));
            };
            if sheet.with_captured(item).is_none() {
                let what = format!("--captured {item}: there is no such item; there are {}", sheet.items().join(", "));
                return Err(Failure::Usage(what));
            }
            recordings.push(recording(Path::new(file), &signer)?);
        }
        let synthesized = sheet.stimuli.len() - recordings.len();
        let mut tracks = self.synthesized(&sheet.stimuli[..synthesized], sources, &signer)?;
        tracks.extend(recordings);
        let blind = blind(self.set, &sheet, self.seed);
        let named: Vec<(&str, &Track)> = blind.names.iter().map(String::as_str).zip(&tracks).collect();
        // In the order of names, which says nothing.
        let mut sorted = named;
        sorted.sort_by_key(|(name, _)| *name);
        let page = questionnaire::write(avatar::GLB, &sorted, &blind.page).map_err(failed)?;
        save(&self.output, page.as_bytes())?;
        save(&self.key, key(&sheet.stimuli, &blind.names).as_bytes())?;
        self.tell(&sheet.stimuli);
        Ok(())
    }

    /// The motions of gloss lines, on all cores.
    fn synthesized(&self, stimuli: &[Stimulus], sources: &Sources, signer: &Signer) -> Result<Vec<Track>, Failure> {
        let grammar = world::grammar(sources)?;
        let words = world::words(&grammar);
        let lexicon = world::lexicon(sources, &words)?;
        let settings = Settings { language: Some("lsf".into()), ..Settings::default() };
        let mut plans = Vec::new();
        for stimulus in stimuli {
            let reading = gloss::read_line(&stimulus.line, &lexicon, &grammar, &words.vocabulary, &settings);
            if reading.has_faults() {
                return Err(Failure::Faults(Some(format!("the stimulus {} cannot be made", stimulus.line))));
            }
            let easing = match &stimulus.version {
                Version::Synthesized(_, easing) => *easing,
                Version::Captured => Options::default().easing,
            };
            plans.push((reading.plan, Options { easing, ..Options::default() }));
        }
        let one = |(plan, options): &(_, Options)| synthesize_plan(plan, &grammar, signer, options);
        let performed: Vec<_> = plans.par_iter().map(one).collect();
        let mut tracks = Vec::new();
        for (stimulus, performance) in stimuli.iter().zip(performed) {
            let performance = performance.map_err(|e| failed(e.context(&stimulus.line)))?;
            for warning in performance.report.warnings.iter().filter(|_| !self.quiet) {
                terminal::err(&format!("warning: {}: {warning}\n", stimulus.line));
            }
            tracks.push(performance.track);
        }
        Ok(tracks)
    }

    fn tell(&self, stimuli: &[Stimulus]) {
        if self.quiet {
            return;
        }
        let captured = stimuli.iter().filter(|s| s.version == Version::Captured).count();
        let without = match captured {
            0 => ", none captured: the paper's recordings are not published, and no --captured was given".to_owned(),
            n => format!(", {n} captured"),
        };
        terminal::err(&format!(
            "{}: {}{without}\n",
            self.output.display(),
            terminal::count(stimuli.len(), "stimulus").replace("stimuluss", "stimuli")
        ));
        terminal::err(&format!("{}: what they are; keep it from participants\n", self.key.display()));
    }
}

/// A recording on the avatar's rig.
fn recording(path: &Path, signer: &Signer) -> Result<Track, Failure> {
    let bytes = files::read_bytes(path)?;
    let reading =
        bvh::read(&bytes).map_err(|faults| told(&faults, &bvh::source_of_bytes(&path.to_string_lossy(), &bytes)))?;
    let options = bvh::ClipOptions::default();
    let clip = bvh::to_clip(&reading.bvh, &options).map_err(|e| failed(e.context(path.display())))?.clip;
    let clip = on_rig(&clip, signer).map_err(|e| failed(e.context(path.display())))?;
    Ok(Track { clip, tiers: Vec::new() })
}

/// The same motion on the avatar's joints, which must be the recording's.
fn on_rig(clip: &Clip, signer: &Signer) -> Result<Clip, Error> {
    let (rig, theirs) = (&signer.skeleton, clip.skeleton());
    let mut joints = Vec::new();
    for id in rig.ids() {
        let name = &rig[id].name;
        let Some(own) = theirs.find(name) else { continue };
        let apart = (rig.offset(id) - theirs.offset(own)).length();
        if rig[id].parent.is_some() && apart > SAME_RIG {
            return Err(Error::new(format!(
                "the joint {name} is {:.0} cm from where the avatar's is: the recording is not on the avatar's rig",
                100.0 * apart
            )));
        }
        joints.push((id, own));
    }
    for needed in ["Hips", "RightArm", "RightForeArm", "RightHand", "RightHandIndex1"] {
        rig.joint(needed).and_then(|_| theirs.joint(needed))?;
    }
    let frame = |frame: &Frame| {
        let mut pose = LocalPose::rest(rig);
        pose.root_model = frame.pose.root_model;
        joints.iter().for_each(|(id, own)| pose.set(*id, frame.pose.rotation(*own)));
        Frame { pose, weights: Vec::new() }
    };
    let frames = clip.frames().iter().map(frame).collect();
    let made = Clip::new(Arc::clone(rig), clip.fps(), Arc::new(Vec::new()), frames);
    made.ok_or_else(|| Error::new("the recording has no frame"))
}
