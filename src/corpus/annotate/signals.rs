//! What is followed of a hand through a clip: points, directions, form, and how fast each changes.
//!
//! # Conventions
//! Points are model space, metres, less the way that the whole body goes (the root joint's), so that a signer who walks moves no
//! hand. Everything is smoothed by a window that reaches [`Options::smoothing`](super::Options) to both sides (Hann), whatever the
//! frame rate; speeds are central differences of what is smoothed.

use super::{Limb, Options};
use crate::body::measure::{FORM_POINTS, HandForm};
use crate::body::signer::Signer;
use crate::motion::clip::Clip;
use crate::motion::pose::ModelPose;
use crate::motion::profile::{derivative, speed};
use crate::phonology::{HandPoint, Side};
use crate::time::Fps;
use glam::{DQuat, DVec3};

/// A hand hangs whose wrist is farther from the shoulder than this part of the arm, and below it within the angle that follows.
const HANGS_REACH: f64 = 0.9;
/// The cosine of the angle between a hanging arm and the plumb line: 20°.
const HANGS_COSINE: f64 = 0.94;

/// One hand through a clip, a value a frame.
#[derive(Debug, Clone)]
pub(super) struct Signals {
    /// Which hand.
    pub side: Side,
    /// The clip's frame rate.
    pub fps: Fps,
    /// The middle of the palm.
    pub palm: Vec<DVec3>,
    /// The wrist.
    pub wrist: Vec<DVec3>,
    /// The end of the middle finger as if it were stretched: a point that turns with the hand and not with the fingers.
    pub front: Vec<DVec3>,
    /// Where the stretched fingers point, unit.
    pub fingers: Vec<DVec3>,
    /// Where the palm faces, unit.
    pub facing: Vec<DVec3>,
    /// Where the body's root is, which is taken from every point.
    pub origins: Vec<DVec3>,
    /// The hand's rotation, not smoothed.
    pub rotations: Vec<DQuat>,
    /// The form of the hand.
    pub forms: Vec<HandForm>,
    /// Whether the arm hangs.
    pub hangs: Vec<bool>,
    /// Metres a second of the palm; zero without an arm.
    pub path_speed: Vec<f64>,
    /// Radians a second of the hand.
    pub turn_speed: Vec<f64>,
    /// Metres a second of the digits' ends in the hand, the mean.
    pub form_speed: Vec<f64>,
}

impl Signals {
    pub fn new(
        clip: &Clip,
        models: &[ModelPose],
        signer: &Signer,
        side: Side,
        limb: Limb,
        options: &Options,
    ) -> Signals {
        let (fps, arm) = (clip.fps(), signer.arm(side));
        let origin = |i: usize| clip.frames()[i].pose.root_model;
        let count = models.len();
        let palm_point = signer.landmarks.hand_point(side, HandPoint::PALM).ok();
        let middle = |i: usize| palm_point.as_ref().map_or(models[i].position(arm.hand), |p| p.position(&models[i]));
        let window = Window::fitting(options.smoothing.0, &(0..count).map(middle).collect::<Vec<_>>(), fps);
        let raw = |f: &dyn Fn(usize) -> DVec3| window.smooth(&(0..count).map(f).collect::<Vec<_>>());
        let rotation = |i: usize| models[i].rotation(arm.hand);
        let wrist_at = |i: usize| models[i].position(arm.hand) - origin(i);
        let wrist = raw(&wrist_at);
        let palm = raw(&|i| middle(i) - origin(i));
        let reach = signer.landmarks.hand_length();
        let front = raw(&|i| wrist_at(i) + arm.fingers_and_palm(rotation(i)).0 * reach);
        let unit = |all: Vec<DVec3>| all.into_iter().map(|v| v.normalize_or(DVec3::Y)).collect::<Vec<_>>();
        let fingers = unit(raw(&|i| arm.fingers_and_palm(rotation(i)).0));
        let facing = unit(raw(&|i| arm.fingers_and_palm(rotation(i)).1));
        let forms: Vec<HandForm> = clip.frames().iter().map(|f| HandForm::of(signer, side, &f.pose)).collect();
        let forms = window.smooth_forms(&forms);
        let path_speed = match limb {
            Limb::Arm => speed(&palm, fps),
            Limb::Hand | Limb::None => vec![0.0; count],
        };
        let hang = |i: usize| {
            let down = models[i].position(arm.hand) - models[i].position(arm.upper);
            limb == Limb::Arm && down.length() > HANGS_REACH * arm.length_m() && -down.y > HANGS_COSINE * down.length()
        };
        let (turn_speed, form_speed) = (turning(&fingers, &facing, fps), forming(&forms, fps));
        Signals {
            side,
            fps,
            origins: (0..count).map(origin).collect(),
            rotations: (0..count).map(rotation).collect(),
            hangs: (0..count).map(hang).collect(),
            palm,
            wrist,
            front,
            fingers,
            facing,
            forms,
            path_speed,
            turn_speed,
            form_speed,
        }
    }

