//! The part of a run that one flow led: its options and the surface it began from.

use crate::flow::options::FlowOptions;
use glam::DVec3;

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
}
