//! Wavefront OBJ: `v` and `f`, as a polygon mesh uses them.
//!
//! Groups, objects, smoothing groups and materials do not divide the mesh: whatever
//! shares an index shares the vertex. Texture and normal indices are not looked at. Three numbers
//! after a position, or four, are a colour, from 0 to 1 or to 255, which most programs know though
//! it is not of the specification. One number is the weight of a rational curve, or a scalar of
//! somebody's own: it is left aside with a warning.

use std::fmt::Write as _;

use super::assembly::{Assembly, Tally};
use super::text::{Lines, Words, comment_lines, parse_integer, without_padding};
use super::{Expected, Extra, Format, Oddity, Read, ReadError, colour};
use crate::soup::PolygonSoup;

/// Reads an OBJ file; a face may name vertices that come after it.
pub(super) fn read(bytes: &[u8]) -> Result<Read, ReadError> {
    let bytes = without_padding(bytes);
    let lines = || Lines::new(Format::Obj, bytes).with_continuation();
    // The number of vertices first, so that every index is judged where it stands.
    let vertices = Lines::of_text(Format::Obj, bytes)?
        .with_continuation()
        .filter_map(|mut words| words.next())
        .filter(|&word| word == b"v")
        .count();

    let mut assembly = Assembly::new();
    assembly.reserve(vertices, 0);
    let (mut skipped, mut fourth) = (Tally::default(), Tally::default());
    let [
        mut has_others,
        mut has_texture,
        mut has_materials,
        mut is_free_form,
    ] = [false; 4];
    let mut groups = 0;
    let mut corners = Vec::new();
    for mut words in lines() {
        match words.next() {
            None => {}
            Some(b"v") => {
                let place = words.place();
                assembly.vertex(words.point()?, place)?;
                match words.numbers() {
                    (0, _) => {}
                    // As most programs write it that write it at all.
                    (1, [1.0, _, _, _]) => {}
                    (1, _) => fourth.count(place),
                    (3 | 4, [r, g, b, a]) if (r + g + b).is_finite() => {
                        assembly.colour(assembly.n_vertices() - 1, [r, g, b, a]);
                    }
                    _ => has_others = true,
                }
            }
            Some(b"f") => {
                let place = words.place();
                corners.clear();
                while let Some(word) = words.next() {
                    corners.push(corner(word, &words, assembly.n_vertices(), vertices)?);
                }
                assembly.face(&corners, place)?;
            }
            Some(b"vt") => has_texture = true,
            Some(b"usemtl") => has_materials = true,
            Some(b"o" | b"g") => groups += 1,
            Some(
                b"vn" | b"vp" | b"s" | b"mg" | b"mtllib" | b"usemap" | b"maplib" | b"bevel"
                | b"c_interp" | b"d_interp" | b"lod" | b"shadow_obj" | b"trace_obj",
            ) => {}
            Some(word) => {
                is_free_form |= word == b"surf";
                skipped.count(words.place());
            }
        }
    }
    if is_free_form && assembly.n_faces() == 0 {
        return Err(ReadError::Unsupported {
            what: "obj-free-form",
        });
    }
    let mut read = assembly.finish(Format::Obj)?;
    let other = |(count, first)| Oddity::OtherLines { count, first };
    read.warnings.extend(skipped.met().map(other));
    let weights = |(count, first)| Oddity::FourthNumbers { count, first };
    read.warnings.extend(fourth.met().map(weights));
    read.warnings.extend(Oddity::left_out(&[
        (Extra::TextureCoordinates, has_texture),
        (Extra::Materials, has_materials),
        // One is the name of the whole.
        (Extra::Groups, groups > 1),
        (Extra::Data, has_others),
    ]));
    Ok(read)
}

/// The vertex of one corner, written `v`, `v/vt`, `v//vn` or `v/vt/vn`; `v` counts from 1,
/// or backwards from the `before` vertices already read.
fn corner(word: &[u8], line: &Words<'_>, before: usize, vertices: usize) -> Result<u32, ReadError> {
    let written = word.split(|&b| b == b'/').next().unwrap_or(word);
    let index =
        parse_integer(written).ok_or_else(|| line.error(Some(word), Expected::ObjCorner))?;
    let (resolved, available) = if index < 0 {
        (index + before as i64, before)
    } else {
        (index - 1, vertices)
    };
    match u32::try_from(resolved) {
        Ok(vertex) if (vertex as usize) < available => Ok(vertex),
        _ => Err(ReadError::IndexOutOfRange {
            format: Format::Obj,
            place: line.place(),
            index,
            vertices: available,
        }),
    }
}

