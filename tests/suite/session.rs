//! The application without a browser.

use std::cell::RefCell;
use std::ops::ControlFlow;
use std::rc::Rc;
use umbilic::app::Session;
use umbilic::energy::circle::Boundary;
use umbilic::flow::options::{FlowOptions, Goal, Integrator, Scheme};
use umbilic::flow::spec::FlowName;
use umbilic::flow::{Reason, Status, Warning};
use umbilic::io::{self, Format};
use umbilic::message::{Say, Value};

fn with(name: &str, values: &[(&str, f64)]) -> Session {
    let mut session = Session::new();
    let values: Vec<(String, f64)> = values.iter().map(|(n, v)| ((*n).to_owned(), *v)).collect();
    session.sample(name, &values).expect("a sample");
    session
}

fn small() -> Session {
    with("icosahedron", &[("level", 2.0)])
}

#[test]
fn a_run_converges_and_says_so() {
    let mut session = small();
    session.configure(FlowOptions::default()).expect("options");
    let taken = session.run(100).expect("a run");
    let state = session.state().expect("state");
    assert_eq!(state.status, Status::Converged);
    assert_eq!(
        (state.step, session.reports().expect("reports").len()),
        (taken, taken)
    );
    assert!(state.message.is_some());
    assert!(state.energy < 1e-7 && state.energy_normalised == 0.5 * state.energy);
    let csv = session.history_csv().expect("CSV");
    assert_eq!(csv.lines().count(), taken + 1);
    let columns = csv.lines().next().expect("a header").split(',').count();
    assert!(csv.lines().all(|line| line.split(',').count() == columns));
}

#[test]
fn back_undoes_a_step_exactly() {
    let mut session = small();
    session.run(3).expect("steps");
    let (positions, state) = (
        session.positions().expect("x"),
        session.state().expect("state"),
    );
    session.run(2).expect("steps");
    let ahead = session.positions().expect("x");
    session.back().expect("back");
    let back = session.back().expect("back");
    assert_eq!((session.positions().expect("x"), back), (positions, state));
    assert_eq!(session.reports().expect("reports").len(), 3);
    // And forward again to the same place.
    session.run(2).expect("steps");
    assert_eq!(session.positions().expect("x"), ahead);
    for _ in 0..9 {
        session.back().expect("back");
    }
    let start = session.state().expect("state");
    assert!(start.step == 0 && !start.can_step_back);
}

#[test]
fn reset_returns_to_the_start() {
    let mut session = small();
    let start = session.positions().expect("x");
    session.run(4).expect("steps");
    assert_ne!(session.positions().expect("x"), start);
    let state = session.reset().expect("reset");
    assert_eq!((session.positions().expect("x"), state.step), (start, 0));
    assert!((state.energy - 12.0 * std::f64::consts::PI).abs() < 1e-9);
}

#[test]
fn a_refused_file_changes_nothing() {
    let mut session = small();
    session.run(2).expect("steps");
    let before = (
        session.positions().expect("x"),
        session.state().expect("state"),
    );
    for (bytes, kind) in [
        (&b"v 0 0 0\nv 1 0 0\nf 1 2 9\n"[..], "IndexOutOfRange"),
        (b"", "Empty"),
        (
            b"v 0 0 0\nv 1 0 0\nv 0 1 0\nv 0 0 1\nv 1 1 1\nf 1 2 3\nf 2 1 4\nf 1 2 5\n",
            "NonManifoldEdge",
        ),
    ] {
        let fault = session.load(bytes, "broken.obj").expect_err("refused");
        assert_eq!(fault.kind, kind);
    }
    let fault = session.sample("no-such-shape", &[]).expect_err("refused");
    assert_eq!(fault.kind, "UnknownShape");
    let options = FlowOptions {
        tau: Some(-1.0),
        ..FlowOptions::default()
    };
    assert_eq!(
        session.configure(options).expect_err("refused").kind,
        "BadOption"
    );
    let everything = FlowOptions {
        free: Some(vec![]),
        ..FlowOptions::default()
    };
    assert_eq!(
        session.configure(everything).expect_err("refused").kind,
        "NothingFree"
    );
    assert_eq!(
        (
            session.positions().expect("x"),
            session.state().expect("state")
        ),
        before
    );
    session.step().expect("still steps");
}

