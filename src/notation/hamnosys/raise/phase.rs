//! One phase of a sign to posture, place and actions.

use super::super::dictionary::Dictionary;
use super::super::lower::phase::hands_of;
use super::super::syntax::{
    Action, Fingers, Hands, Location, Motion, Move, Palm, Phase, Posture, Shape, Site, Split, Symmetry,
};
use super::{location, note, orientation, shape};
use crate::phonology::reflection::Reflection;
use crate::phonology::{
    self, Configuration, Hand, Heading, Keys, Manual, Movement, Orientation, Placement, Relation, Sign,
};

/// What is known of a hand's orientation while a phase is written.
#[derive(Debug, Clone, Default)]
pub(super) struct Known {
    pub(super) fingers: Option<Fingers>,
    pub(super) palm: Option<Palm>,
    pub(super) heading: Option<Heading>,
}

impl Known {
    /// What of fingers and palm has to be said: what differs, and the fingers where nothing does.
    pub(super) fn changed(&self, fingers: Option<Fingers>, palm: Option<Palm>) -> (Option<Fingers>, Option<Palm>) {
        let new_fingers = fingers.filter(|f| self.fingers != Some(*f));
        let new_palm = palm.filter(|p| self.palm != Some(*p));
        match (new_fingers, new_palm) {
            (None, None) if fingers.is_some() => (fingers, None),
            (None, None) => (None, palm),
            (f, p) => (f, p),
        }
    }

    pub(super) fn take(&mut self, o: &Orientation, fingers: Option<Fingers>, palm: Option<Palm>) {
        self.heading = o.fingers.or(self.heading);
        self.fingers = fingers.or(self.fingers);
        self.palm = palm.or(self.palm);
    }
}

/// A phase while it is written.
pub(super) struct Raising<'d> {
    pub(super) dictionary: &'d Dictionary,
    /// The sign's language, whose alphabet names handshapes.
    language: Option<&'d str>,
    strong: Known,
    weak: Known,
    errors: &'d mut Vec<String>,
    warnings: &'d mut Vec<String>,
}

/// A phase of a sign, written.
pub(super) fn phase(
    sign: &Sign,
    language: Option<&str>,
    dictionary: &Dictionary,
    errors: &mut Vec<String>,
    warnings: &mut Vec<String>,
) -> Phase {
    let mut raising =
        Raising { dictionary, language, strong: Known::default(), weak: Known::default(), errors, warnings };
    if sign.relocated.is_some() {
        raising.fail("HamNoSys cannot say that a whole sign is moved");
    }
    let posture = raising.posture(sign, 0, Said::Whole);
    let location = raising.location(sign, 0);
    let actions = (0..sign.intervals).map(|i| raising.interval(sign, i)).collect();
    let mut phase = Phase {
        hands: hands(sign.hands),
        holds_over: sign.holds_over,
        body: Vec::new(),
        posture,
        location,
        actions,
        span: Default::default(),
    };
    if sign.hands == phonology::Hands::Both(None) && hands_of(&phase) != sign.hands && !name_both(&mut phase) {
        raising.fail("HamNoSys shows that a second hand acts by what it says of it, and nothing is said of it");
    }
    phase
}

/// Says what is said of both hands of each one, so that it shows that there are two. `false` where nothing is said.
fn name_both(phase: &mut Phase) -> bool {
    fn each<T: Clone>(split: &mut Option<Split<T>>) -> bool {
        let Some(Split::Both(value)) = split else { return false };
        *split = Some(Split::Each(Some(value.clone()), Some(value.clone())));
        true
    }
    if each(&mut phase.posture.shape) || each(&mut phase.posture.fingers) || each(&mut phase.posture.palm) {
        return true;
    }
    let Some(Location::One(site)) = &phase.location else { return false };
    phase.location = Some(Location::Split(Some(site.clone()), Some(site.clone())));
    true
}

