//! How a file numbers the vertices and faces that sentences name: OBJ counts from 1, and what a
//! file has besides the surface is counted there too.

use super::Session;
use super::fault::Fault;
use super::message::AppError;
use crate::arrays::TypedArray;
use crate::io::Format;
use crate::mesh::{Built, HalfedgeMesh};
use crate::soup::PolygonSoup;
use serde::Serialize;
use std::collections::BTreeMap;

/// Numbers of a file's vertices and faces.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Numbers {
    /// That of the first: 0, or 1 of a format that counts so.
    pub first: u32,
    /// For each vertex the file's, counted from 0; null where these are the same.
    pub vertices: Option<TypedArray<u32>>,
    /// For each triangle the file's face that it was cut from.
    pub faces: Option<TypedArray<u32>>,
}

/// The number of a format's first vertex, and of its first face.
pub(super) fn first_of(format: Format) -> u32 {
    u32::from(format == Format::Obj)
}

/// A list that says more than its places do.
fn unless_plain(list: Vec<u32>) -> Option<TypedArray<u32>> {
    let is_plain = list.iter().copied().eq(0..list.len() as u32);
    (!is_plain).then(|| list.into())
}

impl Numbers {
    /// Of a surface that was built of a file.
    pub(super) fn of(soup: &PolygonSoup, first: u32, built: &Built) -> Self {
        Self {
            first,
            vertices: unless_plain(built.soup_vertex.clone()),
            faces: unless_plain(of_triangles(&built.mesh, faces(soup, built))),
        }
    }

    /// The vertices that the file gives these numbers: all copies of one that was split.
    fn vertices_of(&self, numbers: &[u32]) -> Result<Vec<u32>, AppError> {
        let mut copies: BTreeMap<u32, Vec<u32>> = BTreeMap::new();
        for (&n, v) in self.vertices.iter().flat_map(|all| &all.0).zip(0..) {
            copies.entry(n).or_default().push(v);
        }
        let mut found = Vec::new();
        for &number in numbers {
            let n = number.checked_sub(self.first);
            match n.and_then(|n| copies.get(&n)) {
                Some(all) => found.extend(all),
                // A number past the last is refused by what reads the selection.
                None if self.vertices.is_none() && n.is_some() => found.extend(n),
                None => {
                    let first = self.first;
                    return Err(AppError::BadSelection { number, first });
                }
            }
        }
        Ok(found)
    }

    /// Of a surface that is no longer the file's: its own faces, as a file would have them.
    pub(super) fn plain(&self, polygons: &HalfedgeMesh) -> Self {
        let own = (0..polygons.n_faces() as u32).collect();
        Self {
            first: self.first,
            vertices: None,
            faces: unless_plain(of_triangles(polygons, own)),
        }
    }
}

impl Session {
    /// The vertices that the file gives these numbers.
    ///
    /// # Errors
    /// [`Fault::no_mesh`]; a number that none has.
    pub fn numbered(&self, numbers: &[u32]) -> Result<Vec<u32>, Fault> {
        let document = &self.runner()?.document;
        Ok(document.numbers.vertices_of(numbers)?)
    }
}

/// For each triangle that faces are cut into, the number of its face.
fn of_triangles(polygons: &HalfedgeMesh, numbers: Vec<u32>) -> Vec<u32> {
    let pieces = |f| polygons.face_vertices(f).count() - 2;
    let all = polygons.faces().zip(numbers);
    all.flat_map(|(f, number)| std::iter::repeat_n(number, pieces(f)))
        .collect()
}

/// The file's face that each face is: the builder leaves some out, and keeps the order.
fn faces(soup: &PolygonSoup, built: &Built) -> Vec<u32> {
    let sorted = |corners: &mut Vec<u32>| {
        corners.sort_unstable();
        corners.dedup();
    };
    let (mut own, mut other) = (Vec::new(), Vec::new());
    let mut next = 0;
    let is_whole = built.mesh.n_faces() == soup.n_faces();
    let of_file = |f: crate::mesh::Face| {
        if is_whole {
            return f.0;
        }
        own.clear();
        let vertices = built.mesh.face_vertices(f);
        own.extend(vertices.map(|v| built.soup_vertex[v.index()]));
        sorted(&mut own);
        let found = (next..soup.n_faces()).find(|&g| {
            other.clear();
            other.extend_from_slice(soup.face(g));
            sorted(&mut other);
            own == other
        });
        next = found.map_or(next, |g| g + 1);
        found.map_or(f.0, |g| g as u32)
    };
    built.mesh.faces().map(of_file).collect()
}
