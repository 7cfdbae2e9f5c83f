//! The index of a corpus: all segments, compact, and for everything that can be asked the list of segments that have it.
//!
//! An inverted index in memory, made anew when a corpus is read (facts: a hash map of lists is 30 times faster to build than any
//! database, and 200 times to ask). Labels and glosses are kept once; segments are numbers in arrays, side by side. Every
//! list is sorted, so that several conditions are met by walking their lists together.
//!
//! # Order
//! Segments are numbered by recording, then start, then hand (no hand, right, left), then as they came. Hits come in this order, or by
//! distance and then in this order.

mod bytes;
mod column;
mod intern;
mod names;
mod postings;

pub(in crate::corpus) use names::{Named, Names};
pub use postings::Postings;
pub(in crate::corpus) use postings::Union;

use super::label::{Label, Vocabulary};
use super::segment::{Component, Segment};
use crate::phonology::Side;
use crate::time::Seconds;
use column::{Column, Values};
use intern::Interner;

/// What queries may ask of a recording.
#[derive(Debug, Clone, PartialEq, Eq, Default)]
pub struct About {
    /// Its name in the corpus.
    pub name: String,
    /// Who signs; `None` where it is not known.
    pub signer: Option<String>,
    /// The signer's dominant hand; `None` where it is not known.
    pub dominant: Option<Side>,
}

/// The number of no gloss.
const NONE: u32 = u32::MAX;

/// All segments of a corpus with their lists; see the module.
///
/// ```
/// use chereme::corpus::index::{About, Index};
/// use chereme::corpus::{label::Vocabulary, segment::Segment};
/// use chereme::motion::skeleton::Skeleton;
/// let rig = Skeleton::from_json(chereme::avatar::SKELETON).unwrap();
/// let vocabulary = Vocabulary::builtin(&rig, None).unwrap();
/// let take = About { name: "take 1".into(), ..About::default() };
/// let hello = Segment { gloss: Some("hello".into()), ..Segment::default() };
/// let index = Index::build(&[take], &[hello.clone()], &vocabulary);
/// assert_eq!(index.segment(0), Some(hello));
/// ```
#[derive(Debug, Clone, PartialEq)]
pub struct Index {
    recordings: Vec<About>,
    recording: Vec<u32>,
    /// 0 none, 1 right, 2 left.
    side: Vec<u8>,
    start: Vec<f64>,
    end: Vec<f64>,
    gloss: Vec<u32>,
    /// The glosses as they stand, each once.
    glosses: Vec<String>,
    by_gloss: Names,
    by_recording: Names,
    by_signer: Names,
    columns: [Column; 4],
    /// Segments without a gloss; of no recording of the list; without a hand; of recordings whose signer, or whose dominant hand, is not known.
    no_gloss: Vec<u32>,
    no_recording: Vec<u32>,
    no_side: Vec<u32>,
    no_signer: Vec<u32>,
    no_dominant: Vec<u32>,
}

impl Index {
    /// Indexes the segments of recordings. A segment's recording that is not in the list is one of which nothing is known.
    ///
    /// Times that are not finite are taken as 0, a segment beyond the first 4 billion is left out.
    pub fn build(recordings: &[About], segments: &[Segment], vocabulary: &Vocabulary) -> Index {
        let segments = &segments[..segments.len().min(NONE as usize - 1)];
        let mut order: Vec<u32> = (0..segments.len() as u32).collect();
        let key = |i: u32| {
            let s = &segments[i as usize];
            (s.recording, finite(s.start), side_number(s.side))
        };
        let in_order = |a: &u32, b: &u32| {
            let ((r, s, h), (t, u, k)) = (key(*a), key(*b));
            r.cmp(&t).then(s.total_cmp(&u)).then(h.cmp(&k))
        };
        if !order.is_sorted_by(|a, b| in_order(a, b).is_le()) {
            order.sort_by(in_order);
        }
        let sorted = || order.iter().map(|i| &segments[*i as usize]);
        let mut glosses = Interner::default();
        let gloss: Vec<u32> = sorted().map(|s| s.gloss.as_deref().map_or(NONE, |g| glosses.number(g))).collect();
        let data = Data {
            recordings: recordings.to_vec(),
            recording: sorted().map(|s| s.recording.min(NONE as usize) as u32).collect(),
            side: sorted().map(|s| side_number(s.side)).collect(),
            start: sorted().map(|s| finite(s.start)).collect(),
            end: sorted().map(|s| finite(s.end)).collect(),
            gloss,
            glosses: glosses.into_texts(),
            values: Component::ALL.map(|component| Values::of(sorted().map(|s| s.of(component)), order.len())),
        };
        Index::of(data, vocabulary)
    }

