//! The inventory: loading, checking, finding by name.

use super::angles::FingerAngles;
use super::row::{Level, Row, Table};
use super::shape::Handshape;
use super::written::Written;
use crate::diagnostics::{Diagnostic, Error, Source, Span};
use crate::phonology::grammar::{fold, read_table};
use crate::phonology::{Bend, Configuration, HandPoint};
use std::collections::{BTreeMap, HashMap};
use std::fmt;

/// All handshapes.
#[derive(Debug, Clone, Default)]
pub struct HandshapeInventory {
    levels: BTreeMap<String, Level>,
    shapes: Vec<Handshape>,
    index: Index,
}

/// Which shapes answer to a folded name: as their id, as an alias in full, as an alias without its language.
#[derive(Debug, Clone, Default)]
struct Index {
    ids: HashMap<String, Vec<usize>>,
    aliases: HashMap<String, Vec<usize>>,
    letters: HashMap<String, Vec<usize>>,
    /// The first row that HamNoSys writes so.
    written: HashMap<Written, usize>,
    /// For each bend, in the order of [`Bend::ALL`], the four fingers bent so.
    bent: [[FingerAngles; 4]; 8],
}

impl Index {
    fn of(shapes: &[Handshape], levels: &BTreeMap<String, Level>) -> Index {
        let bent = Bend::ALL.map(|bend| std::array::from_fn(|finger| bent(shapes, levels, finger, bend)));
        let mut index = Index { bent, ..Index::default() };
        for (i, shape) in shapes.iter().enumerate() {
            if let Some(written) = shape.written {
                index.written.entry(written).or_insert(i);
            }
            index.ids.entry(fold(&shape.id)).or_default().push(i);
            for alias in &shape.aliases {
                push_new(index.aliases.entry(fold(alias)).or_default(), i);
                if let Some((language, letter)) = alias.split_once(' ')
                    && is_language(language)
                {
                    push_new(index.letters.entry(fold(letter)).or_default(), i);
                }
            }
        }
        index
    }
}

/// A finger bent so: as solved in the first row that bends it so, else as the level of that name, else stretched.
fn bent(shapes: &[Handshape], levels: &BTreeMap<String, Level>, finger: usize, bend: Bend) -> FingerAngles {
    if let Some(shape) = shapes.iter().find(|s| s.flexion[finger] == bend.name()) {
        return shape.angles().fingers[finger];
    }
    let (mcp, pip, dip) = levels.get(bend.name()).copied().unwrap_or_default();
    FingerAngles { mcp: mcp.to_radians(), abduction: 0.0, pip: pip.to_radians(), dip: dip.to_radians() }
}

fn push_new(all: &mut Vec<usize>, i: usize) {
    if all.last() != Some(&i) {
        all.push(i);
    }
}

/// Why a name gives no handshape.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum NotFound {
    /// Nothing is called so; the nearest known name, if one is near.
    Unknown {
        /// The name that was looked for.
        name: String,
        /// A known name that differs little.
        nearest: Option<String>,
    },
    /// Several are.
    Ambiguous {
        /// The name that was looked for.
        name: String,
        /// The ids of all that answer to it.
        ids: Vec<String>,
    },
}

impl fmt::Display for NotFound {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            NotFound::Unknown { name, nearest: None } => write!(f, "there is no handshape `{name}`"),
            NotFound::Unknown { name, nearest: Some(near) } => {
                write!(f, "there is no handshape `{name}`; did you mean `{near}`?")
            }
            NotFound::Ambiguous { name, ids } => write!(f, "`{name}` may be any of the handshapes {}", ids.join(", ")),
        }
    }
}

impl std::error::Error for NotFound {}

impl From<NotFound> for Error {
    fn from(not_found: NotFound) -> Error {
        Error::new(not_found.to_string())
    }
}

impl HandshapeInventory {
    /// Reads and checks a table.
    ///
    /// # Errors
    /// All faults: text that is not such a table, unknown words, names given twice, angles beyond a hand's limits.
    pub fn read(source: &Source) -> Result<HandshapeInventory, Vec<Diagnostic>> {
        HandshapeInventory::default().overridden(source)
    }

    /// The program's own table.
    pub fn builtin() -> HandshapeInventory {
        let text = include_str!("../../../grammar/handshapes.ron");
        HandshapeInventory::read(&Source::new("grammar/handshapes.ron", text))
            .expect("the embedded table is read by a test")
    }

