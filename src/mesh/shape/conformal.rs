//! Meshes of surfaces that a conformal map of the sphere gives.
//!
//! Points are spread over the sphere with the density λ²(|A|² + L⁻²), λ the map's stretch, |A|²
//! = κ₁² + κ₂² and L = √(A/4π): so edges are as short as the surface bends, and as the map keeps
//! angles the Delaunay triangles of the points are good ones of the surface. Lloyd's iteration
//! moves each point to the centroid of its triangles, weighted with the density squared.

use super::delaunay::triangles;
use crate::mesh::noise::SplitMix64;
use crate::soup::PolygonSoup;
use glam::{DVec2, DVec3};
use std::f64::consts::PI;

/// Points that the density is first drawn from, per vertex.
const CANDIDATES: usize = 12;
/// Rounds of Lloyd's iteration, the last of them without overrelaxation.
const ROUNDS: usize = 45;
const PLAIN_ROUNDS: usize = 10;
const OVERRELAXATION: f64 = 1.3;
/// Step of the finite differences for λ and A, of which the density alone depends.
const STEP: f64 = 2e-4;

/// A conformal map from the sphere, in homogeneous coordinates: z = a/b as a, b.
pub(super) type Map<'a> = &'a dyn Fn(DVec2, DVec2) -> DVec3;

/// Homogeneous coordinates of a point of the unit sphere, by projection from the nearer pole:
/// one of them is 1, the other at most 1.
pub(super) fn coordinates(p: DVec3) -> (DVec2, DVec2) {
    let w = DVec2::new(p.x, p.y) / (1.0 + p.z.abs());
    if p.z > 0.0 {
        (DVec2::X, DVec2::new(w.x, -w.y))
    } else {
        (w, DVec2::X)
    }
}

/// The surface at a point of the sphere.
pub(super) struct Place {
    /// λ², the stretch of areas against the sphere.
    stretch: f64,
    /// |A|² = κ₁² + κ₂².
    pub(super) bend: f64,
    /// Unit normal, on the side that the faces show.
    pub(super) normal: DVec3,
}

/// By finite differences.
pub(super) fn place(map: Map<'_>, p: DVec3) -> Place {
    let (a, b) = coordinates(p);
    let at = |x: f64, y: f64| {
        let shift = STEP * DVec2::new(x, y);
        if p.z > 0.0 {
            map(a, b + shift)
        } else {
            map(a + shift, b)
        }
    };
    let f = at(0.0, 0.0);
    let [e, w, n, s] = [at(1.0, 0.0), at(-1.0, 0.0), at(0.0, 1.0), at(0.0, -1.0)];
    let (fx, fy) = ((e - w) / (2.0 * STEP), (n - s) / (2.0 * STEP));
    let square = STEP * STEP;
    let (fxx, fyy) = ((e + w - 2.0 * f) / square, (n + s - 2.0 * f) / square);
    let corners = at(1.0, 1.0) - at(1.0, -1.0) - at(-1.0, 1.0) + at(-1.0, -1.0);
    let fxy = corners / (4.0 * square);
    // Seen from outside the sphere, the coordinates run clockwise.
    let normal = fy.cross(fx).normalize_or_zero();
    let metric = 0.5 * (fx.length_squared() + fy.length_squared());
    let second = [fxx, fxy, fyy].map(|d| d.dot(normal));
    let squares = second[0].powi(2) + 2.0 * second[1].powi(2) + second[2].powi(2);
    let plane = if p.z > 0.0 { b } else { a };
    let sphere = 2.0 / (1.0 + plane.length_squared());
    Place {
        stretch: metric / sphere.powi(2),
        bend: squares / metric.powi(2).max(f64::MIN_POSITIVE),
        normal,
    }
}

deferred! {
    /// Points of the sphere for a mesh of the image with so many vertices; with `antipodal` each
    /// point of the first half has its opposite at the same place of the second.
    pub(super) fn points(map: Map<'_>, count: usize, antipodal: bool) -> Vec<DVec3> {
        let mut random = SplitMix64::new(1);
        let mut on_sphere =
            || DVec3::from_array(std::array::from_fn(|_| random.gaussian())).normalize_or(DVec3::Z);
        let candidates: Vec<DVec3> = (0..CANDIDATES * count).map(|_| on_sphere()).collect();
        let found: Vec<_> = candidates.iter().map(|p| place(map, *p)).collect();
        let area = 4.0 * PI * found.iter().map(|f| f.stretch).sum::<f64>() / found.len() as f64;
        let flat = 4.0 * PI / area;
        let density = |p: DVec3| {
            let found = place(map, p);
            found.stretch * (found.bend + flat)
        };
        let distinct = if antipodal { count / 2 } else { count };
        let mut points = drawn(&candidates, &found, flat, distinct);
        for round in 0..ROUNDS {
            if antipodal {
                points.truncate(distinct);
                points.extend_from_within(..);
                points[distinct..].iter_mut().for_each(|p| *p = -*p);
            }
            let factor = if round + PLAIN_ROUNDS < ROUNDS {
                OVERRELAXATION
            } else {
                1.0
            };
            points = relaxed(&points, &density, factor);
        }
        if antipodal {
            for i in 0..distinct {
                points[distinct + i] = -points[i];
            }
        }
        points
    }
}

/// Candidates at equal distances of the sum of their densities, in an order without a pattern.
fn drawn(candidates: &[DVec3], found: &[Place], flat: f64, count: usize) -> Vec<DVec3> {
    let weights: Vec<f64> = found
        .iter()
        .map(|found| found.stretch * (found.bend + flat))
        .collect();
    let share = weights.iter().sum::<f64>() / count as f64;
    let (mut points, mut sum) = (Vec::with_capacity(count), 0.0);
    for (p, weight) in candidates.iter().zip(weights) {
        sum += weight;
        // A candidate of great weight stands for itself only.
        if sum >= (points.len() as f64 + 0.5) * share && points.len() < count {
            points.push(*p);
        }
    }
    let spare = candidates.iter().rev().take(count - points.len());
    points.extend(spare.copied());
    points
}

fn relaxed(points: &[DVec3], density: &dyn Fn(DVec3) -> f64, factor: f64) -> Vec<DVec3> {
    let mut sums = vec![(DVec3::ZERO, 0.0); points.len()];
    for t in triangles(points) {
        let [a, b, c] = t.map(|v| points[v as usize]);
        let centre = (a + b + c).normalize_or(a);
        let weight = (b - a).cross(c - a).length() * density(centre).powi(2);
        for v in t {
            let (sum, total) = &mut sums[v as usize];
            *sum += weight * centre;
            *total += weight;
        }
    }
    let moved = |(p, (sum, total)): (&DVec3, (DVec3, f64))| {
        let goal = if total > 0.0 { sum / total } else { *p };
        (*p + factor * (goal - *p)).normalize_or(*p)
    };
    points.iter().zip(sums).map(moved).collect()
}

/// The image of the Delaunay triangles of points.
pub(super) fn image(map: Map<'_>, points: &[DVec3]) -> PolygonSoup {
    let at = |p: &DVec3| {
        let (a, b) = coordinates(*p);
        map(a, b)
    };
    PolygonSoup::from_faces(points.iter().map(at).collect(), &triangles(points))
}
