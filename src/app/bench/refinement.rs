//! Energies of surfaces that are known, at several resolutions, with observed orders.

use super::{BenchOptions, Measurement, Row, Table};
use crate::app::Fault;
use crate::app::library::Shape;
use crate::app::study::{Limits, Study};

pub(super) const TABLE: Table = Table {
    columns: &[
        "shape",
        "vertices",
        "h",
        "area",
        "areaOrder",
        "circle",
        "circleOrder",
        "cotangent",
        "cotangentOrder",
        "fitted",
        "fittedOrder",
    ],
    left: 1,
    digits: Some(5),
    measurements,
};

const fn shape(name: &'static str, parameters: &'static [(&'static str, f64)]) -> Shape {
    Shape { name, parameters }
}

#[rustfmt::skip]
const SHAPES: &[Shape] = &[
    shape("icosphere", &[("level", 2.0)]),
    shape("torus", &[("major", 1.0), ("minor", 0.4), ("around", 28.0), ("tube", 14.0)]),
    shape("sampled-torus", &[("jitter", 0.0)]),
    shape("lattice-torus", &[("columns", 26.0), ("rows", 30.0), ("shear", 0.5)]),
    shape("icosahedron", &[("level", 2.0)]),
];

fn measurements(options: &BenchOptions) -> Vec<Measurement> {
    let most = options.max_vertices.unwrap_or(usize::MAX);
    let measurement =
        |shape: &'static Shape| -> Measurement { Box::new(move || rows(shape, most)) };
    SHAPES.iter().map(measurement).collect()
}

fn rows(shape: &Shape, most: usize) -> Result<Vec<Row>, Fault> {
    let parameters = shape.parameters.iter();
    let parameters = parameters.map(|(name, value)| ((*name).into(), *value));
    let mut study = Study::of_shape(shape.name, &parameters.collect(), 2.0, Limits::default())?;
    let report = loop {
        study.refine()?;
        let report = study.report();
        if report.finished {
            break report;
        }
    };
    let resolutions = report.rows.iter().take_while(|row| row.vertices <= most);
    let row = |(level, resolution): (usize, &crate::app::Resolution)| {
        let name = if level == 0 { shape.name } else { "" };
        let mut row: Row = vec![
            ("shape", name.into()),
            ("vertices", resolution.vertices.into()),
            ("h", resolution.h.into()),
        ];
        for trend in &report.trends {
            row.push((trend.quantity, trend.values[level].into()));
            if let Some(column) = order_of(trend.quantity) {
                // Two digits of an order are all that it has.
                let order = trend.orders[level].map(|order| (100.0 * order).round() / 100.0);
                row.push((column, order.into()));
            }
        }
        row
    };
    Ok(resolutions.enumerate().map(row).collect())
}

/// The column of a quantity's order.
fn order_of(quantity: &str) -> Option<&'static str> {
    let name = format!("{quantity}Order");
    TABLE.columns.iter().copied().find(|column| *column == name)
}
