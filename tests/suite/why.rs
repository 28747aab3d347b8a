//! Why did this happen: each kind is brought about, its element is really there, and the first
//! remedy helps.

use glam::DVec3;
use umbilic::app::{
    Diagnosis, FlipOptions, Loaded, RegulariseOptions, Remedy, RemedyId, Session, SubdivideOptions,
    SubdivisionScheme,
};
use umbilic::flow::Status;
use umbilic::flow::constraint::Kept;
use umbilic::flow::options::{FlowOptions, Integrator, Remeshing, Scheme};
use umbilic::flow::spec::FlowName;
use umbilic::remesh::Mode;

struct Case {
    session: Session,
    options: FlowOptions,
}

fn number(found: &Diagnosis, name: &str) -> f64 {
    found.message.number(name).expect("a number")
}

impl Case {
    fn new(name: &str, values: &[(&str, f64)], options: FlowOptions) -> Self {
        let mut session = Session::new();
        let values: Vec<(String, f64)> =
            values.iter().map(|(n, v)| ((*n).to_owned(), *v)).collect();
        session.sample(name, &values).expect("a sample");
        session.configure(options.clone()).expect("options");
        Self { session, options }
    }

    fn run(&mut self, steps: usize) -> &mut Self {
        // A step that fails is a reason to ask why, and not one to give up.
        let _ = self.session.run(steps);
        self
    }

    fn why(&self) -> Option<Diagnosis> {
        self.session.why().expect("a mesh")
    }

    fn diagnosis(&self, kind: &str) -> Diagnosis {
        let state = self.session.state().expect("a mesh");
        let found = self
            .why()
            .unwrap_or_else(|| panic!("nothing said of {state:?}"));
        assert_eq!(found.kind, kind, "{} {state:?}", found.message);
        assert!(!found.remedies.is_empty() && found.remedies.len() <= 3);
        found
    }

    fn state(&self) -> umbilic::app::State {
        self.session.state().expect("a mesh")
    }

    fn energy(&self) -> f64 {
        self.state().energy
    }

    fn mesh(&self) -> Mesh {
        Mesh::of(&self.session.loaded().expect("a mesh"))
    }

    /// What the page does for a button.
    fn carry_out(&mut self, remedy: &Remedy) {
        let session = &mut self.session;
        match remedy.id {
            RemedyId::Back => {
                for _ in 0..remedy.steps {
                    session.back().expect("back");
                }
                return;
            }
            RemedyId::Continue | RemedyId::Refine => return,
            _ => {}
        }
        if remedy.from_start {
            session.reset().expect("a mesh");
        }
        self.options = remedy.change.applied(&self.options);
        if remedy.change != umbilic::app::Change::default() {
            if !remedy.from_start {
                session.adopt().expect("a mesh");
            }
            session.configure(self.options.clone()).expect("options");
        }
        match remedy.id {
            RemedyId::Regularise => {
                session
                    .regularise(&RegulariseOptions::default())
                    .expect("a closed surface");
            }
            RemedyId::Subdivide => {
                session
                    .subdivide(SubdivideOptions {
                        scheme: SubdivisionScheme::Loop,
                    })
                    .expect("triangles");
                session.configure(self.options.clone()).expect("options");
            }
            RemedyId::KeepAndFlips => {
                session.adopt().expect("a mesh");
                session.flip(&FlipOptions::default()).expect("triangles");
                session.configure(self.options.clone()).expect("options");
            }
            _ => {}
        }
    }
}

struct Mesh {
    x: Vec<DVec3>,
    faces: Vec<[usize; 3]>,
}

impl Mesh {
    fn of(loaded: &Loaded) -> Self {
        let point = |c: &[f32]| DVec3::new(c[0].into(), c[1].into(), c[2].into());
        Self {
            x: loaded.positions.chunks_exact(3).map(point).collect(),
            faces: loaded
                .triangles
                .chunks_exact(3)
                .map(|f| [f[0] as usize, f[1] as usize, f[2] as usize])
                .collect(),
        }
    }

