//! How flows end on sound and on rough meshes, left to themselves: the energy at first and last,
//! the largest relative rise of the monitored functional in a step, the smallest angle there was.

use super::{BenchOptions, Measurement, Row, Table, named};
use crate::app::document::Document;
use crate::app::unpacked::{OpenedFile, unpacked};
use crate::app::{Fault, Session, State};
use crate::flow::StepReport;
use crate::flow::constraint::Kept;
use crate::flow::option::kind::id_of;
use crate::flow::options::FlowOptions;
use crate::flow::spec::{FLOWS, Family, FlowName};
use crate::mesh::noise::SplitMix64;
use crate::mesh::shape;
use crate::soup::PolygonSoup;
use glam::DVec3;
use std::f64::consts::{SQRT_2, TAU};
use std::rc::Rc;
use web_time::Instant;

pub(super) const TABLE: Table = Table {
    columns: &[
        "case", "flow", "ending", "steps", "first", "last", "rise", "angle", "seconds",
    ],
    left: 3,
    digits: Some(4),
    measurements,
};

/// Steps of each flow on meshes of one's own.
const STEPS: usize = 100;

/// A flow, and what it keeps.
#[derive(Clone, Copy)]
struct Left {
    flow: FlowName,
    keep: &'static [Kept],
}

const fn free(flow: FlowName) -> Left {
    Left { flow, keep: &[] }
}

const KEPT: Left = Left {
    flow: FlowName::PWillmore,
    keep: &[Kept::Area, Kept::Volume],
};

