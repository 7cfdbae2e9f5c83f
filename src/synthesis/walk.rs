//! The walk of a hand from key to key: legs with their ends, the points of the hand that are placed, and the postures.

use super::anchor::Anchor;
use super::leg::{Leg, LegEnd, Stand, Stop};
use super::legs::{change, lay_out};
use super::path::Path;
use super::placed::{going_back, way_of};
use super::plan::{Change, HandPlan, KeyPosture, Known, PlacedLeg, Planner, Riding};
use super::posture::{Part, Said, Site, Touching};
use super::side_of;
use super::site::{Asker, Meeting};
use crate::body::landmarks::ContactPoint;
use crate::diagnostics::Error;
use crate::phonology::{Configuration, Orientation, Placement, Side};
use glam::{DQuat, DVec3};
use std::sync::Arc;

/// A hand on its way through a sign.
#[derive(Debug, Clone)]
pub(super) struct Walk<'s> {
    pub part: Part<'s>,
    pub side: Side,
    /// The legs of every interval, reflected where the hand follows the other one.
    pub intervals: Vec<Vec<Leg>>,
    pub sites: Vec<Site>,
    pub start: Anchor,
    /// Whether the start follows from a later place.
    derived: bool,
    /// Where the hand is at each key that it has come to.
    been: Vec<Anchor>,
    pub at: Anchor,
    pub legs: Vec<PlacedLeg>,
    points: Vec<ContactPoint>,
    /// The point that is placed now, and whether the description names it.
    with: usize,
    named: bool,
}

/// The start is as near as this to a place that a path brushes: the path begins before it, metres.
const BEGINS_THERE_M: f64 = 0.03;
/// How far a hand bounces back at least and at most, metres.
const REBOUND_M: (f64, f64) = (0.012, 0.04);

impl Walk<'_> {
    /// In which intervals the hand changes its place.
    pub fn moving(&self) -> Vec<bool> {
        let moves = |leg: &PlacedLeg| leg.leg.path.length(8) > 1e-3 || leg.from != leg.to;
        let count = self.intervals.len();
        (0..count).map(|i| self.legs.iter().any(|leg| leg.interval == i && moves(leg))).collect()
    }

    fn point(&mut self, point: ContactPoint) -> usize {
        self.points.iter().position(|p| *p == point).unwrap_or_else(|| {
            self.points.push(point);
            self.points.len() - 1
        })
    }

    /// Sets where the hand is at its start, as a contact says it.
    pub fn starts_at(&mut self, anchor: Anchor) {
        self.start = anchor.clone();
        self.at = anchor.clone();
        self.been = vec![anchor];
    }

    /// Sets the point that is placed from the first key on.
    pub fn starts_with(&mut self, point: ContactPoint) {
        self.points.clear();
        self.with = self.point(point);
        self.named = true;
    }
}

