//! A recipe as a file: how a surface came about, and what it came to, so that it can be made
//! again and compared.

use super::Origin;
use super::error::RecipeError;
use super::script::{Estimate, Script, Start, steps_in};
use crate::app::arrangement::{Arrangement, Compare};
use crate::app::fault::Fault;
use crate::app::provenance::{Action, EditRecord, Provenance};
use crate::app::{Session, json, library};
use crate::flow::option::{Options, Values};
use crate::flow::options::FlowOptions;
use crate::flow::spec::{self, Family, FlowName};
use serde::Serialize;
use sha2::{Digest, Sha256};
use std::collections::BTreeMap;

/// The mesh a recipe begins with.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(untagged)]
pub enum RecipeMesh {
    /// A sample shape.
    Shape {
        /// Id of the sample that it is the surface of, if it is.
        #[serde(skip_serializing_if = "Option::is_none")]
        #[cfg_attr(test, ts(optional))]
        sample: Option<String>,
        /// Its name.
        shape: String,
        /// Parameters that are not the usual ones.
        parameters: BTreeMap<String, f64>,
    },
    /// A file, which a recipe names only.
    File {
        /// Its name.
        name: String,
        /// Its digest.
        sha256: String,
        /// Its length.
        bytes: usize,
    },
}

/// What came of a surface: the flow's own readings, and the fingerprint of the positions.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct ReplayResult {
    /// The flow's own energy.
    pub energy: f64,
    /// Total area.
    pub area: f64,
    /// Signed volume, of a closed oriented surface.
    pub volume: Option<f64>,
    /// Smallest corner angle.
    pub min_angle_degrees: f64,
    /// Flow time.
    pub time: f64,
    /// SHA-256 of the positions relative to the mesh's frame, as single-precision numbers with
    /// the low byte first.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[cfg_attr(test, ts(optional))]
    pub positions: Option<String>,
}

/// A recipe, as it is written.
#[derive(Clone, Debug, PartialEq, Serialize)]
pub(in crate::app) struct Recipe {
    #[serde(rename = "umbilic")]
    pub(super) version: String,
    pub(super) mesh: RecipeMesh,
    #[serde(skip_serializing_if = "Vec::is_empty")]
    pub(super) edits: Vec<EditRecord>,
    /// All options, as the flow began.
    pub(super) flow: FlowOptions,
    /// Where it is not the plain one.
    #[serde(skip_serializing_if = "Values::is_empty")]
    pub(super) arrangement: Values,
    pub(super) steps: usize,
    /// Where it is more than so many steps.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub(super) path: Option<Vec<Action>>,
    pub(super) result: ReplayResult,
}

/// What is known of a recipe before it is followed.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct RecipeCard {
    /// The version that wrote it.
    pub version: String,
    /// The mesh it begins with.
    pub mesh: RecipeMesh,
    /// The same, as the page calls what it opens.
    pub origin: Origin,
    /// Whether the mesh is the one that is shown at the start: nothing is done to it before.
    pub plain: bool,
    /// Options of the flow.
    pub flow: FlowOptions,
    /// How it is shown.
    pub arrangement: Arrangement,
    /// Steps after the last edit.
    pub steps: usize,
    /// The energy that it promises.
    pub energy: f64,
    /// What it takes to follow it.
    pub estimate: Estimate,
}

/// How what came of a recipe compares with what it promised.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct ReplayReport {
    /// Whether all of it agrees.
    pub same: bool,
    /// Whether it must agree to the last bit: the versions are the same.
    pub exact: bool,
    /// How far it may be off otherwise, relative to the larger.
    pub tolerance: f64,
    /// The version that wrote the recipe.
    pub version: String,
    /// Steps after the last edit.
    pub steps: usize,
    /// As promised.
    pub expected: ReplayResult,
    /// As it came.
    pub got: ReplayResult,
    /// Names of the readings that disagree.
    pub differing: Vec<&'static str>,
}

/// Other versions may differ in the last bits, and a flow carries that on.
const TOLERANCE: f64 = 1e-6;

