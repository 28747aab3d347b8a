//! The same tetrahedron in OBJ, PLY, OFF and STL as other programs write it, each in a way of its
//! own.

use crate::mesh::{is_refused_wherever_it_ends, ordered};
use glam::DVec3;
use umbilic::io::{self, Format, Oddity, Place, ReadError};
use umbilic::mesh;

const CORNERS: [[f32; 3]; 4] = [[0., 0., 0.], [1., 0., 0.], [0., 1., 0.], [0., 0., 1.]];
const FACES: [[u32; 3]; 4] = [[0, 2, 1], [0, 1, 3], [1, 2, 3], [0, 3, 2]];

/// Files of a format; none of one that other tests write.
pub(crate) fn variants(format: Format) -> Vec<Vec<u8>> {
    match format {
        Format::Obj => obj(),
        Format::Ply => ply(),
        Format::Off => off(),
        Format::Stl => stl(),
        Format::StlAscii => vec![ascii_stl()],
        _ => Vec::new(),
    }
}

fn obj() -> Vec<Vec<u8>> {
    let texts = [
        // Relative numbers, continued lines, a weight that is one.
        "v 0 0 0 1\nv 1 0 0 1.0\nv 0 1 0 1\nv 0 0 1 1\nf -4 -2 -3\nf 1 \\ \n 2 4\nf 2 3 \\\n4\nf 1 4 3\n",
        // All slashes, groups, what is no surface, ends of lines of another system.
        "mtllib a b.mtl\r\no one\r\nv 0 0 0\r\nv 1 0 0\r\nv 0 1 0\r\nv 0 0 1\r\nvt 0 0\r\nvn 0 0 1\r\n\
         g a b\r\nusemtl red\r\ns 1\r\nf 1/1 3/1 2/1\r\nf 1/1/1 2/1/1 4/1/1\r\ng c\r\nf 2//1 3//1 4//1\r\n\
         f 1 4 3\r\nl 1 2 3\r\np 1\r\n",
        // Colours, numbers with exponents, a comment at the end of a line, no last line end.
        "\tv 0 0 0 .1 .2 .3\nv 1e0 0 0 0 1 0\nv 0 +1.0D+00 0 1 0 0\nv 0 0 1. 0 0 1\n\nf 1 3 2 # base\n\
         f 1 2 4\nf 2 3 4\nf 1 4 3",
        // Polygons: one with corners on its sides, one with a bridge to a hole in it.
        "v 0 0 0\nv 4 0 0\nv 4 4 0\nv 0 4 0\nv 2 0 0\nv 4 2 0\nv 1 1 0\nv 1 3 0\nv 3 3 0\nv 3 1 0\nv 2 2 5\n\
         f 1 5 2 6 3 4 1 7 8 9 10 7\nf 7 10 11\nf 10 9 11\nf 9 8 11\nf 8 7 11\n",
    ];
    texts.map(|text| text.as_bytes().to_vec()).into()
}

fn ply() -> Vec<Vec<u8>> {
    let head = |format: &str, elements: &str| {
        format!("ply\nformat {format} 1.0\ncomment by hand\nobj_info none\n{elements}end_header\n")
            .into_bytes()
    };
    let vertices = "element vertex 4\nproperty list uchar int tags\nproperty double x\n\
        property double y\nproperty double z\nproperty uchar quality\n";
    let faces = "element face 4\nproperty uchar flags\nproperty list ushort uint vertex_index\n\
        property list uchar float texcoord\n";
    let strips = "element vertex 4\nproperty float x\nproperty float y\nproperty float z\n\
        element tristrips 1\nproperty list int int vertex_indices\n";
    let mut all = Vec::new();
    for big in [false, true] {
        let name = if big {
            "binary_big_endian"
        } else {
            "binary_little_endian"
        };
        // Faces first, an element of no interest between.
        let edges = "element edge 1\nproperty int vertex1\nproperty int vertex2\n";
        let mut bytes = head(name, &format!("{faces}{edges}{vertices}"));
        for face in FACES {
            bytes.push(7);
            bytes.extend(ordered(3_u16.to_le_bytes(), big));
            face.iter()
                .for_each(|v| bytes.extend(ordered(v.to_le_bytes(), big)));
            bytes.push(2);
            bytes.extend([0; 8]);
        }
        bytes.extend([0; 8]);
        for corner in CORNERS {
            bytes.push(1);
            bytes.extend([9; 4]);
            let parts = corner.iter();
            parts.for_each(|x| bytes.extend(ordered(f64::from(*x).to_le_bytes(), big)));
            bytes.push(200);
        }
        all.push(bytes);
        let mut bytes = head(name, strips);
        for x in CORNERS.as_flattened() {
            bytes.extend(ordered(x.to_le_bytes(), big));
        }
        bytes.extend(ordered(9_i32.to_le_bytes(), big));
        for v in [0_i32, 2, 1, 3, 0, 2, -1, 1, 1] {
            bytes.extend(ordered(v.to_le_bytes(), big));
        }
        all.push(bytes);
    }
    let mut text = String::from_utf8(head("ascii", &format!("{vertices}{faces}"))).unwrap();
    for [x, y, z] in CORNERS {
        text += &format!("2 5 6 {x} {y} {z} 100\n");
    }
    for [a, b, c] in FACES {
        text += &format!("1 3 {a} {b} {c} 2 0.5 0.25\n");
    }
    all.push(text.replace('\n', "\r\n").into_bytes());
    all
}

