//! Legacy VTK.

use crate::mesh::{
    cube, is_refused_wherever_it_ends, octahedron, oddities, ordered, plain, refusal,
};
use std::fmt::Write as _;
use umbilic::io::{Extra, Oddity, Place, ReadError};
use umbilic::soup::PolygonSoup;

/// How a file is written.
#[derive(Clone, Copy)]
pub(crate) struct Style {
    pub(crate) binary: bool,
    /// Offsets and connectivity apart, as from version 5 on.
    pub(crate) offsets: bool,
    /// An unstructured grid, not polygonal data.
    pub(crate) grid: bool,
    pub(crate) double: bool,
    pub(crate) line_end: &'static str,
    /// What newer programs write between the parts.
    pub(crate) extras: bool,
}

pub(crate) const PLAIN: Style = Style {
    binary: false,
    offsets: false,
    grid: false,
    double: true,
    line_end: "\n",
    extras: false,
};

struct Writer {
    out: Vec<u8>,
    binary: bool,
    long: bool,
    end: &'static str,
}

impl Writer {
    fn line(&mut self, text: &str) {
        self.out.extend(text.bytes().chain(self.end.bytes()));
    }

    fn integers(&mut self, numbers: &[u32]) {
        for number in numbers {
            match (self.binary, self.long) {
                (true, true) => self.out.extend(u64::from(*number).to_be_bytes()),
                (true, false) => self.out.extend(number.to_be_bytes()),
                _ => self.out.extend(format!("{number} ").bytes()),
            }
        }
        self.line("");
    }
}

pub(crate) fn file(soup: &PolygonSoup, style: Style) -> Vec<u8> {
    let mut w = Writer {
        out: Vec::new(),
        binary: style.binary,
        long: style.offsets,
        end: style.line_end,
    };
    w.line(&format!(
        "# vtk DataFile Version {}.0",
        if style.offsets { 5 } else { 3 }
    ));
    w.line("a title: POINTS 7 float");
    w.line(if style.binary { "BINARY" } else { "ASCII" });
    w.line(&format!(
        "DATASET {}",
        if style.grid {
            "UNSTRUCTURED_GRID"
        } else {
            "POLYDATA"
        }
    ));
    if style.extras {
        w.line("FIELD FieldData 1");
        w.line("TIME 1 1 int");
        w.long = false;
        w.integers(&[7]);
        w.long = style.offsets;
    }
    let kind = if style.double { "double" } else { "float" };
    w.line(&format!("POINTS {} {kind}", soup.positions.len()));
    for x in soup.positions.iter().flat_map(|p| p.to_array()) {
        match (style.binary, style.double) {
            (true, true) => w.out.extend(ordered(x.to_le_bytes(), true)),
            (true, false) => w.out.extend(ordered((x as f32).to_le_bytes(), true)),
            _ => w.out.extend(format!("{x:?} ").bytes()),
        }
    }
    w.line("");
    if style.extras {
        w.line("METADATA");
        w.line("INFORMATION 1");
        w.line("NAME POLYGONS LOCATION vtkDataArray");
        w.line("");
    }
    let section = if style.grid { "CELLS" } else { "POLYGONS" };
    let (faces, corners) = (soup.n_faces(), soup.corners.len());
    if style.offsets {
        w.line(&format!("{section} {} {corners}", faces + 1));
        w.line("OFFSETS vtktypeint64");
        w.integers(&soup.face_starts);
        w.line("CONNECTIVITY vtktypeint64");
        w.integers(&soup.corners);
    } else {
        w.line(&format!("{section} {faces} {}", faces + corners));
        let listed = |face: &[u32]| [&[face.len() as u32], face].concat();
        let all: Vec<u32> = soup.faces().flat_map(listed).collect();
        w.integers(&all);
    }
    if style.grid {
        w.line(&format!("CELL_TYPES {faces}"));
        w.long = false;
        let kind = |face: &[u32]| [5, 9, 7][(face.len() - 3).min(2)];
        w.integers(&soup.faces().map(kind).collect::<Vec<_>>());
    }
    w.out
}

/// Every variant with its name.
pub(crate) fn variants() -> Vec<(String, Style)> {
    let mut all = Vec::new();
    for bits in 0..32_u32 {
        let on = |k: u32| bits >> k & 1 == 1;
        let style = Style {
            binary: on(0),
            offsets: on(1),
            grid: on(2),
            double: on(3),
            extras: on(4),
            line_end: "\n",
        };
        all.push((format!("variant {bits:05b}"), style));
    }
    for (name, line_end) in [("CR LF", "\r\n"), ("CR", "\r"), ("blanks", " \t\n")] {
        all.push((name.into(), Style { line_end, ..PLAIN }));
    }
    all
}

