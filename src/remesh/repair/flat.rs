//! Triangles without area.

use super::faces::Faces;
use crate::soup::PolygonSoup;
use glam::DVec3;

/// Height over length of the longest side, at and below which a triangle has no area.
const FLAT: f64 = 1e-10;

/// The ends of the longest side of a flat triangle, and the corner between them; `None` for any
/// other face.
fn flat(face: &[u32], x: &[DVec3]) -> Option<[u32; 3]> {
    let &[a, b, c] = face else { return None };
    let at = |v: u32| x[v as usize];
    let sides = [[a, b, c], [b, c, a], [c, a, b]];
    let length = |s: &[u32; 3]| at(s[0]).distance_squared(at(s[1]));
    let longest = sides
        .into_iter()
        .max_by(|s, t| length(s).total_cmp(&length(t)))?;
    let [p, q, r] = longest.map(at);
    let twice = (q - p).cross(r - p).length();
    (twice <= FLAT * p.distance_squared(q)).then_some(longest)
}

/// Drops triangles of collinear corners; the corner in the middle joins the neighbour across the
/// longest side, so that no gap is left. Gives the corners of those dropped.
pub(super) fn drop_flat(soup: &mut PolygonSoup) -> Vec<[u32; 3]> {
    let has_any = soup
        .faces()
        .any(|face| flat(face, &soup.positions).is_some());
    if !has_any {
        return Vec::new();
    }
    let mut faces = Faces::of(soup);
    let mut dropped = Vec::new();
    // Those that an insertion makes are of the next round.
    for f in 0..faces.len() {
        let Some([a, b, c]) = flat(faces.face(f), &soup.positions) else {
            continue;
        };
        faces.remove(f);
        dropped.push([a, b, c]);
        // A flat neighbour goes itself: what it leaves open is closed as a junction.
        let is_flat = |g: &u32| flat(faces.face(*g as usize), &soup.positions).is_some();
        let others = faces.at(a, b).iter().copied();
        let others: Vec<u32> = others.filter(|g| !is_flat(g)).collect();
        for g in others {
            faces.insert(g as usize, (a, b), c);
        }
    }
    faces.write_to(soup);
    dropped
}
