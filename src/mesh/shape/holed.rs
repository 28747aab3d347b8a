//! Surfaces with holes to be filled, after figure 5.1 (d) of Xu & Zhang
//! [XZ06](crate::bibliography#xz06).

use std::collections::HashMap;
use std::f64::consts::PI;

use glam::{DQuat, DVec3};

use super::{Conflict, sphere};
use crate::soup::PolygonSoup;

/// Held rings between two holes, which continuous curvature takes.
const BETWEEN: f64 = 4.0;

/// The unit sphere without `holes` round caps of this angular `radius` about the points of a
/// spiral, its vertices pushed along it by `jitter` edge lengths in the mean of squares.
///
/// Every loop is simple, also where the mesh is coarse.
///
/// # Errors
/// If the holes do not fit, or if the mesh is too coarse for them.
pub fn sphere_with_holes(
    level: usize,
    holes: usize,
    radius: f64,
    jitter: f64,
    seed: u64,
) -> Result<PolygonSoup, Conflict> {
    let centres = spiral(holes);
    let edge = 1.1 / (1 << level) as f64;
    if radius < 1.5 * edge {
        return Err(Conflict::TooCoarse { level, radius });
    }
    let pairs = (0..holes).flat_map(|i| (0..i).map(move |j| (i, j)));
    let apart = pairs.map(|(i, j)| centres[i].angle_between(centres[j]));
    // One hole leaves room for its own rings on the other side.
    let room = apart.fold(2.0 * PI, f64::min) - BETWEEN * edge;
    if 2.0 * radius > room {
        let most = (0.5 * room).max(0.0);
        let count = holes;
        return Err(Conflict::HolesOverlap {
            count,
            radius,
            most,
        });
    }
    let soup = sphere::ellipsoid(DVec3::ONE, level, jitter, seed)?;
    let is_inside = |p: &DVec3| centres.iter().any(|c| c.dot(*p) > radius.cos());
    let is_gone = soup.positions.iter().map(is_inside).collect();
    Ok(without(&soup, is_gone))
}

/// Points spread evenly over the sphere, none of them a corner of an icosahedron.
fn spiral(n: usize) -> Vec<DVec3> {
    let turn = PI * (3.0 - 5f64.sqrt());
    let tilt = DQuat::from_rotation_x(0.4) * DQuat::from_rotation_y(0.7);
    let point = |i: usize| {
        let z = 1.0 - (2 * i + 1) as f64 / n as f64;
        let (sin, cos) = (turn * i as f64).sin_cos();
        tilt * (DVec3::new(cos, sin, 0.0) * (1.0 - z * z).sqrt() + z * DVec3::Z)
    };
    (0..n).map(point).collect()
}

/// Takes out vertices with all their faces, and more of them until no loop touches itself.
fn without(soup: &PolygonSoup, mut is_gone: Vec<bool>) -> PolygonSoup {
    let mut faces: Vec<&[u32]> = soup.faces().collect();
    loop {
        faces.retain(|face| face.iter().all(|&v| !is_gone[v as usize]));
        let mut sides: HashMap<(u32, u32), usize> = HashMap::new();
        for face in &faces {
            for (i, &a) in face.iter().enumerate() {
                let b = face[(i + 1) % face.len()];
                *sides.entry((a.min(b), a.max(b))).or_default() += 1;
            }
        }
        let mut ends = vec![0; is_gone.len()];
        for ((a, b), _) in sides.into_iter().filter(|(_, count)| *count == 1) {
            ends[a as usize] += 1;
            ends[b as usize] += 1;
        }
        // Passed twice by loops.
        let Some(first) = ends.iter().position(|&n| n > 2) else {
            break;
        };
        is_gone[first] = true;
    }
    let mut number = vec![u32::MAX; soup.positions.len()];
    let mut positions = Vec::new();
    let mut used: Vec<u32> = faces.iter().flat_map(|f| f.iter().copied()).collect();
    used.sort_unstable();
    used.dedup();
    for v in used {
        number[v as usize] = positions.len() as u32;
        positions.push(soup.positions[v as usize]);
    }
    let renumbered = |face: &&[u32]| face.iter().map(|&v| number[v as usize]).collect();
    let faces: Vec<Vec<u32>> = faces.iter().map(renumbered).collect();
    PolygonSoup::from_faces(positions, &faces)
}
