//! MSH, the format of Gmsh: the surface elements of version 1, which is text, and of versions 2, 4.0
//! and 4.1, in text and in binary.
//!
//! Source: the Gmsh reference manual, "File formats". Nodes have numbers of their own, in any
//! order; elements of second order are cut at their nodes, of higher order read as their corners;
//! points and lines are counted as skipped, and so are volumes unless there are no others.

use super::binary::Scalar;
use super::cell::{Cells, Pieces, SECOND_ORDER_SQUARE, SECOND_ORDER_TRIANGLE, SERENDIPITY};
use super::solid::Solid;
use super::stream::Stream;
use super::{Expected, Extra, Format, Oddity, Place, Read, ReadError};
use crate::order;

/// Whether a file begins as MSH does.
pub(super) fn is_header(bytes: &[u8]) -> bool {
    const STARTS: [&[u8]; 3] = [b"$MeshFormat", b"$Comments", b"$NOD"];
    STARTS.iter().any(|start| bytes.starts_with(start))
}

/// What an element is.
#[derive(Clone, Copy)]
enum Shape {
    /// Faces of so many of its nodes, the first.
    Faces(usize, Pieces),
    Solid(Solid),
    /// A point, a line, or of several parts.
    Other,
}

const TRIANGLE: Shape = Shape::Faces(3, &[&[0, 1, 2]]);
const QUADRILATERAL: Shape = Shape::Faces(4, &[&[0, 1, 2, 3]]);
const TETRAHEDRON: Shape = Shape::Solid(Solid::Tetrahedron);
const HEXAHEDRON: Shape = Shape::Solid(Solid::Hexahedron);
const WEDGE: Shape = Shape::Solid(Solid::Wedge);
const PYRAMID: Shape = Shape::Solid(Solid::Pyramid);

/// How many nodes an element of each of Gmsh's types has, from type 1, and what the first of them
/// make.
const ELEMENTS: [(usize, Shape); 38] = [
    (2, Shape::Other),
    (3, TRIANGLE),
    (4, QUADRILATERAL),
    (4, TETRAHEDRON),
    (8, HEXAHEDRON),
    (6, WEDGE),
    (5, PYRAMID),
    (3, Shape::Other),
    (6, Shape::Faces(6, SECOND_ORDER_TRIANGLE)),
    (9, Shape::Faces(9, SECOND_ORDER_SQUARE)),
    (10, TETRAHEDRON),
    (27, HEXAHEDRON),
    (18, WEDGE),
    (14, PYRAMID),
    (1, Shape::Other),
    (8, Shape::Faces(8, SERENDIPITY)),
    (20, HEXAHEDRON),
    (15, WEDGE),
    (13, PYRAMID),
    (9, TRIANGLE),
    (10, TRIANGLE),
    (12, TRIANGLE),
    (15, TRIANGLE),
    (15, TRIANGLE),
    (21, TRIANGLE),
    (4, Shape::Other),
    (5, Shape::Other),
    (6, Shape::Other),
    (20, TETRAHEDRON),
    (35, TETRAHEDRON),
    (56, TETRAHEDRON),
    // Of 32 and 33 the manual has none, of 34 and 35 neither.
    (0, Shape::Other),
    (0, Shape::Other),
    (0, Shape::Other),
    (0, Shape::Other),
    (16, QUADRILATERAL),
    (25, QUADRILATERAL),
    (36, QUADRILATERAL),
];

fn element(kind: u64) -> Option<(usize, Shape)> {
    let row = match kind {
        // Of third and fourth order.
        92 => (64, HEXAHEDRON),
        93 => (125, HEXAHEDRON),
        _ => *ELEMENTS.get(usize::try_from(kind.checked_sub(1)?).ok()?)?,
    };
    (row.0 > 0).then_some(row)
}

/// Which of the layouts a file has.
#[derive(Clone, Copy, PartialEq, Eq)]
enum Version {
    /// 1, without a header.
    One,
    /// 2 to 2.2.
    Two,
    /// 4.0, of blocks of nodes and of elements with their numbers.
    Four,
    /// 4.1, where the numbers of a block of nodes come before their places.
    FourOne,
}

