//! Collapses: the two ends of each edge that is too short become one vertex.
//!
//! Refused where the surface would change its topology (the ends have other common
//! neighbours than the two opposite), where a vertex would have fewer than four faces or more
//! than nine, where a face would turn by more than 45° or become a sliver, and where an edge
//! would become too long.

use super::crease;
use super::draft::{Draft, Hinge};
use crate::interrupt::paced;
use glam::DVec3;

/// An edge shorter than this share of its wanted length is collapsed …
const TOO_SHORT: f64 = 0.75;
/// … if no edge becomes longer than this share.
const LONGEST: f64 = 1.4;
/// Cosine of the angle by which a face may turn.
const TURN: f64 = std::f64::consts::FRAC_1_SQRT_2;
/// Least area of a triangle over the square of its longest edge; 0.43 if equilateral.
const THINNEST: f64 = 1.0 / 8.0;
/// Most faces at a vertex.
const MOST_FACES: usize = 9;

/// Collapses the edges that are too short, the shortest first; their number.
pub(super) fn run(draft: &mut Draft) -> usize {
    let mut count = 0;
    for edge in paced(draft.by_stretch(|stretch| stretch < TOO_SHORT)) {
        // Earlier ones may have moved the ends or taken one away.
        if edge.iter().all(|&v| draft.is_alive(v))
            && draft.stretch(edge) < TOO_SHORT
            && let Some(hinge) = draft.hinge(edge)
            && let Some(place) = place(draft, hinge)
        {
            collapse(draft, hinge, place);
            count += 1;
        }
    }
    count
}

/// Where the one vertex would be; `None` if the edge must stay.
fn place(draft: &Draft, hinge: Hinge) -> Option<DVec3> {
    let [a, b] = hinge.ends;
    let place = match hinge.ends.map(|v| draft.held[v as usize]) {
        [true, true] if crease::ends_in(draft, hinge, b) => draft.at(b),
        [true, true] if crease::ends_in(draft, hinge, a) => draft.at(a),
        [true, true] => return None,
        [true, false] => draft.at(a),
        [false, true] => draft.at(b),
        [false, false] => draft.middle(hinge.ends),
    };
    let rings = hinge.ends.map(|v| draft.ring(v));
    let common = rings[0].iter().filter(|v| rings[1].contains(v)).count();
    let faces = |v: u32| draft.star[v as usize].len();
    let starves = |v: u32| faces(v) <= 4 && draft.regular[v as usize] == 6;
    if common != 2
        || hinge
            .apexes
            .into_iter()
            .any(|v| starves(v) || faces(v) <= 1)
        || faces(a) + faces(b) > MOST_FACES + 4
    {
        return None;
    }
    let size = 0.5 * (draft.size[a as usize] + draft.size[b as usize]);
    let becomes_long =
        |v: u32| 2.0 * draft.at(v).distance(place) > LONGEST * (draft.size[v as usize] + size);
    let others = rings.iter().flatten().filter(|v| !hinge.ends.contains(v));
    if others.copied().any(becomes_long) {
        return None;
    }
    let stars = hinge.ends.iter().flat_map(|&v| &draft.star[v as usize]);
    let mut kept = stars.filter(|f| !hinge.faces.contains(f));
    kept.all(|&f| stays_good(draft, draft.faces[f as usize], hinge.ends, place))
        .then_some(place)
}

/// Whether a face is still one if the ends of an edge move to one place.
fn stays_good(draft: &Draft, corners: [u32; 3], ends: [u32; 2], place: DVec3) -> bool {
    let before = draft.normal_of(corners);
    let [p, q, r] = corners.map(|v| {
        if ends.contains(&v) {
            place
        } else {
            draft.at(v)
        }
    });
    let after = (q - p).cross(r - p);
    let longest = p
        .distance_squared(q)
        .max(q.distance_squared(r))
        .max(r.distance_squared(p));
    before.dot(after) >= TURN * before.length() * after.length()
        && after.length() >= 2.0 * THINNEST * longest
}

fn collapse(draft: &mut Draft, hinge: Hinge, place: DVec3) {
    // The end that stays in place, if there is one.
    let [a, b] = hinge.ends;
    let (kept, lost) = if draft.at(b) == place { (b, a) } else { (a, b) };
    let (i, j) = (kept as usize, lost as usize);
    draft.x[i] = place;
    draft.normal[i] = (draft.normal[i] + draft.normal[j]).normalize_or_zero();
    draft.size[i] = 0.5 * (draft.size[i] + draft.size[j]);
    for f in hinge.faces {
        draft.remove_face(f);
    }
    for f in std::mem::take(&mut draft.star[j]) {
        let corners = &mut draft.faces[f as usize];
        *corners = corners.map(|v| if v == lost { kept } else { v });
        draft.star[i].push(f);
    }
}
