//! What several test files share.
#![allow(dead_code, reason = "benches use a part of it")]
#![allow(unreachable_pub, reason = "a program has no public interface")]
#![allow(missing_docs, reason = "names say it; this is test code")]

pub mod flap_matrix;
pub mod implicit;
pub mod parts;
pub mod session;
pub mod watched;

use glam::DVec3;
use std::path::PathBuf;
use std::rc::Rc;
use umbilic::flow::options::FlowOptions;
use umbilic::flow::{Driver, FlowError};
use umbilic::mesh::{Built, HalfedgeMesh, Repair, build, shape};
use umbilic::remesh::fill::boundary_loops;
use umbilic::soup::PolygonSoup;

/// A mesh ready for use.
pub struct Surface {
    pub mesh: Rc<HalfedgeMesh>,
    pub x: Vec<DVec3>,
    pub repairs: Vec<Repair>,
}

pub fn surface(soup: &PolygonSoup) -> Surface {
    let Built {
        mesh,
        positions,
        repairs,
        ..
    } = build(soup).expect("a surface");
    mesh.validate().expect("valid connectivity");
    Surface {
        mesh: Rc::new(mesh),
        x: positions,
        repairs,
    }
}

/// A run of the flow that the options ask for.
pub fn drive(
    mesh: &Rc<HalfedgeMesh>,
    x: &mut [DVec3],
    options: FlowOptions,
) -> Result<Driver, FlowError> {
    Driver::start(mesh, mesh, x, options)
}

/// A folder of `../shared`, beside the project; says that tests skip where it is missing.
pub fn shared_folder(name: &str) -> Option<PathBuf> {
    let folder = PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../shared");
    let folder = folder.join(name);
    if folder.is_dir() {
        return Some(folder);
    }
    eprintln!("skipped: no folder ../shared/{name} beside the project");
    None
}

/// The folder of real meshes, where it is present.
pub fn shared_meshes() -> Option<PathBuf> {
    shared_folder("meshes")
}

fn soup_in(folder: &str, name: &str) -> Option<PolygonSoup> {
    let bytes = std::fs::read(shared_folder(folder)?.join(name)).expect("file of the folder");
    Some(umbilic::io::read(&bytes, name).expect("readable").soup)
}

/// A real mesh, triangulated if it has other polygons.
pub fn real(name: &str) -> Option<Surface> {
    let soup = soup_in("meshes", name)?;
    Some(surface(&soup.triangulated()))
}

/// A mesh of a case that went wrong once, from a subfolder of `cases`.
pub fn case(folder: &str, name: &str) -> Option<Surface> {
    Some(surface(&soup_in(&format!("cases/{folder}"), name)?))
}

/// A fixture of `tests/reference`.
pub fn reference(name: &str) -> serde_json::Value {
    let path = PathBuf::from(env!("CARGO_MANIFEST_DIR"))
        .join("tests/reference")
        .join(format!("{name}.json"));
    let text = std::fs::read_to_string(path).expect("a fixture");
    serde_json::from_str(&text).expect("JSON")
}

pub fn number(value: &serde_json::Value) -> f64 {
    value.as_f64().expect("a number")
}

pub fn numbers(value: &serde_json::Value) -> Vec<f64> {
    value
        .as_array()
        .expect("an array")
        .iter()
        .map(number)
        .collect()
}

pub fn indices(value: &serde_json::Value) -> Vec<u32> {
    numbers(value).into_iter().map(|i| i as u32).collect()
}

pub fn points(value: &serde_json::Value) -> Vec<DVec3> {
    let rows = value.as_array().expect("an array");
    rows.iter()
        .map(|p| DVec3::from_slice(&numbers(p)))
        .collect()
}

pub fn soup_of(value: &serde_json::Value) -> PolygonSoup {
    let faces: Vec<Vec<u32>> = value["faces"]
        .as_array()
        .expect("faces")
        .iter()
        .map(indices)
        .collect();
    PolygonSoup::from_faces(points(&value["positions"]), &faces)
}

pub fn largest_difference(a: &[DVec3], b: &[DVec3]) -> f64 {
    assert_eq!(a.len(), b.len());
    a.iter()
        .zip(b)
        .map(|(a, b)| a.distance(*b))
        .fold(0.0, f64::max)
}

/// Reproducible numbers in [−1, 1).
pub struct Random(pub u64);

impl Random {
    pub fn next(&mut self) -> f64 {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (self.0 >> 33) as f64 / (1u64 << 30) as f64 - 1.0
    }

    pub fn vector(&mut self) -> DVec3 {
        DVec3::new(self.next(), self.next(), self.next())
    }
}

pub fn sample(name: &str, values: &[(&str, f64)]) -> PolygonSoup {
    let values: Vec<(String, f64)> = values.iter().map(|&(n, v)| (n.into(), v)).collect();
    shape::make(name, &values).expect("a shape").soup
}

/// The faces of a soup for which `keep` holds of their centroid and corners.
pub fn cut(soup: &PolygonSoup, keep: impl Fn(DVec3, &[u32]) -> bool) -> Surface {
    let mut rest = PolygonSoup {
        positions: soup.positions.clone(),
        ..PolygonSoup::default()
    };
    for face in soup.faces() {
        let sum: DVec3 = face.iter().map(|&v| soup.positions[v as usize]).sum();
        if keep(sum / face.len() as f64, face) {
            rest.push_face(face);
        }
    }
    surface(&rest)
}

/// The unit sphere, its vertices pushed about by `jitter` edge lengths, without the cap of
/// that half-angle.
pub fn open_sphere(level: f64, jitter: f64, degrees: f64) -> Surface {
    let mut random = Random(7);
    let mut soup = sample("icosphere", &[("level", level)]);
    let edge = 1.1 / 2f64.powf(level);
    // About an axis that is none of the icosahedron's.
    let pole = DVec3::new(0.3, 0.5, 0.8).normalize();
    for p in &mut soup.positions {
        *p = (*p + jitter * edge * random.vector()).normalize();
    }
    cut(&soup, |c, _| {
        c.normalize().dot(pole) < degrees.to_radians().cos()
    })
}

/// The numbers of the loops around the origin's side of each tube.
pub fn inner_loops(s: &Surface) -> Vec<usize> {
    let all = boundary_loops(&s.mesh, &s.x);
    let is_inner = |i: &usize| {
        let sum: DVec3 = all[*i].vertices.iter().map(|&v| s.x[v as usize]).sum();
        (sum / all[*i].vertices.len() as f64).length() < 1.01
    };
    (0..all.len()).filter(is_inner).collect()
}
