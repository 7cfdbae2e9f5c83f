//! Signs made from others, over files and layers: their names looked up, and the signs made.
//!
//! A name is that of a sign of the same language first, then of any. Of several layers the last one that has the name
//! counts, whichever layer asks. Circles and unknown names are faults that name file and line of every step.

use super::{Checked, Entry, Key, Lexicon};
use crate::diagnostics::{Diagnostic, Error, Span};
use crate::notation::lower::Derived;
use crate::notation::print::expression;
use crate::notation::raise;
use crate::notation::suggest::nearest;
use crate::phonology::Sign;
use crate::phonology::grammar::fold;
use crate::phonology::operator::Tables;
use crate::phonology::recombination::{Wanted, made};
use std::collections::BTreeMap;

/// How many signs may be made from each other in a row.
const MOST_STEPS: usize = 24;

/// A sign still to be made, and where it was found.
#[derive(Debug, Clone, PartialEq)]
pub(super) struct Unmade {
    pub derived: Derived,
    pub path: String,
    pub line: usize,
    pub is_letter: bool,
    pub layer: usize,
}

impl Unmade {
    pub(super) fn place(&self) -> String {
        format!("{} ({}:{})", self.derived.own.name, self.path, self.line)
    }
}

impl Lexicon {
    /// Makes the signs that are made from others; their faults are added to the texts that they stand in.
    ///
    /// Call it when all sources are added. What cannot be made is left out.
    ///
    /// ```
    /// use chereme::diagnostics::Source;
    /// use chereme::notation::{Lexicon, Vocabulary};
    /// use chereme::phonology::movement_table::MovementTable;
    /// use chereme::phonology::operator::Tables;
    /// use chereme::phonology::LocationInventory;
    /// let text = "sign CLAIR\n  movement up 10cm\n\nsign FONCÉ = CLAIR inverted\n";
    /// let mut lexicon = Lexicon::default();
    /// let mut checked = lexicon.add([Source::new("lexicon/lsf/a.sign", text)], &Vocabulary::builtin());
    /// let (locations, movements) = (LocationInventory::builtin(), MovementTable::embedded());
    /// lexicon.link(&Tables { locations: &locations, movements: &movements }, &mut checked);
    /// assert_eq!(lexicon.find("FONCÉ", Some("lsf")).unwrap().sign.intervals, 1);
    /// assert_eq!(checked[0].signs, 2);
    /// ```
    pub fn link(&mut self, tables: &Tables, checked: &mut [Checked]) {
        let keys: Vec<Key> = self.unmade.keys().cloned().collect();
        let mut maker = Maker { lexicon: self, tables, failed: BTreeMap::new(), told: Vec::new() };
        for key in keys {
            // A failure is told where it happens.
            let _ = maker.make(&key, &mut Vec::new());
        }
        let told = maker.told;
        for (path, diagnostic) in told {
            if let Some(text) = checked.iter_mut().find(|c| c.source.name == path) {
                text.diagnostics.push(diagnostic);
                text.diagnostics.sort_by_key(|d| d.span.start);
            }
        }
        for text in checked {
            let own = self.entries.values().filter(|e| e.derived.is_some() && e.path == text.source.name);
            text.signs += own.count();
        }
        self.unmade.clear();
    }
}

struct Maker<'l> {
    lexicon: &'l mut Lexicon,
    tables: &'l Tables<'l>,
    /// What could not be made, and where it stands.
    failed: BTreeMap<Key, String>,
    /// Faults and warnings with the files they belong to.
    told: Vec<(String, Diagnostic)>,
}

