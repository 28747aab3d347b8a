//! Polygons cut into triangles, the same way for pictures, flows, energies and files.
//!
//! A polygon that a fan covers is cut as people expect it: a quadrilateral along its shorter
//! diagonal, from its first corner where both are as long, and so is a larger one. Any other is cut
//! by ears in the plane of its vector area, so that no triangle leaves it; and none is flat where
//! that can be: a corner in the middle of a straight side would else put a chord along that side
//! into both faces at it.

mod ears;

use ears::Ears;
use glam::DVec3;

/// Twice the area over the square of the longest side, below which a triangle is flat: what is left
/// of a straight side in six digits, and less than what a circle of a thousand corners has.
const FLAT: f64 = 1e-5;

/// The same where nothing else is to be had.
const LEAST: f64 = 1e-12;

/// Squares of diagonals that differ by no more than this share are as long as each other, in numbers
/// of single precision: the first corner decides, and not what turning the surface rounds off.
const SAME: f64 = 1e-6;

/// Cuts polygons of one soup.
#[derive(Default)]
pub(super) struct Cutter {
    ears: Ears,
    triangles: Vec<[u32; 3]>,
}

impl Cutter {
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
                let is_bd_shorter = distance(b, d) < (1.0 - SAME) * distance(a, c);
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
        let fan = || face[1..].windows(2).map(|pair| [face[0], pair[0], pair[1]]);
        if !fan().all(|t| is_inside(&t, up, x)) && self.cut_ears(face, x) {
            return;
        }
        // Of an outline that crosses itself too.
        self.triangles.extend(fan());
    }

    /// Cuts by ears alone; a corner may be there twice, as where a bridge leads to a hole. False
    /// where that is not possible.
    fn cut_ears(&mut self, face: &[u32], x: &[DVec3]) -> bool {
        let Some(normal) = vector_area(face, x).try_normalize() else {
            return false;
        };
        let (u, v) = normal.any_orthonormal_pair();
        // A pair of unknown orientation.
        let v = if u.cross(v).dot(normal) < 0.0 { -v } else { v };
        let first = x[face[0] as usize];
        let plane = |&c: &u32| {
            let p = x[c as usize] - first;
            [p.dot(u), p.dot(v)]
        };
        self.ears.outline(face.iter().map(plane));
        let found = [FLAT, LEAST].iter().any(|flat| self.ears.cut(*flat));
        if found {
            let corners = self.ears.found.iter();
            self.triangles
                .extend(corners.map(|ear| ear.map(|corner| face[corner as usize])));
        }
        found
    }
}

/// The triangles of a face that has a corner twice, as where a bridge leads to a hole in it; none
/// where it is no such face.
pub(crate) fn cut_bridged(face: &[u32], x: &[DVec3]) -> Vec<[u32; 3]> {
    let mut cutter = Cutter::default();
    if !cutter.cut_ears(face, x) {
        return Vec::new();
    }
    let is_whole = |[a, b, c]: &[u32; 3]| a != b && b != c && c != a;
    match cutter.triangles.iter().all(is_whole) {
        true => cutter.triangles,
        false => Vec::new(),
    }
}

/// ½ Σ pᵢ × pᵢ₊₁, which is the same about any origin.
fn vector_area(face: &[u32], x: &[DVec3]) -> DVec3 {
    let Some((&first, others)) = face.split_first() else {
        return DVec3::ZERO;
    };
    let first = x[first as usize];
    let edges = others.windows(2);
    let twice: DVec3 = edges
        .map(|pair| (x[pair[0] as usize] - first).cross(x[pair[1] as usize] - first))
        .sum();
    0.5 * twice
}

fn area([a, b, c]: [u32; 3], x: &[DVec3]) -> DVec3 {
    let [a, b, c] = [a, b, c].map(|v| x[v as usize]);
    0.5 * (b - a).cross(c - a)
}

