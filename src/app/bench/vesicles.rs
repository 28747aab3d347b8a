//! The phase diagram of vesicles: every shape of it, beside what the smooth one has.

use super::{BenchOptions, Measurement, Row, Table, milliseconds, named};
use crate::app::Session;
use crate::app::phases::{self, Branch, Phase};
use crate::flow::option::kind::id_of;
use std::cell::RefCell;
use std::rc::Rc;
use web_time::Instant;

pub(super) const TABLE: Table = Table {
    columns: &[
        "branch",
        "reducedVolume",
        "energy",
        "expected",
        "percentOff",
        "status",
        "milliseconds",
    ],
    left: 1,
    digits: Some(5),
    measurements,
};

/// Branches that cross, and the reduced volume where they do.
const CROSSINGS: [(Branch, Branch, f64); 2] = [
    (Branch::Prolate, Branch::Oblate, 0.651),
    (Branch::Oblate, Branch::Stomatocyte, 0.592),
];

fn measurements(_: &BenchOptions) -> Vec<Measurement> {
    let found = Rc::new(RefCell::new(Vec::new()));
    let shape = |number: usize| -> Measurement {
        let found = Rc::clone(&found);
        Box::new(move || {
            let begun = Instant::now();
            let phase = Session::new().phase(number)?;
            let row = phase.map(|phase| {
                let row = row(&phase, milliseconds(begun));
                found.borrow_mut().push(phase);
                row
            });
            Ok(row.into_iter().collect())
        })
    };
    let mut all: Vec<Measurement> = (0..phases::COUNT).map(shape).collect();
    all.push(Box::new(move || Ok(crossings(&found.borrow()))));
    all
}

fn row(phase: &Phase, milliseconds: f64) -> Row {
    vec![
        ("branch", id_of(&phase.branch).into()),
        ("reducedVolume", phase.reduced_volume.into()),
        ("energy", phase.energy.into()),
        ("expected", phase.expected.into()),
        (
            "percentOff",
            phase.expected.map(|e| off(phase.energy, e)).into(),
        ),
        ("status", named(phase.status).into()),
        ("milliseconds", milliseconds.round().into()),
    ]
}

fn off(found: f64, expected: f64) -> f64 {
    let percent = 100.0 * (found / expected - 1.0);
    (100.0 * percent).round() / 100.0
}

fn crossings(found: &[Phase]) -> Vec<Row> {
    let crossing = |(one, other, expected): (Branch, Branch, f64)| {
        let at = phases::crossing(found, one, other);
        vec![
            (
                "branch",
                format!("{} = {}", id_of(&one), id_of(&other)).into(),
            ),
            ("reducedVolume", at.into()),
            ("expected", expected.into()),
        ]
    };
    CROSSINGS.map(crossing).into()
}
