//! Where hands are: a site each, or hands at each other.
//!
//! ```text
//! site          = digit corefref | level [behind] [contact] | neutral [armextended]
//! contact       = contact | seq( contact hand level )
//! location      = site | par( [site] plus [site] ) | constellation
//! constellation = [par( hand level plus hand level )] contact [site]
//! ```
//! A contact before a place belongs to the hands in signs of two hands, and to the place in signs of one.

use super::cursor::{Handed, Parser, Read};
use crate::notation::hamnosys::kind::{Bracket, Kind};
use crate::notation::hamnosys::syntax::*;
use crate::phonology::Digit;

impl Parser {
    /// Whether a site begins here: a place, perhaps with its side first.
    pub(super) fn site_ahead(&self) -> bool {
        match self.peek() {
            Some(Kind::Body(_) | Kind::Arm(_) | Kind::Hand(_) | Kind::Part(_) | Kind::Neutral) => true,
            Some(Kind::Contact(_)) => true,
            Some(Kind::Digit(_)) => self.ahead(1) != Some(Kind::NamesPlace),
            Some(Kind::NamedPlace) => matches!(self.ahead(1), Some(Kind::Digit(_))),
            Some(Kind::At | Kind::Beside | Kind::Behind) => self.place_at(1),
            _other => false,
        }
    }

    /// Whether a place is some steps on.
    fn place_at(&self, steps: usize) -> bool {
        matches!(self.ahead(steps), Some(Kind::Body(_) | Kind::Arm(_) | Kind::Hand(_) | Kind::Digit(_) | Kind::Part(_)))
    }

    /// Whether a place of body or arm, or neutral space, begins here.
    fn body_site_ahead(&self) -> bool {
        match self.peek() {
            Some(Kind::Body(_) | Kind::Arm(_) | Kind::Neutral) => true,
            Some(Kind::At | Kind::Beside) => matches!(self.ahead(1), Some(Kind::Body(_) | Kind::Arm(_))),
            _other => false,
        }
    }

    /// Whether `seq( contact … )` or `seq( hand part … )` opens here.
    pub(super) fn contact_group_ahead(&self) -> bool {
        self.opens(Bracket::Sequence)
            && matches!(self.ahead(1), Some(Kind::Contact(_) | Kind::Hand(_) | Kind::Digit(_) | Kind::Part(_)))
    }

    /// Reads a site, which is here.
    pub(super) fn site(&mut self) -> Read<Site> {
        let early = self.early_contact();
        let behind_first = self.peek() == Some(Kind::Behind);
        if behind_first {
            self.warn("belongs after the place");
            self.next();
        }
        let after_side = if matches!(self.peek(), Some(Kind::At | Kind::Beside)) { self.ahead(1) } else { self.peek() };
        let mut site = match (after_side, self.ahead(1)) {
            (Some(Kind::Digit(digit)), Some(Kind::NamedPlace)) => return Ok(self.named_site(digit)),
            (Some(Kind::NamedPlace), Some(Kind::Digit(digit))) => return Ok(self.named_site(digit)),
            (Some(Kind::Body(_) | Kind::Arm(_)), _) => {
                let level = Some(self.body_levels()?);
                Site::Body { level, behind: behind_first, contact: early, with: None }
            }
            (Some(Kind::Neutral), _) => {
                self.next();
                Site::Body { level: None, behind: false, contact: early, with: None }
            }
            (Some(Kind::Hand(_) | Kind::Digit(_) | Kind::Part(_)), _) => {
                Site::Hand { level: self.hand_levels()?, contact: early, with: None }
            }
            _other if early.is_some() => Site::Body { level: None, behind: false, contact: early, with: None },
            _other => return self.unexpected(&["a place"]),
        };
        self.how_near(&mut site)?;
        Ok(site)
    }

    /// A contact before the place that it is of.
    fn early_contact(&mut self) -> Option<Contact> {
        let Some(Kind::Contact(contact)) = self.peek() else { return None };
        self.warn("belongs after the place; it is read as if it stood there");
        self.next();
        Some(contact)
    }

    fn named_site(&mut self, digit: Digit) -> Site {
        self.at += 2;
        Site::Named((digit as u8 + 1).to_string())
    }

    /// What follows a place: behind, how near, with what part of the hand.
    fn how_near(&mut self, site: &mut Site) -> Read<()> {
        loop {
            match self.peek() {
                Some(Kind::Behind) => match site {
                    Site::Body { behind, .. } => {
                        *behind = true;
                        self.next();
                    }
                    Site::Hand { .. } | Site::Named(_) => self.skip("is not said of places of the hand"),
                },
                Some(Kind::Contact(here)) => {
                    if let Some(contact) = contact_of(site).filter(|c| c.is_none()) {
                        *contact = Some(here);
                        self.next();
                    } else {
                        self.skip("is a second contact at the same place");
                    }
                }
                Some(Kind::Open(Bracket::Sequence))
                    if self.contact_group_ahead() && with_of(site).is_some_and(|w| w.is_none()) =>
                {
                    let (contact, hand) = self.contact_group()?;
                    if let Some(of_site) = contact_of(site) {
                        *of_site = Some(contact);
                    }
                    if let Some(with) = with_of(site) {
                        *with = hand;
                    }
                }
                _other => return Ok(()),
            }
        }
    }

