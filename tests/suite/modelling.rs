//! Holes filled and surfaces blended, then faired by a flow: Figures 5.2, 5.3 and 5.5 of
//! Xu & Zhang, and closed forms.

use crate::support::*;
use glam::DVec3;
use std::ops::ControlFlow;
use std::rc::Rc;
use umbilic::energy::circle::Boundary;
use umbilic::energy::curvature_jump::{CurvatureJump, curvature_jump};
use umbilic::flow::Status;
use umbilic::flow::options::FlowOptions;
use umbilic::flow::spec::FlowName;
use umbilic::flow::{Decision, Warning};
use umbilic::geometry::measure;
use umbilic::geometry::quality::is_folded;
use umbilic::mesh::{Face, HalfedgeMesh};
use umbilic::remesh::fill::{FillNotice, FillOptions, boundary_loops, fill};

const FLOWS: [FlowName; 4] = [
    FlowName::MeanCurvature,
    FlowName::SurfaceDiffusion,
    FlowName::Willmore,
    FlowName::Mmcv,
];

/// A mesh after its fill, where a flow begins.
struct Start {
    mesh: Rc<HalfedgeMesh>,
    x: Vec<DVec3>,
    /// Number of vertices before the fill.
    n_old: usize,
    faces: Vec<Face>,
    notices: Vec<FillNotice>,
}

fn start(s: &Surface, loops: Option<Vec<usize>>, connect: bool) -> Start {
    let options = FillOptions {
        loops,
        connect,
        ..FillOptions::default()
    };
    let go_on = &mut |_: &str, _: f64| ControlFlow::Continue(());
    let filled = fill(&s.mesh, &s.x, &options, go_on).expect("filled");
    filled.mesh.validate().expect("valid connectivity");
    let faces = filled.patches.iter().flat_map(|p| p.faces.clone());
    Start {
        faces: faces.map(Face).collect(),
        n_old: s.x.len(),
        mesh: Rc::new(filled.mesh),
        x: filled.positions,
        notices: filled.notices,
    }
}

struct Faired {
    /// What the flow monitors.
    energy: f64,
    x: Vec<DVec3>,
    status: Status,
    steps: usize,
    jump: CurvatureJump,
    folded: usize,
    warnings: Vec<Warning>,
}

impl Faired {
    fn assert_good(&self) {
        assert_eq!(
            (self.status, self.folded),
            (Status::Converged, 0),
            "{:?}",
            self.warnings
        );
        assert!(self.jump.absolute.is_finite() && self.jump.relative.is_finite());
        assert!(self.jump.vertices > 0);
    }
}

impl Start {
    fn fair(&self, flow: FlowName) -> Faired {
        self.fair_after(flow, None)
    }

    /// With so many steps of surface diffusion first; by itself if `None`.
    fn fair_after(&self, flow: FlowName, rungs: Option<usize>) -> Faired {
        let free = (self.n_old as u32..self.x.len() as u32).collect();
        let options = FlowOptions {
            flow,
            boundary: Some(Boundary::Fixed),
            free: Some(free),
            rungs,
            ..FlowOptions::default()
        };
        let mut x = self.x.clone();
        let mut running = drive(&self.mesh, &mut x, options).expect("a flow");
        let (mut steps, mut warnings) = (0, Vec::new());
        let status = loop {
            let (report, verdict) = running.step(&mut x).expect("a step");
            steps += usize::from(report.is_some());
            warnings.extend(report.into_iter().flat_map(|r| r.warnings));
            if let Decision::Stop(status, _) = verdict {
                break status;
            }
        };
        assert_eq!(x[..self.n_old], self.x[..self.n_old], "old vertices moved");
        assert!(x.iter().all(|p| p.is_finite()));
        let is_free: Vec<bool> = (0..x.len()).map(|v| v >= self.n_old).collect();
        let found = Faired {
            energy: running.reading(&x).energy,
            jump: curvature_jump(&self.mesh, &x, &is_free).expect("a rim"),
            folded: self.folded(&x),
            x,
            status,
            steps,
            warnings,
        };
        println!(
            "  {flow:?}: {:?}, {} steps, energy {:.6e}, jump {:.4}, {} folded, {:?}",
            found.status,
            found.steps,
            found.energy,
            found.jump.relative,
            found.folded,
            found.warnings
        );
        found
    }

