//! The meshes that files are made of, and what is asked of all readers.

use glam::DVec3;
use umbilic::io::{self, Oddity, Read, ReadError};
use umbilic::soup::PolygonSoup;

/// A cube of six quadrilaterals, moved and scaled; exact in single precision unless far away.
pub(crate) fn cube(origin: f64, size: f64) -> PolygonSoup {
    let corner = |k: u32| {
        let axis = |bit: u32| f64::from(k >> bit & 1);
        origin + size * DVec3::new(axis(0), axis(1), axis(2))
    };
    let faces: [[u32; 4]; 6] = [
        [0, 2, 3, 1],
        [4, 5, 7, 6],
        [0, 1, 5, 4],
        [2, 6, 7, 3],
        [0, 4, 6, 2],
        [1, 3, 7, 5],
    ];
    PolygonSoup::from_faces((0..8).map(corner).collect(), &faces)
}

/// An octahedron, whose triangles are also two fans.
pub(crate) fn octahedron() -> PolygonSoup {
    let positions = [
        DVec3::Z,
        DVec3::X,
        DVec3::Y,
        DVec3::NEG_X,
        DVec3::NEG_Y,
        DVec3::NEG_Z,
    ];
    let mut faces = Vec::new();
    for k in 0..4 {
        let [a, b] = [k + 1, (k + 1) % 4 + 1];
        faces.extend([[0, a, b], [5, b, a]]);
    }
    PolygonSoup::from_faces(positions.to_vec(), &faces)
}

/// The soup that a file holds, said to be of that name, and nothing odd in it.
pub(crate) fn plain(bytes: &[u8], name: &str) -> PolygonSoup {
    let read = io::read(bytes, name).unwrap_or_else(|error| panic!("{name}: {error}"));
    assert_eq!(read.warnings, Vec::<Oddity>::new(), "{name}");
    read.soup
}

/// What is odd in a file that is read.
pub(crate) fn oddities(bytes: &[u8]) -> Vec<Oddity> {
    io::read(bytes, "").unwrap().warnings
}

/// Why a file is refused.
pub(crate) fn refusal(bytes: &[u8]) -> ReadError {
    match io::read(bytes, "") {
        Err(error) => error,
        Ok(Read { soup, .. }) => panic!("{} faces were read", soup.n_faces()),
    }
}

/// No file that ends early is taken for whole.
pub(crate) fn is_refused_wherever_it_ends(bytes: &[u8], from: usize, to: usize) {
    for end in from..to {
        if let Ok(read) = io::read(&bytes[..end], "") {
            panic!(
                "cut at {end} of {}: {} faces",
                bytes.len(),
                read.soup.n_faces()
            );
        }
    }
}

/// A number as bytes of either order.
pub(crate) fn ordered<const N: usize>(mut bytes: [u8; N], big: bool) -> [u8; N] {
    if big {
        bytes.reverse();
    }
    bytes
}

pub(crate) fn base64(bytes: &[u8]) -> String {
    const DIGITS: &[u8; 64] = b"ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
    let mut text = String::new();
    for chunk in bytes.chunks(3) {
        let byte = |n: usize| u32::from(chunk.get(n).copied().unwrap_or(0));
        let bits = byte(0) << 16 | byte(1) << 8 | byte(2);
        for n in 0..4 {
            let digit = DIGITS[(bits >> (18 - 6 * n)) as usize & 63];
            text.push(if n <= chunk.len() { digit as char } else { '=' });
        }
    }
    text
}
