//! What an EAF file says: tiers with their times and texts, and what is said about them.

use crate::tier::Tier;
use crate::time::Seconds;

/// How the annotations of a tier hang on those of its parent tier (ELAN's "stereotypes").
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub enum Stereotype {
    /// They divide the parent's time without gaps, each with times of its own.
    TimeSubdivision,
    /// They lie within the parent's time, with gaps.
    IncludedIn,
    /// They divide the parent in order, without times: each gets an even share.
    SymbolicSubdivision,
    /// One for one; the parent's time.
    SymbolicAssociation,
}

impl Stereotype {
    /// All four.
    pub const ALL: [Stereotype; 4] = [
        Stereotype::TimeSubdivision,
        Stereotype::IncludedIn,
        Stereotype::SymbolicSubdivision,
        Stereotype::SymbolicAssociation,
    ];

    /// The word in the file.
    ///
    /// ```
    /// assert_eq!(chereme::format::eaf::Stereotype::IncludedIn.word(), "Included_In");
    /// ```
    pub fn word(self) -> &'static str {
        match self {
            Stereotype::TimeSubdivision => "Time_Subdivision",
            Stereotype::IncludedIn => "Included_In",
            Stereotype::SymbolicSubdivision => "Symbolic_Subdivision",
            Stereotype::SymbolicAssociation => "Symbolic_Association",
        }
    }
}

/// A tier of a file.
#[derive(Debug, Clone, PartialEq)]
pub struct AnnotatedTier {
    /// Name and values. A value's label is the annotation's text, its source the annotation's id (`a12`).
    pub tier: Tier,
    /// The name of the tier that it hangs on.
    pub parent: Option<String>,
    /// The name of its type, one of [`Eaf::types`].
    pub tier_type: String,
    /// How it hangs on its parent; `None` for a tier by itself.
    pub stereotype: Option<Stereotype>,
    /// Who signs or speaks; empty where the file does not say.
    pub participant: String,
    /// Who annotated; empty where the file does not say.
    pub annotator: String,
    /// The id of its content's language, one of [`Eaf::languages`].
    pub language: Option<String>,
}

/// A type of tiers ("linguistic type").
#[derive(Debug, Clone, PartialEq)]
pub struct TierType {
    /// Its name.
    pub id: String,
    /// Whether its annotations have times of their own.
    pub time_alignable: bool,
    /// How its tiers hang on their parents.
    pub stereotype: Option<Stereotype>,
    /// The name of the vocabulary that its annotations take their texts from, one of [`Eaf::vocabularies`].
    pub vocabulary: Option<String>,
}

/// A language that texts may be in.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Language {
    /// The id that tiers and vocabularies name it by (`eng`).
    pub id: String,
    /// Its definition, as a rule a URL.
    pub definition: String,
    /// What people read.
    pub label: String,
}

/// A list of texts that annotations may have.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct ControlledVocabulary {
    /// Its name.
    pub id: String,
    /// What it is, in the first language that says so; may be empty.
    pub description: String,
    /// Its entries, in their order; none where it is kept in another file that was not given.
    pub entries: Vec<Entry>,
    /// Where the file is that keeps it (an `.ecv`), as written.
    pub external: Option<String>,
}

/// An entry of a vocabulary.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct Entry {
    /// The id that annotations refer to it by; files before 2.8 have none.
    pub id: Option<String>,
    /// The same value in each language; at least one.
    pub values: Vec<EntryValue>,
}

/// An entry in one language.
#[derive(Debug, Clone, PartialEq, Eq)]
pub struct EntryValue {
    /// The language's id; files before 2.8 have none.
    pub language: Option<String>,
    /// The text that annotations get.
    pub text: String,
    /// What it means; may be empty.
    pub description: String,
}

/// A video or sound that the annotations are over.
#[derive(Debug, Clone, PartialEq)]
pub struct Media {
    /// Where it was, as a rule a `file:` URL.
    pub url: String,
    /// The same, from the annotation file.
    pub relative_url: Option<String>,
    /// Its MIME type (`video/mp4`).
    pub mime: String,
    /// What time of the media is 0 in the annotations.
    pub origin: Seconds,
    /// The media that this one was taken out of.
    pub extracted_from: Option<String>,
}

/// What an EAF file says. Times are from the annotations' start.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Eaf {
    /// The version of the format that the file names (`3.0`).
    pub version: String,
    /// Who made it; may be empty.
    pub author: String,
    /// When, as written.
    pub date: String,
    /// The media, in the file's order.
    pub media: Vec<Media>,
    /// Names and values that programs keep with a file.
    pub properties: Vec<(String, String)>,
    /// The tiers, in the file's order.
    pub tiers: Vec<AnnotatedTier>,
    /// The types of tiers, in the file's order.
    pub types: Vec<TierType>,
    /// The languages, in the file's order.
    pub languages: Vec<Language>,
    /// The vocabularies, in the file's order.
    pub vocabularies: Vec<ControlledVocabulary>,
}

impl Eaf {
    /// The tier of a name.
    ///
    /// ```
    /// use chereme::{format::eaf, tier::Tier, time::Seconds};
    /// let mut tier = Tier::new("RH Gloss");
    /// tier.push(Seconds(0.3), Seconds(1.2), "BOL", "");
    /// let file = eaf::write(&[tier], &eaf::Document::default()).unwrap();
    /// let eaf = eaf::read(file.as_bytes()).unwrap().eaf;
    /// assert_eq!(eaf.tier("RH Gloss").unwrap().tier.values()[0].label, "BOL");
    /// assert_eq!(eaf.tier("LH Gloss"), None);
    /// ```
    pub fn tier(&self, name: &str) -> Option<&AnnotatedTier> {
        self.tiers.iter().find(|t| t.tier.name == name)
    }

    /// The vocabulary that a tier's annotations take their texts from.
    ///
    /// ```
    /// use chereme::{format::eaf, tier::Tier};
    /// let phases = eaf::Vocabulary { kind: "Phase".into(), values: vec!["stroke".into()] };
    /// let document = eaf::Document { vocabularies: vec![phases], ..eaf::Document::default() };
    /// let file = eaf::write(&[Tier::new("RH Phase")], &document).unwrap();
    /// let eaf = eaf::read(file.as_bytes()).unwrap().eaf;
    /// let vocabulary = eaf.vocabulary_of(eaf.tier("RH Phase").unwrap()).unwrap();
    /// assert_eq!(vocabulary.entries[0].values[0].text, "stroke");
    /// ```
    pub fn vocabulary_of(&self, tier: &AnnotatedTier) -> Option<&ControlledVocabulary> {
        let named = self.types.iter().find(|t| t.id == tier.tier_type)?.vocabulary.as_ref()?;
        self.vocabularies.iter().find(|v| v.id == *named)
    }
}