/// The reader: the file, and the mesh so far.
struct Reader<'a> {
    stream: Stream<'a>,
    is_binary: bool,
    /// How sizes and numbers of nodes are written.
    size: Scalar,
    cells: Cells,
    /// Numbers of the nodes with their place in the mesh, in the order of numbers.
    nodes: Vec<(u64, u32)>,
}

/// Reads an MSH file.
pub(super) fn read(bytes: &[u8]) -> Result<Read, ReadError> {
    const SECTION: Expected = Expected::Keyword {
        word: "$MeshFormat, $Nodes, $Elements",
    };
    let mut reader = Reader {
        stream: Stream::new(Format::Msh, bytes.trim_ascii_start()),
        is_binary: false,
        size: Scalar::U64,
        cells: Cells::new(),
        nodes: Vec::new(),
    };
    let mut version = None;
    let (mut has_groups, mut has_data) = (false, false);
    while let Some(word) = reader.stream.try_word() {
        match (word, version) {
            (b"$MeshFormat", None) => version = Some(reader.format()?),
            (b"$NOD", None) => {
                version = Some(Version::One);
                reader.nodes_2()?;
            }
            (b"$ELM", Some(Version::One)) => reader.elements_1()?,
            (b"$Nodes", Some(Version::FourOne)) => reader.numbers(Reader::nodes_4_1)?,
            (b"$Nodes", Some(Version::Four)) => reader.numbers(Reader::nodes_4)?,
            (b"$Nodes", Some(_)) => reader.nodes_2()?,
            (b"$Elements", Some(Version::FourOne)) => reader.numbers(Reader::elements_4_1)?,
            (b"$Elements", Some(Version::Four)) => reader.numbers(Reader::elements_4)?,
            (b"$Elements", Some(_)) => reader.elements_2()?,
            _ if word.starts_with(b"$") => {
                has_groups |= word == b"$PhysicalNames";
                has_data |= word.ends_with(b"Data");
            }
            _ => return Err(reader.stream.error(Some(word), SECTION)),
        }
        let start = if version == Some(Version::One) {
            b"$END"
        } else {
            b"$End"
        };
        if !word.starts_with(start) {
            let end = [start, &word[1..]].concat();
            reader.stream.skip_past(&end);
        }
    }
    if version.is_none() {
        return Err(reader.stream.error(None, SECTION));
    }
    let mut read = reader.cells.finish(Format::Msh)?;
    let extra = [(Extra::Groups, has_groups), (Extra::Data, has_data)];
    read.warnings.extend(Oddity::left_out(&extra));
    Ok(read)
}

impl<'a> Reader<'a> {
    /// The version, once the header is read.
    fn format(&mut self) -> Result<Version, ReadError> {
        const NUMBER: Expected = Expected::Number;
        let version = match self.stream.word(NUMBER)? {
            b"2" | b"2.0" | b"2.1" | b"2.2" => Version::Two,
            b"4" | b"4.0" => Version::Four,
            b"4.1" => Version::FourOne,
            _ => {
                let what = "msh-version";
                return Err(ReadError::Unsupported { what });
            }
        };
        self.is_binary = self.stream.count_word(NUMBER)? == 1;
        self.size = match self.stream.count_word(NUMBER)? {
            4 => Scalar::U32,
            _ => Scalar::U64,
        };
        if self.is_binary {
            self.stream.line();
            // The number one tells the byte order.
            let is_big = self.stream.left().first() == Some(&0);
            self.stream.set_big_endian(is_big);
        }
        Ok(version)
    }

    /// Reads a section of numbers, which begin on the next line.
    fn numbers(
        &mut self,
        read: impl FnOnce(&mut Self) -> Result<(), ReadError>,
    ) -> Result<(), ReadError> {
        self.stream.line();
        self.stream.is_binary = self.is_binary;
        let done = read(self);
        self.stream.is_binary = false;
        done
    }

    fn count(&mut self, scalar: Scalar) -> Result<u64, ReadError> {
        self.stream.count(scalar, Expected::ElementCount)
    }

