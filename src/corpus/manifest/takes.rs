//! The recordings of a manifest, one by one: those it lists itself, then those of its tables, with what the defaults say.

use super::fields::number;
use super::read::{hands, side};
use super::{Details, Field, Hands, Manifest, Recording, Table, read};
use crate::corpus::files::{Files, Finding, Place};
use crate::diagnostics::suggest::nearest;
use crate::diagnostics::{Diagnostic, Error, Source, Span, Spanned};
use crate::phonology::Side;
use std::collections::BTreeSet;
use std::path::{Path, PathBuf};
use std::sync::Arc;

/// A recording with all that holds for it.
#[derive(Debug, Clone, PartialEq)]
pub struct Take {
    /// Its name, which no other has.
    pub name: String,
    /// Its motion's file, its folder's path in front.
    pub motion: PathBuf,
    /// The files of its annotations.
    pub annotations: Vec<PathBuf>,
    /// Its gloss, where it is one sign.
    pub gloss: Option<String>,
    /// What of the motion to use, seconds from its start.
    pub span: Option<[f64; 2]>,
    /// The motion's instant at which annotations begin, seconds.
    pub offset: f64,
    /// The number of its skeleton in the manifest.
    pub rig: Option<usize>,
    /// The hands that it shows.
    pub hand: Option<Hands>,
    /// Who signs.
    pub signer: Option<String>,
    /// The strong hand.
    pub dominant: Side,
    /// Under which licence it may be used.
    pub licence: Option<String>,
    /// Whom to name.
    pub credit: Option<String>,
    /// Where its motion is named.
    pub place: Place,
    /// Where its annotations are named, one a file.
    pub annotation_places: Vec<Place>,
}

/// A corpus as its manifest and tables say.
#[derive(Debug, Clone)]
pub struct Listing {
    /// What the manifest says.
    pub manifest: Manifest,
    /// Its text.
    pub source: Arc<Source>,
    /// The recordings, in their order; of several with one name, the first.
    pub takes: Vec<Take>,
    /// What is wrong with the tables, and names used twice among them.
    pub findings: Vec<Finding>,
}

/// Reads a manifest and the tables that it names; `folder` is the manifest's.
///
/// # Errors
/// What is wrong with the manifest, as [`read`]. Tables that are missing or faulty are told among the findings.
pub fn listing(source: Source, folder: &Path, files: &dyn Files) -> Result<Listing, Vec<Diagnostic>> {
    let manifest = read(&source.text)?;
    let source = Arc::new(source);
    let mut list = List { manifest: &manifest, takes: Vec::new(), findings: Vec::new(), seen: BTreeSet::new() };
    for recording in &manifest.recordings {
        let take = list.take(recording, &[&recording.details], folder, &source);
        list.takes.extend(take);
    }
    for table in &manifest.takes {
        let path = folder.join(&table.table.value);
        match files.read(&path) {
            Ok(bytes) => list.table(table, &path, &bytes, &source),
            Err(error) => list.missing(table, &error, &source),
        }
    }
    let List { takes, findings, .. } = list;
    Ok(Listing { manifest, source, takes, findings })
}

struct List<'m> {
    manifest: &'m Manifest,
    takes: Vec<Take>,
    findings: Vec<Finding>,
    /// The names so far.
    seen: BTreeSet<String>,
}

