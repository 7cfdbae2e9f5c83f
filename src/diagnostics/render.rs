//! Diagnostics as text: file, line, column, the source line and a caret.

use super::{Diagnostic, Severity, Source, Span};
use annotate_snippets::{AnnotationKind, Level, Renderer, Snippet};

/// Renders a diagnostic as compilers do, with the source line and a caret under the fault.
///
/// `colour` adds ANSI colours; ask for it on a terminal only.
pub fn render(diagnostic: &Diagnostic, source: &Source, colour: bool) -> String {
    let level = match diagnostic.severity {
        Severity::Warning => Level::WARNING,
        Severity::Fault => Level::ERROR.with_name(Some("fault")),
    };
    let mut snippet = Snippet::source(&source.text).path(&source.name).annotation(
        AnnotationKind::Primary.span(inside(diagnostic.span, &source.text)).label(diagnostic.label.as_str()),
    );
    if let Some((span, what)) = &diagnostic.related {
        snippet = snippet.annotation(AnnotationKind::Context.span(inside(*span, &source.text)).label(what.as_str()));
    }
    let mut group = level.primary_title(diagnostic.message.as_str()).element(snippet);
    for hint in &diagnostic.hints {
        group = group.element(Level::HELP.message(hint.as_str()));
    }
    let renderer = if colour { Renderer::styled() } else { Renderer::plain() };
    renderer.render(&[group])
}

/// The span cut to the text and moved outwards to whole characters.
fn inside(span: Span, text: &str) -> std::ops::Range<usize> {
    let mut start = span.start.min(text.len());
    while !text.is_char_boundary(start) {
        start -= 1;
    }
    let mut end = span.end.clamp(start, text.len());
    while !text.is_char_boundary(end) {
        end += 1;
    }
    start..end
}
