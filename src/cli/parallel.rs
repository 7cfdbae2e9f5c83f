//! Work on many signs: on several cores, told in their order, with a bar on a terminal.

use super::{Failure, terminal};
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle};
use rayon::prelude::*;
use rayon::{ThreadPool, ThreadPoolBuilder};

/// How many items a core gets before results are told. What a batch gave waits for its last item, so no more than this is
/// kept.
const BATCH: usize = 16;

/// Cores to work on; all of them where no number is given.
pub(super) fn pool(jobs: Option<u16>) -> Result<ThreadPool, Failure> {
    let threads = jobs.map_or(0, usize::from);
    let built = ThreadPoolBuilder::new().num_threads(threads).build();
    built.map_err(|e| Failure::Faults(Some(format!("the cores cannot be used: {e}"))))
}

/// Works on items, and hands on the results in the items' order, whichever was done first.
pub(super) fn in_order<T: Send, R: Send>(
    pool: &ThreadPool,
    items: Vec<T>,
    work: impl Fn(T) -> R + Sync,
    mut tell: impl FnMut(R),
) {
    let batch = BATCH * pool.current_num_threads();
    let mut items = items.into_iter();
    loop {
        let next: Vec<T> = items.by_ref().take(batch).collect();
        if next.is_empty() {
            return;
        }
        // One at a time, so that a sign that takes long keeps no other waiting.
        let done: Vec<R> = pool.install(|| next.into_par_iter().with_max_len(1).map(&work).collect());
        done.into_iter().for_each(&mut tell);
    }
}

/// Whether a bar may be drawn.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Loudness {
    /// A bar, where standard error is a terminal.
    Told,
    /// Never.
    Quiet,
}

/// A bar on a terminal; nothing elsewhere.
pub(super) struct Progress(ProgressBar);

impl Progress {
    /// A bar of so many signs.
    pub(super) fn new(items: usize, loudness: Loudness) -> Progress {
        Progress::of(items, "signs", loudness)
    }

    /// A bar of so many items of a name.
    pub(super) fn of(items: usize, what: &str, loudness: Loudness) -> Progress {
        let bar = match loudness {
            Loudness::Quiet => ProgressBar::hidden(),
            Loudness::Told => ProgressBar::with_draw_target(Some(items as u64), ProgressDrawTarget::stderr()),
        };
        let style =
            ProgressStyle::with_template(&format!("{{bar:30}} {{pos}}/{{len}} {what}, {{per_sec}}, {{eta}} left"));
        Progress(bar.with_style(style.unwrap_or_else(|_| ProgressStyle::default_bar())))
    }

    /// One item more is done.
    pub(super) fn step(&self) {
        self.0.inc(1);
    }

    /// Prints to standard error, above the bar.
    pub(super) fn say(&self, text: &str) {
        self.0.suspend(|| terminal::err(text));
    }
}

impl Drop for Progress {
    fn drop(&mut self) {
        self.0.finish_and_clear();
    }
}
