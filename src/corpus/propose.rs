//! A manifest proposed from what a folder holds. Everything in it is a guess that a person can look at; each is told.

mod table;

pub use table::HeadedTable;

use super::manifest::{Details, Field, Hands, Manifest, Recording, Rig, Table, Unit};
use super::motion::{begins_at_rest, propose_unit, recognised};
use crate::body::retarget::names::Recognised;
use crate::body::retarget::{Axes, propose_axes};
use crate::diagnostics::{Diagnostic, Span, Spanned};
use crate::format::bvh::{self, ClipOptions, Roots};
use crate::phonology::Side;
use crate::time::Seconds;
use std::collections::BTreeMap;

/// What was seen of a motion file.
#[derive(Debug, Clone, PartialEq)]
pub struct Seen {
    /// Its path from the folder, with `/`.
    pub path: String,
    /// The names of its joints.
    pub names: Vec<String>,
    /// What they are called.
    pub recognised: Recognised,
    /// Metres in one unit, and the unit's name; `None` where nothing fits.
    pub unit: Option<(f64, &'static str)>,
    /// Where up and front seem to be.
    pub axes: Axes,
    /// Whether its first frame is a rest pose that was put in.
    pub inserted: bool,
    /// How long it is.
    pub duration: Seconds,
}

/// Looks at a motion file.
///
/// # Errors
/// The file's own faults, or what keeps it from being a clip.
pub fn seen(path: &str, bytes: &[u8]) -> Result<Seen, Vec<Diagnostic>> {
    let file = bvh::read(bytes)?.bvh;
    let recognised = recognised(&file);
    let unit = propose_unit(&file, &recognised.joints);
    let metres_per_unit = unit.map_or(0.01, |(metres, _)| metres);
    let clip = bvh::to_clip(&file, &ClipOptions { metres_per_unit, roots: Roots::First })
        .map_err(|e| vec![Diagnostic::fault(Span::default(), e.to_string())])?
        .clip;
    Ok(Seen {
        path: path.to_owned(),
        names: file.joints().iter().map(|joint| joint.name.clone()).collect(),
        axes: propose_axes(&clip, &recognised.joints),
        recognised,
        unit,
        inserted: begins_at_rest(&clip),
        duration: clip.duration(),
    })
}

/// A proposed manifest, and what a person should look at.
#[derive(Debug, Clone, PartialEq)]
pub struct Proposal {
    /// The manifest.
    pub manifest: Manifest,
    /// What was found and guessed, each a sentence.
    pub notes: Vec<String>,
}

/// Proposes a manifest of motion files, annotation files (paths from the folder) and tables.
///
/// Files of equal joints, unit and first frame are one skeleton. A table whose column names motion files lists its takes;
/// the other motions are recordings, with the annotations of the same name beside them. A gloss is read from names such as
/// `eight_0_right.bvh`: gloss, number of the take, hand.
///
/// ```
/// use chereme::corpus::propose::{propose, seen};
/// let text = "HIERARCHY\nROOT Hips {\nOFFSET 0 0 0\nCHANNELS 1 Yrotation\nJOINT Head {\nOFFSET 0 160 0\nCHANNELS 1 Yrotation\n\
///             End Site {\nOFFSET 0 10 0\n}\n}\n}\nMOTION\nFrames: 1\nFrame Time: 0.02\n1 2\n";
/// let motion = seen("eight_0.bvh", text.as_bytes()).unwrap();
/// let proposal = propose("Numbers", &[motion], &["eight_0.eaf".to_owned()], &[]);
/// let recording = &proposal.manifest.recordings[0];
/// assert_eq!(recording.gloss.as_ref().unwrap().value, "eight");
/// assert_eq!(recording.annotations[0].value, "eight_0.eaf");
/// assert_eq!(proposal.manifest.skeletons[0].unit.unwrap().value.name(), Some("cm"));
/// ```
pub fn propose(title: &str, motions: &[Seen], annotations: &[String], tables: &[HeadedTable]) -> Proposal {
    let mut notes = Vec::new();
    let rigs = rigs(motions, &mut notes);
    let mut manifest = Manifest { title: title.to_owned(), ..Manifest::default() };
    // Where two skeletons have the same joints, the file's joints do not say which is meant.
    let ambiguous = |at: usize| rigs.iter().any(|other| other.of != at && other.joints() == rigs[at].joints());
    let mut listed = vec![false; motions.len()];
    for table in tables {
        let Some(found) = table.takes(motions) else { continue };
        if found.rows.iter().any(|at| listed[*at] || ambiguous(group_of(&rigs, *at))) {
            notes.push(format!(
                "{} lists motions, but cannot say which skeleton they have: they are listed here",
                table.path
            ));
            continue;
        }
        notes.push(format!("{} lists {} of the motions: {}", table.path, found.rows.len(), found.columns_told()));
        found.rows.iter().for_each(|at| listed[*at] = true);
        manifest.takes.push(Table { table: of(&table.path), columns: found.columns, details: Details::default() });
    }
    let mut names = BTreeMap::new();
    for (at, motion) in motions.iter().enumerate().filter(|(at, _)| !listed[*at]) {
        let rig = group_of(&rigs, at);
        let mut own = recording(motion, annotations);
        own.details.skeleton = ambiguous(rig).then(|| of(&rigs[rig].rig.name.value));
        *names.entry(own.gloss.is_some()).or_insert(0) += 1;
        manifest.recordings.push(own);
    }
    if let Some(guessed) = names.get(&true) {
        notes.push(format!("glosses of {guessed} recordings are guessed from their files' names: look at `gloss`"));
    }
    if let Some(none) = names.get(&false) {
        notes
            .push(format!("{none} recordings have no gloss in a name or a table: their annotations may have some, or write `gloss` where a take is one sign"));
    }
    notes.push("licence and credit are for you to write".to_owned());
    manifest.skeletons = rigs.into_iter().map(|group| group.rig).collect();
    Proposal { manifest, notes }
}

fn of(text: &str) -> Spanned<String> {
    Spanned::new(text.to_owned(), Span::default())
}

/// Motions of one skeleton.
struct Group {
    of: usize,
    rig: Rig,
    /// Their numbers.
    members: Vec<usize>,
}

impl Group {
    fn joints(&self) -> &[(Spanned<String>, Spanned<String>)] {
        &self.rig.joints
    }
}

fn group_of(groups: &[Group], motion: usize) -> usize {
    groups.iter().position(|group| group.members.contains(&motion)).unwrap_or(0)
}

/// The skeletons of the motions, in the order of their first file.
fn rigs(motions: &[Seen], notes: &mut Vec<String>) -> Vec<Group> {
    let mut keys: Vec<(&[String], Option<&str>, bool)> = Vec::new();
    let mut members: Vec<Vec<usize>> = Vec::new();
    for (at, motion) in motions.iter().enumerate() {
        let key = (&motion.names[..], motion.unit.map(|unit| unit.1), motion.inserted);
        match keys.iter().position(|known| *known == key) {
            Some(group) => members[group].push(at),
            None => {
                keys.push(key);
                members.push(vec![at]);
            }
        }
    }
    let mut taken: BTreeMap<String, usize> = BTreeMap::new();
    let mut groups = Vec::new();
    for (of_group, members) in members.into_iter().enumerate() {
        let first = &motions[members[0]];
        let name = {
            let plain = rig_name(first);
            let times = taken.entry(plain.clone()).or_insert(0);
            *times += 1;
            if *times == 1 { plain } else { format!("{plain}-{times}") }
        };
        let axes = most_frequent(members.iter().map(|at| motions[*at].axes));
        notes.push(told(&name, first, axes, members.len()));
        let differing = members.iter().filter(|at| motions[**at].axes != axes).count();
        if differing > 0 {
            notes.push(format!("{name}: {differing} of its files seem to have other axes; look at `up` and `front`"));
        }
        let joints = first.recognised.joints.iter().map(|(ours, theirs)| (of(ours), of(theirs))).collect();
        let rig = Rig {
            name: of(&name),
            unit: first.unit.map(|(metres, _)| Spanned::new(Unit(metres), Span::default())),
            up: Some(Spanned::new(axes.up(), Span::default())),
            front: Some(Spanned::new(axes.front(), Span::default())),
            skip_frames: Spanned::new(u32::from(first.inserted), Span::default()),
            mode: Spanned::default(),
            joints,
        };
        groups.push(Group { of: of_group, rig, members });
    }
    groups
}

/// What is guessed of a skeleton.
fn told(name: &str, first: &Seen, axes: Axes, files: usize) -> String {
    let known = &first.recognised;
    let unit = first.unit.map_or("unknown, so write `unit`".to_owned(), |(_, unit)| unit.to_owned());
    let skipped = if first.inserted { "; the first frame is a rest pose that was put in, and skipped" } else { "" };
    let unknown = match &known.unknown[..] {
        [] => String::new(),
        [one] => format!("; {one} is none of ours"),
        [one, ..] => format!("; {} joints are none of ours, such as {one}", known.unknown.len()),
    };
    let files = if files == 1 { "1 file".to_owned() } else { format!("{files} files") };
    let convention = if known.joints.is_empty() { "unknown" } else { known.convention };
    format!(
        "skeleton {name}, {files} such as {}: {} of {} joints known, names of {convention}{unknown}; unit {unit}; \
         up {}, front {}{skipped}",
        first.path,
        known.joints.len(),
        first.names.len(),
        axes.up(),
        axes.front()
    )
}

/// `mixamo`, `leap-right-hand`.
fn rig_name(seen: &Seen) -> String {
    let known = &seen.recognised.joints;
    if known.is_empty() {
        return "unknown".to_owned();
    }
    let convention: String =
        seen.recognised.convention.to_lowercase().chars().map(|c| if c.is_alphanumeric() { c } else { '-' }).collect();
    match hands_of(seen) {
        Some(Hands::One(side)) if !known.contains_key("Hips") && !known.contains_key("Spine") => {
            format!("{convention}-{}-hand", super::manifest::side_word(side))
        }
        _ => convention,
    }
}

/// The hands whose joints a file has.
fn hands_of(seen: &Seen) -> Option<Hands> {
    let has = |hand: &str| seen.recognised.joints.keys().any(|ours| ours.starts_with(hand));
    match (has("RightHand"), has("LeftHand")) {
        (true, true) => Some(Hands::Both),
        (true, false) => Some(Hands::One(Side::Right)),
        (false, true) => Some(Hands::One(Side::Left)),
        (false, false) => None,
    }
}

fn most_frequent(all: impl Iterator<Item = Axes>) -> Axes {
    let mut counts: Vec<(Axes, usize)> = Vec::new();
    for axes in all {
        match counts.iter_mut().find(|(known, _)| *known == axes) {
            Some((_, count)) => *count += 1,
            None => counts.push((axes, 1)),
        }
    }
    // Of equals the first.
    let most = counts.iter().map(|(_, count)| *count).max();
    let found = counts.iter().find(|(_, count)| Some(*count) == most).map(|(axes, _)| *axes);
    found.unwrap_or(Axes::OURS)
}

/// A recording of a motion, and the annotations of the same name beside it.
fn recording(seen: &Seen, annotations: &[String]) -> Recording {
    let stem = without_extension(&seen.path);
    let named = stem.rsplit('/').next().unwrap_or(stem);
    let (gloss, side) = of_name(named);
    let hand = side.map(Hands::One).filter(|hand| hands_of(seen).is_none_or(|own| own == *hand));
    Recording {
        name: of(stem),
        motion: of(&seen.path),
        annotations: annotations.iter().filter(|file| without_extension(file) == stem).map(|file| of(file)).collect(),
        gloss: gloss.map(of),
        span: None,
        details: Details { hand: hand.map(|hand| Spanned::new(hand, Span::default())), ..Details::default() },
    }
}

fn without_extension(path: &str) -> &str {
    path.rsplit_once('.').map_or(path, |(stem, _)| stem)
}

/// Gloss and hand of a file's name: `eight_0_right`, `ten-thousand_12`. Without a take's number the name may be anything,
/// and is no gloss.
fn of_name(stem: &str) -> (Option<&str>, Option<Side>) {
    let side = |word: &str| match word.to_lowercase().as_str() {
        "right" | "r" => Some(Side::Right),
        "left" | "l" => Some(Side::Left),
        _ => None,
    };
    let (rest, hand) = match stem.rsplit_once('_') {
        Some((rest, word)) if side(word).is_some() => (rest, side(word)),
        _ => (stem, None),
    };
    let gloss = rest.rsplit_once('_').filter(|(gloss, take)| {
        let is_number = !take.is_empty() && take.bytes().all(|c| c.is_ascii_digit());
        is_number && gloss.chars().any(char::is_alphabetic)
    });
    (gloss.map(|(gloss, _)| gloss), hand)
}

/// A field, for the headings of tables.
fn field_of_heading(heading: &str) -> Option<Field> {
    Some(match heading.to_lowercase().as_str() {
        "gloss" | "sign" | "label" => Field::Gloss,
        "name" | "id" => Field::Name,
        "hand" | "side" => Field::Hand,
        "signer" | "subject" | "performer" => Field::Signer,
        "licence" | "license" => Field::Licence,
        "credit" => Field::Credit,
        "annotation" | "annotations" | "eaf" => Field::Annotations,
        "dominant" => Field::Dominant,
        _ => return None,
    })
}
