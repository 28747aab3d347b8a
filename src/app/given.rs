//! What a link, a recipe or a command line gives as options: read and checked before anything is
//! changed.

use super::RegulariseOptions;
use super::bench::BenchOptions;
use super::fault::Fault;
use super::fill::FillOptions;
use super::flip::FlipOptions;
use super::pane::{Arrangement, Compare};
use super::readings::EnergyOptions;
use crate::flow::option::{
    self, Allowed, Kind, Named, OptionError, Options, Range, ReadBy, Row, Value, Values, row,
};
use crate::flow::options::{FlowName, FlowOptions};
use crate::flow::spec::FLIPS;
use serde::{Deserialize, Serialize};

impl Named for Compare {}

/// The flows that something can stand beside.
const WITH_OTHERS: &[FlowName] = &[
    FlowName::MeanCurvature,
    FlowName::SurfaceDiffusion,
    FlowName::Willmore,
    FlowName::Mmcv,
    FlowName::Flips,
];

impl Options for Arrangement {
    // A table reads best by lines.
    #[rustfmt::skip]
    const ROWS: &'static [Row<Self>] = &{
        let flips = ReadBy::flows(FLIPS);
        let several = ReadBy::flows(WITH_OTHERS);
        let levels = Kind::Number(Range::count(0.0).up_to(3.0));
        let count = Kind::Number(Range::count(1.0));
        [
            row!(compare, "compare", "compare", Kind::choice::<Compare>(), "", Display, several),
            row!(subdivide, "subdivide", "subdivide", levels, "", Display, flips),
            row!(flips_per_step, "flipsPerStep", "flips-per-step", count, "flips", Display, flips)
                .or("all"),
        ]
    };
}

/// Options as a link or a recipe has them.
#[derive(Debug, Default, Deserialize)]
#[serde(rename_all = "camelCase", default)]
pub struct Asked {
    /// Words of a link: options of the flow and of the arrangement, as text.
    words: Values,
    /// What each further pane does otherwise, as text.
    panes: Vec<Values>,
    /// Options of flows, of their types, as recipes have them.
    flows: Vec<Values>,
    /// An arrangement, of its types.
    arrangement: Values,
}

/// The same with their types.
#[derive(Debug, Default, PartialEq, Serialize)]
pub struct Given {
    /// Of the flow: those that were given.
    pub options: Values,
    /// Of the arrangement.
    pub arrangement: Values,
    /// Of each further pane.
    pub panes: Vec<Values>,
}

/// Reads and checks all of it.
///
/// # Errors
/// An option that there is not, or a value that it cannot have.
pub fn read_options(asked: &Asked) -> Result<Given, Fault> {
    for flow in &asked.flows {
        option::options_of::<FlowOptions>(flow)?;
    }
    option::options_of::<Arrangement>(&asked.arrangement)?;
    let of_arrangement = |name: &str| Arrangement::ROWS.iter().any(|row| row.name == name);
    let (arranged, words): (Values, Values) = asked
        .words
        .clone()
        .into_iter()
        .partition(|(name, _)| of_arrangement(name));
    Ok(Given {
        options: option::read::<FlowOptions>(&words)?,
        arrangement: option::read::<Arrangement>(&arranged)?,
        panes: asked.panes.iter().map(pane).collect::<Result<_, _>>()?,
    })
}

fn pane(words: &Values) -> Result<Values, OptionError> {
    let values = option::read::<FlowOptions>(words)?;
    if option::options_of::<FlowOptions>(&values)?.flow == FlowName::Flips {
        // They change the mesh: nothing can stand beside them.
        return Err(OptionError::BadOption {
            name: "flow",
            value: FlowName::Flips.id().into(),
            allowed: Allowed::MovingFlow,
        });
    }
    Ok(values)
}

/// Reads the flags of a command by the names of their options; any command that has no options of
/// its own runs a flow.
///
/// # Errors
/// As [`read_options`], and what would change nothing.
pub fn read_flags(command: &str, words: &Values) -> Result<Values, Fault> {
    Ok(match command {
        "energy" => option::read::<EnergyOptions>(words)?,
        "flips" => option::read::<FlipOptions>(words)?,
        "regularise" => option::read::<RegulariseOptions>(words)?,
        "fill" => option::read::<FillOptions>(words)?,
        "bench" => {
            let values = option::read::<BenchOptions>(words)?;
            option::options_of::<BenchOptions>(&values)?.check()?;
            values
        }
        _ => flow_flags(words.clone())?,
    })
}

fn flow_flags(mut words: Values) -> Result<Values, OptionError> {
    let text = |text: &str| Value::Text(text.into());
    // Smoothing takes a set number of steps, and leading a volume keeps it.
    if words.get("goal") == Some(&text("smooth"))
        && let Some(steps) = words.get("maxSteps").cloned()
    {
        words.entry("smoothSteps".into()).or_insert(steps);
    }
    if words.contains_key("reducedVolume") {
        words.entry("keep".into()).or_insert(text("area,volume"));
    }
    option::read_strictly(&words)
}

/// The refusal of a flag that a command with these flags does not have.
pub fn unknown_flag(typed: &str, flags: &[String]) -> Fault {
    let name_of = |flag: &str| {
        let row = FlowOptions::ROWS.iter().find(|row| row.flag == flag);
        row.map(|row| row.name)
    };
    let pairs = flags
        .iter()
        .map(|flag| (name_of(flag).unwrap_or(flag), flag.as_str()));
    option::unknown(typed, pairs).into()
}
