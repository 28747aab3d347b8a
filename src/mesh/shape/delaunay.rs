//! Triangulations of points on the unit sphere: the convex hull of the points, whose faces are
//! the Delaunay triangles.
//!
//! One point after the other is put into the triangle it lies in, and edges are flipped until
//! the hull is convex again (Lawson's method). The points come in an order without a pattern, so that the walk
//! to the triangle is short.

use glam::DVec3;

/// A triangle: its corners, and the triangle across the side opposite to each.
#[derive(Clone, Copy)]
struct Face {
    corners: [u32; 3],
    across: [u32; 3],
}

deferred! {
    /// The Delaunay triangles of at least four points of the unit sphere that do not all lie within
    /// a hemisphere, turned outward.
    pub(super) fn triangles(points: &[DVec3]) -> Vec<[u32; 3]> {
        let mut faces = first_faces(points);
        let first: Vec<u32> = faces[0]
            .corners
            .into_iter()
            .chain([faces[1].corners[2]])
            .collect();
        let mut at = 0;
        for p in (0..points.len() as u32).filter(|p| !first.contains(p)) {
            at = located(&faces, points, at, p);
            insert(&mut faces, points, at, p);
        }
        faces.into_iter().map(|face| face.corners).collect()
    }
}

fn det(points: &[DVec3], [a, b, c]: [u32; 3]) -> f64 {
    let [a, b, c] = [a, b, c].map(|v| points[v as usize]);
    a.dot(b.cross(c))
}

/// The tetrahedron of the points nearest to the corners of a regular one.
fn first_faces(points: &[DVec3]) -> Vec<Face> {
    let directions = [
        DVec3::new(1.0, 1.0, 1.0),
        DVec3::new(1.0, -1.0, -1.0),
        DVec3::new(-1.0, 1.0, -1.0),
        DVec3::new(-1.0, -1.0, 1.0),
    ];
    let mut chosen: Vec<u32> = Vec::with_capacity(4);
    for direction in directions {
        let free = (0..points.len() as u32).filter(|p| !chosen.contains(p));
        let along = |p: &u32| points[*p as usize].dot(direction);
        chosen.extend(free.max_by(|p, q| along(p).total_cmp(&along(q))));
    }
    let [a, b, c, d] = [chosen[0], chosen[1], chosen[2], chosen[3]];
    let face = |corners, across| Face { corners, across };
    vec![
        face([a, b, c], [3, 2, 1]),
        face([b, a, d], [2, 3, 0]),
        face([a, c, d], [3, 1, 0]),
        face([c, b, d], [1, 2, 0]),
    ]
}

/// The face that the ray to a point passes through.
fn located(faces: &[Face], points: &[DVec3], from: usize, p: u32) -> usize {
    let mut at = from;
    // Each step crosses a side that the point lies beyond; roundoff must not make it endless.
    for _ in 0..faces.len() {
        let [a, b, c] = faces[at].corners;
        let beyond = [[b, c, p], [c, a, p], [a, b, p]].map(|side| det(points, side));
        let worst = (0..3).min_by(|i, j| beyond[*i].total_cmp(&beyond[*j]));
        match worst {
            Some(i) if beyond[i] < 0.0 => at = faces[at].across[i] as usize,
            _ => break,
        }
    }
    at
}

/// Tells the neighbour across a side that its neighbour there is another now.
fn reattach(faces: &mut [Face], of: u32, old: u32, new: u32) {
    for across in &mut faces[of as usize].across {
        if *across == old {
            *across = new;
            return;
        }
    }
}

fn insert(faces: &mut Vec<Face>, points: &[DVec3], at: usize, p: u32) {
    let Face {
        corners: [a, b, c],
        across: [x, y, z],
    } = faces[at];
    let (f, g, h) = (at as u32, faces.len() as u32, faces.len() as u32 + 1);
    faces[at] = Face {
        corners: [p, b, c],
        across: [x, g, h],
    };
    faces.push(Face {
        corners: [p, c, a],
        across: [y, h, f],
    });
    faces.push(Face {
        corners: [p, a, b],
        across: [z, f, g],
    });
    reattach(faces, y, f, g);
    reattach(faces, z, f, h);
    let mut open = vec![f, g, h];
    while let Some(f) = open.pop() {
        // The side opposite to the new point may have to go.
        let other = faces[f as usize].across[0];
        if is_bent_in(faces, points, f, other) {
            flip(faces, f, other);
            open.extend([f, other]);
        }
    }
}

/// Whether the far corner of a neighbour lies above the plane of a face.
fn is_bent_in(faces: &[Face], points: &[DVec3], f: u32, other: u32) -> bool {
    let [p, b, c] = faces[f as usize].corners;
    let Some(far) = faces[other as usize]
        .corners
        .into_iter()
        .find(|v| *v != b && *v != c)
    else {
        return false;
    };
    let [p, b, c, d] = [p, b, c, far].map(|v| points[v as usize]);
    (b - p).cross(c - p).dot(d - p) > 1e-15
}

/// Flips the side opposite to the first corner of a face; that stays the first corner of both.
fn flip(faces: &mut [Face], f: u32, other: u32) {
    let Face {
        corners: [p, b, c],
        across: [_, cp, pb],
    } = faces[f as usize];
    let far = faces[other as usize];
    let i = (0..3)
        .find(|&i| far.corners[i] != b && far.corners[i] != c)
        .unwrap_or_default();
    // The neighbour runs d, c, b: across c lies its side b–d, across b its side d–c.
    let d = far.corners[i];
    let (bd, dc) = (far.across[(i + 1) % 3], far.across[(i + 2) % 3]);
    faces[f as usize] = Face {
        corners: [p, b, d],
        across: [bd, other, pb],
    };
    faces[other as usize] = Face {
        corners: [p, d, c],
        across: [dc, cp, f],
    };
    reattach(faces, bd, other, f);
    reattach(faces, cp, f, other);
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::noise::SplitMix64;
    use crate::soup::PolygonSoup;

    #[test]
    fn the_triangles_of_random_points_are_their_convex_hull() {
        let mut random = SplitMix64::new(5);
        let mut point =
            || DVec3::from_array(std::array::from_fn(|_| random.gaussian())).normalize();
        let points: Vec<DVec3> = (0..500).map(|_| point()).collect();
        let triangles = triangles(&points);
        assert_eq!(triangles.len(), 2 * points.len() - 4);
        for t in &triangles {
            let [a, b, c] = t.map(|v| points[v as usize]);
            let normal = (b - a).cross(c - a);
            let above = points.iter().filter(|p| normal.dot(**p - a) > 1e-12);
            assert_eq!(above.count(), 0, "{t:?}");
        }
        let built = crate::mesh::build(&PolygonSoup::from_faces(points, &triangles));
        let built = built.expect("a surface");
        assert!(built.repairs.is_empty() && built.mesh.is_closed());
    }
}
