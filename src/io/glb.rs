//! glTF 2.0 in one binary file: what slides, phones and other viewers show.

use glam::DVec3;

use super::error::check_writable;
use super::{Format, WriteError, colour, single};
use crate::soup::PolygonSoup;

/// Writes one mesh of triangles, with the normals given at the vertices or none (then
/// viewers shade it flat, as the format asks them to).
///
/// Positions and normals are rounded to single precision, far from the origin after the node has
/// taken on the translation; normals are made unit vectors,
/// and a zero one points along z. Colours are turned into light, as the format asks. `comment` becomes the asset's generator.
///
/// # Errors
/// As for [`super::write`]; also for normals that are not finite or not one a vertex, and
/// for a file of 4 GiB or more.
pub fn write(
    soup: &PolygonSoup,
    normals: Option<&[DVec3]>,
    comment: &str,
) -> Result<Vec<u8>, WriteError> {
    check_writable(soup)?;
    let centre = single::centre(&soup.positions);
    let positions: Vec<DVec3> = soup.positions.iter().map(|p| *p - centre).collect();
    single::check_positions(positions.iter().copied())?;
    let vertices = soup.positions.len();
    if let Some(normals) = normals {
        if normals.len() != vertices {
            return Err(WriteError::NormalCount {
                normals: normals.len(),
                vertices,
            });
        }
        single::check(normals.iter().copied())?;
    }

    // Everything is made of 32-bit numbers, so every view begins on a multiple of four.
    let mut binary = Vec::new();
    for corner in soup.triangles().into_iter().flatten() {
        binary.extend(corner.to_le_bytes());
    }
    let indices = binary.len() / 4;
    push_vectors(&mut binary, positions.iter().copied());
    let unit = |n: &DVec3| n.normalize_or(DVec3::Z);
    push_vectors(&mut binary, normals.into_iter().flatten().map(unit));
    let mut attributes: Vec<(&str, &str, usize)> = Vec::new();
    if normals.is_some() {
        attributes.push(("NORMAL", "VEC3", 12 * vertices));
    }
    if soup.has_colours() {
        let parts = colour::parts(soup);
        for colour in &soup.colours {
            for &part in &colour::to_linear(*colour)[..parts] {
                binary.extend(part.to_le_bytes());
            }
        }
        let kind = if parts == 3 { "VEC3" } else { "VEC4" };
        attributes.push(("COLOR_0", kind, 4 * parts * vertices));
    }

    let mut json = scene(&positions, centre, indices, &attributes, comment).into_bytes();
    json.resize(json.len().next_multiple_of(4), b' ');
    let length = 12 + 8 + json.len() as u64 + 8 + binary.len() as u64;
    let length = u32::try_from(length).map_err(|_| WriteError::TooLarge {
        format: Format::Glb,
    })?;

    let mut out = Vec::with_capacity(length as usize);
    out.extend(b"glTF");
    out.extend(2_u32.to_le_bytes());
    out.extend(length.to_le_bytes());
    for (kind, chunk) in [(b"JSON", &json), (b"BIN\0", &binary)] {
        // Shorter than `length`, so it fits.
        out.extend((chunk.len() as u32).to_le_bytes());
        out.extend(kind);
        out.extend(chunk);
    }
    Ok(out)
}

fn push_vectors(binary: &mut Vec<u8>, vectors: impl Iterator<Item = DVec3>) {
    for coordinate in vectors.flat_map(|v| v.as_vec3().to_array()) {
        binary.extend(coordinate.to_le_bytes());
    }
}

