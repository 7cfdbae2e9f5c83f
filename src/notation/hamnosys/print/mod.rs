//! The tree as HamNoSys: symbols in the order that the grammar wants.
//!
//! What is printed is read as the same tree. Where two readings would be possible, brackets around one action tell them apart.
//! What gestural SiGML can say and HamNoSys cannot, is an error.

mod action;
mod motion;
mod place;
mod posture;

use super::kind::Kind;
use super::parse::Handed;
use super::symbol::Symbol;
use super::syntax::{Hands, Phase, Sign, Symmetry};
use crate::phonology::Direction;

/// How symbols are written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Form {
    /// Characters of the HamNoSys font, without anything between.
    Unicode,
    /// Tags, with commas between.
    Names,
    /// Tags, with spaces between.
    Spaced,
}

/// Prints the manual part of a sign.
///
/// # Errors
/// What HamNoSys cannot say, in plain words, each once: non-manual tiers, times, and some values of gestural SiGML.
///
/// ```
/// use chereme::notation::hamnosys::{parse, print::{Form, print}};
/// let (sign, _) = parse::sign("fist palmd extfingeru");
/// assert_eq!(print(&sign.unwrap(), Form::Spaced).unwrap(), "hamfist hamextfingeru hampalmd");
/// ```
pub fn print(sign: &Sign, form: Form) -> Result<String, Vec<String>> {
    let mut unsaid = Vec::new();
    if !sign.nonmanual.is_empty() {
        unsaid.push("HamNoSys has no symbols for non-manual tiers".to_owned());
    }
    if sign.timing != Default::default() {
        unsaid.push("HamNoSys has no symbols for the speed and duration of a whole sign".to_owned());
    }
    match tokens(&sign.phases) {
        Ok(symbols) if unsaid.is_empty() => Ok(text(&symbols, form)),
        Ok(_) => Err(unsaid),
        Err(more) => {
            unsaid.extend(more);
            Err(unsaid)
        }
    }
}

/// Writes symbols.
pub fn text(symbols: &[Symbol], form: Form) -> String {
    let tags = || symbols.iter().map(|symbol| symbol.tag()).collect::<Vec<_>>();
    match form {
        Form::Unicode => symbols.iter().map(|symbol| symbol.char()).collect(),
        Form::Names => tags().join(","),
        Form::Spaced => tags().join(" "),
    }
}

/// The symbols of phases.
///
/// # Errors
/// As [`print()`].
pub fn tokens(phases: &[Phase]) -> Result<Vec<Symbol>, Vec<String>> {
    let mut writer = Writer { out: Vec::new(), unsaid: Vec::new(), handed: Handed::One };
    for (i, phase) in phases.iter().enumerate() {
        if i > 0 {
            writer.put("hamplus");
        }
        writer.phase(phase);
    }
    if phases.is_empty() {
        writer.cannot("HamNoSys cannot write a sign in which no hand does anything");
    }
    if writer.unsaid.is_empty() { Ok(writer.out) } else { Err(writer.unsaid) }
}

/// What is written so far, and what could not be.
struct Writer {
    out: Vec<Symbol>,
    unsaid: Vec<String>,
    /// As the reader has it at this place.
    handed: Handed,
}

impl Writer {
    /// Writes a symbol of the table.
    fn put(&mut self, tag: &'static str) {
        self.out.push(Symbol::known(tag));
    }

    /// Writes the symbol of a tag that is put together.
    fn put_tag(&mut self, tag: &str) {
        match Symbol::of_tag(tag) {
            Some(symbol) => self.out.push(symbol),
            None => self.cannot(&format!("HamNoSys has no symbol `{tag}`")),
        }
    }

    /// Remembers what cannot be said.
    fn cannot(&mut self, what: &str) {
        if !self.unsaid.iter().any(|known| known == what) {
            self.unsaid.push(what.to_owned());
        }
    }

    /// What a function would write, and whether that can be said is remembered.
    fn apart(&mut self, write: impl FnOnce(&mut Writer)) -> Vec<Symbol> {
        let before = std::mem::take(&mut self.out);
        write(self);
        std::mem::replace(&mut self.out, before)
    }

    /// The class of the last symbol.
    fn last(&self) -> Option<Kind> {
        self.out.last().map(|symbol| symbol.kind())
    }

    /// Writes one of the 26 directions with a family of symbols: `hamextfinger`, `hammove`, `hamcircle`.
    fn direction(&mut self, family: &str, direction: Direction) {
        let [left, up, out] = direction.signs();
        let letter = |sign: i8, positive, negative| match sign {
            0 => "",
            1.. => positive,
            _negative => negative,
        };
        let (up, out, left) = (letter(up, "u", "d"), letter(out, "o", "i"), letter(left, "l", "r"));
        if [up, out, left].contains(&"") {
            self.put_tag(&format!("{family}{up}{out}{left}"));
        } else {
            self.put_tag(&format!("{family}{up}{left}"));
            self.put_tag(&format!("{family}{up}{out}"));
        }
    }

    fn phase(&mut self, phase: &Phase) {
        let before = self.out.len();
        self.handed = Handed::One;
        if phase.holds_over {
            self.put("hamnomotion");
        }
        match phase.hands {
            Hands::Strong => {}
            Hands::Weak => self.put("hamnondominant"),
            Hands::Both(symmetry) => self.symmetry(symmetry),
        }
        self.body_actions(&phase.body);
        let location = phase.location.as_ref().map(|location| self.apart_location(phase, location));
        let after = location.as_ref().and_then(|symbols| symbols.first()).map(|symbol| symbol.kind());
        self.posture(&phase.posture, after);
        self.out.extend(location.unwrap_or_default());
        self.actions_of_phase(&phase.actions, before);
        if self.out.len() == before + usize::from(phase.holds_over) {
            self.cannot("HamNoSys cannot write a phase in which nothing is said");
        }
    }

    /// The symbols of a location that stands after a posture.
    fn apart_location(&mut self, phase: &Phase, location: &super::syntax::Location) -> Vec<Symbol> {
        if phase.posture.splits() {
            self.handed = Handed::Two;
        }
        self.apart(|w| w.location(location))
    }

    fn symmetry(&mut self, symmetry: Symmetry) {
        self.handed = Handed::Two;
        self.put(if symmetry.left_right { "hamsymmlr" } else { "hamsymmpar" });
        let marks = [
            (symmetry.out_in, "hamfingerstraightmod"),
            (symmetry.up_down, "hamlargemod"),
            (symmetry.alternating, "hamalternatingmotion"),
            (symmetry.non_ipsi, "hamnonipsi"),
        ];
        marks.into_iter().filter(|(said, _)| *said).for_each(|(_, tag)| self.put(tag));
    }
}
