//! N-sided hole filling and blending: the first surface, which a flow then fairs.
//!
//! After Xu & Zhang [XZ06](crate::bibliography#xz06), Sections 5.1 and 5.2. Each hole is
//! triangulated by least area, remeshed to the mean edge length of its loop, and drawn into the
//! surface around it by polyharmonic fills of order 3 ([`crate::operator::polyharmonic`]), so
//! that position, tangent plane and curvature continue nearly. Several loops can instead be
//! connected by one patch, which begins as their convex hull.
//!
//! Old vertices keep their numbers and positions bit for bit, old faces their numbers and
//! corners; what is new follows. Two holes that share a corner are two loops, though the mesh has
//! copies of that corner, one for each sheet: they are one vertex again in what is filled, and
//! numbers after the second move up. (Only where a closed part of the result would be inside out its
//! faces are turned, as [`build`](crate::mesh::build()) does, and a warning says so.) Nothing depends
//! on position, orientation or size of the mesh.

mod blend;
mod boundary;
mod error;
mod fair;
mod hull;
mod minimal_area;
mod notice;
mod patch;
mod refine;
mod side;

pub use boundary::{BoundaryLoop, boundary_loops, small_loops};
pub use error::{FillError, FillNotice};

use crate::mesh::{Built, HalfedgeMesh, Repair, build};
use crate::soup::PolygonSoup;
use boundary::{Rim, check_simple};
use fair::{Lowered, ORDER, fair};
use glam::DVec3;
use minimal_area::{Outline, Triangulation};
use patch::Patch;
use refine::{Smoothing, Target, refine};
use std::ops::{ControlFlow, Range};

