//! Curves sampled evenly, and frames that do not spin along them.

use glam::{DQuat, DVec3};

/// Chords a sample: the spacing is even to about the square of its inverse.
const CHORDS: usize = 32;

/// `n` parameters in `[0, 1)`, beginning with 0, that cut `curve` into arcs of equal length.
///
/// The curve is followed over `[0, 1]`; the last arc ends at 1.
pub(super) fn even_parameters(n: usize, curve: impl Fn(f64) -> DVec3) -> Vec<f64> {
    let chords = CHORDS * n;
    let mut length = vec![0.0];
    let mut last = curve(0.0);
    for k in 1..=chords {
        let next = curve(k as f64 / chords as f64);
        length.push(length[k - 1] + last.distance(next));
        last = next;
    }
    let mut k = 0;
    (0..n)
        .map(|i| {
            let wanted = length[chords] * i as f64 / n as f64;
            while length[k + 1] <= wanted {
                k += 1;
            }
            (k as f64 + (wanted - length[k]) / (length[k + 1] - length[k])) / chords as f64
        })
        .collect()
}

/// For each point of a closed polygon, two unit vectors across it that make with its tangent
/// a right-handed frame and turn along it as evenly as closing up allows.
pub(super) fn closed_frames(points: &[DVec3]) -> Vec<(DVec3, DVec3)> {
    let n = points.len();
    let tangent = |i: usize| (points[(i + 1) % n] - points[(i + n - 1) % n]).normalize();
    let mut normal = tangent(0).any_orthonormal_vector();
    let first = normal;
    let mut transported = vec![normal];
    for i in 1..=n {
        // Parallel transport: the smallest rotation from one tangent to the next.
        normal = DQuat::from_rotation_arc(tangent(i - 1), tangent(i % n)) * normal;
        transported.push(normal);
    }
    // Transport around the curve misses the first normal by an angle: spread it.
    let miss = first.cross(normal).dot(tangent(0)).atan2(first.dot(normal));
    (0..n)
        .map(|i| {
            let (t, normal) = (tangent(i), transported[i]);
            let (sin, cos) = (-miss * i as f64 / n as f64).sin_cos();
            let normal = normal * cos + t.cross(normal) * sin;
            (normal, t.cross(normal))
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A closed curve with torsion, over `[0, 1]`.
    fn curve(s: f64) -> DVec3 {
        let t = std::f64::consts::TAU * s;
        DVec3::new(
            2.0 * t.cos(),
            t.sin(),
            (2.0 * t).cos() + 0.7 * (3.0 * t).sin(),
        )
    }

    fn points(n: usize) -> Vec<DVec3> {
        even_parameters(n, curve).into_iter().map(curve).collect()
    }

    #[test]
    fn steps_are_even() {
        let points = points(400);
        let steps = (0..400).map(|i| points[i].distance(points[(i + 1) % 400]));
        let (low, high) = steps.fold((f64::MAX, 0.0_f64), |(l, h), d| (l.min(d), h.max(d)));
        assert!(high / low < 1.005, "{low} to {high}");
    }

    #[test]
    fn frames_turn_evenly_and_close_up() {
        let points = points(400);
        let frames = closed_frames(&points);
        let turn = |i: usize| {
            let (a, b) = (frames[i], frames[(i + 1) % 400]);
            // The part of the step's rotation about the tangent.
            (a.1.dot(b.0) - a.0.dot(b.1)) / 2.0
        };
        for (i, (normal, binormal)) in frames.iter().enumerate() {
            let tangent = (points[(i + 1) % 400] - points[(i + 399) % 400]).normalize();
            assert!((normal.cross(*binormal) - tangent).length() < 1e-12);
            assert!(
                (turn(i) - turn(0)).abs() < 1e-4,
                "{i}: {} and {}",
                turn(i),
                turn(0)
            );
        }
    }
}
