//! The one shape of error that leaves the crate.

use crate::flow::FlowError;
use crate::flow::option::OptionError;
use crate::io::{ReadError, WriteError};
use crate::mesh::MeshError;
use crate::mesh::shape::ShapeError;
use crate::mesh::subdivide::SubdivisionError;
use crate::remesh::fill::FillError;
use serde::Serialize;
use std::collections::BTreeMap;

/// A refusal or failure: what is wrong and where, and what to do about it.
///
/// Code switches on `kind`, never on the text.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Fault {
    /// Noun of what is wrong.
    pub kind: String,
    /// What is wrong and where.
    pub message: String,
    /// What the user can do.
    pub hint: String,
    /// The elements at fault: lists of indices by name.
    pub detail: BTreeMap<String, Vec<f64>>,
}

impl Fault {
    /// A fault without elements.
    pub fn new(kind: &str, message: impl Into<String>, hint: impl Into<String>) -> Self {
        let (message, hint) = (message.into(), hint.into());
        Self {
            kind: kind.into(),
            message,
            hint,
            detail: BTreeMap::new(),
        }
    }

    /// Nothing has been loaded.
    pub fn no_mesh() -> Self {
        Self::new(
            "NoMesh",
            "there is no mesh",
            "Open a mesh or choose a sample first.",
        )
    }

    /// A name of a format that is none.
    pub fn unknown_format(name: &str) -> Self {
        Self::new(
            "UnknownFormat",
            format!("there is no format `{name}`"),
            "obj, off, ply, ply-ascii, stl, stl-ascii or glb.",
        )
    }

    fn with(mut self, detail: impl IntoIterator<Item = (&'static str, Vec<u32>)>) -> Self {
        let numbers = |list: Vec<u32>| list.into_iter().map(f64::from).collect();
        self.detail = detail
            .into_iter()
            .map(|(name, list)| (name.into(), numbers(list)))
            .collect();
        self
    }
}

impl From<ReadError> for Fault {
    fn from(error: ReadError) -> Self {
        let mut fault = Self::new(error.kind(), error.to_string(), error.hint());
        for (name, number) in error.detail() {
            fault.detail.entry(name.into()).or_default().push(number);
        }
        fault
    }
}

impl From<WriteError> for Fault {
    fn from(error: WriteError) -> Self {
        Self::new(error.kind(), error.to_string(), error.hint())
    }
}

impl From<ShapeError> for Fault {
    fn from(error: ShapeError) -> Self {
        Self::new(error.kind(), error.to_string(), error.hint())
    }
}

impl From<MeshError> for Fault {
    fn from(error: MeshError) -> Self {
        Self::new(error.kind(), error.to_string(), error.hint()).with(error.detail())
    }
}

impl From<FlowError> for Fault {
    fn from(error: FlowError) -> Self {
        Self::new(error.kind(), error.to_string(), error.hint()).with(error.detail())
    }
}

impl From<OptionError> for Fault {
    fn from(error: OptionError) -> Self {
        Self::new(error.kind(), error.to_string(), error.hint())
    }
}

impl From<SubdivisionError> for Fault {
    fn from(error: SubdivisionError) -> Self {
        Self::new(error.kind(), error.to_string(), error.hint())
    }
}

impl From<FillError> for Fault {
    fn from(error: FillError) -> Self {
        Self::new(error.kind(), error.to_string(), error.hint()).with(error.detail())
    }
}
