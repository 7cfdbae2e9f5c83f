//! One manual phase: posture, place and actions to the tiers of both hands.

use super::super::dictionary::Dictionary;
use super::super::syntax::{
    self, Action, BodyLevel, Constellation, Fingers, HandLevels, Hands, Location, Palm, Phase, Posture, Shape, Site,
    Split,
};
use super::action::{Depth, leaf};
use super::location::{Places, contact_kind};
use super::orientation::orientation;
use super::shape::configuration;
use crate::diagnostics::{Diagnostic, Span};
use crate::phonology::reflection::Reflection;
use crate::phonology::{
    self, Channel, Configuration, Contact, Distance, Hand, HandPoint, Keys, Manual, Motion, Movement, NonManual,
    NonManualValue, Orientation, Placement, Sign, Symmetry,
};

/// What one hand is known to do while a phase is read.
#[derive(Debug, Clone, Default)]
struct Known {
    shape: Option<Shape>,
    fingers: Option<Fingers>,
    palm: Option<Palm>,
    configuration: Vec<(usize, Configuration)>,
    orientation: Vec<(usize, Orientation)>,
    placement: Vec<(usize, Placement)>,
    movement: Vec<Movement>,
    place: Option<Placement>,
}

/// A phase while it is read.
pub(super) struct Phases<'d> {
    pub(super) dictionary: &'d Dictionary,
    pub(super) diagnostics: &'d mut Vec<Diagnostic>,
    pub(super) span: Span,
    hands: phonology::Hands,
    strong: Known,
    weak: Known,
    contact: Vec<(usize, Contact)>,
    /// What parts of the body do, by key.
    body: Vec<(usize, Channel, NonManual)>,
    /// The key that is read now.
    key: usize,
    /// Whether what is read is said of one hand alone.
    pub(super) alone: bool,
}

/// A phase as a sign without name and face; and what parts of the body do meanwhile.
pub(super) fn phase(
    phase: &Phase,
    dictionary: &Dictionary,
    diagnostics: &mut Vec<Diagnostic>,
) -> (Sign, Vec<(usize, Channel, NonManual)>) {
    let hands = hands_of(phase);
    let mut reading = Phases {
        dictionary,
        diagnostics,
        span: phase.span.0,
        hands,
        strong: Known::default(),
        weak: Known::default(),
        contact: Vec::new(),
        body: Vec::new(),
        key: 0,
        alone: false,
    };
    for action in &phase.body {
        if let Action::OfBody(level, inner) = action {
            reading.of_body(level, inner);
        }
    }
    for hand in reading.acting() {
        reading.take_posture(&phase.posture, hand);
    }
    if let Some(location) = &phase.location {
        reading.locate(location);
    }
    for action in &phase.actions {
        if matches!(action, Action::OfBody(..)) {
            reading.movement(action, Hand::Strong, Depth::Key);
            continue;
        }
        reading.key += 1;
        reading.interval(action);
    }
    reading.finish(phase)
}

/// Which hands act. Split postures or actions without a symmetry need both.
pub(in crate::notation::hamnosys) fn hands_of(phase: &Phase) -> phonology::Hands {
    match phase.hands {
        Hands::Weak => phonology::Hands::Weak,
        Hands::Both(s) => phonology::Hands::Both(Some(symmetry(s))),
        Hands::Strong => {
            let posture = splits_posture(&phase.posture);
            let place = phase.location.as_ref().is_some_and(splits_location);
            let acts = phase.actions.iter().any(splits_action);
            if posture || place || acts { phonology::Hands::Both(None) } else { phonology::Hands::Strong }
        }
    }
}

fn symmetry(s: syntax::Symmetry) -> Symmetry {
    let plain = if s.left_right { Symmetry::MIRRORED } else { Symmetry::PARALLEL };
    Symmetry { up_down: s.up_down, out_in: s.out_in, alternating: s.alternating, crossed: s.non_ipsi, ..plain }
}

fn splits_posture(p: &Posture) -> bool {
    fn each<T>(s: Option<&Split<T>>) -> bool {
        matches!(s, Some(Split::Each(..)))
    }
    each(p.shape.as_ref()) || each(p.fingers.as_ref()) || each(p.palm.as_ref())
}

