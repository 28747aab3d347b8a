//! What the documentation says of speed and of results, measured on the machine at hand: tables,
//! a row a call.
//!
//! A column is a key of JSON, and stays. A table makes a list of measurements, each of which
//! works on surfaces of its own and gives some rows. Times are wall-clock milliseconds; of several
//! steps their median.

mod circle;
mod figures;
mod flips;
mod mmcv;
mod p_willmore;
mod refinement;
mod repair;
mod robustness;
mod vesicles;

use super::fault::Fault;
use super::message::AppError;
use super::unpacked::OpenedFile;
use super::{Loaded, Session};
use crate::flow::option::OptionError;
use crate::flow::option::kind::{Kind, id_of};
use crate::flow::{Status, StepReport};
use crate::message::Value;
use serde::{Deserialize, Serialize};
use std::collections::VecDeque;
use web_time::Instant;

/// Which table.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Deserialize, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "kebab-case")]
pub enum TableName {
    /// Steps of the circle-angle flow on tori.
    Circle,
    /// Steps of the p-Willmore flow, beside table 1 of its paper.
    PWillmore,
    /// Edge flips to the end.
    Flips,
    /// Minimal mean-curvature variation, beside table 5.1 of its paper.
    Mmcv,
    /// Energies under refinement.
    Refinement,
    /// Loose triangles made a surface.
    Repair,
    /// How flows end, left to themselves.
    Robustness,
    /// The phase diagram of vesicles.
    Vesicles,
    /// The figures of the papers.
    Figures,
}

/// What is measured.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase", default, deny_unknown_fields)]
pub struct BenchOptions {
    /// Which table; there must be one.
    pub table: Option<TableName>,
    /// Larger meshes are left out.
    pub max_vertices: Option<usize>,
    /// Steps measured a row, after one that is not.
    pub steps: usize,
    /// Of the table of figures these, by their ids.
    pub figures: Option<Vec<String>>,
    /// Of the table of figures those that take a few seconds.
    pub quick: bool,
    /// Of the table of robustness: meshes to try instead of shapes with noise.
    pub meshes: Vec<OpenedFile>,
}

impl Default for BenchOptions {
    fn default() -> Self {
        Self {
            table: None,
            max_vertices: None,
            steps: 3,
            figures: None,
            quick: false,
            meshes: Vec::new(),
        }
    }
}

impl BenchOptions {
    /// Whether a mesh of so many vertices is measured.
    fn takes(&self, vertices: usize) -> bool {
        self.max_vertices.is_none_or(|most| vertices <= most)
    }

    /// The table.
    ///
    /// # Errors
    /// Where there is none, and options that another table reads.
    pub fn check(&self) -> Result<TableName, OptionError> {
        let table = self.table.ok_or_else(|| OptionError::MissingOption {
            name: "table",
            allowed: Kind::choice::<TableName>().allowed(),
        })?;
        let read = [
            ("figures", self.figures.is_some(), TableName::Figures),
            ("quick", self.quick, TableName::Figures),
            ("meshes", !self.meshes.is_empty(), TableName::Robustness),
        ];
        match read
            .into_iter()
            .find(|(_, given, by)| *given && *by != table)
        {
            Some((name, _, by)) => Err(OptionError::LoneOption {
                name,
                other: "table",
                value: id_of(&by),
            }),
            None => Ok(table),
        }
    }
}

/// Readings of one row by their columns, in any order; what is missing is not known.
type Row = Vec<(&'static str, Value)>;

/// One measurement, of some rows.
type Measurement = Box<dyn FnOnce() -> Result<Vec<Row>, Fault>>;

/// How a table is measured and shown.
struct Table {
    /// Keys of a row, in order.
    columns: &'static [&'static str],
    /// How many of them are set flush left.
    left: usize,
    /// Significant digits of a number that is not whole; none: one after the point.
    digits: Option<usize>,
    /// What there is to measure.
    measurements: fn(&BenchOptions) -> Vec<Measurement>,
}

impl TableName {
    fn table(self) -> &'static Table {
        match self {
            Self::Circle => &circle::TABLE,
            Self::PWillmore => &p_willmore::TABLE,
            Self::Flips => &flips::TABLE,
            Self::Mmcv => &mmcv::TABLE,
            Self::Refinement => &refinement::TABLE,
            Self::Repair => &repair::TABLE,
            Self::Robustness => &robustness::TABLE,
            Self::Vesicles => &vesicles::TABLE,
            Self::Figures => &figures::TABLE,
        }
    }
}

