//! Hand shapes: the many attributes of a `handconfig` that describe one.

use super::reader::{Attr, Reader};
use super::words::{BEND, CLASS, Exactness, OPENING, PART, SUCCESSIVE, THUMB, digit, digits, is_cee, quarters};
use crate::notation::hamnosys::syntax::{
    Bend, BentClass, FingerList, FingerPart, ListedFinger, Shape, ShapeClass, Thumb, ThumbSpecial,
};
use crate::phonology::{Digit, Digits};

/// What one `handconfig` says of the shape.
#[derive(Default)]
pub(super) struct ShapeWords<'a> {
    main: ClassWords<'a>,
    second: ClassWords<'a>,
    approximate: Option<Attr<'a>>,
    special: Option<Attr<'a>>,
    exempted: Option<Attr<'a>>,
    opposed: Option<Attr<'a>>,
    bends: Vec<(Digit, Attr<'a>)>,
    pairs: [Option<Attr<'a>>; 2],
    kinds: [Option<Attr<'a>>; 2],
    /// `thumbbetween`, `thumbenclosed`, `thumbcontact`: one of them.
    thumb: Option<Attr<'a>>,
    successive: Option<Attr<'a>>,
}

/// A class with its thumb and bend.
#[derive(Default)]
struct ClassWords<'a> {
    class: Option<Attr<'a>>,
    thumb: Option<Attr<'a>>,
    opening: Option<Attr<'a>>,
    bend: Option<Attr<'a>>,
}

/// Names of attributes of a shape, for guesses; those of single digits are known by their pattern.
pub(super) const ATTRIBUTES: &[&str] = &[
    "handshape",
    "thumbpos",
    "ceeopening",
    "mainbend",
    "second_handshape",
    "second_thumbpos",
    "second_ceeopening",
    "second_mainbend",
    "approx_shape",
    "specialfingers",
    "exempteddigits",
    "opposedfinger",
    "contactpair",
    "contactkind",
    "second_contactpair",
    "second_contactkind",
    "thumbbetween",
    "thumbenclosed",
    "thumbcontact",
    "successivefingers",
];

impl<'a> ShapeWords<'a> {
    /// Where an attribute of the shape is kept; `None` for others.
    pub(super) fn slot(&mut self, name: &str) -> Option<&mut Option<Attr<'a>>> {
        Some(match name {
            "handshape" => &mut self.main.class,
            "thumbpos" => &mut self.main.thumb,
            "ceeopening" => &mut self.main.opening,
            "mainbend" => &mut self.main.bend,
            "second_handshape" => &mut self.second.class,
            "second_thumbpos" => &mut self.second.thumb,
            "second_ceeopening" => &mut self.second.opening,
            "second_mainbend" => &mut self.second.bend,
            "approx_shape" => &mut self.approximate,
            "specialfingers" => &mut self.special,
            "exempteddigits" => &mut self.exempted,
            "opposedfinger" => &mut self.opposed,
            "contactpair" => &mut self.pairs[0],
            "contactkind" => &mut self.kinds[0],
            "second_contactpair" => &mut self.pairs[1],
            "second_contactkind" => &mut self.kinds[1],
            "thumbbetween" | "thumbenclosed" | "thumbcontact" => &mut self.thumb,
            "successivefingers" => &mut self.successive,
            _ => return None,
        })
    }

    /// Keeps `bend1` to `bend5`; whether the attribute was one of them.
    pub(super) fn bend(&mut self, attr: Attr<'a>) -> bool {
        let mut rest = attr.name.strip_prefix("bend").unwrap_or_default().chars();
        let (Some(digit), None) = (rest.next().and_then(digit), rest.next()) else { return false };
        self.bends.push((digit, attr));
        true
    }

    /// The word of the class, where one is written.
    pub(super) fn class(&self) -> Option<&'a str> {
        self.main.class.map(|attr| attr.value)
    }

    /// Leaves the class away.
    pub(super) fn forget_class(&mut self) {
        self.main.class = None;
    }

    /// The first attribute that is written.
    fn first(&self) -> Option<Attr<'a>> {
        let of = |words: &ClassWords<'a>| words.class.or(words.thumb).or(words.opening).or(words.bend);
        let fingers = self.special.or(self.exempted).or(self.opposed);
        let digits = self.bends.first().map(|(_, attr)| *attr).or(self.pairs[0]).or(self.kinds[0]);
        let more = self.pairs[1].or(self.kinds[1]).or(self.thumb).or(self.successive);
        of(&self.main).or(of(&self.second)).or(self.approximate).or(fingers).or(digits).or(more)
    }
}

