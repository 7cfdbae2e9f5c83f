//! `chereme corpus` as its users meet it.

use crate::cli::{Folder, run};
use crate::corpus_recordings::{hand_bvh, wave_bvh};
use crate::shared::shared;
use std::fs;

/// Takes of hands with a table, bodies with Mixamo's prefix, one with a T-pose put in, one that is broken.
fn takes(name: &str) -> Folder {
    let folder = Folder::new(name);
    folder.write("hands/index.tsv", "file\tgloss\thand\none.bvh\teins\tright\ntwo.bvh\tzwei\tright\n");
    folder.write("hands/one.bvh", &hand_bvh(20));
    folder.write("hands/two.bvh", &hand_bvh(25));
    let mixamo = |text: String| text.replace("JOINT ", "JOINT mixamorig:").replace("ROOT ", "ROOT mixamorig:");
    folder.write("hallo_1.bvh", &mixamo(wave_bvh(30, 0)));
    folder.write("hallo_1.eaf", "<nothing/>");
    let posed = mixamo(wave_bvh(30, 1));
    let (head, rows) = posed.split_at(posed.find("Frame Time").unwrap());
    let (time, rows) = rows.split_once('\n').unwrap();
    let columns = rows.lines().next().unwrap().split(' ').count();
    let bent: String = rows.lines().map(|row| far(row) + "\n").collect();
    let head = head.replace("Frames: 30", "Frames: 31");
    folder.write("posed_2_left.bvh", &format!("{head}{time}\n{}\n{bent}", "0 ".repeat(columns).trim()));
    folder.write("broken.bvh", "HIERARCHY\nROOT\n");
    folder.write(".hidden/x.bvh", "HIERARCHY\n");
    folder
}

/// A row with all angles 40 degrees farther.
fn far(row: &str) -> String {
    let turned = |(at, cell): (usize, &str)| match at {
        0..3 => cell.to_owned(),
        _ => (cell.parse::<f64>().unwrap() + 40.0).to_string(),
    };
    row.split(' ').enumerate().map(turned).collect::<Vec<_>>().join(" ")
}

#[test]
fn init_proposes_what_a_folder_holds() {
    let folder = takes("corpus-init");
    let done = run(&folder.0, &["corpus", "init", "."], "");
    assert_eq!(done.code, 0, "{}", done.err);
    for part in [
        "4 motions of 5 read",
        "left out: broken.bvh:2:",
        "right-hand, 2 files such as hands/one.bvh: 16 of 16 joints known",
        "unit millimetre",
        "hands/index.tsv lists 2 of the motions: motion: file, gloss: gloss, hand: hand",
        "the first frame is a rest pose that was put in, and skipped",
        "glosses of 2 recordings are guessed",
    ] {
        assert!(done.out.contains(part), "{part} is not in\n{}", done.out);
    }
    let written = fs::read_to_string(folder.0.join("corpus.yaml")).unwrap();
    for part in [
        "  - name: hallo_1\n    motion: hallo_1.bvh\n    annotations: [hallo_1.eaf]\n    gloss: hallo\n",
        "    gloss: posed\n",
        "    unit: cm\n",
        "    unit: mm\n",
        "    skip_frames: 1\n",
        "      RightHandIndex1: \"mixamorig:RightHandIndex1\"\n",
        "  - table: hands/index.tsv\n    columns:\n      motion: file\n      gloss: gloss\n      hand: hand\n",
    ] {
        assert!(written.contains(part), "{part} is not in\n{written}");
    }
    let again = run(&folder.0, &["corpus", "init", "."], "");
    assert!(again.code == 2 && again.err.contains("--force"), "{}", again.err);
    assert_eq!(run(&folder.0, &["corpus", "init", ".", "--force"], "").code, 0);
    assert_eq!(fs::read_to_string(folder.0.join("corpus.yaml")).unwrap(), written);
    // Elsewhere, paths lead back.
    assert_eq!(run(&folder.0, &["corpus", "init", "hands", "-o", "up.yaml"], "").code, 0);
    assert!(fs::read_to_string(folder.0.join("up.yaml")).unwrap().contains("- table: hands/index.tsv"));
    assert_eq!(run(&folder.0, &["corpus", "init", ".hidden"], "").code, 0);
    assert_eq!(run(&folder.0, &["corpus", "init", "nowhere"], "").code, 2);
}

