//! Flows compared side by side: what each pane does otherwise than the first.

use crate::flow::option::{OptionError, Options, Values, find};
use crate::flow::options::FlowOptions;
use crate::flow::spec;
use serde::{Deserialize, Serialize};

/// Panes beside the first at most.
pub(super) const MOST_PANES: usize = 3;

/// What is kept level between panes.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Deserialize, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum Lockstep {
    /// The number of the step.
    #[default]
    Step,
    /// Flow time.
    Time,
}

/// A pane beside the first.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct PaneChange {
    /// The options it has otherwise.
    #[cfg_attr(test, ts(type = "Partial<FlowOptions>"))]
    pub change: Values,
    /// The step it stands at; none where that is the step of the first.
    pub step: Option<usize>,
}

/// Flows side by side. Panes are numbered from 0, the first among them.
#[derive(Clone, Debug, Default, PartialEq, Deserialize, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct Comparison {
    /// Those beside the first.
    pub panes: Vec<PaneChange>,
    /// What is kept level.
    pub lockstep: Lockstep,
    /// The only pane that is shown; none where all are, side by side.
    pub shown: Option<usize>,
    /// The pane whose distance colours the others.
    pub difference: Option<usize>,
}

/// What a pane does, the first doing `main`: of a flow other than that, what means nothing to
/// another flow goes back to its default.
///
/// # Errors
/// The first option that there is not, or that has a value it cannot have.
pub(super) fn options_with(
    main: &FlowOptions,
    change: &Values,
) -> Result<FlowOptions, OptionError> {
    let mut options = main.clone();
    let flow = find::<FlowOptions>("flow")?;
    if let Some(other) = change.get(flow.name)
        && *other != (flow.get)(main)
    {
        let usual = FlowOptions::default();
        for row in FlowOptions::ROWS.iter().filter(|row| row.is_of_one_flow) {
            (row.set)(&mut options, &(row.get)(&usual));
        }
    }
    for (name, value) in change {
        let row = find::<FlowOptions>(name)?;
        row.check(value)?;
        (row.set)(&mut options, value);
    }
    Ok(options)
}

/// The change that makes `options` of `main`.
pub(super) fn change_between(
    main: &FlowOptions,
    options: &FlowOptions,
) -> Result<Values, OptionError> {
    let mut change = Values::new();
    if options.flow != main.flow {
        let flow = find::<FlowOptions>("flow")?;
        change.insert(flow.name.into(), (flow.get)(options));
    }
    let base = options_with(main, &change)?;
    change.extend(differing(&base, options));
    Ok(change)
}

/// Adds to a record of options, which says its flow, what it must not leave out.
pub(super) fn say_whole(record: &mut Values, options: &FlowOptions) {
    let rows = FlowOptions::ROWS.iter();
    for row in rows.filter(|row| row.must_be_said(options)) {
        record.insert(row.name.into(), (row.get)(options));
    }
}

/// The options that are others than those of `base`.
pub(super) fn differing(base: &FlowOptions, options: &FlowOptions) -> Values {
    let rows = FlowOptions::ROWS.iter();
    let values = rows.map(|row| (row.name, (row.get)(base), (row.get)(options)));
    values
        .filter(|(_, usual, value)| usual != value)
        .map(|(name, _, value)| (name.into(), value))
        .collect()
}

/// Whether times of flows can be compared: they have one unit.
pub(super) fn times_agree<'a>(all: impl IntoIterator<Item = &'a FlowOptions>) -> bool {
    let power = |options: &FlowOptions| {
        let row = spec::of(options.flow);
        let p = if row.time_power_adds_p {
            options.p
        } else {
            0.0
        };
        f64::from(row.time_power) + p
    };
    let mut powers = all.into_iter().map(power);
    let first = powers.next();
    powers.all(|power| Some(power) == first)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::energy::circle::Boundary;
    use crate::flow::option::Value;
    use crate::flow::spec::FlowName;
    use crate::message::Say;

    #[test]
    fn a_change_gives_back_the_options_it_was_made_of() {
        let main = FlowOptions {
            boundary: Some(Boundary::Free),
            epsilon: 0.02,
            tau: Some(0.5),
            ..FlowOptions::default()
        };
        let other = FlowOptions {
            flow: FlowName::Mmcv,
            epsilon: 0.02,
            rungs: Some(0),
            ..FlowOptions::default()
        };
        let change = change_between(&main, &other).expect("a change");
        // The boundary and τ of the first mean nothing to another flow and need not be said.
        assert_eq!(change.keys().collect::<Vec<_>>(), ["flow", "rungs"]);
        assert_eq!(options_with(&main, &change).as_ref(), Ok(&other));
        assert_eq!(change_between(&main, &main), Ok(Values::new()));
        let bad = Values::from([("epsilon".into(), Value::Number(7.0))]);
        assert_eq!(
            options_with(&main, &bad).expect_err("7").kind(),
            "BadOption"
        );
    }

    #[test]
    fn times_agree_where_they_have_one_unit() {
        let of = |flow, p| FlowOptions {
            flow,
            p,
            ..FlowOptions::default()
        };
        let (circle, mmcv) = (of(FlowName::Circle, 2.0), of(FlowName::Mmcv, 2.0));
        let (p2, p4) = (of(FlowName::PWillmore, 2.0), of(FlowName::PWillmore, 4.0));
        assert!(times_agree([&circle, &circle]) && times_agree([&p2]));
        assert!(!times_agree([&circle, &mmcv]) && !times_agree([&p2, &p4]));
    }
}
