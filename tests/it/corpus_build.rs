//! A corpus's cache: what is written is read again, damage is seen, only what changed is made, and a build that is killed
//! leaves the old cache or the new one.

use crate::cli::{Folder, run};
use crate::corpus_recordings::{RIG, wave, wave_bvh};
use chereme::avatar;
use chereme::body::signer::Signer;
use chereme::corpus::cache::{Cache, Entry, Frames, Head, SourceFile, Writer, disk};
use chereme::corpus::files::{Files, Stamp};
use chereme::corpus::library::{Library, Tally, vocabulary_of};
use chereme::corpus::manifest::listing;
use chereme::diagnostics::{Error, Source};
use chereme::motion::clip::{Clip, Frame};
use chereme::motion::pose::LocalPose;
use chereme::tier::Tier;
use chereme::time::{Fps, Seconds};
use glam::{DQuat, DVec3};
use proptest::prelude::*;
use std::collections::BTreeMap;
use std::fs;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::sync::{Arc, LazyLock};
use std::time::{Duration, Instant};

static SIGNER: LazyLock<Signer> = LazyLock::new(|| avatar::signer().unwrap());

fn entry(name: &str, tiers: Vec<Tier>) -> Entry {
    let motion = SourceFile { path: format!("{name}.bvh"), stamp: Stamp { size: 5, modified_ns: 7 }, hash: 9 };
    let mut entry = Entry::new(name, motion.clone(), 11);
    (entry.annotations, entry.tiers, entry.fps) = (vec![motion], tiers, Fps::new(55.32).unwrap());
    (entry.begins, entry.warnings) = (Seconds(0.25), vec!["odd".to_owned()]);
    entry
}

fn cache_of(recordings: &[(Entry, Clip)], index: &[u8]) -> Vec<u8> {
    let mut writer = Writer::new(Vec::new(), Head { program: "test".into(), rig: 3 }).unwrap();
    for (entry, clip) in recordings {
        writer.add(entry.clone(), &Frames::of(clip).unwrap()).unwrap();
    }
    writer.finish(index).unwrap()
}

prop_compose! {
    fn turn()(axis in prop::array::uniform3(-1.0..1.0f64), angle in -3.0..3.0f64) -> DQuat {
        DQuat::from_scaled_axis(DVec3::from(axis).try_normalize().unwrap_or(DVec3::X) * angle)
    }
}

/// Clips in which some joints move and others do not.
fn clips() -> impl Strategy<Value = Clip> {
    let moved = prop::collection::vec((0..58u16, prop::collection::vec(turn(), 6)), 0..5);
    (1..6usize, moved, prop::array::uniform3(-2.0..2.0f64), 0.0..1.0f32).prop_map(|(frames, moved, root, weight)| {
        let frame = |at: usize| {
            let mut pose = LocalPose::rest(&RIG);
            pose.root_model = DVec3::from(root);
            moved.iter().for_each(|(id, turns)| pose.rotations[usize::from(*id)] = turns[at]);
            Frame { pose, weights: vec![weight * at as f32, 0.5] }
        };
        let morphs = Arc::new(vec!["a".to_owned(), "b".to_owned()]);
        Clip::new(RIG.clone(), Fps::new(55.32).unwrap(), morphs, (0..frames).map(frame).collect()).unwrap()
    })
}

