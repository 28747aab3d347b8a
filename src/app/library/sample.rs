//! Surfaces to begin with: a shape, and options that show it well.

use crate::app::{Fault, FillOptions, Loaded, Loops, Session};
use crate::energy::circle::Boundary;
use crate::flow::constraint::Kept::{Area, Volume};
use crate::flow::options::{FlowOptions, Goal, Remeshing};
use crate::flow::spec::FlowName;
use crate::mesh::shape::sphere;
use serde::Serialize;
use std::ops::ControlFlow;

/// A surface to begin with.
#[derive(Clone, Copy, Debug)]
pub struct Sample {
    /// Its name in links, recipes and locale files.
    pub id: &'static str,
    /// The shelf it stands on.
    pub group: Group,
    /// How it is made.
    pub shape: Shape,
    /// Options that show it well, over the defaults.
    pub options: fn(FlowOptions) -> FlowOptions,
    /// Which holes of the shape are filled at once.
    pub holes: Holes,
}

/// Shelves, by what happens to their surfaces.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[serde(rename_all = "kebab-case")]
pub enum Group {
    /// Closed surfaces that round off.
    Closed,
    /// Tubes and knots.
    Tubes,
    /// Surfaces with a boundary, or held in part.
    Boundary,
    /// What is mended: noise, scars, holes, bad triangles.
    Repair,
    /// Meshes for edge flips.
    Flips,
}

/// A sample shape of [`crate::mesh::shape`], with the parameters that are not its defaults.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Shape {
    /// Its name.
    pub name: &'static str,
    /// Names and values.
    pub parameters: &'static [(&'static str, f64)],
}

/// Boundary loops that are filled before anything else.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Holes {
    /// None.
    #[default]
    Open,
    /// All, one by one.
    All,
    /// The small ones.
    Small,
    /// These, by one patch that connects them.
    Blended(&'static [usize]),
}

impl Holes {
    /// As options of a fill; `None` where nothing is filled.
    pub fn options(self) -> Option<FillOptions> {
        let (loops, connect) = match self {
            Self::Open => return None,
            Self::All => (Loops::Word("all".into()), false),
            Self::Small => (Loops::Word("small".into()), false),
            Self::Blended(loops) => (Loops::Some(loops.to_vec()), true),
        };
        Some(FillOptions {
            loops,
            connect,
            max_vertices: None,
        })
    }
}

impl Shape {
    /// Makes it, `over` taking the place of parameters of the same name.
    pub(in crate::app) fn load(
        &self,
        session: &mut Session,
        over: &[(&str, f64)],
    ) -> Result<Loaded, Fault> {
        let kept = self.parameters.iter();
        let kept = kept.filter(|(name, _)| over.iter().all(|(other, _)| other != name));
        let values: Vec<(String, f64)> = kept
            .chain(over)
            .map(|(name, value)| ((*name).into(), *value))
            .collect();
        session.sample(self.name, &values)
    }
}

impl Sample {
    /// Its shape in a session, its holes filled; `over` takes the place of parameters of the same
    /// name.
    ///
    /// # Errors
    /// Parameters out of range.
    pub fn load(&self, session: &mut Session, over: &[(&str, f64)]) -> Result<Loaded, Fault> {
        let loaded = self.shape.load(session, over)?;
        let Some(fill) = self.holes.options() else {
            return Ok(loaded);
        };
        session.fill(&fill, &mut |_, _| ControlFlow::Continue(()))?;
        session.loaded()
    }

    /// Its options in full.
    pub fn whole_options(&self) -> FlowOptions {
        (self.options)(FlowOptions::default())
    }
}

