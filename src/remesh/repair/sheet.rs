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

/// Drops walls inside: sheets that end at edges of three faces alone, where the other two go on in
/// sheets that end nowhere else either. The smallest go first: of the sheets that share a rim a flat
/// wall is the smallest.
pub(super) fn drop_walls(soup: &mut PolygonSoup) -> Option<Change> {
    let mut faces = Faces::of(soup);
    let (mut count, mut vertices) = (0, Vec::new());
    loop {
        let all = sheets(&faces);
        let mut sheet_of = vec![0; faces.len()];
        for (name, sheet) in all.iter().enumerate() {
            sheet.iter().for_each(|&f| sheet_of[f] = name);
        }
        let ends = |sheet: &Vec<usize>| {
            let mut sides = sheet.iter().flat_map(|&f| sides(faces.face(f)));
            sides.any(|(a, b)| faces.at(a, b).len() == 1)
        };
        let ends: Vec<bool> = all.iter().map(ends).collect();
        let is_wall = |name: usize| {
            let sides = all[name].iter().flat_map(|&f| sides(faces.face(f)));
            let mut rims = sides
                .map(|(a, b)| faces.at(a, b))
                .filter(|of| of.len() != 2);
            let is_rim = |of: &[u32]| {
                let others = of
                    .iter()
                    .map(|f| sheet_of[*f as usize])
                    .filter(|s| *s != name);
                of.len() == 3 && others.clone().count() == 2 && others.into_iter().all(|s| !ends[s])
            };
            rims.next().is_some_and(is_rim) && rims.all(is_rim)
        };
        let area = |name: usize| -> f64 {
            let areas = all[name]
                .iter()
                .map(|&f| area_of(faces.face(f), &soup.positions));
            areas.sum()
        };
        let mut walls: Vec<usize> = (0..all.len()).filter(|name| is_wall(*name)).collect();
        order::sort_by(&mut walls, |s, t| {
            area(*s).total_cmp(&area(*t)).then(s.cmp(t))
        });
        // Where one is gone two others have become one.
        let mut is_settled = vec![false; all.len()];
        let mut gone = Vec::new();
        for &wall in &walls {
            let sides = all[wall].iter().flat_map(|&f| sides(faces.face(f)));
            let near = sides.flat_map(|(a, b)| faces.at(a, b));
            let near: Vec<usize> = near.map(|f| sheet_of[*f as usize]).collect();
            if !near.iter().any(|sheet| is_settled[*sheet]) {
                near.into_iter().for_each(|sheet| is_settled[sheet] = true);
                gone.extend(&all[wall]);
            }
        }
        if gone.is_empty() {
            break;
        }
        count += gone.len();
        for f in gone {
            vertices.extend(faces.remove(f));
        }
    }
    if count == 0 {
        return None;
    }
    faces.write_to(soup);
    Some(Change::of(&RepairChange::Walls { count }, 0, vertices))
}

/// Area of a polygon, of one that is not flat that of its vector area.
fn area_of(face: &[u32], x: &[DVec3]) -> f64 {
    let at = |v: u32| x[v as usize] - x[face[0] as usize];
    let crosses = face.windows(2).map(|pair| at(pair[0]).cross(at(pair[1])));
    0.5 * crosses.sum::<DVec3>().length()
}

/// Gives each sheet at an edge of more than two faces vertices of its own there. Two faces go on
/// as one where they agree in orientation, belong together elsewhere, and lie most nearly
/// opposite each other. An edge that cannot be taken apart, as its ends hang together elsewhere, is
/// doubled. `origin` learns what new vertices are copies of.
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
        let is_one = |f: u32, g: u32| sheet_of[f as usize] == sheet_of[g as usize];
        let pairs: BTreeMap<(u32, u32), Vec<(u32, u32)>> = crowded
            .iter()
            .map(|&ends| (ends, paired(&faces, is_one, ends, &soup.positions)))
            .collect();
        split(soup, origin, &faces, &pairs);
    }
    let doubled = double_edges(soup, origin);
    let count = count
        - doubled
            .as_ref()
            .map_or(0, |doubled| doubled.count)
            .min(count);
    let cut = (count > 0).then(|| Change::of(&RepairChange::CutEdges { count }, 0, vertices));
    cut.into_iter().chain(doubled).collect()
}

/// Gives each pair of faces but the first, at every edge of more than two, a vertex in the middle.
fn double_edges(soup: &mut PolygonSoup, origin: &mut Vec<u32>) -> Option<Change> {
    let mut faces = Faces::of(soup);
    let crowded = faces.edges().filter(|(_, of)| of.len() > 2);
    let mut crowded: Vec<(u32, u32)> = crowded.map(|(ends, _)| *ends).collect();
    if crowded.is_empty() {
        return None;
    }
    order::sort(&mut crowded);
    let mut vertices = Vec::new();
    for &(a, b) in &crowded {
        vertices.extend([origin[a as usize], origin[b as usize]]);
        let pairs = paired(&faces, |_, _| true, (a, b), &soup.positions);
        let in_pairs = |f: &u32| pairs.iter().any(|(g, h)| g == f || h == f);
        let alone = faces.at(a, b).iter().filter(|f| !in_pairs(f));
        let alone: Vec<Vec<u32>> = alone.map(|f| vec![*f]).collect();
        let others = pairs[1..].iter().map(|(f, g)| vec![*f, *g]);
        for sheet in others.chain(alone) {
            let middle = soup.positions.len() as u32;
            let [p, q] = [a, b].map(|v| soup.positions[v as usize]);
            soup.positions.push(p.midpoint(q));
            origin.push(origin[a as usize]);
            for f in sheet {
                faces.insert(f as usize, (a, b), middle);
            }
        }
    }
    faces.write_to(soup);
    let count = crowded.len();
    Some(Change::of(
        &RepairChange::DoubledEdges { count },
        0,
        vertices,
    ))
}

/// Which faces at an edge go on as one sheet; `is_one` tells whether two belong together elsewhere.
fn paired(
    faces: &Faces,
    is_one: impl Fn(u32, u32) -> bool,
    (a, b): (u32, u32),
    x: &[DVec3],
) -> Vec<(u32, u32)> {
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
            let far =
                if is_one(*f, *g) { 0.0 } else { 4.0 } + if runs == other { 8.0 } else { 0.0 };
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
