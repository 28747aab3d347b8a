//! What can be the matter with steps: too long, refused, too many.

use super::elements;
use super::remedy::Remedy;
use super::text::{Text, number};
use super::{Diagnosis, DiagnosisKind};
use crate::app::engine::Engine;
use crate::app::work::Work;
use crate::flow::options::FlowName;
use crate::flow::refusal::Cause;
use crate::flow::{FlowError, Status};

/// An energy above the least of the last steps by more than this share has risen.
const RISEN: f64 = 0.05;
/// Steps that are looked back at.
pub(super) const WINDOW: usize = 10;
/// ε that lets edges stay along lines of curvature, and one that never sticks.
const SMOOTH: [f64; 2] = [0.01, 0.1];
/// An update of so many edges after as many steps is of a flow that does not come to rest.
const LOST: f64 = 2.0;

impl Work {
    pub(super) fn cocircular(&self, flow: &Engine) -> Option<Diagnosis> {
        let at_start = self.state.status == Status::Stalled && self.course_reports().is_empty();
        if !at_start || self.options().flow != FlowName::Circle {
            return None;
        }
        let edges = elements::cocircular_edges(self.triangles(), &self.x, |v| flow.is_free(v));
        if edges.is_empty() {
            return None;
        }
        let epsilon = self.options().epsilon;
        let sentence = Text::new(
            "At {count} edges the four points of both triangles lie on one circle; there the \
             energy has the tip of a cone, and with angle smoothing ε = {epsilon} no step \
             descends from it.",
            [
                ("count", (edges.len() / 2).to_string()),
                ("epsilon", number(epsilon)),
            ],
        );
        let larger = SMOOTH.into_iter().find(|&one| epsilon < one);
        let is_patch = self.options().free.is_some() && !self.options().prefill;
        // Where all quadrilaterals are planar that is a local minimum of this energy, but not of
        // the smooth one: a flow that does not go by angles leaves it.
        let mesh = &self.document.polygons;
        let is_closed = mesh.is_closed() && mesh.is_oriented();
        let diagnosis = Diagnosis::new(DiagnosisKind::CocircularKink, sentence).with([
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
        let values = [
            ("least", number(least)),
            ("energy", number(last.energy)),
            ("tau", number(last.tau)),
            ("vertex", vertex.to_string()),
            ("moved", number(moved / self.h())),
        ];
        let sentence = if last.rejected > 0 {
            Text::new(
                "The energy rises, from {least} to {energy}: the matrix of the step is indefinite \
                 for steps longer than τ = {tau}, so that errors are amplified; vertex {vertex} \
                 moved by {moved} edge lengths in the last step.",
                values,
            )
        } else {
            Text::new(
                "The energy rises, from {least} to {energy}: this scheme does not test for \
                 descent, and steps of τ = {tau} are too long for it; vertex {vertex} moved by \
                 {moved} edge lengths in the last one.",
                values,
            )
        };
        let remedies = [
            Some(Remedy::recommended_scheme().anew()),
            Some(Remedy::smaller_step(last.tau).anew()),
            self.can_go_back(),
        ];
        let diagnosis = Diagnosis::new(DiagnosisKind::RisingEnergy, sentence);
        Some(diagnosis.at_vertices([vertex]).with(remedies))
    }

    pub(super) fn failed(&self) -> Option<Diagnosis> {
        let failure = self.failure.as_ref();
        match failure.filter(|_| self.state.status == Status::Failed)? {
            FlowError::Unfit { vertex } => {
                let sentence = Text::new(
                    "About vertex {vertex} the surface has collapsed so far that no quadratic \
                     surface fits it, and curvatures by fits are what this flow goes by.",
                    [("vertex", vertex.to_string())],
                );
                let circle = Remedy::other_flow(FlowName::Circle).anew();
                let remedies = [Some(circle), self.can_regularise(), self.can_go_back()];
                let diagnosis =
                    Diagnosis::new(DiagnosisKind::Unfit, sentence).at_vertices([*vertex]);
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
            let sentence = Text::new(
                "With p = {p} the sharpest points outweigh all others, most of all vertex {vertex}: \
                 even the shortest step tried would go too far.",
                [("p", number(p)), ("vertex", vertex.to_string())],
            );
            let diagnosis = Diagnosis::new(DiagnosisKind::TooRough, sentence).at_vertices([vertex]);
            return Some(diagnosis.with([Some(Remedy::exponent(2.0)), self.can_regularise()]));
        }
        let update = self.last()?.update.filter(|update| *update > LOST)?;
        let is_long = self.course_reports().len() > 2 * WINDOW;
        let waits = self.options().flow == FlowName::Mmcv && (is_long || stalled);
        let (vertex, _) = self.last_move().filter(|_| waits)?;
        let sentence = Text::new(
            "After {steps} steps vertices are still to move by up to {update} edge lengths: the \
             start is too rough for a flow of sixth order; the last step moved vertex {vertex} \
             most.",
            [
                ("steps", self.state.step.to_string()),
                ("update", number(update)),
                ("vertex", vertex.to_string()),
            ],
        );
        let remedies = [
            (!self.options().prefill && self.options().free.is_some())
                .then(|| Remedy::prefill().anew()),
            self.can_regularise()
                .map(|_| Remedy::regularise_and_diffuse().anew()),
            Some(Remedy::other_flow(FlowName::SurfaceDiffusion).anew()),
        ];
        let diagnosis = Diagnosis::new(DiagnosisKind::TooRough, sentence).at_vertices([vertex]);
        Some(diagnosis.with(remedies))
    }

    pub(super) fn refused(&self, flow: &Engine) -> Option<Diagnosis> {
        let refusal = flow.refusal()?;
        let template = match refusal.cause {
            Cause::TooFar => {
                "Every step tried was refused: even the last and shortest would move vertex \
                 {vertex} by more than half an edge."
            }
            Cause::Turn | Cause::Fold => {
                "Every step tried was refused: even the last and shortest would turn face {face} \
                 by more than 60°."
            }
            Cause::Sliver => {
                "Every step tried was refused: even the last and shortest would make a sliver of \
                 face {face}."
            }
            Cause::Constraints => {
                "Every step tried was refused: area and volume cannot both be kept by a small move \
                 of this surface, which would move vertex {vertex} most."
            }
            Cause::Bound => {
                "Every step tried was refused: even the last and shortest would have less energy \
                 than any smooth surface of this topology, and move vertex {vertex} most."
            }
            Cause::Unfit => {
                "Every step tried was refused: even the last and shortest would leave no surface \
                 that can be fitted about vertex {vertex}."
            }
            Cause::Rise | Cause::ReadingJump | Cause::NotFinite | Cause::Newton => {
                "Every step tried was refused: none lowers the energy, not even the last and \
                 shortest, which would move vertex {vertex} most."
            }
        };
        let vertex = refusal.vertex.to_string();
        let face = refusal.face.map(|face| face.to_string());
        let values = [("vertex", vertex), ("face", face.unwrap_or_default())];
        let diagnosis = Diagnosis::new(DiagnosisKind::RefusedSteps, Text::new(template, values));
        let diagnosis = match refusal.face {
            Some(face) if self.document.polygons.is_triangular() => diagnosis.at_faces([face]),
            _ => diagnosis.at_vertices([refusal.vertex]),
        };
        let remedies = [
            (self.options().keep.len() > 1).then(Remedy::release_area),
            self.can_regularise(),
            self.can_go_back(),
        ];
        Some(diagnosis.with(remedies))
    }

    pub(super) fn step_limit(&self) -> Option<Diagnosis> {
        let last = self.last()?;
        let (vertex, _) = self.last_move()?;
        let fall = (last.objective_before - last.objective) / last.objective_before.abs();
        let values = [
            ("steps", self.state.step.to_string()),
            ("percent", number(100.0 * fall)),
            ("vertex", vertex.to_string()),
        ];
        let sentence = if fall > 0.0 {
            Text::new(
                "Nothing is wrong: after {steps} steps the energy still falls, by {percent} % in \
                 the last one, which moved vertex {vertex} most.",
                values,
            )
        } else {
            Text::new(
                "After {steps} steps the surface is not at rest; the last one moved vertex \
                 {vertex} most.",
                values,
            )
        };
        let diagnosis = Diagnosis::new(DiagnosisKind::StepLimit, sentence).at_vertices([vertex]);
        let fixed = self.options().tau.is_some() || self.options().dt.is_some();
        let automatic = (fixed && !self.is_paper()).then(Remedy::automatic_step);
        Some(diagnosis.with([Some(Remedy::go_on()), automatic]))
    }

    pub(super) fn rejected(&self, flow: &Engine) -> Option<Diagnosis> {
        let last = self.last().filter(|last| last.rejected > 0)?;
        let vertex = flow.refusal()?.vertex;
        let values = [
            ("count", last.rejected.to_string()),
            ("step", last.step.to_string()),
            ("tau", number(last.tau)),
            ("vertex", vertex.to_string()),
        ];
        let template = if last.rejected == 1 {
            "Nothing is wrong: in step {step} a longer trial, which would have moved vertex \
             {vertex} most, was refused, and τ = {tau} taken, for which the energy falls."
        } else {
            "Nothing is wrong: in step {step} {count} longer trials, the last of which would have \
             moved vertex {vertex} most, were refused, and τ = {tau} taken, for which the energy \
             falls."
        };
        let sentence = Text::new(template, values);
        let diagnosis =
            Diagnosis::new(DiagnosisKind::RejectedSteps, sentence).at_vertices([vertex]);
        Some(diagnosis.with([Some(Remedy::go_on())]))
    }
}
