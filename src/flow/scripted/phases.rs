//! Phases that begin, better surfaces put in place, and errors.

use super::{Script, Scripted, ball, idle};
use crate::flow::circle::CircleFlow;
use crate::flow::options::FlowOptions;
use crate::flow::rules::{Ceiling, Rules};
use crate::flow::{Cause, Driver, FlowError, Phase, Reason, Refusal, Search, Status};
use std::rc::Rc;

#[test]
fn a_better_surface_takes_the_place_of_the_last_and_is_no_rest() {
    for (stationarity, is_at_rest) in [(1.0, true), (2.0, false)] {
        let script = Script {
            stationarity,
            better: Some((is_at_rest, 0.5)),
            ..idle()
        };
        let (reports, ending, r) = script.run(200);
        let (status, why) = ending.expect("an ending");
        assert_eq!(status, Status::Stalled, "{why}");
        assert!((r - 0.5).abs() < 1e-12, "{r}");
        assert!(
            is_at_rest == matches!(why, Reason::WorseRest { .. }),
            "{why}"
        );
        assert_eq!(reports.len(), if is_at_rest { 11 } else { 41 });
    }
}

/// A sharp tip at a surface that is at rest is no singularity, while no step was refused.
#[test]
fn a_better_surface_takes_the_place_of_a_rest_with_a_tip_too() {
    let script = Script {
        stationarity: 1.0,
        better: Some((true, 0.5)),
        rules: Rules {
            can_vanish: true,
            ..idle().rules
        },
        spike: 20.0,
        level: 3.0,
        growth: 1.0,
        ..idle()
    };
    let (reports, ending, r) = script.run(200);
    assert_eq!(ending.expect("an ending").0, Status::Stalled);
    assert_eq!(reports.len(), 11);
    assert!((r - 0.5).abs() < 1e-12, "{r}");
}

/// The functional of a phase is compared with itself, its window is its own, and its step size
/// begins anew where that is asked for.
#[test]
fn a_phase_begins_with_its_own_functional_window_and_step_size() {
    let begins = |phase: Phase| {
        let script = Script {
            rules: Rules {
                ceiling: Ceiling::NoRise(0.0),
                ..idle().rules
            },
            stationarity: 1.0,
            phase: Some(phase),
            search: Search::Solve,
            has_begun: Rc::default(),
            ..idle()
        };
        script.run(100)
    };
    let (reports, ending, _) = begins(Phase {
        resets_step_size: true,
        ..Phase::default()
    });
    assert_eq!(reports.len(), 20, "{ending:?}");
    assert_eq!((reports[9].dt, reports[10].dt), (512.0, 1.0));
    assert_eq!((reports[9].objective, reports[10].objective), (1.0, 2.0));
    let (reports, ..) = begins(Phase {
        raises_step_size: true,
        ..Phase::default()
    });
    assert_eq!((reports.len(), reports[10].dt), (20, 1024.0));
}

#[test]
fn a_step_size_that_has_shrunk_is_raised_where_a_phase_asks_for_it() {
    let script = Script {
        phase: Some(Phase {
            raises_step_size: true,
            ..Phase::default()
        }),
        stationarity: 1.0,
        dt: 64.0,
        growth: 1.0,
        // Short steps only, at first.
        refusal: Rc::new(|r| (r > 1.2).then(|| Refusal::of(Cause::Fold))),
        search: Search::Solve,
        ..Script::new(|_| 1.0, |r| if r < 1.0 + 1e-9 { 1.0 } else { 0.0 })
    };
    let (reports, ..) = script.run(100);
    assert_eq!(reports[0].dt, 0.0625);
    assert_eq!((reports[9].dt, reports[10].dt), (0.0625, 64.0));
}

/// An error on the way leaves surface and run as they were before the step.
#[test]
fn an_error_takes_the_step_back() {
    let script = Script {
        refusal: Rc::new(|_| Some(Refusal::of(Cause::Fold))),
        fails_below: 0.1,
        ..idle()
    };
    let (mesh, mut x) = ball(1.0);
    let options = FlowOptions::default();
    let inner = CircleFlow::new(&mesh, &mut x, &options).expect("a flow");
    let flow = Scripted {
        script,
        inner,
        slope: 0.0,
    };
    let before = x.clone();
    let mut driver = Driver::of(Box::new(flow), mesh, &x, options);
    let error = driver.step(&mut x).expect_err("an error");
    assert!(matches!(error, FlowError::Unfit { vertex: 7 }), "{error}");
    assert_eq!((driver.dt(), x), (1.0, before));
}
