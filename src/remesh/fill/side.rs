//! Missing sides of solid shapes.

use super::boundary::Rim;
use crate::mesh::{HalfedgeMesh, Vertex};
use glam::DVec3;

/// Faces that meet at more than this angle, in degrees, meet in an edge of the shape.
const CREASE: f64 = 50.0;
/// So many of those end at the rim of a missing side.
const CORNERS: usize = 3;
/// A rim in a plane leaves it by no more than this share of its size.
const FLAT: f64 = 0.01;

/// Whether a hole lies in a plane and edges of the shape end at its rim, as where a side of a box is
/// missing. A smooth patch would go on from the faces around it, and bulge: a membrane is that side.
pub(super) fn is_side(mesh: &HalfedgeMesh, x: &[DVec3], rim: &Rim) -> bool {
    let points: Vec<DVec3> = rim.vertices.iter().map(|v| x[*v as usize]).collect();
    is_flat(&points) && corners(mesh, x, &rim.vertices) >= CORNERS
}

fn is_flat(points: &[DVec3]) -> bool {
    let centre = points.iter().sum::<DVec3>() / points.len() as f64;
    let arms = || points.iter().map(|p| *p - centre);
    let next = arms().cycle().skip(1);
    let normal = arms().zip(next).map(|(a, b)| a.cross(b)).sum::<DVec3>();
    let normal = normal.normalize_or_zero();
    let size = arms().map(DVec3::length).fold(0.0, f64::max);
    normal != DVec3::ZERO && arms().all(|arm| arm.dot(normal).abs() <= FLAT * size)
}

/// Vertices of the rim at which an edge of the shape ends.
fn corners(mesh: &HalfedgeMesh, x: &[DVec3], rim: &[u32]) -> usize {
    let least = CREASE.to_radians().cos();
    let ends = |v: &&u32| {
        let spokes: Vec<DVec3> = mesh
            .neighbours(Vertex(**v))
            .map(|w| x[w.index()] - x[**v as usize])
            .collect();
        let across = |k: usize| spokes[k].cross(spokes[k + 1]).normalize_or_zero();
        (1..spokes.len().saturating_sub(1)).any(|k| across(k - 1).dot(across(k)) < least)
    };
    rim.iter().filter(ends).count()
}

#[cfg(test)]
mod tests {
    use super::super::boundary_loops;
    use super::*;
    use crate::mesh::{build, shape};
    use crate::soup::PolygonSoup;

    /// Whether the one hole of a shape without some faces is a missing side of it.
    fn is_missing_side(mut soup: PolygonSoup, is_gone: impl Fn(&[DVec3]) -> bool) -> bool {
        let whole = soup.clone();
        soup.corners.clear();
        soup.face_starts.truncate(1);
        for face in whole.faces() {
            let corners: Vec<DVec3> = face.iter().map(|v| whole.positions[*v as usize]).collect();
            if !is_gone(&corners) {
                soup.push_face(face);
            }
        }
        let built = build(&soup).unwrap();
        let all = boundary_loops(&built.mesh, &built.positions);
        assert_eq!(all.len(), 1);
        let rim = Rim::new(&built.mesh, &all, vec![0]);
        is_side(&built.mesh, &built.positions, &rim)
    }

    #[test]
    fn sides_of_a_box_and_no_caps_of_a_sphere() {
        let solid = |name: &str, level: f64| {
            let values = [("level".to_owned(), level)];
            shape::make(name, &values).unwrap().soup
        };
        let mut corners = [[0.0; 3]; 8];
        for (k, corner) in corners.iter_mut().enumerate() {
            *corner = [0, 1, 2].map(|axis| (k >> axis & 1) as f64);
        }
        let mut cube = PolygonSoup {
            positions: corners.map(DVec3::from_array).to_vec(),
            ..PolygonSoup::default()
        };
        for side in [
            [0, 2, 3, 1],
            [4, 5, 7, 6],
            [0, 1, 5, 4],
            [2, 6, 7, 3],
            [0, 4, 6, 2],
            [1, 3, 7, 5],
        ] {
            cube.push_face(&side);
        }
        let on_top = |corners: &[DVec3]| corners.iter().all(|p| p.z > 0.99);
        assert!(is_missing_side(cube, on_top));
        let ball = solid("icosahedron", 3.0);
        assert!(!is_missing_side(ball, |corners| corners
            .iter()
            .all(|p| p.z > 0.5)));
    }
}
