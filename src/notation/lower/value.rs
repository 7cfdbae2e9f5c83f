//! Single values: names looked up, lengths in metres, palms checked against fingers.

use crate::diagnostics::{Diagnostic, Spanned};
use crate::notation::parse::configuration;
use crate::notation::suggest::nearest;
use crate::notation::syntax::{self, ContactKind, NonManualWhat, Values};
use crate::notation::vocabulary::{Found, Vocabulary};
use crate::phonology::{
    self, Attested, Between, Channel, Configuration, Contact, Direction, Distance, Heading, Lateral, NonManual,
    NonManualValue, Orientation, Place, Placement, Sited,
};
use glam::DVec3;

/// Looks names up.
pub(super) struct Names<'v> {
    pub vocabulary: &'v Vocabulary,
    pub language: &'v str,
}

impl Names<'_> {
    pub(super) fn configuration(
        &self,
        written: &syntax::Configuration,
        faults: &mut Vec<Diagnostic>,
    ) -> Option<Configuration> {
        let before = faults.len();
        for name in std::iter::once(&written.base).chain(written.between.as_ref().map(|b| &b.second)) {
            self.handshape(name, faults);
        }
        (faults.len() == before).then(|| Configuration {
            base: written.base.value.clone(),
            between: written.between.as_ref().map(|b| {
                let (first, changes) = (b.first.clone(), b.changes.clone());
                Box::new(Between { first, second: b.second.value.clone(), changes })
            }),
            changes: written.changes.clone(),
        })
    }

    fn handshape(&self, name: &Spanned<String>, faults: &mut Vec<Diagnostic>) {
        let known = |n: &str| self.vocabulary.handshape(n, self.language) != Found::Unknown;
        if self.vocabulary.handshapes.is_empty() {
            return;
        }
        match self.vocabulary.handshape(&name.value, self.language) {
            Found::One(_) => return,
            Found::Several(ids) => {
                faults.push(
                    Diagnostic::fault(name.span, format!("`{}` is several handshapes", name.value))
                        .label("which one?")
                        .hint(format!("say which: {}; or give the language of the sign", ids.join(", "))),
                );
                return;
            }
            Found::Unknown => {}
        }
        let fault = Diagnostic::fault(name.span, format!("`{}` is not a known handshape", name.value))
            .label("unknown handshape");
        if let Some((first, rest)) = split_known(&name.value, known) {
            faults.push(fault.hint(format!("is a comma missing? `{first}, {rest}`")));
            return;
        }
        faults.push(match self.vocabulary.handshapes.nearest(&name.value) {
            Some(near) => fault.hint(format!("did you mean `{near}`?")),
            None if name.value.starts_with("ham") => {
                fault.hint("this looks like HamNoSys; here handshapes have names such as `flat`, `fist-s`, `1`")
            }
            None => {
                fault.hint("`chereme list --handshapes` shows the names; new ones are rows in grammar/handshapes.ron")
            }
        });
    }

    pub(super) fn place(&self, written: &syntax::Place, faults: &mut Vec<Diagnostic>) -> Option<Place> {
        Some(match written {
            syntax::Place::Named(name) => {
                self.place_name(name, faults)?;
                Place::Body(name.value.clone())
            }
            syntax::Place::OtherHand(point) => Place::OtherHand(*point),
            syntax::Place::Space(cell) => Place::Space(*cell),
            syntax::Place::Point(at) => Place::Point(DVec3::from_array(*at)),
            syntax::Place::Between(a, b) => {
                let (a, b) = (self.sited(a, faults), self.sited(b, faults));
                Place::Between(Box::new(a?), Box::new(b?))
            }
            syntax::Place::Referent(name) => Place::Referent(name.clone()),
            syntax::Place::Towards(at) => Place::Towards(Box::new(self.place(at, faults)?)),
        })
    }

    fn sited(&self, written: &syntax::Sited, faults: &mut Vec<Diagnostic>) -> Option<Sited> {
        let lateral = written.side.map(|(side, beside)| Lateral { side, beside });
        Some(Sited { place: self.place(&written.place, faults)?, lateral })
    }

    /// The configurations attested on a base.
    pub(super) fn base(&self, written: &[syntax::Attested], faults: &mut Vec<Diagnostic>) -> Vec<Attested> {
        let made = |one: &syntax::Attested| {
            let configuration = self.configuration(&one.configuration, faults)?;
            Some(Attested { configuration, meaning: one.meaning.clone() })
        };
        written.iter().filter_map(made).collect()
    }

    fn place_name(&self, name: &Spanned<String>, faults: &mut Vec<Diagnostic>) -> Option<()> {
        let places = &self.vocabulary.places;
        if places.is_empty() || places.id(&name.value).is_some() {
            return Some(());
        }
        let fault =
            Diagnostic::fault(name.span, format!("`{}` is not a known place", name.value)).label("unknown place");
        let hand = phonology::HandPart::all()
            .map(phonology::HandPart::name)
            .chain(phonology::Digit::ALL.map(phonology::Digit::name));
        let first = name.value.split(' ').next().unwrap_or_default();
        let fault = if let Some((first, rest)) = split_known(&name.value, |n| places.id(n).is_some()) {
            fault.hint(format!("is a comma missing? `{first}, {rest}`"))
        } else if hand.into_iter().any(|h| h == first) {
            fault.hint(format!("a point of the other hand is `other {}`", name.value))
        } else if let Some(near) = places.nearest(&name.value) {
            fault.hint(format!("did you mean `{near}`?"))
        } else if first.starts_with("ham") {
            fault.hint("this looks like HamNoSys; here places have names such as `chest`, `forehead`, `neutral`")
        } else {
            let some: Vec<&str> = places.ids().take(12).collect();
            fault.hint(format!("places are {}, …; in space: `space left high`", some.join(", ")))
        };
        faults.push(fault);
        None
    }

    pub(super) fn placement(&self, written: &syntax::Placement, faults: &mut Vec<Diagnostic>) -> Option<Placement> {
        Some(Placement {
            place: self.place(&written.place, faults)?,
            lateral: written.side.map(|(side, beside)| Lateral { side, beside }),
            distance: match written.distance {
                None => Distance::Unmarked,
                Some(syntax::Distance::Touch) => Distance::Touch,
                Some(syntax::Distance::Close) => Distance::Close,
                Some(syntax::Distance::Neutral) => Distance::Neutral,
                Some(syntax::Distance::Extended) => Distance::Extended,
                Some(syntax::Distance::Length(length)) => Distance::Metres(length.metres()),
            },
            behind: written.behind,
            with: written.with,
            offset: written.offset.map(|(way, far)| (way, far.metres())),
        })
    }

    pub(super) fn nonmanual(
        &self,
        channel: Channel,
        written: &syntax::NonManual,
        faults: &mut Vec<Diagnostic>,
    ) -> Option<NonManual> {
        let value = match &written.what {
            NonManualWhat::Named(name) => {
                self.nonmanual_name(channel, name, faults)?;
                NonManualValue::Named(name.value.clone())
            }
            NonManualWhat::Towards(heading) => NonManualValue::Towards(*heading),
            NonManualWhat::At(place) => NonManualValue::At(self.placement(place, faults)?),
            NonManualWhat::Mouthing(sounds) => NonManualValue::Mouthing(sounds.clone()),
            NonManualWhat::Sequence(parts) => NonManualValue::Sequence(self.nonmanuals(channel, parts, faults)?),
            NonManualWhat::Together(parts) => NonManualValue::Together(self.nonmanuals(channel, parts, faults)?),
        };
        Some(NonManual { value, amount: written.amount, pace: written.pace.unwrap_or(1.0) })
    }

    fn nonmanuals(
        &self,
        channel: Channel,
        parts: &[syntax::NonManual],
        faults: &mut Vec<Diagnostic>,
    ) -> Option<Vec<NonManual>> {
        let all: Vec<Option<NonManual>> = parts.iter().map(|part| self.nonmanual(channel, part, faults)).collect();
        all.into_iter().collect()
    }

    fn nonmanual_name(&self, channel: Channel, name: &Spanned<String>, faults: &mut Vec<Diagnostic>) -> Option<()> {
        let Some(names) = self.vocabulary.nonmanuals.get(&channel) else { return Some(()) };
        if names.is_empty() || names.id(&name.value).is_some() {
            return Some(());
        }
        let word = channel.name();
        let fault = Diagnostic::fault(name.span, format!("`{}` is not a known value of {word}", name.value))
            .label("unknown value");
        let elsewhere = self.vocabulary.nonmanuals.iter().find(|(_, n)| n.id(&name.value).is_some());
        let next = name.value.split_once(' ').filter(|(first, rest)| {
            let of = rest.split(' ').next().unwrap_or_default();
            names.id(first).is_some() && Channel::ALL.iter().any(|c| c.name().eq_ignore_ascii_case(of))
        });
        faults.push(if let Some((first, rest)) = next {
            fault.hint(format!("is a comma missing? `{first}, {rest}`"))
        } else if let Some(near) = names.nearest(&name.value) {
            fault.hint(format!("did you mean `{near}`?"))
        } else if let Some((other, _)) = elsewhere {
            fault.hint(format!("that is a value of `{}`", other.name()))
        } else if name.value.parse::<Direction>().is_ok() {
            fault.hint(format!("a direction is `towards {}`", name.value))
        } else {
            let all: Vec<&str> = names.ids().collect();
            fault.hint(format!("values of {word} are {}", all.join(", ")))
        });
        None
    }
}

