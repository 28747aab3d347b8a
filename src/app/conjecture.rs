//! The conjecture about edge flips, on the mesh at hand and on random quadrilaterals.

use super::Session;
use super::fault::Fault;
use super::message::AppError;
use super::runner::Runner;
use crate::arrays::TypedArray;
use crate::mesh::{Edge, HalfedgeMesh};
use crate::order;
use crate::remesh::flips::conjecture::{Quadrants, survey};
use crate::remesh::flips::lab::{CLASSES, Lab};
use crate::remesh::flips::reduction::Quad;
use glam::DVec3;
use serde::Serialize;

/// Edges that agree are thinned out to about so many; counterexamples never are.
const SHOWN: usize = 12_000;

/// f_a against f_l for the edges of a mesh that can be flipped.
#[derive(Clone, Debug, Default, PartialEq, Serialize)]
#[serde(rename_all = "camelCase")]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct ConjectureReport {
    /// All of them, by quadrant.
    #[serde(flatten)]
    pub counts: Quadrants,
    /// Those shown: ends and apexes i, j, k, l, …
    pub corners: TypedArray<u32>,
    /// … f_a over the area of both triangles …
    pub area: TypedArray<f32>,
    /// … and f_l in radians. Counterexamples come first, the strongest of them foremost.
    pub localised: TypedArray<f32>,
    /// How many of those shown are counterexamples.
    pub counterexamples: usize,
}

/// The numbers of one quadrilateral.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct QuadReport {
    /// Positions of i, j, k, l.
    pub points: [[f64; 3]; 4],
    /// f_a.
    pub area: f64,
    /// f_l.
    pub localised: f64,
    /// Area of both triangles before the flip.
    pub total_area: f64,
    /// Angle between the normals before and after the flip, in degrees.
    pub fold_degrees: [f64; 2],
    /// Smallest angle of the triangles before and after, in degrees.
    pub min_angle_degrees: [f64; 2],
}

impl QuadReport {
    fn of(quad: &Quad, points: [DVec3; 4]) -> Self {
        let flipped = quad.flipped();
        Self {
            points: points.map(|p| p.to_array()),
            area: quad.area_reduction(),
            localised: quad.localised_reduction(),
            total_area: quad.area(),
            fold_degrees: [quad.fold_degrees(), flipped.fold_degrees()],
            min_angle_degrees: [quad.min_angle_degrees(), flipped.min_angle_degrees()],
        }
    }
}

/// A class of random quadrilaterals.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct ClassReport {
    /// Upper end of the angle between the faces, in degrees.
    pub below: f64,
    /// Quadrilaterals drawn.
    pub total: usize,
    /// Of which counterexamples.
    pub counterexamples: usize,
}

/// What the random quadrilaterals say so far.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct LabReport {
    /// Random tetrahedra drawn …
    pub tetrahedra: usize,
    /// … and those that lower the area only, or the localised energy only.
    pub counterexamples: [usize; 2],
    /// Of all quadrilaterals, flattened ones too.
    pub classes: Vec<ClassReport>,
    /// The clearest counterexample.
    pub strongest: Option<QuadReport>,
}

impl Session {
    /// f_a against f_l on the mesh as it is now.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn conjecture(&self) -> Result<ConjectureReport, Fault> {
        let runner = self.runner()?;
        Ok(report(runner.triangles(), &runner.x))
    }

    /// The numbers of the quadrilateral i, j, k, l, in the coordinates of the file.
    ///
    /// # Errors
    /// If there is no such vertex.
    pub fn quadrilateral(&self, corners: [u32; 4]) -> Result<QuadReport, Fault> {
        self.runner()?.quadrilateral(corners)
    }

    /// Draws more random quadrilaterals, so many tetrahedra and as many flattened ones, and
    /// tells of all there were; 0 begins anew.
    pub fn lab(&mut self, pairs: usize) -> LabReport {
        if pairs == 0 {
            self.lab = None;
        }
        let lab = self.lab.get_or_insert_with(|| Lab::new(1));
        lab.run(pairs);
        let class = |(counts, below): (&Quadrants, f64)| ClassReport {
            below,
            total: counts.total(),
            counterexamples: counts.counterexamples(),
        };
        let Quadrants {
            area_only,
            localised_only,
            ..
        } = lab.tetrahedra;
        LabReport {
            tetrahedra: lab.tetrahedra.total(),
            counterexamples: [area_only, localised_only],
            classes: lab.classes.iter().zip(CLASSES).map(class).collect(),
            strongest: lab
                .strongest
                .map(|(quad, _)| QuadReport::of(&quad, [quad.i, quad.j, quad.k, quad.l])),
        }
    }
}

impl Runner {
    fn quadrilateral(&self, corners: [u32; 4]) -> Result<QuadReport, Fault> {
        let points: Option<Vec<DVec3>> = corners
            .iter()
            .map(|&v| self.x.get(v as usize).copied())
            .collect();
        let Some(x) = points else {
            let corners = corners.to_vec();
            return Err(AppError::NoSuchVertex { corners }.into());
        };
        let x = self.document.frame.leave(&x);
        let quad = Quad {
            i: x[0],
            j: x[1],
            k: x[2],
            l: x[3],
        };
        Ok(QuadReport::of(&quad, [x[0], x[1], x[2], x[3]]))
    }
}

fn report(mesh: &HalfedgeMesh, x: &[DVec3]) -> ConjectureReport {
    let all = survey(mesh, x);
    let mut counts = Quadrants::default();
    all.iter().for_each(|(_, r)| counts.add(r));
    let stride = all.len().div_ceil(SHOWN).max(1);
    let mut counterexamples: Vec<_> = all.iter().filter(|(_, r)| !r.agree()).collect();
    let strength =
        |r: &crate::remesh::flips::conjecture::Reductions| r.area.abs().min(r.localised.abs());
    order::sort_by(&mut counterexamples, |(_, a), (_, b)| {
        strength(b).total_cmp(&strength(a))
    });
    let mut report = ConjectureReport {
        counts,
        counterexamples: counterexamples.len(),
        ..ConjectureReport::default()
    };
    let agreeing = all.iter().filter(|(_, r)| r.agree()).step_by(stride);
    let corners = |e: Edge| {
        let ([i, j], [k, l]) = (mesh.ends(e), mesh.opposite_vertices(e));
        [i.0, j.0, k.0, l.0]
    };
    for (e, r) in counterexamples.into_iter().chain(agreeing) {
        report.corners.extend(corners(*e));
        report.area.push(r.area as f32);
        report.localised.push(r.localised as f32);
    }
    report
}
