//! How runs end.

use super::{Script, idle};
use crate::flow::rules::{Ceiling, Rules};
use crate::flow::{Cause, Monitored, Reason, Refusal, Search, Status};
use std::rc::Rc;

#[test]
fn an_idle_run_has_converged_only_where_it_is_at_rest() {
    let at_rest = Script {
        stationarity: 1.0,
        ..idle()
    };
    assert_eq!(at_rest.status(), (10, Status::Converged));
    // Not at rest, and nothing refused: it is given time to fall, four windows of it.
    assert_eq!(idle().status(), (40, Status::Stalled));
    let resting = Script {
        rests: true,
        ..idle()
    };
    assert_eq!(resting.status(), (1, Status::Converged));
}

/// The first whole step alone would go below the bound: the run has not got stuck since.
#[test]
fn an_idle_run_that_met_a_bound_has_collapsed() {
    let met = Script {
        bounded: Rc::new(|r| if r > 1.9 { 0.0 } else { 2.0 }),
        rules: Rules {
            bound: Some(2.0),
            bound_share: 0.9,
            ..idle().rules
        },
        dt: 1000.0,
        ..Script::new(|_| 1.0, |r| if r < 1.01 { 1e-3 } else { 1e-9 })
    };
    let (reports, ending, _) = met.run(200);
    assert_eq!(ending.expect("an ending").0, Status::Collapsed);
    let refused: usize = reports.iter().map(|report| report.rejected).sum();
    assert_eq!((reports.len(), refused), (10, 1));
}

/// Every trial is refused: for a bound, for a sliver above and below it, for a rise at rest.
#[test]
fn a_run_without_a_step_ends_by_why_trials_were_refused() {
    let refused = |cause: Cause, bound: Option<f64>, stationarity: f64| {
        let script = Script {
            refusal: Rc::new(move |_| Some(Refusal::of(cause))),
            rules: Rules {
                bound,
                ..idle().rules
            },
            stationarity,
            ..idle()
        };
        script.status()
    };
    let none = 0;
    assert_eq!(refused(Cause::Rise, None, 2.0), (none, Status::Stalled));
    assert_eq!(refused(Cause::Rise, None, 0.5), (none, Status::Converged));
    assert_eq!(refused(Cause::Bound, None, 0.5), (none, Status::Collapsed));
    // The value, 1, is below a bound of 2 already.
    assert_eq!(
        refused(Cause::Sliver, Some(2.0), 2.0),
        (none, Status::Collapsed)
    );
    assert_eq!(
        refused(Cause::Sliver, Some(0.5), 2.0),
        (none, Status::Stalled)
    );
    assert_eq!(
        refused(Cause::Rise, Some(2.0), 2.0),
        (none, Status::Stalled)
    );
}

#[test]
fn a_surface_that_may_vanish_is_singular_once_it_has() {
    let shrinking = |can_vanish: bool| {
        let script = Script {
            rules: Rules {
                can_vanish,
                ..idle().rules
            },
            growth: 1.0,
            ..Script::new(|r| r, |r| -0.5 * r)
        };
        let (reports, ending, _) = script.run(12);
        (reports.len(), ending.expect("an ending").0)
    };
    // 4^(−5) of the area is left after five.
    assert_eq!(shrinking(true), (5, Status::Singular));
    assert_eq!(shrinking(false), (12, Status::StepLimit));
}

/// A ball that grows a tip, from where on every step is refused.
fn tip(cause: Cause, spike: f64, monitored: Monitored) -> Script {
    Script {
        monitored,
        rules: Rules {
            can_vanish: true,
            ..idle().rules
        },
        refusal: Rc::new(move |r| (r > 1.2).then(|| Refusal::of(cause))),
        spike,
        level: 3.0,
        growth: 1.0,
        search: Search::Solve,
        ..Script::new(|r| -r, |_| 1e-2)
    }
}

/// A tip that has grown, and from which no step bends further, is told; not so where the functional
/// alone is in the way, unless it is an area that no step lowers; nor where the tip was there before.
#[test]
fn a_new_tip_from_which_no_step_leads_is_told_and_no_singularity() {
    for (cause, spike, monitored, is_told) in [
        (Cause::Turn, 10.0, Monitored::Willmore, true),
        (Cause::Rise, 10.0, Monitored::Willmore, false),
        (Cause::Rise, 10.0, Monitored::Area, true),
        (Cause::Turn, 1.0, Monitored::Willmore, false),
    ] {
        let (status, why) = tip(cause, spike, monitored).run(200).1.expect("an ending");
        assert_eq!(status, Status::Stalled, "{why}");
        let is_tip = matches!(why, Reason::SharpTip { vertex: 0, .. });
        assert_eq!(is_tip, is_told, "{why}");
    }
}

/// The tip is no longer there then.
#[test]
fn where_a_better_surface_takes_the_place_of_a_tip_nothing_is_singular() {
    let script = Script {
        better: Some((false, 0.5)),
        ..tip(Cause::Turn, 10.0, Monitored::Willmore)
    };
    let (_, ending, r) = script.run(200);
    let (status, why) = ending.expect("an ending");
    assert!(
        status == Status::Stalled && matches!(why, Reason::WorseRest { .. }),
        "{why}"
    );
    assert!((r - 0.5).abs() < 1e-12, "{r}");
}

#[test]
fn a_step_limit_and_a_zero_end_a_run() {
    let (reports, ending, _) = Script::new(|r| 2.0 - r, |_| 1e-3).run(7);
    assert_eq!(
        (reports.len(), ending.expect("an ending").0),
        (7, Status::StepLimit)
    );
    let falling = Script {
        rules: Rules {
            zero: 0.25,
            ..idle().rules
        },
        ..Script::new(|r| 2.0 - r, |_| 0.25)
    };
    // 1, 0.75 and, with twice the step, 0.25.
    assert_eq!(falling.status(), (2, Status::Converged));
}

/// A face that grows to hundreds of times the mean stalls a run of the recommended rules.
#[test]
fn a_mesh_that_no_longer_resolves_its_surface_stalls() {
    let grown = |ceiling: Ceiling| {
        let script = Script {
            rules: Rules {
                ceiling,
                ..idle().rules
            },
            spike: 1e4,
            level: 3.0,
            search: Search::Solve,
            ..Script::new(|r| -r, |_| 1.0)
        };
        script.run(1).1.expect("an ending")
    };
    let (status, why) = grown(Ceiling::Descent);
    assert_eq!(status, Status::Stalled);
    assert!(matches!(why, Reason::LargeFace { .. }), "{why}");
    assert_eq!(grown(Ceiling::None).0, Status::StepLimit);
}
