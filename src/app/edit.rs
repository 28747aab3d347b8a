//! Edits: what makes another mesh of the one at hand, and the way back from it.

use super::document::Document;
use super::fault::Fault;
use super::message::AppError;
use super::recipe::Edit;
use super::work::{Suspended, Work};
use super::{Loaded, Session};
use crate::flow::options::FlowOptions;
use crate::mesh::HalfedgeMesh;
use std::rc::Rc;

/// Edits that can be undone.
const MAX_EDITS: usize = 8;

/// What was there before each edit, oldest first.
#[derive(Default)]
pub(super) struct Edits(Vec<Suspended>);

impl Edits {
    fn push(&mut self, before: Suspended) {
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

impl Work {
    /// The surface as it is now, as a document of its own.
    pub(super) fn present(&self) -> Document {
        let mut document = self.document.clone();
        document.start.clone_from(&self.x);
        let flow = self.flow.as_ref();
        if flow.is_some_and(|flow| flow.flips().is_some()) {
            let mesh = Rc::new(HalfedgeMesh::clone(self.triangles()));
            document.polygons = Rc::clone(&mesh);
            document.triangles = mesh;
        }
        document
    }
}

impl Session {
    /// Replaces the mesh by an edited one; on a failure nothing has changed. The flow's
    /// options stay, less a selection of vertices that `edit` has one of its own for.
    pub(super) fn edit<T>(
        &mut self,
        name: Edit,
        edit: impl FnOnce(&Work) -> Result<(Document, T), Fault>,
    ) -> Result<T, Fault> {
        let (document, outcome) = edit(self.work()?)?;
        let Some(before) = self.work.take() else {
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
        let mut work = Work::new(document, x);
        work.begin_course(options);
        work.arrangement = before.arrangement;
        work.origin = before.origin_of(name);
        self.work = Some(work);
        self.edits.push(before.suspend());
        Ok(outcome)
    }

    /// Makes the surface as it is now, connectivity and positions, the start of what comes.
    /// [`undo_edit`](Self::undo_edit) undoes it.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn adopt(&mut self) -> Result<Loaded, Fault> {
        self.edit(Edit::Adopt, |work| Ok((work.present(), ())))?;
        self.loaded()
    }

    /// Whether there is an edit to undo.
    pub fn can_undo_edit(&self) -> bool {
        !self.edits.0.is_empty()
    }

    /// Undoes the last edit, a fill, edge flips, an inversion or a surface that was kept: mesh, positions,
    /// flow, history and reports are those before it, bit for bit.
    ///
    /// # Errors
    /// `NothingToUndo`.
    pub fn undo_edit(&mut self) -> Result<Loaded, Fault> {
        let Some(before) = self.edits.0.pop() else {
            return Err(AppError::NothingToUndo.into());
        };
        self.work = Some(before.resume(self.progress.clone()));
        self.loaded()
    }
}
