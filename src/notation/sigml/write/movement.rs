//! Single motions.

use super::action::{growth, replacement};
use super::element::Element;
use super::words::{ELLIPSE, WAVE, WRIST, clock_letters, number};
use super::{place, unsayable};
use crate::diagnostics::Error;
use crate::notation::hamnosys::syntax::{Circle, Motion, Move, Straight, Times, Waves};
use crate::phonology::Digit;

/// A motion with what is said of it.
pub(super) fn movement(moved: &Move) -> Result<Element, Error> {
    let mut element = match &moved.motion {
        Motion::Nothing => Element::new("nomotion"),
        Motion::Straight(path) => straight(path),
        Motion::Circle(path) => circle(path)?,
        Motion::Wrist(motion, size) => {
            let mut element = Element::new("wristmotion");
            element.word("motion", *motion, &WRIST);
            element.size("size", *size);
            element
        }
        Motion::FingerPlay(digits) => finger_play(digits)?,
        Motion::Replace(posture) => return replacement(moved, posture),
        Motion::Cross => Element::new("crossmotion"),
    };
    manner(&mut element, moved)?;
    element.children.extend(moved.brushing.as_ref().map(place::site).transpose()?);
    Ok(element)
}

/// Attributes of any motion.
pub(super) fn manner(element: &mut Element, moved: &Move) -> Result<(), Error> {
    element.mark("fast", moved.fast);
    element.mark("slow", moved.slow);
    element.mark("tense", moved.tense);
    element.mark("rest", moved.rest);
    element.mark("halt", moved.halt);
    element.mark("bouncing", moved.bouncing);
    element.factor("speed", moved.speed)?;
    if let Some(name) = &moved.names {
        element.set("def_locname", name.as_str());
    }
    Ok(())
}

fn straight(path: &Straight) -> Element {
    let mut element = Element::new("directedmotion");
    element.direction("direction", path.direction);
    if let Some(second) = path.between {
        element.direction("second_direction", second);
    }
    element.size("size", path.size);
    if let Some((toward, size)) = path.arc {
        element.set("curve", toward.tag());
        element.size("curve_size", size);
    }
    if let Some(waves) = path.waves {
        self::waves(&mut element, waves);
        if let Some(plane) = waves.plane {
            element.word("ellipse_direction", plane, &ELLIPSE);
        }
    }
    growth(&mut element, path.growth, ["incrdecr", "incrdecr_size"]);
    element
}

fn circle(path: &Circle) -> Result<Element, Error> {
    let mut element = Element::new("circularmotion");
    element.direction("axis", path.axis);
    if let Some(second) = path.between {
        element.direction("second_axis", second);
    }
    element.size("size", path.size);
    if let Some(start) = path.start {
        element.set("start", clock_letters(start));
    }
    element.mark("clockplus", path.full.is_some());
    element.mark("second_clockplus", path.full == Some(Times::Twice));
    if let Some(end) = path.end {
        element.set("end", clock_letters(end));
    }
    if let Some((axis, size)) = path.ellipse {
        element.word("ellipse_direction", axis, &ELLIPSE);
        // The field's own transform writes this size over the circle's; a name of its own keeps both.
        element.size("ellipse_size", size);
    }
    if let Some(waves) = path.waves {
        if waves.plane.is_some() {
            return unsayable("in gestural SiGML waves along a circle have no plane of their own");
        }
        self::waves(&mut element, waves);
    }
    growth(&mut element, path.growth, ["incrdecr", "incrdecr_size"]);
    Ok(element)
}

fn waves(element: &mut Element, waves: Waves) {
    element.word("zigzag_style", waves.style, &WAVE);
    element.size("zigzag_size", waves.size);
}

fn finger_play(digits: &[Digit]) -> Result<Element, Error> {
    let numbers: String = digits.iter().map(|digit| number(*digit)).collect();
    if numbers.char_indices().any(|(i, c)| numbers[..i].contains(c)) {
        return unsayable("a play of fingers has each digit once");
    }
    let mut element = Element::new("fingerplay");
    if !numbers.is_empty() {
        element.set("digits", numbers);
    }
    Ok(element)
}
