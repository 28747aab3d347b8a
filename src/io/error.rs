//! What can be wrong with a mesh file, and where.

use super::Format;
use crate::message::{Message, Value, messages};
use crate::soup::PolygonSoup;

messages! {
    /// Where in a file.
    #[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
    pub enum Place as "place" {
        /// Of text.
        Line {
            /// Counted from 1.
            line: usize,
        },
        /// Of a binary file.
        Byte {
            /// Counted from 0.
            byte: usize,
        },
    }
}

/// As people call it.
impl From<Format> for Value {
    fn from(format: Format) -> Self {
        Message::new("format-", format.name(), Vec::new()).into()
    }
}

messages! {
    /// What stands in a file.
    #[derive(Clone, Debug, PartialEq, Eq)]
    pub enum Found as "found" {
        /// The line is at its end.
        EndOfLine,
        /// The file is at its end.
        EndOfFile,
        /// It is missing.
        Nothing,
        /// A word.
        Word {
            /// Shortened.
            word: String,
        },
    }
}

messages! {
    /// What should stand in a file.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Expected as "expected" {
        /// A word of the format.
        Keyword {
            /// The word, or several.
            word: &'static str,
        },
        /// A coordinate of a vertex.
        Coordinate {
            /// `x`, `y` or `z`.
            axis: &'static str,
        },
        /// A vertex.
        Vertex,
        /// A face.
        Face,
        /// A vertex by its number.
        VertexIndex,
        /// The same in OBJ, perhaps with a texture coordinate and a normal.
        ObjCorner,
        /// How many vertices follow.
        VertexCount,
        /// The header of OFF, or how many vertices follow.
        OffOrVertexCount,
        /// How many faces follow.
        FaceCount,
        /// How many corners a face has.
        CornerCount,
        /// A number.
        Number,
        /// A name of a property.
        PropertyName,
        /// A name of an element.
        ElementName,
        /// How many elements follow.
        ElementCount,
        /// A line of an element that is not read.
        OtherElement,
        /// How long a list is.
        ListLength,
        /// A type for that.
        IntegerType,
        /// A type of a property.
        NumberType,
        /// All vertices in one element, and all faces.
        OneElementEach,
        /// `x`, `y` and `z`, once each.
        VertexProperties,
        /// One list of vertex indices.
        FaceProperty,
        /// How many corners and indices of cells follow.
        CellCount,
        /// What kind of a cell it is.
        CellType,
        /// A number that no other vertex has.
        VertexNumber,
        /// An element of XML.
        XmlElement {
            /// Its name, or several.
            name: &'static str,
        },
        /// An attribute of an element of XML.
        XmlAttribute {
            /// Its name.
            name: &'static str,
        },
        /// A well-formed value of JSON.
        JsonValue,
        /// A member of an object of JSON.
        JsonMember {
            /// Its name.
            name: &'static str,
        },
        /// A node of a scene by its number, which has one place there.
        SceneNode,
        /// Bytes written as text.
        Base64,
        /// Compressed bytes.
        Compressed,
        /// An object of a 3MF model, by its number.
        ModelObject,
        /// Twelve numbers.
        Transform,
    }
}

