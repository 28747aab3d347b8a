//! Morin's and Boy's surface as critical points of the Willmore energy: minimal surfaces with 2p
//! flat ends (Kusner [K87](crate::bibliography#k87)), inverted.
//!
//! With homogeneous z = a/b,
//!
//! ```math
//! \begin{gathered}
//! N = \Bigl( i (a^{2p-1} b - a b^{2p-1}), \; a^{2p-1} b + a b^{2p-1}, \; i \tfrac{p-1}{p} (a^{2p} + b^{2p}) \Bigr) \\
//! D = a^{2p} + r a^p b^p - b^{2p}, \qquad r = \frac{2 \sqrt{2p-1}}{p-1} \\
//! R = \operatorname{Re}(N \bar D) + s |D|^2 e_3, \qquad x = |D|^2 \frac{R}{|R|^2}, \quad x = 0 \text{ where } D = 0.
//! \end{gathered}
//! ```
//!
//! ∫H² = 8πp for every s ≠ 0, which is where the centre of the inversion lies. p = 2 is Morin's
//! surface, halfway in the eversion of the sphere: z ↦ −z is the half turn about z, and z ↦ i/z̄
//! the quarter turn, which changes the sides. For odd p antipodes coincide: p = 3 covers Boy's
//! surface twice.

use super::conformal::{image, place, points};
use crate::order;
use crate::soup::PolygonSoup;
use glam::{DVec2, DVec3};
use std::f64::consts::PI;

/// The numbers for which the surfaces bend least for their size.
pub(super) const MORIN_HEIGHT: f64 = 0.25;
pub(super) const BOY_HEIGHT: f64 = 0.3;

/// Product of complex numbers.
fn times(a: DVec2, b: DVec2) -> DVec2 {
    DVec2::new(a.x * b.x - a.y * b.y, a.x * b.y + a.y * b.x)
}

fn power(a: DVec2, n: usize) -> DVec2 {
    (0..n).fold(DVec2::X, |product, _| times(product, a))
}

/// The point of the surface of that p and s at z = a/b.
pub fn kusner(p: usize, s: f64, a: DVec2, b: DVec2) -> DVec3 {
    let r = 2.0 * (2.0 * p as f64 - 1.0).sqrt() / (p as f64 - 1.0);
    let i = DVec2::Y;
    let (u, v) = (times(power(a, 2 * p - 1), b), times(a, power(b, 2 * p - 1)));
    let (a2p, b2p) = (power(a, 2 * p), power(b, 2 * p));
    let ratio = (p as f64 - 1.0) / p as f64;
    let n = [times(i, u - v), u + v, ratio * times(i, a2p + b2p)];
    let d = a2p + r * times(power(a, p), power(b, p)) - b2p;
    // Re(n d̄) is the scalar product.
    let size = d.length_squared();
    let inverted = DVec3::from_array(n.map(|n| n.dot(d))) + s * size * DVec3::Z;
    size * inverted / inverted.length_squared().max(f64::MIN_POSITIVE)
}

/// Morin's surface with so many vertices and the area 4π. Its two sides are alike, and so its
/// volume is 0 but for the mesh. `push` moves it by push/√(|A|² + 1) along its normals, less
/// where it bends: to one side or the other of the eversion that it is halfway in.
pub fn morin(vertices: usize, s: f64, push: f64) -> PolygonSoup {
    let map = |a: DVec2, b: DVec2| kusner(2, s, a, b);
    let points = points(&map, vertices, false);
    let mut soup = image(&map, &points);
    let area = |soup: &PolygonSoup| {
        let of_face = |f: &[u32]| {
            let [a, b, c] = [f[0], f[1], f[2]].map(|v| soup.positions[v as usize]);
            0.5 * (b - a).cross(c - a).length()
        };
        soup.faces().map(of_face).sum::<f64>()
    };
    let scale = (4.0 * PI / area(&soup)).sqrt();
    for (x, p) in soup.positions.iter_mut().zip(&points) {
        let found = place(&map, *p);
        *x *= scale;
        *x += push * found.normal / (found.bend / (scale * scale) + 1.0).sqrt();
    }
    soup
}

