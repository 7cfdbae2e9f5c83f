//! How fast `.sign` text is read: parsing alone, and with lowering against the program's inventories.

use chereme::notation::{Vocabulary, parse, print, read};
use divan::counter::BytesCount;

fn main() {
    divan::main();
}

const SIGN: &str = r#"sign BOL-1
  meaning        en "bowl", fr "bol"
  source         "a dictionary, p. 12"
  status         unverified
  hands          both mirrored
  configuration  round-B, thumb out then flat
  placement      chest, neutral distance, with index tip  # before the trunk
  orientation    fingers out-left, palm up
  movement       arc up-right 15cm bulging right, fast while wiggle index middle
  brows          raised slight
  gaze           towards up-left
  duration       0.9s

"#;

/// A file of a thousand signs, each with its own name.
fn text() -> String {
    (0..1000).map(|i| SIGN.replace("BOL-1", &format!("BOL-{i}"))).collect()
}

#[divan::bench]
fn parsing(bencher: divan::Bencher) {
    let text = text();
    bencher.counter(BytesCount::of_str(&text)).bench(|| parse(&text));
}

#[divan::bench]
fn reading(bencher: divan::Bencher) {
    let (text, vocabulary) = (text(), Vocabulary::builtin());
    assert_eq!(read(&text, &vocabulary, "lsf").signs.len(), 1000);
    bencher.counter(BytesCount::of_str(&text)).bench(|| read(&text, &vocabulary, "lsf"));
}

#[divan::bench]
fn printing(bencher: divan::Bencher) {
    let text = text();
    let (file, _) = parse(&text);
    bencher.counter(BytesCount::of_str(&text)).bench(|| print(&file));
}
