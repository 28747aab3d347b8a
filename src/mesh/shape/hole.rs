//! A six-sided hole to be filled: figure 10 of Bobenko & Schröder
//! [BS05](crate::bibliography#bs05).

use glam::{DVec2, DVec3};

use super::Sample;
use super::hexagon::{LatticePoint, hexagon};
use crate::soup::PolygonSoup;

/// Rings of the hexagon: 469 vertices.
const RINGS: usize = 12;

/// A hexagon cut from a square grid with diagonals.
///
/// The two outermost rings lie on a smooth rim of the given `height` and are
/// fixed, so that the fill joins it with a continuous tangent plane; the 331
/// vertices within begin flat. All their diagonals have four corners on a
/// circle, β = 0: nearly a quarter of the inner edges.
pub fn six_sided_hole(height: f64) -> Sample {
    let (points, faces) = hexagon(RINGS);
    let position = |p: &LatticePoint| {
        // The grid turned by 45°: the hexagon's long diagonal lies along x.
        let (i, j) = (f64::from(p.i) / RINGS as f64, f64::from(p.j) / RINGS as f64);
        let z = if is_rim(*p) { height * rim(i, j) } else { 0.0 };
        (DVec2::new(i + j, j - i) * 0.5_f64.sqrt()).extend(z)
    };
    let positions: Vec<DVec3> = points.iter().map(position).collect();
    let fixed = (0..points.len())
        .filter(|&v| is_rim(points[v]))
        .map(|v| v as u32)
        .collect();
    Sample {
        fixed: Some(fixed),
        ..PolygonSoup::from_faces(positions, &faces).into()
    }
}

fn is_rim(p: LatticePoint) -> bool {
    p.ring() + 1 >= RINGS as i32
}

/// Height of the rim over lattice coordinates: a bowl whose corners rise and whose sides sag.
fn rim(i: f64, j: f64) -> f64 {
    // The affine image in which the hexagon is regular with corners at distance 1.
    let q = DVec2::new(i - j / 2.0, j * 0.75_f64.sqrt());
    let angle = q.y.atan2(q.x);
    q.length_squared() * (1.0 + 0.25 * (6.0 * angle).cos())
}
