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
/// Distance of ∫K of the fits from 2πχ, over ∫|K| or 4π, whichever is more.
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
    /// ∫K of the fitted quadrics less 2πχ, which it is on smooth surfaces, over their ∫|K|; where
    /// that is less than 4π, over 4π. Handles and knots have more to be measured, and to err by.
    pub gauss_bonnet: f64,
    /// ∫H² of the fitted quadrics over ∫H² of the mesh.
    pub fitted_energy: f64,
    /// Whether the readings of the mesh can be believed: all four are within their limits.
    pub is_sound: bool,
}

impl Soundness {
    /// The readings of a closed oriented triangle mesh; `willmore` is its ∫H².
    pub fn of(mesh: &HalfedgeMesh, x: &[DVec3], willmore: f64) -> Self {
        let draft = Draft::of(mesh, x, &vec![false; x.len()]);
        let (areas, lengths) = (draft.areas(), mean_edge_lengths(mesh, x));
        let (mut gauss, mut turned, mut squares, mut bend) = (0.0, 0.0, 0.0, 0.0f64);
        for (i, fit) in quadric::fits(&draft.x, &draft.rings(), &draft.normal)
            .iter()
            .enumerate()
        {
            let [low, high] = fit.curvatures();
            gauss += areas[i] * low * high;
            turned += areas[i] * (low * high).abs();
            squares += areas[i] * (0.5 * (low + high)).powi(2);
            bend = bend.max(fit.bend() * lengths[i]);
        }
        let alignment = alignment_of(&draft);
        let topology = 2.0 * PI * mesh.euler_characteristic() as f64;
        let gauss_bonnet = (gauss - topology) / f64::max(turned, 4.0 * PI);
        let fitted_energy = squares / willmore;
        Self {
            bend,
            alignment,
            gauss_bonnet,
            fitted_energy,
            is_sound: bend <= COARSE
                && alignment >= CRUMPLED
                && gauss_bonnet.abs() <= TOPOLOGY
                && ENERGY.contains(&fitted_energy),
        }
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