fn hands(hands: phonology::Hands) -> Hands {
    match hands {
        phonology::Hands::Strong | phonology::Hands::Both(None) => Hands::Strong,
        phonology::Hands::Weak => Hands::Weak,
        phonology::Hands::Both(Some(s)) => Hands::Both(Symmetry {
            left_right: s.relation == Relation::Mirrored,
            up_down: s.up_down,
            out_in: s.out_in,
            alternating: s.alternating,
            non_ipsi: s.crossed,
        }),
    }
}

/// What of a posture is written.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Said {
    /// All of it: that of a phase's start.
    Whole,
    /// What a replacement has to say.
    Changes,
}

impl Raising<'_> {
    pub(super) fn fail(&mut self, message: &str) {
        note(self.errors, message);
    }

    pub(super) fn warn(&mut self, message: &str) {
        note(self.warnings, message);
    }

    /// The value, or its error noted.
    pub(super) fn ok<T>(&mut self, value: Result<T, String>) -> Option<T> {
        value.map_err(|e| self.fail(&e)).ok()
    }

    pub(super) fn known(&mut self, hand: Hand) -> &mut Known {
        match hand {
            Hand::Strong => &mut self.strong,
            Hand::Weak => &mut self.weak,
        }
    }

    pub(super) fn shape(&mut self, configuration: &Configuration) -> Option<Shape> {
        let shape = shape::shape(configuration, self.language, self.dictionary);
        self.ok(shape)
    }

    /// The posture stated at a key.
    fn posture(&mut self, sign: &Sign, key: usize, said: Said) -> Posture {
        let configuration = split(sign, key, |m| &m.configuration, |_, c| c.clone());
        let shape = configuration.and_then(|c| self.split_shape(&c));
        let (fingers, palm) = self.orientations(sign, key, said);
        Posture { shape, fingers, palm }
    }

    fn split_shape(&mut self, configuration: &Split<Configuration>) -> Option<Split<Shape>> {
        match configuration {
            Split::Both(c) => self.shape(c).map(Split::Both),
            Split::Each(a, b) => {
                let (a, b) = (a.as_ref().and_then(|c| self.shape(c)), b.as_ref().and_then(|c| self.shape(c)));
                Some(Split::Each(a, b))
            }
        }
    }

    /// Finger directions and palms stated at a key.
    fn orientations(&mut self, sign: &Sign, key: usize, said: Said) -> (Option<Split<Fingers>>, Option<Split<Palm>>) {
        let mirror = mirror_of(sign);
        match split(sign, key, |m| &m.orientation, |mirror, o| mirror.map_or(*o, |m| m.orientation(o))) {
            None => (None, None),
            Some(Split::Both(o)) => {
                let hand = if sign.hands == phonology::Hands::Weak { Hand::Weak } else { Hand::Strong };
                let (fingers, palm) = self.oriented(&o, hand, said);
                if let Some(mirror) = mirror {
                    // The weak hand follows: later changes of it alone start from there.
                    let image = mirror.orientation(&o);
                    self.oriented(&image, Hand::Weak, Said::Whole);
                }
                (fingers.map(Split::Both), palm.map(Split::Both))
            }
            Some(Split::Each(strong, weak)) => {
                let written = |raising: &mut Self, o: Option<Orientation>, hand| {
                    o.map_or((None, None), |o| raising.oriented(&o, hand, Said::Whole))
                };
                let (f, p) = written(self, strong, Hand::Strong);
                let (g, q) = written(self, weak, Hand::Weak);
                let image = strong.map(|o| mirror.map_or(o, |m| m.orientation(&o)));
                let same_fingers = strong.is_some() && image.and_then(|o| o.fingers) == weak.and_then(|o| o.fingers);
                let same_palm = same_fingers && image.and_then(|o| o.palm) == weak.and_then(|o| o.palm);
                (pair(f, g, same_fingers), pair(p, q, same_palm))
            }
        }
    }

    /// Fingers and palm of one hand, as far as they have to be said.
    fn oriented(&mut self, o: &Orientation, hand: Hand, said: Said) -> (Option<Fingers>, Option<Palm>) {
        let known = self.known(hand);
        let fingers = orientation::fingers(o);
        let palm = orientation::palm(o, known.heading);
        let needed = match said {
            Said::Whole => (fingers, palm),
            Said::Changes => known.changed(fingers, palm),
        };
        known.take(o, fingers, palm);
        needed
    }

    /// Where the hands are at a key, where it is stated.
    fn location(&mut self, sign: &Sign, key: usize) -> Option<Location> {
        let contact = sign.contact.stated(key).copied();
        let place = split(sign, key, |m| &m.placement, |mirror, p| mirror.map_or(p.clone(), |m| m.placement(p)));
        match (contact, place) {
            (None, None) => None,
            (None, Some(Split::Both(p))) => {
                let hand = if sign.hands == phonology::Hands::Weak { Hand::Weak } else { Hand::Strong };
                self.site(&p, hand).map(Location::One)
            }
            (None, Some(Split::Each(a, b))) => {
                let a = a.and_then(|p| self.site(&p, Hand::Strong));
                let b = b.and_then(|p| self.site(&p, Hand::Weak));
                Some(Location::Split(a, b))
            }
            (Some(contact), place) => {
                let at = match place {
                    None => None,
                    Some(Split::Both(p)) => self.site(&p, Hand::Strong),
                    Some(Split::Each(a, b)) => match (a, b) {
                        (Some(p), None) | (None, Some(p)) => self.site(&p, Hand::Strong),
                        (_, _) => {
                            self.warn("HamNoSys has one place for two hands that meet: the weak hand's is written");
                            None
                        }
                    },
                };
                let met = location::constellation(&contact, at, self.dictionary);
                self.ok(met).map(Location::Constellation)
            }
        }
    }

    fn site(&mut self, placement: &Placement, hand: Hand) -> Option<Site> {
        let site = location::site(placement, hand, self.dictionary);
        self.ok(site)
    }

    /// An interval with what the key after it says.
    fn interval(&mut self, sign: &Sign, interval: usize) -> Action {
        let key = interval + 1;
        let change = Movement::Action(Box::new(phonology::Action::new(phonology::Motion::Change)));
        let hold = Movement::Action(Box::new(phonology::Action::new(phonology::Motion::Hold)));
        let own = |m: &Manual| m.movement.get(interval).cloned();
        let weak_stands = |m: &Manual| own(m).is_none_or(|w| w == hold) && !states(m, key);
        let action = match sign.hands {
            phonology::Hands::Strong => self.whole(sign, key, &own(&sign.strong).unwrap_or(change), Hand::Strong),
            phonology::Hands::Weak => self.whole(sign, key, &own(&sign.weak).unwrap_or(change), Hand::Weak),
            phonology::Hands::Both(None) if weak_stands(&sign.weak) => {
                self.whole(sign, key, &own(&sign.strong).unwrap_or(change), Hand::Strong)
            }
            phonology::Hands::Both(None) => self.split_interval(sign, key, own(&sign.strong), own(&sign.weak)),
            phonology::Hands::Both(Some(symmetry)) => {
                let strong = own(&sign.strong).unwrap_or(change);
                let image = Reflection::of(symmetry).movement(&strong);
                match own(&sign.weak) {
                    Some(weak) if weak != image => self.split_interval(sign, key, Some(strong), Some(weak)),
                    Some(_) | None => self.whole(sign, key, &strong, Hand::Strong),
                }
            }
        };
        match self.location(sign, key) {
            Some(location) => Action::Target(Box::new(action), Box::new(location)),
            None => action,
        }
    }

    /// An interval that one action says.
    fn whole(&mut self, sign: &Sign, key: usize, movement: &Movement, hand: Hand) -> Action {
        let posture = self.posture(sign, key, Said::Changes);
        let mut pending = (!posture.is_empty()).then_some(posture);
        let action = self.action(movement, hand, &mut pending);
        with_change(action, pending)
    }

    /// An interval in which each hand does something of its own.
    fn split_interval(&mut self, sign: &Sign, key: usize, strong: Option<Movement>, weak: Option<Movement>) -> Action {
        let mut one = |own: &Manual, movement: Option<Movement>, hand: Hand| -> Option<Box<Action>> {
            let shape = own.configuration.stated(key).and_then(|c| self.shape(c)).map(Split::Both);
            let (fingers, palm) =
                own.orientation.stated(key).map_or((None, None), |o| self.oriented(o, hand, Said::Changes));
            let posture = Posture { shape, fingers: fingers.map(Split::Both), palm: palm.map(Split::Both) };
            let mut pending = (!posture.is_empty()).then_some(posture);
            let action = movement.map(|m| self.action(&m, hand, &mut pending));
            match (action, pending) {
                (None, None) => None,
                (None, Some(posture)) => Some(Box::new(replace(posture))),
                (Some(action), pending) => {
                    let action = with_change(action, pending);
                    let still = Action::Move(Box::new(Move::of(Motion::Nothing)));
                    (action != still).then(|| Box::new(action))
                }
            }
        };
        let strong = one(&sign.strong, strong, Hand::Strong);
        let weak = one(&sign.weak, weak, Hand::Weak);
        Action::Split(strong, weak)
    }
}

