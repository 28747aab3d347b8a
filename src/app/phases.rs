//! The phase diagram of vesicles: the least ∫H² over the reduced volume, of three branches of shapes
//! that are at rest with their area and volume kept.
//!
//! Prolate shapes bend least above v = 0.651, oblate ones (discocytes) down to 0.592, and
//! stomatocytes, which are dented inward, below [SBL91](crate::bibliography#sbl91). Each point is a
//! surface of its own that flowed to rest. Prolate shapes have tips, where triangles pile up unless
//! they are made anew between steps; oblate ones are not the least of all there where they are at
//! rest, and stay oblate by the symmetry of their triangles, which are left alone.

use super::Session;
use super::document::Document;
use super::fault::Fault;
use crate::flow::Status;
use crate::flow::constraint::Kept::{Area, Volume};
use crate::flow::options::{FlowOptions, Remeshing};
use crate::flow::spec::FlowName;
use crate::mesh::shape;
use serde::{Deserialize, Serialize};
use std::f64::consts::PI;

/// Steps in which a shape comes to rest.
const STEPS: usize = 400;

/// One shape of the diagram.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Phase {
    /// Which shapes it belongs to.
    pub branch: Branch,
    /// 6√π V/A^(3/2), 1 of a ball.
    pub reduced_volume: f64,
    /// ∫H²/4π, 1 of a sphere.
    pub energy: f64,
    /// The same of the smooth shape of revolution at rest, where it is known.
    pub expected: Option<f64>,
    /// How the flow ended.
    pub status: Status,
    /// The flow under which it is at rest, and stays on its branch.
    pub options: FlowOptions,
    /// How many shapes the diagram has.
    pub of: usize,
}

/// Shapes that go over into each other as the volume changes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum Branch {
    /// Long.
    Prolate,
    /// Flat.
    Oblate,
    /// Dented inward.
    Stomatocyte,
}

/// Where a shape begins, and what it comes to.
struct Point {
    branch: Branch,
    reduced_volume: f64,
    /// Height over width of the spheroid it begins as; of a stomatocyte the radius of the dent.
    start: f64,
    expected: Option<f64>,
}

const fn point(branch: Branch, reduced_volume: f64, start: f64, expected: Option<f64>) -> Point {
    Point {
        branch,
        reduced_volume,
        start,
        expected,
    }
}

/// From right to left, the three branches in turn. What is expected was computed for this table:
/// ∫H² least over meridians of which the angle is a sum of 16 sines.
const POINTS: &[Point] = &{
    use Branch::{Oblate, Prolate, Stomatocyte};
    [
        point(Prolate, 0.95, 1.582, Some(1.0956)),
        point(Oblate, 0.95, 0.652, Some(1.1061)),
        point(Prolate, 0.9, 1.962, Some(1.1896)),
        point(Oblate, 0.9, 0.544, Some(1.2179)),
        point(Prolate, 0.85, 2.355, Some(1.2857)),
        point(Oblate, 0.85, 0.47, Some(1.3335)),
        point(Prolate, 0.8, 2.791, Some(1.3874)),
        point(Oblate, 0.8, 0.413, Some(1.4525)),
        point(Prolate, 0.75, 3.293, Some(1.5018)),
        point(Oblate, 0.75, 0.366, Some(1.5745)),
        point(Prolate, 0.7, 3.887, Some(1.6433)),
        point(Oblate, 0.7, 0.325, Some(1.6991)),
        point(Prolate, 0.65, 4.605, Some(1.8279)),
        point(Oblate, 0.65, 0.29, Some(1.8262)),
        point(Stomatocyte, 0.65, 0.49, None),
        point(Prolate, 0.62, 5.15, Some(1.961)),
        point(Oblate, 0.62, 0.27, Some(1.9036)),
        point(Oblate, 0.592, 0.253, Some(1.9766)),
        point(Stomatocyte, 0.592, 0.53, Some(1.98)),
        point(Oblate, 0.55, 0.232, Some(2.0873)),
        point(Stomatocyte, 0.55, 0.56, None),
        point(Stomatocyte, 0.5, 0.6, Some(2.0)),
    ]
};

/// How many shapes the diagram has.
pub(super) const COUNT: usize = POINTS.len();

impl Point {
    fn begin(&self) -> Result<Document, Fault> {
        let (name, parameter) = match self.branch {
            Branch::Prolate | Branch::Oblate => ("spheroid", "ratio"),
            Branch::Stomatocyte => ("stomatocyte", "inner"),
        };
        let made = shape::make(name, &[(parameter.into(), self.start)])?;
        Document::from_sample(name, made)
    }

    /// Options of the flow that keeps the volume as it is.
    fn kept(&self) -> FlowOptions {
        FlowOptions {
            flow: FlowName::PWillmore,
            keep: vec![Area, Volume],
            remesh: match self.branch {
                Branch::Oblate => Remeshing::Off,
                Branch::Prolate | Branch::Stomatocyte => Remeshing::Adaptive,
            },
            ..FlowOptions::default()
        }
    }

    /// And of the one that leads it to where it is to be.
    fn led(&self) -> FlowOptions {
        FlowOptions {
            reduced_volume: Some(self.reduced_volume),
            max_steps: Some(STEPS),
            ..self.kept()
        }
    }
}

impl Session {
    /// The shape of that number in the phase diagram of vesicles, which this session then has; `None`
    /// after the last.
    ///
    /// # Errors
    /// Numerical failures.
    pub fn phase(&mut self, number: usize) -> Result<Option<Phase>, Fault> {
        let Some(point) = POINTS.get(number) else {
            return Ok(None);
        };
        self.open(point.begin()?)?;
        self.configure(point.led())?;
        self.run(STEPS)?;
        let state = self.state()?;
        Ok(Some(Phase {
            branch: point.branch,
            reduced_volume: state.reduced_volume.unwrap_or(f64::NAN),
            energy: state.energy / (4.0 * PI),
            expected: point.expected,
            status: state.status,
            options: point.kept(),
            of: COUNT,
        }))
    }
}

/// The reduced volume at which two branches have the same energy, between those of their shapes
/// where the difference changes its sign.
pub fn crossing(phases: &[Phase], one: Branch, other: Branch) -> Option<f64> {
    let of = |branch| phases.iter().filter(move |phase| phase.branch == branch);
    let mut differences = of(one).filter_map(|a| {
        let same = |b: &&Phase| (b.reduced_volume - a.reduced_volume).abs() < 1e-6;
        let b = of(other).find(same)?;
        Some((a.reduced_volume, a.energy - b.energy))
    });
    let mut last = differences.next()?;
    for next in differences {
        if last.1 * next.1 <= 0.0 {
            let share = last.1 / (last.1 - next.1);
            return Some(last.0 + share * (next.0 - last.0));
        }
        last = next;
    }
    None
}
