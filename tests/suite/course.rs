//! Going on with another flow: as from a new start, and the way back stays.

use crate::support::session::{Dice, flowing, shown, with};
use umbilic::app::{Action, Arrangement, Compare, Configured, RegulariseOptions, Session};
use umbilic::flow::Status;
use umbilic::flow::constraint::Kept;
use umbilic::flow::options::{FlowOptions, Scheme};
use umbilic::flow::spec::FlowName;
use umbilic::io::Format;

/// Options that have nothing to do with each other, for a closed and for an open surface.
fn changes() -> Vec<(Session, FlowOptions)> {
    let bumpy = |options| with("bumpy-sphere", &[("level", 2.0)], options);
    let patch = |options| with("four-bumps", &[("vertices", 31.0)], options);
    let kept = FlowOptions {
        keep: vec![Kept::Area, Kept::Volume],
        ..flowing(FlowName::PWillmore)
    };
    let small = FlowOptions {
        tau: Some(0.3),
        ..flowing(FlowName::Circle)
    };
    let filled = FlowOptions {
        prefill: true,
        ..flowing(FlowName::Mmcv)
    };
    vec![
        (bumpy(flowing(FlowName::Circle)), kept.clone()),
        (bumpy(kept), flowing(FlowName::Circle)),
        (bumpy(flowing(FlowName::Circle)), small),
        (
            bumpy(flowing(FlowName::Willmore)),
            flowing(FlowName::PWillmore),
        ),
        (
            patch(flowing(FlowName::MeanCurvature)),
            flowing(FlowName::Mmcv),
        ),
        (patch(flowing(FlowName::SurfaceDiffusion)), filled),
        (patch(flowing(FlowName::Mmcv)), flowing(FlowName::Circle)),
    ]
}

/// The vertices and faces of a file, without the comment that names the step.
fn mesh(session: &Session) -> String {
    let file = session.export(Format::Obj).expect("a file");
    let text = String::from_utf8(file).expect("text");
    text.lines().filter(|line| !line.starts_with('#')).collect()
}

#[test]
fn going_on_is_a_new_start_less_the_clock() {
    for (mut session, options) in changes() {
        let name = format!("{:?}", options.flow);
        session.run(3).expect("steps");
        let turned = session.state().expect("state");
        let mut fresh = with_recipe_of(&session);
        fresh.adopt().expect("kept");
        let expected = fresh.configure(options.clone()).expect("options");
        let configured = session.continue_with(options.clone()).expect("options");
        assert_eq!(configured.free_vertices, expected.free_vertices, "{name}");
        assert_eq!(configured.mean_edge_length, expected.mean_edge_length);
        assert_eq!((configured.dt, configured.tau), (expected.dt, expected.tau));
        assert_eq!(configured.state.energy, expected.state.energy, "{name}");
        assert_eq!(configured.state.status, Status::Ready);
        assert_eq!(
            (configured.state.step, configured.state.time),
            (3, turned.time)
        );
        assert!(
            mesh(&session) == mesh(&fresh),
            "{name}: a pre-fill moves both"
        );
        for _ in 0..4 {
            let a = session.step().expect("a step").expect("there is one");
            let b = fresh.step().expect("a step").expect("there is one");
            assert_eq!(
                (a.step, a.energy, a.dt),
                (b.step + 3, b.energy, b.dt),
                "{name}"
            );
            assert_eq!(a.volume, b.volume, "{name}");
            let time = turned.time + b.time;
            assert!(
                (a.time - time).abs() <= 1e-12 * time,
                "{name}: {} {time}",
                a.time
            );
            assert!(mesh(&session) == mesh(&fresh), "{name}");
        }
        assert_eq!(session.options().expect("a mesh"), Some(options));
    }
}

/// Another session that has done the same.
fn with_recipe_of(session: &Session) -> Session {
    let loaded = session.loaded().expect("a mesh");
    let sample = loaded.name.as_str();
    let values = match loaded.positions.len() / 3 {
        42 => ("level", 1.0),
        162 => ("level", 2.0),
        _ => ("vertices", 31.0),
    };
    let recipe = session.provenance().expect("a recipe");
    let mut other = with(sample, &[values], recipe.flow.expect("options"));
    for action in recipe.path {
        match action {
            Action::Steps(count) => drop(other.run(count).expect("steps")),
            Action::Regularise(settings) => drop(other.regularise(&settings).expect("regularised")),
            Action::Anew => other.renew().expect("renewed"),
            Action::Flow(options) => drop(other.continue_with(*options).expect("options")),
        }
    }
    other
}

