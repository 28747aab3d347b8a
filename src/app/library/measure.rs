//! What is measured on the end of a run: formulas on positions. Distances are vertex by vertex,
//! without weights.

use crate::app::State;
use crate::geometry::curvature::vertex_normals;
use crate::mesh::HalfedgeMesh;
use glam::{DMat3, DVec2, DVec3};

/// Whether a value is within a share of what is expected.
pub fn near(value: f64, expected: f64, relative: f64) -> bool {
    (value / expected - 1.0).abs() <= relative
}

/// How far the area is from that at the start, relative.
pub fn area_drift(first: &State, last: &State) -> f64 {
    (last.area / first.area - 1.0).abs()
}

/// The same of the volume; NaN of a surface that has none.
pub fn volume_drift(first: &State, last: &State) -> f64 {
    match (first.volume, last.volume) {
        (Some(first), Some(last)) => (last / first - 1.0).abs(),
        _ => f64::NAN,
    }
}

/// Distance from the sphere that fits best, root mean square over its radius: |p|² = 2c·p + k in
/// least squares.
pub fn off_sphere(x: &[DVec3]) -> f64 {
    let centroid = mean_point(x);
    let (mut matrix, mut rhs) = (DMat3::ZERO, DVec3::ZERO);
    for p in x {
        let q = *p - centroid;
        matrix += DMat3::from_cols(q.x * q, q.y * q, q.z * q);
        rhs += 0.5 * q.length_squared() * q;
    }
    let centre = centroid + matrix.inverse() * rhs;
    let radius = mean(x.iter().map(|p| p.distance(centre)));
    rms(x.iter().map(|p| p.distance(centre) / radius - 1.0))
}

/// Largest distance from the unit sphere about the origin.
pub fn off_unit_sphere(x: &[DVec3]) -> f64 {
    largest(x.iter().map(|p| p.length() - 1.0))
}

/// Largest distance from a cylinder about a coordinate axis, over its radius.
pub fn off_tube(x: &[DVec3], axis: usize, radius: f64) -> f64 {
    largest(x.iter().map(|p| {
        let mut across = p.to_array();
        across[axis] = 0.0;
        DVec3::from_array(across).length() / radius - 1.0
    }))
}

/// The torus of revolution about z that fits best, ρ² + z² = 2Rρ + c in least squares, ρ and z
/// from the centroid.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct TorusFit {
    /// R.
    pub major: f64,
    /// r.
    pub tube: f64,
    /// Distance from it, root mean square over r.
    pub off: f64,
}

impl TorusFit {
    /// Of these points.
    pub fn of(x: &[DVec3]) -> Self {
        let centroid = mean_point(x);
        let profile = || {
            x.iter().map(|p| {
                let q = *p - centroid;
                (q.truncate().length(), q.z)
            })
        };
        let rho = mean(profile().map(|(r, _)| r));
        let square = mean(profile().map(|(r, z)| r * r + z * z));
        let covariance = mean(profile().map(|(r, z)| (r - rho) * (r * r + z * z)));
        let two_major = covariance / mean(profile().map(|(r, _)| (r - rho).powi(2)));
        let major = 0.5 * two_major;
        let tube = (square - two_major * rho + major * major).sqrt();
        let off = rms(profile().map(|(r, z)| DVec2::new(r - major, z).length() - tube)) / tube;
        Self { major, tube, off }
    }

    /// R/r.
    pub fn ratio(&self) -> f64 {
        self.major / self.tube
    }
}