#[test]
fn exports_keep_the_faces_of_the_file() {
    let quads = b"OFF\n8 6 12\n0 0 0\n1 0 0\n0 1 0\n1 1 0\n0 0 1\n1 0 1\n0 1 1\n1 1 1\n\
        4 0 2 3 1\n4 4 5 7 6\n4 0 1 5 4\n4 2 6 7 3\n4 0 4 6 2\n4 1 3 7 5\n";
    let mut session = Session::new();
    let loaded = session.load(quads, "folder/my.cube.off").expect("a cube");
    assert_eq!(
        (loaded.name.as_str(), loaded.triangles_only),
        ("my.cube", false)
    );
    assert_eq!((loaded.triangles.len(), loaded.wire_edges.len()), (36, 24));
    assert_eq!(loaded.info.warnings.len(), 1);
    let start = io::read(quads, "").expect("readable").soup;
    for format in [Format::Obj, Format::Off, Format::Ply, Format::PlyAscii] {
        let bytes = session.export(format).expect("a file");
        assert_eq!(
            io::read(&bytes, "").expect("readable").soup,
            start,
            "{format:?}"
        );
    }
    assert_eq!(&session.export(Format::Glb).expect("a file")[..4], b"glTF");
}

#[test]
fn meshes_far_from_the_origin_lose_nothing() {
    let mut near = small();
    near.run(3).expect("steps");
    let text = String::from_utf8(near.export(Format::Obj).expect("OBJ")).expect("text");
    let offset = 4e6;
    let shifted: String = text
        .lines()
        .map(|line| match line.strip_prefix("v ") {
            Some(rest) => {
                let c: Vec<f64> = rest
                    .split(' ')
                    .map(|c| c.parse().expect("number"))
                    .collect();
                format!("v {} {} {}\n", c[0] + offset, c[1], c[2])
            }
            None => format!("{line}\n"),
        })
        .collect();
    let mut far = Session::new();
    far.load(shifted.as_bytes(), "far.obj").expect("a mesh");
    let biggest = far.positions().expect("x").into_iter().fold(0.0, f32::max);
    assert!(biggest < 10.0, "drawn near the origin, not at {biggest}");
    far.run(3).expect("steps");
    let soup = io::read(&far.export(Format::Obj).expect("OBJ"), "")
        .expect("readable")
        .soup;
    assert!(soup.positions.iter().all(|p| (p.x - offset).abs() < 10.0));
}

/// In the coordinates of the file.
#[test]
fn the_place_of_a_singularity_is_that_of_the_file() {
    for shift in [[0.0; 3], [1e5, -2e5, 0.0]] {
        let session = small();
        let mut soup = io::read(&session.export(Format::Ply).expect("a file"), "")
            .expect("a mesh")
            .soup;
        for p in &mut soup.positions {
            *p += glam::DVec3::from(shift);
        }
        let bytes = io::write(&soup, Format::Ply, "").expect("a file");
        let mut session = Session::new();
        session.load(&bytes, "far.ply").expect("a surface");
        let options = FlowOptions {
            flow: FlowName::MeanCurvature,
            ..FlowOptions::default()
        };
        session.configure(options).expect("a flow");
        session.run(300).expect("steps");
        let message = session.state().expect("a mesh").message.expect("an end");
        assert_eq!(&*message.id, "reason-vanishes");
        let Some(Value::List(place)) = message.value("place") else {
            panic!("{message:?}")
        };
        for (told, right) in place.iter().zip(shift) {
            let Value::Number(told) = told else {
                panic!("{told:?}")
            };
            assert!((told - right).abs() < 1e-4, "{told} {right}");
        }
    }
}

#[test]
fn the_samples_selection_is_held_unless_told_otherwise() {
    let mut session = with("six-sided-hole", &[]);
    let configured = session.configure(FlowOptions::default()).expect("options");
    let held = session
        .held_vertices()
        .expect("held")
        .iter()
        .filter(|&&h| h == 1)
        .count();
    assert_eq!(
        configured.free_vertices + held,
        session.positions().expect("x").len() / 3
    );
    let start = session.positions().expect("x");
    session.run(3).expect("steps");
    let end = session.positions().expect("x");
    let held = session.held_vertices().expect("held");
    for (v, _) in held.iter().enumerate().filter(|(_, h)| **h == 1) {
        assert_eq!(
            start[3 * v..3 * v + 3],
            end[3 * v..3 * v + 3],
            "vertex {v} moved"
        );
    }
    let options = FlowOptions {
        fixed: Some(vec![0]),
        boundary: Some(Boundary::Free),
        ..FlowOptions::default()
    };
    let configured = session.configure(options).expect("options");
    assert_eq!(configured.free_vertices, start.len() / 3 - 1);
}

