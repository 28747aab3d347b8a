//! Conformal regularisation after a step.

use super::LEAST_TURN;
use super::PWillmoreFlow;
use crate::flow::FlowError;
use crate::flow::guard::turning;
use crate::geometry::measure;
use crate::interrupt::{self, paced};
use crate::remesh::{Mode, Regulariser};
use glam::DVec3;

/// Regularisation may cost the smallest angle what is above this, in degrees.
const GOOD_ANGLE: f64 = 10.0;
/// It may not make an element smaller than this share of the mean: conformal maps of long
/// limbs onto a ball shrink their ends without bound.
const LEAST_ELEMENT: f64 = 1e-4;
/// Shares of a regularising displacement that are tried.
const SHARES: [f64; 5] = [1.0, 0.5, 0.25, 0.125, 0.0625];

impl PWillmoreFlow {
    /// Slides vertices towards a conformal mesh, as far as no face turns against `x` or `y`,
    /// nor the functional rises above `limit`; `None` where that is nowhere.
    pub(super) fn regularised(
        &mut self,
        x: &[DVec3],
        y: &[DVec3],
        limit: f64,
    ) -> Result<Option<Vec<DVec3>>, FlowError> {
        if self.mode() == Mode::Off {
            return Ok(None);
        }
        let regulariser = match &mut self.regulariser {
            Some(regulariser) => regulariser,
            None => self
                .regulariser
                .insert(Regulariser::new(self.functional.elements().clone(), x)?),
        };
        let (mode, epsilon) = (self.options.regularise, self.options.regularise_epsilon);
        let v = regulariser.displacement(y, mode, epsilon)?;
        let distortion = regulariser.distortion(y);
        interrupt::check()?;
        let angle = GOOD_ANGLE.min(measure::min_angle_degrees(&self.mesh, y));
        let smallest = LEAST_ELEMENT.min(self.smallest_element(y));
        // At the new positions M⁻¹∇C serves as direction: smooth, and cheap.
        self.functional.measure(y, &mut self.scratch);
        let directions = self.kept.mass_directions(&self.scratch);
        for share in SHARES {
            interrupt::check()?;
            let mut trial: Vec<DVec3> = y.iter().zip(&v).map(|(y, v)| *y + share * *v).collect();
            if !self.project(&mut trial, &directions) {
                continue;
            }
            let integrals = self.functional.integrals(&trial, &mut self.scratch);
            let improves = self
                .regulariser
                .as_ref()
                .is_some_and(|r| r.distortion(&trial) <= distortion)
                && measure::min_angle_degrees(&self.mesh, &trial) >= angle
                && self.smallest_element(&trial) >= smallest;
            let turns = |from: &[DVec3]| turning(&self.mesh, from, &trial, LEAST_TURN).is_some();
            if self.shown(integrals.objective) <= limit && improves && !turns(y) && !turns(x) {
                self.forget();
                return Ok(Some(trial));
            }
        }
        Ok(None)
    }

    /// Area of the smallest element over the mean.
    fn smallest_element(&self, x: &[DVec3]) -> f64 {
        let elements = self.functional.elements();
        let area = |e| elements.nodes(x, e).map(|node| node.area).sum::<f64>();
        let (mut least, mut total) = (f64::INFINITY, 0.0);
        for area in paced(0..elements.len()).map(area) {
            (least, total) = (least.min(area), total + area);
        }
        least * elements.len() as f64 / total
    }
}