    fn node(&mut self, number: f64, scalar: Scalar, place: Place) -> Result<(), ReadError> {
        if number < 0.0 {
            let word = number.to_string();
            let found = Some(word.as_bytes());
            return Err(self.stream.error(found, Expected::VertexNumber));
        }
        let position = self.stream.point(scalar)?;
        let vertex = self.cells.assembly.n_vertices() as u32;
        self.cells.assembly.vertex(position, place)?;
        self.nodes.push((number as u64, vertex));
        Ok(())
    }

    /// Puts the nodes in the order of their numbers.
    fn sort(&mut self) -> Result<(), ReadError> {
        if !self.nodes.is_sorted() {
            order::sort(&mut self.nodes);
        }
        let mut pairs = self.nodes.windows(2);
        match pairs.find(|pair| pair[0].0 == pair[1].0) {
            Some(pair) => {
                let word = pair[0].0.to_string();
                let found = Some(word.as_bytes());
                Err(self.stream.error(found, Expected::VertexNumber))
            }
            None => Ok(()),
        }
    }

    fn corner(&self, number: f64, place: Place) -> Result<u32, ReadError> {
        let found = self
            .nodes
            .binary_search_by(|(known, _)| (*known as f64).total_cmp(&number));
        match found {
            Ok(at) => Ok(self.nodes[at].1),
            Err(_) => Err(ReadError::IndexOutOfRange {
                format: Format::Msh,
                place,
                index: number as i64,
                vertices: self.nodes.len(),
            }),
        }
    }

    /// The nodes of an element of a type that is known.
    fn element(
        &mut self,
        (nodes, shape): (usize, Shape),
        scalar: Scalar,
        place: Place,
    ) -> Result<(), ReadError> {
        let n = match shape {
            Shape::Faces(corners, _) => corners,
            Shape::Solid(solid) => solid.n_corners(),
            Shape::Other => 0,
        };
        let mut corners = [0; 9];
        for corner in &mut corners[..n] {
            let number = self.stream.value(scalar, Expected::VertexIndex)?;
            *corner = self.corner(number, place)?;
        }
        self.stream.skip(scalar, (nodes - n) as u64)?;
        match shape {
            Shape::Faces(_, pieces) => self.cells.pieces(pieces, &corners, place)?,
            Shape::Solid(solid) => self.cells.solid(solid, &corners[..n], place)?,
            Shape::Other => self.cells.skip(place),
        }
        Ok(())
    }

    fn unknown(&self, kind: u64) -> ReadError {
        let word = kind.to_string();
        let found = Some(word.as_bytes());
        self.stream.error(found, Expected::CellType)
    }

    /// Nodes of version 2: number, x, y, z.
    fn nodes_2(&mut self) -> Result<(), ReadError> {
        let count = self.stream.count_word(Expected::VertexCount)?;
        self.numbers(|reader| {
            let count = reader.stream.checked("vertices", count, 4, 28)?;
            reader.cells.assembly.reserve(count, 0);
            for _ in 0..count {
                let place = reader.stream.place();
                let number = reader.stream.value(Scalar::I32, Expected::VertexNumber)?;
                reader.node(number, Scalar::F64, place)?;
            }
            reader.sort()
        })
    }

    /// Nodes of version 4.1, in blocks: numbers, then positions, perhaps with parameters.
    fn nodes_4_1(&mut self) -> Result<(), ReadError> {
        let blocks = self.count(self.size)?;
        let count = self.count(self.size)?;
        // The smallest and the largest number.
        self.stream.skip(self.size, 2)?;
        self.stream.checked("vertices", count, 4, 32)?;
        let mut numbers = Vec::new();
        for _ in 0..blocks {
            let dimension = self.count(Scalar::I32)?;
            self.stream.skip(Scalar::I32, 1)?;
            let is_parametric = self.count(Scalar::I32)? == 1;
            let count = self.count(self.size)?;
            let count = self.stream.checked("vertices", count, 4, 32)?;
            numbers.clear();
            for _ in 0..count {
                numbers.push(self.stream.value(self.size, Expected::VertexNumber)?);
            }
            let parameters = if is_parametric { dimension.min(3) } else { 0 };
            for &number in &numbers {
                let place = self.stream.place();
                self.node(number, Scalar::F64, place)?;
                self.stream.skip(Scalar::F64, parameters)?;
            }
        }
        self.sort()
    }