impl List<'_> {
    /// A recording with what holds for it; `None` where its name was used before.
    fn take(&mut self, own: &Recording, details: &[&Details], folder: &Path, source: &Arc<Source>) -> Option<Take> {
        let place = |span: Span| Place { source: source.clone(), span };
        if !self.seen.insert(own.name.value.clone()) {
            let told = place(own.name.span).fault(format!("two recordings are called `{}`", own.name.value));
            self.findings.push(told.label("the second").hint("a column `name` can tell them apart"));
            return None;
        }
        let all = || details.iter().copied().chain([&self.manifest.defaults]);
        let text = |of: fn(&Details) -> &Option<Spanned<String>>| {
            all().find_map(|details| of(details).as_ref()).map(|text| text.value.clone())
        };
        let general = |of: &Option<Spanned<String>>| of.as_ref().map(|text| text.value.clone());
        let rig = text(|d| &d.skeleton);
        Some(Take {
            name: own.name.value.clone(),
            motion: folder.join(&own.motion.value),
            annotations: own.annotations.iter().map(|file| folder.join(&file.value)).collect(),
            gloss: own.gloss.as_ref().map(|gloss| gloss.value.clone()),
            span: own.span.map(|span| span.value),
            offset: all().find_map(|d| d.offset).map_or(0.0, |offset| offset.value),
            rig: rig.and_then(|name| self.manifest.skeletons.iter().position(|rig| rig.name.value == name)),
            hand: all().find_map(|d| d.hand).map(|hand| hand.value),
            signer: text(|d| &d.signer),
            dominant: all().find_map(|d| d.dominant).map_or(Side::Right, |side| side.value),
            licence: text(|d| &d.licence).or_else(|| general(&self.manifest.licence)),
            credit: text(|d| &d.credit).or_else(|| general(&self.manifest.credit)),
            place: place(own.motion.span),
            annotation_places: own.annotations.iter().map(|file| place(file.span)).collect(),
        })
    }

    fn missing(&mut self, table: &Table, error: &Error, source: &Arc<Source>) {
        let place = Place { source: source.clone(), span: table.table.span };
        self.findings.push(place.fault(format!("the table cannot be read: {error}")).label("expected a file"));
    }

    /// The recordings of a table.
    fn table(&mut self, table: &Table, path: &Path, bytes: &[u8], manifest: &Arc<Source>) {
        let name = path.to_string_lossy().into_owned();
        let source = Arc::new(Source::new(name, String::from_utf8_lossy(bytes)));
        let rows = match Rows::of(&source.text) {
            Ok(rows) => rows,
            Err(error) => return self.missing(table, &error, manifest),
        };
        let mut columns = Vec::new();
        for (field, heading) in &table.columns {
            match rows.headings.iter().position(|own| *own == heading.value) {
                Some(at) => columns.push((field.value, at)),
                None => {
                    let place = Place { source: manifest.clone(), span: heading.span };
                    let told = place.fault(format!("{} has no column `{}`", table.table.value, heading.value));
                    let guess = nearest(&heading.value, rows.headings.iter().map(String::as_str));
                    self.findings.push(match guess {
                        Some(known) => told.label(format!("did you mean `{known}`?")),
                        None => told.label(format!("its columns are {}", rows.headings.join(", "))),
                    });
                }
            }
        }
        let folder = path.parent().unwrap_or(Path::new(""));
        for (cells, span) in &rows.rows {
            let row = Row { cells, columns: &columns, place: Place { source: source.clone(), span: *span } };
            let Some((recording, details)) = row.recording(self) else { continue };
            let take = self.take(&recording, &[&details, &table.details], folder, &source);
            self.takes.extend(take);
        }
    }
}

/// A row of a table.
struct Row<'r> {
    cells: &'r [String],
    columns: &'r [(Field, usize)],
    place: Place,
}

