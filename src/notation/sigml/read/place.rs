//! Places: of the body, of a hand, of each hand, and hands at each other.

use super::reader::{Attr, Node, Reader, attributes, elements, short, tag_span};
use super::words::{ARM, BODY, CONTACT, FLANK, Flank, PART};
use crate::notation::hamnosys::syntax::{
    BodyLevel, BodyLevels, Constellation, Contact, Face, HandLevel, HandLevels, HandPlace, Location, Side, Site,
};

/// The elements that are a place.
pub(super) const PLACES: [&str; 5] =
    ["location_bodyarm", "location_hand", "split_location", "handconstellation", "use_locname"];

/// The attributes of a place.
#[derive(Default)]
struct PlaceWords<'a> {
    first: LevelWords<'a>,
    second: LevelWords<'a>,
    behind: bool,
    contact: Option<Contact>,
}

#[derive(Default, Clone, Copy)]
struct LevelWords<'a> {
    location: Option<Attr<'a>>,
    side: Option<Attr<'a>>,
    digits: Option<Attr<'a>>,
    approximate: Option<Attr<'a>>,
}

impl LevelWords<'_> {
    fn is_written(&self) -> bool {
        self.location.is_some() || self.side.is_some() || self.digits.is_some()
    }
}

const ATTRIBUTES: &[&str] = &[
    "location",
    "second_location",
    "side",
    "second_side",
    "digits",
    "second_digits",
    "approx_location",
    "behind",
    "contact",
];

impl<'a> Reader<'a> {
    /// Any element that is a place.
    pub(super) fn location(&mut self, node: Node<'a>) -> Option<Location> {
        match node.tag_name().name() {
            "split_location" => self.split_location(node),
            "handconstellation" => self.constellation(node).map(Location::Constellation),
            _ => self.site(node).map(Location::One),
        }
    }

    /// `split_location`: a place each; the weak hand's may be missing.
    fn split_location(&mut self, node: Node<'a>) -> Option<Location> {
        self.no_attributes(node);
        self.no_text(node);
        let (mut sites, mut count) = ([None, None], 0);
        for child in elements(node) {
            match child.tag_name().name() {
                "location_bodyarm" | "location_hand" | "use_locname" if count < 2 => {
                    sites[count] = self.site(child);
                    count += 1;
                }
                _ => self.unknown_element(child, &PLACES),
            }
        }
        if count == 0 {
            let told = self.warning(tag_span(node), "`split_location` names no place");
            self.say(told.label("passed over"));
            return None;
        }
        let [strong, weak] = sites;
        Some(Location::Split(strong, weak))
    }

    /// `handconstellation`.
    fn constellation(&mut self, node: Node<'a>) -> Option<Constellation> {
        self.no_text(node);
        let mut contact = None;
        for attr in attributes(node) {
            match attr.name {
                "contact" => contact = self.value(&attr, &CONTACT),
                _ => self.unknown_attribute(&attr, &["contact"]),
            }
        }
        let (mut points, mut at): (Vec<HandLevels>, Option<Site>) = (Vec::new(), None);
        for child in elements(node) {
            match child.tag_name().name() {
                "location_hand" if points.len() < 2 => {
                    let (levels, near) = self.point(child)?;
                    contact = contact.or(near);
                    points.push(levels);
                }
                "location_bodyarm" | "use_locname" if at.is_none() => at = self.site(child),
                _ => self.unknown_element(child, &["location_hand", "location_bodyarm"]),
            }
        }
        let points = match <[HandLevels; 2]>::try_from(points) {
            Ok([strong, weak]) => Some((strong, weak)),
            Err(rest) => rest.into_iter().next().map(|one| {
                let told = self.warning(tag_span(node), "one part of a hand: it is meant of both hands");
                self.say(told.label("expected two `location_hand`"));
                (one.clone(), one)
            }),
        };
        Some(Constellation { points, contact, at })
    }

    /// A part of a hand, where nothing stands but that part.
    fn point(&mut self, node: Node<'a>) -> Option<(HandLevels, Option<Contact>)> {
        self.no_content(node);
        let words = self.place_words(node);
        Some((self.hand_levels(&words)?, words.contact))
    }

    /// One place; `None` where it has a fault.
    pub(super) fn site(&mut self, node: Node<'a>) -> Option<Site> {
        if node.tag_name().name() == "use_locname" {
            return self.named_place(node);
        }
        let words = self.place_words(node);
        let mut with = None;
        self.no_text(node);
        for child in elements(node) {
            match child.tag_name().name() {
                "location_hand" | "location_bodyarm" if with.is_none() => with = Some(self.point(child)?.0),
                _ => self.unknown_element(child, &["location_hand"]),
            }
        }
        let contact = words.contact;
        if self.is_of_hand(node, &words) {
            if words.behind {
                let told = self.warning(tag_span(node), "`behind` is said of places of the body only: passed over");
                self.say(told.label("here"));
            }
            return Some(Site::Hand { level: self.hand_levels(&words)?, contact, with });
        }
        Some(Site::Body { level: self.body_levels(&words)?, behind: words.behind, contact, with })
    }

