//! The motions of a command line, measured: signs are synthesized, profiles are read.

use super::super::signs::Finder;
use super::super::{Failure, Sources, files, terminal, world};
use super::{ProfileArgs, Wanted, letters, points};
use crate::avatar;
use crate::diagnostics::Error;
use crate::format::profile_plot::Motion;
use crate::format::{bvh, csv};
use crate::motion::clip::Clip;
use crate::motion::curve::{Curve, Measure, Profile, Reference, of_clip};
use crate::motion::point::Point;
use crate::phonology::Sign;
use crate::synthesis::{Options, Performance, synthesize};
use crate::time::Fps;
use std::path::Path;

const DEFAULT_JOINT: &str = "RightHand";

/// All motions that are asked for.
pub(super) fn motions(args: &ProfileArgs, sources: &Sources, wanted: &Wanted) -> Result<Vec<Motion>, Failure> {
    let mut motions = Vec::new();
    let mut signs = Vec::new();
    let tables = |what: &str| has_extension(what, "csv");
    let grammar = world::grammar(sources)?;
    let words = world::words(&grammar);
    let mut finder = Finder::new(sources, &words, args.language.as_deref());
    for what in &args.what {
        if tables(what) {
            motions.push(table(Path::new(what), wanted)?);
        } else if has_extension(what, "bvh") {
            motions.push(recording(Path::new(what), wanted)?);
        } else {
            signs.extend(finder.find(what)?.into_iter().map(|found| found.sign));
        }
    }
    if finder.faulty {
        return Err(Failure::Faults(None));
    }
    if !signs.is_empty() {
        let signer = avatar::signer().map_err(failed)?;
        for (sign, options) in tries(args, &signs)? {
            let performance = synthesize(sign, &grammar, &signer, &options).map_err(failed)?;
            for warning in &performance.report.warnings {
                terminal::err(&format!("warning: {}: {warning}\n", sign.name));
            }
            let name = match (signs.len(), args.easing.len()) {
                (_, 1) => sign.name.clone(),
                (1, _) => options.easing.to_string(),
                _ => format!("{}, {}", sign.name, options.easing),
            };
            motions.push(performed(name, &performance, wanted)?);
        }
    }
    match motions.is_empty() {
        true => Err(Failure::Faults(Some("there is no motion to measure".into()))),
        false => Ok(motions),
    }
}

/// Each sign under each easing.
fn tries<'a>(args: &ProfileArgs, signs: &'a [Sign]) -> Result<Vec<(&'a Sign, Options)>, Failure> {
    let fps = Fps::new(args.fps).ok_or_else(|| {
        Failure::Usage(format!("--fps {}: frames a second lie above 0 and up to {}", args.fps, Fps::MAX))
    })?;
    let options = |easing| Options { fps, easing, speed: args.speed, ..Options::default() };
    Ok(signs.iter().flat_map(|sign| args.easing.iter().map(move |easing| (sign, options(*easing)))).collect())
}

fn failed(error: Error) -> Failure {
    Failure::Faults(Some(error.to_string()))
}

pub(super) fn has_extension(name: &str, extension: &str) -> bool {
    Path::new(name).extension().is_some_and(|e| e.eq_ignore_ascii_case(extension))
}

/// A profile that was written before, and of it what is asked for.
fn table(path: &Path, wanted: &Wanted) -> Result<Motion, Failure> {
    let profile = read_table(path)?;
    let asked = |c: &&Curve| {
        (wanted.joints.is_empty() || wanted.joints.contains(&c.point))
            && wanted.reference.is_none_or(|r| r == c.reference)
            && (wanted.measures.is_empty() || wanted.measures.contains(&c.measure))
    };
    let curves: Vec<Curve> = profile.curves().iter().filter(asked).cloned().collect();
    if curves.is_empty() {
        let names: Vec<String> = profile.curves().iter().take(4).map(Curve::name).collect();
        let some = if names.is_empty() { "no curve".to_owned() } else { names.join(", ") };
        return Err(Failure::Usage(format!("{}: none of its curves is asked for; it has {some}", path.display())));
    }
    let phases = profile.phases().to_vec();
    let profile = Profile::new(profile.times().to_vec(), curves).map_err(failed)?.with_phases(phases);
    Ok(Motion { name: stem(path), profile, marks: Vec::new() })
}

