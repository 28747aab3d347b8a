//! What can be wrong with a mesh file, and where.

use glam::DVec3;

use super::Format;
use crate::soup::PolygonSoup;

/// Where in a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Place {
    /// A line of text, counted from 1.
    Line(usize),
    /// A byte, counted from 0.
    Byte(usize),
}

impl std::fmt::Display for Place {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        match self {
            Self::Line(line) => write!(f, "line {line}"),
            Self::Byte(byte) => write!(f, "byte {byte}"),
        }
    }
}

/// Why a file was refused.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ReadError {
    /// No bytes, or blanks only.
    #[error("the file is empty")]
    Empty,
    /// Neither the content nor the name tells a format.
    #[error("`{name}` is not recognised as OBJ, OFF, PLY or STL")]
    UnknownFormat {
        /// The file's name as given.
        name: String,
    },
    /// A known format that is not read.
    #[error("{what} files cannot be read")]
    Unsupported {
        /// The format or variant.
        what: &'static str,
    },
    /// A NUL byte in what should be text.
    #[error("{format}: byte {offset} is not text")]
    NotText {
        /// The text format.
        format: Format,
        /// The first NUL byte.
        offset: usize,
    },
    /// Something else stands where the format asks for a certain word or number.
    #[error("{format}, {place}: found {found}, expected {expected}")]
    Syntax {
        /// The format being read.
        format: Format,
        /// Where it stands.
        place: Place,
        /// What stands there, quoted and shortened; or `end of line`, `end of file`.
        found: String,
        /// What should.
        expected: &'static str,
    },
    /// A face names a vertex that does not exist.
    #[error("{format}, {place}: a face names vertex {index}, the file has {vertices}")]
    IndexOutOfRange {
        /// The format being read.
        format: Format,
        /// The face's line or byte.
        place: Place,
        /// The index as the file writes it: in OBJ from 1 or negative, elsewhere from 0.
        index: i64,
        /// How many vertices the file has; for a negative OBJ index, how many come before it.
        vertices: usize,
    },
    /// A position with a coordinate that is infinite, not a number, or too large for one.
    #[error("{place}: vertex number {} (counted from 1) is not finite", vertex + 1)]
    NonFiniteVertex {
        /// The vertex, counted from 0 in the file's order; for STL every corner counts.
        vertex: usize,
        /// Its line or byte.
        place: Place,
    },
    /// A binary file ends too soon.
    #[error("the file is cut short: {needed} bytes needed at byte {offset}, {available} there")]
    Truncated {
        /// Where the missing piece begins.
        offset: usize,
        /// Its length.
        needed: u64,
        /// What is left of the file there.
        available: usize,
    },
    /// The file announces more than its bytes could hold, or than 32-bit indices can count.
    #[error("{place} announces {count} {what}, at most {at_most} are possible")]
    CountTooLarge {
        /// Where.
        place: Place,
        /// What is counted.
        what: &'static str,
        /// The number announced.
        count: u64,
        /// The largest number possible there.
        at_most: u64,
    },
    /// The file has no polygon of three corners or more.
    #[error("the file has {vertices} vertices and no faces")]
    NoFaces {
        /// How many vertices it has.
        vertices: usize,
    },
}

impl ReadError {
    /// The variant's name.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::Empty => "Empty",
            Self::UnknownFormat { .. } => "UnknownFormat",
            Self::Unsupported { .. } => "Unsupported",
            Self::NotText { .. } => "NotText",
            Self::Syntax { .. } => "Syntax",
            Self::IndexOutOfRange { .. } => "IndexOutOfRange",
            Self::NonFiniteVertex { .. } => "NonFiniteVertex",
            Self::Truncated { .. } => "Truncated",
            Self::CountTooLarge { .. } => "CountTooLarge",
            Self::NoFaces { .. } => "NoFaces",
        }
    }

    /// What the user can do about it.
    pub fn hint(&self) -> String {
        match self {
            Self::Empty => "Check that the export or download finished.",
            Self::UnknownFormat { .. } => "Open an OBJ, OFF, PLY or STL file.",
            Self::Unsupported { .. } => "Export the surface as OBJ, PLY or STL.",
            Self::NotText { .. } => {
                "The file is binary or UTF-16 text; save it as UTF-8 or give it the right ending."
            }
            Self::Syntax { found, .. } if looks_like_decimal_comma(found) => {
                "Export with a decimal point instead of a decimal comma."
            }
            Self::Syntax { .. } => "Look at that place in the file, or export it again.",
            Self::IndexOutOfRange {
                format: Format::Obj,
                ..
            } => "OBJ counts vertices from 1, or from -1 backwards. Export the file again.",
            Self::IndexOutOfRange { .. } => {
                "This format counts vertices from 0. Export the file again."
            }
            Self::NonFiniteVertex { .. } => {
                "Remove the vertex or give it a position, then export again."
            }
            Self::Truncated { .. } => {
                "The download or copy may have stopped early; fetch it again."
            }
            Self::CountTooLarge { .. } => "The count is wrong or the file is cut short.",
            Self::NoFaces { vertices: 0 } => "Check that the file is what its name says.",
            Self::NoFaces { .. } => "Point clouds and curves have no surface; open a mesh.",
        }
        .to_owned()
    }

    /// The numbers in the error, named, for whoever wants to point at the place.
    pub fn detail(&self) -> Vec<(&'static str, f64)> {
        let at = |place: &Place| match *place {
            Place::Line(line) => ("line", line as f64),
            Place::Byte(byte) => ("byte", byte as f64),
        };
        match self {
            Self::Empty | Self::UnknownFormat { .. } | Self::Unsupported { .. } => Vec::new(),
            Self::NotText { offset, .. } => vec![("byte", *offset as f64)],
            Self::Syntax { place, .. } => vec![at(place)],
            Self::IndexOutOfRange {
                place,
                index,
                vertices,
                ..
            } => {
                vec![
                    at(place),
                    ("index", *index as f64),
                    ("vertices", *vertices as f64),
                ]
            }
            Self::NonFiniteVertex { vertex, place } => vec![at(place), ("vertex", *vertex as f64)],
            Self::Truncated {
                offset,
                needed,
                available,
            } => vec![
                ("byte", *offset as f64),
                ("needed", *needed as f64),
                ("available", *available as f64),
            ],
            Self::CountTooLarge {
                place,
                count,
                at_most,
                ..
            } => {
                vec![
                    at(place),
                    ("count", *count as f64),
                    ("atMost", *at_most as f64),
                ]
            }
            Self::NoFaces { vertices } => vec![("vertices", *vertices as f64)],
        }
    }
}

