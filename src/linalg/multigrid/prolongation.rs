//! How a field on a coarse level is carried to the next finer one.
//!
//! The value at a point is that of the plane fitted to the values at the nearest coarse points by
//! moving least squares (Lancaster and Šalkauskas [LS81](crate::bibliography#ls81)), so that
//! linear functions are carried over, and with them what a bending matrix nearly annihilates. The
//! positions need only tell who is near whom: those at the start of a flow do for all of it.

use super::coarsening::NONE;
use super::rows::Rows;
use crate::interrupt;
use crate::linalg::ordering::Graph;
use crate::order;
use glam::{DMat4, DVec3, DVec4};

/// Coarse points a value is taken from: more fill the coarser matrices and spare no iterations.
const POINTS: usize = 4;
/// Rings that are searched for them.
const RINGS: usize = 4;
/// Square of the radius at which the weights vanish, over that of the farthest point.
const REACH: f64 = 1.2;
/// What weighs at least: the farthest of the points still counts.
const LEAST_WEIGHT: f64 = 1e-6;
/// Share of the squared slopes' weight that flattens the plane: the points lie close to one
/// themselves, which leaves the slope across it open.
const FLATTENING: f64 = 3e-3;

/// The weights, a row for each fine row: rows that stay take their own value, those without a
/// coarse neighbour none, nor all from where the work is given up. All others add up to one.
pub(super) fn prolongation(
    graph: &Graph,
    points: &[DVec3],
    numbers: &[u32],
    n_coarse: usize,
) -> Rows {
    let mut search = Search {
        seen_from: vec![NONE; graph.n()],
        queue: Vec::new(),
        near: Vec::new(),
    };
    let mut rows = Rows::empty(n_coarse);
    let mut goes_on = true;
    for i in 0..graph.n() as u32 {
        if i.is_multiple_of(1024) {
            goes_on = interrupt::check().is_ok();
        }
        if !goes_on {
            rows.end_row();
            continue;
        }
        if numbers[i as usize] != NONE {
            rows.push(numbers[i as usize], 1.0);
            rows.end_row();
            continue;
        }
        search.nearest(graph, points, numbers, i);
        let near = &mut search.near;
        let weights = weights(
            points[i as usize],
            near.iter().map(|n| points[n.1 as usize]),
        );
        let mut row: Vec<(u32, f64)> = near
            .iter()
            .map(|&(_, j)| numbers[j as usize])
            .zip(weights)
            .collect();
        order::sort_by_key(&mut row, |entry| entry.0);
        for (c, weight) in row {
            rows.push(c, weight as f32);
        }
        rows.end_row();
    }
    rows
}

/// Breadth-first search for coarse rows, with the memory it needs.
struct Search {
    /// The row from which each was last found.
    seen_from: Vec<u32>,
    queue: Vec<u32>,
    /// Squared distance and row.
    near: Vec<(f64, u32)>,
}

impl Search {
    /// Writes the nearest coarse rows, of as many rings as are needed, into `near`.
    fn nearest(&mut self, graph: &Graph, points: &[DVec3], numbers: &[u32], i: u32) {
        self.near.clear();
        self.queue.clear();
        self.queue.push(i);
        self.seen_from[i as usize] = i;
        let mut ring_start = 0;
        for _ in 0..RINGS {
            let ring_end = self.queue.len();
            for k in ring_start..ring_end {
                for &j in graph.neighbours(self.queue[k]) {
                    if std::mem::replace(&mut self.seen_from[j as usize], i) == i {
                        continue;
                    }
                    self.queue.push(j);
                    if numbers[j as usize] != NONE {
                        let distance = points[i as usize].distance_squared(points[j as usize]);
                        self.near.push((distance, j));
                    }
                }
            }
            ring_start = ring_end;
            if self.near.len() >= POINTS {
                break;
            }
        }
        let order = |a: &(f64, u32), b: &(f64, u32)| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1));
        self.near.sort_unstable_by(order);
        self.near.truncate(POINTS);
    }
}

/// The weights of the values at `near` in the value at `p` of the plane fitted to them: with
/// φ = (1, Δx/h), ω = (1 − |Δx|²/h²)² and G = Σ ω φ φᵀ they are ω φᵀ G⁻¹ e₀. As only the slopes
/// are damped, the first row of G c = e₀ says that they add up to one.
fn weights(
    p: DVec3,
    near: impl Iterator<Item = DVec3> + Clone,
) -> impl Iterator<Item = f64> + Clone {
    let farthest = near
        .clone()
        .map(|q| q.distance_squared(p))
        .fold(0.0, f64::max);
    // Where all points are one, any positive radius will do.
    let h = (REACH * farthest).sqrt().max(f64::MIN_POSITIVE);
    let terms = near.map(move |q| {
        let d = (q - p) / h;
        let omega = (1.0 - d.length_squared()).powi(2) + LEAST_WEIGHT;
        (omega, DVec4::new(1.0, d.x, d.y, d.z))
    });
    let mut gram = DMat4::ZERO;
    for (omega, phi) in terms.clone() {
        let [a, b, c, d] = (omega * phi).to_array();
        gram += DMat4::from_cols(a * phi, b * phi, c * phi, d * phi);
    }
    let slopes = gram.y_axis.y + gram.z_axis.z + gram.w_axis.w;
    let damping = FLATTENING * slopes + f64::EPSILON.sqrt();
    gram += DMat4::from_diagonal(DVec4::new(0.0, damping, damping, damping));
    let coefficients = gram.inverse().x_axis;
    terms.map(move |(omega, phi)| omega * phi.dot(coefficients))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn weights_at(p: DVec3, near: &[DVec3]) -> Vec<f64> {
        weights(p, near.iter().copied()).collect()
    }

    #[test]
    fn weights_add_up_to_one_whatever_the_points() {
        let flat = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::new(1.0, 1.0, 1e-3)];
        let sliver = [DVec3::X, 1e-3 * DVec3::Y, DVec3::NEG_X, 1e3 * DVec3::X];
        let one = [DVec3::ONE; 4];
        for near in [&flat[..], &flat[..1], &flat[..2], &sliver, &one] {
            for p in [DVec3::new(0.3, 0.4, 0.0), DVec3::ONE] {
                let sum: f64 = weights_at(p, near).iter().sum();
                assert!((sum - 1.0).abs() < 1e-7, "{sum} at {p} of {near:?}");
            }
        }
    }

    #[test]
    fn linear_functions_are_carried_over_but_for_the_flattening() {
        let near = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::new(1.1, 0.9, 0.0)];
        let p = DVec3::new(0.4, 0.45, 0.0);
        let linear = |q: DVec3| 2.0 + 3.0 * q.x - q.y;
        let value: f64 = near
            .iter()
            .zip(weights_at(p, &near))
            .map(|(q, w)| w * linear(*q))
            .sum();
        assert!((value - linear(p)).abs() < 0.03, "{value}");
    }
}
