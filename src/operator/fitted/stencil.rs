//! Which neighbours a vertex is fitted to, and their local parameters.

use super::fit::Fit;
use crate::mesh::{HalfedgeMesh, Vertex};
use glam::{DVec2, DVec3};

/// Largest condition of a fit to the 1-ring; with 30 rough meshes have unstable modes.
const CONDITION: f64 = 8.0;

/// Chooses stencils, with scratch memory.
pub(super) struct Stencils<'a> {
    mesh: &'a HalfedgeMesh,
    members: Vec<u32>,
    parameters: Vec<DVec2>,
    /// Vertices adjacent to the 1-ring, and how often.
    seen: Vec<(u32, usize)>,
}

impl<'a> Stencils<'a> {
    pub(super) fn new(mesh: &'a HalfedgeMesh) -> Self {
        Self {
            mesh,
            members: Vec::new(),
            parameters: Vec::new(),
            seen: Vec::new(),
        }
    }

    /// The stencil chosen last, its vertex left out.
    pub(super) fn members(&self) -> &[u32] {
        &self.members
    }

    /// Fits at a vertex: to the 1-ring with weights 1/d, or, at the boundary, with fewer
    /// than five neighbours or where that is ill-conditioned, to the 1-ring and its flaps with 1/d²,
    /// or to the whole 2-ring.
    pub(super) fn choose(&mut self, x: &[DVec3], v: Vertex, fit: &mut Fit) -> Option<()> {
        let frame = self.frame(x, v)?;
        self.members.clear();
        self.members.extend(self.mesh.neighbours(v).map(|w| w.0));
        if !self.mesh.is_boundary_vertex(v) {
            self.parametrise(x, v, frame);
            if fit.compute(&self.parameters, 1).is_some() && fit.is_conditioned(CONDITION) {
                return Some(());
            }
        }
        let ring = self.members.len();
        // Flaps first: their 1-ring is seen at least twice.
        for least in [2, 1] {
            self.widen(v, ring, least);
            self.parametrise(x, v, frame);
            if fit.compute(&self.parameters, 2).is_some() {
                return Some(());
            }
        }
        None
    }

    /// Adds to the 1-ring the vertices adjacent to at least so many of it.
    fn widen(&mut self, v: Vertex, ring: usize, least: usize) {
        self.members.truncate(ring);
        self.seen.clear();
        for &w in &self.members {
            for u in self.mesh.neighbours(Vertex(w)) {
                if u != v && !self.members.contains(&u.0) {
                    match self.seen.iter_mut().find(|(seen, _)| *seen == u.0) {
                        Some((_, count)) => *count += 1,
                        None => self.seen.push((u.0, 1)),
                    }
                }
            }
        }
        let wide = self.seen.iter().filter(|(_, count)| *count >= least);
        self.members.extend(wide.map(|(u, _)| *u));
    }

    /// Local parameters: direction of the projection onto the tangent plane, length of the
    /// chord. Plain projection would lose the exact normals of spheres.
    fn parametrise(&mut self, x: &[DVec3], v: Vertex, [a, b]: [DVec3; 2]) {
        let centre = x[v.index()];
        self.parameters.clear();
        self.parameters.extend(self.members.iter().map(|&j| {
            let chord = x[j as usize] - centre;
            let flat = DVec2::new(chord.dot(a), chord.dot(b));
            flat * (chord.length() / flat.length())
        }));
    }

    /// Two unit tangents that turn about the angle-weighted normal.
    fn frame(&self, x: &[DVec3], v: Vertex) -> Option<[DVec3; 2]> {
        let centre = x[v.index()];
        let mut normal = DVec3::ZERO;
        for spoke in self.mesh.star(v).filter(|spoke| spoke.face.is_some()) {
            let [a, b, c] = self.mesh.triangle(spoke.face);
            let (p, q) = match v {
                _ if v == a => (b, c),
                _ if v == b => (c, a),
                _ => (a, b),
            };
            let (p, q) = (x[p.index()] - centre, x[q.index()] - centre);
            let cross = p.cross(q);
            let length = cross.length();
            if length > 0.0 {
                normal += cross * (length.atan2(p.dot(q)) / length);
            }
        }
        let normal = normal.try_normalize()?;
        let first = normal.any_orthonormal_vector();
        Some([first, normal.cross(first)])
    }
}
