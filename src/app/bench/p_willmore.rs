//! The p-Willmore flow, p = 2, on a torus: a step with area and volume kept and nonlinear
//! regularisation, or one pass of regularisation alone, beside table 1 of Gruber & Aulisa
//! [GA20](crate::bibliography#ga20), measured on another machine.

use super::{
    BenchOptions, Measurement, Table, megabytes, milliseconds, rejected, shaped, step, steps, times,
};
use crate::app::RegulariseOptions;
use crate::flow::constraint::Kept;
use crate::flow::options::{FlowOptions, Remeshing};
use crate::flow::spec::FlowName;
use crate::message::Value;
use crate::remesh::Mode;
use web_time::Instant;

pub(super) const TABLE: Table = Table {
    columns: &[
        "case",
        "faces",
        "first",
        "step",
        "assemble",
        "factor",
        "solve",
        "search",
        "regularise",
        "rejected",
        "megabytes",
        "paper",
    ],
    left: 1,
    digits: None,
    measurements,
};

/// The paper's size as a torus: points around and of the tube.
const RESTING: [usize; 2] = [150, 115];
/// A pass, and the paper's milliseconds.
const PASSES: [(Mode, &str, f64); 2] = [
    (Mode::Linear, "regularise, linear", 2100.0),
    (Mode::Nonlinear, "regularise, nonlinear", 4300.0),
];
/// The paper's sizes as tori, and its milliseconds a step.
const STEPPING: [([usize; 2], f64); 3] = [
    ([92, 50], 16_600.0),
    ([100, 86], 27_500.0),
    ([500, 346], 707_000.0),
];

fn measurements(options: &BenchOptions) -> Vec<Measurement> {
    let count = options.steps;
    let takes = |[around, tube]: [usize; 2]| options.takes(around * tube);
    let passes = PASSES.into_iter().filter(|_| takes(RESTING)).map(pass);
    let stepping = STEPPING.into_iter().filter(|(size, _)| takes(*size));
    passes
        .chain(stepping.map(|case| stepped(case, count)))
        .collect()
}

fn torus([around, tube]: [usize; 2]) -> [(&'static str, f64); 2] {
    [("around", around as f64), ("tube", tube as f64)]
}

fn pass((mode, name, paper): (Mode, &'static str, f64)) -> Measurement {
    Box::new(move || {
        let (mut session, loaded) = shaped("torus", &torus(RESTING))?;
        let begun = Instant::now();
        session.regularise(&RegulariseOptions {
            mode,
            iterations: 1,
            features: 0.0,
            ..RegulariseOptions::DEFAULT
        })?;
        Ok(vec![vec![
            ("case", name.into()),
            ("faces", loaded.info.faces.into()),
            ("first", milliseconds(begun).into()),
            ("megabytes", megabytes()),
            ("paper", paper.into()),
        ]])
    })
}

fn stepped((size, paper): ([usize; 2], f64), count: usize) -> Measurement {
    Box::new(move || {
        let (mut session, loaded) = shaped("torus", &torus(size))?;
        session.configure(FlowOptions {
            flow: FlowName::PWillmore,
            keep: vec![Kept::Area, Kept::Volume],
            max_steps: Some(count + 1),
            remesh: Remeshing::Off,
            ..FlowOptions::default()
        })?;
        let first = step(&mut session)?.milliseconds;
        let reports = steps(&mut session, count)?;
        let mut row = times(&reports);
        row.extend([
            ("case", Value::from("step")),
            ("faces", loaded.info.faces.into()),
            ("first", first.into()),
            ("rejected", rejected(&reports).into()),
            ("megabytes", megabytes()),
            ("paper", paper.into()),
        ]);
        Ok(vec![row])
    })
}