fn looks_like_decimal_comma(found: &str) -> bool {
    let number = found.trim_matches('`');
    number.contains(',')
        && number
            .bytes()
            .all(|b| b.is_ascii_digit() || b"+-,eE".contains(&b))
}

/// Why a soup cannot be written.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum WriteError {
    /// There is nothing to write.
    #[error("there are no faces to write")]
    NoFaces,
    /// A face names a vertex that does not exist.
    #[error("face {face} names vertex {index} of {vertices}")]
    IndexOutOfRange {
        /// The face, counted from 0.
        face: usize,
        /// The index it holds.
        index: u32,
        /// How many vertices there are.
        vertices: usize,
    },
    /// A position (or normal) is infinite, not a number, or too large for single precision
    /// where the format asks for that.
    #[error("vertex {vertex} cannot be written as a {}", if *single { "32-bit float" } else { "number" })]
    NonFiniteVertex {
        /// The vertex, counted from 0.
        vertex: usize,
        /// The number is fine, but not in single precision.
        single: bool,
    },
    /// Normals were given, but not one a vertex.
    #[error("{normals} normals given for {vertices} vertices")]
    NormalCount {
        /// How many normals.
        normals: usize,
        /// How many vertices.
        vertices: usize,
    },
    /// The format counts in 32 bits and the mesh has more.
    #[error("the mesh is too large for {format}")]
    TooLarge {
        /// The format.
        format: Format,
    },
}

impl WriteError {
    /// The variant's name.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::NoFaces => "NoFaces",
            Self::IndexOutOfRange { .. } => "IndexOutOfRange",
            Self::NonFiniteVertex { .. } => "NonFiniteVertex",
            Self::NormalCount { .. } => "NormalCount",
            Self::TooLarge { .. } => "TooLarge",
        }
    }

    /// What the user can do about it.
    pub fn hint(&self) -> String {
        match self {
            Self::NoFaces => "Load a mesh first.",
            Self::NonFiniteVertex { single: true, .. } => {
                "Scale the mesh down, or use OBJ, OFF or PLY: they keep double precision."
            }
            Self::NonFiniteVertex { .. } => "Step back to a state with finite positions.",
            Self::TooLarge { .. } => "Use OBJ, OFF or PLY.",
            Self::IndexOutOfRange { .. } | Self::NormalCount { .. } => {
                "This is a fault of the program; please report it."
            }
        }
        .to_owned()
    }
}

/// Refuses what no format can hold.
pub(super) fn check_writable(soup: &PolygonSoup) -> Result<(), WriteError> {
    if soup.n_faces() == 0 {
        return Err(WriteError::NoFaces);
    }
    if let Some(vertex) = soup.positions.iter().position(|p| !p.is_finite()) {
        return Err(WriteError::NonFiniteVertex {
            vertex,
            single: false,
        });
    }
    let vertices = soup.positions.len();
    for (face, corners) in soup.faces().enumerate() {
        if let Some(&index) = corners.iter().find(|&&c| c as usize >= vertices) {
            return Err(WriteError::IndexOutOfRange {
                face,
                index,
                vertices,
            });
        }
    }
    Ok(())
}

/// Refuses vectors that single precision cannot hold.
pub(super) fn check_single(vectors: &[DVec3]) -> Result<(), WriteError> {
    match vectors.iter().position(|v| !v.as_vec3().is_finite()) {
        Some(vertex) => Err(WriteError::NonFiniteVertex {
            vertex,
            single: true,
        }),
        None => Ok(()),
    }
}
