//! Sessions on samples, and all that one shows.

use umbilic::app::{Session, State};
use umbilic::flow::options::FlowOptions;
use umbilic::flow::spec::FlowName;
use umbilic::io::Format;

pub fn with(sample: &str, values: &[(&str, f64)], options: FlowOptions) -> Session {
    let mut session = Session::new();
    let values: Vec<(String, f64)> = values.iter().map(|(n, v)| ((*n).into(), *v)).collect();
    session.sample(sample, &values).expect("a sample");
    session.configure(options).expect("options");
    session
}

pub fn flowing(flow: FlowName) -> FlowOptions {
    FlowOptions {
        flow,
        ..FlowOptions::default()
    }
}

pub type Shown = (Vec<u8>, State, Vec<(usize, u64)>, Vec<u32>);

/// All that is shown, less what a clock told and whether there is a step before.
pub fn shown(session: &Session) -> Shown {
    let reports = session.reports().expect("reports");
    let numbers = reports.iter().map(|r| (r.step, r.energy.to_bits()));
    (
        session.export(Format::Ply).expect("a file"),
        State {
            milliseconds: 0.0,
            can_step_back: false,
            ..session.state().expect("state")
        },
        numbers.collect(),
        session.flipped_triangles().expect("triangles"),
    )
}

/// Numbers that look random (Knuth's linear congruence).
pub struct Dice(pub u64);

impl Dice {
    pub fn below(&mut self, n: usize) -> usize {
        self.0 = self
            .0
            .wrapping_mul(6364136223846793005)
            .wrapping_add(1442695040888963407);
        (self.0 >> 33) as usize % n
    }
}
