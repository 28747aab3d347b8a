//! Sheets and bodies that lie on another one, face by face.

use super::faces::Faces;
use super::hash::{Mixed, Table};
use super::sheet::sheets;
use crate::order;
use crate::soup::PolygonSoup;
use std::hash::{Hash, Hasher};

/// The places of a face's corners, whatever their order.
fn places(face: &[u32], soup: &PolygonSoup) -> Vec<[u64; 3]> {
    let place = |v: &u32| (soup.positions[*v as usize] + 0.0).to_array();
    let mut all: Vec<[u64; 3]> = (face.iter()).map(|v| place(v).map(f64::to_bits)).collect();
    order::sort(&mut all);
    all
}

/// Drops sheets all of whose faces lie exactly where those of an earlier one do, as of a surface that
/// was exported twice, or with a back side of its own: open ones would be welded to a bag without an
/// inside, closed ones counted twice. Gives how many faces, and their corners.
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
    let mut known: Table<(usize, u64), Vec<&Vec<usize>>> = Table::default();
    let mut doubled: Vec<usize> = Vec::new();
    let of = |sheet: &[usize]| {
        let mut faces: Vec<_> = (sheet.iter())
            .map(|&f| places(faces.face(f), soup))
            .collect();
        order::sort(&mut faces);
        faces
    };
    for sheet in &all {
        let hash = |f: &usize| {
            let mut hasher = Mixed::default();
            places(faces.face(*f), soup).hash(&mut hasher);
            hasher.finish()
        };
        let sum = sheet.iter().map(hash).fold(0, u64::wrapping_add);
        let same = known.entry((sheet.len(), sum)).or_default();
        if same.iter().any(|other| of(other) == of(sheet)) {
            doubled.extend(sheet);
        } else {
            same.push(sheet);
        }
    }
    let mut vertices = Vec::new();
    for &f in &doubled {
        vertices.extend(faces.remove(f));
    }
    if !doubled.is_empty() {
        faces.write_to(soup);
    }
    (doubled.len(), vertices)
}
