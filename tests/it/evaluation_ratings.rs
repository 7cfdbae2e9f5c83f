//! `chereme evaluate ratings`: from the answers of questionnaires to recognition, realism and differences.

use crate::cli::{Folder, run};
use chereme::evaluation::ratings::{Answer, Level, Levels, Stimulus, analyse, print};
use proptest::prelude::*;

const KEY: &str = "stimulus,group,item,version,correct\na1,pointing,one,linear,\nb2,pointing,one,sigmoid,\nc3,bowls,BOL,synthesized,left\n";

/// Ten people who like the sigmoid; nine recognise the bowl.
fn answers() -> String {
    let mut table = String::from("participant,age,level,stimulus,answer,realism\n");
    for i in 0..10 {
        let level = if i < 8 { "native" } else { "beginner" };
        let place = if i == 0 { "right" } else { "left" };
        table += &format!("P{i},4{i},{level},a1,,{}\nP{i},4{i},{level},b2,,{}\n", 1 + i % 2, 4 + i % 2);
        table += &format!("P{i},4{i},{level},c3,{place},3\n");
    }
    table
}

#[test]
fn answers_and_key_become_tables_and_a_figure() {
    let folder = Folder::new("ratings");
    folder.write("key.csv", KEY);
    folder.write("in/answers.csv", &answers());
    let all = run(&folder.0, &["evaluate", "ratings", "in", "--key", "key.csv"], "");
    assert_eq!(all.code, 0, "{}", all.err);
    assert!(all.out.starts_with("10 participants;") && all.out.contains("9/10 = 90.0 %"), "{}", all.out);
    assert!(all.out.contains("linear – sigmoid") && all.out.contains("r = -1.000: differs"), "{}", all.out);
    let args = ["evaluate", "ratings", "-", "--key", "key.csv", "--level", "good+", "-o", "r.csv", "-o", "r.svg", "-q"];
    let good = run(&folder.0, &args, &answers());
    assert_eq!((good.code, good.err.as_str()), (0, ""));
    assert!(good.out.starts_with("8 participants (2 left out by level)") && good.out.contains("7/8 = 87.5 %"));
    let csv = std::fs::read_to_string(folder.0.join("r.csv")).unwrap();
    assert!(csv.contains("mann-whitney,pointing,,realism,linear,sigmoid"), "{csv}");
    let svg = std::fs::read_to_string(folder.0.join("r.svg")).unwrap();
    assert!(svg.contains("pointing: realism (1 to 5)") && svg.contains("bowls: recognised"), "{svg}");
    let again = run(&folder.0, &args, &answers());
    assert!(again.code == 2 && again.err.contains("--force"), "{}", again.err);
}

#[test]
fn tables_with_faults_are_told_with_their_place() {
    let folder = Folder::new("ratings-faults");
    folder.write("key.csv", KEY);
    let fault = |table: &str, place: &str, message: &str| {
        let done = run(&folder.0, &["evaluate", "ratings", "-", "--key", "key.csv"], table);
        assert!(done.code == 1 && done.err.contains(place) && done.err.contains(message), "{table}\n{}", done.err);
    };
    fault("participant,stimulus,realism\nP1,a1,3\nP2,\"a1\",6\n", "3:9", "expected a number from 1 to 5");
    fault("participant,stimulus,realism\nP1,zz,3\n", "2:1", "nothing says what the stimulus `zz` is");
    fault("participant,level,stimulus\nP1,nativ,a1\n", "2:4", "very-good");
    fault("who,stimulus\nP1,a1\n", "1:1", "there is no column `participant`");
    fault("", "1:1", "there is no column `participant`");
    let german = run(
        &folder.0,
        &["evaluate", "ratings", "-", "--key", "key.csv"],
        "\u{feff}Participant;Stimulus;Realism\nP1;a1;3\nP1;a1;4\n",
    );
    assert!(german.code == 0 && german.err.contains("answered about `a1` twice"), "{}{}", german.out, german.err);
    let nobody =
        run(&folder.0, &["evaluate", "ratings", "-", "--key", "key.csv", "--level", "interpreter"], &answers());
    assert!(nobody.code == 1 && nobody.err.contains("no participant is left"), "{}", nobody.err);
    folder.write("other.csv", &KEY.replace("a1,pointing,one,linear", "a1,pointing,one,sigmoid"));
    let two = run(&folder.0, &["evaluate", "ratings", "-", "--key", "key.csv", "--key", "other.csv"], &answers());
    assert!(two.code == 1 && two.err.contains("other.csv: another key says otherwise of `a1`"), "{}", two.err);
    let none = run(&folder.0, &["evaluate", "ratings", "missing.csv"], "");
    assert_eq!(none.code, 2, "{}", none.err);
}

fn answer(person: usize, version: u8, realism: u8) -> Answer {
    let shown = Stimulus { group: "g".into(), item: "i".into(), version: format!("v{version}"), correct: None };
    Answer {
        participant: format!("P{person}"),
        level: Some(Level::ALL[person % 7]),
        shown,
        answer: None,
        realism: Some(realism),
    }
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    #[test]
    fn the_order_of_rows_does_not_matter(rows in prop::collection::vec((0usize..12, 0u8..3, 1u8..=5), 1..60)) {
        let answers: Vec<Answer> = rows.iter().map(|(p, v, r)| answer(*p, *v, *r)).collect();
        let reversed: Vec<Answer> = answers.iter().rev().cloned().collect();
        let levels: Levels = "good+".parse().unwrap();
        for levels in [None, Some(&levels)] {
            // Sums are taken in another order: the printed digits are the same.
            prop_assert_eq!(print::text(&analyse(&answers, levels), 0.01), print::text(&analyse(&reversed, levels), 0.01));
        }
    }

    #[test]
    fn any_text_is_read_or_refused(text in "[ -~\n\"]{0,200}") {
        let source = chereme::diagnostics::Source::new("x", text.clone());
        let _ = chereme::evaluation::ratings::read_key(&source);
        let source = chereme::diagnostics::Source::new("x", format!("participant,stimulus,level,realism\n{text}"));
        let read = chereme::evaluation::ratings::read_answers(&source);
        if let Err(faults) = read {
            prop_assert!(faults.iter().all(|f| f.span.end <= source.text.len()));
        }
    }
}
