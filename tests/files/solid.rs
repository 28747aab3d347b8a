//! Cells with a volume, of VTK and of Gmsh: the surface around a block of them.

use crate::mesh::oddities;
use std::fmt::Write as _;
use umbilic::io::{self, Format, Oddity, Place};
use umbilic::soup::PolygonSoup;

/// Cells along each axis of the block.
const SIZE: [usize; 3] = [3, 2, 2];

/// One kind of cell: its types in VTK and Gmsh, what it cuts a cube into, and how many faces that
/// makes of a side; 0 where not all sides are alike.
struct Kind {
    vtk: &'static [u8],
    msh: &'static [u8],
    cells: &'static [&'static [usize]],
    per_side: usize,
}

/// A cube's corners are numbered x + 2y + 4z, its centre is 8.
const KINDS: [Kind; 8] = [
    Kind {
        vtk: &[12],
        msh: &[5],
        cells: &[&[0, 1, 3, 2, 4, 5, 7, 6]],
        per_side: 1,
    },
    // The same seen in a mirror, as some programs write it.
    Kind {
        vtk: &[12],
        msh: &[5],
        cells: &[&[4, 5, 7, 6, 0, 1, 3, 2]],
        per_side: 1,
    },
    Kind {
        vtk: &[11],
        msh: &[],
        cells: &[&[0, 1, 2, 3, 4, 5, 6, 7]],
        per_side: 1,
    },
    // Around the diagonal from 0 to 7.
    Kind {
        vtk: &[10, 24],
        msh: &[4, 11],
        cells: &[
            &[0, 1, 3, 7],
            &[0, 3, 2, 7],
            &[0, 2, 6, 7],
            &[0, 6, 4, 7],
            &[0, 4, 5, 7],
            &[0, 5, 1, 7],
        ],
        per_side: 2,
    },
    Kind {
        vtk: &[14],
        msh: &[7],
        cells: &[
            &[0, 1, 3, 2, 8],
            &[4, 5, 7, 6, 8],
            &[0, 1, 5, 4, 8],
            &[2, 3, 7, 6, 8],
            &[0, 2, 6, 4, 8],
            &[1, 3, 7, 5, 8],
        ],
        per_side: 1,
    },
    // Wedges, two to a cube: the triangle that Gmsh has below VTK has above.
    Kind {
        vtk: &[13],
        msh: &[6],
        cells: &[&[0, 1, 3, 4, 5, 7], &[0, 3, 2, 4, 7, 6]],
        per_side: 0,
    },
    Kind {
        vtk: &[13],
        msh: &[6],
        cells: &[&[4, 5, 7, 0, 1, 3], &[4, 7, 6, 0, 3, 2]],
        per_side: 0,
    },
    // Hexahedra with an edge collapsed: wedges in truth.
    Kind {
        vtk: &[12],
        msh: &[5],
        cells: &[&[0, 1, 3, 3, 4, 5, 7, 7], &[0, 3, 2, 2, 4, 7, 6, 6]],
        per_side: 0,
    },
];

/// The nodes of the block: corners of cubes, then their centres.
fn nodes() -> Vec<[f64; 3]> {
    let [nx, ny, nz] = SIZE;
    let grid = |offset: f64, n: [usize; 3]| {
        (0..n[2]).flat_map(move |k| {
            (0..n[1])
                .flat_map(move |j| (0..n[0]).map(move |i| [i, j, k].map(|x| x as f64 + offset)))
        })
    };
    grid(0.0, [nx + 1, ny + 1, nz + 1])
        .chain(grid(0.5, SIZE))
        .collect()
}

/// The cells of the block.
fn cells(kind: &Kind) -> Vec<Vec<usize>> {
    let [nx, ny, nz] = SIZE;
    let corner = |i: usize, j: usize, k: usize| i + (nx + 1) * (j + (ny + 1) * k);
    let mut cells = Vec::new();
    for (k, j, i) in
        (0..nz).flat_map(|k| (0..ny).flat_map(move |j| (0..nx).map(move |i| (k, j, i))))
    {
        let centre = (nx + 1) * (ny + 1) * (nz + 1) + i + nx * (j + ny * k);
        let node = |c: usize| match c {
            8 => centre,
            _ => corner(i + (c & 1), j + (c >> 1 & 1), k + (c >> 2)),
        };
        cells.extend(
            kind.cells
                .iter()
                .map(|cell| cell.iter().map(|&c| node(c)).collect()),
        );
    }
    cells
}

/// Nodes that a tetrahedron of second order has beyond its corners; which, does not matter.
const FURTHER: usize = 6;

