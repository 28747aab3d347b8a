//! Least times of runs, in milliseconds.

use super::clock::clock;

/// Seconds a batch of runs must take: the kernel's clock moves in ticks of some milliseconds.
const BATCH: f64 = 0.1;

fn batch(run: &mut dyn FnMut(), times: usize) -> f64 {
    let start = clock();
    (0..times).for_each(|_| run());
    (clock() - start) / times as f64
}

fn runs_a_batch(run: &mut dyn FnMut()) -> usize {
    let mut runs = 1;
    loop {
        let taken = batch(run, runs) * runs as f64;
        if taken > 0.1 * BATCH || runs > 1_000_000 {
            return (runs as f64 * BATCH / taken.max(1e-3)).ceil() as usize;
        }
        runs *= 10;
    }
}

/// Least time of a run.
pub(super) fn least(repetitions: usize, mut run: impl FnMut()) -> f64 {
    let runs = runs_a_batch(&mut run);
    1e3 * (0..repetitions)
        .map(|_| batch(&mut run, runs))
        .fold(f64::INFINITY, f64::min)
}

/// Least time of either, run in turns: what else the machine does meets both.
pub(super) fn least_of_two(
    repetitions: usize,
    mut ours: impl FnMut(),
    mut theirs: impl FnMut(),
) -> [f64; 2] {
    let runs = [runs_a_batch(&mut ours), runs_a_batch(&mut theirs)];
    let mut least = [f64::INFINITY; 2];
    for _ in 0..repetitions {
        least[0] = least[0].min(batch(&mut ours, runs[0]));
        least[1] = least[1].min(batch(&mut theirs, runs[1]));
    }
    least.map(|seconds| 1e3 * seconds)
}
