//! `render --each`: one file a sign, on several cores.

use super::cli::{Folder, run};
use std::fs;
use std::path::Path;

const TWO: &str = "sign A\n  movement  up 10cm\nsign B/C\n  movement  down 10cm\n";

/// The files below a folder, by name, with what is in them.
fn all(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let mut found = Vec::new();
    let mut left = vec![folder.to_owned()];
    while let Some(next) = left.pop() {
        for entry in fs::read_dir(next).unwrap() {
            let path = entry.unwrap().path();
            match path.is_dir() {
                true => left.push(path),
                false => {
                    found.push((path.strip_prefix(folder).unwrap().display().to_string(), fs::read(&path).unwrap()))
                }
            }
        }
    }
    found.sort();
    found
}

fn names(folder: &Path) -> Vec<String> {
    all(folder).into_iter().map(|(name, _)| name).collect()
}

#[test]
fn each_writes_one_file_a_sign_and_tells_all_in_order_on_any_number_of_cores() {
    let folder = Folder::new("each");
    for n in 0..40 {
        let sign = match n % 10 {
            7 => format!("sign S{n}\n  placement belowstomach right, 15cm away\n  movement  up 60cm duration 0.17s\n"),
            _ => format!("sign S{n}\n  movement  up {}cm\n", 5 + n % 7),
        };
        folder.write(&format!("in/{}/s{n:02}.sign", if n < 20 { "lsf" } else { "dgs" }), &sign);
    }
    folder.write("in/lsf/bad.sign", "sign X\n  movement ark up\n");
    let render = |jobs: &str, out: &str| {
        let out = format!("{out}/{{language}}/{{stem}}.bvh");
        run(&folder.0, &["render", "in", "--each", "-o", &out, "--jobs", jobs, "--fps", "30"], "")
    };
    let (one, four) = (render("1", "one"), render("4", "four"));
    assert_eq!((one.code, four.code), (1, 1), "{}", one.err);
    let told = |err: &str| err.lines().filter(|l| !l.contains("signs/s")).collect::<Vec<_>>().join("\n");
    assert_eq!(told(&one.err), told(&four.err));
    let refused = ["S27", "S37", "S7", "S17"].map(|name| one.err.find(&format!("chereme: {name}: ")).unwrap());
    assert!(refused.is_sorted(), "{}", one.err);
    assert!(one.err.contains("36 signs rendered, 5 refused"), "{}", one.err);
    let files = all(&folder.0.join("one"));
    assert_eq!(files, all(&folder.0.join("four")));
    assert_eq!((files.len(), files[0].0.as_str()), (36, "dgs/s20.bvh"));
    assert!(files.iter().all(|(name, bytes)| name.ends_with(".bvh") && bytes.starts_with(b"HIERARCHY")));
}

#[test]
fn names_that_would_clash_are_told_before_any_work() {
    let folder = Folder::new("each-clash");
    folder.write("two.sign", TWO);
    folder.write("a/x.sign", "sign X\n  movement up\n");
    folder.write("b/x.sign", "sign Y\n  movement up\n");
    for (args, words) in [
        (&["render", "two.sign", "--each", "-o", "out/{stem}.bvh"][..], "{stem}-{number}"),
        (&["render", "two.sign", "--each", "-o", "out/two.bvh"], "{name}"),
        (&["render", "two.sign", "--each", "-o", "-"], "standard output"),
        (&["render", "two.sign", "--each", "-o", "out/{gloss}.bvh"], "{gloss} is unknown"),
        (&["render", "two.sign", "--each", "-o", "out/{name.bvh"], "never closed"),
        (&["render", "two.sign", "--each", "-o", "out/{name}.fbx"], ".glb"),
        (&["render", "two.sign", "--each", "-o", "out/{name}.bvh", "--jobs", "0"], "--jobs"),
        (&["render", "a", "b", "--each", "-o", "out/{stem}.bvh"], "written twice, for X and for Y"),
    ] {
        let done = run(&folder.0, args, "");
        assert_eq!(done.code, 2, "{args:?}: {}", done.err);
        assert!(done.err.contains(words), "{args:?}: {}", done.err);
        assert!(!folder.0.join("out").exists(), "{args:?} left something");
    }
}

#[test]
fn files_with_several_signs_number_or_name_them() {
    let folder = Folder::new("each-several");
    folder.write("two.sign", TWO);
    let each = |outputs: &[&str]| {
        let mut args = vec!["render", "two.sign", "--fps", "5"];
        outputs.iter().for_each(|o| args.extend(["-o", o]));
        run(&folder.0, &args, "")
    };
    // A field in the name says --each.
    let done = each(&["out/{stem}-{number}.bvh", "out/{name}.eaf", "out/{language}/{folder}/{name}.csv"]);
    assert_eq!(done.code, 0, "{}", done.err);
    assert!(done.err.contains("2 signs rendered, 0 refused"), "{}", done.err);
    let written = ["A.eaf", "B_C.eaf", "two-1.bvh", "two-2.bvh", "und/A.csv", "und/B_C.csv"];
    assert_eq!(names(&folder.0.join("out")), written);
    let again = each(&["out/{stem}-{number}.bvh"]);
    assert_eq!(again.code, 2);
    assert!(again.err.contains("two-1.bvh is there already (and 1 more); --force"), "{}", again.err);
    let forced = run(
        &folder.0,
        &["render", "two.sign", "--each", "-o", "out", "--format", "bvh,eaf", "--force", "-q", "--fps", "5"],
        "",
    );
    assert_eq!((forced.code, forced.err.as_str()), (0, ""));
    assert_eq!(names(&folder.0.join("out")).len(), 8);
}

#[test]
fn stems_stay_as_they_are() {
    let folder = Folder::new("each-stems");
    folder.write("in/GEVEN-CL{PLAT}-DI{1_3A}.sign", "sign GEVEN\n  movement  up 5cm\n");
    let out = run(&folder.0, &["render", "in", "--each", "-o", "out/{stem}.csv", "--fps", "30"], "");
    assert_eq!(out.code, 0, "{}", out.err);
    assert_eq!(names(&folder.0.join("out")), ["GEVEN-CL{PLAT}-DI{1_3A}.csv"]);
}
