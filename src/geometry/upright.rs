//! Which of two coordinate axes points up: files follow either custom and do not say which.

use super::measure::{bounding_box, triangle_points};
use crate::interrupt::paced;
use crate::mesh::HalfedgeMesh;
use glam::DVec3;

/// How far from its lowest or highest point a surface is still its side, as a share of its height.
const SIDE: f64 = 0.02;
/// Cosine beyond which a face lies flat.
const FLAT: f64 = 0.98;
/// The least share of the surface that it stands on.
const LEAST: f64 = 0.02;
/// How much larger its base is to be than that along the other axis.
const CLEARLY: f64 = 1.2;

/// Whether a triangle mesh stands on a side across the third axis rather than across the second:
/// on flat faces, or on the rim of an opening. Not where it is much the same along both.
pub fn stands_along_z(mesh: &HalfedgeMesh, x: &[DVec3]) -> bool {
    let (low, high) = bounding_box(x);
    let reach = SIDE * (high - low);
    // Outward and the height there: of the lower and the upper side, across either axis.
    let sides = [DVec3::Y, DVec3::Z].map(|axis| {
        let side = |outward: DVec3, end: DVec3| (outward, end.dot(outward), reach.dot(axis));
        [side(-axis, low), side(axis, high)]
    });
    let mut area = 0.0;
    let mut flat = [[0.0; 2]; 2];
    let mut rims = [[0.0; 2]; 2];
    let each = [(0, 0), (0, 1), (1, 0), (1, 1)];
    for f in paced(mesh.faces()) {
        let [a, b, c] = triangle_points(mesh, x, f);
        let normal = (b - a).cross(c - a);
        let size = normal.length();
        area += 0.5 * size;
        for (i, j) in each {
            let (outward, end, reach) = sides[i][j];
            let is_base = normal.dot(outward) > FLAT * size
                && [a, b, c].iter().all(|p| end - p.dot(outward) <= reach);
            flat[i][j] += if is_base { 0.5 * size } else { 0.0 };
        }
    }
    for h in mesh.boundary_loops().flatten() {
        let [a, b] = [mesh.tail(h), mesh.tip(h)].map(|v| x[v.index()]);
        for (i, j) in each {
            let (outward, end, reach) = sides[i][j];
            if [a, b].iter().all(|p| end - p.dot(outward) <= reach) {
                rims[i][j] += 0.5 * a.cross(b).dot(outward);
            }
        }
    }
    let base = |i: usize| {
        let side = |j: usize| flat[i][j] + f64::max(rims[i][j], 0.0);
        side(0).max(side(1))
    };
    base(1) > LEAST * area && base(1) > CLEARLY * base(0)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::shape;

    /// A shape with its axes exchanged so that what is along the third is along the second.
    fn both(name: &str) -> [bool; 2] {
        let sample = shape::make(name, &[]).expect("a shape");
        [false, true].map(|is_laid| {
            let mut soup = sample.soup.clone();
            if is_laid {
                for p in &mut soup.positions {
                    *p = DVec3::new(p.y, p.z, p.x);
                }
            }
            let soup = soup.triangulated();
            let built = crate::mesh::build(&soup).expect("a surface");
            stands_along_z(&built.mesh, &built.positions)
        })
    }

    #[test]
    fn a_surface_stands_on_its_flat_side_or_its_rim() {
        // Rims at both ends; a rim below; all of it flat; nearly so where it touches the floor.
        for name in ["cylinder", "hemisphere", "disk", "torus"] {
            assert_eq!(both(name), [true, false], "{name}");
        }
        // Flat faces, of which those of the third axis are not the largest; none at all.
        for name in ["letter-c", "icosphere", "pipe"] {
            assert!(!both(name)[1], "{name}");
        }
    }
}