impl Reader<'_> {
    /// The shape that the attributes describe; `None` without a class.
    pub(super) fn shape(&mut self, words: &ShapeWords) -> Option<Shape> {
        let Some(class) = words.main.class else {
            if let Some(attr) = words.first() {
                self.odd(&attr, &format!("`{}` says nothing without `handshape`: passed over", attr.name));
            }
            return None;
        };
        let class = self.value(&class, &CLASS)?;
        let main = self.class(class, &words.main);
        let mut shape = Shape { main, ..Shape::of(class) };
        shape.approximate = words.approximate.is_some_and(|attr| self.truth(&attr));
        shape.between = self.second_class(&main, words);
        for (digit, attr) in &words.bends {
            if let Some(bend) = self.bend(attr) {
                shape.bends.push((Some(*digit), bend));
            }
        }
        for i in 0..2 {
            shape.crossings.extend(self.crossing(words.pairs[i], words.kinds[i]));
        }
        shape.thumb = words.thumb.and_then(|attr| self.thumb_special(&attr));
        shape.successive = words.successive.and_then(|attr| self.value(&attr, &SUCCESSIVE));
        self.fingers_of(&mut shape, words);
        Some(shape)
    }

    /// Thumb and bend of a class.
    fn class(&mut self, class: ShapeClass, words: &ClassWords) -> BentClass {
        let position = words.thumb.and_then(|attr| self.value(&attr, &THUMB));
        let opening = words.opening.and_then(|attr| self.value(&attr, &OPENING));
        let thumb: Option<Thumb> = if is_cee(class) { opening.or(position) } else { position.or(opening) };
        if let Some(attr) = words.opening.filter(|_| !is_cee(class)) {
            self.odd(&attr, "only a C has an opening: read as the position of the thumb");
        }
        BentClass { class, thumb, bend: words.bend.and_then(|attr| self.bend(&attr)) }
    }

    /// The other end of a shape halfway between two; its class may be left out where it is the same.
    fn second_class(&mut self, main: &BentClass, words: &ShapeWords) -> Option<BentClass> {
        let second = &words.second;
        let attr = second.class.or(second.thumb).or(second.opening).or(second.bend)?;
        let class = match second.class {
            Some(class) => self.value(&class, &CLASS)?,
            None => {
                self.odd(&attr, "there is no `second_handshape`: the same class is meant");
                main.class
            }
        };
        Some(self.class(class, second))
    }

    fn bend(&mut self, attr: &Attr) -> Option<Bend> {
        if let Some((bend, exactness)) = quarters(attr.value) {
            if let (Bend::Quarters([a, b, c]), Exactness::Rounded) = (bend, exactness) {
                self.rounded(attr, exactness, &format!("quarters of a bend, `{a}{b}{c}`"));
            }
            return Some(bend);
        }
        self.value(attr, &BEND)
    }

    /// A list of digits, each once.
    pub(super) fn digits(&mut self, attr: &Attr) -> Option<Vec<Digit>> {
        let Some(mut list) = digits(attr.value).filter(|list| !list.is_empty()) else {
            let message = format!("`{}` is no list of digits", super::short(attr.value));
            let fault = self.fault(attr.span, &message).label("expected digits from 1, the thumb, to 5");
            self.say(fault.hint("digits are written together: `23` is index and middle finger"));
            return None;
        };
        let written = list.len();
        let mut seen = Digits::NONE;
        list.retain(|digit| {
            let new = !seen.contains(*digit);
            seen = Digits::of(seen.iter().chain([*digit]));
            new
        });
        if list.len() < written {
            self.odd(attr, "a digit is listed twice");
        }
        Some(list)
    }

    /// Two digits that touch.
    fn crossing(&mut self, pair: Option<Attr>, kind: Option<Attr>) -> Option<(Digit, FingerPart, Digit)> {
        let (pair, kind) = match (pair, kind) {
            (None, None) => return None,
            (Some(pair), Some(kind)) => (pair, kind),
            (Some(one), None) | (None, Some(one)) => {
                self.odd(&one, "`contactpair` and `contactkind` need each other: passed over");
                return None;
            }
        };
        let part = self.value(&kind, &PART);
        let [first, second] = self.two(&pair)?;
        Some((first, part?, second))
    }

    /// Two digits.
    fn two(&mut self, attr: &Attr) -> Option<[Digit; 2]> {
        let list = self.digits(attr)?;
        let two = <[Digit; 2]>::try_from(list).ok();
        if two.is_none() {
            let message = format!("`{}` should name two digits", attr.name);
            self.say(self.fault(attr.span, &message).label("expected two digits, such as `23`"));
        }
        two
    }

    fn thumb_special(&mut self, attr: &Attr) -> Option<ThumbSpecial> {
        match attr.name {
            "thumbbetween" => self.two(attr).map(|[a, b]| ThumbSpecial::Between(a, b)),
            "thumbenclosed" => self.truth(attr).then_some(ThumbSpecial::Enclosed),
            _ => self.value(attr, &PART).map(ThumbSpecial::At),
        }
    }

    /// The list of fingers: SiGML has an attribute for each of its meanings, HamNoSys one list, whose meaning the class says.
    fn fingers_of(&mut self, shape: &mut Shape, words: &ShapeWords) {
        let special = words.special.and_then(|attr| self.digits(&attr));
        let mut exempted = words.exempted.and_then(|attr| self.digits(&attr));
        if let Some(list) = &mut exempted
            && list.contains(&Digit::Thumb)
        {
            list.retain(|digit| *digit != Digit::Thumb);
            match (shape.thumb, words.exempted) {
                (None, _) => shape.thumb = Some(ThumbSpecial::Exempted),
                (Some(_), Some(attr)) => self.odd(&attr, "one thing can be said of the thumb: its bend is passed over"),
                (Some(_), None) => {}
            }
        }
        let exempted = exempted.filter(|list| !list.is_empty());
        let list = special.as_ref().or(exempted.as_ref());
        let listed = |finger: &Digit| ListedFinger { finger: *finger, opposed: false };
        shape.fingers = list.into_iter().flatten().map(listed).collect();
        if shape.fingers.iter().any(|f| f.finger == Digit::Thumb) {
            shape.fingers.retain(|f| f.finger != Digit::Thumb);
            words.special.inspect(|attr| self.odd(attr, "the thumb is no special finger: passed over"));
        }
        self.oppose(shape, words.opposed);
        self.check_list(shape, words, [special, exempted]);
    }

    /// Marks the finger that the thumb is opposed to.
    fn oppose(&mut self, shape: &mut Shape, opposed: Option<Attr>) {
        let Some(attr) = opposed else { return };
        for finger in self.digits(&attr).unwrap_or_default() {
            match shape.fingers.iter_mut().find(|f| f.finger == finger) {
                Some(listed) => listed.opposed = true,
                None => self.odd(&attr, "the opposed finger is none of the special fingers: passed over"),
            }
        }
    }

    /// Says where attributes mean what the list of this class cannot mean.
    fn check_list(&mut self, shape: &Shape, words: &ShapeWords, lists: [Option<Vec<Digit>>; 2]) {
        let (attr, meaning) = match (shape.lists(), lists) {
            (_, [None, None]) => return,
            (FingerList::Special, [Some(_), None]) | (FingerList::Exempted, [None, Some(_)]) => return,
            (FingerList::SpecialAndExempted, [special, exempted]) if special == exempted => return,
            (FingerList::Special, [_, Some(_)]) => (words.exempted, "the fingers that act"),
            (FingerList::Exempted, [Some(_), _]) => (words.special, "the fingers that the bend leaves alone"),
            (FingerList::SpecialAndExempted, _) => (words.special.or(words.exempted), "both kinds of fingers at once"),
        };
        if let Some(attr) = attr {
            self.odd(&attr, &format!("with this hand shape a list of fingers can only be {meaning}: read so"));
        }
    }
}
