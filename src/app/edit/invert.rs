//! Möbius inversion: another surface with the same circle-angle energy.

use crate::app::document::Document;
use crate::app::fault::Fault;
use crate::app::field::{Field, FieldName};
use crate::app::look::{Look, LookOptions};
use crate::app::message::AppError;
use crate::app::provenance::Edit;
use crate::app::runner::Runner;
use crate::app::{Loaded, Session, as_f32};
use crate::arrays::TypedArray;
use crate::energy::circle::angle::Smoothing;
use crate::energy::circle::{Boundary, CircleEnergy};
use crate::energy::p_willmore;
use crate::geometry::inversion::{Inversion, distance_to_surface};
use crate::geometry::measure;
use crate::mesh::HalfedgeMesh;
use glam::DVec3;
use serde::Serialize;
use std::f64::consts::TAU;

/// Least distance of the centre from the surface, in diagonals of its bounding box. What lies
/// there is stretched over the whole picture and the rest is crowded where infinity goes: the
/// digits lost there are as many as the distance has zeros. At this distance W still
/// stays within 10⁻¹² of the sum of its angles (90,000 vertices; `tests/suite/moebius.rs`).
const NEAREST: f64 = 1e-3;

/// Largest distance of the centre from the middle, in the same unit: beyond, the surface is
/// not seen to change, and digits are lost for nothing.
const FARTHEST: f64 = 1e3;

/// What an inversion leaves and what it changes.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct InversionReadings {
    /// W over interior vertices, made of angles between circles through vertices: invariant.
    pub circle: f64,
    /// Of an open surface W with a vertex at infinity closing each boundary loop. An inversion
    /// takes infinity to a point, and another vertex closes the loop: not invariant.
    pub circle_closed: Option<f64>,
    /// ∫H² dA by the lumped formula. It is invariant on smooth closed surfaces; a mesh has it
    /// up to the error of discretisation.
    pub willmore: f64,
    /// Total area.
    pub area: f64,
}

impl InversionReadings {
    /// `energy` over interior vertices, `closed` with loops closed at infinity.
    fn of(
        mesh: &HalfedgeMesh,
        energy: &CircleEnergy,
        closed: Option<&CircleEnergy>,
        x: &[DVec3],
    ) -> Self {
        Self {
            circle: energy.value(x, Smoothing::EXACT),
            circle_closed: closed.map(|energy| energy.value(x, Smoothing::EXACT)),
            willmore: p_willmore::integrated_power(mesh, x, 2.0),
            area: measure::area(mesh, x),
        }
    }
}

/// An inversion in numbers.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct InversionReport {
    /// Its centre, in the coordinates of the file.
    pub centre: [f64; 3],
    /// Radius of the sphere with which the surface keeps its size.
    pub radius: f64,
    /// Whether a reflection follows, so that normals point where they did.
    pub mirrored: bool,
    /// Distance of the centre from the surface, in diagonals of its bounding box.
    pub distance: f64,
    /// Of the surface at hand.
    pub before: InversionReadings,
    /// Of its image.
    pub after: InversionReadings,
    /// Sum of all angles, W + 2πN: what the rounding of W is measured by.
    pub angles: f64,
    /// Largest change of a W_i.
    pub largest_change: f64,
}

/// A surface inverted, to look at.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Inverted {
    /// What changes.
    pub report: InversionReport,
    /// Three coordinates a vertex.
    pub positions: TypedArray<f32>,
    /// The colours asked for.
    pub field: Option<Field>,
    /// What is drawn over it: circles stay circles.
    pub look: Look,
}

impl Session {
    /// The surface as it is now, inverted in a sphere about `centre`, which is given from the
    /// middle of its bounding box in diagonals of it. Nothing changes; `field` as in
    /// [`field`](Self::field), `options` as in [`look`](Self::look).
    ///
    /// # Errors
    /// `CentreTooNear`, `CentreTooFar`, unknown fields.
    pub fn preview_inversion(
        &self,
        centre: [f64; 3],
        field: Option<FieldName>,
        options: LookOptions,
    ) -> Result<Inverted, Fault> {
        let runner = self.runner()?;
        let (x, report) = runner.inverted(centre)?;
        let field = field.map(|name| runner.field_at(name, &x)).transpose()?;
        Ok(Inverted {
            report,
            positions: as_f32(&x).into(),
            field,
            look: runner.look(options, &x),
        })
    }

    /// Makes that surface the start of what comes; [`undo_edit`](Self::undo_edit) undoes it.
    ///
    /// # Errors
    /// As [`preview_inversion`](Self::preview_inversion); the surface stays as it was.
    pub fn invert(&mut self, centre: [f64; 3]) -> Result<(Loaded, InversionReport), Fault> {
        let report = self.edit(Edit::Invert(centre), |runner| {
            let (start, report) = runner.inverted(centre)?;
            let document = runner.present();
            Ok((Document { start, ..document }, report))
        })?;
        Ok((self.loaded()?, report))
    }
}

impl Runner {
    fn inverted(&self, centre: [f64; 3]) -> Result<(Vec<DVec3>, InversionReport), Fault> {
        let (mesh, x) = (self.triangles(), &self.x);
        let (low, high) = measure::bounding_box(x);
        let (middle, size) = (0.5 * (low + high), (high - low).length());
        let from_middle = DVec3::from_array(centre);
        let centre = middle + size * from_middle;
        if !from_middle.is_finite() || from_middle.length() > FARTHEST || size <= 0.0 {
            return Err(AppError::CentreTooFar { most: FARTHEST }.into());
        }
        let distance = distance_to_surface(mesh, x, centre) / size;
        if distance.is_nan() || distance < NEAREST {
            let error = AppError::CentreTooNear {
                percent: 100.0 * distance,
                least: 100.0 * NEAREST,
            };
            return Err(error.into());
        }
        let map = Inversion::framed(mesh, x, centre);
        let y: Vec<DVec3> = x.iter().map(|&p| map.apply(p)).collect();
        let energy = CircleEnergy::new(mesh, Boundary::Clamped);
        let (at_x, at_y) = (energy.vertex_energies(x), energy.vertex_energies(&y));
        let changes = at_x.iter().zip(&at_y).map(|(a, b)| (a - b).abs());
        let closed = (!mesh.is_closed()).then(|| CircleEnergy::new(mesh, Boundary::Free));
        let readings = |x: &[DVec3]| InversionReadings::of(mesh, &energy, closed.as_ref(), x);
        let (before, after) = (readings(x), readings(&y));
        let report = InversionReport {
            centre: (centre + self.document.frame.shift).to_array(),
            radius: map.radius,
            mirrored: map.mirror.is_some(),
            distance,
            before,
            after,
            angles: before.circle + TAU * energy.n_counted() as f64,
            largest_change: changes.fold(0.0, f64::max),
        };
        Ok((y, report))
    }
}
