//! Quadrilaterals whose corners stand in the order of rows, so that two sides cross.

use crate::soup::PolygonSoup;
use glam::DVec3;

/// Two sides cross where they come as near as this share of the shorter of them.
const NEAR: f64 = 0.1;
/// They do so away from their ends, by this share of each.
const INSIDE: f64 = 0.05;

/// Whether two segments cross: the nearest points of their lines lie within both.
fn cross([a, b]: [DVec3; 2], [c, d]: [DVec3; 2]) -> bool {
    let (u, v, w) = (b - a, d - c, c - a);
    let normal = u.cross(v);
    let square = normal.length_squared();
    let shorter = u.length_squared().min(v.length_squared());
    // Sides that are nearly parallel meet nowhere.
    if square <= 1e-12 * u.length_squared() * v.length_squared() {
        return false;
    }
    let [s, t] = [w.cross(v), w.cross(u)].map(|side| side.dot(normal) / square);
    let is_inside = |share: f64| (INSIDE..=1.0 - INSIDE).contains(&share);
    let apart = w.dot(normal).powi(2) / square;
    is_inside(s) && is_inside(t) && apart <= NEAR * NEAR * shorter
}

/// The corners of a quadrilateral in an order in which no sides cross, where they do.
fn uncrossed(face: &[u32], x: &[DVec3]) -> Option<[u32; 4]> {
    let &[a, b, c, d] = face else { return None };
    let [p, q, r, s] = [a, b, c, d].map(|v| x[v as usize]);
    if cross([q, r], [s, p]) {
        return Some([a, b, d, c]);
    }
    cross([p, q], [r, s]).then_some([a, c, b, d])
}

/// Whether a face is a quadrilateral two of whose sides cross.
pub(super) fn is_crossed(face: &[u32], x: &[DVec3]) -> bool {
    uncrossed(face, x).is_some()
}

/// Puts the corners of quadrilaterals whose sides cross in order. Gives how many, and their corners.
pub(super) fn uncross(soup: &mut PolygonSoup) -> (usize, Vec<u32>) {
    let (mut count, mut vertices) = (0, Vec::new());
    for f in 0..soup.n_faces() {
        if let Some(corners) = uncrossed(soup.face(f), &soup.positions) {
            let first = soup.face_starts[f] as usize;
            soup.corners[first..first + 4].copy_from_slice(&corners);
            count += 1;
            vertices.extend(corners);
        }
    }
    (count, vertices)
}
