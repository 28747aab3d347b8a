//! One step: trial, projection onto the constraints, acceptance, regularisation.

use super::PWillmoreFlow;
use crate::energy::p_willmore::{Evaluation, Integrals};
use crate::flow::constraint::{Constraint, multipliers, project};
use crate::flow::refusal::{Cause, farthest};
use crate::flow::{FlowError, Refusal};
use crate::geometry::measure;
use crate::remesh::{Mode, Regulariser};
use glam::DVec3;
use web_time::Instant;

/// A vertex moves at most this share of the mean length of its edges in a trial …
const LONGEST_MOVE: f64 = 0.5;
/// … or of this share of the mean length of all: where conformal triangles are tiny they
/// move along with the rest.
const LEAST_REACH: f64 = 0.5;
/// A normal turns by at most 60° in a step.
const LEAST_TURN: f64 = 0.5;
/// The smallest angle, in degrees, may always fall to this …
const ANGLE_FLOOR: f64 = 5.0;
/// … and in one step to this share of what it was.
const ANGLE_SHARE: f64 = 0.7;
/// Factor on τ after a trial that was refused, and how many may be.
const SHRINK: f64 = 0.3;
const MAX_TRIALS: usize = 12;
/// Factor on τ after a step accepted at once.
const GROWTH: f64 = 1.5;
/// A ramped volume moves by at most this share a step; less in one that was refused.
const RAMP: f64 = 1e-2;
/// … and the flow follows it with steps of at most this τ/L^(p+2), so that a surface stays
/// on its branch: an oblate vesicle, given time, would turn over into a prolate one.
const RAMP_TAU: f64 = 1e-3;
/// Beyond this τ/L^(p+2) the mass term is lost in the roundoff of the stiffness.
const LARGEST_TAU: f64 = 1e4;
/// Regularisation may cost the smallest angle what is above this, in degrees.
const GOOD_ANGLE: f64 = 10.0;
/// Regularisation may not make an element smaller than this share of the mean: conformal
/// maps of long limbs onto a ball shrink their ends without bound.
const LEAST_ELEMENT: f64 = 1e-3;
/// Shares of a regularising displacement that are tried.
const SHARES: [f64; 5] = [1.0, 0.5, 0.25, 0.125, 0.0625];

/// Where the time of a step went, and what it met.
#[derive(Default)]
pub(super) struct Cost {
    pub(super) assemble: f64,
    pub(super) factor: f64,
    pub(super) solve: f64,
    pub(super) iterations: usize,
    pub(super) negative_pivots: usize,
    pub(super) rejected: usize,
    /// Why the last trial was refused.
    pub(super) refusal: Option<Refusal>,
    pub(super) warnings: Vec<String>,
}

/// What a step came to.
pub(super) struct Accepted {
    pub(super) x: Vec<DVec3>,
    pub(super) dt: f64,
    pub(super) multipliers: Vec<f64>,
    pub(super) is_ramping: bool,
}

/// (∇J · n) n at every vertex, n along the gradient of the volume: the part of the gradient
/// that moves the surface and not only its vertices.
pub(super) fn normal_part(evaluation: &Evaluation) -> Vec<DVec3> {
    let pairs = evaluation.gradient.iter().zip(&evaluation.volume_gradient);
    pairs
        .map(|(g, n)| {
            let n = n.normalize_or_zero();
            g.dot(n) * n
        })
        .collect()
}

