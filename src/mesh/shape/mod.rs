//! Sample shapes made by code: what the page opens with, the papers' figures, test surfaces.
//!
//! [`all`] lists them with their parameters and the limits of each; [`make`]
//! builds one by name. The same values always give the same mesh, bit for bit
//! on one platform. Closed shapes have outward faces, except the one-sided ones.
//!
//! One file a family; each is plain functions from numbers to a
//! [`PolygonSoup`], and `registry.rs` is the only place that knows names.

pub mod blocks;
mod conformal;
mod curve;
mod delaunay;
mod face;
pub mod gap;
mod great;
mod grid;
mod hexagon;
pub mod hole;
pub mod holed;
pub mod inverted;
pub mod knot;
pub mod kusner;
pub mod lawson;
pub mod one_sided;
mod parameter;
pub mod patch;
pub mod platonic;
mod registry;
pub mod revolved;
pub mod rough;
pub mod scan;
pub mod scar;
pub mod sphere;
pub mod torus;
pub mod tubes;

use serde::Serialize;

use crate::mesh::subdivide::SubdivisionError;
use crate::message::messages;
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
    build: fn(&[f64]) -> Result<Sample, Conflict>,
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
    /// Whether its faces show the side they are to show, also where that is not outward.
    pub keeps_sides: bool,
    /// Which way up it is looked at.
    pub up: Up,
}

/// The coordinate axis that points up where a surface is looked at.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "lowercase")]
pub enum Up {
    /// The second.
    #[default]
    Y,
    /// The third.
    Z,
}

impl From<PolygonSoup> for Sample {
    fn from(soup: PolygonSoup) -> Self {
        Self {
            soup,
            fixed: None,
            free: None,
            keeps_sides: false,
            up: Up::Y,
        }
    }
}

/// One that is looked at with z up: what is flat then lies on the floor.
fn lying(made: impl Into<Sample>) -> Sample {
    Sample {
        up: Up::Z,
        ..made.into()
    }
}

messages! {
    /// Why a shape cannot be made.
    #[derive(Clone, Debug, PartialEq)]
    pub enum ShapeError as "shape" {
        /// No shape has this name.
        UnknownShape {
            /// The name asked for.
            name: String,
            /// All names there are.
            known: Vec<&'static str>,
        },
        /// The shape has no parameter of this name.
        UnknownParameter {
            /// The shape.
            shape: &'static str,
            /// The name asked for.
            name: String,
            /// All parameters of the shape.
            known: Vec<&'static str>,
        },
        /// A value outside the parameter's limits, or not a number.
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
        NotAnInteger {
            /// The shape.
            shape: &'static str,
            /// The parameter.
            parameter: &'static str,
            /// The value asked for.
            value: f64,
            /// The nearest that would do.
            nearest: f64,
        },
        /// Values that are each within limits but do not go together.
        Incompatible {
            /// The shape.
            shape: &'static str,
            /// Which values disagree, and how.
            reason: Conflict,
        },
    }
}

messages! {
    /// Values of a shape's parameters that do not go together.
    #[derive(Clone, Debug, PartialEq)]
    pub enum Conflict as "conflict" {
        /// The tube of a torus is not thinner than its ring.
        ThickTube {
            /// Radius of the tube.
            minor: f64,
            /// Radius of the ring.
            major: f64,
        },
        /// A sheared lattice does not meet itself.
        Shear {
            /// Shear × rows, no whole number.
            turn: f64,
        },
        /// An odd number that has to be even.
        Odd {
            /// The parameter.
            parameter: &'static str,
            /// The number.
            value: usize,
        },
        /// Triangles too large for the holes.
        TooCoarse {
            /// Of the triangles.
            level: usize,
            /// Of the holes.
            radius: f64,
        },
        /// Holes that overlap.
        HolesOverlap {
            /// How many.
            count: usize,
            /// Of each.
            radius: f64,
            /// What fits.
            most: f64,
        },
        /// Tubes that meet.
        TubesMeet {
            /// How many.
            count: usize,
            /// Of each.
            radius: f64,
            /// What fits.
            most: f64,
        },
        /// Patches longer than the cylinder they lie on.
        PatchesTooLong {
            /// Of the patches.
            radius: f64,
        },
        /// A picture without room for its holes.
        NoRoom {
            /// Rows of the picture.
            resolution: usize,
            /// Holes.
            count: usize,
        },
        /// The mesh cannot be refined.
        Subdivision(reason: SubdivisionError),
    }
}

impl Conflict {
    fn odd(parameter: &'static str, value: usize) -> Self {
        Self::Odd { parameter, value }
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
                nearest: value.round(),
            })
        } else {
            Ok(value)
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::message::Say;

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
        assert!(matches!(
            error,
            ShapeError::UnknownShape { name, known } if name == "cube" && known.contains(&"icosphere")
        ));
        let error = refuse("torus", &[("radius", 2.0)]);
        assert!(matches!(
            error,
            ShapeError::UnknownParameter { known, .. } if known.contains(&"major")
        ));
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
        let reason = Conflict::ThickTube {
            minor: 1.5,
            major: 1.0,
        };
        let shape = "torus";
        assert_eq!(error, ShapeError::Incompatible { shape, reason });
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
