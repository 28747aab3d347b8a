//! What shapes are asked for: kinds of parameters, and those that several share.

use super::Parameter;

pub(super) const fn count(
    name: &'static str,
    label: &'static str,
    default: u32,
    low: u32,
    high: u32,
) -> Parameter {
    let (default, low, high) = (default as f64, low as f64, high as f64);
    Parameter {
        name,
        label,
        default,
        low,
        high,
        integer: true,
    }
}

pub(super) const fn real(
    name: &'static str,
    label: &'static str,
    default: f64,
    low: f64,
    high: f64,
) -> Parameter {
    Parameter {
        name,
        label,
        default,
        low,
        high,
        integer: false,
    }
}

/// Levels of 1-to-4 subdivision.
pub(super) const fn level(default: u32, high: u32) -> Parameter {
    count("level", "Subdivisions", default, 0, high)
}

pub(super) const SEED: Parameter = count("seed", "Seed", 1, 0, 1_000_000);
pub(super) const RINGS: Parameter = count("rings", "Rings", 16, 1, 500);
pub(super) const HEIGHT: Parameter = real("height", "Height", 0.5, -5.0, 5.0);
pub(super) const RESOLUTION: Parameter = count("resolution", "Rows", 285, 60, 1000);
pub(super) const LOOPS: Parameter = count("loops", "Boundary loops", 88, 1, 500);
