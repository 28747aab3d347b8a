//! What a session tells: diagnosis, energies, state, history. Keys in JSON are the
//! field names in camel case.

use super::crossing;
use super::message::Notice;
use super::repairs::RepairItem;
use crate::energy::circle::angle::Smoothing;
use crate::energy::circle::{self, Boundary, CircleEnergy};
use crate::energy::p_willmore::{Evaluation, Helfrich, Integrals, PWillmore, WillmoreBounds};
use crate::energy::{conformal, p_willmore};
use crate::flow::flips::FlipReading;
use crate::flow::{Monitored, Multipliers, Pass, Status, StepReport};
use crate::geometry::measure;
use crate::interrupt;
use crate::mesh::HalfedgeMesh;
use crate::message::Message;
use crate::operator::{Elements, Mass};
use crate::remesh::adaptive::Soundness;
use crate::remesh::fill::boundary_loops;
use glam::DVec3;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use std::rc::Rc;

/// Diagnosis card of a mesh.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Info {
    /// Number of vertices.
    pub vertices: usize,
    /// Number of edges.
    pub edges: usize,
    /// Number of faces, of any degree.
    pub faces: usize,
    /// Number of connected components.
    pub components: usize,
    /// Number of boundary loops; of holes that touch in a vertex each counts.
    pub boundary_loops: usize,
    /// V − E + F.
    pub euler_characteristic: i64,
    /// Summed over components with loops capped; none if not orientable.
    pub genus: Option<i64>,
    /// Whether there is no boundary.
    pub closed: bool,
    /// Whether the faces are, or could be, consistently oriented.
    pub oriented: bool,
    /// Total area.
    pub area: f64,
    /// Signed volume, of a closed oriented surface.
    pub volume: Option<f64>,
    /// Mean edge length.
    pub mean_edge_length: f64,
    /// Smallest corner angle.
    pub min_angle_degrees: f64,
    /// Pairs of triangles that pass through each other, see
    /// [`self_intersection`](crate::geometry::self_intersection); `None` where there are too
    /// many triangles to be compared in about a second.
    pub self_intersections: Option<usize>,
    /// What was repaired or is worth knowing.
    pub warnings: Vec<Message>,
    /// What a repair does to the file: what was safe, and done when it was opened, and what
    /// [`Session::repair`](super::Session::repair) would change now.
    pub repairs: Vec<RepairItem>,
    /// A length within which a weld closes gaps that the usual repair leaves; see
    /// [`gap`](crate::remesh::repair::gap). Left out where there is none.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub gap: Option<f64>,
}

impl Info {
    /// The card of a mesh, less its repairs; `triangles` is the same cut into triangles.
    pub fn of(
        mesh: &Rc<HalfedgeMesh>,
        triangles: &HalfedgeMesh,
        x: &[DVec3],
        warnings: &[Message],
    ) -> Self {
        let self_intersections = crossing::count(triangles, x);
        interrupt::pulse();
        let mut warnings = warnings.to_vec();
        if let Some(n) = self_intersections.filter(|&n| n > 0) {
            warnings.push(Notice::SelfIntersections { count: n }.into());
        }
        let quads = quadrilateral_integrals(mesh, x, 2.0);
        let volume = measure::volume(mesh, x);
        Self {
            vertices: mesh.n_vertices(),
            edges: mesh.n_edges(),
            faces: mesh.n_faces(),
            components: mesh.components().1,
            boundary_loops: boundary_loops(mesh, x).len(),
            euler_characteristic: mesh.euler_characteristic(),
            genus: mesh.genus(),
            closed: mesh.is_closed(),
            oriented: mesh.is_oriented(),
            area: quads.map_or_else(|| measure::area(mesh, x), |q| q.area),
            volume: volume.map(|v| quads.map_or(v, |q| q.volume)),
            mean_edge_length: measure::mean_edge_length(mesh, x),
            min_angle_degrees: measure::min_angle_degrees(mesh, x),
            self_intersections,
            warnings,
            repairs: Vec::new(),
            gap: None,
        }
    }
}

/// Which energies. Unknown names are refused.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase", default, deny_unknown_fields)]
pub struct EnergyOptions {
    /// Exponents beside the usual ones.
    pub p: Vec<f64>,
    /// What holds at the boundary.
    pub boundary: Boundary,
}

/// All energies and integrals of a surface.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct EnergyReadings {
    /// W = Σ W_i as printed by Bobenko & Schröder.
    pub circle: f64,
    /// W/2, which tends to ∫(H² − K) dA on curvature-aligned lattices.
    pub circle_normalised: f64,
    /// ∫H² dA, H = (κ₁+κ₂)/2, with the lumped mass.
    pub willmore: f64,
    /// The same with the consistent mass, never less. Where they part by more than a few per
    /// cent, the mesh does not resolve its curvature.
    pub willmore_consistent: f64,
    /// ∫|H|^p dA by p.
    pub p_willmore: BTreeMap<String, f64>,
    /// Total area.
    pub area: f64,
    /// Signed volume, of a closed oriented surface.
    pub volume: Option<f64>,
    /// Σ 2(D_T − A_T) against the reference angles of Gruber & Aulisa's Algorithm 1.
    pub conformal_distortion: f64,
    /// Frobenius norm of ∇W over the vertices free under the boundary condition.
    pub gradient_norm: f64,
}

