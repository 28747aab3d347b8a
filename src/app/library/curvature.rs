//! Figures of Xu & Zhang [XZ06](crate::bibliography#xz06), minimal mean-curvature-variation flow.

use super::figure::{Figure, Finding, Steps};
use super::measure::{off_tube, off_unit_sphere};
use super::measured::Run;
use crate::app::{Arrangement, Compare, FieldName};
use crate::flow::Status;
use crate::flow::spec::FlowName;
use glam::DVec3;

const PLAIN: Figure = Figure {
    paper: "curvature",
    colour: Some(FieldName::MeanCurvature),
    ..Figure::PLAIN
};

/// The other flows side by side, long enough for each to come to rest.
const COMPARED: Figure = Figure {
    arrangement: Arrangement {
        compare: Compare::Flows,
        ..Arrangement::PLAIN
    },
    steps: Steps::Count(60),
    ..PLAIN
};

/// A surface of radius 1, recovered to `bound`.
fn recovered(run: &Run<'_>, bound: f64, off: fn(&[DVec3]) -> f64) -> Finding {
    let [first, last] = [run.start, run.x].map(off);
    let status = run.last.status;
    let values = [
        ("first", first.into()),
        ("last", last.into()),
        ("steps", run.last.step.into()),
        ("status", status.into()),
    ];
    Finding::new(
        last < bound && status == Status::Converged,
        "measured-recovered",
        &values,
    )
}

/// The jumps of H under the four flows.
#[derive(Clone, Copy)]
struct Jumps {
    mean_curvature: f64,
    surface_diffusion: f64,
    willmore: f64,
    mmcv: f64,
}

fn jumps(run: &Run<'_>, holds: fn(Jumps, Status) -> bool) -> Finding {
    let found = Jumps {
        mean_curvature: run.jump_of(FlowName::MeanCurvature),
        surface_diffusion: run.jump_of(FlowName::SurfaceDiffusion),
        willmore: run.jump_of(FlowName::Willmore),
        mmcv: run.jump_of(FlowName::Mmcv),
    };
    let values = [
        ("meanCurvature", found.mean_curvature.into()),
        ("surfaceDiffusion", found.surface_diffusion.into()),
        ("willmore", found.willmore.into()),
        ("mmcv", found.mmcv.into()),
    ];
    Finding::new(holds(found, run.last.status), "measured-jumps", &values)
}

/// What joins with continuous curvature, up to the mesh, jumps by far less.
const CONTINUOUS: f64 = 0.45;

fn blended(run: &Run<'_>) -> Finding {
    jumps(run, |jump, status| {
        status == Status::Converged && jump.mmcv <= CONTINUOUS * jump.surface_diffusion
    })
}

pub(super) static FIGURES: &[Figure] = &[
    Figure {
        id: "curvature-5.1-cylinder",
        number: "5.1 (a–c)",
        sample: "cylinder-gaps",
        judge: |run| recovered(run, 5e-4, |x| off_tube(x, 2, 1.0)),
        ..PLAIN
    },
    Figure {
        id: "curvature-5.1-sphere",
        number: "5.1 (d–f)",
        sample: "sphere-openings",
        judge: |run| recovered(run, 5e-4, off_unit_sphere),
        ..PLAIN
    },
    Figure {
        id: "curvature-5.4",
        number: "5.4",
        sample: "dodecahedron",
        judge: |run| recovered(run, 1e-3, off_unit_sphere),
        ..PLAIN
    },
    Figure {
        id: "curvature-5.2-two",
        number: "5.2 (a–c)",
        sample: "two-tubes",
        judge: |run| {
            // Along the axis the tubes lie on, which is not said, they are off least.
            let off = (0..3).map(|axis| off_tube(run.x, axis, 0.5));
            let off = off.fold(f64::INFINITY, f64::min);
            let status = run.last.status;
            let values = [
                ("off", off.into()),
                ("jump", run.jump().into()),
                ("steps", run.last.step.into()),
                ("status", status.into()),
            ];
            Finding::new(
                off < 1e-3 && status == Status::Converged,
                "measured-tube",
                &values,
            )
        },
        ..PLAIN
    },
    Figure {
        id: "curvature-5.2-three",
        number: "5.2 (d–f)",
        sample: "three-tubes",
        judge: blended,
        ..COMPARED
    },
    Figure {
        id: "curvature-5.2-six",
        number: "5.2 (g–i)",
        sample: "six-tubes",
        judge: blended,
        ..COMPARED
    },
    Figure {
        id: "curvature-5.3",
        number: "5.3",
        sample: "holed-sphere",
        judge: |run| {
            let (info, jump, status) = (run.info(), run.jump(), run.last.status);
            let values = [
                ("loops", info.boundary_loops.into()),
                ("status", status.into()),
                ("steps", run.last.step.into()),
                ("jump", jump.into()),
            ];
            let is_smooth = jump.is_some_and(|jump| jump < 0.1);
            let ok = info.closed && status == Status::Converged && is_smooth;
            Finding::new(ok, "measured-holes", &values)
        },
        ..PLAIN
    },
    Figure {
        id: "curvature-5.5",
        number: "5.5",
        sample: "three-tubes",
        judge: |run| {
            jumps(run, |jump, _| {
                jump.mmcv <= CONTINUOUS * jump.surface_diffusion
                    && jump.mmcv <= CONTINUOUS * jump.willmore
            })
        },
        ..COMPARED
    },
    Figure {
        id: "curvature-5.6",
        number: "5.6",
        sample: "four-bumps",
        judge: |run| {
            jumps(run, |jump, _| {
                jump.mmcv <= 0.06
                    && jump.mmcv <= 0.5 * jump.surface_diffusion
                    && jump.mmcv <= 0.5 * jump.willmore
                    && jump.mean_curvature > 0.9
            })
        },
        ..COMPARED
    },
];