/// Told a stage's name and the share done; breaking ends the fill.
pub type FillProgress<'a> = &'a mut dyn FnMut(&'static str, f64) -> ControlFlow<()>;

/// What is filled, and how finely.
#[derive(Clone, Debug, PartialEq)]
pub struct FillOptions {
    /// Numbers of the loops; all if absent.
    pub loops: Option<Vec<usize>>,
    /// Whether loops that cannot be filled are left open, with a notice, and are no error as long
    /// as there are others; where all are filled it is always so.
    pub lenient: bool,
    /// Whether one patch connects the loops, instead of one patch each.
    pub connect: bool,
    /// New vertices at most, of all patches together. Where the loops' own edge lengths ask
    /// for more, patches are coarser.
    pub max_vertices: usize,
}

impl Default for FillOptions {
    fn default() -> Self {
        Self {
            loops: None,
            lenient: false,
            connect: false,
            max_vertices: 200_000,
        }
    }
}

impl FillOptions {
    fn is_lenient(&self) -> bool {
        self.lenient || self.loops.is_none()
    }
}

/// A new piece of surface.
#[derive(Clone, Debug, PartialEq)]
pub struct FilledPatch {
    /// The loops it closes or connects.
    pub loops: Vec<usize>,
    /// Its new vertices.
    pub vertices: Range<u32>,
    /// Its faces.
    pub faces: Range<u32>,
    /// Order of the polyharmonic fill; 3 unless a warning says why not.
    pub order: usize,
}

/// The filled mesh.
#[derive(Clone, Debug)]
pub struct Filled {
    /// Connectivity: the old faces, of any degree, and the triangles of the patches.
    pub mesh: HalfedgeMesh,
    /// Positions.
    pub positions: Vec<DVec3>,
    /// The patches in the order of their loops.
    pub patches: Vec<FilledPatch>,
    /// What is worth knowing.
    pub notices: Vec<FillNotice>,
    /// What was repaired in the filled mesh.
    pub repairs: Vec<Repair>,
}

/// Rounds of remeshing of the membrane or hull, and of the curved patch it becomes.
const ROUNDS: [usize; 2] = [8, 4];
/// Fills after the second remeshing: each takes its weights from the last.
const PASSES: usize = 3;
/// The fill of a hole bulges out of its membrane, and takes more vertices than that.
const BULGE: f64 = 1.5;

/// A patch takes so many times the vertices it should at most: edge lengths of a loop that
/// vary wildly must not let it run away.
const AMPLE: f64 = 4.0;

/// A patch under way.
struct Job {
    rim: Rim,
    patch: Patch,
    length: f64,
    most: usize,
    order: usize,
    lowered: Option<Lowered>,
    /// ∫K that the surroundings ask of the patch, where it is a disc.
    total_curvature: Option<f64>,
}

/// Fills holes, or connects loops, of a mesh at `x`.
///
/// # Errors
/// [`FillError`].
pub fn fill(
    mesh: &HalfedgeMesh,
    x: &[DVec3],
    options: &FillOptions,
    progress: FillProgress<'_>,
) -> Result<Filled, FillError> {
    let mut notices = Vec::new();
    let all = boundary_loops(mesh, x);
    if !mesh.is_oriented() {
        return Err(FillError::NotOrientable);
    }
    let chosen = choose(&all, x, options, &mut notices)?;
    let groups: Vec<Vec<usize>> = if options.connect {
        vec![chosen]
    } else {
        chosen.into_iter().map(|index| vec![index]).collect()
    };
    let mut jobs = Vec::with_capacity(groups.len());
    for (done, group) in groups.iter().enumerate() {
        tell(progress, "triangulate", done as f64 / groups.len() as f64)?;
        jobs.push(begin(
            mesh,
            x,
            Rim::new(mesh, &all, group.clone()),
            options,
        )?);
    }
    limit_sizes(&mut jobs, options.max_vertices, &mut notices);

    let first = if options.connect {
        Smoothing::Tangential
    } else {
        Smoothing::Umbrella
    };
    remesh(&mut jobs, ROUNDS[0], first, progress)?;
    let mut old = mesh.to_soup(x);
    unite_copies(&mut old, &all, &mut jobs);
    let triangles = old.triangulated();
    leave_misfits(&triangles, &mut jobs, options, &mut notices)?;
    draw_in(&mut jobs, &triangles, 1, progress)?;
    if !options.connect {
        remesh(&mut jobs, ROUNDS[1], Smoothing::Tangential, progress)?;
        draw_in(&mut jobs, &triangles, PASSES, progress)?;
    }
    notices.extend(jobs.iter().flat_map(notice::of));
    finish(old, jobs, notices)
}

fn tell(progress: FillProgress<'_>, stage: &'static str, share: f64) -> Result<(), FillError> {
    match progress(stage, share) {
        ControlFlow::Continue(()) => Ok(()),
        ControlFlow::Break(()) => Err(FillError::Cancelled),
    }
}

/// The loops to fill, checked.
fn choose(
    all: &[BoundaryLoop],
    x: &[DVec3],
    options: &FillOptions,
    notices: &mut Vec<FillNotice>,
) -> Result<Vec<usize>, FillError> {
    if all.is_empty() {
        return Err(FillError::NoLoops);
    }
    let mut chosen = match &options.loops {
        Some(loops) => loops.clone(),
        None => (0..all.len()).collect(),
    };
    chosen.sort_unstable();
    chosen.dedup();
    if let Some(&index) = chosen.iter().find(|index| **index >= all.len()) {
        let loops = all.len();
        return Err(FillError::LoopOutOfRange { index, loops });
    }
    let mut touching = None;
    let mut simple = Vec::with_capacity(chosen.len());
    for index in chosen {
        match check_simple(index, &all[index], x) {
            Ok(()) => simple.push(index),
            Err(error) if !options.is_lenient() => return Err(error),
            Err(error) => {
                touching.get_or_insert_with(|| error.clone());
                notices.push(FillNotice::LeftOpen { reason: error });
            }
        }
    }
    if options.connect && simple.len() < 2 {
        let loops = simple.len();
        return Err(FillError::TooFewLoops { loops });
    }
    match touching {
        Some(error) if simple.is_empty() => Err(error),
        _ if simple.is_empty() => Err(FillError::NoLoops),
        _ => Ok(simple),
    }
}

/// The first, coarse patch.
fn begin(
    mesh: &HalfedgeMesh,
    x: &[DVec3],
    rim: Rim,
    options: &FillOptions,
) -> Result<Job, FillError> {
    let mut points: Vec<DVec3> = rim.vertices.iter().map(|&v| x[v as usize]).collect();
    let angles = rim.angles(mesh, x);
    let faces = if options.connect {
        blend::connect(&rim, &points)?
    } else {
        let outline = Outline {
            x: &points,
            angles: &angles,
            is_forbidden: &|i, j| rim.is_joined(i, j),
        };
        let mut found = Triangulation::default();
        if rim.is_face(mesh) {
            outline.fan(&[0, 1, 2], &mut found);
        } else {
            found = outline.triangulate();
        }
        points.extend(found.middles);
        found.faces
    };
    let (valences, joined) = (rim.valences.clone(), rim.joined.clone());
    let mut patch = Patch::new(points, faces, valences, joined, rim.mean_edge);
    if rim.is_face(mesh) {
        patch.forbid_face();
    }
    let is_side = !options.connect && side::is_side(mesh, x, &rim);
    Ok(Job {
        patch,
        length: rim.mean_edge,
        most: usize::MAX,
        order: if is_side { 1 } else { ORDER },
        lowered: is_side.then_some(Lowered::Side),
        total_curvature: (!options.connect).then(|| notice::total_curvature(&angles)),
        rim,
    })
}

/// Shares out the number of new vertices, and coarsens where it would be exceeded.
fn limit_sizes(jobs: &mut [Job], most: usize, notices: &mut Vec<FillNotice>) {
    let hexagon = 0.5 * 3f64.sqrt();
    let wanted = |job: &Job| {
        let vertices = BULGE * job.patch.area() / (hexagon * job.length.powi(2));
        if vertices.is_finite() { vertices } else { 0.0 }
    };
    let total: f64 = jobs.iter().map(wanted).sum();
    let coarser = (total / most.max(1) as f64).max(1.0);
    for job in jobs {
        let share = wanted(job) / total.max(1.0) * most as f64;
        let ample = AMPLE * wanted(job) + job.patch.x.len() as f64;
        job.most = if coarser > 1.0 {
            share
        } else {
            ample.min(most as f64)
        } as usize;
        job.length *= coarser.sqrt();
        let n_rim = job.patch.n_rim();
        job.patch.sizes[n_rim..].fill(job.length);
    }
    if coarser > 1.0 {
        notices.push(FillNotice::Coarser {
            vertices: total.round(),
            most,
            times: coarser.sqrt(),
        });
    }
}

fn remesh(
    jobs: &mut [Job],
    rounds: usize,
    smoothing: Smoothing,
    progress: FillProgress<'_>,
) -> Result<(), FillError> {
    let n = jobs.len() as f64;
    for (done, job) in jobs.iter_mut().enumerate() {
        let target = Target {
            length: job.length,
            rounds,
            smoothing,
            most: job.most,
        };
        let tell = &mut |share: f64| progress("remesh", (done as f64 + share) / n);
        if refine(&mut job.patch, &target, tell).is_break() {
            return Err(FillError::Cancelled);
        }
    }
    Ok(())
}

/// Makes one vertex of the copies that the jobs' loops meet in; later numbers move up.
fn unite_copies(old: &mut PolygonSoup, all: &[BoundaryLoop], jobs: &mut [Job]) {
    let filled = jobs.iter().flat_map(|job| &job.rim.loops);
    let copies: Vec<[u32; 2]> = filled
        .flat_map(|&index| all[index].copies.iter().copied())
        .collect();
    if copies.is_empty() {
        return;
    }
    let n = old.positions.len() as u32;
    let mut first: Vec<u32> = (0..n).collect();
    let least = |first: &[u32], mut v: u32| {
        while first[v as usize] != v {
            v = first[v as usize];
        }
        v
    };
    for pair in copies {
        let [a, b] = pair.map(|v| least(&first, v));
        first[a.max(b) as usize] = a.min(b);
    }
    let mut name = vec![0; first.len()];
    let mut positions = Vec::with_capacity(first.len());
    for v in 0..n {
        let one = least(&first, v);
        if one == v {
            name[v as usize] = positions.len() as u32;
            positions.push(old.positions[v as usize]);
        } else {
            name[v as usize] = name[one as usize];
        }
    }
    old.positions = positions;
    let vertices = jobs.iter_mut().flat_map(|job| &mut job.rim.vertices);
    for v in old.corners.iter_mut().chain(vertices) {
        *v = name[*v as usize];
    }
}

/// Whether the builder makes a mesh of a soup without leaving anything out, so that numbers stay.
fn is_kept(soup: &PolygonSoup) -> bool {
    build(soup).is_ok_and(|built| {
        built.mesh.n_faces() == soup.n_faces() && built.positions.len() == soup.positions.len()
    })
}

/// Leaves the loops open whose patch the surface around leaves no room for: it would fall onto
/// faces that are there.
///
/// # Errors
/// Where nothing may be left open, or no other loop is left.
fn leave_misfits(
    triangles: &PolygonSoup,
    jobs: &mut Vec<Job>,
    options: &FillOptions,
    notices: &mut Vec<FillNotice>,
) -> Result<(), FillError> {
    if is_kept(&assemble(triangles, jobs).0) {
        return Ok(());
    }
    let mut fitting: Vec<Job> = Vec::new();
    let mut last = None;
    for job in jobs.drain(..) {
        let index = job.rim.loops.first().copied().unwrap_or_default();
        fitting.push(job);
        if !is_kept(&assemble(triangles, &fitting).0) {
            fitting.pop();
            let reason = FillError::NoRoom { index };
            notices.push(FillNotice::LeftOpen {
                reason: reason.clone(),
            });
            last = Some(reason);
        }
    }
    *jobs = fitting;
    match last {
        Some(error) if !options.is_lenient() || jobs.is_empty() => Err(error),
        _ => Ok(()),
    }
}

/// Old faces and patches as one soup, and where each patch's new vertices and faces are.
fn assemble(old: &PolygonSoup, jobs: &[Job]) -> (PolygonSoup, Vec<[Range<u32>; 2]>) {
    let mut soup = old.clone();
    let mut ranges = Vec::with_capacity(jobs.len());
    for Job { rim, patch, .. } in jobs {
        let (first, first_face) = (soup.positions.len() as u32, soup.n_faces() as u32);
        let n_rim = patch.n_rim();
        soup.positions.extend_from_slice(&patch.x[n_rim..]);
        for face in patch.faces() {
            soup.push_face(&face.map(|v| match rim.vertices.get(v as usize) {
                Some(&old) => old,
                None => first + v - n_rim as u32,
            }));
        }
        let (end, end_face) = (soup.positions.len() as u32, soup.n_faces() as u32);
        ranges.push([first..end, first_face..end_face]);
    }
    (soup, ranges)
}

/// Fills every patch by the highest order it allows, one after the other.
fn draw_in(
    jobs: &mut [Job],
    triangles: &PolygonSoup,
    passes: usize,
    progress: FillProgress<'_>,
) -> Result<(), FillError> {
    let (soup, ranges) = assemble(triangles, jobs);
    let Built {
        mesh,
        mut positions,
        ..
    } = build(&soup)?;
    let n = jobs.len() as f64;
    for (done, (job, [free, _])) in jobs.iter_mut().zip(ranges).enumerate() {
        tell(progress, "fill", done as f64 / n)?;
        let (order, lowered) = fair(&mesh, &mut positions, &free, passes, job.order)?;
        if order < job.order {
            (job.order, job.lowered) = (order, lowered);
        }
        let n_rim = job.patch.n_rim();
        let moved = &positions[free.start as usize..free.end as usize];
        job.patch.x[n_rim..].copy_from_slice(moved);
    }
    Ok(())
}

fn finish(old: PolygonSoup, jobs: Vec<Job>, notices: Vec<FillNotice>) -> Result<Filled, FillError> {
    let (soup, ranges) = assemble(&old, &jobs);
    let Built {
        mesh,
        positions,
        repairs,
        ..
    } = build(&soup)?;
    if mesh.n_faces() != soup.n_faces() || positions.len() != soup.positions.len() {
        let loops = jobs.first().and_then(|job| job.rim.loops.first());
        let index = loops.copied().unwrap_or_default();
        return Err(FillError::NoRoom { index });
    }
    let report = |(job, [vertices, faces]): (Job, [Range<u32>; 2])| FilledPatch {
        loops: job.rim.loops,
        vertices,
        faces,
        order: job.order,
    };
    Ok(Filled {
        mesh,
        positions,
        patches: jobs.into_iter().zip(ranges).map(report).collect(),
        notices,
        repairs,
    })
}
