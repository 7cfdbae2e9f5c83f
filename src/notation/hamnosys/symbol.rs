//! The 209 symbols of HamNoSys 4: code point, tag, and a name that people can read (`grammar/hamnosys.tsv`).
//!
//! A tag may be written with or without `ham`, in any case. [`spelling`] also knows other spellings of old software
//! and common mistakes.

use super::kind::{Kind, kind_of};
use crate::notation::suggest;
use std::fmt;
use std::sync::OnceLock;

/// A symbol of HamNoSys.
#[derive(Clone, Copy, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub struct Symbol(u8);

/// A line of the table.
struct Row {
    char: char,
    tag: &'static str,
    category: &'static str,
    name: &'static str,
    kind: Kind,
}

/// How a word was read as the tag of a symbol.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Spelling {
    /// The tag, or a spelling that other software uses.
    Right(Symbol),
    /// A known mistake, or the tag that is nearest by far.
    Mended(Symbol),
    /// A mark of layout that says nothing (`hamtab`).
    Layout,
    /// No tag; with the nearest one, where one is near.
    Unknown(Option<Symbol>),
}

/// What a known word stands for.
#[derive(Clone, Copy)]
enum Entry {
    Tag(Symbol),
    Mistake(Symbol),
    Layout,
}

struct Table {
    rows: Vec<Row>,
    /// Known words in lower case without `ham`, sorted.
    words: Vec<(String, Entry)>,
    /// The symbol of each private character from U+E000.
    private: [Option<Symbol>; 256],
}

/// Spellings of other software, without `ham`.
const ALIASES: [(&str, &str); 20] = [
    ("cee12open", "ceeopen"),
    ("fingerhookedmod", "fingerhookmod"),
    ("palmud", "palmd"),
    ("moveudl", "movedl"),
    ("clockplus", "clockfull"),
    ("sympar", "symmpar"),
    ("symlr", "symmlr"),
    ("period", "fullstop"),
    ("thumbout", "thumboutmod"),
    ("thumbacross", "thumbacrossmod"),
    ("thumbopen", "thumbopenmod"),
    ("fingerstraight", "fingerstraightmod"),
    ("fingerbend", "fingerbendmod"),
    ("fingerhook", "fingerhookmod"),
    ("fingerhooked", "fingerhookmod"),
    ("doublebentmod", "doublebent"),
    ("doublehookedmod", "doublehooked"),
    ("small", "smallmod"),
    ("large", "largemod"),
    ("neutral", "neutralspace"),
];

/// Mistakes that are common where people write HamNoSys, without `ham`.
const MISTAKES: [(&str, &str); 10] = [
    ("pinchopen", "pinch12open"),
    ("indxfinger", "indexfinger"),
    ("indexfnger", "indexfinger"),
    ("littlefinger", "pinky"),
    ("fingerbentmod", "fingerbendmod"),
    ("doublebend", "doublebent"),
    ("doublehook", "doublehooked"),
    ("amcee12", "cee12"),
    ("cee", "cee12"),
    ("pinch", "pinch12"),
];

/// Marks of layout in lists of other software.
const LAYOUT: [&str; 5] = ["tab", "linefeed", "return", "pagebreak", "nbs"];

/// The tag without `ham`.
fn bare(tag: &'static str) -> &'static str {
    tag.strip_prefix("ham").unwrap_or(tag)
}

fn table() -> &'static Table {
    static TABLE: OnceLock<Table> = OnceLock::new();
    TABLE.get_or_init(|| build(include_str!("../../../grammar/hamnosys.tsv")))
}

fn build(text: &'static str) -> Table {
    let mut rows = Vec::new();
    for line in text.lines().filter(|line| !line.starts_with('#')) {
        let mut cells = line.split('\t');
        let mut cell = || cells.next().expect("four cells in each line of grammar/hamnosys.tsv");
        let (code, tag, category, name) = (cell(), cell(), cell(), cell());
        let code = u32::from_str_radix(code, 16).ok().and_then(char::from_u32);
        let char = code.expect("a code point in each line of grammar/hamnosys.tsv");
        let kind = kind_of(bare(tag)).expect("a class for each tag of grammar/hamnosys.tsv");
        rows.push(Row { char, tag, category, name, kind });
    }
    let words = words(&rows);
    let mut private = [None; 256];
    for (i, row) in rows.iter().enumerate() {
        if let 0xE000..=0xE0FF = row.char as u32 {
            private[row.char as usize - 0xE000] = Some(Symbol(i as u8));
        }
    }
    Table { rows, words, private }
}

fn words(rows: &[Row]) -> Vec<(String, Entry)> {
    let of_tag = |tag: &str| {
        let at = rows.iter().position(|row| bare(row.tag) == tag);
        Symbol(at.expect("aliases of tags of grammar/hamnosys.tsv") as u8)
    };
    let mut words: Vec<(String, Entry)> = Vec::new();
    let mut add = |word: String, entry: Entry| {
        if !words.iter().any(|(known, _)| *known == word) {
            words.push((word, entry));
        }
    };
    for row in rows {
        add(bare(row.tag).to_ascii_lowercase(), Entry::Tag(of_tag(bare(row.tag))));
    }
    ALIASES.iter().for_each(|(word, tag)| add((*word).to_owned(), Entry::Tag(of_tag(tag))));
    LAYOUT.iter().for_each(|word| add((*word).to_owned(), Entry::Layout));
    MISTAKES.iter().for_each(|(word, tag)| add((*word).to_owned(), Entry::Mistake(of_tag(tag))));
    // The two letters of a direction exchanged: `hamextfingerlu`.
    for row in rows {
        let letters = ["extfinger", "move", "circle"].iter().find_map(|stem| bare(row.tag).strip_prefix(stem));
        if let (Some(letters), Kind::Fingers(_) | Kind::Arrow(_) | Kind::Circle(_)) = (letters, row.kind) {
            let stem = &bare(row.tag)[..bare(row.tag).len() - letters.len()];
            add(format!("{stem}{}", letters.chars().rev().collect::<String>()), Entry::Mistake(of_tag(bare(row.tag))));
        }
    }
    words.sort_unstable_by(|a, b| a.0.cmp(&b.0));
    words
}

