//! `check` on folders: what is wrong how often, reports for programs, motion.

use super::cli::{Folder, run};
use serde_json::Value;

const GOOD: &str = "sign BOL\n  hands both mirrored\n  movement  up 10cm\n";

#[test]
fn a_summary_says_what_is_wrong_how_often() {
    let folder = Folder::new("check-summary");
    folder.write("in/a.sign", GOOD);
    folder.write("in/b.sign", "sign X\n  movement ark up\nsign Y\n  movement ork up\nsign Z\n");
    folder.write("in/c.sign", "sign W\n  movement erc up\n  configuration flatt\n");
    folder.write("in/notes.txt", "no signs here");
    folder.write("in/table.csv", "time,speed\n0,1\n");
    let told = run(&folder.0, &["check", "in"], "");
    assert_eq!(told.code, 1);
    assert!(
        told.out.starts_with("2 sound signs in 3 files: 4 faults, 1 warning\n3 signs refused, 1 sign with warnings\n")
    );
    let kinds: Vec<&str> = told.out.lines().filter(|l| l.starts_with("     ")).collect();
    assert!(kinds[0].trim_start().starts_with("3  `…` is"), "{}", told.out);
    assert!(kinds[1].contains("such as in/b.sign:2:12"), "{}", told.out);
    assert!(told.err.contains("in/c.sign:2:12"));
    let quiet = run(&folder.0, &["check", "in", "--quiet"], "");
    assert_eq!((quiet.code, quiet.out.as_str(), quiet.err.as_str()), (1, told.out.as_str(), ""));
}

#[test]
fn fifty_faults_are_told_unless_all_are_asked_for() {
    let folder = Folder::new("check-many");
    for file in 0..4 {
        let signs: String = (0..20).map(|n| format!("sign S{file}-{n}\n  movement ark up\n")).collect();
        folder.write(&format!("in/{file}.sign"), &signs);
    }
    let carets = |err: &str| err.matches("did you mean `arc`?").count();
    let some = run(&folder.0, &["check", "in"], "");
    assert_eq!((some.code, carets(&some.err)), (1, 50));
    assert!(some.err.contains("30 more of 80 faults and warnings: --all"), "{}", some.err);
    assert_eq!(carets(&run(&folder.0, &["check", "in", "--all"], "").err), 80);
    assert_eq!(run(&folder.0, &["check", "in", "--all", "--quiet"], "").code, 2);
}

#[test]
fn a_report_for_programs_has_everything_in_the_texts_order() {
    let folder = Folder::new("check-json");
    folder.write("in/a.sign", "sign A\n  movement ark up\n");
    folder.write("in/b.sign", GOOD);
    let report = |jobs: &str| run(&folder.0, &["check", "in", "--json", "--motion", "--jobs", jobs], "");
    let one = report("1");
    assert_eq!((one.code, one.err.as_str()), (1, ""));
    assert_eq!(one.out, report("4").out);
    let json: Value = serde_json::from_str(&one.out).unwrap();
    assert_eq!((&json["files"], &json["signs"], &json["refused"]), (&2.into(), &1.into(), &1.into()));
    let fault = &json["diagnostics"][0];
    assert_eq!((&fault["severity"], &fault["file"], &fault["line"]), (&"fault".into(), &"in/a.sign".into(), &2.into()));
    assert_eq!(json["reasons"][0]["example"]["column"], 12);
    assert_eq!((&json["motion"]["signs"], &json["motion"]["frames_per_second"]), (&1.into(), &30.0.into()));
}

#[test]
fn motion_is_checked_and_only_what_nobody_can_use_is_a_fault() {
    let folder = Folder::new("check-motion");
    folder.write("good.sign", GOOD);
    let fine = run(&folder.0, &["check", "good.sign", "--motion"], "");
    assert_eq!(fine.code, 0, "{}{}", fine.out, fine.err);
    assert!(fine.out.contains("1 sign signed at 30 frames a second"), "{}", fine.out);
    // Faster than signers sign, but not than anyone can.
    folder.write("fast.sign", "sign FAST\n  placement chest, 20cm away\n  movement  up 40cm duration 0.2s\n");
    let fast = run(&folder.0, &["check", "fast.sign", "--motion"], "");
    assert_eq!(fast.code, 0, "{}{}", fast.out, fast.err);
    assert!(
        fast.out.contains("warning: fast wrist: 1 sign, 1 finding\n  FAST (fast.sign): right hand"),
        "{}",
        fast.out
    );
    // A wrist that cannot go so far: an exception that is counted.
    folder.write(
        "bent.sign",
        "sign BENT\n  placement chest, touch, with index tip\n  orientation fingers up, palm out\n",
    );
    let bent = run(&folder.0, &["check", "bent.sign", "--motion"], "");
    assert_eq!(bent.code, 0, "{}{}", bent.out, bent.err);
    assert!(bent.out.contains("exception: orientation beyond the wrist: 1 sign"), "{}", bent.out);
    folder.write(
        "never.sign",
        "sign NEVER\n  placement belowstomach right, 15cm away\n  movement  up 60cm duration 0.17s\n",
    );
    let never = run(&folder.0, &["check", "never.sign", "--motion", "-q"], "");
    assert_eq!(never.code, 1);
    assert!(never.out.contains("cannot be signed: 1 sign") && never.out.contains("give it more time"), "{}", never.out);
    assert_eq!(run(&folder.0, &["check", "good.sign", "--fps", "30"], "").code, 2);
}