    fn corners(&self, face: u32) -> [DVec3; 3] {
        self.faces[face as usize].map(|v| self.x[v])
    }

    fn normal(&self, face: u32) -> DVec3 {
        let [a, b, c] = self.corners(face);
        (b - a).cross(c - a)
    }

    fn smallest_angle(&self, face: u32) -> f64 {
        let [a, b, c] = self.corners(face);
        let angle = |p: DVec3, q: DVec3, r: DVec3| (q - p).angle_between(r - p).to_degrees();
        angle(a, b, c).min(angle(b, c, a)).min(angle(c, a, b))
    }
}

/// Without passes of remeshing, which leave little to be asked about.
fn p_willmore() -> FlowOptions {
    FlowOptions {
        flow: FlowName::PWillmore,
        remesh: Remeshing::Off,
        ..FlowOptions::default()
    }
}

fn plain() -> FlowOptions {
    FlowOptions::default()
}

fn first(found: &Diagnosis, id: RemedyId) -> Remedy {
    let remedy = found.remedies.first().expect("a remedy").clone();
    assert_eq!(remedy.id, id, "{:?}", found.remedies);
    remedy
}

#[test]
fn nothing_is_said_where_nothing_is_wrong() {
    let mut case = Case::new("icosahedron", &[("level", 2.0)], plain());
    assert_eq!(case.why(), None, "a start has no reasons");
    case.run(3);
    assert_eq!(case.why(), None, "nor have steps that descend at once");
    case.run(200);
    assert_eq!(case.state().status, Status::Converged);
    assert_eq!(case.why(), None, "nor has a run that converged");
    let mut blob = Case::new("bumpy-sphere", &[("level", 2.0)], p_willmore());
    blob.run(200);
    assert_eq!((blob.state().status, blob.why()), (Status::Converged, None));
    assert!(Session::new().why().is_err(), "there is no mesh");
}

#[test]
fn refused_trials_of_a_step_that_descends_are_told_calmly() {
    let mut case = Case::new("eared-head", &[("level", 3.0)], plain());
    let rejected = |case: &Case| {
        let reports = case.session.reports().expect("a mesh");
        reports.last().map_or(0, |last| last.rejected)
    };
    while rejected(&case) == 0 {
        assert_eq!(case.why(), None);
        case.run(1);
        assert_eq!(case.state().status, Status::Ready);
    }
    let found = case.diagnosis("RejectedSteps");
    assert_eq!(number(&found, "step"), case.state().step as f64);
    assert_eq!(found.vertices.len(), 1);
    let before = case.energy();
    case.carry_out(&first(&found, RemedyId::Continue));
    case.run(5);
    assert!(case.energy() < before);
}

#[test]
fn a_budget_that_is_used_up_is_no_fault() {
    let options = FlowOptions {
        max_steps: Some(6),
        ..plain()
    };
    let mut case = Case::new("coarse-torus", &[], options);
    case.run(100);
    let (before, after) = {
        let after = case.mesh();
        let mut back = Case::new("coarse-torus", &[], case.options.clone());
        back.run(5);
        (back.mesh(), after)
    };
    let found = case.diagnosis("StepLimit");
    // The vertex it names is the one that the last step moved most.
    let moved = |v: u32| before.x[v as usize].distance(after.x[v as usize]);
    let most = (0..after.x.len() as u32).map(moved).fold(0.0, f64::max);
    assert!(moved(found.vertices[0]) > (1.0 - 1e-5) * most);
    let energy = case.energy();
    case.carry_out(&first(&found, RemedyId::Continue));
    case.run(6);
    assert!(case.energy() < energy && case.state().step == 12);
}

#[test]
fn a_step_size_that_was_set_can_be_left_to_the_flow() {
    let options = FlowOptions {
        flow: FlowName::SurfaceDiffusion,
        tau: Some(1e-9),
        max_steps: Some(5),
        ..plain()
    };
    let mut case = Case::new("ellipsoid", &[("level", 2.0)], options);
    case.run(10);
    let found = case.diagnosis("StepLimit");
    let automatic = found.remedies[1].clone();
    assert_eq!(automatic.id, RemedyId::AutomaticStep);
    let area = case.state().area;
    case.carry_out(&automatic);
    case.run(5);
    assert!(case.state().area < 0.99 * area);
}