/// Largest distance along z from the plane z = ax + by + c that fits best, over the root mean
/// square extent in x and y.
pub fn off_plane(x: &[DVec3]) -> f64 {
    let centroid = mean_point(x);
    let (mut xx, mut xy, mut yy, mut xz, mut yz) = (0.0, 0.0, 0.0, 0.0, 0.0);
    for p in x {
        let q = *p - centroid;
        xx += q.x * q.x;
        xy += q.x * q.y;
        yy += q.y * q.y;
        xz += q.x * q.z;
        yz += q.y * q.z;
    }
    let determinant = xx * yy - xy * xy;
    let a = (xz * yy - yz * xy) / determinant;
    let b = (yz * xx - xz * xy) / determinant;
    let off = largest(x.iter().map(|p| {
        let q = *p - centroid;
        q.z - a * q.x - b * q.y
    }));
    off / ((xx + yy) / x.len() as f64).sqrt()
}

/// Distance of vertices from the equally numbered ones of a surface along its normals, root mean
/// square over those for which `counts`: sliding along the surface is no distance.
pub fn off_surface(
    x: &[DVec3],
    mesh: &HalfedgeMesh,
    surface: &[DVec3],
    counts: impl Fn(usize) -> bool,
) -> f64 {
    let normals = vertex_normals(mesh, surface);
    let vertices = (0..surface.len()).filter(|&v| counts(v));
    rms(vertices.map(|v| (x[v] - surface[v]).dot(normals[v])))
}

fn mean_point(x: &[DVec3]) -> DVec3 {
    x.iter().sum::<DVec3>() / x.len() as f64
}

fn mean(values: impl Iterator<Item = f64>) -> f64 {
    let (sum, count) = values.fold((0.0, 0.0), |(sum, n), value| (sum + value, n + 1.0));
    sum / count
}

fn rms(values: impl Iterator<Item = f64>) -> f64 {
    mean(values.map(|value| value * value)).sqrt()
}

