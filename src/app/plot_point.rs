//! What a plot has of a step.

use crate::flow::{StepReport, Warning};
use serde::Serialize;

/// What a plot has of a step, and what the step warns of.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct PlotPoint {
    /// Number of the step.
    pub step: usize,
    /// Flow time after it.
    pub time: f64,
    /// Raw step size.
    pub dt: f64,
    /// See [`StepReport::energy`].
    pub energy: f64,
    /// See [`StepReport::objective`].
    pub objective: f64,
    /// Total area.
    pub area: f64,
    /// Signed volume of a closed oriented surface.
    pub volume: Option<f64>,
    /// Smallest corner angle.
    pub min_angle_degrees: f64,
    /// Worth telling the user; none where the step was told of before.
    pub warnings: Vec<Warning>,
}

impl PlotPoint {
    pub(super) fn of(report: &StepReport, warnings: &[Warning]) -> Self {
        Self {
            step: report.step,
            time: report.time,
            dt: report.dt,
            energy: report.energy,
            objective: report.objective,
            area: report.area,
            volume: report.volume,
            min_angle_degrees: report.min_angle_degrees,
            warnings: warnings.to_vec(),
        }
    }
}
