//! Area and volume kept: Lagrange multipliers for the step, projection for what is left.
//!
//! A constrained step is d + Σ λ_k u_k with u_k = H⁻¹ ∇C_k; the bordered system's Schur
//! complement ⟨∇C_j, u_k⟩ has one row a constraint, and the matrix H keeps its pattern.

use glam::DVec3;
use serde::{Deserialize, Serialize};

/// What can be kept.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum Kept {
    /// Total area.
    Area,
    /// Enclosed volume.
    Volume,
}

/// Newton's iterations in a projection, at most.
const MAX_ITERATIONS: usize = 12;
/// Relative violation of a constraint that counts as none.
const SATISFIED: f64 = 1e-13;
/// What a projection must reach for its step to be accepted.
const REQUIRED: f64 = 1e-11;
/// Two constraints whose normalised gradients have a determinant below this are one: on a
/// sphere ∇A ∥ ∇V.
const DEPENDENT: f64 = 1e-8;

/// A scalar constraint at a state: its value and gradient.
#[derive(Clone, Copy)]
pub struct Constraint<'a> {
    /// Wanted value.
    pub target: f64,
    /// Present value.
    pub value: f64,
    /// Gradient, one vector a vertex.
    pub gradient: &'a [DVec3],
}

impl Constraint<'_> {
    /// How far the value is from the target, as a share of that.
    pub fn violation(&self) -> f64 {
        (self.value - self.target).abs() / self.target.abs().max(f64::MIN_POSITIVE)
    }
}

/// ⟨a, b⟩ over all vertices.
pub fn dot(a: &[DVec3], b: &[DVec3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a.dot(*b)).sum()
}

/// λ with ⟨∇C_j, d + Σ λ_k u_k⟩ = target_j − value_j to first order; where the
/// constraints depend on each other, the least-squares solution of smallest norm.
///
/// One or two constraints; `directions` are the u_k, end to end.
pub fn multipliers(constraints: &[Constraint<'_>], d: &[DVec3], directions: &[DVec3]) -> Vec<f64> {
    let n = d.len();
    let rows: Vec<Vec<f64>> = constraints
        .iter()
        .map(|c| {
            directions
                .chunks_exact(n)
                .map(|u| dot(c.gradient, u))
                .collect()
        })
        .collect();
    let rhs: Vec<f64> = constraints
        .iter()
        .map(|c| c.target - c.value - dot(c.gradient, d))
        .collect();
    solve_small(&rows, &rhs)
}

/// Moves `x` along the directions until the constraints hold; `evaluate` tells them at a
/// state. Whether it succeeded.
pub fn project(
    x: &mut [DVec3],
    directions: &[DVec3],
    mut evaluate: impl FnMut(&[DVec3], &mut dyn FnMut(&[Constraint<'_>])),
) -> bool {
    let n = x.len();
    for iteration in 0..=MAX_ITERATIONS {
        let mut correction = Vec::new();
        let mut worst = 0.0;
        evaluate(x, &mut |constraints| {
            worst = constraints
                .iter()
                .map(Constraint::violation)
                .fold(0.0, f64::max);
            if worst > SATISFIED {
                let zero = vec![DVec3::ZERO; n];
                correction = multipliers(constraints, &zero, directions);
            }
        });
        if !worst.is_finite() {
            return false;
        }
        if worst <= SATISFIED || iteration == MAX_ITERATIONS {
            return worst <= REQUIRED;
        }
        for (lambda, u) in correction.iter().zip(directions.chunks_exact(n)) {
            x.iter_mut().zip(u).for_each(|(x, u)| *x += *lambda * *u);
        }
    }
    false
}

/// Solves a system of one or two rows, scaled to a unit diagonal first.
fn solve_small(rows: &[Vec<f64>], rhs: &[f64]) -> Vec<f64> {
    match (rows, rhs) {
        ([row], [r]) => vec![if row[0] == 0.0 { 0.0 } else { r / row[0] }],
        ([p, q], [r, s]) => {
            let scale = [p[0].abs().sqrt(), q[1].abs().sqrt()];
            if scale.contains(&0.0) {
                return vec![0.0, 0.0];
            }
            let [a, b] = [p[0] / scale[0].powi(2), p[1] / (scale[0] * scale[1])];
            let [c, d] = [q[0] / (scale[0] * scale[1]), q[1] / scale[1].powi(2)];
            let (r, s) = (r / scale[0], s / scale[1]);
            let determinant = a * d - b * c;
            let solution = if determinant.abs() > DEPENDENT {
                [(d * r - b * s) / determinant, (a * s - c * r) / determinant]
            } else {
                // The pseudo-inverse of a matrix of rank one.
                let size = a * a + b * b + c * c + d * d;
                [(a * r + c * s) / size, (b * r + d * s) / size]
            };
            vec![solution[0] / scale[0], solution[1] / scale[1]]
        }
        _ => Vec::new(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn dependent_rows_have_the_smallest_solution() {
        let close = |a: &[f64], b: [f64; 2]| a.iter().zip(b).all(|(a, b)| (a - b).abs() < 1e-12);
        let regular = solve_small(&[vec![4.0, 1.0], vec![1.0, 9.0]], &[6.0, 19.0]);
        assert!(close(&regular, [1.0, 2.0]), "{regular:?}");
        let twice = solve_small(&[vec![1.0, 2.0], vec![2.0, 4.0]], &[3.0, 6.0]);
        // Smallest once the rows are scaled to a unit diagonal.
        assert!(close(&twice, [1.5, 0.75]), "{twice:?}");
        // Nearly dependent: what they disagree about is not blown up.
        let nearly = solve_small(&[vec![1.0, 2.0], vec![2.0, 4.0 + 1e-9]], &[3.0, 6.0 + 1e-6]);
        assert!(
            (nearly[0] - 1.5).abs() < 1e-5 && (nearly[1] - 0.75).abs() < 1e-5,
            "{nearly:?}"
        );
        assert_eq!(solve_small(&[vec![2.0]], &[3.0]), [1.5]);
        assert!(solve_small(&[], &[]).is_empty());
    }

    #[test]
    fn a_projection_meets_two_constraints_and_admits_defeat() {
        // Vertices on a line: Σ x = 3 and Σ y² = 2.
        let start = vec![DVec3::new(0.3, 0.9, 0.0), DVec3::new(1.2, 0.4, 0.0)];
        let directions = [vec![DVec3::X; 2], vec![DVec3::Y; 2]].concat();
        let run = |target: f64, x: &mut Vec<DVec3>| {
            project(x, &directions, |x, take| {
                let sum: f64 = x.iter().map(|p| p.x).sum();
                let squares: f64 = x.iter().map(|p| p.y * p.y).sum();
                let slopes: Vec<DVec3> = x.iter().map(|p| 2.0 * p.y * DVec3::Y).collect();
                take(&[
                    Constraint {
                        target: 3.0,
                        value: sum,
                        gradient: &[DVec3::X; 2],
                    },
                    Constraint {
                        target,
                        value: squares,
                        gradient: &slopes,
                    },
                ]);
            })
        };
        let mut x = start.clone();
        assert!(run(2.0, &mut x));
        assert!((x[0].x + x[1].x - 3.0).abs() < 1e-12);
        assert!((x[0].y.powi(2) + x[1].y.powi(2) - 2.0).abs() < 1e-12);
        // The directions keep y₀ − y₁, and with it Σ y² ≥ 0.125.
        assert!(!run(0.01, &mut start.clone()));
    }
}
