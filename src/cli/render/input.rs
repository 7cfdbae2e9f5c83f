//! What is to be rendered: signs of files, of standard input, of the lexicon by name; gloss lines.

use super::super::signs::{Finder, Found};
use super::super::template::Origin;
use super::super::{Failure, Sources, gloss};
use super::Render;
use crate::format::html::Page;
use crate::notation::Lexicon;
use crate::notation::formats::Words;
use crate::phonology::grammar::fold;
use crate::phonology::operator::for_left_hander;
use crate::score::gloss::{CapturedGlosses, Handedness, Reading, Settings};
use crate::score::plan::Plan;
use crate::synthesis::Grammar;

/// Names of files are cut to so many characters: a gloss line may be longer than a file's name can be.
const LONGEST_NAME: usize = 80;

/// One thing to render: it becomes one performance, and one file in each format.
pub(super) struct Asked {
    /// The name of its files and of its messages.
    pub name: String,
    /// What is signed.
    pub plan: Plan,
    /// What a page says of it beside the motion.
    pub page: Page,
    /// Where it came from.
    pub origin: Origin,
}

/// All that a command line asks for, and whether some of its texts had faults.
pub(super) struct Request {
    /// In the order of the command line and of its files.
    pub asked: Vec<Asked>,
    /// Some text had a fault, which is told already; the sound rest is rendered.
    pub faulty: bool,
    /// How many signs are left out because of a fault.
    pub refused: usize,
}

/// Reads what a command line names.
pub(super) fn request(
    render: &Render,
    sources: &Sources,
    grammar: &Grammar,
    words: &Words,
    captured: &CapturedGlosses,
) -> Result<Request, Failure> {
    let mut signs = Vec::new();
    let mut lines = Vec::new();
    let mut faulty = false;
    let mut finder = Finder::new(sources, words, render.language.as_deref());
    let handedness = if render.left_handed { Handedness::Left } else { Handedness::Right };
    for what in &render.what {
        // A gloss that was captured is a line of one gloss.
        let is_line = |known: &Lexicon| {
            let unknown = || known.of_name(what).next().is_none();
            gloss::is_line(what, known) || captured.has(what) && (captured.preferred || unknown())
        };
        if let Some(known) = finder.named(what)?.filter(|known| is_line(known)) {
            let (language, captured) = (render.language.clone(), captured.clone());
            let settings = Settings { language, handedness, captured, ..Settings::default() };
            let reading = gloss::read_line(what, known, grammar, &words.vocabulary, &settings);
            if reading.has_faults() {
                faulty = true;
            } else {
                lines.push(of_line(what, reading));
            }
            continue;
        }
        signs.extend(finder.find(what)?);
    }
    faulty |= finder.faulty;
    choose(&mut signs, &render.sign)?;
    let by_signer = |found: Found| match handedness {
        Handedness::Right => found,
        Handedness::Left => Found { sign: for_left_hander(&found.sign), ..found },
    };
    let mut asked: Vec<Asked> = signs.into_iter().map(by_signer).map(of_sign).collect();
    asked.extend(lines);
    Ok(Request { asked, faulty, refused: finder.refused })
}

/// A gloss line: its name is the line itself.
fn of_line(text: &str, reading: Reading) -> Asked {
    let title = text.split_whitespace().collect::<Vec<_>>().join(" ");
    let name: String = title.chars().filter(|c| !c.is_control()).take(LONGEST_NAME).collect();
    let origin = Origin::of_line(&name, &reading.language);
    let facts = vec![("status".to_owned(), "unverified".to_owned())];
    Asked { name, plan: reading.plan, page: Page { title, language: reading.language, facts }, origin }
}

/// Keeps the signs of these names; all of them where no name is given.
fn choose(signs: &mut Vec<Found>, names: &[String]) -> Result<(), Failure> {
    if names.is_empty() {
        return Ok(());
    }
    let wanted: Vec<String> = names.iter().map(|n| fold(n)).collect();
    if let Some(missing) = wanted.iter().position(|w| !signs.iter().any(|s| fold(&s.sign.name) == *w)) {
        return Err(Failure::Faults(Some(format!("there is no sign {} in what was read", names[missing]))));
    }
    signs.retain(|s| wanted.contains(&fold(&s.sign.name)));
    Ok(())
}

fn of_sign(found: Found) -> Asked {
    let Found { sign, origin, .. } = found;
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
    Asked { name: sign.name.clone(), plan: Plan::of(sign), page, origin }
}
