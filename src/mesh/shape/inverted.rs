//! Minimal surfaces inverted in a sphere: closed surfaces whose ∫H² is 4π times the number of
//! sheets that pass through the centre.
//!
//! The ends of the minimal surface all come to the origin. Sheets that touch there are not joined:
//! they are apart in the mesh.

use super::conformal::{image, points};
use crate::soup::PolygonSoup;
use glam::{DVec2, DVec3};

/// Product of one complex number with the conjugate of another.
fn with_conjugate(a: DVec2, b: DVec2) -> DVec2 {
    DVec2::new(a.dot(b), a.y * b.x - a.x * b.y)
}

/// Point of the catenoid (cosh u cos v, cosh u sin v, u) at e^(u + iv) = a/b, inverted in the unit
/// sphere about its middle.
fn catenoid_at(a: DVec2, b: DVec2) -> DVec3 {
    let (p, q) = (a.length(), b.length());
    let small = p.min(q) / p.max(q);
    if small == 0.0 {
        return DVec3::ZERO;
    }
    let u = (p / q).ln();
    let turn = with_conjugate(a, b) / (p * q);
    // Numerator and denominator by the square of e^(−|u|), which vanishes at the ends.
    let half = 0.5 * (1.0 + small * small);
    let numerator = (small * half * turn).extend(small * small * u);
    numerator / (half * half + (small * u).powi(2))
}

/// The inverted catenoid, with so many vertices: two sheets touch, ∫H² = 8π. Where they do it is
/// smooth to the first derivatives only.
pub fn catenoid(vertices: usize) -> PolygonSoup {
    image(&catenoid_at, &points(&catenoid_at, vertices, false))
}

/// Point of Enneper's surface Re(z − z³/3, i(z + z³/3), z²) at z = a/b, inverted in the unit
/// sphere about (0, 0, 1), which is not on it.
fn enneper_at(a: DVec2, b: DVec2) -> DVec3 {
    let weight = b.length_squared();
    let z = with_conjugate(a, b);
    let square = DVec2::new(z.x * z.x - z.y * z.y, 2.0 * z.x * z.y);
    let cube = DVec2::new(
        square.x * z.x - square.y * z.y,
        square.x * z.y + square.y * z.x,
    );
    // All by |b|⁶, and mirrored in y, so that the faces look outward.
    let first = weight * weight * z;
    let y = DVec3::new(
        first.x - cube.x / 3.0,
        first.y + cube.y / 3.0,
        weight * square.x - weight.powi(3),
    );
    weight.powi(3) * y / y.length_squared().max(f64::MIN_POSITIVE)
}

/// The inverted surface of Enneper, with so many vertices: ∫H² = 12π. Its end winds three
/// times around the origin, a branch point that no flow resolves.
pub fn enneper(vertices: usize) -> PolygonSoup {
    image(&enneper_at, &points(&enneper_at, vertices, false))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::curvature::area_gradient;
    use crate::geometry::measure::vertex_areas;
    use crate::mesh::build;
    use std::f64::consts::PI;

    /// ∫H² over π at the vertices farther than `least` from the origin.
    fn willmore(soup: &PolygonSoup, least: f64) -> f64 {
        let built = build(soup).expect("a surface");
        assert_eq!(built.mesh.euler_characteristic(), 2);
        let (mesh, x) = (&built.mesh, &built.positions);
        let (g, a) = (area_gradient(mesh, x), vertex_areas(mesh, x));
        let far = (0..x.len()).filter(|&v| x[v].length() >= least);
        far.map(|v| g[v].length_squared() / (4.0 * a[v]))
            .sum::<f64>()
            / PI
    }

    #[test]
    fn the_inverted_catenoid_has_the_energy_of_two_sheets() {
        let energies = [1500, 4000].map(|n| willmore(&catenoid(n), 0.0));
        for energy in energies {
            assert!((energy - 8.0).abs() < 0.08, "{energies:?}");
        }
    }

    /// Of 12π the part away from the branch point, where no mesh has a limit.
    #[test]
    fn the_inverted_surface_of_enneper_converges_away_from_its_branch_point() {
        let energies = [2000, 8000].map(|n| willmore(&enneper(n), 0.1));
        let change = energies[0] / energies[1] - 1.0;
        assert!(change.abs() < 0.02, "{energies:?}");
        assert!(energies[1] > 8.0 && energies[1] < 12.0, "{energies:?}");
    }
}
