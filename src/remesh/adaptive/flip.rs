//! Flips: the other diagonal where it makes valences or angles better.
//!
//! First for valence, Σ(faces − regular)² falling, then to a Delaunay triangulation. A flip
//! changes the surface where it bends, so none is made across an edge of the shape or more than 60°, or where a new
//! face stands at more than 45° to the two it replaces.

use super::crease;
use super::draft::{Draft, Hinge};
use crate::interrupt::paced;
use crate::order;
use glam::DVec3;
use std::f64::consts::PI;

/// Cosines of the angle between the faces at an edge, and of the turn of the new ones.
const BENT: f64 = 0.5;
const TURN: f64 = std::f64::consts::FRAC_1_SQRT_2;
/// A flip for valence leaves at least this share of the smallest angle, where the two opposite
/// angles come to this together.
const ANGLE_KEPT: f64 = 0.7;
const OPPOSITE: f64 = 2.2;
/// The two angles opposite to a Delaunay edge come to π at most; this much more is roundoff.
const SLACK: f64 = 0.02;
/// Sweeps for Delaunay edges, at most.
const SWEEPS: usize = 12;

/// Flips edges that make valences better; their number.
pub(super) fn for_valence(draft: &mut Draft) -> usize {
    let is_wanted = |draft: &Draft, hinge: Hinge| {
        let excess = |v: u32, change: i64| {
            let v = v as usize;
            (draft.star[v].len() as i64 + change - i64::from(draft.regular[v])).pow(2)
        };
        let ends = hinge.ends.map(|v| excess(v, -1) - excess(v, 0));
        let apexes = hinge.apexes.map(|v| excess(v, 1) - excess(v, 0));
        ends.iter().chain(&apexes).sum::<i64>() < 0 && opposite_angles(draft, hinge) > OPPOSITE
    };
    let flipped = sweep(draft, draft.edges(), is_wanted, |draft, hinge, new| {
        let old = hinge.faces.map(|f| draft.faces[f as usize]);
        let least =
            |faces: [[u32; 3]; 2]| least_angle(draft, faces[0]).min(least_angle(draft, faces[1]));
        least(new) >= ANGLE_KEPT * least(old)
    });
    flipped.len()
}

/// Flips edges until all are Delaunay; their number.
pub(super) fn to_delaunay(draft: &mut Draft) -> usize {
    let is_wanted = |draft: &Draft, hinge: Hinge| {
        is_reflex(draft, hinge) && opposite_angles(draft, hinge) > PI + SLACK
    };
    let mut count = 0;
    let mut edges = draft.edges();
    for _ in 0..SWEEPS {
        let flipped = sweep(draft, edges, is_wanted, |_, _, _| true);
        count += flipped.len();
        if flipped.is_empty() {
            break;
        }
        // What else may have become another.
        edges = flipped.iter().flat_map(Hinge::sides).collect();
        edges.retain(|edge| !draft.is_held(*edge));
        order::sort(&mut edges);
        edges.dedup();
    }
    count
}

/// Flips those of the edges that are wanted the other way, can be and are better so, one after the
/// other; what they were. What an edge can be takes longest to tell, and most are not wanted.
fn sweep(
    draft: &mut Draft,
    edges: Vec<[u32; 2]>,
    is_wanted: impl Fn(&Draft, Hinge) -> bool,
    is_better: impl Fn(&Draft, Hinge, [[u32; 3]; 2]) -> bool,
) -> Vec<Hinge> {
    let mut done = Vec::new();
    for edge in paced(edges) {
        if let Some(hinge) = draft.hinge(edge)
            && is_wanted(draft, hinge)
            && let Some(new) = flipped(draft, hinge)
            && is_better(draft, hinge, new)
        {
            flip(draft, hinge, new);
            done.push(hinge);
        }
    }
    done
}

/// Whether the two angles opposite to an edge come to more than π, by the sign of the sine of their
/// sum.
fn is_reflex(draft: &Draft, hinge: Hinge) -> bool {
    let [a, b] = hinge.ends.map(|v| draft.at(v));
    let [[sin, cos], [other_sin, other_cos]] = hinge.apexes.map(|v| {
        let (p, q) = (a - draft.at(v), b - draft.at(v));
        [p.cross(q).length(), p.dot(q)]
    });
    sin * other_cos + cos * other_sin < 0.0
}

fn angle(draft: &Draft, at: u32, [a, b]: [u32; 2]) -> f64 {
    let (a, b) = (draft.at(a) - draft.at(at), draft.at(b) - draft.at(at));
    a.cross(b).length().atan2(a.dot(b))
}

fn opposite_angles(draft: &Draft, hinge: Hinge) -> f64 {
    let [c, d] = hinge.apexes;
    angle(draft, c, hinge.ends) + angle(draft, d, hinge.ends)
}

fn least_angle(draft: &Draft, [a, b, c]: [u32; 3]) -> f64 {
    let angles = [
        angle(draft, a, [b, c]),
        angle(draft, b, [c, a]),
        angle(draft, c, [a, b]),
    ];
    angles.into_iter().fold(f64::INFINITY, f64::min)
}

/// The faces after a flip, or `None` where there is none to make.
fn flipped(draft: &Draft, hinge: Hinge) -> Option<[[u32; 3]; 2]> {
    let ([a, b], [c, d]) = (hinge.ends, hinge.apexes);
    let starves =
        |v: u32| draft.star[v as usize].len() <= if draft.regular[v as usize] == 6 { 4 } else { 1 };
    if c == d || starves(a) || starves(b) || draft.ring(c).contains(&d) {
        return None;
    }
    let unit = |corners| draft.normal_of(corners).normalize_or_zero();
    let [n, m]: [DVec3; 2] = hinge.faces.map(|f| unit(draft.faces[f as usize]));
    let (new, mean) = ([[c, a, d], [d, b, c]], (n + m).normalize_or_zero());
    let is_flat = n.dot(m) >= BENT && new.iter().all(|t| unit(*t).dot(mean) >= TURN);
    (is_flat && !crease::is_sharp(draft, hinge)).then_some(new)
}

fn flip(draft: &mut Draft, hinge: Hinge, new: [[u32; 3]; 2]) {
    let ([a, b], [c, d], [f, g]) = (hinge.ends, hinge.apexes, hinge.faces);
    draft.faces[f as usize] = new[0];
    draft.faces[g as usize] = new[1];
    draft.leave(a, g);
    draft.leave(b, f);
    draft.star[c as usize].push(g);
    draft.star[d as usize].push(f);
}