    /// How much the hand does altogether, metres a second: its way, its turning as the way of its fingers' middle, and its forming.
    pub fn activity(&self) -> Vec<f64> {
        const TURNS_AT_M: f64 = 0.1;
        let all = self.path_speed.iter().zip(&self.turn_speed).zip(&self.form_speed);
        all.map(|((path, turn), form)| path + TURNS_AT_M * turn + form).collect()
    }
}

/// Radians a second of a frame of two directions: the rate of each is that of the turn but for the part about itself.
fn turning(fingers: &[DVec3], facing: &[DVec3], fps: Fps) -> Vec<f64> {
    let (a, b) = (derivative(fingers, fps), derivative(facing, fps));
    let third: Vec<DVec3> = fingers.iter().zip(facing).map(|(f, p)| f.cross(*p)).collect();
    let c = derivative(&third, fps);
    let whole = |i: usize| ((a[i].length_squared() + b[i].length_squared() + c[i].length_squared()) / 2.0).sqrt();
    (0..a.len()).map(whole).collect()
}

fn forming(forms: &[HandForm], fps: Fps) -> Vec<f64> {
    let mut sum = vec![0.0; forms.len()];
    for tip in (2..FORM_POINTS).step_by(3) {
        let path: Vec<DVec3> = forms.iter().map(|form| form.0[tip]).collect();
        sum.iter_mut().zip(speed(&path, fps)).for_each(|(sum, speed)| *sum += speed / 5.0);
    }
    sum
}

/// A window of weights about a frame.
struct Window(Vec<f64>);

/// The deviation of a path's noise that counts for none, and that which makes the window twice as wide, metres.
const NOISE_M: (f64, f64) = (0.8e-3, 1.8e-3);
/// A window grows to so many times its reach at most.
const WIDEST: f64 = 2.4;

impl Window {
    /// A window that reaches so far, or farther where a path is noisy.
    ///
    /// Noise differs from frame to frame and motion hardly does: the third difference of a path is 20^(1/2) times the deviation of noise on it.
    /// The median says it, whatever a hand does in some of the frames.
    fn fitting(reach: f64, path: &[DVec3], fps: Fps) -> Window {
        let third = |w: &[DVec3]| ((w[3] - w[0]) - (w[2] - w[1]) * 3.0).length() / 20f64.sqrt();
        let mut off: Vec<f64> = path.windows(4).map(third).collect();
        off.sort_by(f64::total_cmp);
        let noise = off.get(off.len() / 2).copied().unwrap_or(0.0);
        let usual = Window::new(reach, fps);
        let wider = 1.0 + (noise - NOISE_M.0) / (NOISE_M.1 - NOISE_M.0);
        // What is no number makes no window wider.
        if wider > 1.0 { Window::new(reach * wider.min(WIDEST), fps) } else { usual }
    }

    /// A Hann window that reaches so many seconds to each side.
    fn new(reach: f64, fps: Fps) -> Window {
        let reach = reach.clamp(0.0, 1.0) * fps.get();
        let weight = |i: usize| 0.5 + 0.5 * (std::f64::consts::PI * i as f64 / reach.max(1e-9)).cos();
        let beyond = (1..).take_while(|i| (*i as f64) < reach).map(weight);
        Window(std::iter::once(1.0).chain(beyond).collect())
    }

    fn smooth(&self, values: &[DVec3]) -> Vec<DVec3> {
        let mean = |i: usize| {
            let (mut sum, mut all) = (values[i] * self.0[0], self.0[0]);
            for (k, weight) in self.0.iter().enumerate().skip(1) {
                // As far to both sides, so that the ends stay where they are.
                if k > i || i + k >= values.len() {
                    break;
                }
                sum += (values[i - k] + values[i + k]) * *weight;
                all += 2.0 * weight;
            }
            sum / all
        };
        (0..values.len()).map(mean).collect()
    }

    fn smooth_forms(&self, forms: &[HandForm]) -> Vec<HandForm> {
        let mut smoothed = forms.to_vec();
        for point in 0..FORM_POINTS {
            let path: Vec<DVec3> = forms.iter().map(|form| form.0[point]).collect();
            smoothed.iter_mut().zip(self.smooth(&path)).for_each(|(form, at)| form.0[point] = at);
        }
        smoothed
    }
}
