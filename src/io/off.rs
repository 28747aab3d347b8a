//! OFF, the format of Geomview, in text and in binary.
//!
//! The header word may carry `ST`, `C` and `N` or be missing: a normal, a colour and texture
//! coordinates follow the position on a vertex line, in this order. A face line is the number of
//! corners, the corners, and perhaps a colour, which is left aside. Colours are of 1 or of 255.

mod binary;

use std::fmt::Write as _;

use super::assembly::{Assembly, NO_PART};
use super::text::{Lines, comment_lines};
use super::{Expected, Extra, Format, Oddity, Place, Read, ReadError};
use crate::soup::PolygonSoup;

/// Letters before `OFF` that leave the position where it is.
const PREFIXES: [&[u8]; 3] = [b"ST", b"C", b"N"];

/// The word that a file begins with.
const HEADER: Expected = Expected::Keyword { word: "OFF" };

/// Whether a file that begins with this word is an OFF file.
pub(super) fn is_header(word: &[u8]) -> bool {
    let dimension = header_prefix(word);
    matches!(dimension, Some(b"" | b"4" | b"n" | b"4n")) || glued(word).is_some()
}

/// The digits of a count that stands right after the header word, as in a well-known collection.
fn glued(word: &[u8]) -> Option<&[u8]> {
    let header = word.iter().rposition(|byte| !byte.is_ascii_digit())? + 1;
    let (header, digits) = word.split_at(header);
    (!digits.is_empty() && header_prefix(header) == Some(b"")).then_some(digits)
}

/// What stands before `OFF` besides the letters of [`PREFIXES`].
fn header_prefix(word: &[u8]) -> Option<&[u8]> {
    let mut prefix = word
        .strip_suffix(b"OFF")
        .or_else(|| word.strip_suffix(b"off"))?;
    while let Some(rest) = PREFIXES.iter().find_map(|p| prefix.strip_prefix(*p)) {
        prefix = rest;
    }
    Some(prefix)
}

/// Refuses what has another dimension than three.
fn plain(word: &[u8]) -> Result<(), ReadError> {
    match header_prefix(word) {
        Some(b"") => Ok(()),
        _ => Err(ReadError::Unsupported { what: "nd-off" }),
    }
}

/// Whether vertices have colours, texture coordinates and normals.
fn letters_of(word: &[u8]) -> [bool; 3] {
    // `OFF` itself has none of these letters.
    [b'C', b'T', b'N'].map(|letter| word.contains(&letter))
}

/// Reads an OFF file.
pub(super) fn read(bytes: &[u8]) -> Result<Read, ReadError> {
    // Binary OFF begins with a line of text like any other.
    let mut header = Lines::new(Format::Off, bytes).next_filled(HEADER)?;
    let word = header.next().unwrap_or_default();
    let has_header = is_header(word);
    if has_header && header.next() == Some(b"BINARY") {
        plain(word)?;
        let line = bytes.iter().position(|&byte| byte == b'\n');
        return binary::read(word, bytes, line.map_or(bytes.len(), |end| end + 1));
    }

    let mut lines = Lines::of_text(Format::Off, bytes)?;
    let mut words = lines.next_filled(HEADER)?;
    let mut letters: &[u8] = b"";
    if has_header {
        let word = words.word(HEADER)?;
        letters = word;
        if let Some(count) = glued(word) {
            words.give_back(count);
        } else {
            plain(word)?;
        }
        if words.clone().next().is_none() {
            words = lines.next_filled(Expected::VertexCount)?;
        }
    }
    let expected = if has_header {
        Expected::VertexCount
    } else {
        Expected::OffOrVertexCount
    };
    let vertices = words.how_many(expected)?;
    let faces = words.how_many(Expected::FaceCount)?;
    // A vertex takes six bytes at least, as in "0 0 0\n", a face two.
    let left = lines.rest().len() as u64 + 1;
    let vertices = checked_count(vertices, "vertices", left / 6, words.place())?;
    let faces = checked_count(faces, "faces", left / 2, words.place())?;

    let mut assembly = Assembly::new();
    assembly.reserve(vertices, faces);
    let [has_colours, has_texture, has_normals] = letters_of(letters);
    let (before, after) = (3 * usize::from(has_normals), 2 * usize::from(has_texture));
    for vertex in 0..vertices {
        let mut words = lines.next_filled(Expected::Vertex)?;
        assembly.vertex(words.point()?, words.place())?;
        if !has_colours {
            continue;
        }
        let (count, numbers) = words.numbers::<7>();
        let [r, g, b, mut a] = [0, 1, 2, 3].map(|part| numbers[before + part]);
        let parts = count.saturating_sub(before + after);
        if parts == 3 {
            a = NO_PART;
        }
        if matches!(parts, 3 | 4) && (r + g + b).is_finite() {
            assembly.colour(vertex, [r, g, b, a]);
        }
    }
    let mut corners = Vec::new();
    for _ in 0..faces {
        let mut words = lines.next_filled(Expected::Face)?;
        let place = words.place();
        corners.clear();
        for _ in 0..words.how_many(Expected::CornerCount)? {
            let index = words.integer(Expected::VertexIndex)?;
            match u32::try_from(index) {
                Ok(vertex) if (vertex as usize) < vertices => corners.push(vertex),
                _ => {
                    let format = Format::Off;
                    return Err(ReadError::IndexOutOfRange {
                        format,
                        place,
                        index,
                        vertices,
                    });
                }
            }
        }
        assembly.face(&corners, place)?;
    }
    let left = has_colours && !assembly.has_colours();
    let mut read = assembly.finish(Format::Off)?;
    read.warnings.extend(lines.left());
    read.warnings.extend(Oddity::left_out(&[
        (Extra::Colours, left),
        (Extra::TextureCoordinates, has_texture),
    ]));
    Ok(read)
}

