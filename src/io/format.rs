//! The formats, their names, and how to tell them apart.

use super::{ReadError, msh, off, stl, text, vtk, xml};

/// A mesh file format, told apart as finely as a writer needs.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Format {
    /// PLY, binary, little endian.
    Ply,
    /// PLY, text.
    PlyAscii,
    /// PLY, binary, big endian.
    PlyBigEndian,
    /// Wavefront OBJ.
    Obj,
    /// Object File Format of Geomview, in text.
    Off,
    /// STL, binary.
    Stl,
    /// STL, text.
    StlAscii,
    /// glTF 2.0 in one binary file.
    Glb,
    /// glTF 2.0 in JSON.
    Gltf,
    /// The model of a 3MF package: XML.
    ThreeMf,
    /// Legacy VTK, text or binary.
    Vtk,
    /// VTK in XML.
    Vtp,
    /// Gmsh.
    Msh,
}

/// What is known of a format.
struct Row {
    format: Format,
    name: &'static str,
    /// Endings of file names, without the dot; the first is given to files that are written.
    extensions: &'static [&'static str],
    media_type: &'static str,
    is_written: bool,
}

const fn row(
    format: Format,
    name: &'static str,
    extensions: &'static [&'static str],
    media_type: &'static str,
    is_written: bool,
) -> Row {
    Row {
        format,
        name,
        extensions,
        media_type,
        is_written,
    }
}

/// The table of formats, in the order a menu shows them. Page, command line and documents say
/// which there are from it, by `tests/schema.rs`.
const ROWS: [Row; 13] = {
    use Format as F;
    const ANY: &str = "application/octet-stream";
    [
        row(F::Ply, "ply", &["ply"], ANY, true),
        row(F::PlyAscii, "ply-ascii", &["ply"], "text/plain", true),
        row(F::PlyBigEndian, "ply-big", &["ply"], ANY, true),
        row(F::Obj, "obj", &["obj"], "model/obj", true),
        row(F::Off, "off", &["off"], "text/plain", true),
        row(F::Stl, "stl", &["stl"], "model/stl", true),
        row(F::StlAscii, "stl-ascii", &["stl"], "model/stl", true),
        row(F::Glb, "glb", &["glb"], "model/gltf-binary", true),
        row(F::Gltf, "gltf", &["gltf"], "model/gltf+json", false),
        row(F::ThreeMf, "3mf", &["3mf"], "model/3mf", false),
        row(F::Vtk, "vtk", &["vtk"], ANY, false),
        row(F::Vtp, "vtp", &["vtp", "vtu"], "text/xml", false),
        row(F::Msh, "msh", &["msh"], ANY, false),
    ]
};

impl Format {
    fn row(self) -> &'static Row {
        &ROWS[self as usize]
    }

    /// Every format that is read, in the order a menu would show them.
    pub fn all() -> impl Iterator<Item = Self> {
        ROWS.iter().map(|row| row.format)
    }

    /// Every format that is written as well.
    pub fn written() -> impl Iterator<Item = Self> {
        Self::all().filter(|format| format.row().is_written)
    }

    /// The name used in options, such as `ply` or `stl-ascii`.
    pub fn name(self) -> &'static str {
        self.row().name
    }

    /// The format of that [`name`](Self::name).
    pub fn from_name(name: &str) -> Option<Self> {
        Self::all().find(|format| format.name() == name)
    }

    /// The format a file name's ending stands for; the binary one where there are several.
    pub fn from_extension(file_name: &str) -> Option<Self> {
        Self::all().find(|format| !format.ending_of(file_name).is_empty())
    }

    /// Which of the format's endings a file name has; none: empty.
    pub(super) fn ending_of(self, file_name: &str) -> &'static str {
        let ending = file_name.rsplit_once('.').map_or("", |(_, ending)| ending);
        let mut known = self.extensions().iter();
        let known = known.find(|extension| extension.eq_ignore_ascii_case(ending));
        known.copied().unwrap_or_default()
    }

    /// File name endings, without the dot, that of files which are written first.
    pub fn extensions(self) -> &'static [&'static str] {
        self.row().extensions
    }

    /// Endings of all files that are read, without the dot.
    pub fn endings() -> Vec<&'static str> {
        let mut all: Vec<_> = Self::all().flat_map(Self::extensions).copied().collect();
        all.dedup();
        all
    }

    /// Media type for a download; where none is registered, the nearest general one.
    pub fn media_type(self) -> &'static str {
        self.row().media_type
    }

    /// Whether it is written, and not read alone.
    pub fn is_written(self) -> bool {
        self.row().is_written
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
    if let Some(what) = in_its_place(bytes) {
        return Err(ReadError::Substituted { what });
    }
    if let Some(found) = by_magic(bytes) {
        return Ok(found);
    }
    match Format::from_extension(file_name) {
        // These would have been known.
        None | Some(Format::Glb | Format::Gltf | Format::Vtk | Format::Vtp | Format::Msh) => {
            Err(ReadError::UnknownFormat {
                name: file_name.to_owned(),
                known: Format::endings(),
            })
        }
        Some(Format::Stl) if text::nul(bytes).is_none() => Ok(Format::StlAscii),
        Some(named) => Ok(named),
    }
}

