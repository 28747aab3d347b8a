//! Vertex normals for lighting.
//!
//! In single precision and for the eye only: the normals of the mathematics are in
//! `geometry`. Degenerate triangles and positions that are not finite leave a vertex
//! without a normal (zero); the shader then takes that of the triangle.

use glam::Vec3;

/// Area-weighted vertex normals, written to `normals` (one for each of `positions`):
/// `n_v = Σ_t (p_b − p_a) × (p_c − p_a)` over the triangles about `v`, made unit.
///
/// The last `copies.len()` vertices are copies of others along a seam, see
/// [`super::seams`]. A vertex and its copies get one normal between them, up to sign:
/// each keeps the side its own triangles face.
pub fn vertex_normals(
    positions: &[[f32; 4]],
    triangles: &[u32],
    copies: &[u32],
    normals: &mut [[f32; 3]],
) {
    normals.fill([0.0; 3]);
    let position = |vertex: u32| {
        let [x, y, z, _] = positions[vertex as usize];
        Vec3::new(x, y, z)
    };
    for triangle in triangles.chunks_exact(3) {
        let a = position(triangle[0]);
        let double_area = (position(triangle[1]) - a).cross(position(triangle[2]) - a);
        if double_area.is_finite() {
            for &vertex in triangle {
                add(&mut normals[vertex as usize], double_area);
            }
        }
    }
    join_across_seams(copies, normals);
    for normal in normals {
        *normal = Vec3::from(*normal).normalize_or_zero().to_array();
    }
}

/// Gives every copy the normal of its vertex, and the vertex that of its copies: all
/// added on the side of the first, then turned back to each one's own.
fn join_across_seams(copies: &[u32], normals: &mut [[f32; 3]]) {
    let first_copy = normals.len() - copies.len();
    let side = |normal: Vec3, reference: Vec3| {
        if normal.dot(reference) < 0.0 {
            -1.0
        } else {
            1.0
        }
    };
    let reference: Vec<Vec3> = copies
        .iter()
        .map(|&v| Vec3::from(normals[v as usize]))
        .collect();
    for ((copy, &vertex), &reference) in (first_copy..).zip(copies).zip(&reference) {
        let own = Vec3::from(normals[copy]);
        add(&mut normals[vertex as usize], side(own, reference) * own);
    }
    for ((copy, &vertex), &reference) in (first_copy..).zip(copies).zip(&reference) {
        let own = Vec3::from(normals[copy]);
        normals[copy] = (side(own, reference) * Vec3::from(normals[vertex as usize])).to_array();
    }
}

fn add(sum: &mut [f32; 3], term: Vec3) {
    sum[0] += term.x;
    sum[1] += term.y;
    sum[2] += term.z;
}

#[cfg(test)]
mod tests {
    use super::super::seams::{split_seams, tests::mobius_strip};
    use super::*;

    fn normals_of(positions: &[Vec3], triangles: &[u32], copies: &[u32]) -> Vec<Vec3> {
        let all = positions
            .iter()
            .copied()
            .chain(copies.iter().map(|&v| positions[v as usize]));
        let padded: Vec<[f32; 4]> = all.map(|p| p.extend(0.5).to_array()).collect();
        let mut normals = vec![[f32::NAN; 3]; padded.len()];
        vertex_normals(&padded, triangles, copies, &mut normals);
        normals.into_iter().map(Vec3::from).collect()
    }

    #[test]
    fn octahedron_has_radial_outward_normals() {
        let positions = [Vec3::X, Vec3::Y, Vec3::Z, -Vec3::X, -Vec3::Y, -Vec3::Z];
        let triangles = [
            0, 1, 2, 1, 3, 2, 3, 4, 2, 4, 0, 2, 1, 0, 5, 3, 1, 5, 4, 3, 5, 0, 4, 5,
        ];
        for (normal, position) in normals_of(&positions, &triangles, &[])
            .iter()
            .zip(positions)
        {
            assert!(normal.distance(position) < 1e-6, "{normal} at {position}");
        }
    }

    #[test]
    fn larger_triangles_weigh_more() {
        // Two right triangles on a ridge, one three times as large.
        let positions = [Vec3::ZERO, Vec3::Y, Vec3::X, Vec3::new(0.0, 0.0, -3.0)];
        let normal = normals_of(&positions, &[0, 2, 1, 0, 1, 3], &[])[0];
        let expected = Vec3::new(-3.0, 0.0, 1.0).normalize();
        assert!(normal.distance(expected) < 1e-6, "{normal}");
    }

    #[test]
    fn broken_positions_spoil_only_their_own_triangles() {
        let positions = [
            Vec3::ZERO,
            Vec3::X,
            Vec3::Y,
            Vec3::NAN,
            Vec3::new(2.0, 0.0, 0.0),
            Vec3::INFINITY,
        ];
        let normals = normals_of(&positions, &[0, 1, 2, 1, 3, 2, 0, 4, 1, 2, 5, 0], &[]);
        assert_eq!(normals[0], Vec3::Z);
        assert_eq!(normals[3], Vec3::ZERO, "no usable triangle");
        assert_eq!(normals[4], Vec3::ZERO, "only a degenerate triangle");
    }

    #[test]
    fn mobius_strip_is_smooth_across_its_seam() {
        let (positions, mut triangles) = mobius_strip(60);
        let copies = split_seams(positions.len(), &mut triangles);
        let normals = normals_of(&positions, &triangles, &copies);
        for triangle in triangles.chunks_exact(3) {
            let [a, b, c] = [0, 1, 2].map(|i| normals[triangle[i] as usize]);
            let worst = a.dot(b).min(b.dot(c)).min(c.dot(a));
            assert!(
                worst > 0.95,
                "normals turn by {}° in a triangle",
                worst.acos().to_degrees()
            );
        }
        // On both sides of the seam the normal is one line.
        for (copy, &vertex) in (positions.len()..).zip(&copies) {
            assert!((normals[copy] + normals[vertex as usize]).length() < 1e-6);
        }
    }
}
