//! Sample shapes: are they the surfaces they claim to be, and the meshes the papers used?

mod energy;
mod measure;
mod topology;

use std::f64::consts::PI;

use energy::{Angles, free_boundary};
use glam::DVec3;
use measure::{edge_lengths, mean_edge_length, smallest_angle, volume};
use topology::Topology;
use umbilic::mesh::shape::{Parameter, Sample, Shape, all, make};
use umbilic::message::Say;
use umbilic::soup::PolygonSoup;

fn shape(name: &str, values: &[(&str, f64)]) -> Sample {
    let values: Vec<_> = values
        .iter()
        .map(|&(name, value)| (name.into(), value))
        .collect();
    make(name, &values).unwrap_or_else(|error| panic!("{error}"))
}

fn soup(name: &str, values: &[(&str, f64)]) -> PolygonSoup {
    shape(name, values).soup
}

/// Kind of the refusal; never prints a mesh.
fn refusal(name: &str, values: &[(&str, f64)]) -> Option<&'static str> {
    let values: Vec<_> = values
        .iter()
        .map(|&(name, value)| (name.into(), value))
        .collect();
    make(name, &values).err().map(|error| error.kind())
}

fn assert_near(name: &str, value: f64, expected: f64, tolerance: f64) {
    assert!(
        (value - expected).abs() <= tolerance,
        "{name}: {value}, expected {expected}"
    );
}

/// One row a shape: vertices, faces, Euler characteristic, boundary loops, orientable.
#[test]
fn every_shape_is_the_manifold_it_should_be() {
    #[rustfmt::skip]
    let expected = [
        ("icosphere",              2562,  5120,   2,  0, true),
        ("icosahedron",            2562,  5120,   2,  0, true),
        ("octahedron",             1026,  2048,   2,  0, true),
        ("tetrahedron",             514,  1024,   2,  0, true),
        ("uv-sphere",              1106,  2208,   2,  0, true),
        ("ellipsoid",              2562,  5120,   2,  0, true),
        ("spheroid",               2562,  5120,   2,  0, true),
        ("stomatocyte",            2562,  5120,   2,  0, true),
        ("bumpy-sphere",          10242, 20480,   2,  0, true),
        ("dumbbell",               2562,  5120,   2,  0, true),
        ("hemisphere",              817,  1536,   1,  1, true),
        ("torus",                  1152,  2304,   0,  0, true),
        ("sampled-torus",           392,   784,   0,  0, true),
        ("eared-head",             2562,  5120,   2,  0, true),
        ("creased-face",           3087,  5952,   1,  1, true),
        ("counterexample",            4,     2,   1,  1, true),
        ("morin",                  2400,  4796,   2,  0, true),
        ("boy",                    2000,  3998,   1,  0, false),
        ("inverted-catenoid",      2000,  3996,   2,  0, true),
        ("inverted-enneper",       4000,  7996,   2,  0, true),
        ("cyclide",                4096,  8192,   0,  0, true),
        ("lawson",                 2350,  4704,  -2,  0, true),
        ("clifford-torus",         1024,  2048,   0,  0, true),
        ("lattice-torus",           780,  1560,   0,  0, true),
        ("coarse-torus",            768,  1536,   0,  0, true),
        ("double-torus",           3198,  6400,  -2,  0, true),
        ("letter-c",               2946,  5888,   2,  0, true),
        ("trefoil",                1440,  2880,   0,  0, true),
        ("torus-knot",             3840,  7680,   0,  0, true),
        ("klein-bottle",           3072,  6144,   0,  0, false),
        ("moebius",                1248,  2304,   0,  1, false),
        ("pipe",                    792,  1536,   0,  2, true),
        ("six-sided-hole",          469,   864,   1,  1, true),
        ("scar",                  10242, 20480,   2,  0, true),
        ("scan",                  38221, 74678, -86, 88, true),
        ("scan-clean",            38221, 74678, -86, 88, true),
        ("cylinder",                816,  1536,   0,  2, true),
        ("disk",                    817,  1536,   1,  1, true),
        ("hyperbolic-paraboloid",   625,  1152,   1,  1, true),
        ("monkey-saddle",           817,  1536,   1,  1, true),
        ("tubes",                  1560,  2880,   0,  6, true),
        ("cylinder-gaps",          3608,  7040,   0,  2, true),
        ("sphere-openings",       10242, 20480,   2,  0, true),
        ("holed-sphere",           8390, 16383,  -4,  6, true),
        ("dodecahedron",           1154,  2304,   2,  0, true),
        ("four-bumps",             3721,  7200,   1,  1, true),
    ];
    assert_eq!(
        expected.map(|row| row.0).to_vec(),
        all().iter().map(|s| s.name).collect::<Vec<_>>()
    );
    for (name, vertices, faces, euler, loops, orientable) in expected {
        let soup = soup(name, &[]);
        assert_eq!(
            (soup.positions.len(), soup.n_faces()),
            (vertices, faces),
            "{name}"
        );
        let found = Topology::of(&soup).unwrap_or_else(|wrong| panic!("{name}: {wrong}"));
        let expected = Topology {
            euler,
            loops,
            components: if name == "tubes" { 3 } else { 1 },
            orientable,
            oriented: orientable,
        };
        assert_eq!(found, expected, "{name}");
        // The two sides of Morin's surface are alike.
        if orientable && loops == 0 && name != "morin" {
            assert!(volume(&soup) > 0.0, "{name} is inside out");
        }
        // Starts for edge flips have bad triangles on purpose, a branch point has no others.
        let has_bad = ["sampled-torus", "inverted-enneper"].contains(&name);
        let least = if has_bad { 0.5 } else { 2.0 };
        assert!(
            smallest_angle(&soup) > least,
            "{name}: {}°",
            smallest_angle(&soup)
        );
    }
}

