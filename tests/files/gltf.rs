//! glTF, in JSON and in one binary file.

use crate::mesh::{base64, is_refused_wherever_it_ends, octahedron, plain, refusal};
use glam::DVec3;
use umbilic::io::{Extra, Found, Oddity, ReadError};
use umbilic::soup::PolygonSoup;

/// How a file is written.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Style {
    pub(crate) binary: bool,
    /// The type of indices: 5121, 5123, 5125, or 0 for none.
    pub(crate) index: u32,
    /// 4 triangles, 5 strips, 6 fans.
    pub(crate) mode: u32,
    /// Positions between other numbers.
    pub(crate) interleaved: bool,
    /// Positions as normalised 16-bit numbers.
    pub(crate) quantised: bool,
}

pub(crate) const PLAIN: Style = Style {
    binary: true,
    index: 5125,
    mode: 4,
    interleaved: false,
    quantised: false,
};

/// JSON and its bytes as a file.
pub(crate) fn assembled(json: &str, binary: &[u8], is_binary: bool) -> Vec<u8> {
    let length = binary.len();
    if !is_binary {
        let uri = format!("data:application/octet-stream;base64,{}", base64(binary));
        let buffers = format!("\"buffers\":[{{\"byteLength\":{length},\"uri\":\"{uri}\"}}]");
        return json.replace("BUFFERS", &buffers).into_bytes();
    }
    let mut json = json
        .replace(
            "BUFFERS",
            &format!("\"buffers\":[{{\"byteLength\":{length}}}]"),
        )
        .into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let mut out = b"glTF".to_vec();
    let total = 28 + json.len() + length;
    for n in [2, total, json.len()] {
        out.extend((n as u32).to_le_bytes());
    }
    out.extend(b"JSON");
    out.extend(json);
    out.extend((length as u32).to_le_bytes());
    out.extend(b"BIN\0");
    out.extend(binary);
    out
}

/// Primitives as lists of corners: triangles, one strip, or fans.
fn lists(soup: &PolygonSoup, mode: u32) -> Vec<Vec<u32>> {
    match mode {
        4 => vec![soup.corners.clone()],
        5 => soup.faces().map(<[u32]>::to_vec).collect(),
        _ => vec![vec![0, 1, 2, 3, 4, 1], vec![5, 4, 3, 2, 1, 4]],
    }
}

pub(crate) fn file(soup: &PolygonSoup, style: Style, nodes: &str, attributes: &str) -> Vec<u8> {
    let mut binary = Vec::new();
    let stride = match (style.quantised, style.interleaved) {
        (true, false) => 8,
        (false, false) => 12,
        _ => 20,
    };
    for p in &soup.positions {
        let start = binary.len();
        for x in p.to_array() {
            if style.quantised {
                binary.extend(((x * 32767.0).round() as i16).to_le_bytes());
            } else {
                binary.extend((x as f32).to_le_bytes());
            }
        }
        binary.resize(start + stride, 0xAB);
    }
    let vertices = binary.len();
    let (kind, normalised) = if style.quantised {
        (5122, true)
    } else {
        (5126, false)
    };
    let mut accessors = format!(
        "{{\"bufferView\":0,\"componentType\":{kind},\"normalized\":{normalised},\
         \"count\":{},\"type\":\"VEC3\"}}",
        soup.positions.len()
    );
    let mut primitives = Vec::new();
    for list in lists(soup, style.mode) {
        let size = [1, 1, 2, 2, 4, 4][(style.index.max(5121) - 5121) as usize];
        let start = binary.len() - vertices;
        for corner in &list {
            binary.extend(&corner.to_le_bytes()[..size]);
        }
        binary.resize(binary.len().next_multiple_of(4), 0);
        let number = primitives.len() + 1;
        accessors += &format!(
            ",{{\"bufferView\":1,\"byteOffset\":{start},\"componentType\":{},\"count\":{},\
             \"type\":\"SCALAR\"}}",
            style.index,
            list.len()
        );
        primitives.push(format!(
            "{{\"attributes\":{{\"POSITION\":0{attributes}}},\"indices\":{number},\"mode\":{}}}",
            style.mode
        ));
    }
    let all = primitives.join(",");
    let all = if style.index == 0 {
        format!("{{\"attributes\":{{\"POSITION\":0{attributes}}}}}")
    } else {
        all
    };
    let json = format!(
        "{{\"asset\":{{\"version\":\"2.0\"}},{nodes}\"meshes\":[{{\"primitives\":[{all}]}}],\
         \"accessors\":[{accessors}],\"bufferViews\":[{{\"buffer\":0,\"byteLength\":{vertices},\
         \"byteStride\":{stride}}},{{\"buffer\":0,\"byteOffset\":{vertices},\"byteLength\":{}}}],\
         BUFFERS}}",
        binary.len() - vertices
    );
    assembled(&json, &binary, style.binary)
}

