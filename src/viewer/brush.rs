//! Sets of the mesh's vertices, a byte each, as a brush changes them; and the box of all.

use glam::Vec3;

use super::drawing::Drawing;

/// Gives a value to the vertices within a ball.
pub fn painted(drawing: &Drawing, set: &[u8], center: Vec3, radius: f32, value: u8) -> Vec<u8> {
    let at = drawing.positions();
    let is_near = |v| at(v).distance_squared(center) <= radius * radius;
    let vertices = (0..).zip(set);
    vertices
        .map(|(v, old)| if is_near(v) { value } else { *old })
        .collect()
}

/// Spreads a value by one ring of neighbours.
pub fn grown(drawing: &Drawing, set: &[u8], value: u8) -> Vec<u8> {
    let mut next = set.to_vec();
    for corners in drawing.triangles().chunks_exact(3) {
        let corners = [0, 1, 2].map(|k| drawing.source(corners[k] as usize));
        if corners.iter().any(|v| set[*v] == value) {
            for v in corners {
                next[v] = value;
            }
        }
    }
    next
}

/// Middle and diagonal of the box about the surface.
pub fn bounding_box(drawing: &Drawing) -> (Vec3, f32) {
    let at = drawing.positions();
    let points = (0..drawing.n_vertices() as u32).map(at);
    let none = (Vec3::splat(f32::INFINITY), Vec3::splat(f32::NEG_INFINITY));
    let (low, high) = points.fold(none, |(low, high), p| (low.min(p), high.max(p)));
    (0.5 * low + 0.5 * high, low.distance(high))
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Triangles of three vertices in a row each, the vertices all but on a line.
    fn strip(triangles: &[u32]) -> Drawing {
        let mut positions = Vec::new();
        for n in 0..5 {
            positions.extend([n as f32, 0.0, 0.0]);
        }
        Drawing::new(&positions, triangles, false).expect("a valid mesh")
    }

    #[test]
    fn a_brush_paints_what_lies_in_its_ball() {
        let drawing = strip(&[0, 1, 2, 1, 2, 3, 2, 3, 4]);
        let set = painted(&drawing, &[1; 5], Vec3::new(1.6, 0.2, 0.0), 0.7, 0);
        assert_eq!(set, [1, 0, 0, 1, 1]);
        for aside in [Vec3::new(1.6, 0.9, 0.0), Vec3::new(1.6, 0.0, 0.9)] {
            let same = painted(&drawing, &set, aside, 0.7, 1);
            assert_eq!(same, set, "out of reach");
        }
    }

    #[test]
    fn a_region_grows_by_a_ring_also_where_the_drawing_is_split() {
        let drawing = strip(&[0, 1, 2, 1, 2, 3, 2, 3, 4]);
        assert_eq!(grown(&drawing, &[1, 0, 0, 1, 1], 0), [0; 5]);
        assert_eq!(grown(&drawing, &[0, 1, 1, 1, 1], 0), [0, 0, 0, 1, 1]);
        let two = strip(&[0, 1, 2, 1, 2, 3]);
        assert_eq!(grown(&two, &[1, 0, 0, 1, 1], 1), [1; 5]);
        // Both wind along the edge they share the same way: its ends have copies.
        let seam = strip(&[0, 1, 2, 3, 1, 2]);
        assert!(seam.triangles().iter().any(|v| *v > 4));
        assert_eq!(grown(&seam, &[1, 0, 0, 0, 0], 1), [1, 1, 1, 0, 0]);
        assert_eq!(grown(&seam, &[0, 1, 0, 0, 0], 1), [1, 1, 1, 1, 0]);
    }

    #[test]
    fn a_box_has_its_middle_and_its_diagonal() {
        let positions = [0., 0., 0., 2., 0., 0., 2., 4., 4.];
        let drawing = Drawing::new(&positions, &[0, 1, 2], false).expect("a valid mesh");
        let (middle, diagonal) = bounding_box(&drawing);
        assert_eq!((middle, diagonal), (Vec3::new(1., 2., 2.), 6.0));
    }
}
