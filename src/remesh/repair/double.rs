//! Sheets and bodies that lie on another one, face by face.

use super::faces::{Faces, sides};
use super::hash::Table;
use super::sheet::sheets;
use crate::order;
use crate::soup::PolygonSoup;

/// The places of a face's corners, whatever their order.
fn places(face: &[u32], soup: &PolygonSoup) -> Vec<[u64; 3]> {
    let place = |v: &u32| (soup.positions[*v as usize] + 0.0).to_array();
    let mut all: Vec<[u64; 3]> = (face.iter()).map(|v| place(v).map(f64::to_bits)).collect();
    order::sort(&mut all);
    all
}

/// Drops sheets all of whose faces lie exactly where others do, as of a surface that was exported
/// twice, or with a back side of its own: open ones would be welded to a bag without an inside, closed
/// ones counted twice. A closed one must be another as a whole: bodies that touch share faces. Of two
/// that are the same the earlier is kept. Gives how many faces, and their corners.
pub(super) fn drop_doubles(soup: &mut PolygonSoup) -> (usize, Vec<u32>) {
    let mut seen = Table::with_capacity_and_hasher(soup.positions.len(), Default::default());
    let mut used = vec![false; soup.positions.len()];
    soup.corners.iter().for_each(|&v| used[v as usize] = true);
    let mut used = (0..used.len() as u32).filter(|v| used[*v as usize]);
    // Where no two vertices lie at the same place no two faces do.
    if used.all(|v| seen.insert(places(&[v], soup)[0], ()).is_none()) {
        return (0, Vec::new());
    }
    let mut faces = Faces::of(soup);
    let all = sheets(&faces);
    // The sheets that have a face with these places.
    let mut owners: Table<Vec<[u64; 3]>, Vec<usize>> = Table::default();
    for (name, sheet) in all.iter().enumerate() {
        for &f in sheet {
            let owners = owners.entry(places(faces.face(f), soup)).or_default();
            if owners.last() != Some(&name) {
                owners.push(name);
            }
        }
    }
    let mut is_kept = vec![true; all.len()];
    let mut by_size: Vec<usize> = (0..all.len()).rev().collect();
    order::sort_by_key(&mut by_size, |name| all[*name].len());
    for name in by_size {
        let sheet = &all[name];
        let owners = |f: &usize| {
            let all = owners.get(&places(faces.face(*f), soup));
            all.into_iter()
                .flatten()
                .copied()
                .filter(|other| *other != name && is_kept[*other])
        };
        let is_open = || {
            let sides = sheet.iter().flat_map(|&f| sides(faces.face(f)));
            sides.into_iter().any(|(a, b)| faces.at(a, b).len() == 1)
        };
        let is_same = |other: &usize| {
            all[*other].len() == sheet.len() && sheet.iter().all(|f| owners(f).any(|o| o == *other))
        };
        let covered = sheet.iter().all(|f| owners(f).next().is_some());
        if covered
            && (is_open()
                || sheet
                    .first()
                    .is_some_and(|f| owners(f).any(|o| is_same(&o))))
        {
            is_kept[name] = false;
        }
    }
    let doubled = all.iter().zip(&is_kept).filter(|(_, is_kept)| !**is_kept);
    let doubled: Vec<usize> = doubled.flat_map(|(sheet, _)| sheet).copied().collect();
    let mut vertices = Vec::new();
    for &f in &doubled {
        vertices.extend(faces.remove(f));
    }
    if !doubled.is_empty() {
        faces.write_to(soup);
    }
    (doubled.len(), vertices)
}
