//! From polygon soup to half-edges: diagnose, repair what is safe, name what is not.
//!
//! Safe repairs, each of them told: consecutive repeated corners collapsed,
//! degenerate and duplicate faces dropped, unused vertices dropped, faces turned to
//! agree with their neighbours, vertices where several fans meet split into one
//! vertex a fan. Edges with three or more faces are refused.

use super::orient::orient;
use super::repair::{clean_faces, drop_flat_components, drop_unused_vertices, split_vertices};
use super::sides::{Side, paired_sides};
use super::{Face, Halfedge, HalfedgeMesh, MeshError, Repair, Vertex};
use crate::interrupt;
use crate::soup::PolygonSoup;
use glam::DVec3;

/// A mesh with its positions and what was done to get it.
#[derive(Clone, Debug)]
pub struct Built {
    /// Connectivity.
    pub mesh: HalfedgeMesh,
    /// One position a vertex.
    pub positions: Vec<DVec3>,
    /// For each vertex its index in the soup.
    pub soup_vertex: Vec<u32>,
    /// What was repaired.
    pub repairs: Vec<Repair>,
}

/// Builds connectivity from a soup; closed surfaces are turned outward.
///
/// # Errors
/// See [`MeshError`]; the soup is only read.
pub fn build(soup: &PolygonSoup) -> Result<Built, MeshError> {
    connected(soup, true)
}

/// The same, but a closed surface keeps the side that its faces show. An immersed surface has
/// no outside that its volume could tell, and one that was turned outward once is kept so.
///
/// # Errors
/// See [`MeshError`].
pub fn build_as_given(soup: &PolygonSoup) -> Result<Built, MeshError> {
    connected(soup, false)
}

fn connected(soup: &PolygonSoup, turns_outward: bool) -> Result<Built, MeshError> {
    let mut repairs = Vec::new();
    check_indices(soup)?;
    let mut faces = clean_faces(soup, &mut repairs);
    if faces.n_faces() == 0 {
        return Err(MeshError::NoFaces);
    }
    interrupt::pulse();
    let mut sides = paired_sides(&faces)?;
    interrupt::pulse();
    // Whatever changes the faces is told as a repair; most surfaces need none.
    let told = repairs.len();
    orient(&mut faces, &sides, turns_outward, &mut repairs);
    if repairs.len() > told {
        // Turning a face renumbers its corners.
        sides = paired_sides(&faces)?;
    }
    interrupt::pulse();
    let told = repairs.len();
    let origin = split_vertices(&mut faces, &sides, &mut repairs);
    interrupt::pulse();
    drop_flat_components(&mut faces, &sides, &mut repairs);
    if faces.n_faces() == 0 {
        return Err(MeshError::NoFaces);
    }
    interrupt::pulse();
    let soup_vertex = drop_unused_vertices(&mut faces, &origin, soup, &mut repairs);
    if repairs.len() > told {
        interrupt::pulse();
        sides = paired_sides(&faces)?;
    }
    interrupt::pulse();
    let mesh = connect(&faces, &sides);
    Ok(Built {
        mesh,
        positions: faces.positions,
        soup_vertex,
        repairs,
    })
}

fn check_indices(soup: &PolygonSoup) -> Result<(), MeshError> {
    // Half-edges, boundary ones included, must fit u32 with room for `NONE`.
    if soup.corners.len() > (u32::MAX / 2 - 1) as usize {
        return Err(MeshError::TooLarge {
            count: soup.corners.len(),
        });
    }
    let vertices = soup.positions.len();
    for (face, corners) in soup.faces().enumerate() {
        if let Some(&vertex) = corners.iter().find(|&&v| v as usize >= vertices) {
            return Err(MeshError::VertexOutOfRange {
                face,
                vertex,
                vertices,
            });
        }
    }
    match soup.positions.iter().position(|p| !p.is_finite()) {
        Some(vertex) => Err(MeshError::NonFiniteVertex { vertex }),
        None => Ok(()),
    }
}

/// Half-edges from clean, manifold, oriented faces.
fn connect(soup: &PolygonSoup, sides: &[Side]) -> HalfedgeMesh {
    const UNSET: Halfedge = Halfedge::NONE;
    // Edges are numbered in the order in which the faces first mention them.
    let mut group_of_corner = vec![None; soup.corners.len()];
    for group in sides.chunk_by(|a, b| a.key == b.key) {
        group_of_corner[group[0].corner as usize] = Some(group);
    }
    let edges: Vec<&[Side]> = group_of_corner.into_iter().flatten().collect();
    let n_halfedges = 2 * edges.len();
    let mut mesh = HalfedgeMesh {
        next: vec![UNSET; n_halfedges],
        prev: vec![UNSET; n_halfedges],
        tail: vec![Vertex::NONE; n_halfedges],
        face: vec![Face::NONE; n_halfedges],
        halfedge_of_vertex: vec![UNSET; soup.positions.len()],
        halfedge_of_face: Vec::with_capacity(soup.n_faces()),
        halfedge_of_loop: Vec::new(),
    };
    let mut halfedge_of_corner = vec![UNSET; soup.corners.len()];
    for (e, group) in edges.iter().enumerate() {
        for (side, s) in group.iter().enumerate() {
            halfedge_of_corner[s.corner as usize] = Halfedge::new(2 * e + side);
        }
    }
    for f in 0..soup.n_faces() {
        let range = soup.face_starts[f] as usize..soup.face_starts[f + 1] as usize;
        let cycle = &halfedge_of_corner[range.clone()];
        mesh.halfedge_of_face.push(cycle[0]);
        for (i, &h) in cycle.iter().enumerate() {
            let n = cycle[(i + 1) % cycle.len()];
            let v = soup.corners[range.start + i];
            mesh.next[h.index()] = n;
            mesh.prev[n.index()] = h;
            mesh.face[h.index()] = Face::new(f);
            mesh.tail[h.index()] = Vertex(v);
            mesh.halfedge_of_vertex[v as usize] = h;
        }
    }
    connect_boundary(&mut mesh);
    mesh
}

/// Links the boundary half-edges into loops. Each loop is walked from vertex to
/// vertex rather than by orientation, which a Möbius strip's loop does not have.
fn connect_boundary(mesh: &mut HalfedgeMesh) {
    let boundary: Vec<Halfedge> = mesh
        .halfedges()
        .filter(|h| !mesh.face(*h).is_some())
        .collect();
    // The two boundary edges at each boundary vertex: exactly two, as there is one fan.
    let mut at_vertex = vec![[Halfedge::NONE; 2]; mesh.n_vertices()];
    for &b in &boundary {
        for v in mesh.ends(b.edge()) {
            let slots = &mut at_vertex[v.index()];
            slots[usize::from(slots[0].is_some())] = b;
        }
    }
    for &seed in &boundary {
        if mesh.next[seed.index()].is_some() {
            continue;
        }
        mesh.halfedge_of_loop.push(seed);
        // Against the face's own direction, so that an oriented edge is untwisted.
        let (mut b, mut from) = (seed, mesh.tip(seed.twin()));
        loop {
            mesh.tail[b.index()] = from;
            let [p, q] = mesh.ends(b.edge());
            let to = if p == from { q } else { p };
            // The fan of a boundary vertex starts at the boundary, on the face's side.
            mesh.halfedge_of_vertex[to.index()] = b.twin();
            let [s, t] = at_vertex[to.index()];
            let n = if s == b { t } else { s };
            mesh.next[b.index()] = n;
            mesh.prev[n.index()] = b;
            if n == seed {
                break;
            }
            (b, from) = (n, to);
        }
    }
}