impl Planner<'_> {
    /// A hand at the first key, its later places looked up.
    pub(super) fn walk<'s>(&self, part: Part<'s>, known: &mut Known) -> Result<Walk<'s>, Error> {
        let Part { sign, hand, said, .. } = part;
        let side = side_of(hand);
        let mut sites = Vec::with_capacity(sign.intervals + 1);
        for key in 0..=sign.intervals {
            let site = self.site(part, key, known).and_then(|site| self.met(part, key, site, known));
            sites.push(site.map_err(|e| e.context(format_args!("key {}", key + 1)))?);
        }
        let table = &self.grammar.movements;
        let intervals: Vec<Vec<Leg>> = (0..sign.intervals)
            .map(|interval| match said.movement.get(interval) {
                Some(movement) => {
                    lay_out(movement, table, said.turns).into_iter().map(|leg| leg.reflected(said.signs)).collect()
                }
                None => vec![change(table.timing.change)],
            })
            .collect();
        let derived = going_back(&intervals, &sites, 0);
        if sites[0].with.is_none() && derived.is_some() {
            // Going back from a place that is said later, the hand goes with the same point.
            if let Some(later) = sites.iter().find(|s| s.with.is_some()).cloned() {
                (sites[0].with, sites[0].named) = (later.with, later.named);
            }
        }
        let start = match derived.clone() {
            Some(start) => start,
            None => self.default_place(Asker::of(part, Meeting::Apart), known)?,
        };
        let first = match &sites[0].with {
            Some(point) => point.clone(),
            None => self.own_point(&part.configuration(0), sign, side, Touching::Nothing)?,
        };
        Ok(Walk {
            part,
            side,
            intervals,
            named: sites[0].named,
            sites,
            start: start.clone(),
            derived: derived.is_some(),
            been: vec![start.clone()],
            at: start,
            legs: Vec::new(),
            points: vec![first],
            with: 0,
        })
    }

    /// Moves the starts that follow from a later place on the other hand: where that one moves as well, this one begins so
    /// that it comes there on its own way.
    pub(super) fn begin_apart(&self, walks: &mut [Walk]) {
        if walks.len() != 2 {
            return;
        }
        for n in 0..2 {
            let own = &walks[n];
            let rides = own.start.rides_on(self.signer.arm(own.side.other()).clavicle, &self.signer.skeleton);
            let later = own.sites.iter().position(|site| site.anchor.is_some()).filter(|key| rides && *key > 0);
            let Some(key) = later else { continue };
            let way: Option<DVec3> = walks[1 - n].intervals[..key].iter().map(|legs| way_of(legs)).sum();
            let start = own.start.clone().moved(way.unwrap_or_default());
            walks[n].starts_at(start);
        }
    }

    /// Takes the hands through an interval, to where they meet at its end if they do.
    pub(super) fn step(&self, walks: &mut [Walk], interval: usize, known: &mut Known) -> Result<(), Error> {
        let meets = walks.first().is_some_and(|w| w.part.sign.contact.stated(interval + 1).is_some());
        if meets {
            let before = walks.to_vec();
            for walk in walks.iter_mut() {
                self.interval(walk, interval, &mut known.clone())?;
            }
            let reached: Vec<Anchor> = walks.iter().map(|walk| walk.at.clone()).collect();
            for ((walk, was), reached) in walks.iter_mut().zip(before).zip(reached) {
                *walk = was;
                walk.at = reached;
            }
            let at: Vec<Anchor> = walks.iter().map(|walk| walk.been.last().unwrap_or(&walk.start).clone()).collect();
            self.meet(walks, interval + 1, known)?;
            walks.iter_mut().zip(at).for_each(|(walk, at)| walk.at = at);
        }
        for walk in walks.iter_mut() {
            self.interval(walk, interval, known)?;
        }
        Ok(())
    }

    fn interval(&self, walk: &mut Walk, interval: usize, known: &mut Known) -> Result<(), Error> {
        let legs = walk.intervals[interval].clone();
        let first = walk.legs.len();
        // To and fro, with only a later place said: the hand began there too, so its way out does not lead there.
        let unsaid = walk.derived && walk.sites[..=interval].iter().all(|site| site.anchor.is_none());
        let returns = unsaid && way_of(&legs) == Some(DVec3::ZERO);
        let count = legs.len();
        let own = self.points_of(walk, &legs, interval)?;
        for (n, (leg, with)) in legs.into_iter().zip(own).enumerate() {
            let mut leg = leg;
            let from = walk.at.clone();
            let arrives = leg.posture.share.1 >= 1.0 && matches!(leg.posture.to, Stand::After(_)) || n + 1 == count;
            let site = &walk.sites[interval + 1];
            let stated = site.anchor.as_ref().filter(|_| arrives && !returns).cloned();
            if let LegEnd::Rebound(part) = leg.end {
                leg.path = self.rebound(walk.legs.last(), part);
            }
            let displaced = || from.clone().moved(leg.path.end());
            let (end, by) = match &leg.end {
                LegEnd::Off(end, by) => (&**end, *by),
                end => (end, DVec3::ZERO),
            };
            let to = match (end, stated) {
                (LegEnd::At(_) | LegEnd::Displaced | LegEnd::NextKey, Some(anchor))
                    if site.meeting == Meeting::Meets =>
                {
                    anchor
                }
                (LegEnd::At(placement), _) => self.anchor(placement, Asker::of(walk.part, Meeting::Apart), known)?,
                (LegEnd::Meeting(contact), _) => self.meeting_end(walk, contact, displaced(), interval + 1)?,
                (LegEnd::StartOf(n), _) => walk.legs.get(first + n).map_or_else(displaced, |l| l.from.clone()),
                (LegEnd::AtKey(key), _) => walk.been.get(*key).cloned().unwrap_or_else(displaced),
                (LegEnd::Displaced, Some(anchor)) => anchor,
                (LegEnd::NextKey, _) => {
                    going_back(&walk.intervals, &walk.sites, interval + 1).unwrap_or_else(displaced)
                }
                (LegEnd::Rebound(_), _) => from.clone(),
                (LegEnd::Displaced | LegEnd::Off(..), _) => displaced(),
            };
            let mut to = to.moved(by);
            let mut from = from;
            let brush = match leg.brushing.clone() {
                None => None,
                Some(placement) => Some(self.brush(walk, &leg, &placement, (&mut from, &mut to), interval, known)?),
            };
            if let Some(name) = &leg.names {
                known.referents.insert(name.clone(), to.clone());
            }
            walk.at = to.clone();
            let posture = Change::none(0);
            walk.legs.push(PlacedLeg { leg, interval, from, to, posture, via: None, with, brush, hold: Riding::Rides });
        }
        walk.been.push(walk.at.clone());
        Ok(())
    }

    /// Which points of the hand the legs of an interval place.
    fn points_of(&self, walk: &mut Walk, legs: &[Leg], interval: usize) -> Result<Vec<Change>, Error> {
        let mut own = Vec::with_capacity(legs.len());
        let (part, key) = (walk.part, interval + 1);
        let mut targets = false;
        for leg in legs {
            let point = match &leg.end {
                LegEnd::At(placement) => self.point_at(walk, placement, key)?,
                LegEnd::Meeting(contact) => Some(self.meeting_point(part, contact, key)?),
                LegEnd::Displaced
                | LegEnd::Rebound(_)
                | LegEnd::StartOf(_)
                | LegEnd::AtKey(_)
                | LegEnd::NextKey
                | LegEnd::Off(..) => None,
            };
            let from = walk.with;
            match point {
                Some(point) => {
                    walk.with = walk.point(point);
                    walk.named = true;
                    targets |= walk.with != from;
                    own.push(Change { from, to: walk.with, share: (0.0, 1.0) });
                }
                None => own.push(Change::none(from)),
            }
        }
        let site = &walk.sites[key];
        let Some(point) = site.with.clone() else { return Ok(own) };
        let named = site.named;
        let from = own.first().map_or(walk.with, |c| c.from);
        let to = walk.point(point);
        let evenly =
            legs.iter().all(|leg| matches!((&leg.posture.from, &leg.posture.to), (Stand::Before, Stand::After(None))));
        if !targets && evenly {
            let all = legs.iter().map(|leg| Change { from, to, share: leg.posture.share });
            own = all.collect();
        } else if let Some(last) = own.last_mut().filter(|last| last.to != to) {
            *last = Change { from: last.from, to, share: (0.0, 1.0) };
        }
        (walk.with, walk.named) = (to, named);
        Ok(own)
    }

    /// The point with which a hand comes to a place that a movement leads to: the one that is said; where it touches,
    /// what its shape touches with, unless another one was named before.
    fn point_at(&self, walk: &Walk, placement: &Placement, key: usize) -> Result<Option<ContactPoint>, Error> {
        if let Some(point) = placement.with {
            return self.signer.landmarks.hand_point(walk.side, point).map(Some);
        }
        if walk.named || !self.touches(placement) {
            return Ok(None);
        }
        self.own_point(&walk.part.configuration(key), walk.part.sign, walk.side, Touching::Skin).map(Some)
    }

    /// Back a little from where the last leg led.
    fn rebound(&self, last: Option<&PlacedLeg>, part: f64) -> Path {
        let Some(last) = last else { return Path::Still };
        let way = last.from.position(self.neutral) - last.to.position(self.neutral);
        let back = match way.length() > 5e-3 {
            true => way,
            false => last.leg.path.at(0.85) - last.leg.path.end(),
        };
        let Some(along) = back.try_normalize() else { return Path::Still };
        let by = along * (back.length() * part).clamp(REBOUND_M.0, REBOUND_M.1);
        Path::Chain(vec![(1.0, Path::Straight(by)), (1.0, Path::Straight(-by))])
    }

    /// A place touched half way. Where a sign's first path begins at the place that it brushes, it begins before it.
    fn brush(
        &self,
        walk: &mut Walk,
        leg: &Leg,
        placement: &Placement,
        ends: (&mut Anchor, &mut Anchor),
        interval: usize,
        known: &mut Known,
    ) -> Result<(Anchor, usize), Error> {
        let anchor = self.anchor(placement, Asker::of(walk.part, Meeting::Meets), known)?;
        let point = match placement.with {
            Some(point) => Some(self.signer.landmarks.hand_point(walk.side, point)?),
            None if walk.named => None,
            None => {
                let shape = walk.part.configuration(interval + 1);
                Some(self.own_point(&shape, walk.part.sign, walk.side, Touching::Skin)?)
            }
        };
        let with = point.map_or(walk.with, |point| walk.point(point));
        let (from, to) = ends;
        let begins_there = anchor.position(self.neutral).distance(from.position(self.neutral)) < BEGINS_THERE_M;
        if begins_there && leg.end == LegEnd::Displaced {
            let before = -leg.path.at(0.5);
            *from = from.clone().moved(before);
            *to = to.clone().moved(before);
            if walk.legs.is_empty() {
                walk.starts_at(from.clone());
            } else if let Some(last) = walk.legs.last_mut() {
                last.to = from.clone();
            }
        }
        Ok((anchor, with))
    }

    /// Legs of a hand on the other one, away from it while that one moves as well: they go their own way.
    pub(super) fn let_go(&self, walk: &mut Walk, other_moves: &[bool]) {
        let other = self.signer.arm(walk.side.other()).clavicle;
        for leg in &mut walk.legs {
            let moves = leg.leg.path.length(8) > 1e-3 && leg.leg.end == LegEnd::Displaced;
            let both = moves && other_moves.get(leg.interval).copied().unwrap_or(false);
            if both && leg.from.rides_on(other, &self.signer.skeleton) {
                leg.hold = Riding::LetsGo;
            }
        }
    }

    /// The postures of a hand that has come through all its legs.
    pub(super) fn postures(&self, mut walk: Walk) -> Result<HandPlan, Error> {
        let mut all = Postures { planner: self, walk: &walk, list: Vec::new(), vias: Vec::new() };
        let mut carried = Carried::default();
        let first = walk.points.get(walk.legs.first().map_or(walk.with, |l| l.with.from));
        let mut key = all.key(0, None, &mut carried, first)?;
        let mut changes = Vec::with_capacity(walk.legs.len());
        for interval in 0..walk.intervals.len() {
            let mut stands = Stands { interval, key, carried: carried.clone(), stops: Vec::new(), after: None };
            for leg in walk.legs.iter().filter(|leg| leg.interval == interval) {
                let turn = &leg.leg.posture;
                let from = all.stand(&turn.from, &mut stands, leg)?;
                let to = all.stand(&turn.to, &mut stands, leg)?;
                changes.push(Change { from, to, share: turn.share });
                if stands.after.is_none() {
                    key = if turn.share.1 >= 0.5 { to } else { from };
                    carried = stands.carried.after(turn.end());
                }
            }
            if let Some((at, become_)) = stands.after {
                (key, carried) = (at, become_);
            }
        }
        let (list, vias) = (all.list, all.vias);
        for (leg, posture) in walk.legs.iter_mut().zip(changes) {
            leg.posture = posture;
            let pair = (posture.from.min(posture.to), posture.from.max(posture.to));
            leg.via = vias.iter().find(|(of, _)| *of == pair).and_then(|(_, via)| *via);
        }
        Ok(self.finished(walk, list))
    }

    fn finished(&self, walk: Walk, postures: Vec<KeyPosture>) -> HandPlan {
        let Walk { part, side, .. } = walk;
        let other = self.signer.arm(side.other()).clavicle;
        let rides = |anchor: &Anchor| anchor.rides_on(other, &self.signer.skeleton);
        let on_other_hand = rides(&walk.start)
            || walk
                .legs
                .iter()
                .any(|l| rides(&l.from) || rides(&l.to) || l.brush.as_ref().is_some_and(|b| rides(&b.0)));
        // A hand that touches the body comes from outside; elsewhere it may follow the forearm.
        let on_skin = part.said.placement.iter().any(|(_, p)| self.outward(p, side).is_some());
        let reaches_skin = |leg: &PlacedLeg| match &leg.leg.end {
            LegEnd::At(placement) => self.touches(placement),
            LegEnd::Meeting(_) => true,
            LegEnd::Displaced
            | LegEnd::Rebound(_)
            | LegEnd::StartOf(_)
            | LegEnd::AtKey(_)
            | LegEnd::NextKey
            | LegEnd::Off(..) => leg.brush.is_some(),
        };
        let turned_within = walk.legs.iter().any(|leg| match &leg.leg.posture.to {
            Stand::Within(stop) | Stand::After(Some(stop)) => turns(stop),
            Stand::Before | Stand::After(None) => false,
        });
        let touching = on_skin || !part.sign.contact.is_empty() || walk.legs.iter().any(reaches_skin);
        let is_turned = walk.sites.iter().any(|site| site.turned.is_some());
        let free_hand = part.said.orientation.is_empty() && !on_skin && !is_turned && !turned_within;
        HandPlan {
            side,
            postures,
            points: walk.points,
            legs: walk.legs,
            start: walk.start,
            on_other_hand,
            free_hand,
            touching,
            wrist_path: None,
        }
    }
}

