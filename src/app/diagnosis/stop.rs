//! What can be the matter with steps: too long, refused, too many.

use super::elements;
use super::remedy::Remedy;
use super::{Diagnosis, Symptom};
use crate::app::engine::Engine;
use crate::app::runner::Runner;
use crate::flow::spec::FlowName;
use crate::flow::{FlowError, Status, StepReport, Warning};
use crate::message::Say;

/// An energy above the least of the last steps by more than this share has risen.
const RISEN: f64 = 0.05;
/// Steps that are looked back at.
pub(super) const WINDOW: usize = 10;
/// ε that lets edges stay along lines of curvature, and one that never sticks.
const SMOOTH: [f64; 2] = [0.01, 0.1];
/// An update of so many edges after as many steps is of a flow that does not come to rest.
const LOST: f64 = 2.0;

/// Times that a step was halved for a definite matrix.
fn halvings(report: &StepReport) -> usize {
    let of = |warning: &Warning| match warning {
        Warning::HalvedStep { times } => Some(*times),
        _ => None,
    };
    report.warnings.iter().find_map(of).unwrap_or_default()
}

impl Runner {
    pub(super) fn cocircular(&self, flow: &Engine) -> Option<Diagnosis> {
        let at_start = self.state.status == Status::Stalled && self.segment_reports().is_empty();
        if !at_start || self.options().flow != FlowName::Circle {
            return None;
        }
        let edges = elements::cocircular_edges(self.triangles(), &self.x, |v| flow.is_free(v));
        if edges.is_empty() {
            return None;
        }
        let epsilon = self.options().epsilon;
        let symptom = Symptom::CocircularKink {
            count: edges.len() / 2,
            epsilon,
        };
        let larger = SMOOTH.into_iter().find(|&one| epsilon < one);
        let is_patch = self.options().free.is_some() && !self.options().prefill;
        // Where all quadrilaterals are planar that is a local minimum of this energy, but not of
        // the smooth one: a flow that does not go by angles leaves it.
        let mesh = &self.document.polygons;
        let is_closed = mesh.is_closed() && mesh.is_oriented();
        let diagnosis = Diagnosis::new(&symptom).with([
            is_closed.then(|| Remedy::other_flow(FlowName::PWillmore)),
            larger.map(Remedy::larger_epsilon),
            is_patch.then(Remedy::prefill),
        ]);
        Some(Diagnosis {
            edges: edges.into(),
            ..diagnosis
        })
    }

    /// Only the paper's schemes take steps that do not descend.
    pub(super) fn rising(&self) -> Option<Diagnosis> {
        let last = self.last()?;
        let non_finite = matches!(self.failure, Some(FlowError::NonFiniteEnergy { .. }))
            && self.state.status == Status::Failed;
        let energies = self.recent().iter();
        let energies = energies.flat_map(|report| [report.objective_before, report.energy]);
        let least = energies.fold(f64::INFINITY, f64::min);
        let rises = last.energy > (1.0 + RISEN) * least.abs().max(f64::MIN_POSITIVE);
        if !self.is_paper() || !(rises || non_finite) {
            return None;
        }
        let (vertex, moved) = self.last_move()?;
        let symptom = Symptom::RisingEnergy {
            least,
            energy: last.energy,
            tau: last.tau,
            vertex,
            moved: moved / self.h(),
            halved: halvings(last),
        };
        let remedies = [
            Some(Remedy::recommended_scheme().anew()),
            Some(Remedy::smaller_step(last.tau).anew()),
            self.can_go_back(),
        ];
        let diagnosis = Diagnosis::new(&symptom).at_vertices([vertex]);
        Some(diagnosis.with(remedies))
    }

    pub(super) fn failed(&self) -> Option<Diagnosis> {
        let failure = self.failure.as_ref();
        match failure.filter(|_| self.state.status == Status::Failed)? {
            FlowError::Unfit { vertex } => {
                let vertex = *vertex;
                let circle = Remedy::other_flow(FlowName::Circle).anew();
                let remedies = [
                    self.can_repair(),
                    Some(circle),
                    self.can_regularise(),
                    self.can_go_back(),
                ];
                let diagnosis = Diagnosis::new(&Symptom::Unfit { vertex }).at_vertices([vertex]);
                Some(diagnosis.with(remedies))
            }
            _ => None,
        }
    }

