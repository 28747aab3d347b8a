//! Vesicles, surfaces with area and volume kept: which branch of shapes one is on, and a push
//! for a start whose symmetry keeps it on an unstable one.
//!
//! For each reduced volume there are several axisymmetric shapes at rest, prolate, oblate and
//! dented ones (stomatocytes), of which one has the least energy (Seifert, Berndl & Lipowsky
//! [SBL91](crate::bibliography#sbl91)). A flow that leads the volume stays on the branch it
//! started on, and one with a symmetry stays symmetric even where that is unstable.

use super::Warning;
use crate::geometry::curvature::vertex_normals;
use crate::geometry::measure;
use crate::mesh::HalfedgeMesh;
use glam::{DMat3, DVec3};

/// Principal lengths that differ by less are equal.
const EQUAL: f64 = 0.05;

/// Moves each vertex along its normal by up to `amplitude`, by numbers that only look random:
/// the same each time.
pub fn perturb(mesh: &HalfedgeMesh, x: &mut [DVec3], amplitude: f64) {
    if amplitude == 0.0 {
        return;
    }
    let normals = vertex_normals(mesh, x);
    let mut state = 0x9e37_79b9_7f4a_7c15_u64;
    for (p, n) in x.iter_mut().zip(normals) {
        // SplitMix64 (Steele, Lea & Flood 2014).
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        let unit = ((z ^ (z >> 31)) >> 11) as f64 / (1u64 << 53) as f64;
        *p += amplitude * (2.0 * unit - 1.0) * n;
    }
}

/// The shape of a surface as a [`Warning::Branch`]: prolate, oblate or with three axes, by the
/// principal lengths of its vertices about their centre.
pub fn branch(mesh: &HalfedgeMesh, x: &[DVec3]) -> Warning {
    let areas = if mesh.is_triangular() {
        measure::vertex_areas(mesh, x)
    } else {
        vec![1.0; x.len()]
    };
    let total: f64 = areas.iter().sum();
    let centre = x.iter().zip(&areas).map(|(p, a)| *a * *p).sum::<DVec3>() / total;
    let mut second = DMat3::ZERO;
    for (p, a) in x.iter().zip(&areas) {
        let r = *p - centre;
        second += DMat3::from_cols(r * r.x, r * r.y, r * r.z) * (a / total);
    }
    let [a, b, c] = principal_lengths(second);
    let shape = match (b > (1.0 - EQUAL) * a, c > (1.0 - EQUAL) * b) {
        (true, true) => "round",
        (false, true) => "prolate",
        (true, false) => "oblate",
        (false, false) => "triaxial",
    };
    Warning::Branch {
        shape,
        middle: b / a,
        shortest: c / a,
    }
}

/// Square roots of the eigenvalues of a symmetric positive matrix, falling, by its
/// characteristic polynomial.
fn principal_lengths(m: DMat3) -> [f64; 3] {
    let trace = m.x_axis.x + m.y_axis.y + m.z_axis.z;
    let mean = trace / 3.0;
    let off = m - DMat3::from_diagonal(DVec3::splat(mean));
    let squares = off.x_axis.length_squared() + off.y_axis.length_squared();
    let spread = ((squares + off.z_axis.length_squared()) / 6.0).sqrt();
    if spread <= 1e-12 * mean {
        return [mean.sqrt(); 3];
    }
    let r = (0.5 * (off * (1.0 / spread)).determinant()).clamp(-1.0, 1.0);
    let angle = r.acos() / 3.0;
    let third = std::f64::consts::TAU / 3.0;
    let first = mean + 2.0 * spread * angle.cos();
    let last = mean + 2.0 * spread * (angle + third).cos();
    let middle = trace - first - last;
    [first, middle, last].map(|v| v.max(0.0).sqrt())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{build, shape};

    #[test]
    fn ellipsoids_are_told_apart() {
        let ball = shape::make("icosphere", &[("level".into(), 3.0)]).expect("a shape");
        let built = build(&ball.soup).expect("a surface");
        for (axes, name) in [
            ([1.0, 1.0, 1.0], "round"),
            ([1.0, 2.0, 1.0], "prolate"),
            ([2.0, 1.0, 2.0], "oblate"),
            ([1.0, 2.0, 3.0], "triaxial"),
        ] {
            let scale = DVec3::from_array(axes);
            let x: Vec<DVec3> = built.positions.iter().map(|p| scale * *p).collect();
            let found = branch(&built.mesh, &x);
            assert!(
                matches!(found, Warning::Branch { shape, .. } if shape == name),
                "{axes:?}: {found}"
            );
        }
        // Wherever its vertices crowd.
        let pinched = |p: &DVec3| (*p + DVec3::new(0.0, 0.0, 1.6 * p.z.powi(3))).normalize();
        let x: Vec<DVec3> = built.positions.iter().map(pinched).collect();
        let found = branch(&built.mesh, &x);
        assert!(
            matches!(found, Warning::Branch { shape: "round", .. }),
            "{found}"
        );
    }

    #[test]
    fn principal_lengths_do_not_depend_on_the_axes() {
        let turn = DMat3::from_euler(glam::EulerRot::XYZ, 0.3, 1.1, -0.7);
        let m = turn * DMat3::from_diagonal(DVec3::new(4.0, 25.0, 9.0)) * turn.transpose();
        let found = principal_lengths(m);
        for (found, expected) in found.into_iter().zip([5.0, 3.0, 2.0]) {
            assert!((found - expected).abs() < 1e-9, "{found}");
        }
    }

    #[test]
    fn a_perturbation_is_small_and_repeatable() {
        let ball = shape::make("icosphere", &[("level".into(), 2.0)]).expect("a shape");
        let built = build(&ball.soup).expect("a surface");
        let [mut a, mut b] = [built.positions.clone(), built.positions.clone()];
        perturb(&built.mesh, &mut a, 0.01);
        perturb(&built.mesh, &mut b, 0.01);
        assert_eq!(a, b);
        let moved = a.iter().zip(&built.positions).map(|(p, q)| p.distance(*q));
        let most = moved.fold(0.0, f64::max);
        assert!(most > 0.005 && most <= 0.01, "{most}");
        // To both sides, and along the normals only.
        let radii: Vec<f64> = a.iter().map(|p| p.length() - 1.0).collect();
        assert!(radii.iter().any(|r| *r > 0.005) && radii.iter().any(|r| *r < -0.005));
        let aside = a.iter().zip(&built.positions);
        let aside = aside.map(|(p, q)| p.reject_from(*q).length());
        assert!(aside.fold(0.0, f64::max) < 1e-3);
    }
}