#[test]
fn what_was_to_come_becomes_a_branch_under_the_options_before() {
    for (mut session, options) in changes() {
        let name = format!("{:?}", options.flow);
        let before = session.options().expect("a mesh").expect("options");
        session.run(5).expect("steps");
        let old = shown(&session);
        let gradient = |session: &Session| {
            let field = session.field("gradient").expect("a field");
            field.expect("one").values
        };
        let old_gradient = gradient(&session);
        session.seek(2).expect("sought");
        let fork = shown(&session);
        session.continue_with(options.clone()).expect("options");
        let start = shown(&session);
        let timeline = session.timeline().expect("a timeline");
        assert_eq!((timeline.at, timeline.last), (2, 2), "{name}");
        let branch = timeline.branches[0];
        assert_eq!((branch.from, branch.last), (2, 5), "{name}");
        session.run(2).expect("steps");
        let new = shown(&session);
        let new_gradient = gradient(&session);
        // To the other way and back, by branches and by steps.
        session.branch(branch.id).expect("a branch");
        assert!(shown(&session) == old, "{name}");
        // What is measured is measured by the flow that stood there.
        assert!(gradient(&session) == old_gradient, "{name}");
        assert_eq!(session.options().expect("a mesh").as_ref(), Some(&before));
        let other = session.timeline().expect("a timeline").branches[0];
        assert_eq!((other.from, other.last), (2, 4), "{name}");
        session.branch(other.id).expect("a branch");
        assert!(shown(&session) == new, "{name}");
        assert_eq!(session.options().expect("a mesh").as_ref(), Some(&options));
        assert!(gradient(&session) == new_gradient, "{name}");
        session.back().expect("back");
        session.back().expect("back");
        assert!(shown(&session) == start, "{name}");
        session.back().expect("back");
        assert!(shown(&session) == fork, "{name}");
        assert_eq!(session.options().expect("a mesh").as_ref(), Some(&before));
        // Forth again, and on as if nobody had looked.
        session.seek(4).expect("sought");
        assert!(shown(&session) == new, "{name}");
        let mut straight = with_recipe_of(&session);
        assert!(shown(&straight) == new, "{name}");
        session.run(2).expect("steps");
        straight.renew().expect("renewed");
        straight.run(2).expect("steps");
        assert!(shown(&straight) == shown(&session), "{name}");
        // From the start again, with the options in force; what was done stays.
        let end = shown(&session);
        session.reset().expect("reset");
        assert_eq!(session.state().expect("state").step, 0);
        assert_eq!(session.options().expect("a mesh"), Some(options));
        let branches = session.timeline().expect("a timeline").branches;
        session
            .branch(branches[branches.len() - 1].id)
            .expect("a branch");
        assert!(shown(&session) == end, "{name}");
    }
}

#[test]
fn any_walk_is_done_again_by_its_recipe() {
    let kept = FlowOptions {
        keep: vec![Kept::Volume],
        ..flowing(FlowName::PWillmore)
    };
    let flows = [flowing(FlowName::Circle), kept, flowing(FlowName::Willmore)];
    let mut dice = Dice(7);
    let (mut changed, mut turned) = (0, 0);
    for _ in 0..6 {
        let mut session = with("bumpy-sphere", &[("level", 1.0)], flows[0].clone());
        for _ in 0..60 {
            match dice.below(7) {
                0..3 => drop(session.step().expect("a step")),
                3 => drop(session.back().expect("back")),
                4 => drop(session.seek(dice.below(12)).expect("sought")),
                5 => {
                    let options = flows[dice.below(flows.len())].clone();
                    session.continue_with(options).expect("options");
                    changed += 1;
                }
                _ => {
                    let branches = session.timeline().expect("a timeline").branches;
                    if !branches.is_empty() {
                        let id = branches[dice.below(branches.len())].id;
                        session.branch(id).expect("a branch");
                        turned += 1;
                    }
                }
            }
            let mut again = with_recipe_of(&session);
            // That no further step is to be taken is known once one was asked for.
            let ended = session.state().expect("state").status.is_final();
            if ended && !again.state().expect("state").status.is_final() {
                assert!(again.step().expect("no failure").is_none());
            }
            assert!(shown(&again) == shown(&session));
            assert_eq!(
                again.options().expect("a mesh"),
                session.options().expect("a mesh")
            );
            assert_eq!(
                again.configured().expect("a mesh"),
                session
                    .configured()
                    .expect("a mesh")
                    .map(|found| Configured {
                        state: again.state().expect("state"),
                        ..found
                    })
            );
        }
    }
    assert!(
        changed > 10 && turned > 10,
        "{changed} changes, {turned} turns"
    );
}

