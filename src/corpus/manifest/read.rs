//! From the text of a manifest to what it says.

use super::fields::{Faults, Fields, items, map, number, parsed, text};
use super::yaml::{Node, parse};
use super::{Details, Field, Hands, Manifest, Recording, Rig, Table, TierRule, Unit, VERSION, ValueRule};
use crate::body::retarget::{Mode, SignedAxis};
use crate::corpus::segment::Component;
use crate::diagnostics::{Diagnostic, Span, Spanned};
use crate::phonology::Side;
use std::collections::BTreeMap;

const DETAILS: [&str; 7] = ["skeleton", "signer", "dominant", "hand", "licence", "credit", "offset"];

/// Reads a manifest.
///
/// # Errors
/// All faults, by their place: text that is no YAML, another version, fields that are not known, values that are not what
/// the field is for, names used twice, recordings without a motion.
///
/// ```
/// use chereme::corpus::manifest;
/// let text = "version: 1\nrecordings:\n  - {name: hello, motion: hello.bvh, gloss: HELLO}\n";
/// let manifest = manifest::read(text).unwrap();
/// assert_eq!(manifest.recordings[0].motion.value, "hello.bvh");
/// let faults = manifest::read("version: 1\nrecordngs: []\n").unwrap_err();
/// assert_eq!(faults[0].label, "did you mean `recordings`?");
/// ```
pub fn read(source: &str) -> Result<Manifest, Vec<Diagnostic>> {
    let tree = parse(source).map_err(|fault| vec![fault])?;
    let mut faults = Faults::new();
    let manifest = manifest(&tree, &mut faults);
    faults.sort_by_key(|fault| fault.span.start);
    match manifest {
        Some(manifest) if faults.is_empty() => Ok(manifest),
        _ => Err(faults),
    }
}

fn manifest(tree: &Spanned<Node>, faults: &mut Faults) -> Option<Manifest> {
    const KNOWN: [&str; 11] = [
        "version",
        "title",
        "language",
        "licence",
        "credit",
        "defaults",
        "skeletons",
        "tiers",
        "values",
        "recordings",
        "takes",
    ];
    let fields = Fields::of(tree, "a corpus", &KNOWN, faults)?;
    version(&fields, faults);
    let list = |name: &str| fields.get(name).map(items).unwrap_or_default();
    let recordings: Vec<_> = list("recordings").iter().filter_map(|node| recording(node, faults)).collect();
    let rigs = fields.get("skeletons").and_then(|node| map(node, "`skeletons`", faults)).unwrap_or_default();
    let manifest = Manifest {
        title: fields.text("title", faults).map(|title| title.value).unwrap_or_default(),
        language: fields.text("language", faults),
        licence: fields.text("licence", faults),
        credit: fields.text("credit", faults),
        defaults: fields.get("defaults").and_then(|node| defaults(node, faults)).unwrap_or_default(),
        skeletons: rigs.iter().filter_map(|(name, node)| rig(name, node, faults)).collect(),
        tiers: tiers(&fields, faults),
        values: values(&fields, faults),
        recordings,
        takes: list("takes").iter().filter_map(|node| table(node, faults)).collect(),
    };
    unique(manifest.recordings.iter().map(|r| &r.name), faults);
    known_skeletons(&manifest, faults);
    Some(manifest)
}

fn version(fields: &Fields<'_>, faults: &mut Faults) {
    let said = fields.required("version", "a corpus", faults);
    if let Some(said) = said.filter(|said| said.value != VERSION.to_string()) {
        let fault = Diagnostic::fault(said.span, format!("this program reads version {VERSION} of corpus.yaml"));
        faults.push(fault.label(format!("expected {VERSION}")));
    }
}

fn defaults(node: &Spanned<Node>, faults: &mut Faults) -> Option<Details> {
    let fields = Fields::of(node, "`defaults`", &DETAILS, faults)?;
    Some(details(&fields, faults))
}