messages! {
    /// Why a file was refused.
    #[derive(Clone, Debug, PartialEq)]
    pub enum ReadError as "read" {
        /// No bytes, or blanks only.
        Empty,
        /// Neither the content nor the name tells a format.
        UnknownFormat {
            /// The file's name as given.
            name: String,
            /// Endings of files that are read.
            known: Vec<&'static str>,
        },
        /// Something else came in the place of the file.
        Substituted {
            /// `git-lfs` (the pointer that stands for a large file) or `html` (a page about it).
            what: &'static str,
        },
        /// A known format that is not read.
        Unsupported {
            /// `obj-free-form`, `nd-off` (of higher dimension), `vtk-data-set` (no surface),
            /// `vtk-compressor`, `msh-version`, `gltf-external` (parts in other files),
            /// `gltf-draco`, `gltf-meshopt` or `gltf-version`.
            what: &'static str,
        },
        /// A glTF file says that it cannot be read without what is not known here.
        RequiredExtension {
            /// What.
            name: String,
        },
        /// A NUL byte in what should be text.
        NotText {
            /// The text format.
            format: Format,
            /// The first NUL byte.
            offset: usize,
        },
        /// Something else stands where the format asks for a certain word or number.
        Syntax {
            /// The format being read.
            format: Format,
            /// Where it stands.
            place: Place,
            /// What stands there.
            found: Found,
            /// What should.
            expected: Expected,
        },
        /// A number is written with a comma.
        DecimalComma {
            /// The format being read.
            format: Format,
            /// Where it stands.
            place: Place,
            /// What stands there.
            found: Found,
            /// What should.
            expected: Expected,
        },
        /// A face names a vertex that does not exist.
        IndexOutOfRange {
            /// The format being read.
            format: Format,
            /// The face's line or byte.
            place: Place,
            /// The index as the file writes it: in OBJ from 1 or negative, elsewhere from 0.
            index: i64,
            /// How many vertices the file has; for a negative OBJ index, how many come before
            /// it.
            vertices: usize,
        },
        /// A position with a coordinate that is infinite, not a number, or too large for one.
        NonFiniteVertex {
            /// The vertex, counted from 1 in the file's order; for STL every corner counts.
            number: usize,
            /// Its line or byte.
            place: Place,
        },
        /// A binary file ends too soon.
        Truncated {
            /// Where the missing piece begins.
            offset: usize,
            /// Its length.
            needed: u64,
            /// What is left of the file there.
            available: usize,
        },
        /// The file announces more than its bytes could hold, or than 32-bit indices can count.
        CountTooLarge {
            /// Where.
            place: Place,
            /// What is counted: `vertices`, `faces`, `corners`, `elements`, or `bytes` of memory.
            what: &'static str,
            /// The number announced.
            count: u64,
            /// The largest number possible there.
            at_most: u64,
        },
        /// The file has no polygon of three corners or more.
        NoFaces {
            /// How many vertices it has.
            vertices: usize,
        },
    }
}

impl ReadError {
    /// That something else stands where `expected` should.
    pub(super) fn syntax(format: Format, place: Place, found: Found, expected: Expected) -> Self {
        match &found {
            Found::Word { word } if looks_like_decimal_comma(word) => Self::DecimalComma {
                format,
                place,
                found,
                expected,
            },
            _ => Self::Syntax {
                format,
                place,
                found,
                expected,
            },
        }
    }

