//! What a quantity tends to as the mesh is refined, and how fast.

use super::Resolution;
use super::exact::Exact;
use crate::message::{Message, Value};
use serde::Serialize;

/// Where the values of a quantity lead.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tendency {
    /// Right on every mesh, up to roundoff.
    Exact,
    /// To the smooth value, or where none is known to some value.
    Converges,
    /// To another value than the smooth one, or to it so slowly that it does not show.
    Elsewhere,
    /// Nowhere: each refinement changes it as much as the last, or more.
    Diverges,
    /// Too few resolutions to tell.
    Unknown,
}

/// A quantity over all resolutions.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct Trend {
    /// Its name among the fields of [`Resolution`].
    pub quantity: &'static str,
    /// One a resolution.
    pub values: Vec<f64>,
    /// The smooth value.
    pub smooth: Option<f64>,
    /// Whether that is known, and not taken from the finest mesh by quadratic fits.
    pub is_known: bool,
    /// |value − smooth| of each resolution; where no smooth value is known, the distance to
    /// the finest.
    #[serde(skip)]
    pub errors: Vec<f64>,
    /// Observed order between this and the resolution before: log of the ratio of errors, or
    /// where no smooth value is known of successive differences, over that of the widths.
    pub orders: Vec<Option<f64>>,
    /// Where it leads.
    #[serde(skip)]
    pub tendency: Tendency,
}

impl Trend {
    /// What the quantity does, in one sentence.
    pub(super) fn said(&self, p: f64) -> Message {
        let name = vec![("quantity", self.quantity.into()), ("p", p.into())];
        let tendency = match self.tendency {
            Tendency::Exact => "exact",
            Tendency::Converges if self.is_known => "converges",
            Tendency::Converges if self.smooth.is_some() => "nears",
            Tendency::Converges => "settles",
            Tendency::Elsewhere if self.smooth.is_none_or(|smooth| smooth == 0.0) => {
                "elsewhereThanZero"
            }
            Tendency::Elsewhere => "elsewhere",
            Tendency::Diverges => "diverges",
            Tendency::Unknown => "unknown",
        };
        let measured = |number: Option<f64>| number.map_or(Value::None, Value::Number);
        let smooth = self.smooth.filter(|smooth| *smooth != 0.0);
        let ratio = self.values.last().zip(smooth);
        let values = vec![
            ("name", Message::new("trend", "Name", name).into()),
            ("tendency", tendency.into()),
            ("smooth", measured(self.smooth)),
            ("order", measured(self.orders.last().copied().flatten())),
            ("ratio", measured(ratio.map(|(last, smooth)| last / smooth))),
        ];
        Message::new("trend", "", values)
    }
}

/// Relative error of what is right up to roundoff and the conditioning of the sums.
const ROUNDOFF: f64 = 1e-9;
/// A change by so much of ∫H² is that of a quantity that settles.
const RELIABLE: f64 = 0.1;
/// Order below which errors do not fall.
const LEAST_ORDER: f64 = 0.5;

pub(super) fn trends(rows: &[Resolution], exact: Option<Exact>, p: f64) -> Vec<Trend> {
    let column = |of: fn(&Resolution) -> f64| -> Vec<f64> { rows.iter().map(of).collect() };
    let h = column(|row| row.h);
    let size = exact.map(|e| e.willmore).filter(|w| *w > 0.0);
    let size = size.or(rows.last().map(|row| row.fitted)).unwrap_or(1.0);
    let mut all = vec![
        trend(
            "area",
            column(|r| r.area),
            &h,
            exact.map(|e| e.area),
            None,
            0.0,
        ),
        trend(
            "circle",
            column(|r| r.circle),
            &h,
            exact.map(|e| e.willmore - e.gauss),
            fitted_difference(rows),
            size,
        ),
        trend(
            "cotangent",
            column(|r| r.cotangent),
            &h,
            exact.map(|e| e.willmore),
            None,
            size,
        ),
        trend(
            "fitted",
            column(|r| r.fitted),
            &h,
            exact.map(|e| e.willmore),
            None,
            size,
        ),
    ];
    if p != 0.0 && p != 2.0 {
        let smooth = exact.map(|e| e.power);
        all.push(trend("power", column(|r| r.power), &h, smooth, None, 0.0));
    }
    all
}

/// ∫(H² − K) by fits on the finest mesh, and how far it may be off: as much as the last
/// refinement changed it. Where that is much it is no estimate.
fn fitted_difference(rows: &[Resolution]) -> Option<(f64, f64)> {
    let [.., before, last] = rows else {
        return None;
    };
    let of = |row: &Resolution| row.fitted - row.gauss;
    let (value, change) = (of(last), (of(last) - of(before)).abs());
    (change < RELIABLE * last.fitted).then_some((value, change))
}

/// `estimate` stands in for a smooth value that is not known, with its error; `size` is what
/// errors are compared with where the values themselves tend to 0.
fn trend(
    quantity: &'static str,
    values: Vec<f64>,
    h: &[f64],
    known: Option<f64>,
    estimate: Option<(f64, f64)>,
    size: f64,
) -> Trend {
    let smooth = known.or(estimate.map(|(value, _)| value));
    let finest = values.last().copied().unwrap_or_default();
    let errors: Vec<f64> = values
        .iter()
        .map(|value| (value - smooth.unwrap_or(finest)).abs())
        .collect();
    let steps: Vec<f64> = values.windows(2).map(|w| (w[1] - w[0]).abs()).collect();
    let roundoff = ROUNDOFF * size.max(finest.abs());
    let order = |coarse: f64, fine: f64, k: usize| {
        let is_exact = coarse <= roundoff && fine <= roundoff;
        let order = (coarse / fine).ln() / (h[k - 1] / h[k]).ln();
        (!is_exact && order.is_finite()).then_some(order)
    };
    let orders: Vec<Option<f64>> = (0..values.len())
        .map(|k| match (smooth, k) {
            (_, 0) => None,
            (Some(_), _) => order(errors[k - 1], errors[k], k),
            (None, 1) => None,
            (None, _) => order(steps[k - 2], steps[k - 1], k),
        })
        .collect();
    let last = orders.last().copied().flatten();
    let uncertain = estimate
        .filter(|_| known.is_none())
        .map_or(0.0, |(_, by)| by);
    let error = errors.last().copied().unwrap_or_default();
    let settles = match steps[..] {
        [.., before, after] => after < 0.75 * before || after <= roundoff,
        _ => false,
    };
    let tendency = if values.len() < 2 {
        Tendency::Unknown
    } else if smooth.is_some() && errors.iter().all(|e| *e <= roundoff)
        || steps.iter().all(|s| *s <= roundoff) && smooth.is_none()
    {
        Tendency::Exact
    } else if values.len() < 3 {
        Tendency::Unknown
    } else if last.is_some_and(|order| order >= LEAST_ORDER)
        || smooth.is_some() && error <= uncertain.max(roundoff)
    {
        Tendency::Converges
    } else if settles && smooth.is_some() {
        Tendency::Elsewhere
    } else {
        Tendency::Diverges
    };
    Trend {
        quantity,
        values,
        smooth,
        is_known: known.is_some(),
        errors,
        orders,
        tendency,
    }
}