/// Whether a stop or one before it says how the hand is turned.
fn turns(stop: &Stop) -> bool {
    let mut stop = stop;
    loop {
        if stop.becoming.orientation.is_some() {
            return true;
        }
        match &stop.from {
            Stand::Within(before) | Stand::After(Some(before)) => stop = before,
            Stand::Before | Stand::After(None) => return false,
        }
    }
}

/// What became of a hand within intervals, and holds until a key states another.
#[derive(Debug, Clone, Default)]
struct Carried {
    configuration: Option<Configuration>,
    orientation: Option<Orientation>,
}

impl Carried {
    /// What holds at a stand of the interval that begins with this.
    fn after(&self, stand: &Stand) -> Carried {
        let mut made = Carried::default();
        let mut at = stand;
        while let Stand::Within(stop) | Stand::After(Some(stop)) = at {
            made.configuration = made.configuration.or_else(|| stop.becoming.configuration.clone());
            made.orientation = made.orientation.or(stop.becoming.orientation);
            at = &stop.from;
        }
        Carried {
            configuration: made.configuration.or_else(|| self.configuration.clone()),
            orientation: made.orientation.or(self.orientation),
        }
    }
}

/// The stands of an interval and the numbers of their postures.
struct Stands {
    interval: usize,
    /// That of the key before.
    key: usize,
    /// What holds there.
    carried: Carried,
    stops: Vec<(Arc<Stop>, usize)>,
    /// That of the key after, and what holds there.
    after: Option<(usize, Carried)>,
}