/// Whether a triangle has the orientation of its polygon, and is not flat: of a fan or two, that
/// none leaves it.
fn is_inside(triangle: &[u32; 3], up: DVec3, x: &[DVec3]) -> bool {
    let [a, b, c] = triangle.map(|v| x[v as usize]);
    let sides = [
        a.distance_squared(b),
        b.distance_squared(c),
        c.distance_squared(a),
    ];
    let longest = sides.into_iter().fold(0.0, f64::max);
    2.0 * area(*triangle, x).dot(up) > FLAT * longest * up.length()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::soup::PolygonSoup;

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
    fn of_diagonals_of_one_length_the_first_corner_decides() {
        for noise in [0.0, 1e-8, -1e-8, 3e-8] {
            let x = plane(&[[0., 0.], [1., 0.], [1. + noise, 1.], [0., 1. - noise]]);
            for turn in 0..4 {
                let mut face: Vec<u32> = (0..4).collect();
                face.rotate_left(turn);
                let [a, b, c, d] = [0, 1, 2, 3].map(|i| face[i]);
                let cut = PolygonSoup::from_faces(x.clone(), &[face]).triangles();
                assert_eq!(cut, [[a, b, c], [a, c, d]], "{noise}, {turn}");
            }
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
    fn corners_of_a_straight_side_give_no_flat_triangle() {
        // Of a square, of a U, and of a square whose every side has three, in six digits.
        let square = [[0., 0.], [0.4, 0.], [1., 0.], [1., 1.], [0., 1.]];
        check(&square);
        check(&[[0., 0.], [0.4, 0.], [1., 0.], [0.4, 1.]]);
        check(&[
            [0., 0.],
            [1.7, 0.],
            [3., 0.],
            [3., 3.],
            [2., 3.],
            [2., 2.],
            [2., 1.],
            [1.5, 1.],
            [1., 1.],
            [1., 3.],
            [0., 3.],
            [0., 1.3],
        ]);
        let along = |k: i32| {
            let (side, step) = (k / 4, f64::from(k % 4) / 4.0);
            let p = [[step, 0.], [1., step], [1. - step, 1.], [0., 1. - step]][side as usize];
            let off = if k % 4 == 0 { 0.0 } else { 4e-7 };
            // Outwards on two sides, inwards on the others.
            [
                p[0] - if side == 3 { off } else { 0.0 },
                p[1] - if side == 0 { off } else { -off },
            ]
        };
        let many: Vec<_> = (0..16).map(along).collect();
        let x = plane(&many);
        for turn in 0..16 {
            let mut face: Vec<u32> = (0..16).collect();
            face.rotate_left(turn);
            let soup = PolygonSoup::from_faces(x.clone(), &[face]);
            let least = |t: &[u32; 3]| 2.0 * area(*t, &x).length();
            assert!(soup.triangles().iter().all(|t| least(t) > 1e-3));
        }
    }

    #[test]
    fn a_bridge_leads_to_a_hole() {
        let points = [[0., 0.], [4., 0.], [4., 4.], [0., 4.]];
        let hole = [[1., 1.], [1., 3.], [3., 3.], [3., 1.]];
        let x = plane(&[points, hole].concat());
        // Straight on to a corner of the hole, and along one of its sides.
        for face in [
            [0, 1, 2, 3, 0, 4, 5, 6, 7, 4],
            [1, 2, 3, 0, 1, 4, 5, 6, 7, 4],
        ] {
            let triangles = cut_bridged(&face, &x);
            assert_eq!(triangles.len(), 8);
            let up = vector_area(&face, &x);
            assert!(triangles.iter().all(|t| area(*t, &x).dot(up) > 0.0));
            let sum: f64 = triangles.iter().map(|t| area(*t, &x).length()).sum();
            assert!((sum - 12.0).abs() < 1e-12);
        }
        for none in [&[0, 1, 0, 2][..], &[0, 1, 2, 1], &[0, 1], &[0], &[]] {
            assert!(cut_bridged(none, &x).is_empty());
        }
    }

    #[test]
    fn convex_polygons_are_cut_as_ever_and_nonsense_ends_nothing() {
        let x = plane(&[[0., 0.], [4., 0.], [5., 1.], [0., 1.], [-1., 0.5]]);
        let cut = |face: &[u32]| PolygonSoup::from_faces(x.clone(), &[face]).triangles();
        assert_eq!(cut(&[0, 1, 2, 3, 4]), [[0, 1, 2], [0, 2, 3], [0, 3, 4]]);
        assert_eq!(cut(&[0, 1, 2, 3]), [[0, 1, 3], [1, 2, 3]]);
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
