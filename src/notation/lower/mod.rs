//! What was written to what it means: [`syntax`](super::syntax) → [`Sign`], names looked up, keys counted.

mod keys;
mod movement;
mod phase;
mod recombination;
mod value;

use super::syntax::{Begins, Content, File, Line, TierLine, Value, Values};
use super::vocabulary::Vocabulary;
use crate::diagnostics::{Diagnostic, Severity, Span, Spanned};
use crate::phonology::{self, Action, Channel, Hand, Hands, Keys, Manual, Motion, Movement, Relocation, Sign};
use crate::time::Seconds;
use keys::{Tally, place};
pub use movement::default_bulge;
use phase::Phase;
pub use recombination::Derived;
pub(crate) use recombination::operators;
pub(crate) use value::NAME_STOPS;
use value::Names;

/// A sign and where it was written.
#[derive(Debug, Clone, PartialEq)]
pub struct Lowered {
    /// The sign.
    pub sign: Sign,
    /// Where its name stands.
    pub name_span: Span,
}

/// What a file describes.
#[derive(Debug, Clone, Default, PartialEq)]
pub struct Lowering {
    /// The signs that are described by their own tiers.
    pub signs: Vec<Lowered>,
    /// The signs that are made from others.
    pub derived: Vec<Derived>,
}

/// The signs of a file that have no fault; faults and warnings are added to `diagnostics`.
///
/// Signs with a [`Content::Broken`] line are left out without a further word.
pub fn lower(file: &File, vocabulary: &Vocabulary, language: &str, diagnostics: &mut Vec<Diagnostic>) -> Lowering {
    let mut language = language.to_owned();
    let mut said: Option<Span> = None;
    let mut blocks: Vec<Block> = Vec::new();
    let mut orphan_told = false;
    for line in &file.lines {
        match &line.content {
            None => {}
            Some(Content::Language(name)) => {
                if !blocks.is_empty() {
                    diagnostics.push(
                        Diagnostic::fault(name.span, "the language stands before the first sign")
                            .label("too late")
                            .hint("move this line to the top; signs of two languages go into two files"),
                    );
                } else if let Some(first) = said.replace(name.span) {
                    let fault = Diagnostic::fault(name.span, "the language is given twice").label("the second");
                    diagnostics.push(fault.related(first, "the first"));
                } else {
                    language.clone_from(&name.value);
                }
            }
            Some(Content::Sign(name, made)) => {
                blocks.push(Block { name: Some(name), made: made.as_ref(), ..Block::default() });
            }
            Some(Content::Broken(Begins::Sign)) => blocks.push(Block { broken: true, ..Block::default() }),
            Some(Content::Broken(Begins::Phase | Begins::Line)) | Some(Content::Then(_)) | Some(Content::Tier(_)) => {
                match blocks.last_mut() {
                    Some(block) => block.line(line),
                    // Said once, not for each line.
                    None if !orphan_told => {
                        orphan_told = true;
                        diagnostics.extend(orphan(line));
                    }
                    None => {}
                }
            }
        }
    }
    let mut all = Lowering::default();
    for block in blocks {
        let mut faults = Vec::new();
        let sign = match block.made {
            None => block.lower(vocabulary, &language, &mut faults).map(Ok),
            Some(made) => block.derived(made, vocabulary, &language, &mut faults).map(Err),
        };
        let broken = block.broken || block.then.iter().any(|phase| phase.block.broken);
        let sound = !broken && faults.iter().all(|d| d.severity != Severity::Fault);
        match sign.filter(|_| sound) {
            Some(Ok(sign)) => all.signs.push(sign),
            Some(Err(derived)) => all.derived.push(derived),
            None => {}
        }
        diagnostics.append(&mut faults);
    }
    all
}

/// A fault for a line before the first sign; none where the line itself has one.
fn orphan(line: &Line) -> Option<Diagnostic> {
    let (span, what) = match line.content.as_ref()? {
        Content::Tier(tier) => (tier.keyword.0, "a tier"),
        Content::Then(_) => (line.span.0, "a phase"),
        Content::Broken(_) | Content::Sign(..) | Content::Language(_) => return None,
    };
    let fault = Diagnostic::fault(span, format!("{what} before the first sign"));
    Some(fault.label("of which sign?").hint("begin with a line `sign NAME`"))
}

/// A non-manual value with its names looked up, for a gloss line; faults are added to `diagnostics`.
pub fn nonmanual(
    channel: Channel,
    written: &super::syntax::NonManual,
    vocabulary: &Vocabulary,
    diagnostics: &mut Vec<Diagnostic>,
) -> Option<phonology::NonManual> {
    Names { vocabulary, language: "" }.nonmanual(channel, written, diagnostics)
}

/// The lines of a sign, or of one of its phases.
#[derive(Default)]
struct Block<'f> {
    name: Option<&'f Spanned<String>>,
    /// What it is made from.
    made: Option<&'f super::syntax::Expression>,
    tiers: Vec<&'f TierLine>,
    /// Whether one of its lines could not be read.
    broken: bool,
    /// Its further phases.
    then: Vec<Phase<'f>>,
}

