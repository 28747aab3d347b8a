//! The surface around an element, which tells whether it is turned over.

use crate::mesh::Face;
use crate::remesh::conformal::{Normals, Regulariser};
use glam::DVec3;

/// Normals averaged over two rings: of the corners of each element the mean, twice.
///
/// Corners on creases are left out, and an element that has no others keeps its own normal:
/// across a crease there is nothing to be averaged, and an element beside one would be held
/// in a plane that is not its own.
pub(super) fn smoothed(regulariser: &Regulariser, x: &[DVec3], on_creases: &[bool]) -> Normals {
    let elements = regulariser.elements();
    let Normals {
        vertices,
        points: own,
    } = regulariser.normals(x);
    let spread = |vertices: &[DVec3]| -> Vec<DVec3> {
        let mut points = Vec::with_capacity(own.len());
        for corners in elements.corners() {
            for point in elements.points() {
                let sum: DVec3 = (corners.iter().zip(point.shape))
                    .filter(|&(&v, _)| !on_creases[v as usize])
                    .map(|(&v, shape)| shape * vertices[v as usize])
                    .sum();
                let own = own[points.len()];
                points.push(sum.try_normalize().unwrap_or(own));
            }
        }
        points
    };
    let once = spread(&vertices);
    let mut gathered = vec![DVec3::ZERO; x.len()];
    let mut normal = once.iter();
    for (e, corners) in elements.corners().enumerate() {
        for (node, n) in elements.nodes(x, e).zip(&mut normal) {
            for (&v, shape) in corners.iter().zip(node.shape) {
                gathered[v as usize] += shape * node.area * *n;
            }
        }
    }
    gathered.iter_mut().for_each(|n| *n = n.normalize_or_zero());
    Normals {
        points: spread(&gathered),
        vertices: gathered,
    }
}

/// Elements that oppose the normals given, at any of their points.
pub(super) fn inverted<'a>(
    regulariser: &'a Regulariser,
    x: &'a [DVec3],
    normals: &'a Normals,
) -> impl Iterator<Item = Face> + 'a {
    let elements = regulariser.elements();
    let per_element = elements.points().len();
    (0..elements.len())
        .filter(move |&e| {
            let around = &normals.points[e * per_element..(e + 1) * per_element];
            elements
                .nodes(x, e)
                .zip(around)
                .any(|(node, n)| node.normal.dot(*n) < 0.0)
        })
        .map(Face::new)
}
