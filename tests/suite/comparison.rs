//! Documents side by side in a session: the same start, kept level, to their rest.

use crate::support::session::{flowing, with};
use umbilic::app::{Arrangement, Compare, Comparison, Lockstep, Pane, PaneChange, Session};
use umbilic::flow::Status;
use umbilic::flow::option::{Value, Values};
use umbilic::flow::options::{FlowName, FlowOptions, Scheme};

const NAMES: [&str; 4] = ["mean-curvature", "surface-diffusion", "willmore", "mmcv"];

fn compare(session: &mut Session, compare: Compare) {
    let arrangement = Arrangement {
        compare,
        ..Arrangement::default()
    };
    session.arrange(arrangement).expect("arranged");
}

fn bumps(flow: FlowName) -> Session {
    let mut session = Session::new();
    session
        .sample("four-bumps", &[("vertices".into(), 41.0)])
        .expect("a sample");
    let options = FlowOptions {
        flow,
        prefill: true,
        ..FlowOptions::default()
    };
    session.configure(options).expect("configured");
    session
}

fn panes(session: &Session) -> Vec<Pane> {
    let panes = session.panes("mean-curvature").expect("panes");
    assert_eq!(panes.iter().map(|p| p.name).collect::<Vec<_>>(), NAMES);
    panes
}

fn jumps(panes: &[Pane]) -> Vec<f64> {
    let jump = |p: &Pane| p.jump;
    panes
        .iter()
        .map(|p| jump(p).expect("a jump").relative)
        .collect()
}

/// Figures 5.5 and 5.6: only the sixth-order flow joins with continuous mean curvature.
#[test]
fn each_flow_comes_to_its_rest_and_the_sixth_order_one_joins_best() {
    let mut session = bumps(FlowName::Mmcv);
    assert!(session.panes("none").expect("panes").is_empty());
    compare(&mut session, Compare::Flows);
    session.run(60).expect("runs");
    let panes = panes(&session);
    for pane in &panes {
        let state = pane.state.as_ref().expect("a state");
        assert_eq!(state.status, Status::Converged, "{}", pane.name);
    }
    let jumps = jumps(&panes);
    println!("{jumps:.4?}");
    let [mean_curvature, diffusion, willmore, variation] = jumps[..] else {
        panic!("four flows");
    };
    assert!(variation < 0.5 * diffusion && variation < 0.5 * willmore);
    assert!(diffusion < 0.3 * mean_curvature);
    // One scale of colours.
    let range = |p: &Pane| p.field.as_ref().map(|f| (f.low, f.high));
    assert!(panes.iter().all(|p| range(p) == range(&panes[0])));
    assert_ne!(panes[0].positions, panes[3].positions);
}

/// Whichever flow is the chosen one, each does what it does alone.
#[test]
fn a_flow_beside_others_is_the_flow_alone() {
    let mut alone = bumps(FlowName::SurfaceDiffusion);
    alone.run(3).expect("steps");
    let mut session = bumps(FlowName::Willmore);
    session.step().expect("a step");
    // Those that join later catch up.
    compare(&mut session, Compare::Flows);
    assert_eq!(steps(&panes(&session)), [1; 4]);
    session.run(2).expect("steps");
    let now = panes(&session);
    assert_eq!(steps(&now), [3; 4]);
    assert_eq!(now[1].positions, alone.positions().expect("positions"));
    assert_eq!(now[2].positions, session.positions().expect("positions"));
    // Back and forward again, all of them.
    session.back().expect("back");
    session.back().expect("back");
    assert_eq!(steps(&panes(&session)), [1; 4]);
    session.run(2).expect("steps");
    assert!(panes(&session)[1].positions == now[1].positions);
    session.reset().expect("reset");
    assert_eq!(steps(&panes(&session)), [0; 4]);
    compare(&mut session, Compare::None);
    assert!(session.panes("none").expect("panes").is_empty());
    // Under another flow there is nothing to compare, and it stays so after an undo.
    compare(&mut session, Compare::Flows);
    session
        .configure(FlowOptions::default())
        .expect("configured");
    assert!(session.panes("none").expect("panes").is_empty());
}

fn steps(panes: &[Pane]) -> [usize; 4] {
    std::array::from_fn(|i| panes[i].state.as_ref().map_or(99, |s| s.step))
}

fn change(words: &[(&str, Value)]) -> PaneChange {
    let change = words
        .iter()
        .map(|(name, value)| ((*name).into(), value.clone()));
    PaneChange {
        change: change.collect::<Values>(),
        step: None,
    }
}

fn bumpy() -> Session {
    with(
        "bumpy-sphere",
        &[("level", 2.0)],
        flowing(FlowName::MeanCurvature),
    )
}

fn side_by_side(panes: Vec<PaneChange>, lockstep: Lockstep) -> Comparison {
    Comparison {
        panes,
        lockstep,
        ..Comparison::default()
    }
}