    pub(super) fn too_rough(&self) -> Option<Diagnosis> {
        let p = self.options().p;
        let stalled = self.state.status == Status::Stalled;
        if self.options().flow == FlowName::PWillmore && p > 2.0 && stalled {
            let (mesh, x) = (self.triangles(), &self.x);
            let vertex = elements::most_curved(mesh, x)?;
            let diagnosis =
                Diagnosis::new(&Symptom::LargeExponent { p, vertex }).at_vertices([vertex]);
            return Some(diagnosis.with([Some(Remedy::exponent(2.0)), self.can_regularise()]));
        }
        let update = self.last()?.update.filter(|update| *update > LOST)?;
        let is_long = self.segment_reports().len() > 2 * WINDOW;
        let waits = self.options().flow == FlowName::Mmcv && (is_long || stalled);
        let (vertex, _) = self.last_move().filter(|_| waits)?;
        let symptom = Symptom::TooRough {
            steps: self.state.step,
            update,
            vertex,
        };
        let remedies = [
            (!self.options().prefill && self.options().free.is_some())
                .then(|| Remedy::prefill().anew()),
            self.can_regularise()
                .map(|_| Remedy::regularise_and_diffuse().anew()),
            Some(Remedy::other_flow(FlowName::SurfaceDiffusion).anew()),
        ];
        let diagnosis = Diagnosis::new(&symptom).at_vertices([vertex]);
        Some(diagnosis.with(remedies))
    }

    pub(super) fn refused(&self, flow: &Engine) -> Option<Diagnosis> {
        let refusal = flow.refusal()?;
        let diagnosis = Diagnosis::new(&Symptom::RefusedSteps {
            cause: refusal.cause.kind(),
            vertex: refusal.vertex,
            face: refusal.face,
        });
        let diagnosis = match refusal.face {
            Some(face) if self.document.polygons.is_triangular() => diagnosis.at_faces([face]),
            _ => diagnosis.at_vertices([refusal.vertex]),
        };
        let remedies = [
            (self.settled().keep.len() > 1).then(Remedy::release_area),
            self.can_regularise(),
            self.can_go_back(),
        ];
        Some(diagnosis.with(remedies))
    }

    pub(super) fn step_limit(&self) -> Option<Diagnosis> {
        let last = self.last()?;
        let (vertex, _) = self.last_move()?;
        let fall = (last.objective_before - last.objective) / last.objective_before.abs();
        let (steps, percent) = (self.state.step, 100.0 * fall);
        let symptom = if fall > 0.0 {
            Symptom::StepLimit {
                steps,
                percent,
                vertex,
            }
        } else {
            Symptom::NotAtRest { steps, vertex }
        };
        let diagnosis = Diagnosis::new(&symptom).at_vertices([vertex]);
        let fixed = self.options().tau.is_some() || self.options().dt.is_some();
        let automatic = (fixed && !self.is_paper()).then(Remedy::automatic_step);
        Some(diagnosis.with([Some(Remedy::go_on()), automatic]))
    }

    /// Only the paper's schemes halve a step without a trial of it.
    pub(super) fn halved(&self) -> Option<Diagnosis> {
        let last = self.last().filter(|last| halvings(last) > 0)?;
        let (vertex, _) = self.last_move()?;
        let symptom = Symptom::HalvedStep {
            step: last.step,
            count: halvings(last),
            tau: last.tau,
        };
        let remedies = [Remedy::go_on(), Remedy::recommended_scheme().anew()];
        let diagnosis = Diagnosis::new(&symptom).at_vertices([vertex]);
        Some(diagnosis.with(remedies.map(Some)))
    }

    pub(super) fn rejected(&self, flow: &Engine) -> Option<Diagnosis> {
        let last = self.last().filter(|last| last.rejected > 0)?;
        let vertex = flow.refusal()?.vertex;
        let symptom = Symptom::RejectedSteps {
            step: last.step,
            count: last.rejected,
            tau: last.tau,
            vertex,
        };
        let diagnosis = Diagnosis::new(&symptom).at_vertices([vertex]);
        Some(diagnosis.with([Some(Remedy::go_on())]))
    }
}
