//! A recording's tiers: those of its annotations under our names, with our labels, in the clip's time.

use super::manifest::{Hands, Manifest, Take, our_tiers};
use super::segment::Component;
use crate::body::retarget::Coverage;
use crate::diagnostics::{Diagnostic, Span};
use crate::format::{eaf, segments, textgrid};
use crate::phonology::Side;
use crate::tier::Tier;
use crate::time::Seconds;
use std::path::Path;

/// The tiers of an annotation file: ELAN, Praat, or a table of segments; its extension says the format. Times are the annotation's
/// own. Of a table with several recordings, those of the take count, and rows that name none.
///
/// # Errors
/// Its faults, by their place in its text.
pub fn annotations_of(path: &Path, take: &str, bytes: &[u8]) -> Result<Vec<Tier>, Vec<Diagnostic>> {
    let extension = path.extension().map(|e| e.to_string_lossy().to_lowercase()).unwrap_or_default();
    match extension.as_str() {
        "eaf" => eaf::read(bytes).map(|read| read.eaf.tiers.into_iter().map(|tier| tier.tier).collect()),
        "textgrid" => textgrid::read(bytes).map(|read| read.grid.tiers.into_iter().map(|tier| tier.tier).collect()),
        "tsv" | "csv" => {
            let own = |name: &str| {
                let stem = Path::new(name).file_stem().map(|stem| stem.to_string_lossy().into_owned());
                name.is_empty() || name.eq_ignore_ascii_case(take) || stem.is_some_and(|s| s.eq_ignore_ascii_case(take))
            };
            let recordings = segments::read(bytes)?.recordings;
            Ok(recordings.into_iter().filter(|r| own(&r.name)).flat_map(|r| r.tiers).collect())
        }
        _ => {
            let message = "annotations are .eaf, .TextGrid, .tsv or .csv files";
            Err(vec![Diagnostic::fault(Span::default(), message)])
        }
    }
}

/// When a clip is, in its file's time.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Window {
    /// The file's instant of the clip's first frame.
    pub begins: Seconds,
    /// How long the clip is.
    pub duration: Seconds,
}

/// Our name of an annotation's tier: the first rule that fits, else its own name where it is one of ours.
///
/// ```
/// use chereme::corpus::{manifest, tiers::our_name};
/// let manifest = manifest::read("version: 1\ntiers: {'Gl*': RH Gloss}\n").unwrap();
/// assert_eq!(our_name(&manifest, "gloss").as_deref(), Some("RH Gloss"));
/// assert_eq!(our_name(&manifest, "lh phase").as_deref(), Some("LH Phase"));
/// assert_eq!(our_name(&manifest, "Translation"), None);
/// ```
pub fn our_name(manifest: &Manifest, theirs: &str) -> Option<String> {
    let rule = manifest.tiers.iter().find(|rule| rule.fits(theirs)).map(|rule| rule.ours.value.clone());
    rule.or_else(|| our_tiers().find(|ours| ours.eq_ignore_ascii_case(theirs.trim())))
}

/// The component that a tier of ours is for.
///
/// ```
/// use chereme::corpus::{segment::Component, tiers::component_of};
/// assert_eq!(component_of("LH Placement"), Some(Component::Placement));
/// assert_eq!(component_of("LH Gloss"), None);
/// ```
pub fn component_of(tier: &str) -> Option<Component> {
    Component::ALL.into_iter().find(|component| tier.ends_with(component.title()))
}

/// Our label of a value: that of the first rule for it, else its own.
///
/// ```
/// use chereme::corpus::{manifest, tiers::our_label};
/// let manifest = manifest::read("version: 1\nvalues: {Configuration: {flat: flat-B}}\n").unwrap();
/// assert_eq!(our_label(&manifest, "RH Configuration", "Flat"), "flat-B");
/// assert_eq!(our_label(&manifest, "RH Placement", "flat"), "flat");
/// ```
pub fn our_label<'a>(manifest: &'a Manifest, tier: &str, theirs: &'a str) -> &'a str {
    let component = component_of(tier);
    let fits = |theirs_of: &str| theirs_of.to_lowercase() == theirs.trim().to_lowercase();
    let rule = manifest.values.iter().find(|rule| Some(rule.component) == component && fits(&rule.theirs.value));
    rule.map_or(theirs, |rule| rule.ours.value.as_str())
}

