//! The programs of `examples/` say what they promise.

#[allow(dead_code)]
#[path = "../../examples/allot_times.rs"]
mod allot_times;
#[allow(dead_code)]
#[path = "../../examples/gloss_line.rs"]
mod gloss_line;
#[allow(dead_code)]
#[path = "../../examples/recombine.rs"]
mod recombine;
#[allow(dead_code)]
#[path = "../../examples/text_to_bvh.rs"]
mod text_to_bvh;
#[allow(dead_code)]
#[path = "../../examples/text_to_track.rs"]
mod text_to_track;

/// The last column of lines, where the columns before it are as many as `before`.
fn labels(lines: &str, before: usize) -> Vec<String> {
    lines.lines().map(|l| l.split_whitespace().skip(before).collect::<Vec<_>>().join(" ")).collect()
}

#[test]
fn a_text_becomes_a_track() {
    let tiers = text_to_track::tiers().unwrap();
    assert!(tiers.lines().any(|l| l.starts_with("RH Movement") && l.ends_with("arc up-right 15cm")), "{tiers}");
    assert!(tiers.lines().any(|l| l.starts_with("LH Configuration") && l.ends_with("round-B")), "{tiers}");
}

#[test]
fn a_text_becomes_a_bvh_file() {
    let text = text_to_bvh::bvh_text().unwrap();
    let bvh = chereme::format::bvh::read(text.as_bytes()).unwrap().bvh;
    assert!(bvh.rows().len() > 60, "{} frames", bvh.rows().len());
}

#[test]
fn a_sign_is_recombined() {
    let text = recombine::descriptions().unwrap();
    let reading = chereme::notation::read(&text, &chereme::notation::Vocabulary::builtin(), "lsf");
    let signs: Vec<_> = reading.signs.iter().map(|s| &s.sign).collect();
    let [snail, slug, backwards, moved, swapped] = signs.as_slice() else { panic!("{text}") };
    assert_eq!(slug.strong.configuration.at(0).unwrap().base, "U");
    assert_ne!(backwards.strong.movement, snail.strong.movement);
    assert!(moved.relocated.is_some() || moved.strong.placement != snail.strong.placement);
    assert_eq!(swapped.weak.configuration, snail.strong.configuration);
}

#[test]
fn a_gloss_line_is_signed() {
    let lines = gloss_line::glosses().unwrap();
    assert_eq!(labels(&lines, 2), ["BONJOUR", "BOL@left", "IX(BOL)", "CLAIR[inverted]", "fs(LSF)"], "{lines}");
}

#[test]
fn strokes_fall_on_beats() {
    assert_eq!(labels(&allot_times::strokes().unwrap(), 1), ["1.00", "2.00"]);
}
