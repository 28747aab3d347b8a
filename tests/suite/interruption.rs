//! A step that is given up, wherever that is, leaves the surface at the last accepted step, and is
//! the same to the last bit when it is taken again.

use serde_json::{Value as Json, json};
use std::cell::Cell;
use std::ops::ControlFlow;
use std::rc::Rc;
use umbilic::app::{
    Arrangement, Compare, Origin, Progress, RunCommand, ScriptText, Session, ToolCommand,
};
use umbilic::flow::options::{FlowOptions, Goal, Integrator, Remeshing, Scheme};
use umbilic::flow::spec::FlowName;
use umbilic::flow::{Decision, Driver, StepReport};
use umbilic::interrupt;
use umbilic::mesh::{build, shape};
use umbilic::remesh::Mode;

/// The same without times on a clock.
fn timeless(mut value: Json) -> Json {
    match &mut value {
        Json::Object(fields) => {
            fields.retain(|name, _| !name.to_lowercase().contains("milliseconds"));
            fields.values_mut().for_each(|v| *v = timeless(v.take()));
        }
        Json::Array(list) => list.iter_mut().for_each(|v| *v = timeless(v.take())),
        _ => {}
    }
    value
}

/// Everything that is shown.
fn shown(session: &mut Session) -> Json {
    let frame = session.frame().expect("a frame");
    let bits: Vec<u64> = frame.exact.iter().map(|c| c.to_bits()).collect();
    timeless(json!({
        "state": frame.state,
        "bits": bits,
        "triangles": frame.triangles.as_ref().map(|t| t.to_vec()),
        "folded": frame.flipped_triangles.to_vec(),
        "timeline": frame.timeline,
    }))
}

fn told(report: Option<StepReport>) -> Json {
    timeless(json!(report))
}

/// A step that is given up when it asks for the `nth` time; whether it ever asked so often.
fn interrupted(session: &mut Session, nth: usize) -> (bool, Option<StepReport>) {
    let asked = Rc::new(Cell::new(0));
    let count = Rc::clone(&asked);
    session.set_progress(Some(Rc::new(move |_, _| {
        count.set(count.get() + 1);
        match count.get() == nth {
            true => ControlFlow::Break(()),
            false => ControlFlow::Continue(()),
        }
    })));
    let report = session.step().expect("no failure");
    session.set_progress(None);
    (asked.get() >= nth, report)
}

/// Takes so many steps, each of which is given up again and again, later from one time to the next
/// by `growth`; answers how many were given up.
fn compare(make: impl Fn() -> Session, steps: usize, growth: f64) -> usize {
    let (mut plain, mut disturbed) = (make(), make());
    let mut given_up = 0;
    for step in 1..=steps {
        let report = plain.step().expect("no failure");
        let before = shown(&mut disturbed);
        let mut nth = 1.0f64;
        loop {
            let (asked, found) = interrupted(&mut disturbed, nth as usize);
            // What follows an accepted step is not given up any more.
            if !asked || found.is_some() {
                assert_eq!(told(found), told(report), "step {step}");
                break;
            }
            assert!(found.is_none(), "step {step} at {nth}");
            assert_eq!(shown(&mut disturbed), before, "step {step} at {nth}");
            given_up += 1;
            nth = (growth * nth).max(nth + 1.0);
        }
        assert_eq!(shown(&mut disturbed), shown(&mut plain), "step {step}");
    }
    let origin = Origin::Shape {
        shape: "any".into(),
        parameters: [].into(),
    };
    let recipe = |session: &Session| session.write_recipe(Some(&origin));
    assert_eq!(recipe(&disturbed), recipe(&plain));
    given_up
}

fn opened(shape: &str, values: &[(&str, f64)], options: &FlowOptions) -> Session {
    let values: Vec<_> = values.iter().map(|(n, v)| ((*n).into(), *v)).collect();
    let mut session = Session::new();
    session.sample(shape, &values).expect("a shape");
    session.configure(options.clone()).expect("a flow");
    session
}

fn flowing(flow: FlowName) -> FlowOptions {
    FlowOptions {
        flow,
        remesh: Remeshing::Off,
        ..FlowOptions::default()
    }
}

/// On a rough sphere.
fn rough(options: FlowOptions, steps: usize) {
    let values = [("level", 3.0), ("jitter", 0.1)];
    let given_up = compare(|| opened("ellipsoid", &values, &options), steps, 1.4);
    assert!(given_up > 4 * steps, "{options:?}: {given_up}");
}

#[test]
fn steps_of_every_flow_can_be_given_up_anywhere() {
    for flow in [
        FlowName::Circle,
        FlowName::PWillmore,
        FlowName::MeanCurvature,
        FlowName::VolumePreserving,
        FlowName::SurfaceDiffusion,
        FlowName::Willmore,
        FlowName::Mmcv,
    ] {
        rough(flowing(flow), 5);
    }
}

