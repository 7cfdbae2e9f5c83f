//! Movement: what is described of an interval held against what was measured in it.

use super::expected::{Primitive, primitives};
use super::key::Part;
use super::{Judge, Judged, Judgement};
use crate::corpus::annotate::Value;
use crate::phonology::{Movement, label};
use glam::DVec3;

/// The cosine of the greatest angle between a described direction and the measured one: 45°, and half a degree for rounding.
const SAME: f64 = 0.7;
/// A way that is shorter need not be seen, metres.
const LEAST_M: f64 = 0.025;

impl Judge<'_> {
    pub(super) fn movement(&self, part: &Part, interval: usize) -> Vec<Judgement> {
        let Some(said) = part.said.movement.get(interval) else { return Vec::new() };
        let table = &self.grammar.movements;
        let described = primitives(said, part.said.signs, table);
        let (from, to) = (part.keys[interval].0, part.keys[interval + 1].0);
        let inside: Vec<&Value<Movement>> =
            part.measured.movement.iter().filter(|v| shared(v, from, to) > 0.5).collect();
        let moves = part.measured.moves.iter().filter(|v| shared(v, from, to) > 0.5);
        let measured: Vec<(Primitive, u8)> =
            moves.flat_map(|v| unfolded(&v.value)).flat_map(|m| primitives(&m, DVec3::ONE, table)).collect();
        let led = self.led(part, interval);
        let alike = |kind_only: bool| in_order(&described, &measured, led, kind_only);
        let (strict, loose) = (alike(false), alike(true));
        let told =
            |m: &[&Value<Movement>]| m.iter().map(|v| label::movement(&v.value)).collect::<Vec<_>>().join(", then ");
        let measured_label = if inside.is_empty() { "nothing".to_owned() } else { told(&inside) };
        let excepted = self.excepted(part, interval) || self.excepted(part, interval + 1);
        let judgement = |judged, described: String, measured: String, strict, loose| Judgement {
            judged,
            described,
            measured,
            strict,
            loose,
            excepted,
        };
        let mut all =
            vec![judgement(Judged::Movement, label::movement(said), measured_label.clone(), strict, loose || strict)];
        // How often is asked of what was recognised.
        let times = |all: &[(Primitive, u8)]| all.iter().map(|(_, n)| *n).max().unwrap_or(1);
        if strict && !measured.is_empty() && described.iter().any(|(p, n)| *n > 1 && p.is_way()) {
            let joined: Vec<_> = inside.iter().flat_map(|v| primitives(&v.value, DVec3::ONE, table)).collect();
            let same = times(&described) == times(&joined);
            all.push(judgement(Judged::Repetition, label::movement(said), measured_label, same, same));
        }
        all
    }

    /// From the described place at an interval's start to that at its end, where both are described.
    fn led(&self, part: &Part, interval: usize) -> Option<DVec3> {
        let body = self.body(part, interval);
        let a = self.described_place(part, interval, &body)?;
        let b = self.described_place(part, interval + 1, &body)?;
        Some(b.at - a.at)
    }
}

/// The part of a measured value that lies within an interval, or of the interval that the value covers: the larger.
fn shared(v: &Value<Movement>, from: f64, to: f64) -> f64 {
    let common = v.end.0.min(to) - v.start.0.max(from);
    common / (v.end.0 - v.start.0).min(to - from).max(1e-9)
}

/// A way with a play meanwhile as both, one after the other, so that each is found.
fn unfolded(movement: &Movement) -> Vec<Movement> {
    match movement {
        Movement::Together(parts) => parts.clone(),
        other => vec![other.clone()],
    }
}

/// Whether each described primitive is among the measured ones, in order.
fn in_order(described: &[(Primitive, u8)], measured: &[(Primitive, u8)], led: Option<DVec3>, kind_only: bool) -> bool {
    let mut at = 0;
    described.iter().all(|(wanted, _)| {
        if may_be_unseen(wanted, led) && measured.get(at..).is_none_or(|rest| rest.iter().all(|(m, _)| !m.is_way())) {
            return true;
        }
        let alone = described.len() == 1;
        let found = measured[at..].iter().position(|(got, _)| matches(wanted, got, led.filter(|_| alone), kind_only));
        match found {
            Some(n) => {
                at += n + 1;
                true
            }
            None => false,
        }
    })
}

/// Whether nothing need be seen of it: a change or a hold, and a way to where the hand is already.
fn may_be_unseen(wanted: &Primitive, led: Option<DVec3>) -> bool {
    match wanted {
        Primitive::Hold | Primitive::Change => led.is_none_or(|way| way.length() < LEAST_M),
        Primitive::Led => led.is_some_and(|way| way.length() < LEAST_M),
        _ => false,
    }
}

fn matches(wanted: &Primitive, got: &Primitive, led: Option<DVec3>, kind_only: bool) -> bool {
    let same = |a: DVec3, b: DVec3| kind_only || a.length() < 1e-6 || a.dot(b) >= SAME * a.length() * b.length();
    let led_along = |b: DVec3| led.is_some_and(|way| way.length() > LEAST_M && same(way, b));
    match (*wanted, *got) {
        (Primitive::Straight { along, waves }, Primitive::Straight { along: b, waves: w }) => {
            waves == w && (same(along, b) || led_along(b))
        }
        (Primitive::Arc { along }, Primitive::Arc { along: b }) => same(along, b) || led_along(b),
        (Primitive::Circle { axis, .. }, Primitive::Circle { axis: b, .. }) => same(axis, b),
        // Less than three quarters of a circle is an arc as well.
        (Primitive::Circle { turns, .. }, Primitive::Arc { .. }) => turns < 0.76,
        (Primitive::Any { along }, Primitive::Straight { along: b, .. } | Primitive::Arc { along: b }) => {
            same(along, b)
        }
        (Primitive::Any { .. }, Primitive::Circle { .. }) => true,
        (Primitive::Led, Primitive::Straight { along: b, .. } | Primitive::Arc { along: b }) => {
            led.is_none_or(|way| way.length() < LEAST_M || same(way, b))
        }
        (Primitive::Hold | Primitive::Change, Primitive::Straight { along: b, .. } | Primitive::Arc { along: b }) => {
            led.is_some_and(|way| same(way, b))
        }
        (Primitive::Hold | Primitive::Change, Primitive::Hold | Primitive::Change) => true,
        (Primitive::Wrist(a), Primitive::Wrist(b)) => kind_only || a == b,
        (Primitive::Wiggle, Primitive::Wiggle) => true,
        _ => false,
    }
}
