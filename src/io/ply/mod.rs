//! PLY, in text and in binary of both byte orders.
//!
//! The header names elements and, in order, their properties; the body holds them. One
//! walk over the elements serves all three encodings, see [`body`]. Read are `x`, `y`,
//! `z` of `vertex`, its `red`, `green`, `blue` and `alpha`, and the list `vertex_indices` (or
//! `vertex_index`) of `face`; everything else is stepped over.

mod body;
mod header;
mod write;

use glam::DVec3;

use self::body::{Binary, Body, Text};
use self::header::{Element, ElementKind, Header, Property, Role};
pub(super) use self::write::write;
use super::assembly::{Assembly, NO_PART};
use super::binary::Scalar;
use super::{Expected, Extra, Format, Found, Oddity, Place, Read, ReadError};

/// Reads a PLY file of any encoding.
pub(super) fn read(bytes: &[u8]) -> Result<Read, ReadError> {
    let header = Header::read(bytes)?;
    match header.format {
        Format::PlyAscii => read_body(&header, Text::new(&header, bytes)?),
        _ => read_body(&header, Binary::new(&header, bytes)),
    }
}

fn read_body(header: &Header, mut body: impl Body) -> Result<Read, ReadError> {
    let mut assembly = Assembly::new();
    for element in &header.elements {
        let count = body.check_count(element)?;
        match element.kind {
            ElementKind::Vertex => {
                assembly.reserve(count, 0);
                for _ in 0..count {
                    read_vertex(element, &mut body, &mut assembly)?;
                }
            }
            ElementKind::Face => {
                assembly.reserve(0, count);
                let mut corners = Vec::new();
                for _ in 0..count {
                    read_face(element, header, &mut body, &mut corners, &mut assembly)?;
                }
            }
            ElementKind::Strips => {
                let mut corners = Vec::new();
                for _ in 0..count {
                    read_strips(element, header, &mut body, &mut corners, &mut assembly)?;
                }
            }
            ElementKind::Other => {
                for _ in 0..count {
                    body.begin(Expected::OtherElement)?;
                    for property in &element.properties {
                        step_over(property, &mut body)?;
                    }
                }
            }
        }
    }
    let mut read = assembly.finish(header.format)?;
    read.warnings.extend(body.left());
    read.warnings.extend(Oddity::left_out(&[
        (Extra::Colours, header.has(Role::OtherColour)),
        (Extra::TextureCoordinates, header.has(Role::Texture)),
    ]));
    Ok(read)
}

fn read_vertex(
    element: &Element,
    body: &mut impl Body,
    assembly: &mut Assembly,
) -> Result<(), ReadError> {
    body.begin(Expected::Vertex)?;
    let place = body.place();
    let mut position = DVec3::ZERO;
    let mut colour = None;
    for property in &element.properties {
        match property.role {
            Role::Coordinate(axis) => {
                let axis_name = ["x", "y", "z"][axis];
                let expected = Expected::Coordinate { axis: axis_name };
                position[axis] = body.value(property.scalar, expected)?
            }
            Role::Colour(part) => {
                let largest = match property.scalar {
                    Scalar::U8 => f64::from(u8::MAX),
                    Scalar::U16 => f64::from(u16::MAX),
                    _ => 1.0,
                };
                let scalar = match body.format() {
                    // Fractions are met in text whatever the header says.
                    Format::PlyAscii => Scalar::F64,
                    _ => property.scalar,
                };
                let value = body.value(scalar, Expected::Number)?;
                colour.get_or_insert([NO_PART; 4])[part] = value / largest;
            }
            _ => step_over(property, body)?,
        }
    }
    let vertex = assembly.n_vertices();
    assembly.vertex(position, place)?;
    if let Some(parts) = colour {
        assembly.colour(vertex, parts);
    }
    Ok(())
}

fn read_face(
    element: &Element,
    header: &Header,
    body: &mut impl Body,
    corners: &mut Vec<u32>,
    assembly: &mut Assembly,
) -> Result<(), ReadError> {
    body.begin(Expected::Face)?;
    let place = body.place();
    corners.clear();
    for property in &element.properties {
        if property.role != Role::Corners {
            step_over(property, body)?;
            continue;
        }
        for _ in 0..value_count(property, body)? {
            let index = body.value(property.scalar, Expected::VertexIndex)? as i64;
            corners.push(vertex(index, header, place)?);
        }
    }
    assembly.face(corners, place)
}