/// A pane of other options is the same as a document alone under these, wherever it is gone to.
#[test]
fn a_pane_is_a_document_of_its_own() {
    let tau = 0.3;
    let mut alone = with(
        "bumpy-sphere",
        &[("level", 2.0)],
        FlowOptions {
            tau: Some(tau),
            ..flowing(FlowName::MeanCurvature)
        },
    );
    alone.run(3).expect("steps");
    let mut session = bumpy();
    session.step().expect("a step");
    let pane = change(&[("tau", Value::Number(tau))]);
    let comparison = side_by_side(vec![pane, PaneChange::default()], Lockstep::Step);
    session.compare(comparison).expect("compared");
    session.run(2).expect("steps");
    let shown = |session: &Session| session.panes("none").expect("panes");
    let now = shown(&session);
    assert_eq!(
        now.iter().map(|p| p.name).collect::<Vec<_>>(),
        ["A", "B", "C"]
    );
    assert_eq!(now[1].positions, alone.positions().expect("positions"));
    assert_eq!(
        now[2].positions,
        session.positions().expect("positions"),
        "a twin"
    );
    assert_ne!(now[1].positions, now[0].positions);
    session.seek(1).expect("sought");
    session.run(2).expect("steps");
    assert!(shown(&session)[1].positions == now[1].positions);
    // Its steps are told once, in frames.
    let told: Vec<usize> = session.frame().expect("a frame").panes[1]
        .reports
        .iter()
        .map(|point| point.step)
        .collect();
    assert_eq!(told, [1, 2, 3]);
    assert!(
        session.frame().expect("a frame").panes[1]
            .reports
            .is_empty()
    );
    session.compare(Comparison::default()).expect("ended");
    assert!(shown(&session).is_empty());
}

/// In lockstep by time each pane stands at its first step that is no earlier than the first's.
#[test]
fn panes_are_kept_level_by_time_where_their_times_agree() {
    // Steps of one size each.
    let mut session = with(
        "bumpy-sphere",
        &[("level", 2.0)],
        FlowOptions {
            scheme: Scheme::Paper,
            tau: Some(0.05),
            ..flowing(FlowName::MeanCurvature)
        },
    );
    let slow = change(&[("tau", Value::Number(0.02))]);
    session
        .compare(side_by_side(vec![slow.clone()], Lockstep::Time))
        .expect("compared");
    let level = |session: &Session| {
        let panes = session.panes("none").expect("panes");
        let states = panes.iter().map(|p| p.state.clone().expect("a state"));
        let [first, other] = states.collect::<Vec<_>>().try_into().expect("two");
        assert!(
            other.time >= first.time * (1.0 - 1e-8),
            "{} {}",
            other.time,
            first.time
        );
        // One step less, and it would be behind.
        assert!(other.step == 0 || other.time - other.dt < first.time * (1.0 + 1e-9));
        [first.step, other.step]
    };
    session.run(2).expect("steps");
    let [first, other] = level(&session);
    assert_eq!([first, other], [2, 5]);
    session.back().expect("back");
    assert_eq!(level(&session), [1, 3]);
    session.reset().expect("reset");
    assert_eq!(level(&session), [0, 0]);
    // Times of flows of other orders mean nothing to each other: by steps then.
    let fourth = change(&[("flow", Value::Text("surface-diffusion".into()))]);
    session
        .compare(side_by_side(vec![fourth], Lockstep::Time))
        .expect("compared");
    session.run(2).expect("steps");
    let panes = session.panes("none").expect("panes");
    assert_eq!(panes[1].state.as_ref().map(|s| s.step), Some(2));
}

/// Then and now: a pane may be held at a step.
#[test]
fn a_pane_can_be_held_at_a_step() {
    let mut session = bumpy();
    let then = PaneChange {
        step: Some(1),
        ..PaneChange::default()
    };
    session
        .compare(side_by_side(vec![then], Lockstep::Step))
        .expect("compared");
    session.run(3).expect("steps");
    let panes = session.panes("none").expect("panes");
    let steps = panes.iter().map(|p| p.state.as_ref().map(|s| s.step));
    assert_eq!(steps.collect::<Vec<_>>(), [Some(3), Some(1)]);
    assert_ne!(panes[0].positions, panes[1].positions);
}

#[test]
fn what_cannot_stand_side_by_side_is_refused_and_changes_nothing() {
    let mut session = bumpy();
    let good = change(&[("tau", Value::Number(0.5))]);
    session
        .compare(side_by_side(vec![good], Lockstep::Step))
        .expect("compared");
    for (words, kind) in [
        (("flow", Value::Text("flips".into())), "FixedStart"),
        (("tau", Value::Number(-1.0)), "BadOption"),
        (("taut", Value::Number(1.0)), "UnknownOption"),
    ] {
        let pane = change(&[words]);
        let fault = session.compare(side_by_side(vec![pane], Lockstep::Step));
        assert_eq!(fault.expect_err(kind).kind, kind);
    }
    assert_eq!(session.panes("none").expect("panes").len(), 2);
    let other = flowing(FlowName::Circle);
    let fault = session.step().and_then(|_| session.continue_with(other));
    assert_eq!(fault.expect_err("from the mesh itself").kind, "FixedStart");
    // They come back with what an edit took away, and are made anew for another flow.
    session.adopt().expect("kept");
    session.undo_edit().expect("undone");
    assert_eq!(session.panes("none").expect("panes").len(), 2);
    session
        .configure(flowing(FlowName::Circle))
        .expect("a flow");
    let panes = session.panes("none").expect("panes");
    assert_eq!(panes[1].state.as_ref().map(|s| s.step), Some(0));
}
