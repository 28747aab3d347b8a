//! Sides of edges before there are half-edges: which faces meet where.

use super::MeshError;
use crate::soup::PolygonSoup;

/// One side of an edge before pairing: `key` names the edge by its sorted ends.
#[derive(Clone, Copy)]
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
    let mut sides = Vec::with_capacity(soup.corners.len());
    for (f, face) in soup.faces().enumerate() {
        let start = soup.face_starts[f];
        for (i, &a) in face.iter().enumerate() {
            let b = face[(i + 1) % face.len()];
            sides.push(Side {
                key: edge_key(a, b),
                face: f as u32,
                corner: start + i as u32,
            });
        }
    }
    sides.sort_unstable_by_key(|s| (s.key, s.corner));
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
