//! How long a press of Pause waits for the solver, flow by flow: the longest CPU time between two
//! asks whether a step is to go on, and the longest from the ask before a refused one to the step's
//! return, of some in every step.
//!
//! `cargo bench --bench interruption -- [LEVEL [STEPS [FLOW]]]`; a bumpy sphere of level 6 has 41k
//! vertices, one of level 7 has 164k. In wasm all takes about 2.2 times as long.

#![allow(
    clippy::unwrap_used,
    reason = "a bench that fails has nothing to measure"
)]

#[path = "../suite/support/clock.rs"]
mod clock;

use clock::clock;
use std::cell::Cell;
use std::ops::ControlFlow;
use std::rc::Rc;
use umbilic::app::Session;
use umbilic::flow::options::FlowOptions;
use umbilic::flow::spec::FlowName;

const FLOWS: [FlowName; 7] = [
    FlowName::Circle,
    FlowName::PWillmore,
    FlowName::MeanCurvature,
    FlowName::VolumePreserving,
    FlowName::SurfaceDiffusion,
    FlowName::Willmore,
    FlowName::Mmcv,
];

/// Times at which each step is given up before it is taken.
const REFUSALS: usize = 12;

/// Seconds of one step.
#[derive(Clone, Copy, Default)]
struct Times {
    whole: f64,
    /// Longest between two asks.
    gap: f64,
    /// From the ask before the refused one to the return, if one was refused.
    wait: Option<f64>,
}

/// Takes a step; `until` are the seconds after which it is given up.
fn step(session: &mut Session, until: f64) -> Times {
    let start = clock();
    let last = Rc::new(Cell::new(start));
    let times = Rc::new(Cell::new(Times::default()));
    let (asked, told) = (Rc::clone(&last), Rc::clone(&times));
    session.set_progress(Some(Rc::new(move |_, _| {
        let now = clock();
        let mut times = told.get();
        times.gap = times.gap.max(now - asked.get());
        if now - start >= until {
            times.wait = Some(asked.get());
            told.set(times);
            return ControlFlow::Break(());
        }
        told.set(times);
        // Reading the clock takes time of its own.
        asked.set(clock());
        ControlFlow::Continue(())
    })));
    session.step().unwrap();
    let end = clock();
    session.set_progress(None);
    let times = times.get();
    let since = end - last.get();
    match times.wait {
        Some(_) => Times {
            whole: end - start,
            wait: Some(since),
            ..times
        },
        None => Times {
            whole: end - start,
            gap: times.gap.max(since),
            wait: None,
        },
    }
}

fn main() {
    let mut given = std::env::args()
        .skip(1)
        .filter(|word| !word.starts_with("--"));
    let level: f64 = given.next().map_or(6.0, |word| word.parse().unwrap());
    let steps: usize = given.next().map_or(2, |word| word.parse().unwrap());
    let only = given.next();
    println!("milliseconds        step    whole      gap     wait");
    for flow in FLOWS {
        let name = format!("{flow:?}");
        if only.as_ref().is_some_and(|only| *only != name) {
            continue;
        }
        let mut session = Session::new();
        let level = [("level".into(), level)];
        session.sample("bumpy-sphere", &level).unwrap();
        let options = FlowOptions {
            flow,
            ..FlowOptions::default()
        };
        session.configure(options).unwrap();
        let mut length = 0.5;
        for n in 1..=steps {
            let (mut gap, mut wait) = (0.0f64, 0.0f64);
            for k in 0..REFUSALS {
                let times = step(&mut session, length * (k as f64 + 0.5) / REFUSALS as f64);
                gap = gap.max(times.gap);
                match times.wait {
                    Some(this) => wait = wait.max(this),
                    // It was shorter than thought, and is taken.
                    None => break,
                }
            }
            let times = step(&mut session, f64::INFINITY);
            length = times.whole;
            let numbers =
                [times.whole, gap.max(times.gap), wait].map(|s| format!("{:9.0}", 1e3 * s));
            println!("{name:<18}{n:>6}{}", numbers.concat());
        }
    }
}
