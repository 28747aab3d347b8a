//! Open tubes that point at each other, to be blended: Figure 5.2 of Xu & Zhang
//! [XZ06](crate::bibliography#xz06).

use std::f64::consts::TAU;

use glam::DVec3;

use super::{Conflict, grid};
use crate::soup::PolygonSoup;

/// `count` tubes, 2 to 6, along rays from the origin: opposite, at thirds of a circle, to the
/// corners of a tetrahedron, of a triangular bipyramid, and to the faces of a cube.
///
/// Each has this `radius` and begins at distance 1 from the origin, where all of them see each
/// other while `radius < 1`; the wall is outwards.
///
/// # Errors
/// If tubes would meet.
pub fn tubes(
    count: usize,
    radius: f64,
    length: f64,
    around: usize,
    along: usize,
) -> Result<PolygonSoup, Conflict> {
    let axes = directions(count);
    // The rims touch where the radius is the tangent of half the angle between the axes.
    let apart = |a: &DVec3, b: &DVec3| (0.5 * a.angle_between(*b)).tan();
    let pairs = (0..axes.len()).flat_map(|i| axes[..i].iter().map(move |b| (i, b)));
    let most = pairs
        .map(|(i, b)| apart(&axes[i], b))
        .fold(f64::INFINITY, f64::min);
    if radius >= 0.95 * most {
        let most = 0.95 * most;
        return Err(Conflict::TubesMeet {
            count,
            radius,
            most,
        });
    }
    let mut soup = PolygonSoup::default();
    for axis in axes {
        let u = axis.any_orthonormal_vector();
        let v = axis.cross(u);
        let first = soup.positions.len();
        for i in 0..around {
            let (sin, cos) = (TAU * i as f64 / around as f64).sin_cos();
            let out = radius * (cos * u + sin * v);
            let at = |j: usize| axis * (1.0 + length * j as f64 / along as f64) + out;
            soup.positions.extend((0..=along).map(at));
        }
        let vertex = |i: usize, j: usize| first + i % around * (along + 1) + j;
        for face in grid::triangles(around, along, vertex) {
            soup.push_face(&face);
        }
    }
    Ok(soup)
}

fn directions(count: usize) -> Vec<DVec3> {
    let thirds = (0..3).map(|i| {
        let (sin, cos) = (TAU * f64::from(i) / 3.0).sin_cos();
        DVec3::new(cos, sin, 0.0)
    });
    match count {
        2 => vec![DVec3::Z, DVec3::NEG_Z],
        3 => thirds.collect(),
        4 => [(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)]
            .map(|(x, y, z)| DVec3::new(f64::from(x), f64::from(y), f64::from(z)).normalize())
            .to_vec(),
        5 => thirds.chain([DVec3::Z, DVec3::NEG_Z]).collect(),
        _ => DVec3::AXES.iter().flat_map(|&axis| [axis, -axis]).collect(),
    }
}
