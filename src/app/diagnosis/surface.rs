//! What can be the matter with the surface and its mesh. Thresholds are those of the flows' own
//! warnings (see their `warning.rs`, and `flow/ending.rs`) where they have one.

use super::elements;
use super::remedy::Remedy;
use super::{Diagnosis, Symptom};
use crate::app::engine::Engine;
use crate::app::runner::Runner;
use crate::flow::Status;
use crate::flow::constraint::Kept;
use crate::flow::signs::{BUBBLE, NARROW, SHARPENED, SLIVER, UNDER_RESOLVED, WORN};
use crate::flow::spec::{self, Family, FlowName};
use crate::geometry::bend::{Sharpest, sharpest};
use crate::geometry::measure;
use crate::geometry::quality::flat_triangles;
use std::f64::consts::PI;

/// The bend of a ring of n edges is this over n: 2π √(√3/2).
const RING: f64 = 5.85;
/// ∫H² of coarse meshes comes to 1.8 % below the smooth minimum; W of aligned lattices to 2 %
/// and of others not below it at all.
const HONEST: f64 = 0.97;
const HONEST_CIRCLE: f64 = 0.9;
const COLLAPSED: f64 = 1.05;
/// Growth of the area, or its shrinking, that is no approach to anything.
const SCALED: f64 = 2.0;
/// Edges or faces that are still elements, and not the whole surface.
const SHOWN: usize = 2000;

impl Runner {
    /// ∫|H|^p scales like length^(2−p): nothing keeps a free surface from growing or shrinking.
    pub(super) fn scaling(&self) -> Option<Diagnosis> {
        let (start, now) = (self.start_area(), self.state.area);
        // Mean-curvature flow is the one of p = 0.
        let settled = self.settled();
        let p = match settled.flow {
            FlowName::PWillmore if settled.keep.is_empty() => settled.p,
            FlowName::MeanCurvature if self.is_all_free() => 0.0,
            _ => return None,
        };
        if p > 2.0 && now > SCALED * start {
            let symptom = Symptom::Growing {
                p,
                times: now / start,
            };
            let keep = [self.can_keep(&[Kept::Volume]), self.can_keep(&[Kept::Area])];
            return Some(Diagnosis::new(&symptom).with(keep));
        }
        let shrinks = p < 2.0 && now * SCALED < start && !self.is_narrow(NARROW);
        shrinks.then(|| {
            let symptom = Symptom::Shrinking {
                p,
                times: start / now,
            };
            let remedies = [
                self.can_keep(&[Kept::Volume]),
                self.can_keep(&[Kept::Area]),
                self.keeps_volume_instead(),
            ];
            Diagnosis::new(&symptom).with(remedies)
        })
    }

    fn sharpest(&self, least: f64) -> Option<Sharpest> {
        let mesh = self.triangles();
        let now = sharpest(mesh, &self.x)?;
        let then = sharpest(&self.document.triangles, &self.document.start)?;
        (now.bend > least && now.bend > SHARPENED * then.bend).then_some(now)
    }

    /// Surface diffusion, in place of the flow by mean curvature.
    fn keeps_volume_instead(&self) -> Option<Remedy> {
        let flow = FlowName::SurfaceDiffusion;
        (self.options().flow == FlowName::MeanCurvature).then(|| Remedy::other_flow(flow).anew())
    }

    fn start_area(&self) -> f64 {
        measure::area(&self.document.triangles, &self.document.start)
    }

    fn is_narrow(&self, least: f64) -> bool {
        self.sharpest(least).is_some_and(|found| found.is_neck)
    }

    /// A neck of a few edges; less is asked of one that has stopped the flow.
    pub(super) fn pinch(&self, stopped: bool) -> Option<Diagnosis> {
        // Flows of higher order do not shrink necks, and what bends on their rough meshes are none.
        let settled = self.settled();
        let is_low = settled.flow == FlowName::MeanCurvature
            || spec::of(settled.flow).family == Family::PWillmore && settled.p < 2.0;
        if !is_low {
            return None;
        }
        let found = self.sharpest(if stopped { NARROW } else { UNDER_RESOLVED })?;
        if !found.is_neck {
            return None;
        }
        let edges = (RING / found.bend).floor();
        let symptom = Symptom::Pinch {
            vertex: found.vertex,
            // A thin neck bends about its axis only: 2|H| = 1/r.
            width: 1.0 / found.mean_curvature,
            edges,
        };
        // An open surface keeps no volume; with its tangents held it does not become a neck.
        let clamped = (!self.document.polygons.is_closed())
            .then(|| Remedy::other_flow(FlowName::Circle).anew());
        let remedies = [
            self.can_keep(&[Kept::Volume]),
            clamped.or_else(|| self.keeps_volume_instead()),
            self.can_go_back(),
            self.can_regularise(),
        ];
        let diagnosis = Diagnosis::new(&symptom).at_vertices(found.ring);
        Some(diagnosis.with(remedies))
    }

    /// Where the energy does not depend on size nothing keeps a surface from swelling, and
    /// the mesh is worn out on the way.
    pub(super) fn inflating(&self) -> Option<Diagnosis> {
        let is_scale_free = self.options().flow == FlowName::PWillmore
            && self.options().p == 2.0
            && self.options().keep.is_empty();
        let times = self.state.area / self.start_area();
        let (face, angle) = self.sliver()?;
        if !is_scale_free || times < BUBBLE {
            return None;
        }
        let symptom = Symptom::Inflating { times, face, angle };
        let keep = self.can_keep(&[Kept::Area, Kept::Volume]);
        let diagnosis = Diagnosis::new(&symptom).at_faces([face]);
        Some(diagnosis.with([keep, self.can_go_back(), self.can_flip()]))
    }

