//! Minimal mean-curvature variation: the first step and a later one, steps to rest, and forming
//! and solving the system in table 5.1 of Xu & Zhang [XZ06](crate::bibliography#xz06), measured
//! on another machine.

use super::{BenchOptions, Measurement, Row, Table, median, megabytes, named, step, times};
use crate::app::library::{Holes, Shape};
use crate::app::{Fault, Session};
use crate::flow::options::FlowOptions;
use crate::flow::spec::FlowName;
use std::ops::ControlFlow;

pub(super) const TABLE: Table = Table {
    columns: &[
        "figure",
        "free",
        "first",
        "step",
        "assemble",
        "factor",
        "solve",
        "search",
        "regularise",
        "steps",
        "megabytes",
        "paperUnknowns",
        "paperSteps",
        "paper",
        "ratio",
    ],
    left: 1,
    digits: None,
    measurements,
};

/// Of the paper's table.
#[derive(Clone, Copy)]
struct Paper {
    /// Three a vertex.
    unknowns: usize,
    steps: usize,
    /// Seconds of one step for forming the system …
    forming: f64,
    /// … and for solving it.
    solving: f64,
}

impl Paper {
    fn milliseconds(self) -> f64 {
        1e3 * (self.forming + self.solving)
    }
}

#[derive(Clone, Copy)]
struct Case {
    figure: &'static str,
    shape: Shape,
    holes: Holes,
    paper: Option<Paper>,
}

const fn case(
    figure: &'static str,
    name: &'static str,
    parameters: &'static [(&'static str, f64)],
    holes: Holes,
    paper: Option<(usize, usize, f64, f64)>,
) -> Case {
    let paper = match paper {
        None => None,
        Some((unknowns, steps, forming, solving)) => Some(Paper {
            unknowns,
            steps,
            forming,
            solving,
        }),
    };
    let shape = Shape { name, parameters };
    Case {
        figure,
        shape,
        holes,
        paper,
    }
}

/// The figures that are made by code; then larger ones. The surfaces of figures 5.2 and 5.3 are
/// not published: these have as many unknowns, of 5.2 tubes with their inner ends connected.
// A table reads best by lines.
#[rustfmt::skip]
const CASES: &[Case] = &{
    use Holes::{All, Blended, Open};
    [
        case("5.1(c)", "cylinder-gaps", &[], Open, Some((3480, 100, 0.12, 2.11))),
        case("5.1(f)", "sphere-openings", &[], Open, Some((11160, 350, 0.42, 6.72))),
        case("5.2(c), 2 tubes", "tubes", &[("count", 2.0), ("around", 43.0)],
            Blended(&[0, 2]), Some((3222, 5, 0.12, 1.62))),
        case("5.2(f), 3 tubes", "tubes", &[("count", 3.0), ("around", 43.0)],
            Blended(&[0, 2, 4]), Some((4410, 50, 0.17, 2.75))),
        case("5.2(i), 6 tubes", "tubes", &[("count", 6.0), ("around", 30.0)],
            Blended(&[0, 2, 4, 6, 8, 10]), Some((2400, 10, 0.09, 1.43))),
        case("5.3(c), 3 holes", "holed-sphere", &[("holes", 3.0), ("radius", 0.265)],
            All, Some((1296, 10, 0.05, 1.26))),
        case("5.4(b)", "dodecahedron", &[], Open, None),
        case("5.6(c)", "four-bumps", &[], Open, Some((2520, 5, 0.09, 1.5))),
        case("5.6(c), 45", "four-bumps", &[("vertices", 45.0)], Open, None),
        case("5.6(c), 81", "four-bumps", &[("vertices", 81.0)], Open, None),
        case("5.6(c), 121", "four-bumps", &[("vertices", 121.0)], Open, None),
        case("5.6(c), 151", "four-bumps", &[("vertices", 151.0)], Open, None),
        case("5.6(c), 291", "four-bumps", &[("vertices", 291.0)], Open, None),
        case("5.6(c), 421", "four-bumps", &[("vertices", 421.0)], Open, None),
    ]
};

/// Steps in which each comes to rest.
const MOST_STEPS: usize = 60;

fn measurements(options: &BenchOptions) -> Vec<Measurement> {
    let (count, limits) = (options.steps, options.max_vertices);
    let measurement = |case: &'static Case| -> Measurement {
        Box::new(move || measured(case, count, limits.unwrap_or(usize::MAX)))
    };
    CASES.iter().map(measurement).collect()
}

fn measured(case: &Case, count: usize, most: usize) -> Result<Vec<Row>, Fault> {
    let mut session = Session::new();
    if case.shape.load(&mut session, &[])?.info.vertices > most {
        return Ok(Vec::new());
    }
    if let Some(fill) = case.holes.options() {
        session.fill(&fill, &mut |_, _| ControlFlow::Continue(()))?;
    }
    let configured = session.configure(FlowOptions {
        flow: FlowName::Mmcv,
        max_steps: Some(MOST_STEPS),
        ..FlowOptions::default()
    })?;
    let first = step(&mut session)?.milliseconds;
    let mut reports = Vec::new();
    while !session.state()?.status.is_final() {
        // A run may end without a further one.
        reports.extend(session.step()?);
    }
    let later = &reports[..count.min(reports.len())];
    let mut row = times(later);
    let milliseconds = median(later.iter().map(|report| report.milliseconds));
    let status = named(session.state()?.status);
    row.extend([
        ("figure", case.figure.into()),
        ("free", configured.free_vertices.into()),
        ("first", first.into()),
        ("steps", format!("{} {status}", reports.len() + 1).into()),
        ("megabytes", megabytes()),
    ]);
    if let Some(paper) = case.paper {
        row.extend([
            ("paperUnknowns", paper.unknowns.into()),
            ("paperSteps", paper.steps.into()),
            ("paper", paper.milliseconds().into()),
            (
                "ratio",
                milliseconds.map(|ours| paper.milliseconds() / ours).into(),
            ),
        ]);
    }
    Ok(vec![row])
}