fn splits_location(l: &Location) -> bool {
    match l {
        Location::One(_) => false,
        Location::Split(_, weak) => weak.is_some(),
        Location::Constellation(c) => c.points.is_some(),
    }
}

/// Whether an action says something else of each hand.
pub(super) fn splits_action(action: &Action) -> bool {
    match action {
        Action::Move(one) => matches!(&one.motion, syntax::Motion::Replace(p) if splits_posture(p)),
        Action::Target(inner, location) => splits_action(inner) || matches!(**location, Location::Split(_, Some(_))),
        Action::Together(all) | Action::Sequence(all) | Action::Fused(all) => all.iter().any(splits_action),
        Action::Split(..) => true,
        Action::Repeated(inner, _) | Action::Alternating(inner, _) => splits_action(inner),
        Action::OfBody(..) => false,
    }
}

fn share<T>(split: Option<&Split<T>>, hand: Hand) -> Option<&T> {
    match (split?, hand) {
        (Split::Both(value), _) => Some(value),
        (Split::Each(strong, _), Hand::Strong) => strong.as_ref(),
        (Split::Each(_, weak), Hand::Weak) => weak.as_ref(),
    }
}

impl Phases<'_> {
    /// The hands that act, the strong one first.
    fn acting(&self) -> Vec<Hand> {
        match self.hands {
            phonology::Hands::Strong => vec![Hand::Strong],
            phonology::Hands::Weak => vec![Hand::Weak],
            phonology::Hands::Both(_) => vec![Hand::Strong, Hand::Weak],
        }
    }

    pub(super) fn has_both_hands(&self) -> bool {
        matches!(self.hands, phonology::Hands::Both(_))
    }

    /// Whether the weak hand acts beside the strong one without following it.
    pub(super) fn is_beside(&self) -> bool {
        self.hands == phonology::Hands::Both(None)
    }

    fn known(&mut self, hand: Hand) -> &mut Known {
        match hand {
            Hand::Strong => &mut self.strong,
            Hand::Weak => &mut self.weak,
        }
    }

    /// How the weak hand follows the strong one.
    pub(super) fn reflection(&self) -> Option<Reflection> {
        match self.hands {
            phonology::Hands::Both(Some(symmetry)) => Some(Reflection::of(symmetry)),
            phonology::Hands::Strong | phonology::Hands::Weak | phonology::Hands::Both(None) => None,
        }
    }

    /// What a posture says of a hand, its state before in mind. `None` where nothing is said of it.
    ///
    /// A hand that follows the other has what that one has, in the mirror; what is split is said of the hand as it is.
    pub(super) fn passing_posture(
        &mut self,
        posture: &Posture,
        hand: Hand,
    ) -> (Option<Configuration>, Option<Orientation>) {
        let reflection = self.reflection().filter(|_| hand == Hand::Weak && !self.alone);
        let shape = share(posture.shape.as_ref(), hand).cloned();
        let dictionary = self.dictionary;
        let configuration = shape.as_ref().map(|s| configuration(s, dictionary));
        let own = |fingers: Option<Fingers>, split: bool| match (fingers, reflection) {
            (Some(f), Some(mirror)) if !split => Some(mirrored_fingers(f, mirror)),
            (f, _) => f,
        };
        let split_fingers = matches!(posture.fingers, Some(Split::Each(..)));
        let split_palm = matches!(posture.palm, Some(Split::Each(..)));
        let fingers = own(share(posture.fingers.as_ref(), hand).copied(), split_fingers);
        let said_palm = share(posture.palm.as_ref(), hand).copied();
        let turned = fingers.is_some() || said_palm.is_some();
        // The strong hand's fingers, about which a palm is rolled that both hands share.
        let strong_fingers = share(posture.fingers.as_ref(), Hand::Strong).copied().or(self.strong.fingers);
        let known = self.known(hand);
        if shape.is_some() {
            known.shape = shape;
        }
        known.fingers = fingers.or(known.fingers);
        let palm = match (said_palm, reflection) {
            (Some(p), Some(mirror)) if !split_palm => Some(mirrored_palm(p, strong_fingers, mirror)),
            (p, _) => p,
        };
        known.palm = palm.or(known.palm);
        let orientation = turned.then(|| orientation(known.fingers.as_ref(), known.palm.as_ref()));
        (configuration, orientation)
    }

    /// Takes note of what a posture says of a hand at the present key.
    pub(super) fn take_posture(&mut self, posture: &Posture, hand: Hand) {
        let key = self.key;
        let (configuration, orientation) = self.passing_posture(posture, hand);
        let known = self.known(hand);
        known.configuration.extend(configuration.map(|c| (key, c)));
        known.orientation.extend(orientation.map(|o| (key, o)));
    }

    /// Takes note of where a hand is at the present key.
    pub(super) fn take_placement(&mut self, place: Option<Placement>, hand: Hand) {
        let key = self.key;
        let known = self.known(hand);
        if let Some(place) = place {
            known.place = Some(place.clone());
            known.placement.retain(|(k, _)| *k != key);
            known.placement.push((key, place));
        }
    }

    /// Takes note of how the hands meet at the present key.
    pub(super) fn take_contact(&mut self, contact: Contact) {
        let key = self.key;
        self.contact.retain(|(k, _)| *k != key);
        self.contact.push((key, contact));
    }

    /// The points of the strong and the weak hand, of a constellation's parts.
    pub(super) fn points(&self, (weak, strong): &(HandLevels, HandLevels)) -> (HandPoint, HandPoint) {
        let places = self.places(Hand::Strong);
        (places.own_point(strong), places.other_point(weak))
    }

    fn places(&self, hand: Hand) -> Places<'_> {
        let (shape, other) = match hand {
            Hand::Strong => (self.strong.shape.as_ref(), self.weak.shape.as_ref()),
            Hand::Weak => (self.weak.shape.as_ref(), self.strong.shape.as_ref()),
        };
        Places { dictionary: self.dictionary, hand, shape, other }
    }

    /// A placement that is said of both hands: in the mirror for one that follows the other.
    pub(super) fn shared_placement(&mut self, site: &Site, hand: Hand) -> Option<Placement> {
        match self.reflection().filter(|_| hand == Hand::Weak) {
            Some(mirror) => self.placement(site, Hand::Strong).map(|p| mirror.placement(&p)),
            None => self.placement(site, hand),
        }
    }

    /// A placement that is said of one hand.
    pub(super) fn placement(&mut self, site: &Site, hand: Hand) -> Option<Placement> {
        let found = self.places(hand).placement(site);
        if found.is_none() {
            self.warn("a place that is none for a hand is left out");
        }
        found
    }

    /// With one hand acting, a contact alone: the place where it is, touched.
    pub(super) fn touched(&mut self, contact: Option<syntax::Contact>) -> Option<Placement> {
        let hand = self.acting().first().copied()?;
        let Some(place) = self.known(hand).place.clone() else {
            self.warn("a contact without a place or a second hand is left out");
            return None;
        };
        let distance = match contact {
            Some(syntax::Contact::Close) => Distance::Close,
            Some(syntax::Contact::ArmExtended) => Distance::Extended,
            None | Some(syntax::Contact::Touch | syntax::Contact::Interlock | syntax::Contact::Cross) => {
                Distance::Touch
            }
        };
        Some(Placement { distance, ..place })
    }

    /// Where the hands are at the start.
    fn locate(&mut self, location: &Location) {
        match location {
            Location::One(site) => {
                for hand in self.acting() {
                    let place = self.shared_placement(site, hand);
                    self.take_placement(place, hand);
                }
            }
            Location::Split(strong, weak) => {
                for (hand, site) in [(Hand::Strong, strong), (Hand::Weak, weak)] {
                    let place = site.as_ref().and_then(|s| self.placement(s, hand));
                    self.take_placement(place, hand);
                }
            }
            Location::Constellation(c) => self.constellation(c),
        }
    }

    fn constellation(&mut self, c: &Constellation) {
        if let Some(site) = &c.at {
            self.locate(&Location::One(site.clone()));
        }
        if self.has_both_hands() {
            let (strong, weak) = c.points.as_ref().map(|points| self.points(points)).unzip();
            self.take_contact(Contact { strong, weak, kind: contact_kind(c.contact) });
        } else if c.at.is_none() {
            self.warn("a contact of two hands says nothing where one acts");
        }
    }

    /// One action of the phase's own line: an interval of both hands.
    fn interval(&mut self, action: &Action) {
        let split = splits_action(action);
        for hand in self.acting() {
            let follows = hand == Hand::Weak && !split;
            let movement = match (self.hands, follows) {
                // A hand beside the strong one does what split actions say.
                (phonology::Hands::Both(None), true) => None,
                (phonology::Hands::Both(Some(symmetry)), true) => {
                    self.followed_values(action);
                    let mirror = Reflection::of(symmetry);
                    self.strong.movement.last().map(|m| mirror.movement(m))
                }
                (_, _) => self.movement(action, hand, Depth::Key),
            };
            let movement = movement.unwrap_or_else(|| leaf(Motion::Hold));
            self.known(hand).movement.push(movement);
        }
    }

    /// The weak hand's values at the key that the strong one has just come to, where it follows.
    pub(super) fn followed_values(&mut self, action: &Action) {
        let key = self.key;
        let Some(mirror) = self.reflection() else { return };
        fn at<T: Clone>(all: &[(usize, T)], key: usize) -> Option<T> {
            all.iter().find(|(k, _)| *k == key).map(|(_, v)| v.clone())
        }
        let configuration = at(&self.strong.configuration, key);
        let orientation = at(&self.strong.orientation, key).map(|o| mirror.orientation(&o));
        let placement = at(&self.strong.placement, key).map(|p| mirror.placement(&p));
        // The state from which later changes start.
        let posture = replaced_in(action);
        if let Some(posture) = posture {
            self.passing_posture(&posture, Hand::Weak);
        }
        self.weak.configuration.extend(configuration.map(|v| (key, v)));
        self.weak.orientation.extend(orientation.map(|v| (key, v)));
        self.weak.placement.extend(placement.map(|v| (key, v)));
    }

    /// What a part of the body does: heads nod, shake and turn; the rest has no tier and is told.
    pub(super) fn of_body(&mut self, level: &BodyLevel, action: &Action) {
        let channel = match level.place.as_str() {
            "head" | "headtop" => Some(Channel::Head),
            "shoulders" | "chest" | "stomach" => Some(Channel::Torso),
            _ => None,
        };
        let value = channel.and_then(|c| body_value(c, action).map(|v| (c, v)));
        match value {
            Some((channel, value)) => self.body.push((self.key, channel, NonManual::plain(value))),
            None => self.warn(format!("what the {} does is left out: no tier holds it", level.place)),
        }
    }

    fn finish(self, phase: &Phase) -> (Sign, Vec<(usize, Channel, NonManual)>) {
        let mut sign = Sign { hands: self.hands, intervals: self.key, ..Sign::named("") };
        sign.contact = keys(self.contact);
        sign.holds_over = phase.holds_over;
        sign.strong = self.strong.manual();
        sign.weak = self.weak.manual();
        match self.hands {
            phonology::Hands::Both(Some(symmetry)) => sign.weak = own_part(&sign.strong, &sign.weak, symmetry),
            phonology::Hands::Strong => sign.weak = Manual::default(),
            phonology::Hands::Weak => sign.strong = Manual::default(),
            phonology::Hands::Both(None) => {
                if sign.weak.movement.iter().all(|m| *m == leaf(Motion::Hold)) {
                    sign.weak.movement.clear();
                }
            }
        }
        (sign, self.body)
    }
}

