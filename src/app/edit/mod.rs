//! Edits: what makes another mesh of the one at hand, and the way back from it.

pub(super) mod fill;
pub(super) mod flip;
pub(super) mod invert;
pub(super) mod options;
pub(super) mod remesh;
pub(super) mod repair;
pub(super) mod subdivide;

use super::document::Document;
use super::fault::Fault;
use super::halves::OtherHalf;
use super::message::AppError;
use super::provenance::Edit;
use super::runner::{Runner, Suspended};
use super::{Loaded, Session};
use crate::flow::options::FlowOptions;
use crate::interrupt;
use crate::mesh::HalfedgeMesh;
use std::rc::Rc;

/// Edits that can be undone.
const MAX_EDITS: usize = 8;

/// What was there before each edit, oldest first, with the other half of a film.
#[derive(Default)]
pub(super) struct Edits(Vec<(Suspended, OtherHalf)>);

impl Edits {
    pub(super) fn push(&mut self, before: (Suspended, OtherHalf)) {
        if self.0.len() == MAX_EDITS {
            self.0.remove(0);
        }
        self.0.push(before);
    }

    /// Forgets all of them, as the mesh is another.
    pub(super) fn clear(&mut self) {
        self.0.clear();
    }
}

impl Runner {
    /// The surface as it is now, as a document of its own.
    pub(super) fn present(&self) -> Document {
        let mut document = self.document.clone();
        document.start.clone_from(&self.x);
        let flow = self.engine.as_ref();
        if flow.is_some_and(|flow| flow.flips().is_some()) {
            let mesh = Rc::new(HalfedgeMesh::clone(self.triangles()));
            document.polygons = Rc::clone(&mesh);
            document.triangles = mesh;
        } else if let Some(remade) = &self.segment.remade {
            let mesh = &remade.mesh;
            document.polygons = Rc::clone(mesh);
            document.triangles = Rc::clone(mesh);
            document.colours = remade.colours.clone();
            document.lineage = Rc::clone(&remade.lineage);
            document.numbers = document.numbers.plain(mesh);
        }
        document
    }
}

impl Session {
    /// Replaces the mesh by an edited one; on a failure, or [given up](interrupt), nothing has changed. The flow's
    /// options stay, less a selection of vertices that `edit` has one of its own for.
    pub(super) fn edit<T>(
        &mut self,
        name: Edit,
        edit: impl FnOnce(&Runner) -> Result<(Document, T), Fault>,
    ) -> Result<T, Fault> {
        let (mut document, outcome) = edit(self.runner()?)?;
        interrupt::commit()?;
        if !matches!(name, Edit::Repair(_)) {
            document.repaired.clear();
        }
        let Some(before) = self.runner.take() else {
            return Err(Fault::no_mesh());
        };
        let mut options = before.options().clone();
        if document.free.is_some() || document.fixed.is_some() {
            options = FlowOptions {
                free: None,
                fixed: None,
                ..options
            };
        }
        let x = document.start.clone();
        let mut runner = Runner::new(document, x);
        runner.begin_segment(options);
        runner.arrangement = before.arrangement;
        runner.crosses = before.crosses;
        runner.origin = before.origin_of(name);
        self.runner = Some(runner);
        let other_half = std::mem::take(&mut self.other_half);
        self.edits.push((before.suspend(), other_half));
        self.panes.clear();
        Ok(outcome)
    }

    /// Makes the surface as it is now, connectivity and positions, the start of what comes.
    /// [`undo_edit`](Self::undo_edit) undoes it.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn adopt(&mut self) -> Result<Loaded, Fault> {
        self.edit(Edit::Adopt, |runner| Ok((runner.present(), ())))?;
        self.loaded()
    }

    /// Whether there is an edit to undo.
    pub fn can_undo_edit(&self) -> bool {
        !self.edits.0.is_empty()
    }

    /// Undoes the last edit, a fill, a repair, edge flips, an inversion or a surface that was kept: mesh,
    /// positions, flow, history and reports are those before it, bit for bit.
    ///
    /// # Errors
    /// `NothingToUndo`.
    pub fn undo_edit(&mut self) -> Result<Loaded, Fault> {
        let Some((before, other_half)) = self.edits.0.pop() else {
            return Err(AppError::NothingToUndo.into());
        };
        self.runner = Some(before.resume());
        self.other_half = other_half;
        self.settle_panes();
        self.loaded()
    }
}
