//! Subdivision of triangles into four: linear, and Loop's smooth scheme.
//!
//! Both split every edge once. The result lists the old vertices first, in
//! their order, then one vertex an edge in the order in which the faces first
//! name the edges; each face `(a, b, c)` becomes its three corner triangles in
//! that order and then the middle one. Orientation is kept.

use std::f64::consts::TAU;

use glam::DVec3;

use crate::message::messages;
use crate::soup::PolygonSoup;

messages! {
    /// Why a soup cannot be subdivided.
    #[derive(Clone, Debug, PartialEq, Eq)]
    pub enum SubdivisionError as "subdivision" {
        /// A face that is not a triangle.
        NotATriangle {
            /// Index of the face.
            face: usize,
            /// Its number of corners.
            degree: usize,
        },
        /// An edge of three or more faces, around which Loop's mask has no meaning.
        NonManifoldEdge {
            /// Smaller end of the edge.
            a: u32,
            /// Larger end of the edge.
            b: u32,
        },
    }
}

/// Splits each triangle at its edge midpoints. The surface stays the same point set.
///
/// # Errors
/// [`SubdivisionError::NotATriangle`].
pub fn linear(soup: &PolygonSoup) -> Result<PolygonSoup, SubdivisionError> {
    let split = Split::new(soup)?;
    let mut positions = soup.positions.clone();
    positions.extend(
        split
            .edges
            .iter()
            .map(|edge| soup.positions[edge.a].midpoint(soup.positions[edge.b])),
    );
    Ok(PolygonSoup::from_faces(positions, &split.faces))
}

/// [`linear`] repeated `levels` times.
///
/// # Errors
/// [`SubdivisionError::NotATriangle`].
pub fn linear_levels(soup: PolygonSoup, levels: usize) -> Result<PolygonSoup, SubdivisionError> {
    (0..levels).try_fold(soup, |soup, _| linear(&soup))
}

/// One step of Loop's scheme (Loop [L87](crate::bibliography#l87)): C² limit surface, C¹ where
/// the valence is not six.
///
/// * new vertex of an interior edge: 3/8 of each end, 1/8 of each opposite corner;
/// * old interior vertex of valence n: `(1 - n w) x + w Σ neighbours` with
///   `w = (5/8 - (3/8 + cos(2π/n)/4)²) / n`, which is 1/16 for n = 6;
/// * boundary: the cubic B-spline of the boundary polygon alone, midpoint for
///   edges and 1/8, 6/8, 1/8 for vertices, so that surfaces with the same
///   boundary keep fitting together;
/// * a vertex with no face, or where several boundary fans meet, stays.
///
/// # Errors
/// [`SubdivisionError::NotATriangle`], [`SubdivisionError::NonManifoldEdge`].
pub fn loop_scheme(soup: &PolygonSoup) -> Result<PolygonSoup, SubdivisionError> {
    let split = Split::new(soup)?;
    let x = &soup.positions;
    let stars = split.stars(x)?;
    let edge_points = split.edges.iter().map(|edge| {
        let ends = x[edge.a] + x[edge.b];
        if edge.degree == 1 {
            ends * 0.5
        } else {
            ends * 0.375 + edge.opposite_sum * 0.125
        }
    });
    let mut positions: Vec<DVec3> = x
        .iter()
        .zip(&stars)
        .map(|(&x, star)| star.mask(x))
        .collect();
    positions.extend(edge_points);
    Ok(PolygonSoup::from_faces(positions, &split.faces))
}

/// The two ends of the edge that each new vertex of either scheme stands for, in the order of
/// the new vertices; those before keep their numbers.
///
/// # Errors
/// [`SubdivisionError::NotATriangle`].
pub fn parents(soup: &PolygonSoup) -> Result<Vec<[u32; 2]>, SubdivisionError> {
    let split = Split::new(soup)?;
    let ends = |edge: &Edge| [edge.a as u32, edge.b as u32];
    Ok(split.edges.iter().map(ends).collect())
}

/// The vertices moved to where Loop's scheme takes them in the end: the limit surface sampled
/// at the same connectivity. It does not change when the mesh is subdivided first.
///
/// * interior vertex of valence n: `(1 - n l) x + l Σ neighbours` with `l = 1/(n + 3/(8 w))`
///   and the `w` of [`loop_scheme`], half of the way to the mean of its neighbours for n = 6;
/// * boundary: 1/6, 4/6, 1/6, the limit of the cubic B-spline.
///
/// # Errors
/// As [`loop_scheme`].
pub fn loop_limit(soup: &PolygonSoup) -> Result<PolygonSoup, SubdivisionError> {
    let split = Split::new(soup)?;
    let x = &soup.positions;
    let stars = split.stars(x)?;
    let limits = x.iter().zip(&stars).map(|(&x, star)| star.limit(x));
    Ok(PolygonSoup {
        positions: limits.collect(),
        ..soup.clone()
    })
}

