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

    /// The class of what is some steps on, a side passed over.
    fn place_after_side(&self, steps: usize) -> Option<Kind> {
        match self.ahead(steps) {
            Some(Kind::At | Kind::Beside) => self.ahead(steps + 1),
            kind => kind,
        }
    }

    /// Whether a place of body or arm, or neutral space, begins here.
    fn body_site_ahead(&self) -> bool {
        matches!(self.place_after_side(0), Some(Kind::Body(_) | Kind::Arm(_) | Kind::Neutral))
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
        let after_side = self.place_after_side(0);
        let mut site = match (after_side, self.ahead(1)) {
            (Some(Kind::Digit(digit)), Some(Kind::NamedPlace)) => return Ok(self.named_site(digit)),
            (Some(Kind::NamedPlace), Some(Kind::Digit(digit))) => return Ok(self.named_site(digit)),
            (Some(Kind::Arm(_)), _) if self.arm_to_hand() => {
                Site::Hand { level: self.hand_levels()?, contact: early, with: None }
            }
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
        self.other_part(site)
    }

    /// A part of the hand beside a place of the body, without the brackets that it needs.
    fn other_part(&mut self, site: Site) -> Read<Site> {
        const MENDED: &str =
            "the part of the hand at a place belongs after it, in `hamseqbegin` contact part `hamseqend`";
        match site {
            Site::Hand { level: hand, contact, with: None } if self.body_site_ahead() => {
                let span = self.span_before();
                self.warn_at(span, MENDED, "read as if it stood there");
                let mut body = self.site()?;
                if let Site::Body { contact: near, with, .. } = &mut body {
                    *near = near.or(contact).or(Some(Contact::Touch));
                    *with = Some(with.take().unwrap_or(hand));
                }
                Ok(body)
            }
            Site::Body { level: Some(level), behind, contact, with: None } if self.hand_part_ahead() => {
                let span = self.span();
                self.warn_at(span, MENDED, "read as if it stood there");
                let hand = self.hand_levels()?;
                let near = match self.peek() {
                    Some(Kind::Contact(near)) => {
                        self.next();
                        Some(near)
                    }
                    _other => contact,
                };
                let contact = contact.or(near).or(Some(Contact::Touch));
                Ok(Site::Body { level: Some(level), behind, contact, with: Some(hand) })
            }
            site => Ok(site),
        }
    }

    /// Whether a part of the hand is here that no name of a place follows.
    fn hand_part_ahead(&self) -> bool {
        match self.peek() {
            Some(Kind::Hand(_) | Kind::Part(_)) => true,
            Some(Kind::Digit(_)) => !matches!(self.ahead(1), Some(Kind::NamesPlace | Kind::NamedPlace)),
            _other => false,
        }
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
            let hand = match p.place_after_side(0) {
                Some(Kind::Hand(_) | Kind::Digit(_) | Kind::Part(_) | Kind::Arm(_)) => Some(p.hand_levels()?),
                _other => None,
            };
            if p.body_site_ahead() {
                p.warn("is no part of the hand; it is passed over");
                p.site()?;
            }
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
            Some(Kind::Open(Bracket::Sequence)) if self.splits_places() => self.split_places(),
            Some(Kind::Open(Bracket::Sequence)) if matches!(self.place_after_side(2), Some(Kind::Body(_))) => {
                self.warn("begins brackets around one place, which say nothing");
                Ok(Location::One(self.inside(Parser::site)?))
            }
            Some(Kind::Open(Bracket::Sequence)) => self.constellation(None),
            Some(Kind::Open(_)) => self.split_places(),
            _other => Ok(Location::One(self.site()?)),
        }
    }

    /// Reads the brackets of two places, which are here, and how the hands meet there.
    fn split_places(&mut self) -> Read<Location> {
        if !self.plus_inside()
            && (self.at + 1..self.closing(self.at))
                .any(|at| matches!(self.kind(at), Some(Kind::Open(Bracket::Together))))
        {
            self.warn("begins brackets around one place, which say nothing");
            return self.inside(Parser::location);
        }
        let (strong, weak) = self.sides()?;
        if !strong.posture_is_empty() || weak.as_ref().is_some_and(|side| !side.posture_is_empty()) {
            let span = self.span_before();
            self.warn_at(span, "these brackets hold postures beside places", "the postures are passed over");
        }
        match (strong.site, weak) {
            (strong, Some(weak)) => match points(strong, weak.site) {
                Ok(points) => self.constellation(Some(points)),
                Err(mut location) => {
                    self.contact_of_split(&mut location);
                    Ok(*location)
                }
            },
            (Some(site), None) => Ok(Location::One(site)),
            (None, None) => self.unexpected(&["a place"]),
        }
    }

    /// A contact after the brackets of two places, which is said of both.
    fn contact_of_split(&mut self, location: &mut Location) {
        let (Some(Kind::Contact(contact)), Location::Split(strong, weak)) = (self.peek(), location) else { return };
        self.warn("belongs after each place, inside the brackets; it is read as said of both");
        for site in strong.iter_mut().chain(weak) {
            if let Some(of_site) = contact_of(site) {
                *of_site = of_site.or(Some(contact));
            }
        }
        self.next();
    }

    /// Whether a place of body or arm, or neutral space, comes after the contact here.
    fn body_site_after_contact(&self) -> bool {
        matches!(self.place_after_side(1), Some(Kind::Body(_) | Kind::Arm(_) | Kind::Neutral))
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

/// The points of two hands at each other, where both sites in brackets are parts of hands or arms of which nothing more is said;
/// else the places of the two hands.
pub(super) fn points(first: Option<Site>, second: Option<Site>) -> Result<(HandLevels, HandLevels), Box<Location>> {
    if first.as_ref().is_some_and(is_point)
        && second.as_ref().is_some_and(is_point)
        && let (Some(touched), Some(touching)) = (first.clone().and_then(point), second.clone().and_then(point))
    {
        return Ok((touched, touching));
    }
    Err(Box::new(Location::Split(first, second)))
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
