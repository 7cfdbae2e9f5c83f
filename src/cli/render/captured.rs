//! `--corpus`: signs, hands and rest poses out of a corpus.

use super::super::Failure;
use super::Prefer;
use crate::body::signer::Signer;
use crate::corpus::library::Library;
use crate::diagnostics::Error;
use crate::phonology::operator::Operator;
use crate::phonology::{Configuration, Sign};
use crate::score::gloss::CapturedGlosses;
use crate::score::plan::{Act, Plan};
use crate::synthesis::captured::{Captures, Takes, perform};
use crate::synthesis::{Grammar, Options, Performance, synthesize_plan};

/// What a corpus gives to rendering; nothing where there is no corpus.
pub(super) struct Stock<'l> {
    captures: Option<Captures<'l>>,
    prefer: Prefer,
    /// The glosses that gloss lines may take from it.
    pub glosses: CapturedGlosses,
}

impl<'l> Stock<'l> {
    /// Makes ready what a corpus has; where captured motion is preferred the signer rests as captured.
    pub(super) fn of(library: Option<&'l Library>, prefer: Prefer, signer: &mut Signer) -> Result<Stock<'l>, Failure> {
        let failed = |e: Error| Failure::Faults(Some(e.to_string()));
        let Some(library) = library else {
            return Ok(Stock { captures: None, prefer, glosses: CapturedGlosses::default() });
        };
        let captures = Captures::of(library, signer).map_err(failed)?;
        if prefer == Prefer::Corpus {
            signer.resting = captures.resting().map_err(failed)?;
        }
        let glosses = CapturedGlosses { glosses: captures.glosses(), preferred: prefer == Prefer::Corpus };
        Ok(Stock { captures: Some(captures), prefer, glosses })
    }

    /// Signs a plan; what it takes from the corpus its tiers tell.
    pub(super) fn perform(
        &self,
        plan: &Plan,
        grammar: &Grammar,
        signer: &Signer,
        options: &Options,
    ) -> Result<Performance, Error> {
        let Some(captures) = &self.captures else {
            if let Some(item) = plan.items.iter().find(|item| matches!(item.act, Act::Captured(_))) {
                return Err(Error::new(format!("{}: takes are of a corpus: name it with --corpus", item.gloss)));
            }
            return synthesize_plan(plan, grammar, signer, options);
        };
        if self.prefer == Prefer::Procedure {
            return perform(plan, captures, grammar, signer, options);
        }
        let mut grammar = grammar.clone();
        for (configuration, language) in configurations(plan) {
            let language = (!language.is_empty()).then_some(language.as_str());
            let Ok(shape) = grammar.handshapes.find(&configuration.base, language) else { continue };
            let id = shape.id.clone();
            if !grammar.captured.contains_key(&id)
                && let Some(hand) = captures.configuration(&Configuration::named(id.clone()))
            {
                grammar.captured.insert(id, hand);
            }
        }
        perform(plan, captures, &grammar, signer, options)
    }
}

/// The plain configurations of a plan's described signs, with the language of each.
fn configurations(plan: &Plan) -> Vec<(Configuration, String)> {
    let mut all: Vec<(Configuration, String)> = Vec::new();
    let mut add = |configuration: &Configuration, language: &str| {
        let plain = configuration.changes.is_empty() && configuration.between.is_none();
        if plain && !all.iter().any(|(known, of)| known == configuration && of == language) {
            all.push((configuration.clone(), language.to_owned()));
        }
    };
    for item in &plan.items {
        match &item.act {
            Act::Sign(sign) => {
                let phases: Vec<&Sign> = sign.phases().collect();
                for phase in phases {
                    for (_, value) in phase.strong.configuration.iter().chain(phase.weak.configuration.iter()) {
                        add(value, &sign.language);
                    }
                }
            }
            Act::Captured(captured) => {
                for operator in &captured.operators {
                    if let Operator::Configuration(_, keys) = operator {
                        keys.iter().for_each(|(_, value)| add(value, ""));
                    }
                }
            }
            Act::Hold(..) | Act::Rest(_) => {}
        }
    }
    all
}
