//! Elements to be written, and their text.

use super::words::{Words, letters};
use super::{MOST_DEEP, unsayable};
use crate::diagnostics::Error;
use crate::phonology::{Direction, Size};
use quick_xml::Writer;
use quick_xml::events::{BytesDecl, BytesEnd, BytesStart, Event};
use std::borrow::Cow;
use std::io;

/// An element.
#[derive(Debug)]
pub(super) struct Element {
    pub name: &'static str,
    pub attributes: Vec<(&'static str, Cow<'static, str>)>,
    pub children: Vec<Element>,
}

impl Element {
    pub fn new(name: &'static str) -> Element {
        Element { name, attributes: Vec::new(), children: Vec::new() }
    }

    /// With these elements in it.
    pub fn of(name: &'static str, children: Vec<Element>) -> Element {
        Element { name, attributes: Vec::new(), children }
    }

    pub fn set(&mut self, name: &'static str, value: impl Into<String>) {
        self.attributes.push((name, Cow::Owned(value.into())));
    }

    /// The word of a value.
    pub fn word<T: Copy>(&mut self, name: &'static str, value: T, words: &Words<T>) {
        self.attributes.push((name, Cow::Borrowed((words.word)(value))));
    }

    /// `true`, or nothing.
    pub fn mark(&mut self, name: &'static str, value: bool) {
        if value {
            self.attributes.push((name, Cow::Borrowed("true")));
        }
    }

    /// A size, where it is not the plain one.
    pub fn size(&mut self, name: &'static str, size: Size) {
        match size {
            Size::Normal => {}
            Size::Small | Size::Large => self.word(name, size, &super::words::SIZE),
        }
    }

    pub fn direction(&mut self, name: &'static str, direction: Direction) {
        self.set(name, letters(direction));
    }

    /// A number above 0, where it is said.
    pub fn factor(&mut self, name: &'static str, factor: Option<f64>) -> Result<(), Error> {
        let Some(factor) = factor else { return Ok(()) };
        if !(factor.is_finite() && factor > 0.0) {
            return unsayable(&format!("`{name}` should be a number above 0, not {factor}"));
        }
        self.set(name, factor.to_string());
        Ok(())
    }

    /// The element, where XML can hold it: no control characters, not too deep (within `sigml`).
    pub fn checked(self) -> Result<Element, Error> {
        self.check(2)?;
        Ok(self)
    }

    fn check(&self, depth: usize) -> Result<(), Error> {
        if depth > MOST_DEEP {
            return unsayable(&format!("more than {MOST_DEEP} elements would stand within each other"));
        }
        for (name, value) in &self.attributes {
            if let Some(c) = value.chars().find(|c| !is_of_xml(*c)) {
                return unsayable(&format!("XML cannot hold U+{:04X}, which is in `{name}`", u32::from(c)));
            }
        }
        self.children.iter().try_for_each(|child| child.check(depth + 1))
    }

    /// The element as a file.
    pub fn print(&self) -> Result<String, Error> {
        let mut xml = Writer::new_with_indent(Vec::new(), b' ', 2);
        let bytes = xml
            .write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))
            .and_then(|()| self.print_to(&mut xml))
            .map(|()| xml.into_inner());
        let bytes = bytes.map_err(|e| Error::new(e.to_string()).context("writing SiGML"))?;
        String::from_utf8(bytes).map(|text| text + "\n").map_err(|e| Error::new(e.to_string()).context("writing SiGML"))
    }

    fn print_to(&self, xml: &mut Writer<Vec<u8>>) -> io::Result<()> {
        let mut start = BytesStart::new(self.name);
        for (name, value) in &self.attributes {
            start.push_attribute((*name, &**value));
        }
        if self.children.is_empty() {
            return xml.write_event(Event::Empty(start));
        }
        xml.write_event(Event::Start(start))?;
        self.children.iter().try_for_each(|child| child.print_to(xml))?;
        xml.write_event(Event::End(BytesEnd::new(self.name)))
    }
}

/// Characters that XML 1.0 may hold.
fn is_of_xml(c: char) -> bool {
    matches!(c, '\t' | '\n' | '\r' | ' '..='\u{FFFD}' | '\u{10000}'..)
}
