//! The rows of the options that edits, readings and tables of measurements have.

use super::RegulariseOptions;
use super::bench::{BenchOptions, TableName};
use super::edit::options::{FillOptions, FlipOptions, Loops, RemeshOptions, RepairOptions};
use super::library;
use super::readings::EnergyOptions;
use crate::energy::circle::Boundary;
use crate::flow::option::kind::ids;
use crate::flow::option::{Field, Kind, Named, Options, Range, ReadBy, Row, Value, row};
use crate::remesh::Mode;
use crate::remesh::adaptive::{Creases, Kind as RemeshKind};
use crate::remesh::flips::reduction::Criterion;
use crate::remesh::repair::Weld;
use std::sync::OnceLock;

/// Beyond it |H|^p is no number on any mesh.
const MAX_EXPONENT: f64 = 1e3;

/// Of a length: there is no larger mesh.
const MAX_LENGTH: f64 = 1e100;

impl Options for EnergyOptions {
    #[rustfmt::skip]
    const ROWS: &'static [Row<Self>] = &[
        row!(p, "p", "p",
            Kind::Numbers(Range::closed(0.0, MAX_EXPONENT)), "", Functional, ReadBy::COMMAND),
        row!(boundary, "boundary", "boundary",
            Kind::choice::<Boundary>(), "", Surface, ReadBy::COMMAND),
    ];
}

/// What slides vertices.
fn sliding() -> &'static [&'static str] {
    static MODES: OnceLock<Vec<&str>> = OnceLock::new();
    MODES.get_or_init(|| {
        let off = Mode::Off.value();
        let modes = ids::<Mode>().iter().copied();
        modes
            .filter(|id| off != Value::Text((*id).into()))
            .collect()
    })
}

impl Options for RegulariseOptions {
    #[rustfmt::skip]
    const ROWS: &'static [Row<Self>] = &[
        row!(mode, "mode", "mode", Kind::Choice(sliding), "", Method, ReadBy::COMMAND),
        row!(epsilon, "epsilon", "epsilon",
            Kind::Number(Range::positive(1e3)), "", Method, ReadBy::COMMAND),
        row!(iterations, "iterations", "iterations",
            Kind::Number(Range::count(0.0)), "", Budget, ReadBy::COMMAND),
        row!(features, "features", "features",
            Kind::Number(Range::closed(0.0, 1e6)), "", Method, ReadBy::COMMAND),
    ];
}

impl Field for Loops {
    fn value(&self) -> Value {
        match self {
            Self::Usual => Value::Absent,
            Self::Some(loops) => loops.value(),
            Self::Word(word) => word.value(),
        }
    }

    fn of(value: &Value) -> Option<Self> {
        match value {
            Value::Absent => Some(Self::Usual),
            Value::Text(word) => Some(Self::Word(word.clone())),
            value => Vec::of(value).map(Self::Some),
        }
    }
}

impl Options for FillOptions {
    #[rustfmt::skip]
    const ROWS: &'static [Row<Self>] = &[
        row!(loops, "loops", "loops",
            Kind::Numbers(Range::count(0.0)), "", Surface, ReadBy::COMMAND)
            .or("small").words(&["all"]),
        row!(connect, "connect", "connect", Kind::Switch, "", Surface, ReadBy::COMMAND),
        row!(max_vertices, "maxVertices", "max-vertices",
            Kind::Number(Range::count(0.0)), "vertices", Budget, ReadBy::COMMAND).or("auto"),
    ];
}

impl Field for Weld {
    fn value(&self) -> Value {
        match self {
            Self::Auto => Value::Absent,
            Self::Off => Value::Text("off".into()),
            Self::Within(length) => length.value(),
        }
    }

    fn of(value: &Value) -> Option<Self> {
        match value {
            Value::Absent => Some(Self::Auto),
            Value::Text(word) if word == "off" => Some(Self::Off),
            value => f64::of(value).map(Self::Within),
        }
    }
}

impl Options for RepairOptions {
    #[rustfmt::skip]
    const ROWS: &'static [Row<Self>] = &[
        row!(weld, "weld", "weld", Kind::Number(Range::positive(MAX_LENGTH)), "length",
            Surface, ReadBy::COMMAND).or("auto").words(&["off"]),
    ];
}

impl Options for FlipOptions {
    // Whether the flips are listed is no choice of a user's: it depends on who asks.
    #[rustfmt::skip]
    const ROWS: &'static [Row<Self>] = &[
        row!(criterion, "criterion", "criterion",
            Kind::choice::<Criterion>(), "", Functional, ReadBy::COMMAND),
        row!(guard_folds, "guardFolds", "guard-folds",
            Kind::Switch, "", Functional, ReadBy::COMMAND),
        row!(max, "max", "max",
            Kind::Number(Range::count(0.0)), "flips", Budget, ReadBy::COMMAND).or("all"),
    ];
}

impl Named for RemeshKind {}

impl Named for Creases {}

impl Options for RemeshOptions {
    #[rustfmt::skip]
    const ROWS: &'static [Row<Self>] = &[
        row!(kind, "kind", "kind", Kind::choice::<RemeshKind>(), "", Method, ReadBy::COMMAND),
        row!(target, "target", "target",
            Kind::Number(Range::positive(1e300)), "length", Budget, ReadBy::COMMAND).or("auto"),
        row!(vertices, "vertices", "vertices",
            Kind::Number(Range::count(4.0)), "vertices", Budget, ReadBy::COMMAND).or("auto"),
        row!(creases, "creases", "creases",
            Kind::choice::<Creases>(), "", Method, ReadBy::COMMAND),
    ];
}

impl Named for TableName {}

fn figure_ids() -> &'static [&'static str] {
    static IDS: OnceLock<Vec<&str>> = OnceLock::new();
    IDS.get_or_init(|| library::figures().map(|figure| figure.id).collect())
}

impl Options for BenchOptions {
    // The meshes are no option that a text could hold.
    #[rustfmt::skip]
    const ROWS: &'static [Row<Self>] = &[
        row!(table, "table", "table", Kind::choice::<TableName>(), "", Flow, ReadBy::COMMAND),
        row!(max_vertices, "maxVertices", "max-vertices",
            Kind::Number(Range::count(1.0)), "vertices", Budget, ReadBy::COMMAND).or("all"),
        row!(steps, "steps", "steps",
            Kind::Number(Range::count(1.0)), "steps", Budget, ReadBy::COMMAND),
        row!(figures, "figures", "figures",
            Kind::Set(figure_ids), "", Surface, ReadBy::COMMAND).or("all"),
        row!(quick, "quick", "quick", Kind::Switch, "", Budget, ReadBy::COMMAND),
    ];
}
