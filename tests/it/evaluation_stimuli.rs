//! `chereme evaluate stimuli`: a blind questionnaire with its key.

use crate::cli::{Folder, run};
use chereme::diagnostics::Source;
use chereme::evaluation::ratings::read_key;
use chereme::evaluation::stimuli::{Set, blind, key};
use std::collections::BTreeSet;

#[test]
fn every_stimulus_is_asked_once_under_a_name_that_says_nothing() {
    for set in Set::ALL {
        let sheet = set.sheet();
        let one = blind(set, &sheet, 5);
        let names: BTreeSet<&String> = one.names.iter().collect();
        let tasks: BTreeSet<&String> = one.page.tasks.iter().map(|task| &task.stimulus).collect();
        assert!(names.len() == sheet.stimuli.len() && names == tasks && one.page.tasks.len() == names.len());
        assert!(names.iter().all(|name| name.len() == 6 && name.chars().all(|c| c.is_ascii_hexdigit())));
        let order = |seed| blind(set, &sheet, seed).page.tasks.into_iter().map(|t| t.question).collect::<Vec<_>>();
        assert_eq!(order(5), order(5));
        // The key explains every name, and every right answer is one that can be given.
        let read = read_key(&Source::new("key", key(&sheet.stimuli, &one.names))).unwrap();
        for (stimulus, name) in sheet.stimuli.iter().zip(&one.names) {
            assert_eq!(read[name].version, stimulus.version.name());
            let choices = &sheet.questions[stimulus.question].choices;
            assert!(stimulus.correct.iter().all(|c| choices.iter().any(|choice| choice.value == *c)), "{stimulus:?}");
            assert_eq!(stimulus.correct.is_some(), !choices.is_empty());
        }
    }
}

#[test]
fn questionnaires_of_one_seed_share_no_names() {
    let [placement, configuration] = Set::ALL.map(|set| blind(set, &set.sheet(), 0).names);
    assert!(placement.iter().all(|name| !configuration.contains(name)));
}

#[test]
fn every_motion_of_an_avatar_has_its_own_duration() {
    use chereme::motion::clip::{Clip, Frame};
    use chereme::motion::{pose::LocalPose, skeleton::Skeleton};
    let rig = std::sync::Arc::new(Skeleton::from_json(chereme::avatar::SKELETON).unwrap());
    let still = |frames: usize| {
        let rest = Frame { pose: LocalPose::rest(&rig), weights: vec![] };
        let clip = Clip::new(rig.clone(), chereme::time::Fps::DEFAULT, vec![].into(), vec![rest; frames]).unwrap();
        chereme::track::Track { clip, tiers: vec![] }
    };
    let (long, short) = (still(61), still(31));
    let glb =
        chereme::format::glb::write_all(chereme::avatar::GLB, &[("a", &long), ("b", &short), ("c", &long)]).unwrap();
    let length = u32::from_le_bytes(glb[12..16].try_into().unwrap()) as usize;
    let json: serde_json::Value = serde_json::from_slice(&glb[20..20 + length]).unwrap();
    let last = |n: usize| {
        let input = json["animations"][n]["samplers"][0]["input"].as_u64().unwrap() as usize;
        json["accessors"][input]["max"][0].as_f64().unwrap()
    };
    assert_eq!([last(0), last(1), last(2)], [1.0, 0.5, 1.0]);
}

#[test]
fn table_2_is_there() {
    let sheet = Set::Configuration.sheet();
    let versions = |item: &str| sheet.stimuli.iter().filter(|s| s.item == item).count();
    assert_eq!(["ESCARGOT", "LIMACE", "CHAT-MARCHE", "POULE-MARCHE"].map(versions), [2, 1, 1, 1]);
    assert_eq!(["LSF", "SALON", "WEEK-END", "OR", "OK"].map(versions), [2; 5]);
    let answers: BTreeSet<&str> = sheet.questions[0].choices.iter().map(|c| c.value.as_str()).collect();
    assert_eq!(answers.len(), 24);
    let placement = Set::Placement.sheet();
    assert_eq!(placement.questions[0].choices.len(), 6);
    assert_eq!(placement.stimuli.iter().filter(|s| s.group == "pointing").count(), 6);
}

#[test]
fn the_page_is_whole_and_blind_and_its_key_is_apart() {
    let folder = Folder::new("stimuli");
    let args = ["evaluate", "stimuli", "configuration", "-o", "page.html", "--key", "key.csv"];
    let done = run(&folder.0, &args, "");
    assert!(done.code == 0 && done.err.contains("15 stimuli, none captured"), "{}", done.err);
    let page = std::fs::read_to_string(folder.0.join("page.html")).unwrap();
    for told in ["slerp", "captured", "sigmoid", "ESCARGOT-H"] {
        let data = page.split("id=\"chereme-data\">").nth(1).unwrap();
        let (data, _) = data.split_once("</script>").unwrap();
        assert!(!data.contains(told), "the page says {told}");
    }
    assert!(!page.contains("src=\"http") && !page.contains("href=\"http"));
    let key = std::fs::read_to_string(folder.0.join("key.csv")).unwrap();
    assert_eq!(read_key(&Source::new("key", key.clone())).unwrap().len(), 15);
    let again = run(&folder.0, &args, "");
    assert!(again.code == 2 && again.err.contains("--force"), "{}", again.err);
    // The same seed gives the same bytes; a recording on our rig becomes a captured version.
    let ok = run(&folder.0, &["render", "OK", "--fps", "30", "-o", "ok.bvh", "-q"], "");
    assert_eq!(ok.code, 0, "{}", ok.err);
    let more = ["evaluate", "stimuli", "configuration", "-o", "p2.html", "-k", "k2.csv", "--captured", "ok=ok.bvh"];
    let captured = run(&folder.0, &more, "");
    assert!(captured.code == 0 && captured.err.contains("16 stimuli, 1 captured"), "{}", captured.err);
    assert!(std::fs::read_to_string(folder.0.join("k2.csv")).unwrap().contains("dactylology,OK,captured,ok"));
    folder.write(
        "hand.bvh",
        "HIERARCHY\nROOT Hips {\n OFFSET 0 0 0\n CHANNELS 0\n }\nMOTION\nFrames: 1\nFrame Time: .1\n\n",
    );
    let wrong = ["evaluate", "stimuli", "configuration", "-o", "p3.html", "-k", "k3.csv", "--captured"];
    let told = |captured: &str, code: i32, what: &str| {
        let done = run(&folder.0, &[&wrong[..], &[captured]].concat(), "");
        assert!(done.code == code && done.err.contains(what), "{captured}: {} {}", done.code, done.err);
    };
    told("ok", 2, "ITEM=FILE");
    told("WC=ok.bvh", 2, "there is no such item");
    told("ok=missing.bvh", 2, "there is no file");
    told("ok=hand.bvh", 1, "hand.bvh");
    assert!(!folder.0.join("p3.html").exists());
}