impl PWillmoreFlow {
    /// The next positions, or `None` if no trial was accepted.
    pub(super) fn advance(
        &mut self,
        x: &[DVec3],
        cost: &mut Cost,
    ) -> Result<Option<Accepted>, FlowError> {
        let watch = Instant::now();
        let c = self.functional.stiffness(&self.evaluation);
        self.system.assemble(self.functional.elements(), x, &c);
        let least = measure::min_angle_degrees(&self.mesh, x);
        let mut reach = measure::mean_edge_lengths(&self.mesh, x);
        let floor = LEAST_REACH * measure::mean_edge_length(&self.mesh, x);
        reach.iter_mut().for_each(|h| *h = h.max(floor));
        let before = self.evaluation.integrals.objective;
        let wanted = self.pace.volume;
        let is_ramping = wanted != self.pace.last_volume;
        if is_ramping && self.options.dt.is_none() {
            self.pace.dt = self.pace.dt.min(RAMP_TAU * self.time_scale());
        }
        let mut ramp = RAMP;
        let fields =
            1 + usize::from(self.pace.area.is_some()) + usize::from(self.pace.volume.is_some());
        let mut rhs = Vec::with_capacity(fields * x.len());
        rhs.extend(normal_part(&self.evaluation).iter().map(|g| -*g));
        if self.pace.area.is_some() {
            rhs.extend_from_slice(&self.evaluation.area_gradient);
        }
        if self.pace.volume.is_some() {
            rhs.extend_from_slice(&self.evaluation.volume_gradient);
        }
        let mut solution = vec![DVec3::ZERO; rhs.len()];
        cost.assemble += watch.elapsed().as_secs_f64();
        for trial in 0..MAX_TRIALS {
            let dt = self.pace.dt;
            self.pace.volume = ramped(wanted, self.pace.last_volume, ramp);
            self.tell("factor", 0.1);
            let info = self
                .system
                .solve(&self.evaluation.mass, dt, &rhs, &mut solution)?;
            cost.factor += info.factor_seconds;
            cost.solve += info.solve_seconds;
            cost.iterations += info.iterations;
            cost.negative_pivots = info.negative_pivots;
            self.tell("project", 0.4);
            let (d, directions) = solution.split_at(x.len());
            let lambda = multipliers(&self.constraints(&self.evaluation), d, directions);
            let mut y: Vec<DVec3> = x.to_vec();
            for (i, y) in y.iter_mut().enumerate() {
                *y += d[i];
                for (lambda, u) in lambda.iter().zip(directions.chunks_exact(x.len())) {
                    *y += *lambda * u[i];
                }
            }
            let (vertex, farthest) = farthest(x, &y, |v| reach[v]);
            // Too far: the step is cut in proportion, before anything dear is computed.
            if farthest > LONGEST_MOVE || farthest.is_nan() {
                cost.rejected += 1;
                cost.refusal = Some(Refusal {
                    cause: Cause::TooFar,
                    vertex,
                    face: None,
                });
                let ratio = LONGEST_MOVE / farthest;
                ramp *= 0.5;
                self.pace.dt *= if ratio.is_finite() {
                    ratio.clamp(0.1, 0.7)
                } else {
                    0.1
                };
                continue;
            }
            let refusal = self.refusal(x, &mut y, directions, before, least, is_ramping);
            if let Some((cause, face)) = refusal {
                cost.rejected += 1;
                cost.refusal = Some(Refusal {
                    cause,
                    vertex,
                    face,
                });
                ramp *= 0.5;
                self.pace.dt *= SHRINK;
                continue;
            }
            self.pace.dt = match self.options.dt {
                // A step size that was asked for is cut for single steps only.
                Some(asked) => asked,
                None if trial == 0 => (GROWTH * dt).min(LARGEST_TAU * self.time_scale()),
                None => dt,
            };
            let y = self.regularised(x, y, before, is_ramping, cost)?;
            return Ok(Some(Accepted {
                x: y,
                dt,
                multipliers: lambda,
                is_ramping,
            }));
        }
        self.pace.volume = wanted;
        Ok(None)
    }

    /// Areas of the smallest and the largest element over the mean.
    pub(super) fn element_range(&self, x: &[DVec3]) -> (f64, f64) {
        let elements = self.functional.elements();
        let area = |e| elements.nodes(x, e).map(|node| node.area).sum::<f64>();
        let (mut least, mut most, mut total) = (f64::INFINITY, 0.0f64, 0.0);
        for area in (0..elements.len()).map(area) {
            (least, most, total) = (least.min(area), most.max(area), total + area);
        }
        let mean = total / elements.len() as f64;
        (least / mean, most / mean)
    }