#[test]
fn schemes_of_the_papers_and_other_integrators_too() {
    for flow in [FlowName::Circle, FlowName::PWillmore, FlowName::Willmore] {
        let options = FlowOptions {
            scheme: Scheme::Paper,
            ..flowing(flow)
        };
        rough(options, 3);
    }
    for integrator in [Integrator::ForwardEuler, Integrator::BackwardEuler] {
        let options = FlowOptions {
            integrator,
            ..flowing(FlowName::Circle)
        };
        rough(options, 3);
    }
    let options = FlowOptions {
        regularise: Mode::Nonlinear,
        p: 4.0,
        ..flowing(FlowName::PWillmore)
    };
    rough(options, 3);
}

/// Long enough for its preconditioner to be renewed, from what is learnt of the steps before.
#[test]
fn what_the_finisher_has_learnt_is_kept() {
    let options = FlowOptions {
        integrator: Integrator::Lbfgs,
        ..flowing(FlowName::Circle)
    };
    rough(options, 26);
}

/// Through changes of phase to the end, and on from there.
#[test]
fn ends_and_changes_of_phase_are_the_same() {
    for flow in [FlowName::Circle, FlowName::Mmcv] {
        let options = flowing(flow);
        let values = [("level", 2.0), ("jitter", 0.2)];
        compare(|| opened("ellipsoid", &values, &options), 90, 3.0);
    }
    let limited = FlowOptions {
        max_steps: Some(2),
        goal: Goal::Relax,
        ..flowing(FlowName::Circle)
    };
    compare(|| opened("ellipsoid", &[("level", 3.0)], &limited), 6, 1.4);
}

/// A driver by itself, without a session around it.
#[test]
fn a_driver_goes_back_by_itself() {
    let options = FlowOptions {
        integrator: Integrator::Lbfgs,
        ..flowing(FlowName::Circle)
    };
    let sample = shape::make("ellipsoid", &[("level".into(), 2.0)]).expect("a shape");
    let built = build(&sample.soup).expect("a surface");
    let mesh = Rc::new(built.mesh);
    let begun = || {
        let mut x = built.positions.clone();
        let driver = Driver::start(&mesh, &mesh, &mut x, options.clone()).expect("a flow");
        (driver, x)
    };
    let ((mut plain, mut x), (mut disturbed, mut y)) = (begun(), begun());
    for step in 1..=12 {
        plain.step(&mut x).expect("a step");
        for nth in 1.. {
            let left = Cell::new(nth);
            let progress: Progress = Rc::new(move |_, _| {
                left.set(left.get() - 1);
                match left.get() {
                    0 => ControlFlow::Break(()),
                    _ => ControlFlow::Continue(()),
                }
            });
            let before = y.clone();
            let (report, decision) =
                interrupt::observed(Some(progress), || disturbed.step(&mut y)).expect("no failure");
            if report.is_some() {
                break;
            }
            assert_eq!(decision, Decision::GivenUp);
            assert_eq!(y, before);
        }
        assert_eq!(x, y, "step {step}");
        assert_eq!(plain.dt(), disturbed.dt());
    }
}

#[test]
fn a_step_after_a_look_back_is_the_same() {
    let options = flowing(FlowName::Circle);
    let make = || {
        let mut session = opened("ellipsoid", &[("level", 3.0), ("jitter", 0.1)], &options);
        session.run(4).expect("steps");
        session.seek(2).expect("a step");
        session
    };
    let given_up = compare(make, 2, 1.4);
    assert!(given_up > 8, "{given_up}");
}

#[test]
fn a_pass_of_remeshing_can_be_given_up_and_the_step_after_it() {
    let options = FlowOptions {
        flow: FlowName::PWillmore,
        ..FlowOptions::default()
    };
    let values = [("a", 4.0), ("level", 3.0), ("jitter", 0.2)];
    let mut session = opened("ellipsoid", &values, &options);
    let mut passes = 0;
    for _ in 0..8 {
        let report = session.step().expect("a step").expect("there is one");
        passes += usize::from(report.pass.is_some());
    }
    assert!(passes > 0);
    let given_up = compare(|| opened("ellipsoid", &values, &options), 8, 1.4);
    assert!(given_up > 60, "{given_up}");
}

#[test]
fn flips_that_are_given_up_are_taken_back() {
    let options = flowing(FlowName::Flips);
    let arrangement = Arrangement {
        compare: Compare::Criteria,
        subdivide: 0,
        flips_per_step: Some(1500),
    };
    let make = || {
        let mut session = opened("ellipsoid", &[("level", 4.0), ("jitter", 0.4)], &options);
        session.arrange(arrangement).expect("side by side");
        session
    };
    let given_up = compare(make, 3, 1.4);
    assert!(given_up > 6, "{given_up}");
}

/// Where the linear systems are solved by multigrid.
#[test]
fn a_step_on_a_large_mesh_is_the_same() {
    let options = flowing(FlowName::Circle);
    let values = [("level", 6.0)];
    let given_up = compare(|| opened("bumpy-sphere", &values, &options), 1, 5.0);
    assert!(given_up > 3, "{given_up}");
}

