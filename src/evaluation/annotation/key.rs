//! The keys of a sign, and what was measured at each.

use super::{Judge, Judged, Judgement};
use crate::body::measure::HandForm;
use crate::corpus::annotate::{HandAnnotation, Value};
use crate::motion::pose::ModelPose;
use crate::phonology::symmetry::{Resolved, acts, resolve};
use crate::phonology::{Configuration, Hand, Heading, Movement, Orientation, Side, Sign, label};
use crate::synthesis::side_of;
use crate::time::Seconds;
use glam::DVec3;

/// One hand's part of one phase of a sign, with its instants.
pub(super) struct Part<'a> {
    pub phase: &'a Sign,
    pub hand: Hand,
    pub side: Side,
    pub said: Resolved,
    /// The instants of its keys.
    pub keys: Vec<Seconds>,
    /// What was measured of the hand.
    pub measured: &'a HandAnnotation,
}

/// Half of a cell of the 26 directions and a tolerance of 5°.
const LOOSE: f64 = 27.5 * std::f64::consts::PI / 180.0;
/// A palm within this of the fingers' direction (the sine of it) says nothing.
const ALONG: f64 = 0.2;
/// Shapes are as near to a form whose distances differ by less, metres.
const AS_NEAR_M: f64 = 1e-3;
/// Findings of the check that are so near to a key in time are about it, seconds.
const ABOUT_S: f64 = 0.03;

impl Judge<'_> {
    /// All judgements of the sign.
    pub(super) fn all(&self) -> Vec<Judgement> {
        let mut all = Vec::new();
        let count = |phase: &Sign| phase.intervals + 1;
        let phases: Vec<&Sign> = self.sign.phases().collect();
        let instants = &self.performance.report.keys;
        if instants.len() != phases.iter().map(|p| count(p)).sum::<usize>() {
            return all;
        }
        all.extend(self.phases());
        let mut from = 0;
        for phase in phases {
            let keys = instants[from..from + count(phase)].to_vec();
            from += count(phase);
            for hand in Hand::BOTH.into_iter().filter(|hand| acts(phase, *hand)) {
                let (side, said) = (side_of(hand), resolve(phase, hand));
                // A hand that is half a cycle behind is not at its keys when the other one is.
                let behind = said.movement.iter().any(|m| m.any_action(&|action| said.turns.behind(action)));
                let Some(measured) = self.annotation.hand(side).filter(|_| !behind) else { continue };
                let part = Part { phase, hand, side, said, keys: keys.clone(), measured };
                self.part(&part, &mut all);
            }
        }
        all
    }

    /// What each hand does in the middle of the strokes and transitions that the track has.
    fn phases(&self) -> Vec<Judgement> {
        let mut all = Vec::new();
        for hand in &self.annotation.hands {
            let name = if hand.side == Side::Right { "RH Phase" } else { "LH Phase" };
            for phase in self.performance.track.phases(name) {
                if !["stroke", "transition"].contains(&phase.name.as_str()) {
                    continue;
                }
                let found = at(&hand.phases, Seconds((phase.start.0 + phase.end.0) / 2.0));
                let measured = found.map_or("nothing", |v| v.value.name()).to_owned();
                let right = measured == phase.name;
                let judged = Judged::Phase;
                let loose = right || phase.name == "stroke" && measured == "hold";
                all.push(Judgement { judged, described: phase.name, measured, strict: right, loose, excepted: false });
            }
        }
        all
    }

    fn part(&self, part: &Part, all: &mut Vec<Judgement>) {
        for key in 0..part.keys.len() {
            all.extend(self.configuration(part, key));
            all.extend(self.orientation(part, key));
            all.extend(self.placement(part, key));
        }
        for interval in 0..part.keys.len() - 1 {
            all.extend(self.movement(part, interval));
        }
    }

    /// Whether the synthesis reports, or its check finds, that a hand is not as it should be at a key.
    pub(super) fn excepted(&self, part: &Part, key: usize) -> bool {
        let near = |time: Seconds| (time.0 - part.keys[key].0).abs() < ABOUT_S;
        self.findings.iter().any(|f| near(f.time) && f.side.is_none_or(|side| side == part.side))
    }

    /// The body at a key.
    pub(super) fn body(&self, part: &Part, key: usize) -> ModelPose {
        let clip = &self.performance.track.clip;
        clip.sample(part.keys[key]).pose.to_model(clip.skeleton())
    }

    /// The configuration that a hand should have at a key: as stated, or as an earlier interval has changed it.
    pub(super) fn described_shape(&self, part: &Part, key: usize) -> Option<Configuration> {
        for key in (0..=key).rev() {
            if let Some(stated) = part.said.configuration.stated(key) {
                return Some(stated.clone());
            }
            let before = key.checked_sub(1).and_then(|interval| part.said.movement.get(interval));
            if let Some(became) = before.and_then(last_shape) {
                return Some(became);
            }
        }
        part.said.configuration.at(key).cloned()
    }

    fn configuration(&self, part: &Part, key: usize) -> Option<Judgement> {
        let described = self.described_shape(part, key)?;
        let language = (!part.phase.language.is_empty()).then_some(part.phase.language.as_str());
        let angles = self.grammar.handshapes.angles(&described, language).ok()?;
        let form = HandForm::of_angles(self.signer, &angles);
        let forms = self.annotator.forms();
        let nearest = forms.nearest(&form)?;
        let found = at(&part.measured.configuration, part.keys[key]);
        let number = found.map(|v| v.value.number);
        // What lies halfway between two rows is as near to both.
        let strict = number.is_some_and(|n| {
            let own = &forms.shapes()[n].form;
            forms.are_same(n, nearest.shape) || own.is_same(&form) || own.distance(&form) < nearest.distance + AS_NEAR_M
        });
        Some(Judgement {
            judged: Judged::Configuration,
            described: label::configuration(&described),
            measured: found.map_or("nothing".into(), |v| v.value.id.clone()),
            strict,
            loose: strict || number.is_some_and(|n| forms.shapes()[n].form.tips_apart(&form) < 0.015),
            excepted: self.excepted(part, key),
        })
    }

    fn orientation(&self, part: &Part, key: usize) -> Vec<Judgement> {
        let Some(said) = part.said.orientation.stated(key).filter(|said| !said.along_path || key == 0) else {
            return Vec::new();
        };
        let points =
            part.said.placement.at(key).is_some_and(|p| matches!(p.place, crate::phonology::Place::Towards(_)));
        if points || part.phase.relocated.is_some() {
            return Vec::new();
        }
        let found = at(&part.measured.orientation, part.keys[key]);
        let excepted = self.excepted(part, key);
        let judgement = |judged, said: String, got: String, (strict, loose)| Judgement {
            judged,
            described: said,
            measured: got,
            strict,
            loose,
            excepted,
        };
        let heading = |h: Option<Heading>| h.map_or("nothing".to_owned(), |h| h.to_string());
        let got = found.map(|v| v.value).unwrap_or_default();
        let mut all = Vec::new();
        if let Some(fingers) = said.fingers {
            let right = close(got.fingers, fingers.vector());
            all.push(judgement(Judged::Fingers, fingers.to_string(), heading(got.fingers), right));
        }
        if let Some(across) = across(said) {
            let right = close(got.palm, across);
            let told = said.palm.map_or(String::new(), |p| p.to_string());
            all.push(judgement(Judged::Palm, told, heading(got.palm), right));
        }
        if !all.is_empty() {
            let both = (all.iter().all(|j| j.strict), all.iter().all(|j| j.loose));
            let told = label::orientation(said);
            all.push(judgement(Judged::Orientation, told, label::orientation(&got), both));
        }
        all
    }
}