#[test]
fn the_budget_ends_a_run_and_asking_again_renews_it() {
    let mut session = with("coarse-torus", &[]);
    let options = FlowOptions {
        max_steps: Some(5),
        ..FlowOptions::default()
    };
    session.configure(options).expect("options");
    assert_eq!(session.run(50).expect("a run"), 5);
    assert_eq!(session.state().expect("state").status, Status::StepLimit);
    assert_eq!(session.run(50).expect("a run"), 5);
    assert_eq!(session.state().expect("state").step, 10);
}

#[test]
fn a_budget_of_time_holds_only_where_no_number_of_steps_is_set() {
    let mut session = with("coarse-torus", &[]);
    let shortest = FlowOptions {
        max_seconds: Some(f64::MIN_POSITIVE),
        ..FlowOptions::default()
    };
    session.configure(shortest.clone()).expect("options");
    assert_eq!(session.run(50).expect("a run"), 1);
    let state = session.state().expect("state");
    assert_eq!(state.status, Status::StepLimit);
    let seconds = f64::MIN_POSITIVE;
    assert_eq!(state.message, Some(Reason::TimeLimit { seconds }.into()));

    let options = FlowOptions {
        max_steps: Some(5),
        ..shortest.clone()
    };
    session.configure(options).expect("options");
    assert_eq!(session.run(50).expect("a run"), 5);

    let smoothing = FlowOptions {
        goal: Goal::Smooth,
        smooth_steps: 3,
        ..shortest
    };
    session.configure(smoothing).expect("options");
    assert_eq!(session.run(50).expect("a run"), 3);
    let message = session.state().expect("state").message;
    assert_eq!(message, Some(Reason::Smoothed { steps: 3 }.into()));
}

#[test]
fn a_restored_session_goes_on_from_there() {
    let mut session = small();
    session.run(3).expect("steps");
    let frame = session.frame().expect("a frame");
    let (positions, state) = (frame.exact, frame.state);
    let mut other = small();
    let restored = other
        .restore(&positions, None, state.step, state.time)
        .expect("restored");
    assert_eq!((restored.step, restored.time), (3, state.time));
    assert_eq!(restored.energy, state.energy, "to the last bit");
    other.step().expect("a step");
    assert_eq!(other.state().expect("state").step, 4);
    assert_eq!(
        other
            .restore(&positions[1..], None, 0, 0.0)
            .expect_err("short")
            .kind,
        "BadPositions"
    );
}

#[test]
fn a_session_that_is_restored_at_its_limit_of_steps_goes_on_when_asked_to() {
    let limited = || {
        let mut session = small();
        session
            .configure(FlowOptions {
                max_steps: Some(3),
                ..FlowOptions::default()
            })
            .expect("options");
        session
    };
    let mut session = limited();
    session.run(3).expect("steps");
    let frame = session.frame().expect("a frame");
    let state = frame.state;
    assert_eq!(state.status, Status::StepLimit);
    let mut other = limited();
    let restored = other
        .restore(&frame.exact, None, state.step, state.time)
        .expect("restored");
    assert_eq!(
        (restored.status, restored.message),
        (state.status, state.message)
    );
    let report = other.step().expect("a step").expect("a report");
    assert_eq!(report.step, 4);
}

#[test]
fn fields_have_a_value_a_vertex_and_a_range() {
    let mut session = with("torus", &[]);
    session.run(1).expect("a step");
    let n = session.positions().expect("x").len() / 3;
    for name in [
        "mean-curvature",
        "gauss-curvature",
        "willmore",
        "gradient",
        "displacement",
    ] {
        let field = session.field(name).expect("known").expect("a field");
        assert_eq!(field.values.len(), n, "{name}");
        assert!(
            field.low < field.high && field.values.iter().all(|v| v.is_finite()),
            "{name}"
        );
        assert!(!field.signed || field.low == -field.high, "{name}");
    }
    assert_eq!(session.field("none").expect("known"), None);
    assert_eq!(
        session.field("colour").expect_err("unknown").kind,
        "UnknownField"
    );
}

#[test]
fn progress_is_told_within_a_step() {
    let mut session = small();
    let stages = Rc::new(RefCell::new(Vec::new()));
    let told = Rc::clone(&stages);
    session.set_progress(Some(Rc::new(move |stage: &str, share: f64| {
        assert!((0.0..=1.0).contains(&share));
        told.borrow_mut().push(stage.to_owned());
        ControlFlow::Continue(())
    })));
    session.step().expect("a step");
    assert!(stages.borrow().iter().any(|s| s == "factor"), "{stages:?}");
}

