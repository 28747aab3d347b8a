//! What a link, a recipe or a command line gives beside the options of a flow: read and checked
//! before anything is changed.

use super::fault::Fault;
use super::pane::{Arrangement, Compare};
use crate::flow::option::{self, Kind, Named, Options, Range, ReadBy, Row, Values, row};
use crate::flow::options::{FlowName, FlowOptions};
use crate::flow::spec::FLIPS;

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

/// Reads the flags of a command that runs a flow, by the names of their options.
///
/// # Errors
/// As [`option::read_strictly`].
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
