//! Mesh files: bytes to [`PolygonSoup`] and back.
//!
//! | format | read | written as |
//! | --- | --- | --- |
//! | OBJ | `v`, colours, `f` of any degree, negative indices, groups | text, polygons, colours |
//! | OFF | plain and the C, N, ST variants, ASCII and binary | text, polygons, colours |
//! | PLY | ASCII and binary of both byte orders, colours | `double` positions, polygons, colours |
//! | STL | ASCII and binary, corners welded | triangles; binary in single precision |
//! | glTF | GLB, and JSON that holds its buffers; triangles where nodes put them, colours | GLB: triangles in single precision, colours, optional normals |
//! | 3MF | its model, with objects where components put them | no |
//! | VTK | legacy, ASCII and binary, and XML; surface cells, or the surface of solid ones | no |
//! | MSH | Gmsh 1, 2 and 4, ASCII and binary; the same of its elements | no |
//!
//! Readers keep the file's vertex order, unused vertices and repeated faces, so that
//! a download matches the upload; what such a soup means as a surface is decided by
//! [`crate::mesh`]. They refuse what has no meaning at all (an index past the last
//! vertex, a coordinate that is not finite, a file cut short) and say on which line or
//! at which byte. Counts promised by a file are checked against the bytes that could
//! hold them before anything is reserved, so memory stays within a small multiple of the
//! file's size.
//!
//! ```
//! use umbilic::io::{self, Format};
//!
//! let text = b"v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -1\n";
//! let read = io::read(text, "triangle.obj")?;
//! assert_eq!(read.soup.face(0), [0, 1, 2]);
//! let bytes = io::write(&read.soup, Format::PlyAscii, "one triangle")?;
//! assert_eq!(io::read(&bytes, "")?.soup, read.soup);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod assembly;
mod base64;
mod binary;
mod budget;
mod cell;
mod colour;
mod error;
mod format;
pub mod glb;
mod gltf;
mod json;
mod msh;
mod obj;
mod off;
pub mod packed;
mod placed;
mod ply;
mod single;
mod solid;
mod stl;
mod stream;
mod text;
mod three_mf;
mod vtk;
mod vtp;
mod weld;
mod xml;

pub use error::{Expected, Extra, Found, Loss, Oddity, Place, ReadError, WriteError};
pub use format::Format;

use glam::DVec3;

use crate::interrupt;
use crate::soup::PolygonSoup;

/// What a file held.
#[derive(Clone, Debug, PartialEq)]
pub struct Read {
    /// Positions in the file's order (for STL: by first use), and the faces.
    pub soup: PolygonSoup,
    /// The format found in the bytes, whatever the file is called.
    pub format: Format,
    /// Oddities that did not stop the reader.
    pub warnings: Vec<Oddity>,
}

/// Reads a mesh file.
///
/// The bytes decide the format; `file_name` is asked only where they do not, and may be
/// empty. Faces of fewer than three corners are dropped with a warning; faces that repeat
/// a vertex are kept.
///
/// # Errors
/// [`ReadError`] names what is wrong and where. Nothing is returned of a file in error.
pub fn read(bytes: &[u8], file_name: &str) -> Result<Read, ReadError> {
    let (bytes, transcoded) = text::without_byte_order_mark(bytes);
    let format = format::detect(&bytes, file_name)?;
    interrupt::pulse();
    let mut read = match format {
        Format::Obj => obj::read(&bytes),
        Format::Off => off::read(&bytes),
        Format::Ply | Format::PlyAscii | Format::PlyBigEndian => ply::read(&bytes),
        Format::StlAscii => stl::read_ascii(&bytes),
        Format::Stl => stl::read_binary(&bytes),
        Format::Glb => gltf::read_binary(&bytes),
        Format::Gltf => gltf::read_json(&bytes),
        Format::ThreeMf => three_mf::read(&bytes),
        Format::Vtk => vtk::read(&bytes),
        Format::Vtp => vtp::read(&bytes),
        Format::Msh => msh::read(&bytes),
    }?;
    interrupt::pulse();
    if transcoded {
        read.warnings.push(Oddity::Transcoded);
    }
    if let Some(named) = Format::from_extension(file_name)
        && named.extensions() != read.format.extensions()
    {
        read.warnings.push(Oddity::OtherEnding {
            ending: named.ending_of(file_name),
            format: read.format,
        });
    }
    Ok(read)
}

/// Writes a mesh file.
///
/// OBJ, OFF and PLY keep vertices, polygons and every bit of positions and colours. STL and GLB
/// hold triangles, cut by [`PolygonSoup::triangles`]; binary STL and GLB round
/// positions to single precision, to 10⁻⁶ of the size: far from the origin GLB has the translation
/// in its node, and binary STL is moved, see [`losses`]. `comment` goes where the format has room for one.
///
/// # Errors
/// [`WriteError`] for a soup without faces, with a corner past the last vertex, or with a
/// position the format cannot hold.
pub fn write(soup: &PolygonSoup, format: Format, comment: &str) -> Result<Vec<u8>, WriteError> {
    error::check_writable(soup)?;
    match format {
        Format::Obj => Ok(obj::write(soup, comment)),
        Format::Off => Ok(off::write(soup, comment)),
        Format::Ply | Format::PlyAscii | Format::PlyBigEndian => {
            Ok(ply::write(soup, format, comment))
        }
        Format::StlAscii => Ok(stl::write_ascii(soup, comment)),
        Format::Stl => stl::write_binary(soup, comment),
        Format::Glb => glb::write(soup, None, comment),
        Format::Gltf | Format::ThreeMf | Format::Vtk | Format::Vtp | Format::Msh => {
            Err(WriteError::ReadOnly { format })
        }
    }
}

/// What a file written by [`write()`] does not hold as the mesh does, beyond the precision of the
/// format.
pub fn losses(soup: &PolygonSoup, format: Format) -> Vec<Loss> {
    let shift = match format {
        Format::Stl => stl::moved_by(soup),
        _ => None,
    };
    let moved = |by: DVec3| Loss::Moved {
        format,
        x: by.x,
        y: by.y,
        z: by.z,
    };
    let mut losses: Vec<Loss> = shift.map(moved).into_iter().collect();
    let is_stl = matches!(format, Format::Stl | Format::StlAscii);
    let count = if is_stl { stl::joined(soup, format) } else { 0 };
    if count > 0 {
        losses.push(Loss::Joined { format, count });
    }
    if soup.has_colours() && is_stl {
        losses.push(Loss::Colours { format });
    }
    let count = soup.faces().filter(|face| face.len() > 3).count();
    if count > 0 && (is_stl || format == Format::Glb) {
        losses.push(Loss::Polygons { format, count });
    }
    losses
}
