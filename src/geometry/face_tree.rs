//! A hierarchy of bounding boxes over the triangles of a mesh, for finding those that are near
//! each other without asking all pairs.
//!
//! Halved at the median of the box centres along the longest axis, so that the depth is log₂ n on
//! any mesh, of triangles of any sizes; a grid of equal cells has none that suits them all.

use super::measure::triangle_points;
use crate::interrupt;
use crate::mesh::{Face, HalfedgeMesh};
use glam::DVec3;

/// Triangles of a leaf: below this, asking all pairs is faster than halving.
const LEAF: usize = 4;

/// An axis-aligned box.
#[derive(Clone, Copy)]
struct Bounds {
    low: DVec3,
    high: DVec3,
}

impl Bounds {
    const EMPTY: Self = Self {
        low: DVec3::INFINITY,
        high: DVec3::NEG_INFINITY,
    };

    fn around(points: [DVec3; 3], margin: f64) -> Self {
        let [a, b, c] = points;
        Self {
            low: a.min(b).min(c) - margin,
            high: a.max(b).max(c) + margin,
        }
    }

    fn with(self, other: Self) -> Self {
        Self {
            low: self.low.min(other.low),
            high: self.high.max(other.high),
        }
    }

    fn overlaps(&self, other: &Self) -> bool {
        self.low.cmple(other.high).all() && other.low.cmple(self.high).all()
    }

    /// Twice the middle, along one axis.
    fn centre(&self, axis: usize) -> f64 {
        self.low[axis] + self.high[axis]
    }

    fn longest_axis(&self) -> usize {
        let size = self.high - self.low;
        match size {
            _ if size.x >= size.y && size.x >= size.z => 0,
            _ if size.y >= size.z => 1,
            _ => 2,
        }
    }
}

/// A box about some of the triangles.
struct Node {
    bounds: Bounds,
    /// Of a leaf the place of its first triangle, else the right child; the left child follows
    /// its parent.
    at: u32,
    /// Triangles of a leaf; 0 where there are children.
    count: u32,
}

/// A hierarchy over all triangles of a mesh.
pub struct FaceTree {
    nodes: Vec<Node>,
    /// Triangles in the order of the leaves, with their boxes.
    leaves: Vec<(Face, Bounds)>,
}

impl FaceTree {
    /// Over the triangles at `x`, each box wider by `margin` (unit length) on all sides.
    pub fn new(mesh: &HalfedgeMesh, x: &[DVec3], margin: f64) -> Self {
        let bounds = |f| Bounds::around(triangle_points(mesh, x, f), margin);
        let mut tree = Self {
            nodes: Vec::with_capacity(mesh.n_faces()),
            leaves: mesh.faces().map(|f| (f, bounds(f))).collect(),
        };
        if !tree.leaves.is_empty() {
            tree.divide(0, tree.leaves.len());
        }
        tree
    }

    /// Appends the node of a range of triangles and those below it.
    fn divide(&mut self, first: usize, end: usize) {
        let range = &mut self.leaves[first..end];
        let bounds = range.iter().fold(Bounds::EMPTY, |sum, l| sum.with(l.1));
        let node = self.nodes.len();
        self.nodes.push(Node {
            bounds,
            at: first as u32,
            count: range.len() as u32,
        });
        if range.len() <= LEAF {
            return;
        }
        let (axis, middle) = (bounds.longest_axis(), range.len() / 2);
        range.select_nth_unstable_by(middle, |a, b| a.1.centre(axis).total_cmp(&b.1.centre(axis)));
        self.divide(first, first + middle);
        let right = self.nodes.len() as u32;
        self.divide(first + middle, end);
        self.nodes[node].at = right;
        self.nodes[node].count = 0;
    }

