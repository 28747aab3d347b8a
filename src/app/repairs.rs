//! What a repair changes, kind by kind: before it is done, and after.

use crate::arrays::TypedArray;
use crate::mesh::{self, Built, HalfedgeMesh, MeshError};
use crate::message::Message;
use crate::remesh::repair::{Change, Repaired, Weld, gap, is_suspect, repair};
use crate::soup::PolygonSoup;
use glam::DVec3;
use serde::Serialize;
use std::cell::RefCell;
use std::collections::HashMap;
use std::rc::Rc;

/// Vertices that are listed of one kind of change, at most.
const MAX_PLACES: usize = 1000;

/// A kind of change that a repair makes, or has made.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct RepairItem {
    /// Noun of what is changed.
    pub kind: &'static str,
    /// How often.
    pub count: usize,
    /// The same to be said.
    pub message: Message,
    /// Vertices of the surface at which it is, of many only some.
    pub vertices: TypedArray<u32>,
    /// Whether that was safe, and so done when the file was opened.
    pub done: bool,
}

impl RepairItem {
    fn new(change: Change, vertices: Vec<u32>, done: bool) -> Self {
        let mut vertices = vertices;
        vertices.truncate(MAX_PLACES);
        Self {
            kind: change.kind,
            count: change.count,
            message: change.message,
            vertices: vertices.into(),
            done,
        }
    }

    /// What was done when a file was opened.
    pub(super) fn opened(built: &Built) -> Vec<Self> {
        let n_faces = built.mesh.n_faces();
        let changes = built.repairs.iter();
        let changes = changes.filter_map(|repair| Change::built(repair, n_faces));
        let places = Places::of(&built.soup_vertex);
        changes
            .map(|change| {
                let vertices = places.now(&change.vertices);
                Self::new(change, vertices, true)
            })
            .collect()
    }
}

/// Where the vertices that there were are now.
struct Places(HashMap<u32, u32>);

impl Places {
    fn of(were: &[u32]) -> Self {
        // Of several copies the first.
        Self(
            were.iter()
                .copied()
                .zip(0..)
                .collect::<Vec<_>>()
                .into_iter()
                .rev()
                .collect(),
        )
    }

    fn now(&self, were: &[u32]) -> Vec<u32> {
        let all = were.iter().filter_map(|v| self.0.get(v).copied());
        all.collect()
    }
}

/// A soup that was repaired and is a surface.
pub(super) struct Mended {
    pub(super) built: Built,
    pub(super) items: Vec<RepairItem>,
    /// For each vertex the one that it was.
    pub(super) were: Vec<u32>,
}

/// Repairs a soup and makes a surface of it.
pub(super) fn mend(soup: &PolygonSoup, weld: Weld) -> Result<Mended, MeshError> {
    let Repaired {
        soup,
        origin,
        changes,
    } = repair(soup, weld);
    let built = mesh::build(&soup)?;
    let were: Vec<u32> = built
        .soup_vertex
        .iter()
        .map(|&v| origin[v as usize])
        .collect();
    let n_faces = built.mesh.n_faces();
    let after = built.repairs.iter();
    let after = after.filter_map(|repair| Change::built(repair, n_faces));
    let after = after.map(|change| Change {
        vertices: change
            .vertices
            .iter()
            .map(|&v| origin[v as usize])
            .collect(),
        ..change
    });
    let places = Places::of(&were);
    let items = changes.into_iter().chain(after).map(|change| {
        let vertices = places.now(&change.vertices);
        RepairItem::new(change, vertices, false)
    });
    let items = items.collect();
    Ok(Mended { built, items, were })
}

/// What the usual repair makes of a surface, kept for when it is asked for.
#[derive(Clone, Default)]
pub(super) struct Memo(Rc<RefCell<Option<Known>>>);

struct Known {
    mesh: Rc<HalfedgeMesh>,
    x: Vec<DVec3>,
    mended: Mended,
}

deferred! {
    fn mended(mesh: &HalfedgeMesh, x: &[DVec3]) -> Result<Mended, MeshError> {
        mend(&mesh.to_soup(x), Weld::Auto)
    }
}

impl Memo {
    /// A surface, repaired; taken from here if it is known.
    pub(super) fn take(&self, mesh: &Rc<HalfedgeMesh>, x: &[DVec3]) -> Result<Mended, MeshError> {
        let known = self.0.take();
        match known.filter(|known| Rc::ptr_eq(&known.mesh, mesh) && known.x == x) {
            Some(known) => Ok(known.mended),
            None => mended(mesh, x),
        }
    }

    fn keep(&self, mesh: &Rc<HalfedgeMesh>, x: &[DVec3], mended: Mended) {
        let (mesh, x) = (Rc::clone(mesh), x.to_vec());
        self.0.replace(Some(Known { mesh, x, mended }));
    }
}

/// What a repair of a surface would change, its vertices those of the surface as it is.
pub(super) fn preview(memo: &Memo, mesh: &Rc<HalfedgeMesh>, x: &[DVec3]) -> Vec<RepairItem> {
    if !is_suspect(mesh, x, Weld::Auto) {
        return Vec::new();
    }
    let Ok(mended) = memo.take(mesh, x) else {
        return Vec::new();
    };
    let mut items = mended.items.clone();
    for v in items.iter_mut().flat_map(|item| &mut item.vertices.0) {
        *v = mended.were[*v as usize];
    }
    memo.keep(mesh, x, mended);
    items
}

/// A length within which a weld closes what the usual repair leaves open.
pub(super) fn gap_left(memo: &Memo, mesh: &Rc<HalfedgeMesh>, x: &[DVec3]) -> Option<f64> {
    let known = memo.0.borrow();
    let known = known.as_ref();
    match known.filter(|known| Rc::ptr_eq(&known.mesh, mesh) && known.x == x) {
        Some(Known { mended, .. }) => gap(&mended.built.mesh, &mended.built.positions),
        None => gap(mesh, x),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::build;

    #[test]
    fn a_repair_that_was_told_is_made_once_and_only_of_the_same_surface() {
        let x = [[0., 0.], [1., 0.], [0., 1.], [1., 0.], [0., 1.], [1., 1.]];
        let x = x.map(|[a, b]| DVec3::new(a, b, 0.0)).to_vec();
        let soup = PolygonSoup::from_faces(x.clone(), &[[0, 1, 2], [3, 5, 4]]);
        let mesh = Rc::new(build(&soup).expect("a surface").mesh);
        let memo = Memo::default();
        let items = preview(&memo, &mesh, &x);
        assert_eq!((items[0].kind, items[0].count), ("Welded", 2));
        assert!(memo.0.borrow().is_some());
        let known = memo.take(&mesh, &x).expect("repaired");
        assert_eq!(known.items[0].count, 2);
        assert!(memo.0.borrow().is_none());
        // Of the surface that has moved, what was told is not true.
        preview(&memo, &mesh, &x);
        let mut moved = x.clone();
        moved[5].z = 7.0;
        let other = memo.take(&mesh, &moved).expect("repaired");
        assert!(other.built.positions.contains(&moved[5]));
        preview(&memo, &mesh, &x);
        let same = Rc::new(HalfedgeMesh::clone(&mesh));
        assert!(
            memo.take(&same, &moved)
                .expect("repaired")
                .built
                .positions
                .contains(&moved[5])
        );
    }
}