/// What is done again from a recipe can be given up as well; the rest follows.
#[test]
fn a_replay_goes_on_after_a_step_that_was_given_up() {
    let options = flowing(FlowName::Circle);
    let mut session = opened("ellipsoid", &[("level", 3.0)], &options);
    session.run(3).expect("steps");
    let origin = Origin::Shape {
        shape: "ellipsoid".into(),
        parameters: [("level".to_owned(), 3.0)].into(),
    };
    let text = session.write_recipe(Some(&origin)).expect("a recipe");
    let script = ScriptText::Recipe(text.clone());
    let mut again = Session::new();
    again.prepare(&script, None).expect("begun");
    while !again.advance().expect("prepared").is_done {}
    again.configure(options).expect("a flow");
    again.follow(&script).expect("begun");
    for nth in 1.. {
        let asked = Rc::new(Cell::new(0));
        let count = Rc::clone(&asked);
        again.set_progress(Some(Rc::new(move |_, _| {
            count.set(count.get() + 1);
            match count.get() == nth {
                true => ControlFlow::Break(()),
                false => ControlFlow::Continue(()),
            }
        })));
        if again.advance().expect("followed").is_done {
            break;
        }
    }
    let report = again.compare_recipe(&text).expect("a report");
    assert!(report.same && report.exact, "{report:?}");
}

/// The command, asked of a session again and again and given up later from one time to the next.
fn compare_edit(make: &dyn Fn() -> Session, command: &Json) -> usize {
    let command: ToolCommand = serde_json::from_value(command.clone()).expect("a command");
    let (mut plain, mut disturbed) = (make(), make());
    let answer = plain.perform_tool(command.clone()).expect("an edit");
    let before = shown(&mut disturbed);
    let mut given_up = 0;
    let mut nth = 1.0f64;
    loop {
        let left = Cell::new(nth as usize);
        disturbed.set_progress(Some(Rc::new(move |_, _| {
            left.set(left.get().saturating_sub(1));
            match left.get() {
                0 => ControlFlow::Break(()),
                _ => ControlFlow::Continue(()),
            }
        })));
        let found = disturbed.perform_tool(command.clone());
        disturbed.set_progress(None);
        match found {
            Ok(found) => {
                assert_eq!(timeless(json!(found)), timeless(json!(answer)));
                break;
            }
            Err(fault) => assert_eq!(fault.kind, "Cancelled", "{command:?} at {nth}"),
        }
        assert_eq!(shown(&mut disturbed), before, "{command:?} at {nth}");
        assert!(!disturbed.can_undo_edit());
        given_up += 1;
        nth = (1.6 * nth).max(nth + 1.0);
    }
    // Both go on alike.
    for session in [&mut plain, &mut disturbed] {
        session.run(2).expect("steps");
    }
    assert_eq!(shown(&mut disturbed), shown(&mut plain), "{command:?}");
    given_up
}

/// Where the step was too quick to learn that it is not wanted, what is asked next must not pay for it.
#[test]
fn where_a_session_stands_is_told_whoever_gives_up() {
    let mut session = opened("ellipsoid", &[], &flowing(FlowName::Circle));
    session.run(1).expect("a step");
    session.set_progress(Some(Rc::new(|_, _| ControlFlow::Break(()))));
    for command in [RunCommand::State {}, RunCommand::Timeline {}] {
        session.perform(command).expect("an answer");
    }
    let given_up = session.perform(RunCommand::Reset {});
    given_up.map(|_| ()).expect_err("given up");
}

#[test]
fn edits_that_are_given_up_change_nothing() {
    let sphere = || {
        let values = [("level", 4.0), ("jitter", 0.2)];
        let mut session = opened("ellipsoid", &values, &flowing(FlowName::Circle));
        session.run(1).expect("a step");
        session
    };
    let holed = || opened("holed-sphere", &[], &flowing(FlowName::Circle));
    // Every triangle has corners of its own.
    let loose = || {
        let soup = shape::make("ellipsoid", &[("level".into(), 3.0)])
            .expect("a shape")
            .soup;
        let (mut text, mut count) = (String::new(), 0);
        for face in soup.faces() {
            for &v in face {
                let p = soup.positions[v as usize];
                text += &format!("v {} {} {}\n", p.x, p.y, p.z);
            }
            text += &format!("f {} {} {}\n", count + 1, count + 2, count + 3);
            count += 3;
        }
        let mut session = Session::new();
        session
            .load(text.as_bytes(), "loose.obj")
            .expect("a surface");
        session
    };
    let edits: [(&dyn Fn() -> Session, Json, usize); 7] = [
        (&sphere, json!({ "regularise": {} }), 4),
        (&sphere, json!({ "flip": { "options": {} } }), 4),
        (&sphere, json!({ "remesh": { "options": {} } }), 4),
        (
            &sphere,
            json!({ "subdivide": { "options": { "scheme": "loop" } } }),
            1,
        ),
        (
            &sphere,
            json!({ "invert": { "centre": [1.0, 0.2, 0.1] } }),
            1,
        ),
        (
            &holed,
            json!({ "fill": { "options": { "loops": "all" } } }),
            4,
        ),
        (&loose, json!({ "repair": { "options": {} } }), 1),
    ];
    for (make, command, least) in edits {
        let given_up = compare_edit(make, &command);
        println!("{command}: {given_up}");
        assert!(given_up >= least, "{command}: {given_up}");
    }
}