impl EnergyReadings {
    /// All readings of a triangle mesh; `free` tells which vertices may move. Where it is the
    /// copy of a mesh of quadrilaterals, `polygons`, area, volume and powers of H are those
    /// of the bilinear faces.
    pub fn of(
        mesh: &HalfedgeMesh,
        polygons: &Rc<HalfedgeMesh>,
        x: &[DVec3],
        boundary: Boundary,
        free: &[bool],
        powers: &[f64],
    ) -> Self {
        let energy = CircleEnergy::new(mesh, boundary);
        let mut evaluation = circle::Evaluation::default();
        energy.evaluate(x, Smoothing::EXACT, &mut evaluation);
        let gradient = evaluation
            .gradient
            .iter()
            .zip(free)
            .filter(|(_, free)| **free);
        let power = |p: f64| match quadrilateral_integrals(polygons, x, p) {
            Some(quads) => quads.energy / 2f64.powf(p),
            None => p_willmore::integrated_power(mesh, x, p),
        };
        let named = |p: f64| (p.to_string(), power(p));
        let quads = quadrilateral_integrals(polygons, x, 2.0);
        // Of the same faces as the lumped ones; a mesh without faces has none.
        let faces: &HalfedgeMesh = if quads.is_some() { polygons } else { mesh };
        let consistent = WillmoreBounds::of(faces, x);
        let volume = measure::volume(mesh, x);
        let standard = [0.0, 1.0, 2.0, 3.0, 4.0];
        Self {
            circle: evaluation.value,
            circle_normalised: 0.5 * evaluation.value,
            willmore: power(2.0),
            willmore_consistent: consistent.map_or(0.0, |bounds| bounds.consistent),
            p_willmore: standard.iter().chain(powers).map(|&p| named(p)).collect(),
            area: quads.map_or_else(|| measure::area(mesh, x), |q| q.area),
            volume: volume.map(|v| quads.map_or(v, |q| q.volume)),
            conformal_distortion: conformal::conformal_distortion(mesh, x),
            gradient_norm: gradient
                .map(|(g, _)| g.length_squared())
                .sum::<f64>()
                .sqrt(),
        }
    }
}

/// The integrals of a closed mesh of convex quadrilaterals, by the quadrature that flows use; `None`
/// of any other mesh.
fn quadrilateral_integrals(mesh: &Rc<HalfedgeMesh>, x: &[DVec3], p: f64) -> Option<Integrals> {
    if !mesh.is_closed() || Elements::convex(mesh, x)?.degree() != 4 {
        return None;
    }
    let functional = PWillmore::new(Rc::clone(mesh), x, p, Helfrich::default(), Mass::Lumped)?;
    Some(functional.integrals(x, &mut Evaluation::default()))
}

/// Where a session stands.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct State {
    /// Steps taken.
    pub step: usize,
    /// Flow time.
    pub time: f64,
    /// Whether and why the run is over.
    pub status: Status,
    /// The reason.
    pub message: Option<Message>,
    /// The flow's own energy, as in [`StepReport::energy`].
    pub energy: f64,
    /// See [`StepReport::energy_normalised`].
    pub energy_normalised: f64,
    /// The next step's raw size.
    pub dt: f64,
    /// The same without a unit.
    pub tau: f64,
    /// What keeps area and volume, where they are kept.
    pub multipliers: Option<Multipliers>,
    /// See [`StepReport::reduced_volume`].
    pub reduced_volume: Option<f64>,
    /// Edge flips: where each criterion stands, the chosen one first.
    pub flips: Option<Vec<FlipReading>>,
    /// Total area.
    pub area: f64,
    /// Signed volume, of a closed oriented surface.
    pub volume: Option<f64>,
    /// Pairs of triangles that pass through each other, of a surface that did so when it was opened
    /// and has not too many triangles to be looked at after every step.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub crossings: Option<usize>,
    /// Smallest corner angle.
    pub min_angle_degrees: f64,
    /// Which functional a step must not raise.
    pub monitored: Monitored,
    /// What it is.
    pub objective: f64,
    /// Norm of the objective's gradient.
    pub gradient_norm: f64,
    /// Duration of the last step.
    pub milliseconds: f64,
    /// Whether the readings can be believed, as far as was looked at last: every tenth step, after
    /// a pass and at the end of a run of the p-Willmore flow.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub soundness: Option<Soundness>,
    /// The pass of remeshing that the last step began with.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub pass: Option<Pass>,
    /// Whether an earlier state is stored.
    pub can_step_back: bool,
}

