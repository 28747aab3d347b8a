//! A first surface between several loops (Xu & Zhang, Section 5.2): their convex hull less
//! the faces that would close a single loop.
//!
//! The edge of a scan is too ragged to lie on any hull. Where the loops do not, the hull is
//! that of circles in their stead, and only its faces are taken over.

use super::boundary::Rim;
use super::error::FillError;
use super::hull::convex_hull;
use glam::DVec3;
use std::collections::HashSet;
use std::f64::consts::TAU;

/// Triangles between the loops of the rim, in its numbers, turned so that they agree with
/// the surface around most of its sides.
///
/// # Errors
/// [`FillError::HiddenLoop`] unless every loop, or the circle in its stead, lies on the hull
/// and one strip of faces touches each of its sides; [`FillError::LoopsTooClose`].
pub(super) fn connect(rim: &Rim, x: &[DVec3]) -> Result<Vec<[u32; 3]>, FillError> {
    match between(rim, x) {
        Err(FillError::HiddenLoop { .. }) => between(rim, &circles(rim, x)),
        result => result,
    }
}

/// Each loop as a circle in the plane it is nearest to, of its mean radius, its vertices
/// spaced as they are along the loop.
fn circles(rim: &Rim, x: &[DVec3]) -> Vec<DVec3> {
    let mut round = Vec::with_capacity(x.len());
    for range in rim.starts.windows(2) {
        let points = &x[range[0]..range[1]];
        let m = points.len();
        let centre = points.iter().sum::<DVec3>() / m as f64;
        let next = |i: usize| points[(i + 1) % m];
        let area: DVec3 = (0..m)
            .map(|i| (points[i] - centre).cross(next(i) - centre))
            .sum();
        let normal = area.try_normalize().unwrap_or(DVec3::Z);
        let radius = points.iter().map(|p| p.distance(centre)).sum::<f64>() / m as f64;
        let first = (points[0] - centre).reject_from_normalized(normal);
        let u = first
            .try_normalize()
            .unwrap_or(normal.any_orthonormal_vector());
        let v = normal.cross(u);
        let length: f64 = (0..m).map(|i| points[i].distance(next(i))).sum();
        let mut along = 0.0;
        for (i, p) in points.iter().enumerate() {
            let (sin, cos) = (TAU * along / length).sin_cos();
            round.push(centre + radius * (cos * u + sin * v));
            along += p.distance(next(i));
        }
    }
    round
}

fn between(rim: &Rim, x: &[DVec3]) -> Result<Vec<[u32; 3]>, FillError> {
    let mut faces = convex_hull(x);
    faces.retain(|f| {
        let [a, b, c] = f.map(|v| rim.loop_of(v));
        a != b || b != c
    });
    let sides: HashSet<(u32, u32)> = faces
        .iter()
        .flat_map(|&[a, b, c]| [(a, b), (b, c), (c, a)])
        .collect();
    let (mut along, mut against) = (0, 0);
    for (a, b) in rim.sides() {
        // On one side of the strip only.
        match (sides.contains(&(a, b)), sides.contains(&(b, a))) {
            (true, false) => along += 1,
            (false, true) => against += 1,
            _ => {
                let (index, vertex) = (rim.loops[rim.loop_of(a)], rim.vertices[a as usize]);
                return Err(FillError::HiddenLoop { index, vertex });
            }
        }
    }
    let rim_sides: HashSet<(u32, u32)> = rim.sides().flat_map(|(a, b)| [(a, b), (b, a)]).collect();
    for &(a, b) in sides.difference(&rim_sides) {
        if !sides.contains(&(b, a)) {
            // An edge of a face that closed a loop, but not a side of the loop.
            let (index, vertex) = (rim.loops[rim.loop_of(a)], rim.vertices[a as usize]);
            return Err(FillError::HiddenLoop { index, vertex });
        }
        if rim.is_joined(a, b) {
            let [a, b] = [a, b].map(|v| rim.vertices[v as usize]);
            return Err(FillError::LoopsTooClose { a, b });
        }
    }
    if against > along {
        for face in &mut faces {
            face.swap(0, 1);
        }
    }
    Ok(faces)
}
