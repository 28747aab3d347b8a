//! Flows side by side in a session: the same start, kept at one step, to their rest.

use umbilic::app::{Arrangement, Compare, Pane, Session};
use umbilic::flow::Status;
use umbilic::flow::options::FlowOptions;
use umbilic::flow::spec::FlowName;

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
    alone.run(2).expect("steps");
    let mut session = bumps(FlowName::Willmore);
    session.step().expect("a step");
    // Those that join later catch up.
    compare(&mut session, Compare::Flows);
    assert_eq!(steps(&panes(&session)), [1; 4]);
    session.run(1).expect("steps");
    let now = panes(&session);
    assert_eq!(steps(&now), [2; 4]);
    assert_eq!(now[1].positions, alone.positions().expect("positions"));
    assert_eq!(now[2].positions, session.positions().expect("positions"));
    // Back and forward again, all of them.
    session.back().expect("back");
    session.back().expect("back");
    assert_eq!(steps(&panes(&session)), [0; 4]);
    session.run(2).expect("steps");
    assert!(panes(&session)[1].positions == now[1].positions);
    session.reset().expect("reset");
    assert_eq!(steps(&panes(&session)), [0; 4]);
    compare(&mut session, Compare::None);
    assert!(session.panes("none").expect("panes").is_empty());
    // They go from the mesh itself, and come back with what an edit took away.
    compare(&mut session, Compare::Flows);
    session.step().expect("a step");
    let circle = FlowOptions::default();
    let fault = session.continue_with(circle);
    assert_eq!(fault.expect_err("from the mesh itself").kind, "FixedStart");
    session.adopt().expect("kept");
    session.undo_edit().expect("undone");
    assert_eq!(session.panes("none").expect("panes").len(), 4);
    // Under another flow there is nothing to compare.
    session
        .configure(FlowOptions::default())
        .expect("configured");
    assert!(session.panes("none").expect("panes").is_empty());
}

fn steps(panes: &[Pane]) -> [usize; 4] {
    std::array::from_fn(|i| panes[i].state.as_ref().map_or(99, |s| s.step))
}
