//! Where movements begin and end: at instants of little speed.

/// A movement in a speed profile: from rest over a peak to rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Cut {
    /// The last frame at rest before it.
    pub start: usize,
    /// The frame of greatest speed.
    pub peak: usize,
    /// The first frame at rest after it.
    pub end: usize,
    /// Where the speed falls to rest before `end`, in frames, between samples.
    pub stop: f64,
    /// Where the speed rises from rest after `start`, in frames, between samples.
    pub go: f64,
}

/// The movements of a speed profile. Rest is a speed of at most `rest` (a share) of the movement's own peak; a movement goes from the last
/// rest before its peak to the first rest after it. What does not come to rest on both sides, or rises higher before it does, is left out.
/// Movements are in order and do not overlap.
///
/// ```
/// use chereme::evaluation::kinematics::cut::transitions;
/// let speed = [0.0, 0.0, 1.0, 2.0, 1.0, 0.0, 0.0, 3.0, 0.1, 2.0];
/// let cuts = transitions(&speed, 0.05);
/// assert_eq!((cuts.len(), cuts[0].start, cuts[0].peak, cuts[0].end), (2, 1, 3, 5));
/// assert_eq!((cuts[1].start, cuts[1].end), (6, 8));
/// ```
pub fn transitions(speed: &[f64], rest: f64) -> Vec<Cut> {
    let rises = |i: usize| i == 0 || speed[i] > speed[i - 1];
    let falls = |i: usize| i + 1 == speed.len() || speed[i] >= speed[i + 1];
    let mut peaks: Vec<usize> = (0..speed.len()).filter(|&i| speed[i] > 0.0 && rises(i) && falls(i)).collect();
    peaks.sort_by(|&a, &b| speed[b].total_cmp(&speed[a]).then(a.cmp(&b)));
    let mut taken = vec![false; speed.len()];
    let mut cuts: Vec<Cut> = Vec::new();
    for peak in peaks {
        if taken[peak] {
            continue;
        }
        let Some(cut) = around(speed, peak, rest) else { continue };
        // Frames at rest may be shared, frames in motion may not.
        if taken[cut.start + 1..cut.end].iter().all(|t| !t) {
            taken[cut.start + 1..cut.end].fill(true);
            cuts.push(cut);
        }
    }
    cuts.sort_by_key(|cut| cut.start);
    cuts
}

fn around(speed: &[f64], peak: usize, rest: f64) -> Option<Cut> {
    let (top, still) = (speed[peak], rest * speed[peak]);
    // Out of the peak as far as it is the highest; a higher one is another's.
    let start = (0..peak).rev().find(|&i| speed[i] <= still || speed[i] > top).filter(|&i| speed[i] <= still)?;
    let after = peak + 1..speed.len();
    let end = after.into_iter().find(|&i| speed[i] <= still || speed[i] > top).filter(|&i| speed[i] <= still)?;
    let between = |inside: usize, outside: usize| (still - speed[outside]) / (speed[inside] - speed[outside]);
    Some(Cut {
        start,
        peak,
        end,
        go: start as f64 + between(start + 1, start),
        stop: end as f64 - between(end - 1, end),
    })
}
