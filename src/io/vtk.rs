//! Legacy VTK, in text and in binary: polygonal data, and the surface cells of unstructured grids.
//!
//! Source: "VTK File Formats", <https://docs.vtk.org/en/latest/vtk_file_formats/>. Binary numbers
//! are big-endian. Versions before 5 list a cell as its number of corners and their indices; later
//! ones have offsets and connectivity apart. Values at points and cells are not read.

use super::binary::Scalar;
use super::cell::{Cells, POLYGON, POLYHEDRON, STRIP};
use super::stream::Stream;
use super::{Expected, Extra, Format, Oddity, Place, Read, ReadError};

const MAGIC: &[u8] = b"# vtk DataFile";

/// Whether a file begins as legacy VTK does.
pub(super) fn is_header(bytes: &[u8]) -> bool {
    let start = bytes.get(..MAGIC.len());
    start.is_some_and(|start| start.eq_ignore_ascii_case(MAGIC))
}

/// Lists of numbers that follow each other, until their types are known: of vertices, but of
/// polyhedra.
#[derive(Default)]
struct Lists {
    corners: Vec<f64>,
    /// Where each list ends, and where it stands in the file.
    ends: Vec<(usize, Place)>,
}

impl Lists {
    fn iter(&self) -> impl Iterator<Item = (&[f64], Place)> {
        let starts = std::iter::once(0).chain(self.ends.iter().map(|(end, _)| *end));
        let spans = starts.zip(&self.ends);
        spans.map(|(start, (end, place))| (&self.corners[start..*end], *place))
    }
}

/// Reads a legacy VTK file.
pub(super) fn read(bytes: &[u8]) -> Result<Read, ReadError> {
    const ENCODING: Expected = Expected::Keyword {
        word: "ASCII, BINARY",
    };
    const DATASET: Expected = Expected::Keyword { word: "DATASET" };
    const SECTION: Expected = Expected::Keyword {
        word: "POINTS, POLYGONS, TRIANGLE_STRIPS, CELLS, CELL_TYPES, POINT_DATA, CELL_DATA",
    };
    let mut stream = Stream::new(Format::Vtk, bytes.trim_ascii_start());
    stream.line();
    // A title.
    stream.line();
    let is_binary = match upper(stream.word(ENCODING)?).as_slice() {
        b"ASCII" => false,
        b"BINARY" => true,
        word => return Err(stream.error(Some(word), ENCODING)),
    };
    stream.set_big_endian(true);
    let word = stream.word(DATASET)?;
    if upper(word) != b"DATASET" {
        return Err(stream.error(Some(word), DATASET));
    }
    let set = upper(stream.word(DATASET)?);
    if set != b"POLYDATA" && set != b"UNSTRUCTURED_GRID" {
        let what = "vtk-data-set";
        return Err(ReadError::Unsupported { what });
    }
    let mut cells = Cells::new();
    let mut untyped = Lists::default();
    let mut has_data = false;
    while let Some(word) = stream.try_word() {
        match upper(word).as_slice() {
            b"POINTS" => read_points(&mut stream, is_binary, &mut cells)?,
            b"POLYGONS" => {
                let lists = read_lists(&mut stream, is_binary)?;
                for (corners, place) in lists.iter() {
                    take(POLYGON, corners, place, &mut cells)?;
                }
            }
            b"TRIANGLE_STRIPS" => {
                let lists = read_lists(&mut stream, is_binary)?;
                for (corners, place) in lists.iter() {
                    take(STRIP, corners, place, &mut cells)?;
                }
            }
            b"VERTICES" | b"LINES" => {
                let lists = read_lists(&mut stream, is_binary)?;
                lists.iter().for_each(|(_, place)| cells.skip(place));
            }
            b"CELLS" => untyped = read_lists(&mut stream, is_binary)?,
            b"CELL_TYPES" => {
                let count = stream.count_word(Expected::CellCount)?;
                stream.line();
                numbers(&mut stream, is_binary, |stream| {
                    let count = stream.checked("elements", count, 1, 4)?;
                    for (corners, place) in untyped.iter().take(count) {
                        let kind = stream.count(Scalar::I32, Expected::CellType)?;
                        let kind = u8::try_from(kind).unwrap_or(u8::MAX);
                        take(kind, corners, place, &mut cells)?;
                    }
                    let rest = count.saturating_sub(untyped.ends.len());
                    stream.skip(Scalar::I32, rest as u64)
                })?;
            }
            b"FIELD" => {
                has_data = true;
                skip_field(&mut stream, is_binary)?;
            }
            // Up to an empty line.
            b"METADATA" => {
                stream.line();
                while !stream.line().is_empty() {}
            }
            b"POINT_DATA" | b"CELL_DATA" => {
                has_data = true;
                break;
            }
            _ => return Err(stream.error(Some(word), SECTION)),
        }
    }
    let mut read = cells.finish(Format::Vtk)?;
    let extra = [(Extra::Data, has_data)];
    read.warnings.extend(Oddity::left_out(&extra));
    Ok(read)
}

fn upper(word: &[u8]) -> Vec<u8> {
    word.to_ascii_uppercase()
}

/// Reads what is in binary where the file is.
fn numbers<'a, T>(
    stream: &mut Stream<'a>,
    is_binary: bool,
    read: impl FnOnce(&mut Stream<'a>) -> Result<T, ReadError>,
) -> Result<T, ReadError> {
    stream.is_binary = is_binary;
    let done = read(stream);
    stream.is_binary = false;
    done
}

