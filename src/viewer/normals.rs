//! Vertex normals for lighting, and how long edges are about each vertex.
//!
//! In single precision and for the eye only: the normals of the mathematics are in
//! `geometry`. Degenerate triangles and positions that are not finite leave a vertex
//! without a normal (zero); the shader then takes that of the triangle.

use glam::{Vec3, Vec4};

/// Area-weighted vertex normals, written to the first three of each of `normals` (one for
/// each drawn vertex): `n_v = Σ_t (p_b − p_a) × (p_c − p_a)` over the triangles about `v`,
/// made unit. The fourth is the mean length of the sides that meet in `v`, those of two
/// triangles counted twice: a dense wireframe fades by it.
///
/// The last `copies.len()` vertices are copies of others along a seam, see
/// [`super::seams`]. A vertex and its copies get one normal between them, up to sign:
/// each keeps the side its own triangles face.
pub fn vertex_normals(
    positions: &[[f32; 4]],
    triangles: &[u32],
    copies: &[u32],
    normals: &mut [[f32; 4]],
) {
    normals.fill([0.0; 4]);
    let position = |vertex: u32| Vec4::from(positions[vertex as usize]).truncate();
    let mut n_sides = vec![0.0f32; normals.len()];
    for triangle in triangles.chunks_exact(3) {
        let [a, b, c] = [0, 1, 2].map(|k| position(triangle[k]));
        let double_area = (b - a).cross(c - a);
        if !double_area.is_finite() {
            continue;
        }
        let [ab, bc, ca] = [a.distance(b), b.distance(c), c.distance(a)];
        for (&vertex, sides) in triangle.iter().zip([ab + ca, ab + bc, bc + ca]) {
            add(&mut normals[vertex as usize], double_area.extend(sides));
            n_sides[vertex as usize] += 2.0;
        }
    }
    join_across_seams(copies, normals);
    for (normal, n_sides) in normals.iter_mut().zip(n_sides) {
        let unit = Vec4::from(*normal).truncate().normalize_or_zero();
        *normal = unit.extend(normal[3] / n_sides.max(1.0)).to_array();
    }
}

/// Gives every copy the normal of its vertex, and the vertex that of its copies: all
/// added on the side of the first, then turned back to each one's own.
fn join_across_seams(copies: &[u32], normals: &mut [[f32; 4]]) {
    let first_copy = normals.len() - copies.len();
    let at = |normals: &[[f32; 4]], v: usize| Vec4::from(normals[v]).truncate();
    let side = |normal: Vec3, reference: Vec3| {
        if normal.dot(reference) < 0.0 {
            -1.0
        } else {
            1.0
        }
    };
    let reference: Vec<Vec3> = copies.iter().map(|&v| at(normals, v as usize)).collect();
    for ((copy, &vertex), &reference) in (first_copy..).zip(copies).zip(&reference) {
        let own = at(normals, copy);
        let term = side(own, reference) * own;
        add(&mut normals[vertex as usize], term.extend(0.0));
    }
    for ((copy, &vertex), &reference) in (first_copy..).zip(copies).zip(&reference) {
        let own = at(normals, copy);
        let joined = side(own, reference) * at(normals, vertex as usize);
        normals[copy] = joined.extend(normals[copy][3]).to_array();
    }
}

fn add(sum: &mut [f32; 4], term: Vec4) {
    *sum = (Vec4::from(*sum) + term).to_array();
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
        let mut normals = vec![[f32::NAN; 4]; padded.len()];
        vertex_normals(&padded, triangles, copies, &mut normals);
        let normal = |n: [f32; 4]| Vec4::from(n).truncate();
        normals.into_iter().map(normal).collect()
    }

    #[test]
    fn sides_that_meet_in_a_vertex_have_a_mean_length() {
        // A fan of two right triangles: sides 3 and 4 apart, 5 across.
        let positions = [
            [0.0; 4],
            [3., 0., 0., 9.],
            [0., 4., 0., 9.],
            [-3., 0., 0., 9.],
        ];
        let mut normals = [[0.0; 4]; 4];
        vertex_normals(&positions, &[0, 1, 2, 0, 2, 3], &[], &mut normals);
        let lengths = normals.map(|[.., length]| length);
        assert_eq!(lengths, [3.5, 4.0, 4.5, 4.0]);
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