#[test]
fn what_is_kept_is_that_of_where_the_flow_began() {
    let mut session = with("bumpy-sphere", &[("level", 2.0)], flowing(FlowName::Circle));
    let volume = |session: &Session| session.state().expect("state").volume.expect("closed");
    let of_the_mesh = volume(&session);
    session.run(3).expect("steps");
    let turned = volume(&session);
    assert!(
        (turned / of_the_mesh - 1.0).abs() > 1e-3,
        "the first flow keeps none"
    );
    let kept = FlowOptions {
        keep: vec![Kept::Volume],
        max_steps: Some(6),
        ..flowing(FlowName::PWillmore)
    };
    let found = session.continue_with(kept).expect("options");
    let begun = (found.mean_edge_length, found.free_vertices);
    session.run(2).expect("steps");
    // Looked back to the other flow, it is made anew.
    session.seek(1).expect("sought");
    session.seek(5).expect("sought");
    let configured = |session: &Session| {
        let found = session.configured().expect("a mesh").expect("a flow");
        (found.mean_edge_length, found.free_vertices)
    };
    assert_eq!(configured(&session), begun);
    session.run(4).expect("steps");
    let drift = (volume(&session) / turned - 1.0).abs();
    assert!(drift <= 1e-8, "drift {drift:e}");
    // Its budget of steps is its own.
    let state = session.state().expect("state");
    assert_eq!((state.step, state.status), (9, Status::StepLimit));
}

#[test]
fn a_diagnosis_looks_at_the_steps_of_the_present_flow() {
    let mut session = with("bumpy-sphere", &[("level", 2.0)], flowing(FlowName::Circle));
    let kind = |session: &Session| session.why().expect("a mesh").map(|found| found.kind);
    let is_refused = (0..20).any(|_| {
        session.run(1).expect("a step");
        kind(&session) == Some("RejectedSteps")
    });
    assert!(is_refused, "{:?}", kind(&session));
    let paper = FlowOptions {
        scheme: Scheme::Paper,
        ..flowing(FlowName::Circle)
    };
    session.continue_with(paper).expect("options");
    assert_eq!(kind(&session), None, "nothing has happened yet");
    // Of the paper's scheme, less energy at an earlier step means that it rises; not that of
    // another flow.
    session
        .configure(flowing(FlowName::MeanCurvature))
        .expect("options");
    session.run(2).expect("steps");
    let area = session.state().expect("state").energy;
    let small = FlowOptions {
        scheme: Scheme::Paper,
        tau: Some(0.01),
        ..flowing(FlowName::Circle)
    };
    session.continue_with(small).expect("options");
    session.run(2).expect("steps");
    assert!(session.state().expect("state").energy > 1.1 * area);
    assert_eq!(kind(&session), None);
}