/// The type of that name. What the names mean is that of C on 64-bit Unix, where most files are
/// written.
fn scalar(stream: &mut Stream<'_>) -> Result<Scalar, ReadError> {
    let word = stream.word(Expected::NumberType)?;
    Ok(match word.to_ascii_lowercase().as_slice() {
        b"char" | b"signed_char" | b"vtktypeint8" => Scalar::I8,
        b"unsigned_char" | b"vtktypeuint8" => Scalar::U8,
        b"short" | b"vtktypeint16" => Scalar::I16,
        b"unsigned_short" | b"vtktypeuint16" => Scalar::U16,
        b"int" | b"vtktypeint32" => Scalar::I32,
        b"unsigned_int" | b"vtktypeuint32" => Scalar::U32,
        b"long" | b"vtkidtype" | b"vtktypeint64" => Scalar::I64,
        b"unsigned_long" | b"vtktypeuint64" => Scalar::U64,
        b"float" => Scalar::F32,
        b"double" => Scalar::F64,
        _ => return Err(stream.error(Some(word), Expected::NumberType)),
    })
}

fn read_points(
    stream: &mut Stream<'_>,
    is_binary: bool,
    cells: &mut Cells,
) -> Result<(), ReadError> {
    let count = stream.count_word(Expected::VertexCount)?;
    let kind = scalar(stream)?;
    stream.line();
    numbers(stream, is_binary, |stream| {
        let count = stream.checked("vertices", count, 3, 3 * kind.size())?;
        cells.assembly.reserve(count, 0);
        for _ in 0..count {
            let place = stream.place();
            let position = stream.point(kind)?;
            cells.assembly.vertex(position, place)?;
        }
        Ok(())
    })
}

/// Takes in a cell.
fn take(kind: u8, numbers: &[f64], place: Place, cells: &mut Cells) -> Result<(), ReadError> {
    if kind == POLYHEDRON {
        return cells.polyhedron(numbers, 0, Format::Vtk, place);
    }
    let index = |&number: &f64| cells.assembly.index(number, Format::Vtk, place);
    let corners: Vec<u32> = numbers.iter().map(index).collect::<Result<_, _>>()?;
    cells.cell(kind, &corners, place)
}

/// Cells of any kind, each a list of vertices, or what their type makes of it.
fn read_lists(stream: &mut Stream<'_>, is_binary: bool) -> Result<Lists, ReadError> {
    let count = stream.count_word(Expected::CellCount)?;
    let size = stream.count_word(Expected::CellCount)?;
    stream.line();
    let rest = stream.left().trim_ascii_start();
    if rest.starts_with(b"OFFSETS") {
        return read_offsets(stream, is_binary, (count, size));
    }
    let mut lists = Lists::default();
    numbers(stream, is_binary, |stream| {
        stream.checked("elements", count, 1, 4)?;
        for _ in 0..count {
            let place = stream.place();
            let length = stream.count(Scalar::I32, Expected::CornerCount)?;
            let length = stream.checked("corners", length, 1, 4)?;
            for _ in 0..length {
                lists
                    .corners
                    .push(stream.value(Scalar::I32, Expected::VertexIndex)?);
            }
            lists.ends.push((lists.corners.len(), place));
        }
        Ok(())
    })?;
    Ok(lists)
}

/// The same, of version 5: offsets, one more than there are cells, then connectivity.
fn read_offsets(
    stream: &mut Stream<'_>,
    is_binary: bool,
    (offsets, size): (u64, u64),
) -> Result<Lists, ReadError> {
    const CONNECTIVITY: Expected = Expected::Keyword {
        word: "CONNECTIVITY",
    };
    stream.word(Expected::CellCount)?;
    let kind = scalar(stream)?;
    stream.line();
    let ends = numbers(stream, is_binary, |stream| {
        let count = stream.checked("elements", offsets, 1, kind.size())?;
        let mut ends: Vec<(usize, Place)> = Vec::with_capacity(count);
        for _ in 0..count {
            let place = stream.place();
            let end = stream.count(kind, Expected::CellCount)?;
            let before = ends.last().map_or(0, |(end, _)| *end as u64);
            if end < before || end > size || (ends.is_empty() && end > 0) {
                let word = end.to_string();
                return Err(stream.error(Some(word.as_bytes()), Expected::CellCount));
            }
            ends.push((end as usize, place));
        }
        Ok(ends)
    })?;
    let word = stream.word(CONNECTIVITY)?;
    if word != b"CONNECTIVITY" {
        return Err(stream.error(Some(word), CONNECTIVITY));
    }
    let kind = scalar(stream)?;
    stream.line();
    numbers(stream, is_binary, |stream| {
        let count = stream.checked("corners", size, 1, kind.size())?;
        let mut corners = Vec::with_capacity(count);
        for _ in 0..count {
            corners.push(stream.value(kind, Expected::VertexIndex)?);
        }
        let ends = ends.into_iter().skip(1).collect();
        Ok(Lists { corners, ends })
    })
}

/// Steps over arrays that stand before the points.
fn skip_field(stream: &mut Stream<'_>, is_binary: bool) -> Result<(), ReadError> {
    stream.word(Expected::ElementName)?;
    for _ in 0..stream.count_word(Expected::ElementCount)? {
        stream.word(Expected::ElementName)?;
        let columns = stream.count_word(Expected::ElementCount)?;
        let rows = stream.count_word(Expected::ElementCount)?;
        let count = columns.saturating_mul(rows);
        let word = stream.left().trim_ascii_start();
        if word.starts_with(b"string") {
            // Of any length; in text a line each.
            stream.line();
            for _ in 0..stream.checked("elements", count, 0, 1)? {
                stream.line();
            }
            continue;
        }
        let kind = scalar(stream)?;
        stream.line();
        numbers(stream, is_binary, |stream| stream.skip(kind, count))?;
    }
    Ok(())
}
