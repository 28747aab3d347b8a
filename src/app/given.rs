//! What a link, a recipe or a command line gives as options: read and checked before anything is
//! changed.

use super::fault::Fault;
use super::pane::{Arrangement, Compare};
use crate::flow::option::{
    self, Allowed, Kind, Named, OptionError, Options, Range, ReadBy, Row, Values, row,
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

/// Reads the flags of a command that runs a flow, by the names of their options.
///
/// # Errors
/// As [`read_options`], and what would change nothing.
pub fn read_flags(words: &Values) -> Result<Values, Fault> {
    Ok(option::read_strictly(words)?)
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
