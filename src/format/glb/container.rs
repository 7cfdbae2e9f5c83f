//! The outer shell of a GLB file: a header, a JSON chunk and a binary chunk (glTF 2.0, section 4.4).

use crate::diagnostics::Error;
use serde_json::Value;

const MAGIC: u32 = u32::from_le_bytes(*b"glTF");
const JSON: u32 = u32::from_le_bytes(*b"JSON");
const BIN: u32 = u32::from_le_bytes(*b"BIN\0");

/// The two chunks of a file.
#[derive(Debug, Clone)]
pub(super) struct Container<'a> {
    /// The scene description.
    pub(super) json: Value,
    /// The numbers that it points into; empty where the file has none.
    pub(super) bin: &'a [u8],
}

fn u32_at(bytes: &[u8], at: usize) -> Option<u32> {
    let four = bytes.get(at..at.checked_add(4)?)?;
    Some(u32::from_le_bytes(four.try_into().ok()?))
}

impl<'a> Container<'a> {
    /// Takes a file apart.
    pub(super) fn parse(bytes: &'a [u8]) -> Result<Container<'a>, Error> {
        if u32_at(bytes, 0) != Some(MAGIC) {
            return Err(Error::new(
                "this is not a GLB file: it does not begin with \"glTF\" (is it a .gltf, or an FBX?)",
            ));
        }
        match u32_at(bytes, 4) {
            Some(2) => {}
            version => {
                let found = version.map_or("none".to_owned(), |v| v.to_string());
                return Err(Error::new(format!("a GLB file of version 2 is needed, this one says {found}")));
            }
        }
        let length = u32_at(bytes, 8).map_or(usize::MAX, |n| n as usize);
        let whole = bytes.get(..length).ok_or_else(|| cut_short(bytes.len()))?;
        let (kind, json, mut at) = chunk(whole, 12)?;
        if kind != JSON {
            return Err(Error::new("the first chunk of the GLB file is not its JSON"));
        }
        let json =
            serde_json::from_slice(json).map_err(|e| Error::new(format!("the GLB file's JSON cannot be read: {e}")))?;
        let mut bin: &[u8] = &[];
        while at < whole.len() {
            let (kind, data, next) = chunk(whole, at)?;
            if kind == BIN {
                bin = data;
                break;
            }
            at = next;
        }
        Ok(Container { json, bin })
    }

    /// Puts a file together; both chunks are padded to four bytes.
    pub(super) fn to_bytes(&self) -> Result<Vec<u8>, Error> {
        let mut json = self.json.to_string().into_bytes();
        json.resize(json.len().next_multiple_of(4), b' ');
        let mut bin = self.bin.to_vec();
        bin.resize(bin.len().next_multiple_of(4), 0);
        let length = 12 + 8 + json.len() + 8 + bin.len();
        let number = |n: usize| {
            u32::try_from(n)
                .map(u32::to_le_bytes)
                .map_err(|_| Error::new("the motion is too long for a GLB file (4 GB)"))
        };
        let mut bytes = Vec::with_capacity(length);
        for (length, kind, data) in [(json.len(), JSON, &json), (bin.len(), BIN, &bin)] {
            bytes.extend(number(length)?);
            bytes.extend(kind.to_le_bytes());
            bytes.extend(data);
        }
        let header = [MAGIC.to_le_bytes(), 2_u32.to_le_bytes(), number(length)?].concat();
        Ok([header, bytes].concat())
    }
}

/// The chunk at an offset: its kind, its bytes, and where the next one begins.
fn chunk(bytes: &[u8], at: usize) -> Result<(u32, &[u8], usize), Error> {
    let cut = || cut_short(bytes.len());
    let length = u32_at(bytes, at).ok_or_else(cut)? as usize;
    let kind = u32_at(bytes, at + 4).ok_or_else(cut)?;
    let end = (at + 8).checked_add(length).ok_or_else(cut)?;
    let data = bytes.get(at + 8..end).ok_or_else(cut)?;
    Ok((kind, data, end))
}

fn cut_short(length: usize) -> Error {
    Error::new(format!("the GLB file is cut short: it says it is longer than its {length} bytes"))
}
