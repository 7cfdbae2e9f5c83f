//! `chereme profile` as its users meet it.

use crate::cli::{Folder, run};
use chereme::format::csv;
use std::fs;

const SIGN: &str = "sign UP\n  hands          both mirrored\n  movement       up 10cm\n";
const ARGS: [&str; 5] = ["profile", "up.sign", "--fps", "30", "-q"];

fn with<'a>(more: &[&'a str]) -> Vec<&'a str> {
    ARGS.iter().copied().chain(more.iter().copied()).collect()
}

#[test]
fn profile_prints_peaks_and_writes_tables_and_figures() {
    let folder = Folder::new("profile");
    folder.write("up.sign", SIGN);
    let table = run(&folder.0, &with(&[]), "");
    assert_eq!(table.code, 0, "{}", table.err);
    let lines: Vec<&str> = table.out.lines().collect();
    assert!(lines[0].starts_with("motion  curve") && lines[0].ends_with("lasts"), "{}", table.out);
    assert!(lines[1].contains("RightHand floor height") && lines[2].contains("RightHand floor speed"), "{}", table.out);
    let files =
        with(&["-o", "out/up.csv", "-o", "out/up.svg", "--joint", "*HandIndexTip,nose", "--measure", "speed,x"]);
    let done = run(&folder.0, &files, "");
    assert_eq!((done.code, done.err.as_str()), (0, ""));
    let profile = csv::read(&fs::read(folder.0.join("out/up.csv")).unwrap()).unwrap();
    let names: Vec<String> = profile.curves().iter().map(|c| c.name()).collect();
    assert_eq!(
        names[..3],
        ["LeftHandIndexTip floor speed", "LeftHandIndexTip floor x", "RightHandIndexTip floor speed"]
    );
    assert!(names.len() == 6 && names[5] == "nose floor x", "{names:?}");
    assert!(profile.phases().iter().any(|p| p.name == "stroke"));
    assert!(fs::read_to_string(folder.0.join("out/up.svg")).unwrap().contains("RightHandIndexTip"));
    let again = run(&folder.0, &files, "");
    assert!(again.code == 2 && again.err.contains("--force"), "{}", again.err);
    // What was written is a motion, too.
    let both = run(&folder.0, &["profile", "out/up.csv", "out/up.csv", "--measure", "x", "-o", "-"], "");
    assert!(both.code == 2 && both.err.contains("2 motions do not go into one table"), "{}", both.err);
    let one = run(
        &folder.0,
        &["profile", "out/up.csv", "--joint", "nose", "--measure", "x", "-o", "-", "--decimals", "3"],
        "",
    );
    assert!(one.code == 0 && one.out.starts_with("time [s],nose floor x [m],phase\n0.000,"), "{}{}", one.out, one.err);
}

#[test]
fn profile_overlays_easings() {
    let folder = Folder::new("profile-easings");
    folder.write("up.sign", SIGN);
    let three =
        with(&["--easing", "linear,cosine,sigmoid", "--joint", "RightHand*Tip", "--frame", "wrist", "-o", "10.svg"]);
    let done = run(&folder.0, &three, "");
    assert_eq!(done.code, 0, "{}", done.err);
    let svg = fs::read_to_string(folder.0.join("10.svg")).unwrap();
    assert_eq!(svg.matches("<polyline").count(), 3 * 5 * 2);
    assert!(svg.contains(">cosine<") && svg.contains("position from the wrist (m)"));
}