prop_compose! {
    fn tiers()(values in prop::collection::vec((0.0..9.0f64, 0.0..2.0f64, any::<String>()), 0..4)) -> Vec<Tier> {
        let mut tier = Tier::new("RH Gloss");
        values.iter().for_each(|(start, long, label)| tier.push(Seconds(*start), Seconds(start + long), label, "test"));
        vec![tier]
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 32, ..ProptestConfig::default() })]

    #[test]
    fn what_is_written_is_read_again(clips in prop::collection::vec((clips(), tiers()), 0..4), index in any::<Vec<u8>>()) {
        let all: Vec<(Entry, Clip)> =
            clips.into_iter().enumerate().map(|(at, (clip, tiers))| (entry(&format!("é{at}"), tiers), clip)).collect();
        let cache = Cache::from_bytes(cache_of(&all, &index)).unwrap();
        prop_assert_eq!(cache.index(), &index[..]);
        prop_assert_eq!(cache.entries().len(), all.len());
        for (read, (entry, clip)) in cache.entries().iter().zip(&all) {
            prop_assert_eq!((&read.name, &read.tiers, &read.motion), (&entry.name, &entry.tiers, &entry.motion));
            prop_assert_eq!((&read.warnings, read.begins, read.frame_count()), (&entry.warnings, entry.begins, clip.frames().len()));
            let again = cache.clip(read, clip.skeleton(), clip.morphs()).unwrap();
            for (a, b) in again.frames().iter().zip(clip.frames()) {
                prop_assert!(a.pose.root_model.distance(b.pose.root_model) < 1e-6);
                let turned = a.pose.rotations.iter().zip(&b.pose.rotations).map(|(a, b)| 1.0 - a.dot(*b).abs());
                prop_assert!(turned.fold(0.0, f64::max) < 1e-12);
                prop_assert_eq!(&a.weights, &b.weights);
            }
        }
    }

    #[test]
    fn any_bytes_are_a_cache_or_an_error(bytes in any::<Vec<u8>>(), at in any::<prop::sample::Index>(), with in any::<[u8; 8]>()) {
        let _ = Cache::from_bytes(bytes);
        let mut good = cache_of(&[(entry("a", vec![]), wave(3, 0))], b"index");
        let at = at.index(good.len() - 8);
        let same = good[at..at + 8] == with;
        good[at..at + 8].copy_from_slice(&with);
        prop_assert_eq!(is_whole(good), same);
    }
}

/// Whether a cache opens, and all its recordings too.
fn is_whole(bytes: Vec<u8>) -> bool {
    Cache::from_bytes(bytes).is_ok_and(|cache| cache.entries().iter().all(|entry| cache.frames(entry).is_ok()))
}

#[test]
fn each_changed_bit_and_each_cut_is_seen() {
    let good =
        cache_of(&[(entry("a", vec![Tier::new("RH Gloss")]), wave(2, 0)), (entry("b", vec![]), wave(1, 1))], b"i");
    assert!(is_whole(good.clone()));
    for at in 0..good.len() {
        let mut bad = good.clone();
        bad[at] ^= 1 << (at % 8);
        assert!(!is_whole(bad), "byte {at} of {}", good.len());
        assert!(!is_whole(good[..at].to_vec()), "cut at {at}");
    }
    assert!(!is_whole([&good[..], b"x"].concat()));
}

/// Files in memory, each with a time.
#[derive(Default, Clone)]
struct Memory(BTreeMap<PathBuf, (Vec<u8>, u64)>);

impl Memory {
    fn set(&mut self, path: &str, text: &str, modified_ns: u64) {
        self.0.insert(PathBuf::from(path), (text.as_bytes().to_vec(), modified_ns));
    }
}

impl Files for Memory {
    fn read(&self, path: &Path) -> Result<Vec<u8>, Error> {
        let found = self.0.get(path).map(|(bytes, _)| bytes.clone());
        found.ok_or_else(|| Error::new(format!("there is no file `{}`", path.display())))
    }

    fn stamp(&self, path: &Path) -> Option<Stamp> {
        self.0.get(path).map(|(bytes, modified_ns)| Stamp { size: bytes.len() as u64, modified_ns: *modified_ns })
    }
}

fn corpus(tiers: &str, skip: usize) -> String {
    format!(
        "version: 1\nlicence: CC0\ncredit: nobody\nskeletons: {{own: {{unit: cm, skip_frames: {skip}}}}}\n\
         defaults: {{skeleton: own}}\n{tiers}recordings:\n- {{name: a, motion: a.bvh, gloss: A, hand: right}}\n\
         - {{name: b, motion: b.bvh, span: [0.1, 0.2]}}\n- {{name: c, motion: c.bvh}}\n"
    )
}

fn open(text: &str, files: &Memory, folder: &Path) -> (Library, Tally) {
    let listing = listing(Source::new("corpus.yaml", text), Path::new("/c"), files).unwrap();
    Library::open(listing, &SIGNER, files, folder).unwrap()
}

fn three() -> Memory {
    let mut files = Memory::default();
    for (at, name) in ["a", "b", "c"].iter().enumerate() {
        files.set(&format!("/c/{name}.bvh"), &wave_bvh(30, at), 1);
    }
    files
}

