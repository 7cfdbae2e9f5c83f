//! Elements and attributes, with their places.

use crate::diagnostics::xml::tag_span;
use crate::diagnostics::{Diagnostic, Span};
use crate::format::told::Told;

pub(super) type Node<'a> = roxmltree::Node<'a, 'a>;

/// The elements of a name within an element.
pub(super) fn named<'a>(node: Node<'a>, name: &'static str) -> impl Iterator<Item = Node<'a>> {
    node.children().filter(move |child| child.has_tag_name(name))
}

/// An attribute's value and its place.
pub(super) fn attribute<'a>(node: Node<'a>, name: &str) -> Option<(&'a str, Span)> {
    node.attribute_node(name).map(|a| (a.value(), a.range_value().into()))
}

/// An attribute's value that may be missing, as a text of one's own; missing is empty.
pub(super) fn owned(node: Node<'_>, name: &str) -> String {
    node.attribute(name).unwrap_or_default().to_owned()
}

/// An attribute that may be missing; an empty one is missing too.
pub(super) fn optional(node: Node<'_>, name: &str) -> Option<String> {
    node.attribute(name).filter(|value| !value.is_empty()).map(str::to_owned)
}

/// An attribute that the schema asks for; where it is missing, that is told.
pub(super) fn required<'a>(node: Node<'a>, name: &str, told: &mut Told) -> Option<(&'a str, Span)> {
    let found = attribute(node, name);
    if found.is_none() {
        let message = format!("`{}` has no {name}", node.tag_name().name());
        told.say(Diagnostic::fault(tag_span(node), message).label(format!("expected {name}=\"…\"")));
    }
    found
}

/// All text within an element, whatever stands between its parts.
pub(super) fn text(node: Node<'_>) -> String {
    node.descendants().filter(|n| n.is_text()).filter_map(|n| n.text()).collect()
}