    /// Whether the place is of a hand: the element says it, unless its place cannot be meant so.
    fn is_of_hand(&mut self, node: Node<'a>, words: &PlaceWords) -> bool {
        let place = words.first.location.map_or("", |attr| attr.value);
        let element = node.tag_name().name() == "location_hand";
        let is_of_hand = match element {
            true => !BODY.contains(&place),
            false => PART.find(place).is_some() || words.first.digits.is_some(),
        };
        if is_of_hand != element {
            let other = if is_of_hand { "location_hand" } else { "location_bodyarm" };
            let told = self.warning(tag_span(node), &format!("a place that belongs in a `{other}`: read as one"));
            self.say(told.label("here"));
        }
        is_of_hand
    }

    fn named_place(&mut self, node: Node<'a>) -> Option<Site> {
        self.no_content(node);
        let mut name = None;
        for attr in attributes(node) {
            match attr.name {
                "use_locname" => name = Some(attr.raw.to_owned()),
                _ => self.unknown_attribute(&attr, &["use_locname"]),
            }
        }
        if name.is_none() {
            let fault = self.fault(tag_span(node), "the place has no name").label("expected `use_locname=\"…\"`");
            self.say(fault);
        }
        name.map(Site::Named)
    }

    fn place_words(&mut self, node: Node<'a>) -> PlaceWords<'a> {
        let mut words = PlaceWords::default();
        for attr in attributes(node) {
            match attr.name {
                "location" => words.first.location = Some(attr),
                "side" => words.first.side = Some(attr),
                "digits" => words.first.digits = Some(attr),
                "approx_location" => words.first.approximate = Some(attr),
                "second_location" => words.second.location = Some(attr),
                "second_side" => words.second.side = Some(attr),
                "second_digits" => words.second.digits = Some(attr),
                "behind" => words.behind = self.truth(&attr),
                "contact" => words.contact = self.value(&attr, &CONTACT),
                _ => self.unknown_attribute(&attr, ATTRIBUTES),
            }
        }
        words
    }

    /// Side or face.
    fn flank(&mut self, side: Option<Attr>) -> (Option<Side>, Option<Face>) {
        let Some(attr) = side else { return (None, None) };
        if attr.value == "front" {
            self.odd(&attr, "a place has its front before it anyway: passed over");
            return (None, None);
        }
        match self.value(&attr, &FLANK) {
            Some(Flank::Side(side)) => (Some(side), None),
            Some(Flank::Face(face)) => (None, Some(face)),
            None => (None, None),
        }
    }

    /// Places of the body; `Some(None)` is neutral space.
    fn body_levels(&mut self, words: &PlaceWords) -> Option<Option<BodyLevels>> {
        let neutral = words.first.location.is_none_or(|attr| attr.value == "neutralspace");
        if neutral {
            if let Some(attr) = words.first.side.or(words.second.location).or(words.second.side) {
                self.odd(&attr, "neutral space has no sides: passed over");
            }
            return Some(None);
        }
        let first = self.body_level(&words.first)?;
        let mut second = words.second;
        let between = if second.is_written() {
            if let (None, Some(side)) = (second.location, second.side) {
                self.odd(&side, "there is no `second_location`: the same place is meant");
                second.location = words.first.location;
            }
            Some(self.body_level(&second)?)
        } else {
            None
        };
        Some(Some(BodyLevels { first, between }))
    }

    fn body_level(&mut self, words: &LevelWords) -> Option<BodyLevel> {
        if let Some(attr) = words.digits {
            self.odd(&attr, "places of the body have no digits: passed over");
        }
        let attr = words.location?;
        let (side, face) = self.flank(words.side);
        let Some(place) = BODY.iter().chain(ARM).find(|place| **place == attr.value) else {
            self.no_value(&attr, "a place of the body", BODY.iter().chain(ARM).copied());
            return None;
        };
        let approximate = words.approximate.is_some_and(|attr| self.truth(&attr));
        Some(BodyLevel { place: (*place).to_owned(), approximate, side, face })
    }

    fn hand_levels(&mut self, words: &PlaceWords) -> Option<HandLevels> {
        let first = self.hand_level(&words.first)?;
        let between = if words.second.is_written() { Some(self.hand_level(&words.second)?) } else { None };
        let nothing =
            HandLevel { part: HandPlace::Digits(Vec::new(), None), approximate: false, side: None, face: None };
        Some(HandLevels { first, between: between.filter(|level| *level != nothing) })
    }

    fn hand_level(&mut self, words: &LevelWords) -> Option<HandLevel> {
        let (side, face) = self.flank(words.side);
        let digits = match words.digits {
            Some(attr) => self.digits(&attr)?,
            None => Vec::new(),
        };
        let part = match words.location {
            None => HandPlace::Digits(digits, None),
            Some(attr) => match (PART.find(attr.value), ARM.iter().find(|place| **place == attr.value)) {
                (Some(part), _) => HandPlace::Digits(digits, Some(part)),
                (None, Some(place)) => {
                    if let Some(attr) = words.digits {
                        let message = format!("`{}` is not a part of digits: they are passed over", short(place));
                        self.odd(&attr, &message);
                    }
                    HandPlace::Hand((*place).to_owned())
                }
                (None, None) => {
                    self.no_value(&attr, "a place of the hand", PART.list().chain(ARM.iter().copied()));
                    return None;
                }
            },
        };
        let approximate = words.approximate.is_some_and(|attr| self.truth(&attr));
        Some(HandLevel { part, approximate, side, face })
    }
}
