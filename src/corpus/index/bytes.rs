//! An index as bytes, and back.
//!
//! # Format
//! Little-endian. `CHXI`, the version (u32), then counts (u32) and arrays in the order of the fields; texts are a length in bytes
//! (u32) and UTF-8; at the end a checksum of all before it (FNV-1a, 64 bits), which tells a file that was cut off or damaged. Only what
//! was given is kept; lists and features are made anew, so that an index read with another inventory is right for that one.

use super::{About, Data, Index, NONE, Values, side_number, side_of};
use crate::corpus::label::Vocabulary;
use crate::diagnostics::Error;

const MAGIC: &[u8; 4] = b"CHXI";
/// To be raised whenever the format changes.
const VERSION: u32 = 1;
/// What stands for a text that is not known, in place of its length.
const ABSENT: u32 = u32::MAX;

impl Index {
    /// The segments and recordings as bytes (see the module); the same index gives the same bytes.
    ///
    /// ```
    /// use chereme::corpus::{index::Index, label::Vocabulary, segment::Segment};
    /// use chereme::motion::skeleton::Skeleton;
    /// let rig = Skeleton::from_json(chereme::avatar::SKELETON).unwrap();
    /// let vocabulary = Vocabulary::builtin(&rig, None).unwrap();
    /// let index = Index::build(&[], &[Segment::default()], &vocabulary);
    /// let bytes = index.to_bytes();
    /// assert_eq!(Index::from_bytes(&bytes, &vocabulary).unwrap(), index);
    /// assert!(Index::from_bytes(&bytes[..20], &vocabulary).is_err());
    /// ```
    pub fn to_bytes(&self) -> Vec<u8> {
        let mut out = MAGIC.to_vec();
        put(&mut out, VERSION);
        put(&mut out, self.recordings.len() as u32);
        for about in &self.recordings {
            put_text(&mut out, Some(&about.name));
            put_text(&mut out, about.signer.as_deref());
            out.push(side_number(about.dominant));
        }
        put_texts(&mut out, &self.glosses);
        put(&mut out, self.len() as u32);
        self.recording.iter().for_each(|n| put(&mut out, *n));
        out.extend_from_slice(&self.side);
        put_times(&mut out, &self.start);
        put_times(&mut out, &self.end);
        self.gloss.iter().for_each(|n| put(&mut out, *n));
        for column in &self.columns {
            put_texts(&mut out, &column.texts);
            put(&mut out, column.label.len() as u32);
            column.from.iter().for_each(|n| put(&mut out, *n));
            column.label.iter().for_each(|n| put(&mut out, *n));
            put_times(&mut out, &column.start);
            put_times(&mut out, &column.end);
        }
        let sum = checksum(&out);
        out.extend_from_slice(&sum.to_le_bytes());
        out
    }

    /// Reads what [`Index::to_bytes`] wrote.
    ///
    /// # Errors
    /// Bytes that are no such index, of another version, cut off, damaged, or that say what cannot be (numbers out of range,
    /// segments out of order). Memory stays in proportion to the bytes.
    pub fn from_bytes(bytes: &[u8], vocabulary: &Vocabulary) -> Result<Index, Error> {
        let data = read(bytes).map_err(|what| Error::new(format!("this is not a sound index of a corpus: {what}")))?;
        Ok(Index::of(data, vocabulary))
    }
}

fn put(out: &mut Vec<u8>, number: u32) {
    out.extend_from_slice(&number.to_le_bytes());
}

fn put_text(out: &mut Vec<u8>, text: Option<&str>) {
    put(out, text.map_or(ABSENT, |t| t.len() as u32));
    out.extend_from_slice(text.unwrap_or_default().as_bytes());
}

fn put_texts(out: &mut Vec<u8>, texts: &[String]) {
    put(out, texts.len() as u32);
    texts.iter().for_each(|text| put_text(out, Some(text)));
}

fn put_times(out: &mut Vec<u8>, times: &[f64]) {
    times.iter().for_each(|time| out.extend_from_slice(&time.to_le_bytes()));
}

/// FNV-1a over eight bytes at a time, the rest byte by byte.
fn checksum(bytes: &[u8]) -> u64 {
    const PRIME: u64 = 0x0100_0000_01B3;
    let mut sum = 0xCBF2_9CE4_8422_2325u64;
    let (words, rest) = bytes.as_chunks::<8>();
    for word in words {
        sum = (sum ^ u64::from_le_bytes(*word)).wrapping_mul(PRIME);
        // The product moves bits up only: what was there is brought down again.
        sum ^= sum >> 32;
    }
    rest.iter().fold(sum, |sum, byte| (sum ^ u64::from(*byte)).wrapping_mul(PRIME))
}