/// A known name in front of something more: a comma was forgotten.
fn split_known(name: &str, known: impl Fn(&str) -> bool) -> Option<(&str, &str)> {
    name.match_indices(' ').map(|(i, _)| (&name[..i], &name[i + 1..])).rev().find(|(first, _)| known(first)).filter(
        |(_, rest)| {
            let word = rest.split(' ').next().unwrap_or_default();
            let after_comma = [
                "touch", "close", "neutral", "extended", "with", "offset", "spread", "together", "on", "except",
                "tight", "slack", "joints",
            ];
            let digits = phonology::Digit::ALL.map(phonology::Digit::name);
            let bends = phonology::Bend::ALL.map(phonology::Bend::name);
            nearest(word, after_comma.into_iter().chain(digits).chain(bends)).is_some()
                || word.starts_with(|c: char| c.is_ascii_digit())
        },
    )
}

/// How the hands meet.
pub(super) fn contact(written: &syntax::Contact) -> Contact {
    let kind = match written.kind {
        ContactKind::Touches => phonology::ContactKind::Touch,
        ContactKind::CloseTo => phonology::ContactKind::Close,
        ContactKind::Crosses => phonology::ContactKind::Crossed,
        ContactKind::Interlocks => phonology::ContactKind::Interlocked,
        ContactKind::LengthFrom(length) => phonology::ContactKind::Metres(length.metres()),
    };
    Contact { strong: written.strong, weak: written.weak, kind }
}

