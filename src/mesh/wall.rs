//! Walls between two bodies: faces that are there twice, once for each body.

use crate::soup::PolygonSoup;
use std::collections::HashMap;

/// Whether two faces on the same vertices are turned to opposite sides.
pub(super) fn are_opposite(f: &[u32], g: &[u32]) -> bool {
    let n = f.len();
    let at = g.iter().position(|v| *v == f[0]);
    at.is_some_and(|at| (0..n).all(|i| f[i] == g[(at + n - i) % n]))
}

/// Of pairs of opposite faces those that are walls: each patch of pairs ends, and where it does, two
/// other faces go on, one for each side. A sheet with a back of its own ends where there are no others,
/// or nowhere.
pub(super) fn walls(soup: &PolygonSoup, pairs: &[[usize; 2]]) -> Vec<[usize; 2]> {
    if pairs.is_empty() {
        return Vec::new();
    }
    let sides = |f: usize| {
        let face = soup.face(f);
        (0..face.len()).map(move |i| {
            let (a, b) = (face[i], face[(i + 1) % face.len()]);
            (a.min(b), a.max(b))
        })
    };
    // At each edge of a pair the pairs, and how many other faces.
    let mut at: HashMap<(u32, u32), (Vec<usize>, usize)> = HashMap::new();
    for (pair, [f, _]) in pairs.iter().enumerate() {
        for edge in sides(*f) {
            at.entry(edge).or_default().0.push(pair);
        }
    }
    let mut is_paired = vec![false; soup.n_faces()];
    pairs.iter().flatten().for_each(|f| is_paired[*f] = true);
    for f in (0..soup.n_faces()).filter(|f| !is_paired[*f]) {
        for edge in sides(f) {
            if let Some((_, others)) = at.get_mut(&edge) {
                *others += 1;
            }
        }
    }
    let mut is_seen = vec![false; pairs.len()];
    let mut found = Vec::new();
    for seed in 0..pairs.len() {
        if is_seen[seed] {
            continue;
        }
        is_seen[seed] = true;
        let mut patch = vec![seed];
        let (mut next, mut is_wall, mut ends) = (0, true, false);
        while next < patch.len() {
            for edge in sides(pairs[patch[next]][0]) {
                let (here, others) = &at[&edge];
                // Several bodies may meet in an edge.
                is_wall &= *others == 2 || (*others == 0 && here.len() > 1);
                ends |= *others > 0;
                for &pair in here {
                    if !std::mem::replace(&mut is_seen[pair], true) {
                        patch.push(pair);
                    }
                }
            }
            next += 1;
        }
        if is_wall && ends {
            found.extend(patch.iter().map(|pair| pairs[*pair]));
        }
    }
    found
}
