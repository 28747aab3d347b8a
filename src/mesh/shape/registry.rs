//! The table of sample shapes: names, limits and who builds them.

use glam::DVec3;

use super::parameter::{HEIGHT, LOOPS, RESOLUTION, RINGS, SEED, count, level, real};
use super::{Conflict, Sample, Shape, lying};
use super::{
    blocks, gap, great, hole, holed, knot, one_sided, patch, platonic, revolved, rough, scan, scar,
    sphere, torus, tubes,
};
use crate::mesh::subdivide::{SubdivisionError, linear_levels};
use crate::soup::PolygonSoup;

pub(super) static SHAPES: &[Shape] = &[
    Shape {
        name: "icosphere",
        label: "Sphere",
        parameters: &[level(4, 8)],
        build: |v| sample(sphere::icosphere(n(v[0]))),
    },
    Shape {
        name: "icosahedron",
        label: "Icosahedron",
        parameters: &[level(4, 8)],
        build: |v| sample(linear_levels(platonic::icosahedron(), n(v[0]))),
    },
    Shape {
        name: "octahedron",
        label: "Octahedron",
        parameters: &[level(4, 8)],
        build: |v| sample(linear_levels(platonic::octahedron(), n(v[0]))),
    },
    Shape {
        name: "tetrahedron",
        label: "Tetrahedron",
        parameters: &[level(4, 9)],
        build: |v| sample(linear_levels(platonic::tetrahedron(), n(v[0]))),
    },
    Shape {
        name: "uv-sphere",
        label: "Sphere by latitude",
        parameters: &[
            count("rings", "Bands", 24, 3, 1000),
            count("segments", "Segments", 48, 3, 1000),
        ],
        build: |v| Ok(lying(sphere::uv_sphere(n(v[0]), n(v[1])))),
    },
    Shape {
        name: "ellipsoid",
        label: "Ellipsoid",
        parameters: &[
            real("a", "Semi-axis x", 1.5, 0.05, 20.0),
            real("b", "Semi-axis y", 1.0, 0.05, 20.0),
            real("c", "Semi-axis z", 0.7, 0.05, 20.0),
            level(4, 8),
            real("jitter", "Jitter along the surface", 0.0, 0.0, 1.0),
            SEED,
        ],
        build: |v| {
            let axes = DVec3::new(v[0], v[1], v[2]);
            Ok(lying(sphere::ellipsoid(axes, n(v[3]), v[4], v[5] as u64)?))
        },
    },
    Shape {
        name: "spheroid",
        label: "Spheroid",
        parameters: &[
            real("ratio", "Height over width", 2.0, 0.05, 20.0),
            level(4, 8),
        ],
        build: |v| Ok(lying(revolved::spheroid(v[0], n(v[1]))?)),
    },
    Shape {
        name: "stomatocyte",
        label: "Stomatocyte",
        parameters: &[
            real("inner", "Radius of the dent", 0.55, 0.4, 0.75),
            level(4, 8),
        ],
        build: |v| Ok(lying(revolved::stomatocyte(v[0], n(v[1]))?)),
    },
    Shape {
        name: "bumpy-sphere",
        label: "Bumpy sphere",
        parameters: &[
            level(5, 8),
            real("amplitude", "Bump height", sphere::BUMPS.0, 0.0, 0.3),
            real("frequency", "Bumps around", sphere::BUMPS.1, 1.0, 40.0),
            SEED,
        ],
        build: |v| sample(sphere::bumpy_sphere(n(v[0]), v[1], v[2], v[3] as u64)),
    },
    Shape {
        name: "dumbbell",
        label: "Dumbbell",
        parameters: &[level(4, 8), real("waist", "Waist radius", 0.15, 0.01, 0.99)],
        build: |v| sample(sphere::dumbbell(n(v[0]), v[1])),
    },
    Shape {
        name: "hemisphere",
        label: "Hemisphere",
        parameters: &[RINGS],
        build: |v| Ok(lying(sphere::hemisphere(n(v[0])))),
    },
    Shape {
        name: "torus",
        label: "Torus",
        parameters: &[
            real("major", "Axis radius", 1.0, 0.01, 100.0),
            real("minor", "Tube radius", 0.35, 0.01, 100.0),
            count("around", "Steps around", 48, 3, 1000),
            count("tube", "Steps of the tube", 24, 3, 1000),
        ],
        build: |v| {
            if v[1] >= v[0] {
                let [minor, major] = [v[1], v[0]];
                return Err(Conflict::ThickTube { minor, major });
            }
            Ok(lying(torus::torus(v[0], v[1], n(v[2]), n(v[3]))))
        },
    },
    Shape {
        name: "sampled-torus",
        label: "Sampled torus",
        parameters: &[
            count("around", "Steps around", 28, 3, 1000),
            count("tube", "Steps of the tube", 14, 4, 1000),
            real("jitter", "Jitter in steps", 0.25, 0.0, 0.5),
            SEED,
        ],
        build: |v| {
            Ok(lying(rough::sampled_torus(
                n(v[0]),
                n(v[1]),
                v[2],
                v[3] as u64,
            )?))
        },
    },
    Shape {
        name: "eared-head",
        label: "Head with ears",
        parameters: &[
            level(4, 8),
            real("jitter", "Jitter in edge lengths", 0.15, 0.0, 0.5),
            SEED,
        ],
        build: |v| sample(rough::eared_head(n(v[0]), v[1], v[2] as u64)),
    },
    Shape {
        name: "creased-face",
        label: "Face with creases",
        parameters: &[
            count("rows", "Points along a line", 48, 4, 700),
            real("crease", "Creases in steps", 0.25, 0.0, 2.0),
            SEED,
        ],
        build: |v| Ok(rough::creased_face(n(v[0]), v[1], v[2] as u64).into()),
    },
    Shape {
        name: "counterexample",
        label: "Counterexample",
        parameters: &[],
        build: |_| Ok(rough::counterexample().into()),
    },
    great::MORIN,
    great::BOY,
    great::INVERTED_CATENOID,
    great::INVERTED_ENNEPER,
    great::CYCLIDE,
    great::LAWSON,
    Shape {
        name: "clifford-torus",
        label: "Clifford torus",
        parameters: &[
            count("around", "Steps around", 32, 3, 1000),
            count("tube", "Steps of the tube", 32, 3, 1000),
        ],
        build: |v| Ok(lying(torus::clifford_torus(n(v[0]), n(v[1])))),
    },
    Shape {
        name: "lattice-torus",
        label: "Clifford torus, any lattice",
        parameters: &[
            count("columns", "Columns", 26, 3, 1000),
            count("rows", "Rows", 30, 3, 1000),
            real("shear", "Shear", 0.5, -2.0, 2.0),
        ],
        build: |v| {
            let turn = v[1] * v[2];
            if (turn - turn.round()).abs() > 1e-9 * v[1] {
                return Err(Conflict::Shear { turn });
            }
            Ok(lying(torus::lattice_torus(n(v[0]), n(v[1]), v[2])))
        },
    },
    Shape {
        name: "coarse-torus",
        label: "Coarse torus",
        parameters: &[level(2, 6)],
        build: |v| Ok(lying(torus::coarse_torus(n(v[0]))?)),
    },
    Shape {
        name: "double-torus",
        label: "Double torus",
        parameters: &[count("genus", "Holes", 2, 1, 8), level(3, 6)],
        build: |v| Ok(lying(blocks::handles(n(v[0]), n(v[1]))?)),
    },
    Shape {
        name: "letter-c",
        label: "Letter C",
        parameters: &[level(3, 6)],
        build: |v| sample(blocks::letter_c(n(v[0]))),
    },
    Shape {
        name: "trefoil",
        label: "Trefoil knot",
        parameters: &[
            real("tube", "Tube radius", 0.5, 0.05, 0.9),
            count("along", "Steps along", 120, 12, 4000),
            count("around", "Steps around", 12, 3, 200),
        ],
        build: |v| Ok(lying(knot::trefoil(v[0], n(v[1]), n(v[2])))),
    },
    Shape {
        name: "torus-knot",
        label: "Torus knot",
        parameters: &[
            count("p", "Turns about the axis", 2, 1, 12),
            count("q", "Turns through the hole", 5, 1, 12),
            real("tube", "Tube radius", 0.35, 0.02, 0.9),
            count("along", "Steps along", 240, 12, 4000),
            count("around", "Steps around", 16, 3, 200),
        ],
        build: |v| {
            Ok(lying(knot::torus_knot(
                n(v[0]),
                n(v[1]),
                v[2],
                n(v[3]),
                n(v[4]),
            )))
        },
    },
    Shape {
        name: "klein-bottle",
        label: "Klein bottle",
        parameters: &[
            count("along", "Steps along", 96, 12, 2000),
            count("around", "Steps around", 32, 4, 400),
        ],
        build: |v| {
            if n(v[1]) % 2 == 1 {
                return Err(Conflict::odd("around", n(v[1])));
            }
            Ok(one_sided::klein_bottle(n(v[0]), n(v[1])).into())
        },
    },
    Shape {
        name: "moebius",
        label: "Möbius strip",
        parameters: &[
            real("width", "Width", 0.8, 0.01, 1.9),
            count("around", "Steps around", 96, 5, 2000),
            count("across", "Steps across", 12, 1, 400),
        ],
        build: |v| Ok(lying(one_sided::moebius(v[0], n(v[1]), n(v[2])))),
    },
    Shape {
        name: "pipe",
        label: "Pipe",
        parameters: &[level(2, 6)],
        build: |v| sample(torus::pipe(n(v[0]))),
    },
    Shape {
        name: "six-sided-hole",
        label: "Six-sided hole",
        parameters: &[real("height", "Height of the rim", 0.366, 0.0, 2.0)],
        build: |v| Ok(lying(hole::six_sided_hole(v[0]))),
    },
    Shape {
        name: "scar",
        label: "Scarred stone",
        parameters: &[
            level(5, 8),
            real("depth", "Depth in edge lengths", 2.7, 0.0, 6.0),
            SEED,
        ],
        build: |v| scar::scar(n(v[0]), v[1], v[2] as u64).map_err(Conflict::from),
    },
    Shape {
        name: "scan",
        label: "Range scan",
        parameters: &[
            RESOLUTION,
            real("noise", "Noise in edge lengths", 0.14, 0.0, 1.0),
            LOOPS,
            SEED,
        ],
        build: |v| Ok(scan::scan(n(v[0]), v[1], n(v[2]), v[3] as u64)?.into()),
    },
    Shape {
        name: "scan-clean",
        label: "Range scan without noise",
        parameters: &[RESOLUTION, LOOPS, SEED],
        build: |v| Ok(scan::scan(n(v[0]), 0.0, n(v[1]), v[2] as u64)?.into()),
    },
    Shape {
        name: "cylinder",
        label: "Cylinder",
        parameters: &[
            real("length", "Length", 2.0, 0.01, 100.0),
            count("around", "Steps around", 48, 3, 1000),
            count("along", "Steps along", 16, 1, 1000),
        ],
        build: |v| Ok(lying(patch::cylinder(v[0], n(v[1]), n(v[2])))),
    },
    Shape {
        name: "disk",
        label: "Disk",
        parameters: &[RINGS],
        build: |v| Ok(lying(patch::disk(n(v[0])))),
    },
    Shape {
        name: "hyperbolic-paraboloid",
        label: "Hyperbolic paraboloid",
        parameters: &[count("cells", "Cells a side", 24, 1, 1000), HEIGHT],
        build: |v| Ok(lying(patch::hyperbolic_paraboloid(n(v[0]), v[1]))),
    },
    Shape {
        name: "monkey-saddle",
        label: "Monkey saddle",
        parameters: &[RINGS, HEIGHT],
        build: |v| Ok(lying(patch::monkey_saddle(n(v[0]), v[1]))),
    },
    Shape {
        name: "tubes",
        label: "Tubes to be blended",
        parameters: &[
            count("count", "Tubes", 3, 2, 6),
            real("radius", "Radius", 0.5, 0.05, 0.9),
            real("length", "Length", 1.0, 0.05, 10.0),
            count("around", "Steps around", 40, 3, 400),
            count("along", "Steps along", 12, 1, 200),
        ],
        build: |v| Ok(tubes::tubes(n(v[0]), v[1], v[2], n(v[3]), n(v[4]))?.into()),
    },
    Shape {
        name: "cylinder-gaps",
        label: "Cylinder with four gaps",
        parameters: &[
            count("around", "Steps around", 88, 24, 300),
            count("along", "Steps along", 40, 12, 300),
            real("radius", "Radius of a gap", 0.69, 0.05, 0.72),
        ],
        build: |v| Ok(lying(gap::cylinder_with_gaps(n(v[0]), n(v[1]), v[2])?)),
    },
    Shape {
        name: "sphere-openings",
        label: "Sphere with eight openings",
        parameters: &[
            level(5, 7),
            real("radius", "Radius of an opening", 0.43, 0.1, 0.52),
        ],
        build: |v| gap::sphere_with_openings(n(v[0]), v[1]).map_err(Conflict::from),
    },
    Shape {
        name: "holed-sphere",
        label: "Sphere with round holes",
        parameters: &[
            level(5, 7),
            count("holes", "Holes", 6, 1, 12),
            real("radius", "Radius of a hole", 0.35, 0.05, 2.0),
            real("jitter", "Jitter in edge lengths", 0.1, 0.0, 0.2),
            SEED,
        ],
        build: |v| Ok(holed::sphere_with_holes(n(v[0]), n(v[1]), v[2], v[3], v[4] as u64)?.into()),
    },
    Shape {
        name: "dodecahedron",
        label: "Dodecahedron",
        parameters: &[level(3, 6)],
        build: |v| gap::dodecahedron(n(v[0])).map_err(Conflict::from),
    },
    Shape {
        name: "four-bumps",
        label: "Four bumps",
        parameters: &[count("vertices", "Vertices a side", 61, 31, 601)],
        build: |v| Ok(lying(gap::four_bumps(n(v[0])))),
    },
];

fn n(value: f64) -> usize {
    value as usize
}

fn sample(soup: Result<PolygonSoup, SubdivisionError>) -> Result<Sample, Conflict> {
    Ok(soup?.into())
}