fn vtk(types: u8, cells: &[Vec<usize>]) -> String {
    let mut out = "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\n".to_owned();
    let nodes = nodes();
    let _ = writeln!(out, "POINTS {} double", nodes.len());
    for [x, y, z] in nodes {
        let _ = writeln!(out, "{x} {y} {z}");
    }
    let more = if types == 24 { FURTHER } else { 0 };
    let size: usize = cells.iter().map(|cell| 1 + cell.len() + more).sum();
    let _ = writeln!(out, "CELLS {} {size}", cells.len());
    for cell in cells {
        let _ = writeln!(
            out,
            "{} {}{}",
            cell.len() + more,
            list(cell, 0),
            " 0".repeat(more)
        );
    }
    let _ = writeln!(out, "CELL_TYPES {}", cells.len());
    for _ in cells {
        let _ = writeln!(out, "{types}");
    }
    out
}

fn msh(types: u8, cells: &[Vec<usize>], before: &[&str]) -> String {
    let mut out = "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n".to_owned();
    let nodes = nodes();
    let _ = writeln!(out, "{}", nodes.len());
    for (at, [x, y, z]) in nodes.into_iter().enumerate() {
        let _ = writeln!(out, "{} {x} {y} {z}", at + 1);
    }
    let _ = writeln!(out, "$EndNodes\n$Elements\n{}", cells.len() + before.len());
    for line in before {
        let _ = writeln!(out, "{line}");
    }
    let more = if types == 11 { FURTHER } else { 0 };
    for (at, cell) in cells.iter().enumerate() {
        let _ = writeln!(
            out,
            "{} {types} 2 0 0 {}{}",
            at + 9,
            list(cell, 1),
            " 1".repeat(more)
        );
    }
    out + "$EndElements\n"
}

/// Cells that list their faces, and hexahedra, which list their corners.
struct Polyhedra {
    nodes: Vec<[f64; 3]>,
    cells: Vec<(u8, Vec<Vec<usize>>)>,
}

/// The block, of polyhedra alone or with hexahedra in between.
fn listed_block(is_mixed: bool) -> Polyhedra {
    const CUBE: [[usize; 4]; 6] = [
        [0, 1, 2, 3],
        [4, 5, 6, 7],
        [0, 1, 5, 4],
        [1, 2, 6, 5],
        [2, 3, 7, 6],
        [3, 0, 4, 7],
    ];
    let faces = |cell: &Vec<usize>| CUBE.map(|face| face.map(|c| cell[c]).to_vec()).to_vec();
    let cells = cells(&KINDS[0]).into_iter().enumerate();
    let cells = cells.map(|(at, cell)| match is_mixed && at % 2 == 1 {
        true => (12, vec![cell]),
        false => (42, faces(&cell)),
    });
    Polyhedra {
        nodes: nodes(),
        cells: cells.collect(),
    }
}

/// Two prisms of six sides, one on the other.
fn prisms() -> Polyhedra {
    let angle = |k: usize| std::f64::consts::PI / 3.0 * k as f64;
    let node = |layer: usize, k: usize| [angle(k).cos(), angle(k).sin(), layer as f64];
    let ring = |layer: usize| (6 * layer..6 * layer + 6).collect::<Vec<_>>();
    let side = |layer: usize, k: usize| {
        let [a, b] = [k, (k + 1) % 6].map(|k| 6 * layer + k);
        vec![a, b, b + 6, a + 6]
    };
    let prism = |layer| {
        let ends = [ring(layer), ring(layer + 1)];
        let faces = ends.into_iter().chain((0..6).map(|k| side(layer, k)));
        (42, faces.collect())
    };
    Polyhedra {
        nodes: (0..3)
            .flat_map(|layer| (0..6).map(move |k| node(layer, k)))
            .collect(),
        cells: vec![prism(0), prism(1)],
    }
}

/// A prism of eight sides, each end cut in two faces which share their first vertex and their last.
fn cut_prism() -> Polyhedra {
    const AROUND: [usize; 8] = [0, 1, 2, 3, 7, 4, 5, 6];
    let node = |layer: usize, v: usize| {
        let at = AROUND
            .iter()
            .position(|&other| other == v)
            .expect("one of eight");
        let angle = std::f64::consts::PI / 4.0 * at as f64;
        [angle.cos(), angle.sin(), layer as f64]
    };
    let halves = [vec![0, 1, 2, 3, 7], vec![7, 4, 5, 6, 0]];
    let above = |face: &Vec<usize>| face.iter().map(|v| v + 8).collect();
    let side = |k: usize| {
        let [a, b] = [AROUND[k], AROUND[(k + 1) % 8]];
        vec![a, b, b + 8, a + 8]
    };
    let tops: Vec<Vec<usize>> = halves.iter().map(above).collect();
    let faces = halves.into_iter().chain(tops).chain((0..8).map(side));
    Polyhedra {
        nodes: (0..16).map(|v| node(v / 8, v % 8)).collect(),
        cells: vec![(42, faces.collect())],
    }
}

