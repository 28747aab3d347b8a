//! Points found by where they are.

use super::bounds;
use super::hash::Table;
use glam::DVec3;

/// A cube is no smaller than this share of the whole: their numbers stay exact.
const FINEST: f64 = 1e-9;

/// Points in cubes of one size.
pub(super) struct Grid {
    low: DVec3,
    size: f64,
    cells: Table<[i64; 3], Vec<u32>>,
}

impl Grid {
    /// For questions within `reach` among these points.
    pub(super) fn new(reach: f64, x: &[DVec3]) -> Self {
        let (low, high) = bounds(x);
        let finest = FINEST * low.distance(high);
        Self {
            low,
            size: reach.max(finest).max(f64::MIN_POSITIVE),
            cells: Table::default(),
        }
    }

    /// The side of a cube.
    pub(super) fn size(&self) -> f64 {
        self.size
    }

    fn cell(&self, p: DVec3) -> [i64; 3] {
        ((p - self.low) / self.size)
            .to_array()
            .map(|c| c.floor() as i64)
    }

    pub(super) fn insert(&mut self, p: DVec3, name: u32) {
        self.cells.entry(self.cell(p)).or_default().push(name);
    }

    /// Whatever is in the cubes that a box touches, in no order: one by one, or if there are fewer, of
    /// all cubes with something in them those that it touches.
    pub(super) fn near(&self, low: DVec3, high: DVec3) -> impl Iterator<Item = u32> + '_ {
        let (low, high) = (self.cell(low), self.cell(high));
        let range = move |axis: usize| low[axis]..=high[axis];
        let count: f64 = (0..3)
            .map(|axis| (high[axis] - low[axis] + 1) as f64)
            .product();
        let is_wide = count > self.cells.len() as f64;
        let cubes = move || {
            let pairs = range(0).flat_map(move |i| range(1).map(move |j| (i, j)));
            pairs.flat_map(move |(i, j)| range(2).map(move |k| [i, j, k]))
        };
        let few = (!is_wide).then(cubes).into_iter().flatten();
        let few = few.filter_map(|cell| self.cells.get(&cell));
        let is_in = move |cell: &[i64; 3]| (0..3).all(|axis| range(axis).contains(&cell[axis]));
        let all = is_wide.then(|| self.cells.iter()).into_iter().flatten();
        let all = all
            .filter(move |(cell, _)| is_in(cell))
            .map(|(_, list)| list);
        few.chain(all).flatten().copied()
    }

    /// The point nearest to a place, no farther than `near`.
    pub(super) fn nearest(&self, p: DVec3, near: f64, x: &[DVec3]) -> Option<u32> {
        let reach = DVec3::splat(near);
        self.near(p - reach, p + reach)
            .map(|v| (x[v as usize].distance(p), v))
            .filter(|(distance, _)| *distance <= near)
            .min_by(|s, t| s.0.total_cmp(&t.0).then(s.1.cmp(&t.1)))
            .map(|(_, v)| v)
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    /// A box a million times as long as a cube would touch 10¹⁸ of them.
    #[test]
    fn a_box_finds_what_is_in_it_whatever_its_size() {
        let x: Vec<DVec3> = (0..50)
            .map(|i| DVec3::new(f64::from(i % 7), f64::from(i % 5), f64::from(i)))
            .collect();
        for size in [1e-6, 0.7, 3.0] {
            let mut grid = Grid::new(size, &x);
            for (v, p) in x.iter().enumerate() {
                grid.insert(*p, v as u32);
            }
            let (low, high) = (DVec3::new(1.5, 0.5, 3.5), DVec3::new(5.5, 3.5, 40.5));
            let is_in = |v: &u32| {
                let p = x[*v as usize];
                p.cmpge(low).all() && p.cmple(high).all()
            };
            let mut found: Vec<u32> = grid.near(low, high).filter(is_in).collect();
            found.sort_unstable();
            let all: Vec<u32> = (0..50).filter(is_in).collect();
            assert!(all.len() > 5);
            assert_eq!(found, all, "{size}");
        }
    }
}
