//! Scalar fields to colour the surface by.

use super::fault::Fault;
use super::message::AppError;
use crate::arrays::TypedArray;
use crate::energy::circle::{Boundary, CircleEnergy};
use crate::geometry::curvature;
use crate::mesh::HalfedgeMesh;
use glam::DVec3;
use serde::Serialize;

/// What a surface can be coloured by.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "kebab-case")]
pub enum FieldName {
    /// Pointwise H, as the flow measures it.
    MeanCurvature,
    /// Pointwise K.
    GaussCurvature,
    /// W_i.
    Willmore,
    /// Size of the flow's gradient at each vertex.
    Gradient,
    /// Distance from the start.
    Displacement,
}

impl FieldName {
    /// All of them with their names.
    pub const ALL: [(Self, &'static str); 5] = [
        (Self::MeanCurvature, "mean-curvature"),
        (Self::GaussCurvature, "gauss-curvature"),
        (Self::Willmore, "willmore"),
        (Self::Gradient, "gradient"),
        (Self::Displacement, "displacement"),
    ];

    /// From the name used by the page.
    ///
    /// # Errors
    /// Unknown names.
    pub fn parse(name: &str) -> Result<Self, Fault> {
        let found = Self::ALL.into_iter().find(|(_, n)| *n == name);
        found.map(|(field, _)| field).ok_or_else(|| {
            let error = AppError::UnknownField {
                name: name.into(),
                known: Self::ALL.iter().map(|(_, n)| *n).collect(),
            };
            error.into()
        })
    }

    fn is_signed(self) -> bool {
        matches!(self, Self::MeanCurvature | Self::GaussCurvature)
    }
}

/// A value per vertex and how to show it.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Field {
    /// Which field.
    pub name: FieldName,
    /// One value a vertex.
    pub values: TypedArray<f32>,
    /// Lower end of the robust range; −`high` when signed.
    pub low: f32,
    /// Upper end of the robust range.
    pub high: f32,
    /// Whether the sign matters: diverging colours about 0.
    pub signed: bool,
}

/// Share of the values left out at each end of the range: single slivers have curvatures
/// that would drown the rest.
const TAIL: f64 = 0.02;

impl Field {
    /// Computes a field on a triangle mesh. `measured` gives the values of what a flow measures
    /// itself; `boundary` decides which terms of W_i count.
    pub fn compute(
        name: FieldName,
        mesh: &HalfedgeMesh,
        boundary: Boundary,
        x: &[DVec3],
        measured: impl FnOnce(FieldName) -> Option<Vec<f64>>,
    ) -> Self {
        let values = measured(name).unwrap_or_else(|| match name {
            FieldName::MeanCurvature => curvature::pointwise_mean_curvature(mesh, x),
            FieldName::GaussCurvature => curvature::pointwise_gauss_curvature(mesh, x),
            FieldName::Willmore => CircleEnergy::new(mesh, boundary).vertex_energies(x),
            FieldName::Gradient | FieldName::Displacement => vec![0.0; x.len()],
        });
        let (low, high) = robust_range(&values, name.is_signed());
        let values = values.into_iter().map(|v| v as f32).collect();
        let signed = name.is_signed();
        Self {
            name,
            values,
            low: low as f32,
            high: high as f32,
            signed,
        }
    }
}

/// The 2nd and 98th percentile, symmetric about 0 when signed, never empty.
fn robust_range(values: &[f64], signed: bool) -> (f64, f64) {
    // As integers that sort like the numbers: one sorting routine less to download.
    let key = |v: f64| {
        let bits = v.to_bits();
        bits ^ if v.is_sign_negative() {
            u64::MAX
        } else {
            1 << 63
        }
    };
    let value = |key: u64| f64::from_bits(key ^ if key >> 63 == 0 { u64::MAX } else { 1 << 63 });
    let mut keys: Vec<u64> = values
        .iter()
        .filter(|v| v.is_finite())
        .map(|&v| key(v))
        .collect();
    if keys.is_empty() {
        return (if signed { -1.0 } else { 0.0 }, 1.0);
    }
    keys.sort_unstable();
    let tail = (TAIL * keys.len() as f64) as usize;
    let (low, high) = (value(keys[tail]), value(keys[keys.len() - 1 - tail]));
    if signed {
        let reach = low.abs().max(high.abs());
        let reach = if reach > 0.0 { reach } else { 1.0 };
        return (-reach, reach);
    }
    if high > low {
        (low, high)
    } else {
        (low, low + 1.0)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn outliers_are_left_out_of_the_range_and_it_is_never_empty() {
        let mut values: Vec<f64> = (0..1000).map(|n| f64::from(n) / 999.0 - 0.2).collect();
        values[999] = 500.0;
        values[3] = f64::NAN;
        let (low, high) = robust_range(&values, false);
        assert!(
            (low + 0.18).abs() < 2e-3 && (high - 0.78).abs() < 2e-3,
            "{low} {high}"
        );
        assert_eq!(robust_range(&values, true), (-high, high));
        assert_eq!(robust_range(&[0.0; 4], true), (-1.0, 1.0));
        assert_eq!(robust_range(&[0.0; 4], false), (0.0, 1.0));
        assert_eq!(robust_range(&[f64::NAN], false), (0.0, 1.0));
    }
}