    /// Reads `seq( contact hand )`, which is here.
    fn contact_group(&mut self) -> Read<(Contact, Option<HandLevels>)> {
        self.inside(|p| {
            let contact = match p.peek() {
                Some(Kind::Contact(contact)) => {
                    p.next();
                    contact
                }
                _other => {
                    p.warn("is the part of the hand that is there; touch is assumed");
                    Contact::Touch
                }
            };
            let hand_ahead = p.site_ahead() && !p.body_site_ahead() || matches!(p.peek(), Some(Kind::Arm(_)));
            let hand = if hand_ahead { Some(p.hand_levels()?) } else { None };
            while let Some(Kind::Contact(_)) = p.peek() {
                p.skip("is a second contact at the same place");
            }
            Ok((contact, hand))
        })
    }

    /// Whether a location begins here.
    pub(super) fn location_ahead(&self) -> bool {
        self.site_ahead() || self.contact_group_ahead() || self.splits_places()
    }

    /// Reads a location, which is here.
    pub(super) fn location(&mut self) -> Read<Location> {
        match self.peek() {
            Some(Kind::Contact(contact)) if contact != Contact::ArmExtended => {
                let place_next = self.body_site_after_contact();
                if self.handed == Handed::One && (place_next || self.place_at(1)) {
                    return Ok(Location::One(self.site()?));
                }
                self.constellation(None)
            }
            Some(Kind::Open(Bracket::Sequence)) => self.constellation(None),
            Some(Kind::Open(_)) => {
                let (strong, weak) = self.sides()?;
                if !strong.posture_is_empty() || weak.as_ref().is_some_and(|side| !side.posture_is_empty()) {
                    let span = self.span_before();
                    self.warn_at(span, "these brackets hold postures beside places", "the postures are passed over");
                }
                match (strong.site, weak) {
                    (strong, Some(weak)) => match points(strong, weak.site) {
                        Ok(points) => self.constellation(Some(points)),
                        Err(location) => Ok(location),
                    },
                    (Some(site), None) => Ok(Location::One(site)),
                    (None, None) => self.unexpected(&["a place"]),
                }
            }
            _other => Ok(Location::One(self.site()?)),
        }
    }

    fn body_site_after_contact(&self) -> bool {
        match self.ahead(1) {
            Some(Kind::Body(_) | Kind::Arm(_) | Kind::Neutral) => true,
            Some(Kind::At | Kind::Beside) => matches!(self.ahead(2), Some(Kind::Body(_) | Kind::Arm(_))),
            _other => false,
        }
    }

    /// Reads how two hands meet and where, after their points.
    pub(super) fn constellation(&mut self, points: Option<(HandLevels, HandLevels)>) -> Read<Location> {
        let mut constellation = Constellation { points, contact: None, at: None };
        if let Some(Kind::Contact(contact)) = self.peek() {
            constellation.contact = Some(contact);
            self.next();
        } else if self.contact_group_ahead() {
            let (contact, hand) = self.contact_group()?;
            constellation.contact = Some(contact);
            if let (None, Some(hand)) = (&constellation.points, hand) {
                constellation.points = Some((hand.clone(), hand));
            }
        }
        while let (Some(Kind::Contact(_)), false) = (self.peek(), self.body_site_after_contact()) {
            self.skip("is a second contact of the hands");
        }
        if self.body_site_ahead()
            || (self.peek().is_some_and(|k| matches!(k, Kind::Digit(_))) && self.ahead(1) == Some(Kind::NamedPlace))
        {
            constellation.at = Some(self.site()?);
        }
        Ok(Location::Constellation(constellation))
    }
}

/// The points of two hands at each other, where both sites are parts of hands or arms of which nothing more is said;
/// else the places of the two hands.
pub(super) fn points(strong: Option<Site>, weak: Option<Site>) -> Result<(HandLevels, HandLevels), Location> {
    if strong.as_ref().is_some_and(is_point) && weak.as_ref().is_some_and(is_point) {
        if let (Some(strong), Some(weak)) = (strong.clone().and_then(point), weak.clone().and_then(point)) {
            return Ok((strong, weak));
        }
    }
    Err(Location::Split(strong, weak))
}

/// Whether a site is a part of a hand or arm, and no more is said of it.
pub(in crate::notation::hamnosys) fn is_point(site: &Site) -> bool {
    match site {
        Site::Hand { contact, with, .. } => contact.is_none() && with.is_none(),
        Site::Body { level: Some(levels), behind: false, contact: None, with: None } => {
            is_arm(&levels.first) && levels.between.as_ref().is_none_or(is_arm)
        }
        Site::Body { .. } | Site::Named(_) => false,
    }
}

fn is_arm(level: &BodyLevel) -> bool {
    matches!(level.place.as_str(), "upperarm" | "elbow" | "elbowinside" | "lowerarm")
}

/// A site as a point of a hand or arm.
fn point(site: Site) -> Option<HandLevels> {
    let of_arm = |level: BodyLevel| HandLevel {
        part: HandPlace::Hand(level.place),
        approximate: level.approximate,
        side: level.side,
        face: level.face,
    };
    match site {
        Site::Hand { level, .. } => Some(level),
        Site::Body { level, .. } => {
            level.map(|l| HandLevels { first: of_arm(l.first), between: l.between.map(of_arm) })
        }
        Site::Named(_) => None,
    }
}

fn contact_of(site: &mut Site) -> Option<&mut Option<Contact>> {
    match site {
        Site::Body { contact, .. } | Site::Hand { contact, .. } => Some(contact),
        Site::Named(_) => None,
    }
}

fn with_of(site: &mut Site) -> Option<&mut Option<HandLevels>> {
    match site {
        Site::Body { with, .. } | Site::Hand { with, .. } => Some(with),
        Site::Named(_) => None,
    }
}
