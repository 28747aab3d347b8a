//! What is measured on the end of a run: formulas on positions. Distances are vertex by vertex,
//! without weights.

use crate::app::State;
use crate::geometry::curvature::vertex_normals;
use crate::mesh::HalfedgeMesh;
use glam::{DMat3, DVec3};

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
                (q.x.hypot(q.y), q.z)
            })
        };
        let rho = mean(profile().map(|(r, _)| r));
        let square = mean(profile().map(|(r, z)| r * r + z * z));
        let covariance = mean(profile().map(|(r, z)| (r - rho) * (r * r + z * z)));
        let two_major = covariance / mean(profile().map(|(r, _)| (r - rho).powi(2)));
        let major = 0.5 * two_major;
        let tube = (square - two_major * rho + major * major).sqrt();
        let off = rms(profile().map(|(r, z)| (r - major).hypot(z) - tube)) / tube;
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
    // A comparison would pass over NaN.
    values
        .map(f64::abs)
        .fold(0.0, |most, value| if most >= value { most } else { value })
}
