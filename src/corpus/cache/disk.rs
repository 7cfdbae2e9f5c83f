//! The cache's file: found, mapped, written aside and renamed.
//!
//! A build writes `.corpus.cache.<process>.new` beside the cache and renames it over the old one when all of it is on the
//! disk, so that a kill at any moment, or a power cut, leaves the old cache or the new one. Several builds at once each
//! write their own file, and the last rename counts: each of them is whole. What killed builds left behind, the next
//! build takes away.

use super::{Bytes, Cache, Head, Writer};
use crate::diagnostics::Error;
use std::fs::{self, File};
use std::io::{self, BufWriter};
use std::path::{Path, PathBuf};
use std::time::{Duration, SystemTime, UNIX_EPOCH};

/// The folder beside a manifest that holds its cache.
pub const FOLDER: &str = ".chereme";
const NAME: &str = "corpus.cache";

/// A build's file is left over when nothing was written to it for so long, where nobody can say whether the build lives.
const LEFT_OVER: Duration = Duration::from_secs(3600);

/// A file's time and a cache's may be this much apart, and the file still have changed after it was read: clocks of file
/// systems tick that coarsely (FAT: two seconds).
const TICK_NS: u64 = 2_000_000_000;

/// A cache on the disk.
pub struct OnDisk {
    /// What it holds.
    pub cache: Cache,
    /// Stamps of sources from this instant on say nothing, because the file may have changed again within the same tick
    /// of the clock: its content has to be compared. Nanoseconds since 1970.
    pub trusted_before_ns: u64,
}

/// Opens the cache of a folder.
///
/// # Errors
/// There is none, or it cannot be used.
pub fn open(folder: &Path) -> Result<OnDisk, Error> {
    let path = folder.join(NAME);
    let told = |e: io::Error| Error::new(format!("{}: {e}", path.display()));
    let file = File::open(&path).map_err(told)?;
    let written = file.metadata().map_err(told)?.modified().map(since_1970).unwrap_or(0);
    let cache = Cache::open(Bytes::Mapped(super::map::map(&file).map_err(told)?))?;
    Ok(OnDisk { cache, trusted_before_ns: written.saturating_sub(TICK_NS) })
}

/// Says that all sources were found unchanged by their content at an instant, so that next time their stamps do. Where the
/// file cannot be touched, their content is read again next time.
pub fn found_fresh(folder: &Path, at: SystemTime) {
    if let Ok(file) = File::options().append(true).open(folder.join(NAME)) {
        let _ = file.set_modified(at);
    }
}

/// The instant that a look at the sources begins at.
pub fn now() -> SystemTime {
    SystemTime::now()
}

/// Nanoseconds since 1970, as far as they go.
pub fn since_1970(time: SystemTime) -> u64 {
    let since = time.duration_since(UNIX_EPOCH).unwrap_or_default();
    u64::try_from(since.as_nanos()).unwrap_or(u64::MAX)
}

/// A cache that is being written aside.
pub struct Aside {
    /// Where to write.
    pub writer: Writer<BufWriter<File>>,
    beside: Beside,
    folder: PathBuf,
    begun: SystemTime,
}

/// A file that is taken away unless it was renamed.
struct Beside(PathBuf);

impl Drop for Beside {
    fn drop(&mut self) {
        // After the rename there is nothing of that name; without it, a build was given up.
        let _ = fs::remove_file(&self.0);
    }
}

/// Begins a cache in a folder, which is made where it is not there; what killed builds left is taken away.
///
/// # Errors
/// The folder cannot be made or written to.
pub fn begin(folder: &Path, head: Head) -> Result<Aside, Error> {
    let told = |e: io::Error| Error::new(format!("{}: {e}", folder.display()));
    fs::create_dir_all(folder).map_err(told)?;
    clean(folder);
    let begun = SystemTime::now();
    let beside = Beside(folder.join(format!(".{NAME}.{}.new", std::process::id())));
    let file = File::create(&beside.0).map_err(told)?;
    Ok(Aside { writer: Writer::new(BufWriter::new(file), head)?, beside, folder: folder.to_owned(), begun })
}

impl Aside {
    /// Ends the cache and puts it in the old one's place.
    ///
    /// # Errors
    /// What the file system says; the old cache stays.
    pub fn finish(self, index: &[u8]) -> Result<OnDisk, Error> {
        let told = |e: io::Error| Error::new(format!("{}: {e}", self.folder.display()));
        let file = self.writer.finish(index)?.into_inner().map_err(|e| told(e.into_error()))?;
        // Its time says which stamps of sources can be trusted: those from well before anything was read.
        file.set_modified(self.begun).and_then(|()| file.sync_all()).map_err(told)?;
        drop(file);
        fs::rename(&self.beside.0, self.folder.join(NAME)).map_err(told)?;
        open(&self.folder)
    }
}

/// Takes away what killed builds left.
fn clean(folder: &Path) {
    let Ok(entries) = fs::read_dir(folder) else { return };
    for path in entries.flatten().map(|entry| entry.path()) {
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        let process = name.strip_prefix(&format!(".{NAME}.")).and_then(|rest| rest.strip_suffix(".new"));
        if process.is_some_and(|process| is_left_over(&path, process)) {
            let _ = fs::remove_file(&path);
        }
    }
}

/// Whether the process that wrote a file is gone.
fn is_left_over(path: &Path, process: &str) -> bool {
    if process == std::process::id().to_string() {
        return true;
    }
    if Path::new("/proc/self").exists() {
        return !Path::new("/proc").join(process).exists();
    }
    let written = fs::metadata(path).and_then(|data| data.modified());
    written.is_ok_and(|at| at.elapsed().is_ok_and(|age| age > LEFT_OVER))
}
