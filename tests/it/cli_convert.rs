//! `convert`: from any notation to any other, a file or a folder.

use super::cli::{Folder, run};
use std::fs;
use std::path::Path;

const BOL: &str = "language lsf\n\nsign BOL\n  hands          both mirrored\n  movement       up 10cm\n";
const TWO: &str = "sign A\n  movement up 10cm\nsign B\n  movement down 10cm\n";

fn names(folder: &Path) -> Vec<String> {
    let mut names: Vec<String> =
        fs::read_dir(folder).unwrap().map(|f| f.unwrap().file_name().to_string_lossy().into_owned()).collect();
    names.sort();
    names
}

#[test]
fn a_file_becomes_a_file_or_goes_to_standard_output() {
    let folder = Folder::new("convert");
    folder.write("lsf/bol.sign", "sign BOL\nhands both mirrored\nmovement up 10cm");
    let piped = run(&folder.0, &["convert", "lsf/bol.sign", "--as", "sign"], "");
    assert_eq!((piped.code, piped.out.as_str(), piped.err.as_str()), (0, BOL, ""));
    let done = run(&folder.0, &["convert", "lsf/bol.sign", "-o", "new/bol.sign"], "");
    assert_eq!(done.code, 0, "{}", done.err);
    assert!(done.err.contains("1 sign converted into 1 file, 0 refused"), "{}", done.err);
    assert_eq!(fs::read_to_string(folder.0.join("new/bol.sign")).unwrap(), BOL);
    assert_eq!(names(&folder.0.join("new")), ["bol.sign"], "no file is left beside");
    let again = run(&folder.0, &["convert", "lsf/bol.sign", "-o", "new/bol.sign"], "");
    assert_eq!(again.code, 2);
    assert!(again.err.contains("--force"), "{}", again.err);
    assert_eq!(run(&folder.0, &["convert", "lsf/bol.sign", "-o", "new/bol.sign", "--force"], "").code, 0);
    let from = run(&folder.0, &["convert", "-", "--from", "sign", "--as", "sign"], BOL);
    assert_eq!((from.code, from.out.as_str()), (0, BOL));
    let lexicon = run(&folder.0, &["convert", "bol", "--language", "lsf", "--as", "sign"], "");
    assert!(lexicon.out.contains("sign BOL\n  meaning"), "{}", lexicon.out);
}

#[test]
fn a_folder_becomes_a_folder_a_file_for_a_file_or_for_a_sign() {
    let folder = Folder::new("convert-folder");
    folder.write("in/lsf/two.sign", TWO);
    folder.write("in/dgs/deep/one.sign", "sign C\n  movement in 10cm\n");
    let done = run(&folder.0, &["convert", "in", "-o", "out/{folder}/{stem}.sign"], "");
    assert_eq!(done.code, 0, "{}", done.err);
    assert_eq!(names(&folder.0.join("out/lsf")), ["two.sign"]);
    assert_eq!(names(&folder.0.join("out/dgs/deep")), ["one.sign"]);
    let text = fs::read_to_string(folder.0.join("out/lsf/two.sign")).unwrap();
    assert_eq!(text.matches("sign ").count(), 2, "{text}");
    assert!(text.starts_with("language lsf\n\nsign A\n") && text.contains("\n\nsign B\n"), "{text}");
    for jobs in ["1", "4"] {
        let out = format!("each{jobs}/{{number}}-{{name}}.sign");
        let each = run(&folder.0, &["convert", "in/lsf", "-o", &out, "--jobs", jobs], "");
        assert_eq!(each.code, 0, "{}", each.err);
        assert_eq!(names(&folder.0.join(format!("each{jobs}"))), ["1-A.sign", "2-B.sign"]);
    }
    let clash = run(&folder.0, &["convert", "in", "-o", "flat/{number}.sign"], "");
    assert_eq!(clash.code, 2);
    assert!(clash.err.contains("written twice") && !folder.0.join("flat").exists(), "{}", clash.err);
}

#[test]
fn what_cannot_be_said_is_refused_and_the_rest_converted() {
    let folder = Folder::new("convert-refused");
    folder.write("in/lsf/a.sign", "sign A\n  movement up 10cm\nsign X\n  movement ark\n");
    folder.write("in/dgs/b.sign", "sign B\n  movement up 10cm\n");
    let done = run(&folder.0, &["convert", "in", "-o", "all.sign"], "");
    assert_eq!(done.code, 1);
    assert!(done.err.contains("chereme: A: a .sign text is in one language: this one is in dgs"), "{}", done.err);
    assert!(done.err.contains("did you mean `arc`?"), "{}", done.err);
    assert!(done.err.contains("1 sign converted into 1 file, 2 refused"), "{}", done.err);
    assert_eq!(fs::read_to_string(folder.0.join("all.sign")).unwrap().matches("sign B").count(), 1);
}

#[test]
fn what_is_asked_for_wrongly_is_told_before_any_work() {
    let folder = Folder::new("convert-usage");
    folder.write("a.sign", BOL);
    fs::create_dir(folder.0.join("out")).unwrap();
    for (args, words) in [
        (&["convert", "a.sign"][..], "--as"),
        (&["convert", "a.sign", "-o", "a.fbx"], "--as"),
        (&["convert", "a.sign", "-o", "out"], "{stem}"),
        (&["convert", "a.sign", "-o", "out/{x}.sign"], "{x} is unknown"),
        (&["convert", "no.sign", "-o", "b.sign"], "no.sign"),
        (&["convert", "a.sign", "--as", "latin", "-o", "b.sign"], "hamnosys"),
    ] {
        let done = run(&folder.0, args, "");
        assert_eq!(done.code, 2, "{args:?}: {}", done.err);
        assert!(done.err.contains(words), "{args:?}: {}", done.err);
    }
    assert_eq!(names(&folder.0), ["a.sign", "out"]);
}

#[test]
fn the_hands_alone_are_written_where_the_form_has_no_face() {
    let folder = Folder::new("convert-manual");
    for n in 0..12 {
        folder.write(&format!("in/s{n}.sign"), "sign X\n  configuration flat\n  mouth mouthing \"ba\"\n");
    }
    let refused = run(&folder.0, &["convert", "in", "-o", "out/{stem}.ham"], "");
    assert_eq!(refused.code, 1, "{}", refused.err);
    assert_eq!(refused.err.matches("no symbols for non-manual tiers").count(), 9, "{}", refused.err);
    assert!(refused.err.contains("and 4 more") && refused.err.contains("--manual"), "{}", refused.err);
    let hands = run(&folder.0, &["convert", "in/s1.sign", "--manual", "--as", "names"], "");
    assert_eq!((hands.code, hands.out.as_str()), (0, "X\thamflathand\n"), "{}", hands.err);
}

#[test]
fn what_is_said_only_nearly_is_told() {
    let folder = Folder::new("convert-nearly");
    let circle = "sign X\n  configuration flat\n  movement circle axis out turns 1.3\n";
    let told = run(&folder.0, &["convert", "-", "--as", "names"], circle);
    assert_eq!(told.code, 0, "{}", told.err);
    assert!(told.err.contains("warning: X: HamNoSys counts circles in eighths"), "{}", told.err);
    let quiet = run(&folder.0, &["convert", "-", "--as", "names", "-q"], circle);
    assert!(!quiet.err.contains("eighths"), "{}", quiet.err);
}
