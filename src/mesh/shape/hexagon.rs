//! A regular hexagon of `rings` rings of triangles around a centre, every inner vertex of valence six.

use std::f64::consts::TAU;

/// A lattice point `i e₁ + j e₂`, whose neighbours are `±e₁`, `±e₂` and `±(e₁ + e₂)`.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct LatticePoint {
    pub(super) i: i32,
    pub(super) j: i32,
}

impl LatticePoint {
    /// Number of the ring, 0 at the centre: the distance along edges.
    pub(super) fn ring(self) -> i32 {
        self.i.abs().max(self.j.abs()).max((self.i - self.j).abs())
    }

    /// Place in the ring as an angle: corners at multiples of 60°, sides divided evenly.
    pub(super) fn angle(self) -> f64 {
        let (i, j, k) = (self.i, self.j, self.ring());
        let (side, along) = match () {
            _ if k == 0 => return 0.0,
            _ if i == k && j < k && j >= 0 => (0, j),
            _ if j == k && i > 0 => (1, k - i),
            _ if j - i == k && j > 0 => (2, -i),
            _ if i == -k && j > -k => (3, -j),
            _ if j == -k && i < 0 => (4, k + i),
            _ => (5, i),
        };
        TAU / 6.0 * (f64::from(side) + f64::from(along) / f64::from(k))
    }
}

/// The points, row after row, and the triangles, counter-clockwise for `e₁` to `e₂`.
///
/// There are `3n(n + 1) + 1` points and `6n²` triangles for `n` rings.
pub(super) fn hexagon(rings: usize) -> (Vec<LatticePoint>, Vec<[u32; 3]>) {
    let n = rings as i32;
    let mut points = Vec::new();
    // Each row holds the i from max(-n, j - n) to min(n, j + n).
    let mut row_starts = Vec::new();
    for j in -n..=n {
        row_starts.push(points.len() as i32 - (j - n).max(-n));
        points.extend(((j - n).max(-n)..=(j + n).min(n)).map(|i| LatticePoint { i, j }));
    }
    let index = |i: i32, j: i32| {
        let inside = LatticePoint { i, j }.ring() <= n;
        inside.then(|| (row_starts[(j + n) as usize] + i) as u32)
    };
    let mut faces = Vec::new();
    for (a, p) in points.iter().enumerate() {
        let Some(c) = index(p.i + 1, p.j + 1) else {
            continue;
        };
        let a = a as u32;
        faces.extend(index(p.i + 1, p.j).map(|b| [a, b, c]));
        faces.extend(index(p.i, p.j + 1).map(|d| [a, c, d]));
    }
    (points, faces)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn counts_and_angles() {
        let n = 12;
        let (points, faces) = hexagon(n);
        assert_eq!((points.len(), faces.len()), (469, 864));
        for k in 1..=n as i32 {
            let mut angles: Vec<f64> = points
                .iter()
                .filter(|p| p.ring() == k)
                .map(|p| p.angle())
                .collect();
            angles.sort_by(f64::total_cmp);
            assert_eq!(angles.len(), 6 * k as usize);
            for (t, angle) in angles.iter().enumerate() {
                assert!((angle - TAU * t as f64 / angles.len() as f64).abs() < 1e-12);
            }
        }
    }
}
