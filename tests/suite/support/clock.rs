//! The time that computing takes, whatever else the machine does.

use std::sync::LazyLock;
use std::time::Instant;

/// Seconds this thread has computed for, where Linux tells; elsewhere seconds gone by.
pub(super) fn clock() -> f64 {
    static START: LazyLock<Instant> = LazyLock::new(Instant::now);
    let statistics = std::fs::read_to_string("/proc/thread-self/schedstat").unwrap_or_default();
    let nanoseconds = statistics
        .split(' ')
        .next()
        .and_then(|word| word.parse::<f64>().ok());
    nanoseconds.map_or_else(|| START.elapsed().as_secs_f64(), |ns| 1e-9 * ns)
}
