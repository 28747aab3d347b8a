//! Flows as rows of a table: what each is, what it takes and what it minimises.
//!
//! Which options a flow reads is said by the rows of the options ([`super::option`]).

use super::Monitored;
use super::option::value::Value;
use crate::energy::circle::Boundary;
use serde::{Deserialize, Serialize, Serializer};

/// Which flow runs.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "kebab-case")]
pub enum FlowName {
    /// Bobenko & Schröder's circle-angle Willmore flow [BS05](crate::bibliography#bs05).
    #[default]
    Circle,
    /// Gruber & Aulisa's p-Willmore flow [GA20](crate::bibliography#ga20).
    PWillmore,
    /// Flow by mean curvature.
    MeanCurvature,
    /// Huisken's flow by mean curvature that keeps the volume.
    VolumePreserving,
    /// Surface diffusion.
    SurfaceDiffusion,
    /// Willmore flow by fitted operators.
    Willmore,
    /// Xu & Zhang's minimal mean-curvature-variation flow [XZ06](crate::bibliography#xz06).
    Mmcv,
    /// Brink & Alboul's edge flips [BA](crate::bibliography#ba).
    Flips,
}

/// The system that runs a flow.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Family {
    /// The circle-angle Willmore flow.
    Circle,
    /// The p-Willmore flow, and flows that are one of its cases.
    PWillmore,
    /// The flows by mean curvature and its derivatives, on operators by quadratic fits.
    Curvature,
    /// Edge flips, which move no vertex.
    Flips,
}

/// Which meshes a flow takes; triangles every flow takes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct Meshes {
    /// Surfaces with a boundary.
    pub open: bool,
    /// Meshes of quadrilaterals as they are. Flows that move vertices triangulate what they
    /// cannot take; edge flips refuse it.
    pub quads: bool,
    /// One-sided surfaces.
    pub one_sided: bool,
}