impl Polyhedra {
    /// The faces of a cell as VTK lists them; of a hexahedron its corners.
    fn numbers((types, faces): &(u8, Vec<Vec<usize>>)) -> Vec<usize> {
        match types {
            42 => std::iter::once(faces.len())
                .chain(faces.iter().flat_map(|f| [&[f.len()], &f[..]].concat()))
                .collect(),
            _ => faces[0].clone(),
        }
    }

    fn types(&self) -> Vec<usize> {
        self.cells.iter().map(|cell| usize::from(cell.0)).collect()
    }

    fn points(&self) -> String {
        let words = self.nodes.iter().flatten().map(ToString::to_string);
        words.collect::<Vec<_>>().join(" ")
    }

    fn legacy(&self) -> String {
        let mut out =
            "# vtk DataFile Version 3.0\nx\nASCII\nDATASET UNSTRUCTURED_GRID\n".to_owned();
        let _ = writeln!(out, "POINTS {} double\n{}", self.nodes.len(), self.points());
        let lists: Vec<_> = self.cells.iter().map(Self::numbers).collect();
        let size: usize = lists.iter().map(|list| 1 + list.len()).sum();
        let _ = writeln!(out, "CELLS {} {size}", lists.len());
        for numbers in &lists {
            let _ = writeln!(out, "{} {}", numbers.len(), list(numbers, 0));
        }
        let _ = writeln!(
            out,
            "CELL_TYPES {}\n{}",
            lists.len(),
            list(&self.types(), 0)
        );
        out
    }

    /// In two pieces that are the same, if wanted.
    fn xml(&self, pieces: usize) -> String {
        let (mut connectivity, mut offsets) = (Vec::new(), Vec::new());
        let (mut faces, mut ends) = (Vec::new(), Vec::new());
        for cell in &self.cells {
            let mut corners: Vec<usize> = cell.1.concat();
            if cell.0 == 42 {
                corners.sort_unstable();
                corners.dedup();
                faces.extend(Self::numbers(cell));
                ends.push(faces.len().to_string());
            } else {
                ends.push("-1".into());
            }
            connectivity.extend(corners);
            offsets.push(connectivity.len());
        }
        let array = |name: &str, numbers: &str| {
            format!("<DataArray type='Int64' Name='{name}' format='ascii'>{numbers}</DataArray>")
        };
        let points = format!(
            "<Points><DataArray type='Float64' NumberOfComponents='3' format='ascii'>{}</DataArray></Points>",
            self.points()
        );
        let cells = [
            array("connectivity", &list(&connectivity, 0)),
            array("offsets", &list(&offsets, 0)),
            array("types", &list(&self.types(), 0)),
            array("faces", &list(&faces, 0)),
            array("faceoffsets", &ends.join(" ")),
        ];
        let cells = cells.concat();
        let piece = format!("<Piece>{points}<Cells>{cells}</Cells></Piece>").repeat(pieces);
        format!(
            "<VTKFile type='UnstructuredGrid'><UnstructuredGrid>{piece}</UnstructuredGrid></VTKFile>"
        )
    }
}

/// Files of a format, one for each kind of cell.
pub(crate) fn files(format: Format) -> Vec<Vec<u8>> {
    let of = |kind: &Kind| match (format, kind.vtk, kind.msh) {
        (Format::Vtk, [types, ..], _) => Some(vtk(*types, &cells(kind)).into_bytes()),
        (Format::Msh, _, [types, ..]) => Some(msh(*types, &cells(kind), &[]).into_bytes()),
        _ => None,
    };
    let listed = [listed_block(false), listed_block(true), prisms()];
    let listed = listed.iter().filter_map(|some| match format {
        Format::Vtk => Some(some.legacy().into_bytes()),
        Format::Vtp => Some(some.xml(2).into_bytes()),
        _ => None,
    });
    KINDS.iter().filter_map(of).chain(listed).collect()
}

fn list(cell: &[usize], first: usize) -> String {
    let words: Vec<String> = cell.iter().map(|node| (node + first).to_string()).collect();
    words.join(" ")
}

fn volume_and_area(soup: &PolygonSoup) -> (f64, f64) {
    let mut sums = (0.0, 0.0);
    for face in soup.faces() {
        let at = |i: usize| soup.positions[face[i] as usize];
        for i in 2..face.len() {
            let cross = (at(i - 1) - at(0)).cross(at(i) - at(0));
            sums.0 += at(0).dot(cross) / 6.0;
            sums.1 += cross.length() / 2.0;
        }
    }
    sums
}

