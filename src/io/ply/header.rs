//! The header of a PLY file: which elements follow, how many, made of what.

use super::super::binary::Scalar;
use super::super::text::{Lines, Words};
use super::super::{Expected, Format, Place, ReadError};

/// The words that a header begins and ends with.
const PLY: Expected = Expected::Keyword { word: "ply" };
const END: Expected = Expected::Keyword { word: "end_header" };

/// The type of that name, old style or new.
fn scalar_named(name: &[u8]) -> Option<Scalar> {
    Some(match name {
        b"char" | b"int8" => Scalar::I8,
        b"uchar" | b"uint8" => Scalar::U8,
        b"short" | b"int16" => Scalar::I16,
        b"ushort" | b"uint16" => Scalar::U16,
        b"int" | b"int32" => Scalar::I32,
        b"uint" | b"uint32" => Scalar::U32,
        b"float" | b"float32" => Scalar::F32,
        b"double" | b"float64" => Scalar::F64,
        _ => return None,
    })
}

/// What a property is to the reader.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Role {
    /// `x`, `y` or `z` of a vertex: 0, 1 or 2.
    Coordinate(usize),
    /// The list of a face's vertices.
    Corners,
    /// Part of a vertex's colour: 0 to 3 of red, green, blue and opacity.
    Colour(usize),
    /// The first part of a colour of something else.
    OtherColour,
    /// A texture coordinate, or a list of these.
    Texture,
    /// Nothing.
    Other,
}

/// One property of an element.
#[derive(Debug)]
pub(super) struct Property {
    pub(super) role: Role,
    /// Type of the value, or of a list's values.
    pub(super) scalar: Scalar,
    /// Type of a list's length.
    pub(super) length: Option<Scalar>,
}

impl Property {
    fn from_words(kind: ElementKind, words: &mut Words<'_>) -> Result<Self, ReadError> {
        let is_list = words.clone().next() == Some(b"list");
        let length = if is_list {
            words.next();
            let (length, word) = read_type(words)?;
            if !length.is_integer() {
                return Err(words.error(Some(word), Expected::IntegerType));
            }
            Some(length)
        } else {
            None
        };
        let (scalar, _) = read_type(words)?;
        let name = words.word(Expected::PropertyName)?;
        let part = colour_part(name).filter(|_| kind == ElementKind::Vertex && !is_list);
        let role = match (kind, name) {
            (ElementKind::Vertex, b"x") if !is_list => Role::Coordinate(0),
            (ElementKind::Vertex, b"y") if !is_list => Role::Coordinate(1),
            (ElementKind::Vertex, b"z") if !is_list => Role::Coordinate(2),
            (ElementKind::Face | ElementKind::Strips, b"vertex_indices" | b"vertex_index")
                if is_list && scalar.is_integer() =>
            {
                Role::Corners
            }
            (_, b"red" | b"diffuse_red") => part.map_or(Role::OtherColour, Role::Colour),
            (_, b"s" | b"u" | b"texture_u" | b"texcoord") => Role::Texture,
            _ => part.map_or(Role::Other, Role::Colour),
        };
        Ok(Self {
            role,
            scalar,
            length,
        })
    }
}

/// Which part of a colour a property of that name is.
fn colour_part(name: &[u8]) -> Option<usize> {
    let name = name.strip_prefix(b"diffuse_").unwrap_or(name);
    [&b"red"[..], b"green", b"blue", b"alpha"]
        .iter()
        .position(|part| *part == name)
}

fn read_type<'a>(words: &mut Words<'a>) -> Result<(Scalar, &'a [u8]), ReadError> {
    const EXPECTED: Expected = Expected::NumberType;
    let word = words.word(EXPECTED)?;
    let scalar = scalar_named(word).ok_or_else(|| words.error(Some(word), EXPECTED))?;
    Ok((scalar, word))
}

/// What the reader does with an element.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum ElementKind {
    Vertex,
    Face,
    /// Triangle strips.
    Strips,
    Other,
}

impl ElementKind {
    /// What its records are called.
    pub(super) fn plural(self) -> &'static str {
        match self {
            Self::Vertex => "vertices",
            Self::Face => "faces",
            Self::Strips => "strips",
            Self::Other => "elements",
        }
    }
}

/// One element: so many records of the same properties.
#[derive(Debug)]
pub(super) struct Element {
    pub(super) kind: ElementKind,
    pub(super) count: u64,
    /// The header line that announces it.
    pub(super) place: Place,
    pub(super) properties: Vec<Property>,
}

impl Element {
    fn from_words(words: &mut Words<'_>) -> Result<Self, ReadError> {
        let kind = match words.word(Expected::ElementName)? {
            b"vertex" => ElementKind::Vertex,
            b"face" => ElementKind::Face,
            b"tristrips" => ElementKind::Strips,
            _ => ElementKind::Other,
        };
        let count = words.how_many(Expected::ElementCount)?;
        Ok(Self {
            kind,
            count,
            place: words.place(),
            properties: Vec::new(),
        })
    }

