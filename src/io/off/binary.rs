//! Binary OFF: after the line of text, numbers of 32 bits, the most significant byte first. A
//! vertex is x, y, z, its normal, four parts of its colour and two texture coordinates; a face the
//! number of its corners, the corners, and how many parts of a colour follow, which are left aside.

use glam::DVec3;

use super::super::assembly::Assembly;
use super::super::binary::{Cursor, Scalar};
use super::super::{Extra, Format, Oddity, Read, ReadError};
use super::{checked_count, letters_of};

/// A count, and the error of one that the bytes left could not hold at so many each.
fn count(cursor: &mut Cursor<'_>, what: &'static str, size: usize) -> Result<usize, ReadError> {
    let place = cursor.place();
    let count = cursor.value(Scalar::U32)? as u64;
    let at_most = cursor.left().len() as u64 / size as u64;
    checked_count(count, what, at_most, place)
}

/// Reads what stands after the header; `at` is where that is.
pub(super) fn read(word: &[u8], bytes: &[u8], at: usize) -> Result<Read, ReadError> {
    let [has_colours, has_texture, has_normals] = letters_of(word);
    let (normal, texture) = (3 * usize::from(has_normals), 2 * usize::from(has_texture));
    let numbers = 3 + normal + 4 * usize::from(has_colours) + texture;
    let mut cursor = Cursor::new(bytes, at, true);
    let vertices = count(&mut cursor, "vertices", 4 * numbers)?;
    let faces = count(&mut cursor, "faces", 8)?;
    // Edges, of which nobody makes use.
    cursor.take(4)?;
    let mut assembly = Assembly::new();
    assembly.reserve(vertices, faces);
    let mut values = vec![0.0; numbers];
    for vertex in 0..vertices {
        let place = cursor.place();
        for value in &mut values {
            *value = cursor.value(Scalar::F32)?;
        }
        assembly.vertex(DVec3::new(values[0], values[1], values[2]), place)?;
        if has_colours {
            let colour = 3 + normal;
            assembly.colour(vertex, [0, 1, 2, 3].map(|part| values[colour + part]));
        }
    }
    let mut corners = Vec::new();
    for _ in 0..faces {
        let place = cursor.place();
        corners.clear();
        for _ in 0..count(&mut cursor, "corners", 4)? {
            let index = cursor.value(Scalar::I32)?;
            corners.push(assembly.index(index, Format::Off, place)?);
        }
        assembly.face(&corners, place)?;
        let parts = cursor.value(Scalar::U32)? as u64;
        cursor.take(4 * parts)?;
    }
    let mut read = assembly.finish(Format::Off)?;
    let left = cursor.left().len() as u64;
    if left > 0 {
        read.warnings.push(Oddity::BytesLeft { count: left });
    }
    let texture = [(Extra::TextureCoordinates, has_texture)];
    read.warnings.extend(Oddity::left_out(&texture));
    Ok(read)
}
