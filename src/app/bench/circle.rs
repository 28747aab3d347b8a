//! One step of the circle-angle flow on a torus, and one trial of a step.

use super::{BenchOptions, Measurement, Table, median, rejected, shaped, step, steps, times};
use crate::flow::options::FlowOptions;
use crate::flow::spec::FlowName;

pub(super) const TABLE: Table = Table {
    columns: &[
        "vertices",
        "faces",
        "assemble",
        "factor",
        "solve",
        "search",
        "regularise",
        "step",
        "trial",
        "rejected",
    ],
    left: 1,
    digits: None,
    measurements,
};

/// Sides of square lattices on a torus: 2.6, 10, 37, 100 and 350 thousand vertices.
const SIDES: [usize; 5] = [51, 100, 192, 316, 592];

fn measurements(options: &BenchOptions) -> Vec<Measurement> {
    let count = options.steps;
    let sides = SIDES.into_iter().filter(|side| options.takes(side * side));
    let measurement = |side: usize| -> Measurement {
        Box::new(move || {
            let side = side as f64;
            let (mut session, loaded) = shaped("torus", &[("around", side), ("tube", side)])?;
            session.configure(FlowOptions {
                flow: FlowName::Circle,
                max_steps: Some(count + 1),
                ..FlowOptions::default()
            })?;
            // The first step also analyses the matrix's pattern.
            step(&mut session)?;
            let reports = steps(&mut session, count)?;
            let trials = reports
                .iter()
                .map(|r| r.milliseconds / (1 + r.rejected) as f64);
            let mut row = times(&reports);
            row.extend([
                ("vertices", loaded.info.vertices.into()),
                ("faces", loaded.info.faces.into()),
                ("trial", median(trials).into()),
                ("rejected", rejected(&reports).into()),
            ]);
            Ok(vec![row])
        })
    };
    sides.map(measurement).collect()
}
