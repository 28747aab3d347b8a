//! Sides of edges before there are half-edges: which faces meet where.

use super::MeshError;
use crate::order;
use crate::soup::PolygonSoup;

/// One side of an edge before pairing: `key` names the edge by its sorted ends.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub(super) struct Side {
    pub(super) key: u64,
    pub(super) face: u32,
    pub(super) corner: u32,
}

fn edge_key(a: u32, b: u32) -> u64 {
    (u64::from(a.min(b)) << 32) | u64::from(a.max(b))
}

/// All sides of all edges, sorted so that the sides of one edge are neighbours and
/// edges come in the order in which the faces first mention them.
pub(super) fn paired_sides(soup: &PolygonSoup) -> Result<Vec<Side>, MeshError> {
    let all = (0..soup.n_faces()).flat_map(|f| {
        let (face, start) = (soup.face(f), soup.face_starts[f]);
        (0..face.len()).map(move |i| {
            let next = if i + 1 == face.len() { 0 } else { i + 1 };
            let (a, b) = (face[i], face[next]);
            let side = Side {
                key: edge_key(a, b),
                face: f as u32,
                corner: start + i as u32,
            };
            (a.min(b), side)
        })
    });
    // By the first end in one pass; then few are left to be sorted by the other.
    let (first, mut sides) = order::bucketed(soup.positions.len(), all);
    for range in first.windows(2) {
        let at_vertex = &mut sides[range[0] as usize..range[1] as usize];
        at_vertex.sort_unstable_by_key(|s| (s.key, s.corner));
    }
    let crowded = || {
        sides
            .chunk_by(|a, b| a.key == b.key)
            .filter(|g| g.len() > 2)
    };
    if let Some(group) = crowded().next() {
        return Err(MeshError::NonManifoldEdge {
            first: 0,
            a: (group[0].key >> 32) as u32,
            b: group[0].key as u32,
            faces: group.iter().map(|s| s.face).collect(),
            others: crowded().count() - 1,
        });
    }
    Ok(sides)
}

/// Pairs of sides that share an interior edge.
pub(super) fn interior_edges(sides: &[Side]) -> impl Iterator<Item = (Side, Side)> + '_ {
    sides
        .windows(2)
        .filter(|w| w[0].key == w[1].key)
        .map(|w| (w[0], w[1]))
}

/// Adjacency of faces across interior edges, as a compressed list of
/// `(neighbour, sides run the same way)`.
pub(super) fn face_adjacency(soup: &PolygonSoup, sides: &[Side]) -> (Vec<u32>, Vec<(u32, bool)>) {
    let mut start = vec![0u32; soup.n_faces() + 1];
    for (s, t) in interior_edges(sides) {
        start[s.face as usize + 1] += 1;
        start[t.face as usize + 1] += 1;
    }
    for i in 1..start.len() {
        start[i] += start[i - 1];
    }
    let mut fill = start.clone();
    let mut list = vec![(0, false); start[soup.n_faces()] as usize];
    for (s, t) in interior_edges(sides) {
        let same = soup.corners[s.corner as usize] == soup.corners[t.corner as usize];
        for (a, b) in [(s.face, t.face), (t.face, s.face)] {
            list[fill[a as usize] as usize] = (b, same);
            fill[a as usize] += 1;
        }
    }
    (start, list)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::noise::SplitMix64;
    use glam::DVec3;

    /// Strips about a hub whose number lies in the middle, each edge of at most two faces.
    #[test]
    fn sides_are_in_the_order_of_edge_and_corner() {
        let mut random = SplitMix64::new(3);
        let n = 400_u32;
        let mut names: Vec<u32> = (0..n).collect();
        for i in (1..names.len()).rev() {
            names.swap(i, random.below(i + 1));
        }
        let hub = names[0];
        let mut faces: Vec<Vec<u32>> = Vec::new();
        for rim in names[1..].windows(2) {
            faces.push(vec![hub, rim[0], rim[1]]);
        }
        faces.push(vec![names[1], names[2], n, n + 1]);
        let soup = PolygonSoup::from_faces(vec![DVec3::ZERO; n as usize + 2], &faces);
        let found = paired_sides(&soup).expect("a manifold");
        let mut expected = Vec::new();
        for (f, face) in faces.iter().enumerate() {
            for (i, &a) in face.iter().enumerate() {
                expected.push(Side {
                    key: edge_key(a, face[(i + 1) % face.len()]),
                    face: f as u32,
                    corner: soup.face_starts[f] + i as u32,
                });
            }
        }
        expected.sort_by_key(|s| (s.key, s.corner));
        assert_eq!(found, expected);
    }
}