    /// This inventory with the rows of another table added; rows with a known id replace it.
    ///
    /// # Errors
    /// As [`HandshapeInventory::read`].
    pub fn overridden(mut self, source: &Source) -> Result<HandshapeInventory, Vec<Diagnostic>> {
        let table: Table = read_table(source).map_err(|fault| vec![fault])?;
        self.levels.extend(table.levels);
        let (mut faults, mut from) = (Vec::new(), 0);
        let mut spans: Vec<(String, Span)> = Vec::new();
        for row in &table.handshapes {
            let span = span_of(source, &row.id, from);
            from = span.end;
            if let Some((_, first)) = spans.iter().find(|(id, _)| *id == fold(&row.id)) {
                let message = format!("the handshape `{}` is given twice", row.id);
                faults.push(Diagnostic::fault(span, message).related(*first, "first here"));
                continue;
            }
            spans.push((fold(&row.id), span));
            match row.check(&self.levels) {
                Ok(shape) => self.put(shape),
                Err((word, message)) => faults.push(Diagnostic::fault(span_of(source, &word, span.start), message)),
            }
        }
        self.index = Index::of(&self.shapes, &self.levels);
        faults.extend(self.aliases_given_twice(source, &table.handshapes));
        if faults.is_empty() { Ok(self) } else { Err(faults) }
    }

    fn put(&mut self, shape: Handshape) {
        let id = fold(&shape.id);
        match self.shapes.iter_mut().find(|s| fold(&s.id) == id) {
            Some(old) => *old = shape,
            None => self.shapes.push(shape),
        }
    }

    /// Aliases of the new rows that another row has as well, or as its id.
    fn aliases_given_twice(&self, source: &Source, rows: &[Row]) -> Vec<Diagnostic> {
        let mut faults = Vec::new();
        for row in rows {
            let from = span_of(source, &row.id, 0).start;
            for alias in &row.aliases {
                let folded = fold(alias);
                let own = fold(&row.id);
                let answering =
                    [&self.index.ids, &self.index.aliases].into_iter().filter_map(|names| names.get(&folded));
                let other = answering.flatten().map(|i| &self.shapes[*i]).find(|s| fold(&s.id) != own);
                if let Some(other) = other {
                    let message = format!("`{alias}` is a name of `{}` as well", other.id);
                    faults.push(Diagnostic::fault(span_of(source, alias, from), message));
                }
            }
        }
        faults
    }

    /// All handshapes, in the table's order.
    pub fn shapes(&self) -> &[Handshape] {
        &self.shapes
    }

    /// The flexion of a named level: knuckle, middle and last joint, degrees.
    pub fn level(&self, name: &str) -> Option<(f64, f64, f64)> {
        self.levels.get(name).copied()
    }

    /// A handshape by name: in the language's alphabet first (`M` in `lsf` is `LSF M`), then by id, then by any
    /// alias, with or without its language, that means one handshape only. Letter case does not matter.
    ///
    /// # Errors
    /// An unknown name, with the nearest known one, or a name that several answer to.
    ///
    /// ```
    /// use chereme::phonology::handshape::HandshapeInventory;
    /// let inventory = HandshapeInventory::builtin();
    /// assert_eq!(inventory.find("m", Some("lsf")).unwrap().id, "M-lsf");
    /// assert!(inventory.find("M", None).is_err());
    /// ```
    pub fn find(&self, name: &str, language: Option<&str>) -> Result<&Handshape, NotFound> {
        let wanted = fold(name);
        let one = |names: &HashMap<String, Vec<usize>>, name: &str| match names.get(name).map(Vec::as_slice) {
            Some([i]) => Some(&self.shapes[*i]),
            _ => None,
        };
        let in_language = language.and_then(|l| one(&self.index.aliases, &fold(&format!("{l} {name}"))));
        let named = in_language.or_else(|| one(&self.index.ids, &wanted)).or_else(|| one(&self.index.aliases, &wanted));
        if let Some(shape) = named.or_else(|| one(&self.index.letters, &wanted)) {
            return Ok(shape);
        }
        match self.index.letters.get(&wanted) {
            None => Err(NotFound::Unknown { name: name.to_owned(), nearest: self.nearest(&wanted) }),
            Some(several) => {
                let ids = several.iter().map(|i| self.shapes[*i].id.clone()).collect();
                Err(NotFound::Ambiguous { name: name.to_owned(), ids })
            }
        }
    }