/// Writes positions in the shortest form that reads back to the same bits.
pub(super) fn write(soup: &PolygonSoup, comment: &str) -> Vec<u8> {
    let mut out = String::with_capacity(64 * soup.positions.len() + 8 * soup.corners.len());
    for line in comment_lines(comment) {
        out += &format!("# {line}\n");
    }
    let parts = colour::parts(soup);
    for (v, p) in soup.positions.iter().enumerate() {
        // Writing to a string cannot fail.
        let _ = write!(out, "v {:?} {:?} {:?}", p.x, p.y, p.z);
        for part in soup.colours.get(v).iter().flat_map(|c| &c[..parts]) {
            let _ = write!(out, " {part:?}");
        }
        out.push('\n');
    }
    for face in soup.faces() {
        out.push('f');
        for corner in face {
            let _ = write!(out, " {}", u64::from(*corner) + 1);
        }
        out.push('\n');
    }
    out.into_bytes()
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::super::{Found, Place};
    use super::*;

    fn faces(text: &str) -> Vec<Vec<u32>> {
        read(text.as_bytes())
            .unwrap()
            .soup
            .faces()
            .map(<[u32]>::to_vec)
            .collect()
    }

    const SQUARE: &str = "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\n";

    #[test]
    fn corners_in_every_notation() {
        let text =
            format!("{SQUARE}f 1 2 3 4\nf 1/1 2/9 3/x\nf 1//1 2//1 3//1\nf 1/2/3 3/2/1 4/\n");
        assert_eq!(
            faces(&text),
            [
                vec![0, 1, 2, 3],
                vec![0, 1, 2],
                vec![0, 1, 2],
                vec![0, 2, 3]
            ]
        );
    }

    #[test]
    fn negative_indices_count_from_where_they_stand() {
        let text = "v 0 0 0\nv 1 0 0\nv 1 1 0\nf -3 -2 -1\nv 0 1 0\nf -4 -2 -1\n";
        assert_eq!(faces(text), [[0, 1, 2], [0, 2, 3]]);
        let text = "v 0 0 0\nv 1 0 0\nf -3 1 2\nv 1 1 0\n";
        assert_eq!(
            read(text.as_bytes()),
            Err(ReadError::IndexOutOfRange {
                format: Format::Obj,
                place: Place::Line { line: 3 },
                index: -3,
                vertices: 2
            })
        );
    }

    #[test]
    fn groups_share_vertices_and_faces_may_come_first() {
        let text = format!("o a\nf 1 2 3\ng b c\nusemtl\ns off\nf 1 3 4\n{SQUARE}");
        assert_eq!(faces(&text), [[0, 1, 2], [0, 2, 3]]);
    }

    #[test]
    fn what_is_left_aside_is_said_once() {
        let of = |text: &str| read(text.as_bytes()).unwrap();
        let read = of("v 1 2 3 0.5\nv 4 5 6 1\nv 7 8 9 # corner\nf 1 2 3\n");
        assert_eq!(
            read.soup.positions,
            [
                DVec3::new(1., 2., 3.),
                DVec3::new(4., 5., 6.),
                DVec3::new(7., 8., 9.)
            ]
        );
        let first = Place::Line { line: 1 };
        assert_eq!(read.warnings, [Oddity::FourthNumbers { count: 1, first }]);
        assert_eq!(
            of("v 1 2 3 1.000\nv 4 5 6 1\nv 7 8 9 1\nf 1 2 3\n").warnings,
            []
        );
        let rest =
            "g a\ng b\nusemtl c\nvt 0 0\nv 0 0 0 .1 .2\nv 1 0 0 1 x 1\nv 0 1 0\nf 1/1 2/1 3/1\n";
        let what = vec![
            Extra::TextureCoordinates,
            Extra::Materials,
            Extra::Groups,
            Extra::Data,
        ];
        assert_eq!(of(rest).warnings, [Oddity::LeftOut { what }]);
        assert!(
            of("o whole\nv 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")
                .warnings
                .is_empty()
        );
    }

    #[test]
    fn continued_lines_and_bytes_of_another_encoding() {
        let mut text = b"# caf\xE9\ng \xFF\xFE\n".to_vec();
        text.extend(SQUARE.replace('\n', "\r\n").bytes());
        text.extend(b"f 1 2 \\ \t\r\n 3\\\r\n 4");
        let read = read(&text).unwrap();
        assert_eq!(read.soup.face(0), [0, 1, 2, 3]);
        assert!(read.warnings.is_empty());
    }

    #[test]
    fn curves_and_points_are_skipped_with_a_warning() {
        let text = format!("{SQUARE}p 1\nl 1 2\nf 1 2 3\ncurv 0 1 1 2\n");
        assert_eq!(
            read(text.as_bytes()).unwrap().warnings,
            [Oddity::OtherLines {
                count: 3,
                first: Place::Line { line: 5 }
            }]
        );
    }

    #[test]
    fn errors_name_the_line() {
        let syntax = |text: &str| match read(text.as_bytes()) {
            Err(
                ReadError::Syntax { place, found, .. }
                | ReadError::DecimalComma { place, found, .. },
            ) => (place, found),
            other => panic!("{other:?}"),
        };
        let word = |word: &str| Found::Word { word: word.into() };
        assert_eq!(
            syntax("v 0 0\nf 1 1 1"),
            (Place::Line { line: 1 }, Found::EndOfLine)
        );
        assert_eq!(
            syntax("\nv 0 1,5 0"),
            (Place::Line { line: 2 }, word("1,5"))
        );
        assert_eq!(
            syntax("v 0 0 0\nf 1 1 1.5"),
            (Place::Line { line: 2 }, word("1.5"))
        );
        assert_eq!(
            syntax("v 0 0 0\nf 1 /1 1"),
            (Place::Line { line: 2 }, word("/1"))
        );
        for beyond in [0, 5] {
            let text = format!("{SQUARE}f 1 2 {beyond}\n");
            assert_eq!(
                read(text.as_bytes()),
                Err(ReadError::IndexOutOfRange {
                    format: Format::Obj,
                    place: Place::Line { line: 5 },
                    index: beyond,
                    vertices: 4
                })
            );
        }
        let text = format!("{SQUARE}f 1 2 99999999999999999999\n");
        assert!(matches!(
            read(text.as_bytes()),
            Err(ReadError::IndexOutOfRange {
                place: Place::Line { line: 5 },
                index: i64::MAX,
                ..
            })
        ));
    }
}
