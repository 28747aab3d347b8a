//! The part of a run that one flow led on one mesh: its options and the surface it began from.

use crate::flow::options::FlowOptions;
use crate::mesh::HalfedgeMesh;
use glam::DVec3;
use std::rc::Rc;

/// A flow as it was started; the snapshots it led through share it.
#[derive(Debug, Default)]
pub(super) struct Segment {
    pub(super) options: FlowOptions,
    /// No other of the same mesh has it.
    pub(super) number: u32,
    /// The step from which it goes.
    pub(super) from: usize,
    /// What it started from, a quantity of which it may keep; `None` is the mesh itself.
    pub(super) start: Option<Vec<DVec3>>,
    /// The mesh that a pass of remeshing made; `None` is that of the document.
    pub(super) mesh: Option<Rc<HalfedgeMesh>>,
    /// Whether that pass began it.
    pub(super) is_pass: bool,
}

impl Segment {
    /// What it takes to keep it, without its options.
    pub(super) fn bytes(&self) -> usize {
        let start = self.start.as_deref().unwrap_or_default();
        let mesh = self.mesh.as_ref().map_or(0, |mesh| mesh.bytes());
        size_of_val(start) + mesh
    }
}
