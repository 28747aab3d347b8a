//! Colours of vertices: read wherever a format has them, and written wherever one can hold them.

use crate::gltf::assembled;
use crate::mesh::{cube, plain};
use umbilic::io::{self, Extra, Format, Loss, Oddity};
use umbilic::soup::{Colour, PolygonSoup};

/// A mesh with colours: bytes, or fractions of no byte; opaque or not.
pub(crate) fn coloured(bytes: bool, opaque: bool) -> PolygonSoup {
    let mut soup = cube(0.0, 1.0);
    let part = |n: usize| match bytes {
        true => (f64::from((n * 37 % 256) as u8) / 255.0) as f32,
        false => (n % 7) as f32 / 7.0,
    };
    let colour = |v: usize| {
        let alpha = if opaque { 1.0 } else { part(v + 3) };
        [part(v), part(3 * v + 1), part(5 * v + 2), alpha]
    };
    soup.colours = (0..8).map(colour).collect();
    soup
}

/// A triangle in glTF with colours of a type, normalised, as wide as they are.
pub(crate) fn triangle_in_light(kind: u32, rows: [&[f64]; 3]) -> Vec<u8> {
    let mut binary = Vec::new();
    for x in [0.0_f32, 0., 0., 1., 0., 0., 0., 1., 0.] {
        binary.extend(x.to_le_bytes());
    }
    let width = rows[0].len();
    let mut stride = 0;
    for row in rows {
        let start = binary.len();
        for part in row {
            match kind {
                5121 => binary.push((part * 255.0).round() as u8),
                5123 => binary.extend(((part * 65535.0).round() as u16).to_le_bytes()),
                _ => binary.extend((*part as f32).to_le_bytes()),
            }
        }
        binary.resize(binary.len().next_multiple_of(4), 0);
        stride = binary.len() - start;
    }
    let length = binary.len();
    let normalised = kind != 5126;
    let json = format!(
        r#"{{"asset":{{"version":"2.0"}},"meshes":[{{"primitives":[{{"attributes":{{"POSITION":0,"COLOR_0":1}}}}]}}],"accessors":[{{"bufferView":0,"componentType":5126,"count":3,"type":"VEC3"}},{{"bufferView":1,"componentType":{kind},"normalized":{normalised},"count":3,"type":"VEC{width}"}}],"bufferViews":[{{"buffer":0,"byteLength":36}},{{"buffer":0,"byteOffset":36,"byteLength":{},"byteStride":{stride}}}],BUFFERS}}"#,
        length - 36
    );
    assembled(&json, &binary, true)
}

fn check(bytes: &[u8], name: &str, expected: &[Colour], tolerance: f32) {
    let colours = plain(bytes, name).colours;
    assert_eq!(colours.len(), expected.len(), "{name}");
    for (a, b) in colours.iter().flatten().zip(expected.iter().flatten()) {
        assert!((a - b).abs() <= tolerance, "{name}: {colours:?}");
    }
}

