//! A single BVH file as motion of our rig: its joints, unit and axes as they can be told.

use super::super::{Failure, files, terminal};
use super::open::failed;
use crate::body::retarget::{Humanoid, Options, Retargeted, begins_with_t_pose, names, propose_axes, retarget, stands};
use crate::body::signer::Signer;
use crate::corpus::build::rest_of;
use crate::corpus::motion::propose_unit;
use crate::format::bvh;
use std::path::Path;

/// Reads a file's motion; what is odd about it is told.
pub(super) fn motion_of(path: &Path, signer: &Signer) -> Result<Retargeted, Failure> {
    let bytes = files::read_bytes(path)?;
    let source = bvh::source_of_bytes(&path.to_string_lossy(), &bytes);
    let unreadable = || Failure::Faults(Some(format!("{} cannot be used", path.display())));
    let reading = bvh::read(&bytes).map_err(|faults| {
        terminal::tell(&faults, &source);
        unreadable()
    })?;
    terminal::tell(&reading.warnings, &source);
    let any_unit = bvh::ClipOptions { metres_per_unit: 1.0, roots: bvh::Roots::First };
    let joints = names::recognise(bvh::to_clip(&reading.bvh, &any_unit).map_err(failed)?.clip.skeleton()).joints;
    let (metres_per_unit, _) = propose_unit(&reading.bvh, &joints).ok_or_else(|| {
        let what = "its unit of length cannot be told: make a corpus of it (`chereme corpus init`), and say it there";
        Failure::Faults(Some(format!("{}: {what}", path.display())))
    })?;
    let clip = bvh::to_clip(&reading.bvh, &bvh::ClipOptions { metres_per_unit, ..any_unit }).map_err(failed)?.clip;
    let inserted = begins_with_t_pose(&clip);
    let axes = propose_axes(&clip, &joints);
    let humanoid = Humanoid::standing(clip.skeleton(), &stands(&clip), &joints, axes, signer).map_err(failed)?;
    let options = Options { mode: Default::default(), skip_frames: usize::from(inserted), rest: rest_of(signer) };
    retarget(&clip, &humanoid, signer, &options).map_err(failed)
}
