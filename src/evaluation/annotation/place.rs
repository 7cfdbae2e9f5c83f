//! Placement: the described place held against the measured one.

use super::key::{Part, at};
use super::{Judge, Judged, Judgement};
use crate::corpus::annotate::Placed;
use crate::motion::pose::ModelPose;
use crate::phonology::operator::touches;
use crate::phonology::symmetry::points;
use crate::phonology::{Distance, HandPoint, Hands, Lateral, Movement, Place, Placement, Side, label};
use crate::synthesis::plan::{Known, Planner};
use glam::DVec3;

/// The loose sense: so near, metres, or half of half the region's width.
const NEAR_M: f64 = 0.05;

/// Names are of one place that are so near, metres.
const SAME_M: f64 = 0.015;

/// A hand farther from the other one than this is in space, metres.
const HANDS_NEAR_M: f64 = 0.06;

/// A described place, made concrete.
pub(super) struct Sited {
    pub placement: Placement,
    /// Where it is, model space, metres.
    pub at: DVec3,
    /// The point of the hand that is there.
    pub with: HandPoint,
}

/// Places by name with their sides, and whether beside them.
type Sites = Vec<(String, Option<(Side, bool)>)>;

impl Judge<'_> {
    pub(super) fn placement(&self, part: &Part, key: usize) -> Option<Judgement> {
        let body = self.body(part, key);
        let described = self.described_place(part, key, &body)?;
        let found = at(&part.measured.placement, part.keys[key]);
        let names = self.names(part, &described, &body);
        let landmarks = &self.signer.landmarks;
        let said = |v: &Placed| [Some(v.placement.clone()), on_other(v)];
        let strict = found.is_some_and(|v| {
            let said = said(&v.value);
            names.iter().any(|name| said.iter().flatten().any(|said| self.same(part, name, said)))
        });
        let near = found.and_then(|v| {
            let other = on_other(&v.value).filter(|_| matches!(described.placement.place, Place::OtherHand(_)));
            let placed = Placed { placement: other.unwrap_or(v.value.placement.clone()), ..v.value.clone() };
            let point = |p: HandPoint| landmarks.hand_point(part.side, p).ok().map(|c| c.position(&body));
            let place = self.annotator.placer().point_of(&placed, part.side, &body)?;
            Some((place + point(described.with)? - point(v.value.with)?).distance(described.at))
        });
        // Several names may mean one place: halfway from the middle to beside a side is at that side.
        let strict = strict || near.is_some_and(|near| near < SAME_M);
        let wide = match &described.placement.place {
            Place::Body(name) => self.grammar.locations.get(name).map_or(0.0, |row| row.half_width_arms),
            _ => 0.0,
        };
        let tolerance = NEAR_M.max(0.5 * wide * landmarks.arm_length());
        Some(Judgement {
            judged: Judged::Placement,
            described: label::placement(&described.placement),
            measured: found.map_or("nothing".into(), |v| {
                let [place, other] = said(&v.value).map(|p| p.map_or(String::new(), |p| label::placement(&p)));
                if other.is_empty() { place } else { format!("{place} / {other}") }
            }),
            strict,
            loose: strict || near.is_some_and(|near| near < tolerance),
            excepted: self.excepted(part, key),
        })
    }

    /// The place of a hand at a key, as stated there or as the movement before leads there.
    pub(super) fn described_place(&self, part: &Part, key: usize, body: &ModelPose) -> Option<Sited> {
        if part.phase.relocated.is_some() {
            return None;
        }
        let led = || key.checked_sub(1).and_then(|i| part.said.movement.get(i)).and_then(Movement::leads_to);
        let placement = part.said.placement.stated(key).or_else(led)?.clone();
        if matches!(placement.place, Place::Referent(_) | Place::Towards(_)) {
            return None;
        }
        let planner = Planner { grammar: self.grammar, signer: self.signer, neutral: body };
        let meets = part.phase.contact.stated(key).is_some();
        let anchor = planner.place_of_hand(&placement, (part.phase, part.side), meets, &mut Known::default()).ok()?;
        let own = part.phase.contact.stated(key).and_then(|contact| points(contact, part.hand).0);
        let with = match placement.with.or(own) {
            Some(point) => point,
            None if meets => self.shape_touches_with(part, key)?,
            None if touches(&placement, &self.grammar.locations) => self.shape_touches_with(part, key)?,
            None => HandPoint::PALM,
        };
        Some(Sited { at: anchor.position(body), placement, with })
    }

    fn shape_touches_with(&self, part: &Part, key: usize) -> Option<HandPoint> {
        let shape = self.described_shape(part, key)?;
        let language = (!part.phase.language.is_empty()).then_some(part.phase.language.as_str());
        self.grammar.handshapes.touches_with(&shape, language).ok()
    }

    /// The names of a described place: itself, or the nearest name where it is said in numbers.
    fn names(&self, part: &Part, described: &Sited, body: &ModelPose) -> Vec<Placement> {
        let p = &described.placement;
        let numbers = p.offset.is_some()
            || p.behind
            || matches!(p.distance, Distance::Metres(_) | Distance::Neutral)
            || matches!(p.place, Place::Point(_));
        let on_hand =
            matches!(p.place, Place::OtherHand(_)) && matches!(p.distance, Distance::Metres(m) if m < HANDS_NEAR_M);
        if !numbers || on_hand && p.offset.is_none() {
            return vec![p.clone()];
        }
        let point = |point| self.signer.landmarks.hand_point(part.side, point).map(|c| c.position(body));
        let (Ok(palm), Ok(with)) = (point(HandPoint::PALM), point(described.with)) else { return Vec::new() };
        let palm = described.at + palm - with;
        let named = self.annotator.placer().name(part.side, (described.with, described.at), palm, body);
        named.map(|(placed, _)| placed.placement).into_iter().collect()
    }

    /// Whether a measured placement is a described one: the same place on the same side, the distance one step off at most.
    fn same(&self, part: &Part, described: &Placement, measured: &Placement) -> bool {
        if let (Place::OtherHand(a), Place::OtherHand(b)) = (&described.place, &measured.place) {
            // Parts of a hand lie on each other: which of them is the nearest point's matter, not the place's.
            return a == b || self.apart(part, *a, *b) < 0.03;
        }
        let names = self.sites(part, measured);
        let steps = (self.step(described), self.step(measured));
        names.is_some() && names == self.sites(part, described) && (steps.0 - steps.1).abs() <= 1
    }

    /// How far two points of the other hand are apart at rest, metres.
    fn apart(&self, part: &Part, a: HandPoint, b: HandPoint) -> f64 {
        let rest = crate::motion::pose::LocalPose::rest(&self.signer.skeleton).to_model(&self.signer.skeleton);
        let at = |p| self.signer.landmarks.hand_point(part.side.other(), p).map(|c| c.position(&rest));
        match (at(a), at(b)) {
            (Ok(a), Ok(b)) => a.distance(b),
            _ => f64::INFINITY,
        }
    }

    /// A place as names with sides, two where it lies between two.
    fn sites(&self, part: &Part, p: &Placement) -> Option<Sites> {
        let named = |place: &Place, lateral: Option<Lateral>| match place {
            Place::Body(name) => {
                let row = self.grammar.locations.get(name)?;
                Some((row.id.clone(), self.side_of_place(part, p, row.paired || row.id == "neutral", lateral)))
            }
            Place::Space(cell) => Some((format!("{cell:?}"), None)),
            _ => None,
        };
        let mut sites = match &p.place {
            Place::Between(a, b) => {
                vec![named(&a.place, a.lateral.or(p.lateral))?, named(&b.place, b.lateral.or(p.lateral))?]
            }
            place => vec![named(place, p.lateral)?],
        };
        // The middle of the chest and the right shoulder is that of the right chest and the shoulders.
        let mut sides: Vec<_> = sites.iter().map(|(_, side)| *side).collect();
        sites.sort_by(|a, b| a.0.cmp(&b.0));
        sides.sort_by_key(|side| side.map(|(s, beside)| (s == Side::Left, beside)));
        let sites = sites.into_iter().zip(sides).map(|((name, _), side)| (name, side)).collect();
        Some(sites)
    }

    /// The side that a place has: as said; where it is not, the hand's own of what comes in two, and of two hands that are apart.
    fn side_of_place(&self, part: &Part, p: &Placement, own: bool, lateral: Option<Lateral>) -> Option<(Side, bool)> {
        let both = matches!(part.phase.hands, Hands::Both(_));
        let between = matches!(p.place, Place::Between(..));
        match lateral {
            Some(l) => Some((l.side, l.beside)),
            None if own || both && !between => Some((part.side, false)),
            None => None,
        }
    }

    /// How far from the body a placement is: 0 touch, 1 close, 2 at ease, 3 extended.
    fn step(&self, p: &Placement) -> i8 {
        match p.distance {
            Distance::Touch => 0,
            Distance::Close => 1,
            Distance::Neutral => 2,
            Distance::Extended => 3,
            Distance::Unmarked if touches(p, &self.grammar.locations) => 0,
            Distance::Unmarked => 2,
            Distance::Metres(m) => {
                if m < 0.03 {
                    0
                } else if m < 0.12 {
                    1
                } else {
                    2
                }
            }
        }
    }
}

/// The place on the other hand, wherever the hands are.
fn on_other(placed: &Placed) -> Option<Placement> {
    let met = placed.meeting?;
    Some(Placement { distance: met.distance, ..Placement::at(Place::OtherHand(met.other)) })
}
