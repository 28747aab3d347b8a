//! How a surface came about: what was done to it, in turn, so that it can be done again.

use super::edit::options::{
    FillOptions, FlipOptions, RemeshOptions, RepairOptions, SubdivideOptions,
};
use crate::flow::options::FlowOptions;
use crate::remesh::static_pass::RegulariseOptions;
use serde::{Deserialize, Serialize};

/// What was done to a surface, in turn.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub enum Action {
    /// So many steps.
    Steps(usize),
    /// A conformal regularisation of the mesh at rest.
    Regularise(RegulariseOptions),
    /// The flow is made anew where it stands: it knows nothing of earlier steps.
    Anew,
    /// From here on another flow, or the same with other parameters.
    Flow(Box<FlowOptions>),
}

/// What made another mesh of the one at hand.
#[derive(Clone, Debug, PartialEq, Deserialize, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub enum Edit {
    /// The surface as it was became the start.
    Adopt,
    /// Holes were filled.
    Fill(FillOptions),
    /// Connectivity was optimised.
    Flip(FlipOptions),
    /// What keeps it from being a whole surface was repaired; before all else it is the file that
    /// was, which need not be a surface.
    Repair(RepairOptions),
    /// Faces were divided into four.
    Subdivide(SubdivideOptions),
    /// It got other triangles.
    Remesh(RemeshOptions),
    /// The surface was inverted in a sphere: its centre, in the units of [`Session::invert`](crate::app::Session::invert).
    Invert([f64; 3]),
}

/// A run, and the edit that ended it.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct EditRecord {
    /// Options of the flow; absent where none was chosen.
    pub flow: Option<FlowOptions>,
    /// What was done.
    pub path: Vec<Action>,
    /// The edit.
    pub edit: Edit,
}

impl EditRecord {
    /// The repair of what was loaded, before anything else was done with it.
    pub(super) fn repair(&self) -> Option<RepairOptions> {
        match self.edit {
            Edit::Repair(options) if self.flow.is_none() && self.path.is_empty() => Some(options),
            _ => None,
        }
    }
}

/// How the present surface came about.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Provenance {
    /// What made the mesh of the one that was loaded, oldest first.
    pub edits: Vec<EditRecord>,
    /// Options of the flow it began with; absent where none was chosen.
    pub flow: Option<FlowOptions>,
    /// What was done since.
    pub path: Vec<Action>,
}
