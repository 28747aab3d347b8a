//! Steps of a flow that are drawn as one motion: cubic Hermite interpolation between them.
//!
//! A flow takes few, long steps; a display shows sixty pictures a second. The surface is
//! drawn at a time between two steps as a weighted sum of up to [`SLOTS`] of them,
//! `x(t) = Σ wᵢ(t) xᵢ` with `Σ wᵢ = 1`. Whatever is linear in the positions needs these
//! weights alone: so they cross to the GPU, and no positions do.

/// Steps that are held at a time: two between which the surface is drawn, and one on
/// either side of them for the velocities.
pub const SLOTS: usize = 4;

/// A step that is held.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Knot {
    /// Where it is stored.
    slot: usize,
    /// When it is shown.
    time: f32,
    /// Whether the way from the step before it is a straight line at constant velocity.
    is_straight: bool,
}

/// The steps that are held, in the order of their times, and the time that is shown.
#[derive(Clone, Debug, PartialEq)]
pub struct Motion {
    knots: Vec<Knot>,
    time: f32,
}

impl Default for Motion {
    fn default() -> Self {
        Self::still()
    }
}

impl Motion {
    /// One step alone, in slot 0, at time 0.
    pub fn still() -> Self {
        let first = Knot {
            slot: 0,
            time: 0.0,
            is_straight: false,
        };
        Self {
            knots: vec![first],
            time: 0.0,
        }
    }

    /// Adds the step that follows; says in which slot to store it. The oldest step makes
    /// room where all slots are taken.
    ///
    /// `time` counts from the step that [`still`](Self::still) began with; one that is not
    /// finite or not after the last step is refused with none.
    pub fn add(&mut self, time: f32, is_straight: bool) -> Option<usize> {
        if !(time.is_finite() && time > self.last().time) {
            return None;
        }
        let slot = if self.knots.len() < SLOTS {
            self.knots.len()
        } else {
            self.knots.remove(0).slot
        };
        self.knots.push(Knot {
            slot,
            time,
            is_straight,
        });
        Some(slot)
    }

    /// Shows another time. Before the first step held it is that step that is shown, after
    /// the last, that.
    pub fn set_time(&mut self, time: f32) {
        if time.is_finite() {
            self.time = time;
        }
    }

    /// The slot of the step added last.
    pub fn newest(&self) -> usize {
        self.last().slot
    }

    /// Number of steps held; they take the first slots.
    pub fn n_steps(&self) -> usize {
        self.knots.len()
    }

    /// Weight of each slot at the time shown; they add up to 1. At the time of a step its
    /// own is exactly 1 and all others are exactly 0.
    ///
    /// Between two steps at distance `h`, with `s` from 0 to 1: the cubic with their
    /// positions and with velocities `v` of the parabola through a step and its two
    /// neighbours, `v = (h⁺ d⁻ + h⁻ d⁺) / (h⁻ + h⁺)` where `d` are the mean velocities
    /// before and after. At an end, and where one of the two ways is straight, that of the
    /// way itself; with that at both ends the cubic is a straight line.
    pub fn weights(&self) -> [f32; SLOTS] {
        let mut weights = [0.0; SLOTS];
        let after = self.knots.iter().position(|knot| knot.time >= self.time);
        let (n, knot) = match after {
            None => (0, self.last()),
            Some(n) => (n, self.knots[n]),
        };
        if n == 0 || knot.time == self.time {
            weights[knot.slot] = 1.0;
            return weights;
        }
        let from = self.knots[n - 1];
        let h = knot.time - from.time;
        let s = (self.time - from.time) / h;
        let rest = 1.0 - s;
        weights[from.slot] = (1.0 + 2.0 * s) * rest * rest;
        weights[knot.slot] = s * s * (3.0 - 2.0 * s);
        self.add_velocity(n - 1, n, h * s * rest * rest, &mut weights);
        self.add_velocity(n, n, -h * s * s * rest, &mut weights);
        weights
    }

    /// Adds `scale` times the velocity at a step to the weights, on the way to step `way`.
    fn add_velocity(&self, n: usize, way: usize, scale: f32, weights: &mut [f32; SLOTS]) {
        let ways = self.knots.len() - 1;
        let is_smooth = |way: usize| (1..=ways).contains(&way) && !self.knots[way].is_straight;
        let mut add = |way: usize, scale: f32| {
            let (from, to) = (self.knots[way - 1], self.knots[way]);
            let share = scale / (to.time - from.time);
            weights[to.slot] += share;
            weights[from.slot] -= share;
        };
        if is_smooth(n) && is_smooth(n + 1) {
            let before = self.knots[n].time - self.knots[n - 1].time;
            let after = self.knots[n + 1].time - self.knots[n].time;
            add(n, scale * after / (before + after));
            add(n + 1, scale * before / (before + after));
        } else {
            add(way, scale);
        }
    }