pub(crate) fn variants() -> Vec<Style> {
    let mut all = Vec::new();
    for binary in [false, true] {
        for index in [5121, 5123, 5125] {
            for mode in [4, 5, 6] {
                for (interleaved, quantised) in
                    [(false, false), (true, false), (false, true), (true, true)]
                {
                    all.push(Style {
                        binary,
                        index,
                        mode,
                        interleaved,
                        quantised,
                    });
                }
            }
        }
    }
    all
}

/// Triangles by their corners' positions, in an order of their own.
fn triangles(soup: &PolygonSoup) -> Vec<[[u64; 3]; 3]> {
    let mut all: Vec<_> = soup
        .faces()
        .map(|face| {
            let mut corners = [0, 1, 2].map(|k| {
                let p = soup.positions[face[k] as usize] + DVec3::ZERO;
                p.to_array().map(f64::to_bits)
            });
            let first = (0..3).min_by_key(|k| corners[*k]).unwrap_or(0);
            corners.rotate_left(first);
            corners
        })
        .collect();
    all.sort_unstable();
    all
}

#[test]
fn every_variant_reads_as_the_mesh_it_was_written_of() {
    let soup = octahedron();
    for style in variants() {
        let name = if style.binary { "a.glb" } else { "a.gltf" };
        let bytes = file(&soup, style, "", "");
        let read = umbilic::io::read(&bytes, name);
        let read = read.unwrap_or_else(|error| panic!("{style:?}: {error}"));
        assert_eq!(triangles(&read.soup), triangles(&soup), "{style:?}");
        assert_eq!(read.soup.positions.len(), 6, "{style:?}");
        if style.mode == 4 {
            assert_eq!(read.soup, soup, "{style:?}");
        }
    }
}

#[test]
fn nodes_put_meshes_in_place_and_mirrors_keep_the_outside_outside() {
    let soup = octahedron();
    // A turn about z by a right angle, twice as large; a mirror within it; a matrix.
    let half = std::f64::consts::FRAC_1_SQRT_2;
    let nodes = format!(
        "\"scene\":1,\"scenes\":[{{\"nodes\":[3]}},{{\"nodes\":[0,2]}}],\"nodes\":[\
         {{\"rotation\":[0,0,{half},{half}],\"scale\":[2,2,2],\"translation\":[10,0,0],\
         \"children\":[1]}},{{\"mesh\":0,\"scale\":[-1,1,1]}},\
         {{\"mesh\":0,\"matrix\":[1,0,0,0,0,1,0,0,0,0,1,0,5,6,7,1]}},{{\"mesh\":0}}],"
    );
    let read = plain(&file(&soup, PLAIN, &nodes, ""), "");
    assert_eq!((read.positions.len(), read.n_faces()), (12, 16));
    for (p, q) in soup.positions.iter().zip(&read.positions) {
        let expected = DVec3::new(10.0 - 2.0 * p.y, -2.0 * p.x, 2.0 * p.z);
        assert!((*q - expected).length() < 1e-12, "{p} {q} {expected}");
    }
    let moved = DVec3::new(5.0, 6.0, 7.0);
    for (p, q) in soup.positions.iter().zip(&read.positions[6..]) {
        assert_eq!(*q, *p + moved);
    }
    let volume = |faces: std::ops::Range<usize>| -> f64 {
        let corners = faces.map(|f| [0, 1, 2].map(|k| read.positions[read.face(f)[k] as usize]));
        corners.map(|[a, b, c]| a.dot(b.cross(c)) / 6.0).sum()
    };
    assert!((volume(0..8) - 8.0 * 4.0 / 3.0).abs() < 1e-9);
    assert!((volume(8..16) - 4.0 / 3.0).abs() < 1e-9);
}

