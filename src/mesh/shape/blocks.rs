//! Surfaces of unit cubes standing side by side, and what subdivision makes of them.

use glam::DVec3;

use crate::mesh::subdivide::{SubdivisionError, linear_levels, loop_scheme};
use crate::soup::PolygonSoup;

/// A smooth surface with `genus` holes in a row: a frame of cubes after `levels` of Loop's scheme.
///
/// Genus two gives the double torus.
pub fn handles(genus: usize, levels: usize) -> Result<PolygonSoup, SubdivisionError> {
    let solid = |x: i32, y: i32| {
        let inside = (0..=2 * genus as i32).contains(&x) && (0..3).contains(&y);
        inside && !(y == 1 && x % 2 == 1)
    };
    (0..levels).try_fold(surface(2 * genus + 1, 3, solid), |soup, _| {
        loop_scheme(&soup)
    })
}

/// The letter C, 4 cubes wide and 5 high, flat and sharp-edged, subdivided linearly.
pub fn letter_c(levels: usize) -> Result<PolygonSoup, SubdivisionError> {
    let solid = |x: i32, y: i32| {
        let inside = (0..4).contains(&x) && (0..5).contains(&y);
        inside && (x == 0 || y == 0 || y == 4)
    };
    linear_levels(surface(4, 5, solid), levels)
}

/// The boundary of one layer of cubes, `columns` x `rows`, centred, squares cut in two.
fn surface(columns: usize, rows: usize, solid: impl Fn(i32, i32) -> bool) -> PolygonSoup {
    let centre = DVec3::new(columns as f64, rows as f64, 1.0) / 2.0;
    let mut soup = PolygonSoup::default();
    let mut met = Vec::new();
    let mut square = |corners: [(i32, i32, i32); 4]| {
        let [a, b, c, d] = corners.map(|corner| {
            let known = met.iter().position(|&m| m == corner);
            let vertex = known.unwrap_or_else(|| {
                let (x, y, z) = corner;
                met.push(corner);
                soup.positions
                    .push(DVec3::new(x.into(), y.into(), z.into()) - centre);
                met.len() - 1
            });
            vertex as u32
        });
        soup.push_face(&[a, b, c]);
        soup.push_face(&[a, c, d]);
    };
    for y in 0..rows as i32 {
        for x in (0..columns as i32).filter(|&x| solid(x, y)) {
            let (u, v) = (x + 1, y + 1);
            square([(x, y, 1), (u, y, 1), (u, v, 1), (x, v, 1)]);
            square([(x, y, 0), (x, v, 0), (u, v, 0), (u, y, 0)]);
            // A side for each neighbour that is empty.
            let sides = [
                (solid(x - 1, y), (x, v), (x, y)),
                (solid(x + 1, y), (u, y), (u, v)),
                (solid(x, y - 1), (x, y), (u, y)),
                (solid(x, y + 1), (u, v), (x, v)),
            ];
            for (_, (ax, ay), (bx, by)) in sides.into_iter().filter(|side| !side.0) {
                square([(ax, ay, 0), (bx, by, 0), (bx, by, 1), (ax, ay, 1)]);
            }
        }
    }
    soup
}
