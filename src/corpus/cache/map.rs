//! A file's bytes without reading them all: the one place of the crate with `unsafe` code.
#![allow(unsafe_code)]

use memmap2::Mmap;
use std::fs::File;
use std::io;

/// The bytes of a file, read from disk as they are looked at.
pub(super) fn map(file: &File) -> io::Result<Mmap> {
    // SAFETY: `Mmap::map` asks that nobody changes or cuts the file while it is mapped, because its bytes are then no
    // longer what Rust takes a shared slice for, and a page cut off raises SIGBUS. Chereme keeps that by how it writes
    // caches (`super::disk`): a cache is written under another name and renamed over the old one, never written to in
    // place, so a file once mapped keeps its content, even while another process builds anew and after its name is gone.
    // Whoever else writes into `.chereme/` by hand breaks this, as with every program that maps files; the mapping is
    // read-only, and every number that is taken from it is copied out and checked, so no value in it can be invalid for
    // its type.
    unsafe { Mmap::map(file) }
}
