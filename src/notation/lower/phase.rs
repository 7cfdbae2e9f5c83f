//! Phases of a sign: the tiers below a line `then`.

use super::Block;
use super::value::Names;
use crate::diagnostics::{Diagnostic, Span};
use crate::notation::syntax::{Begins, Content, Line, OtherHand, TierLine, Value};
use crate::phonology::Sign;

/// A line `then` and the tiers below it.
pub(super) struct Phase<'f> {
    /// Where the line stands.
    pub span: Span,
    /// What a hand does that does not act.
    pub other: OtherHand,
    /// The lines below.
    pub block: Block<'f>,
}

impl<'f> Block<'f> {
    /// One more line of the sign.
    pub(super) fn line(&mut self, line: &'f Line) {
        let mut begin = |other, broken| {
            let block = Block { name: self.name, broken, ..Block::default() };
            self.then.push(Phase { span: line.span.0, other, block });
        };
        match &line.content {
            Some(Content::Then(other)) => return begin(*other, false),
            Some(Content::Broken(Begins::Phase)) => return begin(OtherHand::Free, true),
            _ => {}
        }
        let block = match self.then.last_mut() {
            Some(phase) => &mut phase.block,
            None => self,
        };
        match &line.content {
            Some(Content::Tier(tier)) => block.tiers.push(tier),
            Some(Content::Broken(_)) => block.broken = true,
            Some(Content::Language(_) | Content::Sign(..) | Content::Then(_)) | None => {}
        }
    }
}

impl Phase<'_> {
    /// What its tiers say.
    pub(super) fn described(&self, names: &Names, faults: &mut Vec<Diagnostic>) -> Option<Sign> {
        faults.extend(self.block.tiers.iter().filter_map(|tier| self.of_the_whole(tier)));
        if self.block.tiers.is_empty() && !self.block.broken {
            let warning = Diagnostic::warning(self.span, "nothing is said of this phase");
            faults.push(warning.label("no tiers stand below it"));
        }
        let sign = self.block.described(names, faults)?;
        Some(Sign { holds_over: self.other == OtherHand::Stays, ..sign })
    }

    /// A fault for a tier that is not that of a phase.
    fn of_the_whole(&self, tier: &TierLine) -> Option<Diagnostic> {
        let hint = match &tier.value {
            Value::Hands(_)
            | Value::Configuration(_)
            | Value::Placement(_)
            | Value::Orientation(_)
            | Value::Movement(_)
            | Value::Contact(_)
            | Value::Duration(_)
            | Value::Speed(_) => return None,
            Value::NonManual(..) => {
                "it holds over all phases: move it up; `( … then … )` says what follows within a value"
            }
            Value::At(_) => "the whole sign is moved: move it up",
            Value::Meaning(_) | Value::Source(_) | Value::Status(_) | Value::Note(_) | Value::Base(_) => {
                "it is said of the whole sign: move it up"
            }
        };
        let word = tier.value.keyword();
        let fault = Diagnostic::fault(tier.keyword.0, format!("`{word}` stands before the first `then`"));
        Some(fault.label("here").related(self.span, "the phase that it stands in").hint(hint))
    }
}