    fn constraints<'a>(&self, at: &'a Evaluation) -> Vec<Constraint<'a>> {
        constraints(self.pace.area, self.pace.volume, at)
    }

    /// Projects a trial onto the constraints and says what is wrong with it, if anything.
    fn refusal(
        &mut self,
        x: &[DVec3],
        y: &mut [DVec3],
        directions: &[DVec3],
        before: f64,
        least_angle: f64,
        is_ramping: bool,
    ) -> Option<(Cause, Option<u32>)> {
        if !self.project(y, directions) {
            return Some((Cause::Constraints, None));
        }
        let Integrals { objective, .. } = self.functional.integrals(y, &mut self.scratch);
        if !objective.is_finite() {
            return Some((Cause::NotFinite, None));
        }
        if objective > before && !is_ramping {
            return Some((Cause::Rise, None));
        }
        if let Some(face) = self.turns_too_far(x, y) {
            return Some((Cause::Turn, Some(face)));
        }
        let angle = measure::min_angle_degrees(&self.mesh, y);
        if angle < ANGLE_FLOOR.min(ANGLE_SHARE * least_angle) {
            let face = measure::sharpest_face(&self.mesh, y).map(|(f, _)| f.0);
            return Some((Cause::Sliver, face));
        }
        None
    }

    fn project(&mut self, y: &mut [DVec3], directions: &[DVec3]) -> bool {
        let (area, volume) = (self.pace.area, self.pace.volume);
        if area.is_none() && volume.is_none() {
            return true;
        }
        let (functional, scratch) = (&self.functional, &mut self.scratch);
        project(y, directions, |y, take| {
            functional.measure(y, scratch);
            take(&constraints(area, volume, scratch));
        })
    }

    /// The first element that turns by more than it may.
    pub(super) fn turns_too_far(&self, x: &[DVec3], y: &[DVec3]) -> Option<u32> {
        let elements = self.functional.elements();
        let turns = |e: &usize| {
            let e = *e;
            elements
                .nodes(x, e)
                .zip(elements.nodes(y, e))
                // A collapsed element has no normal to turn.
                .any(|(a, b)| a.area > 0.0 && a.normal.dot(b.normal) < LEAST_TURN)
        };
        (0..elements.len()).find(turns).map(|e| e as u32)
    }

    /// Slides vertices towards a conformal mesh, as far as no face turns, nor the energy
    /// rises above that `before` the step unless it `may_rise`: while the volume is ramped,
    /// and in the paper's scheme. `y` itself where that is nowhere.
    pub(super) fn regularised(
        &mut self,
        x: &[DVec3],
        y: Vec<DVec3>,
        before: f64,
        may_rise: bool,
        cost: &mut Cost,
    ) -> Result<Vec<DVec3>, FlowError> {
        if self.mode() == Mode::Off {
            return Ok(y);
        }
        self.tell("regularise", 0.5);
        let watch = Instant::now();
        let regulariser = match &mut self.regulariser {
            Some(regulariser) => regulariser,
            None => self
                .regulariser
                .insert(Regulariser::new(self.functional.elements().clone(), x)?),
        };
        let (mode, epsilon) = (self.options.regularise, self.options.regularise_epsilon);
        let v = regulariser.displacement(&y, mode, epsilon)?;
        let distortion = regulariser.distortion(&y);
        let angle = GOOD_ANGLE.min(measure::min_angle_degrees(&self.mesh, &y));
        // At the new positions M⁻¹∇C serves as direction: smooth, and cheap.
        let smallest = LEAST_ELEMENT.min(self.element_range(&y).0);
        self.functional.measure(&y, &mut self.scratch);
        let directions = mass_directions(self.pace.area, self.pace.volume, &self.scratch);
        let mut best = None;
        for share in SHARES {
            let mut trial: Vec<DVec3> = y.iter().zip(&v).map(|(y, v)| *y + share * *v).collect();
            if !self.project(&mut trial, &directions) {
                continue;
            }
            let objective = self
                .functional
                .integrals(&trial, &mut self.scratch)
                .objective;
            let falls = objective <= before || may_rise;
            let improves = self
                .regulariser
                .as_ref()
                .is_some_and(|r| r.distortion(&trial) <= distortion)
                && measure::min_angle_degrees(&self.mesh, &trial) >= angle
                && self.element_range(&trial).0 >= smallest;
            if falls
                && improves
                && self.turns_too_far(&y, &trial).is_none()
                && self.turns_too_far(x, &trial).is_none()
            {
                best = Some(trial);
                break;
            }
        }
        cost.solve += watch.elapsed().as_secs_f64();
        Ok(best.unwrap_or(y))
    }
}

/// The volume wanted next on the way from `wanted` to `last`.
pub(super) fn ramped(wanted: Option<f64>, last: Option<f64>, share: f64) -> Option<f64> {
    let (wanted, last) = (wanted?, last?);
    let most = share * wanted.abs();
    Some(if (last - wanted).abs() <= most {
        last
    } else {
        wanted + most.copysign(last - wanted)
    })
}

/// The constraints in force, of the values and gradients in `at`: area first.
pub(super) fn constraints(
    area: Option<f64>,
    volume: Option<f64>,
    at: &Evaluation,
) -> Vec<Constraint<'_>> {
    let area = area.map(|target| Constraint {
        target,
        value: at.integrals.area,
        gradient: &at.area_gradient,
    });
    let volume = volume.map(|target| Constraint {
        target,
        value: at.integrals.volume,
        gradient: &at.volume_gradient,
    });
    area.into_iter().chain(volume).collect()
}

/// M⁻¹∇C of the constraints in force, end to end.
fn mass_directions(area: Option<f64>, volume: Option<f64>, at: &Evaluation) -> Vec<DVec3> {
    let scaled = |gradient: &[DVec3]| -> Vec<DVec3> {
        let pairs = gradient.iter().zip(&at.mass);
        pairs.map(|(g, m)| *g / m.max(f64::MIN_POSITIVE)).collect()
    };
    let mut directions = Vec::new();
    if area.is_some() {
        directions.extend(scaled(&at.area_gradient));
    }
    if volume.is_some() {
        directions.extend(scaled(&at.volume_gradient));
    }
    directions
}
