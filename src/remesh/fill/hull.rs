//! Convex hull of points in space, incrementally; all its faces are triangles.

use crate::mesh::noise::SplitMix64;
use glam::DVec3;
use std::collections::HashMap;

/// Points are moved by this share of their extent first, so that no four lie in a plane:
/// rims of tubes and faces of boxes do.
const JOGGLE: f64 = 1e-7;

/// Faces of the hull, outwards; none for fewer than four points.
///
/// The points are joggled with a fixed seed: of faces in one plane some triangulation is
/// found, always the same. O(n h) for n points and h faces.
pub(super) fn convex_hull(points: &[DVec3]) -> Vec<[u32; 3]> {
    let Some(x) = joggled(points) else {
        return Vec::new();
    };
    let Some(first) = tetrahedron(&x) else {
        return Vec::new();
    };
    let mut faces: Vec<Facet> = Vec::new();
    for skipped in 0..4 {
        let mut corners = [
            first[(skipped + 1) % 4],
            first[(skipped + 2) % 4],
            first[(skipped + 3) % 4],
        ];
        if Facet::new(&x, corners).distance(x[first[skipped] as usize]) > 0.0 {
            corners.swap(0, 1);
        }
        faces.push(Facet::new(&x, corners));
    }
    for p in (0..x.len() as u32).filter(|p| !first.contains(p)) {
        let (visible, hidden): (Vec<Facet>, Vec<Facet>) = faces
            .into_iter()
            .partition(|f| f.distance(x[p as usize]) > 0.0);
        faces = hidden;
        // Sides of visible faces whose other side is hidden.
        let mut horizon: HashMap<(u32, u32), bool> = HashMap::new();
        let sides = visible.iter().flat_map(|f| {
            let [a, b, c] = f.corners;
            [(a, b), (b, c), (c, a)]
        });
        let mut order = Vec::new();
        for (a, b) in sides {
            if let Some(inner) = horizon.get_mut(&(b, a)) {
                *inner = true;
            } else {
                horizon.insert((a, b), false);
                order.push((a, b));
            }
        }
        for (a, b) in order.into_iter().filter(|side| !horizon[side]) {
            faces.push(Facet::new(&x, [a, b, p]));
        }
    }
    faces.into_iter().map(|f| f.corners).collect()
}

/// A face with its plane.
struct Facet {
    corners: [u32; 3],
    normal: DVec3,
    offset: f64,
}

impl Facet {
    fn new(x: &[DVec3], corners: [u32; 3]) -> Self {
        let [a, b, c] = corners.map(|v| x[v as usize]);
        let normal = (b - a).cross(c - a).normalize_or_zero();
        Self {
            corners,
            normal,
            offset: normal.dot(a),
        }
    }

    fn distance(&self, p: DVec3) -> f64 {
        self.normal.dot(p) - self.offset
    }
}

fn joggled(points: &[DVec3]) -> Option<Vec<DVec3>> {
    let low = points.iter().copied().reduce(DVec3::min)?;
    let size = (points.iter().copied().reduce(DVec3::max)? - low).length();
    let mut random = SplitMix64::new(1);
    let mut push = || JOGGLE * (2.0 * random.uniform() - 1.0);
    let scaled = |p: &DVec3| (*p - low) / size + DVec3::new(push(), push(), push());
    (size > 0.0).then(|| points.iter().map(scaled).collect())
}

/// Four points that are not nearly in a plane, if there are four points.
fn tetrahedron(x: &[DVec3]) -> Option<[u32; 4]> {
    let farthest = |measure: &dyn Fn(DVec3) -> f64| {
        (0..x.len()).max_by(|&i, &j| measure(x[i]).total_cmp(&measure(x[j])))
    };
    let a = farthest(&|p| p.x)?;
    let b = farthest(&|p| p.distance_squared(x[a]))?;
    let axis = x[b] - x[a];
    let c = farthest(&|p| (p - x[a]).cross(axis).length_squared())?;
    let normal = axis.cross(x[c] - x[a]);
    let d = farthest(&|p| (p - x[a]).dot(normal).abs())?;
    let corners = [a, b, c, d];
    let distinct = (0..4).all(|i| !corners[..i].contains(&corners[i]));
    distinct.then(|| corners.map(|v| v as u32))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{Repair, build};
    use crate::soup::PolygonSoup;

    #[test]
    fn hulls_are_closed_convex_and_outwards() {
        let mut random = SplitMix64::new(2);
        let ball: Vec<DVec3> = (0..300)
            .map(|_| DVec3::from_array(std::array::from_fn(|_| random.gaussian())))
            .collect();
        let cube: Vec<DVec3> = (0..27)
            .map(|i| DVec3::new((i % 3) as f64, (i / 3 % 3) as f64, (i / 9) as f64))
            .collect();
        for (points, volume) in [(&ball, None), (&cube, Some(8.0))] {
            let faces = convex_hull(points);
            for face in &faces {
                let facet = Facet::new(points, *face);
                let outside = points
                    .iter()
                    .map(|p| facet.distance(*p))
                    .fold(0.0, f64::max);
                assert!(outside < 1e-4, "{outside}");
            }
            let mut used: Vec<u32> = faces.iter().flatten().copied().collect();
            used.sort_unstable();
            used.dedup();
            assert_eq!(faces.len(), 2 * used.len() - 4);
            let built = build(&PolygonSoup::from_faces(points.clone(), &faces)).expect("a surface");
            assert!(built.mesh.is_closed() && built.mesh.genus() == Some(0));
            assert!(!built.repairs.contains(&Repair::InsideOut));
            let found = crate::geometry::measure::volume(&built.mesh, &built.positions);
            if let (Some(found), Some(volume)) = (found, volume) {
                assert!((found - volume).abs() < 1e-5, "{found}");
            }
        }
    }

    #[test]
    fn points_without_a_hull_have_none() {
        assert!(convex_hull(&[]).is_empty());
        assert!(convex_hull(&[DVec3::ONE; 9]).is_empty());
        assert!(convex_hull(&[DVec3::X, DVec3::Y, DVec3::Z]).is_empty());
    }
}