/// A column of the history: its name, and its cell of a step.
type Column = (&'static str, fn(&StepReport) -> String);

/// The history as a table, in the order of its columns. A name once given stays.
const HISTORY: &[Column] = &[
    ("step", |r| r.step.to_string()),
    ("time", |r| r.time.to_string()),
    ("dt", |r| r.dt.to_string()),
    ("tau", |r| r.tau.to_string()),
    ("energy", |r| r.energy.to_string()),
    ("objectiveBefore", |r| r.objective_before.to_string()),
    ("objective", |r| r.objective.to_string()),
    ("epsilon", |r| r.epsilon.to_string()),
    ("gradientNorm", |r| r.gradient_norm.to_string()),
    ("area", |r| r.area.to_string()),
    ("volume", |r| or_empty(r.volume)),
    ("minAngleDegrees", |r| r.min_angle_degrees.to_string()),
    ("rejected", |r| r.rejected.to_string()),
    ("iterations", |r| r.iterations.to_string()),
    ("negativePivots", |r| r.negative_pivots.to_string()),
    ("skippedAngles", |r| r.skipped_angles.to_string()),
    ("flippedFaces", |r| r.flipped_faces.to_string()),
    ("maxDisplacement", |r| r.max_displacement.to_string()),
    ("milliseconds", |r| thousandths(r.milliseconds)),
    ("assembleMilliseconds", |r| {
        thousandths(r.assemble_milliseconds)
    }),
    ("factorMilliseconds", |r| thousandths(r.factor_milliseconds)),
    ("solveMilliseconds", |r| thousandths(r.solve_milliseconds)),
    ("energyNormalised", |r| r.energy_normalised.to_string()),
    ("reducedVolume", |r| or_empty(r.reduced_volume)),
    ("tension", |r| {
        or_empty(r.multipliers.and_then(|m| m.tension))
    }),
    ("pressure", |r| {
        or_empty(r.multipliers.and_then(|m| m.pressure))
    }),
    ("regulariseMilliseconds", |r| {
        thousandths(r.regularise_milliseconds)
    }),
    ("searchMilliseconds", |r| thousandths(r.search_milliseconds)),
    ("remeshMilliseconds", |r| thousandths(r.remesh_milliseconds)),
];

fn or_empty(value: Option<f64>) -> String {
    value.map(|value| value.to_string()).unwrap_or_default()
}

fn thousandths(value: f64) -> String {
    format!("{value:.3}")
}

/// The history as comma-separated values with a header, one row a step.
pub(super) fn history_csv(reports: &[StepReport]) -> String {
    let line = |cells: Vec<String>| cells.join(",") + "\n";
    let header = line(HISTORY.iter().map(|(name, _)| (*name).into()).collect());
    let row = |report| line(HISTORY.iter().map(|(_, cell)| cell(report)).collect());
    header + &reports.iter().map(row).collect::<String>()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_column_of_the_history_holds_the_reading_of_its_name() {
        // No two readings agree, so that none can stand in another's column.
        let report = StepReport {
            step: 1,
            time: 2.5,
            dt: 3.5,
            energy: 4.5,
            energy_normalised: 5.5,
            objective_before: 6.5,
            objective: 7.5,
            gradient_norm: 8.5,
            area: 9.5,
            volume: Some(10.5),
            min_angle_degrees: 11.5,
            rejected: 12,
            iterations: 13,
            milliseconds: 14.5,
            tau: 15.5,
            epsilon: 16.5,
            negative_pivots: 17,
            skipped_angles: 18,
            flipped_faces: 19,
            max_displacement: 20.5,
            multipliers: Some(Multipliers {
                tension: Some(21.5),
                pressure: None,
            }),
            reduced_volume: Some(22.5),
            assemble_milliseconds: 23.5,
            factor_milliseconds: 24.5,
            solve_milliseconds: 25.5,
            regularise_milliseconds: 26.5,
            search_milliseconds: 27.5,
            remesh_milliseconds: 28.5,
            ..StepReport::default()
        };
        let json = serde_json::to_value(&report).expect("JSON");
        let csv = history_csv(&[report]);
        let lines: Vec<Vec<&str>> = csv.lines().map(|line| line.split(',').collect()).collect();
        assert_eq!(lines.len(), 2);
        assert_eq!((lines[0].len(), lines[1].len()), (29, 29));
        for (name, cell) in lines[0].iter().zip(&lines[1]) {
            let reading = json.get(name).unwrap_or(&json["multipliers"][name]);
            let cell = cell.parse::<f64>().ok();
            assert_eq!(cell, reading.as_f64(), "{name}");
        }
    }
}
