//! A corpus from beginning to end, as docs/corpus.md tells it: a folder of motion and annotations becomes signs that are found,
//! exchanged and signed again. The motion here is synthesized, and annotated by us.

use crate::cli::{Folder, run};
use chereme::format::{bvh, eaf};
use std::fs;

/// Three signs of the lexicon as somebody's recordings: BVH and EAF beside each other.
fn recordings(name: &str) -> Folder {
    let folder = Folder::new(name);
    for sign in ["CLAIR", "ESCARGOT", "BONJOUR"] {
        let stem = sign.to_lowercase();
        let out = [format!("takes/{stem}.bvh"), format!("takes/{stem}.eaf")];
        let done = run(&folder.0, &["render", sign, "--language", "lsf", "-o", &out[0], "-o", &out[1], "--quiet"], "");
        assert_eq!(done.code, 0, "{}", done.err);
    }
    folder
}

#[test]
fn signs_are_found_exchanged_and_signed_again() {
    let folder = recordings("captured");
    let ok = |args: &[&str]| {
        let done = run(&folder.0, args, "");
        assert_eq!(done.code, 0, "{args:?}\n{}\n{}", done.out, done.err);
        done
    };
    assert!(ok(&["corpus", "init", "takes"]).out.contains("3 motions of 3 read"));
    assert!(ok(&["corpus", "check", "takes"]).out.contains("no faults"));
    assert!(ok(&["corpus", "build", "takes"]).out.contains("3 made"));
    let found = ok(&["corpus", "find", "gloss=clair hand=right duration<3s", "takes", "--strict"]).out;
    assert!(found.starts_with("clair  ") && found.contains("gloss is CLAIR"), "{found}");
    let near = ok(&["corpus", "find", "hand=right configuration~Y", "takes"]).out;
    assert!(near.starts_with("escargot  "), "{near}");
    let like = ok(&["corpus", "find", "--like", "takes/bonjour.bvh", "takes", "--json"]).out;
    assert!(like.contains("\"recording\": \"bonjour\""), "{like}");
    let told = run(&folder.0, &["corpus", "find", "gloss=clair hnad=right", "takes"], "");
    assert!(told.code == 1 && told.err.contains("did you mean `hand`?"), "{}", told.err);
    ok(&["corpus", "bases", "takes", "--tolerance", "0.1"]);
    ok(&["corpus", "annotate", "takes", "-o", "tiers/"]);
    let annotated = eaf::read(&fs::read(folder.0.join("tiers/clair.eaf")).unwrap()).unwrap().eaf;
    assert!(annotated.tier("RH Configuration").is_some() && annotated.tier("RH Phase").is_some());

    let line = "CLAIR@(-0.2,1.2,0.35) take(escargot)[with configuration U] MERCI take(clair, configuration escargot)[inverted]++";
    let out = ["-o", "line.bvh", "-o", "line.eaf", "-o", "line.html"];
    let args = [&["render", line, "--language", "lsf", "--corpus", "takes"][..], &out].concat();
    ok(&args);
    let tiers = eaf::read(&fs::read(folder.0.join("line.eaf")).unwrap()).unwrap().eaf;
    let glosses: Vec<&str> = tiers.tier("RH Gloss").unwrap().tier.values().iter().map(|v| v.label.as_str()).collect();
    assert_eq!(glosses.len(), 4, "{glosses:?}");
    let sources = |tier: &str| -> Vec<String> {
        let named = tiers.tier(&format!("{tier} Source")).unwrap();
        named.tier.values().iter().map(|v| v.label.clone()).collect()
    };
    let of_gloss = sources("RH Gloss");
    assert!(of_gloss[0].starts_with("corpus: clair") && of_gloss[1].starts_with("corpus: escargot"), "{of_gloss:?}");
    assert!(of_gloss[2] == "description", "{of_gloss:?}");
    assert!(sources("RH Configuration").iter().any(|source| source.starts_with("corpus: escargot")));
    // The same again are the same bytes.
    let first = fs::read(folder.0.join("line.bvh")).unwrap();
    ok(&[&args[..], &["--force"]].concat());
    assert_eq!(fs::read(folder.0.join("line.bvh")).unwrap(), first);

    // By procedure, and on a rig of somebody else's: here the rig of a recording.
    ok(&["render", "CLAIR", "--language", "lsf", "--corpus", "takes", "--prefer", "procedure", "-o", "made.eaf"]);
    assert!(fs::read_to_string(folder.0.join("made.eaf")).unwrap().contains(">description<"));
    ok(&["render", "MERCI", "--language", "lsf", "--rig", "takes/clair.bvh", "-o", "theirs.bvh"]);
    let theirs = bvh::read(&fs::read(folder.0.join("theirs.bvh")).unwrap()).unwrap().bvh;
    let rig = bvh::read(&fs::read(folder.0.join("takes/clair.bvh")).unwrap()).unwrap().bvh;
    assert_eq!(theirs.joints(), rig.joints());
    let told = run(&folder.0, &["render", "MERCI", "--rig", "takes/clair.bvh", "-o", "x.html"], "");
    assert!(told.code == 2 && told.err.contains("write a .bvh file with it"), "{}", told.err);
    let told = run(&folder.0, &["render", "take(clair)", "-o", "y.bvh"], "");
    assert!(told.code == 1 && told.err.contains("name it with --corpus"), "{}", told.err);
    let told = run(&folder.0, &["render", "take(claire)", "--corpus", "takes", "-o", "y.bvh"], "");
    assert!(told.code == 1 && told.err.contains("did you mean `clair`?"), "{}", told.err);
}