/// One flow.
#[derive(Clone, Copy, Debug, Serialize)]
#[serde(rename_all = "camelCase")]
pub struct FlowRow {
    /// Which.
    pub id: FlowName,
    /// What runs it.
    pub family: Family,
    /// Where it comes from.
    pub paper: &'static str,
    /// Order of the equation in space at the usual exponent; 0 of edge flips.
    pub order: u32,
    /// dt has the unit length^k with this k …
    pub time_power: u32,
    /// … and the exponent p more.
    pub time_power_adds_p: bool,
    /// τ, the step size without a unit, as text; empty where there are no step sizes.
    pub tau: &'static str,
    /// What may be the functional that no accepted step raises, by options and phase.
    pub monitored: &'static [Monitored],
    /// Equation of motion, TeX.
    pub formula: &'static str,
    /// What it takes.
    pub meshes: Meshes,
    /// What happens at the boundary unless told otherwise; `None` where there is no choice.
    pub boundary: Option<Boundary>,
    /// Options of its family that make it this flow, by name; it reads none of them.
    #[serde(serialize_with = "as_record")]
    pub sets: fn() -> Vec<(&'static str, Value)>,
}

fn as_record<S: Serializer>(
    sets: &fn() -> Vec<(&'static str, Value)>,
    serializer: S,
) -> Result<S::Ok, S::Error> {
    serializer.collect_map(sets())
}

use FlowName::{
    Circle, Flips, MeanCurvature, Mmcv, PWillmore, SurfaceDiffusion, VolumePreserving, Willmore,
};

/// The names of the rows for which a condition holds.
macro_rules! flows {
    ($(#[$note:meta])* $name:ident: |$row:ident| $condition:expr) => {
        $(#[$note])*
        pub const $name: &[FlowName] = {
            const fn holds($row: &FlowRow) -> bool {
                $condition
            }
            const NAMES: ([FlowName; FLOWS.len()], usize) = {
                let (mut names, mut count, mut n) = ([Circle; FLOWS.len()], 0, 0);
                while n < FLOWS.len() {
                    if holds(&FLOWS[n]) {
                        names[count] = FLOWS[n].id;
                        count += 1;
                    }
                    n += 1;
                }
                (names, count)
            };
            NAMES.0.split_at(NAMES.1).0
        };
    };
}

flows! {
    /// Every flow.
    ALL: |_row| true
}
flows! {
    /// Those that move vertices.
    MOVING: |row| row.order > 0
}
flows! {
    /// Those with something to choose at a boundary, and with vertices to hold.
    OPEN: |row| row.boundary.is_some()
}
flows! {
    /// The p-Willmore flow and its cases: flows of closed surfaces.
    CLOSED: |row| matches!(row.family, Family::PWillmore)
}
flows! {
    /// Those that another can stand beside.
    COMPARED: |row| matches!(row.family, Family::Curvature | Family::Flips)
}
/// The circle-angle flow.
pub const CIRCLE: &[FlowName] = &[Circle];
/// The p-Willmore flow.
pub const P_WILLMORE: &[FlowName] = &[PWillmore];
/// Minimal mean-curvature variation.
pub const MMCV: &[FlowName] = &[Mmcv];
/// Edge flips.
pub const FLIPS: &[FlowName] = &[Flips];

const XU_ZHANG: &str = "Xu & Zhang, Minimal Mean-Curvature-Variation Surfaces";

const fn fitted(
    id: FlowName,
    order: u32,
    tau: &'static str,
    monitored: &'static [Monitored],
    formula: &'static str,
) -> FlowRow {
    FlowRow {
        id,
        family: Family::Curvature,
        paper: XU_ZHANG,
        order,
        time_power: order,
        time_power_adds_p: false,
        tau,
        monitored,
        formula,
        meshes: Meshes {
            open: true,
            quads: false,
            one_sided: false,
        },
        boundary: Some(Boundary::Fixed),
        sets: Vec::new,
    }
}

/// The flows, in the order of menus.
pub const FLOWS: &[FlowRow] = &[
    FlowRow {
        id: Circle,
        family: Family::Circle,
        paper: "Bobenko & Schröder, Discrete Willmore Flow",
        order: 4,
        // The energy has no unit, so that its gradient is one over a length.
        time_power: 2,
        time_power_adds_p: false,
        tau: "dt/h²",
        monitored: &[Monitored::SmoothedCircle],
        formula: r"\dot x = -M^{-1} \nabla W, \quad W = \sum_i \bigl(\sum_j \beta_{ij} - 2\pi\bigr)",
        meshes: Meshes {
            open: true,
            quads: false,
            one_sided: true,
        },
        boundary: Some(Boundary::Clamped),
        sets: Vec::new,
    },
    FlowRow {
        id: PWillmore,
        family: Family::PWillmore,
        paper: "Gruber & Aulisa, Computational p-Willmore Flow with Conformal Penalty",
        order: 4,
        time_power: 2,
        time_power_adds_p: true,
        tau: "dt/L^(p+2)",
        monitored: &[
            Monitored::Area,
            Monitored::Willmore,
            Monitored::PWillmore,
            Monitored::Helfrich,
        ],
        formula: r"\dot x = -\nabla \int |Y|^p \, dA, \quad Y = 2 H n",
        meshes: Meshes {
            open: false,
            quads: true,
            one_sided: false,
        },
        boundary: None,
        sets: Vec::new,
    },
    fitted(
        MeanCurvature,
        2,
        "dt/L²",
        &[Monitored::Area],
        r"\dot x = -H n",
    ),
    // The case p = 0 of the p-Willmore flow with the volume kept: ∇∫|Y|⁰ dA = ∇A = 2Hn, and the
    // multiplier of the volume is 2H̄. In Huisken's H = κ₁ + κ₂ the speed is H̄ − H.
    FlowRow {
        id: VolumePreserving,
        family: Family::PWillmore,
        paper: "Huisken, The volume preserving mean curvature flow",
        order: 2,
        time_power: 2,
        time_power_adds_p: false,
        tau: "dt/L²",
        monitored: &[Monitored::Area],
        formula: r"\dot x = 2 (\bar H - H) n, \quad \bar H = \int H \, dA \Big/ \int dA",
        meshes: Meshes {
            open: false,
            quads: true,
            one_sided: false,
        },
        boundary: None,
        sets: || {
            let keep = Value::List(vec![Value::Text("volume".into())]);
            vec![("p", Value::Number(0.0)), ("keep", keep)]
        },
    },
    fitted(
        SurfaceDiffusion,
        4,
        "dt/L⁴",
        &[Monitored::Area],
        r"\dot x = \Delta H \, n",
    ),
    fitted(
        Willmore,
        4,
        "dt/L⁴",
        &[Monitored::Willmore],
        r"\dot x = \bigl(\Delta H + 2 H (H^2 - K)\bigr) n",
    ),
    fitted(
        Mmcv,
        6,
        "dt/L⁶",
        &[Monitored::CurvatureVariation, Monitored::Area],
        r"\dot x = -\tfrac12 \nabla \int |\nabla H|^2 \, dA",
    ),
    FlowRow {
        id: Flips,
        family: Family::Flips,
        paper: "Brink & Alboul, Willmore energy vs area as criteria for mesh optimisation",
        order: 0,
        time_power: 2,
        time_power_adds_p: false,
        tau: "",
        monitored: &[Monitored::SmoothedCircle, Monitored::Area],
        formula: r"(i,j) \mapsto (k,l) \text{ where that lowers the criterion}",
        meshes: Meshes {
            open: true,
            quads: false,
            one_sided: true,
        },
        boundary: None,
        sets: Vec::new,
    },
];

/// The row of a flow.
pub fn of(flow: FlowName) -> &'static FlowRow {
    let found = FLOWS.iter().find(|row| row.id == flow);
    // A test sees to it that each has one.
    found.unwrap_or(&FLOWS[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_flow_has_one_row_and_they_stand_in_the_order_of_the_names() {
        let rows: Vec<FlowName> = FLOWS.iter().map(|row| row.id).collect();
        assert_eq!(rows, FlowName::all().collect::<Vec<_>>());
        assert_eq!(rows, ALL);
        assert_eq!(MOVING, &rows[..rows.len() - 1], "all but the flips");
        assert_eq!(CLOSED, [PWillmore, VolumePreserving]);
        assert_eq!(
            OPEN,
            [Circle, MeanCurvature, SurfaceDiffusion, Willmore, Mmcv]
        );
        assert_eq!(COMPARED[..4], OPEN[1..]);
    }
}
