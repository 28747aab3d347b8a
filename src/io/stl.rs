//! STL, in text and in binary: triangles that do not know their neighbours.
//!
//! Corners at exactly the same position become one vertex, numbered by first use; normals
//! and attributes are not looked at. Several solids make one mesh.

use std::fmt::Write as _;

use glam::DVec3;

use super::text::{Lines, Words, comment_lines};
use super::weld::Weld;
use super::{Expected, Format, Oddity, Place, Read, ReadError, WriteError, single};
use crate::order;
use crate::soup::PolygonSoup;

/// Bytes before the first triangle of a binary file: a free text, then the count.
const HEADER: usize = 84;
/// Bytes of a triangle: normal, three corners, two bytes of attributes.
const TRIANGLE: usize = 50;

/// Whether the file is exactly as long as its count of triangles asks for.
///
/// The right test for a binary file: many begin with `solid`, as a text file does, and in
/// a text the count would be four letters, thus an impossible length.
pub(super) fn has_binary_length(bytes: &[u8]) -> bool {
    announced(bytes).is_some_and(|count| {
        bytes.len() as u64 == HEADER as u64 + TRIANGLE as u64 * u64::from(count)
    })
}

/// The number of triangles a binary file announces.
fn announced(bytes: &[u8]) -> Option<u32> {
    bytes
        .get(HEADER - 4..)?
        .first_chunk()
        .map(|count| u32::from_le_bytes(*count))
}

/// Reads a binary STL file.
pub(super) fn read_binary(bytes: &[u8]) -> Result<Read, ReadError> {
    let cut_short = |offset, needed| {
        let available = bytes.len() - offset;
        ReadError::Truncated {
            offset,
            needed,
            available,
        }
    };
    let announced = match announced(bytes) {
        Some(count) => u64::from(count),
        None => return Err(cut_short(0, HEADER as u64)),
    };
    // Some programs write their triangles as a stream and never come back to the header, or join
    // files and leave the header of the first: what the file has counts.
    let whole = (bytes.len() - HEADER) / TRIANGLE;
    let is_uncounted =
        announced != whole as u64 && whole > 0 && (bytes.len() - HEADER).is_multiple_of(TRIANGLE);
    let count = if is_uncounted {
        whole as u64
    } else {
        announced
    };
    let needed = count * TRIANGLE as u64;
    let triangles = &bytes[HEADER..];
    if needed > triangles.len() as u64 {
        return Err(cut_short(HEADER, needed));
    }
    let mut weld = Weld::new();
    // Fits: no more than is there.
    for (face, triangle) in triangles[..needed as usize]
        .chunks_exact(TRIANGLE)
        .enumerate()
    {
        let mut corners = [0; 3];
        for (k, corner) in corners.iter_mut().enumerate() {
            let start = 12 * (k + 1);
            let place = Place::Byte {
                byte: HEADER + TRIANGLE * face + start,
            };
            let position = DVec3::from_array(std::array::from_fn(|axis| {
                let at = start + 4 * axis;
                let bytes = std::array::from_fn(|byte| triangle[at + byte]);
                f64::from(f32::from_le_bytes(bytes))
            }));
            *corner = weld.corner(position, place)?;
        }
        weld.assembly.face(
            &corners,
            Place::Byte {
                byte: HEADER + TRIANGLE * face,
            },
        )?;
    }
    let mut read = weld.assembly.finish(Format::Stl)?;
    if is_uncounted {
        read.warnings.push(Oddity::Uncounted { announced, count });
    }
    let extra = triangles.len() as u64 - needed;
    if extra > 0 {
        read.warnings.push(Oddity::BytesLeft { count: extra });
    }
    Ok(read)
}

