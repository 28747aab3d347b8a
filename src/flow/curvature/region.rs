//! The free vertices, their surroundings and their size.

use crate::flow::FlowError;
use crate::geometry::measure;
use crate::mesh::{Face, HalfedgeMesh, Vertex};
use glam::DVec3;

/// Integrals run over the vertices within so many edges of a free one: those whose
/// curvature, and its gradient, change with it.
const NEAR: usize = 2;

/// What moves, and what must be known around it.
pub(super) struct Region {
    pub(super) is_free: Vec<bool>,
    /// Free vertices, ascending.
    pub(super) free: Vec<u32>,
    /// Vertices that are to be fitted.
    pub(super) reach: Vec<bool>,
    /// Vertices that integrals run over.
    pub(super) near: Vec<u32>,
    /// The faces at these.
    pub(super) near_faces: Vec<Face>,
    /// L = √(area of the faces at free vertices, over the number of patches).
    pub(super) length: f64,
    /// Mean length of the edges at free vertices.
    pub(super) h: f64,
    /// Fewest edges from a free vertex to the boundary of the mesh, up to 3.
    pub(super) margin: usize,
}

impl Region {
    /// Surroundings for a law of that depth, at positions `x`.
    pub(super) fn new(mesh: &HalfedgeMesh, x: &[DVec3], is_free: Vec<bool>, depth: usize) -> Self {
        let free: Vec<u32> = (0..is_free.len() as u32)
            .filter(|&v| is_free[v as usize])
            .collect();
        let rings = rings(mesh, &is_free, (2 * depth).max(NEAR + 2).max(3));
        // A stencil extends over two rings at most.
        let needed = 2 * depth + if depth > 0 { NEAR } else { 0 };
        let needed = needed.min(4);
        let boundary = mesh.vertices().filter(|&v| mesh.is_boundary_vertex(v));
        let margin = boundary.map(|v| rings[v.index()]).min();
        let within = |v: usize, most: usize| rings[v] <= most;
        let (length, h) = (
            length(mesh, x, &is_free),
            mean_edge_length(mesh, x, &is_free),
        );
        Self {
            reach: (0..x.len()).map(|v| within(v, needed)).collect(),
            near: (0..x.len() as u32)
                .filter(|&v| within(v as usize, NEAR))
                .collect(),
            near_faces: mesh
                .faces()
                .filter(|&f| mesh.face_vertices(f).any(|v| within(v.index(), NEAR)))
                .collect(),
            length,
            h,
            margin: margin.unwrap_or(usize::MAX).min(3),
            is_free,
            free,
        }
    }
}

/// Edges from the nearest free vertex, up to `most`; more is `usize::MAX`.
fn rings(mesh: &HalfedgeMesh, is_free: &[bool], most: usize) -> Vec<usize> {
    let mut rings: Vec<usize> = is_free
        .iter()
        .map(|&free| if free { 0 } else { usize::MAX })
        .collect();
    let mut front: Vec<Vertex> = mesh.vertices().filter(|v| is_free[v.index()]).collect();
    for ring in 1..=most {
        let mut next = Vec::new();
        for &v in &front {
            for w in mesh.neighbours(v) {
                if rings[w.index()] == usize::MAX {
                    rings[w.index()] = ring;
                    next.push(w);
                }
            }
        }
        front = next;
    }
    rings
}

fn length(mesh: &HalfedgeMesh, x: &[DVec3], is_free: &[bool]) -> f64 {
    let moving = mesh
        .faces()
        .filter(|&f| mesh.face_vertices(f).any(|v| is_free[v.index()]));
    let area: f64 = moving
        .map(|f| measure::face_vector_area(mesh, x, f).length())
        .sum();
    (area / patches(mesh, is_free).max(1) as f64).sqrt()
}

/// Number of connected sets of free vertices.
fn patches(mesh: &HalfedgeMesh, is_free: &[bool]) -> usize {
    let mut is_seen: Vec<bool> = is_free.iter().map(|free| !free).collect();
    let mut count = 0;
    let mut stack = Vec::new();
    for v in mesh.vertices() {
        if is_seen[v.index()] {
            continue;
        }
        count += 1;
        is_seen[v.index()] = true;
        stack.push(v);
        while let Some(v) = stack.pop() {
            for w in mesh.neighbours(v) {
                if !is_seen[w.index()] {
                    is_seen[w.index()] = true;
                    stack.push(w);
                }
            }
        }
    }
    count
}

fn mean_edge_length(mesh: &HalfedgeMesh, x: &[DVec3], is_free: &[bool]) -> f64 {
    let (mut total, mut count) = (0.0, 0usize);
    for e in mesh.edges() {
        if mesh.ends(e).iter().any(|v| is_free[v.index()]) {
            total += measure::edge_length(mesh, x, e);
            count += 1;
        }
    }
    total / count.max(1) as f64
}

/// The preconditions on a mesh.
pub(super) fn check_mesh(mesh: &HalfedgeMesh) -> Result<(), FlowError> {
    let wrong = mesh
        .faces()
        .map(|f| (f, mesh.face_vertices(f).count()))
        .find(|(_, corners)| *corners != 3);
    if let Some((face, corners)) = wrong {
        return Err(FlowError::NotTriangular {
            face: face.0,
            corners,
        });
    }
    if !mesh.is_oriented() {
        return Err(FlowError::NotOriented);
    }
    Ok(())
}
