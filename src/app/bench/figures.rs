//! The figures of the four papers: what is expected, and what was measured just now.

use super::{BenchOptions, Measurement, Row, Table, milliseconds};
use crate::app::library::{self, Figure, FigureRun, Finding};
use crate::message::{Message, Value};
use web_time::Instant;

pub(super) const TABLE: Table = Table {
    columns: &[
        "id",
        "figure",
        "expected",
        "measured",
        "verdict",
        "steps",
        "milliseconds",
    ],
    left: 4,
    digits: None,
    measurements,
};

fn measurements(options: &BenchOptions) -> Vec<Measurement> {
    let chosen = |figure: &&Figure| {
        let mut ids = options.figures.iter().flatten();
        let is_named = options.figures.is_none() || ids.any(|id| id == figure.id);
        is_named && (figure.quick || !options.quick)
    };
    let figures = library::figures().filter(chosen);
    let measurement = |figure| -> Measurement { Box::new(move || Ok(vec![row(figure)])) };
    figures.map(measurement).collect()
}

/// A figure that cannot be run is a cross, and the others go on.
fn row(figure: &'static Figure) -> Row {
    let begun = Instant::now();
    let mut run = FigureRun::new(figure);
    let Finding { ok, message } = loop {
        match run.advance() {
            Ok(None) => {}
            Ok(Some(finding)) => break finding,
            Err(fault) => {
                let values = [
                    ("kind", fault.kind.into()),
                    ("message", fault.message.into()),
                ];
                break Finding::new(false, "measured-refused", &values);
            }
        }
    };
    vec![
        ("id", figure.id.into()),
        ("figure", words(figure, "")),
        ("expected", words(figure, ".expected")),
        ("measured", message.into()),
        ("verdict", if ok { "✓" } else { "✗" }.into()),
        ("steps", run.steps().into()),
        ("milliseconds", milliseconds(begun).round().into()),
    ]
}

/// What the locale files say of a figure.
fn words(figure: &Figure, part: &str) -> Value {
    // A point in a name would begin a part of it.
    let id = format!("figure-{}{part}", figure.id.replace('.', "-"));
    let values = [("number", figure.number.into())];
    Value::Message(Message {
        id: id.into(),
        values: values.into(),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_figure_that_cannot_be_run_is_a_cross_that_says_why() {
        let mut without_sample = Figure::PLAIN;
        without_sample.id = "none-1.2";
        let row = row(Box::leak(Box::new(without_sample)));
        let value = |column: &str| {
            let found = row.iter().find(|(name, _)| *name == column);
            &found.expect(column).1
        };
        assert_eq!(value("verdict"), &"✗".into());
        let Value::Message(measured) = value("measured") else {
            panic!("it is no message")
        };
        assert_eq!(&*measured.id, "measured-refused");
        assert_eq!(measured.value("kind"), Some(&"NoMesh".into()));
        let Value::Message(figure) = value("figure") else {
            panic!("it is no message")
        };
        assert_eq!(&*figure.id, "figure-none-1-2");
    }
}