/// Reads an ASCII STL file.
///
/// Keywords may be in any case and a facet may lack its normal or have more than three
/// corners.
pub(super) fn read_ascii(bytes: &[u8]) -> Result<Read, ReadError> {
    const SOLID: Expected = Expected::Keyword { word: "solid" };
    let mut lines = Lines::of_text(Format::StlAscii, bytes)?;
    let mut first = lines.next_filled(SOLID)?;
    let word = first.word(SOLID)?;
    if !word.eq_ignore_ascii_case(b"solid") {
        return Err(first.error(Some(word), SOLID));
    }
    let mut weld = Weld::new();
    let mut corners = Vec::new();
    let mut open = None;
    let mut ended = false;
    first.give_back(word);
    for mut words in std::iter::once(first).chain(lines.by_ref()) {
        let place = words.place();
        // Some write all of it in one line.
        while let Some(word) = words.next() {
            let lower = word.to_ascii_lowercase();
            match (lower.as_slice(), open) {
                (b"vertex", Some(_)) => corners.push(weld.corner(words.point()?, place)?),
                (b"outer", None) => open = Some(place),
                (b"endloop", Some(place)) => {
                    weld.assembly.face(&corners, place)?;
                    corners.clear();
                    open = None;
                }
                (b"facet" | b"endfacet", None) => {}
                (b"solid" | b"endsolid", None) => ended = word.len() > 5,
                (_, open) => {
                    let word_of = if open.is_some() {
                        "vertex, endloop"
                    } else {
                        "facet, outer loop, vertex, endloop, endfacet, solid, endsolid"
                    };
                    let expected = Expected::Keyword { word: word_of };
                    return Err(words.error(Some(word), expected));
                }
            }
            skip_to_keyword(&mut words, lower.ends_with(b"solid"));
        }
    }
    if open.is_some() {
        lines.next_filled(Expected::Keyword { word: "endloop" })?;
    }
    let mut read = weld.assembly.finish(Format::StlAscii)?;
    if !ended {
        read.warnings.push(Oddity::NoEnd);
    }
    Ok(read)
}

/// Passes what belongs to the keyword before: a normal, or a name, in which any word may stand.
fn skip_to_keyword(words: &mut Words<'_>, is_named: bool) {
    const KEYWORDS: [&str; 6] = [
        "facet", "outer", "vertex", "endloop", "endfacet", "endsolid",
    ];
    let is_one_of = |word: Option<&[u8]>, all: &[&str]| {
        word.is_some_and(|word| {
            all.iter()
                .any(|one| word.eq_ignore_ascii_case(one.as_bytes()))
        })
    };
    loop {
        let mut ahead = words.clone();
        let next = ahead.next();
        let is_keyword = if is_named {
            is_one_of(next, &KEYWORDS[..1]) && is_one_of(ahead.clone().next(), &["normal", "outer"])
        } else {
            is_one_of(next, &KEYWORDS)
        };
        if next.is_none() || is_keyword {
            return;
        }
        *words = ahead;
    }
}

/// The normal of a triangle; zero, as the format has it, where there is none.
fn normal([a, b, c]: [DVec3; 3]) -> DVec3 {
    (b - a).cross(c - a).normalize_or_zero()
}

fn corner_positions(soup: &PolygonSoup) -> Vec<[DVec3; 3]> {
    let positions = |corners: [u32; 3]| corners.map(|c| soup.positions[c as usize]);
    soup.triangles().into_iter().map(positions).collect()
}

/// Writes positions in the shortest form that reads back to the same bits.
pub(super) fn write_ascii(soup: &PolygonSoup, comment: &str) -> Vec<u8> {
    let name = comment_lines(comment).collect::<Vec<_>>().join(" ");
    let mut out = format!("solid {name}\n");
    for triangle in corner_positions(soup) {
        let n = normal(triangle).as_vec3();
        // Writing to a string cannot fail.
        let _ = writeln!(
            out,
            "facet normal {:?} {:?} {:?}\n outer loop",
            n.x, n.y, n.z
        );
        for p in triangle {
            let _ = writeln!(out, "  vertex {:?} {:?} {:?}", p.x, p.y, p.z);
        }
        out += " endloop\nendfacet\n";
    }
    out += "endsolid\n";
    out.into_bytes()
}

/// How far a binary file moves a mesh to the origin, for whom to tell.
pub(super) fn moved_by(soup: &PolygonSoup) -> Option<DVec3> {
    let centre = single::centre(&soup.positions);
    (centre != DVec3::ZERO).then_some(-centre)
}

