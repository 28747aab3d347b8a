//! Tori of revolution about z, and half of one.

use std::f64::consts::{PI, SQRT_2, TAU};

use glam::DVec3;

use super::grid;
use crate::mesh::subdivide::{SubdivisionError, linear_levels};
use crate::soup::PolygonSoup;

/// The torus `((R + r cos v) cos u, (R + r cos v) sin u, r sin v)`, `around` steps of u and
/// `tube` steps of v: a right-angled lattice along the curvature lines, with diagonals.
pub fn torus(major: f64, minor: f64, around: usize, tube: usize) -> PolygonSoup {
    let positions = (0..around * tube).map(|k| {
        let (u, v) = (
            (k / tube) as f64 / around as f64,
            (k % tube) as f64 / tube as f64,
        );
        on_torus(major, minor, TAU * u, TAU * v)
    });
    let vertex = |i: usize, j: usize| i % around * tube + j % tube;
    PolygonSoup::from_faces(positions.collect(), &grid::triangles(around, tube, vertex))
}

/// The torus with R = √2 and r = 1, the minimum of the Willmore energy among tori (2π²).
pub fn clifford_torus(around: usize, tube: usize) -> PolygonSoup {
    torus(SQRT_2, 1.0, around, tube)
}

/// A cyclide of Dupin: the Clifford torus of the 3-sphere turned by `turn` towards the pole that
/// it is projected from. A Möbius image of [`clifford_torus`], with the same ∫H² = 2π²; at π/4
/// it would pass through infinity. `around` x `tube` cells with the angles of the square.
pub fn cyclide(around: usize, tube: usize, turn: f64) -> PolygonSoup {
    let positions = (0..around * tube).map(|k| {
        let u = TAU * (k / tube) as f64 / around as f64;
        let v = TAU * (k % tube) as f64 / tube as f64;
        let (towards, pole) = (
            turn.cos() * u.cos() - turn.sin() * v.cos(),
            turn.sin() * u.cos() + turn.cos() * v.cos(),
        );
        DVec3::new(towards, u.sin(), v.sin()) / (SQRT_2 - pole)
    });
    let vertex = |i: usize, j: usize| i % around * tube + j % tube;
    PolygonSoup::from_faces(positions.collect(), &grid::triangles(around, tube, vertex))
}

/// A lattice on the Clifford torus whose angles are those of a plane lattice.
///
/// The torus is the stereographic image of the flat torus in the 3-sphere, so
/// it inherits the lattice's angles. Cells are `1/columns` by `1/rows` of the
/// square; row j is shifted by `-shear·j` columns, and each parallelogram is
/// cut from `(i, j)` to `(i + 1, j + 1)`:
///
/// | lattice | columns x rows | shear |
/// | --- | --- | --- |
/// | right-angled, aligned with the curvature lines | n x n | 0 |
/// | right-angled, turned by 45° | n x 2n | 1/2 |
/// | equilateral, nearly | 13n x 15n | 1/2 |
/// | acute isosceles (63°, 53°, 63°) | n x n | 1/2 |
/// | obtuse (104°), not Delaunay | n x n | -1/4 |
///
/// Over 4π², the circle-angle energy tends to 1, grows like the number of columns, tends to 3/2,
/// to 4/3, and grows like its square (the smooth limit of Bobenko & Schröder
/// [BS05](crate::bibliography#bs05), section 2).
///
/// The shift must close up: `shear·rows` is rounded to a whole number.
pub fn lattice_torus(columns: usize, rows: usize, shear: f64) -> PolygonSoup {
    let turn = (shear * rows as f64).round();
    let positions = (0..columns * rows).map(|k| {
        let (i, j) = ((k % columns) as f64, (k / columns) as f64);
        let v = TAU * j / rows as f64;
        let u = TAU * (i - j * turn / rows as f64) / columns as f64;
        DVec3::new(u.cos(), u.sin(), v.sin()) / (SQRT_2 - v.cos())
    });
    // Row `rows` is row 0, begun `turn` columns earlier.
    let back = turn.rem_euclid(columns as f64) as usize;
    let vertex = |i: usize, j: usize| {
        let i = if j == rows { i + columns - back } else { i };
        j % rows * columns + i % columns
    };
    PolygonSoup::from_faces(positions.collect(), &grid::triangles(columns, rows, vertex))
}

/// An 8 x 6 torus with R = 2 and r = 1, subdivided linearly: figure 8 of Bobenko & Schröder 2005.
///
/// Twice subdivided it has 768 vertices and W = 764.40.
pub fn coarse_torus(levels: usize) -> Result<PolygonSoup, SubdivisionError> {
    linear_levels(torus(2.0, 1.0, 8, 6), levels)
}

/// Half a torus with R = 2 and r = 1, of 8 x 6 cells subdivided linearly, its two boundary
/// loops drawn out to circles: figure 9 of Bobenko & Schröder 2005.
///
/// Twice subdivided it has 792 vertices.
pub fn pipe(levels: usize) -> Result<PolygonSoup, SubdivisionError> {
    const AROUND: usize = 8;
    const TUBE: usize = 6;
    let positions = (0..(AROUND + 1) * TUBE).map(|k| {
        let (u, v) = (
            (k / TUBE) as f64 / AROUND as f64,
            (k % TUBE) as f64 / TUBE as f64,
        );
        on_torus(2.0, 1.0, PI * u, TAU * v)
    });
    let faces = grid::triangles(AROUND, TUBE, |i, j| i * TUBE + j % TUBE);
    let mut soup = linear_levels(PolygonSoup::from_faces(positions.collect(), &faces), levels)?;
    // The ends lie in the plane y = 0 (exactly at u = 0, to roundoff at u = π),
    // around (±2, 0, 0).
    for p in soup.positions.iter_mut().filter(|p| p.y.abs() < 1e-9) {
        let centre = DVec3::X * 2.0_f64.copysign(p.x);
        *p = centre + (*p - centre).normalize();
    }
    Ok(soup)
}

pub(super) fn on_torus(major: f64, minor: f64, u: f64, v: f64) -> DVec3 {
    let rho = major + minor * v.cos();
    DVec3::new(rho * u.cos(), rho * u.sin(), minor * v.sin())
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::curvature::area_gradient;
    use crate::geometry::measure::{vertex_areas, volume};
    use crate::mesh::build_as_given;

    #[test]
    fn cyclides_have_the_energy_of_the_clifford_torus_to_the_second_order() {
        for turn in [0.0, 0.4] {
            let errors = [32, 64, 128].map(|n| {
                let built = build_as_given(&cyclide(n, n, turn)).expect("a surface");
                let (mesh, x) = (&built.mesh, &built.positions);
                assert!(volume(mesh, x).expect("closed") > 0.0);
                let (g, a) = (area_gradient(mesh, x), vertex_areas(mesh, x));
                let terms = g.iter().zip(&a);
                let energy: f64 = terms.map(|(g, a)| g.length_squared() / (4.0 * a)).sum();
                1.0 - energy / (2.0 * PI * PI)
            });
            assert!(errors[1] < 0.01, "{turn}: {errors:?}");
            for pair in errors.windows(2) {
                let order = (pair[0] / pair[1]).log2();
                assert!((order - 2.0).abs() < 0.2, "{turn}: {errors:?}");
            }
        }
    }
}