/// Neighbours of a vertex, summed as they are met.
#[derive(Clone, Default)]
struct Star {
    valence: usize,
    sum: DVec3,
    boundary_valence: usize,
    boundary_sum: DVec3,
}

impl Star {
    fn add(&mut self, neighbour: DVec3, along_boundary: bool) {
        self.valence += 1;
        self.sum += neighbour;
        if along_boundary {
            self.boundary_valence += 1;
            self.boundary_sum += neighbour;
        }
    }

    fn mask(&self, x: DVec3) -> DVec3 {
        match (self.valence, self.boundary_valence) {
            (0, _) => x,
            (n, 0) => {
                let (n, w) = (n as f64, self.weight());
                x * (1.0 - n * w) + self.sum * w
            }
            (_, 2) => x * 0.75 + self.boundary_sum * 0.125,
            _ => x,
        }
    }

    /// Of a neighbour of an interior vertex.
    fn weight(&self) -> f64 {
        let n = self.valence as f64;
        (0.625 - (0.375 + (TAU / n).cos() / 4.0).powi(2)) / n
    }

    fn limit(&self, x: DVec3) -> DVec3 {
        match (self.valence, self.boundary_valence) {
            (0, _) => x,
            (n, 0) => {
                let n = n as f64;
                let l = 1.0 / (n + 0.375 / self.weight());
                x * (1.0 - n * l) + self.sum * l
            }
            (_, 2) => (x * 4.0 + self.boundary_sum) / 6.0,
            _ => x,
        }
    }
}

/// An edge, its number of faces and the sum of the corners opposite to it.
struct Edge {
    a: usize,
    b: usize,
    degree: usize,
    opposite_sum: DVec3,
}

/// Edges and new faces: what both schemes share.
struct Split {
    edges: Vec<Edge>,
    faces: Vec<[u32; 3]>,
}

impl Split {
    fn new(soup: &PolygonSoup) -> Result<Self, SubdivisionError> {
        let n = soup.positions.len() as u32;
        if let Some((face, corners)) = soup.faces().enumerate().find(|(_, f)| f.len() != 3) {
            let degree = corners.len();
            return Err(SubdivisionError::NotATriangle { face, degree });
        }
        // Edges by their ends, to be numbered as the faces meet them.
        let key = |i: u32, j: u32| u64::from(i.min(j)) << 32 | u64::from(i.max(j));
        let sides = |f: &[u32]| [key(f[0], f[1]), key(f[1], f[2]), key(f[2], f[0])];
        let mut keys: Vec<u64> = soup.faces().flat_map(sides).collect();
        keys.sort_unstable();
        keys.dedup();
        let mut number = vec![None; keys.len()];
        let mut edges: Vec<Edge> = Vec::with_capacity(keys.len());
        let mut faces = Vec::with_capacity(4 * soup.n_faces());
        for face in soup.faces() {
            let [a, b, c] = [face[0], face[1], face[2]];
            let mut midpoint = |i: u32, j: u32, k: u32| {
                let rank = keys.partition_point(|&k| k < key(i, j));
                let e = *number[rank].get_or_insert_with(|| {
                    let (a, b) = (i as usize, j as usize);
                    edges.push(Edge {
                        a,
                        b,
                        degree: 0,
                        opposite_sum: DVec3::ZERO,
                    });
                    edges.len() - 1
                });
                edges[e].degree += 1;
                edges[e].opposite_sum += soup.positions[k as usize];
                n + e as u32
            };
            let (ab, bc, ca) = (midpoint(a, b, c), midpoint(b, c, a), midpoint(c, a, b));
            faces.extend([[a, ab, ca], [ab, b, bc], [ca, bc, c], [ab, bc, ca]]);
        }
        Ok(Self { edges, faces })
    }