#[test]
fn edges_of_four_points_on_a_circle_stop_the_exact_energy() {
    let options = FlowOptions {
        epsilon: 0.0,
        ..plain()
    };
    let (around, tube) = (36.0, 18.0);
    let mut case = Case::new("torus", &[("around", around), ("tube", tube)], options);
    case.run(5);
    assert_eq!(case.state().status, Status::Stalled);
    let found = case.diagnosis("CocircularKink");
    // All diagonals of the planar trapezia between two circles of latitude.
    assert_eq!(found.edges.len(), 2 * (around * tube) as usize);
    let mesh = case.mesh();
    for ends in found.edges.chunks_exact(2) {
        let ends = [ends[0] as usize, ends[1] as usize];
        let beside: Vec<usize> = mesh
            .faces
            .iter()
            .filter(|face| ends.iter().all(|v| face.contains(v)))
            .flat_map(|face| face.iter().copied().filter(|v| !ends.contains(v)))
            .collect();
        let [i, j, k, l] = [ends[0], ends[1], beside[0], beside[1]].map(|v| mesh.x[v]);
        // Ptolemy's theorem: of four points on a circle the products of opposite sides of the
        // quadrilateral add to that of its diagonals.
        let sides = i.distance(k) * j.distance(l) + k.distance(j) * l.distance(i);
        let diagonals = i.distance(j) * k.distance(l);
        assert!(
            (sides / diagonals - 1.0).abs() < 1e-6,
            "{}",
            sides / diagonals
        );
    }
    let wanted = RemedyId::LargerEpsilon;
    assert!(found.remedies.iter().any(|remedy| remedy.id == wanted));
    // ∫H² of this torus is π²/(r √(1 − r²)) with r = 0.35; the Clifford torus has 2π².
    let boundary = umbilic::energy::circle::Boundary::Clamped;
    let bending = |case: &Case| case.session.energy(boundary, &[]).expect("a mesh").willmore;
    let squared = std::f64::consts::PI.powi(2);
    assert!(
        (bending(&case) / (squared / (0.35 * (1.0f64 - 0.35 * 0.35).sqrt())) - 1.0).abs() < 0.02
    );
    case.carry_out(&first(&found, RemedyId::OtherFlow));
    case.run(60);
    let after = bending(&case) / (2.0 * squared);
    assert!((after - 1.0).abs() < 0.03, "{after}");
}

#[test]
fn steps_too_long_for_the_papers_scheme_raise_the_energy() {
    for (integrator, steps) in [(Integrator::SemiImplicit, 8), (Integrator::ForwardEuler, 4)] {
        let options = FlowOptions {
            scheme: Scheme::Paper,
            integrator,
            tau: Some(1.0),
            ..plain()
        };
        let mut case = Case::new("coarse-torus", &[], options);
        let start = case.energy();
        case.run(steps);
        assert!(case.energy() > start);
        let found = case.diagnosis("RisingEnergy");
        assert_eq!(found.vertices.len(), 1);
        let other = found.remedies[1].clone();
        assert_eq!(other.id, RemedyId::SmallerStep);
        let tau = other.change.tau.flatten().expect("a step size");
        assert!(tau > 0.0 && tau < 1.0);
        case.carry_out(&first(&found, RemedyId::RecommendedScheme));
        let mut last = case.energy();
        assert!((last - start).abs() < 1e-9 * start, "it begins anew");
        for _ in 0..3 {
            case.run(3);
            assert!(case.energy() < last);
            last = case.energy();
        }
    }
}