/// A tier's values of one hand and where they stand.
type Held<'f, T> = Option<(&'f Values<T>, Span)>;

/// The tiers of one prefix (`strong`, `weak`, none).
#[derive(Default)]
struct Written<'f> {
    configuration: Held<'f, super::syntax::Configuration>,
    placement: Held<'f, super::syntax::Placement>,
    orientation: Held<'f, super::syntax::Orientation>,
    movement: Option<(&'f Vec<super::syntax::Movement>, Span)>,
}

impl<'f> Block<'f> {
    fn lower(&self, vocabulary: &Vocabulary, language: &str, faults: &mut Vec<Diagnostic>) -> Option<Lowered> {
        let names = Names { vocabulary, language };
        let name = self.name?;
        let sign = self.described(&names, faults);
        if self.tiers.is_empty() && !self.broken && self.then.is_empty() {
            faults.push(
                Diagnostic::warning(name.span, format!("nothing is said of `{}`", name.value))
                    .label("this sign has no tiers"),
            );
        }
        let then: Vec<Option<Sign>> = self.then.iter().map(|phase| phase.described(&names, faults)).collect();
        let then = then.into_iter().collect::<Option<Vec<Sign>>>();
        let sign = Sign { name: name.value.clone(), language: language.to_owned(), then: then?, ..sign? };
        Some(Lowered { sign, name_span: name.span })
    }

    /// What the tiers say, without name, language and phases.
    fn described(&self, names: &Names, faults: &mut Vec<Diagnostic>) -> Option<Sign> {
        let mut sign = Sign::named("");
        self.twice(faults);
        let hands_span = self.header(&mut sign);
        let manual = self.manual_tiers();
        // A line that could not be read may be the one that says the hands or the movements.
        if !self.broken {
            self.check_hands(&sign, hands_span, faults);
        }
        let tally = self.tally(&manual, faults)?;
        sign.intervals = tally.intervals;
        self.fill(&mut sign, &manual, &tally, names, faults);
        Some(sign)
    }

    /// Faults for tiers given twice.
    fn twice(&self, faults: &mut Vec<Diagnostic>) {
        let mut seen: Vec<(Option<Hand>, &str, Span)> = Vec::new();
        for tier in &self.tiers {
            let key = (tier.hand, tier.value.keyword());
            match seen.iter().find(|(hand, word, _)| (*hand, *word) == key) {
                Some((_, word, first)) => faults.push(
                    Diagnostic::fault(tier.keyword.0, format!("`{word}` is given twice"))
                        .label("the second")
                        .related(*first, "the first")
                        .hint("values that follow each other stand on one line, joined by `then`"),
                ),
                None => seen.push((key.0, key.1, tier.keyword.0)),
            }
        }
    }

    /// What has no keys. Returns where `hands` was written.
    fn header(&self, sign: &mut Sign) -> Option<Span> {
        let mut span = None;
        for tier in &self.tiers {
            match &tier.value {
                Value::Meaning(all) => sign.meaning.clone_from(all),
                Value::Source(text) => sign.source = Some(text.clone()),
                Value::Status(text) => sign.status = Some(text.clone()),
                Value::Note(text) => sign.note = Some(text.clone()),
                Value::Hands(hands) => {
                    sign.hands = *hands;
                    span = Some(tier.keyword.0);
                }
                Value::Duration(duration) => sign.duration = Some(Seconds(duration.seconds())),
                Value::Speed(speed) => sign.speed = *speed,
                _ => {}
            }
        }
        span
    }

    /// The manual tiers: without a prefix, of the strong hand, of the weak hand.
    fn manual_tiers(&self) -> [Written<'f>; 3] {
        let mut all = [Written::default(), Written::default(), Written::default()];
        for tier in &self.tiers {
            let written = &mut all[match tier.hand {
                None => 0,
                Some(Hand::Strong) => 1,
                Some(Hand::Weak) => 2,
            }];
            let span = tier.keyword.0;
            match &tier.value {
                Value::Configuration(v) => written.configuration = Some((v, span)),
                Value::Placement(v) => written.placement = Some((v, span)),
                Value::Orientation(v) => written.orientation = Some((v, span)),
                Value::Movement(v) => written.movement = Some((v, span)),
                _ => {}
            }
        }
        all
    }

