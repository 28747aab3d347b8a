//! Area and volume as they were before: a scaling, and Newton's iteration along two smooth
//! fields of normals.
//!
//! The scaling makes the area exact and leaves ∫H² as it is: of each part that hangs together with no
//! other about its own centroid, so that parts keep their sizes and stay where they are. For the volume
//! the vertices move by (p + q H̃) n, H̃ the mean curvature averaged over neighbours so that no
//! noise of the mesh enters, with p and q from A and V to first order.

use super::draft::Draft;
use crate::mesh::HalfedgeMesh;
use glam::DVec3;

/// What must be as it was.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Targets {
    /// Total area.
    pub area: f64,
    /// Enclosed volume, where that is kept too.
    pub volume: Option<f64>,
}

/// Rounds at most.
const ROUNDS: usize = 8;
/// A volume is met to this share of that of the ball with the same area …
const MET: f64 = 1e-12;
/// … and a surface that misses by this share, or whose vertices had to move for it by this share of
/// the mean edge, is another surface.
const MISSED: f64 = 1e-6;
const FARTHEST: f64 = 1.0;
/// Averages over neighbours of the mean curvature.
const AVERAGES: usize = 5;

/// The parts of a surface that hang together.
struct Parts {
    /// By vertex.
    of: Vec<usize>,
    /// Areas to be brought back.
    areas: Vec<f64>,
}

impl Parts {
    /// Those of a draft that was made of the mesh of another, in proportion to an area of all.
    fn of(draft: &Draft, start: &Draft, mesh: &HalfedgeMesh, area: f64) -> Self {
        let (part_of, count) = mesh.components();
        let of = |vertices: &[u32]| -> Vec<usize> {
            vertices
                .iter()
                .map(|v| part_of[*v as usize] as usize)
                .collect()
        };
        let mut areas = areas(start, &of(&start.seed), count);
        let total: f64 = areas.iter().sum();
        areas.iter_mut().for_each(|own| *own *= area / total);
        Self {
            of: of(&draft.seed),
            areas,
        }
    }
}

fn areas(draft: &Draft, part_of: &[usize], count: usize) -> Vec<f64> {
    let mut areas = vec![0.0; count];
    for corners in draft.live_faces() {
        areas[part_of[corners[0] as usize]] += 0.5 * draft.normal_of(corners).length();
    }
    areas
}

/// Brings area and volume of what was another draft back; whether the surface is still the one it was.
pub(super) fn run(draft: &mut Draft, start: &Draft, mesh: &HalfedgeMesh, targets: Targets) -> bool {
    let parts = Parts::of(draft, start, mesh, targets.area);
    let ball = targets.area.powf(1.5) / (6.0 * std::f64::consts::PI.sqrt());
    scale_to(draft, &parts);
    let before = draft.x.clone();
    for _ in 0..ROUNDS {
        let Some(volume) = targets.volume else { break };
        let missing = volume - self::volume(draft);
        if missing.abs() <= MET * ball {
            break;
        }
        correct(draft, missing);
        scale_to(draft, &parts);
    }
    let missed = targets
        .volume
        .map_or(0.0, |v| (self::volume(draft) - v).abs() / ball);
    let moved = before.iter().zip(&draft.x).map(|(x, y)| x.distance(*y));
    let farthest = moved.fold(0.0, f64::max);
    let edges = draft.edges();
    let total: f64 = edges.iter().map(|e| draft.length(*e)).sum();
    let mean = total / edges.len().max(1) as f64;
    // Not so where a number is no number.
    missed <= MISSED && farthest <= FARTHEST * mean
}

fn scale_to(draft: &mut Draft, parts: &Parts) {
    let count = parts.areas.len();
    let mut sums = vec![(DVec3::ZERO, 0.0); count];
    for (p, part) in draft.x.iter().zip(&parts.of) {
        let (sum, n) = &mut sums[*part];
        *sum += *p;
        *n += 1.0;
    }
    let now = areas(draft, &parts.of, count);
    for (p, &part) in draft.x.iter_mut().zip(&parts.of) {
        let (sum, n) = sums[part];
        let (centre, factor) = (sum / n, (parts.areas[part] / now[part]).sqrt());
        *p = centre + factor * (*p - centre);
    }
}

pub(super) fn volume(draft: &Draft) -> f64 {
    let origin = draft.x[0];
    let part = |corners: [u32; 3]| {
        let [a, b, c] = corners.map(|v| draft.at(v) - origin);
        a.dot(b.cross(c)) / 6.0
    };
    draft.live_faces().map(part).sum()
}

/// Adds so much volume to first order, and no area.
fn correct(draft: &mut Draft, missing: f64) {
    let n = draft.x.len();
    let (normals, areas) = (draft.normals(), draft.areas());
    let mut gradient = vec![DVec3::ZERO; n];
    for corners in draft.live_faces() {
        let points = corners.map(|v| draft.at(v));
        let normal = draft.normal_of(corners).normalize_or_zero();
        for (i, v) in corners.into_iter().enumerate() {
            let opposite = points[(i + 2) % 3] - points[(i + 1) % 3];
            gradient[v as usize] += 0.5 * normal.cross(opposite);
        }
    }
    let slope: Vec<f64> = (0..n).map(|i| gradient[i].dot(normals[i])).collect();
    let rings = draft.rings();
    let mut bend: Vec<f64> = slope.iter().zip(&areas).map(|(g, a)| g / a).collect();
    for _ in 0..AVERAGES {
        let mean = |(i, ring): (usize, &Vec<u32>)| {
            let sum: f64 = ring.iter().map(|&j| bend[j as usize]).sum();
            0.5 * (bend[i] + sum / ring.len().max(1) as f64)
        };
        bend = rings.iter().enumerate().map(mean).collect();
    }
    let sums = |weights: &[f64]| -> [f64; 2] {
        let bent = weights.iter().zip(&bend).map(|(w, b)| w * b);
        [weights.iter().sum(), bent.sum()]
    };
    let ([v1, v2], [a1, a2]) = (sums(&areas), sums(&slope));
    let det = v1 * a2 - v2 * a1;
    let (p, q) = (missing * a2 / det, -missing * a1 / det);
    for ((x, normal), bend) in draft.x.iter_mut().zip(normals).zip(bend) {
        *x += (p + q * bend) * normal;
    }
}
