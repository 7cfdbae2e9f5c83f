//! The second half of a BVH file: a count, a frame time, and a line of numbers a frame.

use super::hierarchy::{finite, short, stop};
use super::number::{few_digits, number};
use super::words::{Word, Words, is_blank};
use crate::diagnostics::{Diagnostic, Span};
use crate::time::Seconds;

/// More faults than these are counted, not shown.
const SHOWN: usize = 20;

/// Words that begin a line of a BVH file elsewhere.
const OTHER_PARTS: [&str; 6] = ["HIERARCHY", "ROOT", "JOINT", "MOTION", "Frames:", "Frame"];

/// What stands after `MOTION`.
pub(super) struct Motion {
    pub frame_time: Seconds,
    pub values: Vec<f64>,
    pub notes: Vec<Diagnostic>,
}

/// Reads from `MOTION` to the end, rows of `channels` numbers. All faults are in `notes`, the first ones in full.
pub(super) fn motion(words: &mut Words, channels: usize) -> Motion {
    let mut made = Motion { frame_time: Seconds(0.0), values: vec![], notes: vec![] };
    match words.next() {
        Some(word) if word.is("MOTION") => {}
        word => {
            let span = word.map_or(words.here(), |w| w.span);
            let hint = "a hierarchy without motion is no whole BVH file";
            made.notes.push(stop(span, "there is no MOTION", "expected MOTION").hint(hint));
            return made;
        }
    }
    match made.header(words) {
        Ok(frames) => made.rows(words, channels, frames),
        Err(stop) => made.notes.push(*stop),
    }
    made
}

impl Motion {
    /// `Frames: n` and `Frame Time: s`; answers the count and where it stands.
    fn header(&mut self, words: &mut Words) -> Result<(u64, Span), Box<Diagnostic>> {
        let count = entry(words, &["Frames"], "Frames: and a count")?;
        let Some(frames) = whole(count.text) else {
            let message = format!("`{}` is not a count of frames", short(count.text));
            return Err(stop(count.span, message, "expected a whole number, 0 or more").into());
        };
        let time = entry(words, &["Frame", "Time"], "Frame Time: and seconds")?;
        let seconds = finite(time)?;
        if seconds <= 0.0 {
            let fault = stop(time.span, "a frame lasts longer than nothing", "expected seconds above 0");
            return Err(fault.hint("Frame Time is in seconds: 0.01666667 at 60 frames a second").into());
        }
        if seconds >= 1.0 {
            let warning = Diagnostic::warning(time.span, format!("a frame of {seconds} s is long"));
            let hint = "Frame Time is in seconds a frame, not frames a second";
            self.notes.push(warning.label("1 s or more").hint(hint));
        }
        self.frame_time = Seconds(seconds);
        Ok((frames, count.span))
    }

    fn rows(&mut self, words: &mut Words, channels: usize, (frames, span): (u64, Span)) {
        let bytes = words.text.as_bytes();
        // A number takes two bytes of text at least, so this is in proportion to what is there.
        let most = (bytes.len() - words.at) / 2 + 1;
        self.values.reserve(most.min(usize::try_from(frames).unwrap_or(most).saturating_mul(channels)));
        let (mut rows, mut faulty) = (0u64, 0usize);
        loop {
            while bytes.get(words.at).is_some_and(|b| is_blank(*b) || matches!(b, b'\n' | b'\r')) {
                words.at += 1;
            }
            if words.at == bytes.len() {
                break;
            }
            let start = words.at;
            match row(bytes, start, channels, &mut self.values) {
                Some(end) => words.at = end,
                None => {
                    let (fault, goes_on) = match slow_row(words, channels) {
                        Row::Fault(fault) => (fault, true),
                        Row::NoMotion(fault) => (fault, false),
                        Row::FaceShapes(span) => {
                            let warning = Diagnostic::warning(span, "face shapes (BVHE) are not read");
                            self.notes.push(warning.label("from here on"));
                            break;
                        }
                    };
                    if faulty < SHOWN {
                        self.notes.push(*fault);
                    }
                    faulty += 1;
                    if !goes_on {
                        break;
                    }
                }
            }
            rows += 1;
        }
        if faulty > SHOWN {
            let message = format!("{} more rows have faults", faulty - SHOWN);
            self.notes.push(stop(words.here(), message, format!("the first {SHOWN} are shown")));
        } else if faulty == 0 && rows != frames {
            let message = format!("Frames: says {frames}, and there are {rows} rows");
            self.notes.push(Diagnostic::warning(span, message).label("the rows count"));
        }
    }
}