    /// Faces of the patches that fold over.
    fn folded(&self, x: &[DVec3]) -> usize {
        self.faces
            .iter()
            .filter(|&&f| is_folded(&self.mesh, x, f))
            .count()
    }
}

fn largest(values: impl Iterator<Item = f64>) -> f64 {
    values.fold(0.0, f64::max)
}

#[test]
fn a_cap_of_a_sphere_is_recovered() {
    // Largest distance from the sphere by half-angle of the hole. The sphere has ΔH = 0, so
    // that only the mesh keeps the flow from it.
    for (degrees, bound) in [(20.0, 2e-5), (35.0, 6e-5), (50.0, 1.5e-4), (70.0, 4e-4)] {
        for jitter in [0.0, 0.25] {
            let begin = start(&open_sphere(4.0, jitter, degrees), None, false);
            let end = begin.fair(FlowName::Mmcv);
            let off = |x: &[DVec3]| {
                let new = x[begin.n_old..].iter();
                largest(new.map(|p| (p.length() - 1.0).abs()))
            };
            println!(
                "{degrees}°, {jitter}: {:.1e} -> {:.1e}",
                off(&begin.x),
                off(&end.x)
            );
            end.assert_good();
            assert!(end.steps <= 15, "{degrees}°: {} steps", end.steps);
            assert!(
                off(&end.x) < bound,
                "{degrees}°, {jitter}: {:.1e}",
                off(&end.x)
            );
            assert!(end.jump.relative < 5e-4, "{:?}", end.jump);
        }
    }
}

/// Tubes of the sample, blended, and that blend under a flow.
fn blend(count: f64) -> Start {
    let s = surface(&sample("tubes", &[("count", count)]));
    let begin = start(&s, Some(inner_loops(&s)), true);
    assert_eq!(
        (begin.mesh.components().1, begin.mesh.genus()),
        (1, Some(0))
    );
    begin
}

/// Figure 5.2: what is between two halves of a cylinder is that cylinder.
#[test]
fn two_tubes_become_a_cylinder() {
    const RADIUS: f64 = 0.5;
    let begin = blend(2.0);
    let off = |x: &[DVec3]| {
        largest(
            x[begin.n_old..]
                .iter()
                .map(|p| (p.truncate().length() - RADIUS).abs()),
        )
    };
    let ends = [
        FlowName::Mmcv,
        FlowName::SurfaceDiffusion,
        FlowName::Willmore,
    ]
    .map(|flow| begin.fair(flow));
    let [variation, diffusion, willmore] = ends.each_ref().map(|end| off(&end.x) / RADIUS);
    println!("off by {variation:.1e}, {diffusion:.1e}, {willmore:.1e} R");
    ends.iter().for_each(Faired::assert_good);
    assert!(variation < 3e-4 && diffusion < 1e-3);
    // A cylinder has H ≠ 0, K = 0: not at rest under Willmore flow.
    assert!(willmore > 0.1);
}

/// Figures 5.2 and 5.5: only the sixth-order flow joins tubes with continuous curvature.
#[test]
fn tubes_are_blended_with_continuous_curvature() {
    for count in [3.0, 6.0] {
        let begin = blend(count);
        let [diffusion, willmore, variation] = [1, 2, 3].map(|k| {
            let end = begin.fair(FLOWS[k]);
            end.assert_good();
            end.jump.relative
        });
        println!("{count} tubes: {diffusion:.3}, {willmore:.3}, {variation:.3}");
        assert!(
            variation <= 0.45 * diffusion,
            "{count} tubes: {variation} of {diffusion}"
        );
        assert!(variation <= 0.45 * willmore);
    }
}

/// The catenoid's limit: a membrane between tubes this far apart pinches off.
#[test]
fn a_neck_pinches_under_mean_curvature_flow_and_that_is_told() {
    let end = blend(2.0).fair(FlowName::MeanCurvature);
    assert_eq!(end.status, Status::Singular);
}

