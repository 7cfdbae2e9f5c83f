//! The recordings that analyses read: BVH files, and tables of markers.

use super::super::parallel::{Loudness, Progress, in_order, pool};
use super::super::{Failure, files, terminal};
use super::markers;
use super::output::expand;
use crate::diagnostics::{Diagnostic, Source};
use crate::evaluation::kinematics::Movement;
use crate::format::{self, bvh};
use crate::motion::clip::Clip;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// Metres in the units that hands alone are recorded in.
const HAND_UNITS: [f64; 3] = [0.001, 0.01, 1.0];
/// The extents of a hand at rest, metres: from a child's to a large one.
const HAND_M: std::ops::Range<f64> = 0.07..0.45;

/// What a file holds.
pub(super) enum Take {
    /// A motion of joints.
    Clip(String, Arc<Clip>),
    /// Markers of an arm.
    Markers(Movement),
}

/// What files hold, and where a file cannot be used, why: its name and the reason.
type Read = Result<Take, String>;

/// Reads all files and works on each, on all cores, in their order. What cannot be read is told and left out; where nothing
/// can be read, that is a fault.
pub(super) fn each<R: Send>(
    paths: &[PathBuf],
    quiet: bool,
    work: impl Fn(&Take) -> R + Sync,
    mut tell: impl FnMut(R),
) -> Result<(), Failure> {
    let files = expand(paths, &["bvh", "tsv"])?;
    let folders = paths.iter().any(|p| p.is_dir());
    let progress = Progress::of(files.len(), "takes", if quiet { Loudness::Quiet } else { Loudness::Told });
    let (mut read, mut left_out) = (0, 0);
    let one = |path: PathBuf| match take(&path) {
        Ok(take) => Ok(work(&take)),
        Err(why) => Err((path, why)),
    };
    in_order(&pool(None)?, files, one, |result| {
        progress.step();
        match result {
            Ok(result) => {
                read += 1;
                tell(result);
            }
            // A folder has tables that are no recordings.
            Err((path, _)) if folders && path.extension().is_some_and(|e| e.eq_ignore_ascii_case("tsv")) => {}
            Err((_, why)) => {
                left_out += 1;
                progress.say(&format!("chereme: {why}; left out\n"));
            }
        }
    });
    drop(progress);
    match (read, left_out) {
        (0, _) => Err(Failure::Faults(Some("there is no recording that can be read".into()))),
        (_, 0) => Ok(()),
        (_, n) => {
            terminal::err(&format!("{} left out\n", terminal::count(n, "file")));
            Ok(())
        }
    }
}

/// The first fault of a file in one line.
fn located(source: &Source, faults: &[Diagnostic], otherwise: &str) -> String {
    let first = faults.first();
    let (line, column) = source.line_column(first.map_or(0, |f| f.span.start));
    format!("{}:{line}:{column}: {}", source.name, first.map_or(otherwise, |f| f.message.as_str()))
}

fn take(path: &Path) -> Read {
    let told = |e: Failure| match e {
        Failure::Faults(Some(why)) | Failure::Usage(why) => why,
        Failure::Faults(None) => format!("{} cannot be read", path.display()),
    };
    let bytes = match path.as_os_str() == "-" {
        true => files::standard_input(None).map_err(told)?.source.text.into_bytes(),
        false => files::read_bytes(path).map_err(told)?,
    };
    let name = path.file_stem().map_or_else(|| "-".into(), |stem| stem.to_string_lossy().into_owned());
    if path.extension().is_some_and(|e| e.eq_ignore_ascii_case("tsv")) {
        let reading = format::markers::read(&bytes).map_err(|faults| {
            located(
                &format::text::source_of_bytes(&path.to_string_lossy(), &bytes),
                &faults,
                "it is no table of markers",
            )
        })?;
        let arm = markers::arm(&name, &reading.markers);
        return arm.map(Take::Markers).map_err(|e| format!("{}: {e}", path.display()));
    }
    let reading = bvh::read(&bytes).map_err(|faults| {
        located(&bvh::source_of_bytes(&path.to_string_lossy(), &bytes), &faults, "it is no BVH file")
    })?;
    let proposed = bvh::propose_unit(&reading.bvh).map(|unit| unit.metres_per_unit);
    let metres_per_unit = proposed.or_else(|| unit_of_hand(&reading.bvh)).ok_or_else(|| {
        format!("{}: the skeleton is as large as neither a person nor a hand, in any unit", path.display())
    })?;
    let options = bvh::ClipOptions { metres_per_unit, roots: bvh::Roots::First };
    let converted = bvh::to_clip(&reading.bvh, &options).map_err(|e| format!("{}: {e}", path.display()))?;
    Ok(Take::Clip(name, Arc::new(converted.clip)))
}

/// The unit in which a hand alone is as large as a hand.
fn unit_of_hand(bvh: &bvh::Bvh) -> Option<f64> {
    let rest = bvh.rest_positions();
    let first = rest.first().copied()?;
    let extent = rest.iter().map(|p| p.distance(first)).fold(0.0, f64::max);
    HAND_UNITS.into_iter().find(|unit| HAND_M.contains(&(extent * unit)))
}