impl Stands {
    fn of(&self, stop: &Arc<Stop>) -> Option<usize> {
        self.stops.iter().find(|(known, _)| Arc::ptr_eq(known, stop)).map(|(_, made)| *made)
    }
}

/// The postures of a hand, as they are come to.
struct Postures<'w, 's> {
    planner: &'w Planner<'w>,
    walk: &'w Walk<'s>,
    list: Vec<KeyPosture>,
    /// The middle of wide turns between two of them.
    vias: Vec<((usize, usize), Option<DQuat>)>,
}

impl Postures<'_, '_> {
    fn push(&mut self, posture: KeyPosture, via: Option<DQuat>, before: Option<usize>) -> usize {
        let at = self.list.len();
        self.list.push(posture);
        if let Some(before) = before {
            self.vias.push(((before, at), via));
        }
        at
    }

    /// The posture at a key, coming from another one.
    fn key(
        &mut self,
        key: usize,
        before: Option<usize>,
        carried: &mut Carried,
        with: Option<&ContactPoint>,
    ) -> Result<usize, Error> {
        let (walk, said) = (self.walk, self.walk.part.said);
        let named = |e: Error| e.context(format_args!("key {}", key + 1));
        if said.configuration.stated(key).is_some() {
            carried.configuration = None;
        }
        if said.orientation.stated(key).is_some() {
            carried.orientation = None;
        }
        let configuration = carried.configuration.clone().unwrap_or_else(|| walk.part.configuration(key));
        let orientation = carried.orientation.or(said.orientation.at(key).copied()).unwrap_or_default();
        let site = &walk.sites[key];
        let place = site.anchor.as_ref().or((key == 0 && walk.derived).then_some(&walk.start));
        let with = with.or(walk.points.first()).ok_or_else(|| Error::new("a hand places no point"))?;
        let made = Said {
            configuration: &configuration,
            orientation,
            turns: said.orientation.stated(key).is_some(),
            turned: site.turned,
            with,
            place: place.map(|anchor| anchor.position(self.planner.neutral)),
            outward: said.placement.stated(key).and_then(|p| self.planner.outward(p, walk.side)),
        };
        let from = before.map(|b| self.list[b].clone());
        let (posture, via) = self.planner.posture(walk.part, &made, from.as_ref()).map_err(named)?;
        Ok(self.push(posture, via, before))
    }

