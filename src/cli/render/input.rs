//! What is to be rendered: signs of files, of standard input, or of the lexicon by name.

use super::super::{Failure, Sources, files, terminal, world};
use super::Render;
use crate::diagnostics::Severity;
use crate::format::html::Page;
use crate::notation::lexicon::language_of_path;
use crate::notation::{Vocabulary, read};
use crate::phonology::Sign;
use crate::phonology::grammar::fold;
use crate::score::plan::Plan;
use std::path::Path;

/// One thing to render: it becomes one performance, and one file in each format.
pub(super) struct Asked {
    /// The name of its files and of its messages.
    pub name: String,
    /// What is signed.
    pub plan: Plan,
    /// What a page says of it beside the motion.
    pub page: Page,
}

/// All that a command line asks for, and whether some of its texts had faults.
pub(super) struct Request {
    /// In the order of the command line and of its files.
    pub asked: Vec<Asked>,
    /// Some text had a fault, which is told already; the sound rest is rendered.
    pub faulty: bool,
}

/// Reads what a command line names.
pub(super) fn request(render: &Render, sources: &Sources, vocabulary: &Vocabulary) -> Result<Request, Failure> {
    let mut signs = Vec::new();
    let mut faulty = false;
    let mut lexicon = None;
    for what in &render.what {
        let path = Path::new(what);
        if what != "-" && !what.ends_with(".sign") && !path.exists() {
            let known = match &lexicon {
                Some(known) => known,
                None => lexicon.insert(world::lexicon(sources, vocabulary)?),
            };
            let entry = known.find(what, render.language.as_deref());
            signs.push(entry.map_err(|e| Failure::Faults(Some(e.to_string())))?.sign.clone());
            continue;
        }
        for text in files::read_all(&[path.to_owned()])? {
            let mut reading = read(&text.source.text, vocabulary, language_of_path(&text.source.name));
            reading.diagnostics.extend(text.fault);
            terminal::tell(&reading.diagnostics, &text.source);
            faulty |= reading.diagnostics.iter().any(|d| d.severity == Severity::Fault);
            signs.extend(reading.signs.into_iter().map(|s| s.sign));
        }
    }
    choose(&mut signs, &render.sign)?;
    Ok(Request { asked: signs.into_iter().map(of_sign).collect(), faulty })
}

/// Keeps the signs of these names; all of them where no name is given.
fn choose(signs: &mut Vec<Sign>, names: &[String]) -> Result<(), Failure> {
    if names.is_empty() {
        return Ok(());
    }
    let wanted: Vec<String> = names.iter().map(|n| fold(n)).collect();
    if let Some(missing) = wanted.iter().position(|w| !signs.iter().any(|s| fold(&s.name) == *w)) {
        return Err(Failure::Faults(Some(format!("there is no sign {} in what was read", names[missing]))));
    }
    signs.retain(|s| wanted.contains(&fold(&s.name)));
    Ok(())
}

fn of_sign(sign: Sign) -> Asked {
    let mut facts: Vec<(String, String)> = Vec::new();
    if !sign.meaning.is_empty() {
        let meanings: Vec<String> =
            sign.meaning.iter().map(|(language, words)| format!("{words} ({language})")).collect();
        facts.push(("meaning".into(), meanings.join(", ")));
    }
    facts.extend(sign.source.iter().map(|s| ("source".into(), s.clone())));
    let status = sign.status.clone().unwrap_or_else(|| "unverified".into());
    facts.push(("status".into(), status));
    facts.extend(sign.note.iter().map(|n| ("note".into(), n.clone())));
    let page = Page { title: sign.name.clone(), language: sign.language.clone(), facts };
    Asked { name: sign.name.clone(), plan: Plan::of(sign), page }
}
