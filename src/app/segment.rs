//! The part of a run that one flow led on one mesh: its options and the surface it began from.

use super::colours::Colours;
use super::lineage::Lineage;
use crate::flow::options::FlowOptions;
use crate::mesh::HalfedgeMesh;
use glam::DVec3;
use std::rc::Rc;

/// Another mesh than that of the document.
#[derive(Clone, Debug)]
pub(super) struct Remade {
    pub(super) mesh: Rc<HalfedgeMesh>,
    /// What the file gave its vertices.
    pub(super) colours: Colours,
    pub(super) lineage: Rc<Lineage>,
    /// Vertices that a pass aims at.
    pub(super) budget: usize,
}

impl Remade {
    fn bytes(&self) -> usize {
        self.mesh.bytes() + size_of_val(self.colours.list()) + self.lineage.bytes()
    }
}

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
    /// What a pass of remeshing made; `None` is the mesh of the document.
    pub(super) remade: Option<Remade>,
    /// Whether that pass began it.
    pub(super) is_pass: bool,
}

impl Segment {
    /// What it takes to keep it, without its options.
    pub(super) fn bytes(&self) -> usize {
        let start = self.start.as_deref().unwrap_or_default();
        size_of_val(start) + self.remade.as_ref().map_or(0, Remade::bytes)
    }
}
