//! Surface elements at their quadrature points: linear (P1) triangles and bilinear (Q1)
//! quadrilaterals.
//!
//! Everything the flows of Gruber & Aulisa [GA20](crate::bibliography#ga20) integrate is a
//! function of the tangent plane at a point. On a triangle that plane is constant and the
//! centroid alone is exact; a quadrilateral takes 2 × 2 Gauss points.

use super::dual::{Dual, DualVec};
use crate::mesh::HalfedgeMesh;
use glam::DVec3;

/// A quadrature point of the reference element.
#[derive(Clone, Copy, Debug)]
pub struct Point {
    /// Weight; the weights sum to the area of the reference element.
    pub weight: f64,
    /// Values of the hat functions.
    pub shape: [f64; 4],
    /// Their first derivatives in the reference coordinates, (∂₁, ∂₂) a corner.
    pub slope: [[f64; 2]; 4],
}

const THIRD: f64 = 1.0 / 3.0;

/// The triangle (0,0), (1,0), (0,1).
const TRIANGLE: [Point; 1] = [Point {
    weight: 0.5,
    shape: [THIRD, THIRD, THIRD, 0.0],
    slope: [[-1.0, -1.0], [1.0, 0.0], [0.0, 1.0], [0.0, 0.0]],
}];

/// A quadrature point of the square (0,0), (1,0), (1,1), (0,1).
const fn gauss(s: f64, t: f64) -> Point {
    let (r, u) = (1.0 - s, 1.0 - t);
    Point {
        weight: 0.25,
        shape: [r * u, s * u, s * t, r * t],
        slope: [[-u, -r], [u, -s], [t, s], [-t, r]],
    }
}

/// ½ − ½/√3 and its mirror image.
const NEAR: f64 = 0.211_324_865_405_187_1;
const FAR: f64 = 1.0 - NEAR;

const SQUARE: [Point; 4] = [
    gauss(NEAR, NEAR),
    gauss(FAR, NEAR),
    gauss(NEAR, FAR),
    gauss(FAR, FAR),
];

/// An element at one of its quadrature points.
#[derive(Clone, Copy, Debug)]
pub struct Node {
    /// Area that the point stands for, weight · |t₁ × t₂|; unit length².
    pub area: f64,
    /// Unit normal; zero where the element has collapsed.
    pub normal: DVec3,
    /// Surface gradients of the hat functions, unit 1/length; zero where collapsed.
    pub gradients: [DVec3; 4],
    /// Values of the hat functions.
    pub shape: [f64; 4],
}

/// The faces of a mesh as elements of one kind.
#[derive(Clone, Debug)]
pub struct Elements {
    corners: Vec<[u32; 4]>,
    degree: usize,
    points: &'static [Point],
    n_vertices: usize,
}

impl Elements {
    /// Elements of a mesh of triangles only or quadrilaterals only; `None` of any other.
    pub fn of(mesh: &HalfedgeMesh) -> Option<Self> {
        let degree = mesh.faces().next().map(|f| mesh.face_vertices(f).count())?;
        let points: &[Point] = match degree {
            3 => &TRIANGLE,
            4 => &SQUARE,
            _ => return None,
        };
        let mut corners = Vec::with_capacity(mesh.n_faces());
        for f in mesh.faces() {
            let mut element = [0; 4];
            let mut count = 0;
            for v in mesh.face_vertices(f) {
                *element.get_mut(count)? = v.0;
                count += 1;
            }
            if count != degree {
                return None;
            }
            corners.push(element);
        }
        let n_vertices = mesh.n_vertices();
        Some(Self {
            corners,
            degree,
            points,
            n_vertices,
        })
    }

    /// The same, where none is a concave quadrilateral: the bilinear map of one folds over, and its area
    /// is too large.
    pub fn convex(mesh: &HalfedgeMesh, x: &[DVec3]) -> Option<Self> {
        let elements = Self::of(mesh)?;
        let is_convex = |corners: &[u32; 4]| {
            let [a, b, c, d] = corners.map(|v| x[v as usize]);
            let normal = (c - a).cross(d - b);
            let turns = [(d, a, b), (a, b, c), (b, c, d), (c, d, a)];
            turns
                .iter()
                .all(|(p, q, r)| (*q - *p).cross(*r - *q).dot(normal) >= 0.0)
        };
        let is_fit = elements.degree == 3 || elements.corners.iter().all(is_convex);
        is_fit.then_some(elements)
    }

    /// Number of corners of an element: 3 or 4.
    pub fn degree(&self) -> usize {
        self.degree
    }

    /// Number of elements.
    pub fn len(&self) -> usize {
        self.corners.len()
    }

    /// Whether there are none.
    pub fn is_empty(&self) -> bool {
        self.corners.is_empty()
    }

    /// Number of vertices of the mesh.
    pub fn n_vertices(&self) -> usize {
        self.n_vertices
    }

    /// The vertices of every element, in order.
    pub fn corners(&self) -> impl ExactSizeIterator<Item = &[u32]> + Clone {
        self.corners.iter().map(|c| &c[..self.degree])
    }

