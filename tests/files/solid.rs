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

/// Files of a format, one for each kind of cell.
pub(crate) fn files(format: Format) -> Vec<Vec<u8>> {
    let of = |kind: &Kind| match (format, kind.vtk, kind.msh) {
        (Format::Vtk, [types, ..], _) => Some(vtk(*types, &cells(kind)).into_bytes()),
        (Format::Msh, _, [types, ..]) => Some(msh(*types, &cells(kind), &[]).into_bytes()),
        _ => None,
    };
    KINDS.iter().filter_map(of).collect()
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