/// How many vertices a file puts at the place of another, which readers take for the same.
pub(super) fn joined(soup: &PolygonSoup, format: Format) -> usize {
    let shift = moved_by(soup).unwrap_or(DVec3::ZERO);
    // Nothing added to -0 is 0.
    let place = |p: &DVec3| match format {
        Format::Stl => (*p + shift).as_vec3().as_dvec3() + DVec3::ZERO,
        _ => *p + DVec3::ZERO,
    };
    let bits = |p: &DVec3| place(p).to_array().map(f64::to_bits);
    let mut places: Vec<[u64; 3]> = soup.positions.iter().map(bits).collect();
    order::sort(&mut places);
    places.dedup();
    soup.positions.len() - places.len()
}

/// Writes positions rounded to single precision, of a mesh far from the origin after it was moved
/// there.
pub(super) fn write_binary(soup: &PolygonSoup, comment: &str) -> Result<Vec<u8>, WriteError> {
    let shift = moved_by(soup).unwrap_or(DVec3::ZERO);
    single::check_positions(soup.positions.iter().map(|p| *p + shift))?;
    let triangles = corner_positions(soup);
    let count = u32::try_from(triangles.len()).map_err(|_| WriteError::TooLarge {
        format: Format::Stl,
    })?;
    // Readers that look for a leading `solid` must not find it.
    let mut out = format!("binary STL {comment}").into_bytes();
    out.resize(HEADER - 4, b' ');
    out.reserve(TRIANGLE * count as usize);
    out.extend(count.to_le_bytes());
    for triangle in triangles {
        let corners = triangle.map(|corner| corner + shift);
        let vectors = std::iter::once(normal(triangle)).chain(corners);
        for coordinate in vectors.flat_map(|v| v.as_vec3().to_array()) {
            out.extend(coordinate.to_le_bytes());
        }
        out.extend([0, 0]);
    }
    Ok(out)
}

#[cfg(test)]
mod tests {
    use super::super::Found;
    use super::*;

    fn binary(header: &str, triangles: &[[[f32; 3]; 3]]) -> Vec<u8> {
        let mut bytes = header.as_bytes().to_vec();
        bytes.resize(80, 0);
        bytes.extend((triangles.len() as u32).to_le_bytes());
        for triangle in triangles {
            bytes.extend([0; 12]);
            bytes.extend(triangle.iter().flatten().flat_map(|c| c.to_le_bytes()));
            bytes.extend([0; 2]);
        }
        bytes
    }

    const SQUARE: [[[f32; 3]; 3]; 2] = [
        [[0., 0., 0.], [1., 0., 0.], [1., 1., 0.]],
        [[-0., 0., -0.], [1., 1., 0.], [0., 1., 0.]],
    ];

    #[test]
    fn corners_weld_in_order_of_first_use() {
        let bytes = binary("solid but binary", &SQUARE);
        assert!(has_binary_length(&bytes));
        let read = read_binary(&bytes).unwrap();
        assert_eq!(
            read.soup.faces().collect::<Vec<_>>(),
            [[0, 1, 2], [0, 2, 3]]
        );
        assert_eq!(read.soup.positions[0].to_array().map(f64::to_bits), [0; 3]);
        // A neighbour one bit away stays its own vertex.
        let mut torn = SQUARE;
        torn[1][1][0] = 1.0_f32.next_up();
        assert_eq!(
            read_binary(&binary("", &torn))
                .unwrap()
                .soup
                .positions
                .len(),
            5
        );
    }

