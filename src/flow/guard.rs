//! Tests of a trial that cost little beside the functional, the same for all flows.

use super::refusal::farthest;
use super::rules::{Folds, Rules};
use super::{Cause, Refusal};
use crate::geometry::{measure, quality};
use crate::mesh::HalfedgeMesh;
use glam::DVec3;

/// A trial that folds over more than this share of the faces is refused, where few may fold.
const FOLDED_SHARE: f64 = 1e-5;
/// The rules' least angle holds for meshes whose smallest angle at the start is this, in
/// degrees; of worse ones less is asked, in proportion.
const GOOD_ANGLE: f64 = 30.0;
/// In one step an angle below that may still fall to this share of what it was …
const ANGLE_SHARE: f64 = 0.7;
/// … but not below this share of the least.
const LAST_SHARE: f64 = 0.2;
/// A move that is shortened to what is allowed keeps this distance from it.
const SAFETY: f64 = 0.95;
/// Edges at a vertex count as no shorter than this share of the mean of all: where triangles
/// are tiny they move along with the rest.
const LEAST_REACH: f64 = 0.5;

/// What trials from one state are compared with.
pub(super) struct Guard {
    rules: Rules,
    /// Mean length of the edges at each vertex, where moves are limited by it.
    reach: Vec<f64>,
    /// Smallest angle that a trial may have.
    angle_floor: Option<f64>,
    /// Trials that were refused for folds.
    fold_refusals: usize,
}

/// A trial is refused for folds at most so many times a step, where few may fold.
const MAX_FOLD_REFUSALS: usize = 3;

impl Guard {
    /// For trials from `x`; the smallest angle at the start of the run was `start_angle`
    /// degrees, and is `angle` at `x`.
    pub(super) fn new(
        rules: Rules,
        mesh: &HalfedgeMesh,
        x: &[DVec3],
        [start_angle, angle]: [f64; 2],
    ) -> Self {
        let mut reach = Vec::new();
        if rules.reach.is_some() {
            reach = measure::mean_edge_lengths(mesh, x);
            let floor = LEAST_REACH * measure::mean_edge_length(mesh, x);
            reach.iter_mut().for_each(|h| *h = h.max(floor));
        }
        Self {
            rules,
            reach,
            angle_floor: rules
                .least_angle
                .map(|least| least * (start_angle / GOOD_ANGLE).min(1.0))
                .map(|least| {
                    least
                        .min((ANGLE_SHARE * angle).max(LAST_SHARE * least))
                        .min(angle)
                }),
            fold_refusals: 0,
        }
    }

    /// Before anything dear is computed: whether the trial is finite and not too far.
    pub(super) fn check_distance(&self, x: &[DVec3], y: &[DVec3]) -> Result<(), Refusal> {
        if !y.iter().all(|p| p.is_finite()) {
            return Err(Refusal::of(Cause::NotFinite));
        }
        let Some(most) = self.rules.reach else {
            return Ok(());
        };
        let (vertex, moved) = farthest(x, y, |v| self.reach[v]);
        if moved <= most {
            return Ok(());
        }
        Err(Refusal {
            ratio: Some(SAFETY * most / moved),
            ..Refusal::at(Cause::TooFar, vertex)
        })
    }

    /// Whether the mesh would still be a good one.
    pub(super) fn check_mesh(
        &mut self,
        mesh: &HalfedgeMesh,
        x: &[DVec3],
        y: &[DVec3],
    ) -> Result<(), Refusal> {
        let refuse = |cause, face| {
            Err(Refusal {
                face: Some(face),
                ..Refusal::of(cause)
            })
        };
        if let Some(cosine) = self.rules.turn
            && let Some(face) = turning(mesh, x, y, cosine)
        {
            return refuse(Cause::Turn, face);
        }
        let allowed = match self.rules.folds {
            Folds::None => 0.0,
            Folds::Few if self.fold_refusals < MAX_FOLD_REFUSALS => {
                FOLDED_SHARE * mesh.n_faces() as f64
            }
            Folds::Few | Folds::Any => f64::INFINITY,
        };
        if allowed.is_finite() && mesh.is_triangular() {
            let folded = quality::newly_folded(mesh, x, y);
            if folded.len() as f64 > allowed {
                self.fold_refusals += 1;
                return refuse(Cause::Fold, folded[0].0);
            }
        }
        if let Some(floor) = self.angle_floor
            && let Some((face, angle)) = measure::sharpest_face(mesh, y)
            && angle < floor
        {
            return refuse(Cause::Sliver, face.0);
        }
        Ok(())
    }
}

/// The first face whose normal turns by an angle with a smaller cosine. A collapsed face has
/// no normal to turn.
pub(crate) fn turning(mesh: &HalfedgeMesh, x: &[DVec3], y: &[DVec3], cosine: f64) -> Option<u32> {
    let turns = |f: &crate::mesh::Face| {
        let [a, b] = [x, y].map(|x| measure::face_vector_area(mesh, x, *f));
        a != DVec3::ZERO && a.normalize_or_zero().dot(b.normalize_or_zero()) < cosine
    };
    mesh.faces().find(turns).map(|f| f.0)
}
