//! What is missing or odd about a corpus, found without building it.

use super::files::{Files, Finding, Place};
use super::manifest::{Listing, Rig, Take, our_tiers};
use super::motion::{Captured, HAND_M, PERSON_M, Size, begins_at_rest, captured, located};
use super::segment::Component;
use super::tiers::{annotations_of, component_of, our_label, our_name};
use crate::diagnostics::suggest::nearest;
use crate::diagnostics::{Diagnostic, Span};
use crate::motion::skeleton::JointId;
use crate::tier::Tier;
use std::collections::BTreeSet;
use std::path::{Component as Part, Path};

/// Frame rates that are not odd, frames a second.
const FPS: std::ops::RangeInclusive<f64> = 20.0..=250.0;
/// No joint of a signer turns faster, radians a second.
const FASTEST_TURN: f64 = 20.0;
/// No hand or foot of a signer moves faster, metres a second.
const FASTEST_POINT: f64 = 5.0;
/// Annotations may be so much longer than the motion, seconds: the end of the last frame, and rounding.
const LONGER_S: f64 = 0.1;

/// The names that labels are compared with.
#[derive(Debug, Clone, Default)]
pub struct Names {
    /// Of handshapes.
    pub configurations: Vec<String>,
    /// Of places.
    pub places: Vec<String>,
    /// Of our rig's joints.
    pub joints: Vec<String>,
}

impl Names {
    /// Those of a component; none where its labels are no plain names.
    fn of(&self, component: Component) -> Option<&[String]> {
        match component {
            Component::Configuration => Some(&self.configurations),
            Component::Placement => Some(&self.places),
            Component::Orientation | Component::Movement => None,
        }
    }
}

/// What is odd about the manifest and its recordings together; [`recording`] looks at each.
pub fn whole(listing: &Listing, names: &Names) -> Vec<Finding> {
    let mut findings = listing.findings.clone();
    let manifest = &listing.manifest;
    let place = |span: Span| Place { source: listing.source.clone(), span };
    if listing.takes.is_empty() {
        findings
            .push(place(Span::default()).fault("the corpus has no recording").hint("`chereme corpus init` finds them"));
    }
    for rule in &manifest.values {
        let told = |known: &str| {
            let told = place(rule.ours.span).fault(format!("`{}` is no {known} that is known", rule.ours.value));
            labelled(told, &rule.ours.value, names.of(rule.component).unwrap_or_default())
        };
        if names.of(rule.component).is_some_and(|known| !is_known(&rule.ours.value, known)) {
            findings.push(told(rule.component.title().to_lowercase().as_str()));
        }
    }
    let written = manifest.recordings.iter().flat_map(|own| own.annotations.iter().chain([&own.motion]));
    for path in written.chain(manifest.takes.iter().map(|table| &table.table)) {
        findings.extend(leads_away(&path.value).map(|how| {
            let told = place(path.span).warning(format!("the path {how}, so the corpus cannot be moved by itself"));
            told.label("not below the manifest's folder")
        }));
    }
    findings.extend(rigs(&manifest.skeletons, &names.joints, &place));
    for (what, lacks) in
        [("licence", without(listing, |take| &take.licence)), ("credit", without(listing, |take| &take.credit))]
    {
        if let [first, ..] = lacks[..] {
            let told =
                first.place.warning(format!("{} of {} recordings have no {what}", lacks.len(), listing.takes.len()));
            findings.push(
                told.label(format!("such as `{}`", first.name))
                    .hint(format!("`{what}:` at the top of corpus.yaml, or under `defaults`, holds for all")),
            );
        }
    }
    findings
}

fn without(listing: &Listing, of: fn(&Take) -> &Option<String>) -> Vec<&Take> {
    listing.takes.iter().filter(|take| of(take).is_none()).collect()
}

/// How a path leads out of the manifest's folder.
fn leads_away(path: &str) -> Option<&'static str> {
    let mut parts = Path::new(path).components();
    if Path::new(path).is_absolute() {
        return Some("is absolute");
    }
    parts.any(|part| part == Part::ParentDir).then_some("leads out of the corpus's folder")
}

/// Joints of ours that are none.
fn rigs(skeletons: &[Rig], ours: &[String], place: &dyn Fn(Span) -> Place) -> Vec<Finding> {
    let mut findings = Vec::new();
    for rig in skeletons {
        for (own, _) in rig.joints.iter().filter(|(own, _)| !ours.contains(&own.value)) {
            let told = place(own.span).fault(format!("our rig has no joint `{}`", own.value));
            findings.push(labelled(told, &own.value, ours));
        }
        if let (Some(up), Some(front)) = (rig.up, rig.front)
            && up.value.to_string()[1..] == front.value.to_string()[1..]
        {
            findings.push(place(front.span).fault("up and front are one line").label("expected another axis"));
        }
    }
    findings
}

