//! Polyharmonic fill: free vertices placed so that a power of the Laplacian vanishes there.
//!
//! With the cotangent stiffness C and the lumped mass M,
//!
//! ```math
//! \bigl[ C (M^{-1} C)^{k-1} x \bigr]_{\text{free}} = 0, \qquad \text{the other vertices held.}
//! ```
//!
//! k = 1 is the membrane the rim spans, k = 2 also meets the tangent planes around it,
//! k = 3 the curvatures too: of the surroundings it uses k rings. C and M are those of the
//! positions given, so a fill that moves far is repeated; it is homogeneous in x and
//! dimensionless in k, and does not change with position, orientation or size. The matrix
//! is symmetric and positive definite wherever a component has a held vertex; its condition
//! grows like (diameter/edge)^2k.

use crate::linalg::{Ldlt, LinalgError, Pattern, Symbolic};
use crate::mesh::{Edge, HalfedgeMesh, Vertex};
use glam::DVec3;
use std::collections::VecDeque;
use std::sync::Arc;

/// Cotangents are bounded by this, so that a triangle without area weighs much but not
/// infinitely.
const MAX_COTANGENT: f64 = 1e3;

/// Corrections from the residual with the factor at hand; the first is the solve itself.
const CORRECTIONS: usize = 3;

const OUTSIDE: u32 = u32::MAX;

/// The largest order up to `wanted` whose stencils at the free vertices do not reach a
/// boundary: all vertices less than k edges from a free one must be interior. At least 1.
pub fn supported_order(mesh: &HalfedgeMesh, free: &[bool], wanted: usize) -> usize {
    let near = Neighbourhood::new(mesh, free, wanted.saturating_sub(1));
    let boundary = near.members.iter().zip(&near.depths);
    boundary
        .filter(|(v, _)| mesh.is_boundary_vertex(**v))
        .map(|(_, depth)| *depth)
        .min()
        .map_or(wanted, |depth| wanted.min(depth))
        .max(1)
}

/// Moves the free vertices of a triangle mesh to the polyharmonic fill of order `k ≥ 1`.
///
/// Vertices of components without a held vertex stay where they are.
///
/// # Errors
/// [`LinalgError`]; `x` is unchanged.
pub fn fill(
    mesh: &HalfedgeMesh,
    x: &mut [DVec3],
    free: &[bool],
    k: usize,
) -> Result<(), LinalgError> {
    let free = anchored(mesh, free);
    let near = Neighbourhood::new(mesh, &free, k.max(1));
    let n_free = near.depths.iter().filter(|d| **d == 0).count();
    if n_free == 0 {
        return Ok(());
    }
    let operator = IteratedLaplacian::new(mesh, x, &near, k.max(1));
    let (pattern, values) = operator.matrix(n_free);
    let points: Vec<DVec3> = near.members[..n_free]
        .iter()
        .map(|v| x[v.index()])
        .collect();
    let symbolic = Arc::new(Symbolic::analyse(&pattern, Some(&points))?);
    let mut factor = Ldlt::new(symbolic)?;
    factor.factor(&values)?;
    // For displacements: what cancels is then small, and each correction gains digits.
    let mut local: Vec<DVec3> = near.members.iter().map(|v| x[v.index()]).collect();
    for _ in 0..CORRECTIONS {
        let mut moves = operator.apply(&local);
        moves.truncate(n_free);
        factor.solve_in_place(&mut moves);
        if let Some(row) = moves.iter().position(|m| !m.is_finite()) {
            let row = near.members[row].index();
            return Err(LinalgError::NonFiniteRightHandSide { row });
        }
        for (p, m) in local.iter_mut().zip(&moves) {
            *p -= *m;
        }
    }
    for (v, p) in near.members[..n_free].iter().zip(local) {
        x[v.index()] = p;
    }
    Ok(())
}

/// `free` without the components that have no held vertex; looks at free vertices only.
pub(crate) fn anchored(mesh: &HalfedgeMesh, free: &[bool]) -> Vec<bool> {
    let mut anchored = free.to_vec();
    let mut is_seen = vec![false; free.len()];
    let mut region: Vec<Vertex> = Vec::new();
    for seed in mesh.vertices() {
        if !free[seed.index()] || is_seen[seed.index()] {
            continue;
        }
        region.clear();
        region.push(seed);
        is_seen[seed.index()] = true;
        let (mut at, mut meets_held) = (0, false);
        while at < region.len() {
            for w in mesh.neighbours(region[at]) {
                meets_held |= !free[w.index()];
                if free[w.index()] && !is_seen[w.index()] {
                    is_seen[w.index()] = true;
                    region.push(w);
                }
            }
            at += 1;
        }
        if !meets_held {
            region.iter().for_each(|v| anchored[v.index()] = false);
        }
    }
    anchored
}

