//! Elements of second order: the surface goes through all their nodes.

use crate::mesh::{cube, octahedron, plain};
use glam::DVec3;
use std::collections::HashMap;
use std::fmt::Write as _;
use umbilic::geometry::measure;
use umbilic::mesh::build;
use umbilic::soup::PolygonSoup;

/// An element of second order in the two formats, and what it is cut into.
struct Element {
    vtk: u8,
    gmsh: Option<u8>,
    has_centre: bool,
    faces: usize,
}

const fn element(vtk: u8, gmsh: Option<u8>, has_centre: bool, faces: usize) -> Element {
    Element {
        vtk,
        gmsh,
        has_centre,
        faces,
    }
}

const TRIANGLES: [Element; 4] = [
    element(22, Some(9), false, 4),
    element(34, None, true, 6),
    element(69, None, false, 4),
    element(36, None, false, 1),
];
const SQUARES: [Element; 4] = [
    element(23, Some(16), false, 5),
    element(28, Some(10), true, 4),
    element(70, None, true, 4),
    element(36, None, false, 1),
];

/// Nodes on the unit sphere, and those of each element: corners, middles of sides, centre.
fn nodes(soup: &PolygonSoup, has_centre: bool) -> (Vec<DVec3>, Vec<Vec<usize>>) {
    let mut nodes: Vec<DVec3> = soup.positions.iter().map(|p| p.normalize()).collect();
    let mut middles = HashMap::new();
    let mut elements = Vec::new();
    for face in soup.faces() {
        let mut element: Vec<usize> = face.iter().map(|&v| v as usize).collect();
        let corners = element.clone();
        for (k, &a) in corners.iter().enumerate() {
            let b = corners[(k + 1) % corners.len()];
            let middle = *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
                nodes.push((nodes[a] + nodes[b]).normalize());
                nodes.len() - 1
            });
            element.push(middle);
        }
        if has_centre {
            let sum: DVec3 = corners.iter().map(|&v| nodes[v]).sum();
            element.push(nodes.len());
            nodes.push(sum.normalize());
        }
        elements.push(element);
    }
    (nodes, elements)
}

fn words(numbers: impl Iterator<Item = usize>) -> String {
    numbers.map(|number| format!(" {number}")).collect()
}

fn vtk(nodes: &[DVec3], elements: &[Vec<usize>], kind: u8) -> String {
    let mut text = format!(
        "# vtk DataFile Version 2.0\n\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS {} double\n",
        nodes.len()
    );
    for p in nodes {
        let _ = writeln!(text, "{:?} {:?} {:?}", p.x, p.y, p.z);
    }
    let size: usize = elements.iter().map(|element| element.len() + 1).sum();
    let _ = writeln!(text, "CELLS {} {size}", elements.len());
    for element in elements {
        let _ = writeln!(text, "{}{}", element.len(), words(element.iter().copied()));
    }
    let _ = writeln!(text, "CELL_TYPES {}", elements.len());
    text + &format!("{kind}\n").repeat(elements.len())
}

fn msh(nodes: &[DVec3], elements: &[Vec<usize>], kind: u8) -> String {
    let mut text = format!(
        "$MeshFormat\n2.2 0 8\n$EndMeshFormat\n$Nodes\n{}\n",
        nodes.len()
    );
    for (k, p) in nodes.iter().enumerate() {
        let _ = writeln!(text, "{} {:?} {:?} {:?}", k + 1, p.x, p.y, p.z);
    }
    let _ = writeln!(text, "$EndNodes\n$Elements\n{}", elements.len());
    for (k, element) in elements.iter().enumerate() {
        let numbers = words(element.iter().map(|node| node + 1));
        let _ = writeln!(text, "{} {kind} 2 0 1{numbers}", k + 1);
    }
    text + "$EndElements\n"
}

#[test]
fn the_surface_goes_through_all_nodes() {
    for (soup, rows) in [(octahedron(), TRIANGLES), (cube(-0.5, 1.0), SQUARES)] {
        let corners = soup.faces().next().unwrap().len();
        for row in rows {
            let (nodes, elements) = nodes(&soup, row.has_centre);
            let mut files = vec![vtk(&nodes, &elements, row.vtk)];
            files.extend(row.gmsh.map(|kind| msh(&nodes, &elements, kind)));
            for text in files {
                let name = format!("{}, {corners} corners", row.vtk);
                let read = plain(text.as_bytes(), "");
                assert_eq!(read.positions, nodes, "{name}");
                assert_eq!(read.n_faces(), row.faces * elements.len(), "{name}");
                let built = build(&read).unwrap();
                assert_eq!(built.repairs, [], "{name}");
                assert!(built.mesh.is_closed() && built.mesh.is_oriented(), "{name}");
                assert_eq!(built.mesh.n_vertices(), nodes.len(), "{name}");
                // Every face is seen from outside.
                for face in read.faces() {
                    let (mut normal, mut middle) = (DVec3::ZERO, DVec3::ZERO);
                    for (&a, &b) in face.iter().zip(face.iter().cycle().skip(1)) {
                        normal += nodes[a as usize].cross(nodes[b as usize]);
                        middle += nodes[a as usize];
                    }
                    assert!(normal.dot(middle) > 0.0, "{name}: {face:?}");
                }
                let bare = build(&PolygonSoup {
                    positions: nodes[..soup.positions.len()].to_vec(),
                    ..soup.clone()
                });
                let bare = bare.unwrap();
                let volume = |built: &umbilic::mesh::Built| {
                    measure::volume(&built.mesh, &built.positions).unwrap()
                };
                assert!(volume(&built) > 1.2 * volume(&bare), "{name}");
            }
        }
    }
}

#[test]
fn elements_that_lack_nodes_and_those_of_higher_order_are_read_as_their_corners() {
    let text = "# vtk DataFile Version 2.0\n\nASCII\nDATASET UNSTRUCTURED_GRID\nPOINTS 4 double\n\
                0 0 0\n1 0 0\n1 1 0\n0 1 0\nCELLS 2 9\n3 0 1 2\n4 0 2 3 1\nCELL_TYPES 2\n22\n76\n";
    let read = umbilic::io::read(text.as_bytes(), "").unwrap();
    assert_eq!(
        read.soup.faces().collect::<Vec<_>>(),
        [[0, 1, 2], [0, 2, 3]]
    );
}
