//! Towards Lawson's minimal surfaces ξ_{g,1} of the 3-sphere [L70](crate::bibliography#l70): a
//! surface with the same symmetries and through the same great circles, as stereographic image.
//!
//! With (z, w) in ℂ², |z|² + |w|² = 1, it is the zero set of
//!
//! ```math
//! f = \operatorname{Im} z^{g+1} + \operatorname{Re} w^2,
//! ```
//!
//! projected from the point w = i, where f = −1, to (z, Re w)/(1 − Im w), and laid down so that the last
//! axis is upright. The 2(g + 1) points of the
//! circle w = 0 with f = 0 and the four of the circle z = 0 are joined by 8(g + 1) quarters of great
//! circles, on which f vanishes; these bound 4(g + 1) quadrilaterals, which half turns about the
//! circles carry into each other. Lawson's surface has the same ones, each of least area; the Willmore
//! energy of that is its area in the sphere. g = 1 is the Clifford torus.

use super::grid;
use crate::soup::PolygonSoup;
use glam::{DVec2, DVec3, DVec4};
use std::collections::HashMap;
use std::f64::consts::{FRAC_PI_4, PI};

/// Rounds in which vertices go to the middle of their neighbours and back to the surface.
const ROUNDS: usize = 40;
/// Steps back to the surface; the distance is squared in each.
const STEPS: usize = 3;

/// f and its gradient along the sphere.
fn level(genus: usize, x: DVec4) -> (f64, DVec4) {
    let z = DVec2::new(x.x, x.y);
    let times = |a: DVec2, b: DVec2| DVec2::new(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x);
    let power = (0..genus).fold(DVec2::X, |product, _| times(product, z));
    let value = times(power, z).y + x.z * x.z - x.w * x.w;
    let slope = (genus + 1) as f64 * power;
    let gradient = DVec4::new(slope.y, slope.x, 2.0 * x.z, -2.0 * x.w);
    (value, gradient - gradient.dot(x) * x)
}

/// The point of f = 0 nearby.
fn on_surface(genus: usize, from: DVec4) -> DVec4 {
    (0..STEPS).fold(from.normalize(), |x, _| {
        let (value, gradient) = level(genus, x);
        let step = value / gradient.length_squared().max(f64::MIN_POSITIVE);
        (x - step * gradient).normalize()
    })
}

/// The surface with `cells` x `cells` cells, each cut in two, in each quadrilateral.
pub fn lawson(genus: usize, cells: usize) -> PolygonSoup {
    let sides = 2 * (genus + 1);
    let on_z = |i: usize| {
        let (y, x) = (PI * i as f64 / (genus + 1) as f64).sin_cos();
        DVec4::new(x, y, 0.0, 0.0)
    };
    let on_w = |j: usize| {
        let (y, x) = (FRAC_PI_4 * (2 * j + 1) as f64).sin_cos();
        DVec4::new(0.0, 0.0, x, y)
    };
    let mut x: Vec<DVec4> = Vec::new();
    let mut faces = Vec::new();
    // Vertices of corners and sides, which quadrilaterals share, by the two ends and the share.
    let mut shared: HashMap<(usize, usize, usize), usize> = HashMap::new();
    for i in 0..sides {
        for j in 0..4 {
            // Im z^(g+1) is positive where i is even, Re w² where j is odd.
            if (i + j) % 2 == 1 {
                continue;
            }
            let ends = [i, (i + 1) % sides, j, (j + 1) % 4];
            let [p, p2, q, q2] = [on_z(ends[0]), on_z(ends[1]), on_w(ends[2]), on_w(ends[3])];
            // p and p2 are opposite corners, q and q2 the other two.
            let corner = [(ends[0], p), (ends[2], q), (ends[1], p2), (ends[3], q2)];
            let mut vertices = vec![0; (cells + 1) * (cells + 1)];
            for a in 0..=cells {
                for b in 0..=cells {
                    let [s, t] = [a, b].map(|k| k as f64 / cells as f64);
                    let place = (1.0 - s) * (1.0 - t) * p
                        + s * (1.0 - t) * q
                        + s * t * p2
                        + (1.0 - s) * t * q2;
                    // From an end on w = 0 to one on z = 0: which two, and how many steps.
                    let side = match (a, b) {
                        (a, 0) => Some((0, 1, a)),
                        (a, b) if a == cells => Some((2, 1, cells - b)),
                        (a, b) if b == cells => Some((2, 3, cells - a)),
                        (0, b) => Some((0, 3, b)),
                        _ => None,
                    };
                    let mut new = || {
                        x.push(on_surface(genus, place));
                        x.len() - 1
                    };
                    vertices[a * (cells + 1) + b] = match side {
                        None => new(),
                        Some((from, to, step)) => {
                            let [from, to] = [from, to].map(|k: usize| corner[k].0);
                            let key = match step {
                                0 => (from, usize::MAX, 0),
                                n if n == cells => (usize::MAX, to, 0),
                                n => (from, to, n),
                            };
                            *shared.entry(key).or_insert_with(new)
                        }
                    };
                }
            }
            let vertex = |a: usize, b: usize| vertices[a * (cells + 1) + b];
            let mut cut = grid::triangles(cells, cells, vertex);
            // A half turn about a side swaps the sides of the surface.
            if i % 2 == 0 {
                cut.iter_mut().for_each(|face| face.swap(1, 2));
            }
            faces.append(&mut cut);
        }
    }
    relax(genus, &mut x, &faces);
    // The axis upright: from the side one looks through the handles.
    let project = |x: &DVec4| DVec3::new(x.x, x.z, -x.y) / (1.0 - x.w);
    PolygonSoup::from_faces(x.iter().map(project).collect(), &faces)
}