    /// Tiers of a hand that does not act, and contact with one hand.
    fn check_hands(&self, sign: &Sign, hands_span: Option<Span>, faults: &mut Vec<Diagnostic>) {
        let idle = match sign.hands {
            Hands::Strong => Hand::Weak,
            Hands::Weak => Hand::Strong,
            Hands::Both(_) => return,
        };
        let idle_name = if idle == Hand::Weak { "weak" } else { "strong" };
        for tier in &self.tiers {
            let fault = if tier.hand == Some(idle) {
                Diagnostic::fault(
                    tier.keyword.0,
                    format!("the {idle_name} hand has a tier, but only the other hand acts"),
                )
                .hint("add `hands both`")
            } else if matches!(tier.value, Value::Contact(_)) {
                Diagnostic::fault(tier.keyword.0, "contact is between the two hands, but only one acts")
                    .hint("add `hands both`; a hand touches the body by its placement: `placement chest, touch`")
            } else {
                continue;
            };
            let fault = fault.label("here");
            faults.push(match hands_span {
                Some(span) => fault.related(span, "the hands that act"),
                None => fault,
            });
        }
    }

    /// How many intervals the sign has.
    fn tally(&self, manual: &[Written], faults: &mut Vec<Diagnostic>) -> Option<Tally> {
        let mut tally = Tally::new(self.broken);
        for written in manual {
            if let Some((movements, span)) = written.movement {
                tally.movements(movements.len(), span, faults);
            }
        }
        for written in manual {
            tally.keys(written.configuration, "configuration");
            tally.keys(written.placement, "placement");
            tally.keys(written.orientation, "orientation");
        }
        for tier in &self.tiers {
            match &tier.value {
                Value::Contact(v) => tally.keys(Some((v, tier.keyword.0)), "contact"),
                Value::NonManual(channel, v) => tally.keys(Some((v, tier.keyword.0)), channel.name()),
                _ => {}
            }
        }
        tally.settle(faults)
    }

    fn fill(&self, sign: &mut Sign, manual: &[Written; 3], tally: &Tally, names: &Names, faults: &mut Vec<Diagnostic>) {
        let [shared, strong, weak] = manual;
        // Without a symmetry both hands share what is said of neither; with one the weak hand follows by itself.
        let (to_strong, to_weak) = match sign.hands {
            Hands::Strong | Hands::Both(Some(_)) => (true, false),
            Hands::Weak => (false, true),
            Hands::Both(None) => (true, true),
        };
        for (hand, own, shares) in [(Hand::Strong, strong, to_strong), (Hand::Weak, weak, to_weak)] {
            let mut manual = Manual::default();
            // A shared tier is read twice; its faults are told once.
            let mut told = Vec::new();
            if let Some(values) = own.configuration.or(shared.configuration.filter(|_| shares)) {
                manual.configuration = place(values, tally, &mut told, |v, f| names.configuration(v, f));
            }
            if let Some(values) = own.placement.or(shared.placement.filter(|_| shares)) {
                manual.placement = place(values, tally, &mut told, |v, f| names.placement(v, f));
            }
            if let Some(values) = own.orientation.or(shared.orientation.filter(|_| shares)) {
                value::check_palms(values.0, &mut told);
                manual.orientation = place(values, tally, &mut told, |v, _| Some(value::orientation(v)));
            }
            // In a sign of two different hands, the movement is the strong hand's unless it says otherwise.
            let moves = shares && !(hand == Hand::Weak && sign.hands == Hands::Both(None));
            if let Some((movements, span)) = own.movement.or(shared.movement.filter(|_| moves)) {
                manual.movement = names.movements(movements, span, &mut told);
            }
            told.retain(|d| !faults.contains(d));
            faults.append(&mut told);
            match hand {
                Hand::Strong => sign.strong = manual,
                Hand::Weak => sign.weak = manual,
            }
        }
        if sign.intervals > 0 && sign.strong.movement.is_empty() && sign.weak.movement.is_empty() {
            let changes = vec![Movement::Action(Box::new(Action::new(Motion::Change))); sign.intervals];
            match sign.hands {
                Hands::Weak => sign.weak.movement = changes,
                Hands::Strong | Hands::Both(_) => sign.strong.movement = changes,
            }
        }
        for channel in Channel::ALL {
            for tier in &self.tiers {
                if let Value::NonManual(found, values) = &tier.value
                    && *found == channel
                {
                    let keys = place((values, tier.keyword.0), tally, faults, |v, f| names.nonmanual(channel, v, f));
                    sign.nonmanual.push((channel, keys));
                }
            }
        }
        for tier in &self.tiers {
            if let Value::Base(all) = &tier.value {
                sign.base = names.base(all, faults);
            }
            if let Value::At(to) = &tier.value {
                sign.relocated = names.place(&to.place, faults).map(|place| Relocation { place, forced: to.forced });
            }
        }
        for tier in &self.tiers {
            if let Value::Contact(values) = &tier.value {
                sign.contact = place((values, tier.keyword.0), tally, faults, |v, _| Some(value::contact(v)));
            }
        }
        // Weak tiers of a one-handed sign were told as faults; nothing of them may stay.
        match sign.hands {
            Hands::Strong => sign.weak = Manual::default(),
            Hands::Weak => sign.strong = Manual::default(),
            Hands::Both(_) => {}
        }
        debug_assert!(sign.contact.iter().all(|(k, _)| k <= sign.intervals));
        if sign.contact.is_empty() {
            sign.contact = Keys::default();
        }
    }
}
