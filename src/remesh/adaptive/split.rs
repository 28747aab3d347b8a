//! Splits: a vertex in the middle of each edge that is too long.

use super::crease;
use super::draft::{Draft, Hinge};
use crate::interrupt::paced;

/// An edge longer than this share of its wanted length is split.
const TOO_LONG: f64 = 4.0 / 3.0;

/// Splits the edges that are too long now, the longest first; their number.
pub(super) fn run(draft: &mut Draft) -> usize {
    let mut long = draft.by_stretch(|stretch| stretch > TOO_LONG);
    long.reverse();
    let mut count = 0;
    for edge in paced(long) {
        // Splits of others leave an edge as it is.
        if let Some(hinge) = draft.hinge(edge) {
            split(draft, hinge);
            count += 1;
        }
    }
    count
}

fn split(draft: &mut Draft, hinge: Hinge) {
    let [a, b] = hinge.ends;
    let (i, j) = (a as usize, b as usize);
    let middle = draft.x.len() as u32;
    draft.x.push(draft.middle(hinge.ends));
    // Normals on an edge of the shape say nothing of the faces beside it.
    let across = match draft.creased[i] || draft.creased[j] {
        true => hinge
            .faces
            .map(|f| draft.normal_of(draft.faces[f as usize])),
        false => [draft.normal[i], draft.normal[j]],
    };
    draft
        .normal
        .push((across[0] + across[1]).normalize_or_zero());
    draft.size.push(0.5 * (draft.size[i] + draft.size[j]));
    let is_creased = crease::is_sharp(draft, hinge);
    draft.held.push(is_creased);
    draft.creased.push(is_creased);
    draft.regular.push(6);
    draft.seed.push(draft.seed[i]);
    draft.star.push(Vec::with_capacity(7));
    for (f, apex) in hinge.faces.into_iter().zip(hinge.apexes) {
        let corners = draft.faces[f as usize];
        let with_middle_for = |old: u32| corners.map(|v| if v == old { middle } else { v });
        let g = draft.faces.len() as u32;
        draft.faces.push(with_middle_for(a));
        draft.faces[f as usize] = with_middle_for(b);
        draft.leave(b, f);
        draft.star[j].push(g);
        draft.star[apex as usize].push(g);
        draft.star[middle as usize].extend([f, g]);
    }
}
