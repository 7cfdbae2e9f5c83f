//! Single movements as symbols.

use super::Writer;
use super::posture::{digit_tag, successive};
use crate::notation::hamnosys::syntax::*;
use crate::phonology::{Size, WristMotion};

impl Writer {
    /// Writes a movement with what is said of it.
    pub(super) fn one_move(&mut self, one: &Move) {
        self.motion(&one.motion);
        let manner = [
            (one.fast, "hamfast"),
            (one.slow, "hamslow"),
            (one.tense, "hamtense"),
            (one.rest, "hamrest"),
            (one.halt, "hamhalt"),
        ];
        manner.into_iter().filter(|(said, _)| *said).for_each(|(_, tag)| self.put(tag));
        if one.bouncing {
            self.cannot("HamNoSys has no symbol for bouncing");
        }
        if one.speed.is_some() {
            self.cannot("HamNoSys has no symbol for the speed of a movement in numbers");
        }
        if let Some(site) = &one.brushing {
            self.put("hamseqbegin");
            self.put("hambrushing");
            self.site(site);
            self.put("hamseqend");
        }
        match one.names.as_deref() {
            None => {}
            Some(name @ ("1" | "2" | "3" | "4" | "5")) => {
                self.number(name);
                self.put("hamcoreftag");
            }
            Some(_) => self.cannot("HamNoSys names places by the numbers 1 to 5 alone"),
        }
    }

    fn motion(&mut self, motion: &Motion) {
        match motion {
            Motion::Nothing => self.put("hamnomotion"),
            Motion::Straight(straight) => self.straight(straight),
            Motion::Circle(circle) => self.circle(circle),
            Motion::Wrist(wrist, size) => {
                self.put(match wrist {
                    WristMotion::Nod => "hamnodding",
                    WristMotion::Swing => "hamswinging",
                    WristMotion::Twist => "hamtwisting",
                    WristMotion::StirClockwise => "hamstircw",
                    WristMotion::StirCounterclockwise => "hamstirccw",
                });
                self.size(*size);
            }
            Motion::FingerPlay(digits) => {
                self.put("hamfingerplay");
                digits.iter().for_each(|digit| self.put(digit_tag(*digit)));
            }
            Motion::Replace(posture) => self.replace(posture),
            Motion::Cross => self.put("hammovecross"),
        }
    }

    fn replace(&mut self, posture: &Posture) {
        self.put("hamreplace");
        match successive(posture) {
            None => {}
            Some(Successive::TowardPinky) => self.put("hamincreasing"),
            Some(Successive::TowardThumb) => self.put("hamdecreasing"),
        }
        if let Some(Split::Each(Some(strong), Some(weak))) = &posture.shape
            && strong.successive != weak.successive
        {
            self.cannot("HamNoSys lets the fingers of both hands change in the same way alone");
        }
        self.posture_parts(posture);
    }

    fn straight(&mut self, straight: &Straight) {
        self.direction("hammove", straight.direction);
        if let Some(between) = straight.between {
            self.put("hambetween");
            self.direction("hammove", between);
        }
        self.size(straight.size);
        if let Some((roll, size)) = straight.arc {
            for letter in roll.tag().chars() {
                self.put_tag(&format!("hamarc{letter}"));
            }
            self.size(size);
        }
        self.waves(straight.waves);
        self.growth(straight.growth);
    }

    fn circle(&mut self, circle: &Circle) {
        self.direction("hamcircle", circle.axis);
        if let Some(between) = circle.between {
            self.put("hambetween");
            self.direction("hamcircle", between);
        }
        self.size(circle.size);
        if (circle.start, circle.full) == (None, None) && circle.end.is_some() {
            self.cannot("HamNoSys says where a circle ends only after where it begins or how often it turns");
        }
        self.clock(circle.start);
        match circle.full {
            None => {}
            Some(Times::Once) => self.put("hamclockfull"),
            Some(Times::Twice) => {
                self.put("hamclockfull");
                self.put("hamclockfull");
            }
        }
        self.clock(circle.end);
        if let Some((ellipse, size)) = circle.ellipse {
            self.ellipse(ellipse);
            self.size(size);
        }
        self.waves(circle.waves);
        self.growth(circle.growth);
    }

    fn clock(&mut self, clock: Option<Clock>) {
        if let Some(clock) = clock {
            let tag = crate::phonology::roll::Roll::TAGS[usize::from(clock.eighths()) % 8];
            self.put_tag(&format!("hamclock{tag}"));
        }
    }

    fn ellipse(&mut self, ellipse: Ellipse) {
        self.put(match ellipse {
            Ellipse::Horizontal => "hamellipseh",
            Ellipse::UpRight => "hamellipseur",
            Ellipse::Vertical => "hamellipsev",
            Ellipse::UpLeft => "hamellipseul",
        });
    }

    fn waves(&mut self, waves: Option<Waves>) {
        if let Some(waves) = waves {
            self.put(match waves.style {
                WaveStyle::Zigzag => "hamzigzag",
                WaveStyle::Wavy => "hamwavy",
            });
            self.size(waves.size);
            if let Some(plane) = waves.plane {
                self.ellipse(plane);
            }
        }
    }

    /// Writes how something grows.
    pub(super) fn growth(&mut self, growth: Option<Growth>) {
        if let Some(growth) = growth {
            self.put(match growth.change {
                Change::Increasing => "hamincreasing",
                Change::Decreasing => "hamdecreasing",
            });
            self.size(growth.size);
        }
    }

    /// Writes a size.
    pub(super) fn size(&mut self, size: Size) {
        match size {
            Size::Small => self.put("hamsmallmod"),
            Size::Normal => {}
            Size::Large => self.put("hamlargemod"),
        }
    }
}
