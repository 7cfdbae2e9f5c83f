//! Kinematic profiles of signs as they were: `tests/golden/profiles`, 30 frames a second, compared with a tolerance.
//!
//! `UPDATE=1 cargo test` writes them anew; look at what changed with `chereme profile old.csv new.csv -o compare.svg`.

use crate::signing::{perform_with, sign, signs_of};
use chereme::format::csv;
use chereme::motion::curve::{Measure, Profile, Reference, of_clip};
use chereme::motion::difference::{Tolerance, compare};
use chereme::motion::easing::Easing;
use chereme::motion::point;
use chereme::phonology::Sign;
use chereme::synthesis::Options;
use chereme::time::Fps;
use std::collections::BTreeSet;
use std::fs;
use std::path::{Path, PathBuf};

/// Wrist height and speed from the floor.
const SIGNS: [&str; 10] =
    ["BOL", "PENSER", "CHIEN", "CLAIR", "DONNER", "MAISON", "ESCARGOT", "PUNIR", "WEEK-END", "LSF"];
const POINTING: &str = include_str!("../suite/profile/pointing-up.sign");

fn tolerance(measure: Measure) -> Tolerance {
    match measure {
        Measure::X | Measure::Y | Measure::Z | Measure::Position | Measure::Height => Tolerance::Absolute(0.005),
        Measure::Speed => Tolerance::Absolute(0.05),
        Measure::Acceleration | Measure::Jerk => Tolerance::OfRange(0.05),
    }
}

fn profile(sign: &Sign, easing: Easing, name: &str, reference: Reference, measures: &[Measure]) -> Profile {
    let options = Options { fps: Fps::new(30.0).unwrap(), easing, ..Options::default() };
    let track = perform_with(sign, &options).track;
    let points = point::matching(track.clip.skeleton(), name);
    of_clip(&track.clip, &points, reference, measures).unwrap().with_phases(track.phases("RH Phase"))
}

/// Every golden profile's name and what it is now.
fn profiles() -> Vec<(String, Profile)> {
    let lsf = signs_of("lsf");
    let named = |name: &str| lsf.iter().find(|s| s.name == name).unwrap_or_else(|| panic!("{name} is gone"));
    let wrist =
        |s: &Sign| profile(s, Easing::default(), "RightHand", Reference::Floor, &[Measure::Height, Measure::Speed]);
    let mut all: Vec<(String, Profile)> = SIGNS.iter().map(|n| ((*n).to_owned(), wrist(named(n)))).collect();
    all.push(("POINTING-UP".to_owned(), wrist(&sign(POINTING))));
    for easing in [Easing::Linear, Easing::Cosine, Easing::default()] {
        let measures = [Measure::Position, Measure::Speed];
        let tip = profile(named("DODO"), easing, "RightHandIndexTip", Reference::Wrist, &measures);
        all.push((format!("DODO-{easing}"), tip));
    }
    all
}

#[test]
fn signs_move_as_they_did() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/golden/profiles");
    let mut wrong = Vec::new();
    let mut known = BTreeSet::new();
    for (name, found) in profiles() {
        let path = folder.join(format!("{name}.csv"));
        known.insert(path.clone());
        if std::env::var_os("UPDATE").is_some() {
            fs::create_dir_all(&folder).unwrap();
            fs::write(&path, csv::write(&found, 3)).unwrap();
            continue;
        }
        let Ok(bytes) = fs::read(&path) else {
            wrong.push(format!("{name}: there is no golden profile; UPDATE=1 writes it"));
            continue;
        };
        let golden = csv::read(&bytes).unwrap_or_else(|e| panic!("{}: {e}", path.display()));
        let comparison = compare(&golden, &found, tolerance).unwrap_or_else(|e| panic!("{name}: {e}"));
        wrong.extend(comparison.durations.map(|(then, now)| format!("{name}: lasts {now} instead of {then}")));
        wrong.extend(comparison.differences.iter().filter(|d| d.is_fault()).map(|d| format!("{name}: {d}")));
    }
    let there: BTreeSet<PathBuf> = fs::read_dir(&folder).unwrap().map(|e| e.unwrap().path()).collect();
    wrong.extend(there.difference(&known).map(|path| format!("{}: of no sign that is compared", path.display())));
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}