impl Maker<'_> {
    /// The sign of a key, made where it is not yet. `steps` are the signs that are being made.
    fn make(&mut self, key: &Key, steps: &mut Vec<Key>) -> Result<Sign, Error> {
        if let Some(entry) = self.lexicon.entries.get(key) {
            return Ok(entry.sign.clone());
        }
        if let Some(place) = self.failed.get(key) {
            return Err(Error::new(format!("{place} has a fault")));
        }
        let Some(unmade) = self.lexicon.unmade.get(key).cloned() else {
            return Err(Error::new("there is no such sign"));
        };
        if let Some(first) = steps.iter().position(|k| k == key) {
            let way = steps[first..].iter().chain([key]).filter_map(|k| self.lexicon.unmade.get(k)).map(Unmade::place);
            return Err(Error::new(format!("this sign is made from itself: {}", way.collect::<Vec<_>>().join(" → "))));
        }
        if steps.len() >= MOST_STEPS {
            return Err(Error::new(format!("more than {MOST_STEPS} signs are made from each other here")));
        }
        steps.push(key.clone());
        let mut source = None;
        let tables = self.tables;
        let mut find = |wanted: Wanted| self.find(wanted, &unmade, steps, &mut source);
        let result = made(&unmade.derived.from, &mut find, tables);
        steps.pop();
        match result {
            Ok(applied) => {
                for warning in applied.warnings {
                    let warning = Diagnostic::warning(unmade.derived.name_span, warning).label("in this sign");
                    self.told.push((unmade.path.clone(), warning));
                }
                let sign = finished(&unmade.derived, applied.sign, source);
                let entry = Entry {
                    sign: sign.clone(),
                    path: unmade.path,
                    line: unmade.line,
                    is_letter: unmade.is_letter,
                    layer: unmade.layer,
                    span: unmade.derived.name_span,
                    derived: Some(unmade.derived.from),
                };
                self.lexicon.entries.insert(key.clone(), entry);
                Ok(sign)
            }
            Err(error) => {
                self.failed.insert(key.clone(), unmade.place());
                self.told.push((unmade.path.clone(), self.fault(&unmade, &error)));
                Err(Error::new(format!("{} has a fault", unmade.place())))
            }
        }
    }

    fn find(
        &mut self,
        wanted: Wanted,
        of: &Unmade,
        steps: &mut Vec<Key>,
        source: &mut Option<String>,
    ) -> Result<Sign, Error> {
        let language = of.derived.own.language.to_lowercase();
        match wanted {
            Wanted::Sign(name) => {
                let key = self.key_of(name, &language)?;
                let sign = self.make(&key, steps)?;
                if source.is_none() {
                    *source = sign.source.as_ref().map(|text| format!("{}: {text}", sign.name));
                }
                Ok(sign)
            }
            Wanted::Letter(letter) => {
                let key = (language.clone(), fold(letter));
                let sign = self.make(&key, steps);
                let is_letter = self.lexicon.entries.get(&key).is_some_and(|e| e.is_letter);
                match sign {
                    Ok(sign) if is_letter => Ok(sign),
                    _ if language.is_empty() => {
                        Err(Error::new(format!("which language's letter {letter}? a line `language lsf` says it")))
                    }
                    _ => Err(Error::new(format!("the alphabet of {language} has no letter {letter}"))),
                }
            }
        }
    }

    /// The key of a name: in the language first, then in all.
    fn key_of(&self, name: &str, language: &str) -> Result<Key, Error> {
        let folded = fold(name);
        let own = (language.to_owned(), folded.clone());
        let known = |key: &Key| self.lexicon.entries.contains_key(key) || self.lexicon.unmade.contains_key(key);
        if known(&own) {
            return Ok(own);
        }
        let all = || self.lexicon.entries.keys().chain(self.lexicon.unmade.keys());
        let mut hits: Vec<&Key> = all().filter(|(_, n)| *n == folded).collect();
        hits.sort();
        hits.dedup();
        match hits.as_slice() {
            [one] => Ok((*one).clone()),
            [] => {
                let entries = self.lexicon.entries.values().map(|e| e.sign.name.as_str());
                let names = entries.chain(self.lexicon.unmade.values().map(|u| u.derived.own.name.as_str()));
                let near = nearest(name, names).map(|n| format!("; did you mean `{n}`?")).unwrap_or_default();
                Err(Error::new(format!("there is no sign `{name}`{near}")))
            }
            several => {
                let languages: Vec<&str> = several.iter().map(|(l, _)| l.as_str()).collect();
                Err(Error::new(format!("`{name}` is a sign of several languages: {}", languages.join(", "))))
            }
        }
    }

    /// The fault of a sign that cannot be made, at the name that is to blame where one is.
    fn fault(&self, unmade: &Unmade, error: &Error) -> Diagnostic {
        let message = error.to_string();
        let blamed = unmade.derived.names.iter().find(|n| message.contains(&format!("`{}`", n.value)));
        let span: Span = blamed.map_or(unmade.derived.name_span, |n| n.span);
        let (message, hint) = match message.split_once("; ") {
            Some((message, hint)) => (message.to_owned(), Some(hint.to_owned())),
            None => (message, None),
        };
        let fault = Diagnostic::fault(span, message).label("here");
        match hint {
            Some(hint) => fault.hint(hint),
            None => fault,
        }
    }
}

/// The made sign with what its own lines say.
fn finished(derived: &Derived, made: Sign, source: Option<String>) -> Sign {
    let own = &derived.own;
    let text = expression(&raise::expression(&derived.from));
    let from = source.map(|s| format!("{text}; {s}")).unwrap_or(text);
    Sign {
        name: own.name.clone(),
        language: if own.language.is_empty() { made.language.clone() } else { own.language.clone() },
        meaning: if own.meaning.is_empty() { made.meaning.clone() } else { own.meaning.clone() },
        source: Some(own.source.clone().unwrap_or(from)),
        status: own.status.clone().or(made.status.clone()),
        note: own.note.clone(),
        duration: own.duration.or(made.duration),
        speed: if own.speed == 1.0 { made.speed } else { own.speed },
        base: if own.base.is_empty() { made.base.clone() } else { own.base.clone() },
        ..made
    }
}