/// Triangles of strips that follow each other in one list, a negative number between two.
fn read_strips(
    element: &Element,
    header: &Header,
    body: &mut impl Body,
    corners: &mut Vec<u32>,
    assembly: &mut Assembly,
) -> Result<(), ReadError> {
    body.begin(Expected::Face)?;
    for property in &element.properties {
        if property.role != Role::Corners {
            step_over(property, body)?;
            continue;
        }
        corners.clear();
        for _ in 0..value_count(property, body)? {
            let place = body.place();
            let index = body.value(property.scalar, Expected::VertexIndex)? as i64;
            if index < 0 {
                corners.clear();
                continue;
            }
            corners.push(vertex(index, header, place)?);
            assembly.strip(corners, place)?;
        }
    }
    Ok(())
}

fn vertex(index: i64, header: &Header, place: Place) -> Result<u32, ReadError> {
    match u32::try_from(index) {
        Ok(vertex) if u64::from(vertex) < header.vertices => Ok(vertex),
        _ => Err(ReadError::IndexOutOfRange {
            format: header.format,
            place,
            index,
            vertices: header.vertices as usize,
        }),
    }
}

fn step_over(property: &Property, body: &mut impl Body) -> Result<(), ReadError> {
    let count = value_count(property, body)?;
    body.skip(property.scalar, count)
}

/// How many values a property has in this record: one, or the length of its list.
fn value_count(property: &Property, body: &mut impl Body) -> Result<u64, ReadError> {
    const EXPECTED: Expected = Expected::ListLength;
    let Some(scalar) = property.length else {
        return Ok(1);
    };
    let place = body.place();
    let length = body.value(scalar, EXPECTED)?;
    if length < 0.0 {
        let word = length.to_string();
        let found = Found::Word { word };
        return Err(ReadError::syntax(body.format(), place, found, EXPECTED));
    }
    let length = length as u64;
    body.check_list(property.scalar, length)?;
    Ok(length)
}

#[cfg(test)]
mod tests {
    use super::super::Place;
    use super::*;
    use crate::soup::PolygonSoup;

    /// A header with the given encoding and elements.
    fn header(encoding: &str, elements: &str) -> Vec<u8> {
        format!("ply\nformat {encoding} 1.0\ncomment x\n{elements}end_header\n").into_bytes()
    }

    const VERTEX: &str = "element vertex 3\nproperty float x\nproperty float y\nproperty float z\n";
    const FACE: &str = "element face 1\nproperty list uchar int vertex_indices\n";

    fn ascii(elements: &str, body: &str) -> Result<Read, ReadError> {
        read(&[&header("ascii", elements), body.as_bytes()].concat())
    }

    #[test]
    fn unwanted_properties_and_elements_are_stepped_over() {
        let elements = "element camera 2\nproperty list uint8 float32 view\nproperty double fov\n\
            element empty 18446744073709551615\n\
            element vertex 3\nproperty uchar red\nproperty short z\nproperty list char int near\n\
            property float64 x\nproperty double y\n\
            element face 1\nproperty uchar flags\nproperty list ushort uint8 vertex_index\n\
            property list uchar float texcoord\n";
        let positions = [(3., 1., 2.), (6., 4., 5.), (9., 7., 8.)].map(|(z, x, y)| [x, y, z]);
        let check = |read: Read| {
            assert_eq!(read.soup.positions, positions.map(DVec3::from_array));
            assert_eq!(read.soup.faces().collect::<Vec<_>>(), [[2, 1, 0]]);
        };
        let body = "2 .5 .5 1\n0 1\n255 3 1 7 1 2\n0 6 0 4 5\n0 9 2 1 2 7 8\n1 3 2 1 0 2 0 0\n";
        check(ascii(elements, body).unwrap());

        let mut body = vec![2];
        body.extend([0; 16]);
        body.push(0);
        body.extend([0; 8]);
        for ([x, y, z], near) in positions.into_iter().zip([1_i8, 0, 2]) {
            body.push(255);
            body.extend((z as i16).to_be_bytes());
            body.push(near as u8);
            body.extend(vec![0; 4 * near as usize]);
            body.extend(x.to_be_bytes());
            body.extend(y.to_be_bytes());
        }
        body.extend([1, 0, 3, 2, 1, 0, 1, 0, 0, 0, 0]);
        check(read(&[header("binary_big_endian", elements), body].concat()).unwrap());
    }

