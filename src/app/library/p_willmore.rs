//! Figures of Gruber & Aulisa, Computational p-Willmore Flow with Conformal Penalty
//! [GA20](crate::bibliography#ga20).

use super::figure::{Figure, Finding, Steps};
use super::measure::{area_drift, near, off_sphere, volume_drift};
use super::measured::Run;
use crate::app::{FieldName, RegulariseOptions};
use crate::flow::Status;
use crate::flow::options::{FlowOptions, Remeshing};
use crate::remesh::Mode;
use std::f64::consts::PI;

const PLAIN: Figure = Figure {
    paper: "p-willmore",
    options: papers,
    ..Figure::PLAIN
};

/// The paper knows no passes of remeshing.
fn papers(o: FlowOptions) -> FlowOptions {
    FlowOptions {
        remesh: Remeshing::Off,
        ..o
    }
}

/// ∫H² of the Clifford torus, the least of all tori.
const CLIFFORD: f64 = 2.0 * PI * PI;
/// Its reduced volume.
const CLIFFORD_VOLUME: f64 = 0.71164;
/// ∫H² of any sphere.
const SPHERE: f64 = 4.0 * PI;
/// Of ∫H²/4π: the axisymmetric minimiser of reduced volume 0.6.
const DISCOCYTE: f64 = 1.95568;
/// How far a quantity that is kept may drift, relative.
const KEPT: f64 = 1e-8;

/// Area and volume kept while ∫H² falls, and `holds` of the smallest angles.
fn kept(run: &Run<'_>, holds: fn(first: f64, last: f64) -> bool) -> Finding {
    let (first, last) = (run.first, run.last);
    let drift = area_drift(first, last).max(volume_drift(first, last));
    let angles = [first.min_angle_degrees, last.min_angle_degrees];
    let values = [
        ("first", first.energy.into()),
        ("last", last.energy.into()),
        ("firstAngle", angles[0].into()),
        ("lastAngle", angles[1].into()),
        ("drift", drift.into()),
        ("status", last.status.into()),
    ];
    let ok = drift < KEPT && last.energy < first.energy && holds(angles[0], angles[1]);
    Finding::new(ok, "measured-kept", &values)
}

/// No face folded any more, far less distortion, and the surface where it was.
fn mended(run: &Run<'_>) -> Finding {
    let Some(outcome) = &run.regularised else {
        return Finding::new(false, "measured-incomplete", &[]);
    };
    let (before, after) = (&outcome.before, &outcome.after);
    let volume = match (before.volume, after.volume) {
        (Some(before), Some(after)) => Some(100.0 * (after / before - 1.0).abs()),
        _ => None,
    };
    let values = [
        ("firstInverted", before.inverted.into()),
        ("lastInverted", after.inverted.into()),
        ("firstAngle", before.min_angle_degrees.into()),
        ("lastAngle", after.min_angle_degrees.into()),
        ("firstDistortion", before.distortion.into()),
        ("lastDistortion", after.distortion.into()),
        ("moved", (100.0 * outcome.distance).into()),
        ("volume", volume.into()),
    ];
    let is_better = after.distortion < before.distortion / 3.0;
    let ok = after.inverted == 0 && is_better && outcome.distance < 0.01;
    Finding::new(ok, "measured-mended", &values)
}

fn letter(run: &Run<'_>, ok: bool) -> Finding {
    let values = [
        ("area", (run.last.area / run.first.area).into()),
        ("energy", run.last.energy_normalised.into()),
        ("status", run.last.status.into()),
    ];
    Finding::new(ok, "measured-letter", &values)
}

fn vesicle(run: &Run<'_>) -> Finding {
    let last = run.last;
    let (energy, volume) = (last.energy / SPHERE, last.reduced_volume.unwrap_or(0.0));
    let values = [
        ("energy", energy.into()),
        ("volume", volume.into()),
        ("status", last.status.into()),
    ];
    let is_there = near(energy, DISCOCYTE, 0.012) && near(volume, 0.6, 1e-8);
    Finding::new(
        is_there && last.status == Status::Converged,
        "measured-vesicle",
        &values,
    )
}

