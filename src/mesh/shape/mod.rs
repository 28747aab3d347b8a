//! Sample shapes made by code: what the page opens with, the papers' figures, test surfaces.
//!
//! [`all`] lists them with their parameters and the limits of each; [`make`]
//! builds one by name. The same values always give the same mesh, bit for bit
//! on one platform. Closed shapes have outward faces, except the one-sided ones.
//!
//! One file a family; each is plain functions from numbers to a
//! [`PolygonSoup`], and `registry.rs` is the only place that knows names.

pub mod blocks;
mod curve;
mod face;
pub mod gap;
mod grid;
mod hexagon;
pub mod hole;
pub mod holed;
pub mod knot;
pub mod one_sided;
mod parameter;
pub mod patch;
pub mod platonic;
mod registry;
pub mod rough;
pub mod scan;
pub mod scar;
pub mod sphere;
pub mod torus;
pub mod tubes;

use serde::Serialize;

use crate::soup::PolygonSoup;

/// A number that a shape can be asked for.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
pub struct Parameter {
    /// Name on the command line.
    pub name: &'static str,
    /// Name on the page.
    pub label: &'static str,
    /// Value when none is given.
    pub default: f64,
    /// Smallest value accepted.
    pub low: f64,
    /// Largest value accepted; no shape can then exceed two million faces.
    pub high: f64,
    /// Whether only whole numbers are accepted.
    pub integer: bool,
}

/// A sample shape's name and parameters.
#[derive(Clone, Copy, Debug, Serialize)]
pub struct Shape {
    /// Name on the command line.
    pub name: &'static str,
    /// Name on the page.
    pub label: &'static str,
    /// What can be asked for, in the order in which they are offered.
    pub parameters: &'static [Parameter],
    /// From one value a parameter, each within its limits.
    #[serde(skip)]
    build: fn(&[f64]) -> Result<Sample, String>,
}

/// A shape that was made, and which of its vertices a flow should hold.
///
/// At most one of `fixed` and `free` is given; both are sorted.
#[derive(Clone, Debug, PartialEq)]
pub struct Sample {
    /// The mesh, all triangles.
    pub soup: PolygonSoup,
    /// Vertices to hold; the others move.
    pub fixed: Option<Vec<u32>>,
    /// Vertices to move; the others are held.
    pub free: Option<Vec<u32>>,
}

impl From<PolygonSoup> for Sample {
    fn from(soup: PolygonSoup) -> Self {
        Self {
            soup,
            fixed: None,
            free: None,
        }
    }
}

/// Why a shape cannot be made.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub enum ShapeError {
    /// No shape has this name.
    #[error("there is no shape `{name}`")]
    UnknownShape {
        /// The name asked for.
        name: String,
        /// All names there are.
        known: Vec<&'static str>,
    },
    /// The shape has no parameter of this name.
    #[error("shape `{shape}` has no parameter `{name}`")]
    UnknownParameter {
        /// The shape.
        shape: &'static str,
        /// The name asked for.
        name: String,
        /// All parameters of the shape.
        known: Vec<&'static str>,
    },
    /// A value outside the parameter's limits, or not a number.
    #[error("`{parameter}` of shape `{shape}` is {value}, outside {low} to {high}")]
    OutOfRange {
        /// The shape.
        shape: &'static str,
        /// The parameter.
        parameter: &'static str,
        /// The value asked for.
        value: f64,
        /// Smallest value accepted.
        low: f64,
        /// Largest value accepted.
        high: f64,
    },
    /// A fraction for a parameter that counts.
    #[error("`{parameter}` of shape `{shape}` is {value}, not a whole number")]
    NotAnInteger {
        /// The shape.
        shape: &'static str,
        /// The parameter.
        parameter: &'static str,
        /// The value asked for.
        value: f64,
    },
    /// Values that are each within limits but do not go together.
    #[error("shape `{shape}` cannot be made: {reason}")]
    Incompatible {
        /// The shape.
        shape: &'static str,
        /// Which values disagree, and how.
        reason: String,
    },
}

