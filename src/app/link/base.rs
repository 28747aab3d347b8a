//! What a scene has unless its link says otherwise.

use crate::app::library;
use crate::flow::option;
use crate::flow::options::FlowOptions;

fn over(usual: FlowOptions, sample: Option<&str>) -> FlowOptions {
    match sample.and_then(library::sample) {
        Some(sample) => (sample.options)(usual),
        None => usual,
    }
}

/// What it has.
pub(super) fn base_of(sample: Option<&str>) -> FlowOptions {
    over(FlowOptions::default(), sample)
}

/// What it had when defaults were others.
pub(super) fn before_of(sample: Option<&str>) -> FlowOptions {
    over(option::before(), sample)
}