/// Boy's surface with so many vertices: a projective plane, one-sided.
pub fn boy(vertices: usize, s: f64) -> PolygonSoup {
    let cover = boy_cover(2 * vertices, s);
    let below = |v: u32| v % vertices as u32;
    let mut faces: Vec<[u32; 3]> = cover
        .faces()
        .map(|f| [f[0], f[1], f[2]].map(below))
        .collect();
    // Each face has its opposite, which is the same on the surface.
    let key = |mut face: [u32; 3]| {
        face.sort_unstable();
        face
    };
    order::sort_by_key(&mut faces, |face| key(*face));
    faces.dedup_by_key(|face| key(*face));
    PolygonSoup::from_faces(cover.positions[..vertices].to_vec(), &faces)
}

/// The sphere that covers Boy's surface twice, with so many vertices, each in the place of another.
pub fn boy_cover(vertices: usize, s: f64) -> PolygonSoup {
    let map = |a: DVec2, b: DVec2| kusner(3, s, a, b);
    image(&map, &points(&map, vertices & !1, true))
}

#[cfg(test)]
mod tests {
    use super::super::conformal::coordinates;
    use super::*;
    use crate::geometry::curvature::area_gradient;
    use crate::geometry::measure::{area, min_angle_degrees, vertex_areas, volume};
    use crate::mesh::{HalfedgeMesh, build, build_as_given};

    fn willmore(mesh: &HalfedgeMesh, x: &[DVec3]) -> f64 {
        let (g, a) = (area_gradient(mesh, x), vertex_areas(mesh, x));
        let terms = g.iter().zip(&a);
        terms.map(|(g, a)| g.length_squared() / (4.0 * a)).sum()
    }

    #[test]
    fn morins_surface_turns_into_itself() {
        let at = |z: DVec3| {
            let (a, b) = coordinates(z);
            kusner(2, MORIN_HEIGHT, a, b)
        };
        for k in 0..200 {
            let (t, h) = (f64::from(k) * 2.4, f64::from(k) / 100.0 - 0.995);
            let r = (1.0 - h * h).sqrt();
            let p = DVec3::new(r * t.cos(), r * t.sin(), h);
            let x = at(p);
            // z ↦ −z, and z ↦ i/z̄.
            let half = at(DVec3::new(-p.x, -p.y, p.z));
            assert!((half - DVec3::new(-x.x, -x.y, x.z)).length() < 1e-12);
            let quarter = at(DVec3::new(-p.y, p.x, -p.z));
            assert!(
                (quarter - DVec3::new(-x.y, x.x, x.z)).length() < 1e-12,
                "{k}"
            );
        }
    }

    #[test]
    fn morins_surface_has_its_energy() {
        let soup = morin(4000, MORIN_HEIGHT, 0.0);
        let built = build_as_given(&soup).expect("a surface");
        assert!(built.repairs.is_empty());
        let (mesh, x) = (&built.mesh, &built.positions);
        assert_eq!((mesh.euler_characteristic(), x.len()), (2, 4000));
        let energy = willmore(mesh, x) / PI;
        assert!((energy - 16.0).abs() < 0.16, "{energy}");
        assert!(min_angle_degrees(mesh, x) > 15.0);
        let ball = area(mesh, x).powf(1.5) / (6.0 * PI.sqrt());
        let volume = volume(mesh, x).expect("closed").abs() / ball;
        assert!(volume < 0.02, "{volume}");
    }

    #[test]
    fn a_push_goes_to_one_side_all_over() {
        let volume = |push: f64| {
            let built = build_as_given(&morin(700, MORIN_HEIGHT, push)).expect("a surface");
            volume(&built.mesh, &built.positions).expect("closed")
        };
        let [out, still, back] = [0.1, 0.0, -0.1].map(volume);
        // ∫ ε/√(|A|² + 1) over the surface, to first order.
        for change in [out - still, still - back] {
            assert!((0.2..0.8).contains(&change), "{change}");
        }
    }

    #[test]
    fn boys_surface_is_one_sided_and_covered_by_a_sphere() {
        let cover = build(&boy_cover(4000, BOY_HEIGHT)).expect("a surface");
        let energy = willmore(&cover.mesh, &cover.positions) / PI;
        assert!((energy - 24.0).abs() < 0.48, "{energy}");
        let boy = build(&boy(2000, BOY_HEIGHT)).expect("a surface");
        assert_eq!(boy.mesh.euler_characteristic(), 1);
        assert!(boy.mesh.is_closed() && !boy.mesh.is_oriented());
        let energy = willmore(&boy.mesh, &boy.positions) / PI;
        assert!((energy - 12.0).abs() < 0.24, "{energy}");
    }
}
