//! Distance from points to a nearby triangle mesh.

use crate::mesh::{Face, HalfedgeMesh, Vertex};
use glam::DVec3;

/// Distance from a point to a triangle.
pub fn point_triangle_distance(p: DVec3, [a, b, c]: [DVec3; 3]) -> f64 {
    let normal = (b - a).cross(c - a);
    let inside = [(a, b), (b, c), (c, a)]
        .iter()
        .all(|(u, v)| (*v - *u).cross(p - *u).dot(normal) >= 0.0);
    if inside && normal.length_squared() > 0.0 {
        return (p - a).dot(normal.normalize()).abs();
    }
    [(a, b), (b, c), (c, a)]
        .iter()
        .map(|(u, v)| {
            let edge = *v - *u;
            let along = (p - *u).dot(edge) / edge.length_squared().max(f64::MIN_POSITIVE);
            p.distance(*u + along.clamp(0.0, 1.0) * edge)
        })
        .fold(f64::INFINITY, f64::min)
}

/// Distance from a point to a face, a polygon being the fan from its first corner.
fn point_face_distance(mesh: &HalfedgeMesh, x: &[DVec3], f: Face, p: DVec3) -> f64 {
    let mut corners = mesh.face_vertices(f).map(|v| x[v.index()]);
    let (Some(a), Some(mut b)) = (corners.next(), corners.next()) else {
        return f64::INFINITY;
    };
    corners.fold(f64::INFINITY, |least, c| {
        let triangle = [a, std::mem::replace(&mut b, c), c];
        least.min(point_triangle_distance(p, triangle))
    })
}

/// Largest distance of `moved` from the surface at `x`, for vertices that have slid along
/// it: each is looked for around the vertex of `x` that is nearest, found by walking there
/// from its own place.
pub fn farthest_from_surface(mesh: &HalfedgeMesh, x: &[DVec3], moved: &[DVec3]) -> f64 {
    let mut farthest = 0.0f64;
    for v in mesh.vertices() {
        let p = moved[v.index()];
        let nearest = walk(mesh, x, v, p);
        let mut least = f64::INFINITY;
        let ring = mesh
            .neighbours(nearest)
            .chain(mesh.neighbours(nearest).flat_map(|w| mesh.neighbours(w)));
        for w in std::iter::once(nearest).chain(ring) {
            for f in faces_around(mesh, w) {
                least = least.min(point_face_distance(mesh, x, f, p));
            }
            // It cannot be the farthest any more.
            if least <= farthest {
                break;
            }
        }
        farthest = farthest.max(least);
    }
    farthest
}

/// Goes on as long as a vertex within two edges is closer to `p`: on rough meshes a
/// neighbour alone need not be.
fn walk(mesh: &HalfedgeMesh, x: &[DVec3], start: Vertex, p: DVec3) -> Vertex {
    let mut at = start;
    loop {
        let distance = |w: Vertex| x[w.index()].distance_squared(p);
        let closer = mesh
            .neighbours(at)
            .flat_map(|v| std::iter::once(v).chain(mesh.neighbours(v)))
            .filter(|&w| distance(w) < distance(at))
            .min_by(|&a, &b| distance(a).total_cmp(&distance(b)));
        match closer {
            Some(w) => at = w,
            None => return at,
        }
    }
}

fn faces_around(mesh: &HalfedgeMesh, v: Vertex) -> impl Iterator<Item = Face> + '_ {
    mesh.star(v).map(|spoke| spoke.face).filter(|f| f.is_some())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::measure::triangle_points;
    use crate::mesh::{build, shape};

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
                let f = faces_around(&mesh, v).next().expect("a face");
                triangle_points(&mesh, &x, f).iter().sum::<DVec3>() / 3.0
            })
            .collect();
        assert!(farthest_from_surface(&mesh, &x, &moved) < 1e-15);
        let mut lifted = moved;
        lifted[7].z += 0.02;
        let found = farthest_from_surface(&mesh, &x, &lifted);
        assert!(found > 0.005 && found <= 0.02, "{found}");
    }
}