    /// Quadrature points of the reference element.
    pub fn points(&self) -> &'static [Point] {
        self.points
    }

    /// Element `e` at its quadrature points, for corners at `x`.
    pub fn nodes(&self, x: &[DVec3], e: usize) -> impl Iterator<Item = Node> + use<> {
        let corners = self.corners[e];
        let mut at = [DVec3::ZERO; 4];
        for (p, v) in at.iter_mut().zip(&corners[..self.degree]) {
            *p = x[*v as usize];
        }
        let degree = self.degree;
        self.points
            .iter()
            .map(move |point| node(&at[..degree], point))
    }
}

/// An element at a quadrature point, with the derivatives of everything along a motion of
/// the corners.
#[derive(Clone, Copy, Debug)]
pub struct DualNode {
    /// See [`Node::area`].
    pub area: Dual,
    /// See [`Node::normal`].
    pub normal: DualVec,
    /// See [`Node::gradients`].
    pub gradients: [DualVec; 4],
}

impl DualNode {
    /// For corners at `x`, none of them collapsed.
    pub fn new(x: &[DualVec], point: &Point) -> Self {
        let (mut t1, mut t2) = (DualVec::default(), DualVec::default());
        for (p, [d1, d2]) in x.iter().zip(point.slope) {
            t1 = t1 + *p * d1;
            t2 = t2 + *p * d2;
        }
        let cross = t1.cross(t2);
        let size = cross.dot(cross).sqrt();
        let inverse = size.recip();
        let normal = cross * inverse;
        let (a1, a2) = (t2.cross(normal) * inverse, normal.cross(t1) * inverse);
        let mut gradients = [DualVec::default(); 4];
        for (gradient, [d1, d2]) in gradients.iter_mut().zip(point.slope) {
            *gradient = a1 * d1 + a2 * d2;
        }
        Self {
            area: size * point.weight,
            normal,
            gradients,
        }
    }
}

/// Tangent plane and hat functions at one point.
fn node(x: &[DVec3], point: &Point) -> Node {
    let (mut t1, mut t2) = (DVec3::ZERO, DVec3::ZERO);
    for (p, [d1, d2]) in x.iter().zip(point.slope) {
        t1 += d1 * *p;
        t2 += d2 * *p;
    }
    let cross = t1.cross(t2);
    let size = cross.length();
    let mut gradients = [DVec3::ZERO; 4];
    let mut normal = DVec3::ZERO;
    if size > 0.0 {
        normal = cross / size;
        // The dual basis: a¹·t₁ = 1, a¹·t₂ = 0.
        let (a1, a2) = (t2.cross(normal) / size, normal.cross(t1) / size);
        for (gradient, [d1, d2]) in gradients.iter_mut().zip(point.slope) {
            *gradient = d1 * a1 + d2 * a2;
        }
    }
    Node {
        area: point.weight * size,
        normal,
        gradients,
        shape: point.shape,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::build;
    use crate::soup::PolygonSoup;

    fn elements(soup: &PolygonSoup) -> Option<Elements> {
        Elements::of(&build(soup).expect("a surface").mesh)
    }

    fn soup(positions: &[[f64; 3]], faces: &[&[u32]]) -> PolygonSoup {
        let mut soup = PolygonSoup {
            positions: positions.iter().map(|&p| DVec3::from(p)).collect(),
            ..PolygonSoup::default()
        };
        faces.iter().for_each(|f| soup.push_face(f));
        soup
    }

    const CORNERS: [[f64; 3]; 5] = [
        [0.0, 0.0, 0.0],
        [2.0, 0.1, 0.0],
        [2.2, 1.5, 0.0],
        [-0.3, 1.0, 0.0],
        [3.0, 0.5, 0.0],
    ];

    #[test]
    fn gradients_reproduce_linear_functions_and_areas_add_up() {
        let slope = DVec3::new(0.7, -1.3, 0.0);
        for faces in [&[&[0u32, 1, 2][..], &[0, 2, 3]][..], &[&[0, 1, 2, 3]]] {
            let soup = soup(&CORNERS[..4], faces);
            let elements = elements(&soup).expect("one kind");
            let mut area = 0.0;
            for (e, corners) in elements.corners().enumerate() {
                for node in elements.nodes(&soup.positions, e) {
                    area += node.area;
                    let found: DVec3 = corners
                        .iter()
                        .zip(node.gradients)
                        .map(|(&v, g)| slope.dot(soup.positions[v as usize]) * g)
                        .sum();
                    assert!((found - slope).length() < 1e-13);
                    assert!((node.normal - DVec3::Z).length() < 1e-14);
                    assert!((node.shape.iter().sum::<f64>() - 1.0).abs() < 1e-14);
                }
            }
            // The shoelace formula.
            assert!((area - 2.715).abs() < 1e-12, "{area}");
        }
    }

    #[test]
    fn mixed_and_larger_faces_are_no_elements() {
        assert!(elements(&soup(&CORNERS, &[&[0, 1, 2, 3], &[1, 4, 2]])).is_none());
        assert!(elements(&soup(&CORNERS, &[&[0, 1, 4, 2, 3]])).is_none());
    }
}