#[test]
fn a_neck_pinches_off_where_it_is_thinnest() {
    let options = FlowOptions {
        p: 0.0,
        ..p_willmore()
    };
    let mut case = Case::new("dumbbell", &[("level", 3.0)], options);
    case.run(200);
    assert_eq!(case.state().status, Status::Singular);
    let found = case.diagnosis("Pinch");
    // The waist of the dumbbell is about its middle, and so is what is named.
    let mesh = case.mesh();
    let size = mesh.x.iter().map(|p| p.length()).fold(0.0, f64::max);
    let start = Case::new("dumbbell", &[("level", 3.0)], plain()).mesh();
    let axis = start
        .x
        .iter()
        .map(|p| p.abs())
        .fold(DVec3::ZERO, DVec3::max);
    let along = if axis.x > axis.y.max(axis.z) {
        DVec3::X
    } else if axis.y > axis.z {
        DVec3::Y
    } else {
        DVec3::Z
    };
    for &v in found.vertices.iter() {
        let at = mesh.x[v as usize];
        assert!(
            at.dot(along).abs() < 0.9 * size && at.reject_from(along).length() < 0.1,
            "{at}"
        );
    }
    let width = number(&found, "width");
    assert!(width < 0.1);
    let back = found
        .remedies
        .iter()
        .find(|remedy| remedy.id == RemedyId::Back);
    let back = back.expect("a way back").clone();
    let step = case.state().step;
    case.carry_out(&back);
    assert_eq!(case.state().step, step - back.steps);
    case.carry_out(&first(&found, RemedyId::KeepVolume));
    case.run(200);
    assert_eq!((case.state().status, case.why()), (Status::Converged, None));
    assert!(case.state().min_angle_degrees > 20.0);
}

#[test]
fn a_tube_between_fixed_ends_pinches_off_too() {
    let options = FlowOptions {
        flow: FlowName::MeanCurvature,
        ..plain()
    };
    let sides = [("length", 3.0), ("around", 32.0), ("along", 24.0)];
    let mut case = Case::new("cylinder", &sides, options);
    case.run(100);
    assert_eq!(case.state().status, Status::Singular);
    let found = case.diagnosis("Pinch");
    let mesh = case.mesh();
    assert!(
        found
            .vertices
            .iter()
            .all(|&v| mesh.x[v as usize].z.abs() < 1.4)
    );
    let named = mesh.x[found.vertices[0] as usize];
    assert!(named.truncate().length() < 0.2, "{named}");
    case.carry_out(&first(&found, RemedyId::OtherFlow));
    case.run(30);
    assert!(case.state().status != Status::Failed && case.state().min_angle_degrees > 20.0);
}

#[test]
fn free_surfaces_shrink_or_grow_with_the_exponent() {
    for (p, kind) in [(0.0, "Shrinking"), (3.0, "Growing")] {
        let options = FlowOptions {
            p,
            max_steps: Some(40),
            ..p_willmore()
        };
        let mut case = Case::new("bumpy-sphere", &[("level", 2.0)], options);
        case.run(20);
        let found = case.diagnosis(kind);
        case.carry_out(&first(&found, RemedyId::KeepVolume));
        let before = case.energy();
        case.run(40);
        assert_eq!(case.why(), None, "p = {p}");
        assert!(case.energy() < before);
    }
    let options = FlowOptions {
        flow: FlowName::MeanCurvature,
        ..plain()
    };
    let mut case = Case::new("ellipsoid", &[("level", 2.0)], options);
    case.run(8);
    let found = case.diagnosis("Shrinking");
    case.carry_out(&first(&found, RemedyId::OtherFlow));
    let volume = case.state().volume.expect("closed");
    case.run(40);
    let kept = case.state().volume.expect("closed") / volume;
    assert!((kept - 1.0).abs() < 0.2, "{kept}");
}