#[test]
fn the_same_values_give_the_same_mesh_and_every_parameter_matters() {
    for s in all() {
        let plain = soup(s.name, &[]);
        assert!(plain == soup(s.name, &[]), "{}", s.name);
        for p in s.parameters {
            let Some(value) = another_value(s, p) else {
                continue;
            };
            // The seed of a jitter matters where there is one.
            let with: &[(&str, f64)] = match (s.name, p.name) {
                ("ellipsoid", "seed") => &[("jitter", 0.1)],
                _ => &[],
            };
            let other = soup(s.name, &[with, &[(p.name, value)]].concat());
            assert!(soup(s.name, with) != other, "{} ignores {}", s.name, p.name);
        }
    }
}

/// A value near the default that the shape accepts.
fn another_value(s: &Shape, p: &Parameter) -> Option<f64> {
    let steps = if p.integer {
        [1.0, -1.0, 2.0]
    } else {
        [0.1, -0.1, 0.2]
    };
    steps
        .into_iter()
        .map(|step| p.default + step)
        .find(|&value| make(s.name, &[(p.name.into(), value)]).is_ok())
}

#[test]
fn no_shape_exceeds_two_million_faces() {
    for s in all() {
        // p and q of the torus knot must stay coprime and count no faces.
        let counts = s
            .parameters
            .iter()
            .filter(|p| p.integer && !["p", "q"].contains(&p.name));
        let largest: Vec<_> = counts.map(|p| (p.name, p.high)).collect();
        let faces = soup(s.name, &largest).n_faces();
        assert!(faces <= 2_000_000, "{}: {faces}", s.name);
    }
}

#[test]
fn subdivided_solids_have_their_exact_energy() {
    for name in ["tetrahedron", "octahedron", "icosahedron"] {
        for level in 0..5_i32 {
            let energy = Angles::of(&soup(name, &[("level", level.into())])).closed_energy();
            assert_near(name, energy, 4.0 * PI * (2_f64.powi(level) - 1.0), 1e-8);
        }
    }
    let figure_6 = Angles::of(&soup("icosahedron", &[])).closed_energy();
    assert_near("figure 6", figure_6, 60.0 * PI, 1e-8);
}