    /// Calls `visit` once for every two triangles whose boxes overlap, in no particular order.
    /// `false` if it gave up, after looking at `most` pairs of boxes: of n triangles that are
    /// no longer than a few of their neighbours it takes less than 30 n, but n² of triangles that
    /// are all in one place.
    #[must_use]
    pub fn overlapping_pairs(&self, most: usize, mut visit: impl FnMut(Face, Face)) -> bool {
        let mut waiting = Vec::new();
        if !self.nodes.is_empty() {
            waiting.push((0, 0));
        }
        let mut looked = 0;
        for turn in 1usize.. {
            let Some((a, b)) = waiting.pop() else { break };
            if turn.is_multiple_of(1 << 16) {
                interrupt::pulse();
            }
            let (p, q) = (&self.nodes[a], &self.nodes[b]);
            looked += 1;
            if looked > most {
                return false;
            }
            if a != b && !p.bounds.overlaps(&q.bounds) {
                continue;
            }
            match (self.leaf(p), self.leaf(q)) {
                (Some(own), Some(others)) => {
                    looked += own.len() * others.len();
                    for (k, (f, box_f)) in own.iter().enumerate() {
                        let rest = if a == b { &own[k + 1..] } else { others };
                        let near = rest.iter().filter(|(_, g)| box_f.overlaps(g));
                        near.for_each(|&(g, _)| visit(*f, g));
                    }
                }
                (None, None) if a == b => {
                    let (left, right) = (a + 1, p.at as usize);
                    waiting.extend([(left, left), (right, right), (left, right)]);
                }
                // The larger one is halved first: two of a size are told apart soonest.
                (None, other) if other.is_some() || is_larger(p, q) => {
                    waiting.extend([(a + 1, b), (p.at as usize, b)]);
                }
                _ => waiting.extend([(a, b + 1), (a, q.at as usize)]),
            }
        }
        true
    }

    fn leaf(&self, node: &Node) -> Option<&[(Face, Bounds)]> {
        let first = node.at as usize;
        (node.count > 0).then(|| &self.leaves[first..first + node.count as usize])
    }
}

fn is_larger(p: &Node, q: &Node) -> bool {
    let size = |node: &Node| (node.bounds.high - node.bounds.low).length_squared();
    size(p) >= size(q)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{build, shape};

    #[test]
    fn a_surface_takes_so_many_boxes_a_triangle() {
        for name in ["icosphere", "trefoil", "torus", "bumpy-sphere"] {
            let sample = shape::make(name, &[]).expect("a shape");
            let built = build(&sample.soup).expect("a surface");
            let n = built.mesh.n_faces();
            let tree = FaceTree::new(&built.mesh, &built.positions, 0.0);
            let is_enough = |each: usize| tree.overlapping_pairs(each * n, |_, _| {});
            assert_eq!([16, 30].map(is_enough), [false, true], "{name}");
        }
    }

    #[test]
    fn every_overlap_is_visited_once() {
        for (name, margin) in [("trefoil", 0.0), ("octahedron", 0.0), ("icosphere", 0.1)] {
            let sample = shape::make(name, &[]).expect("a shape");
            let built = build(&sample.soup).expect("a surface");
            let (mesh, x) = (built.mesh, built.positions);
            let mut found = Vec::new();
            let tree = FaceTree::new(&mesh, &x, margin);
            let done = tree.overlapping_pairs(usize::MAX, |f, g| {
                found.push((f.min(g), f.max(g)));
            });
            assert!(done);
            found.sort_unstable();
            let boxes: Vec<Bounds> = mesh
                .faces()
                .map(|f| Bounds::around(triangle_points(&mesh, &x, f), margin))
                .collect();
            let all = mesh
                .faces()
                .flat_map(|f| (0..f.0).map(move |g| (Face(g), f)));
            let mut expected: Vec<_> = all
                .filter(|(f, g)| boxes[f.index()].overlaps(&boxes[g.index()]))
                .collect();
            expected.sort_unstable();
            assert_eq!(found, expected, "{name}");
        }
    }
}