/// Whether a label is a name that is known: its first part, in any case (`chest, touch` is at the chest).
fn is_known(label: &str, known: &[String]) -> bool {
    let first = first_part(label);
    // Places on the other hand, in space and at points are no rows of the inventory, and read all the same.
    let made = first.starts_with("other ") || first.starts_with("space") || first.starts_with('(');
    made || known.iter().any(|name| name.eq_ignore_ascii_case(first) || name.eq_ignore_ascii_case(label.trim()))
}

fn first_part(label: &str) -> &str {
    label.split([',', ';']).next().unwrap_or_default().trim()
}

fn labelled(told: Finding, word: &str, known: &[String]) -> Finding {
    match nearest(first_part(word), known.iter().map(String::as_str)) {
        Some(name) => told.label(format!("did you mean `{name}`?")),
        None => told.label("not known"),
    }
}

/// What is missing or odd about a recording: its files, its skeleton, its motion, its annotations.
pub fn recording(take: &Take, listing: &Listing, files: &dyn Files, names: &Names) -> Vec<Finding> {
    let mut findings = Vec::new();
    let motion = match files.read(&take.motion) {
        Ok(bytes) => match captured(&bytes, take, &listing.manifest, &listing.source) {
            Ok(captured) => {
                findings.extend(captured.findings.iter().cloned());
                findings.extend(odd_motion(take, &captured));
                Some(captured)
            }
            Err(faults) => {
                findings.extend(faults);
                None
            }
        },
        Err(e) => {
            findings.push(take.place.fault(e.to_string()).label("expected a file"));
            None
        }
    };
    for (path, place) in take.annotations.iter().zip(&take.annotation_places) {
        let read = files.read(path).map_err(|e| vec![place.fault(e.to_string()).label("expected a file")]);
        match read.and_then(|bytes| annotations_of(path, &take.name, &bytes).map_err(|all| located(path, &bytes, all)))
        {
            Ok(tiers) => findings.extend(odd_tiers(take, place, &tiers, listing, motion.as_ref(), names)),
            Err(faults) => findings.extend(faults),
        }
    }
    findings
}

fn odd_motion(take: &Take, captured: &Captured) -> Vec<Finding> {
    let warning = |what: String| take.place.warning(format!("{}: {what}", take.name));
    let mut findings = Vec::new();
    let fps = captured.clip.fps().get();
    if !FPS.contains(&fps) {
        findings.push(warning(format!("{fps:.2} frames a second are odd")).label("expected 20 to 250"));
    }
    match captured.size {
        Some(Size::Body(metres)) if !PERSON_M.contains(&metres) => {
            findings.push(
                warning(format!("the body is {metres:.2} m tall or wide")).label("a giant or a dwarf").hint(UNIT),
            );
        }
        Some(Size::Hand(metres)) if !HAND_M.contains(&metres) => {
            let told = warning(format!("the hand is {:.1} cm long", metres * 100.0));
            findings.push(told.label("a giant's or a dwarf's").hint(UNIT));
        }
        Some(Size::Body(_) | Size::Hand(_)) | None => {}
    }
    findings.extend(lacking_joints(captured).map(|what| warning(what).label("this part will stay at rest")));
    if begins_at_rest(&captured.clip) {
        let told = warning("the first frame is the rest pose, and no motion".to_owned());
        findings.push(told.hint("`skip_frames: 1` of its skeleton leaves it out"));
    }
    findings
        .extend(jumps(captured).into_iter().map(|what| warning(what).label("a fault of the recording, or its unit")));
    findings
}

const UNIT: &str = "`unit:` of its skeleton says how long one unit of the file is";

/// Parts of the body of which only some joints are there.
fn lacking_joints(captured: &Captured) -> Option<String> {
    let has = |name: &str| captured.joints.contains_key(name);
    let mut lacks: Vec<String> = Vec::new();
    let body = has("Hips") || has("Spine");
    for side in ["Left", "Right"] {
        let hand = format!("{side}Hand");
        let fingers: Vec<String> = ["Thumb", "Index", "Middle", "Ring", "Pinky"]
            .iter()
            .flat_map(|finger| (1..=3).map(|bone| format!("{side}Hand{finger}{bone}")).collect::<Vec<_>>())
            .collect();
        let some = fingers.iter().any(|finger| has(finger));
        if body || has(&hand) || some {
            let arm = [format!("{side}Arm"), format!("{side}ForeArm")];
            lacks.extend(arm.into_iter().filter(|joint| body && !has(joint)));
            lacks.extend([hand].into_iter().filter(|joint| !has(joint)));
            lacks.extend(fingers.into_iter().filter(|finger| some && !has(finger)));
        }
    }
    let more = if lacks.len() > 4 { format!(" and {} more", lacks.len() - 4) } else { String::new() };
    let first = lacks.iter().take(4).cloned().collect::<Vec<_>>().join(", ");
    (!lacks.is_empty()).then(|| format!("no joint of the file is our {first}{more}"))
}

