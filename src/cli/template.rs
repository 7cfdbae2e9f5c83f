//! Names of files with places for what differs: `out/{language}/{stem}.bvh`.

use super::Failure;
use super::files::Text;
use crate::phonology::Sign;
use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

/// The longest name that a sign gives to a file, characters: file systems take some 255 bytes.
const LONGEST: usize = 80;
/// The language of a sign that says none, as ISO 639 calls it.
const UNDETERMINED: &str = "und";

/// Where a sign came from, for the names of its files.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Origin {
    /// The name of its file without the extension.
    pub stem: String,
    /// Its gloss.
    pub name: String,
    /// Its language.
    pub language: String,
    /// The folder of its file, as seen from the folder that was asked for.
    pub folder: PathBuf,
    /// Its number in its file, from 1.
    pub number: usize,
    /// How many signs its file has.
    pub of: usize,
}

impl Origin {
    /// A sign that was found by its name.
    pub(super) fn of_name(sign: &Sign) -> Origin {
        Origin::of_line(&sign.name, &sign.language)
    }

    /// A line of glosses, or a sign without a file.
    pub(super) fn of_line(name: &str, language: &str) -> Origin {
        let (name, language) = (name.to_owned(), language.to_owned());
        Origin { stem: safe(&name), name, language, folder: PathBuf::new(), number: 1, of: 1 }
    }

    /// Whether both stand in one file that has several signs.
    pub(super) fn is_of_one_file_with(&self, other: &Origin) -> bool {
        (&self.stem, &self.folder, self.of) == (&other.stem, &other.folder, other.of) && self.number != other.number
    }

    /// The sign of that number among the `of` signs of a text.
    pub(super) fn of_text(sign: &Sign, text: &Text, number: usize, of: usize) -> Origin {
        let stem = text.path.as_deref().and_then(Path::file_stem).map(|stem| stem.to_string_lossy().into_owned());
        Origin {
            stem: stem.unwrap_or_else(|| safe(&sign.name)),
            folder: text.folder.clone(),
            number,
            of,
            ..Origin::of_name(sign)
        }
    }
}

/// What a template leaves open.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Field {
    Stem,
    Name,
    Language,
    Folder,
    Number,
}

impl Field {
    const ALL: [Field; 5] = [Field::Stem, Field::Name, Field::Language, Field::Folder, Field::Number];

    fn name(self) -> &'static str {
        match self {
            Field::Stem => "stem",
            Field::Name => "name",
            Field::Language => "language",
            Field::Folder => "folder",
            Field::Number => "number",
        }
    }

    fn of(self, origin: &Origin) -> String {
        match self {
            Field::Stem => origin.stem.clone(),
            Field::Name => safe(&origin.name),
            Field::Language if origin.language.is_empty() => UNDETERMINED.to_owned(),
            Field::Language => safe(&origin.language),
            Field::Folder => origin.folder.to_string_lossy().into_owned(),
            // As wide as the greatest number of the file, so that names sort as signs do.
            Field::Number => format!("{:0width$}", origin.number, width = origin.of.to_string().len()),
        }
    }
}

#[derive(Debug, Clone, PartialEq, Eq)]
enum Piece {
    Text(String),
    Field(Field),
}

/// The name of a file, perhaps with fields.
#[derive(Debug, Clone, PartialEq, Eq)]
pub(super) struct Template(Vec<Piece>);

impl Template {
    /// Reads a template.
    pub(super) fn of(text: &str) -> Result<Template, Failure> {
        let mut pieces = Vec::new();
        let mut rest = text;
        while let Some((before, after)) = rest.split_once('{') {
            let wrong = |what: &str| Failure::Usage(format!("-o {text}: {what}; {} can stand in it", fields()));
            let (name, after) = after.split_once('}').ok_or_else(|| wrong("a { is never closed"))?;
            let field = Field::ALL.into_iter().find(|field| field.name() == name);
            pieces.push(Piece::Text(before.to_owned()));
            pieces.push(Piece::Field(field.ok_or_else(|| wrong(&format!("{{{name}}} is unknown")))?));
            rest = after;
        }
        pieces.push(Piece::Text(rest.to_owned()));
        Ok(Template(pieces))
    }

    /// Whether something differs from sign to sign.
    pub(super) fn has_fields(&self) -> bool {
        self.0.iter().any(|piece| matches!(piece, Piece::Field(_)))
    }

    /// The file of a sign.
    pub(super) fn path(&self, origin: &Origin) -> PathBuf {
        let piece = |piece: &Piece| match piece {
            Piece::Text(text) => text.clone(),
            Piece::Field(field) => field.of(origin),
        };
        let text: String = self.0.iter().map(piece).collect();
        // An empty folder leaves two slashes, and one at the front would lead elsewhere.
        let from_field = matches!(self.0.as_slice(), [Piece::Text(first), Piece::Field(_), ..] if first.is_empty());
        let text = if from_field { text.trim_start_matches('/') } else { text.as_str() };
        Path::new(text).components().collect()
    }
}

/// The fields, for messages.
fn fields() -> String {
    Field::ALL.map(|field| format!("{{{}}}", field.name())).join(", ")
}

/// A gloss as part of a file's name, on all systems: no separators, no control characters, no dot in front or at the end.
pub(super) fn safe(name: &str) -> String {
    let replaced = |c: char| if c.is_control() || "/\\:*?\"<>|".contains(c) { '_' } else { c };
    let name: String = name.chars().map(replaced).take(LONGEST).collect();
    let name = name.trim().trim_end_matches('.');
    match name.strip_prefix('.') {
        Some(rest) => format!("_{rest}"),
        None if name.is_empty() => "sign".to_owned(),
        None => name.to_owned(),
    }
}

/// Whether files that are there may be replaced.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Replacing {
    /// They stay, and nothing is written.
    Refused,
    /// `--force`.
    Forced,
}

/// Says before any work which files would be written twice, or are there already.
pub(super) fn check<'p>(
    files: impl Iterator<Item = (&'p Origin, &'p PathBuf)>,
    replacing: Replacing,
) -> Result<(), Failure> {
    let mut taken: BTreeMap<&PathBuf, &Origin> = BTreeMap::new();
    let (mut there, mut first_there) = (0, None);
    for (origin, path) in files {
        if let Some(first) = taken.insert(path, origin) {
            return Err(Failure::Usage(twice(path, first, origin)));
        }
        if replacing == Replacing::Refused && path.exists() {
            there += 1;
            first_there.get_or_insert(path);
        }
    }
    match first_there {
        None => Ok(()),
        Some(path) => {
            let more = if there > 1 { format!(" (and {} more)", there - 1) } else { String::new() };
            Err(Failure::Usage(format!("{} is there already{more}; --force overwrites it", path.display())))
        }
    }
}

fn twice(path: &Path, first: &Origin, second: &Origin) -> String {
    let path = path.display();
    let clash = format!("{path} would be written twice, for {} and for {}", first.name, second.name);
    match first.stem == second.stem && first.folder == second.folder && first.of > 1 {
        true => format!(
            "{clash}: {} has {} signs, so -o needs {{number}} or {{name}}, such as {{stem}}-{{number}}",
            first.stem, first.of
        ),
        false => format!("{clash}: -o needs more of {}", fields()),
    }
}