impl Known {
    fn manual(self) -> Manual {
        Manual {
            configuration: keys(self.configuration),
            placement: keys(self.placement),
            orientation: keys(self.orientation),
            movement: self.movement,
        }
    }
}

/// Values at keys; of two at one key the later holds.
fn keys<T>(values: Vec<(usize, T)>) -> Keys<T> {
    let mut rising: Vec<(usize, T)> = Vec::with_capacity(values.len());
    for (key, value) in values {
        match rising.last_mut() {
            Some((last, old)) if *last == key => *old = value,
            _ => rising.push((key, value)),
        }
    }
    // They rise: phases are read from key to key.
    Keys::new(rising).unwrap_or_default()
}

/// What the weak hand says that does not follow from the strong one.
fn own_part(strong: &Manual, weak: &Manual, symmetry: Symmetry) -> Manual {
    let mirror = Reflection::of(symmetry).manual(strong);
    let same = |own: bool| own;
    Manual {
        configuration: if same(weak.configuration == mirror.configuration) {
            Keys::default()
        } else {
            weak.configuration.clone()
        },
        placement: if same(weak.placement == mirror.placement) { Keys::default() } else { weak.placement.clone() },
        orientation: if same(weak.orientation == mirror.orientation) {
            Keys::default()
        } else {
            weak.orientation.clone()
        },
        movement: if weak.movement == mirror.movement { Vec::new() } else { weak.movement.clone() },
    }
}

