//! The program as its users meet it.

use std::fs;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// A folder of its own for a test, removed at the end.
pub struct Folder(pub PathBuf);

impl Folder {
    pub fn new(name: &str) -> Folder {
        let path = std::env::temp_dir().join(format!("chereme-cli-{}-{name}", std::process::id()));
        let _ = fs::remove_dir_all(&path);
        fs::create_dir_all(&path).unwrap();
        Folder(path)
    }

    pub fn write(&self, name: &str, text: &str) -> PathBuf {
        let path = self.0.join(name);
        fs::create_dir_all(path.parent().unwrap()).unwrap();
        fs::write(&path, text).unwrap();
        path
    }
}

impl Drop for Folder {
    fn drop(&mut self) {
        let _ = fs::remove_dir_all(&self.0);
    }
}

pub struct Run {
    pub code: i32,
    pub out: String,
    pub err: String,
}

pub fn run(folder: &Path, args: &[&str], input: &str) -> Run {
    let mut child = Command::new(env!("CARGO_BIN_EXE_chereme"))
        .args(args)
        .current_dir(folder)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .stderr(Stdio::piped())
        .spawn()
        .unwrap();
    child.stdin.take().unwrap().write_all(input.as_bytes()).ok();
    let done = child.wait_with_output().unwrap();
    Run {
        code: done.status.code().unwrap_or(-1),
        out: String::from_utf8(done.stdout).unwrap(),
        err: String::from_utf8(done.stderr).unwrap(),
    }
}

const GOOD: &str = "sign BOL\n  hands          both mirrored\n  movement       up 10cm\n";

#[test]
fn check_finds_faults() {
    let folder = Folder::new("check");
    folder.write("lsf/bol.sign", GOOD);
    let fine = run(&folder.0, &["check", "."], "");
    assert_eq!((fine.code, fine.out.as_str()), (0, "1 sound sign in 1 file: no faults\n"));
    folder.write("lsf/bad.sign", "sign X\n movement ark up\nsign Y\n movement up\n");
    let bad = run(&folder.0, &["check", "lsf"], "");
    assert!(bad.code == 1 && bad.out.starts_with("2 sound signs in 2 files: 1 fault\n"), "{}", bad.out);
    assert!(bad.err.contains("lsf/bad.sign:2:11") && bad.err.contains("did you mean `arc`?"), "{}", bad.err);
    assert!(!bad.err.contains('\u{1b}'));
    let piped = run(&folder.0, &["check", "-"], GOOD);
    assert_eq!(piped.code, 0);
}

#[test]
fn check_refuses_empty_folders_and_missing_files() {
    let folder = Folder::new("empty");
    let empty = run(&folder.0, &["check", "."], "");
    assert_eq!(empty.code, 1);
    assert!(empty.err.contains("no .sign files"), "{}", empty.err);
    assert_eq!(run(&folder.0, &["check", "no.sign"], "").code, 2);
    assert_eq!(run(&folder.0, &["check"], "").code, 2);
    assert_eq!(run(&folder.0, &["--lexicon", "no", "list"], "").code, 2);
}

#[test]
fn check_sees_duplicates_and_bad_bytes() {
    let folder = Folder::new("twice");
    folder.write("lsf/a.sign", GOOD);
    folder.write("lsf/b.sign", GOOD);
    let twice = run(&folder.0, &["check", "lsf"], "");
    assert_eq!(twice.code, 1);
    assert!(twice.err.contains("described twice") && twice.err.contains("lsf/a.sign:1"), "{}", twice.err);
    fs::write(folder.0.join("c.sign"), b"sign A\n note \"caf\xe9\"\n").unwrap();
    let bytes = run(&folder.0, &["check", "c.sign"], "");
    assert_eq!(bytes.code, 1);
    assert!(bytes.err.contains("0xE9 is not UTF-8"), "{}", bytes.err);
}

#[test]
fn fmt_lays_out_and_leaves_faulty_files() {
    let folder = Folder::new("fmt");
    let path = folder.write("a.sign", "sign BOL # a bowl\nhands both mirrored\nmovement up 10cm");
    assert_eq!(run(&folder.0, &["fmt", "--check", "a.sign"], "").code, 1);
    assert_eq!(run(&folder.0, &["fmt", "a.sign"], "").code, 0);
    assert_eq!(fs::read_to_string(&path).unwrap(), GOOD.replace("BOL\n", "BOL  # a bowl\n"));
    assert_eq!(run(&folder.0, &["fmt", "--check", "a.sign"], "").code, 0);
    let bad = folder.write("b.sign", "sign X\nmovement ark\n");
    assert_eq!(run(&folder.0, &["fmt", "."], "").code, 1);
    assert_eq!(fs::read_to_string(bad).unwrap(), "sign X\nmovement ark\n");
    let piped = run(&folder.0, &["fmt", "-"], "sign BOL\nhands both mirrored\nmovement up 10cm");
    assert_eq!((piped.code, piped.out.as_str()), (0, GOOD));
    assert_eq!(fs::read_dir(&folder.0).unwrap().count(), 2, "no file is left beside");
}

