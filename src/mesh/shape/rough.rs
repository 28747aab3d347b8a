//! Surfaces that are sampled well and triangulated badly: starts for edge flips, after the
//! figures of Brink & Alboul [BA](crate::bibliography#ba).

use std::f64::consts::TAU;

use glam::{DVec2, DVec3};

use super::face::height;
use super::torus::on_torus;
use super::{Conflict, grid, sphere};
use crate::mesh::noise::SplitMix64;
use crate::mesh::subdivide::SubdivisionError;
use crate::soup::PolygonSoup;

/// The quadrilateral i, j, k, l = (0,0,0), (3,0,0), (0,4,0), (1,0,1) as the faces i k j and
/// i j l: the flip of ij raises the area and lowers the localised Willmore energy, against
/// the conjecture of Brink & Alboul.
pub fn counterexample() -> PolygonSoup {
    let positions = [[0., 0., 0.], [3., 0., 0.], [0., 4., 0.], [1., 0., 1.]];
    let positions = positions.map(DVec3::from_array).to_vec();
    PolygonSoup::from_faces(positions, &[[0, 2, 1], [0, 1, 3]])
}

/// Points on the torus with axis radius 1 and tube radius 0.4: `tube` rings of `around` points,
/// every second ring turned by half a step as in a lattice of equilateral triangles, all off by
/// up to `jitter` steps. Each cell is cut along either diagonal, the shorter or the longer.
///
/// # Errors
/// If `tube` is odd.
pub fn sampled_torus(
    around: usize,
    tube: usize,
    jitter: f64,
    seed: u64,
) -> Result<PolygonSoup, Conflict> {
    if !tube.is_multiple_of(2) {
        return Err(Conflict::odd("tube", tube));
    }
    let mut random = SplitMix64::new(seed);
    let positions = (0..around * tube).map(|k| {
        let mut off = || jitter * (2.0 * random.uniform() - 1.0);
        let (i, j) = (k / tube, k % tube);
        let turned = if j.is_multiple_of(2) { 0.0 } else { 0.5 };
        let (u, v) = (i as f64 + turned + off(), j as f64 + off());
        on_torus(1.0, 0.4, TAU * u / around as f64, TAU * v / tube as f64)
    });
    let positions = positions.collect();
    let vertex = |i: usize, j: usize| i % around * tube + j % tube;
    let faces = cut_at_random(grid::triangles(around, tube, vertex), &mut random);
    Ok(PolygonSoup::from_faces(positions, &faces))
}

/// Turns the diagonal of about every second pair of triangles `abc`, `acd`.
fn cut_at_random(mut faces: Vec<[u32; 3]>, random: &mut SplitMix64) -> Vec<[u32; 3]> {
    for pair in faces.chunks_exact_mut(2) {
        let ([a, b, c], d) = (pair[0], pair[1][2]);
        if random.uniform() < 0.5 {
            pair.copy_from_slice(&[[a, b, d], [b, c, d]]);
        }
    }
    faces
}

deferred! {
    /// A face as a camera with vertical scan lines sees it: `rows` points along each line, twice as
    /// many lines as that would need, each off in depth by an error of standard deviation `crease`
    /// steps of a line. Long vertical edges and creases come of it.
    pub fn creased_face(rows: usize, crease: f64, seed: u64) -> PolygonSoup {
        const HALF: DVec2 = DVec2::new(0.5, 0.78);
        let columns = (2.0 * rows as f64 * HALF.x / HALF.y).round() as usize;
        let step = HALF * 2.0 / DVec2::new(columns as f64, rows as f64);
        let mut random = SplitMix64::new(seed);
        let mut positions = Vec::with_capacity((columns + 1) * (rows + 1));
        for i in 0..=columns {
            let depth = crease * step.x * random.gaussian();
            for j in 0..=rows {
                let p = DVec2::new(i as f64, j as f64) * step - HALF;
                let noise = 0.2 * crease * step.x * random.gaussian();
                // The middle of the face lies well within the head.
                let z = height(p.x, p.y).unwrap_or_default();
                positions.push(DVec3::new(p.x, p.y, z + depth + noise));
            }
        }
        let vertex = |i: usize, j: usize| i * (rows + 1) + j;
        PolygonSoup::from_faces(positions, &grid::triangles(columns, rows, vertex))
    }
}

deferred! {
    /// A round head with two long ears, its points off by up to `jitter` edge lengths along the
    /// surface: thin parts that lose volume when the area falls.
    ///
    /// # Errors
    /// None with levels up to 8.
    pub fn eared_head(level: usize, jitter: f64, seed: u64) -> Result<PolygonSoup, SubdivisionError> {
        const EARS: [DVec3; 2] = [DVec3::new(0.3, 1.0, 0.05), DVec3::new(-0.3, 1.0, 0.05)];
        /// Cosine of the angle within which a direction belongs to an ear, and the ear's length.
        const WIDTH: f64 = 0.955;
        const LENGTH: f64 = 1.1;
        let mut soup = sphere::icosphere(level)?;
        let mut random = SplitMix64::new(seed);
        let step = 1.1 / (1 << level) as f64;
        for p in &mut soup.positions {
            let off = DVec3::from_array(std::array::from_fn(|_| random.gaussian()));
            let d = (*p + jitter * step * (off - off.dot(*p) * *p)).normalize();
            let ear = EARS.iter().map(|ear| {
                let inside = (d.dot(ear.normalize()) - WIDTH) / (1.0 - WIDTH);
                inside.clamp(0.0, 1.0).powf(0.6)
            });
            let length = LENGTH * ear.fold(0.0, f64::max);
            *p = d + length * DVec3::new(0.18 * d.x.signum(), 1.0, 0.0);
        }
        Ok(soup)
    }
}