impl Symbol {
    /// All symbols, in the order of their code points.
    pub fn all() -> impl Iterator<Item = Symbol> {
        (0..table().rows.len()).map(|i| Symbol(i as u8))
    }

    /// The symbol of a tag, with or without `ham`, in any case; also of the spellings that other software uses.
    ///
    /// ```
    /// use chereme::notation::hamnosys::symbol::Symbol;
    /// let flat = Symbol::of_tag("hamflathand").unwrap();
    /// assert_eq!((flat.tag(), flat.char(), flat.name()), ("hamflathand", '\u{e001}', "flat hand"));
    /// assert_eq!(Symbol::of_tag("FlatHand"), Some(flat));
    /// ```
    pub fn of_tag(tag: &str) -> Option<Symbol> {
        match known(tag)? {
            Entry::Tag(symbol) => Some(symbol),
            Entry::Mistake(_) | Entry::Layout => None,
        }
    }

    /// The symbol of a character.
    pub fn of_char(char: char) -> Option<Symbol> {
        match char as u32 {
            code @ 0xE000..=0xE0FF => table().private[code as usize - 0xE000],
            0..=0x7F => table().rows.iter().take(8).position(|row| row.char == char).map(|i| Symbol(i as u8)),
            _other => None,
        }
    }

    /// Its tag, such as `hamflathand`.
    pub fn tag(self) -> &'static str {
        self.row().tag
    }

    /// Its character in the HamNoSys font.
    pub fn char(self) -> char {
        self.row().char
    }

    /// What it says, in plain words: `flat hand`.
    pub fn name(self) -> &'static str {
        self.row().name
    }

    /// The group of symbols that it belongs to: `handshape`, `movement`, `obsolete`, ...
    pub fn category(self) -> &'static str {
        self.row().category
    }

    /// What it is for.
    pub(crate) fn kind(self) -> Kind {
        self.row().kind
    }

    /// The symbol of a tag of the table itself.
    pub(crate) fn known(tag: &'static str) -> Symbol {
        Symbol::of_tag(tag).expect("a tag of grammar/hamnosys.tsv")
    }

    fn row(self) -> &'static Row {
        &table().rows[usize::from(self.0)]
    }
}

impl fmt::Debug for Symbol {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.tag())
    }
}

/// The entry of a word in lower case and without `ham`; nothing is allocated.
fn known(word: &str) -> Option<Entry> {
    const LONGEST: usize = 32;
    let mut folded = [0u8; LONGEST];
    let target = folded.get_mut(..word.len())?;
    target.copy_from_slice(word.as_bytes());
    target.make_ascii_lowercase();
    let words = &table().words;
    let find = |key: &[u8]| words.binary_search_by(|(known, _)| known.as_bytes().cmp(key)).ok().map(|i| words[i].1);
    let full: &[u8] = target;
    full.strip_prefix(b"ham").and_then(find).or_else(|| find(full))
}

/// Reads a word as a tag, mending what can be mended without doubt.
///
/// ```
/// use chereme::notation::hamnosys::symbol::{Spelling, Symbol, spelling};
/// assert_eq!(spelling("hampinchopen"), Spelling::Mended(Symbol::of_tag("hampinch12open").unwrap()));
/// assert_eq!(spelling("hammovex"), Spelling::Right(Symbol::of_tag("hammoveX").unwrap()));
/// ```
pub fn spelling(word: &str) -> Spelling {
    match known(word) {
        Some(Entry::Tag(symbol)) => Spelling::Right(symbol),
        Some(Entry::Mistake(symbol)) => Spelling::Mended(symbol),
        Some(Entry::Layout) => Spelling::Layout,
        None => nearest(word),
    }
}

/// The nearest tag: mended where it is a slip or two away and no other is as near.
fn nearest(word: &str) -> Spelling {
    let folded = word.to_ascii_lowercase();
    let stem = folded.strip_prefix("ham").unwrap_or(&folded);
    let clear = if stem.len() >= 9 { 2 } else { 1 };
    let far = (stem.len() / 3).max(1);
    let mut best: Option<(usize, Symbol)> = None;
    let mut alone = true;
    for (known, entry) in &table().words {
        let Entry::Tag(symbol) = *entry else { continue };
        let most = best.map_or(far, |(least, _)| least);
        let Some(slips) = suggest::slips(stem, known, most) else { continue };
        match best {
            Some((least, other)) if slips > least || (slips == least && other == symbol) => {}
            Some((least, _)) => {
                alone = slips < least;
                best = Some(if alone { (slips, symbol) } else { best.unwrap_or((slips, symbol)) });
            }
            None => best = Some((slips, symbol)),
        }
    }
    match best {
        Some((slips, symbol)) if alone && slips <= clear && stem.len() >= 4 => Spelling::Mended(symbol),
        Some((_, symbol)) => Spelling::Unknown(Some(symbol)),
        None => Spelling::Unknown(None),
    }
}