fn details(fields: &Fields<'_>, faults: &mut Faults) -> Details {
    Details {
        skeleton: fields.text("skeleton", faults),
        signer: fields.text("signer", faults),
        dominant: fields.parsed("dominant", "`right` or `left`", side, faults),
        hand: fields.parsed("hand", "`right`, `left` or `both`", hands, faults),
        licence: fields.text("licence", faults),
        credit: fields.text("credit", faults),
        offset: fields.parsed("offset", "a number of seconds", number, faults),
    }
}

/// A side's word, in any case.
pub(super) fn side(word: &str) -> Option<Side> {
    [Side::Right, Side::Left].into_iter().find(|side| super::side_word(*side).eq_ignore_ascii_case(word))
}

/// The word of one hand or both, in any case.
pub(super) fn hands(word: &str) -> Option<Hands> {
    Hands::ALL.into_iter().find(|hands| hands.word().eq_ignore_ascii_case(word))
}

fn recording(node: &Spanned<Node>, faults: &mut Faults) -> Option<Recording> {
    let known = [&["name", "motion", "annotations", "gloss", "span"], &DETAILS[..]].concat();
    let fields = Fields::of(node, "a recording", &known, faults)?;
    let annotations = fields.get("annotations").map(items).unwrap_or_default();
    Some(Recording {
        name: fields.required("name", "a recording", faults).unwrap_or_default(),
        motion: fields.required("motion", "a recording", faults).unwrap_or_default(),
        annotations: annotations.iter().filter_map(|node| text(node, "annotations", faults)).collect(),
        gloss: fields.text("gloss", faults),
        span: fields.get("span").and_then(|node| span(node, faults)),
        details: details(&fields, faults),
    })
}

fn span(node: &Spanned<Node>, faults: &mut Faults) -> Option<Spanned<[f64; 2]>> {
    let numbers: Vec<f64> = match &node.value {
        Node::List(list) => {
            list.iter().filter_map(|item| text(item, "span", faults)).filter_map(|t| number(&t.value)).collect()
        }
        Node::Nothing | Node::Text(_) | Node::Map(_) => Vec::new(),
    };
    match numbers[..] {
        [start, end] if 0.0 <= start && start < end => Some(Spanned::new([start, end], node.span)),
        _ => {
            let fault = Diagnostic::fault(node.span, "`span` is the first and the last instant to use");
            faults.push(fault.label("expected [start, end] in seconds, such as [1.2, 3.5]"));
            None
        }
    }
}

fn rig(name: &Spanned<String>, node: &Spanned<Node>, faults: &mut Faults) -> Option<Rig> {
    const KNOWN: [&str; 6] = ["unit", "up", "front", "skip_frames", "mode", "joints"];
    let fields = Fields::of(node, "a skeleton", &KNOWN, faults)?;
    let axis = |word: &str| word.parse::<SignedAxis>().ok();
    let axes = "one of +x, -x, +y, -y, +z, -z";
    let joints = fields.get("joints").and_then(|node| map(node, "`joints`", faults)).unwrap_or_default();
    Some(Rig {
        name: name.clone(),
        unit: fields.parsed("unit", "metres in one unit, or m, cm, mm, inch, cmu", unit, faults),
        up: fields.parsed("up", axes, axis, faults),
        front: fields.parsed("front", axes, axis, faults),
        skip_frames: fields
            .parsed("skip_frames", "a number of frames", |word| word.parse().ok(), faults)
            .unwrap_or_default(),
        mode: fields.parsed("mode", "`directions` or `contacts`", mode, faults).unwrap_or_default(),
        joints: joints
            .iter()
            .filter_map(|(ours, theirs)| Some((ours.clone(), text(theirs, &ours.value, faults)?)))
            .collect(),
    })
}

fn unit(word: &str) -> Option<Unit> {
    Unit::named(word).or_else(|| number(word).filter(|metres| *metres > 0.0).map(Unit))
}

fn mode(word: &str) -> Option<Mode> {
    [Mode::Directions, Mode::Contacts].into_iter().find(|mode| super::mode_word(*mode) == word)
}