/// What a case is made of.
#[derive(Clone, Copy)]
enum Made {
    Shape(&'static str, &'static [(&'static str, f64)]),
    /// A torus of quadrilaterals: both radii, and its cells around and of the tube.
    Quads([f64; 2], [usize; 2]),
}

struct Case {
    name: &'static str,
    made: Made,
    /// Standard deviation of each coordinate, in mean edge lengths.
    noise: f64,
    flows: &'static [Left],
}

// A table reads best by lines.
#[rustfmt::skip]
const CASES: &[Case] = &{
    use FlowName::{Circle, MeanCurvature, Mmcv, PWillmore, Willmore};
    use Made::{Quads, Shape};
    [
        Case { name: "ellipsoid", noise: 0.0,
            made: Shape("ellipsoid", &[("a", 1.5), ("b", 1.0), ("c", 0.7), ("level", 3.0)]),
            flows: &[free(Willmore), free(Mmcv), free(MeanCurvature)] },
        Case { name: "Clifford torus, noise 0.15 h", noise: 0.15,
            made: Shape("torus",
                &[("major", SQRT_2), ("minor", 1.0), ("around", 40.0), ("tube", 20.0)]),
            flows: &[free(Circle)] },
        Case { name: "torus of quads, noise 0.04 h", noise: 0.04,
            made: Quads([1.3, 0.5], [36, 18]),
            flows: &[free(PWillmore)] },
        Case { name: "near-sphere, noise 0.04 h", noise: 0.04,
            made: Shape("ellipsoid", &[("a", 1.1), ("b", 1.0), ("c", 1.0), ("level", 4.0)]),
            flows: &[KEPT] },
        Case { name: "spheroid, noise 0.04 h", noise: 0.04,
            made: Shape("ellipsoid", &[("a", 2.2), ("b", 1.0), ("c", 1.0), ("level", 4.0)]),
            flows: &[KEPT] },
        Case { name: "ellipsoid, noise 0.12 h", noise: 0.12,
            made: Shape("ellipsoid", &[("a", 1.0), ("b", 0.8), ("c", 0.6), ("level", 3.0)]),
            flows: &[KEPT] },
        Case { name: "dumbbell", noise: 0.0,
            made: Shape("dumbbell", &[("level", 4.0), ("waist", 0.15)]),
            flows: &[free(MeanCurvature)] },
    ]
};

/// Flows that are tried on meshes of one's own.
fn every() -> Vec<Left> {
    let by_curvature = FLOWS.iter().filter(|row| row.family == Family::Curvature);
    let others = [free(FlowName::Circle), free(FlowName::PWillmore), KEPT];
    others
        .into_iter()
        .chain(by_curvature.map(|row| free(row.id)))
        .collect()
}

/// Makes the mesh of a case anew.
type Load = Rc<dyn Fn() -> Result<Session, Fault>>;

fn measurements(options: &BenchOptions) -> Vec<Measurement> {
    if options.meshes.is_empty() {
        let of_case = |case: &'static Case| {
            of_mesh(
                case.name,
                Rc::new(|| case.load()),
                case.flows.to_vec(),
                None,
                options,
            )
        };
        return CASES.iter().flat_map(of_case).collect();
    }
    let of_file = |file: &OpenedFile| {
        let (name, file) = (file.name.clone(), file.clone());
        let load = move || {
            let mut session = Session::new();
            let mesh = unpacked(std::slice::from_ref(&file))?;
            session.load(&mesh.bytes, &mesh.name)?;
            Ok(session)
        };
        of_mesh(&name, Rc::new(load), every(), Some(STEPS), options)
    };
    options.meshes.iter().flat_map(of_file).collect()
}

/// A measurement a flow; one that says why, where the mesh is refused.
fn of_mesh(
    name: &str,
    load: Load,
    flows: Vec<Left>,
    max_steps: Option<usize>,
    options: &BenchOptions,
) -> Vec<Measurement> {
    let vertices = load().and_then(|session| Ok(session.info()?.vertices));
    let case = ("case", name.to_owned().into());
    match vertices {
        Err(fault) => vec![Box::new(move || Ok(vec![vec![case, refused(&fault)]]))],
        Ok(vertices) if !options.takes(vertices) => Vec::new(),
        Ok(_) => {
            let measurement = |left: Left| -> Measurement {
                let (load, mut row) = (Rc::clone(&load), vec![case.clone()]);
                Box::new(move || {
                    let names = left.keep.iter().map(id_of);
                    let names: Vec<&str> = std::iter::once(left.flow.id()).chain(names).collect();
                    row.push(("flow", names.join(", ").into()));
                    row.extend(run(&load, left, max_steps)?);
                    Ok(vec![row])
                })
            };
            flows.into_iter().map(measurement).collect()
        }
    }
}

fn refused(fault: &Fault) -> (&'static str, crate::message::Value) {
    ("ending", format!("refused: {}", fault.kind).into())
}

/// Runs a flow on the mesh as it was: what another has done to it is nothing to this one.
fn run(load: &Load, left: Left, max_steps: Option<usize>) -> Result<Row, Fault> {
    let mut session = load()?;
    let configured = session.configure(FlowOptions {
        flow: left.flow,
        keep: left.keep.to_vec(),
        max_steps,
        ..FlowOptions::default()
    });
    if let Err(fault) = configured {
        return Ok(vec![refused(&fault)]);
    }
    let (first, begun) = (session.state()?, Instant::now());
    let mut fault = None;
    while fault.is_none() && !session.state()?.status.is_final() {
        match session.step() {
            Ok(Some(_)) => {}
            Ok(None) => break,
            Err(error) => fault = Some(error.kind),
        }
    }
    let seconds = begun.elapsed().as_secs_f64();
    let mut row = ending(&first, &session.state()?, session.reports()?, fault);
    row.push(("seconds", seconds.into()));
    Ok(row)
}

/// How a run went from `first` to `last`.
fn ending(first: &State, last: &State, reports: &[StepReport], fault: Option<&str>) -> Row {
    let status = named(last.status);
    // Within steps: between them a flow may take up another functional, as that of a smaller ε.
    let rise = |r: &StepReport| (r.objective - r.objective_before) / r.objective_before.abs();
    let angles = reports.iter().map(|report| report.min_angle_degrees);
    vec![
        (
            "ending",
            fault.map_or(status.into(), |kind| format!("{status}: {kind}").into()),
        ),
        ("steps", reports.len().into()),
        ("first", first.energy.into()),
        ("last", last.energy.into()),
        ("rise", reports.iter().map(rise).fold(0.0, f64::max).into()),
        (
            "angle",
            angles.fold(first.min_angle_degrees, f64::min).into(),
        ),
    ]
}

impl Case {
    fn load(&self) -> Result<Session, Fault> {
        let mut soup = match self.made {
            Made::Shape(name, parameters) => {
                let values: Vec<(String, f64)> = parameters
                    .iter()
                    .map(|(name, value)| ((*name).into(), *value))
                    .collect();
                shape::make(name, &values)?.soup
            }
            Made::Quads(radii, cells) => torus_of_quads(radii, cells),
        };
        shake(&mut soup, self.noise);
        let mut session = Session::new();
        session.open(Document::from_sample(self.name, soup.into())?)?;
        Ok(session)
    }
}

/// A torus about the z axis, its faces quadrilaterals.
fn torus_of_quads([major, minor]: [f64; 2], [around, tube]: [usize; 2]) -> PolygonSoup {
    let at = |i: usize, j: usize| ((i % around) * tube + j % tube) as u32;
    let cells = (0..around).flat_map(|i| (0..tube).map(move |j| (i, j)));
    let point = |(i, j): (usize, usize)| {
        let (sin_u, cos_u) = (TAU * i as f64 / around as f64).sin_cos();
        let (sin_v, cos_v) = (TAU * j as f64 / tube as f64).sin_cos();
        let r = major + minor * cos_v;
        DVec3::new(r * cos_u, r * sin_u, minor * sin_v)
    };
    let face = |(i, j)| [at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1)];
    let faces: Vec<[u32; 4]> = cells.clone().map(face).collect();
    PolygonSoup::from_faces(cells.map(point).collect(), &faces)
}

/// Moves every coordinate by a normally distributed number of standard deviation `noise`, in
/// mean sides of the faces; the same each time.
fn shake(soup: &mut PolygonSoup, noise: f64) {
    let x = &soup.positions;
    let sides = soup.faces().flat_map(|face| {
        let next = face.iter().cycle().skip(1);
        face.iter()
            .zip(next)
            .map(|(a, b)| x[*a as usize].distance(x[*b as usize]))
    });
    let (count, sum) = sides.fold((0.0, 0.0), |(count, sum), side| (count + 1.0, sum + side));
    let deviation = noise * sum / f64::max(count, 1.0);
    let mut random = SplitMix64::new(1);
    for p in &mut soup.positions {
        *p += deviation * DVec3::from_array(std::array::from_fn(|_| random.gaussian()));
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::flow::Status;
    use crate::message::Value;

    #[test]
    fn a_row_tells_the_largest_rise_within_a_step_and_the_smallest_angle_of_all() {
        let state = |energy: f64, degrees: f64, status| State {
            energy,
            min_angle_degrees: degrees,
            status,
            ..State::default()
        };
        let report = |objective_before: f64, objective: f64, min_angle_degrees: f64| StepReport {
            objective_before,
            objective,
            min_angle_degrees,
            ..StepReport::default()
        };
        // Between the steps another functional was taken up: from 8 to 20 is no rise.
        let reports = [
            report(10.0, 8.0, 25.0),
            report(20.0, 21.0, 12.0),
            report(21.0, 21.42, 18.0),
        ];
        let first = state(30.0, 40.0, Status::Ready);
        let last = state(27.0, 18.0, Status::Stalled);
        let row = ending(&first, &last, &reports, None);
        let number = |x: f64| Value::Number(x);
        let expected = [
            ("ending", "stalled".into()),
            ("steps", number(3.0)),
            ("first", number(30.0)),
            ("last", number(27.0)),
            ("rise", number(0.05)),
            ("angle", number(12.0)),
        ];
        assert_eq!(row, expected);
        let failed = state(27.0, 18.0, Status::Failed);
        let row = ending(&first, &failed, &[], Some("NonFiniteEnergy"));
        assert_eq!(row[0].1, "failed: NonFiniteEnergy".into());
        assert_eq!((&row[4].1, &row[5].1), (&number(0.0), &number(40.0)));
    }

    #[test]
    fn noise_is_normally_distributed_and_the_same_each_time() {
        // A strip of unit squares: the mean side is 1.
        let count = 2000_u32;
        let points = (0..2 * count).map(|n| DVec3::new(f64::from(n >> 1), f64::from(n & 1), 0.0));
        let faces: Vec<[u32; 4]> = (0..count - 1)
            .map(|n| [0, 1, 3, 2].map(|corner| 2 * n + corner))
            .collect();
        let still = PolygonSoup::from_faces(points.collect(), &faces);
        let moved = || {
            let mut soup = still.clone();
            shake(&mut soup, 0.1);
            soup.positions
        };
        let pairs = moved().into_iter().zip(&still.positions);
        let moves: Vec<f64> = pairs.flat_map(|(p, q)| (p - *q).to_array()).collect();
        let snapshot = |k: i32| {
            let sum: f64 = moves.iter().map(|x| (x / 0.1).powi(k)).sum();
            sum / moves.len() as f64
        };
        // Of 12,000 numbers: standard errors are 0.009, 0.013 and 0.09.
        assert!(snapshot(1).abs() < 0.04, "{}", snapshot(1));
        assert!((snapshot(2) - 1.0).abs() < 0.05, "{}", snapshot(2));
        assert!((snapshot(4) - 3.0).abs() < 0.36, "{}", snapshot(4));
        assert_eq!(moved(), moved());
    }

    #[test]
    fn the_torus_of_quads_is_one() {
        let soup = torus_of_quads([1.3, 0.5], [36, 18]);
        assert_eq!((soup.positions.len(), soup.n_faces()), (648, 648));
        for p in &soup.positions {
            let ring = p.truncate().length() - 1.3;
            assert!((ring.hypot(p.z) - 0.5).abs() < 1e-14);
        }
        let mut session = Session::new();
        let document = Document::from_sample("torus", soup.into()).expect("a torus");
        let info = session.open(document).expect("a torus").info;
        assert_eq!((info.genus, info.closed, info.faces), (Some(1), true, 648));
        assert!(info.volume.expect("closed") > 0.0, "outward");
    }
}