fn largest(values: impl Iterator<Item = f64>) -> f64 {
    let larger = |most: f64, value: f64| {
        // A comparison alone would pass over NaN.
        let replaces = value > most || value.is_nan();
        if replaces { value } else { most }
    };
    values.map(f64::abs).fold(0.0, larger)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{build, shape};

    fn sample(name: &str) -> (HalfedgeMesh, Vec<DVec3>) {
        let built = build(&shape::make(name, &[]).expect("a shape").soup).expect("a surface");
        (built.mesh, built.positions)
    }

    /// A pattern of amplitude 1 that alternates with the number of the vertex.
    fn alternating(v: usize) -> f64 {
        if v.is_multiple_of(2) { 1.0 } else { -1.0 }
    }

    #[test]
    fn a_sphere_anywhere_is_none_off_and_a_rough_one_by_its_roughness() {
        let (_, x) = sample("icosphere");
        let moved: Vec<DVec3> = x
            .iter()
            .map(|p| 3.0 * *p + DVec3::new(5.0, -2.0, 1.0))
            .collect();
        assert!(off_sphere(&moved) < 1e-12, "{}", off_sphere(&moved));
        assert!(off_unit_sphere(&x) < 1e-12);
        assert!(
            (off_unit_sphere(&moved) - 7.0).abs() < 1.5,
            "{}",
            off_unit_sphere(&moved)
        );
        // Of a cap the centroid is not the centre.
        let cap: Vec<DVec3> = moved.iter().copied().filter(|p| p.z > 1.5).collect();
        assert!(off_sphere(&cap) < 1e-12, "{}", off_sphere(&cap));
        let rough: Vec<DVec3> = (x.iter().enumerate())
            .map(|(v, p)| *p * (1.0 + 1e-4 * alternating(v)))
            .collect();
        let off = off_sphere(&rough);
        assert!((off / 1e-4 - 1.0).abs() < 1e-2, "{off}");
        assert!((off_unit_sphere(&rough) / 1e-4 - 1.0).abs() < 1e-9);
    }

    #[test]
    fn a_torus_of_revolution_has_its_own_radii() {
        // Evenly about both circles, as the centroid has to be its centre.
        let around = |n: usize| (0..n).map(move |i| std::f64::consts::TAU * i as f64 / n as f64);
        let torus = |wobble: f64| {
            let at = move |(u, v): (f64, f64)| {
                let tube = 0.5 + wobble * (2.0 * v).cos();
                let rho = 2.0 + tube * v.cos();
                DVec3::new(rho * u.cos() + 7.0, rho * u.sin(), tube * v.sin() - 1.0)
            };
            let angles = around(48).flat_map(|u| around(24).map(move |v| (u, v)));
            angles.map(at).collect::<Vec<_>>()
        };
        let exact = TorusFit::of(&torus(0.0));
        assert!((exact.major - 2.0).abs() < 1e-12 && (exact.tube - 0.5).abs() < 1e-12);
        assert!((exact.ratio() - 4.0).abs() < 1e-11 && exact.off < 1e-12);
        let wobbling = TorusFit::of(&torus(1e-4));
        // The mean square of a cosine is a half.
        let expected = 1e-4 / 0.5 / 2f64.sqrt();
        assert!(
            (wobbling.off / expected - 1.0).abs() < 1e-2,
            "{}",
            wobbling.off
        );
    }

    #[test]
    fn a_plane_is_flat_however_it_leans_and_a_tube_round_about_its_axis() {
        let grid = (0..100).map(|i| (f64::from(i % 10), f64::from(i / 10)));
        let plane: Vec<DVec3> = grid
            .map(|(x, y)| DVec3::new(x, y, 0.3 * x - 2.0 * y + 4.0))
            .collect();
        assert!(off_plane(&plane) < 1e-12);
        let mut lifted = plane.clone();
        lifted[55].z += 0.01;
        // Of 100 points one, over the root mean square extent √(2·8.25).
        let expected = 0.01 * (1.0 - 1.0 / 100.0) / 16.5f64.sqrt();
        assert!(
            (off_plane(&lifted) / expected - 1.0).abs() < 0.01,
            "{}",
            off_plane(&lifted)
        );
        let tube: Vec<DVec3> = (0..40)
            .map(|i| {
                DVec3::new(
                    f64::from(i),
                    2.0 * f64::from(i).sin(),
                    2.0 * f64::from(i).cos(),
                )
            })
            .collect();
        assert!(off_tube(&tube, 0, 2.0) < 1e-12);
        assert!((off_tube(&tube, 0, 1.0) - 1.0).abs() < 1e-12);
        assert!(off_tube(&tube, 2, 2.0) > 1.0);
    }

    #[test]
    fn sliding_along_a_surface_is_no_distance_from_it() {
        let (mesh, surface) = sample("icosphere");
        let normals = vertex_normals(&mesh, &surface);
        let pushed = |along: f64, out: f64| {
            let across = |v: usize| normals[v].any_orthonormal_vector();
            (0..surface.len())
                .map(|v| surface[v] + along * across(v) + out * alternating(v) * normals[v])
                .collect::<Vec<_>>()
        };
        assert!(off_surface(&pushed(0.1, 0.0), &mesh, &surface, |_| true) < 1e-12);
        let off = off_surface(&pushed(0.1, 0.01), &mesh, &surface, |v| v > 10);
        assert!((off - 0.01).abs() < 1e-12, "{off}");
    }

    #[test]
    fn what_is_not_a_number_is_not_near_and_not_small() {
        assert!(near(1.01, 1.0, 0.011) && !near(1.01, 1.0, 0.009) && !near(f64::NAN, 1.0, 1.0));
        assert!(off_unit_sphere(&[DVec3::X, DVec3::NAN, DVec3::Y]).is_nan());
        let (open, closed) = (
            State::default(),
            State {
                volume: Some(2.0),
                area: 3.0,
                ..State::default()
            },
        );
        assert!(volume_drift(&open, &closed).is_nan());
        let grown = State {
            volume: Some(2.2),
            area: 2.7,
            ..State::default()
        };
        assert!((volume_drift(&closed, &grown) - 0.1).abs() < 1e-12);
        assert!((area_drift(&closed, &grown) - 0.1).abs() < 1e-12);
    }
}