/// An orientation as it is meant.
pub(super) fn orientation(written: &syntax::Orientation) -> Orientation {
    Orientation {
        fingers: written.fingers.map(|h| h.value),
        palm: written.palm.map(|h| h.value),
        along_path: written.along_path,
    }
}

/// Faults for palms along the fingers; what is not stated holds from the value before.
pub(super) fn check_palms(values: &Values<syntax::Orientation>, faults: &mut Vec<Diagnostic>) {
    let (mut fingers, mut palm): (Option<Spanned<Heading>>, Option<Spanned<Heading>>) = (None, None);
    for value in values {
        let v = &value.value;
        fingers = v.fingers.or(fingers);
        palm = v.palm.or(palm);
        let (Some(f), Some(p)) = (fingers, palm) else { continue };
        let new = v.fingers.is_some() || v.palm.is_some();
        if !new || f.value.vector().cross(p.value.vector()).length() > 0.1 {
            continue;
        }
        let across: Vec<String> =
            Direction::all().filter(|d| d.vector().dot(f.value.vector()).abs() < 1e-6).map(|d| d.to_string()).collect();
        let at = v.palm.map_or(f.span, |p| p.span);
        let fault =
            Diagnostic::fault(at, format!("the palm cannot face {} while the fingers point {}", p.value, f.value))
                .label("along the fingers")
                .hint(format!("possible palms: {}", across.join(", ")));
        let other = if at == p.span { f.span } else { p.span };
        faults.push(fault.related(other, if at == p.span { "the fingers" } else { "the palm" }));
    }
}

/// The words that end a handshape's name, for the printer.
pub(crate) const NAME_STOPS: [&str; 3] = configuration::STOPS;