    /// The neighbours of every vertex.
    fn stars(&self, x: &[DVec3]) -> Result<Vec<Star>, SubdivisionError> {
        let mut stars = vec![Star::default(); x.len()];
        for edge in &self.edges {
            if edge.degree > 2 {
                let (a, b) = (edge.a.min(edge.b) as u32, edge.a.max(edge.b) as u32);
                return Err(SubdivisionError::NonManifoldEdge { a, b });
            }
            stars[edge.a].add(x[edge.b], edge.degree == 1);
            stars[edge.b].add(x[edge.a], edge.degree == 1);
        }
        Ok(stars)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn triangle() -> PolygonSoup {
        PolygonSoup::from_faces(vec![DVec3::ZERO, DVec3::X, DVec3::Y], &[[0, 1, 2]])
    }

    /// Rows of `n` vertices on the lattice spanned by `e` and `f`.
    fn lattice(n: u32, e: DVec3, f: DVec3) -> PolygonSoup {
        let positions = (0..n * n)
            .map(|v| e * f64::from(v % n) + f * f64::from(v / n))
            .collect::<Vec<_>>();
        let mut soup = PolygonSoup {
            positions,
            ..PolygonSoup::default()
        };
        for v in (0..n * (n - 1)).filter(|v| v % n < n - 1) {
            soup.push_face(&[v, v + 1, v + n + 1]);
            soup.push_face(&[v, v + n + 1, v + n]);
        }
        soup
    }

    #[test]
    fn order_is_old_vertices_then_edges_as_met() {
        let fine = linear(&triangle()).unwrap();
        let half = [DVec3::X * 0.5, DVec3::new(0.5, 0.5, 0.0), DVec3::Y * 0.5];
        assert_eq!(fine.positions[..3], triangle().positions);
        assert_eq!(fine.positions[3..], half);
        assert_eq!(fine.corners, [0, 3, 5, 3, 1, 4, 5, 4, 2, 3, 4, 5]);
    }

    #[test]
    fn loop_reproduces_affine_functions_on_the_regular_lattice() {
        // The masks sum to one and are symmetric, so away from the corners, where
        // the B-spline rounds, a regular lattice maps onto the finer lattice.
        let (e, f) = (DVec3::new(1.0, 0.0, 0.5), DVec3::new(0.5, 0.8, -1.0));
        let fine = loop_scheme(&lattice(7, e, f)).unwrap();
        let centre = 3 * 7 + 3;
        assert!(fine.positions[centre].distance(e * 3.0 + f * 3.0) < 1e-14);
        let straight_side = 3;
        assert!(fine.positions[straight_side].distance(e * 3.0) < 1e-14);
    }

    #[test]
    fn loop_mask_of_valence_six() {
        // A unit impulse: 5/8 stays, each neighbour takes 1/16, each of its edges
        // 3/8 and each edge opposite to it 1/8.
        let mut coarse = lattice(7, DVec3::X, DVec3::Y);
        let centre = 3 * 7 + 3;
        coarse.positions[centre].z = 1.0;
        let fine = loop_scheme(&coarse).unwrap();
        let count = |z: f64| {
            fine.positions
                .iter()
                .filter(|p| (p.z - z).abs() < 1e-15)
                .count()
        };
        assert_eq!(fine.positions[centre].z, 0.625);
        assert_eq!(
            [count(0.625), count(0.0625), count(0.375), count(0.125)],
            [1, 6, 6, 6]
        );
        assert_eq!(count(0.0), fine.positions.len() - 19);
    }

    #[test]
    fn loop_boundary_tends_to_the_cubic_b_spline() {
        // Limit of the B-spline at a control point: (1, 4, 1)/6 of its neighbours;
        // inside vertices must not matter.
        let mut soup = lattice(5, DVec3::X, DVec3::Y);
        soup.positions[2].z = 1.0;
        soup.positions[5 + 2].z = 9.0;
        let mut fine = soup;
        for _ in 0..8 {
            fine = loop_scheme(&fine).unwrap();
        }
        assert!(
            (fine.positions[2].z - 4.0 / 6.0).abs() < 1e-4,
            "{}",
            fine.positions[2].z
        );
        assert!(
            (fine.positions[1].z - 1.0 / 6.0).abs() < 1e-4,
            "{}",
            fine.positions[1].z
        );
    }

    #[test]
    fn the_limit_of_the_finer_mesh_is_the_same() {
        // Interior vertices of valence 4 to 7, the boundary, and a corner.
        let mut soup = lattice(7, DVec3::X, DVec3::new(0.5, 0.9, 0.0));
        let octahedron = crate::mesh::shape::platonic::octahedron();
        for (n, p) in soup.positions.iter_mut().enumerate() {
            p.z = (1.3 * n as f64).sin();
        }
        for coarse in [soup, octahedron] {
            let fine = loop_limit(&loop_scheme(&coarse).unwrap()).unwrap();
            let limit = loop_limit(&coarse).unwrap();
            assert_eq!(limit.corners, coarse.corners);
            for (p, q) in limit.positions.iter().zip(&fine.positions) {
                assert!(p.distance(*q) < 1e-14, "{p} {q}");
            }
            let mut deep = coarse;
            for _ in 0..6 {
                deep = loop_scheme(&deep).unwrap();
            }
            for (p, q) in limit.positions.iter().zip(&deep.positions) {
                assert!(p.distance(*q) < 1e-3, "{p} {q}");
            }
        }
    }

    #[test]
    fn refusals() {
        let mut soup = triangle();
        soup.positions.push(DVec3::Z);
        soup.push_face(&[0, 1, 3]);
        soup.positions.push(-DVec3::Z);
        soup.push_face(&[1, 0, 4]);
        assert_eq!(
            loop_scheme(&soup).unwrap_err(),
            SubdivisionError::NonManifoldEdge { a: 0, b: 1 }
        );
        assert_eq!(linear(&soup).unwrap().n_faces(), 12);
        soup.push_face(&[0, 1, 2, 3]);
        let error = linear(&soup).unwrap_err();
        assert_eq!(error, SubdivisionError::NotATriangle { face: 3, degree: 4 });
    }
}
