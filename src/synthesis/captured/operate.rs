//! What is said of a captured sign, done to its motion.

use super::Takes;
use crate::body::signer::Signer;
use crate::diagnostics::Error;
use crate::motion::pose::LocalPose;
use crate::phonology::operator::Operator;
use crate::phonology::{Configuration, Hand, Place, Side};
use crate::score::plan::Captured;
use crate::synthesis::edit::track::{self, Phases};
use crate::synthesis::edit::{self, HandKept, Repetition, Scaling, Sides};
use crate::synthesis::{Grammar, Options};
use crate::time::Seconds;
use crate::track::Track;
use glam::DVec3;

/// A wrist that stays farther than this from where it should be is told, metres.
const TOLD_M: f64 = 0.005;
/// How much larger (or, below 1, smaller) each further performance is for a growth of 1.
const GROWTH: f64 = 1.25;

/// The sign after its operators, performances, exchange of hands and place, in this order.
pub(super) fn operated(
    mut track: Track,
    captured: &Captured,
    takes: &dyn Takes,
    grammar: &Grammar,
    signer: &Signer,
    options: &Options,
    warnings: &mut Vec<String>,
) -> Result<Track, Error> {
    let by = By { takes, grammar, signer, options };
    for operator in &captured.operators {
        track = by.one(&track, operator, warnings)?;
    }
    if captured.times > 1 {
        track = by.repeated(&track, captured.times, None, 0)?;
    }
    if captured.swapped {
        track = track::swapped(&track, signer)?;
    }
    match &captured.place {
        Some(place) => by.placed(&track, place, warnings),
        None => Ok(track),
    }
}

struct By<'a> {
    takes: &'a dyn Takes,
    grammar: &'a Grammar,
    signer: &'a Signer,
    options: &'a Options,
}

impl By<'_> {
    fn one(&self, track: &Track, operator: &Operator, warnings: &mut Vec<String>) -> Result<Track, Error> {
        let easing = self.options.easing;
        match operator {
            Operator::Inverted => track::inverted(track, self.signer, easing),
            Operator::Mirrored => track::mirrored(track, self.signer, acting(track)?),
            Operator::Swapped => track::swapped(track, self.signer),
            Operator::Reflected => Ok(track::reflected(track)),
            Operator::Repeated { times, gap, growth } => self.repeated(track, *times, *gap, *growth),
            Operator::Configuration(hand, keys) => {
                let mut all = keys.iter().map(|(_, configuration)| configuration);
                let (Some(one), None) = (all.next(), all.next()) else {
                    return Err(Error::new("a captured sign takes one other configuration, not several"));
                };
                self.configured(track, *hand, one)
            }
            Operator::At(to) => self.placed(track, &to.place, warnings),
            Operator::Speed(factor) => track::at_speed(track, *factor),
            Operator::Size(factor) => {
                let phases = Phases::of(track)?;
                let how = Scaling { sides: phases.sides, extent: phases.extent(easing), about: edit::About::Mean };
                let moved = edit::sized(&track.clip, self.signer, *factor, &how)?;
                told(moved.residual_m, moved.at, warnings);
                Ok(Track { clip: moved.clip, tiers: track.tiers.clone() })
            }
            Operator::InvertedMovement => {
                let phases = Phases::of(track)?;
                let clip = edit::inverted_movement(&track.clip, self.signer, phases.sides)?;
                Ok(Track { clip, tiers: track.tiers.clone() })
            }
            Operator::Orientation(..) => Err(no_description("orientation")),
            Operator::Placement(..) => Err(no_description("placement")),
            Operator::Movement(..) => Err(no_description("movement")),
            Operator::NonManual(channel, _) => Err(no_description(channel.name())),
        }
    }

    fn repeated(&self, track: &Track, times: u8, gap: Option<Seconds>, growth: i8) -> Result<Track, Error> {
        let how = Repetition {
            times: u32::from(times),
            gap: gap.unwrap_or(Seconds(0.0)),
            growth: GROWTH.powi(i32::from(growth)),
            sides: Sides::Both,
            easing: self.options.easing,
        };
        track::repeated(track, self.signer, &how)
    }

    /// Another configuration: as it was captured where the corpus has it, else the inventory's.
    fn configured(&self, track: &Track, hand: Option<Hand>, configuration: &Configuration) -> Result<Track, Error> {
        let sides = match (hand, acting(track)?, Phases::of(track)?.sides) {
            (None, _, sides) => sides,
            (Some(Hand::Strong), Side::Right, _) | (Some(Hand::Weak), Side::Left, _) => Sides::Right,
            (Some(_), ..) => Sides::Left,
        };
        let (angles, source) = match self.takes.configuration(configuration) {
            Some(captured) => captured,
            None => {
                let angles = self.grammar.handshapes.angles(configuration, None);
                (angles.map_err(|e| Error::new(e.to_string()))?, format!("grammar: {}", configuration.base))
            }
        };
        let name = crate::phonology::label::configuration(configuration);
        let mut made = track::with_configuration(track, self.signer, sides, (&name, &angles), self.options.easing)?;
        for tier in made.tiers.iter_mut().filter(|tier| tier.name.ends_with("Configuration")) {
            let mut again = crate::tier::Tier::new(tier.name.clone());
            for v in tier.values() {
                let source = if v.source == "configuration replaced" { &source } else { &v.source };
                again.push(v.start, v.end, v.label.clone(), source.clone());
            }
            *tier = again;
        }
        Ok(made)
    }

    fn placed(&self, track: &Track, place: &Place, warnings: &mut Vec<String>) -> Result<Track, Error> {
        let moved = track::relocated_to(track, self.signer, self.position(place)?, HandKept::Global)?;
        told(moved.residual_m, moved.at, warnings);
        Ok(moved.track)
    }

    /// Where a place is when the signer stands at rest, model space, metres.
    fn position(&self, place: &Place) -> Result<DVec3, Error> {
        let model = LocalPose::rest(&self.signer.skeleton).to_model(&self.signer.skeleton);
        match place {
            Place::Space(cell) => Ok(self.signer.landmarks.space(*cell).position(&model)),
            Place::Point(at) => Ok(*at),
            Place::Body(id) => Ok(self.signer.landmarks.body_place(id, None)?.position(&model)),
            Place::OtherHand(_) | Place::Between(..) | Place::Referent(_) | Place::Towards(_) => {
                Err(Error::new("a captured sign is moved to a place of space or of the body"))
            }
        }
    }
}

/// The hand that makes the sign; the right one where both do.
fn acting(track: &Track) -> Result<Side, Error> {
    Ok(if Phases::of(track)?.sides == Sides::Left { Side::Left } else { Side::Right })
}

fn told(residual_m: f64, at: Seconds, warnings: &mut Vec<String>) {
    if residual_m > TOLD_M {
        let mm = residual_m * 1e3;
        warnings.push(format!("at {at} a wrist stays {mm:.0} mm away from its place: out of reach"));
    }
}

fn no_description(what: &str) -> Error {
    let instead = match what {
        "orientation" => ": take it from another take, `take(…, orientation …)`, or sign it by procedure",
        "placement" | "movement" => ": take it from another take, `take(…, placement …)`, or sign it by procedure",
        _ => ": sign it by procedure",
    };
    Error::new(format!("a captured sign has no description in which its {what} could be replaced{instead}"))
}
