//! Readers on arbitrary bytes: whatever comes in, an answer comes out, and what is
//! accepted is sound.

use glam::DVec3;
use proptest::prelude::*;
use umbilic::io::{self, Format};
use umbilic::soup::PolygonSoup;

const NAMES: [&str; 5] = ["a.obj", "a.off", "a.ply", "a.stl", ""];

/// Reads under every name; an accepted soup must be writable and survive the round trip.
fn check(bytes: &[u8]) -> Result<(), TestCaseError> {
    for name in NAMES {
        match io::read(bytes, name) {
            Ok(read) => {
                prop_assert!(read.soup.positions.iter().all(|p| p.is_finite()));
                prop_assert!(read.soup.faces().all(|face| face.len() >= 3));
                let written = io::write(&read.soup, Format::Ply, name);
                let again = written.map(|bytes| io::read(&bytes, "").map(|read| read.soup));
                prop_assert_eq!(again, Ok(Ok(read.soup)));
            }
            Err(error) => {
                // A message stays a message, however long the word it quotes.
                prop_assert!(error.to_string().len() < 400);
            }
        }
    }
    Ok(())
}

/// Soups of a few polygons at arbitrary finite positions.
fn soups() -> impl Strategy<Value = PolygonSoup> {
    let coordinate = || {
        prop_oneof![
            -1.0..1.0,
            any::<f64>().prop_filter("finite", |x| x.is_finite())
        ]
    };
    let position = [coordinate(), coordinate(), coordinate()].prop_map(DVec3::from_array);
    prop::collection::vec(position, 1..12).prop_flat_map(|positions| {
        let corner = 0..positions.len() as u32;
        let face = prop::collection::vec(corner, 3..7);
        prop::collection::vec(face, 1..8)
            .prop_map(move |faces| PolygonSoup::from_faces(positions.clone(), &faces))
    })
}

/// Formats whose text and bytes hold a soup as it is.
fn exact_formats() -> impl Strategy<Value = Format> {
    prop::sample::select(vec![
        Format::Obj,
        Format::Off,
        Format::Ply,
        Format::PlyAscii,
        Format::PlyBigEndian,
    ])
}

/// Pieces that steer random text deep into the readers.
fn fragments() -> impl Strategy<Value = String> {
    let word = prop::sample::select(vec![
        "v 0 0 0",
        "v 1e400 0 0",
        "v -nan(ind) 1 2",
        "f 1 2 3",
        "f -1 -2 -3",
        "f 1/2/3 4//5 6/",
        "f 99999999999999999999 0 -99999999999999999999",
        "OFF",
        "OFF BINARY",
        "3 1 0",
        "4294967296 18446744073709551615 0",
        "0 0 0",
        "1 0 0",
        "3 0 1 2",
        "-1 0",
        "4294967295 1",
        "ply",
        "format ascii 1.0",
        "format binary_little_endian 1.0",
        "format binary_big_endian 1.0",
        "element vertex 3",
        "element vertex 9223372036854775807",
        "element face 1",
        "element face 4294967295",
        "element other 18446744073709551615",
        "property float x",
        "property double y",
        "property char z",
        "property list uint int vertex_indices",
        "property list char uchar vertex_index",
        "property list int double other",
        "end_header",
        "\u{3}\0\0\0\0\u{1}\u{2}",
        "\u{7f}\u{7f}\u{7f}\u{7f}",
        "solid",
        "facet normal 0 0 1",
        "outer loop",
        "vertex 0 0 0",
        "vertex 1 nan 0",
        "endloop",
        "endfacet",
        "endsolid",
        "#",
        "\\",
        "\u{feff}",
    ]);
    let end = prop::sample::select(vec!["\n", "\r\n", "\r", " ", "\\\n", ""]);
    prop::collection::vec((word, end), 0..40).prop_map(|pieces| {
        pieces
            .into_iter()
            .flat_map(|(word, end)| [word, end])
            .collect()
    })
}

proptest! {
    #[test]
    fn random_bytes_get_an_answer(bytes in prop::collection::vec(any::<u8>(), 0..600)) {
        check(&bytes)?;
    }

    #[test]
    fn random_text_gets_an_answer(text in fragments()) {
        check(text.as_bytes())?;
    }

    #[test]
    fn a_ply_header_with_a_random_body_gets_an_answer(
        big in any::<bool>(),
        types in [0_usize..8, 0..8, 0..6],
        faces in 0_u32..9,
        body in prop::collection::vec(any::<u8>(), 0..300),
    ) {
        const TYPES: [&str; 8] =
            ["char", "uchar", "short", "ushort", "int", "uint", "float", "double"];
        let order = if big { "big" } else { "little" };
        let [coordinate, other, length] = types.map(|t| TYPES[t]);
        let header = format!(
            "ply\nformat binary_{order}_endian 1.0\nelement vertex 3\nproperty {coordinate} x\n\
             property {coordinate} y\nproperty {coordinate} z\nelement face {faces}\n\
             property {other} w\nproperty list {length} uchar vertex_indices\nend_header\n"
        );
        check(&[header.as_bytes(), &body].concat())?;
    }

    #[test]
    fn damaged_files_get_an_answer(
        soup in soups(),
        format in prop::sample::select(Format::written().collect::<Vec<_>>()),
        damage in prop::collection::vec((any::<prop::sample::Index>(), any::<u8>()), 0..8),
        cut in any::<prop::sample::Index>(),
        is_cut in any::<bool>(),
    ) {
        // Formats of single precision refuse large positions.
        if let Ok(mut bytes) = io::write(&soup, format, "") {
            for (at, byte) in damage {
                let at = at.index(bytes.len());
                bytes[at] = byte;
            }
            if is_cut {
                bytes.truncate(cut.index(bytes.len()));
            }
            check(&bytes)?;
        }
    }

    #[test]
    fn round_trips_keep_every_bit(soup in soups(), format in exact_formats(), comment in ".*") {
        let bytes = io::write(&soup, format, &comment).unwrap();
        let read = io::read(&bytes, "").unwrap();
        prop_assert_eq!(read.format, format);
        prop_assert_eq!(&read.soup.corners, &soup.corners);
        prop_assert_eq!(&read.soup.face_starts, &soup.face_starts);
        let bits = |soup: &PolygonSoup| -> Vec<_> {
            soup.positions.iter().flat_map(|p| p.to_array()).map(f64::to_bits).collect()
        };
        prop_assert_eq!(bits(&read.soup), bits(&soup));
    }
}
