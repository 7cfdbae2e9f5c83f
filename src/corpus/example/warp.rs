//! Dynamic time warping (Sakoe & Chiba 1978): one motion laid on another, faster here and slower there.
//!
//! [`stretches`] lays a whole example on any part of a recording (open begin and end); its slope is limited to between a half and twice,
//! so that no frame is held to swallow a difference. [`whole`] lays two motions on each other from end to end.

use super::{LANES, Motion};

/// A part of a recording on which an example was laid.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Stretch {
    /// The first frame.
    pub start: usize,
    /// The last frame.
    pub end: usize,
    /// The mean distance of the example's frames.
    pub distance: f32,
}

/// The Euclidean distance of two rows of whole lanes.
fn distance(a: &[f32], b: &[f32]) -> f32 {
    let mut sums = [0f32; LANES];
    for (x, y) in a.as_chunks::<LANES>().0.iter().zip(b.as_chunks::<LANES>().0) {
        for k in 0..LANES {
            let difference = x[k] - y[k];
            sums[k] += difference * difference;
        }
    }
    sums.iter().sum::<f32>().sqrt()
}

/// The best warp that ends in a cell: the sum of distances so far and the frame at which it began.
#[derive(Debug, Clone, Copy)]
struct Cell {
    sum: f32,
    start: usize,
}

const NOWHERE: Cell = Cell { sum: f32::INFINITY, start: 0 };

/// For each frame at which an example may end best (better than one frame before, no worse than one after), the best stretch that ends
/// there; none where the recording is shorter than half the example.
///
/// The steps are one frame of the example on one, one on two (the first of which counts nothing), two on one (Sakoe & Chiba's slope
/// constraint P = 1, asymmetric: every frame of the example counts once, so that distances compare over stretches of any length). Time is the
/// product of the lengths, memory their sum.
///
/// ```
/// use chereme::corpus::example::{Motion, warp::stretches};
/// use chereme::time::Fps;
/// let of = |values: &[f32]| Motion::new(Fps::DEFAULT, 1, values).unwrap();
/// let found = stretches(&of(&[0.0, 1.0]), &of(&[9.0, 0.0, 1.0, 9.0]));
/// assert!(found.iter().any(|s| (s.start, s.end, s.distance) == (1, 2, 0.0)));
/// ```
pub fn stretches(example: &Motion, recording: &Motion) -> Vec<Stretch> {
    let length = example.len();
    // Columns of the table: the recording's frame now, one before and two before.
    let mut columns = [vec![NOWHERE; length], vec![NOWHERE; length], vec![NOWHERE; length]];
    let mut costs = vec![0f32; length];
    let mut ends: Vec<Cell> = Vec::with_capacity(recording.len());
    for frame in 0..recording.len() {
        let row = recording.padded(frame);
        for (i, cost) in costs.iter_mut().enumerate() {
            *cost = distance(example.padded(i), row);
        }
        columns.rotate_right(1);
        let [now, before, earlier] = &mut columns;
        now[0] = Cell { sum: costs[0], start: frame };
        for i in 1..length {
            let mut best = less(before[i - 1], earlier[i - 1]);
            if i >= 2 {
                let two = before[i - 2];
                best = less(best, Cell { sum: two.sum + costs[i - 1], ..two });
            }
            now[i] = Cell { sum: best.sum + costs[i], ..best };
        }
        // Two frames of the example on the recording's first one of the stretch.
        if length > 1 {
            now[1] = less(now[1], Cell { sum: costs[0] + costs[1], start: frame });
        }
        ends.push(now[length - 1]);
    }
    best_ends(&ends, length)
}

/// The lesser sum; of equal ones the first.
fn less(a: Cell, b: Cell) -> Cell {
    if b.sum < a.sum { b } else { a }
}

fn best_ends(ends: &[Cell], length: usize) -> Vec<Stretch> {
    let sum = |frame: Option<usize>| frame.and_then(|f| ends.get(f)).map_or(f32::INFINITY, |cell| cell.sum);
    let is_least = |end: usize| {
        let here = ends[end].sum;
        here.is_finite() && here < sum(end.checked_sub(1)) && here <= sum(Some(end + 1))
    };
    let stretch = |end: usize| Stretch { start: ends[end].start, end, distance: ends[end].sum / length as f32 };
    (0..ends.len()).filter(|end| is_least(*end)).map(stretch).collect()
}

/// How far two motions are from each other when each is laid on the other from its first frame to its last: the sum of distances along the best
/// warp, a diagonal step counted twice, over the sum of the lengths (Sakoe & Chiba 1978, symmetric form without slope constraint).
///
/// A frame is laid on none that is farther from its own part of the motion than `band`, a part of the longer motion (0 to 1). Infinite
/// where the dimensions differ.
///
/// ```
/// use chereme::corpus::example::{Motion, warp::whole};
/// use chereme::time::Fps;
/// let of = |values: &[f32]| Motion::new(Fps::DEFAULT, 1, values).unwrap();
/// assert_eq!(whole(&of(&[0.0, 1.0]), &of(&[0.0, 0.0, 1.0, 1.0]), 0.3), 0.0);
/// assert_eq!(whole(&of(&[0.0, 0.0]), &of(&[1.0, 1.0]), 0.3), 1.0);
/// ```
pub fn whole(a: &Motion, b: &Motion, band: f64) -> f64 {
    whole_by(a, b, band, |distance| distance)
}

/// As [`whole`], where what it costs to lay a frame on another is a function of their distance (of no less than 0, itself none less).
///
/// ```
/// use chereme::corpus::example::{Motion, warp::whole_by};
/// use chereme::time::Fps;
/// let of = |values: &[f32]| Motion::new(Fps::DEFAULT, 1, values).unwrap();
/// assert_eq!(whole_by(&of(&[0.0, 0.0]), &of(&[4.0, 4.0]), 0.3, f32::sqrt), 2.0);
/// ```
pub fn whole_by(a: &Motion, b: &Motion, band: f64, cost: impl Fn(f32) -> f32) -> f64 {
    if a.dims() != b.dims() {
        return f64::INFINITY;
    }
    // The longer one is laid along the rows, so that the order of the two does not matter.
    let (a, b) = if a.len() < b.len() { (b, a) } else { (a, b) };
    let (rows, columns) = (a.len(), b.len());
    let slope = (columns - 1) as f64 / (rows - 1).max(1) as f64;
    // A band of less than a step would leave gaps.
    let half = (band.clamp(0.0, 1.0) * rows as f64 * slope).max(slope).max(1.0);
    let (mut last, mut now) = (vec![f32::INFINITY; columns], vec![f32::INFINITY; columns]);
    for i in 0..rows {
        let middle = i as f64 * slope;
        let from = (middle - half).ceil().max(0.0) as usize;
        let to = ((middle + half).floor() as usize).min(columns - 1);
        now.fill(f32::INFINITY);
        for j in from..=to {
            let cost = cost(distance(a.padded(i), b.padded(j)));
            let diagonal = if i > 0 && j > 0 { last[j - 1] + 2.0 * cost } else { f32::INFINITY };
            let left = if j > 0 { now[j - 1] + cost } else { f32::INFINITY };
            let best = diagonal.min(left).min(last[j] + cost);
            now[j] = if i == 0 && j == 0 { 2.0 * cost } else { best };
        }
        std::mem::swap(&mut last, &mut now);
    }
    f64::from(last[columns - 1]) / (rows + columns) as f64
}
