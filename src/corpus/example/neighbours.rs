//! Which gloss a take is likely to be: that of the takes that move most like it.

use super::Motion;
use super::warp::whole;

/// A take whose gloss is known.
#[derive(Debug, Clone, PartialEq)]
pub struct Take {
    /// The gloss.
    pub gloss: String,
    /// What belongs together: takes of one group (both hands of one performance) are no examples for each other.
    pub group: String,
    /// How it moves.
    pub motion: Motion,
}

/// How a take was guessed from the others.
#[derive(Debug, Clone, PartialEq)]
pub struct Guess {
    /// The glosses of the other takes, nearest first, each once, with the distance of its nearest take.
    pub ranked: Vec<(String, f64)>,
    /// The place of the take's own gloss among them, from 0; `None` where no other take has it.
    pub place: Option<usize>,
}

/// For each take the glosses of all others, ranked by their nearest take (leave-one-out, one nearest neighbour).
///
/// `band` is that of [`whole`].
///
/// ```
/// use chereme::corpus::example::Motion;
/// use chereme::corpus::example::neighbours::{Take, leave_one_out};
/// use chereme::time::Fps;
/// let take = |gloss: &str, group: &str, values: &[f32]| Take {
///     gloss: gloss.into(),
///     group: group.into(),
///     motion: Motion::new(Fps::DEFAULT, 1, values).unwrap(),
/// };
/// let takes = [take("up", "1", &[0.0, 1.0]), take("up", "2", &[0.1, 1.1]), take("down", "3", &[1.0, 0.0])];
/// assert_eq!(leave_one_out(&takes, 0.2)[0].place, Some(0));
/// ```
pub fn leave_one_out(takes: &[Take], band: f64) -> Vec<Guess> {
    // The distance is symmetric: each pair is laid on each other once.
    let mut distances = vec![vec![f64::INFINITY; takes.len()]; takes.len()];
    for i in 0..takes.len() {
        for j in 0..i {
            if takes[i].group != takes[j].group {
                let distance = whole(&takes[i].motion, &takes[j].motion, band);
                distances[i][j] = distance;
                distances[j][i] = distance;
            }
        }
    }
    let guess = |(i, take): (usize, &Take)| {
        let mut others: Vec<(&str, f64)> = takes
            .iter()
            .zip(&distances[i])
            .filter(|(other, _)| other.group != take.group)
            .map(|(other, distance)| (other.gloss.as_str(), *distance))
            .collect();
        others.sort_by(|a, b| a.1.total_cmp(&b.1).then(a.0.cmp(b.0)));
        let mut ranked: Vec<(String, f64)> = Vec::new();
        for (gloss, distance) in others {
            if !ranked.iter().any(|(known, _)| known == gloss) {
                ranked.push((gloss.to_owned(), distance));
            }
        }
        let place = ranked.iter().position(|(gloss, _)| *gloss == take.gloss);
        Guess { ranked, place }
    };
    takes.iter().enumerate().map(guess).collect()
}