/// Nothing is counted twice: the parts are no more than the whole.
#[test]
fn the_parts_of_a_step_are_told_apart() {
    let flowing = |flow| FlowOptions {
        flow,
        ..FlowOptions::default()
    };
    let finishing = FlowOptions {
        integrator: Integrator::Lbfgs,
        ..flowing(FlowName::Circle)
    };
    let laws = [FlowName::Circle, FlowName::PWillmore, FlowName::Willmore];
    for options in laws.map(flowing).into_iter().chain([finishing]) {
        let mut session = Session::new();
        let level = [("level".to_owned(), 4.0)];
        session.sample("bumpy-sphere", &level).expect("a shape");
        session.configure(options.clone()).expect("a flow");
        for _ in 0..3 {
            let report = session.step().expect("a step").expect("a report");
            let parts = [
                report.assemble_milliseconds,
                report.factor_milliseconds,
                report.solve_milliseconds,
                report.search_milliseconds,
                report.regularise_milliseconds,
            ];
            let what = format!("{options:?}: {parts:?} of {}", report.milliseconds);
            assert!(parts.iter().sum::<f64>() <= report.milliseconds, "{what}");
            assert!(parts[0] > 0.0 && parts[3] > 0.0, "{what}");
            assert_eq!(report.remesh_milliseconds, 0.0);
        }
    }
}

#[test]
fn without_a_mesh_every_request_is_refused() {
    let mut session = Session::new();
    assert_eq!(session.step().expect_err("no mesh").kind, "NoMesh");
    assert_eq!(session.back().expect_err("no mesh").kind, "NoMesh");
    assert_eq!(session.info().expect_err("no mesh").kind, "NoMesh");
    assert_eq!(
        session.export(Format::Obj).expect_err("no mesh").kind,
        "NoMesh"
    );
}

#[test]
fn energies_of_a_sphere_are_the_smooth_ones() {
    let session = with("icosphere", &[("level", 5.0)]);
    let found = session.energy(Boundary::Clamped, &[1.5]).expect("energies");
    let sphere = 4.0 * std::f64::consts::PI;
    assert!(found.circle.abs() < 1e-9);
    // H = 1 on the unit sphere, so every ∫|H|^p is its area.
    for (p, value) in &found.p_willmore {
        assert!((value / sphere - 1.0).abs() < 5e-3, "p = {p}: {value}");
    }
    assert_eq!(found.willmore, found.p_willmore["2"]);
    assert!((found.volume.expect("closed") * 3.0 / sphere - 1.0).abs() < 5e-3);
    assert!(found.conformal_distortion >= 0.0 && found.gradient_norm < 1e-6);
}

/// Diagnosis, energies and flow tell one area, one volume and one ∫H² of quadrilaterals.
#[test]
fn quadrilaterals_are_measured_in_one_way() {
    let mut text = String::new();
    let (n, m) = (12, 8);
    for i in 0..n {
        for j in 0..m {
            let (u, v) = (
                std::f64::consts::TAU * f64::from(i) / f64::from(n),
                std::f64::consts::TAU * f64::from(j) / f64::from(m),
            );
            let r = 2.0 + (0.7 + 0.1 * (3.0 * u).sin()) * v.cos();
            text += &format!("v {} {} {}\n", r * u.cos(), r * u.sin(), 0.7 * v.sin());
        }
    }
    for i in 0..n {
        for j in 0..m {
            let at = |i: i32, j: i32| (i % n) * m + j % m + 1;
            let (a, b) = (at(i, j), at(i + 1, j));
            text += &format!("f {a} {b} {} {}\n", at(i + 1, j + 1), at(i, j + 1));
        }
    }
    let mut session = Session::new();
    let loaded = session.load(text.as_bytes(), "quads.obj").expect("a mesh");
    let mut state_of = |scheme| {
        let options = FlowOptions {
            flow: FlowName::PWillmore,
            scheme,
            ..FlowOptions::default()
        };
        session.configure(options).expect("a flow").state
    };
    let paper = state_of(Scheme::Paper);
    let state = state_of(Scheme::Auto);
    let energy = session.energy(Boundary::Fixed, &[]).expect("energies");
    let close = |a: f64, b: f64| (a - b).abs() < 1e-12 * b.abs();
    assert!(close(loaded.info.area, state.area) && close(energy.area, state.area));
    let volumes = [loaded.info.volume, energy.volume].map(|v| v.expect("closed"));
    assert!(
        volumes
            .iter()
            .all(|v| close(*v, state.volume.expect("closed")))
    );
    // The paper's scheme lowers the lumped one, the recommended one what lies between.
    assert!(close(energy.willmore, paper.energy));
    assert!(energy.willmore < state.energy && state.energy < energy.willmore_consistent);
}

