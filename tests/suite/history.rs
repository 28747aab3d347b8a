//! Looking around in a run: any walk through its steps shows what the straight run showed, to
//! the last bit.

use crate::support::session::{Dice, flowing, shown, with};
use umbilic::app::{
    Action, Arrangement, Compare, Edit, FillOptions, FlipOptions, Loops, RegulariseOptions, Session,
};
use umbilic::flow::Status;
use umbilic::flow::options::{FlowOptions, Integrator};
use umbilic::flow::spec::FlowName;
use umbilic::io::Format;
use umbilic::remesh::Mode;

fn flips_a_step(session: &mut Session, flips_per_step: usize, compare: Compare) {
    let arrangement = Arrangement {
        compare,
        flips_per_step: Some(flips_per_step),
        ..Arrangement::default()
    };
    session.arrange(arrangement).expect("arranged");
}

/// A surface with a flow of each kind.
fn flows() -> Vec<(&'static str, Session)> {
    let bumps = [("vertices", 31.0)];
    let mut flips = with(
        "sampled-torus",
        &[("jitter", 0.05)],
        flowing(FlowName::Flips),
    );
    flips_a_step(&mut flips, 2, Compare::Criteria);
    let p_willmore = FlowOptions {
        regularise: Mode::Nonlinear,
        ..flowing(FlowName::PWillmore)
    };
    vec![
        (
            "circle",
            with("bumpy-sphere", &[("level", 2.0)], flowing(FlowName::Circle)),
        ),
        (
            "p-willmore",
            with("bumpy-sphere", &[("level", 2.0)], p_willmore),
        ),
        ("mmcv", with("four-bumps", &bumps, flowing(FlowName::Mmcv))),
        (
            "mean-curvature",
            with("four-bumps", &bumps, flowing(FlowName::MeanCurvature)),
        ),
        ("flips", flips),
    ]
}

const STEPS: usize = 7;

#[test]
fn a_walk_through_the_steps_shows_the_straight_run_to_the_last_bit() {
    for (name, mut session) in flows() {
        let mut straight = vec![shown(&session)];
        for _ in 0..STEPS {
            session.step().expect("a step").expect("there is one");
            straight.push(shown(&session));
        }
        let unit = straight[1].1.step;
        session.reset().expect("reset");
        let mut dice = Dice(name.len() as u64);
        let (mut branched, mut turned) = (0, 0);
        for _ in 0..120 {
            let at = session.state().expect("state").step;
            let before = session.timeline().expect("a timeline");
            match dice.below(6) {
                0..3 if at < STEPS * unit => {
                    session.step().expect("a step");
                    assert_eq!(session.state().expect("state").step, at + unit, "{name}");
                    branched += session.timeline().expect("a timeline").branches.len();
                }
                3 => {
                    session.back().expect("back");
                    let expected = at.saturating_sub(unit);
                    assert_eq!(session.state().expect("state").step, expected, "{name}");
                }
                4 => {
                    let wanted = dice.below(STEPS * unit + 3);
                    session.seek(wanted).expect("sought");
                    let nearest = wanted.min(before.last) / unit * unit;
                    assert_eq!(session.state().expect("state").step, nearest, "{name}");
                    assert_eq!(session.timeline().expect("a timeline").last, before.last);
                }
                _ if !before.branches.is_empty() => {
                    let chosen = &before.branches[dice.below(before.branches.len())];
                    let state = session.branch(chosen.id).expect("a branch");
                    assert_eq!((state.step, state.energy), (chosen.last, chosen.energy));
                    turned += 1;
                }
                _ => {}
            }
            let now = session.state().expect("state");
            assert!(
                shown(&session) == straight[now.step / unit],
                "{name}, {}",
                now.step
            );
            assert_eq!(now.can_step_back, now.step > 0, "{name}");
        }
        // Of edge flips there is one way only.
        let has_branches = name != "flips";
        assert_eq!(
            (branched > 0, turned > 0),
            (has_branches, has_branches),
            "{name}"
        );
    }
}

