//! The mesh among the files that were opened together.

use super::fault::Fault;
use crate::arrays::TypedArray;
use crate::io::packed::{File, Found, UnpackError, mesh_among};
use serde::{Deserialize, Serialize};
use std::borrow::Cow;

/// A file that was opened.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct OpenedFile {
    /// What it is called.
    pub name: String,
    /// What is in it.
    pub bytes: TypedArray<u8>,
}

/// The mesh among files.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Unpacked {
    /// What it is called, without folders and without `.gz`.
    pub name: String,
    /// What is in it, out of whatever it was packed in.
    pub bytes: TypedArray<u8>,
    /// Further meshes, which were not taken.
    pub others: Vec<String>,
}

impl From<UnpackError> for Fault {
    fn from(error: UnpackError) -> Self {
        Self::new(&error)
    }
}

/// Finds it.
///
/// # Errors
/// See [`mesh_among`].
pub(super) fn unpacked(files: &[OpenedFile]) -> Result<Unpacked, Fault> {
    let files = files.iter().map(|OpenedFile { name, bytes }| File {
        name: name.clone(),
        bytes: Cow::Borrowed(bytes.as_slice()),
    });
    let files: Vec<File<'_>> = files.collect();
    let Found {
        name,
        bytes,
        others,
    } = mesh_among(&files)?;
    Ok(Unpacked {
        name,
        bytes: bytes.into(),
        others,
    })
}