/// The mesh of a sample, its holes open.
pub(in crate::app) fn mesh_of_sample(id: &str) -> Option<RecipeMesh> {
    let shape = library::sample(id)?.shape;
    let parameters = shape.parameters.iter();
    Some(RecipeMesh::Shape {
        sample: Some(id.into()),
        shape: shape.name.into(),
        parameters: parameters.map(|(name, x)| ((*name).into(), *x)).collect(),
    })
}

impl RecipeMesh {
    /// Of what the page has open; `None` where its digest is not known.
    fn of(origin: &Origin) -> Option<Self> {
        match origin {
            Origin::Sample { id } => mesh_of_sample(id),
            Origin::Shape { shape, parameters } => Some(Self::Shape {
                sample: None,
                shape: shape.clone(),
                parameters: parameters.clone(),
            }),
            Origin::File {
                file,
                sha256,
                bytes,
                ..
            } => Some(Self::File {
                name: file.clone()?,
                sha256: sha256.clone().filter(|digits| !digits.is_empty())?,
                bytes: (*bytes)?,
            }),
        }
    }

    fn origin(&self) -> Origin {
        match self {
            // A sample that is another by now is a shape like any other.
            Self::Shape {
                sample: Some(id), ..
            } if mesh_of_sample(id).as_ref() == Some(self) => Origin::Sample { id: id.clone() },
            Self::Shape {
                shape, parameters, ..
            } => Origin::Shape {
                shape: shape.clone(),
                parameters: parameters.clone(),
            },
            Self::File {
                name,
                sha256,
                bytes,
            } => Origin::File {
                name: name
                    .rsplit_once('.')
                    .map_or(&**name, |(stem, _)| stem)
                    .into(),
                file: Some(name.clone()),
                sha256: Some(sha256.clone()),
                bytes: Some(*bytes),
            },
        }
    }

    pub(in crate::app) fn start(&self) -> Start {
        match self {
            Self::Shape {
                shape, parameters, ..
            } => Start::Shape {
                name: shape.clone(),
                parameters: parameters.clone().into_iter().collect(),
            },
            Self::File { name, sha256, .. } => Start::File {
                name: Some(name.clone()),
                sha256: Some(sha256.clone()),
            },
        }
    }
}

impl Recipe {
    /// As a file.
    pub(in crate::app) fn write(&self) -> String {
        json::indented(self) + "\n"
    }

    /// What was done after the last edit.
    fn actions(&self) -> Vec<Action> {
        match &self.path {
            Some(path) => path.clone(),
            None => Vec::from_iter((self.steps > 0).then_some(Action::Steps(self.steps))),
        }
    }

    pub(in crate::app) fn script(&self) -> Script {
        Script {
            start: self.mesh.start(),
            edits: self.edits.clone(),
            path: self.actions(),
        }
    }

    fn card(&self) -> RecipeCard {
        let origin = self.mesh.origin();
        // The page shows some samples filled.
        let is_filled = match &origin {
            Origin::Sample { id } => {
                library::sample(id).is_some_and(|sample| sample.holes.options().is_some())
            }
            _ => false,
        };
        let is_shape = matches!(origin, Origin::Shape { .. });
        // Its options were checked when it was read.
        let arrangement = crate::flow::option::options_of(&self.arrangement).unwrap_or_default();
        RecipeCard {
            version: self.version.clone(),
            plain: self.edits.is_empty() && !is_filled && !is_shape,
            mesh: self.mesh.clone(),
            origin,
            flow: self.flow.clone(),
            arrangement,
            steps: self.steps,
            energy: self.result.energy,
            estimate: Estimate::of(&self.edits, steps_in(&self.actions())),
        }
    }

    /// Compares what came of it.
    pub(super) fn compare(&self, got: ReplayResult) -> ReplayReport {
        let expected = self.result.clone();
        let exact = self.version == env!("CARGO_PKG_VERSION");
        let agree = |a: f64, b: f64| match exact {
            true => a.to_bits() == b.to_bits(),
            false => is_near(a, b, TOLERANCE),
        };
        let volumes = match (expected.volume, got.volume) {
            (Some(a), Some(b)) => agree(a, b),
            (a, b) => a == b,
        };
        // Bits of positions can only agree where all bits must.
        let positions =
            !exact || expected.positions.is_none() || expected.positions == got.positions;
        let differing = [
            ("energy", agree(expected.energy, got.energy)),
            ("area", agree(expected.area, got.area)),
            ("volume", volumes),
            (
                "minAngleDegrees",
                agree(expected.min_angle_degrees, got.min_angle_degrees),
            ),
            ("time", agree(expected.time, got.time)),
            ("positions", positions),
        ];
        let differing = differing.into_iter().filter(|(_, same)| !same);
        let differing: Vec<&str> = differing.map(|(name, _)| name).collect();
        ReplayReport {
            same: differing.is_empty(),
            exact,
            tolerance: TOLERANCE,
            version: self.version.clone(),
            steps: self.steps,
            expected,
            got,
            differing,
        }
    }
}

