//! When what failed is tried again.

/// Most solves that go by after a failure before the next attempt.
const LONGEST_WAIT: u32 = 15;

/// Exponential backoff: after failures in a row the next attempt waits for 1, 3, 7, … solves.
#[derive(Default)]
pub(super) struct Backoff {
    wait: u32,
    last_wait: u32,
}

impl Backoff {
    /// Whether this solve is to attempt it.
    pub(super) fn is_due(&mut self) -> bool {
        let due = self.wait == 0;
        self.wait = self.wait.saturating_sub(1);
        due
    }

    /// Takes note of an attempt, and hands on whether it succeeded.
    pub(super) fn record(&mut self, succeeded: bool) -> bool {
        self.last_wait = if succeeded {
            0
        } else {
            (2 * self.last_wait + 1).min(LONGEST_WAIT)
        };
        self.wait = self.last_wait;
        succeeded
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_failed_is_tried_again_after_ever_longer_waits() {
        let mut backoff = Backoff::default();
        let mut attempts = Vec::new();
        for solve in 0..60 {
            if backoff.is_due() {
                backoff.record(false);
                attempts.push(solve);
            }
        }
        assert_eq!(attempts, [0, 2, 6, 14, 30, 46]);
        backoff.record(true);
        assert!(backoff.is_due() && backoff.is_due());
    }
}