/// A table as far as it has come.
#[derive(Clone, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub struct BenchReport {
    /// Keys of a row, in order.
    pub columns: Vec<&'static str>,
    /// How many of them are set flush left.
    pub left: usize,
    /// Significant digits of a number that is not whole; none: one after the point.
    pub digits: Option<usize>,
    /// The next row, a cell a column; none after the last.
    #[cfg_attr(test, ts(type = "unknown[] | null"))]
    pub row: Option<Vec<Value>>,
}

/// A table under way.
pub struct Bench {
    table: &'static Table,
    measurements: VecDeque<Measurement>,
    measured: VecDeque<Row>,
}

impl Bench {
    /// Nothing is measured yet.
    ///
    /// # Errors
    /// As [`BenchOptions::check`].
    pub fn new(options: &BenchOptions) -> Result<Self, OptionError> {
        let table = options.check()?.table();
        Ok(Self {
            table,
            measurements: (table.measurements)(options).into(),
            measured: VecDeque::new(),
        })
    }

    /// Measures until there is a row.
    ///
    /// # Errors
    /// What refuses to be measured.
    pub fn advance(&mut self) -> Result<BenchReport, Fault> {
        while self.measured.is_empty() {
            let Some(measure) = self.measurements.pop_front() else {
                break;
            };
            self.measured.extend(measure()?);
        }
        let columns = self.table.columns;
        let row = self.measured.pop_front().map(|row| {
            debug_assert!(row.iter().all(|(name, _)| columns.contains(name)));
            let cell = |column: &&str| {
                let found = row.iter().find(|(name, _)| name == column);
                found.map_or(Value::None, |(_, value)| value.clone())
            };
            columns.iter().map(cell).collect()
        });
        Ok(BenchReport {
            columns: columns.to_vec(),
            left: self.table.left,
            digits: self.table.digits,
            row,
        })
    }
}

impl Session {
    /// A table of measurements, a row a call: with `options` it begins anew. The surface, its
    /// flow and its history stay as they are.
    ///
    /// # Errors
    /// As [`Bench::new`] and [`Bench::advance`], and going on with what has not begun.
    pub fn bench(&mut self, options: Option<&BenchOptions>) -> Result<BenchReport, Fault> {
        if let Some(options) = options {
            self.bench = Some(Bench::new(options)?);
        }
        self.bench.as_mut().ok_or(AppError::NoBench)?.advance()
    }
}

/// A session with a sample shape.
fn shaped(name: &str, parameters: &[(&str, f64)]) -> Result<(Session, Loaded), Fault> {
    let mut session = Session::new();
    let named = |(name, value): &(&str, f64)| ((*name).to_owned(), *value);
    let parameters: Vec<_> = parameters.iter().map(named).collect();
    let loaded = session.sample(name, &parameters)?;
    Ok((session, loaded))
}

/// A step, which there must be.
fn step(session: &mut Session) -> Result<StepReport, Fault> {
    match session.step()? {
        Some(report) => Ok(report),
        None => {
            let reason = session.state()?.message;
            Err(AppError::NoStep { reason }.into())
        }
    }
}

fn steps(session: &mut Session, count: usize) -> Result<Vec<StepReport>, Fault> {
    (0..count).map(|_| step(session)).collect()
}

/// Medians of what steps took, all of it and its parts.
fn times(reports: &[StepReport]) -> Row {
    let of = |time: fn(&StepReport) -> f64| Value::from(median(reports.iter().map(time)));
    vec![
        ("step", of(|r| r.milliseconds)),
        ("assemble", of(|r| r.assemble_milliseconds)),
        ("factor", of(|r| r.factor_milliseconds)),
        ("solve", of(|r| r.solve_milliseconds)),
        ("search", of(|r| r.search_milliseconds)),
        ("regularise", of(|r| r.regularise_milliseconds)),
    ]
}

fn rejected(reports: &[StepReport]) -> usize {
    reports.iter().map(|report| report.rejected).sum()
}

/// The upper one of two in the middle; none of nothing.
fn median(values: impl Iterator<Item = f64>) -> Option<f64> {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied()
}

fn milliseconds(since: Instant) -> f64 {
    since.elapsed().as_secs_f64() * 1e3
}

/// The most memory that there was, which in wasm never shrinks; not known elsewhere.
fn megabytes() -> Value {
    #[cfg(target_arch = "wasm32")]
    return Value::from(core::arch::wasm32::memory_size::<0>() as f64 * 65_536.0 / 1e6);
    #[cfg(not(target_arch = "wasm32"))]
    Value::None
}

/// What its JSON says of a status.
fn named(status: Status) -> &'static str {
    id_of(&status)
}
