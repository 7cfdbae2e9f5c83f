//! Places as symbols.

use super::Writer;
use super::posture::{digit_tag, part_tag};
use crate::notation::hamnosys::kind::Kind;
use crate::notation::hamnosys::parse::{Handed, is_point};
use crate::notation::hamnosys::symbol::Symbol;
use crate::notation::hamnosys::syntax::*;

impl Writer {
    /// Writes a location.
    pub(super) fn location(&mut self, location: &Location) {
        match location {
            Location::One(site) => self.site(site),
            Location::Split(None, None) => self.cannot("HamNoSys cannot split a place that neither hand has"),
            Location::Split(strong, weak) => {
                if strong.as_ref().is_some_and(is_point) && weak.as_ref().is_some_and(is_point) {
                    self.cannot("HamNoSys reads two parts of hands without contact as hands at each other");
                }
                self.put("hamparbegin");
                self.or_nothing(strong.as_ref(), Writer::site);
                self.put("hamplus");
                self.or_nothing(weak.as_ref(), Writer::site);
                self.put("hamparend");
            }
            Location::Constellation(constellation) => self.constellation(constellation),
        }
    }

    fn constellation(&mut self, constellation: &Constellation) {
        if let Some((touched, touching)) = &constellation.points {
            self.put("hamparbegin");
            self.hand_levels(touched);
            self.put("hamplus");
            self.hand_levels(touching);
            self.put("hamparend");
        }
        match (constellation.contact, &constellation.points) {
            (Some(Contact::ArmExtended), None) => self.cannot("HamNoSys has a stretched arm in places alone"),
            (Some(contact), _) => self.contact(contact),
            (None, Some(_)) => {}
            (None, None) => self.cannot("HamNoSys needs a contact or points for hands at each other"),
        }
        match &constellation.at {
            None => {}
            Some(Site::Hand { .. }) => {
                self.cannot("HamNoSys has two hands at a place of the body, not at one of a hand")
            }
            Some(site) => {
                if self.handed == Handed::One && constellation.points.is_none() {
                    self.cannot("HamNoSys reads a contact before a place as that of one hand, in a sign of one hand");
                }
                self.site(site);
            }
        }
    }

    /// Writes a site.
    pub(super) fn site(&mut self, site: &Site) {
        match site {
            Site::Body { level, behind, contact, with } => {
                match level {
                    Some(levels) => self.body_levels(levels),
                    None => self.put("hamneutralspace"),
                }
                if *behind && level.is_none() {
                    self.cannot("HamNoSys has nothing behind neutral space");
                } else if *behind {
                    self.put("hambehind");
                }
                self.how_near(*contact, with.as_ref());
            }
            Site::Hand { level, contact, with } => {
                self.hand_levels(level);
                self.how_near(*contact, with.as_ref());
            }
            Site::Named(name) => match name.as_str() {
                "1" | "2" | "3" | "4" | "5" => {
                    self.number(name);
                    self.put("hamcorefref");
                }
                _other => self.cannot("HamNoSys names places by the numbers 1 to 5 alone"),
            },
        }
    }

    /// Writes a number as its finger.
    pub(super) fn number(&mut self, name: &str) {
        let index = name.bytes().next().map_or(0, |digit| usize::from(digit.saturating_sub(b'1')));
        self.put(digit_tag(crate::phonology::Digit::ALL[index.min(4)]));
    }

    fn how_near(&mut self, contact: Option<Contact>, with: Option<&HandLevels>) {
        match (contact, with) {
            (None, None) => {}
            (Some(contact), None) => self.contact(contact),
            (Some(contact), Some(hand)) => {
                self.put("hamseqbegin");
                self.contact(contact);
                self.hand_levels(hand);
                self.put("hamseqend");
            }
            (None, Some(_)) => {
                self.cannot("HamNoSys says the part of the hand that is at a place with a contact alone")
            }
        }
    }

    fn contact(&mut self, contact: Contact) {
        self.put(match contact {
            Contact::Touch => "hamtouch",
            Contact::Close => "hamclose",
            Contact::Interlock => "haminterlock",
            Contact::Cross => "hamcross",
            Contact::ArmExtended => "hamarmextended",
        });
    }

    fn body_levels(&mut self, levels: &BodyLevels) {
        self.body_level(&levels.first);
        if let Some(between) = &levels.between {
            self.put("hambetween");
            self.body_level(between);
        }
    }

    /// Writes a place of body or arm.
    pub(super) fn body_level(&mut self, level: &BodyLevel) {
        self.side_before(level.side);
        let on_arm = match self.tag(&level.place) {
            Some(Kind::Arm(_) | Kind::Hand(_)) => true,
            Some(Kind::Body(_)) => false,
            Some(_) | None => return self.cannot(&format!("HamNoSys has no place `{}`", level.place)),
        };
        if level.approximate {
            self.put("hametc");
        }
        if level.face.is_some() && !on_arm {
            self.cannot("HamNoSys says palmar and dorsal of arms and hands alone");
        }
        self.face(level.face);
        self.side_after(level.side);
    }

    /// Writes the symbol of a place and says its class.
    fn tag(&mut self, place: &str) -> Option<Kind> {
        let symbol = Symbol::of_tag(&format!("ham{place}"))?;
        self.out.push(symbol);
        Some(symbol.kind())
    }

    fn hand_levels(&mut self, levels: &HandLevels) {
        self.hand_level(&levels.first);
        if let Some(between) = &levels.between {
            self.put("hambetween");
            self.hand_level(between);
        }
    }

    fn hand_level(&mut self, level: &HandLevel) {
        self.side_before(level.side);
        match &level.part {
            HandPlace::Hand(place) => match self.tag(place) {
                Some(Kind::Arm(_) | Kind::Hand(_)) => {}
                Some(_) | None => self.cannot(&format!("HamNoSys has no part of the hand `{place}`")),
            },
            HandPlace::Digits(digits, part) => self.digits(digits, *part),
        }
        if level.approximate {
            self.put("hametc");
        }
        self.face(level.face);
        self.side_after(level.side);
    }

    /// Writes a part of digits: one digit before its part, several after it.
    fn digits(&mut self, digits: &[crate::phonology::Digit], part: Option<FingerPart>) {
        match (digits, part) {
            ([], None) => self.cannot("HamNoSys needs a digit or a part of one"),
            ([one], Some(part)) => {
                self.put(digit_tag(*one));
                self.put(part_tag(part));
            }
            (digits, part) => {
                if let Some(part) = part {
                    self.put(part_tag(part));
                }
                digits.iter().for_each(|digit| self.put(digit_tag(*digit)));
            }
        }
    }

    fn face(&mut self, face: Option<Face>) {
        match face {
            None => {}
            Some(Face::Dorsal) => self.put("hamhandback"),
            Some(Face::Palmar) => self.put("hampalm"),
        }
    }

    fn side_before(&mut self, side: Option<Side>) {
        match side {
            Some(Side::LeftBeside) => self.put("hamlrbeside"),
            Some(Side::LeftAt) => self.put("hamlrat"),
            Some(Side::RightAt | Side::RightBeside) | None => {}
        }
    }

    fn side_after(&mut self, side: Option<Side>) {
        match side {
            Some(Side::RightAt) => self.put("hamlrat"),
            Some(Side::RightBeside) => self.put("hamlrbeside"),
            Some(Side::LeftBeside | Side::LeftAt) | None => {}
        }
    }
}