#[test]
fn round_spheres_have_no_energy() {
    for name in ["icosphere", "uv-sphere"] {
        let soup = soup(name, &[]);
        assert_near(name, Angles::of(&soup).closed_energy(), 0.0, 1e-9);
        assert!(
            soup.positions
                .iter()
                .all(|p| (p.length() - 1.0).abs() < 1e-15)
        );
    }
    let hemisphere = Angles::of(&soup("hemisphere", &[])).interior_energy();
    assert_near("hemisphere", hemisphere, 0.0, 1e-10);
    let round = soup("ellipsoid", &[("a", 1.0), ("b", 1.0), ("c", 1.0)]);
    assert!(round == soup("icosphere", &[]));
    let smooth = soup("bumpy-sphere", &[("amplitude", 0.0), ("level", 4.0)]);
    assert!(smooth == round);
}

/// Circle-angle energy of lattices on the Clifford torus over 2·2π².
#[test]
fn the_smooth_limit_depends_on_the_lattice() {
    let ratio = |soup: &PolygonSoup| Angles::of(soup).closed_energy() / (4.0 * PI * PI);
    let aligned = [
        (16.0, 0.9795),
        (32.0, 0.9945),
        (64.0, 0.9986),
        (128.0, 0.9996),
        (256.0, 0.9999),
    ];
    for (n, expected) in aligned {
        let soup = soup("clifford-torus", &[("around", n), ("tube", n)]);
        assert_near("aligned", ratio(&soup), expected, 5.1e-5);
    }
    let lattice = |columns: f64, rows: f64, shear: f64| {
        ratio(&soup(
            "lattice-torus",
            &[("columns", columns), ("rows", rows), ("shear", shear)],
        ))
    };
    for (columns, expected) in [(4.0, 2.25), (8.0, 4.08), (16.0, 7.70), (24.0, 11.3)] {
        assert_near(
            "turned 45°",
            lattice(columns, 2.0 * columns, 0.5),
            expected,
            0.0051,
        );
    }
    for (n, expected) in [(16.0, 13.8), (32.0, 51.9), (64.0, 204.0)] {
        assert_near("obtuse", lattice(n, n, -0.25), expected, 0.51);
    }
    assert_near("isosceles", lattice(128.0, 128.0, 0.5), 4.0 / 3.0, 5e-4);
    assert_near("equilateral", lattice(26.0, 30.0, 0.5), 1.485, 2e-3);
    assert_near("equilateral", lattice(104.0, 120.0, 0.5), 1.5, 2e-3);
    assert_near("square", lattice(128.0, 128.0, 0.0), 1.0, 5e-4);
    // Either way of leaning is the same torus in a mirror, once the diagonals agree.
    assert_near(
        "shear 1",
        lattice(32.0, 32.0, 1.0),
        lattice(32.0, 32.0, 0.0),
        1e-9,
    );
}

#[test]
fn what_does_not_close_up_is_refused() {
    let incompatible = Some("Incompatible");
    assert_eq!(
        refusal("lattice-torus", &[("rows", 5.0), ("shear", 0.5)]),
        incompatible
    );
    assert_eq!(refusal("klein-bottle", &[("around", 31.0)]), incompatible);
    // Too small for the mesh, too large for each other and for the sphere.
    assert_eq!(refusal("holed-sphere", &[("level", 2.0)]), incompatible);
    assert_eq!(refusal("holed-sphere", &[("radius", 0.7)]), incompatible);
    let most = [("holes", 1.0), ("radius", 2.0), ("level", 3.0)];
    assert_eq!(refusal("holed-sphere", &most), None);
}