    /// The numbers in the error, named, for whoever wants to point at the place.
    pub fn detail(&self) -> Vec<(&'static str, f64)> {
        let at = |place: &Place| match *place {
            Place::Line { line } => ("line", line as f64),
            Place::Byte { byte } => ("byte", byte as f64),
        };
        match self {
            Self::Empty
            | Self::UnknownFormat { .. }
            | Self::Substituted { .. }
            | Self::Unsupported { .. }
            | Self::RequiredExtension { .. } => Vec::new(),
            Self::NotText { offset, .. } => vec![("byte", *offset as f64)],
            Self::Syntax { place, .. } | Self::DecimalComma { place, .. } => vec![at(place)],
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
            Self::NonFiniteVertex { number, place } => {
                vec![at(place), ("vertex", *number as f64 - 1.0)]
            }
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

fn looks_like_decimal_comma(word: &str) -> bool {
    word.contains(',')
        && word
            .bytes()
            .all(|b| b.is_ascii_digit() || b"+-,eE".contains(&b))
}

messages! {
    /// An oddity that does not stop a reader.
    #[derive(Clone, Debug, PartialEq, Eq)]
    pub enum Oddity as "oddity" {
        /// The text was brought from UTF-16.
        Transcoded,
        /// The name's ending is of another format.
        OtherEnding {
            /// As the name has it, without the dot.
            ending: &'static str,
            /// What the bytes are.
            format: Format,
        },
        /// Faces of fewer than three corners were dropped.
        ShortFaces {
            /// How many.
            count: usize,
            /// The first.
            first: Place,
        },
        /// Vertices without a finite position that no face uses: they were put where the first
        /// vertex is.
        UnplacedVertices {
            /// How many.
            count: usize,
            /// The first.
            first: Place,
        },
        /// The model says of no object that it is to be built: all were read.
        NothingToBuild,
        /// Lines of an OBJ file that are no part of a polygon mesh were skipped.
        OtherLines {
            /// How many.
            count: usize,
            /// The first.
            first: Place,
        },
        /// Lines after what the header counts.
        LinesLeft {
            /// How many.
            count: usize,
        },
        /// Bytes after the end of a binary mesh.
        BytesLeft {
            /// How many.
            count: u64,
        },
        /// The last solid of an STL file has no end.
        NoEnd,
        /// The header of a binary STL file counts no triangles, or more than there are.
        Uncounted {
            /// How many it counts.
            announced: u64,
            /// How many were read, to the file's end.
            count: u64,
        },
        /// Vertices of an OBJ file have a fourth number, which belongs to curves.
        FourthNumbers {
            /// How many.
            count: usize,
            /// The first.
            first: Place,
        },
        /// Cells or primitives that are no polygons were skipped: points, lines, volumes.
        OtherCells {
            /// How many.
            count: usize,
            /// The first.
            first: Place,
        },
        /// There were no faces, but cells with a volume: their surface was read.
        SolidCells {
            /// How many.
            count: usize,
        },
        /// Corners at the same position were joined: the format splits vertices along seams.
        SeamsJoined {
            /// How many vertices fewer there are.
            count: usize,
        },
        /// What the file holds besides the mesh, and is not kept.
        LeftOut {
            /// Each.
            what: Vec<Extra>,
        },
    }
}

messages! {
    /// What a file may hold besides a mesh.
    #[derive(Clone, Copy, Debug, PartialEq, Eq)]
    pub enum Extra as "extra" {
        /// Of vertices or faces.
        Colours,
        /// Positions in a picture.
        TextureCoordinates,
        /// Names of materials.
        Materials,
        /// Parts by name.
        Groups,
        /// Values at vertices or cells.
        Data,
    }
}

impl Oddity {
    /// Some of what a file may hold is there; nothing to be said where none is.
    pub(super) fn left_out(found: &[(Extra, bool)]) -> Option<Self> {
        let what = found.iter().filter(|(_, is_there)| *is_there);
        let what: Vec<Extra> = what.map(|(extra, _)| *extra).collect();
        (!what.is_empty()).then_some(Self::LeftOut { what })
    }
}

messages! {
    /// What a written file does not hold as the mesh does.
    #[derive(Clone, Copy, Debug, PartialEq)]
    pub enum Loss as "loss" {
        /// The mesh was moved to the origin: far away, single precision would round it.
        Moved {
            /// The format, which has no place for how far.
            format: Format,
            /// By so much,
            x: f64,
            /// in all three
            y: f64,
            /// directions.
            z: f64,
        },
        /// The format knows vertices by their places: those at one place are one when it is read.
        Joined {
            /// The format.
            format: Format,
            /// How many are at the place of another.
            count: usize,
        },
        /// The format has no place for colours of vertices.
        Colours {
            /// The format.
            format: Format,
        },
        /// The format holds triangles alone: others were cut.
        Polygons {
            /// The format.
            format: Format,
            /// How many faces had more corners.
            count: usize,
        },
        /// Colours of vertices that a remeshing made, of which a restart has left the places alone.
        ColoursLost,
    }
}

messages! {
    /// Why a soup cannot be written.
    #[derive(Clone, Debug, PartialEq)]
    pub enum WriteError as "write" {
        /// There is nothing to write.
        NoFaces,
        /// A face names a vertex that does not exist.
        IndexOutOfRange {
            /// The face, counted from 0.
            face: usize,
            /// The index it holds.
            index: u32,
            /// How many vertices there are.
            vertices: usize,
        },
        /// A position is infinite or not a number.
        NonFiniteVertex {
            /// The vertex, counted from 0.
            vertex: usize,
        },
        /// A position or normal is too large for single precision, which the format asks for.
        BeyondSingle {
            /// The vertex, counted from 0.
            vertex: usize,
        },
        /// The mesh is so small that single precision cannot tell its vertices apart.
        BelowSingle,
        /// Normals were given, but not one a vertex.
        NormalCount {
            /// How many normals.
            normals: usize,
            /// How many vertices.
            vertices: usize,
        },
        /// The format is read and not written.
        ReadOnly {
            /// The format.
            format: Format,
        },
        /// The format counts in 32 bits and the mesh has more.
        TooLarge {
            /// The format.
            format: Format,
        },
    }
}

/// Refuses what no format can hold.
pub(super) fn check_writable(soup: &PolygonSoup) -> Result<(), WriteError> {
    if soup.n_faces() == 0 {
        return Err(WriteError::NoFaces);
    }
    if let Some(vertex) = soup.positions.iter().position(|p| !p.is_finite()) {
        return Err(WriteError::NonFiniteVertex { vertex });
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