    /// The fewest bytes one record takes in a binary file.
    pub(super) fn least_size(&self) -> usize {
        self.properties
            .iter()
            .map(|p| p.length.unwrap_or(p.scalar).size())
            .sum()
    }

    fn is_complete(&self) -> bool {
        let has = |role| self.properties.iter().filter(|p| p.role == role).count() == 1;
        match self.kind {
            ElementKind::Vertex => (0..3).all(|axis| has(Role::Coordinate(axis))),
            ElementKind::Face | ElementKind::Strips => has(Role::Corners),
            ElementKind::Other => true,
        }
    }
}

/// The header.
#[derive(Debug)]
pub(super) struct Header {
    pub(super) format: Format,
    pub(super) elements: Vec<Element>,
    /// How many vertices are announced.
    pub(super) vertices: u64,
    /// Where the body begins: its first byte,
    pub(super) body: usize,
    /// the header's last line,
    pub(super) lines: usize,
    /// and the byte that ends lines.
    pub(super) line_end: u8,
}

impl Header {
    /// Whether any element has a property of that role.
    pub(super) fn has(&self, role: Role) -> bool {
        let mut properties = self.elements.iter().flat_map(|e| &e.properties);
        properties.any(|property| property.role == role)
    }

    /// Reads the header of the file `bytes`.
    pub(super) fn read(bytes: &[u8]) -> Result<Self, ReadError> {
        // The body may be binary, so the first line alone tells how lines end.
        let line_end = match bytes.iter().position(|b| matches!(b, b'\r' | b'\n')) {
            Some(at) if bytes[at] == b'\r' && bytes.get(at + 1) != Some(&b'\n') => b'\r',
            _ => b'\n',
        };
        let mut lines = Lines::new(Format::Ply, bytes).starting_at(line_end, 0);
        let mut words = lines.next_filled(PLY)?;
        match words.word(PLY)? {
            b"ply" => {}
            word => return Err(words.error(Some(word), PLY)),
        }
        let format = read_format(&mut lines)?;
        let mut elements: Vec<Element> = Vec::new();
        loop {
            let mut words = lines.next_filled(END)?;
            match words.word(END)? {
                b"comment" | b"obj_info" => {}
                b"element" => {
                    let element = Element::from_words(&mut words)?;
                    let kind = element.kind;
                    if kind != ElementKind::Other && elements.iter().any(|e| e.kind == kind) {
                        let found = Some(b"element".as_slice());
                        return Err(words.error(found, Expected::OneElementEach));
                    }
                    elements.push(element);
                }
                b"property" => match elements.last_mut() {
                    Some(element) => {
                        element
                            .properties
                            .push(Property::from_words(element.kind, &mut words)?);
                    }
                    None => {
                        let expected = Expected::Keyword { word: "element" };
                        return Err(words.error(Some(b"property"), expected));
                    }
                },
                b"end_header" => {
                    check_complete(&elements, &words)?;
                    break;
                }
                word => {
                    let expected = Expected::Keyword {
                        word: "element, property, end_header",
                    };
                    return Err(words.error(Some(word), expected));
                }
            }
        }
        let vertices = elements
            .iter()
            .find(|e| e.kind == ElementKind::Vertex)
            .map_or(0, |e| e.count);
        Ok(Self {
            format,
            elements,
            vertices,
            body: bytes.len() - lines.rest().len(),
            lines: lines.number(),
            line_end,
        })
    }
}

fn read_format(lines: &mut Lines<'_>) -> Result<Format, ReadError> {
    const EXPECTED: Expected = Expected::Keyword {
        word: "format ascii, format binary_little_endian, format binary_big_endian",
    };
    loop {
        let mut words = lines.next_filled(EXPECTED)?;
        match words.word(EXPECTED)? {
            b"comment" | b"obj_info" => {}
            b"format" => {
                return match words.word(EXPECTED)? {
                    b"ascii" => Ok(Format::PlyAscii),
                    b"binary_little_endian" => Ok(Format::Ply),
                    b"binary_big_endian" => Ok(Format::PlyBigEndian),
                    word => Err(words.error(Some(word), EXPECTED)),
                };
            }
            word => return Err(words.error(Some(word), EXPECTED)),
        }
    }
}

/// Refuses a header without positions or without a way to tell faces.
fn check_complete(elements: &[Element], end: &Words<'_>) -> Result<(), ReadError> {
    let missing = match elements.iter().find(|element| !element.is_complete()) {
        Some(Element {
            kind: ElementKind::Face | ElementKind::Strips,
            ..
        }) => Expected::FaceProperty,
        Some(_) => Expected::VertexProperties,
        None if elements.iter().all(|e| e.kind != ElementKind::Vertex) => Expected::Keyword {
            word: "element vertex",
        },
        None => return Ok(()),
    };
    Err(end.error(Some(b"end_header"), missing))
}