const fn shape(name: &'static str, parameters: &'static [(&'static str, f64)]) -> Shape {
    Shape { name, parameters }
}

const fn sample(id: &'static str, group: Group, shape: Shape) -> Sample {
    Sample {
        id,
        group,
        shape,
        options: |o| o,
        holes: Holes::Open,
    }
}

impl Sample {
    const fn with(self, options: fn(FlowOptions) -> FlowOptions) -> Self {
        Self { options, ..self }
    }

    const fn filled(self, holes: Holes) -> Self {
        Self { holes, ..self }
    }
}

fn clamped(o: FlowOptions) -> FlowOptions {
    let boundary = Some(Boundary::Clamped);
    FlowOptions { boundary, ..o }
}

fn fixed(o: FlowOptions) -> FlowOptions {
    let boundary = Some(Boundary::Fixed);
    FlowOptions { boundary, ..o }
}

fn free(o: FlowOptions) -> FlowOptions {
    let boundary = Some(Boundary::Free);
    FlowOptions { boundary, ..o }
}

/// Ten steps that take detail below four edge lengths.
fn smoothed(o: FlowOptions) -> FlowOptions {
    FlowOptions {
        goal: Goal::Smooth,
        detail: 4.0,
        smooth_steps: 10,
        ..o
    }
}

fn p_willmore(o: FlowOptions) -> FlowOptions {
    let flow = FlowName::PWillmore;
    FlowOptions { flow, ..o }
}

fn both_kept(o: FlowOptions) -> FlowOptions {
    let keep = vec![Area, Volume];
    p_willmore(FlowOptions { keep, ..o })
}

fn volume_kept(o: FlowOptions) -> FlowOptions {
    let keep = vec![Volume];
    p_willmore(FlowOptions { keep, ..o })
}

fn area_kept(o: FlowOptions) -> FlowOptions {
    FlowOptions {
        keep: vec![Area],
        // Said though it is the default: links to these samples are older than that.
        remesh: Remeshing::Adaptive,
        ..p_willmore(o)
    }
}

/// Towards the volume of a red blood cell, as a share of the ball's.
fn deflated(o: FlowOptions) -> FlowOptions {
    let reduced_volume = Some(0.6);
    both_kept(FlowOptions {
        reduced_volume,
        ..o
    })
}

fn mmcv(o: FlowOptions) -> FlowOptions {
    let flow = FlowName::Mmcv;
    FlowOptions { flow, ..o }
}

fn mmcv_prefilled(o: FlowOptions) -> FlowOptions {
    let prefill = true;
    mmcv(FlowOptions { prefill, ..o })
}

fn flips(o: FlowOptions) -> FlowOptions {
    let flow = FlowName::Flips;
    FlowOptions { flow, ..o }
}

/// All of them. A link that names none means the first; the page opens with the second.
pub static SAMPLES: &[Sample] = {
    use Group::{Boundary, Closed, Flips, Repair, Tubes};
    &[
        sample(
            "icosahedron",
            Closed,
            shape("icosahedron", &[("level", 4.0)]),
        ),
        sample(
            "bumpy-sphere",
            Closed,
            shape("bumpy-sphere", &[("level", sphere::FIRST_LEVEL as f64)]),
        ),
        sample(
            "coarse-torus",
            Closed,
            shape("coarse-torus", &[("level", 2.0)]),
        ),
        // Its edges lie on lines of curvature, where rounded angles would bias the minimum.
        sample("clifford-torus", Closed, shape("clifford-torus", &[])).with(|o| FlowOptions {
            epsilon: 0.001,
            ..o
        }),
        sample("pipe", Tubes, shape("pipe", &[])).with(clamped),
        sample("six-sided-hole", Boundary, shape("six-sided-hole", &[]))
            .with(|o| clamped(FlowOptions { prefill: true, ..o })),
        sample("scar", Repair, shape("scar", &[])),
        sample(
            "noisy-scan",
            Repair,
            shape("scan", &[("resolution", 140.0), ("loops", 30.0)]),
        )
        .with(smoothed),
        sample("trefoil", Tubes, shape("trefoil", &[])),
        sample(
            "vesicle",
            Closed,
            shape(
                "ellipsoid",
                &[("a", 1.0), ("b", 1.0), ("c", 0.65), ("level", 4.0)],
            ),
        )
        .with(deflated),
        sample(
            "blob",
            Closed,
            shape(
                "bumpy-sphere",
                &[
                    ("level", 4.0),
                    ("amplitude", 0.2),
                    ("frequency", 3.0),
                    ("seed", 2.0),
                ],
            ),
        )
        .with(deflated),
        sample(
            "spheroid",
            Closed,
            shape(
                "ellipsoid",
                &[("a", 2.0), ("b", 1.0), ("c", 1.0), ("level", 4.0)],
            ),
        )
        .with(|o| FlowOptions {
            flow: FlowName::VolumePreserving,
            ..o
        }),
        sample("letter-c", Closed, shape("letter-c", &[])).with(p_willmore),
        sample(
            "thin-torus",
            Closed,
            shape(
                "torus",
                &[
                    ("major", 1.0),
                    ("minor", 0.25),
                    ("around", 72.0),
                    ("tube", 24.0),
                ],
            ),
        )
        .with(p_willmore),
        sample(
            "torus-knot",
            Tubes,
            shape(
                "torus-knot",
                &[("p", 3.0), ("q", 4.0), ("along", 240.0), ("around", 16.0)],
            ),
        )
        .with(both_kept),
        sample(
            "bad-mesh",
            Repair,
            shape("ellipsoid", &[("level", 4.0), ("jitter", 0.35)]),
        )
        .with(volume_kept),
        sample(
            "trefoil-kept",
            Tubes,
            shape("trefoil", &[("along", 180.0), ("around", 18.0)]),
        )
        .with(both_kept),
        sample(
            "trefoil-tube",
            Tubes,
            shape("trefoil", &[("along", 180.0), ("around", 18.0)]),
        )
        .with(area_kept),
        sample(
            "linked-tubes",
            Tubes,
            shape(
                "torus-knot",
                &[
                    ("p", 2.0),
                    ("q", 4.0),
                    ("tube", 0.4),
                    ("along", 100.0),
                    ("around", 14.0),
                ],
            ),
        )
        .with(area_kept),
        sample(
            "bumps-kept",
            Closed,
            shape("bumpy-sphere", &[("level", 4.0)]),
        )
        .with(|o| {
            p_willmore(FlowOptions {
                keep: vec![Area],
                ..o
            })
        }),
        sample("ellipsoid-p", Closed, shape("ellipsoid", &[("level", 4.0)]))
            .with(|o| volume_kept(FlowOptions { p: 4.0, ..o })),
        sample("cylinder-gaps", Repair, shape("cylinder-gaps", &[])).with(mmcv),
        sample("sphere-openings", Repair, shape("sphere-openings", &[])).with(mmcv),
        sample("two-tubes", Tubes, shape("tubes", &[("count", 2.0)]))
            .with(mmcv)
            .filled(Holes::Blended(&[0, 2])),
        sample("three-tubes", Tubes, shape("tubes", &[("count", 3.0)]))
            .with(mmcv)
            .filled(Holes::Blended(&[0, 2, 4])),
        sample("six-tubes", Tubes, shape("tubes", &[("count", 6.0)]))
            .with(mmcv)
            .filled(Holes::Blended(&[0, 2, 4, 6, 8, 10])),
        sample(
            "holed-scan",
            Repair,
            shape("scan-clean", &[("resolution", 140.0), ("loops", 30.0)]),
        )
        .with(mmcv)
        .filled(Holes::Small),
        sample("holed-sphere", Repair, shape("holed-sphere", &[]))
            .with(mmcv)
            .filled(Holes::All),
        sample("dodecahedron", Boundary, shape("dodecahedron", &[])).with(mmcv_prefilled),
        sample("four-bumps", Boundary, shape("four-bumps", &[])).with(mmcv_prefilled),
        sample(
            "sampled-torus",
            Flips,
            shape("sampled-torus", &[("jitter", 0.05)]),
        )
        .with(flips),
        sample("uneven-torus", Flips, shape("sampled-torus", &[])).with(flips),
        sample("creased-face", Flips, shape("creased-face", &[])).with(flips),
        sample("eared-head", Flips, shape("eared-head", &[("jitter", 0.2)])).with(flips),
        sample("counterexample", Flips, shape("counterexample", &[])).with(flips),
        sample("moebius", Boundary, shape("moebius", &[])).with(fixed),
        sample("klein-bottle", Closed, shape("klein-bottle", &[])),
        sample(
            "saddle",
            Boundary,
            shape("hyperbolic-paraboloid", &[("cells", 16.0)]),
        )
        .with(free),
        sample(
            "genus-4",
            Closed,
            shape("double-torus", &[("genus", 4.0), ("level", 3.0)]),
        )
        .with(p_willmore),
        sample(
            "morin",
            Closed,
            shape("morin", &[("vertices", 1200.0), ("push", -0.03)]),
        )
        .with(area_kept),
        sample(
            "morin-fine",
            Closed,
            shape("morin", &[("vertices", 5000.0), ("push", -0.03)]),
        )
        .with(area_kept),
        sample("boy", Closed, shape("boy", &[])),
        // Its edges lie on lines of curvature, as those of the Clifford torus do.
        sample("cyclide", Closed, shape("cyclide", &[])).with(|o| FlowOptions {
            epsilon: 0.001,
            ..o
        }),
        sample("inverted-catenoid", Closed, shape("inverted-catenoid", &[])),
        sample(
            "lawson-two-handles",
            Closed,
            shape("lawson", &[("genus", 2.0)]),
        )
        .with(area_kept),
        sample(
            "lawson-three-handles",
            Closed,
            shape("lawson", &[("genus", 3.0), ("cells", 12.0)]),
        )
        .with(area_kept),
        sample(
            "rough-mesh",
            Repair,
            shape("ellipsoid", &[("level", 4.0), ("jitter", 0.2)]),
        )
        .with(volume_kept),
        sample(
            "range-scan",
            Repair,
            shape("scan", &[("resolution", 285.0), ("loops", 88.0)]),
        )
        .with(smoothed),
    ]
};
