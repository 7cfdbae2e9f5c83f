//! Fields of a map and their values, with what is wrong about them told and gone on from.

use super::yaml::Node;
use crate::diagnostics::suggest::nearest;
use crate::diagnostics::{Diagnostic, Span, Spanned};

/// What is wrong with a text, as far as it was read.
pub(super) type Faults = Vec<Diagnostic>;

/// The fields of a map.
pub(super) struct Fields<'n> {
    entries: &'n [(Spanned<String>, Spanned<Node>)],
    /// Where the map begins.
    pub(super) span: Span,
}

impl<'n> Fields<'n> {
    /// The fields of a map of which all field names are known; the others are told, and passed over.
    pub(super) fn of(node: &'n Spanned<Node>, what: &str, known: &[&str], faults: &mut Faults) -> Option<Fields<'n>> {
        let entries = map(node, what, faults)?;
        for (key, _) in entries.iter().filter(|(key, _)| !known.contains(&key.value.as_str())) {
            let fault = Diagnostic::fault(key.span, format!("{what} has no field `{}`", key.value));
            let guess = nearest(&key.value, known.iter().copied());
            faults.push(match guess {
                Some(name) => fault.label(format!("did you mean `{name}`?")),
                None => fault.label("not known").hint(format!("the fields are {}", known.join(", "))),
            });
        }
        Some(Fields { entries, span: node.span })
    }

    /// The value of a field, where it is there and is something.
    pub(super) fn get(&self, name: &str) -> Option<&'n Spanned<Node>> {
        let found = self.entries.iter().find(|(key, _)| key.value == name);
        found.map(|(_, value)| value).filter(|value| value.value != Node::Nothing)
    }

    /// The text of a field, where it is there.
    pub(super) fn text(&self, name: &str, faults: &mut Faults) -> Option<Spanned<String>> {
        text(self.get(name)?, name, faults)
    }

    /// The text of a field that has to be there.
    pub(super) fn required(&self, name: &str, what: &str, faults: &mut Faults) -> Option<Spanned<String>> {
        if self.get(name).is_none() {
            let missing = Diagnostic::fault(self.span, format!("{what} needs a field `{name}`"));
            faults.push(missing.label(format!("`{name}:` is missing")));
        }
        self.text(name, faults)
    }

    /// A field that is one of several words, or anything else that its letters say.
    pub(super) fn parsed<T>(
        &self,
        name: &str,
        expected: &str,
        parse: impl Fn(&str) -> Option<T>,
        faults: &mut Faults,
    ) -> Option<Spanned<T>> {
        parsed(&self.text(name, faults)?, name, expected, parse, faults)
    }
}

/// A text's meaning.
pub(super) fn parsed<T>(
    text: &Spanned<String>,
    name: &str,
    expected: &str,
    parse: impl Fn(&str) -> Option<T>,
    faults: &mut Faults,
) -> Option<Spanned<T>> {
    let value = parse(&text.value);
    if value.is_none() {
        let fault = Diagnostic::fault(text.span, format!("`{name}` cannot be `{}`", text.value));
        faults.push(fault.label(format!("expected {expected}")));
    }
    value.map(|value| Spanned::new(value, text.span))
}

/// A finite number.
pub(super) fn number(text: &str) -> Option<f64> {
    text.parse::<f64>().ok().filter(|number| number.is_finite())
}

/// A node's text.
pub(super) fn text(node: &Spanned<Node>, name: &str, faults: &mut Faults) -> Option<Spanned<String>> {
    match &node.value {
        Node::Text(text) => Some(Spanned::new(text.clone(), node.span)),
        other => {
            let fault = Diagnostic::fault(node.span, format!("`{name}` is one value, not {}", other.kind()));
            faults.push(fault.label("expected a value"));
            None
        }
    }
}

/// A node's entries.
pub(super) fn map<'n>(
    node: &'n Spanned<Node>,
    what: &str,
    faults: &mut Faults,
) -> Option<&'n [(Spanned<String>, Spanned<Node>)]> {
    match &node.value {
        Node::Map(entries) => Some(entries),
        Node::Nothing => Some(&[]),
        other => {
            let fault = Diagnostic::fault(node.span, format!("{what} has fields, and this is {}", other.kind()));
            faults.push(fault.label("expected `field: value`"));
            None
        }
    }
}

/// A node's items; a single value or map is a list of one.
pub(super) fn items(node: &Spanned<Node>) -> &[Spanned<Node>] {
    match &node.value {
        Node::List(items) => items,
        Node::Nothing => &[],
        Node::Text(_) | Node::Map(_) => std::slice::from_ref(node),
    }
}
