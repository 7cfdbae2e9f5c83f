//! A stranger's rig that motion is written for: `--rig theirs.bvh`, `--rig theirs.glb`.

use super::super::{Failure, files, terminal};
use crate::body::retarget::names::recognise;
use crate::body::retarget::{Axes, Humanoid, propose_axes, stands, to_theirs};
use crate::body::signer::Signer;
use crate::diagnostics::Error;
use crate::format::{bvh, glb};
use crate::motion::clip::Clip;
use std::path::Path;

/// A rig of somebody else's, with its joints found.
pub(super) struct Theirs {
    humanoid: Humanoid,
    file: File,
    signer: Signer,
}

enum File {
    Bvh { file: bvh::Bvh, metres_per_unit: f64 },
    Glb { bytes: Vec<u8>, rig: glb::Rig },
}

impl Theirs {
    /// Reads a rig, and says what was found of it.
    pub(super) fn read(path: &Path, signer: Signer, quiet: bool) -> Result<Theirs, Failure> {
        let bytes = files::read_bytes(path)?;
        let failed = |e: Error| Failure::Faults(Some(e.context(path.display()).to_string()));
        let is_glb = bytes.starts_with(b"glTF");
        let (file, humanoid) =
            if is_glb { of_glb(bytes, &signer).map_err(failed)? } else { of_bvh(path, &bytes, &signer)? };
        let covers = humanoid.covers();
        if !quiet {
            let has = |both: [bool; 2]| match both {
                [true, true] => "both",
                [false, false] => "none",
                _ => "one",
            };
            terminal::err(&format!(
                "{}: body {}, arms {}, hands {}\n",
                path.display(),
                if covers.body { "found" } else { "not found" },
                has(covers.arms),
                has(covers.hands)
            ));
        }
        Ok(Theirs { humanoid, file, signer })
    }

    /// The extension of the files that this rig is written to.
    pub(super) fn extension(&self) -> &'static str {
        match self.file {
            File::Bvh { .. } => "bvh",
            File::Glb { .. } => "glb",
        }
    }

    /// A motion of our rig on theirs, as a file like theirs.
    pub(super) fn bytes(&self, clip: &Clip) -> Result<Vec<u8>, Error> {
        let theirs = to_theirs(clip, &self.humanoid, &self.signer)?;
        match &self.file {
            File::Bvh { file, metres_per_unit } => {
                bvh::onto(file, &theirs, *metres_per_unit).map(|bvh| bvh::print(&bvh).into_bytes())
            }
            File::Glb { bytes, rig } => rig.write(bytes, &theirs),
        }
    }
}

fn of_glb(bytes: Vec<u8>, signer: &Signer) -> Result<(File, Humanoid), Error> {
    let rig = glb::Rig::read(&bytes)?;
    let joints = recognise(rig.skeleton()).joints;
    // glTF says its axes: Y up, facing +Z.
    let humanoid = Humanoid::new(rig.skeleton(), &joints, Axes::OURS, signer)?;
    Ok((File::Glb { bytes, rig }, humanoid))
}

fn of_bvh(path: &Path, bytes: &[u8], signer: &Signer) -> Result<(File, Humanoid), Failure> {
    let source = bvh::source_of_bytes(&path.to_string_lossy(), bytes);
    let reading = bvh::read(bytes).map_err(|faults| {
        terminal::tell(&faults, &source);
        Failure::Faults(Some(format!("{} cannot be used as a rig", path.display())))
    })?;
    let failed = |e: Error| Failure::Faults(Some(e.context(path.display()).to_string()));
    let metres_per_unit = bvh::propose_unit(&reading.bvh).map_or(0.01, |unit| unit.metres_per_unit);
    let options = bvh::ClipOptions { metres_per_unit, roots: bvh::Roots::First };
    let clip = bvh::to_clip(&reading.bvh, &options).map_err(failed)?.clip;
    let joints = recognise(clip.skeleton()).joints;
    let axes = propose_axes(&clip, &joints);
    let humanoid = Humanoid::standing(clip.skeleton(), &stands(&clip), &joints, axes, signer).map_err(failed)?;
    Ok((File::Bvh { file: reading.bvh, metres_per_unit }, humanoid))
}