    /// Nodes of version 4.0, in blocks: number, x, y, z, perhaps with parameters. Whatever the
    /// header says, numbers of nodes and elements have 32 bits.
    fn nodes_4(&mut self) -> Result<(), ReadError> {
        let blocks = self.count(self.size)?;
        let count = self.count(self.size)?;
        self.stream.checked("vertices", count, 4, 28)?;
        for _ in 0..blocks {
            self.stream.skip(Scalar::I32, 1)?;
            let dimension = self.count(Scalar::I32)?;
            let is_parametric = self.count(Scalar::I32)? == 1;
            let count = self.count(self.size)?;
            let parameters = if is_parametric { dimension.min(3) } else { 0 };
            for _ in 0..self.stream.checked("vertices", count, 4, 28)? {
                let place = self.stream.place();
                let number = self.stream.value(Scalar::I32, Expected::VertexNumber)?;
                self.node(number, Scalar::F64, place)?;
                self.stream.skip(Scalar::F64, parameters)?;
            }
        }
        self.sort()
    }

    /// Elements of version 1, a line each: number, type, two tags, how many nodes, nodes.
    fn elements_1(&mut self) -> Result<(), ReadError> {
        const INT: Scalar = Scalar::I32;
        let count = self.stream.count_word(Expected::FaceCount)?;
        for _ in 0..self.stream.checked("elements", count, 6, 24)? {
            self.stream.skip(INT, 1)?;
            let place = self.stream.place();
            let kind = self.stream.count(INT, Expected::CellType)?;
            let row = element(kind).ok_or_else(|| self.unknown(kind))?;
            self.stream.skip(INT, 3)?;
            self.element(row, INT, place)?;
        }
        Ok(())
    }

    /// Elements of version 2. In text a line each: number, type, how many tags, tags, nodes. In
    /// binary many of one type under one head.
    fn elements_2(&mut self) -> Result<(), ReadError> {
        const INT: Scalar = Scalar::I32;
        let count = self.stream.count_word(Expected::FaceCount)?;
        self.numbers(|reader| {
            let count = reader.stream.checked("elements", count, 4, 8)? as u64;
            let mut done = 0;
            while done < count {
                if !reader.is_binary {
                    reader.stream.skip(INT, 1)?;
                }
                let kind = reader.stream.count(INT, Expected::CellType)?;
                let row = element(kind).ok_or_else(|| reader.unknown(kind))?;
                let block = if reader.is_binary {
                    reader.count(INT)?
                } else {
                    1
                };
                let tags = reader.count(INT)?;
                // An empty block would never come to an end.
                for _ in 0..block.clamp(1, count - done) {
                    let place = reader.stream.place();
                    let before = u64::from(reader.is_binary);
                    reader.stream.skip(INT, before + tags)?;
                    reader.element(row, INT, place)?;
                    done += 1;
                }
            }
            Ok(())
        })
    }

    /// Elements of version 4.0: as of 4.1, but for what is counted before and the size of numbers.
    fn elements_4(&mut self) -> Result<(), ReadError> {
        let blocks = self.count(self.size)?;
        // How many in all.
        self.stream.skip(self.size, 1)?;
        self.blocks(blocks, Scalar::I32)
    }

    /// Elements of version 4.1.
    fn elements_4_1(&mut self) -> Result<(), ReadError> {
        let blocks = self.count(self.size)?;
        // How many in all, the smallest and the largest number.
        self.stream.skip(self.size, 3)?;
        self.blocks(blocks, self.size)
    }

    /// Blocks of elements of one type: number, nodes.
    fn blocks(&mut self, blocks: u64, scalar: Scalar) -> Result<(), ReadError> {
        for _ in 0..blocks {
            self.stream.skip(Scalar::I32, 2)?;
            let kind = self.stream.count(Scalar::I32, Expected::CellType)?;
            let row = element(kind).ok_or_else(|| self.unknown(kind))?;
            let count = self.count(self.size)?;
            let size = scalar.size() * (1 + row.0);
            for _ in 0..self.stream.checked("elements", count, 1 + row.0, size)? {
                let place = self.stream.place();
                self.stream.skip(scalar, 1)?;
                self.element(row, scalar, place)?;
            }
        }
        Ok(())
    }
}
