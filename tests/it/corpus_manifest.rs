//! `corpus.yaml`: what is written is read as the same, and what is wrong is told with its place, all at once.

use chereme::body::retarget::{Mode, SignedAxis};
use chereme::corpus::files::{Files, Stamp};
use chereme::corpus::manifest::*;
use chereme::corpus::segment::Component;
use chereme::diagnostics::render::render;
use chereme::diagnostics::{Error, Source, Span, Spanned};
use chereme::phonology::Side;
use proptest::prelude::*;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// Files in memory.
#[derive(Default)]
pub struct Memory(pub BTreeMap<PathBuf, Vec<u8>>);

impl Files for Memory {
    fn read(&self, path: &Path) -> Result<Vec<u8>, Error> {
        self.0.get(path).cloned().ok_or_else(|| Error::new(format!("there is no file `{}`", path.display())))
    }

    fn stamp(&self, path: &Path) -> Option<Stamp> {
        self.0.get(path).map(|bytes| Stamp { size: bytes.len() as u64, modified_ns: 1 })
    }
}

fn of<T>(value: T) -> Spanned<T> {
    Spanned::new(value, Span::default())
}

/// Texts that a person or a file system may come up with, YAML's own marks and words among them.
fn any_text() -> impl Strategy<Value = Spanned<String>> {
    let words = prop::sample::select(vec![
        "no",
        "010",
        "1e3",
        "~",
        "null",
        "a: b",
        "# c",
        "- d",
        "é \u{2028}x",
        "*",
        "'",
        "\"\\",
        " x ",
        "<<",
    ]);
    prop_oneof![any::<String>(), words.prop_map(str::to_owned), "[a-z]{1,8}(\\.bvh)?"]
        .prop_filter_map("none", |text: String| (!text.is_empty()).then(|| of(text)))
}

fn maybe<T: std::fmt::Debug + 'static>(of: impl Strategy<Value = T> + 'static) -> BoxedStrategy<Option<T>> {
    prop::option::of(of).boxed()
}

fn details(skeletons: Vec<String>) -> impl Strategy<Value = Details> {
    let skeleton = match skeletons.is_empty() {
        true => Just(None).boxed(),
        false => maybe(prop::sample::select(skeletons).prop_map(of)),
    };
    let side = maybe(prop::sample::select(vec![Side::Left, Side::Right]).prop_map(of));
    let hands = maybe(prop::sample::select(Hands::ALL.to_vec()).prop_map(of));
    (skeleton, maybe(any_text()), side, hands, maybe(any_text()), maybe(any_text()), maybe((-1e3..1e3).prop_map(of)))
        .prop_map(|(skeleton, signer, dominant, hand, licence, credit, offset)| Details {
            skeleton,
            signer,
            dominant,
            hand,
            licence,
            credit,
            offset,
        })
}

fn rigs() -> impl Strategy<Value = Vec<Rig>> {
    let axis =
        || maybe(prop::sample::select(vec![SignedAxis::PLUS_Y, SignedAxis::PLUS_Z, SignedAxis::MINUS_Z]).prop_map(of));
    let named = prop::sample::select(Unit::NAMED.to_vec()).prop_map(|(_, metres)| metres);
    let unit = maybe(prop_oneof![named, 1e-6..10.0].prop_map(|metres| of(Unit(metres))));
    let mode = prop::sample::select(vec![Mode::Directions, Mode::Contacts]);
    let joints = prop::collection::btree_map(any_text().prop_map(|t| t.value), any_text(), 0..4);
    let rig = (unit, axis(), axis(), 0..5u32, mode, joints);
    prop::collection::btree_map(any_text().prop_map(|t| t.value), rig, 0..3).prop_map(|all| {
        let rig =
            |(name, (unit, up, front, skip, mode, joints)): (String, (_, _, _, u32, Mode, BTreeMap<String, _>))| Rig {
                name: of(name),
                unit,
                up,
                front,
                skip_frames: of(skip),
                mode: of(mode),
                joints: joints.into_iter().map(|(ours, theirs)| (of(ours), theirs)).collect(),
            };
        all.into_iter().map(rig).collect()
    })
}

fn recordings(skeletons: Vec<String>) -> impl Strategy<Value = Vec<Recording>> {
    let span = maybe((0.0..5.0, 0.1..5.0).prop_map(|(start, long): (f64, f64)| of([start, start + long])));
    let files = prop::collection::vec(any_text(), 0..3);
    let one = (any_text(), files, maybe(any_text()), span, details(skeletons));
    prop::collection::btree_map(any_text().prop_map(|t| t.value), one, 0..4).prop_map(|all| {
        let one = |(name, (motion, annotations, gloss, span, details))| Recording {
            name: of(name),
            motion,
            annotations,
            gloss,
            span,
            details,
        };
        all.into_iter().map(one).collect()
    })
}

