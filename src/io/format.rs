//! The formats, their names, and how to tell them apart.

use super::{ReadError, off, stl, text};

/// A mesh file format, told apart as finely as a writer needs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    /// Wavefront OBJ.
    Obj,
    /// Object File Format of Geomview, in text.
    Off,
    /// PLY, text.
    PlyAscii,
    /// PLY, binary, little endian.
    Ply,
    /// PLY, binary, big endian.
    PlyBigEndian,
    /// STL, text.
    StlAscii,
    /// STL, binary.
    Stl,
    /// glTF 2.0 in one binary file.
    Glb,
}

impl Format {
    /// Every format, in the order a menu would show them.
    pub const ALL: [Self; 8] = [
        Self::Obj,
        Self::Off,
        Self::Ply,
        Self::PlyAscii,
        Self::PlyBigEndian,
        Self::Stl,
        Self::StlAscii,
        Self::Glb,
    ];

    /// The name used in options: `obj`, `off`, `ply`, `ply-ascii`, `ply-big`, `stl`,
    /// `stl-ascii` or `glb`.
    pub fn name(self) -> &'static str {
        match self {
            Self::Obj => "obj",
            Self::Off => "off",
            Self::Ply => "ply",
            Self::PlyAscii => "ply-ascii",
            Self::PlyBigEndian => "ply-big",
            Self::Stl => "stl",
            Self::StlAscii => "stl-ascii",
            Self::Glb => "glb",
        }
    }

    /// The format of that [`name`](Self::name).
    pub fn from_name(name: &str) -> Option<Self> {
        Self::ALL.into_iter().find(|format| format.name() == name)
    }

    /// The format a file name's ending stands for; the binary one where there are several.
    pub fn from_extension(file_name: &str) -> Option<Self> {
        let (_, extension) = file_name.rsplit_once('.')?;
        Self::ALL
            .into_iter()
            .find(|format| format.extension().eq_ignore_ascii_case(extension))
    }

    /// File name ending, without the dot.
    pub fn extension(self) -> &'static str {
        match self {
            Self::Obj => "obj",
            Self::Off => "off",
            Self::Ply | Self::PlyAscii | Self::PlyBigEndian => "ply",
            Self::Stl | Self::StlAscii => "stl",
            Self::Glb => "glb",
        }
    }

    /// Media type for a download; where none is registered, the nearest general one.
    pub fn media_type(self) -> &'static str {
        match self {
            Self::Obj => "model/obj",
            Self::Off | Self::PlyAscii => "text/plain",
            Self::Ply | Self::PlyBigEndian => "application/octet-stream",
            Self::Stl | Self::StlAscii => "model/stl",
            Self::Glb => "model/gltf-binary",
        }
    }
}

/// The format of a file: by its content, or failing that by its name.
///
/// For PLY the answer is [`Format::Ply`] throughout; the header knows the encoding.
pub(super) fn detect(bytes: &[u8], file_name: &str) -> Result<Format, ReadError> {
    // Length first: many binary STL files begin with the word that marks a text one.
    if stl::has_binary_length(bytes) {
        return Ok(Format::Stl);
    }
    if bytes.trim_ascii().is_empty() {
        return Err(ReadError::Empty);
    }
    let first = text::first_word(bytes);
    match first {
        b"ply" => return Ok(Format::Ply),
        _ if first.starts_with(b"glTF") => return Ok(Format::Glb),
        _ if off::is_header(first) => return Ok(Format::Off),
        _ if first.eq_ignore_ascii_case(b"solid") && text::nul(bytes).is_none() => {
            return Ok(Format::StlAscii);
        }
        b"v" | b"vn" | b"vt" | b"f" | b"o" | b"g" | b"s" | b"mtllib" | b"usemtl" => {
            return Ok(Format::Obj);
        }
        _ => {}
    }
    match Format::from_extension(file_name) {
        None | Some(Format::Glb) => Err(ReadError::UnknownFormat {
            name: file_name.to_owned(),
        }),
        Some(Format::Stl) if text::nul(bytes).is_none() => Ok(Format::StlAscii),
        Some(named) => Ok(named),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_go_both_ways() {
        for format in Format::ALL {
            assert_eq!(Format::from_name(format.name()), Some(format));
            let named = Format::from_extension(&format!("a.b.{}", format.extension()));
            assert_eq!(named.map(Format::extension), Some(format.extension()));
        }
        assert_eq!(Format::from_name("stl-binary"), None);
        assert_eq!(Format::from_extension("SPOT.OBJ"), Some(Format::Obj));
        assert_eq!(Format::from_extension("obj"), None);
    }

    #[test]
    fn content_goes_before_the_name() {
        let detected = |bytes: &[u8], name| detect(bytes, name);
        assert_eq!(
            detected(b"# made by hand\n\nv 0 0 0", "a.stl"),
            Ok(Format::Obj)
        );
        assert_eq!(detected(b"ply\nformat ascii 1.0", "a.obj"), Ok(Format::Ply));
        assert_eq!(detected(b"STCNOFF 3 1 0", "a.obj"), Ok(Format::Off));
        assert_eq!(detected(b" SOLID\tball", ""), Ok(Format::StlAscii));
        assert_eq!(detected(b"solid\0\0", "a.stl"), Ok(Format::Stl));
        assert_eq!(detected(b"glTF\x02\0\0\0", "a.obj"), Ok(Format::Glb));
        assert_eq!(detected(b"3 1 0", "a.off"), Ok(Format::Off));
        assert_eq!(detected(b"<html>", "a.stl"), Ok(Format::StlAscii));
        assert_eq!(detected(b" \n", "a.off"), Err(ReadError::Empty));
        for name in ["a.txt", "", "a.glb"] {
            assert_eq!(
                detected(b"3 1 0", name),
                Err(ReadError::UnknownFormat {
                    name: name.to_owned()
                })
            );
        }
    }
}
