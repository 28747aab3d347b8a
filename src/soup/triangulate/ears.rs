//! Ear clipping in a plane: the best ear first, and no flat one.
//!
//! A corner is an ear where the outline turns left and no other corner at which it does not lies in
//! its triangle. Cutting an ear changes what its two neighbours are and no other
//! (O'Rourke [OR98](crate::bibliography#or98), Section 1.6), so that n corners of
//! which r turn right or go straight on take O(n (n + r)).

type Point = [f64; 2];

/// Cuts outlines.
#[derive(Default)]
pub(super) struct Ears {
    points: Vec<Point>,
    /// Corners that are left, by their neighbours.
    next: Vec<u32>,
    prev: Vec<u32>,
    /// How good the ear at each corner is; zero where there is none.
    quality: Vec<f64>,
    /// Corners at which the outline does not turn left.
    is_open: Vec<bool>,
    /// The triangles.
    pub(super) found: Vec<[u32; 3]>,
}

impl Ears {
    /// Takes the outline that is to be cut, counter-clockwise.
    pub(super) fn outline(&mut self, points: impl Iterator<Item = Point>) {
        self.points.clear();
        self.points.extend(points);
    }

    /// Cuts the outline without triangles that are flatter than so; whether that went.
    pub(super) fn cut(&mut self, flat: f64) -> bool {
        let n = self.points.len() as u32;
        self.found.clear();
        self.next.clear();
        self.next.extend((0..n).map(|i| (i + 1) % n));
        self.prev.clear();
        self.prev.extend((0..n).map(|i| (i + n - 1) % n));
        self.is_open.clear();
        self.is_open.extend((0..n).map(|_| false));
        for i in 0..n {
            self.is_open[i as usize] = self.shape(i) <= flat;
        }
        self.quality.clear();
        self.quality.extend((0..n).map(|_| 0.0));
        for i in 0..n {
            self.quality[i as usize] = self.ear(i, flat);
        }
        for left in (3..=n).rev() {
            let best = (0..n).max_by(|i, j| {
                let [a, b] = [i, j].map(|&i| self.quality[i as usize]);
                // Of equal ones the first.
                a.total_cmp(&b).then(j.cmp(i))
            });
            let Some(i) = best.filter(|&i| self.quality[i as usize] > 0.0) else {
                return false;
            };
            let [a, b] = [self.prev[i as usize], self.next[i as usize]];
            self.found.push([a, i, b]);
            self.quality[i as usize] = 0.0;
            self.is_open[i as usize] = false;
            if left == 3 {
                break;
            }
            self.next[a as usize] = b;
            self.prev[b as usize] = a;
            for j in [a, b] {
                self.is_open[j as usize] = self.shape(j) <= flat;
            }
            for j in [a, b] {
                self.quality[j as usize] = self.ear(j, flat);
            }
        }
        true
    }

    fn triangle(&self, i: u32) -> [u32; 3] {
        [self.prev[i as usize], i, self.next[i as usize]]
    }

    /// Twice the area of the triangle at a corner over the square of its longest side.
    fn shape(&self, i: u32) -> f64 {
        let [a, b, c] = self.triangle(i).map(|i| self.points[i as usize]);
        let longest = square(a, b).max(square(b, c)).max(square(c, a));
        match longest > 0.0 {
            true => twice_area(a, b, c) / longest,
            false => 0.0,
        }
    }

    fn ear(&self, i: u32, flat: f64) -> f64 {
        let shape = self.shape(i);
        if shape <= flat {
            return 0.0;
        }
        let corners = self.triangle(i);
        let [a, b, c] = corners.map(|i| self.points[i as usize]);
        let slack = flat * square(a, b).max(square(b, c)).max(square(c, a));
        let is_in = |p: Point| {
            // Another corner at the same place is the other end of a bridge.
            let is_other = p != a && p != b && p != c;
            let sides = [[a, b], [b, c], [c, a]];
            is_other && sides.iter().all(|[q, r]| twice_area(*q, *r, p) >= -slack)
        };
        let open = self.is_open.iter().zip(0_u32..).filter(|(open, _)| **open);
        let mut others = open.filter(|(_, j)| !corners.contains(j));
        match others.any(|(_, j)| is_in(self.points[j as usize])) {
            true => 0.0,
            false => shape,
        }
    }
}

fn square(a: Point, b: Point) -> f64 {
    (b[0] - a[0]).powi(2) + (b[1] - a[1]).powi(2)
}

fn twice_area(a: Point, b: Point, c: Point) -> f64 {
    (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0])
}
