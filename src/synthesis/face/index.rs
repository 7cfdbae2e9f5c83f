//! All cues of a clip, sorted by time; head and eyes brought into step.

use super::cue::{Cue, Hold, Key, NonManualState, Shape, turned};
use crate::body::signer::Turn;
use crate::phonology::Channel;

/// The cues of a clip, to be asked frame by frame.
#[derive(Debug, Clone, Default)]
pub struct Face {
    cues: Vec<Cue>,
    /// The numbers of the cues that are seen in each stretch of `STRETCH` seconds from `start`.
    stretches: Vec<Vec<u32>>,
    start: f64,
}

/// Seconds of a stretch of the index.
const STRETCH: f64 = 0.25;
/// Eyes are there before the head, seconds.
const GAZE_LEADS: f64 = 0.1;
/// Eyes and head that start within this time go together, seconds.
const TOGETHER: f64 = 0.2;
/// The share of the eyes' turn that a head takes that goes with them.
const HEAD_WITH_GAZE: f64 = 0.7;
/// Where nothing is said of the gaze, eyes take back this share of a turn that is held, and of one that beats.
const COUNTER_HELD: f64 = 0.25;
const COUNTER_BEATING: f64 = 0.7;
/// Eyes turn at most this far in the head: up or down, and sideways; radians.
const EYES_MOST: (f64, f64) = (0.55, 0.66);

impl Face {
    /// Sorts cues.
    pub fn new(mut cues: Vec<Cue>) -> Face {
        go_with_gaze(&mut cues);
        lead_with_gaze(&mut cues);
        cues.retain(|cue| cue.keys.len() > 1);
        let start = cues.iter().map(|c| c.span().0).fold(f64::INFINITY, f64::min);
        let mut stretches: Vec<Vec<u32>> = Vec::new();
        for (number, cue) in cues.iter().enumerate() {
            let (first, last) = cue.span();
            let (first, last) = (((first - start) / STRETCH) as usize, ((last - start) / STRETCH) as usize);
            if stretches.len() <= last {
                stretches.resize(last + 1, Vec::new());
            }
            stretches[first..=last].iter_mut().for_each(|stretch| stretch.push(number as u32));
        }
        Face { cues, stretches, start }
    }

    /// Whether nothing is said.
    pub fn is_empty(&self) -> bool {
        self.cues.is_empty()
    }

    /// What all cues together do at an instant.
    pub fn state_at(&self, time: f64) -> NonManualState {
        let mut state = NonManualState::default();
        let stretch = (time - self.start) / STRETCH;
        let Some(here) = (stretch >= 0.0).then(|| self.stretches.get(stretch as usize)).flatten() else {
            return state;
        };
        for cue in here.iter().filter_map(|n| self.cues.get(*n as usize)) {
            cue.add_to(&mut state, time);
        }
        aim(&mut state);
        state
    }
}

/// Turns the eyes in the head so that they look where they should in space.
fn aim(state: &mut NonManualState) {
    let [said, in_space] = state.gaze.map(|share| share.clamp(0.0, 1.0));
    let held =
        Turn { pitch: state.head.pitch - state.beating.pitch, yaw: state.head.yaw - state.beating.yaw, roll: 0.0 };
    let beating = Turn { roll: 0.0, ..state.beating };
    turned(&mut state.eyes, held, -in_space - (1.0 - said) * COUNTER_HELD);
    turned(&mut state.eyes, beating, -in_space - (1.0 - said) * COUNTER_BEATING);
    state.eyes.pitch = state.eyes.pitch.clamp(-EYES_MOST.0, EYES_MOST.0);
    state.eyes.yaw = state.eyes.yaw.clamp(-EYES_MOST.1, EYES_MOST.1);
}

/// Gives a head that goes with the gaze the keys of the gaze meanwhile, a little later.
fn go_with_gaze(cues: &mut [Cue]) {
    let gazes: Vec<Cue> = cues.iter().filter(|c| c.channel == Channel::Gaze).cloned().collect();
    for cue in cues.iter_mut().filter(|c| c.hold == Hold::WithGaze) {
        let (start, end) = cue.span();
        let mut keys: Vec<Key> = Vec::new();
        let mut shapes: Vec<Shape> = Vec::new();
        for gaze in gazes.iter().filter(|g| g.span().0 < end && g.span().1 > start) {
            let first = shapes.len();
            let only_turn = |s: &Shape| Shape { turn: s.turn, ..Shape::default() };
            shapes.extend(gaze.shapes.iter().map(only_turn));
            for key in &gaze.keys {
                let at = (key.at + GAZE_LEADS).max(keys.last().map_or(start, |k| k.at + 1e-3));
                keys.push(Key { at, shape: first + key.shape, level: key.level * HEAD_WITH_GAZE });
            }
        }
        (cue.keys, cue.shapes) = (keys, shapes);
    }
}

/// Lets eyes start before the head that turns with them.
fn lead_with_gaze(cues: &mut [Cue]) {
    let turns = |c: &Cue| c.hold != Hold::Beating && c.shapes.iter().any(|s| s.turn.yaw != 0.0 || s.turn.pitch != 0.0);
    let heads: Vec<f64> = cues.iter().filter(|c| c.channel == Channel::Head && turns(c)).map(|c| c.span().0).collect();
    for cue in cues.iter_mut().filter(|c| c.channel == Channel::Gaze) {
        let Some(own) = cue.keys.first().map(|k| k.at) else { continue };
        let Some(head) = heads.iter().copied().find(|head| (head - own).abs() < TOGETHER) else { continue };
        let by = (own - (head - GAZE_LEADS)).max(0.0);
        cue.keys.iter_mut().take(2).for_each(|key| key.at -= by);
    }
}
