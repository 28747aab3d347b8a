//! Distance from points to a triangle mesh, and between two positions of one mesh.

mod tree;

pub use tree::SurfaceTree;

use crate::mesh::{HalfedgeMesh, Vertex};
use crate::order;
use glam::DVec3;
use std::borrow::Cow;

/// Distance from a point to a triangle; never too small, as it is that to one of its points.
pub fn point_triangle_distance(p: DVec3, triangle: [DVec3; 3]) -> f64 {
    squared_distance(p, triangle).sqrt()
}

fn squared_distance(p: DVec3, [a, b, c]: [DVec3; 3]) -> f64 {
    let (ab, ac, ap) = (b - a, c - a, p - a);
    let normal = ab.cross(ac);
    let size = normal.length_squared();
    if size > 0.0 {
        let v = ap.cross(ac).dot(normal) / size;
        let w = ab.cross(ap).dot(normal) / size;
        if v >= 0.0 && w >= 0.0 && v + w <= 1.0 {
            return (ap - v * ab - w * ac).length_squared();
        }
    }
    let mut least = f64::INFINITY;
    for (u, v) in [(a, b), (b, c), (c, a)] {
        let (side, from) = (v - u, p - u);
        let along = from.dot(side) / side.length_squared().max(f64::MIN_POSITIVE);
        least = least.min((from - along.clamp(0.0, 1.0) * side).length_squared());
    }
    least
}

/// Two-sided distances between a surface and others of the same connectivity,
///
/// ```math
/// \max \bigl( \max_i d(y_i, S_x), \; \max_i d(x_i, S_y) \bigr),
/// ```
///
/// the vertices of each against all of the other: what slides along a surface is at no
/// distance from it, but a surface that has lost a corner is, even if all of its own
/// vertices lie on the old one. Unit length. Between vertices nothing is measured, so the
/// Hausdorff distance of the surfaces can be larger, by no more than their edges sag.
pub struct TwoSided<'a> {
    mesh: &'a HalfedgeMesh,
    x: &'a [DVec3],
    tree: SurfaceTree,
}

impl<'a> TwoSided<'a> {
    /// Prepares distances from the surface at `x`, in O(n log n).
    pub fn new(mesh: &'a HalfedgeMesh, x: &'a [DVec3]) -> Self {
        let tree = SurfaceTree::new(mesh, x);
        Self { mesh, x, tree }
    }

    /// The two-sided distance of the surface at `y`.
    pub fn distance(&self, y: &[DVec3]) -> f64 {
        let there = farthest(self.mesh, self.x, y, 0.0, || Cow::Borrowed(&self.tree));
        farthest(self.mesh, y, self.x, there, || self.refitted(y))
    }

    /// The vertices i with d(y_i, S_x) or d(x_i, S_y) over `limit`; much faster than the
    /// distance itself where vertices stay near their faces.
    pub fn beyond(&self, y: &[DVec3], limit: f64) -> Vec<Vertex> {
        let mut found = beyond(self.mesh, self.x, y, limit, || Cow::Borrowed(&self.tree));
        found.extend(beyond(self.mesh, y, self.x, limit, || self.refitted(y)));
        found.sort_unstable();
        found.dedup();
        found
    }

    fn refitted(&self, y: &[DVec3]) -> Cow<'_, SurfaceTree> {
        let mut tree = self.tree.clone();
        tree.refit(y);
        Cow::Owned(tree)
    }
}

/// Largest distance of `points`, one a vertex of the mesh, from the surface at `x`; unit
/// length. One-sided: of what that surface has and the points have not it tells nothing.
pub fn farthest_from_surface(mesh: &HalfedgeMesh, x: &[DVec3], points: &[DVec3]) -> f64 {
    farthest(mesh, x, points, 0.0, || {
        Cow::Owned(SurfaceTree::new(mesh, x))
    })
}

/// The largest distance of `points`, one a vertex, from the surface at `x`, or `floor` if
/// that is more.
///
/// From the largest upper bound down, the tree is asked for the true distance, until no bound
/// is larger than the farthest found: then no point is left that could be farther.
fn farthest<'t>(
    mesh: &HalfedgeMesh,
    x: &[DVec3],
    points: &[DVec3],
    floor: f64,
    tree: impl FnOnce() -> Cow<'t, SurfaceTree>,
) -> f64 {
    let mut open = bounds_above(mesh, x, points, floor);
    if open.is_empty() {
        return floor;
    }
    order::sort_by(&mut open, |a, b| b.0.total_cmp(&a.0));
    let tree = tree();
    let mut farthest = floor;
    for (bound, v) in open {
        if bound <= farthest {
            break;
        }
        farthest = farthest.max(tree.distance(x, points[v.index()], bound));
    }
    farthest
}