fn replace(posture: Posture) -> Action {
    Action::Move(Box::new(Move::of(Motion::Replace(posture))))
}

/// An action with a change of posture that none of its own changes took.
fn with_change(action: Action, pending: Option<Posture>) -> Action {
    let Some(posture) = pending else { return action };
    match action {
        Action::Move(one) if one.motion == Motion::Nothing => {
            Action::Move(Box::new(Move { motion: Motion::Replace(posture), ..*one }))
        }
        Action::Together(mut parts) => {
            parts.push(replace(posture));
            Action::Together(parts)
        }
        other => Action::Together(vec![other, replace(posture)]),
    }
}

/// Whether a hand's tiers say something at a key.
fn states(own: &Manual, key: usize) -> bool {
    own.configuration.stated(key).is_some()
        || own.orientation.stated(key).is_some()
        || own.placement.stated(key).is_some()
}

fn mirror_of(sign: &Sign) -> Option<Reflection> {
    match sign.hands {
        phonology::Hands::Both(Some(symmetry)) => Some(Reflection::of(symmetry)),
        phonology::Hands::Strong | phonology::Hands::Weak | phonology::Hands::Both(None) => None,
    }
}

/// The value that a key states, for both hands at once where the weak one has what follows from the strong one.
fn split<T: Clone + PartialEq>(
    sign: &Sign,
    key: usize,
    tier: impl Fn(&Manual) -> &Keys<T>,
    image: impl Fn(Option<Reflection>, &T) -> T,
) -> Option<Split<T>> {
    let (strong, weak) = (tier(&sign.strong).stated(key), tier(&sign.weak).stated(key));
    let mirror = mirror_of(sign);
    match sign.hands {
        phonology::Hands::Strong => strong.cloned().map(Split::Both),
        phonology::Hands::Weak => weak.cloned().map(Split::Both),
        phonology::Hands::Both(Some(_)) if tier(&sign.weak).is_empty() => strong.cloned().map(Split::Both),
        // Beside a strong hand that acts alone, the weak one is as it was.
        phonology::Hands::Both(None) if key > 0 && weak.is_none() => strong.cloned().map(Split::Both),
        phonology::Hands::Both(_) => match (strong, weak) {
            (None, None) => None,
            (Some(s), Some(w)) if image(mirror, s) == *w => Some(Split::Both(s.clone())),
            (s, w) => Some(Split::Each(s.cloned(), w.cloned())),
        },
    }
}

fn pair<T>(strong: Option<T>, weak: Option<T>, same: bool) -> Option<Split<T>> {
    match (strong, weak) {
        (None, None) => None,
        (Some(s), _) if same => Some(Split::Both(s)),
        (s, w) => Some(Split::Each(s, w)),
    }
}