/// Without the faces within `radius` of the centres, and the numbers of those holes.
fn punch(whole: &Surface, centres: &[DVec3], radius: f64) -> (Surface, Vec<usize>) {
    let soup = whole.mesh.to_soup(&whole.x);
    let s = cut(&soup, |c, _| centres.iter().all(|p| p.distance(c) > radius));
    let all = boundary_loops(&s.mesh, &s.x);
    let is_hole = |i: &usize| {
        let rim = &all[*i].vertices;
        let mean = rim.iter().map(|&v| s.x[v as usize]).sum::<DVec3>() / rim.len() as f64;
        centres.iter().any(|c| c.distance(mean) < 0.5 * radius)
    };
    let holes: Vec<usize> = (0..all.len()).filter(is_hole).collect();
    assert_eq!(holes.len(), centres.len());
    (s, holes)
}

/// Centres of `count` round holes of that radius, apart from each other and from the
/// outline, where the surface is smoothest: where its own curvature jumps least across the
/// rim that the hole would have.
fn smooth_places(whole: &Surface, radius: f64, count: usize) -> Vec<DVec3> {
    let (mesh, x) = (&whole.mesh, &whole.x);
    let near = |c: DVec3, factor: f64| move |p: &DVec3| p.distance(c) < factor * radius;
    let outline = mesh.vertices().filter(|&v| mesh.is_boundary_vertex(v));
    let outline: Vec<DVec3> = outline.map(|v| x[v.index()]).collect();
    let mut found: Vec<(f64, DVec3)> = Vec::new();
    for &c in x.iter().step_by(x.len() / 150) {
        let free: Vec<bool> = x.iter().map(near(c, 1.0)).collect();
        if let Some(jump) = curvature_jump(mesh, x, &free) {
            found.push((jump.relative, c));
        }
    }
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    let mut centres: Vec<DVec3> = Vec::new();
    for (jump, c) in found {
        let is_apart = !centres.iter().any(near(c, 3.0)) && !outline.iter().any(near(c, 2.0));
        if centres.len() < count && is_apart {
            println!("  a hole where the surface itself jumps by {jump:.3}");
            centres.push(c);
        }
    }
    centres
}

/// Removes detail of the size of an edge by surface diffusion of the whole surface.
fn smoothed(mut s: Surface) -> Surface {
    const STEPS: usize = 3;
    let options = FlowOptions {
        flow: FlowName::SurfaceDiffusion,
        dt: Some(measure::mean_edge_length(&s.mesh, &s.x).powi(4)),
        max_steps: Some(STEPS),
        ..FlowOptions::default()
    };
    let mut flow = drive(&s.mesh, &mut s.x, options).expect("a flow");
    for _ in 0..STEPS {
        flow.step(&mut s.x).expect("a step");
    }
    s
}

/// Figure 5.3: holes of a head. Closed where cut, nothing folds, finite jumps.
fn close_holes(whole: &Surface, size: f64, flows: &[FlowName]) -> Vec<Faired> {
    let radius = size * measure::bounding_diagonal(&whole.x);
    let centres = smooth_places(whole, radius, 3);
    assert_eq!(centres.len(), 3);
    let (s, holes) = punch(whole, &centres, radius);
    let begin = start(&s, Some(holes), false);
    println!("{} new vertices", begin.x.len() - begin.n_old);
    assert!(begin.notices.is_empty(), "{:?}", begin.notices);
    assert_eq!(begin.mesh.n_boundary_loops(), whole.mesh.n_boundary_loops());
    assert_eq!(
        begin.mesh.euler_characteristic(),
        whole.mesh.euler_characteristic()
    );
    let ends = flows.iter().map(|&flow| begin.fair(flow));
    let ends: Vec<Faired> = ends.collect();
    ends.iter().for_each(Faired::assert_good);
    ends
}

#[test]
fn a_scanned_head_is_closed_as_it_is() {
    let Some(head) = real("demosthenes_low_res.obj") else {
        return;
    };
    // Its curvature is noise of the size of an edge: where it is smoothest it jumps by 0.6
    // already, and no fill can be told from another by that.
    let ends = close_holes(&head, 0.05, &FLOWS);
    assert!(
        ends[1..]
            .iter()
            .all(|end| end.jump.relative < 0.8 * ends[0].jump.relative)
    );
}

