//! The viewer page: one file, complete, asking for nothing, whatever the labels say.

use crate::format_glb_write::{AVATAR, track};
use chereme::format::html::{Page, write};
use chereme::tier::Tier;
use chereme::time::Seconds;

fn page(label: &str) -> String {
    let mut track = track();
    let mut tier = Tier::new("RH Gloss");
    tier.push(Seconds(0.0), Seconds(1.0), label, "description");
    track.tiers.push(tier);
    let facts = vec![("meaning".to_owned(), "en bowl".to_owned())];
    write(AVATAR, &track, &Page { title: label.to_owned(), language: "lsf".into(), facts }).unwrap()
}

/// The text of the data element, as a browser would see it: up to the first end tag.
fn data(page: &str) -> serde_json::Value {
    let start = page.split_once("id=\"chereme-data\">").unwrap().1;
    serde_json::from_str(start.split_once("</script").unwrap().0).unwrap()
}

#[test]
fn labels_cannot_break_the_page() {
    let label = "</script><!--chereme:modules--><script>alert('É')";
    let page = page(label);
    let data = data(&page);
    assert_eq!(data["title"], label);
    assert_eq!(data["tiers"][0]["values"][0]["label"], label);
    assert_eq!(data["duration"], 2.0);
    assert_eq!(page.matches("id=\"chereme-data\"").count(), 1);
}

#[test]
fn every_import_is_in_the_page_and_every_script_is_closed() {
    let page = page("BOL");
    assert_eq!(page.matches("<script").count(), page.matches("</script>").count());
    for name in ["three.core.min.js", "three.module.min.js", "GLTFLoader.js", "main.js", "timeline.js"] {
        assert!(page.contains(&format!("data-module=\"{name}\"")), "{name}");
    }
    assert!(!page.contains("<script src") && !page.contains("<link rel=\"stylesheet\""));
    assert!(page.contains("Permission is hereby granted"), "three.js goes with its licence");
    assert!(page.trim_end().ends_with("</html>"));
}
