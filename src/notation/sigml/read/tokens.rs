//! `hamnosys_manual`: the symbols of HamNoSys, an element each, in the order in which they stand.

use super::reader::{Node, Reader, attributes, tag_span};
use crate::diagnostics::{Severity, Span};
use crate::notation::hamnosys::lex::{Token, lex, named};
use crate::notation::hamnosys::parse;
use crate::notation::hamnosys::syntax::Phase;

impl<'a> Reader<'a> {
    /// The phases of a list of symbols. Elements within elements follow the one that they stand in; text may hold symbols too.
    pub(super) fn plain_manual(&mut self, node: Node<'a>, phases: &mut Vec<Phase>) {
        self.no_attributes(node);
        let faults = self.faults();
        let mut tokens = Vec::new();
        for part in node.descendants().skip(1) {
            if part.is_element() {
                attributes(part).for_each(|attr| self.unknown_attribute(&attr, &[]));
                let (token, told) = named(part.tag_name().name(), tag_span(part));
                tokens.extend(token);
                told.into_iter().for_each(|told| self.adopt(told));
            } else if part.is_text() {
                self.text(part, &mut tokens);
            }
        }
        // With a symbol missing, faults of the order would mislead; a sign of face and body alone has no symbols.
        if self.faults() > faults || tokens.is_empty() {
            return;
        }
        let end = node.range().end;
        let (read, told) = parse::phases(&tokens, Span::new(end, end));
        told.into_iter().for_each(|told| self.adopt(told));
        phases.extend(read.into_iter().flatten());
    }

    /// Symbols that are written as text.
    fn text(&mut self, node: Node<'a>, tokens: &mut Vec<Token>) {
        let text = node.text().unwrap_or_default();
        if text.trim().is_empty() {
            return;
        }
        let range = node.range();
        let verbatim = node.document().input_text().get(range.clone()) == Some(text);
        let place = |span: Span| match verbatim {
            true => Span::new(range.start + span.start, range.start + span.end),
            false => range.clone().into(),
        };
        let (read, told) = lex(text);
        tokens.extend(read.into_iter().map(|token| Token { span: place(token.span), ..token }));
        for mut told in told {
            told.span = place(told.span);
            told.related = told.related.map(|(span, what)| (place(span), what));
            if told.severity == Severity::Fault {
                told = told.hint("in H-SiGML symbols are elements, such as `<hamflathand/>`");
            }
            self.adopt(told);
        }
    }
}