/// The vertices whose points are farther than `limit` from the surface at `x`.
fn beyond<'t>(
    mesh: &HalfedgeMesh,
    x: &[DVec3],
    points: &[DVec3],
    limit: f64,
    tree: impl FnOnce() -> Cow<'t, SurfaceTree>,
) -> Vec<Vertex> {
    let open = bounds_above(mesh, x, points, limit);
    if open.is_empty() {
        return Vec::new();
    }
    let tree = tree();
    open.into_iter()
        .filter(|&(bound, v)| tree.distance(x, points[v.index()], bound) > limit)
        .map(|(_, v)| v)
        .collect()
}

/// Of each point the distance from the faces around its own vertex, no less than that from the
/// surface, where it is over `floor`.
fn bounds_above(
    mesh: &HalfedgeMesh,
    x: &[DVec3],
    points: &[DVec3],
    floor: f64,
) -> Vec<(f64, Vertex)> {
    mesh.vertices()
        .map(|v| (near(mesh, x, v, points[v.index()]), v))
        .filter(|(bound, _)| *bound > floor)
        .collect()
}

/// Distance from `p` to the faces around a vertex, a polygon being the fan from its first
/// corner.
fn near(mesh: &HalfedgeMesh, x: &[DVec3], v: Vertex, p: DVec3) -> f64 {
    let faces = mesh.star(v).map(|spoke| spoke.face).filter(|f| f.is_some());
    let mut least = f64::INFINITY;
    for f in faces {
        let mut corners = mesh.face_vertices(f).map(|v| x[v.index()]);
        let (Some(a), Some(mut b)) = (corners.next(), corners.next()) else {
            continue;
        };
        for c in corners {
            least = least.min(squared_distance(p, [a, b, c]));
            b = c;
        }
    }
    least.sqrt()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::measure::triangle_points;
    use crate::mesh::{build, shape};
    use crate::soup::PolygonSoup;

    #[test]
    fn distances_to_a_triangle() {
        let t = [DVec3::ZERO, DVec3::X, DVec3::Y];
        for (p, expected) in [
            ([0.2, 0.3, 0.5], 0.5),
            ([-1.0, 0.5, 0.0], 1.0),
            ([1.0, 1.0, 0.0], 0.5f64.sqrt()),
            ([2.0, 0.0, 1.0], 2f64.sqrt()),
        ] {
            let found = point_triangle_distance(DVec3::from_array(p), t);
            assert!((found - expected).abs() < 1e-14, "{p:?}: {found}");
        }
    }

    #[test]
    fn sliding_is_no_distance() {
        let sample = shape::make("torus", &[]).expect("a shape");
        let built = build(&sample.soup).expect("a surface");
        let (mesh, x) = (built.mesh, built.positions);
        // Every vertex to the middle of some face nearby.
        let moved: Vec<DVec3> = mesh
            .vertices()
            .map(|v| {
                let mut faces = mesh.star(v).map(|spoke| spoke.face);
                let f = faces.next().expect("a face");
                triangle_points(&mesh, &x, f).iter().sum::<DVec3>() / 3.0
            })
            .collect();
        assert!(farthest_from_surface(&mesh, &x, &moved) < 1e-15);
        let mut lifted = moved;
        lifted[7].z += 0.02;
        let found = farthest_from_surface(&mesh, &x, &lifted);
        assert!(found > 0.005 && found <= 0.02, "{found}");
    }

    /// A corner of a cube drawn into a face lies on the old surface, which one side alone
    /// takes for no change at all.
    #[test]
    fn a_lost_corner_is_a_distance() {
        let at = |i: u32| DVec3::from([i & 1, i >> 1 & 1, i >> 2].map(f64::from));
        let sides = [
            [0, 2, 3, 1],
            [4, 5, 7, 6],
            [0, 1, 5, 4],
            [2, 6, 7, 3],
            [0, 4, 6, 2],
            [1, 3, 7, 5],
        ];
        let soup = PolygonSoup::from_faces((0..8).map(at).collect(), &sides.map(Vec::from));
        let built = build(&soup.triangulated()).expect("a surface");
        let (mesh, x) = (built.mesh, built.positions);
        let both = TwoSided::new(&mesh, &x);
        assert_eq!(both.distance(&x), 0.0);
        let mut y = x.clone();
        y[7] = DVec3::new(0.75, 0.75, 1.0);
        let there = farthest_from_surface(&mesh, &x, &y);
        assert!(there < 1e-15, "{there}");
        let all = mesh
            .faces()
            .map(|f| point_triangle_distance(x[7], triangle_points(&mesh, &y, f)));
        let expected = all.fold(f64::INFINITY, f64::min);
        assert!(expected > 0.1, "{expected}");
        assert_eq!(both.distance(&y), expected);
        assert_eq!(both.beyond(&y, expected), []);
        assert_eq!(both.beyond(&y, 0.999 * expected), [Vertex(7)]);
    }
}
