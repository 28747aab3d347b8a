//! A link says what energy its scene had; whoever opens it learns whether it came out the same.
//! One version gives the same bits everywhere.

use crate::app::Session;
use crate::app::fault::Fault;
use crate::app::recipe::is_near;
use serde::Serialize;

/// Fewer digits are no proof.
const FEWEST_DIGITS: usize = 6;
/// All digits that a number has.
const ALL_DIGITS: usize = 15;
/// How near other versions come, relative to the energies …
const NEAR: f64 = 1e-6;
/// … or, where the flow has brought them down to nothing, to the energy at the start.
const NOTHING: f64 = 1e-12;

/// How an energy compares with the one sent.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
#[serde(rename_all = "camelCase")]
pub enum Check {
    /// To the last bit, or as far as it was written.
    Same,
    /// As near as other versions come.
    Near,
    /// Further off.
    Off,
    /// The flow ends before the step.
    EndsEarly,
}

/// What came of the scene of a link.
#[derive(Clone, Copy, Debug, PartialEq, Serialize)]
#[cfg_attr(test, derive(ts_rs::TS))]
pub struct LinkCheck {
    /// In a word.
    pub outcome: Check,
    /// The step here; of the half of a film that is shown backwards a negative one.
    pub step: i32,
    /// The energy here.
    pub energy: f64,
    /// The energy sent.
    pub sent: f64,
}

/// Significant digits of a number as text.
fn digits_of(text: &str) -> usize {
    let mantissa = text.split(['e', 'E']).next().unwrap_or("");
    let digits: String = mantissa.chars().filter(char::is_ascii_digit).collect();
    digits.trim_start_matches('0').len()
}

/// Compares an energy with one that was sent, `start` being the energy before the first step.
fn compare(sent: &str, energy: f64, start: f64) -> Check {
    let value: f64 = sent.parse().unwrap_or(f64::NAN);
    let digits = digits_of(sent);
    // Shortened by hand, all that is left of it must agree.
    let is_shortened = (FEWEST_DIGITS..ALL_DIGITS).contains(&digits);
    let rounded = || format!("{energy:.*e}", digits - 1).parse() == Ok(value);
    if value == energy || is_shortened && rounded() {
        return Check::Same;
    }
    let is_nothing = (value - energy).abs() <= NOTHING * start.abs();
    match is_nothing || is_near(value, energy, NEAR) {
        true => Check::Near,
        false => Check::Off,
    }
}

impl Session {
    /// Compares the scene of a link, at rest, with what the link says: the energy at a step.
    /// `None` where somebody went on, went elsewhere, or paused before it was there.
    ///
    /// # Errors
    /// [`Fault::no_mesh`].
    pub fn check_link(&self, sent: &str, step: i32) -> Result<Option<LinkCheck>, Fault> {
        let runner = self.runner()?;
        let (state, start) = (&runner.state, runner.beginning().0.energy);
        let here = self.signed(state.step);
        let outcome = match here.abs().cmp(&step.abs()) {
            _ if here.signum() * step.signum() < 0 => return Ok(None),
            std::cmp::Ordering::Equal => compare(sent, state.energy, start),
            std::cmp::Ordering::Less if state.status.is_final() => Check::EndsEarly,
            _ => return Ok(None),
        };
        Ok(Some(LinkCheck {
            outcome,
            step: here,
            energy: state.energy,
            sent: sent.parse().unwrap_or(f64::NAN),
        }))
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn energies_are_compared_to_the_last_bit_or_as_far_as_they_were_written() {
        let energy = 188.495_559_215_387_57;
        for (sent, outcome) in [
            ("188.49555921538757", Check::Same),
            ("188.49555921538760", Check::Near),
            ("188.4956", Check::Same),
            ("188.4957", Check::Near),
            // Too few digits, and not that number.
            ("188.50", Check::Off),
            ("188.4970", Check::Off),
        ] {
            assert_eq!(compare(sent, energy, 0.0), outcome, "{sent}");
        }
        // All gone: what is left is rounding.
        assert_eq!(compare("3e-15", 8e-16, 12.0), Check::Near);
        assert_eq!(compare("3e-5", 8e-6, 12.0), Check::Off);
    }
}
