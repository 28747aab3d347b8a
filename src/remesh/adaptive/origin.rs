//! Where the vertices of a new mesh come from: what was known of the old one is carried over.

use super::draft::Draft;
use glam::DVec3;

/// Steps of the walk over the old faces, at most.
const MAX_STEPS: usize = 64;

/// A point of the old surface: corners of one of its faces with weights that sum to 1. A vertex
/// that stayed has itself with the weight 1.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Origin {
    /// Vertices of the old mesh.
    pub corners: [u32; 3],
    /// Their weights.
    pub weights: [f64; 3],
}

impl Origin {
    fn vertex(v: u32) -> Self {
        Self {
            corners: [v; 3],
            weights: [1.0, 0.0, 0.0],
        }
    }

    /// The old vertex that is nearest.
    pub fn nearest(&self) -> u32 {
        let heavier = |a: &usize, b: &usize| self.weights[*a].total_cmp(&self.weights[*b]);
        self.corners[(0..3).max_by(heavier).unwrap_or_default()]
    }

    /// A value that the vertices of the old mesh have, here.
    pub fn mean(&self, value: impl Fn(u32) -> f64) -> f64 {
        let terms = self.corners.iter().zip(self.weights);
        terms.map(|(&v, w)| w * value(v)).sum()
    }
}

/// The origins of the vertices of `new`, each found by a walk over the faces of `old` from the
/// vertex it came of: always downhill, so that it never jumps to another sheet that happens to
/// be near.
pub(super) fn origins(old: &Draft, new: &Draft) -> Vec<Origin> {
    let n = new.x.len();
    (0..n)
        .map(|i| origin(old, new.x[i], new.seed[i], new.is_fixed(i)))
        .collect()
}

fn origin(old: &Draft, p: DVec3, seed: u32, held: bool) -> Origin {
    let mut best = Origin::vertex(seed);
    let mut least = old.at(seed).distance_squared(p);
    if held || least == 0.0 {
        return best;
    }
    let mut around = vec![seed];
    for _ in 0..MAX_STEPS {
        let faces = around.iter().flat_map(|&v| &old.star[v as usize]);
        let mut found = None;
        for &f in faces {
            let corners = old.faces[f as usize];
            let (weights, distance) = closest(corners.map(|v| old.at(v)), p);
            if distance < least {
                least = distance;
                found = Some(Origin { corners, weights });
            }
        }
        let Some(nearer) = found else { break };
        best = nearer;
        around = nearer.corners.to_vec();
    }
    best
}

/// Weights of the point of a triangle closest to `p`, and the square of its distance.
fn closest([a, b, c]: [DVec3; 3], p: DVec3) -> ([f64; 3], f64) {
    let (ab, ac, ap) = (b - a, c - a, p - a);
    let normal = ab.cross(ac);
    let square = normal.length_squared().max(f64::MIN_POSITIVE);
    let v = ap.cross(ac).dot(normal) / square;
    let w = ab.cross(ap).dot(normal) / square;
    if v >= 0.0 && w >= 0.0 && v + w <= 1.0 {
        let to_plane = ap - v * ab - w * ac;
        return ([1.0 - v - w, v, w], to_plane.length_squared());
    }
    let points = [a, b, c];
    let on_side = |i: usize| {
        let j = (i + 1) % 3;
        let (side, from) = (points[j] - points[i], p - points[i]);
        let along = from.dot(side) / side.length_squared().max(f64::MIN_POSITIVE);
        let share = along.clamp(0.0, 1.0);
        let mut weights = [0.0; 3];
        (weights[i], weights[j]) = (1.0 - share, share);
        (weights, (from - share * side).length_squared())
    };
    let nearer = |s: ([f64; 3], f64), t: ([f64; 3], f64)| if t.1 < s.1 { t } else { s };
    nearer(nearer(on_side(0), on_side(1)), on_side(2))
}
