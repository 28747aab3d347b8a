//! Surfaces that cannot be oriented: each face turns as its neighbour does, save across one seam.
//!
//! The circle-angle energy needs no orientation, so the flow runs on them as on any other.

use std::f64::consts::{PI, TAU};

use glam::DVec3;

use super::{curve, grid};
use crate::soup::PolygonSoup;

/// A strip of `width` around the unit circle with half a turn, `around` x `across` cells.
pub fn moebius(width: f64, around: usize, across: usize) -> PolygonSoup {
    let positions = (0..around * (across + 1)).map(|k| {
        let u = TAU * (k / (across + 1)) as f64 / around as f64;
        let s = width * ((k % (across + 1)) as f64 / across as f64 - 0.5);
        let rho = 1.0 + s * (u / 2.0).cos();
        DVec3::new(rho * u.cos(), rho * u.sin(), s * (u / 2.0).sin())
    });
    // One turn leads back to the first column, upside down.
    let vertex = |i: usize, j: usize| {
        if i == around {
            across - j
        } else {
            i * (across + 1) + j
        }
    };
    PolygonSoup::from_faces(
        positions.collect(),
        &grid::triangles(around, across, vertex),
    )
}

/// The Klein bottle as a tube of varying radius along a teardrop: the neck bends over, passes
/// through the side and widens into the bottom from inside. `along` x `around` cells,
/// `around` even.
///
/// The axis is the piriform `(-b sin t (1 - cos t), 1 - cos t)` and the radius
/// `c - d(t - π)√(t(2π - t))` (Franzoni [F12](crate::bibliography#f12)), here with
/// `b, c, d = 0.4, 0.26, 0.26/π²`, sampled at equal steps of axis and radius. Closed, immersed,
/// Euler characteristic 0.
pub fn klein_bottle(along: usize, around: usize) -> PolygonSoup {
    let steps = curve::even_parameters(along, |s| {
        let section = Section::at(s);
        section.centre + DVec3::Z * section.radius
    });
    let sections: Vec<Section> = steps.into_iter().map(Section::at).collect();
    let positions = (0..along * around).map(|k| {
        let Section {
            centre,
            side,
            radius,
        } = sections[k / around];
        let v = TAU * (k % around) as f64 / around as f64;
        centre + (side * v.cos() - DVec3::Z * v.sin()) * radius
    });
    // The axis ends where it began but in the opposite direction: there the side
    // vector is reversed and v meets π - v.
    let vertex = |i: usize, j: usize| match i == along {
        true => (3 * around / 2 - j) % around,
        false => i * around + j % around,
    };
    PolygonSoup::from_faces(positions.collect(), &grid::triangles(along, around, vertex))
}

/// A circle of the Klein bottle, in the plane of `side` and z.
#[derive(Clone, Copy)]
struct Section {
    centre: DVec3,
    side: DVec3,
    radius: f64,
}

impl Section {
    /// The circle at `s` in `[0, 1]`.
    fn at(s: f64) -> Self {
        // t = π(1 - cos w) takes the root out of the radius: (t - π)√… = -π²/2 sin 2w.
        let w = PI * s;
        let t = PI * (1.0 - w.cos());
        let centre = DVec3::new(-0.4 * t.sin(), 1.0, 0.0) * (1.0 - t.cos());
        // The axis' derivative over 2 sin(t/2), which does not vanish at the ends.
        let direction = DVec3::new(-0.4 * (1.5 * t).sin(), (t / 2.0).cos(), 0.0).normalize();
        let radius = 0.26 + 0.13 * (2.0 * w).sin();
        Self {
            centre,
            side: DVec3::Z.cross(direction),
            radius,
        }
    }
}
