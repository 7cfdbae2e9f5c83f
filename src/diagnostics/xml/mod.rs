//! XML that people and programs wrote: what is refused before it is parsed, and the parser's faults in plain words.
//!
//! Every reader of a format that is XML asks here, so that none of them meets a document type or a file that is made to
//! exhaust memory.

mod fault;
mod scan;

use super::{Diagnostic, Span};

/// A format that is XML.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct Xml {
    /// What people call it, for messages.
    pub name: &'static str,
    /// The largest text that is read, in bytes.
    pub most_bytes: usize,
    /// How many elements may stand within each other.
    pub most_deep: usize,
}

impl Xml {
    /// The elements of a text. Document types and entities of one's own are refused.
    ///
    /// # Errors
    /// The first thing that is no well-formed XML or is refused, with its place in `text`.
    ///
    /// ```
    /// use chereme::diagnostics::xml::Xml;
    /// let format = Xml { name: "EAF", most_bytes: 1 << 20, most_deep: 8 };
    /// assert_eq!(format.parse("<a><b/></a>").unwrap().root_element().tag_name().name(), "a");
    /// assert_eq!(format.parse("<a><b></a>").unwrap_err().message, "`</a>` closes `<b>`");
    /// ```
    pub fn parse<'a>(&self, text: &'a str) -> Result<roxmltree::Document<'a>, Diagnostic> {
        match scan::refused(text, self) {
            Some(fault) => Err(fault),
            None => roxmltree::Document::parse(text).map_err(|error| fault::fault(&error, text, self.name)),
        }
    }
}

/// Where the name of an element stands.
pub(crate) fn tag_span(node: roxmltree::Node<'_, '_>) -> Span {
    let range = node.range();
    let text = &node.document().input_text()[range.clone()];
    let end = text.find([' ', '\t', '\r', '\n', '/', '>']).unwrap_or(text.len());
    Span::new(range.start, range.start + end)
}

/// A text for a message: cut where it is long.
pub(crate) fn short(text: &str) -> String {
    const LONGEST: usize = 40;
    match text.char_indices().nth(LONGEST) {
        Some((end, _)) => format!("{}…", &text[..end]),
        None => text.to_owned(),
    }
}