#[test]
fn new_signs_are_sound_and_replace_nothing() {
    let folder = Folder::new("new");
    let made = run(&folder.0, &["new", "bon appétit", "-o", "lexicon/lsf/bon.sign"], "");
    assert_eq!(made.code, 0, "{}", made.err);
    let checked = run(&folder.0, &["check", "lexicon"], "");
    assert_eq!(checked.code, 0, "{}", checked.err);
    assert_eq!(run(&folder.0, &["fmt", "--check", "lexicon"], "").code, 0);
    assert_eq!(run(&folder.0, &["new", "X", "-o", "lexicon/lsf/bon.sign"], "").code, 1);
    assert_eq!(run(&folder.0, &["new", "X", "-o", "lexicon/lsf/bon.sign", "--force"], "").code, 0);
    let printed = run(&folder.0, &["new", "BOL", "--language", "lsf"], "");
    assert!(printed.out.starts_with("language lsf\n\nsign BOL\n"));
}

#[test]
fn list_and_explain_use_the_lexicon() {
    let folder = Folder::new("list");
    folder.write("lexicon/lsf/bol.sign", &GOOD.replace("BOL\n", "BOL\n  meaning en \"bowl\"\n"));
    folder.write("more/xyz/un.sign", "sign UN\n configuration 1\n");
    let listed = run(&folder.0, &["--lexicon", "more", "list", "--where"], "");
    assert_eq!(listed.code, 0, "{}", listed.err);
    assert!(listed.out.contains("lexicon/lsf/bol.sign:1") && listed.out.contains("bowl"), "{}", listed.out);
    let one = run(&folder.0, &["list", "--language", "xyz", "--lexicon", "more"], "");
    assert_eq!(one.out, "xyz  UN\n");
    let said = run(&folder.0, &["explain", "bol", "--language", "lsf"], "");
    assert!(said.out.contains("weak hand movement: mirrors the strong hand (symmetry)"), "{}", said.out);
    let french = run(&folder.0, &["explain", "bol", "--language", "lsf", "--lang", "fr"], "");
    assert!(french.out.contains("la main dominée, mouvement : en miroir de la main dominante"), "{}", french.out);
    assert_eq!(run(&folder.0, &["explain", "bol", "--lang", "xx"], "").code, 2);
    let near = run(&folder.0, &["explain", "BLO", "--language", "lsf"], "");
    assert_eq!(near.code, 1);
    assert!(near.err.contains("did you mean `BOL`?"), "{}", near.err);
    assert!(run(&folder.0, &["list", "--handshapes"], "").out.contains("round-B\n"));
}

#[test]
fn a_grammar_folder_adds_names() {
    let folder = Folder::new("grammar");
    folder.write("g/nonmanuals.ron", "[(channel: \"brows\", name: \"dancing\")]");
    let sign = "sign A\n brows dancing\n";
    assert_eq!(run(&folder.0, &["check", "-"], sign).code, 1);
    assert_eq!(run(&folder.0, &["check", "-", "--grammar", "g"], sign).code, 0);
    folder.write("g/nonmanuals.ron", "[(chanel: 1)]");
    let bad = run(&folder.0, &["check", "-", "--grammar", "g"], sign);
    assert_eq!(bad.code, 1);
    assert!(bad.err.contains("nonmanuals.ron:1"), "{}", bad.err);
}

#[test]
fn help_has_examples_and_completions_come() {
    let here = std::env::temp_dir();
    for command in ["check", "fmt", "list", "new", "explain", "profile", "completions"] {
        let help = run(&here, &[command, "--help"], "");
        assert!(help.code == 0 && help.out.contains("chereme"), "{command}");
        assert!(help.out.contains("Example"), "{command}");
    }
    assert!(run(&here, &["completions", "bash"], "").out.contains("chereme"));
    assert_eq!(run(&here, &[], "").code, 2);
}

#[test]
fn files_without_a_sign_are_a_fault() {
    let folder = Folder::new("empty");
    folder.write("a.sign", "# nothing yet\n");
    let checked = run(&folder.0, &["check", "a.sign"], "");
    assert_eq!(checked.code, 1);
    assert!(checked.err.contains("no sign"), "{}", checked.err);
}

