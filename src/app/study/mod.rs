//! A refinement study: the same surface at several resolutions, and what its energies tend to.
//!
//! Each level halves the mesh width h. A sample shape is sampled anew; any other surface is
//! replaced by the limit surface of Loop's scheme, sampled ever more finely: splitting edges
//! at their midpoints would get no closer to a smooth surface.
//!
//! What is known: the area converges with order h² (Morvan & Thibert
//! [MT04](crate::bibliography#mt04) where angles do not tend to 0). ∫H² by cotangents and by fits
//! converges on meshes of fixed shape. The circle energy W/2 tends to ∫(H² − K) dA on
//! right-angled lattices along the lines of curvature, to a multiple of it on others, and is
//! unbounded where triangles are not Delaunay ([BS05](crate::bibliography#bs05), Section 2). And of
//! minimisers: that the values converge on given meshes does not let minimisers converge;
//! minimising any of the piecewise-linear Willmore energies proposed so far fails to converge to
//! a solution of the smooth problem (Chen, Yu, Brogan, Kusner, Yang & Zigerelli
//! [CYBKYZ19](crate::bibliography#cybkyz19)).

mod exact;
mod subject;
mod trend;

pub use subject::RefinedBy;
pub use trend::{Tendency, Trend};

use super::Session;
use super::fault::Fault;
use super::message::AppError;
use crate::energy::circle::angle::Smoothing;
use crate::energy::circle::{Boundary, CircleEnergy};
use crate::energy::p_willmore::integrated_power;
use crate::geometry::measure;
use crate::mesh;
use crate::message::Message;
use crate::operator::FittedOperators;
use exact::Exact;
use glam::DVec3;
use serde::{Deserialize, Serialize};
use std::collections::BTreeMap;
use subject::Subject;

/// How far a study goes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Limits {
    /// Vertices of the finest mesh at most.
    pub vertices: usize,
    /// Resolutions at most.
    pub levels: usize,
}

impl Default for Limits {
    fn default() -> Self {
        Self {
            vertices: 100_000,
            levels: 4,
        }
    }
}

/// What is studied.
#[derive(Clone, Debug, Default, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase", default, deny_unknown_fields)]
pub struct StudyOptions {
    /// A sample shape by name; the present surface if absent.
    pub shape: Option<String>,
    /// Its parameters.
    pub parameters: BTreeMap<String, f64>,
    /// Exponent of ∫|H|^p dA.
    pub p: Option<f64>,
}

/// The surface at one resolution; the trends have its energies for who only shows them.
#[derive(Clone, Copy, Debug, Default, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Resolution {
    /// Vertices.
    pub vertices: usize,
    /// Triangles.
    #[serde(skip)]
    pub faces: usize,
    /// Mean edge length.
    pub h: f64,
    /// Area.
    #[serde(skip)]
    pub area: f64,
    /// Half the circle-angle energy, ½ Σ W_i over interior vertices; no unit.
    #[serde(skip)]
    pub circle: f64,
    /// ∫H² dA by cotangents, over interior vertices.
    #[serde(skip)]
    pub cotangent: f64,
    /// ∫H² dA by quadratic fits, Σ m_i H_i² with m_i a third of the area about vertex i.
    #[serde(skip)]
    pub fitted: f64,
    /// ∫|H|^p dA by cotangents, unit length^(2−p).
    #[serde(skip)]
    pub power: f64,
    /// ∫K dA by quadratic fits.
    #[serde(skip)]
    pub gauss: f64,
    /// Vertices that no quadratic surface fits; left out of what is fitted.
    #[serde(skip)]
    pub unfit: usize,
}

impl Resolution {
    fn of(built: &mesh::Built, p: f64) -> Self {
        let (mesh, x): (_, &[DVec3]) = (&built.mesh, &built.positions);
        let areas = measure::vertex_areas(mesh, x);
        let operators = FittedOperators::everywhere(mesh, x);
        let rows = (0..x.len()).filter_map(|v| Some((operators.row(v)?, areas[v])));
        let (mut fitted, mut gauss, mut fits) = (0.0, 0.0, 0);
        for (row, area) in rows {
            fitted += area * operators.mean_curvature(row, x).powi(2);
            gauss += area * operators.gauss_curvature(row, x);
            fits += 1;
        }
        let circle = CircleEnergy::new(mesh, Boundary::Clamped);
        Self {
            vertices: mesh.n_vertices(),
            faces: mesh.n_faces(),
            h: measure::mean_edge_length(mesh, x),
            area: measure::area(mesh, x),
            circle: 0.5 * circle.value(x, Smoothing::EXACT),
            cotangent: integrated_power(mesh, x, 2.0),
            fitted,
            power: integrated_power(mesh, x, p),
            gauss,
            unfit: x.len() - fits,
        }
    }
}