/// By how much the energies on three meshes, each twice as fine, come closer.
fn refinement(run: &Run<'_>) -> Finding {
    let [coarse, middle] = &*run.refined else {
        return Finding::new(false, "measured-incomplete", &[]);
    };
    let last = run.last;
    let ratio = (coarse.energy - middle.energy) / (middle.energy - last.energy);
    let together = [coarse, middle]
        .iter()
        .all(|end| near(end.time, last.time, 1e-9));
    let values = [
        ("coarse", coarse.energy.into()),
        ("middle", middle.energy.into()),
        ("fine", last.energy.into()),
        ("ratio", ratio.into()),
    ];
    let ok = together && last.energy < run.first.energy && (ratio - 4.0).abs() < 1.0;
    let id = if together {
        "measured-refinement"
    } else {
        "measured-refinement-apart"
    };
    Finding::new(ok, id, &values)
}

fn ball(run: &Run<'_>) -> Finding {
    let (drift, off) = (volume_drift(run.first, run.last), off_sphere(run.x));
    let values = [
        ("off", off.into()),
        ("drift", drift.into()),
        ("steps", run.last.step.into()),
        ("status", run.last.status.into()),
    ];
    Finding::new(off < 2e-3 && drift < KEPT, "measured-ball", &values)
}

/// A static pass of regularisation, with the usual settings but for these.
const fn passes(mode: Mode, iterations: usize) -> Option<RegulariseOptions> {
    Some(RegulariseOptions {
        mode,
        iterations,
        ..RegulariseOptions::DEFAULT
    })
}

const LETTER: Figure = Figure {
    number: "2",
    sample: "letter-c",
    colour: Some(FieldName::MeanCurvature),
    quick: false,
    ..PLAIN
};

const MENDED: Figure = Figure {
    steps: Steps::Count(0),
    judge: mended,
    ..PLAIN
};

const VESICLE: Figure = Figure {
    number: "6",
    quick: false,
    judge: vesicle,
    ..PLAIN
};

const REFINED: Figure = Figure {
    number: "10",
    sample: "ellipsoid-p",
    refine: &[&[("level", 2.0)], &[("level", 3.0)]],
    steps: Steps::Count(30),
    judge: refinement,
    ..PLAIN
};

/// Free and without regularisation, in steps of one size, so that meshes are compared at one time.
fn steady(p: f64, dt: f64, o: FlowOptions) -> FlowOptions {
    FlowOptions {
        p,
        dt: Some(dt),
        keep: Vec::new(),
        regularise: Mode::Off,
        ..papers(o)
    }
}

const BALL: Figure = Figure {
    number: "12",
    sample: "ellipsoid-p",
    quick: false,
    judge: ball,
    ..PLAIN
};