#[test]
fn curvature_flows_run_go_back_and_tell_their_jump() {
    let mut session = with("four-bumps", &[("vertices", 31.0)]);
    assert_eq!(session.curvature_jump().expect("a mesh"), None);
    let jump = |session: &Session| {
        let jump = session.curvature_jump().expect("a mesh");
        jump.expect("a rim").relative
    };
    let mut last = Vec::new();
    for flow in [
        FlowName::MeanCurvature,
        FlowName::SurfaceDiffusion,
        FlowName::Willmore,
        FlowName::Mmcv,
    ] {
        let options = FlowOptions {
            flow,
            ..FlowOptions::default()
        };
        let configured = session.configure(options).expect("options");
        assert_eq!(configured.free_vertices, 185);
        assert!((configured.tau - 1.0).abs() < 1e-12);
        assert!((jump(&session) - 0.1054).abs() < 1e-3, "the surface itself");
        session.run(2).expect("steps");
        let (x, state) = (
            session.positions().expect("x"),
            session.state().expect("state"),
        );
        session.run(1).expect("a step");
        assert_eq!(session.back().expect("back"), state);
        assert_eq!(session.positions().expect("x"), x);
        session.run(60).expect("a run");
        let state = session.state().expect("state");
        assert_eq!(state.status, Status::Converged, "{:?}", state.message);
        for name in [
            "mean-curvature",
            "gauss-curvature",
            "gradient",
            "displacement",
        ] {
            let field = session.field(name).expect("a field").expect("values");
            assert!(
                field.values.iter().all(|v| v.is_finite()),
                "{flow:?} {name}"
            );
        }
        last.push(jump(&session));
    }
    let [first, second, third, sixth] = last[..] else {
        panic!("four flows")
    };
    assert!(first > 0.9 && sixth < 0.6 * second.min(third), "{last:?}");
}

/// The field shows what the flow sees, also where the usual H is none: on the boundary.
#[test]
fn mean_curvature_is_that_of_the_fits_under_flows_that_use_them() {
    let mut session = with("four-bumps", &[("vertices", 31.0)]);
    let on_corner = |session: &Session| {
        let field = session.field("mean-curvature").expect("a field");
        field.expect("values").values[0]
    };
    session.configure(FlowOptions::default()).expect("options");
    assert_eq!(on_corner(&session), 0.0);
    let options = FlowOptions {
        flow: FlowName::Mmcv,
        ..FlowOptions::default()
    };
    session.configure(options).expect("options");
    assert!(on_corner(&session) != 0.0);
}

#[test]
fn the_boundary_is_clamped_or_held_as_the_flow_has_it() {
    let mut session = with("hyperbolic-paraboloid", &[("cells", 10.0)]);
    let mut free = |flow, boundary| {
        let options = FlowOptions {
            flow,
            boundary,
            ..FlowOptions::default()
        };
        session.configure(options).expect("options").free_vertices
    };
    assert_eq!(free(FlowName::Circle, None), 49);
    assert_eq!(free(FlowName::Mmcv, None), 81);
    assert_eq!(free(FlowName::Circle, Some(Boundary::Fixed)), 81);
    assert_eq!(free(FlowName::Mmcv, Some(Boundary::Clamped)), 49);
}

/// What is told at the end is of the surface, and not of who took the steps.
#[test]
fn a_run_ends_with_what_its_steps_warned_of() {
    let values = [("around", 20.0), ("tube", 20.0)];
    let options = FlowOptions {
        max_steps: Some(30),
        ..FlowOptions::default()
    };
    let mut session = crate::support::session::with("clifford-torus", &values, options);
    while !session.state().expect("a state").status.is_final() {
        session.step().expect("a step");
    }
    let mut steps = Vec::new();
    for report in session.reports().expect("reports") {
        steps.extend(report.warnings.iter().map(Warning::message));
    }
    assert!(steps.iter().any(|told| &*told.id == "warning-little-gain"));
    let end = session.outcome().expect("an outcome").warnings;
    let end: Vec<&str> = end.iter().map(|told| &*told.id).collect();
    assert_eq!(end, ["warning-reading-rose"]);
}