#[test]
fn profile_compares_with_a_golden_one() {
    let folder = Folder::new("profile-against");
    folder.write("up.sign", SIGN);
    let against = |more: &[&str]| run(&folder.0, &with(&[&["--against", "g.csv"], more].concat()), "");
    let none = against(&[]);
    assert!(none.code == 2 && none.err.contains("--update writes it"), "{}", none.err);
    assert_eq!(against(&["--update", "--measure", "height,speed"]).code, 0);
    assert_eq!(against(&["--tolerance", "0.001"]).code, 0);
    assert_eq!(against(&["--tolerance", "1%", "--measure", "speed"]).code, 0);
    let lacks = against(&["--measure", "jerk"]);
    assert!(lacks.code == 1 && lacks.err.contains("no curve RightHand floor jerk"), "{}", lacks.err);
    folder.write("up.sign", &SIGN.replace("10cm", "14cm duration 0.5s"));
    let differs = against(&["--tolerance", "0.02", "--measure", "height", "-o", "d.svg"]);
    assert_eq!(differs.code, 1, "{}", differs.err);
    assert!(
        differs.err.contains("RightHand floor height at ") && differs.err.contains("UP differs from g.csv"),
        "{}",
        differs.err
    );
    let svg = fs::read_to_string(folder.0.join("d.svg")).unwrap();
    assert!(svg.contains("difference in height (m), tolerance ±0.020") && svg.contains("g (golden)"));
    assert_eq!(against(&["--tolerance", "speed=1,height=1", "--measure", "height", "--joint", "LeftHand"]).code, 1);
    assert_eq!(against(&["--update"]).code, 0);
    assert_eq!(against(&["--tolerance", "0.02"]).code, 0);
    assert!(fs::read_dir(&folder.0).unwrap().all(|e| !e.unwrap().file_name().to_string_lossy().ends_with(".new")));
}

#[test]
fn profile_says_what_it_cannot_do() {
    let folder = Folder::new("profile-faults");
    folder.write("up.sign", SIGN);
    folder.write("bad.bvh", "HIERARCHY\nROOT");
    folder.write("bad.csv", "time [s],A floor x [m]\n0,one\n");
    for (args, code, words) in [
        (with(&["--joint", "RightHnd"]), 2, "did you mean `RightHand`?"),
        (with(&["--joint", "Head", "--frame", "wrist"]), 1, "hangs from no hand"),
        (with(&["--frame", "flor"]), 2, "there are floor, body, wrist"),
        (with(&["--measure", "sped"]), 2, "there is no measure called `sped`"),
        (with(&["-o", "x.png"]), 2, ".svg for a figure"),
        (with(&["--tolerance", "1%"]), 2, "--against"),
        (with(&["--against", "bad.csv", "--tolerance=-1"]), 2, "no tolerance"),
        (vec!["profile", "bad.csv"], 1, "bad.csv: line 2, column 2: `one` is no finite number"),
        (vec!["profile", "up.sign", "--fps", "0"], 2, "--fps"),
        (vec!["profile", "bad.bvh"], 1, "bad.bvh:2:1"),
        (vec!["profile", "none.csv"], 2, "no file"),
        (vec!["profile", "NO-SUCH-SIGN"], 1, "NO-SUCH-SIGN"),
    ] {
        let done = run(&folder.0, &args, "");
        assert_eq!(done.code, code, "{args:?}: {}", done.err);
        assert!(done.err.contains(words), "{args:?}: {}", done.err);
    }
}

#[test]
fn profile_measures_recordings() {
    let folder = Folder::new("profile-bvh");
    let text = "HIERARCHY\nROOT Hips {\n OFFSET 0 0 0\n CHANNELS 1 Yposition\n End Site {\n OFFSET 0 170 0 } }\n\
                MOTION\nFrames: 3\nFrame Time: 0.1\n90\n95\n100\n";
    folder.write("walk.bvh", text);
    let done = run(&folder.0, &["profile", "walk.bvh", "--joint", "Hips,HipsTip", "-o", "-", "--decimals", "3"], "");
    assert_eq!(done.code, 0, "{}", done.err);
    assert!(done.out.starts_with("time [s],Hips floor height [m],Hips floor speed [m/s],HipsTip floor height [m]"));
    assert!(done.out.contains("\n0.100,0.950,0.500,2.650,0.500\n"), "{}", done.out);
}

#[test]
fn profile_measures_signs_made_from_others() {
    let folder = Folder::new("profile-made");
    folder.write(
        "made.sign",
        "language lsf\nsign RUHE\n  placement chest, 20cm away\n\nsign X = RUHE with movement up 10cm\n",
    );
    let done = run(&folder.0, &["profile", "made.sign"], "");
    assert_eq!(done.code, 0, "{}", done.err);
    assert!(done.out.contains("RUHE") && done.out.lines().any(|l| l.starts_with("X ")), "{}", done.out);
}
