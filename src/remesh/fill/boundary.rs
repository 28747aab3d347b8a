//! Boundary loops, and what the surface around them forbids.

use super::error::FillError;
use crate::geometry::measure::edge_length;
use crate::mesh::{HalfedgeMesh, Vertex};
use glam::DVec3;
use std::collections::{HashMap, HashSet};
use std::f64::consts::TAU;

/// Vertices of a loop closer than this share of its mean edge lie in the same place.
const SAME_PLACE: f64 = 1e-9;

/// A boundary loop; it has as many edges as vertices.
#[derive(Clone, Debug, PartialEq)]
pub struct BoundaryLoop {
    /// Its vertices in the order in which a face that fills it would list them.
    pub vertices: Vec<u32>,
    /// Sum of its edge lengths.
    pub length: f64,
}

/// The boundary loops of a mesh, in the order of [`HalfedgeMesh::boundary_loops`].
pub fn boundary_loops(mesh: &HalfedgeMesh, x: &[DVec3]) -> Vec<BoundaryLoop> {
    mesh.boundary_loops()
        .map(|halfedges| {
            let mut found = BoundaryLoop {
                vertices: Vec::new(),
                length: 0.0,
            };
            for h in halfedges {
                found.vertices.push(mesh.tail(h).0);
                found.length += edge_length(mesh, x, h.edge());
            }
            found
        })
        .collect()
}

/// Refuses a loop of which two vertices that are not neighbours lie in the same place.
pub(super) fn check_simple(
    index: usize,
    boundary: &BoundaryLoop,
    x: &[DVec3],
) -> Result<(), FillError> {
    let m = boundary.vertices.len();
    let same = SAME_PLACE * boundary.length / m as f64;
    // Along a direction that few meshes have a plane across.
    let direction = DVec3::new(0.5377, 0.6411, 0.5471);
    let place = |i: usize| x[boundary.vertices[i] as usize];
    let mut order: Vec<usize> = (0..m).collect();
    order.sort_by(|&i, &j| place(i).dot(direction).total_cmp(&place(j).dot(direction)));
    for (at, &i) in order.iter().enumerate() {
        let near = |j: &&usize| (place(**j) - place(i)).dot(direction) <= same;
        for &j in order[at + 1..].iter().take_while(near) {
            let apart = i.abs_diff(j).min(m - i.abs_diff(j));
            if apart > 1 && place(i).distance(place(j)) <= same {
                let (a, b) = (boundary.vertices[i.min(j)], boundary.vertices[i.max(j)]);
                return Err(FillError::TouchingLoop { index, a, b });
            }
        }
    }
    Ok(())
}

/// The held vertices of a patch, numbered loop after loop.
pub(super) struct Rim {
    /// The loops, by their numbers.
    pub(super) loops: Vec<usize>,
    /// Number in the mesh of each vertex.
    pub(super) vertices: Vec<u32>,
    /// Where each loop begins; one entry more than there are loops.
    pub(super) starts: Vec<usize>,
    /// Number of edges at each vertex.
    pub(super) valences: Vec<usize>,
    /// Pairs that share a face, smaller first: they are joined by an edge, or by one as
    /// soon as the face is cut into triangles.
    pub(super) joined: HashSet<(u32, u32)>,
    /// Mean length of the loops' edges.
    pub(super) mean_edge: f64,
}

impl Rim {
    pub(super) fn new(mesh: &HalfedgeMesh, all: &[BoundaryLoop], loops: Vec<usize>) -> Self {
        let mut vertices = Vec::new();
        let mut starts = vec![0];
        for &index in &loops {
            vertices.extend_from_slice(&all[index].vertices);
            starts.push(vertices.len());
        }
        let local: HashMap<u32, u32> = vertices.iter().copied().zip(0..).collect();
        let mut joined = HashSet::new();
        for (&v, &i) in vertices.iter().zip(local_numbers(vertices.len()).iter()) {
            for spoke in mesh.star(Vertex(v)).filter(|s| s.face.is_some()) {
                for w in mesh.face_vertices(spoke.face) {
                    if let Some(&j) = local.get(&w.0).filter(|j| **j > i) {
                        joined.insert((i, j));
                    }
                }
            }
        }
        let length: f64 = loops.iter().map(|&index| all[index].length).sum();
        Self {
            valences: vertices.iter().map(|&v| mesh.valence(Vertex(v))).collect(),
            mean_edge: length / vertices.len() as f64,
            loops,
            vertices,
            starts,
            joined,
        }
    }

    /// Whether two of the vertices share a face.
    pub(super) fn is_joined(&self, i: u32, j: u32) -> bool {
        self.joined.contains(&(i.min(j), i.max(j)))
    }

    /// The sides of the loops, in the direction of a face that fills them.
    pub(super) fn sides(&self) -> impl Iterator<Item = (u32, u32)> + '_ {
        self.starts.windows(2).flat_map(|range| {
            let (from, to) = (range[0] as u32, range[1] as u32);
            (from..to).map(move |i| (i, if i + 1 == to { from } else { i + 1 }))
        })
    }

    /// Which of the loops a vertex belongs to.
    pub(super) fn loop_of(&self, i: u32) -> usize {
        self.starts.partition_point(|&start| start <= i as usize) - 1
    }

    /// Whether the three vertices of a rim of three have a face already.
    pub(super) fn is_face(&self, mesh: &HalfedgeMesh) -> bool {
        let is_rim = |w: Vertex| self.vertices.contains(&w.0);
        let has_rim = |s: &crate::mesh::walk::Spoke| {
            s.face.is_some() && mesh.face_vertices(s.face).filter(|&w| is_rim(w)).count() == 3
        };
        self.vertices.len() == 3 && mesh.star(Vertex(self.vertices[0])).any(|s| has_rim(&s))
    }

    /// Interior angle at each vertex as the surface around sees it: 2π less its angles.
    pub(super) fn angles(&self, mesh: &HalfedgeMesh, x: &[DVec3]) -> Vec<f64> {
        let angle = |v: &u32| {
            let spokes: Vec<_> = mesh.star(Vertex(*v)).collect();
            let towards = |w: Vertex| x[w.index()] - x[*v as usize];
            let corner = |pair: &[crate::mesh::walk::Spoke]| {
                let (a, b) = (towards(pair[0].neighbour), towards(pair[1].neighbour));
                a.cross(b).length().atan2(a.dot(b))
            };
            TAU - spokes.windows(2).map(corner).sum::<f64>()
        };
        self.vertices.iter().map(angle).collect()
    }
}

fn local_numbers(n: usize) -> Vec<u32> {
    (0..n as u32).collect()
}
