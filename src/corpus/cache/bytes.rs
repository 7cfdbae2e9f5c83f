//! Little-endian numbers and texts, written one after the other and read back with every length checked.

use crate::diagnostics::Error;

/// Bytes that grow.
#[derive(Debug, Default)]
pub(super) struct Sink(pub(super) Vec<u8>);

impl Sink {
    pub(super) fn u8(&mut self, value: u8) {
        self.0.push(value);
    }

    pub(super) fn u32(&mut self, value: u32) {
        self.0.extend(value.to_le_bytes());
    }

    pub(super) fn u64(&mut self, value: u64) {
        self.0.extend(value.to_le_bytes());
    }

    pub(super) fn f64(&mut self, value: f64) {
        self.0.extend(value.to_le_bytes());
    }

    pub(super) fn text(&mut self, text: &str) {
        self.u64(text.len() as u64);
        self.0.extend(text.as_bytes());
    }

    /// A list, its length in front.
    pub(super) fn list<T>(&mut self, items: &[T], mut one: impl FnMut(&mut Sink, &T)) {
        self.u64(items.len() as u64);
        items.iter().for_each(|item| one(self, item));
    }
}

/// Bytes that are read from the front.
#[derive(Debug, Clone, Copy)]
pub(super) struct Tap<'b>(pub(super) &'b [u8]);

impl<'b> Tap<'b> {
    fn take(&mut self, length: u64) -> Result<&'b [u8], Error> {
        let length = usize::try_from(length).ok().filter(|length| *length <= self.0.len());
        let (taken, rest) = self.0.split_at(length.ok_or_else(short)?);
        self.0 = rest;
        Ok(taken)
    }

    fn array<const N: usize>(&mut self) -> Result<[u8; N], Error> {
        self.take(N as u64)?.try_into().map_err(|_| short())
    }

    pub(super) fn u8(&mut self) -> Result<u8, Error> {
        self.array().map(u8::from_le_bytes)
    }

    pub(super) fn u32(&mut self) -> Result<u32, Error> {
        self.array().map(u32::from_le_bytes)
    }

    pub(super) fn u64(&mut self) -> Result<u64, Error> {
        self.array().map(u64::from_le_bytes)
    }

    pub(super) fn f64(&mut self) -> Result<f64, Error> {
        self.array().map(f64::from_le_bytes)
    }

    pub(super) fn text(&mut self) -> Result<String, Error> {
        let length = self.u64()?;
        let bytes = self.take(length)?;
        std::str::from_utf8(bytes).map(str::to_owned).map_err(|_| Error::new("a text in it is not UTF-8"))
    }

    /// A list. Every item takes at least a byte, so a length beyond what is left is refused before anything is kept.
    pub(super) fn list<T>(&mut self, mut one: impl FnMut(&mut Tap<'b>) -> Result<T, Error>) -> Result<Vec<T>, Error> {
        let length = self.u64()?;
        if length > self.0.len() as u64 {
            return Err(short());
        }
        (0..length).map(|_| one(self)).collect()
    }

    /// Refuses bytes that nobody asked for.
    pub(super) fn end(self) -> Result<(), Error> {
        if self.0.is_empty() { Ok(()) } else { Err(Error::new("there is more in it than should be")) }
    }
}

fn short() -> Error {
    Error::new("it ends too early")
}
