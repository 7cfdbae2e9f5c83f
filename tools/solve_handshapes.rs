//! Puts every handshape of `grammar/handshapes.ron` on the avatar's mesh and writes the solved angles back.
//!
//!     cargo run --release --example solve_handshapes [-- --only ID,ID] [--dump rotations.json] [--keep]
//!
//! For each row the fingers and the thumb are solved together (damped least squares on the skinned mesh): the
//! named contact is made, nothing enters anything, closed fingers close on the palm, fingers that lie together
//! touch, every joint stays within limits and each finger within 15° of the table. `--dump` writes the finger
//! joints' rotations of all shapes for `tools/shots/handshapes.mjs`; `--keep` leaves the table as it is. `--try FILE` measures instead the
//! configurations of a file, one a line, as gestural SiGML names their parts (`handshape=flat thumbpos=out`).

#[path = "solve_handshapes/configurations.rs"]
mod configurations;
#[path = "solve_handshapes/goals.rs"]
mod goals;
#[path = "solve_handshapes/least_squares.rs"]
mod least_squares;
#[path = "solve_handshapes/report.rs"]
mod report;

use chereme::avatar;
use chereme::body::hand_skin::HandSkin;
use chereme::diagnostics::{Error, Source};
use chereme::motion::skeleton::Skeleton;
use chereme::phonology::Side;
use chereme::phonology::handshape::{Handshape, HandshapeInventory, Solved, ThumbGoal};
use goals::Goals;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::sync::{Mutex, PoisonError};

const TABLE: &str = "grammar/handshapes.ron";

fn main() -> Result<(), Box<dyn std::error::Error>> {
    let arguments: Vec<String> = std::env::args().skip(1).collect();
    let value = |flag: &str| arguments.iter().position(|a| a == flag).and_then(|i| arguments.get(i + 1)).cloned();
    let keep = arguments.iter().any(|a| a == "--keep");
    let text = std::fs::read_to_string(TABLE)?;
    let inventory = HandshapeInventory::read(&Source::new(TABLE, &text))
        .map_err(|faults| Error::new(faults.iter().map(|f| f.message.clone()).collect::<Vec<_>>().join("; ")))?;
    let skeleton = Skeleton::from_json(avatar::SKELETON)?;
    let hand = HandSkin::new(&skeleton, &avatar::skin(&skeleton)?, Side::Left)?;
    if let Some(path) = value("--try") {
        let hands = configurations::hands(&inventory, &std::fs::read_to_string(path)?);
        configurations::measure(&skeleton, &hand, &hands)?;
        if let Some(path) = value("--dump") {
            std::fs::write(path, report::rotations(&skeleton, &hands)?)?;
        }
        return Ok(());
    }
    let mut shapes = inventory.shapes().to_vec();
    if !keep {
        let only = value("--only");
        solve_all(&hand, &mut shapes, only.as_deref());
        std::fs::write(TABLE, report::with_solutions(&text, &shapes))?;
    }
    for shape in &shapes {
        println!("{}", report::line(&hand, shape));
    }
    if let Some(path) = value("--dump") {
        let hands: Vec<_> = shapes.iter().map(|s| (s.id.clone(), s.angles())).collect();
        std::fs::write(path, report::rotations(&skeleton, &hands)?)?;
    }
    Ok(())
}

/// Solves the rows on as many threads as there are cores; the result does not depend on how many.
fn solve_all(hand: &HandSkin, shapes: &mut [Handshape], only: Option<&str>) {
    let next = AtomicUsize::new(0);
    let solved = Mutex::new(Vec::new());
    let rows: &[Handshape] = shapes;
    std::thread::scope(|scope| {
        for _ in 0..std::thread::available_parallelism().map_or(1, |n| n.get()) {
            scope.spawn(|| {
                loop {
                    let i = next.fetch_add(1, Ordering::Relaxed);
                    let Some(shape) = rows.get(i) else { break };
                    if only.is_none_or(|ids| ids.split(',').any(|id| id == shape.id)) {
                        let result = solve(hand, shape);
                        solved.lock().unwrap_or_else(PoisonError::into_inner).push((i, result));
                    }
                }
            });
        }
    });
    for (i, result) in solved.into_inner().unwrap_or_else(PoisonError::into_inner) {
        shapes[i].solved = Some(result);
    }
}

/// Where the thumb may start from besides the table: radial, palmar, pronation, MCP, IP, degrees.
const STARTS: [[f64; 5]; 6] = [
    [40.0, 65.0, 50.0, 45.0, 40.0],
    [14.0, 68.0, 35.0, 50.0, 50.0],
    [-5.0, 50.0, 40.0, 60.0, 20.0],
    [-15.0, 54.0, 52.0, 18.0, -15.0],
    [5.0, 45.0, 55.0, 10.0, 0.0],
    [20.0, 12.0, 10.0, 5.0, 10.0],
];

/// The best of several starts: the table's thumb, that thumb swung aside, and thumbs across, opposed and along.
fn solve(hand: &HandSkin, shape: &Handshape) -> Solved {
    let goals = Goals::new(hand, shape);
    let table = shape.table.to_array();
    let mut starts = vec![table];
    if !matches!(shape.thumb, ThumbGoal::Posture(_)) {
        let mut swung = table;
        swung[16] += 20f64.to_radians();
        swung[18] += 10f64.to_radians();
        starts.push(swung);
        starts.extend(STARTS.map(|s| std::array::from_fn(|i| if i < 16 { table[i] } else { s[i - 16].to_radians() })));
    }
    let mut tried: Vec<(f64, [f64; 21])> =
        starts.into_iter().map(|x| least_squares::solve(&goals, goals.clamp(x), 10)).collect();
    tried.sort_by(|a, b| a.0.total_cmp(&b.0));
    let finished = tried.into_iter().take(3).map(|(_, x)| least_squares::solve(&goals, x, 40));
    let (_, x) = finished.min_by(|a, b| a.0.total_cmp(&b.0)).unwrap_or((0.0, table));
    let angles = report::rounded(&goals.hand_angles(x));
    Solved { angles, residual_mm: (hand.pose(&angles).residual_mm(&shape.thumb) * 10.0).round() / 10.0 }
}
