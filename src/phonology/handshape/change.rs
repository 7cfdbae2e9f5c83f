//! From a described configuration to joint angles: changes and `between`.
//!
//! Where a changed handshape is one that HamNoSys writes and the inventory has a row for it, it is that row's hand, as it was
//! solved on the mesh. Else the fingers are made from the base's, each by its change (`fingers`), and the thumb is taken from
//! the row whose thumb does the same and whose fingers are most alike (`thumb`).

use super::angles::{FingerAngles, HandAngles};
use super::inventory::{HandshapeInventory, NotFound};
use super::limits::HandLimits;
use super::shape::Handshape;
use super::thumb::{Thumb, Wish};
use super::written::Written;
use crate::phonology::{Bend, Configuration, Digit, Digits, HandshapeChange, Opening, ThumbPosition};

/// A hand while changes are applied to it.
pub(super) struct Shaping<'a> {
    pub(super) inventory: &'a HandshapeInventory,
    /// The base's row.
    pub(super) row: &'a Handshape,
    pub(super) fingers: [FingerAngles; 4],
    /// Spread of the stretched fingers, radians.
    pub(super) spread: [f64; 4],
    /// The fingers that the handshape is about; bends without digits are theirs.
    pub(super) selected: Digits,
    /// Digits that bends of the whole hand leave alone.
    pub(super) kept: Digits,
    /// The bend of the whole hand, where a change gave one.
    pub(super) bend: Option<Bend>,
    pub(super) thumb: Thumb,
    opening: Option<Opening>,
    /// What HamNoSys writes for the hand as it is now; `None` where a change is none of HamNoSys's.
    pub(super) written: Option<Written>,
}

impl HandshapeInventory {
    /// The joint angles of a described configuration: its named handshape as solved on the avatar, halfway to
    /// the second where one is named, with the changes applied in order, within a hand's limits.
    ///
    /// A list of fingers (`on ring pinky`) said of a whole that lies between two is said of both.
    ///
    /// # Errors
    /// A name that no handshape, or several, answer to.
    ///
    /// ```
    /// use chereme::phonology::handshape::HandshapeInventory;
    /// use chereme::phonology::{Configuration, Digit, Digits, HandshapeChange};
    /// let inventory = HandshapeInventory::builtin();
    /// let changes = vec![HandshapeChange::On(Digits::of([Digit::Pinky]))];
    /// let pinky = Configuration { changes, ..Configuration::named("1") };
    /// assert_eq!(inventory.angles(&pinky, None).unwrap(), inventory.find("I", None).unwrap().angles());
    /// ```
    pub fn angles(&self, configuration: &Configuration, language: Option<&str>) -> Result<HandAngles, NotFound> {
        let base = self.find(&configuration.base, language)?;
        let Some(between) = &configuration.between else {
            return Ok(self.shaped(base, configuration.changes.iter().copied()).0);
        };
        let second = self.find(&between.second, language)?;
        let is_list = |change: &HandshapeChange| matches!(change, HandshapeChange::On(_));
        let lists = || configuration.changes.iter().copied().filter(is_list);
        let (first, from) = self.shaped(base, lists().chain(between.first.iter().copied()));
        let (second, to) = self.shaped(second, lists().chain(between.changes.iter().copied()));
        let mut whole = Shaping::of(self, base);
        whole.mixed(&first.lerp(&second, 0.5), from.zip(to));
        for change in configuration.changes.iter().filter(|change| !is_list(change)) {
            whole.apply(*change);
        }
        Ok(HandLimits::ANATOMICAL.clamp(&whole.composed()))
    }

    /// A row's hand with changes, and where its thumb is.
    fn shaped(
        &self,
        row: &Handshape,
        changes: impl Iterator<Item = HandshapeChange>,
    ) -> (HandAngles, Option<ThumbPosition>) {
        let mut shaping = Shaping::of(self, row);
        for change in changes {
            shaping.apply(change);
        }
        (HandLimits::ANATOMICAL.clamp(&shaping.hand()), shaping.thumb_position())
    }
}

