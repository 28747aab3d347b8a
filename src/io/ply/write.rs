//! Writing PLY.

use std::fmt::Write as _;

use super::super::Format;
use super::super::text::comment_lines;
use crate::soup::PolygonSoup;

/// Writes a PLY file with `double` positions, so that all encodings keep every bit.
pub(in crate::io) fn write(soup: &PolygonSoup, format: Format, comment: &str) -> Vec<u8> {
    let encoding = match format {
        Format::PlyAscii => "ascii",
        Format::PlyBigEndian => "binary_big_endian",
        _ => "binary_little_endian",
    };
    let small = soup.faces().all(|face| face.len() <= usize::from(u8::MAX));
    let length_type = if small { "uchar" } else { "uint" };
    let mut text = format!("ply\nformat {encoding} 1.0\n");
    for line in comment_lines(comment) {
        text += &format!("comment {line}\n");
    }
    text += &format!(
        "element vertex {}\nproperty double x\nproperty double y\nproperty double z\n\
         element face {}\nproperty list {length_type} uint vertex_indices\nend_header\n",
        soup.positions.len(),
        soup.n_faces()
    );
    match format {
        Format::PlyAscii => write_text(soup, text),
        Format::PlyBigEndian => write_binary(soup, text, small, f64::to_be_bytes, u32::to_be_bytes),
        _ => write_binary(soup, text, small, f64::to_le_bytes, u32::to_le_bytes),
    }
}

fn write_text(soup: &PolygonSoup, mut out: String) -> Vec<u8> {
    for p in &soup.positions {
        // Writing to a string cannot fail.
        let _ = writeln!(out, "{:?} {:?} {:?}", p.x, p.y, p.z);
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

fn write_binary(
    soup: &PolygonSoup,
    header: String,
    small: bool,
    float: fn(f64) -> [u8; 8],
    integer: fn(u32) -> [u8; 4],
) -> Vec<u8> {
    let mut out = header.into_bytes();
    out.reserve(24 * soup.positions.len() + 4 * (soup.corners.len() + soup.n_faces()));
    for coordinate in soup.positions.iter().flat_map(|p| p.to_array()) {
        out.extend(float(coordinate));
    }
    for face in soup.faces() {
        if small {
            out.push(face.len() as u8);
        } else {
            out.extend(integer(face.len() as u32));
        }
        for &corner in face {
            out.extend(integer(corner));
        }
    }
    out
}
