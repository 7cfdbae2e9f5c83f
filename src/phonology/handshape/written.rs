//! A handshape as HamNoSys writes it: class, thumb, bend, list of fingers and what is said of single digits.
//!
//! Rows of the inventory say in tokens what HamNoSys writes for them. Read as these features, they let a change find the
//! row that was solved for exactly what it comes to: `1, on pinky` is the row of `hamfinger2 hamthumbacrossmod hampinky`.

use crate::phonology::{Bend, Digit, Digits, HandPart, Opening, ThumbPosition};

/// HamNoSys's twelve classes, by their tokens.
const CLASSES: [&str; 12] = [
    "hamfist",
    "hamflathand",
    "hamfinger2",
    "hamfinger23",
    "hamfinger23spread",
    "hamfinger2345",
    "hampinch12",
    "hampinchall",
    "hampinch12open",
    "hamcee12",
    "hamceeall",
    "hamceeopen",
];

/// What HamNoSys writes of a handshape that is one class (not halfway between two).
#[derive(Debug, Clone, Copy, PartialEq, Eq, Hash)]
pub(super) struct Written {
    /// Which of [`CLASSES`].
    class: usize,
    /// The thumb's modifier; [`ThumbPosition::Along`] where there is none.
    pub thumb: ThumbPosition,
    /// The bend of the whole hand.
    pub bend: Option<Bend>,
    /// The fingers listed.
    pub list: Digits,
    /// Bends of single digits, from the thumb on.
    pub digits: [Option<Bend>; 5],
    /// A digit at a part of another.
    pub meet: Option<(Digit, HandPart, Digit)>,
    /// The fingers that the thumb comes out between, the nearer to the thumb first.
    pub between: Option<(Digit, Digit)>,
    /// How open a C is.
    pub opening: Option<Opening>,
}

impl Written {
    /// A class with at most a bend.
    pub(super) fn plain(class: &str, bend: Option<Bend>) -> Option<Written> {
        let class = if class == "hamcee12open" { "hamceeopen" } else { class };
        Some(Written {
            class: CLASSES.iter().position(|c| *c == class)?,
            thumb: ThumbPosition::Along,
            bend,
            list: Digits::NONE,
            digits: [None; 5],
            meet: None,
            between: None,
            opening: None,
        })
    }

    /// Reads a row's tokens; `None` for none, and for what is no single class.
    pub(super) fn of(tokens: &[String]) -> Option<Written> {
        let mut rest = tokens.iter().map(String::as_str).peekable();
        let mut written = Written::plain(rest.next()?, None)?;
        while let Some(token) = rest.next() {
            if let Some(thumb) = thumb_of(token) {
                written.set_thumb(thumb);
            } else if let Some(bend) = bend_of(token) {
                written.bend = Some(bend);
            } else if let Some(digit) = digit_of(token) {
                if let Some(bend) = rest.peek().and_then(|t| bend_of(t)) {
                    rest.next();
                    written.digits[digit as usize] = Some(bend);
                } else if let Some(part) = rest.peek().and_then(|t| part_of(t)) {
                    rest.next();
                    written.meet = Some((digit, part, digit_of(rest.next()?)?));
                } else {
                    written.list = Digits::of(written.list.iter().chain([digit]));
                }
            } else if token == "hambetween" {
                match rest.next() {
                    None => written.thumb = ThumbPosition::Enclosed,
                    Some(near) => {
                        let (near, far) = (digit_of(near)?, digit_of(rest.next()?)?);
                        written.between = Some((near.min(far), near.max(far)));
                    }
                }
            } else {
                return None;
            }
        }
        Some(written)
    }

    /// Whether the class is a C of thumb and fingers.
    pub(super) fn is_cee(&self) -> bool {
        CLASSES[self.class].starts_with("hamcee")
    }

    /// Whether fingers and thumb meet: a pinch or a C.
    pub(super) fn meets_thumb(&self) -> bool {
        self.is_cee() || CLASSES[self.class].starts_with("hampinch")
    }

    /// Sets the thumb; after a C the same modifiers say how open it is.
    pub(super) fn set_thumb(&mut self, thumb: ThumbPosition) {
        match thumb {
            ThumbPosition::Across if self.is_cee() => self.opening = Some(Opening::Tight),
            ThumbPosition::Opposed if self.is_cee() => self.opening = Some(Opening::Slack),
            ThumbPosition::Along
            | ThumbPosition::Out
            | ThumbPosition::Across
            | ThumbPosition::Opposed
            | ThumbPosition::Enclosed => self.thumb = thumb,
        }
    }
}

fn thumb_of(token: &str) -> Option<ThumbPosition> {
    match token {
        "hamthumboutmod" => Some(ThumbPosition::Out),
        "hamthumbacrossmod" => Some(ThumbPosition::Across),
        "hamthumbopenmod" => Some(ThumbPosition::Opposed),
        _ => None,
    }
}

fn bend_of(token: &str) -> Option<Bend> {
    match token {
        "hamfingerstraightmod" => Some(Bend::Bent),
        "hamfingerbendmod" => Some(Bend::Round),
        "hamfingerhookmod" => Some(Bend::Hooked),
        "hamdoublebent" => Some(Bend::DoubleBent),
        "hamdoublehooked" => Some(Bend::DoubleHooked),
        _ => None,
    }
}

fn digit_of(token: &str) -> Option<Digit> {
    match token {
        "hamthumb" => Some(Digit::Thumb),
        "hamindexfinger" => Some(Digit::Index),
        "hammiddlefinger" => Some(Digit::Middle),
        "hamringfinger" => Some(Digit::Ring),
        "hampinky" => Some(Digit::Pinky),
        _ => None,
    }
}

fn part_of(token: &str) -> Option<HandPart> {
    match token {
        "hamfingertip" => Some(HandPart::Tip),
        "hamfingernail" => Some(HandPart::Nail),
        "hamfingerpad" => Some(HandPart::Pad),
        "hamfingermidjoint" => Some(HandPart::Midjoint),
        "hamfingerbase" => Some(HandPart::Base),
        "hamfingerside" => Some(HandPart::Side),
        _ => None,
    }
}