#[test]
fn vertices_split_along_seams_are_joined_and_others_are_not() {
    let soup = octahedron();
    let mut split = PolygonSoup::default();
    for face in soup.faces() {
        let first = split.positions.len() as u32;
        split
            .positions
            .extend(face.iter().map(|v| soup.positions[*v as usize]));
        split.push_face(&[first, first + 1, first + 2]);
    }
    let read = umbilic::io::read(&file(&split, PLAIN, "", ",\"NORMAL\":0"), "").unwrap();
    assert_eq!(triangles(&read.soup), triangles(&soup));
    assert_eq!(read.soup.positions.len(), 6);
    assert_eq!(read.warnings, [Oddity::SeamsJoined { count: 18 }]);
    assert_eq!(plain(&file(&split, PLAIN, "", ""), ""), split);
    let coloured = plain(&file(&split, PLAIN, "", ",\"COLOR_0\":0"), "");
    assert_eq!(coloured.positions, split.positions);
    // Indices are no colours.
    let other = umbilic::io::read(&file(&split, PLAIN, "", ",\"COLOR_0\":1"), "").unwrap();
    assert_eq!(other.soup, split);
    let what = vec![Extra::Colours];
    assert_eq!(other.warnings, [Oddity::LeftOut { what }]);
}

#[test]
fn triangles_without_indices_are_joined() {
    let soup = octahedron();
    let mut loose = PolygonSoup::default();
    for v in &soup.corners {
        loose.positions.push(soup.positions[*v as usize]);
    }
    let style = Style { index: 0, ..PLAIN };
    let read = umbilic::io::read(&file(&loose, style, "", ""), "").unwrap();
    assert_eq!(triangles(&read.soup), triangles(&soup));
    assert_eq!(read.soup.positions.len(), 6);
}

/// An octahedron of which two vertices stand in a sparse list.
pub(crate) fn sparse(indices: [u8; 2]) -> Vec<u8> {
    let soup = octahedron();
    let mut binary = Vec::new();
    for (v, p) in soup.positions.iter().enumerate() {
        let p = if v == 1 || v == 4 { DVec3::ZERO } else { *p };
        binary.extend(p.to_array().iter().flat_map(|x| (*x as f32).to_le_bytes()));
    }
    binary.extend(soup.corners.iter().map(|v| *v as u8));
    binary.extend(indices);
    for v in [1, 4] {
        let p = soup.positions[v].to_array();
        binary.extend(p.iter().flat_map(|x| (*x as f32).to_le_bytes()));
    }
    let json = "{\"asset\":{},\"meshes\":[{\"primitives\":[{\"attributes\":{\"POSITION\":0},\
        \"indices\":1}]}],\"accessors\":[{\"bufferView\":0,\"componentType\":5126,\"count\":6,\
        \"type\":\"VEC3\",\"sparse\":{\"count\":2,\"indices\":{\"bufferView\":0,\"byteOffset\":96,\
        \"componentType\":5121},\"values\":{\"bufferView\":0,\"byteOffset\":98}}},\
        {\"bufferView\":0,\"byteOffset\":72,\"componentType\":5121,\"count\":24,\
        \"type\":\"SCALAR\"}],\"bufferViews\":[{\"buffer\":0,\"byteLength\":122}],BUFFERS}";
    assembled(json, &binary, true)
}