/// A study as far as it has come.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct StudyReport {
    /// How the surface is refined.
    pub refined_by: RefinedBy,
    /// Exponent of [`Resolution::power`].
    #[serde(skip)]
    pub p: f64,
    /// Coarsest first.
    pub rows: Vec<Resolution>,
    /// What each quantity tends to.
    pub trends: Vec<Trend>,
    /// Whether there is no finer one to come.
    pub finished: bool,
    /// What that means, once there is none.
    pub findings: Vec<Message>,
    /// Vertices of the finest mesh at most.
    pub most_vertices: usize,
}

/// A study under way.
pub struct Study {
    subject: Subject,
    exact: Option<Exact>,
    p: f64,
    limits: Limits,
    rows: Vec<Resolution>,
    finished: bool,
}

impl Study {
    fn new(subject: Subject, p: f64, limits: Limits) -> Self {
        Self {
            exact: subject.exact(p),
            subject,
            p,
            limits,
            rows: Vec::new(),
            finished: false,
        }
    }

    /// Of a sample shape.
    ///
    /// # Errors
    /// Unknown names and values out of range.
    pub fn of_shape(
        name: &str,
        parameters: &BTreeMap<String, f64>,
        p: f64,
        limits: Limits,
    ) -> Result<Self, Fault> {
        Ok(Self::new(
            Subject::shape(name, parameters, limits)?,
            p,
            limits,
        ))
    }

    /// The next finer resolution, if there is one.
    ///
    /// # Errors
    /// Surfaces that cannot be refined.
    pub fn refine(&mut self) -> Result<(), Fault> {
        let level = self.rows.len();
        // Of the first one the size is whatever the user has made it.
        let predicted = self.rows.last().map_or(0, |row| 4 * row.vertices);
        if level < self.limits.levels && predicted <= self.limits.vertices + 8 {
            let built = mesh::build(&self.subject.at(level)?)?;
            self.rows.push(Resolution::of(&built, self.p));
        }
        let next = self.rows.last().map_or(0, |row| 4 * row.vertices);
        self.finished = self.rows.len() >= self.limits.levels || next > self.limits.vertices + 8;
        Ok(())
    }

    fn findings(&self, trends: &[Trend]) -> Vec<Message> {
        let mut said: Vec<Message> = trends.iter().map(|trend| trend.said(self.p)).collect();
        let mut add = |name| said.push(Message::new("study", name, vec![]));
        if self.subject.refined_by() == RefinedBy::Polyhedron {
            add("Polyhedron");
        }
        let circle = trends.iter().find(|trend| trend.quantity == "circle");
        let tendency = circle.map(|trend| trend.tendency);
        if let Some(Tendency::Elsewhere | Tendency::Diverges) = tendency {
            add("Lattice");
        }
        add("Minimisers");
        said
    }

    /// What is known so far.
    pub fn report(&self) -> StudyReport {
        let trends = trend::trends(&self.rows, self.exact, self.p);
        let findings = if self.finished {
            self.findings(&trends)
        } else {
            Vec::new()
        };
        StudyReport {
            refined_by: self.subject.refined_by(),
            p: self.p,
            rows: self.rows.clone(),
            trends,
            finished: self.finished,
            findings,
            most_vertices: self.limits.vertices,
        }
    }
}

impl Session {
    /// A refinement study, one resolution a call: with `options` it begins anew. The surface,
    /// its flow and its history stay as they are.
    ///
    /// # Errors
    /// [`Fault::no_mesh`], unknown shapes, surfaces that cannot be refined, and going on with
    /// what has not begun.
    pub fn study(&mut self, options: Option<&StudyOptions>) -> Result<StudyReport, Fault> {
        if let Some(options) = options {
            let (p, limits) = (options.p.unwrap_or(2.0), Limits::default());
            self.study = Some(match &options.shape {
                Some(name) => Study::of_shape(name, &options.parameters, p, limits)?,
                None => {
                    let runner = self.runner()?;
                    let soup = runner.triangles().to_soup(&runner.x);
                    Study::new(Subject::surface(soup), p, limits)
                }
            });
        }
        let study = self.study.as_mut().ok_or(AppError::NoStudy)?;
        study.refine()?;
        Ok(study.report())
    }
}
