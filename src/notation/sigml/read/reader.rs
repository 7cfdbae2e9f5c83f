//! What all parts of the reader share: attributes with their places, and what is said of them.

use super::words::{Exactness, TRUTH, Words};
pub(super) use crate::diagnostics::xml::{short, tag_span};
use crate::diagnostics::{Diagnostic, Severity, Span};
use crate::notation::suggest::nearest;

/// An element, or a text between elements.
pub(super) type Node<'a> = roxmltree::Node<'a, 'a>;

/// Faults and warnings of one file that are kept; the rest is counted.
const MOST_TOLD: usize = 1000;

/// An attribute.
#[derive(Clone, Copy)]
pub(super) struct Attr<'a> {
    pub name: &'a str,
    /// The value without the spaces around it.
    pub value: &'a str,
    /// The value as it stands.
    pub raw: &'a str,
    /// Of the value.
    pub span: Span,
}

/// The attributes of an element; those of other namespaces are nobody's concern here.
pub(super) fn attributes<'a>(node: Node<'a>) -> impl Iterator<Item = Attr<'a>> {
    node.attributes().filter(|attr| attr.namespace().is_none()).map(|attr| Attr {
        name: attr.name(),
        value: attr.value().trim(),
        raw: attr.value(),
        span: attr.range_value().into(),
    })
}

/// The elements within an element.
pub(super) fn elements<'a>(node: Node<'a>) -> impl Iterator<Item = Node<'a>> {
    node.children().filter(Node::is_element)
}

/// The sign that is read.
enum Place<'a> {
    Outside,
    Sign(Option<&'a str>, usize),
}

/// Reads elements, and keeps what is to be said.
pub(super) struct Reader<'a> {
    told: Vec<Diagnostic>,
    /// What was not kept.
    untold: usize,
    faults: usize,
    signs: usize,
    place: Place<'a>,
}