#[test]
fn the_future_is_kept_as_a_branch_until_the_path_has_come_to_its_end() {
    let mut session = with("bumpy-sphere", &[("level", 2.0)], FlowOptions::default());
    session.run(6).expect("steps");
    let end = shown(&session);
    session.seek(2).expect("sought");
    assert_eq!(session.reports().expect("reports").len(), 2);
    session.step().expect("a step");
    let timeline = session.timeline().expect("a timeline");
    assert_eq!(
        (timeline.at, timeline.last, timeline.branches.len()),
        (3, 3, 1)
    );
    let branch = timeline.branches[0];
    assert_eq!((branch.from, branch.last), (2, 6));
    assert_eq!(branch.energy, end.1.energy);
    session.branch(branch.id).expect("a branch");
    assert!(shown(&session) == end);
    // What was left had nothing that the branch has not.
    assert_eq!(session.timeline().expect("a timeline").branches, []);
    session.seek(4).expect("sought");
    session.run(1).expect("a step");
    assert_eq!(session.timeline().expect("a timeline").branches.len(), 1);
    session.run(1).expect("a step");
    assert!(shown(&session) == end);
    assert_eq!(session.timeline().expect("a timeline").branches, []);
    let fault = session.branch(branch.id).expect_err("there is none");
    assert_eq!(fault.kind, "NoSuchBranch");
    assert!(shown(&session) == end);
}

#[test]
fn a_regularisation_on_the_way_makes_a_branch_of_its_own() {
    let options = FlowOptions {
        regularise: Mode::Off,
        ..flowing(FlowName::PWillmore)
    };
    let mut session = with("bumpy-sphere", &[("level", 2.0)], options);
    session.run(4).expect("steps");
    let plain = shown(&session);
    session.seek(2).expect("sought");
    let settings = RegulariseOptions::default();
    session.regularise(&settings).expect("regularised");
    let timeline = session.timeline().expect("a timeline");
    assert_eq!((timeline.at, timeline.branches.len()), (2, 1));
    session.run(2).expect("steps");
    let other = shown(&session);
    assert!(other.0 != plain.0);
    let recipe = session.provenance().expect("a recipe");
    let anew = Action::Anew;
    let expected = [
        Action::Steps(2),
        anew,
        Action::Regularise(settings),
        Action::Steps(2),
    ];
    assert_eq!(recipe.path, expected);
    // There and back.
    let id = timeline.branches[0].id;
    session.branch(id).expect("a branch");
    assert!(shown(&session) == plain);
    let branches = session.timeline().expect("a timeline").branches;
    assert_eq!(
        (branches.len(), branches[0].from, branches[0].last),
        (1, 2, 4)
    );
    session.branch(branches[0].id).expect("a branch");
    assert!(shown(&session) == other);
    // One step at a time, back undoes the regularisation and shows step 2 as it was.
    for _ in 0..3 {
        session.back().expect("back");
    }
    assert_eq!(session.state().expect("state").step, 2);
    session
        .branch(session.timeline().expect("a timeline").branches[0].id)
        .expect("a branch");
    session.seek(2).expect("sought");
    assert_eq!(
        session.provenance().expect("a recipe").path,
        [Action::Steps(2)]
    );
}

