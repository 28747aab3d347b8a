//! Edits: what makes another mesh of the one at hand, and the way back from it.

use super::document::Document;
use super::fault::Fault;
use super::work::Work;
use super::{Loaded, Session};
use crate::mesh::HalfedgeMesh;
use std::rc::Rc;

/// Edits that can be undone; each keeps the positions of its mesh.
const MAX_EARLIER: usize = 20;

impl Work {
    /// Puts another document in place; the one before can be had again.
    pub(super) fn replace(&mut self, document: Document) {
        let before = std::mem::replace(&mut self.document, document);
        self.earlier.push(before);
        if self.earlier.len() > MAX_EARLIER {
            self.earlier.remove(0);
        }
        self.restart(self.document.start.clone());
    }

    /// The surface as it is now, as a document of its own.
    pub(super) fn present(&self) -> Document {
        let mut document = self.document.clone();
        document.start.clone_from(&self.x);
        if self
            .flow
            .as_ref()
            .is_some_and(|flow| flow.flips().is_some())
        {
            let mesh = Rc::new(HalfedgeMesh::clone(self.triangles()));
            document.polygons = Rc::clone(&mesh);
            document.triangles = mesh;
        }
        document
    }
}

impl Session {
    /// Makes the surface as it is now, connectivity and positions, the start of what comes.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn adopt(&mut self) -> Result<Loaded, Fault> {
        let work = self.work_mut()?;
        work.replace(work.present());
        Ok(Loaded::of(&work.document))
    }

    /// Takes the last edit back: [`adopt`](Self::adopt), or whatever else made another mesh.
    ///
    /// # Errors
    /// If there is none.
    pub fn undo(&mut self) -> Result<Loaded, Fault> {
        let work = self.work_mut()?;
        let Some(document) = work.earlier.pop() else {
            let hint = "Open the mesh again to begin anew.";
            return Err(Fault::new(
                "NothingToUndo",
                "there is no edit to undo",
                hint,
            ));
        };
        work.document = document;
        work.restart(work.document.start.clone());
        Ok(Loaded::of(&work.document))
    }
}