#[test]
fn a_sparse_list_replaces_some_rows() {
    assert_eq!(
        triangles(&plain(&sparse([1, 4]), "")),
        triangles(&octahedron())
    );
    // Without other rows they stand among zeros.
    let mut alone = sparse([1, 4]);
    let view = b"\"bufferView\":0,\"componentType\":5126";
    let at = alone.windows(view.len()).position(|w| w == view);
    let at = at.expect("the first accessor");
    alone[at..at + 15].fill(b' ');
    let mut positions = plain(&alone, "").positions;
    positions.retain(|p| *p != DVec3::ZERO);
    assert_eq!(positions, [1, 4].map(|v| octahedron().positions[v]));
    let detail = refusal(&sparse([1, 6])).detail();
    assert_eq!(detail.first().map(|(name, _)| *name), Some("byte"));
}

#[test]
fn what_is_not_read_is_named() {
    let soup = octahedron();
    let style = Style {
        binary: false,
        ..PLAIN
    };
    let text = String::from_utf8(file(&soup, style, "", "")).unwrap();
    let refused = |from: &str, to: &str| {
        assert!(text.contains(from), "{from}");
        refusal(text.replacen(from, to, 1).as_bytes())
    };
    let what = |what| ReadError::Unsupported { what };
    let data = &text[text.find("data:").unwrap()..text.rfind('"').unwrap()];
    assert_eq!(refused(data, "mesh.bin"), what("gltf-external"));
    let required =
        "\"extensionsRequired\":[\"KHR_materials_unlit\",\"EXT_mesh_gpu_instancing\"],\"asset\"";
    assert_eq!(
        refused("\"asset\"", required),
        ReadError::RequiredExtension {
            name: "EXT_mesh_gpu_instancing".into()
        }
    );
    let meshopt = "\"extensions\":{\"EXT_meshopt_compression\":{}},\"buffer\":0";
    assert_eq!(refused("\"buffer\":0", meshopt), what("gltf-meshopt"));
    let draco = text.replacen("\"bufferView\":0,", "", 1).replace(
        "\"mode\":4",
        "\"mode\":4,\"extensions\":{\"KHR_draco_mesh_compression\":{}}",
    );
    assert_eq!(refusal(draco.as_bytes()), what("gltf-draco"));
    for (from, to) in [
        ("\"count\":6", "\"count\":7"),
        ("\"count\":24", "\"count\":99"),
        ("\"type\"", "\"sparse\":{},\"type\""),
        ("\"POSITION\":0", "\"POSITION\":9"),
        ("\"POSITION\":0", "\"POSITION\":1"),
        ("\"VEC3\"", "\"VEC4\""),
        ("5126", "5127"),
        ("\"byteStride\":12", "\"byteStride\":4"),
        ("base64,", "base64,*"),
        ("\"asset\"", "\"other\""),
        (
            "\"meshes\"",
            "\"nodes\":[{\"children\":[0]}],\"scenes\":[{\"nodes\":[0]}],\"meshes\"",
        ),
        ("\"meshes\"", "\"nodes\":[{\"mesh\":3}],\"meshes\""),
        (
            "\"meshes\"",
            "\"nodes\":[{\"mesh\":0,\"scale\":[1,2]}],\"meshes\"",
        ),
    ] {
        let error = refused(from, to);
        if let ReadError::Syntax { found, .. } = &error {
            assert_ne!(*found, Found::EndOfFile, "{to}");
        }
        let detail = error.detail();
        assert_eq!(detail.first().map(|(name, _)| *name), Some("byte"), "{to}");
    }
    for binary in [false, true] {
        let bytes = file(&soup, Style { binary, ..PLAIN }, "", "");
        is_refused_wherever_it_ends(&bytes, 1, bytes.len());
    }
    let points = text.replace("\"mode\":4", "\"mode\":0");
    assert_eq!(
        refusal(points.as_bytes()),
        ReadError::NoFaces { vertices: 0 }
    );
}

#[test]
fn a_small_file_cannot_ask_for_much_memory() {
    let nodes: Vec<String> = (0..400_000).map(|_| "{\"mesh\":0}".into()).collect();
    let nodes = format!("\"nodes\":[{}],", nodes.join(","));
    let error = refusal(&file(&octahedron(), PLAIN, &nodes, ""));
    assert!(
        matches!(error, ReadError::CountTooLarge { what: "bytes", .. }),
        "{error}"
    );
}
