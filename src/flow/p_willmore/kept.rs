//! Area and volume kept, and a volume that is led to another value.

use crate::energy::p_willmore::{Evaluation, Integrals};
use crate::flow::FlowError;
use crate::flow::constraint::{self, Constraint};
use crate::flow::option::Allowed;
use crate::flow::options::FlowOptions;
use glam::DVec3;
use std::f64::consts::PI;

/// A led volume moves by at most this share a step; less in one that was refused.
pub(super) const LEAD: f64 = 1e-2;
/// Below this share of it a step leads nowhere.
const LEAST_LEAD: f64 = 1e-6;

/// Volume of the ball with that much surface: A^(3/2) / (6√π).
pub(super) fn ball_volume(area: f64) -> f64 {
    area.powf(1.5) / (6.0 * PI.sqrt())
}

/// What is kept, and where it is led.
#[derive(Clone, Copy, Debug)]
pub(super) struct Kept {
    /// Wanted area, if it is kept.
    pub(super) area: Option<f64>,
    /// Wanted volume, if it is kept; falls or rises step by step towards `last_volume`.
    pub(super) volume: Option<f64>,
    last_volume: Option<f64>,
    /// Whether the step before was the last of a lead.
    arrived: bool,
}

impl Kept {
    /// From the integrals at the start.
    pub(super) fn new(options: &FlowOptions, start: &Integrals) -> Result<Self, FlowError> {
        let keeps = |kept| options.keep.contains(&kept);
        let (keeps_area, keeps_volume) = (
            keeps(constraint::Kept::Area),
            keeps(constraint::Kept::Volume),
        );
        let volume = keeps_volume.then_some(start.volume);
        let last_volume = match options.reduced_volume {
            None => volume,
            Some(reduced) => {
                if !(keeps_area && keeps_volume) {
                    let allowed = Allowed::WithAreaAndVolume;
                    return Err(FlowError::option("reducedVolume", reduced, allowed));
                }
                Some(reduced * ball_volume(start.area) * start.volume.signum())
            }
        };
        Ok(Self {
            area: keeps_area.then_some(start.area),
            volume,
            last_volume,
            arrived: false,
        })
    }

    /// Whether anything is kept.
    pub(super) fn any(&self) -> bool {
        self.area.is_some() || self.volume.is_some()
    }

    /// Whether the volume is on its way.
    pub(super) fn is_leading(&self) -> bool {
        self.volume != self.last_volume
    }

    /// Whether the last step brought the volume to where it was to go.
    pub(super) fn has_arrived(&self) -> bool {
        self.arrived
    }

    /// Whether the volume was led to a value other than that of the start.
    pub(super) fn leads(options: &FlowOptions) -> bool {
        options.reduced_volume.is_some()
    }

    /// The volume wanted next, `share` of the longest lead further on.
    pub(super) fn next_volume(&self, share: f64) -> Option<f64> {
        let (wanted, last) = (self.volume?, self.last_volume?);
        let most = LEAD * share.max(LEAST_LEAD) * wanted.abs();
        Some(if (last - wanted).abs() <= most {
            last
        } else {
            wanted + most.copysign(last - wanted)
        })
    }

    /// A step has led the volume there.
    pub(super) fn lead_to(&mut self, volume: Option<f64>) {
        let was_leading = self.is_leading();
        self.volume = volume.or(self.volume);
        self.arrived = was_leading && !self.is_leading();
    }

    /// The constraints with this volume wanted, of the values and gradients in `at`: area
    /// first.
    pub(super) fn constraints<'a>(
        &self,
        volume: Option<f64>,
        at: &'a Evaluation,
    ) -> Vec<Constraint<'a>> {
        let area = self.area.map(|target| Constraint {
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

    /// Gradients of what is kept, in the same order.
    pub(super) fn gradients<'a>(&self, at: &'a Evaluation) -> Vec<&'a [DVec3]> {
        let all = self.constraints(self.volume, at);
        all.into_iter().map(|c| c.gradient).collect()
    }

    /// M⁻¹∇C of what is kept, end to end.
    pub(super) fn mass_directions(&self, at: &Evaluation) -> Vec<DVec3> {
        let scaled = |gradient: &[DVec3]| -> Vec<DVec3> {
            let pairs = gradient.iter().zip(&at.mass);
            pairs.map(|(g, m)| *g / m.max(f64::MIN_POSITIVE)).collect()
        };
        self.gradients(at).into_iter().flat_map(scaled).collect()
    }

    /// Values in the order of the constraints, as those of area and volume.
    pub(super) fn sorted(&self, values: &[f64]) -> [Option<f64>; 2] {
        let mut values = values.iter().copied();
        let area = self.area.and_then(|_| values.next());
        let volume = self.volume.and_then(|_| values.next());
        [area, volume]
    }
}
