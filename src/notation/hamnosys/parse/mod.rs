//! HamNoSys as a tree: from symbols to phases.
//!
//! The grammar is that of HamNoSys 4 (Hanke, *HamNoSys – Representing sign language data in language resources and language
//! processing contexts*, LREC 2004) as the ViSiCAST project fixed it for synthesis: a symmetry, hand shapes, finger directions, palms, a place,
//! then actions. It needs no backtracking: brackets are paired first, so that a look at what a bracket holds says
//! what it is for.
//!
//! # What is read although it is wrong
//! People write parts in another order, leave parts out, double symbols, forget brackets. Where the meaning is
//! clear, the text is read and a warning says what was assumed; where a symbol is passed over, a warning says that too.
//! Where the meaning is not clear, there is a fault, and no phases.
//!
//! # Conventions
//! - `hamplus` outside brackets joins phases. So do, with a warning, punctuation between symbols and a hand shape after a movement.
//! - Of alternatives, `{a|b}`, the first is read, with a warning.
//! - `hammime` says that what follows is mimed rather than notated: a warning, and passed over.
//! - Where brackets hold one action, they only group: the tree has no trace of them.

mod action;
mod brackets;
mod cursor;
mod group;
mod motion;
mod phase;
mod place;
mod posture;
mod repetition;
mod shape;
mod site;

use super::lex::{Token, lex};
use super::syntax::{Ignored, Phase, Sign};
use crate::diagnostics::{Diagnostic, Severity, Span};
use cursor::Parser;

pub(super) use cursor::Handed;
pub(super) use site::is_point;

/// Reads the symbols of one sign; `end` is where they end, for what is missing there.
///
/// With a fault there are no phases. No symbols at all are a fault too.
pub fn phases(tokens: &[Token], end: Span) -> (Option<Vec<Phase>>, Vec<Diagnostic>) {
    let mut parser = Parser::new(tokens, end);
    let phases = parser.phases();
    let faulty = parser.diagnostics.iter().any(|d| d.severity == Severity::Fault);
    ((!faulty).then_some(phases), parser.diagnostics)
}

/// Reads a whole text: characters of the font, names, or both (see [`lex`](super::lex)).
///
/// ```
/// use chereme::notation::hamnosys::{parse, syntax::Hands};
/// let (sign, diagnostics) = parse::sign("hamflathand,hamextfingeru,hampalmd,hamchest,hammoveo");
/// assert!(diagnostics.is_empty());
/// let phase = &sign.unwrap().phases[0];
/// assert_eq!((phase.hands, phase.actions.len()), (Hands::Strong, 1));
/// ```
pub fn sign(text: &str) -> (Option<Sign>, Vec<Diagnostic>) {
    let (tokens, mut diagnostics) = lex(text);
    if diagnostics.iter().any(|d| d.severity == Severity::Fault) {
        // The rest would be read with holes in it: its faults would mislead.
        return (None, diagnostics);
    }
    let whole = Span::new(0, text.len());
    let (phases, more) = phases(&tokens, Span::new(text.len(), text.len()));
    diagnostics.extend(more);
    let sign = phases.map(|phases| Sign { phases, span: Ignored(whole), ..Sign::default() });
    (sign, diagnostics)
}
