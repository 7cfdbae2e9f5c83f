//! What is refused before the XML is parsed: document types, and files built to exhaust memory or the stack.
//!
//! The parser of XML takes its time by elements, but keeps names of namespaces for each element and compares each
//! attribute with those before it; so both are counted here first, in one pass over the text.

use super::Xml;
use crate::diagnostics::{Diagnostic, Span};

/// Attributes of one element.
const MOST_ATTRIBUTES: usize = 256;
/// Namespaces that hold at one place.
const MOST_NAMESPACES: usize = 64;

/// The first thing that is refused.
pub(super) fn refused(text: &str, xml: &Xml) -> Option<Diagnostic> {
    if text.len() > xml.most_bytes {
        let message = format!("this file is larger than {} MiB", xml.most_bytes >> 20);
        let told = Diagnostic::fault(Span::new(0, 0), message);
        return Some(told.label("starts here").hint("split it into several files"));
    }
    let mut open: Vec<usize> = Vec::new();
    let mut namespaces = 0;
    let mut at = 0;
    while let Some(start) = byte(text, at, b'<') {
        let rest = &text[start..];
        let end = if rest.starts_with("<!--") {
            find(text, start + 4, "-->")
        } else if rest.starts_with("<![CDATA[") {
            find(text, start, "]]>")
        } else if rest.starts_with("<?") {
            find(text, start, "?>")
        } else if rest.starts_with("<!") {
            return Some(document_type(start, rest));
        } else if rest.starts_with("</") {
            namespaces -= open.pop().unwrap_or(0);
            byte(text, start, b'>')
        } else {
            let tag = tag(text, start)?;
            if tag.attributes > MOST_ATTRIBUTES {
                return Some(too_many(start, &format!("more than {MOST_ATTRIBUTES} attributes")));
            }
            if namespaces + tag.namespaces > MOST_NAMESPACES {
                return Some(too_many(start, &format!("more than {MOST_NAMESPACES} namespaces")));
            }
            if open.len() >= xml.most_deep {
                return Some(too_deep(start, xml.most_deep));
            }
            if tag.kind == Kind::Open {
                open.push(tag.namespaces);
                namespaces += tag.namespaces;
            }
            Some(tag.end)
        };
        at = end?;
    }
    None
}

/// Where a character of one byte is, from a place on.
fn byte(text: &str, from: usize, wanted: u8) -> Option<usize> {
    text.as_bytes().get(from..)?.iter().position(|byte| *byte == wanted).map(|i| from + i)
}

/// Where a mark is, from a place on.
fn find(text: &str, from: usize, mark: &str) -> Option<usize> {
    text.get(from..).and_then(|rest| rest.find(mark)).map(|i| from + i)
}

fn document_type(start: usize, rest: &str) -> Diagnostic {
    let end = rest.find(['[', '>', '\n']).unwrap_or(rest.len());
    Diagnostic::fault(Span::new(start, start + end), "a document type is not read here")
        .label("a document type or an entity of one's own")
        .hint("take this declaration out: nothing here needs it")
        .hint("of entities, `&lt;`, `&gt;`, `&amp;`, `&quot;` and `&apos;` are known, and characters by number (`&#233;`)")
}

fn too_many(start: usize, what: &str) -> Diagnostic {
    Diagnostic::fault(Span::new(start, start + 1), format!("this element has {what}")).label("here")
}

fn too_deep(start: usize, most: usize) -> Diagnostic {
    Diagnostic::fault(Span::new(start, start + 1), format!("more than {most} elements stand within each other"))
        .label("the one too deep")
        .hint("is a closing tag missing somewhere before?")
}

#[derive(PartialEq)]
enum Kind {
    Open,
    Closed,
}

/// A start tag.
struct Tag {
    /// Where its `>` is.
    end: usize,
    kind: Kind,
    attributes: usize,
    namespaces: usize,
}

/// The start tag at a place; `None` where it does not end.
fn tag(text: &str, start: usize) -> Option<Tag> {
    let bytes = text.as_bytes();
    let (mut attributes, mut namespaces) = (0, 0);
    let mut at = start + 1;
    loop {
        match bytes.get(at)? {
            b'>' => break,
            quote @ (b'"' | b'\'') => at = byte(text, at + 1, *quote)?,
            b'=' => attributes += 1,
            b'x' if bytes[at - 1].is_ascii_whitespace() && bytes[at..].starts_with(b"xmlns") => namespaces += 1,
            _ => {}
        }
        at += 1;
    }
    let kind = if bytes[at - 1] == b'/' { Kind::Closed } else { Kind::Open };
    Some(Tag { end: at, kind, attributes, namespaces })
}