#[test]
fn faces_that_are_folded_over_are_counted_and_mended() {
    let mut case = Case::new(
        "ellipsoid",
        &[("level", 3.0), ("jitter", 0.35)],
        p_willmore(),
    );
    case.run(30);
    let found = case.diagnosis("FoldedFaces");
    assert_eq!(number(&found, "count"), found.faces.len() as f64);
    let mesh = case.mesh();
    for &face in found.faces.iter() {
        let own = mesh.faces[face as usize];
        let shares = |other: &[usize; 3]| other.iter().filter(|v| own.contains(v)).count() == 2;
        let neighbours = (0..mesh.faces.len() as u32)
            .filter(|&other| shares(&mesh.faces[other as usize]))
            .map(|other| mesh.normal(other).normalize_or_zero());
        assert!(neighbours.sum::<DVec3>().dot(mesh.normal(face)) < 0.0);
    }
    let (energy, angle) = (case.energy(), case.state().min_angle_degrees);
    case.carry_out(&first(&found, RemedyId::Regularise));
    assert!(case.state().min_angle_degrees > 10.0 && angle < 1.0);
    case.run(60);
    assert!(case.energy() < 0.2 * energy);
    assert_eq!(case.why(), None);
}

#[test]
fn a_mesh_that_degenerates_is_told_by_its_smallest_angle() {
    let options = FlowOptions {
        regularise: Mode::Off,
        keep: vec![Kept::Area, Kept::Volume],
        ..p_willmore()
    };
    let knot = [("p", 3.0), ("q", 4.0), ("along", 120.0), ("around", 8.0)];
    let mut case = Case::new("torus-knot", &knot, options);
    case.run(500);
    assert_eq!(case.state().status, Status::Stalled);
    let found = case.diagnosis("DegenerateFaces");
    let [face] = found.faces[..] else {
        panic!("{:?}", found.faces)
    };
    let worst = case.mesh().smallest_angle(face);
    assert!((worst - case.state().min_angle_degrees).abs() < 1e-3 && worst < 8.0);
    let stuck = case.energy();
    case.carry_out(&first(&found, RemedyId::RegulariseEachStep));
    case.run(45);
    assert!(case.energy() < stuck && case.state().min_angle_degrees > 5.0);
}

#[test]
fn a_surface_does_not_swell_although_size_costs_nothing() {
    let mut case = Case::new("trefoil", &[("along", 60.0), ("around", 6.0)], p_willmore());
    let area = case.state().area;
    case.run(200);
    assert_eq!(case.state().status, Status::Stalled);
    assert!(case.state().area < 4.0 * area);
    let found = case.diagnosis("DegenerateFaces");
    let angle = case.state().min_angle_degrees;
    assert!((case.mesh().smallest_angle(found.faces[0]) - angle).abs() < 1e-2);
    // Passes of remeshing do not make it swell either, and the mesh stays good.
    let options = FlowOptions {
        remesh: Remeshing::Adaptive,
        ..p_willmore()
    };
    let mut case = Case::new("trefoil", &[("along", 60.0), ("around", 6.0)], options);
    case.run(200);
    let state = case.state();
    assert!(state.area < 4.0 * area, "{} of {area}", state.area);
    assert!(
        state.min_angle_degrees > 15.0,
        "{}",
        state.min_angle_degrees
    );
}

#[test]
fn energies_below_the_smooth_minimum_are_those_of_coarse_meshes() {
    let sphere = 4.0 * std::f64::consts::PI;
    // The paper's scheme lowers the lumped energy, which is the one that falls so low.
    let options = FlowOptions {
        scheme: Scheme::Paper,
        ..p_willmore()
    };
    let mut case = Case::new("icosahedron", &[("level", 1.0)], options);
    case.run(200);
    assert_eq!(case.state().status, Status::Converged);
    assert!(case.energy() < 0.95 * sphere);
    let found = case.diagnosis("BelowSmoothMinimum");
    assert_eq!(number(&found, "smooth"), sphere);
    assert!(
        found
            .remedies
            .iter()
            .any(|remedy| remedy.id == RemedyId::Refine)
    );
    let vertices = case.mesh().x.len();
    case.carry_out(&first(&found, RemedyId::Subdivide));
    assert_eq!(case.mesh().x.len(), 4 * vertices - 6);
    case.run(200);
    assert!(case.energy() > 0.97 * sphere);
    assert_eq!((case.state().status, case.why()), (Status::Converged, None));
    case.session.undo_edit().expect("an edit");
    assert_eq!(case.mesh().x.len(), vertices);
}