fn tiers(fields: &Fields<'_>, faults: &mut Faults) -> Vec<TierRule> {
    let entries = fields.get("tiers").and_then(|node| map(node, "`tiers`", faults)).unwrap_or_default();
    let ours = |word: &str| super::our_tiers().find(|tier| tier.eq_ignore_ascii_case(word));
    let mut rule = |(theirs, node): &(Spanned<String>, Spanned<Node>)| {
        let name = text(node, &theirs.value, faults)?;
        let expected = "one of our tiers, such as RH Gloss, LH Configuration, Mouth";
        Some(TierRule { theirs: theirs.clone(), ours: parsed(&name, &theirs.value, expected, ours, faults)? })
    };
    entries.iter().filter_map(&mut rule).collect()
}

fn values(fields: &Fields<'_>, faults: &mut Faults) -> Vec<ValueRule> {
    let components = Component::ALL.map(Component::title);
    let Some(own) = fields.get("values").and_then(|node| Fields::of(node, "`values`", &components, faults)) else {
        return Vec::new();
    };
    let mut rules = Vec::new();
    for component in Component::ALL {
        let Some(node) = own.get(component.title()) else { continue };
        for (theirs, ours) in map(node, component.title(), faults).unwrap_or_default() {
            let ours = text(ours, &theirs.value, faults);
            rules.extend(ours.map(|ours| ValueRule { component, theirs: theirs.clone(), ours }));
        }
    }
    rules
}

fn table(node: &Spanned<Node>, faults: &mut Faults) -> Option<Table> {
    let known = [&["table", "columns"], &DETAILS[..]].concat();
    let fields = Fields::of(node, "a table of takes", &known, faults)?;
    let words = Field::ALL.map(Field::word);
    let field = |word: &str| Field::ALL.into_iter().find(|field| field.word() == word);
    let mut columns = Vec::new();
    if let Some(own) = fields.get("columns") {
        Fields::of(own, "`columns`", &words, faults);
        for (name, heading) in map(own, "`columns`", &mut Faults::new()).unwrap_or_default() {
            let heading = text(heading, &name.value, faults);
            columns.extend(field(&name.value).map(|field| Spanned::new(field, name.span)).zip(heading));
        }
    }
    if !columns.iter().any(|(field, _)| field.value == Field::Motion) {
        let span = fields.get("columns").map_or(fields.span, |node| node.span);
        let fault = Diagnostic::fault(span, "a table of takes needs a column with the motion's file");
        faults.push(fault.label("expected `columns: {motion: HEADING, ...}`"));
    }
    let table = fields.required("table", "a table of takes", faults).unwrap_or_default();
    Some(Table { table, columns, details: details(&fields, faults) })
}

/// Tells of names used twice.
fn unique<'n>(names: impl Iterator<Item = &'n Spanned<String>>, faults: &mut Faults) {
    let mut seen: BTreeMap<&str, Span> = BTreeMap::new();
    for name in names {
        if let Some(first) = seen.insert(&name.value, name.span) {
            let fault = Diagnostic::fault(name.span, format!("two recordings are called `{}`", name.value));
            faults.push(fault.label("the second").related(first, "the first"));
        }
    }
}

/// Tells of skeletons that are named and not there.
fn known_skeletons(manifest: &Manifest, faults: &mut Faults) {
    let names = || manifest.skeletons.iter().map(|rig| rig.name.value.as_str());
    let details = manifest.recordings.iter().map(|r| &r.details).chain(manifest.takes.iter().map(|t| &t.details));
    let named = details.chain([&manifest.defaults]).filter_map(|d| d.skeleton.as_ref());
    faults.extend(named.filter(|name| !names().any(|known| known == name.value)).map(|name| {
        let fault = Diagnostic::fault(name.span, format!("there is no skeleton `{}`", name.value));
        match crate::diagnostics::suggest::nearest(&name.value, names()) {
            Some(known) => fault.label(format!("did you mean `{known}`?")),
            None => fault.label("expected a name under `skeletons`"),
        }
    }));
}