fn tables(skeletons: Vec<String>) -> impl Strategy<Value = Vec<Table>> {
    let one =
        (any_text(), any_text(), maybe(any_text()), details(skeletons)).prop_map(|(table, motion, gloss, details)| {
            let gloss = gloss.map(|heading| (of(Field::Gloss), heading));
            Table { table, columns: [(of(Field::Motion), motion)].into_iter().chain(gloss).collect(), details }
        });
    prop::collection::vec(one, 0..3)
}

fn manifests() -> impl Strategy<Value = Manifest> {
    rigs().prop_flat_map(|skeletons| {
        let names: Vec<String> = skeletons.iter().map(|rig| rig.name.value.clone()).collect();
        let tier = prop::sample::select(our_tiers().collect::<Vec<_>>());
        let tiers = prop::collection::btree_map(any_text().prop_map(|t| t.value), tier, 0..3);
        let values = prop::collection::btree_map((0..4usize, any_text().prop_map(|t| t.value)), any_text(), 0..4);
        let general =
            (any::<String>(), maybe(any_text()), maybe(any_text()), maybe(any_text()), details(names.clone()));
        (general, Just(skeletons), tiers, values, recordings(names.clone()), tables(names)).prop_map(
            |((title, language, licence, credit, defaults), skeletons, tiers, values, recordings, takes)| Manifest {
                title,
                language,
                licence,
                credit,
                defaults,
                skeletons,
                tiers: tiers
                    .into_iter()
                    .map(|(theirs, ours)| TierRule { theirs: of(theirs), ours: of(ours) })
                    .collect(),
                values: values
                    .into_iter()
                    .map(|((at, theirs), ours)| ValueRule { component: Component::ALL[at], theirs: of(theirs), ours })
                    .collect(),
                recordings,
                takes,
            },
        )
    })
}

/// The faults of a manifest, as they are printed.
fn faults(text: &str) -> String {
    let source = Source::new("corpus.yaml", text);
    let faults = read(text).expect_err("it has faults");
    faults.iter().map(|fault| render(fault, &source, false) + "\n").collect()
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 128, ..ProptestConfig::default() })]

    #[test]
    fn what_is_written_is_read_as_the_same(manifest in manifests()) {
        let text = manifest.to_yaml();
        let again = read(&text).map_err(|all| TestCaseError::fail(format!("{all:?}\n{text}")))?;
        prop_assert_eq!(&again, &manifest);
        prop_assert_eq!(again.to_yaml(), text);
    }

    #[test]
    fn any_text_is_read_or_refused(text in any::<String>(), at in 0usize..400, what in "[-:{}\\[\\]#&*!|>'\"% \n\t\r\u{feff}é]{1,3}") {
        let _ = read(&text);
        let mut good = Manifest { title: "x".into(), ..Manifest::default() }.to_yaml();
        let at = (0..=at.min(good.len())).rev().find(|at| good.is_char_boundary(*at)).unwrap_or(0);
        good.insert_str(at, &what);
        for fault in read(&good).err().unwrap_or_default() {
            prop_assert!(fault.span.end <= good.len());
            render(&fault, &Source::new("x", good.clone()), false);
        }
    }
}

#[test]
fn all_faults_are_told_at_once_each_at_its_place() {
    let text = "version: 2\ntitl: Numbers\nskeletons:\n  leap: {unit: furlong, up: y, front: north}\nrecordings:\n\
                \x20 - {name: a, motion: a.bvh, hand: rihgt, span: [2, 1]}\n  - {name: a, motin: b.bvh, skeleton: laep}\n\
                tiers: {G: RH Glos}\nvalues: {Configration: {x: y}}\ntakes: {table: t.tsv, columns: {gloss: g}}\n";
    let told = faults(text);
    let expected = [
        "corpus.yaml:1:10",
        "this program reads version 1",
        "corpus.yaml:2:1",
        "did you mean `title`?",
        "corpus.yaml:4:16",
        "`unit` cannot be `furlong`",
        "corpus.yaml:4:39",
        "`front` cannot be `north`",
        "corpus.yaml:6:36",
        "`hand` cannot be `rihgt`",
        "expected [start, end] in seconds",
        "corpus.yaml:7:12",
        "two recordings are called `a`",
        "did you mean `motion`?",
        "a recording needs a field `motion`",
        "corpus.yaml:7:39",
        "did you mean `leap`?",
        "`G` cannot be `RH Glos`",
        "did you mean `Configuration`?",
        "a table of takes needs a column with the motion's file",
    ];
    for part in expected {
        assert!(told.contains(part), "{part} is not in\n{told}");
    }
    assert_eq!(told.matches("fault:").count(), 13, "{told}");
}

