//! Edges of the mesh as the shader of the surface finds them: three bits a triangle.
//!
//! A fragment knows how far it is from each side of its triangle. Which of the sides are
//! edges of the mesh it is told: the diagonals that split a quad are none.

/// Bit of a corner that says whether the side across from corner 0 of its triangle is an
/// edge; those of corners 1 and 2 follow. Lower bits number the vertex.
pub const FIRST_SIDE: u32 = 29;

/// The corners of the triangles, each with the three bits of its triangle. `edges` are two
/// vertices each, in any order; `source` tells which vertex a drawn one stands for.
///
/// Sorts the edges once: `O(n log n)`.
pub fn corners_with_sides(
    triangles: &[u32],
    edges: &[u32],
    source: impl Fn(u32) -> u32,
) -> Vec<u32> {
    let key = |a: u32, b: u32| u64::from(a.min(b)) << 32 | u64::from(a.max(b));
    let mut known: Vec<u64> = edges.chunks_exact(2).map(|e| key(e[0], e[1])).collect();
    known.sort_unstable();
    let mark = |triangle: &[u32]| {
        let vertex = [0, 1, 2].map(|k| source(triangle[k]));
        let sides = (0..3).fold(0, |sides, k| {
            let side = key(vertex[(k + 1) % 3], vertex[(k + 2) % 3]);
            sides | u32::from(known.binary_search(&side).is_ok()) << k
        });
        [0, 1, 2].map(|k| triangle[k] | sides << FIRST_SIDE)
    };
    triangles.chunks_exact(3).flat_map(mark).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn sides(corners: &[u32]) -> Vec<u32> {
        corners.iter().map(|corner| corner >> FIRST_SIDE).collect()
    }

    #[test]
    fn the_diagonal_of_a_quad_is_no_edge() {
        let triangles = [0, 1, 2, 0, 2, 3];
        let corners = corners_with_sides(&triangles, &[1, 0, 1, 2, 3, 2, 0, 3], |v| v);
        // Across from corner 1 of the first and corner 2 of the second lies the diagonal.
        assert_eq!(sides(&corners), [0b101, 0b101, 0b101, 0b011, 0b011, 0b011]);
        let vertices: Vec<u32> = corners
            .iter()
            .map(|c| c & ((1 << FIRST_SIDE) - 1))
            .collect();
        assert_eq!(vertices, triangles);
    }

    #[test]
    fn copies_have_the_edges_of_their_vertices() {
        // Vertex 4 is a copy of vertex 2.
        let source = |v| if v == 4 { 2 } else { v };
        let corners = corners_with_sides(&[0, 1, 4], &[0, 1, 1, 2], source);
        assert_eq!(sides(&corners), [0b101; 3]);
        assert_eq!(corners[2] & 7, 4, "drawn at the copy");
    }

    #[test]
    fn without_edges_there_are_no_sides() {
        assert_eq!(corners_with_sides(&[2, 0, 1], &[], |v| v), [2, 0, 1]);
        assert!(corners_with_sides(&[], &[0, 1], |v| v).is_empty());
    }
}
