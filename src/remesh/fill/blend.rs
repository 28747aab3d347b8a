//! A first surface between several loops (Xu & Zhang, Section 5.2): their convex hull less
//! the faces that would close a single loop.

use super::boundary::Rim;
use super::error::FillError;
use super::hull::convex_hull;
use glam::DVec3;
use std::collections::HashSet;

/// Triangles between the loops of the rim, in its numbers, turned so that they agree with
/// the surface around most of its sides.
///
/// # Errors
/// [`FillError::HiddenLoop`] unless every loop lies on the hull and one strip of faces
/// touches each of its sides; [`FillError::LoopsTooClose`].
pub(super) fn connect(rim: &Rim, x: &[DVec3]) -> Result<Vec<[u32; 3]>, FillError> {
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
