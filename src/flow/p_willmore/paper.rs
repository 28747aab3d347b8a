//! The paper's scheme as a flow: centred steps on its schedule of step sizes, without a test
//! for descent.

use super::centred::CentredStep;
use super::{LEAST_TURN, PWillmoreFlow};
use crate::flow::guard::turning;
use crate::flow::options::FlowOptions;
use crate::flow::refusal::farthest;
use crate::flow::step_size::StepSize;
use crate::flow::{Cause, Cost, FlowError, Move, Proposal, Refusal, Search};
use crate::interrupt;
use glam::DVec3;
use web_time::Instant;

/// Most vertices the scheme takes: a step solves several unsymmetric systems of three
/// unknowns a vertex, where the recommended one solves a scalar one.
pub(super) const LARGEST: usize = 20_000;
/// How far, and by what, a step is cut that does not converge.
const MOST_CUT: f64 = 1e-12;
const CUT: f64 = 0.1;

/// The first τ and the largest, in units of L^(p+2): where Newton's method converges in a few
/// iterations on the surfaces of the paper.
fn schedule(p: f64) -> (f64, f64) {
    let first = 10f64.powf(-4.0 - 1.5 * (p - 2.0).max(0.0));
    (first, 100.0 * first)
}

/// The step size and its growth, with τ in this unit.
pub(super) fn step_size(options: &FlowOptions, unit: f64) -> StepSize {
    let (first, largest) = schedule(options.p);
    let tau = options.tau.unwrap_or(first);
    let dt = options.dt.unwrap_or(tau * unit);
    let size = if options.dt.is_some() {
        StepSize::constant(dt, MOST_CUT * dt)
    } else {
        let largest = options.tau_max.unwrap_or(largest) * unit;
        StepSize::adaptive(dt, MOST_CUT * dt, largest)
    };
    size.with_factors(options.tau_growth, CUT)
}

impl PWillmoreFlow {
    /// The move to the solution of Problem 5.1; its regularisation, Problem 5.3, follows as
    /// after any step.
    pub(super) fn centred(
        &mut self,
        x: &[DVec3],
        dt: f64,
        cost: &mut Cost,
    ) -> Result<Proposal, FlowError> {
        let watch = Instant::now();
        if !self.is_assembled {
            let c = self.functional.stiffness(&self.evaluation);
            self.system.assemble(self.functional.elements(), x, &c);
            self.is_assembled = true;
        }
        cost.assemble += watch.elapsed().as_secs_f64();
        self.next_volume = self.kept.next_volume(1.0);
        interrupt::tell("newton", 0.1);
        let watch = Instant::now();
        let (kept, volume) = (self.kept, self.next_volume);
        let (functional, scratch) = (&self.functional, &mut self.scratch);
        let step = CentredStep {
            elements: functional.elements(),
            p: functional.p(),
            rounding: functional.rounding(),
            x,
            weighted: functional.weighted(&self.evaluation),
            tau: dt,
        };
        let in_force = [kept.area.is_some(), volume.is_some()];
        let system = &mut self.system;
        let found = step.solve(system, &self.evaluation, in_force, |y, take| {
            functional.measure(y, scratch);
            take(&kept.constraints(volume, scratch));
        })?;
        cost.solve += watch.elapsed().as_secs_f64();
        let vertex = found
            .as_ref()
            .map_or(0, |found| farthest(x, &found.x, |_| 1.0).0);
        let turns = |y: &[DVec3]| turning(&self.mesh, x, y, LEAST_TURN).is_some();
        let Some(found) = found.filter(|found| !turns(&found.x)) else {
            return Ok(Proposal::Refused(Refusal::at(Cause::Newton, vertex)));
        };
        cost.iterations += found.newton;
        self.multipliers = found.multipliers.iter().map(|l| -l).collect();
        // It is on the constraints already.
        self.directions.clear();
        let d = found.x.iter().zip(x).map(|(y, x)| *y - *x).collect();
        let step = Move::new(d, 0.0, dt, Search::Unseen);
        Ok(Proposal::Move(Box::new(step)))
    }
}
