//! Lengths, angles and volumes of triangle soups.

use umbilic::soup::PolygonSoup;

/// Positive if the faces look outwards.
pub(crate) fn volume(soup: &PolygonSoup) -> f64 {
    let x = |v: u32| soup.positions[v as usize];
    soup.faces()
        .map(|f| x(f[0]).dot(x(f[1]).cross(x(f[2]))))
        .sum::<f64>()
        / 6.0
}

/// In degrees.
pub(crate) fn smallest_angle(soup: &PolygonSoup) -> f64 {
    let x = |v: u32| soup.positions[v as usize];
    let corners = soup
        .faces()
        .flat_map(|f| (0..3).map(|c| [f[c], f[(c + 1) % 3], f[(c + 2) % 3]]));
    corners
        .map(|[a, b, c]| (x(b) - x(a)).angle_between(x(c) - x(a)).to_degrees())
        .fold(180.0, f64::min)
}

/// Mean over all faces of their sides: inner edges count twice.
pub(crate) fn mean_edge_length(soup: &PolygonSoup) -> f64 {
    edge_lengths(soup).sum::<f64>() / soup.corners.len() as f64
}

pub(crate) fn edge_lengths(soup: &PolygonSoup) -> impl Iterator<Item = f64> {
    let x = |v: u32| soup.positions[v as usize];
    let sides = soup
        .faces()
        .flat_map(|f| [(f[0], f[1]), (f[1], f[2]), (f[2], f[0])]);
    sides.map(move |(a, b)| x(a).distance(x(b)))
}
