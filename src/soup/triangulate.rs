//! Polygons cut into triangles, the same way for pictures, flows, energies and files.
//!
//! A polygon that a fan covers is cut as people expect it: a quadrilateral along its shorter
//! diagonal, a larger one from its first corner. One that is not convex is cut by ears in the
//! plane of its vector area, so that no triangle leaves it.

use super::PolygonSoup;
use earcut::Earcut;
use glam::DVec3;

/// Cuts polygons of one soup.
pub(super) struct Cutter {
    ears: Earcut<f64>,
    found: Vec<u32>,
    triangles: Vec<[u32; 3]>,
}

impl Cutter {
    pub(super) fn new() -> Self {
        Self {
            ears: Earcut::new(),
            found: Vec::new(),
            triangles: Vec::new(),
        }
    }

    /// The triangles of a face, with its orientation; of fewer than three corners none.
    pub(super) fn cut(&mut self, face: &[u32], x: &[DVec3]) -> &[[u32; 3]] {
        self.triangles.clear();
        match *face {
            [] | [_] | [_, _] => {}
            [a, b, c] => self.triangles.push([a, b, c]),
            [a, b, c, d] => {
                let up = vector_area(face, x);
                let by_ac = [[a, b, c], [a, c, d]];
                let by_bd = [[a, b, d], [b, c, d]];
                let fits = |cut: &[[u32; 3]; 2]| cut.iter().all(|t| is_inside(t, up, x));
                let distance = |a: u32, b: u32| x[a as usize].distance_squared(x[b as usize]);
                let is_bd_shorter = distance(b, d) < distance(a, c);
                // Where neither fits the corners are out of a plane, or in a line.
                let takes_bd = match (fits(&by_ac), fits(&by_bd)) {
                    (true, false) => false,
                    (false, true) => true,
                    _ => is_bd_shorter,
                };
                self.triangles.extend(if takes_bd { by_bd } else { by_ac });
            }
            _ => self.cut_large(face, x),
        }
        &self.triangles
    }

    fn cut_large(&mut self, face: &[u32], x: &[DVec3]) {
        let up = vector_area(face, x);
        let fan = face[1..].windows(2).map(|pair| [face[0], pair[0], pair[1]]);
        self.triangles.extend(fan);
        if self.triangles.iter().all(|t| is_inside(t, up, x)) {
            return;
        }
        let Some(normal) = up.try_normalize() else {
            return;
        };
        let (u, v) = normal.any_orthonormal_pair();
        let flat = face.iter().map(|&c| {
            let p = x[c as usize] - x[face[0] as usize];
            [p.dot(u), p.dot(v)]
        });
        self.ears.earcut(flat, &[], &mut self.found);
        // Of an outline that crosses itself there are fewer: then the fan stays.
        if self.found.len() != 3 * (face.len() - 2) {
            return;
        }
        self.triangles.clear();
        for ear in self.found.chunks_exact(3) {
            let [a, b, c] = [ear[0], ear[1], ear[2]].map(|corner| face[corner as usize]);
            let is_turned = area([a, b, c], x).dot(up) < 0.0;
            self.triangles
                .push(if is_turned { [a, c, b] } else { [a, b, c] });
        }
    }
}

/// ½ Σ pᵢ × pᵢ₊₁, which is the same about any origin.
fn vector_area(face: &[u32], x: &[DVec3]) -> DVec3 {
    let first = x[face[0] as usize];
    let edges = face[1..].windows(2);
    let twice: DVec3 = edges
        .map(|pair| (x[pair[0] as usize] - first).cross(x[pair[1] as usize] - first))
        .sum();
    0.5 * twice
}

fn area([a, b, c]: [u32; 3], x: &[DVec3]) -> DVec3 {
    let [a, b, c] = [a, b, c].map(|v| x[v as usize]);
    0.5 * (b - a).cross(c - a)
}

/// Whether a triangle has the orientation of its polygon: of a fan or two, that none leaves it.
fn is_inside(triangle: &[u32; 3], up: DVec3, x: &[DVec3]) -> bool {
    area(*triangle, x).dot(up) >= 0.0
}

