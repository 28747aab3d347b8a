//! Tubes around knots.

use std::f64::consts::TAU;

use glam::DVec3;

use super::curve::{closed_frames, even_parameters};
use super::grid;
use crate::soup::PolygonSoup;

/// A tube of radius `tube` around the trefoil `(sin t + 2 sin 2t, cos t - 2 cos 2t, -sin 3t)`.
///
/// Its strands are 2 apart where they cross.
pub fn trefoil(tube: f64, along: usize, around: usize) -> PolygonSoup {
    let curve = |s: f64| {
        let t = TAU * s;
        DVec3::new(
            t.sin() + 2.0 * (2.0 * t).sin(),
            t.cos() - 2.0 * (2.0 * t).cos(),
            -(3.0 * t).sin(),
        )
    };
    closed_tube(curve, tube, along, around)
}

/// A tube of radius `tube` around the curve that winds `p` times around the axis of a torus
/// with R = 2 and r = 1 and `q` times through its hole: a knot if p and q are coprime, else a link of
/// as many tubes as their greatest common divisor says, each of `along` x `around` points.
pub fn torus_knot(p: usize, q: usize, tube: f64, along: usize, around: usize) -> PolygonSoup {
    let tubes = greatest_common_divisor(p, q);
    let mut link = PolygonSoup::default();
    for k in 0..tubes {
        // In a section the strands of all tubes are evenly spaced.
        let begin = k as f64 / p as f64;
        let curve = |s: f64| {
            let (u, v) = ((p / tubes) as f64 * s, (q / tubes) as f64 * s + begin);
            let (u, v) = (TAU * u, TAU * v);
            let rho = 2.0 + v.cos();
            DVec3::new(rho * u.cos(), rho * u.sin(), v.sin())
        };
        let one = closed_tube(curve, tube, along, around);
        let first = link.positions.len() as u32;
        link.positions.extend(&one.positions);
        for face in one.faces() {
            link.push_face(&[face[0] + first, face[1] + first, face[2] + first]);
        }
    }
    link
}

fn greatest_common_divisor(a: usize, b: usize) -> usize {
    if b == 0 {
        a
    } else {
        greatest_common_divisor(b, a % b)
    }
}

/// Circles of `around` points in `along` planes across a closed curve over `[0, 1]`.
fn closed_tube(
    curve: impl Fn(f64) -> DVec3,
    radius: f64,
    along: usize,
    around: usize,
) -> PolygonSoup {
    let points: Vec<DVec3> = even_parameters(along, &curve)
        .into_iter()
        .map(&curve)
        .collect();
    let frames = closed_frames(&points);
    let positions = (0..along * around).map(|k| {
        let (i, v) = (k / around, TAU * (k % around) as f64 / around as f64);
        let (normal, binormal) = frames[i];
        // Against the frame, so that tangent x turn points outwards.
        points[i] + (normal * v.cos() - binormal * v.sin()) * radius
    });
    let vertex = |i: usize, j: usize| i % along * around + j % around;
    PolygonSoup::from_faces(positions.collect(), &grid::triangles(along, around, vertex))
}