    /// The number of the posture at a stand, made where it is not there yet.
    fn stand(&mut self, stand: &Stand, stands: &mut Stands, leg: &PlacedLeg) -> Result<usize, Error> {
        match stand {
            Stand::Before => Ok(stands.key),
            Stand::Within(stop) => self.stop(stop, stands, leg),
            Stand::After(stop) => {
                if let Some((made, _)) = &stands.after {
                    return Ok(*made);
                }
                let before = match stop {
                    Some(stop) => self.stop(stop, stands, leg)?,
                    None => stands.key,
                };
                let mut carried = stands.carried.after(stand);
                let with = self.walk.points.get(leg.with.to);
                let made = self.key(stands.interval + 1, Some(before), &mut carried, with)?;
                stands.after = Some((made, carried));
                Ok(made)
            }
        }
    }

    fn stop(&mut self, stop: &Arc<Stop>, stands: &mut Stands, leg: &PlacedLeg) -> Result<usize, Error> {
        if let Some(made) = stands.of(stop) {
            return Ok(made);
        }
        // Stops are come to in order: the one before is known, or is the key.
        let before = match &stop.from {
            Stand::Within(before) | Stand::After(Some(before)) => stands.of(before).unwrap_or(stands.key),
            Stand::Before | Stand::After(None) => stands.key,
        };
        let becoming = &stop.becoming;
        let from = self.list[before].clone();
        let points = &self.walk.points;
        let with = points.get(leg.with.to).or(points.first()).ok_or_else(|| Error::new("a hand places no point"))?;
        let configuration = becoming.configuration.clone().unwrap_or_else(|| self.walk.part.configuration(0));
        let kept = Orientation { along_path: from.along_path, ..Orientation::default() };
        let said = Said {
            configuration: &configuration,
            orientation: becoming.orientation.unwrap_or(kept),
            turns: becoming.orientation.is_some(),
            turned: None,
            with,
            place: Some(leg.to.position(self.planner.neutral)),
            outward: None,
        };
        let (mut posture, via) = self.planner.posture(self.walk.part, &said, Some(&from))?;
        if becoming.configuration.is_none() {
            posture.angles = from.angles;
        }
        let made = self.push(posture, via, Some(before));
        stands.stops.push((stop.clone(), made));
        Ok(made)
    }
}
