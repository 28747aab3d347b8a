//! MSH, the format of Gmsh.

use crate::mesh::{cube, is_refused_wherever_it_ends, oddities, ordered, refusal};
use umbilic::io::{Extra, Oddity, Place, ReadError};
use umbilic::soup::PolygonSoup;

/// How a file is written.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Style {
    pub(crate) binary: bool,
    pub(crate) big: bool,
    /// 1, 2.2, 4.0 or 4.1; the first knows no binary.
    pub(crate) version: &'static str,
    /// How many bytes sizes have in version 4.
    pub(crate) size: usize,
    /// Numbers of nodes: the first, and the step to the next.
    pub(crate) numbers: (u64, u64),
    /// Nodes with parameters, in version 4.
    pub(crate) parametric: bool,
    pub(crate) line_end: &'static str,
}

pub(crate) const PLAIN: Style = Style {
    binary: false,
    big: false,
    version: "4.1",
    size: 8,
    numbers: (1, 1),
    parametric: false,
    line_end: "\n",
};

struct Writer {
    out: Vec<u8>,
    style: Style,
}

impl Writer {
    fn line(&mut self, text: &str) {
        self.out
            .extend(text.bytes().chain(self.style.line_end.bytes()));
    }

    fn integer(&mut self, number: u64, size: usize) {
        let Style { binary, big, .. } = self.style;
        match (binary, size) {
            (true, 8) => self.out.extend(ordered(number.to_le_bytes(), big)),
            (true, _) => self.out.extend(ordered((number as u32).to_le_bytes(), big)),
            _ => self.out.extend(format!("{number} ").bytes()),
        }
    }

    fn float(&mut self, x: f64) {
        let Style { binary, big, .. } = self.style;
        if binary {
            self.out.extend(ordered(x.to_le_bytes(), big));
        } else {
            self.out.extend(format!("{x:?} ").bytes());
        }
    }

    /// The end of a line, in text.
    fn end(&mut self) {
        if !self.style.binary {
            self.line("");
        }
    }
}

pub(crate) fn file(soup: &PolygonSoup, style: Style) -> Vec<u8> {
    let mut w = Writer {
        out: Vec::new(),
        style,
    };
    let (first, step) = style.numbers;
    let number = |vertex: u32| first + step * u64::from(vertex);
    let is_four = style.version.starts_with('4');
    let places_apart = style.version == "4.1";
    // What a node or an element is called by has the size of a size in version 4.1 alone.
    let name = if places_apart { style.size } else { 4 };
    if style.version != "1" {
        w.line("$MeshFormat");
        let binary = u8::from(style.binary);
        w.line(&format!("{} {binary} {}", style.version, style.size));
        if style.binary {
            w.integer(1, 4);
            w.line("");
        }
        w.line("$EndMeshFormat");
    }
    let sections = match style.version {
        "1" => ["$NOD", "$ENDNOD", "$ELM", "$ENDELM"],
        _ => ["$Nodes", "$EndNodes", "$Elements", "$EndElements"],
    };
    if style.version != "1" {
        w.line("$Entities");
        w.line("$Nodes is no section here");
        w.line("$EndEntities");
    }
    w.line(sections[0]);
    let count = soup.positions.len() as u64;
    if is_four {
        let range = [first, number(count as u32 - 1)];
        let head = [2, count]
            .into_iter()
            .chain(places_apart.then_some(range).into_iter().flatten());
        head.for_each(|n| w.integer(n, style.size));
        w.end();
        let half = count as usize / 2;
        for (block, from) in [
            (&soup.positions[..half], 0),
            (&soup.positions[half..], half),
        ] {
            // Dimension and entity, in 4.0 the other way round.
            let [a, b] = if places_apart { [2, 1] } else { [1, 2] };
            for n in [a, b, u64::from(style.parametric)] {
                w.integer(n, 4);
            }
            w.integer(block.len() as u64, style.size);
            w.end();
            let names = (from..from + block.len()).map(|k| number(k as u32));
            for n in names.clone().filter(|_| places_apart) {
                w.integer(n, name);
                w.end();
            }
            for (n, p) in names.zip(block) {
                if !places_apart {
                    w.integer(n, name);
                }
                p.to_array().into_iter().for_each(|x| w.float(x));
                if style.parametric {
                    w.float(0.25);
                    w.float(0.5);
                }
                w.end();
            }
        }
    } else {
        w.line(&count.to_string());
        for (k, p) in (0..).zip(&soup.positions) {
            w.integer(number(k), name);
            p.to_array().into_iter().for_each(|x| w.float(x));
            w.end();
        }
    }
    if style.binary {
        w.line("");
    }
    w.line(sections[1]);
    w.line(sections[2]);
    let faces = soup.n_faces() as u64;
    let kind = |face: &[u32]| face.len() as u64 - 1;
    if is_four {
        let head: &[u64] = if places_apart {
            &[faces, faces, 1, faces]
        } else {
            &[faces, faces]
        };
        head.iter().for_each(|n| w.integer(*n, style.size));
        w.end();
        for (k, face) in (1..).zip(soup.faces()) {
            for n in [2, 1, kind(face)] {
                w.integer(n, 4);
            }
            w.integer(1, style.size);
            w.end();
            w.integer(k, name);
            face.iter().for_each(|v| w.integer(number(*v), name));
            w.end();
        }
    } else {
        w.line(&faces.to_string());
        for (k, face) in (1..).zip(soup.faces()) {
            let corners = face.len() as u64;
            let head = match (style.version, style.binary) {
                ("1", _) => vec![k, kind(face), 7, 9, corners],
                (_, true) => vec![kind(face), 1, 2, k, 7, 9],
                (_, false) => vec![k, kind(face), 2, 7, 9],
            };
            head.into_iter().for_each(|n| w.integer(n, name));
            face.iter().for_each(|v| w.integer(number(*v), name));
            w.end();
        }
    }
    if style.binary {
        w.line("");
    }
    w.line(sections[3]);
    w.out
}