#[test]
fn only_what_changed_is_made() {
    let folder = Folder::new("corpus-changes");
    let mut files = three();
    let made = |files: &Memory, text: &str| {
        let (library, tally) = open(text, files, &folder.0);
        (tally.made, tally.kept, tally.failed, library.len())
    };
    assert_eq!(made(&files, &corpus("", 0)), (3, 0, 0, 3));
    assert_eq!(made(&files, &corpus("", 0)), (0, 3, 0, 3));
    let (library, _) = open(&corpus("", 0), &files, &folder.0);
    assert_eq!((library.take(0).name.as_str(), library.find("b")), ("a", Some(1)));
    let vocabulary = vocabulary_of(library.listing(), &SIGNER).unwrap();
    assert_eq!(library.index(&vocabulary).recordings().len(), library.len());
    // Frames whose instants lie within the span: the sixth to the twelfth at 60 a second.
    assert_eq!((library.entry(1).frame_count(), library.entry(1).begins), (7, Seconds(0.1)));
    let gloss = &library.tiers(0)[0];
    assert_eq!((gloss.name.as_str(), gloss.values()[0].label.as_str()), ("RH Gloss", "A"));
    // What nobody annotated was measured.
    assert!(library.tiers(0).iter().any(|tier| tier.name == "RH Phase"));
    let forearm = |clip: &Clip| {
        let model = clip.frames()[9].pose.to_model(clip.skeleton());
        let at = |name: &str| model.position(clip.skeleton().joint(name).unwrap());
        at("RightHand") - at("RightForeArm")
    };
    assert!(forearm(&library.clip(2).unwrap()).angle_between(forearm(&wave(30, 2))) < 0.01);
    files.set("/c/b.bvh", &wave_bvh(30, 7), 2);
    assert_eq!(made(&files, &corpus("", 0)), (1, 2, 0, 3));
    // Another time, and the same content; then what is said of tiers, which leaves motions as they are.
    files.set("/c/b.bvh", &wave_bvh(30, 7), 3);
    assert_eq!(made(&files, &corpus("", 0)), (0, 3, 0, 3));
    assert_eq!(made(&files, &corpus("tiers: {x: RH Gloss}\n", 0)), (0, 3, 0, 3));
    assert_eq!(made(&files, &corpus("", 1)), (3, 0, 0, 3));
    // A recording fewer.
    let two = corpus("", 1).replace("- {name: c, motion: c.bvh}\n", "");
    assert_eq!(made(&files, &two), (0, 2, 0, 2));
}

#[test]
fn a_file_that_changes_within_a_tick_of_the_clock_is_seen() {
    let folder = Folder::new("corpus-tick");
    let mut files = three();
    open(&corpus("", 0), &files, &folder.0);
    // The cache's own time is now: a source as new as that may have changed again without another time or size.
    files.set("/c/a.bvh", &wave_bvh(30, 0), u64::MAX);
    assert_eq!(open(&corpus("", 0), &files, &folder.0).1.kept, 3);
    let text = wave_bvh(30, 0);
    let digit = text.rfind('1').unwrap();
    files.set("/c/a.bvh", &format!("{}2{}", &text[..digit], &text[digit + 1..]), u64::MAX);
    assert_eq!(open(&corpus("", 0), &files, &folder.0).1.made, 1);
}

#[test]
fn faulty_recordings_are_left_out_until_they_are_mended() {
    let folder = Folder::new("corpus-faulty");
    let mut files = three();
    files.0.remove(Path::new("/c/a.bvh"));
    files.set("/c/b.bvh", "HIERARCHY\nROOT\n", 1);
    let (library, tally) = open(&corpus("", 0), &files, &folder.0);
    assert_eq!((tally.made, tally.failed, library.len()), (1, 2, 1));
    assert_eq!(library.take(0).name, "c");
    let told: Vec<&str> = tally.findings.iter().map(|found| found.diagnostic.message.as_str()).collect();
    assert!(told.len() == 2 && told[0].contains("no file `/c/a.bvh`"), "{told:?}");
    assert_eq!(tally.findings[1].source.name, "/c/b.bvh");
    let (_, again) = open(&corpus("", 0), &files, &folder.0);
    assert_eq!((again.made, again.kept, again.failed), (0, 1, 2));
    files.set("/c/a.bvh", &wave_bvh(10, 0), 1);
    let (library, tally) = open(&corpus("", 0), &files, &folder.0);
    assert_eq!((tally.made, tally.kept, tally.failed, library.len()), (1, 1, 1, 2));
}

