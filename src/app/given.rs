//! What a link, a recipe or a command line gives beside the options of a flow: read and checked
//! before anything is changed.

use super::RegulariseOptions;
use super::arrangement::{Arrangement, Compare};
use super::bench::BenchOptions;
use super::edit::options::{FillOptions, FlipOptions, RemeshOptions, RepairOptions};
use super::fault::Fault;
use super::readings::EnergyOptions;
use crate::flow::option::{
    self, Kind, Named, OptionError, Options, Range, ReadBy, Row, Value, Values, row,
};
use crate::flow::options::FlowOptions;
use crate::flow::spec::{COMPARED, FLIPS};

impl Named for Compare {}

impl Options for Arrangement {
    // A table reads best by lines.
    #[rustfmt::skip]
    const ROWS: &'static [Row<Self>] = &{
        let flips = ReadBy::flows(FLIPS);
        let several = ReadBy::flows(COMPARED);
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

/// Reads the flags of a command by the names of their options; any command that has no options of
/// its own runs a flow.
///
/// # Errors
/// An option that there is not, a value that it cannot have, and what would change nothing.
pub fn read_flags(command: &str, words: &Values) -> Result<Values, Fault> {
    Ok(match command {
        "energy" => option::read::<EnergyOptions>(words)?,
        "flips" => option::read::<FlipOptions>(words)?,
        "regularise" => option::read::<RegulariseOptions>(words)?,
        "fill" => option::read::<FillOptions>(words)?,
        "repair" => option::read::<RepairOptions>(words)?,
        "remesh" => {
            let values = option::read::<RemeshOptions>(words)?;
            option::options_of::<RemeshOptions>(&values)?.check()?;
            values
        }
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
