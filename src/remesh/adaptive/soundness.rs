//! Whether the readings of a mesh can be believed.
//!
//! The energy of a spoilt mesh is as likely too low as too high, so that it cannot tell.
//! Four readings together can: how far edges turn around the curvature, whether the faces at a
//! vertex look the same way, and how the quadrics fitted to the surface compare with its
//! topology and with its energy.

use super::draft::Draft;
use super::quadric;
use crate::geometry::measure::mean_edge_lengths;
use crate::mesh::HalfedgeMesh;
use glam::DVec3;
use serde::Serialize;
use std::f64::consts::PI;

/// κh above which a surface is not resolved.
const COARSE: f64 = 1.5;
/// Face normal · vertex normal below which a mesh is crumpled.
const CRUMPLED: f64 = 0.3;
/// Distance of ∫K/4π of the fits from χ/2.
const TOPOLOGY: f64 = 0.15;
/// ∫H² of the fits over that of the mesh.
const ENERGY: std::ops::RangeInclusive<f64> = 0.9..=1.2;

/// What tells a sound mesh of a closed triangulated surface from a spoilt one. No unit.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Soundness {
    /// Largest κh: the larger principal curvature times the mean edge at a vertex.
    pub bend: f64,
    /// Least product of a unit face normal with a unit normal at its corners.
    pub alignment: f64,
    /// ∫K/4π of the fitted quadrics less χ/2, which it is on smooth surfaces.
    pub gauss_bonnet: f64,
    /// ∫H² of the fitted quadrics over ∫H² of the mesh.
    pub fitted_energy: f64,
}

impl Soundness {
    /// The readings of a closed oriented triangle mesh; `willmore` is its ∫H².
    pub fn of(mesh: &HalfedgeMesh, x: &[DVec3], willmore: f64) -> Self {
        let draft = Draft::of(mesh, x, &vec![false; x.len()]);
        let (areas, lengths) = (draft.areas(), mean_edge_lengths(mesh, x));
        let (mut gauss, mut squares, mut bend) = (0.0, 0.0, 0.0f64);
        for (i, fit) in quadric::fits(&draft, &draft.normal).iter().enumerate() {
            let [low, high] = fit.curvatures();
            gauss += areas[i] * low * high;
            squares += areas[i] * (0.5 * (low + high)).powi(2);
            bend = bend.max(fit.bend() * lengths[i]);
        }
        Self {
            bend,
            alignment: alignment_of(&draft),
            gauss_bonnet: gauss / (4.0 * PI) - 0.5 * mesh.euler_characteristic() as f64,
            fitted_energy: squares / willmore,
        }
    }

    /// Whether the readings of the mesh can be believed.
    pub fn is_sound(&self) -> bool {
        self.bend <= COARSE
            && self.alignment >= CRUMPLED
            && self.gauss_bonnet.abs() <= TOPOLOGY
            && ENERGY.contains(&self.fitted_energy)
    }
}

/// Least product of a unit face normal with a unit normal at its corners; 1 of a plane, positive of
/// what is immersed without a crease.
pub fn alignment(mesh: &HalfedgeMesh, x: &[DVec3]) -> f64 {
    alignment_of(&Draft::of(mesh, x, &vec![false; x.len()]))
}

fn alignment_of(draft: &Draft) -> f64 {
    let of_face = |corners: [u32; 3]| {
        let n = draft.normal_of(corners).normalize_or_zero();
        let products = corners.map(|v| n.dot(draft.normal[v as usize]));
        products.into_iter().fold(f64::INFINITY, f64::min)
    };
    draft
        .live_faces()
        .map(of_face)
        .fold(f64::INFINITY, f64::min)
}