/// What came in the place of a file, whatever it is called.
fn in_its_place(bytes: &[u8]) -> Option<&'static str> {
    const PAGES: [&[u8]; 2] = [b"<!doctype html", b"<html"];
    let start = bytes.trim_ascii_start();
    let begins = |text: &[u8]| {
        let start = start.get(..text.len());
        start.is_some_and(|start| start.eq_ignore_ascii_case(text))
    };
    if begins(b"version https://git-lfs.") {
        return Some("git-lfs");
    }
    PAGES.into_iter().any(begins).then_some("html")
}

/// The format that the first bytes tell of.
fn by_magic(bytes: &[u8]) -> Option<Format> {
    let start = bytes.trim_ascii_start();
    // Its first line would be a comment elsewhere.
    if vtk::is_header(start) {
        return Some(Format::Vtk);
    }
    match start.first() {
        Some(b'<') => return xml_root(start),
        Some(b'{') => return Some(Format::Gltf),
        Some(b'$') if msh::is_header(start) => return Some(Format::Msh),
        _ => {}
    }
    let first = text::first_word(bytes);
    match first {
        b"ply" => Some(Format::Ply),
        _ if first.starts_with(b"glTF") => Some(Format::Glb),
        _ if off::is_header(first) => Some(Format::Off),
        _ if first.eq_ignore_ascii_case(b"solid") && text::nul(bytes).is_none() => {
            Some(Format::StlAscii)
        }
        b"v" | b"vn" | b"vt" | b"f" | b"o" | b"g" | b"s" | b"mtllib" | b"usemtl" => {
            Some(Format::Obj)
        }
        _ => None,
    }
}

/// The format whose outermost element the XML begins with.
fn xml_root(bytes: &[u8]) -> Option<Format> {
    match xml::root(bytes)? {
        b"VTKFile" => Some(Format::Vtp),
        b"model" => Some(Format::ThreeMf),
        _ => None,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_go_both_ways() {
        for (at, format) in Format::all().enumerate() {
            assert_eq!(format as usize, at, "the rows stand as the variants do");
            assert_eq!(Format::from_name(format.name()), Some(format));
            for ending in format.extensions() {
                let named = Format::from_extension(&format!("a.b.{ending}"));
                assert_eq!(named.map(Format::extensions), Some(format.extensions()));
            }
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
        assert_eq!(detected(b"solid\0\0\x01", "a.stl"), Ok(Format::Stl));
        assert_eq!(detected(b"glTF\x02\0\0\0", "a.obj"), Ok(Format::Glb));
        assert_eq!(detected(b"3 1 0", "a.off"), Ok(Format::Off));
        assert_eq!(
            detected(b"# vtk DataFile Version 3.0\n", "a.obj"),
            Ok(Format::Vtk)
        );
        assert_eq!(detected(b"$MeshFormat\n", "a.stl"), Ok(Format::Msh));
        assert_eq!(detected(b"\n{ \"asset\": {}}", "a"), Ok(Format::Gltf));
        let xml = b"<?xml version=\"1.0\"?><!-- a > b --><x:model>";
        assert_eq!(detected(xml, "a"), Ok(Format::ThreeMf));
        assert_eq!(detected(b"<VTKFile type='PolyData'>", "a"), Ok(Format::Vtp));
        assert_eq!(detected(b"<svg>", "a.stl"), Ok(Format::StlAscii));
        assert_eq!(detected(b" \n", "a.off"), Err(ReadError::Empty));
        for name in ["a.txt", "", "a.glb"] {
            assert_eq!(
                detected(b"3 1 0", name),
                Err(ReadError::UnknownFormat {
                    name: name.to_owned(),
                    known: Format::endings()
                })
            );
        }
    }
}