#[test]
fn a_rough_start_is_too_much_for_the_sixth_order_only() {
    // With p = 16 the sharpest points outweigh all others: the flow rounds them all the same.
    let options = FlowOptions {
        p: 16.0,
        ..p_willmore()
    };
    let mut case = Case::new("bumpy-sphere", &[("level", 3.0)], options);
    let before = case.energy();
    case.run(60);
    assert_eq!(case.state().status, Status::Ready);
    assert!(case.energy() < 1e-3 * before);

    let options = FlowOptions {
        flow: FlowName::Mmcv,
        rungs: Some(0),
        ..plain()
    };
    let mut case = Case::new("ellipsoid", &[("level", 3.0), ("jitter", 0.25)], options);
    case.run(30);
    assert_eq!(case.state().status, Status::Stalled);
    let found = case.diagnosis("FoldedFaces");
    first(&found, RemedyId::Regularise);
}

#[test]
fn a_surface_that_no_quadratic_fits_is_told_by_its_vertex() {
    let options = FlowOptions {
        flow: FlowName::Mmcv,
        ..plain()
    };
    let mut case = Case::new("tetrahedron", &[("level", 0.0)], options);
    let fault = case
        .session
        .step()
        .expect_err("three neighbours are too few");
    let found = case.diagnosis("Unfit");
    assert_eq!(fault.detail["vertices"], [f64::from(found.vertices[0])]);
    case.carry_out(&first(&found, RemedyId::OtherFlow));
    case.run(30);
    assert!(case.state().status != Status::Failed && case.state().min_angle_degrees > 20.0);
    assert_eq!(case.why(), None);
}

#[test]
fn steps_that_are_all_refused_are_told_by_the_last() {
    // The exact energy has cones, and here it comes to a halt on their tips.
    let options = FlowOptions {
        epsilon: 0.0,
        integrator: Integrator::Lbfgs,
        ..plain()
    };
    let mut case = Case::new("coarse-torus", &[], options);
    case.run(4000);
    assert_eq!(case.state().status, Status::Stalled);
    let found = case.diagnosis("RefusedSteps");
    assert_eq!(found.vertices.len() + found.faces.len(), 1);
}

/// The step is longer than the scheme of the paper bears; it goes on with it, until it is plain that
/// the energy does not fall.
#[test]
fn a_step_that_is_too_long_for_the_papers_scheme_is_halved_and_ends_by_a_rise() {
    let options = FlowOptions {
        scheme: Scheme::Paper,
        tau: Some(5.0),
        ..plain()
    };
    let mut case = Case::new("coarse-torus", &[], options);
    case.run(1);
    let found = case.diagnosis("HalvedStep");
    assert!(number(&found, "count") >= 1.0);
    assert_eq!(found.remedies[0].id, RemedyId::Continue);
    case.run(400);
    let state = case.state();
    assert_eq!(state.status, Status::Stalled);
    let reason = state.message.expect("a reason");
    assert_eq!(&*reason.id, "reason-rises");
    assert!(reason.number("times") > Some(2.0));
    case.carry_out(&first(
        &case.diagnosis("RisingEnergy"),
        RemedyId::RecommendedScheme,
    ));
}

#[test]
fn a_mesh_that_cannot_be_believed_is_said_to_be_the_matter() {
    let knot = [("p", 3.0), ("q", 4.0), ("along", 240.0), ("around", 16.0)];
    let options = FlowOptions {
        keep: vec![Kept::Area, Kept::Volume],
        ..p_willmore()
    };
    let mut case = Case::new("torus-knot", &knot, options);
    case.run(40);
    let readings = case.state().soundness.expect("a closed mesh");
    assert!(!readings.is_sound);
    let found = case.diagnosis("Untrusted");
    assert_eq!(number(&found, "bend"), readings.bend);
    assert_eq!(found.vertices.len(), 1);
}