#[test]
fn holes_of_a_smooth_head_are_filled_with_continuous_curvature() {
    let heads = [
        real("demosthenes_low_res.obj"),
        Some(surface(&sample(
            "scan-clean",
            &[("resolution", 160.0), ("loops", 1.0)],
        ))),
    ];
    for head in heads.into_iter().flatten() {
        let ends = close_holes(&smoothed(head), 0.05, &FLOWS);
        let [mean, diffusion, _, variation] = [0, 1, 2, 3].map(|k| ends[k].jump.relative);
        assert!(variation < 0.9 * diffusion && variation < 0.5 * mean);
    }
    // A stone whose bumps are many edges wide.
    let stone = surface(&sample("bumpy-sphere", &[("frequency", 3.0)]));
    let ends = close_holes(&stone, 0.1, &FLOWS);
    let [mean, diffusion, _, variation] = [0, 1, 2, 3].map(|k| ends[k].jump.relative);
    assert!(variation < 0.3 * diffusion && variation < 0.02 * mean);
}

/// Holes of a face on which depth jumps: the sixth-order flow wanders from the fill, and begins
/// anew from where surface diffusion leads; the patch of least energy is kept.
#[test]
fn a_run_that_is_lost_begins_anew_with_surface_diffusion() {
    let face = sample("scan-clean", &[("resolution", 160.0), ("loops", 1.0)]);
    let whole = surface(&face);
    let radius = 0.065 * measure::bounding_diagonal(&whole.x);
    let centres = smooth_places(&whole, radius, 3);
    let (s, holes) = punch(&whole, &centres, radius);
    let begin = start(&s, Some(holes), false);
    let alone = begin.fair_after(FlowName::Mmcv, Some(0));
    assert_eq!(alone.status, Status::Stalled);
    // No rest there either, but the best patch on the way.
    let end = begin.fair(FlowName::Mmcv);
    assert_eq!((end.status, end.folded), (Status::Stalled, 0));
    assert!(end.energy <= alone.energy);
    let told = end
        .warnings
        .iter()
        .filter(|w| matches!(w, Warning::BackToStart { .. }));
    assert_eq!(told.count(), 1, "{:?}", end.warnings);
    let asked = begin.fair_after(FlowName::Mmcv, Some(40));
    assert!(asked.jump.relative < alone.jump.relative);
}

#[test]
fn holes_of_a_plane_stay_in_it() {
    // A sheet in no special position, its points pushed about in it.
    let mut soup = sample("hyperbolic-paraboloid", &[("cells", 40.0), ("height", 0.0)]);
    let normal = DVec3::new(0.2, -0.6, 0.7).normalize();
    let u = normal.any_orthonormal_vector();
    let mut random = Random(3);
    for p in &mut soup.positions {
        let (a, b) = (p.x + 0.01 * random.next(), p.y + 0.01 * random.next());
        *p = 3.0 * normal + a * u + b * normal.cross(u);
    }
    let at = |a: f64, b: f64| 3.0 * normal + a * u + b * normal.cross(u);
    let centres = [at(-0.5, -0.4), at(0.5, -0.5), at(0.1, 0.45)];
    let (s, holes) = punch(&surface(&soup), &centres, 0.28);
    let begin = start(&s, Some(holes), false);
    assert!(begin.notices.is_empty(), "{:?}", begin.notices);
    assert_eq!(begin.mesh.n_boundary_loops(), 1);
    let off = |x: &[DVec3]| largest(x.iter().map(|p| (p.dot(normal) - 3.0).abs()));
    assert!(off(&begin.x) < 1e-12);
    for flow in FLOWS {
        let end = begin.fair(flow);
        assert_eq!((end.status, end.folded), (Status::Converged, 0));
        assert!(off(&end.x) < 1e-10, "{flow:?}: {:.1e}", off(&end.x));
    }
}

/// A toy aeroplane with the holes of its windows: less than six edges across each.
#[test]
fn all_holes_of_an_aeroplane_are_closed() {
    let Some(s) = real("plane_holes.obj") else {
        return;
    };
    let begin = start(&s, None, false);
    assert!(begin.mesh.is_closed());
    for flow in FLOWS {
        begin.fair(flow).assert_good();
    }
}
