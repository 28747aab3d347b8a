//! Regular solids with triangular faces, circumradius 1.
//!
//! Subdivided linearly k times, each has the printed circle-angle energy `4π(2^k - 1)`: 188.496
//! for the icosahedron and k = 4, where figure 6 of Bobenko & Schröder
//! [BS05](crate::bibliography#bs05) begins.

use glam::DVec3;

use crate::soup::PolygonSoup;

/// The regular tetrahedron, corners on alternate corners of a cube.
pub fn tetrahedron() -> PolygonSoup {
    let corners = [(1, 1, 1), (1, -1, -1), (-1, 1, -1), (-1, -1, 1)];
    solid(
        corners.map(integers),
        &[[0, 1, 2], [0, 3, 1], [0, 2, 3], [1, 3, 2]],
    )
}

/// The regular octahedron, corners on the axes.
pub fn octahedron() -> PolygonSoup {
    let corners = [
        (1, 0, 0),
        (-1, 0, 0),
        (0, 1, 0),
        (0, -1, 0),
        (0, 0, 1),
        (0, 0, -1),
    ];
    let faces = [
        [0, 2, 4],
        [2, 1, 4],
        [1, 3, 4],
        [3, 0, 4],
        [2, 0, 5],
        [1, 2, 5],
        [3, 1, 5],
        [0, 3, 5],
    ];
    solid(corners.map(integers), &faces)
}

/// The regular icosahedron, corners on three golden rectangles.
pub fn icosahedron() -> PolygonSoup {
    let golden = (1.0 + 5_f64.sqrt()) / 2.0;
    let rectangle = [
        (-1.0, golden),
        (1.0, golden),
        (-1.0, -golden),
        (1.0, -golden),
    ];
    let xy = rectangle.map(|(s, l)| DVec3::new(s, l, 0.0));
    let yz = rectangle.map(|(s, l)| DVec3::new(0.0, s, l));
    let zx = rectangle.map(|(s, l)| DVec3::new(l, 0.0, s));
    let faces = [
        [0, 11, 5],
        [0, 5, 1],
        [0, 1, 7],
        [0, 7, 10],
        [0, 10, 11],
        [1, 5, 9],
        [5, 11, 4],
        [11, 10, 2],
        [10, 7, 6],
        [7, 1, 8],
        [3, 9, 4],
        [3, 4, 2],
        [3, 2, 6],
        [3, 6, 8],
        [3, 8, 9],
        [4, 9, 5],
        [2, 4, 11],
        [6, 2, 10],
        [8, 6, 7],
        [9, 8, 1],
    ];
    solid([xy, yz, zx].concat(), &faces)
}

fn integers((x, y, z): (i32, i32, i32)) -> DVec3 {
    DVec3::new(x.into(), y.into(), z.into())
}

fn solid(corners: impl Into<Vec<DVec3>>, faces: &[[u32; 3]]) -> PolygonSoup {
    let corners = corners.into().into_iter().map(DVec3::normalize).collect();
    PolygonSoup::from_faces(corners, faces)
}
