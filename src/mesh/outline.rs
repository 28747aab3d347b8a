//! What a picture of a mesh is made of: corners of triangles, ends of edges.

use super::HalfedgeMesh;

impl HalfedgeMesh {
    /// Three corners a triangle, end to end; of a triangle mesh.
    pub fn triangle_indices(&self) -> Vec<u32> {
        self.faces()
            .flat_map(|f| self.triangle(f).map(|v| v.0))
            .collect()
    }

    /// Two ends an edge, of all edges or of those on the boundary only.
    pub fn edge_indices(&self, boundary_only: bool) -> Vec<u32> {
        self.edges()
            .filter(|&e| !boundary_only || self.is_boundary_edge(e))
            .flat_map(|e| self.ends(e).map(|v| v.0))
            .collect()
    }
}