fn off() -> Vec<Vec<u8>> {
    let body = |vertex: &str, face: &str| {
        let points = CORNERS.map(|[x, y, z]| format!("{x} {y} {z}{vertex}\n"));
        let faces = FACES.map(|[a, b, c]| format!("3 {a} {b} {c}{face}\n"));
        points.concat() + &faces.concat()
    };
    let heads = [
        ("OFF4 4 6\n", "", " 7"),
        ("OFF 4 4 0\n", "", " 255 0 0"),
        ("# a\nOFF\n# b\n\n4 4 6 # c\n", "", ""),
        ("COFF\n4 4 0\n", " .1 .5 .25 1", ""),
        ("NOFF\n4 4 0\n", " 0 0 1", " .1 .2 .3 1"),
        ("STCNOFF\n4 4 0\n", " 0 0 1 10 20 30 255 .5 .5", ""),
    ];
    let texts = heads.map(|(head, vertex, face)| format!("{head}{}", body(vertex, face)));
    let mut all: Vec<_> = texts.map(String::into_bytes).into();
    all.push(
        all[1]
            .iter()
            .map(|byte| if *byte == b'\n' { b'\r' } else { *byte })
            .collect(),
    );
    all.extend([
        binary_off("OFF BINARY", 0, 0),
        binary_off("NOFF BINARY", 3, 4),
        binary_off("STCNOFF BINARY # by hand", 9, 1),
    ]);
    all
}

/// So many numbers more at a vertex, and parts of a colour at a face.
fn binary_off(head: &str, more: usize, parts: u32) -> Vec<u8> {
    let mut bytes = format!("{head}\n").into_bytes();
    let mut push = |word: u32| bytes.extend(word.to_be_bytes());
    [4, 4, 6].into_iter().for_each(&mut push);
    for corner in CORNERS {
        let rest: Vec<f32> = (0..more).map(|k| 0.125 * k as f32).collect();
        corner.iter().chain(&rest).for_each(|x| push(x.to_bits()));
    }
    for face in FACES {
        push(3);
        face.into_iter().for_each(&mut push);
        push(parts);
        (0..parts).for_each(|_| push(0.25_f32.to_bits()));
    }
    bytes
}

fn stl() -> Vec<Vec<u8>> {
    [
        ("exported", 4_u32),
        ("solid binary", 4),
        ("a stream", 0),
        ("a stream", u32::MAX),
    ]
    .map(|(head, count)| {
        let mut bytes = head.as_bytes().to_vec();
        bytes.resize(80, 0);
        bytes.extend(count.to_le_bytes());
        for face in FACES {
            bytes.extend([0; 12]);
            let corners = face.iter().flat_map(|v| CORNERS[*v as usize]);
            corners.for_each(|x| bytes.extend(x.to_le_bytes()));
            bytes.extend([0, 0x80]);
        }
        bytes
    })
    .into()
}

fn ascii_stl() -> Vec<u8> {
    let mut text = String::from("\nsolid one part\n");
    for (n, face) in FACES.iter().enumerate() {
        if n == 2 {
            text += "endsolid one part\nSOLID two\n";
        }
        text += "\tfacet normal nan 0 1e0\n\t outer loop\n";
        for v in face {
            let [x, y, z] = CORNERS[*v as usize];
            text += &format!("\t\tVERTEX {x:e} {y} {z}\n");
        }
        text += "endloop\nendfacet\n";
    }
    text += "endsolid\n";
    text.into_bytes()
}