/// The tiers of a recording, from its clip's start: annotations file by file (with the name of each file), what lies
/// outside the clip cut off; then the gloss of a take that is one sign, for each hand that has no glosses.
///
/// ```
/// use chereme::body::retarget::Coverage;
/// use chereme::corpus::files::{Files, Stamp};
/// use chereme::corpus::{manifest, tiers::{Window, tiers}};
/// use chereme::{diagnostics::{Error, Source}, tier::Tier, time::Seconds};
/// # use std::path::Path;
/// # struct None;
/// # impl Files for None {
/// #     fn read(&self, _: &Path) -> Result<Vec<u8>, Error> { Err(Error::new("none")) }
/// #     fn stamp(&self, _: &Path) -> Option<Stamp> { Option::None }
/// # }
/// let text = "version: 1\ntiers: {'handshape *': RH Configuration}\nvalues: {Configuration: {flat: flat-B}}\n\
///             recordings: [{name: a, motion: a.bvh, offset: 2}]\n";
/// let listing = manifest::listing(Source::new("corpus.yaml", text), Path::new(""), &None).unwrap();
/// let mut theirs = Tier::new("Handshape right");
/// theirs.push(Seconds(0.0), Seconds(1.0), "Flat", "");
/// let window = Window { begins: Seconds(2.5), duration: Seconds(4.0) };
/// let ours = tiers(&listing.manifest, &listing.takes[0], &[("a.eaf".into(), vec![theirs])], window, Coverage::default());
/// assert_eq!((ours[0].name.as_str(), ours[0].values()[0].label.as_str()), ("RH Configuration", "flat-B"));
/// assert_eq!((ours[0].values()[0].start, ours[0].values()[0].end), (Seconds(0.0), Seconds(0.5)));
/// ```
pub fn tiers(
    manifest: &Manifest,
    take: &Take,
    annotations: &[(String, Vec<Tier>)],
    window: Window,
    covers: Coverage,
) -> Vec<Tier> {
    let mut ours: Vec<Tier> = Vec::new();
    for (file, theirs) in annotations {
        for tier in theirs {
            let Some(name) = our_name(manifest, &tier.name) else { continue };
            let at = ours.iter().position(|known| known.name == name).unwrap_or_else(|| {
                ours.push(Tier::new(&name));
                ours.len() - 1
            });
            add(&mut ours[at], tier, manifest, take, window, file);
        }
    }
    let hands = take.hand.unwrap_or(match covers.hands {
        [true, false] => Hands::One(Side::Left),
        [false, true] => Hands::One(Side::Right),
        [true, true] | [false, false] => Hands::Both,
    });
    if let Some(gloss) = &take.gloss {
        for (side, name) in [(Side::Right, "RH Gloss"), (Side::Left, "LH Gloss")] {
            if hands.has(side) && !ours.iter().any(|tier| tier.name == name) {
                let mut tier = Tier::new(name);
                tier.push(Seconds(0.0), window.duration, gloss, "corpus: gloss of the take");
                ours.push(tier);
            }
        }
    }
    // In the order of our tiers, whatever order the files have.
    let order: Vec<String> = our_tiers().collect();
    ours.sort_by_key(|tier| order.iter().position(|name| *name == tier.name));
    ours
}

/// Adds the values of a tier that lie within the clip.
fn add(ours: &mut Tier, theirs: &Tier, manifest: &Manifest, take: &Take, window: Window, file: &str) {
    for value in theirs.values() {
        let moved = |at: Seconds| (at.0 + take.offset - window.begins.0).clamp(0.0, window.duration.0);
        let (start, end) = (moved(value.start), moved(value.end));
        if end > start {
            let label = our_label(manifest, &ours.name, &value.label).to_owned();
            ours.push(Seconds(start), Seconds(end), label, format!("annotation: {file}"));
        }
    }
}
