//! Flows beside each other: the same surface under the other flows by mean curvature and its
//! derivatives, step by step (Xu & Zhang, figures 5.5 and 5.6).

use super::as_f32;
use super::field::FieldName;
use super::pane::Pane;
use super::work::Work;
use crate::arrays::TypedArray;
use crate::energy::curvature_jump::{CurvatureJump, curvature_jump};
use crate::flow::Status;
use crate::flow::options::{FlowName, FlowOptions};
use crate::flow::spec::{self, Family};
use crate::message::Message;
use serde::Serialize;

/// Steps that the others still take after the chosen flow has come to rest.
const FURTHER: usize = 60;

/// Where a flow beside others stands.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Standing {
    /// Steps taken.
    pub step: usize,
    /// Whether it is over.
    pub status: Status,
    /// Why.
    pub message: Option<Message>,
    /// The jump of H across the boundary of what moves.
    pub jump: Option<CurvatureJump>,
}

/// Whether a flow can stand beside others.
fn has_others(flow: FlowName) -> bool {
    spec::of(flow).family == Family::Curvature
}

impl Work {
    /// Starts the other flows and lets them catch up, or ends them.
    pub(super) fn run_beside(&mut self, wanted: bool) {
        if !wanted || !has_others(self.options().flow) || self.flow.is_none() {
            self.beside.clear();
            return;
        }
        if !self.beside.is_empty() {
            return;
        }
        let own = self.options().flow;
        for flow in FlowName::all().filter(|flow| *flow != own && has_others(*flow)) {
            let mut other = Self::new(self.document.clone(), self.document.start.clone());
            let options = FlowOptions {
                boundary: self.options().boundary,
                ..self.options().with_flow(flow)
            };
            // What the chosen flow takes, the others take.
            if other.configure(options, None).is_ok() {
                other.step_to(self.state.step);
                self.beside.push(other);
            }
        }
    }

    fn step_to(&mut self, step: usize) {
        while self.state.step < step && !self.state.status.is_final() {
            // A failure ends it, and its standing says so.
            if !matches!(self.step(), Ok(Some(_))) {
                break;
            }
        }
    }

    /// The step that the others are to come to: to their rest when this flow is at its own.
    fn goal_beside(&self) -> usize {
        let is_over = self.state.status.is_final();
        self.state.step + if is_over { FURTHER } else { 0 }
    }

    /// Takes the others along after a step.
    pub(super) fn step_beside(&mut self) {
        let goal = self.goal_beside();
        self.beside.iter_mut().for_each(|other| other.step_to(goal));
    }

    /// Takes the others to where this flow is now.
    pub(super) fn seek_beside(&mut self) {
        let goal = self.goal_beside();
        for other in &mut self.beside {
            other.seek(goal);
            other.step_to(goal);
        }
    }

    /// The jump of H across the boundary of what moves.
    pub(super) fn curvature_jump(&self) -> Option<CurvatureJump> {
        let flow = self.flow.as_ref()?;
        let mesh = self.triangles();
        let free: Vec<bool> = (0..self.x.len()).map(|v| flow.is_free(v)).collect();
        if mesh.is_oriented() {
            curvature_jump(mesh, &self.x, &free)
        } else {
            None
        }
    }

    /// The pictures of flows beside each other; none where there is one only.
    pub(super) fn flow_panes(&self, field: Option<FieldName>) -> Vec<Pane> {
        if self.beside.is_empty() {
            return Vec::new();
        }
        let works = || std::iter::once(self).chain(&self.beside);
        let pane = |name: &'static str, work: &Self| Pane {
            name,
            standing: Some(Standing {
                step: work.state.step,
                status: work.state.status,
                message: work.state.message.clone(),
                jump: work.curvature_jump(),
            }),
            positions: as_f32(&work.x).into(),
            triangles: work.document.triangles.triangle_indices().into(),
            wire_edges: work.document.polygons.edge_indices(false).into(),
            boundary_edges: work.document.polygons.edge_indices(true).into(),
            highlight: TypedArray::default(),
            field: field.and_then(|f| work.field(f).ok()),
        };
        // In the order of the paper, whichever was chosen.
        let mut panes: Vec<Pane> = FlowName::all()
            .flat_map(|flow| {
                works()
                    .filter(move |work| work.options().flow == flow)
                    .map(move |work| pane(flow.id(), work))
            })
            .collect();
        // That of the chosen flow: where another breaks, it may go out of the scale.
        let range = panes
            .iter()
            .find(|pane| pane.name == self.options().flow.id())
            .and_then(|pane| pane.field.as_ref().map(|f| (f.low, f.high)));
        for field in panes.iter_mut().filter_map(|pane| pane.field.as_mut()) {
            (field.low, field.high) = range.unwrap_or((field.low, field.high));
        }
        panes
    }
}
