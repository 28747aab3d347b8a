//! One pass: the displacement, and how much of it does no harm.

use super::RegulariseOptions;
use super::likeness::{Likeness, Property};
use super::surroundings::{inverted, smoothed};
use crate::linalg::LinalgError;
use crate::mesh::{Face, HalfedgeMesh, Vertex};
use crate::remesh::conformal::{Mode, Regulariser};
use glam::DVec3;

/// Tried one after the other until a pass does no harm: diag(K) times this is added …
const DAMPINGS: [f64; 4] = [0.0, 0.1, 1.0, 10.0];
/// … and then shares of the displacement, halved from 1 down to this.
const LEAST_SHARE: f64 = 1.0 / 16.0;

/// The smallest share of a displacement that is tried, for folds alone, before another.
const FOLDING_SHARE: f64 = 0.25;

/// How often shares are halved here and there before the next damping is tried.
const ROUNDS: usize = 16;

/// Over how many rings a share that was halved goes over into those around it.
const TAPER: usize = 2;

/// A pass that lessens CD by a smaller share than this is not worth taking.
const LEAST_GAIN: f64 = 1e-3;

/// What is done about elements that a displacement would turn over.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Folds {
    /// Less of it is tried, and no less than a quarter.
    Refuse,
    /// Their corners are held back.
    HoldBack,
}

/// What came of looking for a pass.
pub(super) enum Pass {
    /// The next positions.
    Taken(Vec<DVec3>),
    /// None are better; or some would be, but for what they lose.
    Refused(Option<Property>),
}

/// What all passes have in common.
pub(super) struct Search<'a> {
    pub(super) regulariser: &'a mut Regulariser,
    pub(super) mesh: &'a HalfedgeMesh,
    pub(super) settings: &'a RegulariseOptions,
    pub(super) damping: &'a [f64],
    pub(super) on_creases: &'a [bool],
    pub(super) likeness: &'a Likeness<'a>,
    pub(super) is_folded: bool,
}

impl Search<'_> {
    /// The next positions after `x`.
    pub(super) fn pass(&mut self, x: &[DVec3]) -> Result<Pass, LinalgError> {
        let epsilon = self.settings.epsilon;
        let distortion = (1.0 - LEAST_GAIN) * self.regulariser.distortion(x);
        let normals = smoothed(self.regulariser, x, self.on_creases);
        let folded: Vec<Face> = inverted(self.regulariser, x, &normals).collect();
        let mut lost = None;
        let mut undamped = None;
        for extra in DAMPINGS {
            let damping: Vec<f64> = self.damping.iter().map(|f| f + extra).collect();
            let mut v = self
                .regulariser
                .solve(x, &normals, epsilon, Some(&damping))?;
            if self.settings.mode == Mode::Nonlinear {
                let central = smoothed(self.regulariser, &moved(x, &v, 0.5), self.on_creases);
                v = self
                    .regulariser
                    .solve(x, &central, epsilon, Some(&damping))?;
            }
            match self.share(x, &v, distortion, &folded, Folds::Refuse) {
                Pass::Refused(why) => lost = lost.or(why),
                taken => return Ok(taken),
            }
            undamped.get_or_insert(v);
        }
        // A fold is damped better than held back, which makes others around it; but if no
        // damping prevents it, all but its surroundings may still move.
        let last = undamped.map(|v| self.share(x, &v, distortion, &folded, Folds::HoldBack));
        Ok(match last {
            Some(Pass::Refused(why)) => Pass::Refused(lost.or(why)),
            Some(taken) => taken,
            None => Pass::Refused(lost),
        })
    }

    /// The largest part of the displacements `v` from `x` that does no harm: halved around
    /// the vertices where it would, or everywhere where that is not to be told.
    fn share(
        &self,
        x: &[DVec3],
        v: &[DVec3],
        distortion: f64,
        folded: &[Face],
        folds: Folds,
    ) -> Pass {
        let mut shares = vec![1.0; x.len()];
        let mut share = 1.0;
        let mut lost = None;
        // Of a folded start: better but for a sharp angle.
        let mut sharper = None;
        for _ in 0..ROUNDS {
            let parts = x.iter().zip(v).zip(&shares);
            let trial: Vec<DVec3> = parts.map(|((x, v), s)| *x + share * s * *v).collect();
            if self.regulariser.distortion(&trial) >= distortion {
                share *= 0.5;
                if share < LEAST_SHARE {
                    break;
                }
                continue;
            }
            let mut at = self.newly_inverted(&trial, folded);
            if !at.is_empty() && folds == Folds::Refuse {
                share *= 0.5;
                if share < FOLDING_SHARE {
                    break;
                }
                continue;
            }
            if at.is_empty() {
                let mut loss = self.likeness.loss(&trial);
                if loss.is_none() {
                    loss = self.likeness.sharper(x, &trial);
                    if self.is_folded && loss.is_some() {
                        sharper = sharper.or(Some(trial.clone()));
                    }
                }
                let Some(loss) = loss else {
                    return Pass::Taken(trial);
                };
                lost = lost.or(Some(loss.of));
                at = loss.at;
                if at.is_empty() {
                    share *= 0.5;
                }
            }
            self.hold_back(&mut shares, &at);
        }
        match sharper {
            Some(trial) => Pass::Taken(trial),
            None => Pass::Refused(lost),
        }
    }

    /// Halves the shares of these vertices, and lessens those around them so that what is held
    /// back does not end abruptly.
    fn hold_back(&self, shares: &mut [f64], at: &[Vertex]) {
        let (mut at, mesh) = (at.to_vec(), self.mesh);
        at.sort_unstable();
        at.dedup();
        for v in &at {
            let share = &mut shares[v.index()];
            *share = if *share > LEAST_SHARE {
                0.5 * *share
            } else {
                0.0
            };
        }
        for _ in 0..TAPER {
            at = at
                .iter()
                .flat_map(|&v| mesh.neighbours(v))
                .chain(at.iter().copied())
                .collect();
            at.sort_unstable();
            at.dedup();
            let tapered: Vec<f64> = at
                .iter()
                .map(|&v| {
                    let (sum, count) = mesh
                        .neighbours(v)
                        .fold((0.0, 0.0), |(s, n), w| (s + shares[w.index()], n + 1.0));
                    shares[v.index()].min(sum / count)
                })
                .collect();
            for (v, share) in at.iter().zip(tapered) {
                shares[v.index()] = share;
            }
        }
    }

    /// Corners of elements inverted at `trial` but not before, if there are more than before.
    fn newly_inverted(&self, trial: &[DVec3], before: &[Face]) -> Vec<Vertex> {
        let normals = smoothed(self.regulariser, trial, self.on_creases);
        let now: Vec<Face> = inverted(self.regulariser, trial, &normals).collect();
        if now.len() <= before.len() {
            return Vec::new();
        }
        let new = now.iter().filter(|f| before.binary_search(f).is_err());
        new.flat_map(|&f| self.mesh.face_vertices(f)).collect()
    }
}

fn moved(x: &[DVec3], v: &[DVec3], share: f64) -> Vec<DVec3> {
    x.iter().zip(v).map(|(x, v)| *x + share * *v).collect()
}