/// The vertices within some number of edges of a free one, nearest first.
struct Neighbourhood {
    members: Vec<Vertex>,
    /// Distance of each in edges; 0 for the free ones.
    depths: Vec<usize>,
    /// Number among the members of each vertex of the mesh, or [`OUTSIDE`].
    local: Vec<u32>,
}

impl Neighbourhood {
    fn new(mesh: &HalfedgeMesh, free: &[bool], reach: usize) -> Self {
        let members: Vec<Vertex> = mesh.vertices().filter(|v| free[v.index()]).collect();
        let mut this = Self {
            depths: vec![0; members.len()],
            local: vec![OUTSIDE; mesh.n_vertices()],
            members,
        };
        for (i, v) in this.members.iter().enumerate() {
            this.local[v.index()] = i as u32;
        }
        let mut queue: VecDeque<usize> = (0..this.members.len()).collect();
        while let Some(i) = queue.pop_front() {
            let depth = this.depths[i] + 1;
            if depth > reach {
                break;
            }
            for w in mesh.neighbours(this.members[i]) {
                if this.local[w.index()] == OUTSIDE {
                    this.local[w.index()] = this.members.len() as u32;
                    queue.push_back(this.members.len());
                    this.members.push(w);
                    this.depths.push(depth);
                }
            }
        }
        this
    }
}

/// Rows of C and entries of M at the vertices less than k edges from a free one.
struct IteratedLaplacian {
    k: usize,
    starts: Vec<usize>,
    columns: Vec<u32>,
    weights: Vec<f64>,
    masses: Vec<f64>,
    /// Number of members within so many edges of a free vertex.
    within: Vec<usize>,
    n: usize,
}

impl IteratedLaplacian {
    fn new(mesh: &HalfedgeMesh, x: &[DVec3], near: &Neighbourhood, k: usize) -> Self {
        let within: Vec<usize> = (0..=k)
            .map(|depth| near.depths.partition_point(|d| *d <= depth))
            .collect();
        let mut this = Self {
            k,
            starts: vec![0],
            columns: Vec::new(),
            weights: Vec::new(),
            masses: Vec::new(),
            n: near.members.len(),
            within,
        };
        for (i, &v) in near.members[..this.within[k - 1]].iter().enumerate() {
            let diagonal = this.columns.len();
            this.columns.push(i as u32);
            this.weights.push(0.0);
            let mut mass = 0.0;
            for spoke in mesh.star(v) {
                let weight = cotangent_weight(mesh, x, spoke.edge);
                this.columns.push(near.local[spoke.neighbour.index()]);
                this.weights.push(-weight);
                this.weights[diagonal] += weight;
                if spoke.face.is_some() {
                    let [a, b, c] = mesh.triangle(spoke.face).map(|v| x[v.index()]);
                    mass += (b - a).cross(c - a).length() / 6.0;
                }
            }
            this.masses.push(mass.max(f64::MIN_POSITIVE));
            this.starts.push(this.columns.len());
        }
        // Against overflow of M⁻² where triangles are tiny: the fill does not depend on the
        // unit of area.
        let mean = this.masses.iter().sum::<f64>() / this.masses.len().max(1) as f64;
        for mass in &mut this.masses {
            *mass = (*mass / mean).max(1e-9);
        }
        this
    }

    fn row(&self, i: usize) -> impl Iterator<Item = (usize, f64)> + '_ {
        let range = self.starts[i]..self.starts[i + 1];
        let columns = self.columns[range.clone()].iter().map(|&j| j as usize);
        columns.zip(self.weights[range].iter().copied())
    }

    /// The operator on values of the members; right at the free ones, which come first.
    fn apply(&self, x: &[DVec3]) -> Vec<DVec3> {
        let mut values = x.to_vec();
        for level in (0..self.k).rev() {
            let rows = self.within[level];
            let mut next: Vec<DVec3> = (0..rows)
                .map(|i| self.row(i).map(|(j, w)| w * values[j]).sum())
                .collect();
            if level > 0 {
                for (value, mass) in next.iter_mut().zip(&self.masses) {
                    *value /= *mass;
                }
            }
            values = next;
        }
        values
    }

    /// The operator among the free vertices.
    fn matrix(&self, n_free: usize) -> (Pattern, Vec<f64>) {
        let mut rows: Vec<(u32, u32, f64)> = Vec::new();
        let mut sums = vec![0.0; self.n];
        let mut touched: Vec<usize> = Vec::new();
        for f in 0..n_free {
            // C is symmetric: its column at a vertex is its row there.
            let mut support = vec![(f, 1.0)];
            for level in 0..self.k {
                for (i, value) in support.drain(..) {
                    let value = if level == 0 {
                        value
                    } else {
                        value / self.masses[i]
                    };
                    for (j, w) in self.row(i) {
                        if sums[j] == 0.0 {
                            touched.push(j);
                        }
                        sums[j] += w * value;
                    }
                }
                // A sum that passed through zero is listed twice; the second is then 0.
                support.extend(touched.drain(..).map(|j| (j, std::mem::take(&mut sums[j]))));
            }
            let lower = support.iter().filter(|(j, _)| *j <= f);
            rows.extend(lower.map(|&(j, value)| (f as u32, j as u32, value)));
        }
        let pattern = Pattern::from_cliques(n_free, rows.iter().map(|&(i, j, _)| [i, j]));
        let mut values = vec![0.0; pattern.nnz()];
        for (i, j, value) in rows {
            values[pattern.slot(i, j)] += value;
        }
        (pattern, values)
    }
}