pub(crate) fn variants() -> Vec<Style> {
    let mut all = Vec::new();
    for version in ["1", "2.2", "4.0", "4.1"] {
        let is_four = version.starts_with('4');
        for binary in [false, true]
            .into_iter()
            .filter(|binary| version != "1" || !binary)
        {
            for (big, size) in [(false, 8), (true, 8), (false, 4), (true, 4)] {
                for (numbers, parametric) in [((1, 1), false), ((40, 3), is_four), ((0, 1), false)]
                {
                    all.push(Style {
                        version,
                        binary,
                        big,
                        size,
                        numbers,
                        parametric,
                        line_end: "\n",
                    });
                }
            }
        }
        for line_end in ["\r\n", "\r", " \n \n"] {
            all.push(Style {
                line_end,
                version,
                ..PLAIN
            });
        }
    }
    all
}

#[test]
fn every_variant_reads_as_the_mesh_it_was_written_of() {
    let soup = cube(0.0, 1.0);
    for style in variants() {
        let bytes = file(&soup, style);
        let read = umbilic::io::read(&bytes, "a.msh");
        assert_eq!(read.map(|read| read.soup), Ok(soup.clone()), "{style:?}");
    }
}

#[test]
fn elements_of_no_surface_are_counted_and_higher_order_is_cut() {
    let text = "$Comments\nv 1 2 3\n$EndComments\n$MeshFormat\n2.2 0 8\n$EndMeshFormat\n\
                $PhysicalNames\n1\n2 1 \"a\"\n$EndPhysicalNames\n$Nodes\n6\n6 0 0 0\n5 1 0 0\n\
                4 0 1 0\n3 .5 0 0\n2 .5 .5 0\n1 0 .5 0\n$EndNodes\n$Elements\n4\n1 15 0 6\n\
                2 1 2 0 0 6 5\n3 9 2 0 0 6 5 4 3 2 1\n4 4 2 0 0 6 5 4 3\n$EndElements\n\
                $NodeData\n1\n\"x\"\n$EndNodeData\n";
    let read = umbilic::io::read(text.as_bytes(), "").unwrap();
    assert_eq!(
        read.soup.faces().collect::<Vec<_>>(),
        [[0, 3, 5], [3, 1, 4], [5, 4, 2], [3, 4, 5]]
    );
    assert_eq!(
        oddities(text.as_bytes()),
        [
            Oddity::OtherCells {
                count: 3,
                first: Place::Line { line: 22 }
            },
            Oddity::LeftOut {
                what: vec![Extra::Groups, Extra::Data]
            }
        ]
    );
}

#[test]
fn damage_is_named_where_it_is() {
    let soup = cube(0.0, 1.0);
    let version = "2.2";
    let text = String::from_utf8(file(&soup, Style { version, ..PLAIN })).unwrap();
    for (from, to, line) in [
        ("1 3 2 7 9 1 3 4 2", "1 3 2 7 9 1 3 4 9", 20),
        ("1 3 2 7 9 1 3 4 2", "1 3 2 7 9 1 3 4 x", 20),
        ("1 3 2 7 9 1 3 4 2", "1 77 2 7 9 1 3 4 2", 20),
        ("1 0.0 0.0 0.0", "2 0.0 0.0 0.0", 16),
        ("1 0.0 0.0 0.0", "1 0,5 0.0 0.0", 9),
        ("$Nodes\n8", "$Nodes\n80000", 9),
    ] {
        assert!(text.contains(from), "{from}");
        let detail = refusal(text.replacen(from, to, 1).as_bytes()).detail();
        assert_eq!(detail.first(), Some(&("line", f64::from(line))), "{to}");
    }
    let what = "msh-version";
    for version in ["5 0 8", "1 0 8", "3 0 8"] {
        let other = text.replace("2.2 0 8", version);
        assert_eq!(refusal(other.as_bytes()), ReadError::Unsupported { what });
    }
    for binary in [false, true] {
        let bytes = file(&soup, Style { binary, ..PLAIN });
        // Up to the last number.
        let end = bytes.len() - "\n$EndElements\n".len() - 3;
        is_refused_wherever_it_ends(&bytes, 1, end);
    }
}