#[test]
fn its_recipe_tells_each_flow_in_its_turn() {
    let mut session = with("bumpy-sphere", &[("level", 2.0)], flowing(FlowName::Circle));
    session.run(2).expect("steps");
    let p_willmore = flowing(FlowName::PWillmore);
    session.continue_with(p_willmore.clone()).expect("options");
    session.run(3).expect("steps");
    let settings = RegulariseOptions::default();
    session.regularise(&settings).expect("regularised");
    session
        .continue_with(flowing(FlowName::Mmcv))
        .expect("options");
    session.run(1).expect("a step");
    let recipe = session.provenance().expect("a recipe");
    assert_eq!(recipe.flow, Some(flowing(FlowName::Circle)));
    let expected = [
        Action::Steps(2),
        Action::Flow(Box::new(p_willmore)),
        Action::Steps(3),
        Action::Regularise(settings),
        Action::Flow(Box::new(flowing(FlowName::Mmcv))),
        Action::Steps(1),
    ];
    assert_eq!(recipe.path, expected);
    assert!(shown(&with_recipe_of(&session)) == shown(&session));
    // So does an edit, and undoing it brings all of it back.
    let before = shown(&session);
    session.adopt().expect("kept");
    let recipe = session.provenance().expect("a recipe");
    let chapter = &recipe.edits[0];
    assert_eq!(chapter.flow, Some(flowing(FlowName::Circle)));
    assert_eq!(chapter.path, expected);
    session.undo_edit().expect("undone");
    assert!(shown(&session) == before);
    assert_eq!(
        session.options().expect("a mesh"),
        Some(flowing(FlowName::Mmcv))
    );
    session.seek(1).expect("sought");
    assert_eq!(
        session.options().expect("a mesh"),
        Some(flowing(FlowName::Circle))
    );
}

#[test]
fn a_second_thought_takes_the_place_of_the_first() {
    let filled = FlowOptions {
        prefill: true,
        ..flowing(FlowName::Mmcv)
    };
    let mut session = with(
        "four-bumps",
        &[("vertices", 31.0)],
        flowing(FlowName::Willmore),
    );
    session.run(2).expect("steps");
    let fork = shown(&session);
    session.continue_with(filled).expect("options");
    let moved = shown(&session);
    assert!(moved.0 != fork.0, "the pre-fill");
    // One that comes to nothing takes nothing away.
    let bad = FlowOptions {
        free: Some(vec![1_000_000]),
        ..flowing(FlowName::Mmcv)
    };
    session.continue_with(bad).expect_err("refused");
    assert!(shown(&session) == moved);
    assert_eq!(session.timeline().expect("a timeline").stored, 4);
    session
        .continue_with(flowing(FlowName::Mmcv))
        .expect("options");
    let timeline = session.timeline().expect("a timeline");
    assert_eq!((timeline.stored, timeline.branches.len()), (4, 0));
    assert_eq!(
        session.provenance().expect("a recipe").path,
        [
            Action::Steps(2),
            Action::Flow(Box::new(flowing(FlowName::Mmcv)))
        ]
    );
    session.back().expect("back");
    assert!(shown(&session) == fork);
    // Back to what it was: as if nothing had been changed.
    let before = flowing(FlowName::Willmore);
    session
        .continue_with(flowing(FlowName::Mmcv))
        .expect("options");
    session.continue_with(before.clone()).expect("options");
    assert!(shown(&session) == fork);
    session.continue_with(before).expect("options");
    assert_eq!(
        session.provenance().expect("a recipe").path,
        [Action::Steps(2)]
    );
    assert_eq!(session.timeline().expect("a timeline").last, 2);
}

#[test]
fn what_goes_from_the_mesh_itself_is_refused() {
    let mut session = with("sampled-torus", &[], flowing(FlowName::Flips));
    session.run(1).expect("a flip");
    let fault = session
        .continue_with(flowing(FlowName::Circle))
        .expect_err("refused");
    assert_eq!(fault.kind, "FixedStart");
    session
        .configure(flowing(FlowName::Willmore))
        .expect("options");
    // Nothing to go on from yet: the same as a configuration.
    session
        .continue_with(flowing(FlowName::Circle))
        .expect("options");
    assert_eq!(session.provenance().expect("a recipe").path, []);
    session.run(1).expect("a step");
    let before = shown(&session);
    let fault = session
        .continue_with(flowing(FlowName::Flips))
        .expect_err("refused");
    assert_eq!(fault.kind, "FixedStart");
    assert!(shown(&session) == before);
    session
        .configure(flowing(FlowName::Willmore))
        .expect("options");
    let arrangement = Arrangement {
        compare: Compare::Flows,
        ..Arrangement::default()
    };
    session.arrange(arrangement).expect("arranged");
    session.run(1).expect("a step");
    let fault = session
        .continue_with(flowing(FlowName::Mmcv))
        .expect_err("refused");
    assert_eq!(fault.kind, "FixedStart");
}