/// The value of a header line: keywords, a colon with or without blanks about it, a word, the end of the line.
fn entry<'a>(words: &mut Words<'a>, keywords: &[&str], expected: &str) -> Result<Word<'a>, Box<Diagnostic>> {
    let expected = format!("expected {expected}");
    let Some(first) = words.peek() else {
        return Err(stop(words.here(), "the file ends too early", expected).into());
    };
    words.at = first.span.start;
    let line = words.rest_of_line();
    let mut rest = line.text;
    for keyword in keywords {
        rest = match rest.get(..keyword.len()) {
            Some(said) if said.eq_ignore_ascii_case(keyword) => rest[keyword.len()..].trim_start(),
            _ => return Err(stop(line.span, format!("`{}` comes too early", short(line.text)), expected).into()),
        };
    }
    let value = rest.strip_prefix(':').unwrap_or(rest).trim_start();
    if value.is_empty() {
        return Err(stop(line.span, format!("{} has no value", keywords.join(" ")), expected).into());
    }
    let end = line.span.end;
    Ok(Word { text: value, span: Span::new(end - value.len(), end) })
}

/// A count, which some programs write as `12.0`.
fn whole(text: &str) -> Option<u64> {
    let digits =
        text.split_once('.').map_or(text, |(whole, rest)| if rest.trim_matches('0').is_empty() { whole } else { text });
    (!digits.is_empty() && digits.bytes().all(|b| b.is_ascii_digit())).then(|| digits.parse().unwrap_or(u64::MAX))
}

/// Reads a row that is as it should be and answers where its line ends; any other leaves `values` as they were.
#[inline]
fn row(bytes: &[u8], mut at: usize, channels: usize, values: &mut Vec<f64>) -> Option<usize> {
    let before = values.len();
    for _ in 0..channels {
        while bytes.get(at).is_some_and(|b| is_blank(*b)) {
            at += 1;
        }
        // Most angles of a hand are nothing.
        if let Some(b"0 ") = bytes.get(at..at + 2) {
            values.push(0.0);
            at += 1;
            continue;
        }
        if let Some((value, end)) = few_digits(bytes, at) {
            values.push(value);
            at = end;
            continue;
        }
        match number(&bytes[at..]) {
            Some((value, length)) if value.is_finite() && ends_word(bytes.get(at + length)) => {
                values.push(value);
                at += length;
            }
            _ => {
                values.truncate(before);
                return None;
            }
        }
    }
    while bytes.get(at).is_some_and(|b| is_blank(*b)) {
        at += 1;
    }
    if matches!(bytes.get(at), None | Some(b'\n' | b'\r')) {
        return Some(at);
    }
    values.truncate(before);
    None
}

#[inline(always)]
fn ends_word(next: Option<&u8>) -> bool {
    next.is_none_or(|b| is_blank(*b) || matches!(b, b'\n' | b'\r'))
}

/// What a line is that is no row.
enum Row {
    Fault(Box<Diagnostic>),
    /// Another part of a file begins; what follows is not rows.
    NoMotion(Box<Diagnostic>),
    /// The extension of PERFORMS and Animics begins.
    FaceShapes(Span),
}

/// Reads a row again, word by word, to say what is wrong with it; goes to the end of its line.
fn slow_row(words: &mut Words, channels: usize) -> Row {
    let mut line: Option<Span> = None;
    let mut count = 0;
    let mut wrong = None;
    while let Some(word) = words.next_on_line() {
        if count == 0 && word.is("BLENDSHAPES") {
            return Row::FaceShapes(word.span);
        }
        if count == 0 && OTHER_PARTS.iter().any(|keyword| word.is(keyword)) {
            let message = format!("`{}` among the rows", word.text);
            let fault = stop(word.span, message, "expected a row of numbers or the end");
            return Row::NoMotion(fault.hint("if these are two files in one, cut them apart").into());
        }
        if wrong.is_none() {
            wrong = finite(word).err();
        }
        count += 1;
        line = Some(line.map_or(word.span, |l| l.to(word.span)));
    }
    if let Some(fault) = wrong {
        return Row::Fault(fault);
    }
    let line = line.unwrap_or(words.here());
    let message = format!("this row has {count} numbers, and the joints have {channels} channels");
    let fault = stop(line, message, format!("expected {channels} numbers on one line"));
    Row::Fault(Box::new(match words.text[words.at..].trim().is_empty() && count < channels {
        true => fault.hint("this is the last row: the file may have been cut off"),
        false => fault,
    }))
}
