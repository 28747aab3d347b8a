//! Edges of more than two faces: sheets that hang on them.

use super::faces::{Faces, sides};
use super::hash::Table;
use super::{Change, RepairChange, edges, key};
use crate::order;
use crate::soup::PolygonSoup;
use glam::DVec3;
use std::collections::BTreeMap;
use std::f64::consts::TAU;

/// A sheet that hangs on others is dropped where it has no more than this share of all faces.
const SMALL: f64 = 0.01;
/// So many faces are a small sheet whatever the mesh.
const FEW: usize = 4;

/// The faces of each sheet: those that hang together over edges of two faces.
pub(super) fn sheets(faces: &Faces) -> Vec<Vec<usize>> {
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

/// Whether there is an edge of more than two faces.
pub(super) fn has_crowded_edge(soup: &PolygonSoup) -> bool {
    let mut count: Table<(u32, u32), u32> =
        Table::with_capacity_and_hasher(soup.corners.len(), Default::default());
    edges(soup).any(|(a, b)| {
        let count = count.entry(key(a, b)).or_default();
        *count += 1;
        *count > 2
    })
}

fn is_crowded(faces: &Faces, (a, b): (u32, u32)) -> bool {
    faces.at(a, b).len() > 2
}

/// Whether faces hang together, and with no others over an edge of two.
fn is_sheet(faces: &Faces, sheet: &[usize]) -> bool {
    let mut sides = sheet.iter().flat_map(|&f| sides(faces.face(f)));
    sides.all(|(a, b)| match *faces.at(a, b) {
        [f, g] => [f, g].iter().all(|f| sheet.contains(&(*f as usize))),
        _ => true,
    })
}

/// Drops small sheets that hang on an edge of more than two faces and end somewhere, the smallest
/// first, as long as there are any.
pub(super) fn drop_fins(soup: &mut PolygonSoup) -> Option<Change> {
    let mut faces = Faces::of(soup);
    let small = FEW.max((SMALL * soup.n_faces() as f64) as usize);
    let (mut count, mut vertices) = (0, Vec::new());
    loop {
        let before = count;
        let mut fins = sheets(&faces);
        fins.retain(|sheet| sheet.len() <= small);
        order::sort_by_key(&mut fins, Vec::len);
        for fin in fins {
            let edges = || fin.iter().flat_map(|&f| sides(faces.face(f)));
            let hangs = edges().any(|edge| is_crowded(&faces, edge));
            let ends = edges().any(|(a, b)| faces.at(a, b).len() == 1);
            // Where one is gone two others may have become one.
            if !hangs || !ends || !is_sheet(&faces, &fin) {
                continue;
            }
            count += fin.len();
            for f in fin {
                vertices.extend(faces.remove(f));
            }
        }
        if count == before {
            break;
        }
    }
    if count == 0 {
        return None;
    }
    faces.write_to(soup);
    Some(Change::of(&RepairChange::Fins { count }, 0, vertices))
}

/// Gives each sheet at an edge of more than two faces vertices of its own there. Two faces go on
/// as one where they agree in orientation, belong together elsewhere, and lie most nearly
/// opposite each other. What cannot be taken apart, as its ends hang together elsewhere, is
/// dropped. `origin` learns what new vertices are copies of.
pub(super) fn cut(soup: &mut PolygonSoup, origin: &mut Vec<u32>) -> Vec<Change> {
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
        order::sort(&mut crowded);
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
        split(soup, origin, &faces, &pairs);
    }
    if count == 0 {
        return Vec::new();
    }
    let mut changes = vec![Change::of(&RepairChange::CutEdges { count }, 0, vertices)];
    // What still hangs together.
    let mut faces = Faces::of(soup);
    let crowded = faces.edges().filter(|(_, of)| of.len() > 2);
    let mut tangled: Vec<u32> = crowded.flat_map(|(_, of)| of[2..].to_vec()).collect();
    tangled.sort_unstable();
    tangled.dedup();
    if !tangled.is_empty() {
        let count = tangled.len();
        let corners = tangled.into_iter().flat_map(|f| faces.remove(f as usize));
        let corners: Vec<u32> = corners.map(|v| origin[v as usize]).collect();
        changes.push(Change::of(
            &RepairChange::TangledFaces { count },
            0,
            corners,
        ));
        faces.write_to(soup);
    }
    changes
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
    // A wall between two bodies is there twice: each goes on where its body is inside.
    let corners = |f: u32| {
        let mut corners = faces.face(f as usize).to_vec();
        corners.sort_unstable();
        corners
    };
    let all: Vec<Vec<u32>> = wings.iter().map(|(f, ..)| corners(*f)).collect();
    let has_wall = (1..all.len()).any(|i| all[..i].contains(&all[i]));
    let mut candidates = Vec::new();
    for (i, (f, p, runs)) in wings.iter().enumerate() {
        for (g, q, other) in &wings[i + 1..] {
            // Of one sheet first, flattest first; faces that disagree last.
            let is_one = sheet_of[*f as usize] == sheet_of[*g as usize];
            let far = if is_one { 0.0 } else { 4.0 } + if runs == other { 8.0 } else { 0.0 };
            let bend = if has_wall && runs != other {
                let along = if *runs { axis } else { -axis };
                inside(along.cross(*p), *p, *q)
            } else {
                p.dot(*q) + far
            };
            candidates.push((bend, *f, *g));
        }
    }
    order::sort_by(&mut candidates, |s, t| {
        s.0.total_cmp(&t.0).then((s.1, s.2).cmp(&(t.1, t.2)))
    });
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

/// By how much a face must be turned about an edge, through what is inside of it, to lie on another:
/// from its normal and the directions of both away from the edge. A whole turn where they coincide.
fn inside(normal: DVec3, p: DVec3, q: DVec3) -> f64 {
    let angle = (-normal.dot(q)).atan2(p.dot(q));
    if angle > 1e-9 { angle } else { angle + TAU }
}

/// Gives every fan of faces about a vertex of a cut edge a vertex of its own; faces hang together
/// over edges of two faces, and over the pairs at the others.
fn split(
    soup: &mut PolygonSoup,
    origin: &mut Vec<u32>,
    faces: &Faces,
    pairs: &BTreeMap<(u32, u32), Vec<(u32, u32)>>,
) {
    let mut is_cut = vec![false; soup.positions.len()];
    for (a, b) in pairs.keys() {
        is_cut[*a as usize] = true;
        is_cut[*b as usize] = true;
    }
    let fans = faces.fans(soup, |edge, of| match of[..] {
        [f, g] => vec![(f, g)],
        _ => pairs.get(&edge).cloned().unwrap_or_default(),
    });
    // The first fan keeps the vertex.
    let mut has_fan = vec![false; is_cut.len()];
    let mut name_of: BTreeMap<u32, u32> = BTreeMap::new();
    for (corner, &fan) in soup.corners.iter_mut().zip(&fans) {
        let v = *corner as usize;
        if !is_cut[v] {
            continue;
        }
        *corner = *name_of.entry(fan).or_insert_with(|| {
            if !std::mem::replace(&mut has_fan[v], true) {
                return v as u32;
            }
            soup.positions.push(soup.positions[v]);
            origin.push(origin[v]);
            soup.positions.len() as u32 - 1
        });
    }
}