    /// The handshape that HamNoSys writes with these tokens (`hamfinger2 hamthumboutmod`), thumb and bend in either order.
    ///
    /// ```
    /// use chereme::phonology::handshape::HandshapeInventory;
    /// let inventory = HandshapeInventory::builtin();
    /// let found = |tokens: &str| inventory.of_hamnosys(tokens.split_whitespace()).map(|s| s.id.as_str());
    /// assert_eq!(found("hamfinger2 hamthumboutmod"), Some("L"));
    /// assert_eq!(found("hamfinger23spread hamfingerhookmod hamthumbacrossmod"), Some("bent-V"));
    /// assert_eq!(found("hamfist hamfist"), None);
    /// ```
    pub fn of_hamnosys<'a>(&self, tokens: impl IntoIterator<Item = &'a str>) -> Option<&Handshape> {
        let tokens: Vec<String> = tokens.into_iter().map(str::to_owned).collect();
        let as_they_stand = || self.shapes.iter().find(|s| !tokens.is_empty() && s.hamnosys == tokens);
        Written::of(&tokens).and_then(|w| self.written_as(&w)).or_else(as_they_stand)
    }

    /// The row that HamNoSys writes so.
    pub(super) fn written_as(&self, written: &Written) -> Option<&Handshape> {
        self.index.written.get(written).map(|i| &self.shapes[*i])
    }

    /// The pinch of all fingers, plain or with straight fingers.
    pub(super) fn pinch(&self, bend: Option<Bend>) -> Option<&Handshape> {
        self.written_as(&Written::plain("hampinchall", bend)?)
    }

    /// The C of all fingers, plain or with straight fingers.
    pub(super) fn cee(&self, bend: Option<Bend>) -> Option<&Handshape> {
        self.written_as(&Written::plain("hamceeall", bend)?)
    }

    /// A finger (0 is the index) bent so.
    pub(super) fn bent(&self, finger: usize, bend: Bend) -> FingerAngles {
        let which = Bend::ALL.iter().position(|b| *b == bend).unwrap_or(0);
        self.index.bent[which][finger]
    }

    /// The point of the hand that touches a place where the sign does not say: that of the named handshape.
    ///
    /// # Errors
    /// As [`HandshapeInventory::find`].
    pub fn touches_with(&self, configuration: &Configuration, language: Option<&str>) -> Result<HandPoint, NotFound> {
        self.find(&configuration.base, language).map(|shape| shape.touches_with)
    }

    fn nearest(&self, wanted: &str) -> Option<String> {
        let names = self.shapes.iter().flat_map(Handshape::names);
        let near = names.map(|n| (edits(&fold(n), wanted), n)).min_by_key(|(d, _)| *d)?;
        (near.0 <= 2 && near.0 < wanted.chars().count()).then(|| near.1.to_owned())
    }
}

impl Handshape {
    /// The id and all aliases.
    pub fn names(&self) -> impl Iterator<Item = &str> {
        std::iter::once(self.id.as_str()).chain(self.aliases.iter().map(String::as_str))
    }
}

/// Whether a word is the short name of a language, as aliases write it: capitals only.
fn is_language(word: &str) -> bool {
    word.len() >= 2 && word.chars().all(char::is_uppercase)
}

/// How many letters must be changed, added or left out (Levenshtein 1966).
fn edits(a: &str, b: &str) -> usize {
    let b: Vec<char> = b.chars().collect();
    let mut row: Vec<usize> = (0..=b.len()).collect();
    for (i, x) in a.chars().enumerate() {
        let mut diagonal = row[0];
        row[0] = i + 1;
        for (j, y) in b.iter().enumerate() {
            let change = diagonal + usize::from(x != *y);
            diagonal = row[j + 1];
            row[j + 1] = change.min(diagonal + 1).min(row[j] + 1);
        }
    }
    row[b.len()]
}

/// Where a quoted word stands in the text, from an offset on.
fn span_of(source: &Source, word: &str, from: usize) -> Span {
    let from = from.min(source.text.len());
    let quoted = format!("\"{word}\"");
    let found = source.text[from..].find(&quoted).map(|i| (from + i, quoted.len()));
    let found = found.or_else(|| source.text[from..].find(word).map(|i| (from + i, word.len())));
    let (start, length) = found.unwrap_or((from, 0));
    Span::new(start, start + length)
}