    fn last(&self) -> Knot {
        // There is always one: `still` begins with it, and `add` takes none away for nothing.
        self.knots[self.knots.len() - 1]
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Where the motion is at a time, if step `i` is at `at[i]`.
    struct Path {
        motion: Motion,
        at: [f32; SLOTS],
    }

    impl Path {
        fn new(steps: &[(f32, f32)]) -> Self {
            let mut path = Self {
                motion: Motion::still(),
                at: [steps[0].1; SLOTS],
            };
            for &(time, place) in &steps[1..] {
                path.add(time, place, false);
            }
            path
        }

        fn add(&mut self, time: f32, place: f32, is_straight: bool) {
            let slot = self.motion.add(time, is_straight).expect("later");
            self.at[slot] = place;
        }

        fn at(&mut self, time: f32) -> f32 {
            self.motion.set_time(time);
            let weights = self.motion.weights();
            assert!(
                (weights.iter().sum::<f32>() - 1.0).abs() < 1e-6,
                "{weights:?}"
            );
            weights.iter().zip(self.at).map(|(w, x)| w * x).sum()
        }

        fn velocity(&mut self, time: f32) -> f32 {
            (self.at(time + 5e-4) - self.at(time - 5e-4)) / 1e-3
        }
    }

    #[test]
    fn at_a_step_its_weight_is_exactly_one() {
        let mut motion = Motion::still();
        let times = [0.0, 0.1, 0.4, 1.7, 1.8, 2.9];
        for (n, &time) in times.iter().enumerate().skip(1) {
            motion.add(time, n == 4).expect("later");
            for &shown in &times[n.saturating_sub(3)..=n] {
                motion.set_time(shown);
                let weights = motion.weights();
                let ones = weights.iter().filter(|&&w| w == 1.0).count();
                let zeros = weights.iter().filter(|&&w| w == 0.0).count();
                assert_eq!((ones, zeros), (1, 3), "{weights:?} at {shown}");
            }
        }
    }

    #[test]
    fn a_parabola_is_followed_exactly() {
        // Cubic Hermite with the velocities of parabolas: exact up to degree two inside.
        let x = |t: f32| 1.0 + 2.0 * t - 1.5 * t * t;
        let times = [0.0, 0.3, 1.0, 1.2];
        let mut path = Path::new(&times.map(|t| (t, x(t))));
        for i in 0..=20 {
            let t = 0.3 + 0.7 * i as f32 / 20.0;
            assert!((path.at(t) - x(t)).abs() < 2e-6, "{} at {t}", path.at(t));
        }
    }

    #[test]
    fn the_velocity_does_not_jump_at_a_step() {
        let mut path = Path::new(&[(0.0, 0.0), (0.5, 1.0), (0.8, 3.0), (2.0, 2.0)]);
        for step in [0.5, 0.8] {
            let (before, after) = (path.velocity(step - 1e-3), path.velocity(step + 1e-3));
            assert!(
                (before - after).abs() < 0.1,
                "{before} and {after} at {step}"
            );
        }
    }

    #[test]
    fn a_straight_way_is_straight_and_spares_its_neighbours() {
        let mut path = Path::new(&[(0.0, 0.0), (1.0, 1.0)]);
        path.add(2.0, 9.0, true);
        path.add(3.0, 10.0, false);
        for (t, x) in [(1.25, 3.0), (1.5, 5.0), (0.5, 0.5), (2.5, 9.5)] {
            assert!((path.at(t) - x).abs() < 1e-5, "{} at {t}", path.at(t));
        }
    }

    #[test]
    fn beyond_what_is_held_the_nearest_step_is_shown() {
        let mut path = Path::new(&[(0.0, 0.0), (1.0, 1.0), (2.0, 2.0), (3.0, 3.0), (4.0, 4.0)]);
        assert_eq!(path.at(0.5), 1.0, "the oldest has made room");
        assert_eq!(path.at(9.0), 4.0);
        path.motion.set_time(f32::NAN);
        assert_eq!(path.motion.time, 9.0);
    }

    #[test]
    fn a_step_that_is_not_later_is_refused() {
        let mut motion = Motion::still();
        for time in [0.0, -1.0, f32::NAN, f32::INFINITY] {
            assert_eq!(motion.add(time, false), None);
        }
        assert_eq!(motion, Motion::still());
        let slots: Vec<_> = (1..7).map(|n| motion.add(n as f32, false)).collect();
        assert_eq!(slots, [1, 2, 3, 0, 1, 2].map(Some));
        assert_eq!(motion.newest(), 2);
    }
}
