//! The files of a corpus on the disk.

use crate::corpus::cache::disk::since_1970;
use crate::corpus::files::{Files, Stamp};
use crate::diagnostics::Error;
use std::fs;
use std::io::ErrorKind;
use std::path::Path;

/// The largest file that is read, in bytes: ten hours of a body with fingers as BVH.
const LARGEST: u64 = 2 * 1024 * 1024 * 1024;

/// Files as the system has them.
pub(super) struct Disk;

impl Files for Disk {
    fn read(&self, path: &Path) -> Result<Vec<u8>, Error> {
        let told = |e: std::io::Error| match e.kind() {
            ErrorKind::NotFound => Error::new(format!("there is no file `{}`", path.display())),
            _ => Error::new(format!("{}: {e}", path.display())),
        };
        let data = fs::metadata(path).map_err(told)?;
        if !data.is_file() {
            return Err(Error::new(format!("`{}` is no file", path.display())));
        }
        if data.len() > LARGEST {
            return Err(Error::new(format!("{}: more than 2 GiB is not read", path.display())));
        }
        fs::read(path).map_err(told)
    }

    fn stamp(&self, path: &Path) -> Option<Stamp> {
        let data = fs::metadata(path).ok().filter(fs::Metadata::is_file)?;
        Some(Stamp { size: data.len(), modified_ns: data.modified().map(since_1970).unwrap_or(0) })
    }
}
