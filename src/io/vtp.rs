//! VTK in XML: polygonal data (`.vtp`), and the surface cells of unstructured grids (`.vtu`).
//!
//! Source: "VTK XML Formats", <https://docs.vtk.org/en/latest/vtk_file_formats/>. Arrays stand in
//! their element, as text or as base64, or at an offset after all elements, raw or as base64;
//! where there is a compressor it is zlib. Values at points and cells are not read.

mod array;

use glam::DVec3;

use self::array::{Arrays, File};
use super::budget::Budget;
use super::cell::{Cells, POLYGON, POLYHEDRON, STRIP};
use super::text::parse_integer;
use super::xml::{Event, Tag, Xml};
use super::{Expected, Extra, Format, Oddity, Place, Read, ReadError};

/// Bytes that arrays may take for each byte of a file: in text a number takes two at least, and
/// eight in memory; compressed ones take more, but no mesh is all zeros.
const PLAIN: u64 = 16;
const COMPRESSED: u64 = 200;

/// What a file may hold of cells, by the name of the element around their arrays.
const GROUPS: [(&[u8], Option<u8>); 5] = [
    (b"Verts", Some(1)),
    (b"Lines", Some(4)),
    (b"Strips", Some(STRIP)),
    (b"Polys", Some(POLYGON)),
    // With a type each.
    (b"Cells", None),
];

/// Arrays of one piece of the mesh.
#[derive(Default)]
struct Piece {
    /// The first vertex of its own.
    first: usize,
    connectivity: Vec<f64>,
    offsets: Vec<f64>,
    types: Vec<f64>,
    /// What polyhedra list, one after the other, and where each ends; −1 for another cell.
    faces: Vec<f64>,
    face_offsets: Vec<f64>,
}

/// Reads a VTK file in XML.
pub(super) fn read(bytes: &[u8]) -> Result<Read, ReadError> {
    let mut file = File::of(bytes);
    let head = file.head;
    let mut xml = Xml::new(Format::Vtp, head);
    let mut cells = Cells::new();
    let mut budget = Budget::new(bytes, PLAIN);
    let mut piece = Piece::default();
    // The element around the arrays.
    let mut group: &[u8] = b"";
    let mut has_data = false;
    while let Some(event) = xml.next()? {
        match event {
            Event::Start(tag) => match tag.name {
                b"VTKFile" => {
                    begin(&tag, &mut file)?;
                    if file.is_compressed {
                        budget = Budget::new(bytes, COMPRESSED);
                    }
                }
                b"Piece" => piece.first = cells.assembly.n_vertices(),
                b"DataArray" if group == b"Points" => {
                    let arrays = Arrays::read(&tag, &mut xml, &file)?;
                    points(&arrays, &mut budget, &mut cells)?;
                }
                b"DataArray" if GROUPS.iter().any(|(name, _)| *name == group) => {
                    let into = match tag.get("Name").unwrap_or_default() {
                        b"connectivity" => &mut piece.connectivity,
                        b"offsets" => &mut piece.offsets,
                        b"types" => &mut piece.types,
                        b"faces" => &mut piece.faces,
                        b"faceoffsets" => &mut piece.face_offsets,
                        _ => continue,
                    };
                    *into = Arrays::read(&tag, &mut xml, &file)?.values(&mut budget)?;
                }
                b"DataArray" => has_data |= matches!(group, b"PointData" | b"CellData"),
                name @ (b"Points" | b"PointData" | b"CellData") => group = name,
                name if GROUPS.iter().any(|(known, _)| *known == name) => group = name,
                _ => {}
            },
            Event::End(name) => {
                if let Some((_, kind)) = GROUPS.iter().find(|(known, _)| *known == name) {
                    let place = xml.place();
                    take(&mut piece, *kind, place, &mut cells)?;
                }
                if name == group {
                    group = b"";
                }
            }
            _ => {}
        }
    }
    let mut read = cells.finish(Format::Vtp)?;
    let extra = [(Extra::Data, has_data)];
    read.warnings.extend(Oddity::left_out(&extra));
    Ok(read)
}

/// What the outermost element says of all arrays.
fn begin(tag: &Tag<'_>, file: &mut File<'_>) -> Result<(), ReadError> {
    if !matches!(tag.need("type")?, b"PolyData" | b"UnstructuredGrid") {
        let what = "vtk-data-set";
        return Err(ReadError::Unsupported { what });
    }
    file.big = tag.get("byte_order") == Some(b"BigEndian");
    file.long_headers = tag.get("header_type") == Some(b"UInt64");
    file.is_compressed = match tag.get("compressor") {
        None | Some(b"") => false,
        Some(b"vtkZLibDataCompressor") => true,
        Some(_) => {
            let what = "vtk-compressor";
            return Err(ReadError::Unsupported { what });
        }
    };
    Ok(())
}

fn points(
    arrays: &Arrays<'_, '_>,
    budget: &mut Budget,
    cells: &mut Cells,
) -> Result<(), ReadError> {
    let values = arrays.values(budget)?;
    if values.len() % 3 != 0 {
        return Err(arrays.wrong(values.len(), Expected::Coordinate { axis: "z" }));
    }
    cells.assembly.reserve(values.len() / 3, 0);
    for point in values.chunks_exact(3) {
        let position = DVec3::from_slice(point);
        cells.assembly.vertex(position, arrays.place)?;
    }
    Ok(())
}

/// Takes in the cells of one group.
fn take(
    piece: &mut Piece,
    kind: Option<u8>,
    place: Place,
    cells: &mut Cells,
) -> Result<(), ReadError> {
    let own = (cells.assembly.n_vertices() - piece.first) as f64;
    let mut corners = Vec::with_capacity(piece.connectivity.len());
    for &index in &piece.connectivity {
        if !(index >= 0.0 && index < own) {
            return Err(ReadError::IndexOutOfRange {
                format: Format::Vtp,
                place,
                index: index as i64,
                vertices: own as usize,
            });
        }
        corners.push(piece.first as u32 + index as u32);
    }
    let mut start = 0;
    let mut first_face = 0;
    for (at, &end) in piece.offsets.iter().enumerate() {
        if !(end >= start as f64 && end <= corners.len() as f64) {
            return Err(array::wrong(place, end, Expected::CellCount));
        }
        let kind = match (kind, piece.types.get(at)) {
            (Some(kind), _) => kind,
            (None, Some(kind)) => *kind as u8,
            (None, None) => return Err(array::wrong(place, at as f64, Expected::CellType)),
        };
        let listed = piece.face_offsets.get(at).map_or(-1.0, |&end| end);
        if kind == POLYHEDRON && listed >= first_face as f64 {
            let numbers = piece.faces.get(first_face..listed as usize);
            let numbers = numbers.unwrap_or_default();
            cells.polyhedron(numbers, piece.first, Format::Vtp, place)?;
            first_face = listed as usize;
        } else {
            cells.cell(kind, &corners[start..end as usize], place)?;
        }
        start = end as usize;
    }
    for values in [
        &mut piece.connectivity,
        &mut piece.offsets,
        &mut piece.types,
        &mut piece.faces,
        &mut piece.face_offsets,
    ] {
        values.clear();
    }
    Ok(())
}

/// A whole number that must be there.
fn whole(tag: &Tag<'_>, name: &'static str) -> Result<usize, ReadError> {
    let natural = |word: &[u8]| usize::try_from(parse_integer(word)?).ok();
    tag.number(name, natural)
}