#[test]
fn text_that_is_no_yaml_is_refused_at_its_place() {
    for (text, part) in [
        ("version: 1\ntitle: [a\n", "corpus.yaml:2:8"),
        ("version: 1\nversion: 1\n", "corpus.yaml:2:1"),
        ("version: 1\nrecordings:\n\t- x\n", "with spaces, not with tabs"),
        ("version: 1\n---\nversion: 1\n", "corpus.yaml:3:1"),
        ("- a\n", "a corpus has fields, and this is a list"),
        ("", "a corpus needs a field `version`"),
    ] {
        let told = faults(text);
        assert!(told.contains(part), "{part} is not in\n{told}");
    }
    let deep = "[".repeat(100_000);
    assert!(faults(&deep).contains("recursion limit"));
    // Nine levels of ten references each come to a billion nodes; they are not made.
    let level = |n: usize| format!("a{n}: &a{n} [{}]\n", format!("*a{}, ", n - 1).repeat(10).trim_end_matches(", "));
    let bomb = "a0: &a0 x\n".to_owned() + &(1..=9).map(level).collect::<String>();
    assert!(read(&bomb).is_err());
}

#[test]
fn recordings_inherit_and_tables_list_takes() {
    let text = "version: 1\nlicence: CC0\ndefaults: {hand: left, signer: A}\nskeletons: {leap: {unit: mm}}\n\
                recordings: [{name: one, motion: m/one.bvh, hand: both, annotations: [a.eaf, b.tsv]}]\n\
                takes: {table: t/index.tsv, columns: {motion: file, gloss: sign, hand: side, skeleton: rig}, signer: B}\n";
    let table = "\u{feff}file\tside\tsign\trig\r\n\r\nx.bvh\tright\tno\tleap\r\ny/z.bvh\t\t5\t\r\n\tleft\tq\t\r\nw.bvh\tup\tw\tlaep\r\nx.bvh\t\t\t\r\n";
    let files = Memory([(PathBuf::from("/c/t/index.tsv"), table.as_bytes().to_vec())].into());
    let listing = listing(Source::new("corpus.yaml", text), Path::new("/c"), &files).unwrap();
    let names: Vec<&str> = listing.takes.iter().map(|take| take.name.as_str()).collect();
    assert_eq!(names, ["one", "x", "y/z", "w"]);
    let [one, x, z, _] = &listing.takes[..] else { panic!("four") };
    assert_eq!(
        (one.motion.as_path(), one.hand, one.signer.as_deref()),
        (Path::new("/c/m/one.bvh"), Some(Hands::Both), Some("A"))
    );
    assert_eq!(one.annotations, [PathBuf::from("/c/a.eaf"), PathBuf::from("/c/b.tsv")]);
    assert_eq!((x.motion.as_path(), x.hand, x.rig), (Path::new("/c/t/x.bvh"), Some(Hands::One(Side::Right)), Some(0)));
    assert_eq!((x.gloss.as_deref(), x.signer.as_deref(), x.licence.as_deref()), (Some("no"), Some("B"), Some("CC0")));
    assert_eq!((z.gloss.as_deref(), z.hand, z.rig), (Some("5"), Some(Hands::One(Side::Left)), None));
    let told: Vec<String> = listing.findings.iter().map(|f| render(&f.diagnostic, &f.source, false)).collect();
    assert_eq!(told.len(), 4, "{told:#?}");
    for (told, parts) in told.iter().zip([
        ["index.tsv:5:1", "no motion"],
        ["index.tsv:6:1", "`laep`"],
        ["index.tsv:6:1", "`up`"],
        ["index.tsv:7:1", "called `x`"],
    ]) {
        assert!(parts.iter().all(|part| told.contains(part)), "{told}");
    }
    let missing =
        chereme::corpus::manifest::listing(Source::new("corpus.yaml", text), Path::new("/d"), &files).unwrap();
    assert!(missing.findings[0].diagnostic.message.contains("no file `/d/t/index.tsv`"));
}

/// What fuzzing found: YAML has no plain keys beyond 1024 letters.
#[test]
fn long_keys_are_read_again() {
    for word in ["a*", "b", "é "] {
        let long = of(word.repeat(1500).trim().to_owned());
        let rig = Rig { name: long.clone(), joints: vec![(long.clone(), long.clone())], ..Rig::default() };
        let manifest = Manifest {
            skeletons: vec![rig, Rig { name: of("short".to_owned()), ..Rig::default() }],
            tiers: vec![TierRule { theirs: long.clone(), ours: of("RH Gloss".to_owned()) }],
            values: vec![ValueRule { component: Component::Movement, theirs: long.clone(), ours: long }],
            ..Manifest::default()
        };
        assert_eq!(read(&manifest.to_yaml()).unwrap(), manifest, "{word}");
    }
}
