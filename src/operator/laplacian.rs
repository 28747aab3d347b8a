//! The cotangent Laplacian, assembled from surface elements.

use super::element::Elements;
use crate::interrupt::paced;
use crate::linalg::Pattern;
use glam::DVec3;

/// Stiffness matrix `L_ij = ∫ ⟨∇φ_i, ∇φ_j⟩ dA` of the hat functions: symmetric, positive
/// semi-definite, rows sum to zero, dimensionless. On triangles its entries are the
/// cotangent weights, `L_ij = −½ (cot α_ij + cot β_ij)`.
///
/// Kept by rows, each the vertex itself and then those that share a face with it.
#[derive(Clone, Debug)]
pub struct Laplacian {
    starts: Vec<u32>,
    members: Vec<u32>,
    values: Vec<f64>,
    /// For every element its `degree²` positions in `values`, row by row.
    positions: Vec<u32>,
}

impl Laplacian {
    /// Finds the pattern; the values come with [`assemble`](Self::assemble).
    pub fn new(elements: &Elements) -> Self {
        let n = elements.n_vertices();
        // Through the symmetric pattern, which sorts and removes repetitions.
        let pattern = Pattern::from_cliques(n, elements.corners());
        let mut starts = vec![0u32; n + 1];
        for j in 0..n {
            for &i in &pattern.rows()[pattern.column(j)] {
                starts[j + 1] += 1;
                if i as usize != j {
                    starts[i as usize + 1] += 1;
                }
            }
        }
        for i in 0..n {
            starts[i + 1] += starts[i];
        }
        let mut next = starts.clone();
        let mut members = vec![0u32; starts[n] as usize];
        let mut push = |row: usize, member: u32| {
            members[next[row] as usize] = member;
            next[row] += 1;
        };
        (0..n).for_each(|i| push(i, i as u32));
        for j in 0..n {
            for &i in &pattern.rows()[pattern.column(j)][1..] {
                push(j, i);
                push(i as usize, j as u32);
            }
        }
        let mut positions = Vec::with_capacity(elements.len() * elements.degree().pow(2));
        for corners in elements.corners() {
            for &i in corners {
                let range = starts[i as usize] as usize..starts[i as usize + 1] as usize;
                for &j in corners {
                    let found = members[range.clone()].iter().position(|&m| m == j);
                    positions.push(starts[i as usize] + found.unwrap_or_default() as u32);
                }
            }
        }
        let values = vec![0.0; members.len()];
        Self {
            starts,
            members,
            values,
            positions,
        }
    }

    /// Computes the values for vertices at `x`; some of them where the work is given up.
    pub fn assemble(&mut self, elements: &Elements, x: &[DVec3]) {
        let degree = elements.degree();
        self.values.fill(0.0);
        for (e, positions) in paced(self.positions.chunks_exact(degree * degree).enumerate()) {
            for node in elements.nodes(x, e) {
                for (i, row) in positions.chunks_exact(degree).enumerate() {
                    for (j, &k) in row.iter().enumerate() {
                        let product = node.gradients[i].dot(node.gradients[j]);
                        self.values[k as usize] += node.area * product;
                    }
                }
            }
        }
    }

    /// Number of rows.
    pub fn n(&self) -> usize {
        self.starts.len() - 1
    }

    fn range(&self, i: usize) -> std::ops::Range<usize> {
        self.starts[i] as usize..self.starts[i + 1] as usize
    }

    /// The vertices of row `i`: itself first, then its neighbours.
    pub fn members(&self, i: usize) -> &[u32] {
        &self.members[self.range(i)]
    }

    /// The values of row `i`, in the order of its members.
    pub fn row(&self, i: usize) -> &[f64] {
        &self.values[self.range(i)]
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::curvature::area_gradient;
    use crate::mesh::{build, shape};

    #[test]
    fn rows_sum_to_zero_and_the_laplacian_of_x_is_the_area_gradient() {
        let sample = shape::make("bumpy-sphere", &[("level".into(), 2.0)]).expect("a shape");
        let built = build(&sample.soup).expect("a surface");
        let (mesh, x) = (built.mesh, built.positions);
        let elements = Elements::of(&mesh).expect("triangles");
        let mut laplacian = Laplacian::new(&elements);
        laplacian.assemble(&elements, &x);
        let expected = area_gradient(&mesh, &x);
        for (i, expected) in expected.iter().enumerate() {
            assert_eq!(laplacian.members(i)[0] as usize, i);
            assert!(laplacian.row(i).iter().sum::<f64>().abs() < 1e-12);
            let found: DVec3 = laplacian
                .members(i)
                .iter()
                .zip(laplacian.row(i))
                .map(|(&j, w)| *w * x[j as usize])
                .sum();
            assert!((found - *expected).length() < 1e-13, "vertex {i}");
        }
    }
}