/// Whether two numbers differ by no more than a share of the larger.
pub(in crate::app) fn is_near(a: f64, b: f64, share: f64) -> bool {
    (a - b).abs() <= share * a.abs().max(b.abs()).max(f64::MIN_POSITIVE)
}

/// Whether a path is so many steps and nothing else.
pub(in crate::app) fn is_plain(path: &[Action]) -> bool {
    path.iter()
        .all(|action| matches!(action, Action::Steps(count) if *count > 0))
}

/// SHA-256 in hexadecimal digits.
pub(in crate::app) fn sha256(bytes: &[u8]) -> String {
    let digest = Sha256::digest(bytes);
    digest.iter().map(|byte| format!("{byte:02x}")).collect()
}

impl Session {
    /// What is known of a recipe.
    ///
    /// # Errors
    /// What is wrong with it, and where.
    pub fn read_recipe(&self, text: &str) -> Result<RecipeCard, Fault> {
        Ok(Recipe::read(text)?.card())
    }

    /// How the present surface came about, as a file.
    ///
    /// # Errors
    /// Where the beginning is not known any more, or no flow was chosen.
    pub fn write_recipe(&self, origin: Option<&Origin>) -> Result<String, Fault> {
        let mesh = origin.and_then(RecipeMesh::of);
        let mesh = mesh.ok_or(RecipeError::OriginUnknown)?;
        let Provenance { edits, flow, path } = self.provenance()?;
        let flow = flow.ok_or(RecipeError::NoFlow)?;
        let recipe = Recipe {
            version: env!("CARGO_PKG_VERSION").into(),
            mesh,
            edits,
            flow,
            arrangement: self.runner()?.arrangement_that_matters(),
            steps: steps_in(&path) as usize,
            path: (!is_plain(&path)).then_some(path),
            result: self.replay_result()?,
        };
        Ok(recipe.write())
    }

    /// How the present surface compares with what a recipe promised.
    ///
    /// # Errors
    /// As [`read_recipe`](Self::read_recipe); [`Fault::no_mesh`].
    pub fn compare_recipe(&self, text: &str) -> Result<ReplayReport, Fault> {
        Ok(Recipe::read(text)?.compare(self.replay_result()?))
    }

    fn replay_result(&self) -> Result<ReplayResult, Fault> {
        let state = self.state()?;
        let bytes = self.positions()?.into_iter().flat_map(f32::to_le_bytes);
        Ok(ReplayResult {
            energy: state.energy,
            area: state.area,
            volume: state.volume,
            min_angle_degrees: state.min_angle_degrees,
            time: state.time,
            positions: Some(sha256(&bytes.collect::<Vec<u8>>())),
        })
    }
}

impl crate::app::runner::Runner {
    /// Of the arrangement, what is not as usual and changes what is seen.
    pub(in crate::app) fn arrangement_that_matters(&self) -> Values {
        let (ours, plain) = (&self.arrangement, Arrangement::PLAIN);
        let flow = self.options().flow;
        let is_flips = flow == FlowName::Flips;
        let compares = match ours.compare {
            Compare::None => false,
            Compare::Flows => spec::of(flow).family == Family::Curvature,
            Compare::Start | Compare::Criteria => is_flips,
        };
        let rows = Arrangement::ROWS.iter();
        let matter = rows.filter(|row| match row.name {
            "compare" => compares,
            _ => is_flips && (row.get)(ours) != (row.get)(&plain),
        });
        matter
            .map(|row| (row.name.into(), (row.get)(ours)))
            .collect()
    }
}