    #[test]
    fn records_without_properties_are_none() {
        for encoding in ["ascii", "binary_little_endian"] {
            let elements = format!("element empty 9223372036854775807\n{VERTEX}{FACE}");
            let bytes = header(encoding, &elements);
            let header = Header::read(&bytes).unwrap();
            let count = if encoding == "ascii" {
                Text::new(&header, &bytes)
                    .unwrap()
                    .check_count(&header.elements[0])
            } else {
                Binary::new(&header, &bytes).check_count(&header.elements[0])
            };
            assert_eq!(count, Ok(0));
        }
    }

    #[test]
    fn line_ends_of_three_kinds() {
        for end in ["\n", "\r\n", "\r"] {
            let text = header("binary_little_endian", &format!("{VERTEX}{FACE}"));
            let mut bytes = String::from_utf8(text)
                .unwrap()
                .replace('\n', end)
                .into_bytes();
            // A body whose first byte looks like a line's end.
            bytes.extend([b'\n', 0, 0, 0]);
            bytes.extend([0; 32]);
            bytes.extend([3, 0, 0, 0, 0, 1, 0, 0, 0, 2, 0, 0, 0]);
            let read = read(&bytes).unwrap();
            assert_eq!(read.soup.face(0), [0, 1, 2]);
            assert_eq!(read.soup.positions[0].x, f64::from(f32::from_bits(10)));
        }
    }

    #[test]
    fn faces_may_come_before_vertices() {
        let read = ascii(&format!("{FACE}{VERTEX}"), "3 0 1 2\n0 0 0\n1 0 0\n0 1 0\n").unwrap();
        assert_eq!(read.soup.face(0), [0, 1, 2]);
    }

    #[test]
    fn strips_are_triangles_every_other_turned_round() {
        let elements = VERTEX.replace('3', "5")
            + "property uchar s\nelement tristrips 1\nproperty list int int vertex_indices\n";
        let points = "0 0 0 1\n1 0 0 1\n0 1 0 1\n1 1 0 1\n2 0 0 1\n";
        let strip = |list: &str| {
            let count = list.split(' ').count();
            ascii(&elements, &format!("{points}{count} {list}\n"))
        };
        let read = strip("0 1 2 3 -1 1 4 3").unwrap();
        let faces: Vec<_> = read.soup.faces().collect();
        assert_eq!(faces, [[0, 1, 2], [2, 1, 3], [1, 4, 3]]);
        let what = vec![Extra::TextureCoordinates];
        assert_eq!(read.warnings, [Oddity::LeftOut { what }]);
        // Repeated corners lead to the next part of a strip and are no triangles.
        let read = strip("0 1 2 2 1 1 1 4 3").unwrap();
        let faces: Vec<_> = read.soup.faces().collect();
        assert_eq!(faces, [[0, 1, 2], [1, 4, 3]]);
        let beyond = strip("0 1 5");
        assert!(
            matches!(beyond, Err(ReadError::IndexOutOfRange { index: 5, .. })),
            "{beyond:?}"
        );
    }