/// Where the palm looks that is said, across the fingers that are said; as said where the fingers are not. `None` where it says nothing.
fn across(said: &Orientation) -> Option<DVec3> {
    let palm = said.palm?.vector();
    let Some(fingers) = said.fingers.map(Heading::vector) else { return Some(palm) };
    let across = palm - fingers * palm.dot(fingers);
    (across.length() > ALONG).then(|| across.normalize())
}

/// Whether a measured heading is the cell of a direction, and whether it is near to it.
fn close(got: Option<Heading>, said: DVec3) -> (bool, bool) {
    let Some(got) = got.map(Heading::vector) else { return (false, false) };
    // A direction between two cells is each of them.
    let nearest = crate::phonology::Direction::all().map(|d| d.vector().dot(said)).fold(-1.0, f64::max);
    let strict = got.dot(said) > nearest - 1e-6
        || got.dot(said).clamp(-1.0, 1.0).acos() < nearest.clamp(-1.0, 1.0).acos() + 0.02;
    (strict, strict || got.angle_between(said) < LOOSE)
}

/// The last configuration that a movement comes to.
fn last_shape(movement: &Movement) -> Option<Configuration> {
    match movement {
        Movement::Action(action) if action.repetition.is_none() => action.becoming.as_ref()?.configuration.clone(),
        Movement::Sequence(parts) | Movement::Together(parts) | Movement::Fused(parts) => {
            parts.iter().rev().find_map(last_shape)
        }
        Movement::Action(_) | Movement::Repeated(_) | Movement::Backwards(_) => None,
    }
}

/// The value that holds at an instant: the one in which it lies, else the nearest within a fifth of a second.
pub(super) fn at<T>(values: &[Value<T>], time: Seconds) -> Option<&Value<T>> {
    let away = |v: &&Value<T>| (v.start.0 - time.0).max(time.0 - v.end.0).max(0.0);
    values.iter().min_by(|a, b| away(a).total_cmp(&away(b))).filter(|v| away(v) < 0.2)
}
