//! Fill-reducing orders of elimination: approximate minimum degree and geometric
//! nested dissection.

use super::pattern::Pattern;
use super::vertex_cover::{Bipartite, minimum_vertex_cover};
use crate::interrupt;
use faer::dyn_stack::{MemBuffer, MemStack};
use faer::sparse::linalg::amd;
use faer::sparse::{FaerError, SymbolicSparseColMatRef};
use glam::{DMat3, DVec3};

/// Parts of a dissection of at most this many vertices are ordered by minimum degree.
///
/// Smaller leaves cut where minimum degree would do better; larger ones leave it pieces
/// in which its fill is above that of dissection.
pub(super) const LEAF: usize = 120;

/// Iterations of the power method for the principal axis; an axis a few degrees off
/// cuts as well.
const AXIS_ITERATIONS: usize = 20;

/// Neighbours of each row of a symmetric matrix, ascending, itself not counted.
pub(super) struct Graph {
    starts: Vec<u32>,
    neighbours: Vec<u32>,
}

impl Graph {
    pub(super) fn new(pattern: &Pattern) -> Self {
        let n = pattern.n();
        let mut starts = vec![0; n + 1];
        let pairs = || {
            (0..n).flat_map(|j| {
                pattern
                    .column(j)
                    .skip(1)
                    .map(move |k| (j, pattern.rows()[k] as usize))
            })
        };
        for (i, j) in pairs() {
            starts[i] += 1;
            starts[j] += 1;
        }
        let mut total = 0;
        for start in &mut starts {
            total += std::mem::replace(start, total);
        }
        interrupt::pulse();
        let mut next = starts.clone();
        let mut neighbours = vec![0; total as usize];
        for (i, j) in pairs() {
            for (from, to) in [(i, j), (j, i)] {
                neighbours[next[from] as usize] = to as u32;
                next[from] += 1;
            }
        }
        Self { starts, neighbours }
    }

    pub(super) fn n(&self) -> usize {
        self.starts.len() - 1
    }

    pub(super) fn neighbours(&self, i: u32) -> &[u32] {
        &self.neighbours[self.starts[i as usize] as usize..self.starts[i as usize + 1] as usize]
    }
}

/// Approximate minimum degree (Amestoy, Davis, Duff [ADD96](crate::bibliography#add96)): the row
/// eliminated first, second, …
pub(super) fn minimum_degree(graph: &Graph) -> Result<Vec<u32>, FaerError> {
    minimum_degree_of(&graph.starts, &graph.neighbours)
}

/// The same for neighbour lists, ascending and both ways.
fn minimum_degree_of(starts: &[u32], neighbours: &[u32]) -> Result<Vec<u32>, FaerError> {
    let n = starts.len() - 1;
    let graph = SymbolicSparseColMatRef::new_checked(n, n, starts, None, neighbours);
    let (mut order, mut inverse) = (vec![0; n], vec![0; n]);
    let mut memory = MemBuffer::try_new(amd::order_scratch::<u32>(n, neighbours.len() / 2))?;
    let stack = MemStack::new(&mut memory);
    amd::order(
        &mut order,
        &mut inverse,
        graph,
        amd::Control::default(),
        stack,
    )?;
    Ok(order)
}

/// Nested dissection by coordinates: the row eliminated first, second, …
///
/// A part is split at the median of its principal axis; the separator is a minimum vertex cover
/// of the edges *of the matrix graph* that cross, and is eliminated after both halves. On a
/// surface of n vertices with bounded stencils the factor has O(n log n) entries and costs
/// O(n^{3/2}) operations (George [G73](crate::bibliography#g73); Lipton, Rose and Tarjan
/// [LRT79](crate::bibliography#lrt79)). The order itself takes O(n log n). Coordinates that
/// coincide or are not finite only make it a poorer order. Parts of at most `leaf` vertices are
/// ordered by minimum degree.
pub(super) fn nested_dissection(
    graph: &Graph,
    points: &[DVec3],
    leaf: usize,
) -> Result<Vec<u32>, FaerError> {
    let n = points.len();
    let mut order: Vec<u32> = (0..n as u32).collect();
    let mut dissection = Dissection {
        graph,
        points,
        part: vec![0; n],
        local: vec![0; n],
        n_parts: 0,
        leaf,
    };
    dissection.dissect(&mut order)?;
    Ok(order)
}

struct Dissection<'a> {
    graph: &'a Graph,
    points: &'a [DVec3],
    /// The part each vertex was put into last.
    part: Vec<u32>,
    /// Number of each vertex within the piece at hand.
    local: Vec<u32>,
    n_parts: u32,
    leaf: usize,
}