fn mirrored_fingers(f: Fingers, mirror: Reflection) -> Fingers {
    Fingers { direction: mirror.direction(f.direction), between: f.between.map(|d| mirror.direction(d)), ..f }
}

/// A palm of the other hand in the mirror: the roll that comes to the mirrored direction.
fn mirrored_palm(palm: Palm, strong_fingers: Option<Fingers>, mirror: Reflection) -> Palm {
    use super::super::syntax::Facing;
    use crate::phonology::roll::Roll;
    let about = strong_fingers
        .map_or(phonology::Direction::OUT.vector(), |f| super::orientation::heading(f.direction, f.between).vector());
    let image = mirror.vector(about);
    let one = |facing: Facing| match facing {
        Facing::Roll(roll) => Facing::Roll(Roll::nearest(image, mirror.vector(roll.palm(about)))),
        Facing::Toward(d) => Facing::Toward(mirror.direction(d)),
    };
    Palm { facing: one(palm.facing), between: palm.between.map(one), ..palm }
}

/// The posture that an action of the own line changes to.
pub(super) fn replaced_in(action: &Action) -> Option<Posture> {
    match action {
        Action::Move(one) => match &one.motion {
            syntax::Motion::Replace(posture) => Some(posture.clone()),
            syntax::Motion::Nothing
            | syntax::Motion::Straight(_)
            | syntax::Motion::Circle(_)
            | syntax::Motion::Wrist(..)
            | syntax::Motion::FingerPlay(_)
            | syntax::Motion::Cross => None,
        },
        Action::Target(inner, _) | Action::Repeated(inner, _) | Action::Alternating(inner, _) => replaced_in(inner),
        Action::Together(parts) => parts.iter().find_map(replaced_in),
        Action::Sequence(_) | Action::Fused(_) | Action::Split(..) | Action::OfBody(..) => None,
    }
}