/// The JSON part: views of the binary part, and one node that uses them. What there is `more` of
/// vertices than positions is a name, a type and so many bytes each.
fn scene(
    positions: &[DVec3],
    centre: DVec3,
    indices: usize,
    more: &[(&str, &str, usize)],
    comment: &str,
) -> String {
    let vertices = positions.len();
    let (index_bytes, vector_bytes) = (4 * indices, 12 * vertices);
    let single = |p: &DVec3| p.as_vec3().as_dvec3();
    let low = positions
        .iter()
        .map(single)
        .fold(DVec3::INFINITY, DVec3::min);
    let high = positions
        .iter()
        .map(single)
        .fold(DVec3::NEG_INFINITY, DVec3::max);

    let mut attributes = r#""POSITION":1"#.to_owned();
    let mut accessors = format!(
        r#"{{"bufferView":0,"componentType":5125,"count":{indices},"type":"SCALAR"}},{{"bufferView":1,"componentType":5126,"count":{vertices},"type":"VEC3","min":{:?},"max":{:?}}}"#,
        low.to_array(),
        high.to_array()
    );
    let mut views = format!(
        r#"{{"buffer":0,"byteLength":{index_bytes},"target":34963}},{{"buffer":0,"byteOffset":{index_bytes},"byteLength":{vector_bytes},"target":34962}}"#
    );
    let mut total = index_bytes + vector_bytes;
    for (view, (name, kind, bytes)) in (2..).zip(more) {
        attributes += &format!(r#","{name}":{view}"#);
        accessors += &format!(
            r#",{{"bufferView":{view},"componentType":5126,"count":{vertices},"type":"{kind}"}}"#
        );
        views +=
            &format!(r#",{{"buffer":0,"byteOffset":{total},"byteLength":{bytes},"target":34962}}"#);
        total += bytes;
    }
    let generator = quoted(comment);
    let node = if centre == DVec3::ZERO {
        r#""mesh":0"#.to_owned()
    } else {
        format!(r#""mesh":0,"translation":{:?}"#, centre.to_array())
    };
    format!(
        r#"{{"asset":{{"version":"2.0","generator":{generator}}},"scene":0,"scenes":[{{"nodes":[0]}}],"nodes":[{{{node}}}],"meshes":[{{"primitives":[{{"attributes":{{{attributes}}},"indices":0,"mode":4}}]}}],"accessors":[{accessors}],"bufferViews":[{views}],"buffers":[{{"byteLength":{total}}}]}}"#
    )
}

/// A JSON string.
fn quoted(text: &str) -> String {
    let mut out = String::from('"');
    for c in text.chars() {
        match c {
            '"' | '\\' => out.extend(['\\', c]),
            c if c.is_control() => out.push(' '),
            c => out.push(c),
        }
    }
    out.push('"');
    out
}

#[cfg(test)]
mod tests {
    use serde_json::Value;

    use super::*;

    /// The JSON and the binary part, taken apart by the rules of the format.
    fn parts(bytes: &[u8]) -> (Value, Vec<u8>) {
        let number = |at: usize| u32::from_le_bytes(bytes[at..at + 4].try_into().unwrap()) as usize;
        assert_eq!(&bytes[..4], b"glTF");
        assert_eq!((number(4), number(8)), (2, bytes.len()));
        let json = number(12);
        let binary = number(20 + json);
        assert_eq!(
            (&bytes[16..20], &bytes[24 + json..28 + json]),
            (&b"JSON"[..], &b"BIN\0"[..])
        );
        assert_eq!((json % 4, binary % 4), (0, 0));
        assert_eq!(28 + json + binary, bytes.len());
        (
            serde_json::from_slice(&bytes[20..20 + json]).unwrap(),
            bytes[28 + json..].to_vec(),
        )
    }

    fn floats(binary: &[u8], view: &Value) -> Vec<f32> {
        let start = view["byteOffset"].as_u64().unwrap() as usize;
        let length = view["byteLength"].as_u64().unwrap() as usize;
        let chunks = binary[start..start + length].chunks_exact(4);
        chunks
            .map(|c| f32::from_le_bytes(c.try_into().unwrap()))
            .collect()
    }

    fn quad() -> PolygonSoup {
        let corners = [(0.1, 0., -7.), (1., 0., 0.), (1., 1., 0.), (0., 1e-9, 0.1)];
        let positions = corners.map(|(x, y, z)| DVec3::new(x, y, z)).to_vec();
        PolygonSoup::from_faces(positions, &[[0, 1, 2, 3]])
    }

    #[test]
    fn the_scene_describes_the_bytes() {
        let soup = quad();
        let normals = [DVec3::Z, DVec3::new(3., 0., 4.), DVec3::ZERO, DVec3::NEG_X];
        let bytes = write(&soup, Some(&normals), "Umbilic, \"step\" \\ 3\n").unwrap();
        let (scene, binary) = parts(&bytes);
        assert_eq!(scene["asset"]["generator"], "Umbilic, \"step\" \\ 3 ");
        assert_eq!(scene["buffers"][0]["byteLength"], binary.len());

        let accessors = scene["accessors"].as_array().unwrap();
        assert_eq!(accessors[0]["count"], 6);
        let indices: Vec<u32> = binary[..24]
            .chunks_exact(4)
            .map(|c| u32::from_le_bytes(c.try_into().unwrap()))
            .collect();
        assert_eq!(indices, [0, 1, 3, 1, 2, 3], "along the shorter diagonal");

        let views = &scene["bufferViews"];
        let positions = floats(&binary, &views[1]);
        let expected: Vec<f32> = soup
            .positions
            .iter()
            .flat_map(|p| p.as_vec3().to_array())
            .collect();
        assert_eq!(positions, expected);
        let (lows, highs) = (&accessors[1]["min"], &accessors[1]["max"]);
        for axis in 0..3 {
            // Equal after rounding, as validators demand, not merely close.
            let coordinates = positions
                .iter()
                .skip(axis)
                .step_by(3)
                .copied()
                .map(f64::from);
            let low = coordinates.clone().fold(f64::INFINITY, f64::min);
            let high = coordinates.fold(f64::NEG_INFINITY, f64::max);
            assert_eq!(lows[axis].as_f64(), Some(low));
            assert_eq!(highs[axis].as_f64(), Some(high));
        }
        let unit = floats(&binary, &views[2]);
        assert_eq!(unit, [0., 0., 1., 0.6, 0., 0.8, 0., 0., 1., -1., 0., 0.]);
        assert_eq!(
            scene["meshes"][0]["primitives"][0]["attributes"]["NORMAL"],
            2
        );
    }

    #[test]
    fn normals_may_be_left_out() {
        let (scene, binary) = parts(&write(&quad(), None, "").unwrap());
        assert_eq!(binary.len(), 24 + 48);
        assert_eq!(scene["accessors"].as_array().map(Vec::len), Some(2));
        assert!(scene["meshes"][0]["primitives"][0]["attributes"]["NORMAL"].is_null());
    }

    #[test]
    fn what_single_precision_cannot_hold_is_refused() {
        let mut soup = quad();
        soup.positions[3].x = 1e39;
        let error = write(&soup, None, "").unwrap_err();
        assert_eq!(error, WriteError::BeyondSingle { vertex: 3 });
        let mut soup = quad();
        for p in &mut soup.positions {
            *p *= 1e-40;
        }
        assert_eq!(write(&soup, None, ""), Err(WriteError::BelowSingle));
        assert_eq!(
            write(&quad(), Some(&[DVec3::X]), "").unwrap_err(),
            WriteError::NormalCount {
                normals: 1,
                vertices: 4
            }
        );
    }
}