#[test]
fn every_variant_reads_as_the_mesh_it_was_written_of() {
    let soup = cube(0.0, 1.0);
    for (name, style) in variants() {
        let bytes = file(&soup, style);
        let read = umbilic::io::read(&bytes, "a.vtk").unwrap_or_else(|e| panic!("{name}: {e}"));
        assert_eq!(read.soup, soup, "{name}");
        let left_out = Oddity::LeftOut {
            what: vec![Extra::Data],
        };
        let expected = if style.extras { vec![left_out] } else { vec![] };
        assert_eq!(read.warnings, expected, "{name}");
    }
}

#[test]
fn cells_that_are_no_faces_are_counted_and_others_are_cut() {
    let mut text = String::from(
        "# vtk DataFile Version 2.0\n\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 6 float\n",
    );
    for k in 0..6 {
        let _ = writeln!(text, "{} {} 0", k / 2, k % 2);
    }
    text +=
        "CELLS 8 40\n1 0 2 0 1 3 0 2 1 4 0 2 1 3 4 0 1 2 4 5 0 2 4 1 3\n6 0 2 1 3 4 5 4 0 1 2 4\n";
    // A point, a line, a triangle, a pixel, a tetrahedron, a strip, a triangle of second order,
    // nothing.
    text += "CELL_TYPES 8\n1 3 5 8 10 6 22 0\nPOINT_DATA 6\nanything";
    let read = umbilic::io::read(text.as_bytes(), "").unwrap();
    let faces: Vec<&[u32]> = read.soup.faces().collect();
    assert_eq!(
        faces,
        [
            &[0, 2, 1][..],
            &[0, 2, 3, 1],
            &[0, 2, 4],
            &[4, 2, 1],
            &[4, 1, 3],
            &[0, 3, 5],
            &[3, 2, 4],
            &[5, 4, 1],
            &[3, 4, 5],
        ]
    );
    let Oddity::OtherCells { count: 3, .. } = read.warnings[0] else {
        panic!("{:?}", read.warnings);
    };
}

#[test]
fn strips_and_lines_of_polygonal_data() {
    let text = "# vtk DataFile Version 4.2\nx\nASCII\nDATASET POLYDATA\nPOINTS 4 float\n\
                0 0 0 1 0 0 0 1 0 1 1 0\nLINES 1 3\n2 0 1\nTRIANGLE_STRIPS 1 5\n4 0 1 2 3\n";
    assert_eq!(
        oddities(text.as_bytes()),
        [Oddity::OtherCells {
            count: 1,
            first: Place::Line { line: 8 }
        }]
    );
    let cube_of_strips = octahedron();
    assert_eq!(plain(&file(&cube_of_strips, PLAIN), "").n_faces(), 8);
}

#[test]
fn damage_is_named_where_it_is() {
    let soup = cube(0.0, 1.0);
    let text = String::from_utf8(file(&soup, PLAIN)).unwrap();
    for (from, to, line) in [
        ("ASCII", "TEXT", 3),
        ("POINTS 8", "POINTS x", 5),
        ("POINTS 8", "POINTS 80000", 6),
        ("double", "complex", 5),
        ("POLYGONS 6", "POLYGON 6", 7),
        ("4 0 2 3 1", "4 0 2 3 8", 8),
        ("4 0 2 3 1", "4 0 2 3 -1", 8),
        ("4 0 2 3 1", "9999 0 2 3 1", 8),
        ("4 0 2 3 1", "4 0 2 3 x", 8),
    ] {
        assert!(text.contains(from), "{from}");
        // A title may say what it likes.
        let at = text.rfind(from).unwrap();
        let damaged = text[..at].to_owned() + to + &text[at + from.len()..];
        let detail = refusal(damaged.as_bytes()).detail();
        assert_eq!(detail.first(), Some(&("line", f64::from(line))), "{to}");
    }
    let grid = text.replace("POLYDATA", "STRUCTURED_GRID");
    let what = "vtk-data-set";
    assert_eq!(refusal(grid.as_bytes()), ReadError::Unsupported { what });
    for binary in [false, true] {
        let bytes = file(&soup, Style { binary, ..PLAIN });
        // Up to the last number.
        is_refused_wherever_it_ends(&bytes, 1, bytes.len() - 3);
    }
}
