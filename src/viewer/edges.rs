//! Edges as drawn: where they end, and how long edges are about there.

use bytemuck::{Pod, Zeroable};
use glam::Vec3;

/// Rounds of averaging over neighbours: enough to even out an irregular triangulation,
/// too few to hide that a mesh is finer here than there.
const ROUNDS: usize = 3;

/// One instance of the line shader.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub struct Edge {
    /// The two vertices.
    pub ends: [u32; 2],
    /// Mean length of edges about each end, in lengths of this edge. A dense wireframe
    /// fades by it: were each edge to fade by its own length, those left standing in an
    /// irregular mesh would look like straw.
    pub surroundings: [f32; 2],
}

/// Edges given by two vertices each, measured at the present positions. The measure is a
/// ratio, and so stays of use while a surface grows or shrinks.
pub fn edges(positions: &[[f32; 4]], ends: &[u32]) -> Vec<Edge> {
    let position = |vertex: u32| {
        let [x, y, z, _] = positions[vertex as usize];
        Vec3::new(x, y, z)
    };
    let pairs: Vec<[u32; 2]> = ends
        .chunks_exact(2)
        .map(|pair| [pair[0], pair[1]])
        .collect();
    let lengths: Vec<f32> = pairs
        .iter()
        .map(|&[a, b]| position(a).distance(position(b)))
        .collect();

    let mut about = lengths.clone();
    let mut at_vertex = Vec::new();
    for _ in 0..ROUNDS {
        at_vertex = mean_at_vertices(positions.len(), &pairs, &about);
        let mean = |&[a, b]: &[u32; 2]| 0.5 * (at_vertex[a as usize] + at_vertex[b as usize]);
        about = pairs.iter().map(mean).collect();
    }
    let edge = |(&[a, b], &length): (&[u32; 2], &f32)| {
        let ratio = |vertex: u32| {
            if length > 0.0 {
                at_vertex[vertex as usize] / length
            } else {
                1.0
            }
        };
        Edge {
            ends: [a, b],
            surroundings: [ratio(a), ratio(b)],
        }
    };
    pairs.iter().zip(&lengths).map(edge).collect()
}

/// Mean of a value an edge over the edges about each vertex.
fn mean_at_vertices(n_vertices: usize, pairs: &[[u32; 2]], values: &[f32]) -> Vec<f32> {
    let mut sums = vec![(0.0, 0.0); n_vertices];
    for (pair, value) in pairs.iter().zip(values) {
        for &vertex in pair {
            sums[vertex as usize].0 += value;
            sums[vertex as usize].1 += 1.0;
        }
    }
    sums.into_iter()
        .map(|(sum, count): (f32, f32)| sum / count.max(1.0))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A path of edges of length 1, `long`, 1, `long`, …
    fn zigzag(n: u32, long: f32) -> Vec<Edge> {
        let place = |i: u32| (i / 2) as f32 * (1.0 + long) + (i % 2) as f32;
        let positions: Vec<[f32; 4]> = (0..=n).map(|i| [place(i), 0.0, 0.0, 9.0]).collect();
        edges(
            &positions,
            &(0..n).flat_map(|i| [i, i + 1]).collect::<Vec<_>>(),
        )
    }

    #[test]
    fn irregular_edges_have_even_surroundings() {
        let edges = zigzag(20, 3.0);
        for (i, edge) in edges.iter().enumerate().skip(4).take(12) {
            let length = if i.is_multiple_of(2) { 1.0 } else { 3.0 };
            assert_eq!(edge.ends, [i as u32, i as u32 + 1]);
            for ratio in edge.surroundings {
                assert!(
                    (ratio * length - 2.0).abs() < 1e-5,
                    "edge {i}: {}",
                    ratio * length
                );
            }
        }
    }

    #[test]
    fn both_ends_of_neighbouring_edges_agree() {
        let edges = zigzag(9, 5.0);
        for (i, pair) in edges.windows(2).enumerate() {
            let length = |i: usize| if i.is_multiple_of(2) { 1.0 } else { 5.0 };
            let before = pair[0].surroundings[1] * length(i);
            let after = pair[1].surroundings[0] * length(i + 1);
            assert!(
                (before - after).abs() < 1e-5,
                "the fading jumps at vertex {}",
                i + 1
            );
        }
    }

    #[test]
    fn edge_without_length_is_harmless() {
        assert_eq!(edges(&[[1.0; 4]; 2], &[0, 1])[0].surroundings, [1.0, 1.0]);
    }
}