    #[test]
    fn headers_that_describe_no_mesh_are_refused() {
        let expected = |elements: &str| match ascii(elements, "") {
            Err(ReadError::Syntax { expected, .. }) => expected,
            other => panic!("{other:?}"),
        };
        let element = |word| Expected::Keyword { word };
        for (elements, missing) in [
            (FACE.to_owned(), element("element vertex")),
            (
                VERTEX.replace("float z", "list uchar float z"),
                Expected::VertexProperties,
            ),
            (
                format!("{VERTEX}property float x\n"),
                Expected::VertexProperties,
            ),
            (format!("{VERTEX}element face 1\n"), Expected::FaceProperty),
            (
                format!("{VERTEX}{}", FACE.replace("int ", "float ")),
                Expected::FaceProperty,
            ),
            (
                format!("{VERTEX}{}", FACE.replace("uchar", "float")),
                Expected::IntegerType,
            ),
            (VERTEX.replace("float x", "quad x"), Expected::NumberType),
            (format!("{VERTEX}{VERTEX}"), Expected::OneElementEach),
            ("property float x\n".to_owned(), element("element")),
            ("element vertex -3\n".to_owned(), Expected::ElementCount),
        ] {
            assert_eq!(expected(&elements), missing, "{elements}");
        }
        assert_eq!(
            ascii(VERTEX, "0 0 0\n1 0 0\n0 1 0\n"),
            Err(ReadError::NoFaces { vertices: 3 })
        );
        for text in [
            "ply",
            "ply\nformat ascii 1.0\nelement vertex 1\n",
            "ply\nformat binary 1.0\n",
        ] {
            assert!(
                matches!(read(text.as_bytes()), Err(ReadError::Syntax { .. })),
                "{text}"
            );
        }
    }

    #[test]
    fn errors_name_the_line_or_the_byte() {
        let elements = format!("{VERTEX}{FACE}");
        let lines = header("ascii", &elements)
            .iter()
            .filter(|b| **b == b'\n')
            .count();
        let word = |word: &str| Found::Word { word: word.into() };
        for (face, found) in [
            ("-1 0 0", word("-1")),
            ("3 0 1", Found::EndOfLine),
            ("3 0 1 x", word("x")),
            ("   ", Found::EndOfFile),
        ] {
            let body = format!("0 0 0\n1 0 0\n\n0 1 0\n{face}");
            match ascii(&elements, &body) {
                Err(ReadError::Syntax {
                    place, found: f, ..
                }) => {
                    let line = 5;
                    assert_eq!((place, f), (Place::Line { line: lines + line }, found));
                }
                other => panic!("{other:?}"),
            }
        }
        let start = header("binary_little_endian", &elements);
        let face = start.len() + 36;
        let binary = |face: &[u8]| read(&[&start[..], &[0; 36], face].concat());
        assert_eq!(
            binary(&[3, 0, 0, 0, 0, 1, 0, 0, 0, 3, 0, 0, 0]),
            Err(ReadError::IndexOutOfRange {
                format: Format::Ply,
                place: Place::Byte { byte: face },
                index: 3,
                vertices: 3
            })
        );
        assert_eq!(
            binary(&[255, 0, 0]),
            Err(ReadError::Truncated {
                offset: face + 1,
                needed: 4 * 255,
                available: 2
            })
        );
        assert_eq!(
            read(&[&start[..], &[0; 35]].concat()),
            Err(ReadError::Truncated {
                offset: start.len(),
                needed: 36,
                available: 35
            })
        );
    }

    #[test]
    fn huge_counts_are_refused_before_anything_is_reserved() {
        let most = u64::MAX;
        let elements = VERTEX.replace('3', &i64::MAX.to_string()) + FACE;
        assert!(matches!(
            ascii(&elements, "0 0 0\n"),
            Err(ReadError::CountTooLarge {
                place: Place::Line { line: 4 },
                what: "vertices",
                ..
            })
        ));
        let bytes = header("binary_big_endian", &elements);
        assert_eq!(
            read(&bytes),
            Err(ReadError::Truncated {
                offset: bytes.len(),
                needed: most,
                available: 0
            })
        );
        let elements = format!("{VERTEX}{}", FACE.replace("uchar", "uint"));
        let mut bytes = header("binary_big_endian", &elements);
        bytes.extend([0; 36]);
        let offset = bytes.len() + 4;
        bytes.extend([0xFF; 4]);
        assert_eq!(
            read(&bytes),
            Err(ReadError::Truncated {
                offset,
                needed: 4 * u64::from(u32::MAX),
                available: 0
            })
        );
    }

    #[test]
    fn long_faces_get_a_long_count() {
        let corners: Vec<u32> = (0..300).collect();
        let soup = PolygonSoup::from_faces(vec![DVec3::ONE; 300], &[corners]);
        for format in [Format::Ply, Format::PlyBigEndian, Format::PlyAscii] {
            assert_eq!(read(&write(&soup, format, "")).unwrap().soup, soup);
        }
    }
}
