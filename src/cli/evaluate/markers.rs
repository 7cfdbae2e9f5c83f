//! Marker positions as Qualisys exports them (TSV, millimetres): shoulder, elbow and hand of one arm.

use crate::diagnostics::Error;
use crate::evaluation::kinematics::Movement;
use crate::time::Fps;
use glam::DVec3;

const METRES: f64 = 0.001;
/// The marker of the hand, by preference.
const HANDS: [&str; 3] = ["hand_top", "wrist", "hand"];

/// The arm of a table whose columns are named `… shoulder X`, `… elbow X`, `hand_top X`.
pub(super) fn arm(take: &str, text: &str) -> Result<Movement, Error> {
    let mut lines = text.lines().enumerate();
    let mut frequency = None;
    let mut names = Vec::new();
    for (_, line) in lines.by_ref() {
        let cells: Vec<&str> = line.split('\t').map(str::trim).collect();
        match cells.as_slice() {
            ["FREQUENCY", rate, ..] => frequency = rate.parse::<f64>().ok().and_then(Fps::new),
            ["Frame", ..] => {
                names = cells.into_iter().map(str::to_owned).collect();
                break;
            }
            _ => {}
        }
    }
    let fps =
        frequency.ok_or_else(|| Error::new("there is no row FREQUENCY with a rate; is it a table of Qualisys?"))?;
    let column = |part: &str| names.iter().position(|n| n.strip_suffix(" X").is_some_and(|n| n.ends_with(part)));
    let marker =
        |part: &str| column(part).ok_or_else(|| Error::new(format!("there is no marker whose name ends in `{part}`")));
    let hand = HANDS.iter().find_map(|part| column(part));
    let hand = hand.ok_or_else(|| Error::new(format!("there is no marker of a hand: {}", HANDS.join(", "))))?;
    let columns = [marker("shoulder")?, marker("elbow")?, hand];
    let mut frames = Vec::new();
    for (number, line) in lines.filter(|(_, line)| !line.trim().is_empty()) {
        let cells: Vec<&str> = line.split('\t').collect();
        let value = |at: usize| {
            let cell = cells.get(at).map_or("", |c| c.trim());
            cell.parse::<f64>()
                .ok()
                .filter(|v| v.is_finite())
                .ok_or_else(|| Error::new(format!("line {}, column {}: `{cell}` is no number", number + 1, at + 1)))
        };
        let place = |at: usize| Ok::<DVec3, Error>(DVec3::new(value(at)?, value(at + 1)?, value(at + 2)?) * METRES);
        frames.push([place(columns[0])?, place(columns[1])?, place(columns[2])?]);
    }
    Movement::of_arm(take, fps, frames).ok_or_else(|| Error::new("there is no row of positions"))
}