fn read(bytes: &[u8]) -> Result<Data, String> {
    let cut_off = || "it is cut off".to_owned();
    let (body, sum) = bytes.split_last_chunk::<8>().ok_or_else(cut_off)?;
    if !body.starts_with(MAGIC) {
        return Err("it does not begin as one".to_owned());
    }
    let mut rest = Bytes { rest: &body[MAGIC.len()..] };
    let version = rest.number()?;
    if version != VERSION {
        return Err(format!("its version is {version}, and this program reads version {VERSION}"));
    }
    if checksum(body) != u64::from_le_bytes(*sum) {
        return Err("its checksum does not fit: the file was cut off or damaged".to_owned());
    }
    let recordings = (0..rest.count(9)?).map(|_| rest.about()).collect::<Result<Vec<About>, String>>()?;
    let glosses = rest.texts()?;
    let count = rest.count(25)?;
    let recording = rest.numbers(count)?;
    let side = rest.take(count)?.to_vec();
    let (start, end) = (rest.times(count)?, rest.times(count)?);
    let gloss = rest.numbers(count)?;
    let mut values = Vec::with_capacity(4);
    for _ in 0..4 {
        values.push(rest.values(count)?);
    }
    let values: [Values; 4] = values.try_into().map_err(|_| cut_off())?;
    if !rest.rest.is_empty() {
        return Err(format!("{} bytes too many", rest.rest.len()));
    }
    let data = Data { recordings, recording, side, start, end, gloss, glosses, values };
    data.check().map(|()| data)
}

impl Data {
    /// What the arrays promise one another.
    fn check(&self) -> Result<(), String> {
        let order = |i: usize| (self.recording[i], self.start[i], self.side[i]);
        for i in 0..self.recording.len() {
            if self.side[i] > 2 {
                return Err(format!("segment {i} is of no hand"));
            }
            if self.gloss[i] != NONE && self.gloss[i] as usize >= self.glosses.len() {
                return Err(format!("segment {i} has a gloss that is not there"));
            }
            if i > 0 && order(i - 1).partial_cmp(&order(i)).is_none_or(std::cmp::Ordering::is_gt) {
                return Err(format!("segment {i} is out of order"));
            }
        }
        Ok(())
    }
}

/// What is left to read.
struct Bytes<'a> {
    rest: &'a [u8],
}

impl<'a> Bytes<'a> {
    fn take(&mut self, count: usize) -> Result<&'a [u8], String> {
        let (taken, rest) = self.rest.split_at_checked(count).ok_or("it is cut off")?;
        self.rest = rest;
        Ok(taken)
    }

    fn number(&mut self) -> Result<u32, String> {
        let bytes = self.take(4)?;
        Ok(bytes.iter().rev().fold(0, |all, byte| all << 8 | u32::from(*byte)))
    }

    /// A count of things of so many bytes each at least: one that the rest cannot hold is refused before anything is made of it.
    fn count(&mut self, least: usize) -> Result<usize, String> {
        let count = self.number()? as usize;
        if count.checked_mul(least).is_none_or(|bytes| bytes > self.rest.len()) {
            return Err(format!("it says that {count} things follow, and ends before"));
        }
        Ok(count)
    }

    fn numbers(&mut self, count: usize) -> Result<Vec<u32>, String> {
        let (words, _) = self.take(count.saturating_mul(4))?.as_chunks::<4>();
        Ok(words.iter().map(|word| u32::from_le_bytes(*word)).collect())
    }

    fn times(&mut self, count: usize) -> Result<Vec<f64>, String> {
        let (words, _) = self.take(count.saturating_mul(8))?.as_chunks::<8>();
        let times: Vec<f64> = words.iter().map(|word| f64::from_le_bytes(*word)).collect();
        if times.iter().all(|time| time.is_finite()) { Ok(times) } else { Err("a time is no number".to_owned()) }
    }

    fn text(&mut self) -> Result<Option<String>, String> {
        let length = self.number()?;
        if length == ABSENT {
            return Ok(None);
        }
        let bytes = self.take(length as usize)?;
        std::str::from_utf8(bytes).map(|text| Some(text.to_owned())).map_err(|_| "a text is not UTF-8".to_owned())
    }

    fn texts(&mut self) -> Result<Vec<String>, String> {
        let some = |text: Option<String>| text.ok_or_else(|| "a text is missing".to_owned());
        (0..self.count(4)?).map(|_| self.text().and_then(some)).collect()
    }

    fn about(&mut self) -> Result<About, String> {
        let name = self.text()?.ok_or("a recording has no name")?;
        let signer = self.text()?;
        let dominant = match self.take(1)? {
            [side @ 0..=2] => side_of(*side),
            _ => return Err("a recording's dominant hand is none".to_owned()),
        };
        Ok(About { name, signer, dominant })
    }

    fn values(&mut self, segments: usize) -> Result<Values, String> {
        let texts = self.texts()?;
        let count = self.count(20)?;
        let from = self.numbers(segments + 1)?;
        let sound = from.first() == Some(&0) && from.last() == Some(&(count as u32)) && from.is_sorted();
        if !sound {
            return Err("the values do not fit the segments".to_owned());
        }
        let label = self.numbers(count)?;
        if label.iter().any(|l| *l as usize >= texts.len()) {
            return Err("a value has a label that is not there".to_owned());
        }
        Ok(Values { texts, from, label, start: self.times(count)?, end: self.times(count)? })
    }
}
