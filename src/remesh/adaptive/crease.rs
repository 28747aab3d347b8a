//! Edges of the shape, as those of a cube or a chamfer: faces meet there at more than 60°, or flat sides
//! at more than 40°. Nothing is flipped across them. Vertices on them stay on them: they come of splits along such an edge, and go by collapses
//! along one that is straight.

use super::draft::{Draft, Hinge};
use glam::DVec3;

/// Cosine of the angle from which an edge is one of the shape, …
const SHARP: f64 = 0.5;
/// … and from which one between flat sides is: 40°. Coarse meshes of smooth surfaces bend less there, or
/// have no flat sides.
const CHAMFER: f64 = 0.766;
/// Cosine of the angle between two faces of one flat side: 1°.
const FLAT: f64 = 0.999_85;
/// Cosine of the angle by which one may turn that is straight: 1°.
const STRAIGHT: f64 = 0.999_85;
/// Edges of the shape at a vertex on one; a single one is noise.
const LEAST: usize = 2;

/// Whether an edge is one of the shape.
pub(super) fn is_sharp(draft: &Draft, hinge: Hinge) -> bool {
    if !hinge.ends.iter().all(|&v| draft.creased[v as usize]) {
        return false;
    }
    bend(draft, hinge) < CHAMFER
}

/// Cosine of the angle between two faces.
fn bend(draft: &Draft, hinge: Hinge) -> f64 {
    let normal = |f: u32| draft.normal_of(draft.faces[f as usize]).normalize_or_zero();
    let [n, m]: [DVec3; 2] = hinge.faces.map(normal);
    n.dot(m)
}

fn is_bent(draft: &Draft, hinge: Hinge) -> bool {
    let cosine = bend(draft, hinge);
    cosine < SHARP || cosine < CHAMFER && hinge.faces.iter().all(|&f| is_flat(draft, f))
}

/// Whether a face goes on into another of the same flat side.
fn is_flat(draft: &Draft, face: u32) -> bool {
    let [a, b, c] = draft.faces[face as usize];
    let hinges = [[a, b], [b, c], [c, a]].map(|edge| draft.hinge(edge));
    hinges
        .into_iter()
        .flatten()
        .any(|hinge| bend(draft, hinge) > FLAT)
}

/// Holds the vertices on edges of the shape.
pub(super) fn mark(draft: &mut Draft) {
    let mut count = vec![0; draft.x.len()];
    for edge in draft.edges() {
        if draft.hinge(edge).is_some_and(|hinge| is_bent(draft, hinge)) {
            edge.iter().for_each(|&v| count[v as usize] += 1);
        }
    }
    for (v, count) in count.into_iter().enumerate() {
        if count >= LEAST && !draft.held[v] {
            (draft.held[v], draft.creased[v]) = (true, true);
        }
    }
}

/// Whether the other end of an edge of the shape may move to `kept`: where that edge goes straight on
/// beyond it.
pub(super) fn ends_in(draft: &Draft, hinge: Hinge, kept: u32) -> bool {
    let [a, b] = hinge.ends;
    let lost = if kept == a { b } else { a };
    if !is_sharp(draft, hinge) {
        return false;
    }
    let ring = draft.ring(lost);
    let edges = ring.iter().filter_map(|&v| draft.hinge([lost, v]));
    let sharp: Vec<u32> = edges
        .filter(|hinge| is_sharp(draft, *hinge))
        .map(|hinge| hinge.ends[1])
        .collect();
    let [p, q] = sharp[..] else {
        return false;
    };
    let way = |v: u32| (draft.at(v) - draft.at(lost)).normalize_or_zero();
    way(p).dot(way(q)) < -STRAIGHT
}
