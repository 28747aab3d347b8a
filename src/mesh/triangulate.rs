//! A triangulated copy of a polygon soup.

use crate::soup::PolygonSoup;

/// Splits every polygon into triangles on its own corners; triangles stay as they are,
/// vertices keep their indices.
///
/// Quads are cut along the shorter diagonal, larger polygons into a fan from their first
/// corner.
pub fn triangulate(soup: &PolygonSoup) -> PolygonSoup {
    let mut out = PolygonSoup {
        positions: soup.positions.clone(),
        ..PolygonSoup::default()
    };
    let distance =
        |a: u32, b: u32| soup.positions[a as usize].distance_squared(soup.positions[b as usize]);
    for face in soup.faces() {
        match *face {
            [a, b, c, d] if distance(b, d) < distance(a, c) => {
                out.push_face(&[a, b, d]);
                out.push_face(&[b, c, d]);
            }
            _ => {
                for pair in face.get(1..).unwrap_or_default().windows(2) {
                    out.push_face(&[face[0], pair[0], pair[1]]);
                }
            }
        }
    }
    out
}