impl<'a> Reader<'a> {
    pub fn new() -> Reader<'a> {
        Reader { told: Vec::new(), untold: 0, faults: 0, signs: 0, place: Place::Outside }
    }

    /// Everything said, in the order of the text.
    pub fn told(mut self) -> Vec<Diagnostic> {
        self.told.sort_by_key(|told| told.span.start);
        if self.untold > 0 {
            let message = format!("{} more faults and warnings of this file are not shown", self.untold);
            self.told.push(Diagnostic::warning(Span::default(), message).label("in this file"));
        }
        self.told
    }

    /// The next sign begins.
    pub fn next_sign(&mut self, gloss: Option<&'a str>) {
        self.signs += 1;
        self.place = Place::Sign(gloss, self.signs);
    }

    /// What follows is of no sign.
    pub fn end_sign(&mut self) {
        self.place = Place::Outside;
    }

    /// How many faults there were.
    pub fn faults(&self) -> usize {
        self.faults
    }

    /// Keeps a fault or warning.
    pub fn say(&mut self, told: Diagnostic) {
        self.faults += usize::from(told.severity == Severity::Fault);
        if self.told.len() < MOST_TOLD {
            self.told.push(told);
        } else {
            self.untold += 1;
        }
    }

    /// Keeps what another reader said, named after the sign.
    pub fn adopt(&mut self, told: Diagnostic) {
        let message = self.named(&told.message);
        self.say(Diagnostic { message, ..told });
    }

    /// A fault, named after its sign.
    pub fn fault(&self, span: Span, message: &str) -> Diagnostic {
        Diagnostic::fault(span, self.named(message))
    }

    /// A warning, named after its sign.
    pub fn warning(&self, span: Span, message: &str) -> Diagnostic {
        Diagnostic::warning(span, self.named(message))
    }

    fn named(&self, message: &str) -> String {
        match self.place {
            Place::Outside => message.to_owned(),
            Place::Sign(Some(gloss), _) if !gloss.trim().is_empty() => format!("{}: {message}", short(gloss.trim())),
            Place::Sign(_, number) => format!("sign {number}: {message}"),
        }
    }

    /// A fault at a value: what it is not, the nearest that it might be, what could stand there.
    pub fn no_value(&mut self, attr: &Attr, what: &str, known: impl Iterator<Item = &'static str>) {
        let known: Vec<&str> = known.collect();
        let message = match attr.value {
            "" => format!("`{}` is empty: it should be {what}", attr.name),
            value => format!("`{}` is not {what}", short(value)),
        };
        let mut fault = self.fault(attr.span, &message).label(format!("expected {what}"));
        // Words of one or two letters are all near each other.
        let near = nearest(attr.value, known.iter().copied()).filter(|_| attr.value.len() > 2);
        if let Some(near) = near {
            fault = fault.hint(format!("did you mean `{near}`?"));
        }
        self.say(fault.hint(format!("what may stand here: {}", known.join(", "))));
    }

    /// The value of an attribute that has a list of them.
    pub fn value<T: Copy>(&mut self, attr: &Attr, words: &Words<T>) -> Option<T> {
        let found = words.find(attr.value).or_else(|| words.find(&attr.value.to_ascii_lowercase()));
        if found.is_none() {
            self.no_value(attr, words.what, words.list());
        }
        found
    }

    /// An attribute that is `true` or `false`.
    pub fn truth(&mut self, attr: &Attr) -> bool {
        self.value(attr, &TRUTH).unwrap_or(false)
    }

    /// A number above 0.
    pub fn factor(&mut self, attr: &Attr) -> Option<f64> {
        self.number(attr, "a number above 0", |n| n > 0.0)
    }

    /// A number that is not below 0.
    pub fn amount(&mut self, attr: &Attr) -> Option<f64> {
        self.number(attr, "a number from 0 up", |n| n >= 0.0)
    }

    fn number(&mut self, attr: &Attr, what: &str, fits: fn(f64) -> bool) -> Option<f64> {
        let number = attr.value.parse().ok().filter(|n: &f64| n.is_finite() && fits(*n));
        if number.is_none() {
            let message = format!("`{}` is not {what}", short(attr.value));
            self.say(self.fault(attr.span, &message).label(format!("expected {what}")));
        }
        number
    }

    /// A value that was taken though it is not quite what is defined.
    pub fn rounded(&mut self, attr: &Attr, exactness: Exactness, taken: &str) {
        match exactness {
            Exactness::Exact => {}
            Exactness::Rounded => self.odd(attr, &format!("`{}` is read as {taken}", short(attr.value))),
        }
    }

    /// A warning at a value.
    pub fn odd(&mut self, attr: &Attr, message: &str) {
        self.say(self.warning(attr.span, message).label("here"));
    }

    /// An attribute that is not of this element.
    pub fn unknown_attribute(&mut self, attr: &Attr, known: &[&'static str]) {
        if is_of_time(attr.name) {
            return;
        }
        let message = format!("`{}` is not an attribute of this element: passed over", short(attr.name));
        let mut told = self.warning(attr.span, &message).label("not read");
        if let Some(near) = nearest(attr.name, known.iter().copied()) {
            told = told.hint(format!("did you mean `{near}`?"));
        }
        self.say(told);
    }

    /// An element that may not stand here.
    pub fn unknown_element(&mut self, node: Node<'a>, known: &[&'static str]) {
        let name = node.tag_name().name();
        let message = format!("`{}` has no meaning here: passed over", short(name));
        let mut told = self.warning(tag_span(node), &message).label("not read");
        if let Some(near) = nearest(name, known.iter().copied()) {
            told = told.hint(format!("did you mean `{near}`?"));
        }
        self.say(told);
    }

    /// An element that has no attributes.
    pub fn no_attributes(&mut self, node: Node<'a>) {
        attributes(node).for_each(|attr| self.unknown_attribute(&attr, &[]));
    }

    /// Text between elements says nothing.
    pub fn no_text(&mut self, node: Node<'a>) {
        for child in node.children().filter(Node::is_text) {
            let range = child.range();
            let text = child.document().input_text().get(range.clone()).unwrap_or_default();
            if !text.trim().is_empty() {
                let start = range.start + text.len() - text.trim_start().len();
                let span = Span::new(start, start + text.trim().len());
                let told = self.warning(span, "text between elements is passed over");
                self.say(told.label("not read"));
            }
        }
    }

    /// An element that has nothing within it.
    pub fn no_content(&mut self, node: Node<'a>) {
        self.no_text(node);
        elements(node).for_each(|child| self.unknown_element(child, &[]));
    }
}

/// What gestural SiGML says of how tiers fit each other in time; it is not in the tree, and nothing is lost without it.
fn is_of_time(name: &str) -> bool {
    name.ends_with("synchronization") || matches!(name, "fitpicturetomanual" | "fitgesturetomanual")
}
