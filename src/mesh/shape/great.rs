//! Surfaces that the theory of the Willmore energy is about, as shapes: critical points, and what
//! Möbius transformations make of minimal surfaces.

use super::parameter::{count, real};
use super::{Sample, Shape, lying};
use super::{inverted, kusner, lawson, torus};

/// Halfway in the eversion of the sphere.
pub(super) const MORIN: Shape = Shape {
    name: "morin",
    label: "Morin’s surface",
    parameters: &[
        count("vertices", "Vertices", 2400, 300, 20_000),
        real(
            "height",
            "Centre of the inversion",
            kusner::MORIN_HEIGHT,
            0.05,
            2.0,
        ),
        real("push", "Push along the normals", 0.0, -0.1, 0.1),
    ],
    build: |v| {
        Ok(Sample {
            keeps_sides: true,
            ..kusner::morin(v[0] as usize, v[1], v[2]).into()
        })
    },
};

/// The projective plane of least energy.
pub(super) const BOY: Shape = Shape {
    name: "boy",
    label: "Boy’s surface",
    parameters: &[
        count("vertices", "Vertices", 2000, 300, 10_000),
        real(
            "height",
            "Centre of the inversion",
            kusner::BOY_HEIGHT,
            0.05,
            2.0,
        ),
    ],
    build: |v| Ok(kusner::boy(v[0] as usize, v[1]).into()),
};

/// Two sheets that touch.
pub(super) const INVERTED_CATENOID: Shape = Shape {
    name: "inverted-catenoid",
    label: "Inverted catenoid",
    parameters: &[count("vertices", "Vertices", 2000, 300, 20_000)],
    build: |v| Ok(lying(inverted::catenoid(v[0] as usize))),
};

/// A branch point of order three.
pub(super) const INVERTED_ENNEPER: Shape = Shape {
    name: "inverted-enneper",
    label: "Inverted surface of Enneper",
    parameters: &[count("vertices", "Vertices", 4000, 300, 20_000)],
    build: |v| Ok(lying(inverted::enneper(v[0] as usize))),
};

/// Möbius images of the Clifford torus.
pub(super) const CYCLIDE: Shape = Shape {
    name: "cyclide",
    label: "Cyclide of Dupin",
    parameters: &[
        count("around", "Steps around", 64, 3, 1000),
        count("tube", "Steps of the tube", 64, 3, 1000),
        real("turn", "Turn in the 3-sphere", 0.4, 0.0, 0.7),
    ],
    build: |v| Ok(lying(torus::cyclide(v[0] as usize, v[1] as usize, v[2]))),
};

/// Towards Lawson's minimal surfaces of the 3-sphere.
pub(super) const LAWSON: Shape = Shape {
    name: "lawson",
    label: "Towards Lawson’s surfaces",
    parameters: &[
        count("genus", "Handles", 2, 1, 8),
        count("cells", "Cells a side", 14, 4, 160),
    ],
    build: |v| Ok(lawson::lawson(v[0] as usize, v[1] as usize).into()),
};