impl Row<'_> {
    /// The cell of a field; `None` where it is empty.
    fn cell(&self, field: Field) -> Option<Spanned<String>> {
        let at = self.columns.iter().find(|(own, _)| *own == field)?.1;
        let cell = self.cells.get(at).map(|cell| cell.trim()).filter(|cell| !cell.is_empty())?;
        Some(Spanned::new(cell.to_owned(), self.place.span))
    }

    /// What a cell means; what means nothing is told.
    fn parsed<T>(
        &self,
        field: Field,
        expected: &str,
        parse: impl Fn(&str) -> Option<T>,
        list: &mut List<'_>,
    ) -> Option<Spanned<T>> {
        let cell = self.cell(field)?;
        let value = parse(&cell.value);
        if value.is_none() {
            let told = self.place.fault(format!("`{}` cannot be `{}`", field.word(), cell.value));
            list.findings.push(told.label(format!("expected {expected}")));
        }
        value.map(|value| Spanned::new(value, cell.span))
    }

    fn recording(&self, list: &mut List<'_>) -> Option<(Recording, Details)> {
        let Some(motion) = self.cell(Field::Motion) else {
            list.findings.push(self.place.fault("a row has no motion").label("this row is left out"));
            return None;
        };
        let stem = || motion.clone().map(|file| Path::new(&file).with_extension("").to_string_lossy().into_owned());
        let files = self.cell(Field::Annotations).map(|cell| cell.value).unwrap_or_default();
        let files = files.split(';').map(str::trim).filter(|file| !file.is_empty());
        let start = self.parsed(Field::Start, "seconds", number, list);
        let end = self.parsed(Field::End, "seconds", number, list);
        let span = match (start.map(|s| s.value), end.map(|e| e.value)) {
            (None, None) => None,
            (start, end) => Some([start.unwrap_or(0.0), end.unwrap_or(f64::MAX)]),
        };
        if span.is_some_and(|[start, end]| !(0.0 <= start && start < end)) {
            list.findings.push(self.place.fault("the end is not after the start").label("this row is left out"));
            return None;
        }
        let recording = Recording {
            name: self.cell(Field::Name).unwrap_or_else(stem),
            motion: motion.clone(),
            annotations: files.map(|file| Spanned::new(file.to_owned(), self.place.span)).collect(),
            gloss: self.cell(Field::Gloss),
            span: span.map(|span| Spanned::new(span, self.place.span)),
            details: Details::default(),
        };
        let details = Details {
            skeleton: self.skeleton(list),
            signer: self.cell(Field::Signer),
            dominant: self.parsed(Field::Dominant, "`right` or `left`", side, list),
            hand: self.parsed(Field::Hand, "`right`, `left` or `both`", hands, list),
            licence: self.cell(Field::Licence),
            credit: self.cell(Field::Credit),
            offset: self.parsed(Field::Offset, "a number of seconds", number, list),
        };
        Some((recording, details))
    }

    fn skeleton(&self, list: &mut List<'_>) -> Option<Spanned<String>> {
        let manifest = list.manifest;
        let known = |name: &str| manifest.skeletons.iter().any(|rig| rig.name.value == name).then(|| name.to_owned());
        self.parsed(Field::Skeleton, "a name under `skeletons`", known, list)
    }
}

/// A table as text, its rows with their places.
pub(in crate::corpus) struct Rows {
    pub(in crate::corpus) headings: Vec<String>,
    pub(in crate::corpus) rows: Vec<(Vec<String>, Span)>,
}

impl Rows {
    /// Tab-separated where the first line has a tab, without quotes; else CSV with commas or semicolons.
    pub(in crate::corpus) fn of(text: &str) -> Result<Rows, Error> {
        let skipped = text.len() - text.trim_start_matches('\u{feff}').len();
        let text = &text[skipped..];
        let first = text.lines().next().unwrap_or_default();
        let tabs = first.contains('\t');
        let delimiter = match (tabs, first.contains(',')) {
            (true, _) => b'\t',
            (false, true) => b',',
            (false, false) => b';',
        };
        let mut reader = csv::ReaderBuilder::new();
        let reader = reader.delimiter(delimiter).quoting(!tabs).has_headers(false).flexible(true);
        let mut rows = Vec::new();
        for record in reader.from_reader(text.as_bytes()).records() {
            let record = record.map_err(|e| Error::new(e.to_string()))?;
            let start = record.position().map_or(0, |at| usize::try_from(at.byte()).unwrap_or(usize::MAX));
            let rest = text.get(start..).unwrap_or_default();
            // The position may be that of line ends passed over before the row.
            let start = start + rest.len() - rest.trim_start_matches(['\r', '\n']).len();
            let length = text.get(start..).and_then(|rest| rest.lines().next()).map_or(0, str::len);
            let start = start + skipped;
            rows.push((record.iter().map(|cell| cell.trim().to_owned()).collect(), Span::new(start, start + length)));
        }
        if rows.is_empty() {
            return Err(Error::new("it is empty, without even headings"));
        }
        let headings = rows.remove(0).0;
        Ok(Rows { headings, rows })
    }
}