    #[test]
    fn binary_length_is_checked() {
        let bytes = binary("", &SQUARE);
        for cut in [84, 100, 183] {
            assert_eq!(
                read_binary(&bytes[..cut]),
                Err(ReadError::Truncated {
                    offset: 84,
                    needed: 100,
                    available: cut - 84
                })
            );
        }
        let short = [0xFF; 83];
        assert_eq!(
            read_binary(&short),
            Err(ReadError::Truncated {
                offset: 0,
                needed: 84,
                available: 83
            })
        );
        let long = [&bytes[..], b"..."].concat();
        let read = read_binary(&long).unwrap();
        assert_eq!(read.soup.n_faces(), 2);
        assert_eq!(read.warnings, [Oddity::BytesLeft { count: 3 }]);
        let mut uncounted = bytes.clone();
        uncounted[80..84].fill(0);
        let read = read_binary(&uncounted).unwrap();
        assert_eq!(read.soup.n_faces(), 2);
        let said = |announced, count| [Oddity::Uncounted { announced, count }];
        assert_eq!(read.warnings, said(0, 2));
        uncounted[80..84].copy_from_slice(&1_u32.to_le_bytes());
        assert_eq!(read_binary(&uncounted).unwrap().warnings, said(1, 2));
        // As a stream, or cut after a whole triangle.
        uncounted[80..84].fill(0xFF);
        let read = read_binary(&uncounted).unwrap();
        assert_eq!(read.warnings, said(u64::from(u32::MAX), 2));
        let read = read_binary(&bytes[..134]).unwrap();
        assert_eq!(read.soup.n_faces(), 1);
        assert_eq!(read.warnings, said(2, 1));
        assert_eq!(
            read_binary(&binary("", &[])),
            Err(ReadError::NoFaces { vertices: 0 })
        );
    }

    #[test]
    fn a_corner_that_is_not_finite_is_named() {
        let mut broken = SQUARE;
        broken[1][2][1] = f32::NAN;
        assert_eq!(
            read_binary(&binary("", &broken)),
            Err(ReadError::NonFiniteVertex {
                number: 6,
                place: Place::Byte { byte: 84 + 50 + 36 }
            })
        );
    }

    #[test]
    fn text_in_loose_style() {
        let text = "SOLID\tfacet vertex\r\nfacet\r\nOuter Loop\r\nVERTEX 0 0 0\nvertex 1 0 0\n\
            vertex 1 1 0\nvertex -0 1 0\nendloop\nendfacet\nendsolid\nsolid\nfacet normal 0 0 1\n\
            outer loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 0 1\nendloop\nendfacet\nendsolid b\n";
        let read = read_ascii(text.as_bytes()).unwrap();
        assert_eq!(
            read.soup.faces().collect::<Vec<_>>(),
            [&[0, 1, 2, 3][..], &[0, 1, 4]]
        );
        assert!(read.warnings.is_empty());
        let one_line = text.replace("\r\nfacet\r\n", " facet normal 0 0 1 ");
        let one_line = one_line.replace(['\r', '\n'], " ");
        assert_eq!(read_ascii(one_line.as_bytes()), Ok(read));
        let unended = text.trim_end().strip_suffix("endsolid b").unwrap();
        assert_eq!(read_ascii(unended.as_bytes()).unwrap().warnings.len(), 1);
    }

    #[test]
    fn text_out_of_order_is_refused() {
        let word = |word: &str| Found::Word { word: word.into() };
        for (text, line, found) in [
            ("solid\nvertex 0 0 0\n", 2, word("vertex")),
            ("solid\nouter loop\nouter loop\n", 3, word("outer")),
            ("solid\nouter loop\nvertex 0 0\n", 3, Found::EndOfLine),
            ("solid\nouter loop\nvertex 0 0 0\n", 3, Found::EndOfFile),
            ("solid\nfacet normal 0 0 1\nv 0 0 0\n", 3, word("v")),
            ("facet\n", 1, word("facet")),
        ] {
            match read_ascii(text.as_bytes()) {
                Err(ReadError::Syntax {
                    place, found: f, ..
                }) => {
                    assert_eq!((place, f), (Place::Line { line }, found));
                }
                other => panic!("{text}: {other:?}"),
            }
        }
    }

    #[test]
    fn a_written_binary_file_never_begins_like_a_text_one() {
        let square = read_binary(&binary("", &SQUARE)).unwrap().soup;
        let bytes = write_binary(&square, &"solid ".repeat(40)).unwrap();
        assert!(has_binary_length(&bytes) && !bytes.starts_with(b"solid"));
        // The normal of the first triangle.
        assert_eq!(bytes[84 + 8..][..4], 1.0_f32.to_le_bytes());
    }
}
