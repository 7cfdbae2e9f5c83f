//! A motion against its golden profile.

use super::super::{Failure, files, terminal};
use super::output::Outputs;
use super::{ProfileArgs, Wanted, input};
use crate::format::csv;
use crate::format::profile_plot::{Motion, against};
use crate::motion::curve::{Curve, Profile};
use crate::motion::difference;
use std::path::Path;

/// How many differing curves are named.
const MOST_TOLD: usize = 10;

/// The golden profile; `None` where it is yet to be written.
pub(super) fn golden(path: &Path, update: bool) -> Result<Option<Profile>, Failure> {
    match (path.exists(), update) {
        (true, false) => input::read_table(path).map(Some),
        // A golden file that cannot be read any more is replaced.
        (true, true) => Ok(input::read_table(path).ok()),
        (false, true) => Ok(None),
        (false, false) => Err(Failure::Usage(format!("there is no file `{}`; --update writes it", path.display()))),
    }
}

/// Compares a motion with its golden profile, or writes that anew.
pub(super) fn compare(
    args: &ProfileArgs,
    path: &Path,
    golden: Option<&Profile>,
    wanted: &Wanted,
    motions: &[Motion],
    outputs: &Outputs,
) -> Result<(), Failure> {
    let [found] = motions else {
        let message = format!("--against compares one motion, and these are {}", motions.len());
        return Err(Failure::Usage(message));
    };
    let Some(golden) = golden.filter(|_| !args.update) else {
        files::make_folder_of(path)?;
        files::write_whole(path, csv::write(&found.profile, args.decimals).as_bytes())?;
        if !args.quiet {
            terminal::err(&format!("{}: written\n", path.display()));
        }
        return outputs.write(motions, || outputs.figure(motions));
    };
    let golden = asked_of(golden, found, wanted, path)?;
    let comparison = difference::compare(&golden, &found.profile, |m| args.tolerance(m));
    let comparison = comparison.map_err(|e| Failure::Faults(Some(format!("{}: {e}", found.name))))?;
    let name = path.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default();
    let old = Motion { name: format!("{name} (golden)"), profile: golden, marks: Vec::new() };
    let title = args.title.clone().unwrap_or_else(|| format!("{} against {name}", found.name));
    outputs.write(motions, || against(&title, &old, found, |m| args.tolerance(m)))?;
    if let Some((golden, now)) = comparison.durations {
        terminal::err(&format!("{}: lasts {now} instead of {golden}\n", found.name));
    }
    for difference in comparison.differences.iter().filter(|d| d.is_fault()).take(MOST_TOLD) {
        terminal::err(&format!("{}: {difference}\n", found.name));
    }
    if comparison.is_fault() {
        return Err(Failure::Faults(Some(format!("{} differs from {}", found.name, path.display()))));
    }
    if let Some(worst) = comparison.differences.first().filter(|_| !args.quiet) {
        terminal::out(&format!("{} agrees with {}; at most {worst}\n", found.name, path.display()));
    }
    Ok(())
}

/// The golden curves that are asked for: all of them, unless joints, frame or measures are named.
fn asked_of(golden: &Profile, found: &Motion, wanted: &Wanted, path: &Path) -> Result<Profile, Failure> {
    let all = wanted.joints.is_empty() && wanted.reference.is_none() && wanted.measures.is_empty();
    let mut curves: Vec<Curve> = golden.curves().to_vec();
    if !all {
        if let Some(missing) = found.profile.curves().iter().find(|c| golden.like(c).is_none()) {
            let message = format!("{} has no curve {}; --update writes it anew", path.display(), missing.name());
            return Err(Failure::Faults(Some(message)));
        }
        curves.retain(|c| found.profile.like(c).is_some());
    }
    let chosen = Profile::new(golden.times().to_vec(), curves).map_err(|e| Failure::Faults(Some(e.to_string())))?;
    Ok(chosen.with_phases(golden.phases().to_vec()))
}
