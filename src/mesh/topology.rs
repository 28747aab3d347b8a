//! Components, Euler characteristic, genus.

use super::{HalfedgeMesh, Vertex};

impl HalfedgeMesh {
    /// For each vertex the number of its connected component, and how many there are.
    pub fn components(&self) -> (Vec<u32>, usize) {
        let mut component = vec![u32::MAX; self.n_vertices()];
        let mut count = 0;
        let mut stack: Vec<Vertex> = Vec::new();
        for seed in self.vertices() {
            if component[seed.index()] != u32::MAX {
                continue;
            }
            component[seed.index()] = count;
            stack.push(seed);
            while let Some(v) = stack.pop() {
                for w in self.neighbours(v) {
                    if component[w.index()] == u32::MAX {
                        component[w.index()] = count;
                        stack.push(w);
                    }
                }
            }
            count += 1;
        }
        (component, count as usize)
    }

    /// Euler characteristic χ = V − E + F.
    pub fn euler_characteristic(&self) -> i64 {
        self.n_vertices() as i64 - self.n_edges() as i64 + self.n_faces() as i64
    }

    /// Genus summed over components with boundary loops capped, from
    /// Σ (2 − 2g) = χ + loops; `None` if the surface is not orientable.
    pub fn genus(&self) -> Option<i64> {
        let capped = self.euler_characteristic() + self.n_boundary_loops() as i64;
        let components = self.components().1 as i64;
        self.is_oriented().then_some((2 * components - capped) / 2)
    }
}