impl ShapeError {
    /// Name of the variant.
    pub fn kind(&self) -> &'static str {
        match self {
            Self::UnknownShape { .. } => "UnknownShape",
            Self::UnknownParameter { .. } => "UnknownParameter",
            Self::OutOfRange { .. } => "OutOfRange",
            Self::NotAnInteger { .. } => "NotAnInteger",
            Self::Incompatible { .. } => "Incompatible",
        }
    }

    /// What to do about it.
    pub fn hint(&self) -> String {
        match self {
            Self::UnknownShape { known, .. } => format!("The shapes are {}.", known.join(", ")),
            Self::UnknownParameter { shape, known, .. } if known.is_empty() => {
                format!("`{shape}` takes no parameters.")
            }
            Self::UnknownParameter { shape, known, .. } => {
                format!("`{shape}` takes {}.", known.join(", "))
            }
            Self::OutOfRange { low, high, .. } => format!("Use a value from {low} to {high}."),
            Self::NotAnInteger { value, .. } => format!("Use {}.", value.round()),
            Self::Incompatible { .. } => "Change one of the values named.".into(),
        }
    }
}

/// All sample shapes, in the order in which the page offers them.
pub fn all() -> &'static [Shape] {
    registry::SHAPES
}

/// Makes the shape called `name`; parameters not in `values` take their defaults.
///
/// If a parameter is given more than once, the last value counts.
///
/// # Errors
/// Every kind of [`ShapeError`].
pub fn make(name: &str, values: &[(String, f64)]) -> Result<Sample, ShapeError> {
    let shape = all()
        .iter()
        .find(|shape| shape.name == name)
        .ok_or_else(|| ShapeError::UnknownShape {
            name: name.into(),
            known: all().iter().map(|shape| shape.name).collect(),
        })?;
    let mut numbers: Vec<f64> = shape.parameters.iter().map(|p| p.default).collect();
    for (name, value) in values {
        let at = shape
            .parameters
            .iter()
            .position(|p| p.name == name)
            .ok_or_else(|| ShapeError::UnknownParameter {
                shape: shape.name,
                name: name.clone(),
                known: shape.parameters.iter().map(|p| p.name).collect(),
            })?;
        numbers[at] = shape.parameters[at].check(shape.name, *value)?;
    }
    (shape.build)(&numbers).map_err(|reason| ShapeError::Incompatible {
        shape: shape.name,
        reason,
    })
}

impl Parameter {
    fn check(&self, shape: &'static str, value: f64) -> Result<f64, ShapeError> {
        let &Self {
            name: parameter,
            low,
            high,
            integer,
            ..
        } = self;
        if !(low..=high).contains(&value) {
            Err(ShapeError::OutOfRange {
                shape,
                parameter,
                value,
                low,
                high,
            })
        } else if integer && value.fract() != 0.0 {
            Err(ShapeError::NotAnInteger {
                shape,
                parameter,
                value,
            })
        } else {
            Ok(value)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn refuse(name: &str, values: &[(&str, f64)]) -> ShapeError {
        let values: Vec<_> = values
            .iter()
            .map(|&(name, value)| (name.into(), value))
            .collect();
        make(name, &values).unwrap_err()
    }

    #[test]
    fn refusals_name_what_is_wrong_and_what_would_be_right() {
        let error = refuse("cube", &[]);
        assert_eq!(error.kind(), "UnknownShape");
        assert!(error.hint().contains("icosphere"));
        let error = refuse("torus", &[("radius", 2.0)]);
        assert_eq!(error.kind(), "UnknownParameter");
        assert!(error.hint().contains("major"), "{}", error.hint());
        for value in [-1.0, 1e6, f64::NAN, f64::INFINITY] {
            assert_eq!(
                refuse("icosphere", &[("level", value)]).kind(),
                "OutOfRange"
            );
        }
        assert_eq!(
            refuse("icosphere", &[("level", 2.5)]).kind(),
            "NotAnInteger"
        );
        let error = refuse("torus", &[("major", 1.0), ("minor", 1.5)]);
        assert_eq!(error.kind(), "Incompatible");
        assert!(error.to_string().contains("minor"), "{error}");
    }

    #[test]
    fn defaults_lie_within_limits_and_names_are_unique() {
        for (i, shape) in all().iter().enumerate() {
            assert!(
                all()[..i].iter().all(|other| other.name != shape.name),
                "{}",
                shape.name
            );
            for (j, p) in shape.parameters.iter().enumerate() {
                assert_eq!(p.check(shape.name, p.default), Ok(p.default));
                assert!(
                    shape.parameters[..j]
                        .iter()
                        .all(|other| other.name != p.name)
                );
                assert!(!p.integer || p.low.fract() == 0.0 && p.high.fract() == 0.0);
            }
        }
    }

    #[test]
    fn the_last_of_repeated_values_counts() {
        let values = [("level".into(), 3.0), ("level".into(), 1.0)];
        assert_eq!(make("icosphere", &values).unwrap().soup.n_faces(), 80);
    }
}
