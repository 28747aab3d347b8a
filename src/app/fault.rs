//! The one shape of error that leaves the crate.

use super::message::AppError;
use super::repairs::RepairItem;
use crate::flow::FlowError;
use crate::flow::option::OptionError;
use crate::interrupt::Interrupted;
use crate::io::{Format, ReadError, WriteError};
use crate::mesh::MeshError;
use crate::mesh::shape::ShapeError;
use crate::mesh::subdivide::SubdivisionError;
use crate::message::{Message, Say};
use crate::remesh::adaptive::RemeshError;
use crate::remesh::fill::FillError;
use crate::remesh::static_pass::RegulariseError;
use serde::Serialize;
use std::collections::BTreeMap;

/// A refusal or failure: what is wrong and where, and what to do about it.
///
/// Code switches on `kind`, never on the message.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Fault {
    /// Noun of what is wrong.
    pub kind: &'static str,
    /// What is wrong and where.
    pub message: Message,
    /// What the user can do.
    pub hint: Message,
    /// The elements at fault: lists of indices by name.
    pub detail: BTreeMap<&'static str, Vec<f64>>,
    /// Of a file that is no surface, or a surface that is not whole: what a repair would change.
    #[serde(skip_serializing_if = "<[RepairItem]>::is_empty")]
    #[cfg_attr(test, ts(as = "Option<Vec<RepairItem>>", optional))]
    pub repairs: Box<[RepairItem]>,
}

impl Fault {
    /// A fault without elements.
    pub fn new(said: &impl Say) -> Self {
        Self {
            kind: said.kind(),
            message: said.message(),
            hint: said.hint(),
            detail: BTreeMap::new(),
            repairs: Box::default(),
        }
    }

    /// Nothing has been loaded.
    pub fn no_mesh() -> Self {
        AppError::NoMesh.into()
    }

    /// The format of a name.
    ///
    /// # Errors
    /// If no format that is written has it.
    pub fn format_named(name: &str) -> Result<Format, Self> {
        let unknown = || AppError::UnknownFormat {
            name: name.into(),
            known: Format::written().map(Format::name).collect(),
        };
        Format::from_name(name).ok_or_else(|| unknown().into())
    }

    fn with(mut self, detail: impl IntoIterator<Item = (&'static str, Vec<u32>)>) -> Self {
        let numbers = |list: Vec<u32>| list.into_iter().map(f64::from).collect();
        self.detail = detail
            .into_iter()
            .map(|(name, list)| (name, numbers(list)))
            .collect();
        self
    }
}

impl From<Interrupted> for Fault {
    fn from(_: Interrupted) -> Self {
        AppError::Cancelled.into()
    }
}

impl From<AppError> for Fault {
    fn from(error: AppError) -> Self {
        Self::new(&error)
    }
}

impl From<ReadError> for Fault {
    fn from(error: ReadError) -> Self {
        let mut fault = Self::new(&error);
        for (name, number) in error.detail() {
            fault.detail.entry(name).or_default().push(number);
        }
        fault
    }
}

impl From<WriteError> for Fault {
    fn from(error: WriteError) -> Self {
        Self::new(&error)
    }
}

impl From<ShapeError> for Fault {
    fn from(error: ShapeError) -> Self {
        Self::new(&error)
    }
}

impl From<OptionError> for Fault {
    fn from(error: OptionError) -> Self {
        Self::new(&error)
    }
}

impl From<SubdivisionError> for Fault {
    fn from(error: SubdivisionError) -> Self {
        Self::new(&error)
    }
}

impl From<RemeshError> for Fault {
    fn from(error: RemeshError) -> Self {
        Self::new(&error)
    }
}

impl From<RegulariseError> for Fault {
    fn from(error: RegulariseError) -> Self {
        Self::new(&error)
    }
}

impl From<MeshError> for Fault {
    fn from(error: MeshError) -> Self {
        Self::new(&error).with(error.detail())
    }
}

impl From<FlowError> for Fault {
    fn from(error: FlowError) -> Self {
        Self::new(&error).with(error.detail())
    }
}

impl From<FillError> for Fault {
    fn from(error: FillError) -> Self {
        Self::new(&error).with(error.detail())
    }
}
