//! How long edges should be: short where the surface bends, within a number of vertices.
//!
//! ρ = 1/√(κ² + L⁻²) with κ the larger principal curvature by absolute value and
//! L = √(A/4π); averaged once over neighbours, by logarithms; h = sρ, made to change by at
//! most 0.3 a unit of length, with s such that Σ A_i/(√3/2 h_i²) is the number of vertices.
//! Then κh ≈ √((∫κ² + 4π)/(0.87 N)) all over the surface. Isotropic meshes have one h.

use super::Kind;
use super::draft::Draft;
use super::quadric;
use crate::interrupt::paced;
use std::f64::consts::PI;

/// Growth of h per unit of length.
const GRADATION: f64 = 0.3;
/// Area a vertex of a mesh of equilateral triangles, over the square of their edges.
const AREA_OF_VERTEX: f64 = 0.866_025_403_784_438_6;
/// Rounds of the fixed point for s, and of the gradation in each, at most.
const ROUNDS: usize = 12;
const SWEEPS: usize = 20;
/// The budget is met to this share.
const MET: f64 = 0.005;

/// The length of equilateral triangles' edges if so many vertices share an area.
pub(super) fn even_length(area: f64, vertices: f64) -> f64 {
    (area / (AREA_OF_VERTEX * vertices)).sqrt()
}

/// Number of vertices of equilateral triangles with edges of a length on an area.
fn even_count(area: f64, length: f64) -> f64 {
    area / (AREA_OF_VERTEX * length * length)
}

/// How many vertices stay whatever there is around them.
pub(super) fn held(draft: &Draft) -> usize {
    (0..draft.x.len()).filter(|&v| draft.is_fixed(v)).count()
}

/// The area of those that are not.
fn free_area(draft: &Draft, areas: &[f64]) -> f64 {
    let free = (0..areas.len()).filter(|&v| !draft.is_fixed(v));
    free.map(|v| areas[v]).sum()
}

/// Number of vertices with edges of a length between those that are not held.
pub(super) fn count(draft: &Draft, length: f64) -> f64 {
    held(draft) as f64 + even_count(free_area(draft, &draft.areas()), length)
}

/// Wanted edge length at each vertex for `vertices` of them, the held ones included.
pub(super) fn field(draft: &Draft, kind: Kind, vertices: usize) -> Vec<f64> {
    let areas = draft.areas();
    let budget = vertices.saturating_sub(held(draft)).max(1) as f64;
    let even = even_length(free_area(draft, &areas), budget);
    if kind == Kind::Isotropic {
        return vec![even; draft.x.len()];
    }
    let rings = draft.rings();
    let radii = radii(draft, &rings, areas.iter().sum());
    let mut scale = 1.0;
    let mut field = radii.clone();
    for _ in 0..ROUNDS {
        for (h, radius) in field.iter_mut().zip(&radii) {
            *h = scale * radius;
        }
        grade(&mut field, draft, &rings);
        let free = (0..areas.len()).filter(|&v| !draft.is_fixed(v));
        let count: f64 = free.map(|v| even_count(areas[v], field[v])).sum();
        let factor = (count / budget).sqrt();
        if !factor.is_finite() || (factor - 1.0).abs() < MET {
            break;
        }
        scale *= factor;
    }
    field
}

fn radii(draft: &Draft, rings: &[Vec<u32>], area: f64) -> Vec<f64> {
    let flat = 4.0 * PI / area;
    let quadrics = quadric::fits(&draft.x, rings, &draft.normal);
    let logs: Vec<f64> = quadrics
        .iter()
        .zip(&draft.creased)
        // On an edge of the shape there is no curvature.
        .map(|(q, creased)| if *creased { 0.0 } else { q.bend() })
        .map(|bend| -0.5 * (bend.powi(2) + flat).ln())
        .collect();
    let mean = |(ring, log): (&Vec<u32>, &f64)| {
        let sum: f64 = ring.iter().map(|&j| logs[j as usize]).sum();
        (0.5 * (log + sum / ring.len().max(1) as f64)).exp()
    };
    rings.iter().zip(&logs).map(mean).collect()
}

/// Lowers lengths until none is more than the gradation above a neighbour's.
fn grade(field: &mut [f64], draft: &Draft, rings: &[Vec<u32>]) {
    for _ in 0..SWEEPS {
        let mut is_settled = true;
        for (i, ring) in paced(rings.iter().enumerate()) {
            for &j in ring {
                let limit = field[j as usize] + GRADATION * draft.x[i].distance(draft.at(j));
                if field[i] > limit * 1.0001 {
                    field[i] = limit;
                    is_settled = false;
                }
            }
        }
        if is_settled {
            break;
        }
    }
}