impl<'a> Shaping<'a> {
    fn of(inventory: &'a HandshapeInventory, row: &'a Handshape) -> Shaping<'a> {
        let angles = row.angles();
        Shaping {
            inventory,
            row,
            fingers: angles.fingers,
            spread: row.spread,
            selected: row.selected_fingers(),
            kept: Digits::NONE,
            bend: None,
            thumb: Thumb { angles: angles.thumb, wish: Wish::Own, bend: None },
            opening: None,
            written: row.written,
        }
    }

    /// Takes a hand that lies between two as it is. From a closed index's side to across the closed fingers a thumb goes over
    /// the index, not through it.
    fn mixed(&mut self, hand: &HandAngles, thumbs: Option<(ThumbPosition, ThumbPosition)>) {
        self.fingers = hand.fingers;
        let along_and_across = matches!(
            thumbs,
            Some((ThumbPosition::Along, ThumbPosition::Across) | (ThumbPosition::Across, ThumbPosition::Along))
        );
        let wish = if along_and_across && hand.fingers[0].pip > CLOSED { Wish::OverIndex } else { Wish::Kept };
        self.thumb = Thumb { angles: hand.thumb, wish, bend: None };
        self.written = None;
    }

    /// Where the thumb is, as its wish or the row says.
    fn thumb_position(&self) -> Option<ThumbPosition> {
        match self.thumb.wish {
            Wish::Position(position) => Some(position),
            Wish::Own | Wish::Kept => self.row.thumb_position(),
            Wish::OverIndex | Wish::Between(..) | Wish::At(_) | Wish::Touch(..) => None,
        }
    }

    fn apply(&mut self, change: HandshapeChange) {
        self.note(change);
        match change {
            HandshapeChange::Thumb(position) => self.thumb.wish = Wish::Position(position),
            HandshapeChange::ThumbBetween(a, b) => self.thumb.wish = Wish::Between(a.min(b), a.max(b)),
            HandshapeChange::ThumbAt(part) => self.thumb.wish = Wish::At(part),
            HandshapeChange::Bend(digits, bend) => self.bend_by(digits, bend),
            HandshapeChange::Joints(digits, quarters) => self.quarters(digits, quarters),
            HandshapeChange::Spread(spread) => self.spread_out(spread),
            HandshapeChange::Cross(front, behind) => self.cross(front, behind),
            HandshapeChange::On(fingers) => self.on(fingers),
            HandshapeChange::Except(digits) => self.kept = digits,
            HandshapeChange::Opening(opening) => self.opening = Some(opening),
            HandshapeChange::Meet(a, part, b) => self.meet(a, part, b),
        }
    }

    /// What HamNoSys would write after a change.
    fn note(&mut self, change: HandshapeChange) {
        let (kept, selected) = (self.kept, self.selected);
        let Some(written) = &mut self.written else { return };
        let mut expressible = true;
        match change {
            HandshapeChange::Thumb(position) => {
                written.thumb = position;
                written.between = None;
            }
            HandshapeChange::ThumbBetween(a, b) => {
                written.thumb = ThumbPosition::Across;
                written.between = Some((a.min(b), a.max(b)));
            }
            HandshapeChange::Bend(digits, bend) if digits.is_empty() || digits == selected => {
                written.bend = Some(bend);
                expressible = kept.is_empty();
            }
            HandshapeChange::Bend(digits, bend) => {
                digits.iter().for_each(|digit| written.digits[digit as usize] = Some(bend));
            }
            HandshapeChange::On(fingers) if fingers == selected => {}
            HandshapeChange::On(fingers) => written.list = fingers,
            HandshapeChange::Meet(a, part, Digit::Thumb) => written.meet = Some((Digit::Thumb, part, a)),
            HandshapeChange::Meet(a, part, b) => written.meet = Some((a, part, b)),
            // How open it is, is made from the row without it.
            HandshapeChange::Except(_) | HandshapeChange::Opening(_) => {}
            HandshapeChange::ThumbAt(_)
            | HandshapeChange::Spread(_)
            | HandshapeChange::Cross(..)
            | HandshapeChange::Joints(..) => expressible = false,
        }
        if !expressible {
            self.written = None;
        }
    }

    /// The hand that the changes come to.
    fn hand(&self) -> HandAngles {
        let solved = self
            .written
            .and_then(|w| if Some(w) == self.row.written { Some(self.row) } else { self.inventory.written_as(&w) });
        let hand = solved.map_or_else(|| self.composed(), Handshape::angles);
        self.opened(hand)
    }

    /// The hand from its parts.
    fn composed(&self) -> HandAngles {
        HandAngles { fingers: self.fingers, thumb: self.suited_thumb() }
    }

    /// A C or a pinch opened or closed: along the way from the pinch to the C and beyond.
    fn opened(&self, hand: HandAngles) -> HandAngles {
        let (Some(opening), Some(written)) = (self.opening, self.row.written) else { return hand };
        let bend = if self.bend == Some(Bend::Bent) { self.bend } else { written.bend };
        let (Some(pinch), Some(cee)) = (self.inventory.pinch(bend), self.inventory.cee(bend)) else { return hand };
        let (pinch, cee) = (pinch.angles(), cee.angles());
        let way = match (opening, written.is_cee()) {
            (Opening::Tight, true) => TIGHT,
            (Opening::Tight, false) => TIGHT / 2.0,
            (Opening::Slack, true) => SLACK,
            (Opening::Slack, false) => 1.0,
        };
        let mut open = hand;
        for (i, digit) in Digit::FINGERS.into_iter().enumerate() {
            if self.selected.contains(digit) {
                open.fingers[i] = pinch.fingers[i].lerp(&cee.fingers[i], way);
            }
        }
        if !written.is_cee() || opening == Opening::Tight {
            open.thumb = pinch.thumb.lerp(&cee.thumb, way.min(1.0));
        }
        open
    }
}

/// The flexion of the middle joint beyond which a finger is closed enough to have a thumb laid over it, radians.
const CLOSED: f64 = 1.0;
/// How far from the pinch to the C a tight one stands.
const TIGHT: f64 = 0.5;
/// How far a slack one stands: beyond the C.
const SLACK: f64 = 1.7;
