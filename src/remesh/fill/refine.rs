//! Incremental remeshing of a patch to a target edge length (Botsch & Kobbelt
//! [BK04](crate::bibliography#bk04)): split, collapse, flip, smooth.

use super::patch::Patch;
use crate::order;
use std::collections::VecDeque;
use std::ops::ControlFlow;

/// Edges longer than this many target lengths are split …
const LONG: f64 = 4.0 / 3.0;
/// … and shorter ones collapsed.
const SHORT: f64 = 4.0 / 5.0;
/// Sweeps of smoothing a round.
const SMOOTHINGS: usize = 3;
/// How often an edge is looked at, on average and at most: in space Delaunay flips need not
/// end by themselves.
const VISITS: usize = 12;
/// From ring to ring edges grow by this factor at most.
const GROWTH: f64 = 1.2;
/// Sweeps in which the sizes of the rim spread into the patch, before the first round.
const SPREADS: usize = 10;
/// Edges at a vertex of a regular mesh.
const REGULAR: usize = 6;

/// How vertices are smoothed.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Smoothing {
    /// To the mean of the neighbours: the patch becomes a membrane.
    Umbrella,
    /// The same along the surface only: the patch keeps its shape. Across a neck a membrane
    /// would pinch off.
    Tangential,
}

/// What a patch is remeshed to.
#[derive(Clone, Copy, Debug)]
pub(super) struct Target {
    /// Edge length wanted.
    pub(super) length: f64,
    /// Rounds; in the second half flips even out the valences.
    pub(super) rounds: usize,
    /// How vertices move.
    pub(super) smoothing: Smoothing,
    /// Free vertices at most.
    pub(super) most: usize,
}

/// Remeshes the patch; `progress` is told the share done and may end it.
pub(super) fn refine(
    patch: &mut Patch,
    target: &Target,
    progress: &mut dyn FnMut(f64) -> ControlFlow<()>,
) -> ControlFlow<()> {
    set_sizes(patch, target.length);
    // From coarse to fine: cut to length at once, the chords of a long loop would be
    // slivers with far too many vertices.
    let longest = patch
        .inner_edges()
        .iter()
        .map(|&(a, b)| patch.length(a, b))
        .fold(0.0, f64::max);
    let mut length = longest;
    while length > 2.0 * target.length {
        length *= 0.5;
        split_long(patch, length, target);
        flip_delaunay(patch);
        smooth(patch, target.smoothing);
        progress(0.0)?;
    }
    for _ in 0..SPREADS {
        spread_sizes(patch, target.length);
    }
    for round in 0..target.rounds {
        progress(round as f64 / target.rounds as f64)?;
        split_long(patch, target.length, target);
        collapse_short(patch);
        patch.compact();
        if 2 * round < target.rounds {
            flip_delaunay(patch);
        } else {
            flip_for_valence(patch);
        }
        for _ in 0..SMOOTHINGS {
            smooth(patch, target.smoothing);
        }
        spread_sizes(patch, target.length);
    }
    progress(1.0)
}

/// Sizes of the rim from its own edges, which cannot be changed: `length` unless they are
/// much longer, where splitting would never end, or much shorter, where slivers would be left.
fn set_sizes(patch: &mut Patch, length: f64) {
    let n_rim = patch.n_rim();
    let (mut longest, mut sum) = (vec![0.0f64; n_rim], vec![0.0; n_rim]);
    for (a, b, edge) in patch.rim_edges() {
        for v in [a, b] {
            longest[v as usize] = longest[v as usize].max(edge);
            sum[v as usize] += 0.5 * edge;
        }
    }
    for v in 0..n_rim {
        patch.sizes[v] = length.min(1.5 * sum[v]).max(longest[v] / LONG);
    }
    spread_sizes(patch, length);
}

/// Sizes of the free vertices from those around them.
fn spread_sizes(patch: &mut Patch, length: f64) {
    let free: Vec<u32> = patch.free_vertices().collect();
    for v in free {
        let mean: f64 = patch.mean_around(v, |w| patch.sizes[w as usize]);
        patch.sizes[v as usize] = length.min(GROWTH * mean);
    }
}