    /// The face with the smallest angle, where that is small and was not at the start.
    fn sliver(&self) -> Option<(u32, f64)> {
        let (face, angle) = measure::sharpest_face(self.triangles(), &self.x)?;
        let then = self.start_angle();
        (angle < SLIVER && angle < WORN * then).then_some((face.0, angle))
    }

    /// In degrees.
    fn start_angle(&self) -> f64 {
        measure::min_angle_degrees(&self.document.triangles, &self.document.start)
    }

    /// Closed surfaces have ∫H² ≥ 4π, with handles ≥ 2π² (Willmore; Marques & Neves 2014).
    pub(super) fn below_minimum(&self) -> Option<Diagnosis> {
        let mesh = &self.document.triangles;
        let genus = mesh
            .genus()
            .filter(|_| mesh.is_closed() && mesh.is_oriented())?;
        if mesh.components().1 != 1 {
            return None;
        }
        let least = if genus > 0 { 2.0 * PI * PI } else { 4.0 * PI };
        let (energy, smooth, share) = match self.options().flow {
            FlowName::PWillmore if self.options().p == 2.0 => (self.state.energy, least, HONEST),
            // ∫(H² − K) is ∫H² less 4π(1 − genus).
            FlowName::Circle if genus > 0 => {
                let gauss = 4.0 * PI * (1.0 - genus as f64);
                (self.state.energy_normalised, least - gauss, HONEST_CIRCLE)
            }
            _ => return None,
        };
        let plain = self.options().spontaneous_curvature == 0.0
            && self.options().tension == 0.0
            && self.options().pressure == 0.0;
        // A flow that has collapsed stands just above what it may not go below.
        let share = if self.state.status == Status::Collapsed {
            COLLAPSED
        } else {
            share
        };
        if !plain || energy >= share * smooth {
            return None;
        }
        let bent = sharpest(self.triangles(), &self.x)?;
        let vertex = bent.vertex;
        let symptom = Symptom::BelowSmoothMinimum {
            energy,
            smooth,
            vertex,
        };
        let diagnosis = Diagnosis::new(&symptom).at_vertices([vertex]);
        let finer = Some(self.can_subdivide().unwrap_or_else(Remedy::refine));
        Some(diagnosis.with([finer, Some(Remedy::refine()), self.can_go_back()]))
    }

    /// A mesh too coarse or too crumpled for its readings to be believed.
    pub(super) fn untrusted(&self) -> Option<Diagnosis> {
        let readings = self.state.soundness.filter(|readings| !readings.is_sound)?;
        let vertex = elements::most_curved(self.triangles(), &self.x)?;
        let symptom = Symptom::Untrusted {
            bend: readings.bend,
            alignment: readings.alignment,
            topology: readings.gauss_bonnet,
            energy: readings.fitted_energy,
            vertex,
        };
        let finer = self.can_subdivide().unwrap_or_else(Remedy::refine);
        let remedies = [Some(finer), self.can_regularise(), self.can_go_back()];
        let diagnosis = Diagnosis::new(&symptom).at_vertices([vertex]);
        Some(diagnosis.with(remedies))
    }

    pub(super) fn unresolved(&self) -> Option<Diagnosis> {
        let is_at_start = self.segment_reports().is_empty();
        let symptom = (self.state.status == Status::Collapsed && is_at_start)
            .then_some(Symptom::Unresolved)?;
        let other = Remedy::other_flow(FlowName::PWillmore).anew();
        Some(Diagnosis::new(&symptom).with([Some(other)]))
    }

    /// Triangles without area from which no first step led on.
    pub(super) fn flat_faces(&self) -> Option<Diagnosis> {
        let is_at_start = self.state.status == Status::Stalled && self.segment_reports().is_empty();
        let mesh = self.triangles();
        let flat = is_at_start.then(|| flat_triangles(mesh, &self.x))?;
        let (face, count) = (flat.first()?.0, flat.len());
        let diagnosis = Diagnosis::new(&Symptom::FlatFaces { count, face });
        let remedies = [self.can_repair(), self.can_regularise()];
        Some(
            diagnosis
                .at_faces(flat.into_iter().map(|f| f.0))
                .with(remedies),
        )
    }

    pub(super) fn folded_over(&self, flow: &Engine) -> Option<Diagnosis> {
        let faces = elements::folded_faces(self.triangles(), &self.x);
        let lately = self.recent().iter().any(|report| report.flipped_faces > 0)
            || !flow.flipped_faces().is_empty();
        // Circle angles do not ask which way a face lies, and unfold what is folded.
        let minds = lately || self.options().flow != FlowName::Circle;
        let &first = faces.first().filter(|_| minds)?;
        let symptom = Symptom::FoldedFaces {
            count: faces.len(),
            face: first,
        };
        let remedies = [self.can_regularise(), self.can_flip(), self.can_go_back()];
        let shown = faces.into_iter().take(SHOWN);
        let diagnosis = Diagnosis::new(&symptom).at_faces(shown);
        Some(diagnosis.with(remedies))
    }

    pub(super) fn degenerate(&self) -> Option<Diagnosis> {
        let (face, angle) = self.sliver()?;
        let symptom = Symptom::DegenerateFaces {
            face,
            angle,
            before: self.start_angle(),
        };
        let remedies = [
            self.can_repair(),
            self.can_regularise_each_step(),
            self.can_regularise(),
            self.can_flip(),
            self.can_go_back(),
        ];
        let diagnosis = Diagnosis::new(&symptom).at_faces([face]);
        Some(diagnosis.with(remedies))
    }
}