/// Reads a profile.
pub(super) fn read_table(path: &Path) -> Result<Profile, Failure> {
    let bytes = files::read_bytes(path)?;
    csv::read(&bytes).map_err(|e| Failure::Faults(Some(format!("{}: {e}", path.display()))))
}

/// A recording; its unit is what its skeleton says, else centimetres.
fn recording(path: &Path, wanted: &Wanted) -> Result<Motion, Failure> {
    let bytes = files::read_bytes(path)?;
    let source = bvh::source_of_bytes(&path.to_string_lossy(), &bytes);
    let reading = bvh::read(&bytes).map_err(|faults| {
        terminal::tell(&faults, &source);
        Failure::Faults(Some(format!("{} cannot be read", path.display())))
    })?;
    let usual = bvh::ClipOptions::default();
    let metres_per_unit = bvh::propose_unit(&reading.bvh).map_or(usual.metres_per_unit, |unit| unit.metres_per_unit);
    let converted = bvh::to_clip(&reading.bvh, &bvh::ClipOptions { metres_per_unit, ..usual });
    let clip = converted.map_err(|e| Failure::Faults(Some(format!("{}: {e}", path.display()))))?.clip;
    Ok(Motion { name: stem(path), profile: measured(&clip, wanted)?, marks: Vec::new() })
}

fn stem(path: &Path) -> String {
    path.file_stem().map(|s| s.to_string_lossy().into_owned()).unwrap_or_default()
}

/// A sign as it was signed.
fn performed(name: String, performance: &Performance, wanted: &Wanted) -> Result<Motion, Failure> {
    let profile = measured(&performance.track.clip, wanted)?;
    let left = profile.curves().iter().all(|c| c.point.starts_with("Left"));
    let phases = performance.track.phases(if left { "LH Phase" } else { "RH Phase" });
    // The paper's letters: at rest, at each posture, at rest again.
    let start = phases.first().map(|p| p.start);
    let end = phases.last().map(|p| p.end);
    let instants = start.into_iter().chain(performance.report.keys.iter().copied()).chain(end);
    Ok(Motion { name, marks: letters(instants), profile: profile.with_phases(phases) })
}

/// The curves of a clip that are asked for; else those of the golden profile; else height and speed of the right wrist.
fn measured(clip: &Clip, wanted: &Wanted) -> Result<Profile, Failure> {
    let skeleton = clip.skeleton();
    let unasked = wanted.joints.is_empty() && wanted.reference.is_none() && wanted.measures.is_empty();
    if let Some(golden) = wanted.golden.filter(|_| unasked) {
        let mut curves = Vec::new();
        let mut times = Vec::new();
        for curve in golden.curves() {
            let found = points::points(skeleton, &curve.point)?;
            let profile = of_clip(clip, &found, curve.reference, &[curve.measure]).map_err(failed)?;
            times = profile.times().to_vec();
            curves.extend(profile.curves().iter().cloned());
        }
        return Profile::new(times, curves).map_err(failed);
    }
    let default = [DEFAULT_JOINT.to_owned()];
    let names = if wanted.joints.is_empty() { &default[..] } else { wanted.joints };
    let mut followed: Vec<Point> = Vec::new();
    for name in names {
        let new = points::points(skeleton, name)?;
        followed
            .extend(new.into_iter().filter(|p| followed.iter().all(|known| known.name != p.name)).collect::<Vec<_>>());
    }
    let reference = wanted.reference.unwrap_or(Reference::Floor);
    let usual = match reference {
        Reference::Floor | Reference::Body => [Measure::Height, Measure::Speed],
        Reference::Wrist => [Measure::Position, Measure::Speed],
    };
    let measures = if wanted.measures.is_empty() { &usual[..] } else { wanted.measures };
    of_clip(clip, &followed, reference, measures).map_err(failed)
}
