//! What every diagnosis looks at, and the remedies that this surface and flow allow.

use super::remedy::Remedy;
use super::stop::WINDOW;
use crate::app::repairs::preview;
use crate::app::runner::Runner;
use crate::flow::StepReport;
use crate::flow::constraint::Kept;
use crate::flow::option::Options;
use crate::flow::options::{FlowOptions, Scheme};
use crate::flow::refusal::farthest;
use crate::remesh::Mode;

/// A mesh of more vertices is not the one to be subdivided without being asked.
const FEW: usize = 50_000;

impl Runner {
    pub(super) fn last(&self) -> Option<&StepReport> {
        self.segment_reports().last()
    }

    pub(super) fn recent(&self) -> &[StepReport] {
        let reports = self.segment_reports();
        &reports[reports.len().saturating_sub(WINDOW)..]
    }

    /// What the flow's system runs with.
    pub(super) fn settled(&self) -> FlowOptions {
        self.options().settled()
    }

    /// Whether the flow reads the option of that name.
    fn reads(&self, name: &str) -> bool {
        let mut rows = FlowOptions::ROWS.iter();
        rows.any(|row| row.name == name && row.read_by.flows.contains(&self.options().flow))
    }

    pub(super) fn is_paper(&self) -> bool {
        self.options().scheme == Scheme::Paper
    }

    /// Whether conformal regularisation takes this surface, and what it is called with.
    pub(super) fn can_regularise(&self) -> Option<Remedy> {
        let mesh = &self.document.polygons;
        (mesh.is_closed() && mesh.is_oriented()).then(Remedy::regularise)
    }

    /// Repair of the surface as it is, where that would change anything.
    pub(super) fn can_repair(&self) -> Option<Remedy> {
        let changes = preview(&self.document.mended, &self.document.polygons, &self.x);
        (!changes.is_empty()).then(Remedy::repair)
    }

    /// The flow's own regularisation, where it has one, that is off, and no passes of remeshing
    /// stand in its place.
    pub(super) fn can_regularise_each_step(&self) -> Option<Remedy> {
        let is_off = self.reads("regularise") && self.options().regularise == Mode::Off;
        let off = is_off && self.passes().is_none();
        off.then(|| Remedy::regularise_each_step().anew())
    }

    /// Whether the present surface can be the start of a finer one.
    pub(super) fn can_subdivide(&self) -> Option<Remedy> {
        let whole = self.options().free.is_none() && self.options().fixed.is_none();
        (whole && self.x.len() < FEW).then(Remedy::subdivide)
    }

    /// Whether nothing is held.
    pub(super) fn is_all_free(&self) -> bool {
        let flow = self.engine.as_ref();
        flow.is_some_and(|flow| flow.n_free() == self.x.len())
    }

    pub(super) fn can_flip(&self) -> Option<Remedy> {
        self.document.polygons.is_triangular().then(Remedy::flips)
    }

    /// As far back as helps, where there is a way back.
    pub(super) fn can_go_back(&self) -> Option<Remedy> {
        let steps = self.history.reports().len().min(WINDOW / 2);
        (self.state.can_step_back && steps > 0).then(|| Remedy::back(steps))
    }

    /// A kept quantity more, where there is a choice.
    pub(super) fn can_keep(&self, wanted: &[Kept]) -> Option<Remedy> {
        let kept = &self.options().keep;
        let helps = wanted.iter().any(|one| !kept.contains(one));
        (self.reads("keep") && helps).then(|| Remedy::keep(wanted).anew())
    }

    /// The vertex that the last step moved most, and by how much.
    pub(super) fn last_move(&self) -> Option<(u32, f64)> {
        let before = self.history.last()?.x.as_ref()?;
        Some(farthest(before, &self.x, |_| 1.0))
    }

    pub(super) fn h(&self) -> f64 {
        let flow = self.engine.as_ref();
        flow.map_or(1.0, |flow| flow.mean_edge_length())
    }
}