fn check(text: &str, kind: &Kind, what: &str) {
    let read = io::read(text.as_bytes(), "").unwrap();
    let [nx, ny, nz] = SIZE;
    let sides = 2 * (nx * ny + ny * nz + nz * nx);
    if kind.per_side > 0 {
        assert_eq!(read.soup.n_faces(), sides * kind.per_side, "{what}");
    }
    let (volume, area) = volume_and_area(&read.soup);
    assert!(
        (volume - (nx * ny * nz) as f64).abs() < 1e-12,
        "{what}: volume {volume}"
    );
    assert!((area - sides as f64).abs() < 1e-12, "{what}: area {area}");
    let count = cells(kind).len();
    assert_eq!(read.warnings, [Oddity::SolidCells { count }], "{what}");
}

#[test]
fn of_solid_cells_alone_their_surface_is_read() {
    for kind in &KINDS {
        let cells = cells(kind);
        for &types in kind.vtk {
            check(&vtk(types, &cells), kind, &format!("VTK {types}"));
        }
        for &types in kind.msh {
            check(&msh(types, &cells, &[]), kind, &format!("MSH {types}"));
        }
    }
}

#[test]
fn a_file_that_has_faces_is_read_as_these() {
    let kind = &KINDS[0];
    let cells = cells(kind);
    for before in [
        &["1 2 2 0 0 1 2 6"][..],
        &["1 15 2 0 0 1", "2 2 2 0 0 1 2 6"],
    ] {
        let text = msh(5, &cells, before);
        let read = io::read(text.as_bytes(), "").unwrap();
        assert_eq!(read.soup.faces().collect::<Vec<_>>(), [[0, 1, 5]]);
        let others = before.len() - 1;
        let nodes = nodes().len();
        // The header takes three lines, the nodes three besides their own, the elements two.
        let first = Place::Line {
            line: nodes + 10 - others,
        };
        let count = cells.len() + others;
        assert_eq!(
            oddities(text.as_bytes()),
            [Oddity::OtherCells { count, first }],
        );
    }
}

#[test]
fn of_polyhedra_their_faces_are_read_and_hexahedra_fit_beside_them() {
    let prism = 1.5 * 3f64.sqrt();
    let octagon = 8f64.sqrt();
    let around = 16.0 * (std::f64::consts::PI / 8.0).sin();
    for (some, faces, volume, area) in [
        (listed_block(false), 32, 12.0, 32.0),
        (listed_block(true), 32, 12.0, 32.0),
        (prisms(), 14, 2.0 * prism, 2.0 * prism + 12.0),
        (cut_prism(), 12, octagon, 2.0 * octagon + around),
    ] {
        for (text, pieces) in [(some.legacy(), 1), (some.xml(1), 1), (some.xml(2), 2)] {
            let read = io::read(text.as_bytes(), "").unwrap();
            assert_eq!(read.soup.n_faces(), pieces * faces);
            let found = volume_and_area(&read.soup);
            let n = pieces as f64;
            assert!((found.0 - n * volume).abs() < 1e-12, "volume {}", found.0);
            assert!((found.1 - n * area).abs() < 1e-12, "area {}", found.1);
            let count = pieces * some.cells.len();
            assert_eq!(read.warnings, [Oddity::SolidCells { count }]);
        }
    }
}

#[test]
fn polyhedra_that_name_no_vertex_are_refused_and_those_that_end_early_are_none() {
    let whole = prisms();
    let mut wrong = prisms();
    wrong.cells[1].1[0][2] = 18;
    for text in [wrong.legacy(), wrong.xml(1)] {
        let error = io::read(text.as_bytes(), "").unwrap_err();
        assert!(error.to_string().contains("18"), "{error}");
    }
    // In the second piece −1 would be a vertex of the first.
    let text = whole.xml(2);
    let at = text.rfind("'faces' format='ascii'>8 6 0 ").expect("faces");
    let text = format!(
        "{}{}",
        &text[..at],
        text[at..].replacen(">8 6 0 ", ">8 6 -1 ", 1)
    );
    let error = io::read(text.as_bytes(), "").unwrap_err();
    assert!(error.to_string().contains("-1"), "{error}");
    // More faces than there are.
    let text = whole.legacy().replace(" 8 6 6 7", " 9 6 6 7");
    assert_ne!(text, whole.legacy());
    let read = io::read(text.as_bytes(), "").unwrap();
    assert_eq!(read.soup.n_faces(), 8);
}
