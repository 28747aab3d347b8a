//! Which trials of a move are taken, and how much of it.

use super::{Script, idle};
use crate::flow::rules::{Ceiling, Rules};
use crate::flow::{Cause, Refusal, Search};
use std::rc::Rc;

/// (r − 2)² from r = 1 by a move of 4: whole, it would rise to 9; the parabola has its least at a
/// quarter of it.
#[test]
fn a_move_that_rises_is_shortened_to_the_least_of_a_parabola() {
    let parabola = Script {
        dt: 4.0,
        ..Script::new(|r| (r - 2.0).powi(2), |_| 1.0)
    };
    let (reports, _, r) = parabola.run(1);
    assert!((r - 2.0).abs() < 1e-9, "{r}");
    assert_eq!((reports[0].rejected, reports[0].objective_before), (1, 1.0));
    assert!((reports[0].dt - 1.0).abs() < 1e-6 && (reports[0].time - 1.0).abs() < 1e-6);
}

#[test]
fn a_refusal_that_knows_by_how_much_shortens_the_move_by_that() {
    let limited = Script {
        refusal: Rc::new(|r| {
            let too_far = Refusal {
                ratio: Some(0.37),
                ..Refusal::of(Cause::TooFar)
            };
            (r > 1.9).then_some(too_far)
        }),
        ..Script::new(|r| -r, |_| 1.0)
    };
    let (_, _, r) = limited.run(1);
    assert!((r - 1.37).abs() < 1e-9, "{r}");
}

#[test]
fn ceilings_hold_for_trials() {
    // A whole step rises by 0.1 a unit; then up to a ceiling as it is shortened.
    let rising = |ceiling: Ceiling| {
        let script = Script {
            rules: Rules {
                ceiling,
                ..idle().rules
            },
            search: Search::Solve,
            ..Script::new(|r| 1.0 + 0.1 * (r - 1.0), |_| 1.0)
        };
        script.run(1).2
    };
    assert!((rising(Ceiling::None) - 2.0).abs() < 1e-9);
    assert!((rising(Ceiling::Below(1.02)) - 1.0625).abs() < 1e-9);
    assert!((rising(Ceiling::NoRise(0.0)) - 1.0).abs() < 1e-9);
    assert!((rising(Ceiling::NoRise(1.02)) - 1.0625).abs() < 1e-9);
    assert!((rising(Ceiling::Descent) - 1.0).abs() < 1e-9);
}

/// A fall that is smaller than the roundoff of the functional proves nothing.
#[test]
fn an_invisible_fall_is_none() {
    let script = |roundoff: f64| Script {
        rules: Rules {
            roundoff,
            ..idle().rules
        },
        ..Script::new(|r| 1.0 - 1e-9 * (r - 1.0), |_| 1.0)
    };
    assert_eq!(script(1e-6).run(1).0.len(), 0);
    assert_eq!(script(1e-12).run(1).0.len(), 1);
    // The move as a whole would be seen; its tenth, which alone is let pass, is not.
    let far = Script {
        refusal: Rc::new(|r| (r > 1.5).then(|| Refusal::of(Cause::Fold))),
        ..script(0.5e-9)
    };
    let (reports, ending, r) = far.run(1);
    assert!(reports.is_empty() && r == 1.0, "{ending:?}");
}

/// A step of the Wolfe search goes on until the slope has flattened; what is reported is what was
/// measured last, at the surface that is taken.
#[test]
fn a_quasi_newton_step_goes_on_until_the_slope_flattens() {
    let bowl = Script {
        search: Search::Wolfe,
        dt: 0.1,
        ..Script::new(|r| (r - 3.0).powi(2), |_| 1.0)
    };
    let (reports, _, r) = bowl.run(1);
    // The slope −4 has flattened to nine tenths at 1.2.
    assert!((1.2..3.0).contains(&r), "{r}");
    assert!((reports[0].objective - (r - 3.0).powi(2)).abs() < 1e-12);
    // Before a jump no step flattens it.
    let rim = Script {
        search: Search::Wolfe,
        dt: 0.1,
        ..Script::new(
            |r: f64| if r < 1.501 { 2.501 - r } else { r + 9.0 },
            |_| 1.0,
        )
    };
    let (reports, _, r) = rim.run(1);
    assert!((1.49..1.501).contains(&r), "{r}");
    assert!((reports[0].objective - (2.501 - r)).abs() < 1e-12);
    let last = *rim.measured.borrow().last().expect("trials");
    assert!((last - r).abs() < 1e-12, "{last} is measured, {r} taken");
}