#[test]
fn a_reset_goes_to_the_very_start_and_is_undone_by_seeking() {
    for (name, mut session) in flows() {
        let start = shown(&session);
        if name == "p-willmore" {
            let settings = RegulariseOptions::default();
            session.regularise(&settings).expect("regularised");
        }
        session.run(3).expect("steps");
        let end = shown(&session);
        let path = session.provenance().expect("a recipe").path;
        session.reset().expect("reset");
        assert!(shown(&session) == start, "{name}");
        assert_eq!(session.provenance().expect("a recipe").path, []);
        session.seek(usize::MAX).expect("sought");
        assert!(shown(&session) == end, "{name}");
        // From there the steps are the same again, and are told as if nobody had looked.
        session.reset().expect("reset");
        if name == "p-willmore" {
            let settings = RegulariseOptions::default();
            session.regularise(&settings).expect("regularised");
        }
        session.run(3).expect("steps");
        assert!(shown(&session) == end, "{name}");
        assert_eq!(session.provenance().expect("a recipe").path, path, "{name}");
        assert_eq!(session.timeline().expect("a timeline").branches, []);
    }
}

/// The flow is left where it is while one looks back: even what it remembers of earlier steps.
#[test]
fn looking_back_does_not_disturb_a_flow_with_a_memory() {
    let options = FlowOptions {
        integrator: Integrator::Lbfgs,
        ..FlowOptions::default()
    };
    let mut straight = with("bumpy-sphere", &[("level", 2.0)], options.clone());
    straight.run(8).expect("steps");
    let mut session = with("bumpy-sphere", &[("level", 2.0)], options);
    session.run(5).expect("steps");
    session.seek(1).expect("sought");
    session.seek(5).expect("sought");
    session.run(3).expect("steps");
    assert!(shown(&session) == shown(&straight));
    assert_eq!(
        session.provenance().expect("a recipe").path,
        [Action::Steps(8)]
    );
    // From an earlier step it has to begin anew, comes out otherwise, and says so.
    session.seek(5).expect("sought");
    session.run(3).expect("steps");
    assert!(shown(&session).0 != shown(&straight).0);
    let expected = [Action::Steps(5), Action::Anew, Action::Steps(3)];
    assert_eq!(session.provenance().expect("a recipe").path, expected);
    // Done as told, it comes out the same.
    straight.reset().expect("reset");
    straight.run(5).expect("steps");
    straight.renew().expect("renewed");
    straight.run(3).expect("steps");
    assert!(shown(&session) == shown(&straight));
    assert_eq!(session.timeline().expect("a timeline").branches.len(), 1);
}

#[test]
fn edge_flips_are_sought_forwards_and_backwards() {
    let mut session = with(
        "sampled-torus",
        &[("jitter", 0.05)],
        flowing(FlowName::Flips),
    );
    flips_a_step(&mut session, 5, Compare::None);
    session.run(1000).expect("flips");
    let end = session.state().expect("state");
    assert_eq!(end.status, Status::Converged);
    let mesh = session.export(Format::Obj).expect("a file");
    let settings = RegulariseOptions::default();
    let fault = session.regularise(&settings).expect_err("refused");
    assert_eq!(fault.kind, "HeldPositions");
    session.seek(10).expect("sought");
    // What stands beside follows, though it has joined only now.
    flips_a_step(&mut session, 1, Compare::Criteria);
    session.step().expect("a flip");
    let timeline = session.timeline().expect("a timeline");
    assert_eq!(
        (timeline.at, timeline.last, timeline.branches.len()),
        (11, end.step, 0)
    );
    session.seek(usize::MAX).expect("sought");
    let state = session.state().expect("state");
    assert_eq!((state.step, state.energy), (end.step, end.energy));
    assert_eq!(state.flips.as_ref().map(Vec::len), Some(3));
    // But for the comment on top.
    let body = |file: &[u8]| {
        String::from_utf8_lossy(file)
            .lines()
            .skip(1)
            .collect::<String>()
    };
    assert_eq!(
        body(&session.export(Format::Obj).expect("a file")),
        body(&mesh)
    );
    assert_eq!(session.panes("none").expect("panes").len(), 3);
    assert_eq!(
        session.provenance().expect("a recipe").path,
        [Action::Steps(end.step)]
    );
}

