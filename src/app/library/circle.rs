//! Figures of Bobenko & Schröder, Discrete Willmore Flow [BS05](crate::bibliography#bs05).

use super::figure::{Figure, Finding, Steps};
use super::measure::{TorusFit, near, off_plane, off_sphere};
use super::measured::Run;
use super::sample::Shape;
use crate::energy::circle::Boundary;
use crate::flow::Status;
use crate::flow::options::{FlowOptions, Scheme};
use std::f64::consts::PI;

const PLAIN: Figure = Figure {
    paper: "circle",
    ..Figure::PLAIN
};

/// What the undamaged stone comes to rest at.
const STONE: f64 = 6.408;

fn energy(run: &Run<'_>, ok: bool) -> Finding {
    let (first, last) = (run.first.energy, run.last.energy);
    Finding::new(
        ok,
        "measured-energy",
        &[("first", first.into()), ("last", last.into())],
    )
}

fn plane(run: &Run<'_>, holds: fn(energy: [f64; 2], off: f64) -> bool) -> Finding {
    let (first, last) = (run.first.energy, run.last.energy);
    let off = off_plane(run.x);
    let values = [
        ("first", first.into()),
        ("last", last.into()),
        ("off", off.into()),
    ];
    Finding::new(holds([first, last], off), "measured-plane", &values)
}

/// `share` of the distance from the clean surface at the start.
fn noise(run: &Run<'_>, share: f64) -> Finding {
    let (first, last) = (run.first.energy, run.last.energy);
    let [before, after] = run.off_reference();
    let values = [
        ("first", first.into()),
        ("last", last.into()),
        ("ratio", (after / before).into()),
    ];
    Finding::new(
        last < first && after < share * before,
        "measured-noise",
        &values,
    )
}

const fn scan(id: &'static str, steps: usize) -> Figure {
    Figure {
        id,
        number: "12",
        sample: "range-scan",
        reference: Some(Shape {
            name: "scan-clean",
            parameters: &[("resolution", 285.0), ("loops", 88.0)],
        }),
        steps: Steps::Count(steps),
        ..PLAIN
    }
}

fn smoothed(steps: usize, o: FlowOptions) -> FlowOptions {
    FlowOptions {
        tau: Some(0.01),
        smooth_steps: steps,
        boundary: Some(Boundary::Fixed),
        ..o
    }
}

pub(super) static FIGURES: &[Figure] = &[
    Figure {
        id: "circle-6",
        number: "6",
        sample: "icosahedron",
        options: |o| FlowOptions {
            scheme: Scheme::Paper,
            dt: Some(0.0345),
            ..o
        },
        steps: Steps::Count(24),
        judge: |run| {
            let (first, last) = (run.first.energy, run.last.energy);
            let off = off_sphere(run.x);
            let values = [
                ("first", (first / PI).into()),
                ("last", last.into()),
                ("steps", run.last.step.into()),
                ("off", off.into()),
            ];
            let ok = near(first, 60.0 * PI, 1e-9) && last <= 1e-7 && off < 1e-3;
            Finding::new(ok, "measured-round", &values)
        },
        ..PLAIN
    },
    Figure {
        id: "circle-6-adaptive",
        number: "6",
        sample: "icosahedron",
        judge: |run| {
            let (last, steps, status) = (run.last.energy, run.last.step, run.last.status);
            let values = [
                ("last", last.into()),
                ("steps", steps.into()),
                ("status", status.into()),
            ];
            let ok = last <= 1e-7 && steps <= 12 && status == Status::Converged;
            Finding::new(ok, "measured-rest", &values)
        },
        ..PLAIN
    },
    Figure {
        id: "circle-7-fixed",
        number: "7",
        sample: "saddle",
        options: |o| FlowOptions {
            boundary: Some(Boundary::Fixed),
            ..o
        },
        steps: Steps::Count(100),
        judge: |run| plane(run, |[first, last], off| last < 0.1 * first && off > 0.1),
        ..PLAIN
    },
    Figure {
        id: "circle-7-free",
        number: "7",
        sample: "saddle",
        steps: Steps::Count(100),
        judge: |run| plane(run, |[_, last], off| last < 1e-6 && off < 1e-4),
        ..PLAIN
    },
    Figure {
        id: "circle-8",
        number: "8",
        sample: "coarse-torus",
        options: |o| FlowOptions {
            scheme: Scheme::Paper,
            tau: Some(0.01),
            ..o
        },
        steps: Steps::Count(100),
        judge: |run| {
            let (first, last) = (run.first.energy, run.last.energy);
            let off = TorusFit::of(run.x).off;
            let values = [
                ("first", first.into()),
                ("last", last.into()),
                ("off", (100.0 * off).into()),
            ];
            let ok = near(first, 764.397, 1e-5) && near(last, 57.0, 0.05) && off < 0.025;
            Finding::new(ok, "measured-torus", &values)
        },
        ..PLAIN
    },
    Figure {
        id: "circle-8-long",
        number: "8",
        sample: "coarse-torus",
        options: |o| FlowOptions {
            scheme: Scheme::Paper,
            tau: Some(0.003),
            ..o
        },
        steps: Steps::Count(1000),
        quick: false,
        judge: |run| {
            let [first, last] = [run.start, run.x].map(TorusFit::of);
            let values = [
                ("first", first.ratio().into()),
                ("last", last.ratio().into()),
                ("off", (100.0 * last.off).into()),
            ];
            let ok = (last.ratio() - 2.04).abs() < 0.02 && last.off < 0.015;
            Finding::new(ok, "measured-proportions", &values)
        },
        ..PLAIN
    },
    Figure {
        id: "circle-9",
        number: "9",
        sample: "pipe",
        steps: Steps::Count(50),
        judge: |run| {
            let starts = near(run.first.energy, 398.65, 1e-5);
            energy(run, starts && run.last.energy < 80.0)
        },
        ..PLAIN
    },
    Figure {
        id: "circle-10",
        number: "10",
        sample: "six-sided-hole",
        options: |o| FlowOptions {
            prefill: false,
            ..o
        },
        steps: Steps::Count(100),
        judge: |run| energy(run, run.last.energy < run.first.energy - 60.0),
        ..PLAIN
    },
    Figure {
        id: "circle-11",
        number: "11",
        sample: "scar",
        steps: Steps::Count(20),
        judge: |run| energy(run, near(run.last.energy, STONE, 0.02)),
        ..PLAIN
    },
    Figure {
        options: |o| smoothed(10, o),
        judge: |run| noise(run, 0.7),
        ..scan("circle-12-10", 10)
    },
    Figure {
        options: |o| smoothed(100, o),
        quick: false,
        judge: |run| noise(run, 1.5),
        ..scan("circle-12-100", 100)
    },
];