#[test]
fn all_ways_to_write_a_tetrahedron_read_as_one() {
    let formats = [
        Format::Obj,
        Format::Ply,
        Format::Off,
        Format::Stl,
        Format::StlAscii,
    ];
    for format in formats {
        for (n, bytes) in variants(format).iter().enumerate() {
            let of = format!("{format:?} {n}");
            let read =
                io::read(bytes, "").or_else(|_| io::read(bytes, &format!("a.{}", format.name())));
            let read = read.unwrap_or_else(|error| panic!("{of}: {error}"));
            let built = mesh::build(&read.soup).unwrap_or_else(|error| panic!("{of}: {error}"));
            if (format, n) == (Format::Obj, 3) {
                // The base with its hole, and a tip over the hole: an open surface of one loop.
                assert_eq!(built.mesh.boundary_loops().count(), 1, "{of}");
                let area = umbilic::geometry::measure::area(&built.mesh, &built.positions);
                assert!(
                    (area - (12.0 + 4.0 * 26_f64.sqrt())).abs() < 1e-12,
                    "{of}: {area}"
                );
                continue;
            }
            assert!(built.mesh.is_closed(), "{of}");
            assert_eq!(
                (built.positions.len(), built.mesh.n_faces()),
                (4, 4),
                "{of}"
            );
            let volume = umbilic::geometry::measure::volume(&built.mesh, &built.positions);
            assert_eq!(volume.map(|v| (6.0 * v).round()), Some(1.0), "{of}");
            assert!(
                built
                    .positions
                    .contains(&DVec3::ONE.with_y(0.0).with_x(0.0)),
                "{of}"
            );
        }
    }
}

#[test]
fn binary_off_is_refused_wherever_it_ends_and_holds_its_colours() {
    let bytes = binary_off("CNOFF BINARY", 7, 3);
    is_refused_wherever_it_ends(&bytes, 0, bytes.len() - 1);
    let read = io::read(&bytes, "").expect("a mesh");
    assert_eq!(read.soup.colours, [[0.375, 0.5, 0.625, 0.75]; 4]);
    // A count that the file cannot hold, and a corner that it has not.
    for (at, word) in [(13, u32::MAX), (13 + 12 + 4 * 40 + 8, 4)] {
        let mut broken = bytes.clone();
        broken[at..at + 4].copy_from_slice(&word.to_be_bytes());
        let error = io::read(&broken, "").expect_err("no such number");
        let is_named = matches!(
            error,
            ReadError::CountTooLarge { .. } | ReadError::IndexOutOfRange { .. }
        );
        assert!(is_named, "{error}");
    }
}

#[test]
fn a_vertex_without_a_position_counts_only_where_a_face_uses_it() {
    let obj = "v nan nan nan\nv 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 inf\nf 2 3 4\n";
    let off = "OFF\n5 1 0\nnan nan nan\n0 0 0\n1 0 0\n0 1 0\n0 0 inf\n3 1 2 3\n";
    let ply = "ply\nformat ascii 1.0\nelement vertex 5\nproperty float x\nproperty float y\n\
        property float z\nelement face 1\nproperty list uchar int vertex_index\nend_header\n\
        nan nan nan\n0 0 0\n1 0 0\n0 1 0\n0 0 inf\n3 1 2 3\n";
    let files = [
        (obj, 1, "f 2 3 4", "f 2 3 1"),
        (off, 3, "3 1 2 3", "3 1 2 4"),
        (ply, 10, "3 1 2 3", "3 1 4 3"),
    ];
    for (text, line, face, bad) in files {
        let read = io::read(text.as_bytes(), "").expect("a mesh");
        let (count, first) = (2, Place::Line { line });
        assert_eq!(read.warnings, [Oddity::UnplacedVertices { count, first }]);
        assert_eq!(read.soup.positions.len(), 5);
        let built = mesh::build(&read.soup).expect("a triangle");
        assert_eq!(built.mesh.n_vertices(), 3);
        let error = io::read(text.replace(face, bad).as_bytes(), "").expect_err("it is used");
        assert!(
            matches!(error, ReadError::NonFiniteVertex { .. }),
            "{error}"
        );
    }
}

#[test]
fn what_came_in_the_place_of_a_file_is_called_that() {
    let pointer = "version https://git-lfs.github.com/spec/v1\noid sha256:0f\nsize 123\n";
    let pages = [
        "<!DOCTYPE html><html></html>",
        "\n<HTML lang=\"en\">",
        "<!doctype HTML>\n",
    ];
    let pages = pages.map(|text| (text, "html"));
    for (text, what) in pages.into_iter().chain([(pointer, "git-lfs")]) {
        for name in ["a.obj", "a.stl", "a.ply", "a.3mf", ""] {
            let error = io::read(text.as_bytes(), name).expect_err("no mesh");
            assert_eq!(error, ReadError::Substituted { what }, "{name}");
        }
    }
}

#[test]
fn text_may_be_filled_up_with_nul_bytes() {
    for format in [Format::Obj, Format::Off, Format::StlAscii] {
        for text in variants(format)
            .into_iter()
            .filter(|bytes| !bytes.contains(&0))
        {
            let mut padded = text.clone();
            padded.resize(text.len().next_multiple_of(512), 0);
            let name = format!(
                "a.{}",
                if format == Format::Off {
                    "off"
                } else {
                    format.name()
                }
            );
            let [plain, filled] = [&text, &padded].map(|bytes| io::read(bytes, &name));
            assert_eq!(filled, plain, "{format:?}");
            // Within, they are none of a text.
            padded.extend(b"\n#");
            assert!(io::read(&padded, &name).is_err());
        }
    }
}