fn checked_count(
    count: u64,
    what: &'static str,
    at_most: u64,
    place: Place,
) -> Result<usize, ReadError> {
    match usize::try_from(count) {
        Ok(fitting) if count <= at_most => Ok(fitting),
        _ => Err(ReadError::CountTooLarge {
            place,
            what,
            count,
            at_most,
        }),
    }
}

/// Writes positions in the shortest form that reads back to the same bits.
pub(super) fn write(soup: &PolygonSoup, comment: &str) -> Vec<u8> {
    let mut out = String::with_capacity(64 * soup.positions.len() + 8 * soup.corners.len());
    let has_colours = soup.has_colours();
    out += if has_colours { "COFF\n" } else { "OFF\n" };
    for line in comment_lines(comment) {
        out += &format!("# {line}\n");
    }
    // Writing to a string cannot fail. Nobody reads the edge count; 0 is customary.
    let _ = writeln!(out, "{} {} 0", soup.positions.len(), soup.n_faces());
    for (v, p) in soup.positions.iter().enumerate() {
        let _ = write!(out, "{:?} {:?} {:?}", p.x, p.y, p.z);
        for part in soup.colours.get(v).into_iter().flatten() {
            let _ = write!(out, " {part:?}");
        }
        out.push('\n');
    }
    for face in soup.faces() {
        let _ = write!(out, "{}", face.len());
        for corner in face {
            let _ = write!(out, " {corner}");
        }
        out.push('\n');
    }
    out.into_bytes()
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::super::Found;
    use super::*;

    const BODY: &str = "0 0 0\n1 0 0\n1 1 0\n0 1 0\n4 0 1 2 3\n3 0 1 2 255 0 0\n";

    #[test]
    fn headers_of_every_shape() {
        for header in [
            "OFF\n4 2 0\n",
            "OFF 4 2 5\n",
            "OFF 4 2\n",
            "4 2 0\n",
            "off\n# made by hand\n\n4 2 0 # counts\n",
            "COFF\n4 2 0\n",
            "STCNOFF\r\n4 2 0\r\n",
            "NCOFF\n4 2 0\n",
            "OFF4 2 0\n",
            "COFF4 2 0\n",
        ] {
            let read = read(format!("{header}{BODY}").as_bytes()).unwrap();
            let faces: Vec<_> = read.soup.faces().collect();
            assert_eq!(faces, [&[0, 1, 2, 3][..], &[0, 1, 2]], "{header}");
            assert_eq!(read.soup.positions[2], DVec3::new(1., 1., 0.));
        }
    }

    #[test]
    fn what_is_not_plain_three_dimensional_text_is_refused() {
        for (text, what) in [
            ("4OFF BINARY\n\0\0\0\x04", "nd-off"),
            ("4OFF\n1 1 0\n", "nd-off"),
            ("CnOFF\n4\n1 1 0\n", "nd-off"),
        ] {
            assert_eq!(read(text.as_bytes()), Err(ReadError::Unsupported { what }));
        }
    }

    #[test]
    fn counts_are_checked_before_anything_is_reserved() {
        for (counts, what, at_most) in [
            (
                "18446744073709551615 1 0",
                "vertices",
                BODY.len() as u64 / 6,
            ),
            ("4 99999 0", "faces", BODY.len() as u64 / 2),
        ] {
            match read(format!("OFF\n{counts}\n{BODY}").as_bytes()) {
                Err(ReadError::CountTooLarge {
                    place,
                    what: w,
                    at_most: m,
                    ..
                }) => {
                    assert_eq!((place, w), (Place::Line { line: 2 }, what));
                    assert!(m <= at_most + 1);
                }
                other => panic!("{other:?}"),
            }
        }
        for (text, line, found) in [
            ("OFF\n-4 2 0\n", 2, "-4"),
            ("OFF 1 1 0\n0 0 0\n-3 0\n", 3, "-3"),
        ] {
            match read(text.as_bytes()) {
                Err(ReadError::Syntax {
                    place, found: f, ..
                }) => {
                    let word = found.into();
                    assert_eq!((place, f), (Place::Line { line }, Found::Word { word }));
                }
                other => panic!("{other:?}"),
            }
        }
    }

    #[test]
    fn errors_name_the_line() {
        let text = format!("OFF\n4 3 0\n{BODY}3 0 1 4\n");
        assert_eq!(
            read(text.as_bytes()),
            Err(ReadError::IndexOutOfRange {
                format: Format::Off,
                place: Place::Line { line: 9 },
                index: 4,
                vertices: 4
            })
        );
        let text = format!("OFF\n4 3 0\n{BODY}");
        assert_eq!(
            read(text.as_bytes()),
            Err(ReadError::Syntax {
                format: Format::Off,
                place: Place::Line { line: 8 },
                found: Found::EndOfFile,
                expected: Expected::Face
            })
        );
    }
}
