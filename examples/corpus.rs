//! A folder of captured signs is opened, asked by phonology, and one of its signs is signed again.
//!
//! `cargo run --example corpus -- FOLDER [QUERY [OUT.bvh]]` prints the recordings of a folder with a `corpus.yaml` and what the query finds
//! among them, and writes the take of the first hit, or of the first recording, to a BVH file. `docs/corpus.md` says how to come by such a
//! folder: `chereme corpus init FOLDER` writes its `corpus.yaml`.

use chereme::avatar;
use chereme::corpus::files::{Files, Stamp};
use chereme::corpus::library::{Library, vocabulary_of};
use chereme::corpus::manifest::{FILE_NAME, listing};
use chereme::corpus::query::{self, parse};
use chereme::diagnostics::render::render;
use chereme::diagnostics::{Diagnostic, Error, Source};
use chereme::format::bvh;
use chereme::notation::{Lexicon, Vocabulary};
use chereme::phonology::operator::Tables;
use chereme::score::gloss::{Known, Settings, read};
use chereme::synthesis::captured::{Captures, perform};
use chereme::synthesis::{Grammar, Options};
use std::fs;
use std::path::Path;
use std::time::UNIX_EPOCH;

/// Files as the system has them: the library itself opens none but those of its cache.
struct Disk;

impl Files for Disk {
    fn read(&self, path: &Path) -> Result<Vec<u8>, Error> {
        fs::read(path).map_err(|e| Error::new(e.to_string()).context(path.display()))
    }

    fn stamp(&self, path: &Path) -> Option<Stamp> {
        let data = fs::metadata(path).ok().filter(fs::Metadata::is_file)?;
        let since = data.modified().ok().and_then(|time| time.duration_since(UNIX_EPOCH).ok());
        let modified_ns = since.map_or(0, |since| u64::try_from(since.as_nanos()).unwrap_or(u64::MAX));
        Some(Stamp { size: data.len(), modified_ns })
    }
}

/// What a corpus has, what a query finds in it, and a take of it as the text of a BVH file; the cache is made in the folder `cache`.
pub fn shown(folder: &Path, asked: &str, cache: &Path) -> Result<(String, String), Error> {
    let signer = avatar::signer()?;
    let path = folder.join(FILE_NAME);
    let source = Source::new(path.to_string_lossy(), String::from_utf8_lossy(&Disk.read(&path)?));
    let listed = listing(source.clone(), folder, &Disk).map_err(|faults| told(&faults, &source))?;
    let (library, tally) = Library::open(listed, &signer, &Disk, cache)?;
    let mut text = format!("{} recordings, {} left out for their faults\n", library.len(), tally.failed);
    for recording in 0..library.len() {
        let gloss = library.take(recording).gloss.as_deref().unwrap_or("-");
        text += &format!("{}  {gloss}  {:.2} s\n", library.take(recording).name, library.duration(recording).0);
    }

    let vocabulary = vocabulary_of(library.listing(), &signer)?;
    let index = library.index(&vocabulary);
    let source = Source::new("query", asked);
    let query = parse(&source, &vocabulary).map_err(|faults| told(&faults, &source))?.query;
    let hits = index.find(&query, &query::Options { limit: 5, strict: false });
    text += &format!("{asked}\n");
    let mut first = None;
    for hit in &hits {
        let Some(segment) = index.segment(hit.segment) else { continue };
        let name = &library.take(segment.recording).name;
        first = first.or(Some(segment.recording));
        text += &format!("{name}  {:.2}-{:.2} s  ", segment.start.0, segment.end.0);
        text += &format!("{}\n", index.reasons(&query, hit).join("; "));
    }

    if library.is_empty() {
        return Err(Error::new("the corpus has no recording that can be used"));
    }
    let name = &library.take(first.unwrap_or(0)).name;
    let bvh = signed(&format!("take(\"{name}\")"), &library)?;
    text += &format!("signed: {name}\n");
    Ok((text, bvh))
}

/// A gloss line with takes of a corpus in it, as the text of a BVH file in centimetres.
fn signed(line: &str, library: &Library) -> Result<String, Error> {
    let (grammar, signer) = (Grammar::builtin(), avatar::signer()?);
    let (lexicon, vocabulary) = (Lexicon::builtin(), Vocabulary::builtin());
    let tables = Tables { locations: &grammar.locations, movements: &grammar.movements };
    let reading = read(line, &Known { lexicon: &lexicon, vocabulary: &vocabulary, tables }, &Settings::default());
    if reading.has_faults() {
        return Err(told(&reading.diagnostics, &Source::new("gloss line", line)));
    }
    let captures = Captures::of(library, &signer)?;
    let track = perform(&reading.plan, &captures, &grammar, &signer, &Options::default())?.track;
    bvh::write(&track.clip, &bvh::Options::default())
}

/// Faults of a text as one error, each with its line.
fn told(faults: &[Diagnostic], source: &Source) -> Error {
    Error::new(faults.iter().map(|fault| render(fault, source, false)).collect::<String>())
}

fn main() -> Result<(), Error> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let argument = |at: usize| arguments.get(at).map(String::as_str);
    let folder = argument(0).ok_or_else(|| Error::new("which folder with a corpus.yaml?"))?;
    let (query, out) = (argument(1).unwrap_or("hand=right"), argument(2).unwrap_or("take.bvh"));
    let cache = std::env::temp_dir().join(format!("chereme-corpus-{}", std::process::id()));
    let made = shown(Path::new(folder), query, &cache);
    // The cache is a copy of what the folder has, and may always go.
    let _ = fs::remove_dir_all(&cache);
    let (text, bvh) = made?;
    fs::write(out, bvh).map_err(|e| Error::new(e.to_string()).context(out))?;
    println!("{text}{out} is written");
    Ok(())
}
