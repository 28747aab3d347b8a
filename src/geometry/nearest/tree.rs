//! Triangles of a surface in a hierarchy of boxes, for nearest-point queries.

use super::squared_distance;
use crate::mesh::HalfedgeMesh;
use glam::DVec3;

/// Triangles in a box that is not divided further.
const LEAF: usize = 4;

/// Boxes are halved by number, so that 2³² triangles make no deeper a tree than this.
const DEPTH: usize = 64;

/// A box and what is in it.
#[derive(Clone, Copy)]
struct Node {
    low: DVec3,
    high: DVec3,
    /// First triangle of a leaf; of an inner node the second child, the first being next to it.
    first: u32,
    /// Number of triangles of a leaf; 0 for an inner node.
    count: u32,
}

/// A binary tree of axis-aligned boxes around the triangles of a surface, halved at the
/// median along their longest side. A polygon is the fan from its first corner.
///
/// It holds connectivity and boxes but no positions: these are given with each query, and
/// must be those that the boxes were fitted to.
#[derive(Clone)]
pub struct SurfaceTree {
    triangles: Vec<[u32; 3]>,
    nodes: Vec<Node>,
}

impl SurfaceTree {
    /// The tree of the surface at `x`, in O(n log n).
    pub fn new(mesh: &HalfedgeMesh, x: &[DVec3]) -> Self {
        let mut triangles = Vec::with_capacity(mesh.n_faces());
        for f in mesh.faces() {
            let mut corners = mesh.face_vertices(f).map(|v| v.0);
            let (Some(a), Some(mut b)) = (corners.next(), corners.next()) else {
                continue;
            };
            for c in corners {
                triangles.push([a, b, c]);
                b = c;
            }
        }
        let mut tree = Self {
            nodes: Vec::with_capacity(2 * triangles.len() / LEAF + 1),
            triangles,
        };
        tree.divide(x);
        tree.refit(x);
        tree
    }

    /// Sorts the triangles into leaves; boxes are left to [`Self::refit`].
    fn divide(&mut self, x: &[DVec3]) {
        // Ranges of triangles that still need a node, with the parent whose second child
        // that node will be.
        let mut open = vec![(0, self.triangles.len(), None)];
        while let Some((start, end, parent)) = open.pop() {
            let here = self.nodes.len();
            if let Some(parent) = parent {
                let parent: &mut Node = &mut self.nodes[parent];
                parent.first = here as u32;
            }
            let mut node = Node {
                low: DVec3::ZERO,
                high: DVec3::ZERO,
                first: start as u32,
                count: (end - start) as u32,
            };
            if end - start > LEAF {
                node.count = 0;
                let centre = |t: &[u32; 3]| t.iter().map(|&v| x[v as usize]).sum::<DVec3>();
                let range = &mut self.triangles[start..end];
                let empty = (DVec3::INFINITY, DVec3::NEG_INFINITY);
                let (low, high) = range
                    .iter()
                    .map(centre)
                    .fold(empty, |(low, high), p| (low.min(p), high.max(p)));
                let size = (high - low).to_array();
                let axis = (0..3).fold(0, |a, b| if size[b] > size[a] { b } else { a });
                let half = range.len() / 2;
                range.select_nth_unstable_by(half, |s, t| {
                    centre(s)[axis].total_cmp(&centre(t)[axis])
                });
                // The first child is taken next, and so stands next to its parent.
                open.push((start + half, end, Some(here)));
                open.push((start, start + half, None));
            }
            self.nodes.push(node);
        }
    }

    /// Fits the boxes to other positions of the same connectivity, in O(n). Distances stay
    /// exact; after large moves boxes overlap more and queries take longer.
    pub fn refit(&mut self, x: &[DVec3]) {
        // Children stand after their parents.
        for n in (0..self.nodes.len()).rev() {
            let node = self.nodes[n];
            let (low, high) = if node.count > 0 {
                let empty = (DVec3::INFINITY, DVec3::NEG_INFINITY);
                self.leaf(&node)
                    .iter()
                    .flatten()
                    .map(|&v| x[v as usize])
                    .fold(empty, |(low, high), p| (low.min(p), high.max(p)))
            } else {
                let (a, b) = (&self.nodes[n + 1], &self.nodes[node.first as usize]);
                (a.low.min(b.low), a.high.max(b.high))
            };
            (self.nodes[n].low, self.nodes[n].high) = (low, high);
        }
    }

    fn leaf(&self, node: &Node) -> &[[u32; 3]] {
        &self.triangles[node.first as usize..(node.first + node.count) as usize]
    }

    /// Distance from `p` to the nearest point of the surface at `x`, or `ceiling` if that is
    /// less. Exact: no triangle is left out that could be nearer.
    pub fn distance(&self, x: &[DVec3], p: DVec3, ceiling: f64) -> f64 {
        let mut least = ceiling * ceiling;
        let mut stack = [(0usize, 0.0f64); DEPTH];
        let mut height = 0;
        if let Some(root) = self.nodes.first() {
            stack[0] = (0, box_distance(root, p));
            height = 1;
        }
        while height > 0 {
            height -= 1;
            let (n, bound) = stack[height];
            if bound >= least {
                continue;
            }
            let node = &self.nodes[n];
            if node.count > 0 {
                for t in self.leaf(node) {
                    least = least.min(squared_distance(p, t.map(|v| x[v as usize])));
                }
                continue;
            }
            let mut near = (n + 1, box_distance(&self.nodes[n + 1], p));
            let second = node.first as usize;
            let mut far = (second, box_distance(&self.nodes[second], p));
            if far.1 < near.1 {
                std::mem::swap(&mut near, &mut far);
            }
            (stack[height], stack[height + 1]) = (far, near);
            height += 2;
        }
        least.sqrt()
    }
}

/// Squared distance from a point to a box; 0 inside.
fn box_distance(node: &Node, p: DVec3) -> f64 {
    (node.low - p)
        .max(p - node.high)
        .max(DVec3::ZERO)
        .length_squared()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{build, noise::SplitMix64, shape};

    #[test]
    fn a_query_is_the_least_over_all_triangles() {
        let mut noise = SplitMix64::new(5);
        let mut point = |size: f64| size * DVec3::from([0, 1, 2].map(|_| noise.uniform() - 0.5));
        for name in ["torus", "double-torus", "bumpy-sphere"] {
            let built = build(&shape::make(name, &[]).expect("a shape").soup).expect("a surface");
            let (mesh, x) = (built.mesh, built.positions);
            let mut tree = SurfaceTree::new(&mesh, &x);
            let other: Vec<DVec3> = x.iter().map(|p| *p + point(0.5)).collect();
            for (round, x) in [&x, &other].into_iter().enumerate() {
                if round > 0 {
                    tree.refit(x);
                }
                for _ in 0..200 {
                    let p = point(8.0);
                    let all = mesh
                        .faces()
                        .map(|f| squared_distance(p, mesh.triangle(f).map(|v| x[v.index()])));
                    let expected = all.fold(f64::INFINITY, f64::min).sqrt();
                    let found = tree.distance(x, p, f64::INFINITY);
                    assert!((found - expected).abs() < 1e-14 * expected, "{name}");
                    let half = 0.5 * expected;
                    assert!((tree.distance(x, p, half) - half).abs() < 1e-15 * half);
                }
            }
        }
    }
}