    /// The lists of checked data.
    fn of(data: Data, vocabulary: &Vocabulary) -> Index {
        let Data { recordings, recording, side, start, end, gloss, glosses, values } = data;
        let by_gloss = Names::of(glosses.iter().map(|gloss| Some(gloss.as_str())), &gloss);
        let by_recording = Names::of(recordings.iter().map(|about| Some(about.name.as_str())), &recording);
        let by_signer = Names::of(recordings.iter().map(|about| about.signer.as_deref()), &recording);
        let numbers =
            |test: &dyn Fn(usize) -> bool| (0..recording.len() as u32).filter(|i| test(*i as usize)).collect();
        let about = |i: usize| recordings.get(recording[i] as usize);
        let no_gloss = numbers(&|i| gloss[i] == NONE);
        let no_recording = numbers(&|i| about(i).is_none());
        let no_side = numbers(&|i| side[i] == 0);
        let no_signer = numbers(&|i| about(i).is_none_or(|a| a.signer.is_none()));
        let no_dominant = numbers(&|i| side[i] == 0 || about(i).is_none_or(|a| a.dominant.is_none()));
        let mut values = values.into_iter();
        let columns = Component::ALL.map(|component| {
            let values = values.next().expect("there are four components");
            Column::of(values, component, vocabulary)
        });
        Index {
            recordings,
            recording,
            side,
            start,
            end,
            gloss,
            glosses,
            by_gloss,
            by_recording,
            by_signer,
            columns,
            no_gloss,
            no_recording,
            no_side,
            no_signer,
            no_dominant,
        }
    }

    /// How many segments there are.
    pub fn len(&self) -> usize {
        self.recording.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.recording.is_empty()
    }

    /// What is known of the recordings.
    pub fn recordings(&self) -> &[About] {
        &self.recordings
    }

    /// A segment by its number, as it was given.
    pub fn segment(&self, number: usize) -> Option<Segment> {
        let recording = *self.recording.get(number)? as usize;
        let values = Component::ALL.map(|component| self.columns[component as usize].values(number));
        let gloss = self.glosses.get(self.gloss[number] as usize).cloned();
        let (start, end) = (Seconds(self.start[number]), Seconds(self.end[number]));
        Some(Segment { recording, side: side_of(self.side[number]), start, end, gloss, values })
    }

    /// What is known of a segment's recording.
    pub(super) fn about(&self, number: usize) -> Option<&About> {
        self.recordings.get(self.recording[number] as usize)
    }

    /// The labels of a component of one segment, in time order: their numbers.
    pub(super) fn label_numbers(&self, component: Component, number: usize) -> &[u32] {
        self.columns[component as usize].numbers(number)
    }

    /// All labels of a component, each once.
    pub(super) fn labels(&self, component: Component) -> &[Label] {
        &self.columns[component as usize].labels
    }

    /// The segments that have a term of a component.
    pub(super) fn with_term(&self, component: Component, term: &str) -> &[u32] {
        let column = &self.columns[component as usize];
        column.terms.binary_search_by(|own| own.as_str().cmp(term)).map_or(&[], |at| column.by_term.of(at))
    }

    /// The segments of which some question about a component has no answer.
    pub(super) fn open(&self, component: Component) -> &[u32] {
        &self.columns[component as usize].open
    }

    /// The names of what queries name: glosses, recordings, signers.
    pub(super) fn names(&self, of: Named) -> &Names {
        match of {
            Named::Gloss => &self.by_gloss,
            Named::Recording => &self.by_recording,
            Named::Signer => &self.by_signer,
        }
    }

    /// The number of a segment's name, which all spellings of it share; `None` where it is not known.
    pub(super) fn name_number(&self, of: Named, number: usize) -> Option<u32> {
        let item = match of {
            Named::Gloss => self.gloss[number],
            Named::Recording | Named::Signer => self.recording[number],
        };
        self.names(of).of_thing(item)
    }

    /// A segment's gloss as it stands.
    pub(super) fn gloss_text(&self, number: usize) -> Option<&str> {
        self.glosses.get(self.gloss[number] as usize).map(String::as_str)
    }

    /// All glosses as they stand, each once.
    pub fn glosses(&self) -> &[String] {
        &self.glosses
    }

    pub(super) fn side(&self, number: usize) -> Option<Side> {
        side_of(self.side[number])
    }

    pub(super) fn start(&self, number: usize) -> f64 {
        self.start[number]
    }

    pub(super) fn duration(&self, number: usize) -> f64 {
        self.end[number] - self.start[number]
    }

    /// The segments of which it is not known: a gloss, a recording, a signer.
    pub(super) fn without(&self, of: Named) -> &[u32] {
        match of {
            Named::Gloss => &self.no_gloss,
            Named::Recording => &self.no_recording,
            Named::Signer => &self.no_signer,
        }
    }

    /// The segments without a hand; those of which it is not known whether the hand is the strong one.
    pub(super) fn without_hand(&self) -> [&[u32]; 2] {
        [&self.no_side, &self.no_dominant]
    }
}

/// What an index is made of, in the order of its segments: what is kept in a file.
struct Data {
    recordings: Vec<About>,
    recording: Vec<u32>,
    side: Vec<u8>,
    start: Vec<f64>,
    end: Vec<f64>,
    gloss: Vec<u32>,
    glosses: Vec<String>,
    values: [Values; 4],
}

fn finite(time: Seconds) -> f64 {
    // Negative zero would sort before zero.
    if time.0.is_finite() { time.0 + 0.0 } else { 0.0 }
}

fn side_number(side: Option<Side>) -> u8 {
    match side {
        None => 0,
        Some(Side::Right) => 1,
        Some(Side::Left) => 2,
    }
}

fn side_of(number: u8) -> Option<Side> {
    match number {
        1 => Some(Side::Right),
        2 => Some(Side::Left),
        _ => None,
    }
}
