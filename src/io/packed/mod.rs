//! The mesh among files that are opened together: out of gzip and ZIP, and with what a glTF file or
//! a 3MF package keeps elsewhere put into it.

mod archive;
mod buffers;
pub(super) mod inflate;
mod package;

use super::Format;
use crate::message::messages;
use inflate::{gunzip, is_gzip};
use std::borrow::Cow;

messages! {
    /// Why there is no mesh among files.
    #[derive(Clone, Debug, PartialEq, Eq)]
    pub enum UnpackError as "unpack" {
        /// None of them is one.
        NoMesh {
            /// What they are called.
            names: Vec<String>,
        },
        /// Compressed bytes, or the list of an archive, that contradict themselves or end early.
        Damaged,
        /// A file in an archive that wants a password.
        Encrypted,
        /// A file in an archive that is compressed in another way.
        Unsupported {
            /// Number of the method, as ZIP counts them.
            method: u32,
        },
        /// More would come out than of any mesh, or than was announced.
        TooLarge {
            /// What is allowed, rounded.
            megabytes: u64,
        },
    }
}

/// A file by its name.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub struct File<'a> {
    /// With folders, where it has some.
    pub name: String,
    /// What is in it.
    pub bytes: Cow<'a, [u8]>,
}

/// The mesh, and what was not taken.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Found {
    /// Its name, without folders and without `.gz`.
    pub name: String,
    /// What is in it.
    pub bytes: Vec<u8>,
    /// Further meshes that there are.
    pub others: Vec<String>,
}

/// A file that is unpacked when it is asked for.
struct Part<'a> {
    name: String,
    /// In bytes, once unpacked.
    size: u64,
    content: Content<'a>,
}

enum Content<'a> {
    Plain(&'a [u8]),
    Packed(archive::Entry<'a>),
    /// The models of a 3MF package, and the file that says which comes first.
    Package(Vec<Part<'a>>, Option<Box<Part<'a>>>),
}

impl<'a> Part<'a> {
    fn read(&self) -> Result<Cow<'a, [u8]>, UnpackError> {
        match &self.content {
            Content::Plain(bytes) => Ok(Cow::Borrowed(bytes)),
            Content::Packed(entry) => entry.read().map(Cow::Owned),
            Content::Package(models, relations) => package::joined(models, relations.as_deref()),
        }
    }
}

/// What stands after the last slash.
fn base(name: &str) -> &str {
    name.rsplit_once('/').map_or(name, |(_, base)| base)
}

/// A name without the ending that gzip gives.
fn without_gzip(name: &str) -> &str {
    let end = name.len().saturating_sub(3);
    let ending = name.get(end..).unwrap_or_default();
    let has_it = ending.eq_ignore_ascii_case(".gz");
    if has_it { &name[..end] } else { name }
}

fn is_mesh(part: &Part<'_>) -> bool {
    Format::from_extension(without_gzip(&part.name)).is_some()
}

/// Finds the mesh among files, the largest of several; one file alone is taken for a mesh whatever
/// it is called.
///
/// # Errors
/// [`UnpackError`]. Nothing is unpacked past the size that an archive announces, nor to more than
/// 200 times the size of what is compressed, or 16 MiB where that is more.
pub fn mesh_among(files: &[File<'_>]) -> Result<Found, UnpackError> {
    let mut opened = Vec::new();
    for File { name, bytes } in files {
        opened.push(match is_gzip(bytes) {
            true => (without_gzip(name), Cow::Owned(gunzip(bytes)?)),
            false => (name.as_str(), Cow::Borrowed(&**bytes)),
        });
    }
    let mut parts = Vec::new();
    for (name, bytes) in &opened {
        if archive::is_zip(bytes) {
            parts.extend(package::recognised(name, archive::parts(bytes)?));
        } else {
            parts.push(Part {
                name: (*name).to_owned(),
                size: bytes.len() as u64,
                content: Content::Plain(bytes),
            });
        }
    }
    let is_alone = parts.len() == 1;
    let meshes = || parts.iter().filter(|part| is_alone || is_mesh(part));
    // The first of those of one size.
    let Some(mesh) = meshes().rev().max_by_key(|part| part.size) else {
        let names = parts.into_iter().map(|part| part.name).collect();
        return Err(UnpackError::NoMesh { names });
    };
    let read = mesh.read()?;
    let mut bytes = match is_gzip(&read) {
        true => gunzip(&read)?,
        false => read.into_owned(),
    };
    let name = base(without_gzip(&mesh.name)).to_owned();
    if Format::from_extension(&name) == Some(Format::Gltf) {
        bytes = buffers::put_into(bytes, &mesh.name, &parts)?;
    }
    let others = meshes().filter(|part| !std::ptr::eq(*part, mesh));
    let others = others.map(|part| part.name.clone()).collect();
    Ok(Found {
        name,
        bytes,
        others,
    })
}