#[test]
fn what_stands_beside_follows() {
    let mut session = with(
        "four-bumps",
        &[("vertices", 31.0)],
        flowing(FlowName::Willmore),
    );
    let arrangement = Arrangement {
        compare: Compare::Flows,
        ..Arrangement::default()
    };
    session.arrange(arrangement).expect("arranged");
    let positions = |session: &Session| {
        let panes = session.panes("none").expect("panes");
        panes.into_iter().map(|p| p.positions).collect::<Vec<_>>()
    };
    let mut seen = vec![positions(&session)];
    for _ in 0..6 {
        session.step().expect("a step");
        seen.push(positions(&session));
    }
    for step in [2, 5, 0, 6, 3, 4, 1] {
        session.seek(step).expect("sought");
        assert!(positions(&session) == seen[step], "step {step}");
    }
    session.step().expect("a step");
    assert!(positions(&session) == seen[2]);
}

#[test]
fn a_new_start_has_no_history_and_a_recipe_with_all_that_was_done() {
    let mut session = with(
        "four-bumps",
        &[("vertices", 31.0)],
        flowing(FlowName::MeanCurvature),
    );
    session.run(2).expect("steps");
    session.adopt().expect("kept");
    session
        .configure(flowing(FlowName::Flips))
        .expect("options");
    flips_a_step(&mut session, 1, Compare::None);
    session.run(3).expect("flips");
    session.flip(&FlipOptions::default()).expect("flipped");
    session.configure(flowing(FlowName::Mmcv)).expect("options");
    session.run(1).expect("a step");
    let timeline = session.timeline().expect("a timeline");
    assert_eq!((timeline.start, timeline.last), (0, 1));
    let recipe = session.provenance().expect("a recipe");
    let edits: Vec<_> = recipe.edits.iter().map(|c| (&c.edit, &*c.path)).collect();
    let flip = Edit::Flip(FlipOptions::default());
    let expected = [
        (&Edit::Adopt, &[Action::Steps(2)][..]),
        (&flip, &[Action::Steps(3)]),
    ];
    assert_eq!(edits, expected);
    // The sample's own selection is not repeated.
    let flow = recipe.edits[0].flow.as_ref().expect("options");
    assert_eq!((flow.flow, &flow.free), (FlowName::MeanCurvature, &None));
    session.undo_edit().expect("undone");
    assert_eq!(session.state().expect("state").step, 3);
    session.seek(1).expect("sought");
    assert_eq!(session.provenance().expect("a recipe").edits.len(), 1);
    // After a loss nothing is known any more.
    let positions = session.frame().expect("a frame").exact;
    session
        .configure(flowing(FlowName::Circle))
        .expect("options");
    session.restore(&positions, None, 7, 1.0).expect("restored");
    assert_eq!(session.timeline().expect("a timeline").start, 7);
    assert_eq!(session.provenance().expect_err("unknown").kind, "NoRecipe");
    session.reset().expect("reset");
    assert_eq!(session.provenance().expect("known").edits.len(), 1);
    session.restore(&positions, None, 7, 1.0).expect("restored");
    session.adopt().expect("kept");
    assert_eq!(session.provenance().expect_err("unknown").kind, "NoRecipe");
}

#[test]
fn a_fill_is_told_by_its_loops() {
    let mut session = Session::new();
    session.sample("pipe", &[]).expect("a sample");
    let all = FillOptions {
        loops: Loops::Word("all".into()),
        ..FillOptions::default()
    };
    session
        .fill(&all, &mut |_, _| std::ops::ControlFlow::Continue(()))
        .expect("filled");
    let recipe = session.provenance().expect("a recipe");
    assert_eq!(
        (recipe.edits.len(), recipe.edits[0].flow.is_none()),
        (1, true)
    );
    let text = serde_json::to_value(&recipe.edits[0].edit).expect("JSON");
    let expected =
        serde_json::json!({ "fill": { "loops": "all", "connect": false, "maxVertices": null } });
    assert_eq!(text, expected);
}
