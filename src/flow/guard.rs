//! Tests of a trial that cost little beside the functional, the same for all flows.

use super::refusal::farthest;
use super::rules::{Folds, Rules};
use super::{Cause, Refusal};
use crate::geometry::{measure, quality};
use crate::interrupt::paced;
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
    paced(mesh.faces()).find(turns).map(|f| f.0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Built, build, shape};

    fn ball() -> Built {
        let ball = shape::make("icosphere", &[("level".into(), 2.0)]).expect("a shape");
        build(&ball.soup).expect("a surface")
    }

    fn all() -> Rules {
        Rules {
            reach: Some(0.5),
            turn: Some(0.5),
            folds: Folds::None,
            least_angle: Some(5.0),
            ..Rules::unseen()
        }
    }

    /// With vertex 0 moved by so many of its edges along its normal and along the first edge.
    fn moved(s: &Built, out: f64, along: f64) -> Vec<DVec3> {
        let mut y = s.positions.clone();
        let h = measure::mean_edge_lengths(&s.mesh, &y)[0];
        let mut neighbours = s.mesh.neighbours(crate::mesh::Vertex(0));
        let edge = y[neighbours.next().expect("a neighbour").index()] - y[0];
        let n = y[0].normalize();
        y[0] += out * h * n + along * edge;
        y
    }

    #[test]
    fn a_move_too_far_is_shortened_to_just_below_what_is_allowed() {
        let s = ball();
        let x = &s.positions;
        let guard = Guard::new(all(), &s.mesh, x, [60.0, 50.0]);
        assert!(guard.check_distance(x, &moved(&s, 0.499, 0.0)).is_ok());
        let refusal = guard.check_distance(x, &moved(&s, 2.0, 0.0));
        let refusal = refusal.expect_err("too far");
        assert_eq!((refusal.cause, refusal.vertex), (Cause::TooFar, 0));
        let ratio = refusal.ratio.expect("known");
        assert!((ratio - 0.95 * 0.25).abs() < 1e-12, "{ratio}");
        let mut y = x.clone();
        y[3].x = f64::NAN;
        let refusal = guard.check_distance(x, &y).expect_err("not finite");
        assert_eq!(refusal.cause, Cause::NotFinite);
        // Far from all others an edge counts as at least half the mean.
        let mut tiny = x.clone();
        let first = tiny[0];
        for v in s.mesh.neighbours(crate::mesh::Vertex(0)) {
            tiny[v.index()] = first + 1e-3 * (tiny[v.index()] - first);
        }
        let guard = Guard::new(all(), &s.mesh, &tiny, [60.0, 50.0]);
        let mean = measure::mean_edge_length(&s.mesh, &tiny);
        let mut y = tiny.clone();
        y[0] += 0.24 * mean * first.normalize();
        assert!(guard.check_distance(&tiny, &y).is_ok());
    }

    #[test]
    fn what_spoils_the_mesh_is_refused_by_its_cause() {
        let s = ball();
        let cause = |rules: Rules, y: &[DVec3]| {
            let mut guard = Guard::new(rules, &s.mesh, &s.positions, [60.0, 50.0]);
            guard
                .check_mesh(&s.mesh, &s.positions, y)
                .err()
                .map(|r| r.cause)
        };
        assert_eq!(cause(all(), &moved(&s, 0.1, 0.1)), None);
        // A peak of 1.5 edges stands at more than 60°, and folds nothing.
        let peak = moved(&s, 2.5, 0.0);
        assert_eq!(cause(all(), &peak), Some(Cause::Turn));
        let any_turn = Rules {
            turn: None,
            ..all()
        };
        assert_eq!(cause(any_turn, &peak), None);
        // Beyond its neighbour, faces fold.
        let fold = moved(&s, 0.0, 1.6);
        assert_eq!(cause(any_turn, &fold), Some(Cause::Fold));
        // Close to its neighbour, a face becomes a sliver.
        let sliver = moved(&s, 0.0, 0.95);
        assert_eq!(cause(all(), &sliver), Some(Cause::Sliver));
        let any_angle = Rules {
            least_angle: None,
            ..all()
        };
        assert_eq!(cause(any_angle, &sliver), None);
    }

    #[test]
    fn few_folds_are_refused_three_times_and_then_let_pass() {
        let s = ball();
        let rules = Rules {
            folds: Folds::Few,
            ..Rules::unseen()
        };
        let mut guard = Guard::new(rules, &s.mesh, &s.positions, [60.0, 50.0]);
        let fold = moved(&s, 0.0, 1.6);
        let mut check = || guard.check_mesh(&s.mesh, &s.positions, &fold).is_ok();
        assert_eq!(
            [check(), check(), check(), check()],
            [false, false, false, true]
        );
    }

    /// A mesh that starts with slivers may keep them, and one under way may lose a little.
    #[test]
    fn the_least_angle_falls_with_that_of_the_mesh() {
        let s = ball();
        let floor = |start: f64, angle: f64| {
            let guard = Guard::new(all(), &s.mesh, &s.positions, [start, angle]);
            guard.angle_floor.expect("a floor")
        };
        for (start, angle, expected) in [
            (60.0, 50.0, 5.0),
            (15.0, 15.0, 2.5),
            (60.0, 4.0, 2.8),
            (60.0, 1.2, 1.0),
            (60.0, 0.3, 0.3),
        ] {
            let found = floor(start, angle);
            assert!(
                (found - expected).abs() < 1e-12,
                "{start}, {angle}: {found}"
            );
        }
    }
}
