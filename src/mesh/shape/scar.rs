//! A stone with a scar to be healed: figure 11 of Bobenko & Schröder
//! [BS05](crate::bibliography#bs05).

use glam::DVec3;

use super::Sample;
use super::sphere::moved;
use crate::mesh::noise::SplitMix64;
use crate::mesh::subdivide::SubdivisionError;

/// Cosine of the angle at the centre between the middle of the free patch and its rim.
const PATCH: f64 = 0.716;
/// Half the angle that the trench spans lengthwise, and its half width, in radians.
const TRENCH: (f64, f64) = (0.46, 0.12);

/// An egg-shaped stone with a ragged trench, `depth` mean edge lengths deep.
///
/// The vertices of a round patch around the trench, 14 % of all, are free; with
/// `depth` 0 the stone is whole and the patch the same.
pub fn scar(level: usize, depth: f64, seed: u64) -> Result<Sample, SubdivisionError> {
    let middle = DVec3::new(0.25, 0.3, 0.9).normalize();
    // A slanting frame at the middle of the patch: the trench runs along `along`.
    let along = DVec3::new(0.55, 1.0, 0.0)
        .reject_from_normalized(middle)
        .normalize();
    let across = middle.cross(along);

    let directions = moved(level, |p| p)?.positions;
    let mut soup = moved(level, stone)?;
    // Mean edge length of a triangulation of the unit sphere by n vertices.
    let edge = (8.0 * std::f64::consts::PI / (3.0_f64.sqrt() * directions.len() as f64)).sqrt();
    let mut random = SplitMix64::new(seed);
    for (x, p) in soup.positions.iter_mut().zip(&directions) {
        let (u, v) = (p.dot(along), p.dot(across));
        // Drawn for each vertex, so that the damage does not depend on the patch.
        let ragged = random.gaussian();
        if p.dot(middle) > PATCH {
            // A slightly bent cut, with lips thrown up at its sides.
            let along = (u / TRENCH.0).powi(8);
            let across = (v - 0.5 * u * u + 0.012 * ragged) / TRENCH.1;
            let cut = (-along - across.powi(4)).exp();
            let lip = (-along - (across.abs() - 1.6).powi(2) * 4.0).exp();
            *x -= *p * (depth * edge * (cut * (1.0 + 0.1 * ragged) - 0.25 * lip));
        }
    }
    let free = (0..directions.len()).filter(|&v| directions[v].dot(middle) > PATCH);
    Ok(Sample {
        free: Some(free.map(|v| v as u32).collect()),
        ..soup.into()
    })
}

/// The whole stone in direction `p`: an egg with the thick end below, y upwards and shallow dents.
fn stone(p: DVec3) -> DVec3 {
    let dents = (3.1 * p.x + 0.4).sin() * (2.7 * p.y - 0.8).cos() + (3.7 * p.z + 1.9 * p.x).sin();
    let radius = 1.0 + 0.035 * dents;
    let taper = 1.0 - 0.14 * p.y;
    DVec3::new(p.x * taper, p.y * 1.3, p.z * taper * 0.92) * radius
}