/// The fastest turn of a joint, and the fastest hand or foot, where a body could not.
fn jumps(captured: &Captured) -> Vec<String> {
    let (clip, fps) = (&captured.clip, captured.clip.fps().get());
    let skeleton = clip.skeleton();
    let known: Vec<JointId> = captured.joints.values().filter_map(|name| skeleton.find(name)).collect();
    let ends = ["LeftHand", "RightHand", "LeftFoot", "RightFoot"];
    let ends = ends.iter().filter_map(|ours| skeleton.find(captured.joints.get(*ours)?)).collect::<Vec<_>>();
    let (mut turn, mut way) = (Fastest::default(), Fastest::default());
    let mut before = None;
    for (at, pair) in clip.frames().windows(2).enumerate() {
        let [a, b] = pair else { continue };
        let turns = known.iter().map(|id| (a.pose.rotation(*id).angle_between(b.pose.rotation(*id)) * fps, *id));
        turn.look(turns, at, FASTEST_TURN);
        let from = before.take().unwrap_or_else(|| a.pose.to_model(skeleton));
        let to = b.pose.to_model(skeleton);
        way.look(ends.iter().map(|id| (from.position(*id).distance(to.position(*id)) * fps, *id)), at, FASTEST_POINT);
        before = Some(to);
    }
    let told = |fastest: Fastest, what: &str, unit: &str| {
        let (speed, at, joint) = fastest.worst?;
        let time = captured.begins.0 + at as f64 / fps;
        let name = &skeleton[joint].name;
        let times = if fastest.count > 1 { format!(", and {} times more", fastest.count - 1) } else { String::new() };
        Some(format!("{name} {what} at {speed:.0} {unit} at {time:.2} s{times}"))
    };
    told(turn, "turns", "rad/s").into_iter().chain(told(way, "moves", "m/s")).collect()
}

/// Speeds beyond a limit.
#[derive(Default)]
struct Fastest {
    /// Speed, frame and joint of the fastest.
    worst: Option<(f64, usize, JointId)>,
    /// How many frames have one.
    count: usize,
}

impl Fastest {
    fn look(&mut self, speeds: impl Iterator<Item = (f64, JointId)>, frame: usize, limit: f64) {
        let over = speeds.filter(|(speed, _)| *speed > limit);
        let Some((speed, joint)) = over.max_by(|a, b| a.0.total_cmp(&b.0)) else { return };
        self.count += 1;
        if self.worst.is_none_or(|(worst, ..)| speed > worst) {
            self.worst = Some((speed, frame, joint));
        }
    }
}

fn odd_tiers(
    take: &Take,
    place: &Place,
    tiers: &[Tier],
    listing: &Listing,
    motion: Option<&Captured>,
    names: &Names,
) -> Vec<Finding> {
    let warning = |what: String| place.warning(format!("{}: {what}", take.name));
    let mut findings = Vec::new();
    let unmapped: Vec<&str> = tiers
        .iter()
        .map(|tier| tier.name.as_str())
        .filter(|name| our_name(&listing.manifest, name).is_none())
        // Beside a tier of ours, where its values came from.
        .filter(|name| name.strip_suffix(" Source").is_none_or(|of| our_name(&listing.manifest, of).is_none()))
        .collect();
    if !unmapped.is_empty() {
        let told = warning(format!("tiers that are none of ours: {}", unmapped.join(", ")));
        let ours: Vec<String> = our_tiers().collect();
        findings.push(
            told.label("left out").hint(format!("`tiers:` says what they are, such as `{}: {}`", unmapped[0], ours[0])),
        );
    }
    let ends = tiers.iter().flat_map(|tier| tier.values().iter().map(|value| value.end.0 + take.offset));
    let end = ends.fold(0.0, f64::max);
    if let Some(motion) = motion.filter(|motion| end > motion.file_duration.0 + LONGER_S) {
        let told = warning(format!("the annotation ends at {end:.2} s, after the motion"));
        findings
            .push(told.label(format!("the motion ends at {:.2} s", motion.file_duration.0)).hint("look at `offset`"));
    }
    let mut told: BTreeSet<(String, String)> = BTreeSet::new();
    for tier in tiers {
        let Some(name) = our_name(&listing.manifest, &tier.name) else { continue };
        let Some(known) = component_of(&name).and_then(|component| names.of(component)) else { continue };
        for value in tier.values() {
            let label = our_label(&listing.manifest, &name, &value.label);
            let empty = label.trim().is_empty();
            if !empty && !is_known(label, known) && told.insert((name.clone(), label.to_owned())) {
                let what = warning(format!("`{label}` on {} is not in the inventory", tier.name));
                findings.push(labelled(what, label, known).hint("`values:` says what it means"));
            }
        }
    }
    findings
}

/// Whether something found is a fault.
pub fn is_fault(diagnostic: &Diagnostic) -> bool {
    diagnostic.severity == crate::diagnostics::Severity::Fault
}
