//! Surfaces with patches to be restored: the figures of Xu & Zhang
//! [XZ06](crate::bibliography#xz06).

use crate::order;
use std::f64::consts::TAU;

use glam::{DVec2, DVec3};

use super::{Conflict, Sample, grid, platonic, sphere};
use crate::mesh::subdivide::{SubdivisionError, linear_levels};
use crate::soup::PolygonSoup;

/// Sweeps and over-relaxation that bring the membrane over a patch to rest.
const SWEEPS: usize = 400;
const RELAXATION: f64 = 1.8;

/// A cylinder of radius 1 with four round patches replaced by the membranes their rims
/// span: figure 5.1 (a, b). The patches are free; restored, all points have distance 1
/// from the axis.
pub fn cylinder_with_gaps(around: usize, along: usize, radius: f64) -> Result<Sample, Conflict> {
    let edge = TAU / around as f64;
    let height = edge * along as f64;
    // Two held rings and one more between a patch and the ends.
    if radius + 3.5 * edge > 0.5 * height {
        return Err(Conflict::PatchesTooLong { radius });
    }
    let place = |k: usize| {
        let (i, j) = (k / (along + 1), k % (along + 1));
        (edge * i as f64, edge * j as f64 - 0.5 * height)
    };
    let n = around * (along + 1);
    let positions = (0..n).map(|k| {
        let (angle, z) = place(k);
        DVec3::new(angle.cos(), angle.sin(), z)
    });
    let faces = grid::triangles(around, along, |i, j| i % around * (along + 1) + j);
    let soup = PolygonSoup::from_faces(positions.collect(), &faces);
    let free = (0..n).filter(|&k| {
        let (angle, z) = place(k);
        let quarter = TAU / 4.0;
        let from_centre = angle - quarter * (angle / quarter).round();
        DVec2::new(from_centre, z).length() < radius
    });
    let free = free.map(|k| k as u32).collect();
    Ok(with_membranes(soup, free))
}

/// The unit sphere with eight round openings, of this radius on the sphere about the
/// corners of a cube, filled by the membranes their rims span: figure 5.1 (d, e).
pub fn sphere_with_openings(level: usize, radius: f64) -> Result<Sample, SubdivisionError> {
    let soup = sphere::icosphere(level)?;
    let least = radius.cos();
    let corner = 3f64.sqrt().recip();
    let free = (0..soup.positions.len() as u32).filter(|&v| {
        let p = soup.positions[v as usize].abs();
        corner * (p.x + p.y + p.z) > least
    });
    let free = free.collect();
    Ok(with_membranes(soup, free))
}

/// The regular dodecahedron, corners on the unit sphere, each face cut into three triangles and
/// those `level` times into four: figure 5.4 (a). Its corners are to be interpolated.
pub fn dodecahedron(level: usize) -> Result<Sample, SubdivisionError> {
    let solid = platonic::icosahedron();
    // Corners are the centres of the icosahedron's faces.
    let triangles: Vec<[u32; 3]> = solid
        .faces()
        .filter_map(|face| <[u32; 3]>::try_from(face).ok())
        .collect();
    let centre = |t: &[u32; 3]| -> DVec3 { t.iter().map(|&v| solid.positions[v as usize]).sum() };
    let corners: Vec<DVec3> = triangles.iter().map(|t| centre(t).normalize()).collect();
    let mut faces = Vec::new();
    for (v, axis) in solid.positions.iter().enumerate() {
        let first = axis.any_orthonormal_vector();
        let second = axis.cross(first);
        let mut around: Vec<(f64, u32)> = (0..triangles.len())
            .filter(|&t| triangles[t].contains(&(v as u32)))
            .map(|t| {
                let p = corners[t];
                (p.dot(second).atan2(p.dot(first)), t as u32)
            })
            .collect();
        order::sort_by(&mut around, |a, b| a.0.total_cmp(&b.0));
        let ring: Vec<u32> = around.into_iter().map(|(_, t)| t).collect();
        faces.extend((1..4).map(|k| [ring[0], ring[k], ring[k + 1]]));
    }
    let fixed = (0..corners.len() as u32).collect();
    let soup = linear_levels(PolygonSoup::from_faces(corners, &faces), level)?;
    Ok(Sample {
        fixed: Some(fixed),
        ..soup.into()
    })
}

/// The graph over `[-1, 1]²` of four bumps, `vertices` a side, whose part above 1.5 is free
/// but for its rim: figure 5.6.
///
/// The paper prints bumps `exp(-(81/16)(u-½)² + (v-½)²)`, whose sum has no patch above
/// 1.5 inside the square. With `exp(-(27/16)((u-½)² + (v-½)²))`, used here, 61 a side give
/// 839 free vertices; the paper's table has 840.
pub fn four_bumps(vertices: usize) -> Sample {
    let cells = vertices - 1;
    let coordinate = |i: usize| 2.0 * i as f64 / cells as f64 - 1.0;
    let bump = |u: f64, v: f64| (-27.0 / 16.0 * ((u - 0.5).powi(2) + (v - 0.5).powi(2))).exp();
    let height = |u, v| bump(u, v) + bump(u + 1.0, v) + bump(u, v + 1.0) + bump(u + 1.0, v + 1.0);
    let positions: Vec<DVec3> = (0..vertices * vertices)
        .map(|k| {
            let (u, v) = (coordinate(k / vertices), coordinate(k % vertices));
            DVec3::new(u, v, height(u, v))
        })
        .collect();
    let faces = grid::triangles(cells, cells, |i, j| i * vertices + j);
    // The patch is made of triangles; the vertices on its rim are held.
    let mut is_inside: Vec<bool> = positions.iter().map(|p| p.z > 1.5).collect();
    for face in &faces {
        if face.iter().any(|&v| positions[v as usize].z <= 1.5) {
            face.iter().for_each(|&v| is_inside[v as usize] = false);
        }
    }
    let free = (0..positions.len() as u32).filter(|&v| is_inside[v as usize]);
    let free = free.collect();
    Sample {
        free: Some(free),
        ..PolygonSoup::from_faces(positions, &faces).into()
    }
}

/// Replaces the free vertices by the membranes their rims span: every one the mean of its
/// neighbours, by successive over-relaxation.
fn with_membranes(mut soup: PolygonSoup, free: Vec<u32>) -> Sample {
    let mut neighbours = vec![Vec::new(); soup.positions.len()];
    for face in soup.faces() {
        for (k, &v) in face.iter().enumerate() {
            neighbours[v as usize].push(face[(k + 1) % face.len()]);
        }
    }
    for _ in 0..SWEEPS {
        for &v in &free {
            let around = &neighbours[v as usize];
            let sum: DVec3 = around.iter().map(|&w| soup.positions[w as usize]).sum();
            let p = soup.positions[v as usize];
            let mean = sum / around.len() as f64;
            soup.positions[v as usize] = p + RELAXATION * (mean - p);
        }
    }
    Sample {
        free: Some(free),
        ..soup.into()
    }
}
