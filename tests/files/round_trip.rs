//! What is written reads back as the same mesh, near and far, small and large.

use glam::DVec3;
use umbilic::io::{self, Format, Loss, Oddity};
use umbilic::soup::PolygonSoup;

/// A torus of quadrilaterals whose coordinates need all their digits.
pub(crate) fn torus(origin: f64, size: f64) -> PolygonSoup {
    const N: [u32; 2] = [24, 12];
    let angle = |k: u32, n: u32| f64::from(k) / f64::from(n) * std::f64::consts::TAU;
    let mut soup = PolygonSoup::default();
    for i in 0..N[0] {
        for j in 0..N[1] {
            let (u, v) = (angle(i, N[0]), angle(j, N[1]));
            let radius = 1.0 + 0.4 * v.cos() + 0.05 * (3.0 * u).sin();
            let p = DVec3::new(radius * u.cos(), radius * u.sin(), 0.4 * v.sin());
            soup.positions
                .push(DVec3::new(0.1, 1.0, -0.3) * origin + p * size);
        }
    }
    for i in 0..N[0] {
        for j in 0..N[1] {
            let at = |i: u32, j: u32| i % N[0] * N[1] + j % N[1];
            soup.push_face(&[at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)]);
        }
    }
    soup
}

/// Largest distance of corners, triangle after triangle.
fn distance(a: &PolygonSoup, b: &PolygonSoup, shift: DVec3) -> f64 {
    let corners = |soup: &PolygonSoup| -> Vec<DVec3> {
        let corners = soup.triangles().into_iter().flatten();
        corners.map(|v| soup.positions[v as usize]).collect()
    };
    let (a, b) = (corners(a), corners(b));
    assert_eq!(a.len(), b.len());
    let pairs = a.iter().zip(&b);
    pairs.fold(0.0, |most, (p, q)| (*p + shift).distance(*q).max(most))
}

#[test]
fn every_format_reads_back_as_the_same_mesh_near_and_far_small_and_large() {
    for origin in [0.0, 1e3, 5e6] {
        for size in [1e-6, 1.0, 1e6] {
            let soup = torus(origin, size);
            for format in Format::written() {
                let what = format!("{format:?}, {size:e} at {origin:e}");
                let bytes = io::write(&soup, format, "").unwrap();
                let read = io::read(&bytes, "").unwrap();
                assert_eq!(read.warnings, [], "{what}");
                let back = read.soup;
                assert_eq!(back.positions.len(), soup.positions.len(), "{what}");
                let is_cut = back.n_faces() != soup.n_faces();
                if is_cut {
                    let shift = match io::losses(&soup, format)[..] {
                        [Loss::Moved { x, y, z, .. }, ..] => DVec3::new(x, y, z),
                        _ => DVec3::ZERO,
                    };
                    let off = distance(&soup.triangulated(), &back, shift);
                    assert!(off <= 1e-6 * size, "{what}: {off:e}");
                } else {
                    // Polygons are kept, and with them every bit.
                    assert_eq!(back, soup, "{what}");
                }
                let is_moved = format == Format::Stl && origin > 20.0 * size;
                let losses = io::losses(&soup, format).len();
                assert_eq!(
                    losses,
                    usize::from(is_moved) + usize::from(is_cut),
                    "{what}"
                );
            }
        }
    }
}

#[test]
fn formats_that_are_only_read_refuse_to_be_written() {
    for format in Format::all().filter(|format| !format.is_written()) {
        let error = io::write(&torus(0.0, 1.0), format, "");
        assert_eq!(error, Err(io::WriteError::ReadOnly { format }));
    }
}

/// Two tetrahedra that were cut apart at a vertex: STL joins it again when it is read, which is told,
/// and no other format does.
#[test]
fn vertices_that_stl_joins_are_told() {
    let corners = [DVec3::ZERO, DVec3::X, DVec3::Y, DVec3::Z];
    let positions: Vec<DVec3> = corners.iter().copied().chain(corners.map(|p| -p)).collect();
    let faces: [[u32; 3]; 8] = [
        [0, 2, 1],
        [0, 1, 3],
        [1, 2, 3],
        [2, 0, 3],
        [4, 5, 6],
        [4, 7, 5],
        [5, 7, 6],
        [6, 7, 4],
    ];
    let soup = PolygonSoup::from_faces(positions, &faces);
    for format in Format::written() {
        let bytes = io::write(&soup, format, "").unwrap();
        let read = io::read(&bytes, "").unwrap();
        let lost = soup.positions.len() - read.soup.positions.len();
        let told = match io::losses(&soup, format)[..] {
            [Loss::Joined { count, .. }] => count,
            _ => 0,
        };
        assert_eq!(told, lost, "{format:?}");
        assert_eq!(
            told > 0,
            matches!(format, Format::Stl | Format::StlAscii),
            "{format:?}"
        );
    }
}

/// What follows after what the header counts is told, and blank space is nothing.
#[test]
fn what_the_header_does_not_count_is_told() {
    let soup = torus(0.0, 1.0);
    for (format, more, oddity) in [
        (
            Format::PlyAscii,
            "3 0 1 2\n\n3 0 1 3\n",
            Oddity::LinesLeft { count: 2 },
        ),
        (Format::Off, "3 0 1 2\n", Oddity::LinesLeft { count: 1 }),
        (Format::Ply, "abc", Oddity::BytesLeft { count: 3 }),
    ] {
        let bytes = io::write(&soup, format, "").unwrap();
        let read = |more: &str| io::read(&[&bytes, more.as_bytes()].concat(), "").unwrap();
        assert_eq!(read(more).warnings, [oddity], "{format:?}");
        assert_eq!(read(" \n\n").warnings, [], "{format:?}");
    }
}
