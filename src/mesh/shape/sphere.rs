//! Spheres and what becomes of them when their points are moved along rays.

use std::f64::consts::{FRAC_PI_2, PI, TAU};

use glam::DVec3;

use super::hexagon::hexagon;
use super::{grid, platonic};
use crate::mesh::noise::SplitMix64;
use crate::mesh::subdivide::{SubdivisionError, linear};
use crate::soup::PolygonSoup;

/// The unit sphere from an icosahedron split `level` times, each time drawn out to the sphere.
///
/// `10·4^level + 2` vertices. Its triangles are Delaunay, so the circle-angle
/// energy is zero to roundoff.
pub fn icosphere(level: usize) -> Result<PolygonSoup, SubdivisionError> {
    (0..level).try_fold(platonic::icosahedron(), |soup, _| {
        let mut fine = linear(&soup)?;
        for p in &mut fine.positions {
            *p = p.normalize();
        }
        Ok(fine)
    })
}

/// The unit sphere by latitude and longitude: `rings` bands of `segments` cells.
pub fn uv_sphere(rings: usize, segments: usize) -> PolygonSoup {
    let mut positions = vec![DVec3::Z];
    for i in 1..rings {
        positions.extend((0..segments).map(|j| {
            spherical(
                PI * i as f64 / rings as f64,
                TAU * j as f64 / segments as f64,
            )
        }));
    }
    positions.push(-DVec3::Z);
    let (north, south) = (0, positions.len() as u32 - 1);
    let vertex = |i: usize, j: usize| 1 + i * segments + j % segments;
    let mut faces = grid::triangles(rings - 2, segments, vertex);
    for j in 0..segments {
        let last = rings - 2;
        faces.push([north, vertex(0, j) as u32, vertex(0, j + 1) as u32]);
        faces.push([south, vertex(last, j + 1) as u32, vertex(last, j) as u32]);
    }
    PolygonSoup::from_faces(positions, &faces)
}

/// The upper half of the unit sphere: `rings` rings of triangles around the pole.
pub fn hemisphere(rings: usize) -> PolygonSoup {
    let (points, faces) = hexagon(rings);
    let position = |p: &super::hexagon::LatticePoint| {
        spherical(FRAC_PI_2 * f64::from(p.ring()) / rings as f64, p.angle())
    };
    PolygonSoup::from_faces(points.iter().map(position).collect(), &faces)
}

/// The ellipsoid with semi-axes `axes`, the affine image of an icosphere whose vertices have
/// been pushed along the sphere by `jitter` edge lengths, in the mean of the squares of each
/// of two directions: from about 0.3 on some triangles turn over.
pub fn ellipsoid(
    axes: DVec3,
    level: usize,
    jitter: f64,
    seed: u64,
) -> Result<PolygonSoup, SubdivisionError> {
    let mut random = SplitMix64::new(seed);
    // Of the equilateral triangles that would cover the sphere.
    let triangles = 20.0 * 4f64.powi(level as i32);
    let edge = (16.0 * PI / (3f64.sqrt() * triangles)).sqrt();
    moved(level, |p| {
        if jitter == 0.0 {
            return p * axes;
        }
        let push = DVec3::from_array(std::array::from_fn(|_| random.gaussian()));
        let along = push - push.dot(p) * p;
        (p + jitter * edge * along).normalize() * axes
    })
}

/// Height and number of the bumps, and the seed of those, unless one asks for others.
pub const BUMPS: (f64, f64, u64) = (0.12, 6.0, 1);

/// Level of the bumpy sphere that the page opens with: 2,562 vertices.
pub const FIRST_LEVEL: usize = 4;

/// A sphere of radius `exp(amplitude·s)` with `s` a sum of twelve plane waves of random
/// direction and phase, of variance one and about `frequency` bumps a great circle.
pub fn bumpy_sphere(
    level: usize,
    amplitude: f64,
    frequency: f64,
    seed: u64,
) -> Result<PolygonSoup, SubdivisionError> {
    const WAVES: usize = 12;
    let mut random = SplitMix64::new(seed);
    let waves: [(DVec3, f64); WAVES] = std::array::from_fn(|_| {
        let direction = DVec3::from_array(std::array::from_fn(|_| random.gaussian()));
        (direction.normalize() * frequency, TAU * random.uniform())
    });
    moved(level, |p| {
        let sum: f64 = waves
            .iter()
            .map(|(k, phase)| (k.dot(p) + phase).cos())
            .sum();
        p * (amplitude * sum * (2.0 / WAVES as f64).sqrt()).exp()
    })
}

/// Two lobes and a waist: the oval of Cassini with foci `±1` on the x axis, turned about it,
/// and scaled so that it ends at `±1`; the waist has radius `waist`, `0 < waist < 1`.
pub fn dumbbell(level: usize, waist: f64) -> Result<PolygonSoup, SubdivisionError> {
    // |p - f||p + f| = b² crosses the axis at sqrt(b² + 1) and the waist plane at
    // sqrt(b² - 1); their ratio gives b.
    let b2 = (1.0 + waist * waist) / (1.0 - waist * waist);
    let length = (b2 + 1.0).sqrt();
    moved(level, |p| {
        let (cos2, sin2) = (p.x * p.x, 1.0 - p.x * p.x);
        // r² = cos 2θ + sqrt(b⁴ - sin² 2θ), with sin² 2θ = 4 sin² θ cos² θ.
        let r2 = cos2 - sin2 + (b2 * b2 - 4.0 * sin2 * cos2).sqrt();
        p * (r2.sqrt() / length)
    })
}

/// An icosphere with each point moved.
pub(super) fn moved(
    level: usize,
    mut place: impl FnMut(DVec3) -> DVec3,
) -> Result<PolygonSoup, SubdivisionError> {
    let mut soup = icosphere(level)?;
    for p in &mut soup.positions {
        *p = place(*p);
    }
    Ok(soup)
}

/// The point at polar angle `theta` and longitude `phi`.
fn spherical(theta: f64, phi: f64) -> DVec3 {
    let (sin, cos) = theta.sin_cos();
    DVec3::new(sin * phi.cos(), sin * phi.sin(), cos)
}