impl PolygonSoup {
    /// The faces cut into triangles on their own corners, orientation and order kept; vertices
    /// keep their numbers.
    pub fn triangles(&self) -> Vec<[u32; 3]> {
        let mut cutter = Cutter::new();
        let mut all = Vec::with_capacity(self.corners.len().saturating_sub(2 * self.n_faces()));
        for face in self.faces() {
            all.extend_from_slice(cutter.cut(face, &self.positions));
        }
        all
    }

    /// The same surface with triangles only; faces of fewer than three corners are gone.
    #[must_use]
    pub fn triangulated(&self) -> Self {
        Self {
            colours: self.colours.clone(),
            ..Self::from_faces(self.positions.clone(), &self.triangles())
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn plane(points: &[[f64; 2]]) -> Vec<DVec3> {
        // Out of all coordinate planes.
        let (u, v) = DVec3::new(1.0, 2.0, -0.5)
            .normalize()
            .any_orthonormal_pair();
        points
            .iter()
            .map(|[a, b]| DVec3::ONE + *a * u + *b * v)
            .collect()
    }

    /// Areas of triangles add up to the polygon's only where none leaves it.
    fn check(points: &[[f64; 2]]) {
        let x = plane(points);
        for turn in 0..points.len() {
            let mut face: Vec<u32> = (0..points.len() as u32).collect();
            face.rotate_left(turn);
            let soup = PolygonSoup::from_faces(x.clone(), &[face.clone()]);
            let triangles = soup.triangles();
            assert_eq!(triangles.len(), points.len() - 2);
            let up = vector_area(&face, &x);
            let sum: f64 = triangles.iter().map(|t| area(*t, &x).length()).sum();
            assert!((sum - up.length()).abs() < 1e-12 * sum, "{turn}: {sum}");
            assert!(triangles.iter().all(|t| area(*t, &x).dot(up) > 0.0));
            face.reverse();
            let soup = PolygonSoup::from_faces(x.clone(), &[face]);
            let turned = soup.triangles();
            assert!(turned.iter().all(|t| area(*t, &x).dot(up) < 0.0));
        }
    }

    #[test]
    fn no_triangle_leaves_its_polygon() {
        let (square, dart) = ([[0., 0.], [1., 0.], [1., 1.], [0., 1.]], 0.2);
        check(&square);
        check(&[[0., 0.], [1., 0.], [dart, dart], [0., 1.]]);
        // A U, a comb, a star.
        check(&[
            [0., 0.],
            [3., 0.],
            [3., 3.],
            [2., 3.],
            [2., 1.],
            [1., 1.],
            [1., 3.],
            [0., 3.],
        ]);
        // No three corners in a line, of which a triangle without area could be made.
        let comb = (0..20).map(|i| {
            let bow = 0.01 * f64::from(i * i);
            [f64::from(i), if i % 2 == 0 { 9.0 + bow } else { 1.0 + bow }]
        });
        let mut comb: Vec<_> = comb.collect();
        comb.extend([[19.0, -1.0], [0.0, -1.0]]);
        comb.reverse();
        check(&comb);
        let star = (0..10).map(|i| {
            let (sin, cos) = (f64::from(i) * 0.2 * std::f64::consts::PI).sin_cos();
            let r = if i % 2 == 0 { 1.0 } else { 0.4 };
            [r * cos, r * sin]
        });
        check(&star.collect::<Vec<_>>());
    }

    #[test]
    fn convex_polygons_are_cut_as_ever_and_nonsense_ends_nothing() {
        let x = plane(&[[0., 0.], [4., 0.], [5., 1.], [0., 1.], [-1., 0.5]]);
        let soup = PolygonSoup::from_faces(x.clone(), &[vec![0, 1, 2, 3, 4], vec![0, 1, 2, 3]]);
        let triangles = soup.triangles();
        assert_eq!(triangles[..3], [[0, 1, 2], [0, 2, 3], [0, 3, 4]]);
        assert_eq!(triangles[3..], [[0, 1, 3], [1, 2, 3]]);
        // All in one point, in a line, an eight, and faces that are none.
        let odd = [
            vec![0; 7],
            vec![0, 1, 0, 1, 0, 1],
            vec![0, 2, 1, 3, 4],
            vec![0, 1],
            vec![],
        ];
        let soup = PolygonSoup::from_faces(x, &odd);
        assert_eq!(soup.triangles().len(), 5 + 4 + 3);
    }
}
