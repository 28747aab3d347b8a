//! Edges of more than two faces: sheets that hang on them.

use super::faces::{Faces, sides};
use super::{RepairChange, key, named};
use crate::soup::PolygonSoup;
use glam::DVec3;
use std::collections::BTreeMap;

/// A sheet that hangs on others is dropped where it has no more than this share of all faces.
const SMALL: f64 = 0.01;
/// So many faces are a small sheet whatever the mesh.
const FEW: usize = 4;

/// The faces of each sheet: those that hang together over edges of two faces.
fn sheets(faces: &Faces) -> Vec<Vec<usize>> {
    let mut is_seen = vec![false; faces.len()];
    let mut all = Vec::new();
    for seed in 0..faces.len() {
        if is_seen[seed] || faces.face(seed).is_empty() {
            continue;
        }
        is_seen[seed] = true;
        let mut sheet = vec![seed];
        let mut at = 0;
        while at < sheet.len() {
            for (a, b) in sides(faces.face(sheet[at])) {
                let &[f, g] = faces.at(a, b) else { continue };
                for next in [f as usize, g as usize] {
                    if !std::mem::replace(&mut is_seen[next], true) {
                        sheet.push(next);
                    }
                }
            }
            at += 1;
        }
        all.push(sheet);
    }
    all
}

fn is_crowded(faces: &Faces, (a, b): (u32, u32)) -> bool {
    faces.at(a, b).len() > 2
}

/// Drops small sheets that hang on an edge of more than two faces and end somewhere, the smallest
/// first, as long as there are any.
pub(super) fn drop_fins(soup: &mut PolygonSoup) -> Option<RepairChange> {
    let mut faces = Faces::of(soup);
    if !faces.edges().any(|(_, of)| of.len() > 2) {
        return None;
    }
    let small = FEW.max((SMALL * soup.n_faces() as f64) as usize);
    let (mut count, mut vertices) = (0, Vec::new());
    loop {
        let fins = sheets(&faces).into_iter().filter(|sheet| {
            let edges = || sheet.iter().flat_map(|&f| sides(faces.face(f)));
            sheet.len() <= small
                && edges().any(|edge| is_crowded(&faces, edge))
                && edges().any(|(a, b)| faces.at(a, b).len() == 1)
        });
        let Some(fin) = fins.min_by_key(Vec::len) else {
            break;
        };
        count += fin.len();
        for f in fin {
            vertices.extend(faces.remove(f));
        }
    }
    if count == 0 {
        return None;
    }
    faces.write_to(soup);
    Some(RepairChange::Fins {
        count,
        vertices: named(vertices),
    })
}

/// Gives each sheet at an edge of more than two faces vertices of its own there. Two faces go on
/// as one where they agree in orientation, belong together elsewhere, and lie most nearly
/// opposite each other; what
/// cannot be told apart, as its ends hang together elsewhere, is dropped.
pub(super) fn cut(soup: &mut PolygonSoup) -> Option<RepairChange> {
    let (mut count, mut vertices) = (0, Vec::new());
    for round in 0..2 {
        let faces = Faces::of(soup);
        let mut crowded: Vec<(u32, u32)> = faces
            .edges()
            .filter(|(_, of)| of.len() > 2)
            .map(|(ends, _)| *ends)
            .collect();
        if crowded.is_empty() {
            break;
        }
        crowded.sort_unstable();
        if round == 0 {
            count = crowded.len();
            vertices = crowded.iter().flat_map(|&(a, b)| [a, b]).collect();
        }
        let mut sheet_of = vec![0; faces.len()];
        for (name, sheet) in sheets(&faces).iter().enumerate() {
            sheet.iter().for_each(|&f| sheet_of[f] = name);
        }
        let pairs: BTreeMap<(u32, u32), Vec<(u32, u32)>> = crowded
            .iter()
            .map(|&ends| (ends, paired(&faces, &sheet_of, ends, &soup.positions)))
            .collect();
        split(soup, &pairs);
    }
    // What still hangs together.
    let mut faces = Faces::of(soup);
    let crowded: Vec<Vec<u32>> = (faces.edges().filter(|(_, of)| of.len() > 2))
        .map(|(_, of)| of[2..].to_vec())
        .collect();
    for f in crowded.into_iter().flatten() {
        faces.remove(f as usize);
    }
    faces.write_to(soup);
    (count > 0).then(|| RepairChange::CutEdges {
        count,
        vertices: named(vertices),
    })
}

