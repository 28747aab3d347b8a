//! Writing PLY.

use std::fmt::Write as _;

use super::super::text::comment_lines;
use super::super::{Format, colour};
use crate::soup::PolygonSoup;

/// A colour part in bytes: the way most programs know, where it loses nothing.
fn byte(part: f32) -> Option<u8> {
    let byte = (255.0 * part).round() as u8;
    ((f64::from(byte) / 255.0) as f32 == part).then_some(byte)
}

/// How colours are written: how many parts, and whether in bytes.
struct Colours {
    parts: usize,
    bytes: bool,
}

impl Colours {
    fn of(soup: &PolygonSoup) -> Self {
        let parts = match soup.has_colours() {
            false => 0,
            true => colour::parts(soup),
        };
        let bytes = soup.colours.iter().flatten().all(|p| byte(*p).is_some());
        Self { parts, bytes }
    }

    fn header(&self) -> String {
        let scalar = if self.bytes { "uchar" } else { "float" };
        let names = &["red", "green", "blue", "alpha"][..self.parts];
        let lines = names.iter().map(|n| format!("property {scalar} {n}\n"));
        lines.collect()
    }

    fn of_vertex<'a>(&self, soup: &'a PolygonSoup, v: usize) -> &'a [f32] {
        soup.colours.get(v).map_or(&[], |c| &c[..self.parts])
    }
}

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
    let colours = Colours::of(soup);
    text += &format!(
        "element vertex {}\nproperty double x\nproperty double y\nproperty double z\n{}\
         element face {}\nproperty list {length_type} uint vertex_indices\nend_header\n",
        soup.positions.len(),
        colours.header(),
        soup.n_faces()
    );
    match format {
        Format::PlyAscii => write_text(soup, &colours, text),
        Format::PlyBigEndian => {
            let numbers: Bytes = (f64::to_be_bytes, u32::to_be_bytes);
            write_binary(soup, &colours, text, small, numbers)
        }
        _ => {
            let numbers: Bytes = (f64::to_le_bytes, u32::to_le_bytes);
            write_binary(soup, &colours, text, small, numbers)
        }
    }
}

fn write_text(soup: &PolygonSoup, colours: &Colours, mut out: String) -> Vec<u8> {
    for (v, p) in soup.positions.iter().enumerate() {
        // Writing to a string cannot fail.
        let _ = write!(out, "{:?} {:?} {:?}", p.x, p.y, p.z);
        for part in colours.of_vertex(soup, v) {
            let _ = match byte(*part).filter(|_| colours.bytes) {
                Some(byte) => write!(out, " {byte}"),
                None => write!(out, " {part:?}"),
            };
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

/// How numbers become bytes, in either order.
type Bytes = (fn(f64) -> [u8; 8], fn(u32) -> [u8; 4]);

fn write_binary(
    soup: &PolygonSoup,
    colours: &Colours,
    header: String,
    small: bool,
    (float, integer): Bytes,
) -> Vec<u8> {
    let mut out = header.into_bytes();
    out.reserve(24 * soup.positions.len() + 4 * (soup.corners.len() + soup.n_faces()));
    for (v, p) in soup.positions.iter().enumerate() {
        out.extend(p.to_array().into_iter().flat_map(float));
        for part in colours.of_vertex(soup, v) {
            match byte(*part).filter(|_| colours.bytes) {
                Some(byte) => out.push(byte),
                // The bits of a number in single precision, in the same order.
                None => out.extend(integer(part.to_bits())),
            }
        }
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
