//! What is studied, and how it is made finer.

use super::Limits;
use super::exact::Exact;
use crate::app::fault::Fault;
use crate::mesh::shape;
use crate::mesh::subdivide::{loop_limit, loop_scheme};
use crate::soup::PolygonSoup;
use serde::Serialize;
use std::collections::BTreeMap;

/// How a surface is refined.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub enum RefinedBy {
    /// A smooth shape, sampled anew.
    Sampled,
    /// A polyhedron, its faces split: the surface stays what it is, with its edges.
    Polyhedron,
    /// The limit surface of Loop's scheme.
    Loop,
}

use RefinedBy::{Polyhedron, Sampled};

/// Shapes that are the same surface at every resolution, and the counts that set it. Not
/// among them are those whose noise or damage is measured in edge lengths.
const REFINED: &[(&str, &[&str], RefinedBy)] = &[
    ("icosphere", &["level"], Sampled),
    ("icosahedron", &["level"], Polyhedron),
    ("octahedron", &["level"], Polyhedron),
    ("tetrahedron", &["level"], Polyhedron),
    ("uv-sphere", &["rings", "segments"], Sampled),
    ("ellipsoid", &["level"], Sampled),
    ("bumpy-sphere", &["level"], Sampled),
    ("dumbbell", &["level"], Sampled),
    ("hemisphere", &["rings"], Sampled),
    ("torus", &["around", "tube"], Sampled),
    ("sampled-torus", &["around", "tube"], Sampled),
    ("clifford-torus", &["around", "tube"], Sampled),
    ("lattice-torus", &["columns", "rows"], Sampled),
    ("coarse-torus", &["level"], Polyhedron),
    ("letter-c", &["level"], Polyhedron),
    ("trefoil", &["along", "around"], Sampled),
    ("torus-knot", &["along", "around"], Sampled),
    ("klein-bottle", &["along", "around"], Sampled),
    ("moebius", &["around", "across"], Sampled),
    ("cylinder", &["around", "along"], Sampled),
    ("disk", &["rings"], Sampled),
    ("hyperbolic-paraboloid", &["cells"], Sampled),
    ("monkey-saddle", &["rings"], Sampled),
];

/// Resolutions that an order of convergence takes.
const WANTED: usize = 3;

/// A surface that can be had at any resolution.
pub(super) enum Subject {
    Shape {
        name: &'static str,
        refined_by: RefinedBy,
        counts: &'static [&'static str],
        /// Of the coarsest resolution.
        values: BTreeMap<String, f64>,
    },
    /// A control mesh, subdivided as often as the last level asked for.
    Surface { soup: PolygonSoup, level: usize },
}

impl Subject {
    pub(super) fn surface(soup: PolygonSoup) -> Self {
        Self::Surface { soup, level: 0 }
    }

    /// A shape from so coarse a resolution that three fit into the limits.
    pub(super) fn shape(
        name: &str,
        parameters: &BTreeMap<String, f64>,
        limits: Limits,
    ) -> Result<Self, Fault> {
        let pairs: Vec<(String, f64)> = parameters.clone().into_iter().collect();
        let asked = shape::make(name, &pairs)?.soup;
        let Some(&(name, counts, refined_by)) = REFINED.iter().find(|(known, ..)| *known == name)
        else {
            return Ok(Self::surface(asked));
        };
        let defaults = shape::all().iter().find(|shape| shape.name == name);
        let mut values: BTreeMap<String, f64> = defaults
            .iter()
            .flat_map(|shape| shape.parameters)
            .map(|parameter| (parameter.name.to_owned(), parameter.default))
            .collect();
        values.extend(parameters.clone());
        let mut size = asked.positions.len();
        while size << (2 * (WANTED - 1)) > limits.vertices {
            match refined(&values, counts, -1) {
                Some(coarser) => values = coarser,
                None => break,
            }
            size /= 4;
        }
        Ok(Self::Shape {
            name,
            refined_by,
            counts,
            values,
        })
    }

    pub(super) fn refined_by(&self) -> RefinedBy {
        match self {
            Self::Shape { refined_by, .. } => *refined_by,
            Self::Surface { .. } => RefinedBy::Loop,
        }
    }

    pub(super) fn exact(&self, p: f64) -> Option<Exact> {
        match self {
            Self::Shape { name, values, .. } => Exact::of(name, values, p),
            Self::Surface { .. } => None,
        }
    }

    /// The mesh of a level; levels are asked for in order.
    pub(super) fn at(&mut self, wanted: usize) -> Result<PolygonSoup, Fault> {
        match self {
            Self::Shape {
                name,
                counts,
                values,
                ..
            } => {
                let finer = refined(values, counts, wanted as i32).unwrap_or_default();
                let pairs: Vec<(String, f64)> = finer.into_iter().collect();
                Ok(shape::make(name, &pairs)?.soup)
            }
            Self::Surface { soup, level } => {
                while *level < wanted {
                    *soup = loop_scheme(soup)?;
                    *level += 1;
                }
                Ok(loop_limit(soup)?)
            }
        }
    }
}

/// The values with h halved `levels` times, or doubled where that is negative; `None` where
/// the counts cannot be halved any more.
fn refined(
    values: &BTreeMap<String, f64>,
    counts: &[&str],
    levels: i32,
) -> Option<BTreeMap<String, f64>> {
    let mut finer = values.clone();
    for &count in counts {
        let value = finer.get_mut(count)?;
        *value = if count == "level" {
            *value + f64::from(levels)
        } else {
            *value * 2f64.powi(levels)
        };
        // Coarser than this nothing is to be learned of a shape, nor is half a count one.
        let least = if count == "level" { 1.0 } else { 6.0 };
        if value.fract() != 0.0 || (levels < 0 && *value < least) {
            return None;
        }
    }
    Some(finer)
}
