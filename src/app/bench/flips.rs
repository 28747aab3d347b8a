//! Edge flips to the end on a torus of jittered points, its cells cut at random.

use super::{BenchOptions, Measurement, Table, megabytes, milliseconds, shaped};
use crate::app::FlipOptions;
use crate::flow::option::kind::id_of;
use crate::remesh::flips::reduction::Criterion;
use web_time::Instant;

pub(super) const TABLE: Table = Table {
    columns: &[
        "edges",
        "criterion",
        "flips",
        "milliseconds",
        "kiloflips",
        "nanoseconds",
        "megabytes",
    ],
    left: 1,
    digits: None,
    measurements,
};

/// Points around the tube of a torus with twice as many along: 10 to 3000 thousand edges.
const TUBES: [usize; 5] = [42, 128, 200, 224, 708];
/// The shape has so many points at most each way.
const MOST_AROUND: usize = 1000;

fn measurements(options: &BenchOptions) -> Vec<Measurement> {
    let sizes = TUBES.map(|tube| [(2 * tube).min(MOST_AROUND), tube]);
    let sizes = sizes.into_iter().filter(|[a, b]| options.takes(a * b));
    let each = |size| Criterion::ALL.map(|criterion| measurement(size, criterion));
    sizes.flat_map(each).collect()
}

fn measurement([around, tube]: [usize; 2], criterion: Criterion) -> Measurement {
    Box::new(move || {
        let size = [("around", around as f64), ("tube", tube as f64)];
        let (mut session, loaded) = shaped("sampled-torus", &size)?;
        let begun = Instant::now();
        let outcome = session.flip(&FlipOptions {
            criterion,
            ..FlipOptions::default()
        })?;
        let milliseconds = milliseconds(begun);
        let edges = loaded.info.edges as f64;
        Ok(vec![vec![
            ("edges", edges.into()),
            ("criterion", id_of(&criterion).into()),
            ("flips", outcome.flips.into()),
            ("milliseconds", milliseconds.into()),
            ("kiloflips", (outcome.flips as f64 / milliseconds).into()),
            (
                "nanoseconds",
                (1e6 * milliseconds / (edges * edges.log2())).into(),
            ),
            ("megabytes", megabytes()),
        ]])
    })
}