#[test]
fn damaged_and_foreign_caches_are_made_anew_and_closed_folders_are_done_without() {
    let folder = Folder::new("corpus-damaged");
    let files = three();
    open(&corpus("", 0), &files, &folder.0);
    let path = folder.0.join("corpus.cache");
    let good = fs::read(&path).unwrap();
    for (at, made) in [(good.len() - 5, 3), (good.len() - 100, 3), (20, 0)] {
        let mut bad = good.clone();
        bad[at] ^= 4;
        fs::write(&path, bad).unwrap();
        let (library, tally) = open(&corpus("", 0), &files, &folder.0);
        assert_eq!(tally.made, made, "damage at {at}");
        // Damage among the frames is seen where they are read, and mended where the recording is made again.
        assert_eq!(library.clip(0).is_ok(), made == 3);
    }
    let damaged = disk::open(&folder.0).unwrap();
    let listed = listing(Source::new("corpus.yaml", corpus("", 0)), Path::new("/c"), &files).unwrap();
    let builder = chereme::corpus::build::Builder::new(&listed, &SIGNER, &files, Some(&damaged));
    assert!(!builder.make(&listed.takes[0]).kept && builder.make(&listed.takes[1]).kept);
    fs::write(&path, b"CHERCRPS of another program").unwrap();
    assert_eq!(open(&corpus("", 0), &files, &folder.0).1.made, 3);
    assert_eq!(fs::read(&path).unwrap(), good);
    // A folder that cannot be made, because a file has its name.
    let (library, tally) = open(&corpus("", 0), &files, &path.join("inside"));
    assert!(tally.unwritten.is_some() && tally.made == 3);
    assert_eq!(library.clip(1).unwrap().frames().len(), 7);
}

/// A pseudo-random sequence, the same every time (Knuth's linear congruence).
struct Chance(u64);

impl Chance {
    fn below(&mut self, bound: u64) -> u64 {
        self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 33) % bound.max(1)
    }
}

/// Kills builds at random instants; `CHEREME_KILLS` says how many (tools/kill_build.sh: a hundred).
#[test]
fn a_build_that_is_killed_leaves_the_old_cache_or_the_new_one() {
    let kills: u64 = std::env::var("CHEREME_KILLS").ok().and_then(|n| n.parse().ok()).unwrap_or(10);
    let folder = Folder::new("corpus-killed");
    for at in 0..12 {
        folder.write(&format!("{at}.bvh"), &wave_bvh(90, at));
    }
    let manifest = |skip: usize| {
        let recordings: String =
            (0..12).map(|at| format!("- {{name: r{at}, motion: {at}.bvh, gloss: G{at}}}\n")).collect();
        format!(
            "version: 1\nskeletons: {{own: {{unit: cm, skip_frames: {skip}}}}}\ndefaults: {{skeleton: own}}\nrecordings:\n{recordings}"
        )
    };
    let cache = folder.0.join(".chereme/corpus.cache");
    let build = || {
        let done = run(&folder.0, &["corpus", "build", "-q"], "");
        assert_eq!(done.code, 0, "{}", done.err);
        fs::read(&cache).unwrap()
    };
    let began = Instant::now();
    let undisturbed: Vec<Vec<u8>> = (0..2)
        .map(|skip| {
            folder.write("corpus.yaml", &manifest(skip));
            build()
        })
        .collect();
    assert_ne!(undisturbed[0], undisturbed[1]);
    let lasts = u64::try_from(began.elapsed().as_micros()).unwrap() / 2;
    let (mut chance, mut kill, mut in_time, mut left_over) = (Chance(5), 0, 0, 0);
    // A build that is done before it is killed does not count.
    while in_time < kills {
        assert!(kill < 10 * kills, "most builds are done before they are killed");
        // Each build has all motions to make again.
        let skip = usize::try_from(kill % 2).unwrap();
        folder.write("corpus.yaml", &manifest(skip));
        let mut child = Command::new(env!("CARGO_BIN_EXE_chereme"))
            .args(["corpus", "build", "-q"])
            .current_dir(&folder.0)
            .stdout(Stdio::null())
            .stderr(Stdio::null())
            .spawn()
            .unwrap();
        std::thread::sleep(Duration::from_micros(chance.below(lasts)));
        child.kill().unwrap();
        in_time += u64::from(!child.wait().unwrap().success());
        let names = || fs::read_dir(folder.0.join(".chereme")).unwrap().map(|e| e.unwrap().file_name());
        left_over += names().count() - 1;
        let now = fs::read(&cache).unwrap();
        assert!(undisturbed.contains(&now), "kill {kill} left a cache that is neither the old nor the new one");
        assert!(build() == undisturbed[skip], "after kill {kill} the build is another one");
        assert_eq!(names().count(), 1, "kill {kill} left files behind");
        kill += 1;
    }
    println!("{in_time} builds killed, {} done before; {left_over} files left over and cleaned", kill - in_time);
}
