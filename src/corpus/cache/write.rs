//! A cache written from front to end: frames as recordings come, the table last.

use super::bytes::Sink;
use super::columns::Columns;
use super::entry::{Entry, Head};
use super::{Cache, FORM, HEAD, HEAD_BYTES, TAIL, hash};
use crate::body::signer::Signer;
use crate::diagnostics::Error;
use crate::motion::clip::Clip;
use crate::time::Fps;
use std::io::Write;

/// A recording's frames as a cache holds them.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Frames {
    pub(super) columns: Columns,
    pub(super) bytes: Vec<u8>,
}

impl Frames {
    /// The frames of a motion on our rig.
    ///
    /// # Errors
    /// There are more than 2³² of them.
    pub fn of(clip: &Clip) -> Result<Frames, Error> {
        Columns::of(clip).map(|(columns, bytes)| Frames { columns, bytes })
    }

    /// How many they are.
    pub fn count(&self) -> usize {
        self.columns.frames as usize
    }

    /// The motion again, as it will be read.
    ///
    /// # Errors
    /// They are of another rig, or none.
    pub fn clip(&self, signer: &Signer, fps: Fps) -> Result<Clip, Error> {
        self.columns.clip(&self.bytes, &signer.skeleton, &signer.morphs, fps)
    }

    /// Those that a cache holds already.
    ///
    /// # Errors
    /// They are damaged.
    pub fn kept(cache: &Cache, entry: &Entry) -> Result<Frames, Error> {
        Ok(Frames { columns: entry.columns.clone(), bytes: cache.frames(entry)?.to_vec() })
    }
}

/// Writes a cache.
pub struct Writer<W> {
    out: W,
    head: Head,
    at: usize,
    entries: Vec<Entry>,
}

impl<W: Write> Writer<W> {
    /// Begins a cache.
    ///
    /// # Errors
    /// What the output says.
    pub fn new(mut out: W, head: Head) -> Result<Writer<W>, Error> {
        let mut front = Sink(HEAD.to_vec());
        front.u32(FORM);
        front.u32(0);
        out.write_all(&front.0).map_err(told)?;
        Ok(Writer { out, head, at: HEAD_BYTES, entries: Vec::new() })
    }

    /// Adds a recording.
    ///
    /// # Errors
    /// What the output says.
    pub fn add(&mut self, entry: Entry, frames: &Frames) -> Result<(), Error> {
        self.out.write_all(&frames.bytes).map_err(told)?;
        let at = self.at..self.at + frames.bytes.len();
        self.at = at.end;
        self.entries.push(Entry { columns: frames.columns.clone(), at, hash: hash(&frames.bytes), ..entry });
        Ok(())
    }

    /// The recordings so far.
    pub fn entries(&self) -> &[Entry] {
        &self.entries
    }

    /// Writes table, index and end, and hands the output back.
    ///
    /// # Errors
    /// What the output says.
    pub fn finish(mut self, index: &[u8]) -> Result<W, Error> {
        let mut table = Sink::default();
        self.head.write(&mut table);
        table.list(&self.entries, |sink, entry| entry.write(sink));
        let (at, length) = (self.at as u64, table.0.len() as u64);
        let mut tail = Sink::default();
        for number in [at, length, at + length, index.len() as u64, hash(&table.0), hash(index)] {
            tail.u64(number);
        }
        tail.u64(hash(&tail.0));
        tail.0.extend(TAIL);
        for part in [&table.0[..], index, &tail.0] {
            self.out.write_all(part).map_err(told)?;
        }
        self.out.flush().map_err(told)?;
        Ok(self.out)
    }
}

fn told(error: std::io::Error) -> Error {
    Error::new(error.to_string())
}
