//! Principal curvatures and directions, from the quadratic fits.

use super::fit::Fit;
use super::stencil::Stencils;
use crate::mesh::{Edge, HalfedgeMesh, Vertex};
use glam::{DVec2, DVec3};
use std::f64::consts::FRAC_PI_2;

/// Principal curvatures and directions at a vertex: eigenvalues and eigenvectors of the shape
/// operator, κ > 0 on a sphere with outward normal; unit 1/length.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Principal {
    /// κ₁ ≥ κ₂.
    pub curvatures: [f64; 2],
    /// Unit tangents along them, orthogonal; up to sign.
    pub directions: [DVec3; 2],
    /// Unit normal of the fit.
    pub normal: DVec3,
}

/// Share of the size of the curvatures, √(κ₁² + κ₂²), that κ₁ − κ₂ must exceed for directions
/// to mean anything: below, the vertex counts as an umbilic.
pub const UMBILIC: f64 = 0.05;

/// Curvatures below this over the size of the surface count as none: a plane is all umbilics.
const FLAT: f64 = 1e-6;

impl Principal {
    /// Whether the principal directions are not defined, up to the error of a fit: an umbilic,
    /// or a flat point of a surface of size `size`.
    pub fn is_umbilic(&self, size: f64) -> bool {
        let [a, b] = self.curvatures;
        let most = a.hypot(b);
        most * size < FLAT || a - b < UMBILIC * most
    }
}

/// Principal curvatures and directions at every vertex that `wanted` marks; none where its
/// neighbours do not determine a quadratic.
pub fn principal_directions(
    mesh: &HalfedgeMesh,
    x: &[DVec3],
    wanted: impl Fn(usize) -> bool,
) -> Vec<Option<Principal>> {
    let mut stencils = Stencils::new(mesh);
    let mut fit = Fit::default();
    mesh.vertices()
        .map(|v| {
            if !wanted(v.index()) {
                return None;
            }
            stencils.choose(x, v, &mut fit)?;
            let members = stencils.members().iter();
            let differences = members.map(|&j| x[j as usize] - x[v.index()]);
            diagonalised(fit.derivatives(differences))
        })
        .collect()
}

/// From the derivatives r_u, r_v, r_uu, r_uv, r_vv of a parametrisation.
fn diagonalised([ru, rv, ruu, ruv, rvv]: [DVec3; 5]) -> Option<Principal> {
    let normal = ru.cross(rv).try_normalize()?;
    let first = ru.try_normalize()?;
    let second = normal.cross(first);
    // r_u = a e₁, r_v = b e₁ + c e₂; the second form, with the sign of the outward normal.
    let (a, b, c) = (ru.length(), rv.dot(first), rv.dot(second));
    let [l, m, n] = [ruu, ruv, rvv].map(|r| -r.dot(normal));
    let s11 = l / (a * a);
    let s12 = (m / a - b * s11) / c;
    let s22 = (n - 2.0 * b * c * s12 - b * b * s11) / (c * c);
    let (mean, half) = (0.5 * (s11 + s22), 0.5 * (s11 - s22));
    let radius = half.hypot(s12);
    let along = DVec2::from_angle(0.5 * s12.atan2(half));
    let found = Principal {
        curvatures: [mean + radius, mean - radius],
        directions: [
            along.x * first + along.y * second,
            along.x * second - along.y * first,
        ],
        normal,
    };
    found.curvatures[0].is_finite().then_some(found)
}

/// Edges within `degrees` of a line of curvature: how many, and of how many; those between
/// umbilics do not count. The angle is that in the tangent plane to the nearer principal
/// direction, at the middle of the edge: the mean of those at its ends, with their signs, as a
/// chord leaves a curved line to one side and comes back from the other. Where edges know nothing of
/// curvature, every angle up to 45° is as likely.
pub fn aligned_edges(
    mesh: &HalfedgeMesh,
    x: &[DVec3],
    at: &[Option<Principal>],
    size: f64,
    degrees: f64,
) -> (usize, usize) {
    let defined = |v: Vertex| at[v.index()].filter(|p| !p.is_umbilic(size));
    let angle = |e: Edge| {
        let [a, b] = mesh.ends(e);
        let edge = x[b.index()] - x[a.index()];
        let turn = |p: &Principal| {
            let [first, second] = p.directions.map(|d| edge.dot(d));
            quarter(second.atan2(first))
        };
        match (defined(a), defined(b)) {
            (Some(p), Some(q)) => {
                let sign = 1f64.copysign(p.normal.dot(q.normal));
                let (s, t) = (turn(&p), sign * turn(&q));
                Some(quarter(s + 0.5 * quarter(t - s)))
            }
            (Some(p), None) | (None, Some(p)) => Some(turn(&p)),
            (None, None) => None,
        }
    };
    let angles: Vec<f64> = mesh.edges().filter_map(angle).collect();
    let near = angles.iter().filter(|a| a.abs().to_degrees() < degrees);
    (near.count(), angles.len())
}

/// An angle up to multiples of a right one, in [−π/4, π/4].
fn quarter(angle: f64) -> f64 {
    angle - FRAC_PI_2 * (angle / FRAC_PI_2).round()
}