pub(super) static FIGURES: &[Figure] = &[
    Figure {
        id: "p-willmore-1",
        number: "1",
        sample: "bumps-kept",
        judge: |run| {
            let (drift, off) = (area_drift(run.first, run.last), off_sphere(run.x));
            let values = [
                ("energy", (run.last.energy / SPHERE).into()),
                ("off", off.into()),
                ("drift", drift.into()),
            ];
            let ok = near(run.last.energy, SPHERE, 6e-3) && off < 1e-3 && drift < KEPT;
            Finding::new(ok, "measured-area-kept", &values)
        },
        ..PLAIN
    },
    Figure {
        id: "p-willmore-2-p0",
        options: |o| papers(FlowOptions { p: 0.0, ..o }),
        steps: Steps::Count(100),
        judge: |run| letter(run, run.last.area < 0.2 * run.first.area),
        ..LETTER
    },
    Figure {
        id: "p-willmore-2-p2",
        options: |o| papers(FlowOptions { p: 2.0, ..o }),
        steps: Steps::Count(160),
        judge: |run| letter(run, near(run.last.energy_normalised, 1.0, 0.01)),
        ..LETTER
    },
    Figure {
        id: "p-willmore-2-p4",
        options: |o| papers(FlowOptions { p: 4.0, ..o }),
        steps: Steps::Count(160),
        judge: |run| letter(run, run.last.area > 1.8 * run.first.area),
        ..LETTER
    },
    Figure {
        id: "p-willmore-3-linear",
        number: "3",
        sample: "bad-mesh",
        regularise: passes(Mode::Linear, 5),
        ..MENDED
    },
    Figure {
        id: "p-willmore-3-nonlinear",
        number: "3",
        sample: "bad-mesh",
        regularise: passes(Mode::Nonlinear, 5),
        ..MENDED
    },
    Figure {
        id: "p-willmore-4",
        number: "4",
        sample: "thin-torus",
        judge: |run| {
            let (energy, volume) = (run.last.energy, run.last.reduced_volume.unwrap_or(0.0));
            let values = [
                ("energy", (energy / CLIFFORD).into()),
                ("volume", volume.into()),
            ];
            let ok = near(energy, CLIFFORD, 0.016) && near(volume, CLIFFORD_VOLUME, 0.012);
            Finding::new(ok, "measured-clifford", &values)
        },
        ..PLAIN
    },
    Figure {
        id: "p-willmore-5",
        number: "5",
        sample: "torus-knot",
        steps: Steps::Count(50),
        quick: false,
        judge: |run| kept(run, |first, last| last > 0.5 * first),
        ..PLAIN
    },
    Figure {
        id: "p-willmore-6",
        sample: "vesicle",
        ..VESICLE
    },
    Figure {
        id: "p-willmore-6-blob",
        sample: "blob",
        ..VESICLE
    },
    Figure {
        id: "p-willmore-7",
        number: "7",
        sample: "rough-mesh",
        regularise: passes(Mode::Linear, 1),
        ..MENDED
    },
    Figure {
        id: "p-willmore-8",
        number: "8",
        sample: "genus-4",
        quick: false,
        judge: |run| {
            let genus = run.info().genus;
            let (first, last) = (run.first.energy, run.last.energy);
            let values = [
                ("genus", genus.map(|g| g as f64).into()),
                ("first", first.into()),
                ("last", last.into()),
                ("energy", (last / (8.0 * PI)).into()),
                ("status", run.last.status.into()),
            ];
            let ok = genus == Some(4) && last > CLIFFORD && last < 8.0 * PI;
            Finding::new(ok, "measured-genus", &values)
        },
        ..PLAIN
    },
    Figure {
        id: "p-willmore-9",
        number: "9",
        sample: "trefoil-kept",
        steps: Steps::Count(60),
        quick: false,
        judge: |run| kept(run, |first, last| last >= first),
        ..PLAIN
    },
    Figure {
        id: "p-willmore-9-off",
        number: "9",
        sample: "trefoil-kept",
        options: |o| {
            papers(FlowOptions {
                regularise: Mode::Off,
                ..o
            })
        },
        quick: false,
        judge: |run| kept(run, |first, last| last < 0.5 * first),
        ..PLAIN
    },
    Figure {
        id: "p-willmore-10-p0",
        options: |o| steady(0.0, 2e-3, o),
        quick: false,
        ..REFINED
    },
    Figure {
        id: "p-willmore-10-p2",
        options: |o| steady(2.0, 2e-4, o),
        ..REFINED
    },
    Figure {
        id: "p-willmore-10-p4",
        options: |o| steady(4.0, 1e-5, o),
        quick: false,
        ..REFINED
    },
    Figure {
        id: "p-willmore-11",
        number: "11",
        sample: "bad-mesh",
        options: |o| {
            papers(FlowOptions {
                regularise: Mode::Off,
                keep: Vec::new(),
                tau: Some(1e-4),
                ..o
            })
        },
        regularise: passes(Mode::Nonlinear, 2),
        steps: Steps::Count(1),
        ..MENDED
    },
    Figure {
        id: "p-willmore-12-p0",
        options: |o| papers(FlowOptions { p: 0.0, ..o }),
        ..BALL
    },
    Figure {
        id: "p-willmore-12-p2",
        options: |o| papers(FlowOptions { p: 2.0, ..o }),
        ..BALL
    },
    Figure {
        id: "p-willmore-12-p4",
        options: |o| papers(FlowOptions { p: 4.0, ..o }),
        ..BALL
    },
];