#[test]
fn a_proposed_corpus_is_checked_built_and_listed() {
    let folder = takes("corpus-whole");
    fs::remove_file(folder.0.join("hallo_1.eaf")).unwrap();
    assert_eq!(run(&folder.0, &["corpus", "init", "."], "").code, 0);
    let checked = run(&folder.0, &["corpus", "check"], "");
    assert!(
        checked.code == 0 && checked.out == "4 recordings: no faults, 2 warnings\n",
        "{}{}",
        checked.out,
        checked.err
    );
    assert!(checked.err.contains("4 of 4 recordings have no licence"), "{}", checked.err);
    let built = run(&folder.0, &["corpus", "build"], "");
    assert!(
        built.code == 0 && built.out.contains("4 recordings, 0.0 minutes: 4 made, 0 as they were"),
        "{}{}",
        built.out,
        built.err
    );
    let list = run(&folder.0, &["corpus", "list", "--json"], "");
    let rows: serde_json::Value = serde_json::from_str(&list.out).unwrap();
    let of = |at: usize, field: &str| rows[at][field].clone();
    assert_eq!(
        (of(0, "name"), of(0, "gloss"), of(1, "frames_per_second")),
        ("hallo_1".into(), "hallo".into(), 60.0.into())
    );
    assert_eq!(
        (of(2, "name"), of(2, "gloss"), of(2, "tiers")[0].clone()),
        ("one".into(), "eins".into(), "RH Gloss".into())
    );
    // The frame that was put in is skipped.
    assert_eq!(of(1, "seconds"), 0.483);
    let table = run(&folder.0, &["corpus", "list"], "");
    assert!(table.out.lines().count() == 5 && table.out.starts_with("name          gloss"), "{}", table.out);
    // A cache elsewhere leaves the corpus's folder alone.
    fs::remove_dir_all(folder.0.join(".chereme")).unwrap();
    assert_eq!(run(&folder.0, &["corpus", "build", ".", "--cache", "elsewhere/cache"], "").code, 0);
    assert!(!folder.0.join(".chereme").exists() && folder.0.join("elsewhere/cache/corpus.cache").exists());
}

#[test]
fn check_tells_everything_at_once() {
    let folder = takes("corpus-check");
    let jumps = wave_bvh(30, 0)
        .lines()
        .enumerate()
        .map(|(at, line)| if at % 40 == 39 { line.replace("0.", "9.") } else { line.into() })
        .collect::<Vec<String>>()
        .join("\n");
    folder.write("jumps.bvh", &jumps);
    folder.write(
        "corpus.yaml",
        "version: 1\nlicence: CC0\ncredit: us\n\
         skeletons:\n  body: {unit: inch, joints: {RightHand: mixamorig:RightHand, RightFoot: mixamorig:RihgtFoot, Tail: Tail}}\n\
         values: {Configuration: {flat: flat-Q}}\n\
         recordings:\n\
         - {name: a, motion: no.bvh}\n- {name: b, motion: broken.bvh}\n\
         - {name: c, motion: hallo_1.bvh, skeleton: body, annotations: [../x.eaf, hallo_1.eaf]}\n\
         - {name: d, motion: posed_2_left.bvh, span: [0, 9]}\n- {name: e, motion: hands/one.bvh}\n- {name: f, motion: jumps.bvh}\n",
    );
    let done = run(&folder.0, &["corpus", "check", "."], "");
    assert_eq!(done.code, 1, "{}", done.out);
    for part in [
        "there is no file `./no.bvh`",
        "./corpus.yaml:8:21",
        "broken.bvh:2:",
        "no joint `mixamorig:RihgtFoot`",
        "did you mean `mixamorig:RightFoot`?",
        "our rig has no joint `Tail`",
        "`flat-Q` is no configuration that is known",
        "leads out of the corpus's folder",
        "there is no file `./../x.eaf`",
        ".eaf",
        "the span ends after the motion, at 9 s",
        "the first frame is the rest pose",
        "turns at",
    ] {
        assert!(done.err.contains(part), "{part} is not in\n{}", done.err);
    }
    let quiet = run(&folder.0, &["corpus", "check", ".", "-q"], "");
    assert!(quiet.err.is_empty() && quiet.out == done.out, "{}", quiet.err);
    let built = run(&folder.0, &["corpus", "build", "-q"], "");
    assert!(built.code == 1 && built.out.contains("3 left out"), "{}", built.out);
    folder.write("corpus.yaml", "version: 1\nrecordins: []\n");
    let wrong = run(&folder.0, &["corpus", "check"], "");
    assert!(
        wrong.code == 1 && wrong.err.contains("corpus.yaml:2:1") && wrong.err.contains("`recordings`"),
        "{}",
        wrong.err
    );
    let none = run(&folder.0, &["corpus", "build", "hands"], "");
    assert!(none.code == 2 && none.err.contains("chereme corpus init hands"), "{}", none.err);
}

#[test]
fn the_thai_takes_are_one_corpus() {
    let Some(takes) = shared("data/mocap/sign_hand_tsl") else { return };
    let folder = Folder::new("corpus-tsl");
    let done = run(&folder.0, &["corpus", "init", takes.to_str().unwrap(), "-o", "corpus.yaml"], "");
    assert!(
        done.out.contains("906 motions of 906 read") && done.out.contains("lists 906 of the motions"),
        "{}",
        done.out
    );
    let checked = run(&folder.0, &["corpus", "check", "-q"], "");
    assert!(checked.code == 0 && checked.out.starts_with("906 recordings: no faults"), "{}", checked.out);
}