impl Dissection<'_> {
    /// Brings the vertices of a part into the order of elimination; leaves them in any where the
    /// work is given up.
    fn dissect(&mut self, vertices: &mut [u32]) -> Result<(), FaerError> {
        if interrupt::check().is_err() {
            return Ok(());
        }
        if vertices.len() <= self.leaf {
            return self.order_leaf(vertices);
        }
        let [n_near, n_far] = self.separate(vertices);
        let (near, rest) = vertices.split_at_mut(n_near);
        self.dissect(near)?;
        self.dissect(&mut rest[..n_far])
    }

    /// Rearranges the vertices to near half, far half, separator; returns the sizes of
    /// the halves. No edge joins the two.
    fn separate(&mut self, vertices: &mut [u32]) -> [usize; 2] {
        let axis = principal_axis(vertices.iter().map(|&v| self.points[v as usize]));
        let middle = vertices.len() / 2;
        vertices.select_nth_unstable_by(middle, |&a, &b| {
            let height = |v: u32| self.points[v as usize].dot(axis);
            height(a).total_cmp(&height(b)).then(a.cmp(&b))
        });

        let [near, far, separator] = [1, 2, 3].map(|k| self.n_parts + k);
        self.n_parts += 3;
        for (k, &v) in vertices.iter().enumerate() {
            self.part[v as usize] = if k < middle { near } else { far };
        }

        let (mut left, mut right) = (Vec::new(), Vec::new());
        let mut cut = Bipartite {
            starts: vec![0],
            ..Bipartite::default()
        };
        for &u in &vertices[..middle] {
            for &v in self.graph.neighbours(u) {
                if self.part[v as usize] == far {
                    let known = self.local[v as usize] as usize;
                    if right.get(known) != Some(&v) {
                        self.local[v as usize] = right.len() as u32;
                        right.push(v);
                    }
                    cut.targets.push(self.local[v as usize]);
                }
            }
            if cut.targets.len() as u32 > cut.starts[left.len()] {
                left.push(u);
                cut.starts.push(cut.targets.len() as u32);
            }
        }
        cut.n_right = right.len();
        let (left_cover, right_cover) = minimum_vertex_cover(&cut);
        let ends = left
            .iter()
            .zip(&left_cover)
            .chain(right.iter().zip(&right_cover));
        for (&v, _) in ends.filter(|(_, in_cover)| **in_cover) {
            self.part[v as usize] = separator;
        }
        vertices.sort_unstable_by_key(|&v| self.part[v as usize]);
        [near, far].map(|part| {
            vertices
                .iter()
                .filter(|&&v| self.part[v as usize] == part)
                .count()
        })
    }

    /// Orders the vertices of a leaf by minimum degree within it.
    fn order_leaf(&mut self, vertices: &mut [u32]) -> Result<(), FaerError> {
        self.n_parts += 1;
        for (k, &v) in vertices.iter().enumerate() {
            self.part[v as usize] = self.n_parts;
            self.local[v as usize] = k as u32;
        }
        let (mut starts, mut rows) = (vec![0], Vec::new());
        for &u in &*vertices {
            let from = rows.len();
            let inside = |v: &&u32| self.part[**v as usize] == self.n_parts;
            let neighbours = self.graph.neighbours(u).iter().filter(inside);
            rows.extend(neighbours.map(|&v| self.local[v as usize]));
            rows[from..].sort_unstable();
            starts.push(rows.len() as u32);
        }
        let order: Vec<u32> = minimum_degree_of(&starts, &rows)?
            .iter()
            .map(|&k| vertices[k as usize])
            .collect();
        vertices.copy_from_slice(&order);
        Ok(())
    }
}

/// Direction in which the points spread most: the leading eigenvector of their
/// covariance by the power method.
fn principal_axis(points: impl ExactSizeIterator<Item = DVec3> + Clone) -> DVec3 {
    let centre = points.clone().sum::<DVec3>() / points.len() as f64;
    let covariance = points.fold(DMat3::ZERO, |sum, p| {
        let d = p - centre;
        sum + DMat3::from_cols(d * d.x, d * d.y, d * d.z)
    });
    // No mesh in practice lies exactly across this direction.
    let start = DVec3::new(0.53, 0.61, 0.59);
    (0..AXIS_ITERATIONS).fold(start, |axis, _| (covariance * axis).normalize_or(axis))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Square grid in which a vertex meets those within one step of each side, lifted to
    /// a bowl.
    fn grid(side: u32) -> (Graph, Vec<DVec3>) {
        let cell = |i: u32, j: u32| {
            [
                i * side + j,
                i * side + j + 1,
                (i + 1) * side + j,
                (i + 1) * side + j + 1,
            ]
        };
        let cells = (0..side - 1).flat_map(|i| (0..side - 1).map(move |j| cell(i, j)));
        let n = side * side;
        let point = |k: u32| {
            let (x, y) = (f64::from(k / side), f64::from(k % side));
            DVec3::new(x, 1.3 * y, 0.01 * x * y)
        };
        let pattern = Pattern::from_cliques(n as usize, cells);
        (Graph::new(&pattern), (0..n).map(point).collect())
    }

    #[test]
    fn separators_separate_and_are_small() {
        let (graph, points) = grid(40);
        let n = points.len();
        let mut dissection = Dissection {
            graph: &graph,
            points: &points,
            part: vec![0; n],
            local: vec![0; n],
            n_parts: 0,
            leaf: LEAF,
        };
        let mut vertices: Vec<u32> = (0..n as u32).collect();
        let [near, far] = dissection.separate(&mut vertices);
        let separator = n - near - far;
        assert!(near.abs_diff(far) <= 2 * separator, "{near} and {far}");
        // One row of the grid; the neighbours of one half would be as many.
        assert!((40..=42).contains(&separator), "{separator}");
        for &u in &vertices[..near] {
            for v in graph.neighbours(u) {
                assert!(!vertices[near..near + far].contains(v), "{u} meets {v}");
            }
        }
    }

    #[test]
    fn every_vertex_is_eliminated_once() {
        let (graph, points) = grid(57);
        let mut order = nested_dissection(&graph, &points, LEAF).unwrap();
        order.sort_unstable();
        assert!(order.iter().copied().eq(0..57 * 57));
    }

    #[test]
    fn the_principal_axis_is_where_points_spread() {
        let direction = DVec3::new(2.0, -1.0, 0.5).normalize();
        let across = direction.any_orthonormal_vector();
        let points = (0..100).map(|k| {
            let t = f64::from(k);
            DVec3::ONE + t * direction + 20.0 * (7.0 * t).sin() * across
        });
        assert!(principal_axis(points).dot(direction).abs() > 0.99);
    }
}
