//! Steps without a part along the conformal maps of space (`flow/conformal_fields.rs`): least far
//! out on the orbit of a mesh under them, ∫H² would go on falling, growing the mesh. What is left
//! still descends.

use crate::energy::p_willmore::Evaluation;
use crate::flow::conformal_fields::{self, COUNT};
use crate::flow::constraint::dot;
use glam::DVec3;

/// M v of the fields' normal parts, end to end, unit length³ up to their scale.
pub(super) fn fields(x: &[DVec3], at: &Evaluation) -> Vec<DVec3> {
    let total: f64 = at.mass.iter().sum();
    let weighted = x.iter().zip(&at.mass).map(|(p, m)| *m * *p);
    let centre = weighted.sum::<DVec3>() / total;
    let scale = total.sqrt();
    let mut fields = Vec::with_capacity(COUNT * x.len());
    for k in 0..COUNT {
        for (i, p) in x.iter().enumerate() {
            let n = at.volume_gradient[i].normalize_or_zero();
            let y = (*p - centre) / scale;
            let v = conformal_fields::velocity(k, y);
            fields.push(at.mass[i] * v.dot(n) * n);
        }
    }
    fields
}

/// Adds to `d` what makes it orthogonal to the fields, of their responses u_k = H⁻¹g_k: with a
/// symmetric positive H the sum descends as `d` does.
pub(super) fn remove(d: &mut [DVec3], responses: &[DVec3], fields: &[DVec3]) {
    let n = d.len();
    let field = |k: usize| &fields[k * n..(k + 1) * n];
    let response = |k: usize| &responses[k * n..(k + 1) * n];
    let mut matrix = [[0.0; COUNT]; COUNT];
    let mut rhs = [0.0; COUNT];
    for j in 0..COUNT {
        for (k, entry) in matrix[j].iter_mut().enumerate() {
            *entry = dot(field(j), response(k));
        }
        rhs[j] = -dot(field(j), d);
    }
    let lambda = solve(matrix, rhs);
    for (k, lambda) in lambda.into_iter().enumerate() {
        d.iter_mut()
            .zip(response(k))
            .for_each(|(d, u)| *d += lambda * *u);
    }
}

/// Gaussian elimination with a symmetric positive semi-definite matrix; a field that depends
/// on those before, as the special conformal ones do on a round sphere about its centre, is
/// left out.
fn solve(mut a: [[f64; COUNT]; COUNT], mut b: [f64; COUNT]) -> [f64; COUNT] {
    let size = (0..COUNT).map(|k| a[k][k]).fold(0.0, f64::max);
    let mut is_used = [true; COUNT];
    for p in 0..COUNT {
        if a[p][p] <= 1e-12 * size {
            is_used[p] = false;
            continue;
        }
        for r in (0..COUNT).filter(|&r| r != p) {
            let factor = a[r][p] / a[p][p];
            let pivot = a[p];
            for (entry, value) in a[r].iter_mut().zip(pivot) {
                *entry -= factor * value;
            }
            b[r] -= factor * b[p];
        }
    }
    let mut x = [0.0; COUNT];
    for k in (0..COUNT).filter(|&k| is_used[k]) {
        x[k] = b[k] / a[k][k];
    }
    x
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::energy::p_willmore::{Helfrich, PWillmore};
    use crate::operator::Mass;

    #[test]
    fn what_is_left_is_orthogonal_to_the_fields() {
        // H = 1: the responses are the fields themselves.
        let n = 9;
        let wave = |k: usize, i: usize| {
            let t = (k * n + i) as f64;
            DVec3::new(t.sin(), (1.7 * t).cos(), (0.3 * t * t).sin())
        };
        let fields: Vec<DVec3> = (0..COUNT * n).map(|i| wave(0, i)).collect();
        let mut d: Vec<DVec3> = (0..n).map(|i| wave(7, i)).collect();
        let before = dot(&d, &d);
        remove(&mut d, &fields, &fields);
        for k in 0..COUNT {
            let along = dot(&fields[k * n..(k + 1) * n], &d);
            assert!(along.abs() < 1e-12, "{along}");
        }
        assert!(dot(&d, &d) < before);
    }

    /// About its centre a sphere has no field but the scaling and the translations: of the special
    /// conformal fields the normal part is b·n, as b is a translation's. An ellipsoid has all four,
    /// and they do not depend on where it is.
    #[test]
    fn fields_are_those_of_the_conformal_maps_about_the_centre() {
        let shape = crate::mesh::shape::make("ellipsoid", &[("level".into(), 3.0)]);
        let built = crate::mesh::build(&shape.expect("a shape").soup).expect("a surface");
        let mesh = std::rc::Rc::new(built.mesh);
        let fields_at = |x: &[DVec3]| {
            let functional = PWillmore::new(
                std::rc::Rc::clone(&mesh),
                x,
                2.0,
                Helfrich::default(),
                Mass::Lumped,
            );
            let mut at = Evaluation::default();
            functional.expect("triangles").evaluate(x, &mut at);
            (fields(x, &at), at)
        };
        let x = built.positions;
        let (here, at) = fields_at(&x);
        let far: Vec<DVec3> = x.iter().map(|p| *p + 7.0).collect();
        let (there, _) = fields_at(&far);
        let off = here.iter().zip(&there).map(|(a, b)| a.distance(*b));
        assert!(off.fold(0.0, f64::max) < 1e-12);
        let scale = at.mass.iter().sum::<f64>().sqrt();
        for (i, p) in x.iter().enumerate() {
            let n = at.volume_gradient[i].normalize();
            let (y, m) = (*p / scale, at.mass[i]);
            assert!((here[i] - m * y.dot(n) * n).length() < 1e-12);
            for k in 0..3 {
                // Derivative at 0 of the inverse of y/|y|² + t b, which is y + t (…).
                let t = 1e-6;
                let moved = |t: f64| {
                    let z = y / y.length_squared() + t * DVec3::AXES[k];
                    z / z.length_squared()
                };
                let v = (moved(-t) - moved(t)) / (2.0 * t);
                let found = here[(k + 1) * x.len() + i];
                assert!((found - m * v.dot(n) * n).length() < 1e-8 * m, "{k}, {i}");
            }
        }
    }

    #[test]
    fn dependent_fields_do_no_harm() {
        let mut fields = vec![DVec3::ZERO; 4];
        fields[0] = DVec3::X;
        fields[1] = 2.0 * DVec3::X;
        let mut d = vec![DVec3::new(3.0, 1.0, 0.0)];
        remove(&mut d, &fields.clone(), &fields);
        assert!((d[0] - DVec3::Y).length() < 1e-12, "{d:?}");
    }
}
