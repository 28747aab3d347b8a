//! Surfaces with boundary, as graphs or rolled up.

use std::f64::consts::TAU;

use glam::DVec3;

use super::grid;
use super::hexagon::{LatticePoint, hexagon};
use crate::soup::PolygonSoup;

/// The flat unit disk, `rings` rings of triangles around the centre.
pub fn disk(rings: usize) -> PolygonSoup {
    over_disk(rings, |_, _| 0.0)
}

/// The monkey saddle `z = height (x³ - 3xy²)` over the unit disk.
pub fn monkey_saddle(rings: usize, height: f64) -> PolygonSoup {
    over_disk(rings, |x, y| height * (x * x * x - 3.0 * x * y * y))
}

/// The hyperbolic paraboloid `z = height (x² - y²)` over the square `[-1, 1]²` of `cells`²
/// cells; its four sides are parabolas.
pub fn hyperbolic_paraboloid(cells: usize, height: f64) -> PolygonSoup {
    let coordinate = |i: usize| 2.0 * i as f64 / cells as f64 - 1.0;
    let positions = (0..(cells + 1) * (cells + 1)).map(|k| {
        let (x, y) = (coordinate(k / (cells + 1)), coordinate(k % (cells + 1)));
        DVec3::new(x, y, height * (x * x - y * y))
    });
    let faces = grid::triangles(cells, cells, |i, j| i * (cells + 1) + j);
    PolygonSoup::from_faces(positions.collect(), &faces)
}

/// The open cylinder of radius 1 about z, centred, `around` x `along` cells.
pub fn cylinder(length: f64, around: usize, along: usize) -> PolygonSoup {
    let positions = (0..around * (along + 1)).map(|k| {
        let u = TAU * (k / (along + 1)) as f64 / around as f64;
        let z = length * ((k % (along + 1)) as f64 / along as f64 - 0.5);
        DVec3::new(u.cos(), u.sin(), z)
    });
    let faces = grid::triangles(around, along, |i, j| i % around * (along + 1) + j);
    PolygonSoup::from_faces(positions.collect(), &faces)
}

fn over_disk(rings: usize, height: impl Fn(f64, f64) -> f64) -> PolygonSoup {
    let (points, faces) = hexagon(rings);
    let position = |p: &LatticePoint| {
        let rho = f64::from(p.ring()) / rings as f64;
        let (x, y) = (rho * p.angle().cos(), rho * p.angle().sin());
        DVec3::new(x, y, height(x, y))
    };
    PolygonSoup::from_faces(points.iter().map(position).collect(), &faces)
}