#[test]
fn torus_knots_without_coprime_numbers_are_links() {
    for (p, q, tubes) in [(2.0, 4.0, 2), (3.0, 6.0, 3), (2.0, 2.0, 2), (2.0, 5.0, 1)] {
        let values = [("p", p), ("q", q), ("tube", 0.3)];
        let link = soup("torus-knot", &values);
        let found = Topology::of(&link).expect("a manifold");
        assert_eq!((found.euler, found.components), (0, tubes), "{p}, {q}");
        // As far apart as the strands of one tube are.
        let one = link.positions.len() / tubes;
        let [a, b] = [&link.positions[..one], &link.positions[one..]];
        let apart = |p: &DVec3| {
            b.iter()
                .map(|q| p.distance(*q))
                .fold(f64::INFINITY, f64::min)
        };
        let least = a.iter().map(apart).fold(f64::INFINITY, f64::min);
        assert!(least > 0.2, "{p}, {q}: {least}");
        assert!(volume(&link) > 0.0);
    }
}

#[test]
fn holes_of_a_sphere_are_as_many_as_asked_for_and_simple() {
    let mut made = 0;
    for level in [3.0, 4.0, 5.0] {
        for (holes, radius) in [
            (1.0, 0.35),
            (1.0, 1.9),
            (3.0, 0.5),
            (6.0, 0.3),
            (12.0, 0.25),
        ] {
            for seed in 0..8 {
                let values = [
                    ("level", level),
                    ("holes", holes),
                    ("radius", radius),
                    ("jitter", 0.2),
                    ("seed", f64::from(seed)),
                ];
                if refusal("holed-sphere", &values).is_some() {
                    continue;
                }
                made += 1;
                let found = Topology::of(&soup("holed-sphere", &values)).expect("a manifold");
                let (euler, loops) = (2 - holes as i64, holes as usize);
                assert_eq!((found.euler, found.loops), (euler, loops), "{values:?}");
            }
        }
    }
    assert_eq!(made, 3 * 5 * 8 - 8);
}

#[test]
fn coarse_torus_and_pipe_begin_where_figures_8_and_9_do() {
    let torus = Angles::of(&soup("coarse-torus", &[])).closed_energy();
    assert_near("torus", torus, 764.397_337, 1e-5);
    let pipe = soup("pipe", &[]);
    let angles = Angles::of(&pipe);
    assert_near("pipe, edges twice", angles.edges_twice(), 506.464_999, 1e-5);
    assert_near(
        "pipe, interior vertices",
        angles.interior_energy(),
        398.649_780,
        1e-5,
    );
    assert_near(
        "pipe, closed by two points at infinity",
        free_boundary(&pipe),
        430.563_937,
        1e-5,
    );
    for v in angles.boundary_vertices() {
        let p = pipe.positions[v];
        assert!(p.y.abs() < 1e-14);
        assert_near("circle", (p.x.abs() - 2.0).hypot(p.z), 1.0, 1e-14);
    }
}

#[test]
fn six_sided_hole_is_flat_inside_a_fixed_rim() {
    let Sample {
        soup, fixed, free, ..
    } = shape("six-sided-hole", &[]);
    let fixed = fixed.unwrap();
    assert_eq!((fixed.len(), free), (138, None));
    assert!(fixed.is_sorted());
    let angles = Angles::of(&soup);
    assert!(
        angles
            .boundary_vertices()
            .all(|v| fixed.contains(&(v as u32)))
    );
    let flat = (0..469)
        .filter(|v| !fixed.contains(v))
        .all(|v| soup.positions[v as usize].z == 0.0);
    assert!(flat);
    let share = angles.circular_edges() as f64 / angles.len() as f64;
    assert_near(
        "share of edges with four corners on a circle",
        share,
        0.23,
        0.01,
    );
    assert_near("energy", angles.edges_twice(), 254.6, 0.3);
}