/// Spreads the vertices evenly over the surface.
fn relax(genus: usize, x: &mut [DVec4], faces: &[[u32; 3]]) {
    for _ in 0..ROUNDS {
        let mut sums = vec![(DVec4::ZERO, 0.0); x.len()];
        // Diagonals run from corner to corner on w = 0, which all symmetries carry to such.
        for face in faces {
            for (k, &v) in face.iter().enumerate() {
                let (sum, total) = &mut sums[v as usize];
                *sum += x[face[(k + 1) % 3] as usize];
                *total += 1.0;
            }
        }
        for (x, (sum, total)) in x.iter_mut().zip(sums) {
            *x = on_surface(genus, 0.5 * (*x + sum / total));
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::curvature::area_gradient;
    use crate::geometry::measure::{min_angle_degrees, vertex_areas, volume};
    use crate::mesh::build_as_given;
    use glam::DQuat;

    #[test]
    fn they_have_the_symmetries_and_handles_of_lawsons_surfaces() {
        for genus in [1, 2, 3, 8] {
            let soup = lawson(genus, 8);
            let built = build_as_given(&soup).expect("a surface");
            assert!(built.repairs.is_empty(), "{:?}", built.repairs);
            let (mesh, x) = (&built.mesh, &built.positions);
            assert_eq!(mesh.euler_characteristic(), 2 - 2 * genus as i64);
            assert!(volume(mesh, x).expect("closed") > 0.0, "{genus}");
            assert!(min_angle_degrees(mesh, x) > 12.0, "{genus}");
            // A turn by a handle about the axis, which is the circle z = 0, and the mirror of the
            // plane of the circle w = 0.
            let turn = std::f64::consts::TAU / (genus + 1) as f64;
            let images = |p: &DVec3| {
                [
                    DQuat::from_rotation_y(turn) * *p,
                    DVec3::new(p.x, -p.y, p.z),
                ]
            };
            for image in x.iter().flat_map(images) {
                let nearest = x.iter().map(|p| p.distance(image));
                let nearest = nearest.fold(f64::INFINITY, f64::min);
                assert!(nearest < 1e-9, "{genus}: {nearest}");
            }
        }
    }

    /// g = 1 is the Clifford torus. The others bend more than Lawson’s, whose ∫H² is 21.89 and 22.82.
    #[test]
    fn their_energies_converge_to_the_second_order() {
        let energy = |genus: usize, cells: usize| {
            let built = build_as_given(&lawson(genus, cells)).expect("a surface");
            let (mesh, x) = (&built.mesh, &built.positions);
            let (g, a) = (area_gradient(mesh, x), vertex_areas(mesh, x));
            let terms = g.iter().zip(&a);
            let sum = terms.map(|(g, a)| g.length_squared() / (4.0 * a));
            sum.sum::<f64>()
        };
        for genus in 1..=3 {
            let [coarse, middle, fine] = [7, 14, 28].map(|cells| energy(genus, cells));
            let order = ((middle - coarse) / (fine - middle)).log2();
            assert!((order - 2.0).abs() < 0.25, "{genus}: {order}");
            let limit = fine + (fine - middle) / 3.0;
            let expected = [2.0 * PI * PI, 25.86, 36.4][genus - 1];
            assert!((limit / expected - 1.0).abs() < 0.002, "{genus}: {limit}");
        }
    }
}