#[test]
fn render_writes_pages_and_files_and_overwrites_nothing_unasked() {
    let folder = Folder::new("render");
    folder.write("bol.sign", GOOD);
    let done = run(&folder.0, &["render", "bol.sign", "-o", "bol.html", "-o", "bol.glb", "-o", "bol.eaf"], "");
    assert_eq!(done.code, 0, "{}", done.err);
    assert!(done.err.contains("bol.glb"), "{}", done.err);
    let page = fs::read_to_string(folder.0.join("bol.html")).unwrap();
    assert!(page.starts_with("<!doctype html>") && page.contains("RH Phase") && page.contains("unverified"));
    assert!(fs::read(folder.0.join("bol.glb")).unwrap().starts_with(b"glTF"));
    let tiers = fs::read_to_string(folder.0.join("bol.eaf")).unwrap();
    assert!(tiers.contains("TIER_ID=\"LH Movement\"") && tiers.contains(">retraction</CVE_VALUE>"));
    let piped = run(&folder.0, &["render", "bol.sign", "-o", "-", "--format", "eaf"], "");
    assert_eq!((piped.code, piped.out), (0, tiers));
    let again = run(&folder.0, &["render", "bol.sign", "-o", "bol.glb"], "");
    assert_eq!(again.code, 2);
    assert!(again.err.contains("--force"), "{}", again.err);
    assert_eq!(run(&folder.0, &["render", "bol.sign", "-o", "bol.glb", "--force", "--quiet"], "").code, 0);
}

#[test]
fn render_says_what_it_cannot_do() {
    let folder = Folder::new("render-faults");
    folder.write("two.sign", &format!("{GOOD}sign CHAT\n  movement  down 10cm\n"));
    folder.write("fast.sign", "sign FAST\n  placement chest, 20cm away\n  movement  up 60cm duration 0.1s\n");
    for (args, code, words) in [
        (&["render", "two.sign", "-o", "x.html"][..], 2, "--sign"),
        (&["render", "two.sign", "--sign", "CHIEN", "-o", "x.html"], 1, "CHIEN"),
        (&["render", "two.sign", "-o", "x.fbx"], 2, ".glb"),
        (&["render", "two.sign", "--sign", "CHAT", "-o", "x.html", "-o", "x.html"], 2, "twice"),
        (&["render", "two.sign", "--sign", "CHAT", "-o", "-", "--format", "html,eaf"], 2, "one format"),
        (&["render", "two.sign", "-o", "x"], 2, ".html"),
        (&["render", "two.sign", "--sign", "CHAT", "-o", "x.html", "--fps", "0"], 2, "--fps"),
        (&["render", "two.sign", "--sign", "CHAT", "-o", "x.html", "--speed", "nan"], 1, "speed"),
        (&["render", "two.sign", "--sign", "CHAT", "-o", "x.html", "--easing", "wobbly"], 2, "sigmoid"),
        (&["render", "NO-SUCH-SIGN", "-o", "x.html"], 1, "NO-SUCH-SIGN"),
        (&["render", "fast.sign", "-o", "x.html"], 1, "more time"),
    ] {
        let done = run(&folder.0, args, "");
        assert_eq!(done.code, code, "{args:?}: {}", done.err);
        assert!(done.err.contains(words), "{args:?}: {}", done.err);
        assert!(!folder.0.join("x.html").exists(), "{args:?} left a file");
    }
}

#[test]
fn render_writes_one_page_a_sign_into_a_folder() {
    let folder = Folder::new("render-folder");
    folder.write("two.sign", &format!("{GOOD}sign CHAT\n  movement  down 10cm\n"));
    let done = run(&folder.0, &["render", "two.sign", "-o", "out/", "--format", "html,glb", "-q"], "");
    assert_eq!((done.code, done.err.as_str()), (0, ""));
    let mut names: Vec<_> = fs::read_dir(folder.0.join("out")).unwrap().map(|f| f.unwrap().file_name()).collect();
    names.sort();
    assert_eq!(names, ["BOL.glb", "BOL.html", "CHAT.glb", "CHAT.html"]);
}

#[test]
fn a_gloss_line_is_explained_and_rendered() {
    let folder = Folder::new("gloss");
    let told = run(&folder.0, &["explain", "BOL@left IX(BOL) {brows raised: TOI++}, fs(LSF)"], "");
    assert_eq!(told.code, 0, "{}", told.err);
    for words in
        ["made in space, left", "the index points where BOL was made", "made 3 times", "spelled L S F", "brows raised"]
    {
        assert!(told.out.contains(words), "{words}: {}", told.out);
    }
    let done = run(&folder.0, &["render", "TOI BOL@left", "-o", "line.glb", "--fps", "10"], "");
    assert_eq!(done.code, 0, "{}", done.err);
    assert!(fs::metadata(folder.0.join("line.glb")).unwrap().len() > 1000);
    let wrong = run(&folder.0, &["render", "TOI BOLL@left {brows up: X", "-o", "wrong.glb"], "");
    assert_eq!(wrong.code, 1);
    assert!(wrong.err.contains("did you mean `BOL`?") && wrong.err.contains("never closed"), "{}", wrong.err);
    assert!(!folder.0.join("wrong.glb").exists());
}
