//! Relaxation: vertices slide along the surface towards the middle of what they stand for.
//!
//! The goal is the mean of the centroids of the faces at a vertex, weighted with A/h² so that
//! faces come to their wanted sizes; the way there stays on the fitted quadric. Moved in the
//! tangent plane alone, a sphere would lose volume in every sweep.

use super::draft::Draft;
use super::quadric;
use crate::interrupt::paced;
use glam::DVec3;

/// Sweeps of a round.
const SWEEPS: usize = 3;
/// Share of the way to the goal, and the longest way over the wanted edge length.
const DAMPING: f64 = 0.8;
const LONGEST: f64 = 0.3;

/// Slides the vertices that are not held.
pub(super) fn run(draft: &mut Draft) {
    let rings = draft.rings();
    for _ in 0..SWEEPS {
        let normals = draft.normals();
        let quadrics = quadric::fits(&draft.x, &rings, &normals);
        let before = draft.x.clone();
        for (v, quadric) in paced(quadrics.iter().enumerate()) {
            if draft.held[v] {
                continue;
            }
            let goal = goal(draft, &before, v);
            let longest = DAMPING * LONGEST * draft.size[v];
            draft.x[v] = before[v] + quadric.along(DAMPING * (goal - before[v]), longest);
        }
    }
}

fn goal(draft: &Draft, x: &[DVec3], v: usize) -> DVec3 {
    let (mut sum, mut total) = (DVec3::ZERO, 0.0);
    for &f in &draft.star[v] {
        let corners = draft.faces[f as usize];
        let [a, b, c] = corners.map(|u| x[u as usize]);
        let size: f64 = corners.iter().map(|&u| draft.size[u as usize]).sum();
        let weight = (b - a).cross(c - a).length() / size.powi(2);
        sum += weight * (a + b + c) / 3.0;
        total += weight;
    }
    if total > 0.0 { sum / total } else { x[v] }
}
