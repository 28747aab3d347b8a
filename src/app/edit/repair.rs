//! Repair: what keeps a file, or the surface at hand, from being a whole surface.

use super::options::RepairOptions;
use crate::app::document::{Document, triangulated};
use crate::app::fault::Fault;
use crate::app::provenance::{Edit, EditRecord};
use crate::app::runner::Runner;
use crate::app::{Loaded, Session};
use crate::arrays::TypedArray;
use crate::mesh::{self, Built, HalfedgeMesh, MeshError};
use crate::message::Message;
use crate::remesh::repair::{Change, Repaired, Weld, is_suspect, repair};
use crate::soup::PolygonSoup;
use glam::DVec3;
use serde::Serialize;
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
    pub(in crate::app) fn opened(built: &Built) -> Vec<Self> {
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
pub(in crate::app) struct Mended {
    pub(in crate::app) built: Built,
    pub(in crate::app) items: Vec<RepairItem>,
    /// For each vertex the one that it was.
    were: Vec<u32>,
}

/// Repairs a soup and makes a surface of it.
pub(in crate::app) fn mend(soup: &PolygonSoup, weld: Weld) -> Result<Mended, MeshError> {
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

/// What a repair of a surface would change, its vertices those of the surface as it is.
pub(in crate::app) fn preview(mesh: &HalfedgeMesh, x: &[DVec3]) -> Vec<RepairItem> {
    let weld = Weld::Auto;
    if !is_suspect(mesh, x, weld) {
        return Vec::new();
    }
    let mended = mend(&mesh.to_soup(x), weld);
    let Ok(Mended {
        mut items, were, ..
    }) = mended
    else {
        return Vec::new();
    };
    for item in &mut items {
        for v in &mut item.vertices.0 {
            *v = were[*v as usize];
        }
    }
    items
}

impl Runner {
    /// A document of the surface as it is now, repaired; `None` where there is nothing to repair.
    fn repaired(&self, options: RepairOptions) -> Result<Option<Document>, Fault> {
        let document = self.present();
        if !is_suspect(&document.polygons, &self.x, options.weld) {
            return Ok(None);
        }
        let mended = mend(&document.polygons.to_soup(&self.x), options.weld)?;
        let Mended { built, items, were } = mended;
        if items.is_empty() {
            return Ok(None);
        }
        let chosen = |list: &Option<Vec<u32>>| {
            let list = list.as_ref()?;
            let mut is_chosen = vec![false; self.x.len()];
            for &v in list {
                if let Some(is_chosen) = is_chosen.get_mut(v as usize) {
                    *is_chosen = true;
                }
            }
            let now = (0..).zip(&were).filter(|(_, v)| is_chosen[**v as usize]);
            Some(now.map(|(v, _)| v).collect())
        };
        let polygons = Rc::new(built.mesh);
        let mut warnings = document.warnings.clone();
        warnings.extend(items.iter().map(|item| item.message.clone()));
        let repaired = Document {
            triangles: triangulated(&polygons, &built.positions)?,
            polygons,
            start: built.positions,
            free: chosen(&self.options().free),
            fixed: chosen(&self.options().fixed),
            warnings,
            opened: Vec::new(),
            repaired: items,
            ..document
        };
        Ok(Some(repaired.with_shape_warnings()))
    }
}

/// Refusals of a surface that a repair may help against.
const MENDABLE: [&str; 7] = [
    "NotClosed",
    "NotOriented",
    "NotOrientable",
    "ZeroLengthEdge",
    "Unfit",
    "TouchingLoop",
    "NoRoom",
];

impl Session {
    /// A refusal with what a repair of the surface would change, where that may help.
    pub(in crate::app) fn offering(&self, mut fault: Fault) -> Fault {
        if let Some(runner) = &self.runner
            && MENDABLE.contains(&fault.kind)
        {
            fault.repairs = preview(runner.polygons(), &runner.x).into();
        }
        fault
    }

    /// Repairs the surface as it is now, which becomes the start; where there is nothing to repair
    /// nothing changes. [`undo_edit`](Self::undo_edit) undoes it. What was changed stands in
    /// [`Loaded::repaired`].
    ///
    /// # Errors
    /// [`Fault::no_mesh`]; where no face is left.
    pub fn repair(&mut self, options: RepairOptions) -> Result<Loaded, Fault> {
        match self.runner()?.repaired(options)? {
            Some(document) => self.edit(Edit::Repair(options), |_| Ok((document, ())))?,
            None => self.runner_mut()?.document.repaired.clear(),
        }
        self.loaded()
    }

    /// Loads a mesh file and repairs it; it need not be a surface.
    /// [`undo_edit`](Self::undo_edit) takes the repair of one that is back.
    ///
    /// # Errors
    /// As [`load`](Self::load), less what a repair helps against; the mesh loaded before stays.
    pub fn load_repaired(
        &mut self,
        bytes: &[u8],
        file_name: &str,
        options: RepairOptions,
    ) -> Result<Loaded, Fault> {
        match Document::from_file(bytes, file_name) {
            Ok(document) => {
                let opened = document.opened.clone();
                self.open(document)?;
                self.repair(options)?;
                let runner = self.runner_mut()?;
                runner.document.repaired.splice(0..0, opened);
            }
            Err(fault) if fault.repairs.is_empty() => return Err(fault),
            Err(_) => {
                let document = Document::from_broken_file(bytes, file_name, options.weld)?;
                self.open(document)?;
                self.runner_mut()?.origin = Some(vec![EditRecord {
                    flow: None,
                    path: Vec::new(),
                    edit: Edit::Repair(options),
                }]);
            }
        }
        self.loaded()
    }
}