#[test]
fn colours_are_read_in_every_notation() {
    const WHITE: Colour = [1.0; 4];
    let text = "v 0 0 0 0.5 .25 1\nv 1 0 0 0 0 0\nv 0 1 0\nf 1 2 3\n";
    let half = [[0.5, 0.25, 1.0, 1.0], [0.0, 0.0, 0.0, 1.0], WHITE];
    check(text.as_bytes(), "a.obj", &half, 0.0);
    let text = "v 0 0 0 255 51 0 0.2\nv 1 0 0 0 255 0 255\nv 0 1 0 1 1 1 255\nf 1 2 3\n";
    let dark = 1.0 / 255.0;
    let of_255 = [
        [1.0, 0.2, 0.0, 0.2 / 255.0],
        [0.0, 1.0, 0.0, 1.0],
        [dark, dark, dark, 1.0],
    ];
    check(text.as_bytes(), "a.obj", &of_255, 1e-7);

    let body = |colour: [&str; 3], before: &str, after: &str| {
        let [a, b, c] = colour;
        format!(
            "3 1 0\n0 0 0{before} {a}{after}\n1 0 0{before} {b}{after}\n0 1 0{before} {c}{after}\n3 0 1 2\n"
        )
    };
    let fractions = ["0.5 0.25 1 1", "0 0 0 1", "1 1 1 1"];
    let bytes = ["255 51 0", "0 255 0", "1 1 1"];
    let whole = of_255.map(|[r, g, b, _]| [r, g, b, 1.0]);
    for (header, before) in [("COFF\n", ""), ("NCOFF\n", " 0 0 9"), ("NCOFF ", " 0 0 9")] {
        let text = format!("{header}{}", body(fractions, before, ""));
        check(text.as_bytes(), "a.off", &half, 0.0);
        let text = format!("{header}{}", body(bytes, before, ""));
        check(text.as_bytes(), "a.off", &whole, 1e-7);
    }
    let text = format!("STCOFF\n{}", body(bytes, "", " 300 0.5"));
    let read = io::read(text.as_bytes(), "a.off").unwrap();
    let what = vec![Extra::TextureCoordinates];
    assert_eq!(read.warnings, [Oddity::LeftOut { what }]);
    assert!((read.soup.colours[0][1] - 0.2).abs() < 1e-7);

    let ply = |scalar: &str, rows: [&str; 3]| {
        let [a, b, c] = rows;
        format!(
            "ply\nformat ascii 1.0\nelement vertex 3\nproperty float x\nproperty float y\n\
             property {scalar} red\nproperty {scalar} green\nproperty {scalar} blue\n\
             property float z\nelement face 1\nproperty list uchar int vertex_indices\nend_header\n\
             0 0 {a} 0\n1 0 {b} 0\n0 1 {c} 0\n3 0 1 2\n"
        )
    };
    for (scalar, rows) in [
        ("uchar", bytes),
        ("ushort", ["65535 13107 0", "0 65535 0", "257 257 257"]),
        ("float", bytes),
    ] {
        check(ply(scalar, rows).as_bytes(), "a.ply", &whole, 1e-7);
    }
    let rows = [".5 .25 1", "0 0 0", "1 1 1"];
    check(ply("double", rows).as_bytes(), "a.ply", &half, 0.0);
}

#[test]
fn colours_of_gltf_are_light() {
    // What a screen shows as a half is about a fifth of the light.
    let light = ((0.5_f64 + 0.055) / 1.055).powf(2.4);
    let shown = |alpha| [[0.5, 1.0, 0.0, alpha], [0.0, 0.0, 0.0, 1.0], [1.0; 4]];
    for (kind, tolerance) in [(5121, 4e-3), (5123, 1e-4), (5126, 1e-6)] {
        let rows: [&[f64]; 3] = [&[light, 1.0, 0.0], &[0.0; 3], &[1.0; 3]];
        let bytes = triangle_in_light(kind, rows);
        check(&bytes, "a.glb", &shown(1.0), tolerance);
        let rows: [&[f64]; 3] = [&[light, 1.0, 0.0, 0.5], &[0.0, 0.0, 0.0, 1.0], &[1.0; 4]];
        let bytes = triangle_in_light(kind, rows);
        check(&bytes, "a.glb", &shown(0.5), tolerance);
    }
}

#[test]
fn colours_that_are_written_read_back() {
    for (bytes, opaque) in [(true, true), (true, false), (false, true), (false, false)] {
        let soup = coloured(bytes, opaque);
        for format in Format::written() {
            let what = format!("{format:?}, bytes {bytes}, opaque {opaque}");
            let file = io::write(&soup, format, "").unwrap();
            let read = io::read(&file, "").unwrap();
            assert_eq!(read.warnings, [], "{what}");
            let losses = io::losses(&soup, format);
            let cut = Loss::Polygons { format, count: 6 };
            match format {
                Format::Stl | Format::StlAscii => {
                    assert_eq!(losses, [Loss::Colours { format }, cut], "{what}");
                    assert_eq!(read.soup.colours, [[0.0; 4]; 0], "{what}");
                    continue;
                }
                Format::Glb => {
                    assert_eq!(losses, [cut], "{what}");
                    check(&file, "a.glb", &soup.colours, 1e-6);
                }
                _ => {
                    assert_eq!(losses, [], "{what}");
                    assert_eq!(read.soup, soup, "{what}");
                }
            }
        }
        let text = io::write(&soup, Format::PlyAscii, "").unwrap();
        let text = String::from_utf8(text).unwrap();
        assert_eq!(text.contains("property uchar red"), bytes);
        assert_eq!(text.contains("alpha"), !opaque);
    }
}
