//! Faces that are there more than once; those that are a wall between two bodies are there for each.

use crate::order;
use crate::soup::PolygonSoup;
use std::collections::HashMap;

/// The faces whose vertices an earlier face has, walls between two bodies excepted, in order.
pub(super) fn duplicate_faces(soup: &PolygonSoup) -> Vec<usize> {
    // A hash in the upper half, the face in the lower: whole vertex sets are compared only
    // where hashes agree.
    let hash = |f: usize| {
        // Not linear in the numbers: those of neighbouring faces have the same sum.
        let mix = |v: &u32| {
            let z = (u64::from(*v) + 1).wrapping_mul(0x9E37_79B9_7F4A_7C15);
            (z ^ (z >> 30)).wrapping_mul(0xBF58_476D_1CE4_E5B9) >> 7
        };
        soup.face(f).iter().map(mix).fold(0, u64::wrapping_add) << 32
    };
    // Only faces with the same least vertex can be duplicates.
    let least = |f: usize| soup.face(f).iter().copied().min().unwrap_or_default();
    let entries = (0..soup.n_faces()).map(|f| (least(f), hash(f) | f as u64));
    let (start, mut entries) = order::bucketed(soup.positions.len(), entries);
    for range in start.windows(2) {
        entries[range[0] as usize..range[1] as usize].sort_unstable();
    }
    let groups = entries.chunk_by(|a, b| a >> 32 == b >> 32);
    let alike = groups.filter(|group| group.len() > 1).flatten();
    let alike: Vec<usize> = alike.map(|entry| *entry as u32 as usize).collect();
    if alike.is_empty() {
        return Vec::new();
    }
    repeated(soup, &alike)
}

deferred! {
    fn repeated(soup: &PolygonSoup, faces: &[usize]) -> Vec<usize> {
        let mut same: HashMap<Vec<u32>, Vec<usize>> = HashMap::new();
        for &f in faces {
            let mut corners = soup.face(f).to_vec();
            corners.sort_unstable();
            same.entry(corners).or_default().push(f);
        }
        let (mut later, mut pairs) = (Vec::new(), Vec::new());
        for faces in same.values_mut() {
            faces.sort_unstable();
            match faces[..] {
                [f, g] if are_opposite(soup.face(f), soup.face(g)) => pairs.push([f, g]),
                _ => later.extend(&faces[1..]),
            }
        }
        pairs.sort_unstable();
        let mut walls = walls(soup, &pairs);
        walls.sort_unstable();
        let is_wall = |pair: &[usize; 2]| walls.binary_search(pair).is_ok();
        let sheets = pairs.into_iter().filter(|pair| !is_wall(pair));
        later.extend(sheets.map(|[_, g]| g));
        later.sort_unstable();
        later
    }
}

/// Whether two faces on the same vertices are turned to opposite sides.
fn are_opposite(f: &[u32], g: &[u32]) -> bool {
    let n = f.len();
    let at = g.iter().position(|v| *v == f[0]);
    at.is_some_and(|at| (0..n).all(|i| f[i] == g[(at + n - i) % n]))
}

/// Of pairs of opposite faces those that are walls: each patch of pairs ends, and where it does, two
/// other faces go on, one for each side. A sheet with a back of its own ends where there are no others,
/// or nowhere.
fn walls(soup: &PolygonSoup, pairs: &[[usize; 2]]) -> Vec<[usize; 2]> {
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
