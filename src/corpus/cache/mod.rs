//! The cache of a corpus: its motions on our rig as `f32`, its tiers, its index, in one file that is mapped into memory.
//!
//! It is never the only copy of anything: a cache that is missing, damaged, or of another program is built anew from the
//! recordings. This is the only part of `corpus` that touches files, and only its own ([`disk`]).
//!
//! # The file
//! All numbers are little-endian.
//!
//! | part | what |
//! |---|---|
//! | head | `CHERCRPS`, then the version of this form as `u32`, and four bytes of 0 |
//! | frames | of each recording, frame by frame, the `f32` columns that change |
//! | table | what [`Head`] and the [`Entry`]s hold |
//! | index | any bytes; the segments' index |
//! | tail | six `u64`: where the table begins and its length, the same of the index, the hash of table and index each; the hash of these 48 bytes; `SPRCREHC` |
//!
//! Lengths and hashes are checked before anything is taken from the bytes; each recording's frames have their hash in
//! the table, which is checked when they are read.

mod bytes;
mod columns;
pub mod disk;
mod entry;
mod hash;
mod map;
mod write;

pub use entry::{Entry, Head, Off, SourceFile};
pub use hash::hash;
pub use write::{Frames, Writer};

use crate::diagnostics::Error;
use crate::motion::clip::Clip;
use crate::motion::skeleton::Skeleton;
use bytes::Tap;
use std::ops::Range;
use std::sync::Arc;

const HEAD: &[u8; 8] = b"CHERCRPS";
const TAIL: &[u8; 8] = b"SPRCREHC";
const FORM: u32 = 2;
const HEAD_BYTES: usize = 16;
const TAIL_BYTES: usize = 64;

/// A cache's bytes, and what its table says.
pub struct Cache {
    bytes: Bytes,
    head: Head,
    entries: Vec<Entry>,
    index: Range<usize>,
}

/// Where the bytes are.
enum Bytes {
    Memory(Vec<u8>),
    Mapped(memmap2::Mmap),
}

impl Bytes {
    fn get(&self) -> &[u8] {
        match self {
            Bytes::Memory(bytes) => bytes,
            Bytes::Mapped(map) => map,
        }
    }
}

impl Cache {
    /// A cache of bytes in memory.
    ///
    /// # Errors
    /// They are none, or are damaged: any bytes are an error or a cache, and never a panic.
    ///
    /// ```
    /// use chereme::corpus::cache::{Cache, Head, Writer};
    /// let written = Writer::new(Vec::new(), Head::default()).unwrap().finish(b"index").unwrap();
    /// let cache = Cache::from_bytes(written).unwrap();
    /// assert_eq!((cache.entries().len(), cache.index()), (0, &b"index"[..]));
    /// assert!(Cache::from_bytes(b"anything else".to_vec()).is_err());
    /// ```
    pub fn from_bytes(bytes: Vec<u8>) -> Result<Cache, Error> {
        Cache::open(Bytes::Memory(bytes))
    }

    fn open(bytes: Bytes) -> Result<Cache, Error> {
        let (head, entries, index) = open(bytes.get()).map_err(|e| e.context("the cache cannot be used"))?;
        Ok(Cache { bytes, head, entries, index })
    }

    /// What it was made by and for.
    pub fn head(&self) -> &Head {
        &self.head
    }

    /// The recordings, in their order.
    pub fn entries(&self) -> &[Entry] {
        &self.entries
    }

    /// The bytes of the index.
    pub fn index(&self) -> &[u8] {
        &self.bytes.get()[self.index.clone()]
    }

    /// The bytes of a recording's frames.
    ///
    /// # Errors
    /// They are damaged.
    pub fn frames(&self, entry: &Entry) -> Result<&[u8], Error> {
        let damaged = || Error::new(format!("the cache is damaged where the frames of `{}` are", entry.name));
        let frames = self.bytes.get().get(entry.at.clone()).ok_or_else(damaged)?;
        if hash(frames) == entry.hash { Ok(frames) } else { Err(damaged()) }
    }

    /// A recording's motion, `f64` in memory, on the rig that the cache was made for.
    ///
    /// # Errors
    /// Its frames are damaged, or of another rig.
    pub fn clip(&self, entry: &Entry, rig: &Arc<Skeleton>, morphs: &Arc<Vec<String>>) -> Result<Clip, Error> {
        let clip = entry.columns.clip(self.frames(entry)?, rig, morphs, entry.fps);
        clip.map_err(|e| e.context(format!("the cache cannot be used: `{}`", entry.name)))
    }
}

/// Table and index of a cache's bytes.
fn open(bytes: &[u8]) -> Result<(Head, Vec<Entry>, Range<usize>), Error> {
    let not_one = || Error::new("it is no cache of a corpus, or was cut short");
    if bytes.len() < HEAD_BYTES + TAIL_BYTES || !bytes.starts_with(HEAD) || !bytes.ends_with(TAIL) {
        return Err(not_one());
    }
    let mut front = Tap(&bytes[HEAD.len()..HEAD_BYTES]);
    if (front.u32()?, front.u32()?) != (FORM, 0) {
        return Err(Error::new("it has another form"));
    }
    let tail_at = bytes.len() - TAIL_BYTES;
    let mut tail = Tap(&bytes[tail_at..bytes.len() - TAIL.len()]);
    let [table_at, table_bytes, index_at, index_bytes, table_hash, index_hash] =
        [tail.u64()?, tail.u64()?, tail.u64()?, tail.u64()?, tail.u64()?, tail.u64()?];
    if tail.u64()? != hash(&bytes[tail_at..tail_at + 48]) {
        return Err(Error::new("its end is damaged"));
    }
    let table = part(bytes, table_at, table_bytes, table_hash, "table")?;
    let index = part(bytes, index_at, index_bytes, index_hash, "index")?;
    if table.end != index.start || index.end != tail_at {
        return Err(not_one());
    }
    let mut tap = Tap(&bytes[table.clone()]);
    let head = Head::read(&mut tap)?;
    // The frames of all recordings follow one another and leave no gap, so that every byte is covered by a hash.
    let mut at = HEAD_BYTES;
    let entries = tap.list(|tap| {
        let entry = Entry::read(tap, at)?;
        at = entry.at.end;
        Ok(entry)
    })?;
    tap.end()?;
    if at == table.start { Ok((head, entries, index)) } else { Err(not_one()) }
}

/// A part's range, where it lies in the bytes and has its hash.
fn part(bytes: &[u8], at: u64, length: u64, expected: u64, what: &str) -> Result<Range<usize>, Error> {
    let range = at.checked_add(length).and_then(|end| Some(usize::try_from(at).ok()?..usize::try_from(end).ok()?));
    let found = range.filter(|range| bytes.get(range.clone()).is_some_and(|part| hash(part) == expected));
    found.ok_or_else(|| Error::new(format!("its {what} is damaged")))
}