/// What head or trunk do, as far as their tiers know it.
fn body_value(channel: Channel, action: &Action) -> Option<NonManualValue> {
    use crate::phonology::WristMotion;
    let named = |name: &str| Some(NonManualValue::Named(name.to_owned()));
    match action {
        Action::Move(one) => match &one.motion {
            syntax::Motion::Wrist(WristMotion::Nod, _) if channel == Channel::Head => named("nod"),
            syntax::Motion::Wrist(WristMotion::Twist, _) if channel == Channel::Head => named("shake"),
            syntax::Motion::Wrist(..) => named("sway"),
            syntax::Motion::Straight(s) => {
                Some(NonManualValue::Towards(super::orientation::heading(s.direction, s.between)))
            }
            syntax::Motion::Nothing
            | syntax::Motion::Circle(_)
            | syntax::Motion::FingerPlay(_)
            | syntax::Motion::Replace(_)
            | syntax::Motion::Cross => None,
        },
        Action::Repeated(inner, _) | Action::Alternating(inner, _) | Action::Target(inner, _) => {
            body_value(channel, inner)
        }
        Action::Together(all) | Action::Sequence(all) | Action::Fused(all) => {
            all.first().and_then(|a| body_value(channel, a))
        }
        Action::Split(strong, _) => strong.as_ref().and_then(|a| body_value(channel, a)),
        Action::OfBody(_, inner) => body_value(channel, inner),
    }
}