/// ½ (cot α + cot β) of the angles opposite to an edge.
fn cotangent_weight(mesh: &HalfedgeMesh, x: &[DVec3], e: Edge) -> f64 {
    let [a, b] = mesh.ends(e).map(|v| x[v.index()]);
    let h = e.halfedge();
    let inner = [h, h.twin()]
        .into_iter()
        .filter(|&h| !mesh.is_boundary_halfedge(h));
    let cotangent = inner.map(|h| {
        let apex = x[mesh.tail(mesh.prev(h)).index()];
        let (u, v) = (a - apex, b - apex);
        let (dot, cross) = (u.dot(v), u.cross(v).length());
        if cross * MAX_COTANGENT > dot.abs() {
            dot / cross
        } else {
            MAX_COTANGENT * dot.signum()
        }
    });
    0.5 * cotangent.sum::<f64>()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::{build, shape};

    /// A flat hexagon of equilateral triangles, its vertices lifted a little, and which of
    /// them are at least `rings` edges from the border.
    fn lifted(rings: usize, z: impl Fn(f64, f64) -> f64) -> (HalfedgeMesh, Vec<DVec3>, Vec<bool>) {
        let sample = shape::make("six-sided-hole", &[("height".into(), 0.0)]).expect("a shape");
        let built = build(&sample.soup).expect("a surface");
        let mut x = built.positions;
        for p in &mut x {
            p.z = 1e-6 * z(p.x, p.y);
        }
        let mut free = vec![true; x.len()];
        for _ in 0..rings {
            let held: Vec<Vertex> = built
                .mesh
                .vertices()
                .filter(|&v| {
                    built.mesh.is_boundary_vertex(v)
                        || built.mesh.neighbours(v).any(|w| !free[w.index()])
                })
                .collect();
            held.iter().for_each(|v| free[v.index()] = false);
        }
        (built.mesh, x, free)
    }

    #[test]
    fn order_k_reproduces_polynomials_of_degree_2k_minus_1_on_a_lattice() {
        let quintic = |x: f64, y: f64| x.powi(5) - 3.0 * x.powi(2) * y.powi(3) + y.powi(4) - x * y;
        let cubic = |x: f64, y: f64| x.powi(3) - 2.0 * x * y * y + y * y;
        let linear = |x: f64, y: f64| 0.3 * x - y;
        let error = |k: usize, z: &dyn Fn(f64, f64) -> f64| {
            let (mesh, x, free) = lifted(3, z);
            assert_eq!(supported_order(&mesh, &free, 3), 3);
            let mut filled = x.clone();
            for (p, _) in filled.iter_mut().zip(&free).filter(|(_, f)| **f) {
                p.z = 0.0;
            }
            fill(&mesh, &mut filled, &free, k).expect("solved");
            let heights = x.iter().zip(&filled).map(|(a, b)| (a.z - b.z).abs());
            heights.fold(0.0, f64::max) / 1e-6
        };
        assert!(error(1, &linear) < 1e-6, "{}", error(1, &linear));
        assert!(error(2, &cubic) < 1e-6, "{}", error(2, &cubic));
        assert!(error(3, &quintic) < 1e-5, "{}", error(3, &quintic));
        // And not one degree more than it should.
        assert!(error(1, &cubic) > 1e-2);
        assert!(error(2, &quintic) > 1e-3);
    }

    #[test]
    fn the_order_is_bounded_by_the_rings_there_are() {
        for (rings, expected) in [(1, 1), (2, 2), (3, 3), (4, 3)] {
            let (mesh, _, free) = lifted(rings, |_, _| 0.0);
            assert_eq!(supported_order(&mesh, &free, 3), expected, "{rings} rings");
        }
    }

    #[test]
    fn a_component_without_a_held_vertex_stays() {
        let sample = shape::make("icosphere", &[("level".into(), 1.0)]).expect("a shape");
        let built = build(&sample.soup).expect("a surface");
        let mut x = built.positions.clone();
        let free = vec![true; x.len()];
        fill(&built.mesh, &mut x, &free, 3).expect("nothing to do");
        assert_eq!(x, built.positions);
    }
}
