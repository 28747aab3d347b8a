//! The paper's scheme as a flow: centred steps on its schedule of step sizes, without a test
//! for descent.

use super::PWillmoreFlow;
use super::centred::CentredStep;
use super::step::{Accepted, Cost, constraints, ramped};
use crate::flow::refusal::{Cause, farthest};
use crate::flow::{FlowError, Refusal};
use web_time::Instant;

/// Most vertices the scheme takes: a step solves several unsymmetric systems of three
/// unknowns a vertex, where the recommended one solves a scalar one.
pub(super) const LARGEST: usize = 20_000;
/// How often, and by what, a step is cut that does not converge.
const MAX_CUTS: usize = 12;
const CUT: f64 = 0.1;
/// The volume moves by at most this share a step where it is led.
const RAMP: f64 = 1e-2;

/// The first τ and the largest, in units of L^(p+2): where Newton's method converges in a few
/// iterations on the surfaces of the paper.
pub(super) fn schedule(p: f64) -> (f64, f64) {
    let first = 10f64.powf(-4.0 - 1.5 * (p - 2.0).max(0.0));
    (first, 100.0 * first)
}

impl PWillmoreFlow {
    /// The next positions by Problem 5.1 and its regularisation, Problem 5.3; `None` where no
    /// step converges.
    pub(super) fn paper_advance(
        &mut self,
        x: &[glam::DVec3],
        cost: &mut Cost,
    ) -> Result<Option<Accepted>, FlowError> {
        let watch = Instant::now();
        let c = self.functional.stiffness(&self.evaluation);
        self.system.assemble(self.functional.elements(), x, &c);
        cost.assemble += watch.elapsed().as_secs_f64();
        let wanted = self.pace.volume;
        let is_ramping = wanted != self.pace.last_volume;
        let weighted = self.functional.weighted(&self.evaluation);
        let before = self.evaluation.integrals.objective;
        for cuts in 0..MAX_CUTS {
            let dt = self.pace.dt;
            self.pace.volume = ramped(wanted, self.pace.last_volume, RAMP);
            self.tell("newton", 0.1);
            let watch = Instant::now();
            let (area, volume) = (self.pace.area, self.pace.volume);
            let (functional, scratch) = (&self.functional, &mut self.scratch);
            let step = CentredStep {
                elements: functional.elements(),
                p: functional.p(),
                rounding: functional.rounding(),
                x,
                weighted: weighted.clone(),
                tau: dt,
            };
            let kept = [area.is_some(), volume.is_some()];
            let system = &mut self.system;
            let found = step.solve(system, &self.evaluation, kept, |y, take| {
                functional.measure(y, scratch);
                take(&constraints(area, volume, scratch));
            })?;
            cost.solve += watch.elapsed().as_secs_f64();
            let vertex = found
                .as_ref()
                .map_or(0, |found| farthest(x, &found.x, |_| 1.0).0);
            let Some(found) = found.filter(|found| self.turns_too_far(x, &found.x).is_none())
            else {
                cost.rejected += 1;
                cost.refusal = Some(Refusal {
                    cause: Cause::Newton,
                    vertex,
                    face: None,
                });
                self.pace.dt *= CUT;
                continue;
            };
            cost.iterations += found.newton;
            let asked = self.options.dt.is_some();
            self.pace.dt = if cuts == 0 && !asked {
                (self.options.tau_growth * dt).min(self.largest_dt())
            } else {
                self.options.dt.unwrap_or(dt)
            };
            if cuts > 0 {
                cost.warnings.push(format!(
                    "Newton’s method did not converge: this step was cut to a tenth {cuts} times."
                ));
            }
            let y = self.regularised(x, found.x, before, true, cost)?;
            return Ok(Some(Accepted {
                x: y,
                dt,
                multipliers: found.multipliers.iter().map(|l| -l).collect(),
                is_ramping,
            }));
        }
        self.pace.volume = wanted;
        Ok(None)
    }

    fn largest_dt(&self) -> f64 {
        let largest = self
            .options
            .tau_max
            .unwrap_or_else(|| schedule(self.options.p).1);
        largest * self.time_scale()
    }
}