#[test]
fn scar_cuts_only_into_the_free_patch() {
    let scarred = shape("scar", &[]);
    let whole = shape("scar", &[("depth", 0.0)]);
    let free = scarred.free.clone().unwrap();
    assert_eq!((&whole.free, &scarred.fixed), (&scarred.free, &None));
    assert_eq!(free.len(), 1451);
    let displacement = |v: usize| scarred.soup.positions[v].distance(whole.soup.positions[v]);
    let edge = mean_edge_length(&whole.soup);
    let moved = |v: &usize| displacement(*v) > 1e-6;
    assert!(
        (0..10_242)
            .filter(moved)
            .all(|v| free.contains(&(v as u32)))
    );
    let deepest = (0..10_242).map(displacement).fold(0.0, f64::max) / edge;
    assert_near("depth in edge lengths", deepest, 2.7, 0.7);
    // The rim of the patch is whole, so that both starts have the same fill.
    let angles = Angles::of(&scarred.soup);
    let on_rim = angles
        .ends()
        .filter(|(a, b)| free.contains(a) != free.contains(b));
    for (a, b) in on_rim {
        assert!(displacement(a as usize).max(displacement(b as usize)) < 0.02 * edge);
    }
}

#[test]
fn scan_has_the_noise_asked_for_and_nothing_else() {
    let (noisy, clean) = (soup("scan", &[]), soup("scan-clean", &[]));
    assert!(noisy.corners == clean.corners);
    let offsets = noisy
        .positions
        .iter()
        .zip(&clean.positions)
        .map(|(a, b)| *a - *b);
    let offsets: Vec<_> = offsets.collect();
    assert!(offsets.iter().all(|d| d.x == 0.0 && d.y == 0.0));
    let square = offsets.iter().map(|d| d.z * d.z).sum::<f64>() / offsets.len() as f64;
    let rms = square.sqrt() / mean_edge_length(&clean);
    assert_near("noise in edge lengths", rms, 0.14, 0.002);
}

#[test]
fn small_scans_keep_their_holes_or_say_why_not() {
    let small = soup("scan", &[("resolution", 86.0)]);
    assert!(
        (3300..3700).contains(&small.positions.len()),
        "{}",
        small.positions.len()
    );
    for (resolution, loops) in [(86.0, 1), (86.0, 88), (61.0, 40), (77.0, 100), (120.0, 88)] {
        let soup = soup(
            "scan",
            &[("resolution", resolution), ("loops", f64::from(loops))],
        );
        let found = Topology::of(&soup).unwrap();
        assert_eq!((found.loops, found.components), (loops as usize, 1));
    }
    let crowded = [("resolution", 60.0), ("loops", 500.0)];
    assert_eq!(refusal("scan", &crowded), Some("Incompatible"));
}

/// Where a grid is glued to itself, shifted or reversed, its edges are as long as elsewhere.
#[test]
fn seams_close() {
    for name in [
        "lattice-torus",
        "trefoil",
        "torus-knot",
        "klein-bottle",
        "moebius",
    ] {
        let soup = soup(name, &[]);
        let longest = edge_lengths(&soup).fold(0.0, f64::max);
        let ratio = longest / mean_edge_length(&soup);
        assert!(ratio < 3.0, "{name}: an edge of {ratio} mean lengths");
    }
}

#[test]
fn volumes() {
    let torus = soup("torus", &[("around", 400.0), ("tube", 200.0)]);
    assert_near("torus", volume(&torus), 2.0 * PI * PI * 0.35 * 0.35, 1e-3);
    let ellipsoid = soup("ellipsoid", &[("level", 6.0)]);
    assert_near(
        "ellipsoid",
        volume(&ellipsoid),
        4.0 / 3.0 * PI * 1.5 * 0.7,
        3e-3,
    );
    assert_near(
        "letter of 11 cubes",
        volume(&soup("letter-c", &[])),
        11.0,
        1e-9,
    );
    // A tube's volume is its section times the length of its axis.
    let knot = |tube| {
        let values = [("tube", tube), ("along", 1000.0), ("around", 100.0)];
        volume(&soup("trefoil", &values)) / (PI * tube * tube)
    };
    assert_near(
        "length of the trefoil",
        knot(0.5),
        knot(0.05),
        0.02 * knot(0.05),
    );
}
