//! Ear clipping in a plane: the best ear first, and no flat one.
//!
//! A corner is an ear where the outline turns left and no other corner at which it does not lies in
//! its triangle. Cutting an ear changes what its two neighbours are and no other
//! (O'Rourke [OR98](crate::bibliography#or98), Section 1.6), so that n corners of
//! which r turn right or go straight on take O(n (r + log n)).

use std::cmp::Reverse;
use std::collections::BinaryHeap;

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
    /// Ears, the best on top, of equal ones the first; those that are none any more too.
    best: BinaryHeap<(u64, Reverse<u32>)>,
    /// Corners at which the outline does not turn left.
    open: Vec<u32>,
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
        self.open.clear();
        for i in 0..n {
            if self.shape(i) <= flat {
                self.open.push(i);
            }
        }
        self.best.clear();
        self.quality.clear();
        self.quality.extend((0..n).map(|_| 0.0));
        for i in 0..n {
            self.weigh(i, flat);
        }
        for left in (3..=n).rev() {
            let Some(i) = self.pop() else {
                return false;
            };
            let [a, i, b] = self.triangle(i);
            self.found.push([a, i, b]);
            self.quality[i as usize] = 0.0;
            if left == 3 {
                break;
            }
            self.next[a as usize] = b;
            self.prev[b as usize] = a;
            self.open.retain(|&j| j != a && j != b);
            for j in [a, b] {
                if self.shape(j) <= flat {
                    self.open.push(j);
                }
            }
            for j in [a, b] {
                self.weigh(j, flat);
            }
        }
        true
    }

    /// The best ear.
    fn pop(&mut self) -> Option<u32> {
        loop {
            let (bits, Reverse(i)) = self.best.pop()?;
            // Else it has been cut, or weighed anew.
            if bits == self.quality[i as usize].to_bits() {
                return Some(i);
            }
        }
    }

    fn weigh(&mut self, i: u32, flat: f64) {
        let quality = self.ear(i, flat);
        self.quality[i as usize] = quality;
        if quality > 0.0 {
            // Positive numbers are in the order of their bits.
            self.best.push((quality.to_bits(), Reverse(i)));
        }
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
        let mut others = self.open.iter().filter(|j| !corners.contains(j));
        match others.any(|&j| is_in(self.points[j as usize])) {
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
