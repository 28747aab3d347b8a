//! Every reading of a triangle mesh that a flow's report needs, in one pass.

use super::measure::triangle_points;
use crate::interrupt::paced;
use crate::mesh::{Face, HalfedgeMesh};
use glam::DVec3;

/// What [`survey`] found; the same as the functions of [`measure`](super::measure) and
/// [`quality`](super::quality) by these names tell.
#[derive(Clone, Debug, PartialEq)]
pub struct Survey {
    /// Total area.
    pub area: f64,
    /// Signed volume; `None` unless closed and oriented.
    pub volume: Option<f64>,
    /// Smallest corner angle.
    pub min_angle_degrees: f64,
    /// The worst triangle and its quality.
    pub worst: Option<(Face, f64)>,
    /// Faces whose normal has turned by more than a right angle.
    pub turned: Vec<Face>,
}

/// Surveys the triangles at `x`, and which of them turned over on the way from `before`.
pub fn survey(mesh: &HalfedgeMesh, before: &[DVec3], x: &[DVec3]) -> Survey {
    let has_volume = mesh.is_closed() && mesh.is_oriented() && !x.is_empty();
    let origin = x.first().copied().unwrap_or_default();
    let (mut area, mut volume) = (0.0, 0.0);
    let mut min_tangent = f64::INFINITY;
    let mut worst: Option<(Face, f64)> = None;
    let mut turned = Vec::new();
    for f in paced(mesh.faces()) {
        let [a, b, c] = triangle_points(mesh, x, f);
        let (u, v, w) = (b - a, c - a, c - b);
        let normal = u.cross(v);
        let size = normal.length();
        area += 0.5 * size;
        volume += (a - origin).dot(normal);
        // The smallest angle is acute, and has the largest product of its two sides.
        let product = u.dot(v).max(-u.dot(w)).max(v.dot(w));
        let tangent = if product > 0.0 { size / product } else { 0.0 };
        min_tangent = min_tangent.min(tangent);
        let edges = u.length_squared() + v.length_squared() + w.length_squared();
        let quality = if edges > 0.0 {
            2.0 * 3f64.sqrt() * size / edges
        } else {
            0.0
        };
        if worst.is_none_or(|(_, least)| quality < least) {
            worst = Some((f, quality));
        }
        let [a, b, c] = triangle_points(mesh, before, f);
        if (b - a).cross(c - a).dot(normal) < 0.0 {
            turned.push(f);
        }
    }
    Survey {
        area,
        volume: has_volume.then_some(volume / 6.0),
        min_angle_degrees: min_tangent.atan().to_degrees(),
        worst,
        turned,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::{measure, quality};
    use crate::mesh::{build, shape};

    #[test]
    fn one_pass_tells_what_the_single_readings_tell() {
        for name in ["bumpy-sphere", "moebius", "monkey-saddle"] {
            let sample = shape::make(name, &[]).expect("a shape");
            let built = build(&sample.soup).expect("a surface");
            let (mesh, x) = (built.mesh, built.positions);
            // Pulled through the origin: some triangles turn over.
            let mut y = x.clone();
            y.iter_mut().step_by(7).for_each(|p| *p *= -0.3);
            let found = survey(&mesh, &x, &y);
            let is_close = |a: f64, b: f64| (a - b).abs() < 1e-12 * b.abs();
            assert!(is_close(found.area, measure::area(&mesh, &y)));
            let angle = measure::min_angle_degrees(&mesh, &y);
            assert!((found.min_angle_degrees - angle).abs() < 1e-12);
            let normal = |x: &[DVec3], f| measure::face_vector_area(&mesh, x, f);
            let turned = |f: &Face| normal(&x, *f).dot(normal(&y, *f)) < 0.0;
            assert_eq!(
                found.turned,
                mesh.faces().filter(turned).collect::<Vec<_>>()
            );
            let folded = |f: &Face| quality::is_folded(&mesh, &y, *f);
            let newly: Vec<Face> = found.turned.iter().copied().filter(folded).collect();
            assert_eq!(newly, quality::newly_folded(&mesh, &x, &y));
            assert!(!found.turned.is_empty() && found.turned.len() < mesh.n_faces());
            let (worst, expected) = (found.worst, quality::worst_triangle(&mesh, &y));
            let ((f, q), (g, r)) = worst.zip(expected).expect("triangles");
            assert!(f == g && is_close(q, r));
            match (found.volume, measure::volume(&mesh, &y)) {
                (Some(v), Some(w)) => assert!(is_close(v, w)),
                (v, w) => assert_eq!(v, w),
            }
        }
    }

    #[test]
    fn a_collapsed_triangle_has_the_angle_zero() {
        let sample = shape::make("monkey-saddle", &[]).expect("a shape");
        let built = build(&sample.soup).expect("a surface");
        let x = vec![DVec3::ONE; built.mesh.n_vertices()];
        let found = survey(&built.mesh, &x, &x);
        assert_eq!((found.area, found.min_angle_degrees), (0.0, 0.0));
        assert_eq!(found.worst.map(|(_, q)| q), Some(0.0));
    }
}