/// Which faces at an edge go on as one sheet.
fn paired(faces: &Faces, sheet_of: &[usize], (a, b): (u32, u32), x: &[DVec3]) -> Vec<(u32, u32)> {
    let axis = (x[b as usize] - x[a as usize]).normalize_or_zero();
    // Of each face the direction away from the edge, and whether it runs from a to b.
    let wings: Vec<(u32, DVec3, bool)> = faces
        .at(a, b)
        .iter()
        .map(|&f| {
            let face = faces.face(f as usize);
            let others = face.iter().filter(|&&v| v != a && v != b);
            let (mut sum, mut n) = (DVec3::ZERO, 0.0);
            for &v in others {
                sum += x[v as usize];
                n += 1.0;
            }
            let away = sum / f64::max(n, 1.0) - x[a as usize];
            let away = (away - away.dot(axis) * axis).normalize_or_zero();
            (f, away, sides(face).any(|side| side == (a, b)))
        })
        .collect();
    let mut candidates = Vec::new();
    for (i, (f, p, runs)) in wings.iter().enumerate() {
        for (g, q, other) in &wings[i + 1..] {
            // Of one sheet first, flattest first; faces that disagree last.
            let is_one = sheet_of[*f as usize] == sheet_of[*g as usize];
            let far = if is_one { 0.0 } else { 4.0 } + if runs == other { 8.0 } else { 0.0 };
            let bend = p.dot(*q) + far;
            candidates.push((bend, *f, *g));
        }
    }
    candidates.sort_by(|s, t| s.0.total_cmp(&t.0).then((s.1, s.2).cmp(&(t.1, t.2))));
    let mut taken = Vec::new();
    let mut pairs = Vec::new();
    for (_, f, g) in candidates {
        if !taken.contains(&f) && !taken.contains(&g) {
            taken.extend([f, g]);
            pairs.push((f, g));
        }
    }
    pairs
}

fn root(parent: &mut [u32], mut i: u32) -> u32 {
    while parent[i as usize] != i {
        parent[i as usize] = parent[parent[i as usize] as usize];
        i = parent[i as usize];
    }
    i
}

/// Gives every fan of faces about a vertex of a cut edge a vertex of its own; faces hang together
/// over edges of two faces, and over the pairs at the others.
fn split(soup: &mut PolygonSoup, pairs: &BTreeMap<(u32, u32), Vec<(u32, u32)>>) {
    let mut is_cut = vec![false; soup.positions.len()];
    for (a, b) in pairs.keys() {
        is_cut[*a as usize] = true;
        is_cut[*b as usize] = true;
    }
    let faces = Faces::of(soup);
    let corner_of = |f: u32, v: u32| {
        let start = soup.face_starts[f as usize];
        let place = soup.face(f as usize).iter().position(|&c| c == v);
        place.map(|place| start + place as u32)
    };
    let mut parent: Vec<u32> = (0..soup.corners.len() as u32).collect();
    for (&(a, b), of) in faces.edges() {
        let two = match of[..] {
            [f, g] => vec![(f, g)],
            _ => pairs.get(&key(a, b)).cloned().unwrap_or_default(),
        };
        for (f, g) in two {
            for v in [a, b] {
                let (Some(c), Some(d)) = (corner_of(f, v), corner_of(g, v)) else {
                    continue;
                };
                let (c, d) = (root(&mut parent, c), root(&mut parent, d));
                parent[c.max(d) as usize] = c.min(d);
            }
        }
    }
    let mut fans: BTreeMap<u32, BTreeMap<u32, u32>> = BTreeMap::new();
    for c in 0..soup.corners.len() {
        let v = soup.corners[c];
        if !is_cut[v as usize] {
            continue;
        }
        let fan = root(&mut parent, c as u32);
        let of_vertex = fans.entry(v).or_default();
        let is_first = of_vertex.is_empty();
        let name = *of_vertex.entry(fan).or_insert_with(|| {
            if is_first {
                return v;
            }
            soup.positions.push(soup.positions[v as usize]);
            soup.positions.len() as u32 - 1
        });
        soup.corners[c] = name;
    }
}