fn split_long(patch: &mut Patch, length: f64, target: &Target) {
    let is_long = |patch: &Patch, a: u32, b: u32| {
        let coarse = if length > target.length { length } else { 0.0 };
        patch.length(a, b) > LONG * patch.size(a, b).max(coarse)
    };
    let mut edges = patch.inner_edges();
    edges.retain(|&(a, b)| is_long(patch, a, b));
    order::sort_by(&mut edges, |p, q| {
        patch.length(q.0, q.1).total_cmp(&patch.length(p.0, p.1))
    });
    let mut room = target.most.saturating_sub(patch.n_free());
    let mut queue = VecDeque::from(edges);
    while room > 0 {
        let Some((a, b)) = queue.pop_front() else {
            break;
        };
        if let Some(middle) = patch.split(a, b) {
            room -= 1;
            let long = |v: &u32| is_long(patch, middle, *v);
            queue.extend(
                patch
                    .neighbours(middle)
                    .into_iter()
                    .filter(long)
                    .map(|v| (middle, v)),
            );
        }
    }
}

fn collapse_short(patch: &mut Patch) {
    for (a, b) in patch.inner_edges() {
        // The ends of an edge that is gone by now have no face together.
        let size = patch.size(a, b);
        if patch.length(a, b) < SHORT * size {
            let (gone, kept) = if patch.is_rim(a) { (b, a) } else { (a, b) };
            let longest = LONG * size;
            if !patch.collapse(gone, kept, longest) && !patch.is_rim(kept) {
                patch.collapse(kept, gone, longest);
            }
        }
    }
}

/// Flips edges until the angles opposite to each sum to at most π.
fn flip_delaunay(patch: &mut Patch) {
    flip_while(patch, |patch, [a, b, c, d]| {
        let cotangent = |apex: u32| {
            let at = |v: u32| patch.x[v as usize];
            let (u, v) = (at(a) - at(apex), at(b) - at(apex));
            u.dot(v) / u.cross(v).length().max(f64::MIN_POSITIVE)
        };
        cotangent(c) + cotangent(d) < -1e-9
    });
}

/// Flips edges as long as that brings the valences of their four vertices nearer to six.
fn flip_for_valence(patch: &mut Patch) {
    flip_while(patch, |patch, [a, b, c, d]| {
        let excess =
            |v: u32, change: i64| (patch.valence(v) as i64 + change - REGULAR as i64).pow(2);
        let cost =
            |lost: i64| excess(a, -lost) + excess(b, -lost) + excess(c, lost) + excess(d, lost);
        cost(1) < cost(0)
    });
}

fn flip_while(patch: &mut Patch, wants: impl Fn(&Patch, [u32; 4]) -> bool) {
    let mut queue = VecDeque::from(patch.inner_edges());
    let mut visits = VISITS * queue.len();
    while let Some((a, b)) = queue.pop_front() {
        if let Some((c, d)) = patch.flip(a, b, &wants) {
            queue.extend([(a, c), (c, b), (b, d), (d, a)]);
        }
        visits -= 1;
        if visits == 0 {
            break;
        }
    }
}

fn smooth(patch: &mut Patch, smoothing: Smoothing) {
    let free: Vec<u32> = patch.free_vertices().collect();
    for v in free {
        let at = patch.x[v as usize];
        let mut step: glam::DVec3 = patch.mean_around(v, |w| patch.x[w as usize]) - at;
        if smoothing == Smoothing::Tangential {
            let normal = patch.vertex_normal(v);
            step -= step.dot(normal) * normal;
        }
        if !patch.try_move(v, at + step) {
            patch.try_move(v, at + 0.25 * step);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use glam::DVec3;
    use std::collections::HashSet;

    #[test]
    fn smoothing_turns_no_face_over() {
        // An arrowhead: the mean of its corners, at 1/2, lies behind its notch, at 2.
        let corners = [
            (3.0, 0.0),
            (-1.5, 3.0),
            (2.0, 0.0),
            (-1.5, -3.0),
            (2.4, 0.0),
        ];
        let x = corners.map(|(x, y)| DVec3::new(x, y, 0.0)).to_vec();
        let faces = vec![[0, 1, 4], [1, 2, 4], [2, 3, 4], [3, 0, 4]];
        let start = Patch::new(x, faces, vec![3; 4], HashSet::new(), 1.0);
        for smoothing in [Smoothing::Umbrella, Smoothing::Tangential] {
            let mut patch = start.clone();
            for _ in 0..20 {
                smooth(&mut patch, smoothing);
            }
            let height = |[a, b, c]: [u32; 3]| {
                let [a, b, c] = [a, b, c].map(|v| patch.x[v as usize]);
                (b - a).cross(c - a).z
            };
            assert!(
                patch.faces().all(|face| height(face) > 0.0),
                "{:?}",
                patch.x[4]
            );
        }
    }
}
